//! A base given by a closure, of which only values are known.

use std::fmt;
use std::sync::Arc;

use crate::expression::Defect;

/// Places at which it is looked at for values that are not finite.
const PLACES: usize = 1024;
/// Points of the polynomial whose derivative is the slope, and half of the interval of `xi` that it covers at first: of a wave `cos(w xi)` the degree 10 leaves `w (w/100)^10/10!`, rounding `1e-12`.
const POINTS: usize = 11;
const REACH: f64 = 0.02;
/// The interval is halved, so often at most, until the last two coefficients are no more than this share of the heights: rounding.
const HALVINGS: usize = 4;
const ROUNDED: f64 = 8.0 * f64::EPSILON;

/// A closure of `x`, in the units of the problem, and the places where it has kinks or jumps.
#[derive(Clone)]
pub(super) struct Function {
    height: Arc<dyn Fn(f64) -> f64 + Send + Sync>,
    breaks: Vec<f64>,
}

impl fmt::Debug for Function {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Function").field("breaks", &self.breaks).finish_non_exhaustive()
    }
}

/// Closures are the same where they are one and the same.
impl PartialEq for Function {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.height, &other.height) && self.breaks == other.breaks
    }
}

impl Function {
    pub(super) fn new(height: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self {
        Self { height: Arc::new(height), breaks: Vec::new() }
    }

    pub(super) fn with_breaks(&self, mut breaks: Vec<f64>) -> Self {
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        Self { height: Arc::clone(&self.height), breaks }
    }

    pub(super) fn evaluate(&self, x: f64) -> f64 {
        (self.height)(x)
    }

    /// The breaks inside `(-1, 1)` as `xi`.
    pub(super) fn breaks(&self, half_width: f64) -> Vec<f64> {
        let places = self.breaks.iter().map(|x| x / half_width);
        places.filter(|xi| xi.abs() < 1.0).collect()
    }

    /// `df/dxi`, at a break to the right: that of the polynomial through Chebyshev points around the place, between the neighbouring breaks.
    pub(super) fn slope(&self, xi: f64, half_width: f64) -> f64 {
        let (mut left, mut right) = (-1.0f64, 1.0f64);
        for at in self.breaks(half_width) {
            if at <= xi {
                left = left.max(at);
            } else {
                right = right.min(at);
            }
        }
        let mut reach = REACH;
        for _ in 0..HALVINGS {
            let (slope, is_resolved) = self.slope_within([left, right], reach, (xi, half_width));
            if is_resolved {
                return slope;
            }
            reach *= 0.5;
        }
        self.slope_within([left, right], reach, (xi, half_width)).0
    }

    /// The slope of a polynomial between breaks, and whether that is the function to rounding.
    fn slope_within(
        &self,
        [left, right]: [f64; 2],
        reach: f64,
        (xi, half_width): (f64, f64),
    ) -> (f64, bool) {
        // Moved inwards where it would reach beyond a break or an end.
        let from = (xi - reach).min(right - 2.0 * reach).max(left);
        let (left, right) = (from, right.min(from + 2.0 * reach));
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let angle = |j: usize| std::f64::consts::PI * (j as f64 + 0.5) / POINTS as f64;
        let heights: [f64; POINTS] =
            std::array::from_fn(|j| self.evaluate(half_width * (middle + half * angle(j).cos())));
        let largest = heights.iter().fold(0.0f64, |most, f| most.max(f.abs()));
        let y = (xi - middle) / half;
        let coefficients: [f64; POINTS] = std::array::from_fn(|m| {
            let terms = heights.iter().enumerate();
            let sum: f64 = terms.map(|(j, f)| f * (m as f64 * angle(j)).cos()).sum();
            2.0 / POINTS as f64 * sum
        });
        let last = coefficients[POINTS - 2].abs().max(coefficients[POINTS - 1].abs());
        // p = sum c_m T_m(y), p' = sum m c_m U_(m-1)(y).
        let (mut slope, mut before, mut chebyshev) = (0.0, 0.0, 1.0);
        for (m, coefficient) in coefficients.iter().enumerate().skip(1) {
            slope += m as f64 * coefficient * chebyshev;
            (before, chebyshev) = (chebyshev, 2.0 * y * chebyshev - before);
        }
        (slope / half, last <= ROUNDED * largest)
    }

    /// A `xi` of those looked at where the value is not finite, and how.
    pub(super) fn find_not_finite(&self, half_width: f64) -> Option<(f64, Defect)> {
        let places = (0..=PLACES).map(|i| 2.0 * i as f64 / PLACES as f64 - 1.0);
        places.map(|xi| (xi, self.evaluate(half_width * xi))).find_map(|(xi, f)| {
            let defect = if f.is_nan() { Defect::Undefined } else { Defect::Infinite };
            (!f.is_finite()).then_some((xi, defect))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_those_of_the_values() {
        let wave = Function::new(|x: f64| (3.0 * x).sin() + x * x);
        for xi in [-1.0, -0.999, -0.4, 0.0, 0.7, 1.0] {
            let exact = 2.0 * (3.0 * f64::cos(6.0 * xi) + 4.0 * xi);
            let found = wave.slope(xi, 2.0);
            assert!((found - exact).abs() < 2e-11, "{xi}: {found} {exact}");
        }
        let wedge = Function::new(f64::abs).with_breaks(vec![0.0]);
        for (xi, exact) in [(-0.001, -2.0), (0.0, 2.0), (0.001, 2.0)] {
            assert!((wedge.slope(xi, 2.0) - exact).abs() < 1e-10, "{xi}");
        }
        let pole = Function::new(|x| 1.0 / x).find_not_finite(0.5);
        assert_eq!(pole, Some((0.0, Defect::Infinite)));
    }
}
