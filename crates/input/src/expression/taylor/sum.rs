//! Sums of products of intervals, rounded outward once at the end.

use super::super::interval::Interval;

/// More than what underflow can take from a product and its weight.
const UNDERFLOW: f64 = 1e-315;
/// In larger sums underflow is lost in rounding.
const RESOLVED: f64 = 1e-280;

/// A sum with a bound of all that rounding did to it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sum {
    lower: f64,
    upper: f64,
    /// Sum of the magnitudes.
    size: f64,
    terms: u32,
}

impl Sum {
    /// Adds `weight u v`, the weight known to within the rounding of `spread >= |weight|`.
    pub(super) fn add_near(&mut self, weight: f64, spread: f64, u: Interval, v: Interval) {
        if u.is_zero() || v.is_zero() {
            return;
        }
        let corners = [
            u.lower() * v.lower(),
            u.lower() * v.upper(),
            u.upper() * v.lower(),
            u.upper() * v.upper(),
        ];
        let least = corners.into_iter().fold(f64::INFINITY, f64::min);
        let most = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let (lower, upper) = if weight < 0.0 { (most, least) } else { (least, most) };
        self.lower += weight * lower;
        self.upper += weight * upper;
        self.size += spread * least.abs().max(most.abs());
        self.terms += 1;
    }

    /// Adds `weight u v` for a weight without rounding.
    pub(super) fn add(&mut self, weight: f64, u: Interval, v: Interval) {
        self.add_near(weight, weight.abs(), u, v);
    }

    /// Adds `weight u`.
    pub(super) fn add_one(&mut self, weight: f64, u: Interval) {
        self.add(weight, u, Interval::ONE);
    }

    /// The sum over a positive number.
    pub(super) fn over(self, divisor: f64) -> Interval {
        if self.terms == 0 {
            return Interval::ZERO;
        }
        // A product, its weight and the sums round once each, by half a unit; twice that covers the rounding of the bound itself.
        let terms = f64::from(self.terms);
        let underflow = if self.size < RESOLVED { terms * UNDERFLOW } else { 0.0 };
        let lost = self.size * (terms + 6.0) * f64::EPSILON + underflow;
        let lower = ((self.lower - lost) / divisor).next_down();
        let upper = ((self.upper + lost) / divisor).next_up();
        Interval::ends(lower, upper)
    }

    pub(super) fn total(self) -> Interval {
        self.over(1.0)
    }
}
