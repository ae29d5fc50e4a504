//! Equations of the second kind on a kernel that is none of the catalogue.

use fredholm::Interval;
use fredholm::equation::{Solution, collocate_in_parts};
use fredholm::kernel::{Kernel, Singularity};
use serde::Serialize;

use super::definition::{MOST_BREAKS, check_solver};
use super::draft::relative_error;
use super::parts::Parts;
use super::plan::USEFUL;
use super::{EquationErrors, Kind, Samples, places, right_hand_side};
use crate::error::require;
use crate::expression::Expression;
use crate::solver::AIM;
use crate::{Error, ErrorKind, MethodReport, Solver, Warning};

/// A right-hand side `f(x)`.
pub struct RightHandSide<'f> {
    function: Box<dyn Fn(f64) -> f64 + Send + Sync + 'f>,
    formula: Option<Expression>,
}

impl<'f> RightHandSide<'f> {
    /// An expression in `x`: its kinks and jumps are found, and it is looked at in every part on which it is proved to be nearly a polynomial.
    #[must_use]
    pub fn formula(formula: Expression) -> Self {
        let compiled = formula.clone();
        Self { function: Box::new(move |x| compiled.evaluate(&[x])), formula: Some(formula) }
    }

    /// A function of which nothing is known but its values; it should be smooth.
    #[must_use]
    pub fn function(function: impl Fn(f64) -> f64 + Send + Sync + 'f) -> Self {
        Self { function: Box::new(function), formula: None }
    }
}

impl std::fmt::Debug for RightHandSide<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let text = self.formula.as_ref().map(Expression::text);
        formatter.debug_struct("RightHandSide").field("formula", &text).finish_non_exhaustive()
    }
}

/// Solves `phi + lambda int_L K(x, s) phi(s) dm(s) = f` on a kernel of one's own by collocation, and judges the answer as that of an [`Equation`](super::Equation): an explicit
/// tolerance, relative to the largest value of the solution, is met or refused, and a relative error above 1 % is no answer. Errors are estimates.
///
/// The kernel is taken as it is: [`fredholm::conformance::check_kernel`] looks whether it is one.
///
/// ```
/// use fredholm::Interval;
/// use fredholm::kernel::{Kernel, Singularity, Split};
/// use shtaerman::equation::{RightHandSide, solve_own};
///
/// /// `x s`: `phi = f - lambda c x` with `c = int s phi ds`.
/// struct Product;
///
/// impl Kernel for Product {
///     fn interval(&self) -> Interval {
///         Interval::unit()
///     }
///     fn singularity(&self) -> Singularity {
///         Singularity::None
///     }
///     fn split(&self, x: f64, s: f64, _distance: f64) -> Split {
///         Split { factor: 0.0, rest: x * s }
///     }
/// }
///
/// let rhs = RightHandSide::function(|x| x);
/// let solved = solve_own(&Product, 3.0, &rhs, None)?;
/// let phi = solved.answer(&[0.5])?.solution.phi[0].unwrap();
/// assert!((phi - 0.5 / 3.0).abs() < 1e-12);
/// # Ok::<(), shtaerman::Error>(())
/// ```
///
/// # Errors
/// [`Error::InvalidValue`] for a `lambda` that is not finite and a tolerance not between 0 and 1, [`Error::RightHandSide`] for a formula that is not finite, [`Error::Equation`] where
/// `-1/lambda` is an eigenvalue or a value is not finite, [`Error::EquationTolerance`] and [`Error::OwnEquationUnsolved`] for an error that is too large.
pub fn solve_own<'a>(
    kernel: &dyn Kernel,
    lambda: f64,
    rhs: &'a RightHandSide<'a>,
    tolerance: Option<f64>,
) -> Result<SolvedOwn<'a>, Error> {
    require(lambda.is_finite(), "lambda", lambda, "finite")?;
    check_solver(Kind::Second { lambda }, &Solver { tolerance, ..Solver::default() })?;
    let interval = kernel.interval();
    let (mut breaks, mut parts, mut rounding) = (Vec::new(), Parts::default(), 0.0);
    if let Some(formula) = &rhs.formula {
        right_hand_side::require_finite(formula, interval)?;
        breaks = right_hand_side::breakpoints(formula, interval);
        if breaks.len() > MOST_BREAKS {
            breaks.clear();
        }
        parts = Parts::of(formula, interval);
        rounding = right_hand_side::rounding(formula, interval);
    }
    let aim = tolerance.unwrap_or(AIM);
    let places = [&breaks[..], &parts.cuts[..]];
    let mut solution = collocate_in_parts(kernel, lambda, &rhs.function, places, aim)?;
    solution.error.solution += rounding;
    solution.error.integral += rounding * (interval.right() - interval.left());
    let reached = require_error(&solution, tolerance)?;
    let mut warnings: Vec<Warning> = parts.warning().into_iter().collect();
    if tolerance.is_none() && reached > AIM {
        warnings.push(Warning::tolerance_not_met(AIM, reached));
    }
    Ok(SolvedOwn { kernel: OwnKernel::of(kernel), interval, lambda, rhs, solution, warnings })
}

/// The relative error, unless it is above the tolerance or leaves no answer.
fn require_error(solution: &Solution<'_>, tolerance: Option<f64>) -> Result<f64, Error> {
    let (reached, n) = (relative_error(solution), solution.count);
    match tolerance {
        Some(tolerance) if reached <= tolerance => Ok(reached),
        Some(tolerance) => Err(Error::EquationTolerance { tolerance, reached, method: METHOD, n }),
        None if reached <= USEFUL => Ok(reached),
        None => Err(Error::OwnEquationUnsolved { reached, n }),
    }
}

/// How all of them are solved.
const METHOD: &str = "sinc";

/// The solution of an equation on a kernel of one's own.
#[derive(Debug)]
pub struct SolvedOwn<'a> {
    kernel: OwnKernel,
    interval: Interval,
    lambda: f64,
    rhs: &'a RightHandSide<'a>,
    solution: Solution<'a>,
    warnings: Vec<Warning>,
}

impl SolvedOwn<'_> {
    /// `count` places from end to end, denser at the ends.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for fewer than two.
    pub fn places(&self, count: usize) -> Result<Vec<f64>, Error> {
        require(count >= 2, "points", count as f64, "at least 2")?;
        Ok(places::from_end_to_end([self.interval.left(), self.interval.right()], count))
    }

    /// The answer with the solution at places.
    ///
    /// # Errors
    /// [`Error::BeyondInterval`] for a place that is not in the closed interval, [`Error::EquationOverflow`] should a value not be a number.
    pub fn answer(&self, places: &[f64]) -> Result<OwnAnswer<'_>, Error> {
        let value = |x: &f64| {
            let value = self.solution.evaluate(places::within(self.interval, *x)?);
            let overflow = Error::EquationOverflow { quantity: "solution", value };
            if value.is_finite() { Ok(Some(value)) } else { Err(overflow) }
        };
        let phi = places.iter().map(value).collect::<Result<Vec<_>, _>>()?;
        let error = &self.solution.error;
        Ok(OwnAnswer {
            kind: "second",
            lambda: self.lambda,
            rhs: self.rhs.formula.as_ref().map(Expression::text),
            kernel: &self.kernel,
            solution: Samples { x: places.to_vec(), phi },
            integral: self.solution.integral,
            integral_of: "phi",
            method: MethodReport {
                name: METHOD,
                n: self.solution.count,
                reason: "no spectral relation is known of a kernel of one's own: collocation"
                    .to_owned(),
            },
            error: EquationErrors {
                kind: ErrorKind::Estimate,
                solution_sup: Some(error.solution),
                integral: Some(error.integral),
                of: "phi",
            },
            warnings: &self.warnings,
        })
    }
}

/// A solution at chosen points, by the keys of an [`EquationAnswer`](super::EquationAnswer).
#[derive(Debug, Serialize)]
pub struct OwnAnswer<'a> {
    /// `second`.
    pub kind: &'static str,
    /// `lambda`.
    pub lambda: f64,
    /// The right-hand side as it was written; none for a function.
    pub rhs: Option<&'a str>,
    /// What is known of the kernel.
    pub kernel: &'a OwnKernel,
    /// The solution at points.
    pub solution: Samples,
    /// The integral of `integral_of`.
    pub integral: Option<f64>,
    /// What the integral is taken of, by `dx`.
    pub integral_of: &'static str,
    /// How it was solved.
    pub method: MethodReport,
    /// How sure the answer is.
    pub error: EquationErrors,
    /// What a user should know.
    pub warnings: &'a [Warning],
}

/// What is known of a kernel of one's own.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OwnKernel {
    /// `own`.
    pub name: &'static str,
    /// The ends of its interval.
    pub interval: [f64; 2],
    /// The exponent `q` of `|x - s|^-q`: 0 for a logarithm; none for a smooth kernel.
    pub exponent: Option<f64>,
}

impl OwnKernel {
    fn of(kernel: &dyn Kernel) -> Self {
        let (interval, singularity) = (kernel.interval(), kernel.singularity());
        Self {
            name: "own",
            interval: [interval.left(), interval.right()],
            exponent: (singularity != Singularity::None).then(|| singularity.exponent()),
        }
    }
}
