//! Quadrature that does not mind what happens at the ends.

use crate::Interval;
use crate::collocation::map::{Node as Image, RANGE};

/// A node of a rule on an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// `x`.
    pub position: f64,
    /// `x - left`, to full relative precision.
    pub from_left: f64,
    /// `right - x`, to full relative precision.
    pub from_right: f64,
    /// Weight.
    pub weight: f64,
}

/// The double-exponential rule on `(-1, 1)` with `2 half_count + 1` nodes from left to right: the trapezoidal rule after
/// `x = tanh(pi/2 sinh t)`, `|t| <= 3.2` (H. Takahasi and M. Mori, Publ. RIMS 9 (1974) 721). Logarithms and roots at the ends cost nothing;
/// integrands must be analytic inside.
///
/// ```
/// let integral: f64 = fredholm::quadrature::double_exponential(40).map(|n| n.weight * n.from_right.ln()).sum();
/// assert!((integral - (2.0 * 2f64.ln() - 2.0)).abs() < 1e-14);
/// ```
pub fn double_exponential(half_count: usize) -> impl Iterator<Item = Node> {
    let step = RANGE / half_count.max(1) as f64;
    let interval = Interval::unit();
    (0..=2 * half_count).map(move |j| {
        let image = Image::at(interval, (j as f64 - half_count as f64) * step);
        let Image { position, from_left, from_right, derivative } = image;
        Node { position, from_left, from_right, weight: step * derivative }
    })
}
