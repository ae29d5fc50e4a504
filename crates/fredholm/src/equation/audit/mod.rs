//! How far a solution of the second kind is from the truth, whatever found it.

mod leaf;
mod norms;
mod residuals;
mod tree;

use super::Solution;
use crate::Error;
use crate::kernel::Kernel;
use crate::quadrature::places::Sampled;
use norms::Norms;
use residuals::Residuals;
use tree::Tree;

/// Lengths of intervals that can be audited.
const LENGTHS: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// What an [`audit`] found: an **estimate** of the error of a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Audit {
    /// Of the largest error of the solution on the closed interval.
    pub solution: f64,
    /// Of the error of the integral; infinite where the solution states none.
    pub integral: f64,
    /// Of `||phi - q||`, the root of the integral of its square by the measure of the kernel, for the solution `q` resampled.
    pub mean_square: f64,
    /// The largest residual that was met.
    pub residual: f64,
    /// What the largest error of the solution is at least, with that residual: a statement below it is wrong.
    pub least: f64,
    /// Number of panels.
    pub panels: usize,
}

/// The error of a solution `q` of `phi + parameter K phi = f`, `parameter >= 0`, for a kernel that is **positive semidefinite** in `L2` of its measure, on a finite interval.
///
/// Then `1 + parameter K >= 1`, and with the residual `r = f - q - parameter K q`
///
/// `||phi - q|| <= ||r||`,
///
/// whatever way `q` was found. Nothing of that way is used: `q` is sampled on panels of the audit's own, graded to the ends, to the breakpoints and to wherever `f` asks for it; `K q` is integrated as the split
/// `K = A sigma + B` asks for it, with exact moments of `sigma`, so that nothing but values of the kernel is shared with the solvers. The residual is looked at until polynomials resolve it. At a point, with any distance `h`,
///
/// `|phi - q| (1 - parameter ||K||_1) <= |r| + parameter ||K||_2 ||r||`
///
/// with the norms of `K(x, .)` within `h` of `x` and beyond it; or, where that is less, `|phi - q| <= |r| + C ||r||` from the continuity of `parameter K (phi - q)`, whose mean square is at most `||r||`. Norms are those of values at places, so that it is an estimate: a feature of `f` that is hidden from all
/// of these is hidden from it. `places` are the breakpoints of `f`, and cuts between which `f` is known to be nearly a polynomial of a degree below 32: it is looked at between all of them.
///
/// ```
/// use fredholm::equation::{audit, collocate};
/// use fredholm::kernel::LogarithmRatioLimit;
///
/// let kernel = LogarithmRatioLimit::new(1.0)?;
/// let solution = collocate(&kernel, 3.0, &|x| x, &[], 1e-12)?;
/// let audit = audit(&kernel, 3.0, &|x| x, [&[], &[]], &solution)?;
/// assert!(audit.solution < 1e-11);
/// # Ok::<(), fredholm::Error>(())
/// ```
///
/// # Errors
/// [`Error::InvalidParameter`] for a negative parameter, where there is no such bound, for an infinite interval, and where the kernel has features so fine that too many panels would be needed;
/// [`Error::NotFinite`] where the right-hand side or the solution is not finite.
pub fn audit(
    kernel: &dyn Kernel,
    parameter: f64,
    f: &dyn Fn(f64) -> f64,
    places: [&[f64]; 2],
    solution: &Solution<'_>,
) -> Result<Audit, Error> {
    let [breakpoints, cuts] = places;
    if !(parameter >= 0.0 && parameter.is_finite()) {
        let requirement =
            "finite and not negative: only then are solutions bounded by their residuals";
        return Err(Error::InvalidParameter { name: "parameter", value: parameter, requirement });
    }
    let interval = kernel.interval();
    if !interval.is_finite() {
        let requirement = "finite: the residual is needed on the whole interval";
        let value = interval.right();
        return Err(Error::InvalidParameter { name: "right end", value, requirement });
    }
    let length = interval.right() - interval.left();
    if !LENGTHS.contains(&length) {
        let requirement =
            "between 1e-100 and 1e100: beyond that squares leave the range of numbers";
        return Err(Error::InvalidParameter { name: "length", value: length, requirement });
    }
    let sampled = Sampled::new(interval, f, cuts)?;
    let tree = Tree::new(kernel, &sampled, f, breakpoints, &|x| solution.evaluate(x))?;
    let found = Residuals::new(&tree, parameter, f, solution)?;
    let mean_square = found.square.sqrt();
    let norms = Norms::new(kernel);
    let integral = solution.integral.map_or(f64::INFINITY, |integral| {
        let own = tree.integral(&|x| kernel.mass_function(x));
        let size = tree.square_of(&|x| kernel.mass_function(x)).sqrt();
        (integral - own).abs() + size * mean_square
    });
    let plain = norms.largest_error(parameter, found.largest, found.misfit, mean_square);
    let smooth =
        norms.continuity(kernel, parameter).map(|factor| found.largest + factor * mean_square);
    Ok(Audit {
        solution: smooth.map_or(plain, |smooth| smooth.min(plain)),
        integral,
        mean_square,
        residual: found.largest,
        least: norms.least_error(parameter, found.largest, found.misfit),
        panels: tree.leaves(),
    })
}
