//! Kernel 2: `ln((x + s)/|x - s|)` on `(b, a)`.

use std::f64::consts::PI;

use super::half_sums::half_sums;
use super::{
    EndExponents, Expansion, Gram, Kernel, Pair, Parity, Singularity, SpectralRelation, Split,
};
use crate::basis::harmonics::Harmonics;
use crate::basis::{ChebyshevSeries, Function};
use crate::special::elliptic::{carlson_first_kind, complete_first_kind};
use crate::special::logarithms_of_one_and;
use crate::{Error, Interval};

/// Range of the ends: squares neither overflow nor vanish.
const ENDS: std::ops::RangeInclusive<f64> = 1e-150..=1e150;
/// Smallest `b/a`: its square must not vanish.
const SMALLEST_RATIO: f64 = 1e-150;
/// `exp(-x)` with this `x` is nothing beside 1.
const NEGLIGIBLE: f64 = 46.0;

/// `K(x, s) = ln((x + s)/|x - s|)` on `(b, a)`, `0 < b < a`: two equal punches on `(b, a)` and `(-a, -b)` loaded alike but with opposite signs. Positive.
///
/// Spectral relation: with the moduli `k' = b/a`, `k^2 = 1 - k'^2`, the complete elliptic integrals `K = K(k)`, `K' = K(k')` and
/// `x = a dn(K t/pi, k)`, `0 <= t <= pi` from `a` to `b`,
///
/// `phi_n = cos n t`, `w = 1/sqrt((a^2 - x^2)(x^2 - b^2))`, `lambda_0 = pi K'/a`, `lambda_n = (K/(a n)) tanh(n pi K'/K)`, `h_0 = K/a`, `h_n = K/(2a)`.
///
/// Gram matrix: `R_km = (c_{k+m} + c_{|k-m|})/2`, `c_0 = a - b`, `c_j = (2 pi a/K) sum n^2 sech(n pi K'/K)/(n^2 - j^2)` over the `n >= 1` of the
/// other parity than `j`.
///
/// As `b -> 0` the eigenvalues crowd towards `pi^2/(2a)`, and as many more terms are needed as `K ~ ln(4a/b)` grows; for `b = 0`
/// there is [`LogarithmRatioLimit`](super::LogarithmRatioLimit). As `b -> a` the system becomes that of [`Logarithm`](super::Logarithm).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogarithmRatio {
    interval: Interval,
    /// `K`.
    complete: f64,
    /// `K'`.
    complementary: f64,
}

impl LogarithmRatio {
    /// The kernel on `(inner, outer)`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `0 < inner < outer`, `outer` between `1e-150` and `1e150`, and `inner` at least `1e-150 outer`.
    pub fn new(inner: f64, outer: f64) -> Result<Self, Error> {
        if !ENDS.contains(&outer) {
            return Err(Error::InvalidParameter {
                name: "outer end",
                value: outer,
                requirement: "between 1e-150 and 1e150, so that its square neither overflows nor vanishes",
            });
        }
        if !(inner > 0.0 && inner / outer >= SMALLEST_RATIO && inner < outer) {
            return Err(Error::InvalidParameter {
                name: "inner end",
                value: inner,
                requirement: "positive, at least 1e-150 of the outer end and below it: the weight is not integrable at 0, \
                    where the system is another one (LogarithmRatioLimit)",
            });
        }
        let modulus = ((outer - inner) / outer).sqrt() * ((outer + inner) / outer).sqrt();
        Ok(Self {
            interval: Interval::new(inner, outer)?,
            complete: complete_first_kind(inner / outer),
            complementary: complete_first_kind(modulus),
        })
    }

    /// `b`.
    #[must_use]
    pub fn inner(&self) -> f64 {
        self.interval.left()
    }

    /// `a`.
    #[must_use]
    pub fn outer(&self) -> f64 {
        self.interval.right()
    }

    /// `pi K'/K`, minus the logarithm of the nome.
    fn decay(&self) -> f64 {
        PI * self.complementary / self.complete
    }

    /// The eigenfunctions at a point, by the angle `t` from the outer or `pi - t` from the inner end.
    fn harmonics(&self, x: f64) -> Harmonics {
        let (a, b) = (self.outer(), self.inner());
        let x = x.clamp(b, a);
        // With u = K t/pi: sn^2 u, cn^2 u, dn^2 u.
        let sn = ((a - x) / (a - b)) * ((a + x) / (a + b));
        let cn = ((x - b) / (a - b)) * ((x + b) / (a + b));
        let scale = PI / self.complete;
        if (x / a) * x > b {
            let dn = (x / a) * (x / a);
            Harmonics::cosines(scale * sn.sqrt() * carlson_first_kind(cn, dn, 1.0), false)
        } else {
            // The same functions of K - u: cn/dn, k' sn/dn, k'/dn.
            let dn = (b / x) * (b / x);
            let sine = cn.sqrt() / (x / a);
            Harmonics::cosines(scale * sine * carlson_first_kind(dn * sn, dn, 1.0), true)
        }
    }

    /// `x = a dn(K t/pi)` for `cos t`.
    fn position(&self, cosine: f64) -> f64 {
        let t = ((1.0 - cosine) * (1.0 + cosine)).sqrt().atan2(cosine);
        let a = self.outer();
        let x = if self.complementary <= self.complete {
            // (pi/2K') sum_n sech(pi (u - 2nK)/(2K')): all digits, however small dn is.
            let rate = 0.5 * self.complete / self.complementary;
            let term = |n: f64| 1.0 / (rate * (t - 2.0 * PI * n)).cosh();
            let count = (NEGLIGIBLE / (2.0 * PI * rate)).ceil() as i32;
            let images: f64 = (1..=count).rev().map(f64::from).map(|n| term(n) + term(-n)).sum();
            0.5 * PI * a / self.complementary * (images + term(0.0))
        } else {
            // (pi/2K) [1 + 2 sum_n sech(n pi K'/K) cos(n t)]
            let decay = self.decay();
            let count = (NEGLIGIBLE / decay).ceil() as i32;
            let term = |n: f64| (n * t).cos() / (n * decay).cosh();
            let sum: f64 = (1..=count).rev().map(f64::from).map(term).sum();
            0.5 * PI * a / self.complete * (1.0 + 2.0 * sum)
        };
        x.clamp(self.inner(), a)
    }

    /// `c_0, c_1, ...`.
    fn integrals(&self, count: usize) -> Vec<f64> {
        let decay = self.decay();
        let scale = 2.0 * PI * self.outer() / self.complete;
        // n^2 sech(n decay) until n^2 e^(-n decay) is negligible beside its maximum.
        let last = (2.0 + (NEGLIGIBLE + 8.0) / decay).ceil() as i32;
        let terms: Vec<(f64, f64)> =
            (1..=last).map(f64::from).map(|n| (n, scale * n * n / (n * decay).cosh())).collect();
        let integral = |j: usize| {
            let first = usize::from(!j.is_multiple_of(2));
            let j = j as f64;
            // The largest n last: the small terms come first.
            terms.iter().skip(first).step_by(2).rev().map(|(n, c)| c / ((n - j) * (n + j))).sum()
        };
        let length = self.outer() - self.inner();
        (0..count).map(|j| if j == 0 { length } else { integral(j) }).collect()
    }
}

impl Kernel for LogarithmRatio {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        Singularity::Logarithm
    }

    fn split(&self, x: f64, s: f64, _distance: f64) -> Split {
        Split { factor: -1.0, rest: (x + s).ln() }
    }

    fn pair(&self, x: f64, s: f64, distance: f64) -> Pair {
        Pair { value: ratio(x, s, distance), factor: -1.0 }
    }

    fn pairs(
        &self,
        x: f64,
        points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        factors: &mut [f64],
    ) {
        ratios(x, points, distances, values);
        factors.fill(-1.0);
    }
}

/// `ln((x + s)/|x - s|)`: the sum would lose the digits of a small value, `2 s/x` where `s` is far below `x`.
pub(super) fn ratio(x: f64, s: f64, distance: f64) -> f64 {
    (2.0 * (x.min(s) / distance)).ln_1p()
}

/// [`ratio`] for many points.
pub(super) fn ratios(x: f64, points: &[f64], distances: &[f64], values: &mut [f64]) {
    for ((value, s), distance) in values.iter_mut().zip(points).zip(distances) {
        *value = 2.0 * (x.min(*s) / distance);
    }
    logarithms_of_one_and(values);
}

impl SpectralRelation for LogarithmRatio {
    fn weight_exponents(&self) -> EndExponents {
        EndExponents { left: -0.5, right: -0.5 }
    }

    fn weight_rest(&self, _n: usize, x: f64) -> f64 {
        1.0 / ((self.outer() + x).sqrt() * (self.inner() + x).sqrt())
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        if n == 0 {
            PI * self.complementary / self.outer()
        } else {
            let n = n as f64;
            self.complete / (self.outer() * n) * (n * self.decay()).tanh()
        }
    }

    fn norm(&self, n: usize) -> f64 {
        self.complete / self.outer() * if n == 0 { 1.0 } else { 0.5 }
    }

    fn expansion_factor(&self, n: usize) -> f64 {
        if n == 0 {
            self.decay()
        } else {
            let n = n as f64;
            2.0 / n * (n * self.decay()).tanh()
        }
    }

    fn parity(&self) -> Parity {
        Parity::None
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        self.harmonics(x).fill(values.iter_mut());
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        self.harmonics(x).sum(coefficients.iter())
    }

    fn largest_sum(&self, coefficients: &[f64]) -> Option<f64> {
        Some(ChebyshevSeries::new(coefficients.to_vec()).largest_value())
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        half_sums(count, 0, |count| self.integrals(count))
    }

    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        let function = Function::resolve(&|cosine| f(self.position(cosine)))?;
        Ok(Expansion {
            coefficients: function.series().coefficients().to_vec(),
            error: function.error(),
            resolved: function.is_resolved(),
        })
    }
}
