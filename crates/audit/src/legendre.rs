//! Legendre polynomials on `[-1, 1]`: Gauss nodes, expansions, and the potentials of single polynomials.

use std::sync::LazyLock;

use crate::kernel::Singularity;

/// Nodes of a panel, and coefficients of the density on it.
pub(crate) const ORDER: usize = 16;
/// Moments that stand for a panel or a cluster far away, the mass included.
pub(crate) const MOMENTS: usize = 34;
/// Up to this place beyond the end of a panel the recurrence forward has grown its rounding by less than a hundred.
const FORWARD: f64 = 1.03;
/// Backward recurrences begin so far up that what they neglect has fallen by `exp(-START)`.
const START: f64 = 38.0;

/// What depends on the number of nodes alone.
pub(crate) struct Rule {
    /// Gauss nodes, rising.
    pub(crate) nodes: [f64; ORDER],
    /// Their weights.
    pub(crate) weights: [f64; ORDER],
    /// `coefficients[k][i]` takes values at the nodes to Legendre coefficients.
    coefficients: [[f64; ORDER]; ORDER],
    /// `int P_k(t) t^j dt`.
    moments: [[f64; MOMENTS]; ORDER],
}

pub(crate) static RULE: LazyLock<Rule> = LazyLock::new(Rule::new);

impl Rule {
    fn new() -> Self {
        let (nodes, weights) = gauss();
        let mut coefficients = [[0.0; ORDER]; ORDER];
        for (i, &node) in nodes.iter().enumerate() {
            for (k, value) in polynomials(node).into_iter().enumerate() {
                coefficients[k][i] = (k as f64 + 0.5) * weights[i] * value;
            }
        }
        let mut moments = [[0.0; MOMENTS]; ORDER];
        for (k, row) in moments.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = power_moment(k, j);
            }
        }
        Self { nodes, weights, coefficients, moments }
    }

    /// Legendre coefficients of the polynomial through these values at the nodes.
    pub(crate) fn expand(&self, values: &[f64; ORDER]) -> [f64; ORDER] {
        let mut expanded = [0.0; ORDER];
        for (entry, row) in expanded.iter_mut().zip(&self.coefficients) {
            *entry = row.iter().zip(values).map(|(a, b)| a * b).sum();
        }
        expanded
    }

    /// `int q(t) t^j dt` of an expansion.
    pub(crate) fn moments(&self, coefficients: &[f64; ORDER]) -> [f64; MOMENTS] {
        let mut found = [0.0; MOMENTS];
        for (c, row) in coefficients.iter().zip(&self.moments) {
            for (entry, moment) in found.iter_mut().zip(row) {
                *entry += c * moment;
            }
        }
        found
    }
}

/// `P_0(t)` to `P_(ORDER-1)(t)`.
pub(crate) fn polynomials(t: f64) -> [f64; ORDER] {
    let mut p = [1.0; ORDER];
    p[1] = t;
    for k in 1..ORDER - 1 {
        let n = k as f64;
        p[k + 1] = ((2.0 * n + 1.0) * t * p[k] - n * p[k - 1]) / (n + 1.0);
    }
    p
}

/// `sum c_k P_k(t)`.
pub(crate) fn evaluate(coefficients: &[f64; ORDER], t: f64) -> f64 {
    // Clenshaw: b_k = c_k + (2k+1)/(k+1) t b_(k+1) - (k+1)/(k+2) b_(k+2)
    let (mut next, mut after) = (0.0, 0.0);
    for k in (0..ORDER).rev() {
        let n = k as f64;
        let here = coefficients[k] + (2.0 * n + 1.0) / (n + 1.0) * t * next
            - (n + 1.0) / (n + 2.0) * after;
        (next, after) = (here, next);
    }
    next
}

/// `int P_k(t) t^j dt = 2^(k+1) j! ((j+k)/2)! / (((j-k)/2)! (j+k+1)!)` for `j >= k` of the same parity, by its recurrence in `j`.
fn power_moment(k: usize, j: usize) -> f64 {
    if j < k || (j - k) % 2 == 1 {
        return 0.0;
    }
    // For j = k it is 2^(k+1) k!^2/(2k+1)!; from j to j + 2 it grows by (j+1)(j+2)/((j-k+2)(j+k+3)).
    let mut value = 2.0;
    for i in 1..=k {
        value *= i as f64 / (2.0 * i as f64 + 1.0);
    }
    for i in (k..j).step_by(2) {
        let (i, k) = (i as f64, k as f64);
        value *= (i + 1.0) * (i + 2.0) / ((i - k + 2.0) * (i + k + 3.0));
    }
    value
}

fn gauss() -> ([f64; ORDER], [f64; ORDER]) {
    let n = ORDER as f64;
    let (mut nodes, mut weights) = ([0.0; ORDER], [0.0; ORDER]);
    for i in 0..ORDER {
        let mut t = -(std::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5)).cos();
        let mut slope = 1.0;
        // Newton's method from this start has converged after five steps.
        for _ in 0..8 {
            let p = polynomials(t);
            let last = ((2.0 * n - 1.0) * t * p[ORDER - 1] - (n - 1.0) * p[ORDER - 2]) / n;
            slope = n * (p[ORDER - 1] - t * last) / (1.0 - t * t);
            t -= last / slope;
        }
        nodes[i] = t;
        weights[i] = 2.0 / ((1.0 - t * t) * slope * slope);
    }
    (nodes, weights)
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_integrate_polynomials() {
        for j in 0..2 * ORDER {
            let sum: f64 =
                (RULE.nodes.iter().zip(&RULE.weights)).map(|(t, w)| w * t.powi(j as i32)).sum();
            let exact = if j % 2 == 0 { 2.0 / (j as f64 + 1.0) } else { 0.0 };
            assert!((sum - exact).abs() < 4e-15, "{j}: {sum}");
        }
    }

    #[test]
    fn expansions_give_their_values_back() {
        let mut values = [0.0; ORDER];
        for (value, t) in values.iter_mut().zip(&RULE.nodes) {
            *value = t.exp();
        }
        let coefficients = RULE.expand(&values);
        for i in 0..=20 {
            let t = f64::from(i) / 10.0 - 1.0;
            assert!((evaluate(&coefficients, t) - t.exp()).abs() < 1e-14, "{t}");
        }
        // int_{-1}^1 e^t t^j dt for j = 0, 1, 2
        let (e, inverse) = (1f64.exp(), (-1f64).exp());
        let exact = [e - inverse, 2.0 * inverse, e - 5.0 * inverse];
        for (found, exact) in RULE.moments(&coefficients).iter().zip(exact) {
            assert!((found - exact).abs() < 1e-14, "{found} {exact}");
        }
    }

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
