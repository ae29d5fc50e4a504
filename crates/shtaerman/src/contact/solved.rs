//! The solved contact.

use std::sync::Arc;

use super::accuracy::{Accuracy, Sizes};
use super::balance::State;
use super::extremes::{Extreme, Sampled};
use super::kinks::{Kink, kinks};
use super::promise::Reached;
use super::solution::Solution;
use super::unilateral::Complementarity;
use super::warning::{Warning, WarningCode};
use crate::audit::{Audit, Unaudited};
use crate::roughness::Law;
use crate::{ContactKind, Error, Problem, Rotational, Scaling, Vertical};

/// Method and size of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Method {
    /// Name of the method: `spectral`, `sinc`, `panels`, `cells`, `first_kind` or `expansion`.
    pub name: &'static str,
    /// Highest Chebyshev degree kept, or number of nodes.
    pub n: usize,
}

/// The tangent stiffness `d(P, M)/d(delta, -alpha)`, symmetric positive definite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stiffness {
    /// `dP/d delta` (Pa).
    pub force_settlement: f64,
    /// `dP/d(-alpha) = dM/d delta` (N/m).
    pub coupling: f64,
    /// `dM/d(-alpha)` (N).
    pub moment_tilt: f64,
}

impl Stiffness {
    /// As a matrix, row by row.
    #[must_use]
    pub fn matrix(&self) -> [[f64; 2]; 2] {
        [[self.force_settlement, self.coupling], [self.coupling, self.moment_tilt]]
    }

    /// In the units of the problem.
    pub(crate) fn scaled(&self, scaling: &Scaling) -> Self {
        let (force, moment) = (scaling.force(), scaling.moment());
        let (displacement, angle) = (scaling.displacement(), scaling.angle());
        Self {
            force_settlement: self.force_settlement * force / displacement,
            coupling: self.coupling * force / angle,
            moment_tilt: self.moment_tilt * moment / angle,
        }
    }
}

/// At most so many breaks of a base are looked at for the largest pressure.
const MOST_BREAKS: usize = 64;

/// Settlement, tilt, force, moment, zones and pressure of a contact.
///
/// Quantities are kept without dimensions; those without a `0` in their name are in the units of the problem (SI, or none for a
/// dimensionless problem).
#[derive(Debug, Clone)]
pub struct Contact {
    problem: Problem,
    /// The problem with heights from the level of the base, which was solved.
    solved: Problem,
    /// The height of that level, without dimensions.
    level: f64,
    solution: Arc<dyn Solution>,
    /// Settlement, tilt, force and moment, without dimensions.
    state: State,
    accuracy: Option<Accuracy>,
    /// The error that the rounding of heights makes, relative to its size.
    of_heights: f64,
    /// The same of the edges, in `xi`.
    edges_of_heights: f64,
    reason: String,
    /// Whether tilt and moment are zero, by symmetry or because a wave has none.
    is_level: bool,
    /// Whether base and load are their own mirror images.
    is_symmetric: bool,
    peak: (f64, f64),
    kinks: Vec<Kink>,
    tension: Vec<[f64; 2]>,
    warnings: Vec<Warning>,
    audit: Option<Result<Audit, Unaudited>>,
}

impl Contact {
    /// The answer that a solution amounts to.
    pub(super) fn new(
        problem: &Problem,
        solution: Arc<dyn Solution>,
        reason: String,
    ) -> Result<Self, Error> {
        let of_heights = problem.of_heights(solution.as_ref());
        let is_symmetric = problem.is_symmetric();
        let mut contact = Self {
            problem: problem.clone(),
            solved: problem.clone(),
            level: 0.0,
            accuracy: of_heights.zip(solution.accuracy()).map(|(own, known)| own.or(known)),
            of_heights: of_heights.map_or(0.0, |own| own.relative()),
            edges_of_heights: of_heights.map_or(0.0, |own| own.edges()),
            reason,
            is_level: is_symmetric || problem.is_wave(),
            is_symmetric,
            peak: (0.0, 0.0),
            kinks: kinks(problem, &solution.zones()),
            state: solution.state(),
            solution,
            tension: Vec::new(),
            warnings: Vec::new(),
            audit: None,
        };
        contact.require_finite()?;
        contact.warn(Warning::evenness_not_proved(problem));
        let (peak, tension) = {
            let (places, pressures) = contact.solution.sample(problem);
            let sampled = Sampled::new(|xi| contact.pressure0(xi), places, pressures);
            (sampled.maximum(), sampled.negative())
        };
        let is_round = problem.frame().is_circular() && contact.is_level;
        let peak = contact.peak_under_breaks(peak);
        let place = if is_round { peak.place.abs() } else { peak.place };
        let peak = Extreme { place, ..peak };
        contact.peak = contact.singular_peak().unwrap_or((peak.value, peak.place));
        if problem.solver().contact == ContactKind::Bilateral {
            contact.tension = tension;
        }
        Ok(contact)
    }

    /// The answer to the problem whose base lies higher by a level.
    pub(super) fn with_level(self, problem: &Problem, level: f64) -> Self {
        let accuracy = self.accuracy.map(|accuracy| accuracy.with_level(level));
        Self { problem: problem.clone(), level, accuracy, ..self }
    }

    /// This contact under a force as the answer to the settlement it has but for rounding, which the force answers for.
    pub(super) fn as_settled(mut self, problem: &Problem, settlement: f64) -> Self {
        let missed = (self.state.settlement - settlement).abs();
        if let Some(known) = &mut self.accuracy {
            let [raise, _] =
                self.solution.stiffness().displaced(&self.problem.dimensionless_load(), [1.0, 0.0]);
            let size = self.state.force.abs();
            known.force = ((known.settlement + missed) / raise).abs() + 4.0 * f64::EPSILON * size;
            known.moment = known.force * (self.state.moment / self.state.force).abs();
            known.settlement = 0.0;
        }
        self.state.settlement = settlement;
        (self.problem, self.solved) = (problem.clone(), problem.clone());
        self
    }

    /// The largest pressure, or that under a break of the base if it is larger: a cusp is too narrow for a search.
    fn peak_under_breaks(&self, found: Extreme) -> Extreme {
        let breaks = self.problem.profile().breakpoints(self.problem.frame().half_width());
        let under = breaks.into_iter().take(MOST_BREAKS).filter(|xi| self.solution.touches(*xi));
        let peaks = under.map(|place| Extreme { place, value: self.pressure0(place) });
        peaks.fold(found, |best, peak| if peak.value > best.value { peak } else { best })
    }

    /// The first end of a zone or kink where the pressure is infinite.
    fn singular_peak(&self) -> Option<(f64, f64)> {
        let kinks = self.kinks.iter().map(|kink| kink.xi);
        let places = self.edges0().into_iter().flatten().chain(kinks);
        places.map(|xi| (self.pressure0(xi), xi)).find(|(p, _)| *p == f64::INFINITY)
    }

    /// Where on a smooth surface the pressure is infinite under the base.
    pub(super) fn kinks(&self) -> &[Kink] {
        &self.kinks
    }

    /// The problem solved.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// `theta0`.
    #[must_use]
    pub fn theta0(&self) -> f64 {
        self.problem.frame().theta0()
    }

    /// `P0 = P/(a E)`.
    #[must_use]
    pub fn force0(&self) -> f64 {
        self.state.force
    }

    /// `M0 = M/(a^2 E)`; of a wave without gaps `int xi p0 dxi` over the period from `-1` to 1, whatever the load says: a moment cannot turn it.
    #[must_use]
    pub fn moment0(&self) -> f64 {
        if self.is_symmetric { 0.0 } else { self.state.moment }
    }

    /// `delta0 = delta/(chi E)`.
    #[must_use]
    pub fn settlement0(&self) -> f64 {
        self.state.settlement + self.level
    }

    /// `alpha0 = a alpha/(chi E)`.
    #[must_use]
    pub fn tilt0(&self) -> f64 {
        if self.is_level { 0.0 } else { self.state.tilt }
    }

    /// `p0(xi)` for `xi` in `[-1, 1]`, on the full base (3.1); 0 outside the zones of a unilateral contact and at their free edges. On a smooth surface
    /// infinite at corners and under kinks of the base, negative where that is hollow.
    /// Points beyond the punch count as the nearer edge, NaN stays.
    #[must_use]
    pub fn pressure0(&self, xi: f64) -> f64 {
        let xi = xi.clamp(-1.0, 1.0);
        self.singular_pressure(xi).unwrap_or_else(|| self.solution.pressure(&self.solved, xi))
    }

    /// Force per unit length `P` (N/m); where it is prescribed, as given.
    #[must_use]
    pub fn force(&self) -> f64 {
        match self.problem.load().vertical {
            Vertical::Force(prescribed) => prescribed,
            Vertical::Settlement(_) => self.force0() * self.scale(Scaling::force),
        }
    }

    /// Moment per unit length `M = int x p dx` (N m/m); where it is prescribed, as given.
    #[must_use]
    pub fn moment(&self) -> f64 {
        match self.problem.load().rotational {
            Rotational::Moment(prescribed) if !self.problem.is_wave() => prescribed,
            Rotational::Eccentricity(eccentricity) if !self.problem.is_wave() => {
                eccentricity * self.force()
            }
            _ => self.moment0() * self.scale(Scaling::moment),
        }
    }

    /// Settlement `delta` in the gauge `ln(a/|x-s|)` (m); where it is prescribed, as given.
    #[must_use]
    pub fn settlement(&self) -> f64 {
        match self.problem.load().vertical {
            Vertical::Settlement(prescribed) => prescribed,
            Vertical::Force(_) => self.settlement0() * self.scale(Scaling::displacement),
        }
    }

    /// Tilt `alpha` (rad); a positive moment gives a negative one; where it is prescribed, as given.
    #[must_use]
    pub fn tilt(&self) -> f64 {
        match self.problem.load().rotational {
            Rotational::Tilt(prescribed) => prescribed,
            Rotational::Moment(_) | Rotational::Eccentricity(_) => {
                self.tilt0() * self.scale(Scaling::angle)
            }
        }
    }

    /// Pressure `p(x)` (Pa), `x` in the units of the problem.
    ///
    /// # Errors
    /// [`Error::BeyondPunch`] outside the closed base, also for NaN.
    pub fn pressure(&self, x: f64) -> Result<f64, Error> {
        Ok(self.pressure0(self.on_base(x)?) * self.scale(Scaling::pressure))
    }

    /// Pressures `p(x)` (Pa) at many places, in the units of the problem; of a smooth surface they cost less than one by one.
    ///
    /// # Errors
    /// [`Error::BeyondPunch`] as soon as one lies outside the closed base or is NaN.
    pub fn pressures(&self, places: &[f64]) -> Result<Vec<f64>, Error> {
        let mut on_base = places.to_vec();
        for place in &mut on_base {
            *place = self.on_base(*place)?;
        }
        let mut pressures = self.solution.pressures(&self.solved, &on_base);
        for (pressure, xi) in pressures.iter_mut().zip(&on_base) {
            *pressure = self.singular_pressure(*xi).unwrap_or(*pressure);
        }
        let scale = self.scale(Scaling::pressure);
        pressures.iter_mut().for_each(|p| *p *= scale);
        Ok(pressures)
    }

    /// `p0` in a zone of [`edges0`](Self::edges0) by the distances from both of its ends.
    pub(crate) fn pressure_beside0(&self, zone: usize, from_left: f64, from_right: f64) -> f64 {
        self.solution.pressure_beside(&self.solved, zone, from_left, from_right)
    }

    /// The `xi` of a point on the closed base.
    pub(super) fn on_base(&self, x: f64) -> Result<f64, Error> {
        let half_width = self.problem.frame().half_width();
        if x.abs() <= half_width {
            return Ok((x / half_width).clamp(-1.0, 1.0));
        }
        let variable = self.problem.frame().coordinate();
        Err(Error::BeyondPunch { variable, at: x, left: -half_width, right: half_width })
    }

    /// Pressure at the left edge of the punch (Pa).
    #[must_use]
    pub fn pressure_left(&self) -> f64 {
        self.pressure0(-1.0) * self.scale(Scaling::pressure)
    }

    /// Pressure in the middle of the punch (Pa).
    #[must_use]
    pub fn pressure_mid(&self) -> f64 {
        self.pressure0(0.0) * self.scale(Scaling::pressure)
    }

    /// Pressure at the right edge of the punch (Pa).
    #[must_use]
    pub fn pressure_right(&self) -> f64 {
        self.pressure0(1.0) * self.scale(Scaling::pressure)
    }

    /// Mean pressure over the base (Pa): `P/(2a)`, or `P/(pi a^2)` under a circular punch.
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        self.mean_pressure0() * self.scale(Scaling::pressure)
    }

    /// Mean of `p0` over the base.
    #[must_use]
    pub fn mean_pressure0(&self) -> f64 {
        let frame = self.problem.frame();
        self.force0() / frame.geometry().measure(frame.half_width())
    }

    /// The largest pressure (Pa) and its place (m); of equal ones the leftmost.
    #[must_use]
    pub fn peak_pressure(&self) -> (f64, f64) {
        let (value, xi) = self.peak;
        (value * self.scale(Scaling::pressure), xi * self.problem.frame().half_width())
    }

    /// The largest `p0` and its `xi`.
    #[must_use]
    pub fn peak_pressure0(&self) -> (f64, f64) {
        self.peak
    }

    /// Intervals of the base where the pressure is negative, in the units of the problem.
    #[must_use]
    pub fn tension(&self) -> Vec<[f64; 2]> {
        let half_width = self.problem.frame().half_width();
        self.tension.iter().map(|interval| interval.map(|xi| xi * half_width)).collect()
    }

    /// The zones of contact from left to right, `[left, right]`, in the units of the problem; the full base of a bilateral contact.
    #[must_use]
    pub fn edges(&self) -> Vec<[f64; 2]> {
        let half_width = self.problem.frame().half_width();
        self.edges0().into_iter().map(|zone| zone.map(|xi| xi * half_width)).collect()
    }

    /// The zones of contact from left to right, `[left, right]` in `xi`.
    #[must_use]
    pub fn edges0(&self) -> Vec<[f64; 2]> {
        self.solution.zones()
    }

    /// Width of all zones together, in the units of the problem.
    #[must_use]
    pub fn contact_width(&self) -> f64 {
        self.edges().iter().map(|[left, right]| right - left).sum()
    }

    /// The estimated error of the edges, in `xi`; none where they are known.
    #[must_use]
    pub fn edge_error0(&self) -> Option<f64> {
        let own = || self.solution.edge_error().map(|known| known.max(self.edges_of_heights));
        self.found_audit().map_or_else(own, |audit| audit.edges)
    }

    /// The error of the [largest pressure](Self::peak_pressure0), without dimensions; none without an audit that bounds it.
    #[must_use]
    pub fn peak_error0(&self) -> Option<f64> {
        let audit = self.found_audit()?;
        // Where it was found the true pressure is no less than that, and nowhere more than this.
        let above = audit.highest? - self.peak_pressure0().0;
        Some(audit.accuracy.pressure.max(above)).filter(|error| error.is_finite())
    }

    /// What a unilateral answer leaves of tension and penetration; none for a bilateral one.
    #[must_use]
    pub fn complementarity(&self) -> Option<Complementarity> {
        self.solution.complementarity()
    }

    /// The tangent stiffness in the units of the problem.
    #[must_use]
    pub fn stiffness(&self) -> Stiffness {
        let stiffness = self.stiffness0();
        self.problem.frame().scaling().map_or(stiffness, |scaling| stiffness.scaled(scaling))
    }

    /// The tangent stiffness without dimensions.
    #[must_use]
    pub fn stiffness0(&self) -> Stiffness {
        self.without_symmetry(self.solution.stiffness())
    }

    /// The estimated error of each entry of [`stiffness0`](Self::stiffness0), where the method tells one.
    #[must_use]
    pub fn stiffness_error0(&self) -> Option<Stiffness> {
        self.solution.stiffness_error().map(|error| self.without_symmetry(error))
    }

    /// With zeros where symmetry makes them.
    fn without_symmetry(&self, known: Stiffness) -> Stiffness {
        let coupling = if self.is_level { 0.0 } else { known.coupling };
        let moment_tilt = if self.problem.is_wave() { 0.0 } else { known.moment_tilt };
        Stiffness { coupling, moment_tilt, ..known }
    }

    /// How it was solved.
    #[must_use]
    pub fn method(&self) -> Method {
        self.solution.method()
    }

    /// Why this method was taken.
    #[must_use]
    pub fn reason(&self) -> &str {
        &self.reason
    }

    /// The error of the answer without dimensions, where the method tells one.
    #[must_use]
    pub fn accuracy(&self) -> Option<&Accuracy> {
        self.found_audit().map_or(self.accuracy.as_ref(), |audit| Some(&audit.accuracy))
    }

    /// The audit that was carried out, or why there is none; none where nobody asked for it.
    #[must_use]
    pub fn audited_by(&self) -> Option<&Result<Audit, Unaudited>> {
        self.audit.as_ref()
    }

    fn found_audit(&self) -> Option<&Audit> {
        self.audit.as_ref()?.as_ref().ok()
    }

    /// Takes the errors of an audit in place of those that the method states.
    pub(crate) fn set_audit(&mut self, audit: Result<Audit, Unaudited>) {
        self.audit = Some(audit);
    }

    /// Holds the audited errors against the tolerance; without one, against what is aimed at.
    pub(crate) fn require_tolerance(&mut self) -> Result<(), Error> {
        if self.found_audit().is_none() {
            return Ok(());
        }
        let reached = self.relative_error();
        let displacements = [self.settlement0(), self.tilt0()];
        let solver = *self.problem.solver();
        Reached { error: reached, method: self.method(), displacements }.require_kept(&solver)?;
        if solver.tolerance.is_some() || solver.degree.is_some() {
            return Ok(());
        }
        self.warnings.retain(|warning| warning.code != WarningCode::ToleranceNotMet);
        let aim = self.problem.aim();
        self.warn((reached > aim).then(|| Warning::tolerance_not_met(aim, reached)));
        Ok(())
    }

    /// What a user should know.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// Refuses an answer that is not finite: extreme but valid input can overflow.
    fn require_finite(&self) -> Result<(), Error> {
        let stiffness = self.stiffness();
        for (quantity, value) in [
            ("force", self.force()),
            ("moment", self.moment()),
            ("settlement", self.settlement()),
            ("tilt", self.tilt()),
            ("stiffness", stiffness.force_settlement + stiffness.coupling + stiffness.moment_tilt),
            ("pressure", self.pressure_bound()),
            ("pressure at the left edge", self.pressure_left()),
            ("pressure in the middle", self.pressure_mid()),
            ("pressure at the right edge", self.pressure_right()),
        ] {
            // At a corner of a smooth body the pressure is infinite, and a wave in full contact does not yield.
            let may_be_infinite = self.problem.frame().law() == Law::Smooth
                && (quantity.starts_with("pressure ") || quantity == "stiffness");
            if value.is_nan() || value.is_infinite() && !may_be_infinite {
                return Err(Error::Overflow { quantity, value });
            }
        }
        match self.accuracy().filter(|accuracy| !accuracy.is_finite()) {
            Some(accuracy) => {
                Err(Error::Overflow { quantity: "error of the pressure", value: accuracy.pressure })
            }
            None => Ok(()),
        }
    }

    /// The largest error relative to its size; infinite where the method tells none.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        let (_, pressures) = self.solution.sample(&self.solved);
        let largest = pressures.into_iter().fold(0.0f64, |most, p| most.max(p.abs()));
        let sizes = self.state.sizes(largest);
        if let Some(audit) = self.found_audit() {
            // Its settlement is that of the problem itself, counted from no level; the gauge of the plane can take away what the layer gives, which is a part of it.
            let layer = self.problem.frame().law().displacement(largest);
            let displacement = sizes.displacement.max(self.settlement0().abs()).max(layer);
            return audit.accuracy.relative(&Sizes { displacement, ..sizes });
        }
        self.solution.relative_error().max(self.of_heights)
    }

    /// A bound of `|p + E f0|` on the base (Pa).
    fn pressure_bound(&self) -> f64 {
        self.solution_size() * self.scale(Scaling::pressure)
    }

    /// A bound of `|p0 + f0|` on the base.
    pub(crate) fn solution_size(&self) -> f64 {
        self.solution.size()
    }

    /// Whether tilt and moment are zero.
    pub(super) fn is_level(&self) -> bool {
        self.is_level
    }

    /// The error that the rounding of heights makes, relative to its size.
    pub(super) fn of_heights(&self) -> f64 {
        self.of_heights
    }

    /// The problem as it was solved, with heights from the level of the base.
    pub(crate) fn solved(&self) -> &Problem {
        &self.solved
    }

    /// The settlement of the problem as it was solved, and the height of its level.
    pub(crate) fn solved_settlement0(&self) -> (f64, f64) {
        (self.state.settlement, self.level)
    }

    pub(super) fn solution(&self) -> &dyn Solution {
        self.solution.as_ref()
    }

    pub(super) fn tension0(&self) -> &[[f64; 2]] {
        &self.tension
    }

    pub(super) fn warn(&mut self, warning: Option<Warning>) {
        self.warnings.extend(warning);
    }

    pub(super) fn scale(&self, unit: impl Fn(&Scaling) -> f64) -> f64 {
        self.problem.frame().scaling().map_or(1.0, unit)
    }
}
