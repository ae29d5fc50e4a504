//! Jacobi polynomials `P_n^(alpha, beta)(t)` on `[-1, 1]`, `alpha, beta > -1` (DLMF 18).

use crate::Error;
use crate::quadrature::gauss_jacobi;

/// Steps of Newton's method from nodes that are known to 1e-16 but not relative to their distance from an end.
const STEPS: usize = 2;

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
}

/// A node of a Gauss rule and its weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GaussNode {
    pub(crate) argument: Argument,
    pub(crate) weight: f64,
}

impl Jacobi {
    /// The Gauss rule of `count` nodes for `int_0^1 g z^alpha (1 - z)^beta dz`, `z = (1 - t)/2`, from `t = -1` to 1, with nodes and weights accurate relative to their
    /// own sizes: coefficients of expansions need it where weights differ much.
    ///
    /// # Errors
    /// Those of [`gauss_jacobi`].
    pub(crate) fn gauss(self, count: usize) -> Result<Vec<GaussNode>, Error> {
        let rule = gauss_jacobi(count, self.alpha, self.beta)?;
        let mut nodes: Vec<GaussNode> =
            rule.nodes.iter().map(|t| self.refined(count, *t)).collect();
        let total: f64 = nodes.iter().map(|node| node.weight).sum();
        let gamma = libm::tgamma;
        let exact =
            gamma(self.alpha + 1.0) * gamma(self.beta + 1.0) / gamma(self.alpha + self.beta + 2.0);
        nodes.iter_mut().for_each(|node| node.weight *= exact / total);
        Ok(nodes)
    }

    /// The zero of `P_count` next to `t`, and `(1 - t^2)/P_(count-1)(t)^2`, to which the weight is proportional (DLMF 3.5.22, 18.9.17).
    fn refined(self, count: usize, t: f64) -> GaussNode {
        let Self { alpha, beta } = self;
        let n = count as f64;
        let degree = 2.0 * n + alpha + beta;
        let lead = 2.0 * (n + alpha) * (n + beta) / degree;
        let near_one = t > 0.0;
        let mut distance = 0.5 * (1.0 - t.abs());
        let place = |distance: f64| {
            let (near, far) = (distance, 1.0 - distance);
            let (from_one, from_minus_one) = if near_one { (near, far) } else { (far, near) };
            Argument { from_one, from_minus_one }
        };
        let mut before = 1.0;
        for step in 0..=STEPS {
            let argument = place(distance);
            let mut values = self.values(argument, 1.0).skip(count - 1);
            before = values.next().unwrap_or(1.0);
            if step == STEPS {
                break;
            }
            let value = values.next().unwrap_or(0.0);
            // (1 - t^2) dP/dt
            let t = argument.from_minus_one - argument.from_one;
            let slope = n * ((alpha - beta) / degree - t) * value + lead * before;
            let change = 2.0 * value / slope * (1.0 - distance) * distance;
            let moved = if near_one { distance + change } else { distance - change };
            if moved > 0.0 && moved < 1.0 {
                distance = moved;
            }
        }
        let weight = distance * (1.0 - distance) / (before * before);
        GaussNode { argument: place(distance), weight }
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
    fn gauss_rules_have_exact_moments_relative_to_themselves() {
        // int z^(alpha+k) (1-z)^(beta+l) dz = B(alpha+k+1, beta+l+1): high k and l weigh either end alone.
        for (alpha, beta) in [(0.0, -0.5), (0.7, -0.99), (-0.5, 0.4), (0.0, 0.0), (0.5, -0.01)] {
            for count in [1, 2, 7, 40, 200] {
                let rule = Jacobi::new(alpha, beta).gauss(count).unwrap();
                for (k, l) in [(0, 0), (1, 0), (0, 1), (count, 0), (0, count), (count, count - 1)] {
                    let found: f64 = rule
                        .iter()
                        .map(|node| {
                            let Argument { from_one, from_minus_one } = node.argument;
                            node.weight * from_one.powi(k as i32) * from_minus_one.powi(l as i32)
                        })
                        .sum();
                    let (p, q) = (alpha + k as f64 + 1.0, beta + l as f64 + 1.0);
                    let exact = (libm::lgamma(p) + libm::lgamma(q) - libm::lgamma(p + q)).exp();
                    let rounding = 1e-14 * (2.0 + (count as f64).ln() * count as f64);
                    assert!(
                        (found / exact - 1.0).abs() < rounding,
                        "{alpha} {beta} {count} {k} {l}"
                    );
                }
            }
        }
    }
}
