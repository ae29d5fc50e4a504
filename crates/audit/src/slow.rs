//! Potentials of single Legendre polynomials, slowly: what the fast ones are compared with.

use crate::kernel::Singularity;
use crate::legendre::ORDER;

/// Up to this place beyond the end of a panel the recurrence forward has grown its rounding by less than a hundred.
const FORWARD: f64 = 1.03;
/// Backward recurrences begin so far up that what they neglect has fallen by `exp(-START)`.
const START: f64 = 38.0;

/// A place as a panel `[-1, 1]` sees it: `z`, with `1 - z` and `1 + z` to their own digits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Seen {
    pub(crate) z: f64,
    pub(crate) to_right: f64,
    pub(crate) from_left: f64,
}

/// `int P_k(t) sigma(|z - t|) dt` for `k < ORDER`, with `sigma = ln` or the power `-mu`; with a bound of their rounding in units of the machine's.
///
/// Both are `(2k+1) z I_k = (k+2-mu) I_(k+1) + (k-1+mu) I_(k-1)` for `k >= 2` (`mu = 0` for the logarithm), from `(z - t) P_k` and integration by parts. Forward where
/// all solutions are of one size, backward where `I_k` is the one that falls.
pub(crate) fn potentials(singularity: Singularity, at: Seen) -> [f64; ORDER] {
    let mut found = [0.0; ORDER];
    let z = at.z;
    let mu = singularity.exponent();
    let first = match singularity {
        Singularity::Logarithm => {
            let (right, left) = (at.to_right, at.from_left);
            let times_ln = |d: f64| if d == 0.0 { 0.0 } else { d * d.abs().ln() };
            found[0] = times_ln(right) + times_ln(left) - 2.0;
            // (z^2 - 1) Q_0 - z
            let half = if right == 0.0 || left == 0.0 { 0.0 } else { (left / right).abs().ln() };
            found[1] = -0.5 * right * left * half - z;
            found[2] = z * found[1] + 2.0 / 3.0;
            2
        }
        Singularity::Power(_) => {
            let signed = |d: f64, q: f64| d.abs().powf(q).copysign(d);
            let (right, left) = (at.to_right, at.from_left);
            found[0] = (signed(right, 1.0 - mu) + signed(left, 1.0 - mu)) / (1.0 - mu);
            let odd = (left.abs().powf(2.0 - mu) - right.abs().powf(2.0 - mu)) / (2.0 - mu);
            found[1] = z * found[0] - odd;
            1
        }
    };
    if z.abs() <= FORWARD {
        for k in first..ORDER - 1 {
            let n = k as f64;
            found[k + 1] =
                ((2.0 * n + 1.0) * z * found[k] - (n - 1.0 + mu) * found[k - 1]) / (n + 2.0 - mu);
        }
        return found;
    }
    let growth = (z.abs() + (z * z - 1.0).sqrt()).ln();
    let last = ORDER + (0.5 * START / growth).ceil() as usize;
    let mut ratio = 0.0;
    let mut ratios = [0.0; ORDER];
    for k in (first..=last).rev() {
        let n = k as f64;
        ratio = (n - 1.0 + mu) / ((2.0 * n + 1.0) * z - (n + 2.0 - mu) * ratio);
        if k < ORDER {
            ratios[k] = ratio;
        }
    }
    for k in first + 1..ORDER {
        found[k] = ratios[k] * found[k - 1];
    }
    found
}

mod tests {
    use super::*;
    use crate::legendre::{RULE, polynomials};

    /// By Gauss quadrature after the substitution `|z - t| = s^20`, which removes the singularity; for `|z| <= 1`.
    fn brute(singularity: Singularity, z: f64, k: usize) -> f64 {
        let side = |length: f64, sign: f64| -> f64 {
            let end = length.powf(0.05);
            let mut sum = 0.0;
            for piece in 0..40 {
                let (l, r) = (end * f64::from(piece) / 40.0, end * f64::from(piece + 1) / 40.0);
                for (t, w) in RULE.nodes.iter().zip(&RULE.weights) {
                    let s = 0.5 * (l + r) + 0.5 * (r - l) * t;
                    let d = s.powi(20);
                    let p = polynomials(z + sign * d)[k];
                    sum += 0.5 * (r - l) * w * p * singularity.value(d) * 20.0 * s.powi(19);
                }
            }
            sum
        };
        side(1.0 - z, 1.0) + side(1.0 + z, -1.0)
    }

    #[test]
    fn potentials_of_polynomials() {
        for singularity in
            [Singularity::Logarithm, Singularity::Power(0.3), Singularity::Power(0.7)]
        {
            for z in [-0.99, -0.3, 0.0, 0.7] {
                let at = Seen { z, to_right: 1.0 - z, from_left: 1.0 + z };
                let found = potentials(singularity, at);
                for (k, value) in found.iter().enumerate() {
                    let truth = brute(singularity, z, k);
                    assert!(
                        (value - truth).abs() < 2e-12,
                        "{singularity:?} {z} {k}: {value} {truth}"
                    );
                }
            }
        }
    }

    #[test]
    fn recurrences_meet_where_they_change_over() {
        for singularity in
            [Singularity::Logarithm, Singularity::Power(0.3), Singularity::Power(0.9)]
        {
            for z in [1.02, 1.04, 1.3, 2.0, 2.9, -1.5] {
                let at = Seen { z, to_right: 1.0 - z, from_left: 1.0 + z };
                let found = potentials(singularity, at);
                for (k, value) in found.iter().enumerate() {
                    // Far enough from the singularity for Gauss quadrature on pieces.
                    let mut truth = 0.0;
                    let pieces = 400u32;
                    for piece in 0..pieces {
                        let l = -1.0 + 2.0 * f64::from(piece) / f64::from(pieces);
                        let r = l + 2.0 / f64::from(pieces);
                        for (t, w) in RULE.nodes.iter().zip(&RULE.weights) {
                            let s = 0.5 * (l + r) + 0.5 * (r - l) * t;
                            truth += 0.5
                                * (r - l)
                                * w
                                * polynomials(s)[k]
                                * singularity.value((z - s).abs());
                        }
                    }
                    assert!(
                        (value - truth).abs() < 1e-13,
                        "{singularity:?} {z} {k}: {value} {truth}"
                    );
                }
            }
        }
    }
}
