//! Interpolation at Chebyshev nodes on `[-1, 1]`.

use std::f64::consts::PI;
use std::sync::OnceLock;

use crate::vectorised::vectorised;

/// Largest number of nodes.
pub(crate) const MOST: usize = 48;

/// Nodes and the cosines that take values to coefficients.
pub(crate) struct Nodes {
    /// The nodes, rising.
    pub(crate) places: Vec<f64>,
    /// Of each node one after the other, for all coefficients.
    cosines: Vec<f64>,
}

static ALL: [OnceLock<Nodes>; MOST + 1] = [const { OnceLock::new() }; MOST + 1];

/// So many nodes, at most [`MOST`].
pub(crate) fn nodes(count: usize) -> &'static Nodes {
    let count = count.min(MOST);
    ALL[count].get_or_init(|| Nodes::new(count))
}

impl Nodes {
    fn new(count: usize) -> Self {
        let angle = |j: usize| PI * (1.0 - (j as f64 + 0.5) / count as f64);
        let places = (0..count).map(|j| angle(j).cos()).collect();
        // cos(k pi (1 - (2j+1)/(2n))) = (-1)^k cos(pi k (2j+1)/(2n)), which has the period 4n.
        let period = 4 * count;
        let turned: Vec<f64> =
            (0..period).map(|m| (PI * m as f64 / (2 * count) as f64).cos()).collect();
        let mut cosines = Vec::with_capacity(count * count);
        for j in 0..count {
            cosines.extend((0..count).map(|k| {
                let factor = if k == 0 { 1.0 } else { 2.0 } / count as f64;
                let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
                factor * sign * turned[k * (2 * j + 1) % period]
            }));
        }
        Self { places, cosines }
    }

    /// Coefficients of the polynomial through values at the nodes.
    pub(crate) fn coefficients(&self, values: &[f64]) -> Vec<f64> {
        let count = self.places.len();
        let mut found = vec![0.0; count];
        vectorised(
            #[inline(always)]
            || {
                // All coefficients advance together: their sums do not wait for each other.
                for (value, row) in values.iter().zip(self.cosines.chunks(count.max(1))) {
                    for (entry, cosine) in found.iter_mut().zip(row) {
                        *entry += cosine * value;
                    }
                }
            },
        );
        found
    }
}

/// A bound of the Lebesgue constant of so many Chebyshev nodes (T. J. Rivlin, *The Chebyshev Polynomials*, 1974, sec. 1.3: `2/pi ln n + 1`).
pub(crate) fn lebesgue(count: usize) -> f64 {
    1.0 + 2.0 / PI * (count as f64).ln()
}

/// `sum c_k T_k(t)`.
pub(crate) fn evaluate(coefficients: &[f64], t: f64) -> f64 {
    let (mut next, mut after) = (0.0, 0.0);
    for c in coefficients.iter().skip(1).rev() {
        (next, after) = (c + 2.0 * t * next - after, next);
    }
    coefficients.first().map_or(0.0, |c| c + t * next - after)
}

/// The same at several places, which advance together.
#[inline(always)]
pub(crate) fn evaluate_at<const N: usize>(coefficients: &[f64], places: &[f64; N]) -> [f64; N] {
    let (mut next, mut after) = ([0.0; N], [0.0; N]);
    for c in coefficients.iter().skip(1).rev() {
        for ((next, after), t) in next.iter_mut().zip(&mut after).zip(places) {
            (*next, *after) = (c + 2.0 * t * *next - *after, *next);
        }
    }
    let first = coefficients.first().copied().unwrap_or_default();
    std::array::from_fn(|i| first + places[i] * next[i] - after[i])
}

/// Roundings of [`evaluate`] at a place that is itself off by four units, in units of the machine.
///
/// A step of Clenshaw's scheme is off by `2 |c_k| + 6 |b_(k+1)| + 2 |b_(k+2)|`, and the value by the sum of that with `|T_k| <= 1`; `b_k = sum c_j U_(j-k)`, `|U_n| <= n + 1`. The place:
/// `|T_k'| <= k^2`.
pub(crate) fn evaluated(coefficients: &[f64]) -> f64 {
    (coefficients.iter().enumerate())
        .map(|(k, c)| {
            let k = k as f64;
            c.abs() * (2.0 + 3.0 * k * (k + 1.0) + k * (k - 1.0) + 4.0 * k * k)
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interpolation_gives_the_function() {
        for count in [1, 2, 7, 24, 48] {
            let at = nodes(count);
            let f =
                |t: f64| if count < 20 { 1.0 + t.powi(count as i32 - 1) } else { (3.0 * t).sin() };
            let values: Vec<f64> = at.places.iter().map(|t| f(*t)).collect();
            let coefficients = at.coefficients(&values);
            for i in 0..=30 {
                let t = f64::from(i) / 15.0 - 1.0;
                assert!((evaluate(&coefficients, t) - f(t)).abs() < 1e-13, "{count} {t}");
            }
        }
    }
}
