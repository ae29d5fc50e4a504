//! How a problem is to be solved.

use std::time::Duration;

use crate::Error;
use crate::error::require;

/// Relative error that is aimed at where no tolerance is given.
pub const AIM: f64 = 1e-12;
/// Where `theta0` is so many times the last degree of a series, none leaves less than 1e-2 of the pressure (survey: 3e-2 at 61 times, 2e-3 at 15 times).
pub(crate) const UNRESOLVED: f64 = 32.0;

/// Memory that a degree of the degenerate kernel takes at the peak of a solve with its answer, in bytes: measured 740 to 1490 for one to five million
/// degrees (`/usr/bin/time -v shtaerman solve examples/crowned_punch.toml --set solver.contact=bilateral --set solver.method=spectral --set solver.n=N`).
const BYTES_A_DEGREE: f64 = 1600.0;

/// Share of the free memory that a solve may take.
const MEMORY_SHARE: f64 = 0.9;

/// Refuses a degree whose solve would not fit into memory, before anything is allocated.
pub(crate) fn check_memory(degree: usize) -> Result<(), Error> {
    let available = fredholm::memory::available();
    let needed = BYTES_A_DEGREE * degree as f64;
    if needed > MEMORY_SHARE * available as f64 {
        return Err(fredholm::Error::TooLarge { degree, needed: needed as u64, available }.into());
    }
    Ok(())
}

/// The highest degree whose solve fits into so much free memory.
pub(crate) fn most_degree(available: u64) -> usize {
    (MEMORY_SHARE * available as f64 / BYTES_A_DEGREE) as usize
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

/// How the equation is to be solved; without one the punch may lift off, the method is that which suits the problem, and a relative error of `1e-12` is aimed at.
///
/// ```
/// use shtaerman::Solver;
///
/// let kept_in_contact = Solver::bilateral().with_tolerance(1e-9)?;
/// let degenerate_kernel = Solver::spectral(256)?;
/// assert!(Solver::spectral(0).is_err());
/// # Ok::<(), shtaerman::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Solver {
    pub(crate) contact: ContactKind,
    pub(crate) method: MethodChoice,
    pub(crate) degree: Option<usize>,
    pub(crate) tolerance: Option<f64>,
    pub(crate) time_limit: Option<Duration>,
}

impl Solver {
    /// The punch may lift off.
    #[must_use]
    pub fn unilateral() -> Self {
        Self::default()
    }

    /// The full base stays in contact.
    #[must_use]
    pub fn bilateral() -> Self {
        Self { contact: ContactKind::Bilateral, ..Self::default() }
    }

    /// The degenerate kernel with a fixed [degree](Self::degree), on the full base.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for 0.
    pub fn spectral(degree: usize) -> Result<Self, Error> {
        Self::bilateral().with_method(MethodChoice::Spectral)?.with_degree(degree)
    }

    /// The same for another kind of contact.
    #[must_use]
    pub fn with_contact(self, contact: ContactKind) -> Self {
        Self { contact, ..self }
    }

    /// The same by another method.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for [`MethodChoice::Sinc`] where a degree is given.
    pub fn with_method(self, method: MethodChoice) -> Result<Self, Error> {
        Self { method, ..self }.checked()
    }

    /// The same with a fixed [degree](Self::degree).
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for 0, and where the method is [`MethodChoice::Sinc`].
    pub fn with_degree(self, degree: usize) -> Result<Self, Error> {
        Self { degree: Some(degree), ..self }.checked()
    }

    /// The same with a [tolerance](Self::tolerance) that must be met.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless it is greater than 0 and less than 1.
    pub fn with_tolerance(self, tolerance: f64) -> Result<Self, Error> {
        Self { tolerance: Some(tolerance), ..self }.checked()
    }

    /// The same with a [limit of the time](Self::time_limit) that the search for an answer may take.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a limit of 0.
    pub fn with_time_limit(self, limit: Duration) -> Result<Self, Error> {
        Self { time_limit: Some(limit), ..self }.checked()
    }

    /// Whether the punch may lift off.
    #[must_use]
    pub fn contact(&self) -> ContactKind {
        self.contact
    }

    /// The method.
    #[must_use]
    pub fn method(&self) -> MethodChoice {
        self.method
    }

    /// Highest Chebyshev degree kept in the degenerate kernel, the paper's `n` and the key `n` of problem files, where it is fixed. Contacts other than that of one plane punch on a linear layer
    /// and a half-plane have no degenerate kernel: problem files refuse it there, here it is of no effect.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.degree
    }

    /// Relative error to be met, of settlement, tilt and of the pressure over its largest value; where there is none, `1e-12` is aimed at.
    #[must_use]
    pub fn tolerance(&self) -> Option<f64> {
        self.tolerance
    }

    /// How long the search for an answer may take, after which it ends with [`Error::TimeLimit`] at its next step; none by default. What a run comes to then depends on the machine.
    #[must_use]
    pub fn time_limit(&self) -> Option<Duration> {
        self.time_limit
    }

    fn checked(self) -> Result<Self, Error> {
        if let Some(degree) = self.degree {
            require(degree > 0, "n", 0.0, "at least 1")?;
            let spectral = self.method != MethodChoice::Sinc;
            require(spectral, "n", degree as f64, "left out: it belongs to method = \"spectral\"")?;
        }
        if let Some(tolerance) = self.tolerance {
            let sensible = tolerance.is_finite() && tolerance > 0.0 && tolerance < 1.0;
            require(sensible, "tolerance", tolerance, "greater than 0 and less than 1")?;
        }
        if let Some(limit) = self.time_limit {
            let requirement = "greater than 0 seconds";
            require(!limit.is_zero(), "time_limit", limit.as_secs_f64(), requirement)?;
        }
        Ok(self)
    }
}
