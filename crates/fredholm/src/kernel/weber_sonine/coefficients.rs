//! The hypergeometric functions of the kernel of Weber and Sonine.

use std::f64::consts::PI;

use crate::special::{half_gamma_quotient, mean_digamma};

/// Terms of the series about the diagonal, which reach rounding for `delta <= 1/2`.
pub(super) const NEAR_TERMS: usize = 16;

/// With `r = |ln(x/s)|` and `delta = 2 sinh(r/2) = |x - s|/sqrt(x s)`, and `q = 2 gamma`,
///
/// `(x s)^(1/2+gamma) W = (kappa/q) [F_1 delta^-q - e^(q l) F_2]`, `F_1 = F(1/2-mu, 1/2+mu; 1-gamma; v)`, `F_2 = F(1/2-mu+gamma, 1/2+mu+gamma; 1+gamma; v)`,
/// `v = -delta^2/4`
///
/// (Legendre functions of `cosh r`, DLMF 14.3, 15.10): analytic in `gamma` through 0, where it is `kappa [-F_1 (ln delta + l) + dF]`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Coefficients {
    pub(super) order: f64,
    pub(super) exponent: f64,
    /// `kappa = 4^gamma Gamma(1+gamma) / (sqrt(pi) Gamma(1/2-gamma))`.
    pub(super) strength: f64,
    /// `l = -ln 2 - [ln Gamma(1+gamma) - ln Gamma(1-gamma) - ln Gamma(mu+1/2+gamma) + ln Gamma(mu+1/2-gamma)]/(2 gamma)`.
    pub(super) shift: f64,
}

impl Coefficients {
    pub(super) fn new(order: f64, exponent: f64) -> Self {
        let span = 2.0 * exponent.abs();
        let mean = |middle: f64| mean_digamma(middle - exponent.abs(), span);
        let inverse_gamma = (0.5 - exponent) / libm::tgamma(1.5 - exponent);
        Self {
            order,
            exponent,
            strength: 4f64.powf(exponent) * libm::tgamma(1.0 + exponent) * inverse_gamma
                / PI.sqrt(),
            shift: mean(order + 0.5) - mean(1.0) - std::f64::consts::LN_2,
        }
    }

    /// The coefficients of the powers of `delta^2/4` in `F_1` and in `dF = (F_1 - F_2)/q`, the latter stepped as differences.
    pub(super) fn near(&self) -> [[f64; 2]; NEAR_TERMS] {
        let (mu, gamma) = (self.order, self.exponent);
        let (mut first, mut second, mut difference) = (1.0, 1.0, 0.0);
        let mut terms = [[1.0, 0.0]; NEAR_TERMS];
        for (k, term) in terms.iter_mut().enumerate().skip(1) {
            let k = k as f64;
            let middle = k - 0.5;
            let square = (middle - mu) * (middle + mu);
            let step = square / ((k - gamma) * k);
            let shifted = middle + gamma;
            let other = (shifted - mu) * (shifted + mu) / ((k + gamma) * k);
            // (step - other)/(2 gamma)
            let slope =
                (square - (middle + 0.5 * gamma) * (k - gamma)) / ((k - gamma) * (k + gamma) * k);
            difference = -(difference * step + second * slope);
            first *= -step;
            second *= -other;
            *term = [first, difference];
        }
        terms
    }

    /// `C` in `W = C s^mu x^(-mu-1-2 gamma) F(mu+gamma+1/2, gamma+1/2; mu+1; s^2/x^2)`, `s < x`:
    /// `2^(2 gamma) Gamma(mu+gamma+1/2) / (Gamma(1/2-gamma) Gamma(mu+1))`.
    pub(super) fn far_strength(&self) -> f64 {
        let (mu, gamma) = (self.order, self.exponent);
        let inverse_gamma = (0.5 - gamma) / libm::tgamma(1.5 - gamma);
        4f64.powf(gamma) * half_gamma_quotient(mu, gamma) * inverse_gamma
    }

    /// That `F` at `1 - z`; all terms are positive.
    pub(super) fn far(&self, rest: f64) -> f64 {
        let (mu, gamma) = (self.order, self.exponent);
        let (a, b, c, z) = (mu + gamma + 0.5, gamma + 0.5, mu + 1.0, 1.0 - rest);
        let (mut term, mut sum, mut k) = (1.0, 1.0, 0.0);
        // The terms left make less than the last one over 1 - z.
        while term > 1e-17 * rest * sum {
            term *= (a + k) * (b + k) / ((c + k) * (k + 1.0)) * z;
            sum += term;
            k += 1.0;
        }
        sum
    }
}
