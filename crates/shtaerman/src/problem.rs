//! A contact problem, physical or dimensionless.

use fredholm::basis::Function;

use crate::error::{finite, require};
use crate::expression::Defect;
use crate::{Elastic, Error, Load, Profile, Scaling};

/// Chebyshev degrees for each measured point, so that none falls between the first samples.
const POINTS_PER_SAMPLE: usize = 4;

/// In which units a problem is stated.
#[derive(Debug, Clone, PartialEq)]
pub enum Frame {
    /// SI units, (2.3).
    Physical {
        /// Material of the foundation.
        foundation: Elastic,
        /// Material of an elastic punch; `None` for a rigid one.
        body: Option<Elastic>,
        /// Scales that follow.
        scaling: Scaling,
    },
    /// Numbers without dimension, (2.5); `theta0 = 0` is the pure layer.
    Dimensionless {
        /// `theta0 = 2 a/(pi E* chi)`.
        theta0: f64,
    },
}

impl Frame {
    /// A foundation with roughness compliance `chi` (m/Pa) under a punch of half-width `a` (m), rigid or elastic.
    ///
    /// # Errors
    /// Those of [`Scaling::new`].
    pub fn physical(
        foundation: Elastic,
        roughness: f64,
        half_width: f64,
        body: Option<Elastic>,
    ) -> Result<Self, Error> {
        let scaling = Scaling::new(&foundation, roughness, half_width, body.as_ref())?;
        Ok(Self::Physical { foundation, body, scaling })
    }

    /// The dimensionless problem at `theta0`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `theta0` is finite and not negative.
    pub fn dimensionless(theta0: f64) -> Result<Self, Error> {
        require(theta0.is_finite() && theta0 >= 0.0, "theta0", theta0, "finite and not negative")?;
        Ok(Self::Dimensionless { theta0 })
    }

    /// `theta0`.
    #[must_use]
    pub fn theta0(&self) -> f64 {
        match self {
            Self::Physical { scaling, .. } => scaling.theta0(),
            Self::Dimensionless { theta0 } => *theta0,
        }
    }

    /// The scales of a physical problem.
    #[must_use]
    pub fn scaling(&self) -> Option<&Scaling> {
        match self {
            Self::Physical { scaling, .. } => Some(scaling),
            Self::Dimensionless { .. } => None,
        }
    }

    /// Half-width in the units of the problem: metres, or 1.
    #[must_use]
    pub fn half_width(&self) -> f64 {
        self.scaling().map_or(1.0, Scaling::half_width)
    }

    /// Name of the coordinate in the units of the problem: `x` or `xi`.
    #[must_use]
    pub fn coordinate(&self) -> &'static str {
        if self.scaling().is_some() { "x" } else { "xi" }
    }
}

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

/// How the equation is to be solved.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Solver {
    /// The method.
    pub method: MethodChoice,
    /// Highest Chebyshev degree kept in the degenerate kernel, the paper's `n`; fixes the truncation. Not for [`MethodChoice::Sinc`].
    pub degree: Option<usize>,
    /// Relative error to be met, of settlement, tilt and of the pressure over its largest value; without it `1e-12` is aimed at.
    pub tolerance: Option<f64>,
}

impl Solver {
    /// The degenerate kernel with a fixed degree.
    #[must_use]
    pub fn spectral(degree: usize) -> Self {
        Self { method: MethodChoice::Spectral, degree: Some(degree), tolerance: None }
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

/// A punch, what it stands on and what is prescribed. The contact is bilateral: the full base stays in contact.
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

    /// `f0(xi) = f(a xi)/(chi E)`, for a dimensionless problem the profile itself.
    #[must_use]
    pub fn dimensionless_profile(&self, xi: f64) -> f64 {
        let half_width = self.frame.half_width();
        let height = self.profile.height(xi, half_width);
        self.frame.scaling().map_or(height, |scaling| height / scaling.displacement())
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

    fn checked(&self, xi: f64, value: f64) -> Result<f64, Error> {
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
