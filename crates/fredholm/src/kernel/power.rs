//! Kernel 4: the power, `|x - s|^-mu`.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{
    EndExponents, Expansion, Gram, Kernel, Pair, Parity, Singularity, SpectralRelation, Split,
};
use crate::basis::expansion::expand_by_rule;
use crate::basis::gegenbauer;
use crate::quadrature::Rule;
use crate::quadrature::gauss_jacobi;
use crate::special::powers;
use crate::{Error, Interval, memory};

/// From here on `Gamma(n + mu)/Gamma(n)` by Stirling's series, whose terms kept reach rounding.
const STIRLING_FROM: usize = 16;

/// `K(x, s) = |x - s|^-mu`, `0 < mu < 1`, on a finite interval: the plane punch on a half-plane whose modulus grows as
/// the power `mu` of the depth (N. A. Rostovtsev), and creep with a power law (N. Kh. Arutyunyan). Positive.
///
/// Square-summable for `mu < 1/2` only; for every `mu < 1` it is compact and its spectral relation holds.
///
/// Spectral relation, with the half-length `a`, the middle `c` and `t = (x - c)/a`: `w = (a^2 - (x - c)^2)^((mu-1)/2)` and
///
/// `phi_n = Q_n(t) = C_n^(mu/2)(t)/C_n^(mu/2)(1)`, `C_n^(mu/2)(1) = (mu)_n/n!`,
///
/// Gegenbauer polynomials with the value 1 at `t = 1`: unlike `C_n` itself they have a limit as `mu -> 0`, `Q_n -> T_n`. A coefficient of
/// `C_n` is that of `Q_n` times `n!/(mu)_n`.
///
/// `lambda_n = pi (mu)_n/(cos(pi mu/2) n!)`, whatever `a`; `h_n = a^mu sqrt(pi) Gamma((1+mu)/2)/Gamma(1+mu/2) · (mu/2) n!/((n + mu/2)(mu)_n)`.
/// Decay `lambda_n = O(n^(mu-1))`. Gram matrix by a recurrence in both indices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Power {
    interval: Interval,
    exponent: f64,
    /// `lambda_0 = pi/cos(pi mu/2)`.
    first_eigenvalue: f64,
    /// `h_0`.
    first_norm: f64,
}

impl Power {
    /// `|x - s|^-exponent` on `interval`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `0 < exponent < 1`, and for an interval that is not finite.
    pub fn new(interval: Interval, exponent: f64) -> Result<Self, Error> {
        if !(exponent > 0.0 && exponent < 1.0) {
            return Err(Error::InvalidParameter {
                name: "exponent",
                value: exponent,
                requirement: "between 0 and 1, both excluded: below the kernel is not positive, above it cannot be integrated",
            });
        }
        if !interval.is_finite() {
            return Err(Error::InvalidParameter {
                name: "right end",
                value: interval.right(),
                requirement: "finite: on the half-line the kernel has no spectral relation",
            });
        }
        // cos(pi mu/2), without cancellation as mu -> 1
        let cosine = (FRAC_PI_2 * (1.0 - exponent)).sin();
        let total = gegenbauer::total_weight(0.5 * exponent);
        Ok(Self {
            interval,
            exponent,
            first_eigenvalue: PI / cosine,
            first_norm: interval.half_length().powf(exponent) * total,
        })
    }

    /// `mu`.
    #[must_use]
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// Whether `int int K^2 dx ds` is finite, `mu < 1/2`, which the paper asks for; the degenerate kernel converges without it, the slower the larger `mu` is.
    #[must_use]
    pub fn is_square_summable(&self) -> bool {
        self.exponent < 0.5
    }

    /// `t` of a point.
    fn local(&self, x: f64) -> f64 {
        (x - self.interval.centre()) / self.interval.half_length()
    }

    /// `(mu)_n/(mu (n-1)!) = Gamma(n + mu)/(Gamma(1 + mu) Gamma(n))` for `n >= 1`: 1 at `mu = 0`.
    fn growth(&self, n: usize) -> f64 {
        let mu = self.exponent;
        let below = n.min(STIRLING_FROM);
        let product: f64 = (1..below).map(|j| 1.0 + mu / j as f64).product();
        if n <= STIRLING_FROM {
            return product;
        }
        product * gamma_ratio(n as f64, mu) / gamma_ratio(STIRLING_FROM as f64, mu)
    }
}

/// `Gamma(x + mu)/Gamma(x)` for `x >= 16` and `0 <= mu <= 1`, by Stirling's series of both.
fn gamma_ratio(x: f64, mu: f64) -> f64 {
    let stirling = |x: f64| {
        let s = 1.0 / (x * x);
        (((s / 1188.0 - 1.0 / 1680.0) * s + 1.0 / 1260.0) * s - 1.0 / 360.0) * s / x
            + 1.0 / (12.0 * x)
    };
    let small = (x - 0.5) * (mu / x).ln_1p() - mu + stirling(x + mu) - stirling(x);
    (x + mu).powf(mu) * small.exp()
}

impl Kernel for Power {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        Singularity::Power { exponent: self.exponent }
    }

    fn split(&self, _x: f64, _s: f64, _distance: f64) -> Split {
        // d^-mu = 1 + mu sigma(d)
        Split { factor: self.exponent, rest: 1.0 }
    }

    fn pair(&self, _x: f64, _s: f64, distance: f64) -> Pair {
        Pair { value: distance.powf(-self.exponent), factor: self.exponent }
    }

    fn pairs(
        &self,
        _x: f64,
        _points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        factors: &mut [f64],
    ) {
        values.copy_from_slice(distances);
        powers(values, -self.exponent);
        factors.fill(self.exponent);
    }

    fn is_even(&self) -> bool {
        true
    }
}

impl SpectralRelation for Power {
    fn weight_exponents(&self) -> EndExponents {
        let exponent = 0.5 * (self.exponent - 1.0);
        EndExponents { left: exponent, right: exponent }
    }

    fn weight_rest(&self, _n: usize, _x: f64) -> f64 {
        1.0
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        if n == 0 {
            return self.first_eigenvalue;
        }
        self.first_eigenvalue * self.exponent * self.growth(n) / n as f64
    }

    fn norm(&self, n: usize) -> f64 {
        if n == 0 {
            return self.first_norm;
        }
        let n_real = n as f64;
        self.first_norm * 0.5 * (n_real / (n_real + 0.5 * self.exponent)) / self.growth(n)
    }

    fn parity(&self) -> Parity {
        Parity::Alternating
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        gegenbauer::polynomials(self.exponent, self.local(x), values);
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        gegenbauer::sum(self.exponent, coefficients, self.local(x))
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        memory::admit(count.saturating_sub(1), 16.0 * (count as f64).powi(2))?;
        let mut entries = gegenbauer::gram(self.exponent, count);
        entries.iter_mut().for_each(|entry| *entry *= self.interval.half_length());
        Ok(Gram::Dense { order: count, entries })
    }

    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        let exponent = 0.5 * (self.exponent - 1.0);
        let (centre, half) = (self.interval.centre(), self.interval.half_length());
        let scale = half.powf(self.exponent);
        expand_by_rule(self, f, |count| {
            let Rule { nodes, weights } = gauss_jacobi(count, exponent, exponent)?;
            Ok(Rule {
                nodes: nodes.iter().map(|t| centre + half * t).collect(),
                weights: weights.iter().map(|weight| scale * weight).collect(),
            })
        })
    }
}
