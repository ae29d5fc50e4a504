//! What is to be solved, and what is worth knowing about the base.

use std::fmt;
use std::sync::Arc;

use super::kernel::SmoothKernel;
use crate::contact::search::Work;
use crate::contact::steps::{REACH, rise};
use crate::contact::valleys;
use crate::contact::valleys::MOST_CELLS;
use crate::contact::zones::{Walls, Zone};
use crate::deadline::Deadline;
use crate::error::require;
use crate::{Error, Load};

/// Samples that show the ups and downs of a profile, at least and at most. At half or twice 2 of 32 answers change, within what they state (survey).
pub(super) const SAMPLES: usize = 2048;
pub(super) const MOST_SAMPLES: usize = 32768;
/// Cells of a base with few valleys.
pub(super) const USUAL_CELLS: usize = 768;

/// A function of `xi`.
pub(crate) type Curve = Arc<dyn Fn(f64) -> f64 + Send + Sync>;

/// The base of a smooth punch, `f0(xi)`.
#[derive(Clone)]
pub(crate) struct SmoothProfile {
    /// `f0`.
    pub(crate) height: Curve,
    /// `df0/dxi`; without it the slope is that of polynomials through heights, which loses digits where the base is steep and
    /// the zones are short.
    pub(crate) slope: Option<Curve>,
    /// Where the profile has kinks or jumps, increasing.
    pub(crate) breaks: Vec<f64>,
    /// Where only higher derivatives jump, as at measured points, increasing: no polynomial shows the slope across them.
    pub(crate) joints: Vec<f64>,
    /// Relative accuracy to which the slope is resolved; 0 for the best, about `1e-10` for measured points.
    pub(crate) tolerance: f64,
}

impl fmt::Debug for SmoothProfile {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { breaks, joints, tolerance, .. } = self;
        formatter
            .debug_struct("SmoothProfile")
            .field("breaks", breaks)
            .field("joints", joints)
            .field("tolerance", tolerance)
            .finish_non_exhaustive()
    }
}

/// Contact without a layer, an equation of the first kind on the zones,
///
/// `theta0 int K(xi - eta) p0(eta) deta = delta0 - alpha0 xi - f0(xi)`.
#[derive(Debug, Clone)]
pub(crate) struct SmoothProblem {
    /// The pieces of the base from left to right, in `[-1, 1]`.
    pub(crate) pieces: Vec<[f64; 2]>,
    /// `K`.
    pub(crate) kernel: SmoothKernel,
    /// `theta0 > 0`.
    pub(crate) theta0: f64,
    /// What is prescribed, without dimensions.
    pub(crate) load: Load,
    /// `f0`.
    pub(crate) profile: SmoothProfile,
    /// Whether the zones are part of the answer, with the pressure nowhere negative.
    pub(crate) is_unilateral: bool,
    /// When the search for zones has to come to its end.
    pub(crate) deadline: Deadline,
}

impl SmoothProfile {
    /// All places where the profile has to be cut for polynomials, increasing.
    pub(super) fn cuts(&self) -> Vec<f64> {
        let mut cuts: Vec<f64> = self.breaks.iter().chain(&self.joints).copied().collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        cuts
    }
}

impl SmoothProblem {
    /// Whether the base is a wave without edges.
    pub(super) fn is_wave(&self) -> bool {
        self.kernel.period().is_some_and(|period| period <= 2.0)
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        let Self { pieces, kernel, theta0, load, .. } = self;
        require(theta0.is_finite() && *theta0 > 0.0, "theta0", *theta0, "finite and positive")?;
        Load::new(load.vertical, load.rotational)?;
        let mut from = -1.0;
        for &[left, right] in pieces {
            require(left >= from && left < right, "piece", left, "right of the one before")?;
            from = right;
        }
        require(!pieces.is_empty() && from <= 1.0, "piece", from, "within the base")?;
        if let Some(period) = kernel.period() {
            require(period >= 2.0 && period.is_finite(), "period", period, "at least 2 a")?;
        }
        Ok(())
    }

    /// Heights of a piece, which must be finite.
    fn samples(&self, [left, right]: [f64; 2]) -> Result<Vec<Sample>, Error> {
        let steps = valleys::steps(&*self.profile.height, [left, right], SAMPLES, MOST_SAMPLES);
        (0..=steps)
            .map(|i| {
                let xi = left + (right - left) * i as f64 / steps as f64;
                let height = (self.profile.height)(xi);
                require(height.is_finite(), "profile", xi, "such that the height is finite")?;
                Ok((xi, height))
            })
            .collect()
    }
}

/// A place with the height there, `(xi, f0)`.
pub(super) type Sample = (f64, f64);

/// A problem with its walls and samples.
pub(super) struct Base<'p> {
    pub(super) problem: &'p SmoothProblem,
    /// `mu` of the kernel `|d|^-mu` that stands in the place of the logarithm on graded ground.
    pub(super) grading: Option<f64>,
    /// Where ends of the contact can rest.
    pub(super) walls: Walls,
    /// Samples of each piece.
    pub(super) samples: Vec<Vec<Sample>>,
    pub(super) work: Work,
}

impl<'p> Base<'p> {
    pub(super) fn new(problem: &'p SmoothProblem) -> Result<Self, Error> {
        problem.check()?;
        let samples =
            problem.pieces.iter().map(|piece| problem.samples(*piece)).collect::<Result<_, _>>()?;
        Self::with_samples(problem, samples)
    }

    /// The base of a problem that is one, with the samples of each piece.
    pub(super) fn with_samples(
        problem: &'p SmoothProblem,
        samples: Vec<Vec<Sample>>,
    ) -> Result<Self, Error> {
        let walls = Walls::of(&problem.pieces);
        let work = Work::default();
        let mut base = Self { problem, grading: None, walls, samples, work };
        base.find_steps()?;
        if problem.is_unilateral {
            base.require_load()?;
        }
        Ok(base)
    }

    /// `f0(xi)`.
    pub(super) fn height(&self, xi: f64) -> f64 {
        (self.problem.profile.height)(xi)
    }

    /// The parts of a zone that lie beyond a step: the body cannot touch both its sides without a gap.
    pub(super) fn beyond_steps(&self, [left, right]: [f64; 2]) -> Vec<[f64; 2]> {
        let walls = |side: usize| self.walls.inside(side, [left, right]);
        walls(0).map(|wall| [left, wall]).chain(walls(1).map(|wall| [wall, right])).collect()
    }

    /// The zones of bilateral contact.
    pub(super) fn whole(&self) -> Vec<Zone> {
        let pieces = self.problem.pieces.iter();
        pieces.map(|&[left, right]| Zone::new([left, right], [false; 2])).collect()
    }

    fn all_samples(&self) -> impl Iterator<Item = &Sample> {
        self.samples.iter().flatten()
    }

    /// Difference of the largest and the smallest height.
    pub(super) fn range(&self) -> f64 {
        let heights = || self.all_samples().map(|sample| sample.1);
        heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
    }

    /// Number of cells that show every valley of the profile.
    pub(super) fn cells(&self) -> usize {
        valleys::cells(self.valleys().count(), USUAL_CELLS, MOST_CELLS)
    }

    /// Where the samples have valleys.
    pub(super) fn valleys(&self) -> impl Iterator<Item = f64> + '_ {
        self.samples.iter().flat_map(|piece| valleys::valleys(piece))
    }

    fn find_steps(&mut self) -> Result<(), Error> {
        for &place in &self.problem.profile.breaks {
            let inside = |[left, right]: &[f64; 2]| *left < place - REACH && place + REACH < *right;
            if !self.problem.pieces.iter().any(inside) {
                continue;
            }
            let Some(rise) = rise(|xi| self.height(xi), place) else { continue };
            let requirement = "without a step inside the base: bilateral contact of smooth bodies has no pressure across one";
            require(self.problem.is_unilateral, "profile", place, requirement)?;
            self.walls.add_step(place, rise);
        }
        Ok(())
    }

    /// Refuses what no contact can balance.
    fn require_load(&self) -> Result<(), Error> {
        self.problem.load.check_balance(1.0)?;
        if self.problem.load.keeps_clear(self.all_samples()) {
            return Err(Error::NoContact);
        }
        Ok(())
    }
}
