//! The base of a punch on a smooth surface: heights and slopes, where it bends, and where ends of the contact can rest.

use std::sync::{Arc, OnceLock};

use fredholm::inversion::{Slopes, few_waves};

use crate::contact::ground::Ground;
use crate::contact::ground::of_problem::ground;
use crate::contact::kinks::jump;
use crate::contact::parts::{DEGREE, MOST_CUTS, RESOLVED};
use crate::contact::revolution::require_even;
use crate::contact::setting::Setting;
use crate::contact::steps::{INSIDE, REACH, rise};
use crate::contact::valleys;
use crate::contact::valleys::{MOST_CELLS, MOST_SAMPLES};
use crate::contact::zones::{Walls, Zone};
use crate::deadline::{Deadline, work};
use crate::error::require;
use crate::intervals::SLIVER;
use crate::{Error, Geometry, Load, Rotational, Vertical};

/// Samples that show the ups and downs of a profile, at least. At half or twice 2 of 32 answers change, within what they state (survey).
pub(super) const SAMPLES: usize = 2048;
/// To this share slopes of a measured profile or a closure are resolved by Abel's transforms: the third derivative of a spline jumps at every point, and slopes of a closure are those of
/// polynomials through its values. At half or twice 1 of 10 answers are lost and stated errors grow up to 2.7 times (survey).
const MEASURED: f64 = 1e-10;
/// Waves of slopes that are a smaller share of the largest are not looked for: they change the pressure by about as small a share (theory).
const UNSEEN: f64 = 1e-8;

/// A place with the height there, `(xi, f0)`.
type Sample = (f64, f64);

/// The base without dimensions; of a circular punch along a radius.
#[derive(Debug, Clone)]
pub(in crate::contact) struct Base {
    pub(super) setting: Setting,
    /// What is prescribed of the pressure that is solved for: of a circular punch and a wave without what turns.
    pub(super) load: Load,
    pub(super) ground: Arc<dyn Ground>,
    /// The pieces, from left to right.
    pub(super) pieces: Vec<[f64; 2]>,
    /// A wave is seen from elsewhere: its own `xi` is the place here plus this, wrapped.
    pub(super) shift: f64,
    /// Kinks, steps and the surroundings of features that samples miss, increasing.
    pub(super) breaks: Vec<f64>,
    /// Where only higher derivatives jump, as at measured points, increasing.
    pub(super) joints: Vec<f64>,
    /// Breaks, joints and places between: on each interval slopes have a wave or two at most.
    pub(super) marks: Vec<f64>,
    /// The kinks among the breaks that open away from the body: under these the pressure falls, on homogeneous ground below all bounds.
    pub(super) hollows: Vec<f64>,
    /// Relative accuracy to which slopes are resolved; 0 for the best.
    pub(super) tolerance: f64,
    /// Where ends of the contact can rest.
    pub(super) walls: Walls,
    samples: Vec<Vec<Sample>>,
    /// The slope of a formula; none of a base whose slope is told at once.
    slopes: OnceLock<Option<Slopes>>,
}

/// A place moved by whole periods into `-1 .. 1`.
pub(super) fn wrapped(xi: f64) -> f64 {
    match xi.abs() {
        size if size < 1.0 => xi,
        size if size - 2.0 < 1.0 => xi - 2f64.copysign(xi),
        _ => xi - 2.0 * (0.5 * xi).round(),
    }
}

impl Base {
    pub(super) fn new(setting: &Setting) -> Result<Self, Error> {
        let problem = setting.problem();
        let (bodies, profile) = (problem.bodies(), problem.profile());
        let half_width = bodies.half_width();
        let (is_disk, is_graded) = (bodies.is_circular(), bodies.grading().is_some());
        if is_disk {
            require_even(problem)?;
        }
        let pieces = if is_disk { vec![[0.0, 1.0]] } else { bodies.pieces() };
        let is_measured = profile.measured_points().is_some();
        let mut breaks = if is_measured || is_graded {
            profile.breakpoints(half_width)
        } else {
            profile.resolve(&bodies.pieces(), half_width, DEGREE, RESOLVED).joints
        };
        let mut joints = if is_measured {
            profile.joints(half_width)
        } else if is_graded && !is_disk {
            profile.resolve(&bodies.pieces(), half_width, DEGREE, RESOLVED).joints
        } else {
            Vec::new()
        };
        joints.retain(|at| breaks.iter().all(|known| (known - at).abs() > INSIDE));
        for places in [&mut breaks, &mut joints] {
            let inside = |at: &f64| !is_disk || (0.0 < *at && *at < 1.0);
            *places = crate::order::ascending(places.drain(..).filter(inside));
        }
        if is_disk && breaks.len() > MOST_CUTS {
            breaks.clear();
        }
        let uses_transforms = is_disk || is_graded;
        let is_rounded = uses_transforms && (is_measured || profile.is_closure());
        let base = Self {
            load: setting.load(),
            ground: ground(problem)?,
            walls: Walls::of(&pieces),
            setting: setting.clone(),
            pieces,
            shift: 0.0,
            marks: Vec::new(),
            hollows: Vec::new(),
            breaks,
            joints,
            tolerance: if is_rounded { MEASURED } else { 0.0 },
            samples: Vec::new(),
            slopes: OnceLock::new(),
        };
        base.balanced()?.sampled()?.seen()
    }

    /// The wave from a place that becomes `-1` and `1`; its own seam is a break where it bends there.
    pub(super) fn turned(&self, place: f64, has_seam: bool) -> Result<Self, Error> {
        let shift = place - 1.0;
        let moved = |places: &[f64], seam: Option<f64>| -> Vec<f64> {
            let places = places.iter().copied().chain(seam);
            let mut moved: Vec<f64> = places.map(|at| wrapped(at - shift)).collect();
            moved.sort_by(f64::total_cmp);
            moved
        };
        let (breaks, joints) =
            (moved(&self.breaks, has_seam.then_some(1.0)), moved(&self.joints, None));
        let walls = Walls::of(&self.pieces);
        let slopes = OnceLock::new();
        let turned = Self { shift, breaks, joints, walls, slopes, ..self.clone() };
        turned.moved().seen()
    }

    /// With the samples where they lie from here, and both ends.
    fn moved(mut self) -> Self {
        let ends = [-1.0, 1.0].map(|end| (end, self.height(end)));
        for piece in &mut self.samples {
            // The first and the last are one.
            let kept = piece.iter().skip(1).map(|(xi, height)| (wrapped(xi - self.shift), *height));
            let inside = kept.filter(|(xi, _)| -1.0 < *xi && *xi < 1.0);
            *piece = inside.chain(ends).collect();
            crate::order::sort_by_number(piece, |one| one.0);
        }
        self
    }

    /// The same under a force.
    pub(super) fn under(&self, force: f64) -> Self {
        let load = Load { vertical: Vertical::Force(force), ..self.load };
        Self { load, ..self.clone() }
    }

    /// With hollow kinks and steps; refuses a base that is clear of the body, and a step where all is kept in contact.
    fn seen(mut self) -> Result<Self, Error> {
        let problem = self.setting.problem();
        let is_hollow =
            |at: &&f64| jump(problem, self.own(**at)).is_some_and(|jump| jump.is_hollow());
        self.hollows = self.breaks.iter().filter(is_hollow).copied().collect();
        for &place in &self.breaks {
            let inside = |[left, right]: &[f64; 2]| *left < place - REACH && place + REACH < *right;
            if !self.pieces.iter().any(inside) {
                continue;
            }
            let Some(rise) = rise(|xi| self.height(xi), place) else { continue };
            let requirement = "without a step inside the base: bilateral contact of smooth bodies has no pressure across one";
            let at = place * problem.bodies().half_width();
            require(self.setting.is_unilateral(), "profile", at, requirement)?;
            self.walls.add_step(place, rise);
        }
        let slopes = |places: &[f64]| {
            self.tangents(places)
                .into_iter()
                .map(|(height, slope)| slope.unwrap_or(height))
                .collect()
        };
        let marked = |[left, right]: &[f64; 2]| {
            let inside = self.cuts().into_iter().filter(|at| left < at && at < right);
            let ends: Vec<f64> = [*left].into_iter().chain(inside).chain([*right]).collect();
            few_waves(&ends, slopes, UNSEEN)
        };
        self.marks = self.pieces.iter().flat_map(marked).collect();
        let is_clear =
            || self.load.is_clear(self.samples.concat(), &self.pieces, &|xi| self.height(xi));
        if self.setting.is_unilateral() && is_clear() { Err(Error::NoContact) } else { Ok(self) }
    }

    /// With the heights of all pieces, which must be finite.
    fn sampled(mut self) -> Result<Self, Error> {
        let problem = self.setting.problem();
        let of = |&[left, right]: &[f64; 2]| {
            let height = |xi: f64| self.height(xi);
            let steps = valleys::steps(height, [left, right], SAMPLES, MOST_SAMPLES);
            let place = |i: usize| left + (right - left) * i as f64 / steps as f64;
            let places: Vec<f64> = (0..=steps).map(place).collect();
            let heights = problem.finite_profiles(&places)?;
            Ok(places.into_iter().zip(heights).collect())
        };
        self.samples = self.pieces.iter().map(of).collect::<Result<_, Error>>()?;
        Ok(self)
    }

    /// Leaves out of the load what a geometry answers elsewhere, and refuses what no contact can balance.
    fn balanced(mut self) -> Result<Self, Error> {
        let problem = self.setting.problem();
        let level = Rotational::Tilt(0.0);
        if problem.bodies().is_circular() {
            // Tilt and moment belong to another harmonic.
            self.load.rotational = level;
            problem.under(Load { rotational: level, ..*problem.load() }).check_balance()?;
            return Ok(self);
        }
        if problem.is_wave() {
            problem.require_no_turn()?;
            // That no moment is asked for means that none is applied.
            self.load.rotational = level;
        }
        problem.check_balance()?;
        Ok(self)
    }

    /// The place of the base itself.
    fn own(&self, xi: f64) -> f64 {
        if self.shift == 0.0 { xi } else { wrapped(xi + self.shift) }
    }

    /// How large the numbers are with which a place is told, whose rounding it has: seen from elsewhere it may be near nothing.
    pub(super) fn distance(&self, xi: f64) -> f64 {
        xi.abs().max(self.own(xi).abs())
    }

    /// Where a place of the base lies among the zones: on a disk its distance from the axis.
    pub(super) fn located(&self, xi: f64) -> f64 {
        match self.setting.problem().bodies().geometry().scaled(self.half_width()) {
            Geometry::Circular => xi.abs(),
            _ if self.shift != 0.0 => wrapped(xi - self.shift),
            Geometry::Periodic { period } if xi.abs() >= 0.5 * period => {
                xi - period * (xi / period).round()
            }
            _ => xi,
        }
    }

    fn half_width(&self) -> f64 {
        self.setting.problem().bodies().half_width()
    }

    /// `f0(xi)`.
    pub(super) fn height(&self, xi: f64) -> f64 {
        self.setting.height(self.own(xi))
    }

    /// The same at many places.
    pub(super) fn heights(&self, places: &[f64]) -> Vec<f64> {
        let own: Vec<f64> = places.iter().map(|xi| self.own(*xi)).collect();
        self.setting.problem().dimensionless_profiles(&own)
    }

    /// `df0/dxi`, NaN where there is none.
    pub(super) fn slope(&self, xi: f64) -> f64 {
        let profile = self.setting.problem().profile();
        self.deadline().spend(work::DERIVATIVE * work::share(profile.operations()));
        self.setting.problem().dimensionless_slope(self.own(xi)).unwrap_or(f64::NAN)
    }

    /// Heights and slopes at many places, where slopes are known better than by differences.
    pub(super) fn tangents(&self, places: &[f64]) -> Vec<(f64, Option<f64>)> {
        if !self.has_slope() {
            return self.heights(places).into_iter().map(|height| (height, None)).collect();
        }
        let problem = self.setting.problem();
        let work = work::DERIVATIVE * work::share(problem.profile().operations());
        self.deadline().spend(work * places.len() as f64);
        let own: Vec<f64> = places.iter().map(|xi| self.own(*xi)).collect();
        let tangents = problem.dimensionless_tangents(&own).into_iter();
        tangents.map(|[height, slope]| (height, Some(slope))).collect()
    }

    /// The same for Abel's transforms, by polynomials where they are sooner known.
    pub(super) fn quick_slope(&self, xi: f64) -> f64 {
        self.deadline().spend(work::SLOPE);
        let slope = |xi: f64| self.slope(xi);
        let of_formula = || {
            let profile = self.setting.problem().profile();
            let mut ends = self.cuts();
            if self.ground.is_disk() {
                ends.extend(Slopes::towards_axis());
            } else {
                ends.extend(self.pieces.as_flattened());
            }
            let is_formula = !profile.is_closure() && profile.points().is_none();
            is_formula.then(|| Slopes::new(ends))
        };
        let slopes = self.slopes.get_or_init(of_formula).as_ref();
        slopes.and_then(|slopes| slopes.at(xi, slope)).unwrap_or_else(|| slope(xi))
    }

    /// Whether slopes are known better than by differences of heights: not those of a closure.
    pub(super) fn has_slope(&self) -> bool {
        !self.setting.problem().profile().is_closure()
    }

    /// The height at a place of a zone or a gap: at a step that of this side.
    pub(super) fn height_in(&self, [left, right]: [f64; 2], xi: f64) -> f64 {
        let from = if self.is_outermost(left) { left } else { left.next_up() };
        let to = if self.is_outermost(right) { right } else { right.next_down() };
        self.height(if from < to { xi.clamp(from, to) } else { xi })
    }

    fn is_outermost(&self, xi: f64) -> bool {
        self.pieces.iter().flatten().any(|end| *end == xi)
    }

    pub(super) fn deadline(&self) -> &Deadline {
        self.setting.problem().deadline()
    }

    /// Breaks and joints, increasing.
    pub(super) fn cuts(&self) -> Vec<f64> {
        let mut cuts: Vec<f64> = self.breaks.iter().chain(&self.joints).copied().collect();
        cuts.sort_by(f64::total_cmp);
        cuts
    }

    /// The parts of a zone that lie beyond a step: the body cannot touch both its sides without a gap.
    pub(super) fn beyond_steps(&self, [left, right]: [f64; 2]) -> Vec<[f64; 2]> {
        let walls = |side: usize| self.walls.inside(side, [left, right]);
        walls(0).map(|wall| [left, wall]).chain(walls(1).map(|wall| [wall, right])).collect()
    }

    /// The zones of bilateral contact.
    pub(super) fn whole(&self) -> Vec<Zone> {
        let zones = self.pieces.iter().map(|&piece| Zone::new(piece, [false; 2]));
        zones.map(|zone| self.arranged(zone)).collect()
    }

    /// A zone as it lies about the axis of a disk, where a ring whose hole closes becomes a disk, or about a bend that only rounding keeps from its middle, where its halves are looked at.
    pub(super) fn arranged(&self, mut zone: Zone) -> Zone {
        if !self.ground.is_disk() {
            let (middle, half) = (zone.middle(), 0.5 * zone.length());
            let is_there = |at: &&f64| (*at - middle).abs() <= zone.rounding();
            let halves = self.ground.exponent() > 0.0;
            let bend = self.breaks.iter().find(is_there).filter(|_| halves);
            if let Some(at) = bend.filter(|_| zone.is_free(0) && zone.is_free(1)) {
                zone.ends = [at - half, at + half];
            }
            return zone;
        }
        if zone.left() < SLIVER * zone.right() {
            zone.ends[0] = 0.0;
        }
        zone.about_axis()
    }

    fn all_samples(&self) -> impl Iterator<Item = &Sample> {
        self.samples.iter().flatten()
    }

    /// The pieces; of a base with one valley what lies about the line of the force, or in the body as it is: narrow zones that have to come from elsewhere do so by their own lengths.
    pub(super) fn begun(&self) -> Vec<[f64; 2]> {
        if self.valleys().nth(1).is_some() {
            return self.pieces.clone();
        }
        let reached = |piece: &Vec<Sample>| self.load.reached(piece, &|xi| self.height(xi));
        let begun = match self.load.about(&self.pieces) {
            Some(about) => vec![about],
            None => self.samples.iter().flat_map(reached).collect(),
        };
        if begun.is_empty() { self.pieces.clone() } else { begun }
    }

    /// The lowest place of the base.
    pub(super) fn lowest(&self) -> f64 {
        let lowest = self.all_samples().min_by(|one, two| one.1.total_cmp(&two.1));
        lowest.map_or(0.0, |(xi, _)| *xi)
    }

    /// Difference of the largest and the smallest height.
    pub(super) fn range(&self) -> f64 {
        let heights = || self.all_samples().map(|sample| sample.1);
        heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
    }

    /// Number of cells that show every valley of the profile.
    pub(super) fn cells(&self) -> usize {
        valleys::cells(self.valleys().count(), MOST_CELLS)
    }

    /// Where the samples have valleys.
    pub(super) fn valleys(&self) -> impl Iterator<Item = f64> + '_ {
        self.samples.iter().flat_map(|piece| valleys::valleys(piece))
    }
}
