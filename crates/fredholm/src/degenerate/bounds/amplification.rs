//! From the residual in the mean square to the error at a point.

use std::f64::consts::{LN_2, TAU};

/// Euler's constant, rounded up.
const EULER: f64 = 0.577_215_664_901_533;
/// Splits `N = 1, 2, 4, ..` of the expansion that are tried.
const SPLITS: u32 = 60;

/// The least known `C` with `|theta (K A^{-1} r)(x)| <= C ||r||` for all `x` and `r`, `A = 1 + theta K`, `K` the logarithmic
/// kernel on `(-1, 1)`: the smaller of `2 theta` and, over `N`,
///
/// `(b + sqrt(a^2 + b^2)) / 2`, `a^2 = theta (ln 2 + 2 H_N)`, `b = theta sqrt(2 pi / N)`.
///
/// Derivation: chapter "Error bounds" of the book.
pub(super) fn amplification(theta: f64) -> f64 {
    let split = |power: u32| {
        let n = f64::from(power).exp2();
        // H_N <= ln N + gamma + 1/(2N)
        let harmonic = n.ln() + EULER + 0.5 / n;
        let low = (theta * (LN_2 + 2.0 * harmonic)).sqrt();
        let high = theta * (TAU / n).sqrt();
        0.5 * (high + low.hypot(high))
    };
    (0..SPLITS).map(split).fold(2.0 * theta, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::double_exponential;

    #[test]
    fn the_kernel_is_largest_in_the_middle() {
        // ||K(x, .)||^2 = F(1-x) + F(1+x) by quadrature.
        let square = |length: f64| -> f64 {
            double_exponential(50)
                .map(|node| {
                    0.5 * length * node.weight * (0.5 * length * node.from_left).ln().powi(2)
                })
                .sum()
        };
        let norm = |x: f64| (square(1.0 - x) + square(1.0 + x)).sqrt();
        assert!((norm(0.0) - 2.0).abs() < 1e-13);
        for i in 1..100 {
            assert!(norm(0.01 * f64::from(i)) < 2.0);
        }
    }

    #[test]
    fn grows_with_the_square_root_of_the_parameter() {
        assert_eq!(amplification(0.0), 0.0);
        assert_eq!(amplification(1e-3), 2e-3);
        assert!(amplification(1e4) < 300.0 && amplification(1e4) > 100.0);
        assert!(amplification(1e6) / amplification(1e4) < 13.0);
    }
}
