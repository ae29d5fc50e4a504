//! Jacobi polynomials `P_n^(alpha, beta)(t)` on `[-1, 1]`, `alpha, beta > -1` (DLMF 18).

/// A point of `[-1, 1]` by its distances to both ends, which near an end hold more digits than the point does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Argument {
    /// `(1 - t)/2`.
    pub(crate) from_one: f64,
    /// `(1 + t)/2`.
    pub(crate) from_minus_one: f64,
}

/// The polynomials `P_n^(alpha, beta)`, orthogonal with the weight `(1 - t)^alpha (1 + t)^beta`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Jacobi {
    alpha: f64,
    beta: f64,
}

impl Jacobi {
    pub(crate) fn new(alpha: f64, beta: f64) -> Self {
        Self { alpha, beta }
    }

    /// `scale P_0, scale P_1, ...` at a point, without end.
    ///
    /// The recurrence steps the differences of `P_n(t)/P_n(1)`, in the half next to `-1` of `P_n(t)/P_n(-1)`: the plain one loses `n^2` roundings
    /// near the ends.
    pub(crate) fn values(self, argument: Argument, scale: f64) -> Values {
        let Argument { from_one, from_minus_one } = argument;
        let (polynomials, distance, sign) = if from_one <= from_minus_one {
            (self, from_one, 1.0)
        } else {
            (Self { alpha: self.beta, beta: self.alpha }, from_minus_one, -1.0)
        };
        Values { polynomials, distance, sign, index: 0.0, end: scale, share: 1.0, difference: 0.0 }
    }

    /// `sum_n coefficients[n] P_n` at a point, times `scale`.
    pub(crate) fn sum(self, coefficients: &[f64], argument: Argument, scale: f64) -> f64 {
        coefficients.iter().zip(self.values(argument, scale)).map(|(c, value)| c * value).sum()
    }

    /// The coefficients of `t p_n = b_n p_{n+1} + a_n p_n + b_{n-1} p_{n-1}` for the orthonormal polynomials `p_n`: `(a_n, b_n)`.
    pub(crate) fn recurrence(self, n: usize) -> (f64, f64) {
        let Self { alpha, beta } = self;
        let (k, sum) = (n as f64, alpha + beta);
        if n == 0 {
            let off = 2.0 / (sum + 2.0) * ((alpha + 1.0) * (beta + 1.0) / (sum + 3.0)).sqrt();
            return ((beta - alpha) / (sum + 2.0), off);
        }
        let degree = 2.0 * k + sum;
        let diagonal = (beta - alpha) / degree * (sum / (degree + 2.0));
        let product = (k + 1.0) * (k + 1.0 + alpha) / (degree + 1.0)
            * ((k + 1.0 + beta) * (k + 1.0 + sum) / (degree + 3.0));
        (diagonal, 2.0 / (degree + 2.0) * product.sqrt())
    }
}

/// The values of Jacobi polynomials of growing degree at one point.
#[derive(Debug, Clone)]
pub(crate) struct Values {
    /// With the nearer end as `t = 1`.
    polynomials: Jacobi,
    /// Half of the distance to that end.
    distance: f64,
    /// Sign of `P_1` at that end.
    sign: f64,
    /// `n`.
    index: f64,
    /// `P_n` at that end.
    end: f64,
    /// `P_n(t)` as a share of that.
    share: f64,
    /// Its difference to the share before.
    difference: f64,
}

impl Iterator for Values {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        let value = self.end * self.share;
        let Jacobi { alpha, beta } = self.polynomials;
        let (n, sum) = (self.index, alpha + beta);
        let next = n + 1.0 + alpha;
        if n == 0.0 {
            self.difference = -(sum + 2.0) / next * self.distance * self.share;
        } else {
            let degree = 2.0 * n + sum;
            let inverse = 1.0 / (next * (n + 1.0 + sum));
            let ratio = n * (n + beta) * (degree + 2.0) / degree * inverse;
            let slope = (degree + 1.0) * (degree + 2.0) * inverse;
            self.difference = ratio * self.difference - slope * self.distance * self.share;
        }
        self.share += self.difference;
        self.end *= self.sign * next / (n + 1.0);
        self.index = n + 1.0;
        Some(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(t: f64) -> Argument {
        Argument { from_one: 0.5 * (1.0 - t), from_minus_one: 0.5 * (1.0 + t) }
    }

    #[test]
    fn equal_exponents_of_minus_a_half_are_chebyshev_polynomials() {
        // P_n^(-1/2,-1/2)(cos u) = (1/2)_n / n! cos(n u)
        let jacobi = Jacobi::new(-0.5, -0.5);
        for i in 0..=40 {
            let u = std::f64::consts::PI * f64::from(i) / 40.0;
            let point = Argument {
                from_one: (0.5 * u).sin().powi(2),
                from_minus_one: (0.5 * u).cos().powi(2),
            };
            let mut end = 1.0;
            for (n, found) in jacobi.values(point, 1.0).take(2000).enumerate() {
                let exact = end * (n as f64 * u).cos();
                assert!((found - exact).abs() < 1e-12 * end, "n = {n}, u = {u}: {found} {exact}");
                end *= (n as f64 + 0.5) / (n as f64 + 1.0);
            }
        }
    }

    #[test]
    fn low_degrees_have_their_formulae() {
        let (alpha, beta) = (2.5, -0.6);
        let jacobi = Jacobi::new(alpha, beta);
        for t in [-1.0, -0.7, -0.2, 0.0, 0.4, 0.9, 1.0] {
            let found: Vec<f64> = jacobi.values(at(t), 3.0).take(3).collect();
            let first = (alpha + 1.0) + (alpha + beta + 2.0) * 0.5 * (t - 1.0);
            // DLMF 18.5.7
            let w = 0.5 * (t - 1.0);
            let second = 0.5 * (alpha + 1.0) * (alpha + 2.0)
                + (alpha + 2.0) * (alpha + beta + 3.0) * w
                + 0.5 * (alpha + beta + 3.0) * (alpha + beta + 4.0) * w * w;
            for (found, exact) in found.iter().zip([1.0, first, second]) {
                assert!((found - 3.0 * exact).abs() < 1e-14 * (1.0 + exact.abs()), "t = {t}");
            }
            assert!((jacobi.sum(&[0.0, 2.0], at(t), 1.0) - 2.0 * first).abs() < 1e-14);
        }
    }

    #[test]
    fn the_orthonormal_recurrence_is_that_of_the_polynomials() {
        // Without norms: a_n, and b_n^2 = (coefficient up) (coefficient down) of the recurrence of P_n.
        for (alpha, beta) in [(0.0, -0.5), (2.5, -0.9), (0.5, 0.3), (-0.5, -0.5)] {
            let jacobi = Jacobi::new(alpha, beta);
            let (s, t) = (0.3, -0.8);
            let [p, q]: [Vec<f64>; 2] =
                [s, t].map(|t| jacobi.values(at(t), 1.0).take(12).collect());
            let mut up_before = 0.0;
            for n in 1..11 {
                // t P_n = u P_{n+1} + a_n P_n + d P_{n-1}; u from the leading coefficients (DLMF 18.3.1)
                let (k, sum) = (n as f64, alpha + beta);
                let up = 2.0 * (k + 1.0) * (k + 1.0 + sum)
                    / ((2.0 * k + sum + 1.0) * (2.0 * k + sum + 2.0));
                let a = jacobi.recurrence(n).0;
                let down = |t: f64, p: &[f64]| (t * p[n] - up * p[n + 1] - a * p[n]) / p[n - 1];
                assert!((down(s, &p) - down(t, &q)).abs() < 1e-13, "{alpha} {beta} {n}");
                let off = jacobi.recurrence(n - 1).1;
                if n > 1 {
                    assert!((off * off - up_before * down(s, &p)).abs() < 1e-13);
                }
                up_before = up;
            }
        }
    }
}
