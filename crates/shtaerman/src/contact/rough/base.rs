//! The base of the punch as unilateral contact sees it: where it bends and where an edge of the contact can rest.

use std::cell::OnceCell;
use std::rc::Rc;
use std::sync::Arc;

use super::anchor::Anchor;
use super::coarse::{self, Coarse};
use super::effort::Effort;
use super::layer::Layer;
use crate::contact::ground::Ground;
use crate::contact::ground::of_problem::ground;
use crate::contact::parts::{MOST_BREAKS, Parts, Smoothness};
use crate::contact::revolution::require_even;
use crate::contact::search::{Equation, Work};
use crate::contact::setting::Setting;
use crate::contact::steps::{BESIDE, rise};
use crate::contact::valleys;
use crate::contact::valleys::{MOST_CELLS, SAMPLES};
use crate::contact::zones::{Walls, Zone};
use crate::error::require;
use crate::{ContactKind, Error, Load, Problem, Rotational, Scaling, Vertical};

/// Most samples that show the ups and downs of a profile.
const MOST_SAMPLES: usize = 8192;
/// Parts shorter than so many steps have samples of their own, so many. Half and twice change none of 32 answers (survey).
const SHORT: f64 = 8.0;
pub(super) const SAMPLES_A_PART: usize = 24;
/// Length of base within which all zones must lie for heights from a tangent. Half and twice change none of 20 answers (survey).
const SMALL_ZONES: f64 = 0.1;

/// A dimensionless problem with what is worth knowing about its profile.
#[derive(Clone)]
pub(super) struct Base<'p> {
    pub(super) setting: &'p Setting,
    pub(super) problem: &'p Problem,
    pub(super) load: Load,
    pub(super) theta: f64,
    /// What the punch stands on.
    pub(super) ground: Arc<dyn Ground>,
    pub(super) layer: Layer,
    /// Whether the whole base stays in contact.
    pub(super) is_bilateral: bool,
    /// The pieces of the base, from left to right; of a circular one the radius.
    pub(super) pieces: Vec<[f64; 2]>,
    /// The middle of the base: where it has no gaps, of the part of the wave that is looked at.
    pub(super) origin: f64,
    /// Where the profile is cut into smooth parts.
    pub(super) breaks: Vec<f64>,
    /// What these are.
    pub(super) smoothness: Smoothness,
    /// Where ends of the contact can rest.
    pub(super) walls: Walls,
    /// Samples `(xi, f0)` from edge to edge.
    pub(super) samples: Vec<(f64, f64)>,
    /// More of them in parts that fall between those.
    beside: Vec<(f64, f64)>,
    /// Whether base and load are their own mirror images; not asked of a base without bends on a linear layer, where nothing comes of it.
    pub(super) is_mirrored: bool,
    /// Where heights are counted from.
    pub(super) anchor: Option<Anchor>,
    /// What cells tell, once that is asked for.
    coarse: OnceCell<Rc<Coarse>>,
    /// How far collocation goes.
    pub(super) effort: Effort,
    /// What was done so far.
    pub(super) work: Work,
}

/// Samples of the parts that are shorter than a few steps.
fn beside(problem: &Problem, joints: &[f64], step: f64) -> Result<Vec<(f64, f64)>, Error> {
    let mut samples = Vec::new();
    let parts = joints.windows(2).filter(|part| part[1] - part[0] < SHORT * step);
    for part in parts {
        for i in 0..=SAMPLES_A_PART {
            let xi = part[0] + (part[1] - part[0]) * i as f64 / SAMPLES_A_PART as f64;
            samples.push((xi, problem.finite_profile(xi)?));
        }
    }
    Ok(samples)
}

/// Whether base and load of an open contact are their own mirror images.
fn is_mirrored(base: &Base<'_>) -> bool {
    let is_open = !base.ground.is_disk() && !base.ground.is_closed();
    let is_even = |values: &[f64]| values.iter().zip(values.iter().rev()).all(|(a, b)| *a == -*b);
    let ends: Vec<f64> = base.pieces.iter().flatten().copied().collect();
    is_open && is_even(&base.breaks) && is_even(&ends) && base.problem.is_symmetric()
}

impl<'p> Base<'p> {
    pub(super) fn new(setting: &'p Setting, kind: ContactKind) -> Result<Self, Error> {
        let problem = setting.problem();
        let wanted = 4 * problem.profile().measured_points().unwrap_or(0);
        let count = wanted.clamp(SAMPLES, MOST_SAMPLES);
        let ground = ground(problem)?;
        let pieces = if ground.is_disk() { vec![[0.0, 1.0]] } else { problem.frame().pieces() };
        let length: f64 = pieces.iter().map(|[left, right]| right - left).sum();
        let mut samples = Vec::with_capacity(count + pieces.len());
        for [left, right] in &pieces {
            let steps = ((count as f64 * (right - left) / length).ceil() as usize).max(2);
            let steps = if wanted > 0 || steps < SAMPLES / 4 {
                steps
            } else {
                let height = |xi| problem.dimensionless_profile(xi);
                valleys::steps(height, [*left, *right], steps, MOST_SAMPLES)
            };
            for i in 0..=steps {
                let xi = left + (right - left) * i as f64 / steps as f64;
                samples.push((xi, problem.finite_profile(xi)?));
            }
        }
        let parts = setting.parts_between_points();
        let beside = beside(problem, &parts.joints, length / count as f64)?;
        let mut base = Self {
            setting,
            problem,
            load: setting.load(),
            theta: setting.theta0(),
            layer: Layer::new(problem)?,
            is_bilateral: kind == ContactKind::Bilateral,
            origin: 0.0,
            smoothness: parts.smoothness,
            breaks: parts.joints,
            walls: Walls::of(&pieces),
            ground,
            pieces,
            samples,
            beside,
            is_mirrored: false,
            anchor: None,
            coarse: OnceCell::new(),
            effort: Effort::MOST,
            work: Work::default(),
        };
        let serves = !base.breaks.is_empty() || !base.layer.is_linear();
        base.is_mirrored = serves && is_mirrored(&base);
        base.find_steps();
        base.require_geometry()?;
        base.require_load()?;
        Ok(base)
    }

    /// `df0/dxi`, at a kink to the right, or what it has beyond the slope of the tangent; NaN where the profile has none.
    pub(super) fn slope(&self, xi: f64) -> f64 {
        let frame = self.problem.frame();
        let scale = frame.scaling().map_or(1.0, Scaling::displacement);
        let slope = self.problem.profile().slope(self.on_base(xi), frame.half_width());
        let tangent = self.anchor.map_or(0.0, |anchor| anchor.slope());
        slope.unwrap_or(f64::NAN) / scale - tangent
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

    /// The same base under another load, with nothing done so far.
    pub(super) fn under(&self, load: Load) -> Self {
        Self { load, work: Work::default(), coarse: OnceCell::new(), ..self.clone() }
    }

    /// Where the force acts, if the load says so.
    pub(super) fn line_of_force(&self) -> Option<f64> {
        match (self.load.vertical, self.load.rotational) {
            (Vertical::Force(force), Rotational::Moment(moment)) => Some(moment / force),
            (_, Rotational::Eccentricity(e)) => Some(e),
            _ => None,
        }
    }

    /// `f0(xi)`, or what it has beyond its tangent.
    pub(super) fn height(&self, xi: f64) -> f64 {
        match &self.anchor {
            Some(anchor) => anchor.rise(self.problem, xi),
            None => self.problem.dimensionless_profile(self.on_base(xi)),
        }
    }

    /// `f0(xi)`, which must be finite.
    pub(super) fn finite_height(&self, xi: f64) -> Result<f64, Error> {
        self.problem.checked(xi, self.height(xi))
    }

    /// The place on the base: a wave without gaps goes on beyond its period.
    pub(super) fn on_base(&self, xi: f64) -> f64 {
        if self.ground.is_closed() && xi.abs() > 1.0 { xi - 2.0 * (0.5 * xi).round() } else { xi }
    }

    /// The wave seen between `cut` and `cut + 2`.
    pub(super) fn shifted(mut self, cut: f64) -> Self {
        // The ends of a zone do not meet: there the kernel is infinite.
        let window = [cut + BESIDE, cut + 2.0 - BESIDE];
        let images = |at: f64| [at - 2.0, at, at + 2.0].into_iter();
        let inside = |at: &f64| *at > window[0] && *at < window[1];
        let mut breaks: Vec<f64> =
            self.breaks.iter().flat_map(|at| images(*at)).filter(inside).collect();
        // Where the period is joined the profile may bend.
        breaks.extend([-1.0, 1.0].into_iter().filter(inside));
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        let mut samples: Vec<(f64, f64)> = (self.samples.iter())
            .flat_map(|&(at, height)| images(at).map(move |at| (at, height)))
            .filter(|(at, _)| inside(at))
            .collect();
        samples.sort_by(|one, two| one.0.total_cmp(&two.0));
        self.walls = Walls::of(&[window]);
        (self.breaks, self.samples, self.pieces, self.origin) =
            (breaks, samples, vec![window], cut + 1.0);
        self.coarse = OnceCell::new();
        self.find_steps();
        self
    }

    /// Whether this is one punch on a half-plane with a linear layer.
    pub(super) fn is_plain(&self) -> bool {
        self.is_line() && self.pieces.len() == 1
    }

    /// Whether the kernel is the logarithm, and the layer linear: of one punch or of two.
    pub(super) fn is_line(&self) -> bool {
        self.ground.is_logarithm() && self.layer.is_linear()
    }

    /// Whether panels serve: on any ground with fast products.
    pub(super) fn has_panels(&self) -> bool {
        self.ground.panel_kernel().is_some()
    }

    /// Whether panels are tried first: the third derivative of the base jumps at measured points, where collocation loses its digits, or the base falls into more parts than
    /// that has panels for.
    pub(super) fn is_for_panels(&self) -> bool {
        let is_measured = self.problem.profile().measured_points().is_some();
        self.has_panels() && (is_measured || self.breaks.len() > MOST_BREAKS)
    }

    /// Whether a zone is the whole circle of a wave without gaps.
    pub(super) fn is_joined(&self, zone: &Zone) -> bool {
        self.ground.is_closed() && zone.length() >= 2.0
    }

    /// The same with so much effort.
    pub(super) fn with_effort(&self, effort: Effort) -> Self {
        Self { effort, work: Work::default(), ..self.clone() }
    }

    /// The pieces of the base as zones.
    pub(super) fn whole(&self) -> Vec<Zone> {
        self.pieces.iter().map(|piece| self.zone(*piece)).collect()
    }

    /// The prescribed tilt, or none.
    pub(super) fn tilt(&self) -> f64 {
        match self.load.rotational {
            Rotational::Tilt(tilt) => tilt,
            Rotational::Moment(_) | Rotational::Eccentricity(_) => 0.0,
        }
    }

    /// Number of cells that show every valley of the profile.
    pub(super) fn cells(&self) -> usize {
        const USUAL: usize = 1024;
        // Many zones under one plane punch are for panels.
        let most = if self.is_plain() { USUAL } else { MOST_CELLS };
        valleys::cells(self.valleys(), USUAL, most)
    }

    /// Number of valleys of the profile.
    pub(super) fn valleys(&self) -> usize {
        valleys::valleys(&self.samples).count()
    }

    fn find_steps(&mut self) {
        for &place in &self.breaks {
            if let Some(rise) = rise(|xi| self.height(xi), place) {
                self.walls.add_step(place, rise);
            }
        }
    }

    /// Refuses what a geometry does not know, and leaves out of the load what it answers elsewhere.
    fn require_geometry(&mut self) -> Result<(), Error> {
        if self.ground.is_disk() {
            require_even(self.problem)?;
            // Tilt and moment belong to another harmonic.
            self.load.rotational = Rotational::Tilt(0.0);
        }
        if self.ground.is_closed() {
            let (field, value) = match self.problem.load().rotational {
                Rotational::Moment(value) => ("moment", value),
                Rotational::Eccentricity(value) => ("eccentricity", value),
                Rotational::Tilt(value) => ("tilt", value),
            };
            require(
                value == 0.0,
                field,
                value,
                "zero where the base fills the period: a wave cannot tilt",
            )?;
            self.load.rotational = Rotational::Tilt(0.0);
        }
        Ok(())
    }

    /// Refuses what no contact can balance.
    fn require_load(&self) -> Result<(), Error> {
        if self.is_bilateral {
            return Ok(());
        }
        self.problem.check_balance()?;
        if self.touches_nowhere() {
            return Err(Error::NoContact);
        }
        Ok(())
    }

    /// Whether the prescribed displacements leave the base clear of the body.
    pub(super) fn touches_nowhere(&self) -> bool {
        self.load.keeps_clear(self.samples.iter().chain(&self.beside))
    }
}

impl Base<'_> {
    /// Where the base touches, to about a cell.
    pub(super) fn coarse(&self) -> Result<Rc<Coarse>, Error> {
        if let Some(known) = self.coarse.get() {
            return Ok(Rc::clone(known));
        }
        let found = Rc::new(coarse::loaded(self, self.cells())?);
        Ok(Rc::clone(self.coarse.get_or_init(|| found)))
    }

    /// The same with heights from the tangent where the zones are, if these are small: differences of heights have few digits there. None where they are not, or the profile has no tangent.
    pub(super) fn anchored(&self) -> Option<Self> {
        if self.ground.is_disk() || self.ground.is_closed() {
            return None;
        }
        let found = self.coarse().unwrap_or_default();
        let zones = found.intervals();
        // The line of the force passes between the ends of the contact.
        let arm = self.line_of_force().map(|arm| [arm; 2]);
        let left = zones.first().copied().or(arm)?[0];
        let right = zones.last().copied().or(arm)?[1];
        if right - left >= SMALL_ZONES {
            return None;
        }
        let anchor = Anchor::new(self.problem, 0.5 * (left + right))?;
        let rise = |&(xi, _): &(f64, f64)| (xi, anchor.rise(self.problem, xi));
        let mut base = self.under(anchor.load(self.load));
        base.samples = self.samples.iter().map(rise).collect();
        base.anchor = Some(anchor);
        Some(base)
    }
}
