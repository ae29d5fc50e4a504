//! The Macdonald kernel on the half-line, by collocation on a finite section.
//!
//! The kernel decays as `e^(-kappa d)`, and so does the influence of what lies beyond a section `(0, X)`: the values on `(0, x_max)`
//! change by about `e^(-rate (X - x_max))`. For `lambda >= 0` the rate is `kappa`; for `lambda < 0` it is `p`, the zero of the symbol
//! `1 + lambda G^(i p)`, `p^2 = kappa^2 - (|lambda| G)^(1/delta)`, `G = sqrt(pi) (2 kappa)^-mu Gamma(delta)`, `delta = 1/2 - mu`, which closes in on 0 as `lambda`
//! approaches the spectrum. Any bounded right-hand side will do, a constant too.
//!
//! The nodes crowd doubly exponentially at 0 and are equidistant far out, where nothing happens: half as many as the symmetric map needs, in a
//! matrix that is a band there. The section ends in a smooth taper, because the sinc functions of a sharp end ring far into it.
//!
//! The integral over the half-line comes from integrating the equation: with `T(s) = int_s^inf K(u) du`,
//!
//! `(1 + lambda G^(0)) int phi dx = int f dx + lambda int T phi ds`,
//!
//! where `T` decays: what is unknown far out does not count.

mod integral;
mod map;
mod misfit;
mod problem;
mod section;
mod solution;

pub use solution::{HalfLineEstimate, HalfLineSolution};

use problem::Problem;

use super::operator::require_finite_parameter;
use crate::Error;
use crate::kernel::MacdonaldHalfLine;

/// Solves `phi + parameter int_0^inf K phi ds = f` on the half-line for `0 <= x <= x_max`, to a tolerance relative to the largest value of the solution on
/// the section; `f` must be bounded, and is asked for values on the whole half-line for the sake of the integral.
///
/// The error is judged from solutions on growing numbers of nodes, between the nodes, on sections of different lengths, and from the values of `f` at 6000 places of the section between all nodes;
/// a feature narrower than about a 4000th of the section may be hidden from these too, and beyond the section only the integral of `f` is asked for. 4 to 20 ms for a parameter and a range
/// of the order of 1 (in units of the decay length).
///
/// ```
/// use fredholm::collocation::solve_half_line;
/// use fredholm::kernel::MacdonaldHalfLine;
///
/// let kernel = MacdonaldHalfLine::new(0.0, 1.0)?;
/// let f = |x: f64| (-0.5 * x).exp();
/// let solution = solve_half_line(&kernel, 0.5, f, 5.0, 1e-12)?;
/// // Wiener and Hopf, 30 digits.
/// assert!((solution.evaluate(0.0, f(0.0)) - 0.680_792_167_935_991_56).abs() < 1e-13);
/// assert!((solution.evaluate(5.0, f(5.0)) - 0.029_339_584_916_497_104).abs() < 1e-13);
/// assert!((solution.integral().unwrap() - 0.849_201_418_903_122_5).abs() < 1e-13);
///
/// let constant = solve_half_line(&kernel, 1.0, |_| 1.0, 5.0, 1e-12)?;
/// assert!((constant.evaluate(5.0, 1.0) - 0.241_501_430_464_806_35).abs() < 1e-13);
/// assert_eq!(constant.integral(), None);
/// # Ok::<(), fredholm::Error>(())
/// ```
///
/// # Errors
/// [`Error::InSpectrum`] for a parameter at or below `-1/G^(0)`, [`Error::InvalidParameter`] for one that is not finite, for `x_max` negative or not
/// finite, and for a tolerance that is not positive; [`Error::BeyondMethod`] for one too far; [`Error::NotFinite`] when `f` is not finite on the section. A tolerance that is out of reach is
/// no error: see [`HalfLineSolution::converged`].
pub fn solve_half_line(
    kernel: &MacdonaldHalfLine,
    parameter: f64,
    f: impl Fn(f64) -> f64,
    x_max: f64,
    tolerance: f64,
) -> Result<HalfLineSolution, Error> {
    solve_half_line_in_parts(kernel, parameter, f, &[], [x_max, tolerance])
}

/// [`solve_half_line`] for a right-hand side that is known to be nearly a polynomial of a degree below 32 on each of the parts into which cuts divide the section: it is looked at in every part. The
/// limits are `x_max` and `tolerance`.
///
/// # Errors
/// As [`solve_half_line`].
pub fn solve_half_line_in_parts(
    kernel: &MacdonaldHalfLine,
    parameter: f64,
    f: impl Fn(f64) -> f64,
    cuts: &[f64],
    [x_max, tolerance]: [f64; 2],
) -> Result<HalfLineSolution, Error> {
    require_finite_parameter(parameter)?;
    let end = kernel.decay() * x_max;
    require(
        "tolerance",
        tolerance,
        tolerance > 0.0 && tolerance.is_finite(),
        "finite and positive",
    )?;
    require("x_max", x_max, end >= 0.0 && end.is_finite(), "finite and not negative")?;
    Problem::new(kernel, parameter, &f, (x_max, cuts))?.solve(tolerance)
}

fn require(
    name: &'static str,
    value: f64,
    met: bool,
    requirement: &'static str,
) -> Result<(), Error> {
    if met { Ok(()) } else { Err(Error::InvalidParameter { name, value, requirement }) }
}
