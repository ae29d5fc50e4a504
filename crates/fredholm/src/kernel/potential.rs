//! The logarithmic potential of a polynomial, in closed form.

use std::f64::consts::LN_2;

use crate::basis::ChebyshevSeries;

/// `U(x) = int_{-1}^{1} ln(1/|x - s|) q(s) ds` of `q = sum c_j T_j`, exact but for rounding, the ends included.
///
/// With an antiderivative `G` of `q`, by parts,
///
/// `U(x) = -[G(1) - G(x)] ln(1 - x) - [G(x) - G(-1)] ln(1 + x) + W(x)`, `W(x) = int_{-1}^{1} (G(s) - G(x))/(s - x) ds`.
///
/// `W` is a polynomial: for `G = T_k` it satisfies `W_{k+1} = 2x W_k - W_{k-1} + 2 int T_k`, `W_0 = 0`, `W_1 = 2`, and Clenshaw's
/// sums `b_k` of `G` give it as `sum_i w_i b_{i+1}`, `w_0 = 2`, `w_i = 4/(1 - i^2)` for even `i`, else 0. One pass over
/// the coefficients gives `G(x)` and `W(x)`: 5 operations a coefficient.
///
/// ```
/// use fredholm::{basis::ChebyshevSeries, kernel::LogarithmicPotential};
///
/// let potential = LogarithmicPotential::new(&ChebyshevSeries::new(vec![1.0]));
/// assert!((potential.evaluate(0.0) - 2.0).abs() < 1e-15);
/// assert!((potential.evaluate(1.0) - (2.0 - 2.0 * 2f64.ln())).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LogarithmicPotential {
    /// Coefficients of `G`, from `T_1` on.
    antiderivative: Vec<f64>,
    /// `G(-1)` and `G(1)`.
    ends: [f64; 2],
    /// `U(-1)` and `U(1)`, from the moments of the kernel at the ends: at high degrees the recurrence loses digits there.
    end_values: [f64; 2],
}

impl LogarithmicPotential {
    /// The potential of `density`.
    #[must_use]
    pub fn new(density: &ChebyshevSeries) -> Self {
        let c = density.coefficients();
        let at = |j: usize| c.get(j).copied().unwrap_or(0.0);
        let antiderivative: Vec<f64> = (1..=c.len())
            .map(|k| {
                let below = if k == 1 { 2.0 * at(0) } else { at(k - 1) };
                (below - at(k + 1)) / (2.0 * k as f64)
            })
            .collect();
        let odd: f64 = antiderivative.iter().step_by(2).sum();
        let even: f64 = antiderivative.iter().skip(1).step_by(2).sum();
        let mut values = [0.0; 2];
        for (j, (c, e)) in c.iter().zip(EndMoments::default()).enumerate() {
            values[j % 2] += c * e;
        }
        Self {
            antiderivative,
            ends: [even - odd, even + odd],
            end_values: [values[0] - values[1], values[0] + values[1]],
        }
    }

    /// `U(x)`, `x` in `[-1, 1]`.
    #[must_use]
    pub fn evaluate(&self, x: f64) -> f64 {
        if x.abs() == 1.0 {
            return self.end_values[usize::from(x > 0.0)];
        }
        self.inside(x)
    }

    fn inside(&self, x: f64) -> f64 {
        let (value, polynomial) = if x.abs() < 0.5 { self.plain(x) } else { self.reinsch(x) };
        polynomial
            - vanishing(self.ends[1] - value, 1.0 - x)
            - vanishing(value - self.ends[0], 1.0 + x)
    }

    /// `G(x)` and `W(x)` by Clenshaw's recurrence.
    fn plain(&self, x: f64) -> (f64, f64) {
        let (mut b, mut above, mut sum) = (0.0, 0.0, 0.0);
        for (i, &g) in self.antiderivative.iter().enumerate().rev() {
            (b, above) = (2.0 * x * b - above + g, b);
            sum += weight(i) * b;
        }
        (x * b - above, sum)
    }

    /// The same with `b_k - b_{k+1} sign x` carried along, which keeps the digits near the ends.
    fn reinsch(&self, x: f64) -> (f64, f64) {
        let sign = x.signum();
        let slope = 2.0 * (x - sign);
        let (mut b, mut difference, mut sum) = (0.0, 0.0, 0.0);
        for (i, &g) in self.antiderivative.iter().enumerate().rev() {
            difference = slope * b + sign * difference + g;
            b = sign * b + difference;
            sum += weight(i) * b;
        }
        (0.5 * slope * b + sign * difference, sum)
    }
}

/// `e_m = int_{-1}^{1} ln(1/(1 - x)) T_m dx`, `m < count`: the kernel at the right end against the eigenfunctions.
///
/// With `B_m = -4 sum i/(i^2 - 1)` over even `0 < i < m`: `e_m = [2 ln 2 - 2/(m + 1) + B_m]/(m^2 - 1)` for even `m`, `B_m/(m^2 - 1)` for odd
/// `m >= 3`, `e_1 = 1`; no cancellation but of a few units in the first.
#[must_use]
pub fn end_moments(count: usize) -> Vec<f64> {
    EndMoments::default().take(count).collect()
}

/// The moments one after another.
#[derive(Debug, Default)]
pub(crate) struct EndMoments {
    next: usize,
    sum: f64,
}

impl Iterator for EndMoments {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        let m = self.next as f64;
        self.next += 1;
        let square = (m - 1.0) * (m + 1.0);
        if self.next == 2 {
            return Some(1.0);
        }
        if self.next.is_multiple_of(2) {
            return Some(self.sum / square);
        }
        let value = (2.0 * LN_2 - 2.0 / (m + 1.0) + self.sum) / square;
        if m > 0.0 {
            self.sum -= 4.0 * m / square;
        }
        Some(value)
    }
}

/// `w_i`.
fn weight(i: usize) -> f64 {
    match i {
        0 => 2.0,
        _ if i.is_multiple_of(2) => {
            let i = i as f64;
            4.0 / ((1.0 - i) * (1.0 + i))
        }
        _ => 0.0,
    }
}

/// `factor ln(distance)`, 0 at distance 0, where the factor vanishes like the distance.
fn vanishing(factor: f64, distance: f64) -> f64 {
    if distance > 0.0 { factor * distance.ln() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::double_exponential;

    /// `int ln(1/|x - s|) q(s) ds` by the double-exponential rule on either side of `x`.
    fn by_quadrature(q: &ChebyshevSeries, x: f64) -> f64 {
        let side = |length: f64, sign: f64| -> f64 {
            double_exponential(60)
                .map(|node| {
                    let distance = 0.5 * length * node.from_left;
                    -0.5 * length * node.weight * distance.ln() * q.evaluate(x + sign * distance)
                })
                .sum()
        };
        let mut sum = 0.0;
        if x < 1.0 {
            sum += side(1.0 - x, 1.0);
        }
        if x > -1.0 {
            sum += side(1.0 + x, -1.0);
        }
        sum
    }

    #[test]
    fn agrees_with_quadrature() {
        for degree in [0usize, 1, 2, 3, 4, 7, 20] {
            let coefficients =
                (0..=degree).map(|j| (1.7 * j as f64 + 0.3).cos() / (1.0 + j as f64)).collect();
            let q = ChebyshevSeries::new(coefficients);
            let potential = LogarithmicPotential::new(&q);
            for x in [-1.0, -0.999, -0.7, -0.5, 0.0, 0.1, 0.5, 0.93, 1.0 - 1e-9, 1.0] {
                let (found, exact) = (potential.evaluate(x), by_quadrature(&q, x));
                assert!((found - exact).abs() < 2e-14, "{degree} {x}: {found} {exact}");
            }
        }
        assert_eq!(LogarithmicPotential::new(&ChebyshevSeries::default()).evaluate(0.3), 0.0);
    }

    #[test]
    fn both_ways_agree_at_the_ends() {
        for m in 0..300 {
            let mut coefficients = vec![0.0; m + 1];
            coefficients[m] = 1.0;
            let potential = LogarithmicPotential::new(&ChebyshevSeries::new(coefficients));
            for end in [-1.0, 1.0] {
                let (found, exact) = (potential.evaluate(end), potential.inside(end));
                assert!(
                    (found - exact).abs() < 1e-15 + 1e-14 * exact.abs(),
                    "{m}: {found} {exact}"
                );
            }
        }
        assert_eq!(end_moments(2), [2.0 - 2.0 * LN_2, 1.0]);
    }

    #[test]
    fn satisfies_the_bilinear_expansion_at_high_degree() {
        // U = sum a_m <q, T_m> T_m with a_0 = ln 2, a_m = 2/m; the terms fall as m^-3.
        let coefficients: Vec<f64> =
            (0..=3000).map(|j| 1.0 / (1.0 + f64::from(j)).powi(2)).collect();
        let q = ChebyshevSeries::new(coefficients);
        let potential = LogarithmicPotential::new(&q);
        let mut terms = q.moments(1 << 16);
        for (m, term) in terms.iter_mut().enumerate() {
            *term *= if m == 0 { 2f64.ln() } else { 2.0 / m as f64 };
        }
        for x in [-1.0, -0.3, 0.0, 0.8, 0.9999, 1.0] {
            let expanded = crate::basis::chebyshev::sum(&terms, x);
            assert!((potential.evaluate(x) - expanded).abs() < 2e-9, "{x}");
        }
    }
}
