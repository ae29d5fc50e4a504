//! The kernels of a disk, harmonic by harmonic.
//!
//! `K(x, y) = (G/2) |x - y|^-(1+mu)` on the disk, `G = 2^mu Gamma((1+mu)/2)/Gamma((1-mu)/2)`, is `pi int_0^inf t^mu J_m(r t) J_m(s t) dt` on densities `q(s) cos(m phi)` with the
//! measure `s ds`: `K_m(r, s) = (G/2) int_0^(2 pi) cos(m phi) R^-(1+mu) dphi`, `R^2 = r^2 + s^2 - 2 r s cos(phi)`.

use std::f64::consts::{FRAC_1_PI, PI};

use crate::legendre::ORDER;

/// Most terms of a series. Of a kernel its terms halve at least; of its parts beside `r = s` they fall as `1 - (s/r)^2`, which is 8/9 at most where these serve.
const TERMS: usize = 400;
/// Most steps of a mean: from the smallest numbers of the machine it takes sixteen.
const STEPS: usize = 40;
/// Nearer places are taken to be this far from each other, relative to their sum, where a kernel is split: what is left without its singularity is even in the distance.
const APART: f64 = 1e-9;

/// The kernel of a harmonic, 0 or 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Harmonic {
    order: u32,
    exponent: f64,
    /// `G/2` times `2 pi (beta)_m/m!`, `beta = (1+mu)/2`.
    factor: f64,
    /// Coefficients of both series about `r = s`.
    beside: [f64; 2],
}

impl Harmonic {
    /// Of a homogeneous ground, `exponent = 0`, or a graded one, `0 < exponent < 1`.
    pub(crate) fn new(order: u32, exponent: f64) -> Self {
        let gamma = libm::tgamma;
        let (mu, m) = (exponent, f64::from(order));
        let beta = 0.5 * (1.0 + mu);
        let strength = 2f64.powf(mu) * gamma(beta) / gamma(1.0 - beta);
        let rising = if order == 0 { 1.0 } else { beta };
        // 2F1(beta, beta + m; m + 1; z) about z = 1; for mu = 0 both are infinite, and the mean of Gauss serves.
        let beside = [
            gamma(m + 1.0) * gamma(-mu) / (gamma(m + 1.0 - beta) * gamma(1.0 - beta)),
            gamma(m + 1.0) * gamma(mu) / (gamma(beta) * gamma(beta + m)),
        ];
        Self { order, exponent, factor: PI * strength * rising, beside }
    }

    /// `K_m(r, s)` at the distance `d = |r - s| > 0`.
    pub(crate) fn value(&self, r: f64, s: f64, d: f64) -> f64 {
        if self.exponent > 0.0 {
            return self.graded(r, s, d);
        }
        let sum = r + s;
        if self.order == 0 {
            return PI / mean(sum, d);
        }
        // (4 K/(sigma m)) sum 2^(n-1) c_n^2 with the complete integral K of the parameter m = 4 r s/sigma^2 and the differences c_n of the means.
        let (mut a, mut b) = (sum, d);
        // Half the difference of a and b, without cancellation.
        let mut c = r.min(s);
        let (mut parts, mut weight) = (0.0, 1.0);
        while c > 1e-9 * a {
            parts += weight * c * c;
            weight *= 2.0;
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
            c = c * c / (2.0 * (a + b));
        }
        let product = r * s;
        if product == 0.0 { 0.0 } else { 0.5 * PI / (0.5 * (a + b)) * parts / product }
    }

    /// The same of many `s` at once.
    pub(super) fn values(&self, r: f64, s: &[f64; ORDER], d: &[f64; ORDER]) -> [f64; ORDER] {
        if self.is_plain() {
            means(s.map(|s| r + s), *d).map(|mean| PI / mean)
        } else {
            std::array::from_fn(|j| self.value(r, s[j], d[j]))
        }
    }

    /// Whether it vanishes at the axis.
    pub(super) fn is_turning(&self) -> bool {
        self.order > 0
    }

    fn is_plain(&self) -> bool {
        self.exponent == 0.0 && self.order == 0
    }

    /// `K = R + L sigma(d/h)`, `sigma = -ln` or the power `-mu`, with `R` and `L` analytic in `s > 0`.
    ///
    /// By the expansions of hypergeometric functions about 1 (M. Abramowitz, I. A. Stegun, 15.3.6 and 15.3.10): on homogeneous ground `L_0 = 1/M(r, s)`.
    pub(super) fn split(&self, r: f64, s: &[f64; ORDER], half: f64) -> Split {
        let mut split = Split { regular: [0.0; ORDER], singular: [0.0; ORDER], size: [0.0; ORDER] };
        let mu = self.exponent;
        if mu > 0.0 {
            for (j, s) in s.iter().enumerate() {
                let [regular, singular] = self.graded_split(r, *s, half);
                let power = ((r - s).abs() / half).max(APART).powf(-mu);
                split.regular[j] = regular;
                split.singular[j] = singular;
                split.size[j] = (regular + singular * power).abs();
            }
            return split;
        }
        let d = s.map(|s| (r - s).abs().max(APART * (r + s)));
        let values = self.values(r, s, &d);
        split.singular = if self.order == 0 {
            means([r; ORDER], *s).map(|mean| 1.0 / mean)
        } else {
            s.map(|s| self.logarithmic(r, s))
        };
        for j in 0..ORDER {
            let taken = split.singular[j] * (d[j] / half).ln();
            split.regular[j] = values[j] + taken;
            split.size[j] = values[j] + taken.abs();
        }
        split
    }

    /// The factor of `-ln d` in the first harmonic on homogeneous ground.
    fn logarithmic(&self, r: f64, s: f64) -> f64 {
        let (large, small) = (r.max(s), r.min(s));
        let t = small / large;
        2.0 * FRAC_1_PI * self.factor * t / large * series(0.5, 1.5, 1.0, (1.0 - t) * (1.0 + t))
    }

    fn graded_split(&self, r: f64, s: f64, half: f64) -> [f64; 2] {
        let (large, small) = (r.max(s), r.min(s));
        let (mu, m) = (self.exponent, f64::from(self.order));
        let beta = 0.5 * (1.0 + mu);
        let t = small / large;
        let rest = (1.0 - t) * (1.0 + t);
        let power = if self.order == 0 { 1.0 } else { t };
        let factor = self.factor * large.powf(-2.0 * beta) * power;
        let regular = self.beside[0] * series(beta, beta + m, 1.0 + mu, rest);
        let singular = self.beside[1] * series(m + 1.0 - beta, 1.0 - beta, 1.0 - mu, rest);
        let scale = ((large + small) * half / (large * large)).powf(-mu);
        [factor * regular, factor * singular * scale]
    }

    fn graded(&self, r: f64, s: f64, d: f64) -> f64 {
        let (large, small) = (r.max(s), r.min(s));
        let beta = 0.5 * (1.0 + self.exponent);
        let m = f64::from(self.order);
        let t = small / large;
        // 1 - t^2
        let rest = d * (large + small) / (large * large);
        let function = if rest >= 0.5 {
            series(beta, beta + m, m + 1.0, t * t)
        } else {
            let mu = self.exponent;
            self.beside[0] * series(beta, beta + m, 1.0 + mu, rest)
                + self.beside[1]
                    * rest.powf(-mu)
                    * series(m + 1.0 - beta, 1.0 - beta, 1.0 - mu, rest)
        };
        let power = if self.order == 0 { 1.0 } else { t };
        self.factor * large.powf(-2.0 * beta) * power * function
    }

    /// What rounding does to a value, in units of it.
    pub(crate) fn rounding(&self) -> f64 {
        // Near a homogeneous ground the two series cancel.
        if self.exponent > 0.0 { 16.0 + 4.0 / self.exponent } else { 8.0 }
    }
}

/// A kernel without its singularity, the factor of this, and the sizes of what both were found from.
pub(super) struct Split {
    pub(super) regular: [f64; ORDER],
    pub(super) singular: [f64; ORDER],
    pub(super) size: [f64; ORDER],
}

/// A bound of `int K_m(r, s) s ds` over the disk of radius 1: it is largest at the axis, `pi G/(1-mu)`.
pub(super) fn mass(mu: f64) -> f64 {
    let gamma = libm::tgamma;
    PI * 2f64.powf(mu) * gamma(0.5 * (1.0 + mu)) / gamma(0.5 * (1.0 - mu)) / (1.0 - mu)
}

/// The arithmetic-geometric mean of Gauss.
fn mean(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 1e-8 * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    0.5 * (a + b)
}

/// The same of many numbers, which advance together: their roots do not wait for each other.
fn means(mut a: [f64; ORDER], mut b: [f64; ORDER]) -> [f64; ORDER] {
    for _ in 0..STEPS {
        let mut is_done = true;
        for (a, b) in a.iter_mut().zip(&mut b) {
            is_done &= (*a - *b).abs() <= 1e-8 * *a;
            (*a, *b) = (0.5 * (*a + *b), (*a * *b).sqrt());
        }
        if is_done {
            break;
        }
    }
    a
}

/// `2F1(a, b; c; z)`, `0 <= z < 1`.
fn series(a: f64, b: f64, c: f64, z: f64) -> f64 {
    let (mut term, mut sum) = (1.0f64, 1.0f64);
    for k in 0..TERMS {
        let n = k as f64;
        term *= (a + n) * (b + n) / ((c + n) * (n + 1.0)) * z;
        sum += term;
        if term.abs() < 1e-17 * sum.abs() {
            break;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `(G/2) int cos(m phi) R^-(1+mu) dphi` by the rule of the trapezia, which converges geometrically, to the rounding of its terms.
    fn integral(order: u32, mu: f64, r: f64, s: f64) -> f64 {
        let count = 20_000;
        let strength =
            2f64.powf(mu) * libm::tgamma(0.5 * (1.0 + mu)) / libm::tgamma(0.5 * (1.0 - mu));
        let sum: f64 = (0..count)
            .map(|k| {
                let phi = 2.0 * PI * f64::from(k) / f64::from(count);
                let square = (r - s).powi(2) + 4.0 * r * s * (0.5 * phi).sin().powi(2);
                (f64::from(order) * phi).cos() * square.powf(-0.5 * (1.0 + mu))
            })
            .sum();
        0.5 * strength * sum * 2.0 * PI / f64::from(count)
    }

    #[test]
    fn kernels_are_their_integrals() {
        for mu in [0.0, 0.05, 0.3, 0.8] {
            for order in [0, 1] {
                let kernel = Harmonic::new(order, mu);
                for (r, s) in [(0.5, 0.9), (0.9, 0.5), (0.31, 0.32), (0.01, 0.8), (1.0, 1e-3)] {
                    let (found, exact) =
                        (kernel.value(r, s, f64::abs(r - s)), integral(order, mu, r, s));
                    assert!(
                        (found - exact).abs() < 1e-12 * exact.abs() + 1e-14,
                        "{mu} {order} {r} {s}: {found} {exact}"
                    );
                }
            }
        }
    }

    /// Split or not, a kernel has the same values.
    #[test]
    fn split_kernels_are_whole() {
        for mu in [0.0, 0.05, 0.3, 0.8] {
            for order in [0, 1] {
                let kernel = Harmonic::new(order, mu);
                for (r, from) in [(0.7, 0.5), (0.5, 0.501), (0.4, 0.6), (0.9, 0.5)] {
                    let nodes = crate::legendre::RULE.nodes.map(|t| from * (1.5 + 0.5 * t));
                    let split = kernel.split(r, &nodes, 0.1);
                    for (j, s) in nodes.into_iter().enumerate() {
                        let d = f64::abs(r - s);
                        let own = if mu == 0.0 { -(d / 0.1).ln() } else { (d / 0.1).powf(-mu) };
                        let found = split.regular[j] + split.singular[j] * own;
                        let exact = kernel.value(r, s, d);
                        let terms = split.regular[j].abs() + (split.singular[j] * own).abs();
                        // The largest share of roundings is that of the series, whose terms fall slowly far from r = s.
                        assert!(
                            (found - exact).abs() <= 200.0 * f64::EPSILON * terms,
                            "{mu} {order} {r} {s}: {found} {exact}"
                        );
                    }
                }
            }
        }
    }
}
