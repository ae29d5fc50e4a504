//! A contact problem, physical or dimensionless.

use fredholm::basis::Function;

use crate::error::{finite, require};
use crate::expression::{Defect, Interval, Reflection, remainder_of_sum};
use crate::profile::Resolution;
use crate::{Error, Frame, Load, Profile, Rotational, Vertical};

/// Chebyshev degrees for each measured point, so that none falls between the first samples.
const POINTS_PER_SAMPLE: usize = 4;

/// The method that solves the equation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MethodChoice {
    /// The one that suits the problem.
    #[default]
    Auto,
    /// The paper's degenerate kernel.
    Spectral,
    /// Sinc collocation.
    Sinc,
}

/// Whether the punch may lift off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ContactKind {
    /// The pressure never pulls: the zones of contact are part of the answer.
    #[default]
    Unilateral,
    /// The full base stays in contact and the pressure may pull.
    Bilateral,
}

impl ContactKind {
    /// Name as in problem files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Unilateral => "unilateral",
            Self::Bilateral => "bilateral",
        }
    }
}

/// How the equation is to be solved.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Solver {
    /// Whether the punch may lift off.
    pub contact: ContactKind,
    /// The method.
    pub method: MethodChoice,
    /// Highest Chebyshev degree kept in the degenerate kernel, the paper's `n`; fixes the truncation. Not for [`MethodChoice::Sinc`].
    pub degree: Option<usize>,
    /// Relative error to be met, of settlement, tilt and of the pressure over its largest value; without it `1e-12` is aimed at.
    pub tolerance: Option<f64>,
}

impl Solver {
    /// The degenerate kernel with a fixed degree, on the full base.
    #[must_use]
    pub fn spectral(degree: usize) -> Self {
        Self { method: MethodChoice::Spectral, degree: Some(degree), ..Self::bilateral() }
    }

    /// The full base stays in contact.
    #[must_use]
    pub fn bilateral() -> Self {
        Self { contact: ContactKind::Bilateral, ..Self::default() }
    }

    fn check(&self) -> Result<(), Error> {
        if let Some(degree) = self.degree {
            require(degree > 0, "n", 0.0, "at least 1")?;
            let spectral = self.method != MethodChoice::Sinc;
            require(spectral, "n", degree as f64, "left out: it belongs to method = \"spectral\"")?;
        }
        if let Some(tolerance) = self.tolerance {
            let sensible = tolerance.is_finite() && tolerance > 0.0 && tolerance < 1.0;
            require(sensible, "tolerance", tolerance, "greater than 0 and less than 1")?;
        }
        Ok(())
    }
}

/// A punch, what it stands on and what is prescribed.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    frame: Frame,
    profile: Profile,
    load: Load,
    solver: Solver,
}

impl Problem {
    /// The problem; profile and load are in the units of the frame.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for `degree = 0` or a load that is not finite once scaled, [`Error::ProfileNotFinite`] where the profile
    /// is not finite on the closed punch.
    pub fn new(frame: Frame, profile: Profile, load: Load, solver: Solver) -> Result<Self, Error> {
        solver.check()?;
        if let Some(scaling) = frame.scaling() {
            let scaled = scaling.load(&load);
            Load::new(scaled.vertical, scaled.rotational)?;
        }
        let half_width = frame.half_width();
        let is_wave = frame.geometry().is_wave(half_width);
        let profile = if is_wave { profile.repeating(half_width) } else { profile };
        let problem = Self { frame, profile, load, solver };
        problem.check_profile()?;
        Ok(problem)
    }

    /// Units and material.
    #[must_use]
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// Base of the punch.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// What is prescribed, in the units of the frame.
    #[must_use]
    pub fn load(&self) -> &Load {
        &self.load
    }

    /// What is prescribed, without dimensions.
    #[must_use]
    pub fn dimensionless_load(&self) -> Load {
        self.frame.scaling().map_or(self.load, |scaling| scaling.load(&self.load))
    }

    /// How it is to be solved.
    #[must_use]
    pub fn solver(&self) -> &Solver {
        &self.solver
    }

    /// The same problem for the degenerate kernel of another degree.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for zero.
    pub fn with_degree(&self, degree: usize) -> Result<Self, Error> {
        let solver = Solver::spectral(degree);
        solver.check()?;
        Ok(Self { solver, ..self.clone() })
    }

    /// The same problem under another load, in the units of the problem.
    pub(crate) fn under(&self, load: Load) -> Self {
        Self { load, ..self.clone() }
    }

    /// The same problem solved otherwise.
    pub(crate) fn with_solver(&self, solver: Solver) -> Self {
        Self { solver, ..self.clone() }
    }

    /// The same problem with heights and settlement counted from the level of the base, and the height of that level in the units of the problem; none where that
    /// makes no difference.
    pub(crate) fn lowered(&self) -> Option<(Self, f64)> {
        let (profile, level) = self.profile.lowered(self.frame.half_width())?;
        let (vertical, profile) = match self.load.vertical {
            Vertical::Force(force) => (Vertical::Force(force), profile),
            // What rounding takes from the settlement is left to the heights.
            Vertical::Settlement(settlement) => (
                Vertical::Settlement(settlement - level),
                profile.raised(-remainder_of_sum(settlement, -level)),
            ),
        };
        let load = Load { vertical, ..self.load };
        Some((Self { profile, load, ..self.clone() }, level))
    }

    /// `f0(xi) = f(a xi)/(chi E)`, for a dimensionless problem the profile itself.
    #[must_use]
    pub fn dimensionless_profile(&self, xi: f64) -> f64 {
        let half_width = self.frame.half_width();
        let height = self.profile.height(xi, half_width);
        self.frame.scaling().map_or(height, |scaling| height / scaling.displacement())
    }

    /// `df0/dxi`.
    pub(crate) fn dimensionless_slope(&self, xi: f64) -> Option<f64> {
        let slope = self.profile.slope(xi, self.frame.half_width())?;
        Some(self.frame.scaling().map_or(slope, |scaling| slope / scaling.displacement()))
    }

    /// `f0(xi) - f0(c) - f0'(c) (xi - c)`.
    pub(crate) fn dimensionless_rise(&self, c: f64, xi: f64) -> f64 {
        let rise = self.profile.rise(c, xi - c, self.frame.half_width());
        self.frame.scaling().map_or(rise, |scaling| rise / scaling.displacement())
    }

    /// Encloses `f0(xi)` on an interval, as [`Profile::enclose`] does.
    #[must_use]
    pub fn dimensionless_enclosure(&self, interval: [f64; 2]) -> Option<Interval> {
        self.profile.enclose(interval, self.frame.half_width()).map(|range| self.scaled(range))
    }

    /// Encloses the exact and the computed `f0(xi)` at one place, as [`Profile::enclose_at`] does.
    #[must_use]
    pub fn dimensionless_enclosure_at(&self, xi: f64) -> Option<Interval> {
        let range = self.profile.enclose_at(xi, self.frame.half_width());
        range.map(|range| self.scaled(range))
    }

    /// Encloses `f0^(k)/k!` for `k` from 0 to `order` on an interval, as [`Profile::taylor`] does.
    #[must_use]
    pub fn dimensionless_taylor(&self, interval: [f64; 2], order: usize) -> Option<Vec<Interval>> {
        let terms = self.profile.taylor(interval, order, self.frame.half_width())?;
        Some(terms.into_iter().map(|term| self.scaled(term)).collect())
    }

    /// Bounds `|f0^(n)|/n!` on an interval, as [`Profile::taylor_bound`] does.
    #[must_use]
    pub fn dimensionless_taylor_bound(&self, interval: [f64; 2], order: usize) -> f64 {
        let bound = self.profile.taylor_bound(interval, order, self.frame.half_width());
        self.scaled(Interval::ends(0.0, bound)).upper()
    }

    /// Where the base has to be cut so that polynomials of a degree resolve the profile, as [`Profile::resolve`] has it.
    #[must_use]
    pub fn resolution(&self, degree: usize, tolerance: f64) -> Resolution {
        let half_width = self.frame.half_width();
        self.profile.resolve(&self.frame.pieces(), half_width, degree, tolerance)
    }

    /// Heights without dimensions.
    fn scaled(&self, heights: Interval) -> Interval {
        self.frame.scaling().map_or(heights, |scaling| {
            let displacement = scaling.displacement();
            heights.over(Interval::ends(displacement, displacement)).0
        })
    }

    /// Whether the base is proved to be its own mirror image, or its negative.
    pub(crate) fn reflection(&self) -> Reflection {
        self.profile.reflection(self.frame.half_width())
    }

    /// Whether base and load are proved to be their own mirror images.
    pub(crate) fn is_symmetric(&self) -> bool {
        let level = match self.load.rotational {
            Rotational::Moment(value)
            | Rotational::Eccentricity(value)
            | Rotational::Tilt(value) => value == 0.0,
        };
        // A circular base is a body of revolution, or refused.
        level && (self.frame.is_circular() || self.reflection().is_even)
    }

    /// The relative error that is aimed at where no tolerance is given: `1e-12 max(1, theta0/10)`, of measured profiles `1e-10 max(1, theta0/100)`: rounding grows with `theta0`.
    pub(crate) fn aim(&self) -> f64 {
        let theta0 = self.frame.theta0();
        if self.profile.measured_points().is_some() {
            return 1e-10 * (theta0 / 100.0).max(1.0);
        }
        crate::AIM * (theta0 / 10.0).max(1.0)
    }

    /// Whether the base fills the whole period of a row.
    pub(crate) fn is_wave(&self) -> bool {
        self.frame.geometry().is_wave(self.frame.half_width())
    }

    /// The profile resolved by a Chebyshev series in `xi`.
    pub(crate) fn resolved_profile(&self) -> Result<Function, Error> {
        let degree = POINTS_PER_SAMPLE * self.profile.measured_points().unwrap_or(0);
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
        self.load.check_balance(self.frame.half_width())?;
        let (Vertical::Force(scaled), Vertical::Force(force)) =
            (self.dimensionless_load().vertical, self.load.vertical)
        else {
            return Ok(());
        };
        let requirement = "large enough against modulus and width to be a number";
        require(scaled > 0.0, "force", force, requirement).map(|_| ())
    }

    fn check_profile(&self) -> Result<(), Error> {
        if let Some((xi, defect)) = self.profile.find_not_finite(self.frame.half_width()) {
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
            variable: self.frame.coordinate(),
            at: xi * self.frame.half_width(),
            defect,
        }
    }
}
