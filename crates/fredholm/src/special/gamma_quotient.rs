//! Quotients of gamma functions at neighbouring arguments, without the digits that differences of `ln Gamma` lose at large ones.

/// From here on the asymptotic series of the digamma function reaches rounding.
const ASYMPTOTIC_FROM: f64 = 12.0;
/// `B_2k / 2k` of `psi(y) = ln y - 1/(2y) - sum B_2k / (2k y^2k)` (DLMF 5.11.2).
const DIGAMMA: [f64; 8] = [
    1.0 / 12.0,
    -1.0 / 120.0,
    1.0 / 252.0,
    -1.0 / 240.0,
    1.0 / 132.0,
    -691.0 / 32760.0,
    1.0 / 12.0,
    -3617.0 / 8160.0,
];
/// Half of the Gauss-Legendre rule with six nodes: node, weight for the mean.
const LEGENDRE: [[f64; 2]; 3] = [
    [0.238_619_186_083_196_9, 0.233_956_967_286_345_52],
    [0.661_209_386_466_264_5, 0.180_380_786_524_069_3],
    [0.932_469_514_203_152, 0.085_662_246_189_585_17],
];

/// `Gamma(y + exponent + 1/2) / Gamma(y + 1)` for `|exponent| < 1/2` and `y >= 0`; relative error about 1e-15, at any size.
pub(crate) fn half_gamma_quotient(y: f64, exponent: f64) -> f64 {
    // From the exponent, which the sum at the top would round.
    let delta = exponent - 0.5;
    let (mut top, mut bottom, mut product) = (y + (exponent + 0.5), y + 1.0, 1.0);
    while bottom < ASYMPTOTIC_FROM {
        product *= bottom / top;
        top += 1.0;
        bottom += 1.0;
    }
    product * bottom.powf(delta) * (delta * mean_beyond_logarithm(bottom, delta)).exp()
}

/// `[ln Gamma(low + span) - ln Gamma(low)] / span`, the mean of the digamma function over an interval, and its value for
/// `span = 0`; `low > 0` and `0 <= span <= 1`. Absolute error about 1e-15 times the sum of its terms.
pub(crate) fn mean_digamma(low: f64, span: f64) -> f64 {
    let mut y = low;
    let mut sum = 0.0;
    while y < ASYMPTOTIC_FROM {
        sum += if span == 0.0 { 1.0 / y } else { (span / y).ln_1p() / span };
        y += 1.0;
    }
    y.ln() + mean_beyond_logarithm(y, span) - sum
}

/// The mean of `psi(u) - ln y` for `u` between `y` and `y + span`.
fn mean_beyond_logarithm(y: f64, span: f64) -> f64 {
    let beyond = |place: f64| {
        let step = 0.5 * span * (1.0 + place);
        let inverse = 1.0 / (y + step);
        let square = inverse * inverse;
        let series = DIGAMMA.iter().rev().fold(0.0, |sum, c| (sum + c) * square);
        (step / y).ln_1p() - 0.5 * inverse - series
    };
    LEGENDRE.iter().map(|[node, weight]| weight * (beyond(*node) + beyond(-node))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// mpmath, 30 digits; arguments are the doubles nearest to the decimals.
    const QUOTIENTS: [[f64; 3]; 8] = include!("../../tests/data/gamma_quotients.txt");
    const MEANS: [[f64; 3]; 8] = include!("../../tests/data/digamma_means.txt");

    #[test]
    fn quotients_agree_with_mpmath() {
        for [y, exponent, exact] in QUOTIENTS {
            let found = half_gamma_quotient(y, exponent);
            assert!((found / exact - 1.0).abs() < 4e-15, "{y} {exponent}: {found} {exact}");
        }
    }

    #[test]
    fn means_agree_with_mpmath() {
        for [low, span, exact] in MEANS {
            let found = mean_digamma(low, span);
            let scale = 3.0 + 1.0 / low;
            assert!((found - exact).abs() < 1e-15 * scale, "{low} {span}: {found} {exact}");
        }
    }
}
