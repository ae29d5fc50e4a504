//! The second kind by collocation.

use super::{ErrorStatement, Method, Solution, checks};
use crate::Error;
use crate::bounds::Kind;
use crate::collocation::{AdaptiveSolution, solve_adaptive_with_breaks, solve_half_line};
use crate::kernel::{Kernel, MacdonaldHalfLine};

/// Intervals between the points that tell the size of a solution.
const CHECKS: usize = 257;

/// `phi + parameter K phi = f` to a tolerance relative to the largest value of the solution, by collocation on growing numbers of nodes; `breakpoints` are where `f` has kinks
/// or jumps.
///
/// # Errors
/// As [`solve_adaptive_with_breaks`]; [`Error::Singular`] where `-1/parameter` is an eigenvalue. A tolerance out of reach is no error: see [`Solution::converged`].
pub fn collocate<'a>(
    kernel: &(impl Kernel + ?Sized),
    parameter: f64,
    f: &'a dyn Fn(f64) -> f64,
    breakpoints: &[f64],
    tolerance: f64,
) -> Result<Solution<'a>, Error> {
    let AdaptiveSolution { solution, estimate, converged, half_count } =
        solve_adaptive_with_breaks(kernel, breakpoints, parameter, f, tolerance)?;
    let integral = solution.integral(|x| kernel.mass_function(x));
    let largest = solution.values().iter().fold(0.0f64, |most, value| most.max(value.abs()));
    Ok(Solution {
        integral: Some(integral),
        error: ErrorStatement {
            kind: Kind::Estimate,
            solution: estimate.solution,
            integral: estimate.integral,
        },
        method: Method::Sinc,
        count: (2 * half_count + 1) * (breakpoints.len() + 1),
        converged,
        largest,
        value: Box::new(move |x| solution.evaluate(x, f(x))),
    })
}

/// The same on the half-line, for `0 <= x <= x_max`.
///
/// # Errors
/// As [`solve_half_line`].
pub fn collocate_half_line<'a>(
    kernel: &MacdonaldHalfLine,
    parameter: f64,
    f: &'a dyn Fn(f64) -> f64,
    x_max: f64,
    tolerance: f64,
) -> Result<Solution<'a>, Error> {
    let solution = solve_half_line(kernel, parameter, f, x_max, tolerance)?;
    let values = checks(kernel.extent(), CHECKS)
        .filter(|x| *x <= x_max)
        .map(|x| solution.evaluate(x, f(x)).abs());
    Ok(Solution {
        integral: solution.integral(),
        error: ErrorStatement {
            kind: Kind::Estimate,
            solution: solution.estimate().solution,
            integral: solution.estimate().integral,
        },
        method: Method::Sinc,
        count: solution.node_count(),
        converged: solution.converged(),
        largest: values.fold(0.0, f64::max),
        value: Box::new(move |x| solution.evaluate(x, f(x))),
    })
}
