//! The second kind on the half-line.

use super::{ErrorStatement, Method, Solution, checks};
use crate::bounds::Kind;
use crate::collocation::solve_half_line_in_parts;
use crate::kernel::MacdonaldHalfLine;
use crate::{Error, Interval};

/// Intervals between the points at which the largest value is looked for.
const CHECKS: usize = 257;

/// `phi + parameter K phi = f` on the half-line, for `0 <= x <= reach`, by collocation on a finite section; the solution is NaN beyond `reach`, where nothing is known.
/// The integral is that over the whole half-line, where it exists.
///
/// # Errors
/// As [`solve_half_line`](crate::collocation::solve_half_line).
pub fn collocate_half_line<'a>(
    kernel: &MacdonaldHalfLine,
    parameter: f64,
    f: &'a (dyn Fn(f64) -> f64 + Sync),
    reach: f64,
    tolerance: f64,
) -> Result<Solution<'a>, Error> {
    collocate_half_line_in_parts(kernel, parameter, f, &[], [reach, tolerance])
}

/// [`collocate_half_line`] for a right-hand side that is known to be nearly a polynomial of a degree below 32 on each of the parts into which cuts divide the section that is solved: it is looked
/// at in every part. The limits are `reach` and `tolerance`.
///
/// # Errors
/// As [`collocate_half_line`].
pub fn collocate_half_line_in_parts<'a>(
    kernel: &MacdonaldHalfLine,
    parameter: f64,
    f: &'a (dyn Fn(f64) -> f64 + Sync),
    cuts: &[f64],
    [reach, tolerance]: [f64; 2],
) -> Result<Solution<'a>, Error> {
    let solution = solve_half_line_in_parts(kernel, parameter, f, cuts, [reach, tolerance])?;
    let estimate = *solution.estimate();
    let largest = if reach > 0.0 {
        checks(Interval::new(0.0, reach)?, CHECKS)
            .map(|x| solution.evaluate(x, f(x)).abs())
            .fold(0.0, f64::max)
    } else {
        solution.evaluate(0.0, f(0.0)).abs()
    };
    Ok(Solution {
        integral: solution.integral(),
        error: ErrorStatement {
            kind: Kind::Estimate,
            solution: estimate.solution,
            integral: estimate.integral,
        },
        method: Method::Sinc,
        count: solution.node_count(),
        converged: solution.converged(),
        largest,
        value: Box::new(move |x| solution.evaluate(x, f(x))),
    })
}
