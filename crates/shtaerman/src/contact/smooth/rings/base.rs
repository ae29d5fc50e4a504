//! The base of revolution with its walls and samples.

use fredholm::inversion::Shape;

use crate::contact::search::Work;
use crate::contact::smooth::disk::SmoothDisk;
use crate::contact::smooth::problem::{MOST_SAMPLES, SAMPLES, USUAL_CELLS};
use crate::contact::steps::{REACH, rise};
use crate::contact::valleys;
use crate::contact::valleys::MOST_CELLS;
use crate::contact::zones::Walls;
use crate::{Error, Load, Rotational};

/// A problem with its walls and samples.
pub(super) struct Base<'p> {
    pub(super) problem: &'p SmoothDisk,
    pub(super) shape: Shape<'p>,
    /// Where ends of the contact can rest.
    pub(super) walls: Walls,
    /// `(r, f0)`.
    pub(super) samples: Vec<(f64, f64)>,
    pub(super) work: Work,
}

impl<'p> Base<'p> {
    pub(super) fn new(problem: &'p SmoothDisk) -> Result<Self, Error> {
        problem.check()?;
        let count = valleys::steps(&*problem.height, [0.0, 1.0], SAMPLES, MOST_SAMPLES);
        let samples: Vec<(f64, f64)> = (0..=count)
            .map(|i| i as f64 / count as f64)
            .map(|r| (r, (problem.height)(r)))
            .collect();
        let walls = Walls::of(&[[0.0, 1.0]]);
        let mut base =
            Self { problem, shape: problem.shape()?, walls, samples, work: Work::default() };
        base.find_steps();
        base.require_load()?;
        Ok(base)
    }

    /// `f0(r)`.
    pub(super) fn height(&self, r: f64) -> f64 {
        (self.problem.height)(r)
    }

    /// Difference of the largest and the smallest height.
    pub(super) fn range(&self) -> f64 {
        let heights = || self.samples.iter().map(|sample| sample.1);
        heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
    }

    /// Number of cells that show every valley of the profile.
    pub(super) fn cells(&self) -> usize {
        valleys::cells(valleys::valleys(&self.samples).count(), USUAL_CELLS, MOST_CELLS)
    }

    fn find_steps(&mut self) {
        for &place in &self.problem.breaks {
            let is_inside = place > REACH && place + REACH < 1.0;
            if let Some(rise) = is_inside.then(|| rise(|r| self.height(r), place)).flatten() {
                self.walls.add_step(place, rise);
            }
        }
    }

    fn require_load(&self) -> Result<(), Error> {
        let load = Load { rotational: Rotational::Tilt(0.0), ..self.problem.load };
        load.check_balance(1.0)?;
        if load.keeps_clear(self.samples.iter()) { Err(Error::NoContact) } else { Ok(()) }
    }
}
