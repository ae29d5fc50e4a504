//! Exact integrals of the sinc functions against the singular functions.

use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::Range;
use std::sync::LazyLock;

use crate::kernel::{Pair, Singularity, Split};
use crate::linear::vectorised;
use crate::special::{cosine_integral_pi, oscillatory_tail, powers};

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;

/// What turns values of a kernel into exact sinc weights.
///
/// With nodes `jh`, `int sinc(u/h - j) ln|ih - u| du` is `h (ln h + c_{i-j})`, where `c_0 = -(gamma + ln pi)`,
/// `c_j = ln j - Ci(pi j)`. A plain trapezoidal rule has `ln(hj)` there: beside it remains the term `-Ci(pi j)`.
///
/// For the power `|ih - u|^-q` it is `h^(1-q) c_{i-j}`, where `c_j = (2 Gamma(1-q) sin(pi q/2)/pi) int_0^pi w^(q-1) cos(jw) dw`, continued
/// analytically to `q <= 0`; of `sigma = (d^-q - 1)/q` there remains beside the trapezoidal rule `d^-q e_j`, `e_j = (j^q c_j - 1)/q`, and
/// on the diagonal `(h^-q c_0 - 1)/q`. At `q = 0` they are those of `-ln d`.
#[derive(Debug, Clone)]
pub(super) enum SincWeights {
    /// `c_0, -Ci(pi), -Ci(2 pi), ...`.
    Logarithm(Vec<f64>),
    Power(PowerWeights),
    Smooth,
}

/// Weights of `(d^-q - 1)/q`.
#[derive(Debug, Clone)]
pub(super) struct PowerWeights {
    /// `q`.
    exponent: f64,
    /// `ln(c_0)/q`.
    origin: f64,
    /// `e_1, e_2, ...`, after a zero.
    corrections: Vec<f64>,
}

impl SincWeights {
    /// For index differences below `count`.
    pub(super) fn new(singularity: Singularity, count: usize) -> Self {
        match singularity {
            Singularity::Logarithm => Self::Logarithm(logarithm(count)),
            Singularity::Power { exponent } => Self::Power(PowerWeights::new(exponent, count)),
            Singularity::None => Self::Smooth,
        }
    }

    /// The entry of the matrix, less the weight, for two nodes `difference > 0` places apart.
    pub(super) fn apart(&self, pair: Pair, distance: f64, difference: usize) -> f64 {
        let Pair { value, factor } = pair;
        match self {
            Self::Logarithm(c) => value + factor * c[difference],
            Self::Power(power) => value + factor * power.apart(distance, difference),
            Self::Smooth => value,
        }
    }

    /// [`apart`](Self::apart) for neighbouring nodes on one side of a node, from the farthest to the nearest or the other way round: turns the values of the kernel into the entries.
    /// `differences` are how many places off they are, and the distances are used up.
    pub(super) fn apart_in_row(
        &self,
        values: &mut [f64],
        factors: &[f64],
        distances: &mut [f64],
        differences: Differences,
    ) {
        let corrections = match self {
            Self::Logarithm(corrections) => corrections,
            Self::Power(power) => {
                if power.exponent != 0.0 {
                    powers(distances, -power.exponent);
                } else {
                    distances.fill(1.0);
                }
                &power.corrections
            }
            Self::Smooth => return,
        };
        let is_logarithm = matches!(self, Self::Logarithm(_));
        vectorised(
            #[inline(always)]
            || {
                let terms = values.iter_mut().zip(factors).zip(&*distances);
                match differences {
                    Differences::Falling(range) => {
                        add(terms, corrections[range].iter().rev(), is_logarithm);
                    }
                    Differences::Growing(range) => {
                        add(terms, corrections[range].iter(), is_logarithm);
                    }
                }
            },
        );
    }

    /// The same for a node and itself; `weight` is `h dx/dt`.
    pub(super) fn at_node(&self, split: Split, weight: f64) -> f64 {
        let Split { factor, rest } = split;
        match self {
            Self::Logarithm(c) => factor * (weight.ln() + c[0]) + rest,
            Self::Power(power) => factor * power.at_node(weight) + rest,
            Self::Smooth => rest,
        }
    }
}

/// How many places neighbouring nodes are off, from left to right.
#[derive(Debug, Clone)]
pub(super) enum Differences {
    /// Left of the node, so that they fall.
    Falling(Range<usize>),
    /// Right of it.
    Growing(Range<usize>),
}

/// `value += factor correction power`, without the power for the logarithm.
#[inline(always)]
fn add<'v>(
    terms: impl Iterator<Item = ((&'v mut f64, &'v f64), &'v f64)>,
    corrections: impl Iterator<Item = &'v f64>,
    is_logarithm: bool,
) {
    if is_logarithm {
        for (((value, factor), _), correction) in terms.zip(corrections) {
            *value += factor * correction;
        }
    } else {
        for (((value, factor), power), correction) in terms.zip(corrections) {
            *value += factor * (power * correction);
        }
    }
}

fn logarithm(count: usize) -> Vec<f64> {
    /// As many as most equations need; they depend on nothing.
    static FIRST: LazyLock<[f64; 512]> = LazyLock::new(|| std::array::from_fn(of_logarithm));
    let known = &FIRST[..count.min(FIRST.len())];
    let mut weights = Vec::with_capacity(count);
    weights.extend_from_slice(known);
    weights.extend((known.len()..count).map(of_logarithm));
    weights
}

fn of_logarithm(j: usize) -> f64 {
    if j == 0 { -(EULER + PI.ln()) } else { -cosine_integral_pi(j) }
}

impl PowerWeights {
    /// `j^q c_j = 1 - C int_{pi j}^inf v^(q-1) cos v dv` with `C = 2 Gamma(1-q) sin(pi q/2)/pi`, because the whole
    /// integral from 0 is `1/C`; `c_0 = C pi^q/q`.
    fn new(exponent: f64, count: usize) -> Self {
        // ln(C/q) = ln Gamma(1-q) + ln(sin(pi q/2)/(pi q/2)), free of 0/0 at q = 0
        let strength = log_gamma_sine(exponent);
        let corrections = (0..count).map(|j| {
            if j == 0 {
                return 0.0;
            }
            let sign = if j.is_multiple_of(2) { -1.0 } else { 1.0 };
            let scale = (exponent * (strength + (PI * j as f64).ln())).exp();
            sign * scale * oscillatory_tail(exponent, j)
        });
        Self { exponent, origin: strength + PI.ln(), corrections: corrections.collect() }
    }

    fn apart(&self, distance: f64, difference: usize) -> f64 {
        let correction = self.corrections[difference];
        if self.exponent == 0.0 { correction } else { distance.powf(-self.exponent) * correction }
    }

    fn at_node(&self, weight: f64) -> f64 {
        let logarithm = self.origin - weight.ln();
        if self.exponent == 0.0 {
            logarithm
        } else {
            (self.exponent * logarithm).exp_m1() / self.exponent
        }
    }
}

/// `[ln Gamma(1-q) + ln(sin(pi q/2)/(pi q/2))]/q`, `gamma` at `q = 0`.
fn log_gamma_sine(exponent: f64) -> f64 {
    if exponent.abs() > 0.25 {
        let sine = (FRAC_PI_2 * exponent).sin() / (FRAC_PI_2 * exponent);
        return (libm::lgamma(1.0 - exponent) + sine.ln()) / exponent;
    }
    // Both logarithms as series with the values of the zeta function: sum zeta(k) q^k/k - sum zeta(2k) (q/2)^(2k)/k.
    let mut sum = EULER;
    let mut power = 1.0;
    for (k, zeta) in (2..).zip(ZETA) {
        power *= exponent;
        let halves = if k % 2 == 0 { 2.0 * 0.5f64.powi(k) } else { 0.0 };
        sum += zeta * power * (1.0 - halves) / f64::from(k);
    }
    sum
}

/// `zeta(2), zeta(3), ...`; the last is 1 to 8 digits, times `0.25^26`.
const ZETA: [f64; 25] = [
    1.644_934_066_848_226_4,
    1.202_056_903_159_594_3,
    1.082_323_233_711_138_2,
    1.036_927_755_143_37,
    1.017_343_061_984_449,
    1.008_349_277_381_922_8,
    1.004_077_356_197_944_3,
    1.002_008_392_826_082_2,
    1.000_994_575_127_818_1,
    1.000_494_188_604_119_5,
    1.000_246_086_553_308,
    1.000_122_713_347_578_5,
    1.000_061_248_135_058_7,
    1.000_030_588_236_307,
    1.000_015_282_259_408_7,
    1.000_007_637_197_637_9,
    1.000_003_817_293_265,
    1.000_001_908_212_716_6,
    1.000_000_953_962_033_9,
    1.000_000_476_932_986_8,
    1.000_000_238_450_502_7,
    1.000_000_119_219_926,
    1.000_000_059_608_189,
    1.000_000_029_803_503_5,
    1.000_000_014_901_554_8,
];

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str) -> impl Iterator<Item = [f64; 3]> + '_ {
        text.lines().filter(|line| !line.starts_with('#')).map(|line| {
            let fields: Vec<f64> =
                line.split_whitespace().map(|field| field.parse().unwrap()).collect();
            fields.try_into().unwrap()
        })
    }

    #[test]
    fn weights_of_the_power_agree_with_mpmath() {
        // Origin: see the head of the file.
        let reference = include_str!("../../tests/data/sinc_weights_power.txt");
        for [exponent, j, exact] in table(reference) {
            let weights = PowerWeights::new(exponent, j as usize + 1);
            let found = match j as usize {
                0 => (exponent * weights.origin).exp(),
                j => 1.0 + exponent * weights.corrections[j],
            };
            // Gamma(1 - q) carries the rounding of 1 - q.
            assert!(
                (found - exact).abs() < 1e-15 + 5e-16 / (1.0 - exponent) * exact.abs(),
                "q = {exponent}, j = {j}: {found} {exact}"
            );
        }
        assert_eq!(table(reference).count(), 63);
    }

    #[test]
    fn the_family_is_continuous_through_the_logarithm() {
        // Origin: see the head of the file.
        let reference = include_str!("../../tests/data/sinc_weights_family.txt");
        for [exponent, j, exact] in table(reference) {
            let weights = PowerWeights::new(exponent, j as usize + 1);
            let found = if j == 0.0 { weights.origin } else { weights.corrections[j as usize] };
            let rounding = 1e-15 / (1.0 - exponent) * (1.0 + exact.abs());
            assert!((found - exact).abs() < rounding, "q = {exponent}, j = {j}: {found} {exact}");
        }
        assert_eq!(table(reference).count(), 84);
    }
}
