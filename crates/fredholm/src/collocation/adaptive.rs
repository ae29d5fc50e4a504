//! The number of nodes chosen by the estimate of the error.

use std::f64::consts::SQRT_2;

use super::estimate::{largest, rounding};
use super::operator::require_finite_parameter;
use super::{Estimate, SincOperator, SincSolution};
use crate::Error;
use crate::kernel::Kernel;

/// Growth of the number of nodes.
const RATIO: f64 = SQRT_2;
/// Most nodes on either side of the middle of a panel.
const LARGEST_HALF_COUNT: usize = 1500;
/// Most nodes on either side of the middles of all panels together.
const LARGEST_TOTAL: usize = 3999;
/// Differences that no longer fall and are below this share of the solution are rounding.
const STAGNANT: f64 = 1e-9;

/// A solution with the estimate of its error.
#[derive(Debug, Clone)]
pub struct AdaptiveSolution {
    /// The solution on the finest nodes.
    pub solution: SincSolution,
    /// The estimate of its error.
    pub estimate: Estimate,
    /// Whether the estimate meets the tolerance; if not, this is the best that was reached.
    pub converged: bool,
    /// Nodes on either side of the middle of each panel.
    pub half_count: usize,
}

/// Solves `phi + parameter K phi = f` to a tolerance relative to the largest value of the solution, by collocation on
/// growing numbers of nodes.
///
/// The error is judged from three solutions, between their nodes as well as at them.
///
/// ```
/// use fredholm::collocation::solve_adaptive;
/// use fredholm::kernel::Logarithm;
///
/// let found = solve_adaptive(&Logarithm::unit(), 60.0, f64::exp, 1e-11)?;
/// assert!(found.converged && found.estimate.solution < 1e-11);
/// let exact = 0.029_684_678_799_719_241; // mpmath, 40 digits
/// assert!((found.solution.integral(|_| 1.0) - exact).abs() < 1e-13);
/// # Ok::<(), fredholm::Error>(())
/// ```
///
/// # Errors
/// [`Error::InvalidParameter`] for a tolerance that is not positive or a parameter that is not finite; as
/// [`SincOperator::sample`] and [`SincOperator::factor`]. A tolerance that is out of reach is no error: see
/// [`AdaptiveSolution::converged`].
pub fn solve_adaptive(
    kernel: &(impl Kernel + ?Sized),
    parameter: f64,
    f: impl Fn(f64) -> f64,
    tolerance: f64,
) -> Result<AdaptiveSolution, Error> {
    solve_adaptive_with_breaks(kernel, &[], parameter, f, tolerance)
}

/// [`solve_adaptive`] for a right-hand side with kinks or jumps at the breakpoints.
///
/// # Errors
/// As [`solve_adaptive`]; [`Error::InvalidParameter`] for a bad breakpoint.
pub fn solve_adaptive_with_breaks(
    kernel: &(impl Kernel + ?Sized),
    breaks: &[f64],
    parameter: f64,
    f: impl Fn(f64) -> f64,
    tolerance: f64,
) -> Result<AdaptiveSolution, Error> {
    require_finite_parameter(parameter)?;
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::InvalidParameter {
            name: "tolerance",
            value: tolerance,
            requirement: "finite and positive",
        });
    }
    let solve = |half_count: usize| {
        let operator = SincOperator::with_breaks(kernel, half_count, breaks)?;
        operator.factor(parameter)?.solve(&operator.sample(&f)?)
    };
    let most = LARGEST_HALF_COUNT.min(LARGEST_TOTAL / (breaks.len() + 1));
    let start = first_half_count(parameter * kernel.interval().half_length())
        .max(kernel.first_half_count());
    let mut sequence = half_counts(start).take_while(|half_count| *half_count <= most);
    let mut next = || sequence.next();
    let (Some(n1), Some(n2), Some(n3)) = (next(), next(), next()) else {
        return Err(Error::InvalidParameter {
            name: "number of breakpoints",
            value: breaks.len() as f64,
            requirement: "few enough for 2 * half_count + 1 nodes on each panel",
        });
    };
    let mass = |x: f64| kernel.mass_function(x);
    let (first, mut previous) = (solve(n1)?, solve(n2)?);
    let mut before = Estimate::weighted(&first, &previous, &mass)?;
    let mut half_count = n3;
    loop {
        let solution = solve(half_count)?;
        let difference = Estimate::weighted(&previous, &solution, &mass)?;
        let estimate = Estimate::extrapolated(&before, &difference, &solution, RATIO);
        let scale = largest(solution.values());
        let converged = estimate.solution <= tolerance * scale;
        let rounding = rounding(&solution);
        let stagnant = difference.solution > 0.5 * before.solution;
        let out_of_reach = rounding > tolerance * scale;
        let settled = difference.solution <= rounding
            || (stagnant && (out_of_reach || difference.solution <= STAGNANT * scale));
        match next() {
            Some(larger) if !converged && !settled => half_count = larger,
            _ => return Ok(AdaptiveSolution { solution, estimate, converged, half_count }),
        }
        previous = solution;
        before = difference;
    }
}

/// Nodes on either side of the middle that give about 13 digits for the logarithm and a right-hand side of a few terms; `strength` is
/// `lambda` times the half-length. Measured.
#[must_use]
pub fn first_half_count(strength: f64) -> f64 {
    let decades = strength.abs().max(1.0).log10();
    (22.0 + 16.0 * decades).min(160.0)
}

/// Two coarser numbers, the start, and ever larger ones.
fn half_counts(start: f64) -> impl Iterator<Item = usize> {
    (-2..).map(move |power| ((start * RATIO.powi(power)).round() as usize).max(4))
}
