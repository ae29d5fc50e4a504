//! The base of the punch as contact on a rough surface sees it: where it bends and where an edge of the contact can rest.

use std::cell::OnceCell;
use std::sync::Arc;

use fredholm::basis::Shown;

use super::coarse;
use super::layer::Layer;
use super::surface::{Surface, Tangent};
use crate::contact::accuracy::SAFETY;
use crate::contact::check::between_breaks;
use crate::contact::ground::Ground;
use crate::contact::ground::of_problem::ground;
use crate::contact::parts::{MOST_BREAKS, Parts, Smoothness};
use crate::contact::revolution::require_even;
use crate::contact::setting::Setting;
use crate::contact::steps::{BESIDE, INSIDE, rise};
use crate::contact::valleys::{self, MISSED, MOST_CELLS, MOST_SAMPLES, SAMPLES};
use crate::contact::zones::{Walls, Zone};
use crate::intervals::joined;
use crate::line_search::Point;
use crate::{ContactKind, Error, Load, Problem, Rotational};

/// Samples between two measured points (survey).
pub(super) const SAMPLES_A_POINT: usize = 4;
/// Length of base within which all zones must lie for heights from a tangent (survey).
const SMALL_ZONES: f64 = 0.1;

/// A dimensionless problem with what is worth knowing about its profile.
#[derive(Clone)]
pub(super) struct Base {
    pub(super) surface: Surface,
    /// What is asked for: of a circular base without its tilt, with a tangent that of what lies above it.
    pub(super) load: Load,
    /// What the punch stands on.
    pub(super) ground: Arc<dyn Ground>,
    pub(super) layer: Layer,
    /// Whether the whole base stays in contact.
    pub(super) is_bilateral: bool,
    /// The pieces of the base, from left to right; of a circular one the radius.
    pub(super) pieces: Vec<[f64; 2]>,
    /// Where the profile is cut into smooth parts, and what these are.
    pub(super) breaks: Vec<f64>,
    pub(super) smoothness: Smoothness,
    /// Where ends of the contact can rest.
    pub(super) walls: Walls,
    /// Samples `(xi, f0)` from edge to edge.
    pub(super) samples: Vec<(f64, f64)>,
    /// What cells show of the contact, once that is asked for.
    coarse: OnceCell<Vec<[f64; 2]>>,
}

/// The intervals of a wave between `cut` and `cut + 2`; none where the cut is in one of them: other cells may show a gap there.
fn seen_from(known: Vec<[f64; 2]>, cut: f64) -> Option<Vec<[f64; 2]>> {
    let images = |ends: [f64; 2]| [-2.0, 0.0, 2.0].map(|by| ends.map(|end| end + by));
    let mut images = joined(known.into_iter().flat_map(images).collect());
    let window = [cut, cut + 2.0];
    let is_cut = |ends: &[f64; 2]| window.iter().any(|at| ends[0] <= *at && *at <= ends[1]);
    let is_apart = !images.iter().any(is_cut);
    images.retain(|[left, right]| *left > window[0] && *right < window[1]);
    is_apart.then_some(images)
}

/// Samples of the pieces that show the ups and downs of the profile.
fn samples(problem: &Problem, pieces: &[[f64; 2]]) -> Result<Vec<(f64, f64)>, Error> {
    let wanted = SAMPLES_A_POINT * problem.profile().measured_points().unwrap_or(0);
    let count = wanted.clamp(SAMPLES, MOST_SAMPLES);
    let length: f64 = pieces.iter().map(|[left, right]| right - left).sum();
    let mut samples = Vec::with_capacity(count + pieces.len());
    for [left, right] in pieces {
        let mut steps = ((count as f64 * (right - left) / length).ceil() as usize).max(2);
        if wanted == 0 && steps as f64 >= MISSED * SAMPLES as f64 {
            let height = |xi| problem.dimensionless_profile(xi);
            steps = valleys::steps(height, [*left, *right], steps, MOST_SAMPLES);
        }
        let place = |i: usize| left + (right - left) * i as f64 / steps as f64;
        let places: Vec<f64> = (0..=steps).map(place).collect();
        let heights = problem.finite_profiles(&places)?;
        samples.extend(places.into_iter().zip(heights));
    }
    Ok(samples)
}

impl Base {
    pub(super) fn new(setting: &Setting, kind: ContactKind) -> Result<Self, Error> {
        let problem = setting.problem();
        let ground = ground(problem)?;
        let pieces = if ground.is_disk() { vec![[0.0, 1.0]] } else { problem.bodies().pieces() };
        let parts = setting.parts_between_points();
        let mut base = Self {
            surface: Surface::new(setting, ground.as_ref()),
            load: setting.load(),
            layer: Layer::new(problem)?,
            is_bilateral: kind == ContactKind::Bilateral,
            smoothness: parts.smoothness,
            breaks: parts.joints,
            walls: Walls::of(&pieces),
            ground,
            samples: samples(problem, &pieces)?,
            pieces,
            coarse: OnceCell::new(),
        };
        base.find_steps();
        base.require_geometry()?;
        base.require_load()?;
        Ok(base)
    }

    pub(super) fn problem(&self) -> &Problem {
        self.surface.setting.problem()
    }

    pub(super) fn theta(&self) -> f64 {
        self.surface.setting.theta0()
    }

    /// `k theta0`.
    pub(super) fn strength(&self) -> f64 {
        self.ground.strength() * self.theta()
    }

    /// The same base with all of it in contact, where the pressure may pull.
    pub(super) fn kept(&self) -> Self {
        Self { is_bilateral: true, ..self.clone() }
    }

    /// The same base cut into these parts.
    pub(super) fn cut(mut self, parts: &Parts) -> Self {
        (self.breaks, self.smoothness) = (parts.joints.clone(), parts.smoothness);
        self
    }

    /// `f0(xi)`, or what it has beyond its tangent.
    pub(super) fn height(&self, xi: f64) -> f64 {
        self.surface.height(xi)
    }

    /// Places with their heights.
    pub(super) fn points(&self, places: Vec<f64>) -> Vec<Point> {
        let heights = self.surface.heights(&places);
        places.into_iter().zip(heights).collect()
    }

    /// The same, looked up at a sample.
    pub(super) fn sampled_height(&self, xi: f64) -> f64 {
        match self.samples.binary_search_by(|(at, _)| at.total_cmp(&xi)) {
            Ok(sample) => self.samples[sample].1,
            Err(_) => self.height(xi),
        }
    }

    /// `f0` at places, which must be finite.
    pub(super) fn heights(&self, places: &[f64]) -> Result<Vec<f64>, Error> {
        let heights = self.surface.heights(places).into_iter().zip(places);
        heights.map(|(height, xi)| self.problem().checked(*xi, height)).collect()
    }

    /// What the polynomial through so many points of a panel shows of the profile there.
    pub(super) fn shown(&self, panel: [f64; 2], order: usize) -> Shown {
        Shown::new(panel, order, |places| self.surface.heights(places))
    }

    /// The wave seen between `cut` and `cut + 2`.
    pub(super) fn shifted(mut self, cut: f64) -> Self {
        // The ends of a zone do not meet: there the kernel is infinite.
        let window = [cut + BESIDE, cut + 2.0 - BESIDE];
        let inside = |[image, _]: &[f64; 2]| *image > window[0] && *image < window[1];
        let images = |at: f64| [-2.0, 0.0, 2.0].map(|by| [at + by, at]).into_iter().filter(inside);
        // Where the period is joined the profile may bend.
        let breaks = self.breaks.iter().copied().chain([-1.0, 1.0]);
        let mut places: Vec<[f64; 2]> = breaks.flat_map(images).collect();
        crate::order::sort_by_number(&mut places, |[image, _]| *image);
        let breaks = crate::order::ascending(places.iter().map(|[image, _]| *image));
        places.retain(|[image, at]| image != at);
        let of_image = |&(at, height): &(f64, f64)| images(at).map(move |[at, _]| (at, height));
        let mut samples: Vec<(f64, f64)> = self.samples.iter().flat_map(of_image).collect();
        crate::order::sort_by_number(&mut samples, |one| one.0);
        self.walls = Walls::of(&[window]);
        (self.breaks, self.samples, self.pieces) = (breaks, samples, vec![window]);
        (self.surface.origin, self.surface.images) = (cut + 1.0, places);
        let seen = self.coarse.take().and_then(|known| seen_from(known, cut));
        self.coarse = seen.map_or_else(OnceCell::new, OnceCell::from);
        self.find_steps();
        self
    }

    /// Whether panels serve: on any ground with fast products.
    pub(super) fn has_panels(&self) -> bool {
        self.ground.panel_kernel().is_some()
    }

    pub(super) fn is_measured(&self) -> bool {
        self.problem().profile().measured_points().is_some()
    }

    /// Whether panels are tried first: the third derivative of the base jumps at measured points, where collocation loses its digits, or the base falls into more parts than that has panels for.
    pub(super) fn is_for_panels(&self) -> bool {
        self.has_panels() && (self.is_measured() || self.breaks.len() > MOST_BREAKS)
    }

    /// Whether a zone is the whole circle of a wave without gaps.
    pub(super) fn is_joined(&self, zone: &Zone) -> bool {
        self.ground.is_closed() && zone.length() >= 2.0
    }

    /// A zone about this interval. Walls, steps of the base too, hold the contact until they pull: where the pressure rises towards one a free end would be led away from it.
    pub(super) fn zone(&self, ends: [f64; 2]) -> Zone {
        // The check looks just inside a wall.
        let beside = SAFETY * INSIDE;
        let walls = [0, 1].map(|side| {
            let inwards = if side == 0 { beside } else { -beside };
            self.walls.near(side, ends[side] + inwards, 2.0 * beside)
        });
        let zone = Zone::new(
            [0, 1].map(|side| walls[side].unwrap_or(ends[side])),
            walls.map(|wall| wall.is_none()),
        );
        if self.ground.is_disk() { zone.about_axis() } else { zone }
    }

    /// Whether base and load of an open contact are their own mirror images.
    pub(super) fn is_mirrored(&self) -> bool {
        let is_even =
            |places: &[f64]| places.iter().zip(places.iter().rev()).all(|(a, b)| *a == -*b);
        let is_open = !self.ground.is_disk() && !self.ground.is_closed();
        let are_even = is_even(&self.breaks) && is_even(self.pieces.as_flattened());
        is_open && are_even && self.problem().is_symmetric()
    }

    /// The pieces of the base as zones.
    pub(super) fn whole(&self) -> Vec<Zone> {
        self.pieces.iter().map(|piece| self.zone(*piece)).collect()
    }

    /// The prescribed tilt, or none.
    pub(super) fn tilt(&self) -> f64 {
        self.load.displacements()[1]
    }

    /// Number of cells that show every valley of the profile.
    pub(super) fn cells(&self) -> usize {
        // Panels find the zones of a linear layer from any that are about right: more cells would only delay them.
        let is_sure = self.is_for_panels() && self.layer.is_linear();
        let most = if is_sure { 0 } else { MOST_CELLS };
        valleys::cells(self.valleys().count(), most)
    }

    /// Where the profile has valleys.
    pub(super) fn valleys(&self) -> impl Iterator<Item = f64> {
        valleys::valleys(&self.samples)
    }

    fn find_steps(&mut self) {
        for &place in &self.breaks {
            if let Some(rise) = rise(|xi| self.surface.height(xi), place) {
                self.walls.add_step(place, rise);
            }
        }
    }

    /// Refuses what a geometry does not know, and leaves out of the load what it answers elsewhere.
    fn require_geometry(&mut self) -> Result<(), Error> {
        if self.ground.is_disk() {
            require_even(self.problem())?;
            // Tilt and moment belong to another harmonic.
            self.load.rotational = Rotational::Tilt(0.0);
        }
        if self.ground.is_closed() {
            self.problem().require_no_turn()?;
            self.load.rotational = Rotational::Tilt(0.0);
        }
        Ok(())
    }

    /// Refuses what no contact can balance, and displacements that leave the base clear of the body.
    fn require_load(&self) -> Result<(), Error> {
        if self.is_bilateral {
            return Ok(());
        }
        self.problem().check_balance()?;
        // Parts between breaks may be so short that no sample lies in them.
        let of = |piece: &[f64; 2]| between_breaks(&self.breaks, *piece);
        let places: Vec<f64> = self.pieces.iter().flat_map(of).collect();
        let heights = self.heights(&places)?;
        let samples = places.into_iter().zip(heights).chain(self.samples.iter().copied()).collect();
        let is_clear = self.load.is_clear(samples, &self.pieces, &|xi| self.height(xi));
        if is_clear { Err(Error::NoContact) } else { Ok(()) }
    }

    /// Where the base touches, to about a cell.
    pub(super) fn coarse(&self) -> Result<&[[f64; 2]], Error> {
        if let Some(known) = self.coarse.get() {
            return Ok(known);
        }
        let found = coarse::intervals(self, self.cells())?;
        Ok(self.coarse.get_or_init(|| found))
    }

    /// The same with heights from the tangent where the zones are, if these are small: differences of heights have few digits there. None where they are not, or the profile has no tangent.
    pub(super) fn on_tangent(&self) -> Option<Self> {
        if self.ground.is_disk() || self.ground.is_closed() {
            return None;
        }
        let zones = self.coarse().unwrap_or_default();
        // The line of the force passes between the ends of the contact.
        let arm = self.load.arm().map(|arm| [arm; 2]);
        let left = zones.first().copied().or(arm)?[0];
        let right = zones.last().copied().or(arm)?[1];
        if right - left >= SMALL_ZONES {
            return None;
        }
        let tangent = Tangent::new(self.problem(), 0.5 * (left + right))?;
        let mut surface = self.surface.clone();
        surface.tangent = Some(tangent);
        let (load, coarse) = (tangent.load(self.load), OnceCell::new());
        let samples = self.samples.iter().map(|&(xi, _)| (xi, surface.height(xi))).collect();
        Some(Self { surface, load, coarse, samples, ..self.clone() })
    }
}
