//! The second kind by collocation.

use super::{ErrorStatement, Method, Solution};
use crate::Error;
use crate::bounds::Kind;
use crate::collocation::{AdaptiveSolution, solve_adaptive_in_parts};
use crate::kernel::Kernel;

/// `phi + parameter K phi = f` to a tolerance relative to the largest value of the solution, by collocation on growing numbers of nodes; `breakpoints` are where `f` has kinks
/// or jumps.
///
/// `f` is looked at between the nodes of collocation, and what they miss of it is resolved or stated; what it can hide all the same is told at
/// [`solve_adaptive`](crate::collocation::solve_adaptive).
///
/// # Errors
/// As [`solve_adaptive_in_parts`]; [`Error::Singular`] where `-1/parameter` is an eigenvalue. A tolerance out of reach is no error: see [`Solution::converged`].
pub fn collocate<'a>(
    kernel: &dyn Kernel,
    parameter: f64,
    f: &'a (dyn Fn(f64) -> f64 + Sync),
    breakpoints: &[f64],
    tolerance: f64,
) -> Result<Solution<'a>, Error> {
    collocate_in_parts(kernel, parameter, f, [breakpoints, &[]], tolerance)
}

/// [`collocate`] for a right-hand side that is known to be nearly a polynomial of a degree below 32 on each of the parts into which cuts divide the interval
/// ([`solve_adaptive_in_parts`]); `places` are the breakpoints and the cuts.
///
/// # Errors
/// As [`collocate`].
pub fn collocate_in_parts<'a>(
    kernel: &dyn Kernel,
    parameter: f64,
    f: &'a (dyn Fn(f64) -> f64 + Sync),
    places: [&[f64]; 2],
    tolerance: f64,
) -> Result<Solution<'a>, Error> {
    let [breakpoints, cuts] = places;
    let AdaptiveSolution { solution, estimate, converged, .. } =
        solve_adaptive_in_parts(kernel, breakpoints, cuts, parameter, f, tolerance)?;
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
        count: solution.values().len(),
        converged,
        largest,
        value: Box::new(move |x| solution.evaluate(x, f(x))),
    })
}
