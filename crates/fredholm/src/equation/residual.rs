//! The residual of an approximate solution at single points.

use crate::kernel::{EndExponents, Kernel};
use crate::quadrature::panels::kernel_rule;

/// Nodes on either side of the middle of a panel, beside two for each term of the solution.
const NODES: usize = 60;
/// No power at the ends.
const PLAIN: EndExponents = EndExponents { left: 0.0, right: 0.0 };

/// The largest `|f - phi - lambda K phi|` over a few points, the ends among them: there a truncated expansion is worst, and a layer at an end that is thinner than its last term can
/// resolve shows in no difference of two truncations. By double-exponential quadrature; the solution has `degree` oscillations at most.
pub(super) fn residual(
    kernel: &dyn Kernel,
    parameter: f64,
    f: &dyn Fn(f64) -> f64,
    phi: &dyn Fn(f64) -> f64,
    degree: usize,
) -> f64 {
    let extent = kernel.extent();
    let (centre, half) = (extent.centre(), extent.half_length());
    let inside = [-0.97, -0.2, 0.61].map(|share| centre + share * half);
    let points = [extent.left(), extent.right()].into_iter().chain(inside);
    points
        .map(|x| {
            let potential: f64 = kernel_rule(kernel, PLAIN, x, NODES + 2 * degree)
                .into_iter()
                .filter(|(_, weight)| *weight != 0.0)
                .map(|(s, weight)| weight * phi(s))
                .sum();
            (f(x) - phi(x) - parameter * potential).abs()
        })
        .fold(0.0, f64::max)
}
