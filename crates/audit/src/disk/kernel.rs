//! The kernels of a disk, harmonic by harmonic.
//!
//! `K(x, y) = (G/2) |x - y|^-(1+mu)` on the disk, `G = 2^mu Gamma((1+mu)/2)/Gamma((1-mu)/2)`, is `pi int_0^inf t^mu J_m(r t) J_m(s t) dt` on densities `q(s) cos(m phi)` with the
//! measure `s ds`: `K_m(r, s) = (G/2) int_0^(2 pi) cos(m phi) R^-(1+mu) dphi`, `R^2 = r^2 + s^2 - 2 r s cos(phi)`.

use std::f64::consts::{FRAC_1_PI, PI};

use super::series::Series;
use crate::elementary::{exp, ln};
use crate::legendre::ORDER;
use crate::vectorised::vectorised;

/// Most terms of a series. Of a kernel its terms halve at least; of its parts beside `r = s` they fall as `1 - (s/r)^2`, which is 8/9 at most where these serve.
const TERMS: usize = 400;
/// Most steps of a mean: from the smallest numbers of the machine it takes sixteen.
const STEPS: usize = 40;
/// Means that advance together, a divisor of their number.
const LANES: usize = 8;
/// Nearer places are taken to be this far from each other, relative to their sum, where a kernel is split: what is left without its singularity is even in the distance.
const APART: f64 = 1e-9;

/// The kernel of a harmonic, 0 or 1.
#[derive(Debug, Clone)]
pub(crate) struct Harmonic {
    order: u32,
    exponent: f64,
    /// `G/2` times `2 pi (beta)_m/m!`, `beta = (1+mu)/2`.
    factor: f64,
    /// Coefficients of both series about `r = s`.
    beside: [f64; 2],
    /// The series about `s = 0`, and both about `r = s`, of graded ground.
    series: [Series; 3],
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
        let series = if exponent > 0.0 {
            [
                Series::new(beta, beta + m, m + 1.0),
                Series::new(beta, beta + m, 1.0 + mu),
                Series::new(m + 1.0 - beta, 1.0 - beta, 1.0 - mu),
            ]
        } else {
            Default::default()
        };
        Self { order, exponent, factor: PI * strength * rising, beside, series }
    }

    /// `K_m(r, s)` at the distance `d = |r - s| > 0`.
    #[cfg(test)]
    pub(crate) fn value(&self, r: f64, s: f64, d: f64) -> f64 {
        if self.exponent > 0.0 {
            let [value] = self.graded(r, &[s], &[d]);
            return value;
        }
        if self.order == 0 {
            return PI / means([r + s; ORDER], [d; ORDER])[0];
        }
        let [value] = turning(r, [s], [d]);
        value
    }

    /// The same of many `s` at once.
    pub(super) fn values(&self, r: f64, s: &[f64; ORDER], d: &[f64; ORDER]) -> [f64; ORDER] {
        if self.is_plain() {
            means(s.map(|s| r + s), *d).map(|mean| PI / mean)
        } else if self.exponent > 0.0 {
            vectorised(
                #[inline(always)]
                || self.graded(r, s, d),
            )
        } else {
            vectorised(
                #[inline(always)]
                || {
                    let mut found = [0.0; ORDER];
                    for from in (0..ORDER).step_by(LANES) {
                        let (mut own, mut apart) = ([0.0; LANES], [0.0; LANES]);
                        own.copy_from_slice(&s[from..from + LANES]);
                        apart.copy_from_slice(&d[from..from + LANES]);
                        found[from..from + LANES].copy_from_slice(&turning(r, own, apart));
                    }
                    found
                },
            )
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
        if self.exponent > 0.0 {
            return vectorised(
                #[inline(always)]
                || self.graded_split(r, s, half),
            );
        }
        let mut split = Split { regular: [0.0; ORDER], singular: [0.0; ORDER], size: [0.0; ORDER] };
        let d = s.map(|s| (r - s).abs().max(APART * (r + s)));
        let values = self.values(r, s, &d);
        split.singular = if self.order == 0 {
            means([r; ORDER], *s).map(|mean| 1.0 / mean)
        } else {
            s.map(|s| self.logarithmic(r, s))
        };
        vectorised(
            #[inline(always)]
            || {
                let logarithms = ln(&d.map(|d| d / half));
                for j in 0..ORDER {
                    let taken = split.singular[j] * logarithms[j];
                    split.regular[j] = values[j] + taken;
                    split.size[j] = values[j] + taken.abs();
                }
            },
        );
        split
    }

    /// The factor of `-ln d` in the first harmonic on homogeneous ground.
    fn logarithmic(&self, r: f64, s: f64) -> f64 {
        let (large, small) = (r.max(s), r.min(s));
        let t = small / large;
        2.0 * FRAC_1_PI * self.factor * t / large * series(0.5, 1.5, 1.0, (1.0 - t) * (1.0 + t))
    }

    #[inline(always)]
    fn graded_split(&self, r: f64, s: &[f64; ORDER], half: f64) -> Split {
        let (mu, beta) = (self.exponent, 0.5 * (1.0 + self.exponent));
        let mut split = Split { regular: [0.0; ORDER], singular: [0.0; ORDER], size: [0.0; ORDER] };
        let [mut large, mut rest, mut scale, mut own, mut t] = [[0.0; ORDER]; 5];
        let mut largest = 0.0f64;
        for j in 0..ORDER {
            large[j] = r.max(s[j]);
            t[j] = r.min(s[j]) / large[j];
            rest[j] = (1.0 - t[j]) * (1.0 + t[j]);
            largest = largest.max(rest[j]);
            scale[j] = (large[j] + r.min(s[j])) * half / (large[j] * large[j]);
            own[j] = ((r - s[j]).abs() / half).max(APART);
        }
        let regular = self.series[1].sums(&rest, largest);
        let singular = self.series[2].sums(&rest, largest);
        let factors = exp(&ln(&large).map(|ln| -2.0 * beta * ln));
        let scales = exp(&ln(&scale).map(|ln| -mu * ln));
        let powers = exp(&ln(&own).map(|ln| -mu * ln));
        for j in 0..ORDER {
            let power = if self.order == 0 { 1.0 } else { t[j] };
            let factor = self.factor * factors[j] * power;
            split.regular[j] = factor * (self.beside[0] * regular[j]);
            split.singular[j] = factor * (self.beside[1] * singular[j]) * scales[j];
            split.size[j] = (split.regular[j] + split.singular[j] * powers[j]).abs();
        }
        split
    }

    #[inline(always)]
    fn graded<const N: usize>(&self, r: f64, s: &[f64; N], d: &[f64; N]) -> [f64; N] {
        let (mu, beta) = (self.exponent, 0.5 * (1.0 + self.exponent));
        let [mut large, mut t, mut rest, mut apart, mut beside] = [[0.0; N]; 5];
        let mut largest = [0.0f64; 2];
        for j in 0..N {
            large[j] = r.max(s[j]);
            t[j] = r.min(s[j]) / large[j];
            // 1 - t^2
            rest[j] = d[j] * (r + s[j]) / (large[j] * large[j]);
            if rest[j] >= 0.5 {
                apart[j] = t[j] * t[j];
            } else {
                beside[j] = rest[j];
            }
            largest = [largest[0].max(apart[j]), largest[1].max(beside[j])];
        }
        let mut found = self.series[0].sums(&apart, largest[0]);
        if largest[1] > 0.0 {
            let regular = self.series[1].sums(&beside, largest[1]);
            let singular = self.series[2].sums(&beside, largest[1]);
            let powers = exp(&ln(&rest).map(|ln| -mu * ln));
            for j in 0..N {
                if rest[j] < 0.5 {
                    found[j] =
                        self.beside[0] * regular[j] + self.beside[1] * powers[j] * singular[j];
                }
            }
        }
        let factors = exp(&ln(&large).map(|ln| -2.0 * beta * ln));
        for j in 0..N {
            let power = if self.order == 0 { 1.0 } else { t[j] };
            found[j] *= self.factor * factors[j] * power;
        }
        found
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

/// Gauss's arithmetic-geometric means of many numbers, which advance together: their roots do not wait for each other.
fn means(a: [f64; ORDER], b: [f64; ORDER]) -> [f64; ORDER] {
    let mut found = [0.0; ORDER];
    vectorised(
        #[inline(always)]
        || {
            for from in (0..ORDER).step_by(LANES) {
                let (mut one, mut other) = ([0.0; LANES], [0.0; LANES]);
                one.copy_from_slice(&a[from..from + LANES]);
                other.copy_from_slice(&b[from..from + LANES]);
                for _ in 0..STEPS {
                    let mut apart = [false; LANES];
                    for i in 0..LANES {
                        apart[i] = (one[i] - other[i]).abs() > 1e-8 * one[i];
                        let (sum, product) = (one[i] + other[i], one[i] * other[i]);
                        one[i] = 0.5 * sum;
                        other[i] = product.sqrt();
                    }
                    if apart == [false; LANES] {
                        break;
                    }
                }
                found[from..from + LANES].copy_from_slice(&one);
            }
        },
    );
    found
}

/// The first harmonic on homogeneous ground: `(4 K/(sigma m)) sum 2^(n-1) c_n^2` with the complete integral `K` of the parameter `m = 4 r s/sigma^2`, `sigma = r + s`, and half the differences `c_n` of
/// Gauss's means, which are found without cancellation.
#[inline(always)]
fn turning<const N: usize>(r: f64, s: [f64; N], d: [f64; N]) -> [f64; N] {
    let (mut a, mut b, mut c) = (s.map(|s| r + s), d, s.map(|s| r.min(s)));
    let (mut parts, mut weight) = ([0.0; N], 1.0);
    for _ in 0..STEPS {
        let mut apart = [false; N];
        for i in 0..N {
            apart[i] = c[i] > 1e-9 * a[i];
            parts[i] += weight * (c[i] * c[i]);
            let (sum, product) = (a[i] + b[i], a[i] * b[i]);
            a[i] = 0.5 * sum;
            b[i] = product.sqrt();
            c[i] = c[i] * c[i] / (2.0 * (a[i] + b[i]));
        }
        if apart == [false; N] {
            break;
        }
        weight *= 2.0;
    }
    std::array::from_fn(|i| {
        let product = r * s[i];
        if product == 0.0 { 0.0 } else { PI / (a[i] + b[i]) * parts[i] / product }
    })
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
