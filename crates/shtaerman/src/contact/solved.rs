//! The solved contact.

use std::sync::{Arc, OnceLock};

use super::accuracy::{Accuracy, Sizes};
use super::audit::Audit;
use super::balance::State;
use super::heights::OfHeights;
use super::kinks::{Kink, kinks};
use super::method::Method;
use super::parts::MOST_CUTS;
use super::promise::Reached;
use super::route::Found;
use super::setting::Setting;
use super::solution::Solution;
use super::steps::rise;
use super::stiffness::Stiffness;
use super::unaudited::Unaudited;
use crate::extremes::{Extreme, Sampled};
use crate::roughness::Law;
use crate::warning::{Warning, WarningCode};
use crate::{ContactKind, Error, Problem, Scaling};

/// The answer: settlement, tilt, force, moment, zones and pressure of a contact.
///
/// Quantities are in the units of the problem: SI, or numbers for a dimensionless problem. [`dimensionless`](Self::dimensionless) has the same ones without
/// dimensions. Copies share what they hold and are cheap.
///
/// ```
/// use shtaerman::{Elastic, Foundation, Load, Problem, Profile, Punch};
///
/// let steel = Foundation::new(Elastic::new(200e9, 0.3)?).with_roughness(1.2e-14)?;
/// let crowned = Punch::new(5e-3)?.with_profile(Profile::expression("x^2 / (2*0.8)")?);
/// let contact = Problem::new(steel, crowned, Load::force(0.4e6)?)?.solve()?;
///
/// let [left, right] = contact.zones()[0];                 // m
/// assert!(-5e-3 < left && left < 0.0 && right < 5e-3);    // the edges lifted off
/// assert!(contact.peak_pressure() > 2.0 * contact.mean_pressure());
/// assert_eq!(contact.pressure(5e-3)?, 0.0);               // Pa
///
/// let bare = contact.dimensionless();
/// assert_eq!(bare.zones()[0][0] * 5e-3, left);            // lengths in half-widths
/// assert!((bare.peak_pressure() * 200e9 / contact.peak_pressure() - 1.0).abs() < 1e-15);   // pressures in E
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Contact {
    record: Arc<Record>,
    units: Units,
}

/// The units in which a contact tells its quantities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Units {
    OfProblem,
    None,
}

/// What a solution amounts to, without dimensions.
#[derive(Debug, Clone)]
struct Record {
    problem: Problem,
    /// The problem with heights from the level of the base, which was solved.
    setting: Setting,
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
    /// The largest pressure with its place.
    peak: (f64, f64),
    kinks: Vec<Kink>,
    tension: Vec<[f64; 2]>,
    warnings: Vec<Warning>,
    audit: Option<Result<Audit, Unaudited>>,
    /// The corner intensities of the smooth companion, once they are asked for.
    without_roughness: OnceLock<Option<Vec<[f64; 2]>>>,
}

impl Contact {
    /// The answer that a solution amounts to, with what the rounding of heights makes of it.
    pub(super) fn new(
        setting: Setting,
        found: Found,
        of_heights: Option<OfHeights>,
    ) -> Result<Self, Error> {
        let accuracy = of_heights.zip(found.solution.accuracy()).map(|(own, known)| own.or(known));
        Self::with_errors(setting, found, of_heights, accuracy)
    }

    /// What a solution that is not final amounts to: without the errors that the method states, which hold for answers only, and with a warning that says so.
    pub(super) fn unfinished(setting: Setting, found: Found) -> Result<Self, Error> {
        let left = found.solution.complementarity();
        let mut contact = Self::with_errors(setting, found, None, None)?;
        contact.warn(Some(Warning::time_limit(left)));
        Ok(contact)
    }

    /// Whether the [time limit](crate::Solver::with_time_limit) ended the search for it: zones and pressure are not final, and nothing is stated of its errors but by an
    /// [audit](Contact::with_audit).
    #[must_use]
    pub fn is_unfinished(&self) -> bool {
        self.warnings().iter().any(|warning| warning.code == WarningCode::TimeLimit)
    }

    fn with_errors(
        setting: Setting,
        found: Found,
        of_heights: Option<OfHeights>,
        accuracy: Option<Accuracy>,
    ) -> Result<Self, Error> {
        let Found { solution, reason, .. } = found;
        let problem = setting.problem().clone();
        let is_symmetric = problem.is_symmetric();
        let record = Record {
            problem: problem.clone(),
            setting,
            level: 0.0,
            accuracy,
            of_heights: of_heights.map_or(0.0, |own| own.relative()),
            edges_of_heights: of_heights.map_or(0.0, |own| own.edges()),
            reason: reason.to_string(),
            is_level: is_symmetric || problem.is_wave(),
            is_symmetric,
            peak: (0.0, 0.0),
            kinks: kinks(&problem, &solution.zones()),
            state: solution.state(),
            solution,
            tension: Vec::new(),
            warnings: Vec::new(),
            audit: None,
            without_roughness: OnceLock::new(),
        };
        let mut contact = Self { record: Arc::new(record), units: Units::OfProblem };
        contact.require_finite()?;
        contact.warn(Warning::evenness_not_proved(&problem));
        let (peak, tension) = {
            let (places, pressures) = contact.solution().sample();
            // Of what is no number nothing is sampled.
            if places.is_empty() {
                return Err(Error::Overflow { quantity: "pressure", value: f64::INFINITY });
            }
            let sampled = Sampled::new(|xi| contact.pressure_at(xi), places, pressures);
            (sampled.maximum(), sampled.negative())
        };
        let is_round = problem.bodies().is_circular() && contact.is_level();
        let peak = contact.peak_under_breaks(peak);
        let place = if is_round { peak.place.abs() } else { peak.place };
        let peak = Extreme { place, ..peak };
        let peak = contact.singular_peak().unwrap_or((peak.value, peak.place));
        let record = contact.record_mut();
        record.peak = peak;
        if problem.solver().contact == ContactKind::Bilateral {
            record.tension = tension;
        }
        Ok(contact)
    }

    /// The answer to the problem whose base lies higher by a level.
    pub(super) fn with_level(mut self, problem: &Problem, level: f64) -> Self {
        let record = self.record_mut();
        record.accuracy = record.accuracy.map(|accuracy| accuracy.with_level(level));
        record.problem = problem.clone();
        record.level = level;
        self
    }

    fn record_mut(&mut self) -> &mut Record {
        Arc::make_mut(&mut self.record)
    }

    /// This contact under a force as the answer to the settlement it has but for rounding, which the force answers for.
    ///
    /// # Errors
    /// Those of an error above what the problem asks for.
    pub(super) fn settled_at(mut self, problem: &Problem, settlement: f64) -> Result<Self, Error> {
        let record = self.record_mut();
        let state = record.state;
        let missed = (state.settlement - settlement).abs();
        if let Some(known) = &mut record.accuracy {
            let load = record.problem.dimensionless_load();
            let [raise, _] = record.solution.stiffness().displaced(&load, [1.0, 0.0]);
            let rounding = 4.0 * f64::EPSILON * state.force.abs();
            *known = known.with_profile_error(missed, [0.0; 2]);
            known.force = (known.settlement / raise).abs() + rounding;
            known.moment = known.force * (state.moment / state.force).abs();
            known.settlement = 0.0;
        }
        record.state.settlement = settlement;
        (record.problem, record.setting) = (problem.clone(), Setting::new(problem));
        let sizes = record.state.sizes(record.peak.0.abs());
        let reached = record.accuracy.map_or(0.0, |known| known.relative(&sizes));
        // Of a search that ended with the time the best so far is shown, as it is.
        if !problem.deadline().is_past() {
            self.require_kept(reached)?;
        }
        Ok(self)
    }

    /// The largest pressure, or that at or beside a break or an end of the base if it is larger: a cusp is too narrow for a search.
    fn peak_under_breaks(&self, found: Extreme) -> Extreme {
        let problem = &self.record.problem;
        let half_width = problem.bodies().half_width();
        let breaks = problem.profile().breakpoints(half_width);
        let under = breaks.into_iter().take(MOST_CUTS).chain([-1.0, 1.0]);
        let under = under.filter(|xi| self.record.solution.touches(*xi));
        // Beside a step the pressure is that of its side, and largest at one of its neighbours.
        let height = |xi: f64| problem.profile().height(xi.clamp(-1.0, 1.0), half_width);
        let numbers = |at: f64| {
            let beside = rise(height, at).map(|_| [at.next_down(), at.next_up()]);
            std::iter::once(at).chain(beside.into_iter().flatten())
        };
        let peaks = under.flat_map(numbers);
        let peaks = peaks.map(|place| Extreme { place, value: self.pressure_at(place) });
        peaks.fold(found, |best, peak| if peak.value > best.value { peak } else { best })
    }

    /// The first end of a zone or kink where the pressure is infinite.
    fn singular_peak(&self) -> Option<(f64, f64)> {
        let kinks = self.record.kinks.iter().map(|kink| kink.xi);
        let places = self.solution().zones().into_iter().flatten().chain(kinks);
        places.map(|xi| (self.pressure_at(xi), xi)).find(|(p, _)| *p == f64::INFINITY)
    }

    /// Where on a smooth surface the pressure is infinite under the base.
    pub(super) fn kinks(&self) -> &[Kink] {
        &self.record.kinks
    }

    /// The problem solved, as it was stated.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.record.problem
    }

    /// The same contact in numbers without dimensions: lengths in half-widths `a`, pressures in Young's modulus `E`, displacements in what the layer gives under
    /// that, `chi E`, forces in `a E` (`a^2 E` under a circular punch), moments in `a^2 E` (`a^3 E`), as (2.5) has it. Of a smooth surface, where that scale of displacements
    /// is undefined, displacements are in those that make `theta0 = 1`.
    ///
    /// Every quantity has the name that it has with units, and places are asked for in half-widths. What belongs to the problem and not to a quantity, as
    /// [`problem`](Self::problem) and [`sensitivities`](Self::sensitivities), stays as the problem states it.
    #[must_use]
    pub fn dimensionless(&self) -> Self {
        Self { units: Units::None, ..self.clone() }
    }

    /// The same contact in the units of its problem.
    pub(crate) fn stated(&self) -> Self {
        Self { units: Units::OfProblem, ..self.clone() }
    }

    /// Whether quantities are told in the units of the problem, and as given where they are prescribed.
    pub(crate) fn is_as_stated(&self) -> bool {
        self.units == Units::OfProblem
    }

    /// A scale of the problem in the units of this contact: 1 for numbers without dimensions.
    pub(crate) fn scale(&self, unit: impl Fn(&Scaling) -> f64) -> f64 {
        match (self.units, self.record.problem.scaling()) {
            (Units::OfProblem, Some(scaling)) => unit(scaling),
            _ => 1.0,
        }
    }

    /// `p0(xi)`, 0 outside the zones; points beyond the punch count as the nearer edge, subnormal ones as the middle, NaN stays.
    pub(crate) fn pressure_at(&self, xi: f64) -> f64 {
        let xi = if xi.is_subnormal() { 0.0 } else { xi.clamp(-1.0, 1.0) };
        self.singular_pressure(xi).unwrap_or_else(|| self.solution().pressure(xi))
    }

    /// `p0` at many places of the base.
    pub(super) fn pressures_at(&self, places: &[f64]) -> Vec<f64> {
        let mut pressures = self.solution().pressures(places);
        for (pressure, xi) in pressures.iter_mut().zip(places) {
            *pressure = self.singular_pressure(*xi).unwrap_or(*pressure);
        }
        pressures
    }

    /// `p0` in a zone by the distances from both of its ends, in half-widths.
    pub(crate) fn pressure_beside(&self, zone: usize, from_left: f64, from_right: f64) -> f64 {
        self.solution().pressure_beside(zone, from_left, from_right)
    }

    /// The largest `p0` with its `xi`.
    pub(crate) fn peak(&self) -> (f64, f64) {
        self.record.peak
    }

    /// Settlement, tilt, force and moment without dimensions.
    pub(super) fn state(&self) -> State {
        let state = self.record.state;
        State {
            settlement: state.settlement + self.record.level,
            tilt: if self.is_level() { 0.0 } else { state.tilt },
            force: state.force,
            moment: if self.record.is_symmetric { 0.0 } else { state.moment },
        }
    }

    /// With zeros where symmetry makes them, and what is `missing` of a wave: it cannot tilt, and how its moment changes is not found, which is not a number.
    pub(super) fn stiffness_by(&self, known: Stiffness, missing: f64) -> Stiffness {
        let of_wave = Stiffness { coupling: f64::NAN, moment_tilt: missing, ..known };
        let found = if self.problem().is_wave() { of_wave } else { known };
        Stiffness { coupling: if self.record.is_symmetric { 0.0 } else { found.coupling }, ..found }
    }

    /// How it was solved.
    #[must_use]
    pub fn method(&self) -> Method {
        self.solution().method()
    }

    /// Why this method was taken.
    #[must_use]
    pub fn reason(&self) -> &str {
        &self.record.reason
    }

    /// The errors without dimensions, where the method tells them.
    pub(crate) fn accuracy(&self) -> Option<&Accuracy> {
        self.found_audit().map_or(self.record.accuracy.as_ref(), |audit| Some(&audit.accuracy))
    }

    /// The error of the free ends of the zones, in `xi`.
    pub(super) fn zones_error(&self) -> Option<f64> {
        let own = || self.solution().edge_error().map(|e| e.max(self.record.edges_of_heights));
        self.found_audit().map_or_else(own, |audit| audit.edges)
    }

    /// The error of the largest `p0`; none without an audit that bounds it.
    pub(super) fn peak_error(&self) -> Option<f64> {
        let audit = self.found_audit()?;
        let (peak, at) = self.peak();
        // Where it was found the true pressure is no less than that, and nowhere more than this. That of a node is not to the last digit the one between nodes, which was audited.
        let above = audit.highest? - peak;
        let below = audit.accuracy.pressure + (peak - self.pressure_at(at)).abs();
        Some(below.max(above)).filter(|error| error.is_finite())
    }

    /// The audit that was carried out, or why there is none; none where nobody asked for it.
    #[must_use]
    pub fn audited_by(&self) -> Option<&Result<Audit, Unaudited>> {
        self.record.audit.as_ref()
    }

    /// Refuses a relative error above what the problem asks for.
    pub(super) fn require_kept(&self, reached: f64) -> Result<(), Error> {
        let State { settlement, tilt, .. } = self.state();
        let displacements = [settlement, tilt];
        let solver = self.problem().solver();
        Reached { error: reached, method: self.method(), displacements }.require_kept(solver)
    }

    fn found_audit(&self) -> Option<&Audit> {
        self.audited_by()?.as_ref().ok()
    }

    /// What `solve` finds of the smooth companion, which is solved once.
    pub(super) fn corners_without_roughness(
        &self,
        solve: impl FnOnce() -> Option<Vec<[f64; 2]>>,
    ) -> Option<&[[f64; 2]]> {
        self.record.without_roughness.get_or_init(solve).as_deref()
    }

    /// Takes the errors of an audit in place of those that the method states. What it bounds between all places has not to be proved of the profile as well.
    pub(crate) fn set_audit(&mut self, audit: Result<Audit, Unaudited>) {
        let unproved = Warning::profile_not_proved(audit.is_ok());
        self.record_mut().warnings.retain(|warning| Some(warning) != unproved.as_ref());
        self.record_mut().audit = Some(audit);
    }

    /// Holds the audited errors against the tolerance; without one, against what is aimed at.
    pub(crate) fn require_tolerance(&mut self) -> Result<(), Error> {
        if self.found_audit().is_none() {
            return Ok(());
        }
        let reached = self.relative_error();
        self.require_kept(reached)?;
        let solver = *self.problem().solver();
        if solver.tolerance.is_some() || solver.degree.is_some() {
            return Ok(());
        }
        self.record_mut().warnings.retain(|warning| warning.code != WarningCode::ToleranceNotMet);
        let aim = self.problem().aim();
        self.warn((reached > aim).then(|| Warning::tolerance_not_met(aim, reached)));
        Ok(())
    }

    /// What a user should know.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.record.warnings
    }

    /// Refuses an answer that is not finite: extreme but valid input can overflow.
    fn require_finite(&self) -> Result<(), Error> {
        let [[k11, k12], [_, k22]] = self.stiffness().matrix();
        // A wave has the first entry alone.
        let entries = if self.problem().is_wave() { k11 } else { k11 + k12 + k22 };
        for (quantity, value) in [
            ("force", self.force()),
            ("moment", self.moment()),
            ("settlement", self.settlement()),
            ("tilt", self.tilt()),
            ("stiffness", entries),
            ("pressure", self.solution_size() * self.scale(Scaling::pressure)),
            ("pressure at the left edge", self.pressure_left()),
            ("pressure in the middle", self.pressure_middle()),
            ("pressure at the right edge", self.pressure_right()),
            ("corner intensity", self.singular_corners().iter().map(|(_, k)| k.abs()).sum()),
        ] {
            // At a corner of a smooth body the pressure is infinite, and a wave in full contact does not yield.
            let may_be_infinite = self.problem().bodies().law() == Law::Smooth
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
        let (_, pressures) = self.solution().sample();
        let largest = pressures.into_iter().fold(0.0f64, |most, p| most.max(p.abs()));
        let sizes = self.record.state.sizes(largest);
        if let Some(audit) = self.found_audit() {
            // Its settlement is that of the problem itself, counted from no level; the gauge of the plane can take away what the layer gives, which is a part of it.
            let layer = self.problem().bodies().law().displacement(largest);
            let displacement = sizes.displacement.max(self.state().settlement.abs()).max(layer);
            return audit.accuracy.relative(&Sizes { displacement, ..sizes });
        }
        self.solution().relative_error().max(self.of_heights())
    }

    /// A bound of `|p0 + f0|` on the base.
    pub(crate) fn solution_size(&self) -> f64 {
        self.solution().size()
    }

    /// Whether tilt and moment are zero.
    pub(super) fn is_level(&self) -> bool {
        self.record.is_level
    }

    /// The error that the rounding of heights makes, relative to its size.
    pub(super) fn of_heights(&self) -> f64 {
        self.record.of_heights
    }

    /// The problem as it was solved, with heights from the level of the base.
    pub(crate) fn solved(&self) -> &Problem {
        self.record.setting.problem()
    }

    /// The settlement of the problem as it was solved, and the height of its level.
    pub(crate) fn solved_settlement(&self) -> (f64, f64) {
        (self.record.state.settlement, self.record.level)
    }

    pub(super) fn solution(&self) -> &dyn Solution {
        self.record.solution.as_ref()
    }

    pub(super) fn tension_at(&self) -> &[[f64; 2]] {
        &self.record.tension
    }

    pub(super) fn warn(&mut self, warning: Option<Warning>) {
        if warning.is_some() {
            self.record_mut().warnings.extend(warning);
        }
    }
}
