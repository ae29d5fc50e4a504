//! How far from the diagonal the factor of the singular function is kept.

/// Steepness: the cutoff is 1 to rounding at the diagonal.
const STEEPNESS: f64 = 6.0;
/// Depth, in powers of e below the radius, that counts at most.
const DEEPEST: f64 = 40.0;

/// `erfc(6 (r/r_c - 1))/2` with `r = |ln(x/s)|`, `r_c = c + theta L` and the depth `L = -ln(sqrt(x s)/a)`.
///
/// Collocation replaces trapezoidal sums by exact weights, and the difference is the factor times numbers that alternate and fall as the square of the number of
/// places. The sums cancel if the factor is smooth on the grid, which in the corner at 0 is one of `ln x` with steps proportional to the depth: so the width must
/// grow with the depth. The factor grows as `(x/s)^mu`: so the width must stop at `theta`, where the scaled matrix keeps its size
/// (`s > x^(1-1/mu)`) and rounding of potentials stays below their largest value (`s > x^(mu/(2 mu+1))`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cutoff {
    constant: f64,
    slope: f64,
}

impl Cutoff {
    pub(super) fn new(order: f64) -> Self {
        let nearest = (order / (2.0 * order + 1.0)).max(1.0 - 1.0 / order.max(1e-3));
        // 1.6: there the cutoff has fallen to 1e-7.
        let slope = 2.0 / 1.6 * (1.0 - nearest) / (1.0 + nearest);
        Self { constant: 4.0 / (order + 0.5), slope }
    }

    /// The cutoff at `r`, where `x s` is `a^2 e^(-2 depth)`.
    pub(super) fn value(self, r: f64, depth: f64) -> f64 {
        let depth = depth.max(0.0);
        let saturated = depth / (1.0 + depth / DEEPEST);
        let place = r / (self.constant + self.slope * saturated);
        if place >= 2.0 { 0.0 } else { 0.5 * libm::erfc(STEEPNESS * (place - 1.0)) }
    }

    /// From here on it vanishes.
    pub(super) fn reach(self) -> f64 {
        2.0 * (self.constant + self.slope * DEEPEST)
    }
}
