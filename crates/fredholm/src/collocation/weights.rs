//! Exact integrals of the sinc functions against the singular functions.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::kernel::{Singularity, Split};
use crate::special::{cosine_integral_pi, oscillatory_tail};

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;

/// What turns values of a kernel into exact sinc weights.
///
/// With nodes `jh`, `int sinc(u/h - j) sigma(|ih - u|) du` is `h (ln h + c_{i-j})` for the logarithm, where
/// `c_0 = -(gamma + ln pi)`, `c_j = ln j - Ci(pi j)`, and `h^(1-mu) c_{i-j}` for the power, where
/// `c_j = (2 Gamma(1-mu) sin(pi mu/2)/pi) int_0^pi w^(mu-1) cos(jw) dw`. A plain trapezoidal rule has `ln(hj)` and
/// `(hj)^-mu` there: beside it remain the term `-Ci(pi j)` and the factor `j^mu c_j`.
#[derive(Debug, Clone)]
pub(super) enum SincWeights {
    /// `c_0, -Ci(pi), -Ci(2 pi), ...`.
    Logarithm(Vec<f64>),
    /// `mu`, and `c_0, c_1, 2^mu c_2, ...`.
    Power(f64, Vec<f64>),
    Smooth,
}

impl SincWeights {
    /// For index differences below `count`.
    pub(super) fn new(singularity: Singularity, count: usize) -> Self {
        match singularity {
            Singularity::Logarithm => Self::Logarithm(logarithm(count)),
            Singularity::Power { exponent } => Self::Power(exponent, power(exponent, count)),
            Singularity::None => Self::Smooth,
        }
    }

    /// The entry of the matrix, less the weight, for two nodes `difference > 0` places apart.
    pub(super) fn apart(&self, split: Split, distance: f64, difference: usize) -> f64 {
        let Split { factor, rest } = split;
        match self {
            Self::Logarithm(c) => factor * (distance.ln() + c[difference]) + rest,
            Self::Power(exponent, c) => factor * distance.powf(-exponent) * c[difference] + rest,
            Self::Smooth => rest,
        }
    }

    /// The same for a node and itself; `weight` is `h dx/dt`.
    pub(super) fn at_node(&self, split: Split, weight: f64) -> f64 {
        let Split { factor, rest } = split;
        match self {
            Self::Logarithm(c) => factor * (weight.ln() + c[0]) + rest,
            Self::Power(exponent, c) => factor * weight.powf(-exponent) * c[0] + rest,
            Self::Smooth => rest,
        }
    }
}

fn logarithm(count: usize) -> Vec<f64> {
    (0..count).map(|j| if j == 0 { -(EULER + PI.ln()) } else { -cosine_integral_pi(j) }).collect()
}

/// `j^mu c_j = 1 - C int_{pi j}^inf v^(mu-1) cos v dv` with `C = 2 Gamma(1-mu) sin(pi mu/2)/pi`, because the whole
/// integral from 0 is `1/C`; `c_0 = C pi^mu/mu`.
fn power(exponent: f64, count: usize) -> Vec<f64> {
    let constant = 2.0 * libm::tgamma(1.0 - exponent) * (FRAC_PI_2 * exponent).sin() / PI;
    (0..count)
        .map(|j| {
            if j == 0 {
                return constant * PI.powf(exponent) / exponent;
            }
            let sign = if j.is_multiple_of(2) { 1.0 } else { -1.0 };
            let scale = constant * (PI * j as f64).powf(exponent);
            1.0 - sign * scale * oscillatory_tail(exponent, j)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Origin: see the head of the file.
    const REFERENCE: &str = include_str!("../../tests/data/sinc_weights_power.txt");

    #[test]
    fn weights_of_the_power_agree_with_mpmath() {
        let mut compared = 0;
        for line in REFERENCE.lines().filter(|line| !line.starts_with('#')) {
            let fields: Vec<f64> =
                line.split_whitespace().map(|field| field.parse().unwrap()).collect();
            let [exponent, j, exact] = fields[..] else { panic!("three numbers a line") };
            let found = power(exponent, j as usize + 1)[j as usize];
            // Gamma(1 - mu) carries the rounding of 1 - mu.
            assert!(
                (found - exact).abs() < 1e-15 + 5e-16 / (1.0 - exponent) * exact.abs(),
                "mu = {exponent}, j = {j}: {found} {exact}"
            );
            compared += 1;
        }
        assert_eq!(compared, 63);
    }
}
