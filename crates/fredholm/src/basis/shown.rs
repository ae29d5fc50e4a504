//! What a polynomial on an interval shows of a function.

use std::f64::consts::PI;

/// Places, from -1 to 1, at which the polynomial is held against the function (survey).
const BETWEEN: [f64; 5] = [-0.97, -0.6, 0.13, 0.71, 0.99];

/// The largest value at the nodes, and what is missed between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// Largest `|f|`.
    pub largest: f64,
    /// Largest difference.
    pub missed: f64,
}

impl Shown {
    /// Of the polynomial through so many Chebyshev points, for a function that is given at many places at a time.
    pub fn new([left, right]: [f64; 2], order: usize, f: impl Fn(&[f64]) -> Vec<f64>) -> Self {
        let middle = 0.5 * (left + right);
        let points = (0..order).map(|k| (PI * (k as f64 + 0.5) / order as f64).cos());
        let points: Vec<f64> = points.collect();
        let places = points.iter().chain(&BETWEEN).map(|y| middle + 0.5 * (right - left) * y);
        let values = f(&places.collect::<Vec<_>>());
        let (known, between) = values.split_at(order);
        let missed = |(y, value): (&f64, &f64)| {
            let (mut above, mut below) = (0.0, 0.0);
            for (k, (point, known)) in points.iter().zip(known).enumerate() {
                let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
                let weight = sign * (1.0 - point * point).sqrt() / (y - point);
                above += weight * known;
                below += weight;
            }
            (above / below - value).abs()
        };
        Self {
            largest: known.iter().fold(0.0, |most, value| value.abs().max(most)),
            missed: BETWEEN.iter().zip(between).map(missed).fold(0.0, f64::max),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_show_themselves_and_no_more() {
        let of = |order: usize, f: fn(f64) -> f64| {
            Shown::new([0.0, 0.5], order, |places| places.iter().map(|x| f(*x)).collect())
        };
        let cubic = of(4, |x| x * x * x - x);
        assert!(cubic.missed < 1e-15 && (cubic.largest - 0.37).abs() < 0.02, "{cubic:?}");
        // x^4 less its cubic through Chebyshev points is T_4(y) h^4/8, y = (x - 1/4)/h, next to -1 at 0.71.
        let quartic = of(4, |x| x.powi(4));
        assert!((quartic.missed / (0.25f64.powi(4) / 8.0) - 1.0).abs() < 1e-3, "{quartic:?}");
        // Of a power what is missed falls as the power of the length alone.
        let root = of(13, f64::sqrt).missed;
        assert!(root > 1e-3 && root < 0.1, "{root}");
    }
}
