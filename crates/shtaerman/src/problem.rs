//! A contact problem, physical or dimensionless.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use fredholm::basis::Function;

use crate::bodies::Bodies;
use crate::deadline::{Deadline, work};
use crate::error::{finite, require};
use crate::expression::{Defect, Interval, Reflection, decimal_rounding, remainder_of_sum};
use crate::profile::Resolution;
use crate::{ContactKind, Error, Foundation, Load, Profile, Punch, Scaling, Solver, Vertical};

/// Chebyshev degrees for each measured point, so that none falls between the first samples.
const POINTS_PER_SAMPLE: usize = 4;

/// A punch on a foundation under a load: physical in SI units, or [dimensionless](Foundation::dimensionless).
///
/// ```
/// use shtaerman::{Elastic, Foundation, Load, Problem, Profile, Punch};
///
/// let steel = Foundation::new(Elastic::new(200e9, 0.3)?).with_roughness(1.2e-14)?;
/// let crowned = Punch::new(5e-3)?.with_profile(Profile::from_fn(|x| x * x / 1.6));
/// let problem = Problem::new(steel, crowned, Load::force(0.8e6)?)?;
///
/// // What is varied in a loop: copies share the profile and are cheap.
/// let mut last = 0.0;
/// for force in [0.2e6, 0.4e6, 0.8e6] {
///     let contact = problem.with_force(force)?.solve()?;
///     assert!(contact.contact_width() > last);
///     last = contact.contact_width();
/// }
///
/// // Without dimensions: theta0 alone, lengths in half-widths.
/// let bare = Problem::new(Foundation::dimensionless(5.0)?, Punch::new(1.0)?, Load::force(2.0)?)?;
/// assert_eq!(bare.solve()?.mean_pressure(), 1.0);
/// # Ok::<(), shtaerman::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    foundation: Foundation,
    punch: Punch,
    /// What the equation needs of both.
    bodies: Bodies,
    load: Load,
    solver: Solver,
    /// When the search for its answer has to come to its end.
    deadline: Deadline,
    /// What the difference of settlement and heights is known to where a level was taken from both: decimal numbers are rounded before that.
    rounding: f64,
}

impl Problem {
    /// The problem of a unilateral contact; [`with_solver`](Self::with_solver) has others.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for what does not go together (a graded foundation with an elastic punch or under a periodic row, a half-width other than 1 in a
    /// dimensionless problem) and for scales or a load beyond the range of double precision; [`Error::ProfileNotFinite`] where the profile is not finite on
    /// the closed punch.
    pub fn new(foundation: Foundation, punch: Punch, load: Load) -> Result<Self, Error> {
        let bodies = Bodies::new(&foundation, &punch)?;
        let (solver, deadline) = (Solver::default(), Deadline::default());
        Self { foundation, punch, bodies, load, solver, deadline, rounding: 0.0 }.ready()
    }

    /// The same problem solved with other bodies, without asking what foundation and punch would make it so.
    pub(crate) fn of_bodies(&self, bodies: Bodies) -> Result<Self, Error> {
        Self { bodies, ..self.clone() }.ready()
    }

    fn ready(mut self) -> Result<Self, Error> {
        if let Some(scaling) = self.bodies.scaling() {
            let scaled = scaling.load(&self.load);
            Load::new(scaled.vertical, scaled.rotational)?;
        }
        if self.is_wave() {
            let profile = self.profile().clone().repeating(self.bodies.half_width());
            self.punch = self.punch.with_profile(profile);
        }
        self.check_profile()?;
        Ok(self)
    }

    /// What the punch is pressed into.
    #[must_use]
    pub fn foundation(&self) -> &Foundation {
        &self.foundation
    }

    /// The punch.
    #[must_use]
    pub fn punch(&self) -> &Punch {
        &self.punch
    }

    /// Units, material, layer and geometry together.
    pub(crate) fn bodies(&self) -> &Bodies {
        &self.bodies
    }

    /// Base of the punch.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        self.punch.profile()
    }

    /// What is prescribed, in the units of the problem.
    #[must_use]
    pub fn load(&self) -> &Load {
        &self.load
    }

    /// A roughness in place of 0 with which a solution may be found: a circular punch that leans has one only where all of it touches.
    pub(crate) fn small_roughness(&self) -> Option<f64> {
        let leans = self.bodies().is_circular() && self.load().rotational.named().1 != 0.0;
        self.bodies().small_roughness().filter(|_| !leans)
    }

    /// What is prescribed, without dimensions.
    #[must_use]
    pub fn dimensionless_load(&self) -> Load {
        self.bodies.scaling().map_or(self.load, |scaling| scaling.load(&self.load))
    }

    /// How it is to be solved.
    #[must_use]
    pub fn solver(&self) -> &Solver {
        &self.solver
    }

    /// Whether it is stated in numbers without dimensions.
    #[must_use]
    pub fn is_dimensionless(&self) -> bool {
        self.bodies.scaling().is_none()
    }

    /// The scales of a physical problem; none of a dimensionless one.
    #[must_use]
    pub fn scaling(&self) -> Option<&Scaling> {
        self.bodies.scaling()
    }

    /// `theta0 = 2 a/(pi E* chi)`; of a smooth surface, where its scale is undefined, a number of internal use.
    #[must_use]
    pub fn theta0(&self) -> f64 {
        self.bodies.theta0()
    }

    /// What the settlement is measured against.
    #[must_use]
    pub fn gauge(&self) -> &'static str {
        self.bodies.gauge()
    }

    /// Name of the coordinate in the units of the problem: `x` or `xi`.
    #[must_use]
    pub fn coordinate(&self) -> &'static str {
        self.bodies.coordinate()
    }

    /// Whether force and moment are those of a disk (N, N m), not per unit length.
    #[must_use]
    pub fn is_circular(&self) -> bool {
        self.bodies.is_circular()
    }

    /// The same problem under another load, in the units of the problem.
    pub(crate) fn under(&self, load: Load) -> Self {
        Self { load, ..self.clone() }
    }

    /// The same problem solved otherwise.
    #[must_use]
    pub fn with_solver(&self, solver: Solver) -> Self {
        Self { solver, ..self.clone() }
    }

    /// The same problem with the time that its solver allows running from now on, or else with the work of a search; none where that runs already.
    pub(crate) fn timed(&self) -> Option<Self> {
        self.timed_for(self.most_work())
    }

    /// The same with so much work, for what comes beside an answer.
    pub(crate) fn timed_for(&self, most: f64) -> Option<Self> {
        if self.deadline.is_set() {
            return None;
        }
        let of_work = || Deadline::of_work(most);
        let deadline = self.solver.time_limit().map_or_else(of_work, Deadline::after);
        Some(Self { deadline, ..self.clone() })
    }

    /// What a search may take.
    fn most_work(&self) -> f64 {
        let points = self.profile().measured_points().unwrap_or(0);
        work::MOST * (1.0 + points as f64 / work::POINTS)
    }

    /// The same problem with the time that its solver allows running from now on, and with an end of it where `stop` is set.
    pub(crate) fn stopped_by(&self, stop: &Arc<AtomicBool>) -> Self {
        let deadline = Deadline::unless(stop, self.solver.time_limit(), self.most_work());
        Self { deadline, ..self.clone() }
    }

    /// When the search for its answer has to come to its end.
    pub(crate) fn deadline(&self) -> &Deadline {
        &self.deadline
    }

    /// The same problem with heights and settlement counted from the level of the base, and the height of that level in the units of the problem; none where that
    /// makes no difference.
    pub(crate) fn lowered(&self) -> Option<(Self, f64)> {
        let (profile, [level, of_level]) = self.profile().lowered(self.bodies.half_width())?;
        let load = self.load.lowered(level, 0.0);
        let (profile, rounding) = match self.load.vertical.settlement() {
            // What rounding takes from the settlement is left to the heights.
            Some(settlement) => {
                let raised = profile.raised(-remainder_of_sum(settlement, -level));
                (raised, of_level + decimal_rounding(settlement) * settlement.abs())
            }
            None => (profile, 0.0),
        };
        let punch = self.punch.clone().with_profile(profile);
        Some((Self { punch, load, rounding, ..self.clone() }, level))
    }

    /// What settlement and heights, one taken from the other, are known to in the units of the problem.
    pub(crate) fn rounding(&self) -> f64 {
        self.rounding
    }

    /// `f0(xi) = f(a xi)/(chi E)`, for a dimensionless problem the profile itself.
    #[must_use]
    pub fn dimensionless_profile(&self, xi: f64) -> f64 {
        let height = self.profile().height(xi, self.bodies.half_width());
        height / self.bodies.unit(Scaling::displacement)
    }

    /// The same at many places.
    pub(crate) fn dimensionless_profiles(&self, places: &[f64]) -> Vec<f64> {
        let mut heights = self.profile().heights(places, self.bodies.half_width());
        let displacement = self.bodies.unit(Scaling::displacement);
        heights.iter_mut().for_each(|height| *height /= displacement);
        heights
    }

    /// The same, which must be finite.
    pub(crate) fn finite_profiles(&self, places: &[f64]) -> Result<Vec<f64>, Error> {
        let heights = self.dimensionless_profiles(places);
        match heights.iter().position(|height| !height.is_finite()) {
            Some(place) => self.checked(places[place], heights[place]).map(|_| heights),
            None => Ok(heights),
        }
    }

    /// `df0/dxi`.
    pub(crate) fn dimensionless_slope(&self, xi: f64) -> Option<f64> {
        let slope = self.profile().slope(xi, self.bodies.half_width())?;
        Some(slope / self.bodies.unit(Scaling::displacement))
    }

    /// `f0` and `df0/dxi` at many places.
    pub(crate) fn dimensionless_tangents(&self, places: &[f64]) -> Vec<[f64; 2]> {
        let displacement = self.bodies.unit(Scaling::displacement);
        let tangents = self.profile().tangents(places, self.bodies.half_width());
        tangents.into_iter().map(|tangent| tangent.map(|part| part / displacement)).collect()
    }

    /// `f0(xi) - f0(c) - f0'(c) (xi - c)`.
    pub(crate) fn dimensionless_rise(&self, c: f64, xi: f64) -> f64 {
        let rise = self.profile().rise(c, xi - c, self.bodies.half_width());
        rise / self.bodies.unit(Scaling::displacement)
    }

    /// Encloses `f0(xi)` on an interval, as [`Profile::enclose`] does.
    #[must_use]
    pub fn dimensionless_enclosure(&self, interval: [f64; 2]) -> Option<Interval> {
        self.profile().enclose(interval, self.bodies.half_width()).map(|range| self.scaled(range))
    }

    /// Encloses the exact and the computed `f0(xi)` at one place, as [`Profile::enclose_at`] does.
    #[must_use]
    pub fn dimensionless_enclosure_at(&self, xi: f64) -> Option<Interval> {
        let range = self.profile().enclose_at(xi, self.bodies.half_width());
        range.map(|range| self.scaled(range))
    }

    /// The same at many places.
    pub(crate) fn dimensionless_enclosures_at(&self, places: &[f64]) -> Vec<Option<Interval>> {
        let mut found = self.profile().enclosures_at(places, self.bodies.half_width());
        found.iter_mut().flatten().for_each(|range| *range = self.scaled(*range));
        found
    }

    /// Encloses `f0^(k)/k!` for `k` from 0 to `order` on an interval, as [`Profile::taylor`] does.
    #[must_use]
    pub fn dimensionless_taylor(&self, interval: [f64; 2], order: usize) -> Option<Vec<Interval>> {
        let terms = self.profile().taylor(interval, order, self.bodies.half_width())?;
        Some(terms.into_iter().map(|term| self.scaled(term)).collect())
    }

    /// Where the base has to be cut so that polynomials of a degree resolve the profile, as [`Profile::resolve`] has it.
    #[must_use]
    pub fn resolution(&self, degree: usize, tolerance: f64) -> Resolution {
        let half_width = self.bodies.half_width();
        self.profile().resolve(&self.bodies.pieces(), half_width, degree, tolerance)
    }

    /// Heights without dimensions.
    fn scaled(&self, heights: Interval) -> Interval {
        self.bodies.scaling().map_or(heights, |scaling| {
            let displacement = scaling.displacement();
            heights.over(Interval::ends(displacement, displacement)).0
        })
    }

    /// Whether the base is proved to be its own mirror image, or its negative.
    pub(crate) fn reflection(&self) -> Reflection {
        self.profile().reflection(self.bodies.half_width())
    }

    /// Whether base and load are proved to be their own mirror images.
    pub(crate) fn is_symmetric(&self) -> bool {
        // A circular base is a body of revolution, or refused.
        self.load.rotational.named().1 == 0.0
            && (self.bodies.is_circular() || self.reflection().is_even)
    }

    /// The relative error that is aimed at where no tolerance is given: `1e-12 max(1, theta0/10)`, of measured profiles `1e-10 max(1, theta0/100)`: rounding grows with `theta0`.
    pub(crate) fn aim(&self) -> f64 {
        let theta0 = self.bodies.theta0();
        if self.profile().measured_points().is_some() {
            return 1e-10 * (theta0 / 100.0).max(1.0);
        }
        crate::solver::AIM * (theta0 / 10.0).max(1.0)
    }

    /// Whether the base fills the whole period of a row.
    pub(crate) fn is_wave(&self) -> bool {
        self.bodies.geometry().is_wave(self.bodies.half_width())
    }

    /// The profile resolved by a Chebyshev series in `xi`.
    pub(crate) fn resolved_profile(&self) -> Result<Function, Error> {
        let degree = POINTS_PER_SAMPLE * self.profile().measured_points().unwrap_or(0);
        Function::resolve_from(&|xi| self.dimensionless_profile(xi), degree).map_err(|error| {
            match error {
                fredholm::Error::NotFinite { at, value, .. } if value.is_nan() => {
                    self.profile_not_finite(at, Defect::Undefined)
                }
                fredholm::Error::NotFinite { at, .. } => {
                    self.profile_not_finite(at, Defect::Infinite)
                }
                other => other.into(),
            }
        })
    }

    /// `f0(xi)`, which must be finite.
    pub(crate) fn finite_profile(&self, xi: f64) -> Result<f64, Error> {
        self.checked(xi, self.dimensionless_profile(xi))
    }

    /// Refuses a force that lifts the punch off and one that tips it over.
    pub(crate) fn check_balance(&self) -> Result<(), Error> {
        if self.solver.contact == ContactKind::Bilateral {
            return Ok(());
        }
        self.load.check_balance(self.bodies.half_width())?;
        let (Vertical::Force(scaled), Vertical::Force(force)) =
            (self.dimensionless_load().vertical, self.load.vertical)
        else {
            return Ok(());
        };
        let requirement = "large enough against modulus and width to be a number";
        require(scaled > 0.0, "force", force, requirement).map(|_| ())
    }

    /// Refuses a tilt and a moment of a base that fills its period.
    pub(crate) fn require_no_turn(&self) -> Result<(), Error> {
        let (field, value) = self.load.rotational.named();
        let requirement = "zero where the base fills the period: a wave cannot tilt, and a moment does not repeat";
        require(value == 0.0, field, value, requirement).map(|_| ())
    }

    /// Refuses a tilt and a moment of a disk whose pressure would have more than the harmonics 0 and 1 of the angle.
    pub(crate) fn require_one_harmonic(&self) -> Result<(), Error> {
        let exponent = self.bodies.law().exponent();
        let is_mixed = exponent.is_some_and(|exponent| exponent != 1.0);
        let (field, value) = self.load.rotational.named();
        let requirement = "zero for a circular punch on a layer with a power law, which mixes the harmonics of the pressure";
        require(!is_mixed || value == 0.0, field, value, requirement).map(|_| ())
    }

    fn check_profile(&self) -> Result<(), Error> {
        if let Some((xi, defect)) = self.profile().find_not_finite(self.bodies.half_width()) {
            return Err(self.profile_not_finite(xi, defect));
        }
        // Scaling may overflow what is finite in the units of the file.
        for xi in fredholm::basis::chebyshev::points(64) {
            self.finite_profile(xi)?;
        }
        Ok(())
    }

    pub(crate) fn checked(&self, xi: f64, value: f64) -> Result<f64, Error> {
        let defect = if value.is_nan() { Defect::Undefined } else { Defect::Infinite };
        finite("profile", value).map_err(|_| self.profile_not_finite(xi, defect))
    }

    fn profile_not_finite(&self, xi: f64, defect: Defect) -> Error {
        Error::ProfileNotFinite {
            variable: self.bodies.coordinate(),
            at: xi * self.bodies.half_width(),
            defect,
        }
    }
}
