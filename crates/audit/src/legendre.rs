//! Legendre polynomials on `[-1, 1]`: Gauss nodes, expansions, and the potentials of single polynomials.

use std::sync::LazyLock;

use crate::vectorised::vectorised;

/// Nodes of a panel, and coefficients of the density on it.
pub(crate) const ORDER: usize = 24;
/// Moments that stand for a panel or a cluster far away, the mass included.
pub(crate) const MOMENTS: usize = 34;

/// What depends on the number of nodes alone.
pub(crate) struct Rule {
    /// Gauss nodes, rising.
    pub(crate) nodes: [f64; ORDER],
    /// Their weights.
    pub(crate) weights: [f64; ORDER],
    /// `coefficients[i][k]` takes values at the nodes to Legendre coefficients.
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
                coefficients[i][k] = (k as f64 + 0.5) * weights[i] * value;
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
        vectorised(
            #[inline(always)]
            || {
                let mut expanded = [0.0; ORDER];
                // Of a constant rounded weights leave some of all degrees.
                let middle = values[ORDER / 2];
                // All coefficients advance together: their sums do not wait for each other.
                for (value, column) in values.iter().zip(&self.coefficients) {
                    for (entry, factor) in expanded.iter_mut().zip(column) {
                        *entry += factor * (value - middle);
                    }
                }
                expanded[0] += middle;
                expanded
            },
        )
    }

    /// The weights at the nodes that integrate polynomials as those do whose sums with `P_0`, `P_1`, .. are these.
    pub(crate) fn spread(&self, sums: &[f64; ORDER]) -> [f64; ORDER] {
        self.coefficients.map(|row| row.iter().zip(sums).map(|(c, sum)| c * sum).sum())
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

/// Factors of Clenshaw's scheme, `b_k = c_k + (2k+1)/(k+1) t b_(k+1) - (k+1)/(k+2) b_(k+2)`.
const CLENSHAW: [[f64; 2]; ORDER] = {
    let mut factors = [[0.0; 2]; ORDER];
    let mut k = 0;
    while k < ORDER {
        let n = k as f64;
        factors[k] = [(2.0 * n + 1.0) / (n + 1.0), (n + 1.0) / (n + 2.0)];
        k += 1;
    }
    factors
};

/// `sum c_k P_k(t)`.
pub(crate) fn evaluate(coefficients: &[f64; ORDER], t: f64) -> f64 {
    let (mut next, mut after) = (0.0, 0.0);
    for (c, [a, b]) in coefficients.iter().zip(&CLENSHAW).rev() {
        (next, after) = (c + a * t * next - b * after, next);
    }
    next
}

/// The same at several places, which advance together.
#[inline(always)]
pub(crate) fn evaluate_at<const N: usize>(
    coefficients: &[f64; ORDER],
    places: &[f64; N],
) -> [f64; N] {
    let (mut next, mut after) = ([0.0; N], [0.0; N]);
    for (c, [a, b]) in coefficients.iter().zip(&CLENSHAW).rev() {
        for ((next, after), t) in next.iter_mut().zip(&mut after).zip(places) {
            (*next, *after) = (c + a * t * *next - b * *after, *next);
        }
    }
    next
}

/// Places that advance together.
const TOGETHER: usize = 16;

/// The same at any number of places.
pub(crate) fn evaluate_all(coefficients: &[f64; ORDER], places: &[f64], values: &mut [f64]) {
    vectorised(
        #[inline(always)]
        || {
            for (places, values) in places.chunks(TOGETHER).zip(values.chunks_mut(TOGETHER)) {
                let mut some = [0.0; TOGETHER];
                some[..places.len()].copy_from_slice(places);
                let found = evaluate_at(coefficients, &some);
                values.copy_from_slice(&found[..values.len()]);
            }
        },
    );
}

/// Roundings of [`evaluate`] at a place that is itself off by four units, in units of the machine.
///
/// A step of Clenshaw's scheme is off by `2 |c_k| + 10 |b_(k+1)| + 3 |b_(k+2)|`, and the value by the sum of that with `|P_k| <= 1`; `b_k = sum c_j p_(j-k)` with the associated Legendre
/// polynomials, `|p_n| <= n + 1`. The place: `|P_k'| <= k (k + 1)/2`.
pub(crate) fn evaluated(coefficients: &[f64; ORDER]) -> f64 {
    (coefficients.iter().enumerate())
        .map(|(k, c)| {
            let k = k as f64;
            c.abs() * (2.0 + 7.0 * k * (k + 1.0) + 1.5 * k * (k - 1.0))
        })
        .sum()
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
        // Newton's method from this start has converged after five steps.
        for _ in 0..8 {
            let p = polynomials(t);
            let last = ((2.0 * n - 1.0) * t * p[ORDER - 1] - (n - 1.0) * p[ORDER - 2]) / n;
            let slope = n * (p[ORDER - 1] - t * last) / (1.0 - t * t);
            t -= last / slope;
        }
        nodes[i] = t;
        // The polynomials are orthonormal under these weights to rounding: no differences lose digits.
        let squares = polynomials(t).into_iter().enumerate();
        weights[i] = 1.0 / squares.map(|(k, p)| (k as f64 + 0.5) * p * p).sum::<f64>();
    }
    (nodes, weights)
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
            assert!((evaluate(&coefficients, t) - t.exp()).abs() < 3e-14, "{t}");
        }
        // int_{-1}^1 e^t t^j dt for j = 0, 1, 2
        let (e, inverse) = (1f64.exp(), (-1f64).exp());
        let exact = [e - inverse, 2.0 * inverse, e - 5.0 * inverse];
        for (found, exact) in RULE.moments(&coefficients).iter().zip(exact) {
            assert!((found - exact).abs() < 3e-14, "{found} {exact}");
        }
    }
}
