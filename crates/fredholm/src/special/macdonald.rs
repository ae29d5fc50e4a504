//! The Macdonald function of an order between -1/2 and 1/2.

/// Terms of the series in `z^2`: at `z = 1` the first one left out is 1e-18.
pub(crate) const TERMS: usize = 11;
/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;
/// Beyond it `exp(-z)` is zero.
pub(crate) const LARGEST: f64 = 746.0;
/// Where `exp(-z (cosh t - 1))` counts as zero.
const NEGLIGIBLE: f64 = 42.0;

/// `z^-mu K_mu(z)` for `|mu| < 1/2` and `z > 0`, to a relative error of about 1e-15; infinite at `z = 0` for `mu >= 0`, 0 where it underflows
/// (`z > 745`), NaN outside that range of `mu` and `z`.
///
/// For `z < 1` by the power series in `z^2` and the singular power, of which all terms are positive, without a gap at `mu = 0`; from there on by the
/// trapezoidal rule for `K_mu(z) = int_0^inf exp(-z cosh t) cosh(mu t) dt` (DLMF 10.32.9), which converges exponentially.
///
/// ```
/// let value = fredholm::special::macdonald(0.0, 2.0);
/// assert!((value - 0.113_893_872_749_533_44).abs() < 1e-16);
/// ```
#[must_use]
pub fn macdonald(order: f64, z: f64) -> f64 {
    if !(order.abs() < 0.5 && z >= 0.0) {
        f64::NAN
    } else if z < 1.0 {
        SmallArgument::new(order).value(z)
    } else if z <= LARGEST {
        (-z).exp() * macdonald_scaled(order, z)
    } else {
        0.0
    }
}

/// `e^z z^-mu K_mu(z)` for `z >= 1`.
pub(crate) fn macdonald_scaled(order: f64, z: f64) -> f64 {
    // Below both bounds the error of the rule is less than 1e-17: from the strip |Im t| < pi/2, and from the width of the bell.
    let step = (0.62 / z.sqrt()).min(0.18);
    let mut sum = 0.5;
    for j in 1.. {
        let t = step * f64::from(j);
        let half = (0.5 * t).sinh();
        let decline = 2.0 * z * half * half;
        if decline.is_nan() || decline > NEGLIGIBLE {
            break;
        }
        sum += (-decline).exp() * (order * t).cosh();
    }
    step * sum * z.powf(-order)
}

/// The power series `z^-mu K_mu(z) = A(z^2) sigma(z) + B(z^2)` with `sigma(z) = (z^-2mu - 1)/(2 mu)`, `-ln z` at `mu = 0`; `A` and `B` are entire.
///
/// From `K_mu = (pi/2) (I_-mu - I_mu)/sin(pi mu)` (DLMF 10.27.4, 10.25.2): with `y = z^2/4`
///
/// `A = s sum g_k e^(mu t_k) y^k/k!`, `B = s sum g_k (sinh(mu t_k)/mu) y^k/k!`, `s = pi mu/sin(pi mu)`,
///
/// `g_k = [Gamma(k+1-mu) Gamma(k+1+mu)]^-1/2`, `mu t_k = mu ln 2 + (1/2) ln[Gamma(k+1+mu)/Gamma(k+1-mu)]`, where nothing cancels as `mu -> 0`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SmallArgument {
    order: f64,
    /// Coefficients of `A` in powers of `z^2`.
    pub(crate) factor: [f64; TERMS],
    /// Coefficients of `B` in powers of `z^2`.
    pub(crate) rest: [f64; TERMS],
}

impl SmallArgument {
    pub(crate) fn new(order: f64) -> Self {
        let scale = reflection(order);
        let mut slope = std::f64::consts::LN_2 - odd_log_gamma(order);
        let mut size = scale / scale.sqrt();
        let (mut factor, mut rest) = ([0.0; TERMS], [0.0; TERMS]);
        for k in 0..TERMS {
            if k > 0 {
                let k = k as f64;
                slope += atanh_ratio(order, k);
                size /= 4.0 * k * ((k - order) * (k + order)).sqrt();
            }
            factor[k] = size * (order * slope).exp();
            rest[k] = size * sinh_ratio(order, slope);
        }
        Self { order, factor, rest }
    }

    /// `z^-mu K_mu(z)` for `z <= 1`.
    pub(crate) fn value(&self, z: f64) -> f64 {
        let square = z * z;
        polynomial(&self.factor, square) * sigma(2.0 * self.order, z)
            + polynomial(&self.rest, square)
    }

    /// `B(0) + A(0) sigma(scale)`: with `z = scale d` the rest of the split by `sigma(d)` at `d = 0`, times `scale^mu`.
    pub(crate) fn rest_at_origin(&self, scale: f64) -> f64 {
        let slope = (0.5 * scale).ln() + odd_log_gamma(self.order);
        -reflection(self.order).sqrt() * sinh_ratio(self.order, slope)
    }

    /// `A(z^2)` for every `z >= 0` where it does not overflow.
    pub(crate) fn factor_anywhere(&self, z: f64) -> f64 {
        let y = 0.25 * z * z;
        let (mut term, mut sum) = (1.0, 1.0);
        let mut k = 1.0;
        while term > 1e-18 * sum && k < 1e4 {
            term *= y / (k * (k - self.order));
            sum += term;
            k += 1.0;
        }
        self.factor[0] * sum
    }
}

/// `sum_k coefficients[k] x^k`, the even and the odd powers apart: two chains of operations take half the time of one.
#[inline]
pub(crate) fn polynomial<const N: usize>(coefficients: &[f64; N], x: f64) -> f64 {
    let square = x * x;
    let (mut even, mut odd) = (0.0, 0.0);
    for pair in coefficients.rchunks(2) {
        match pair {
            [low, high] if N.is_multiple_of(2) => {
                even = even * square + low;
                odd = odd * square + high;
            }
            [low, high] => {
                odd = odd * square + low;
                even = even * square + high;
            }
            [single] => even = even * square + single,
            _ => {}
        }
    }
    even + odd * x
}

/// `(z^-q - 1)/q`, `-ln z` at `q = 0`; a power where that is the more accurate one.
#[inline]
pub(crate) fn sigma(exponent: f64, z: f64) -> f64 {
    if exponent.abs() >= 0.25 {
        (z.powf(-exponent) - 1.0) / exponent
    } else if exponent == 0.0 {
        -z.ln()
    } else {
        (-exponent * z.ln()).exp_m1() / exponent
    }
}

/// `pi mu/sin(pi mu)`.
fn reflection(order: f64) -> f64 {
    let angle = std::f64::consts::PI * order;
    if order == 0.0 { 1.0 } else { angle / angle.sin() }
}

/// `sinh(mu t)/mu`, `t` at `mu = 0`.
fn sinh_ratio(order: f64, t: f64) -> f64 {
    let x = order * t;
    if x.abs() < 1e-4 { t * (1.0 + x * x / 6.0) } else { x.sinh() / order }
}

/// `artanh(mu/k)/mu`.
fn atanh_ratio(order: f64, k: f64) -> f64 {
    let x = order / k;
    if x.abs() < 1e-4 { (1.0 + x * x / 3.0) / k } else { x.atanh() / order }
}

/// `[ln Gamma(1-mu) - ln Gamma(1+mu)]/(2 mu)`, Euler's constant at `mu = 0`: `gamma + sum zeta(2k+1) mu^2k/(2k+1)`, of which
/// `artanh(mu)/mu - 1` is summed exactly and `zeta - 1` remains.
fn odd_log_gamma(order: f64) -> f64 {
    let square = order * order;
    let mut sum = 0.0;
    for (k, less_one) in ZETA_LESS_ONE.iter().enumerate().rev() {
        sum = (sum + less_one / (2 * k + 3) as f64) * square;
    }
    EULER + (atanh_ratio(order, 1.0) - 1.0) + sum
}

/// `zeta(3) - 1, zeta(5) - 1, ...`; what follows is `2^-(2k+1) mu^2k < 4e-18`.
const ZETA_LESS_ONE: [f64; 13] = [
    0.202_056_903_159_594_3,
    0.036_927_755_143_369_93,
    0.008_349_277_381_922_827,
    0.002_008_392_826_082_214_4,
    0.000_494_188_604_119_464_5,
    0.000_122_713_347_578_489_15,
    3.058_823_630_702_049e-5,
    7.637_197_637_899_763e-6,
    1.908_212_716_553_939e-6,
    4.769_329_867_878_064e-7,
    1.192_199_259_653_110_7e-7,
    2.980_350_351_465_228e-8,
    7.450_711_789_835_429e-9,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_mpmath() {
        // Origin: see the head of the file.
        let reference = include_str!("../../tests/data/macdonald.txt");
        let mut worst = 0.0f64;
        let mut count = 0;
        for line in reference.lines().filter(|line| !line.starts_with('#')) {
            let fields: Vec<f64> = line.split_whitespace().map(|f| f.parse().unwrap()).collect();
            let [order, z, exact] = fields[..] else { panic!("{line}") };
            let found = macdonald(order, z);
            // The exponential carries the rounding of its argument, the power that of its logarithm.
            let allowed = 1.5e-15 + 2e-16 * (2.0 * order * z.ln()).abs().min(60.0);
            let error = (found / exact - 1.0).abs();
            worst = worst.max(error);
            assert!(error < allowed, "mu = {order}, z = {z}: {found} {exact}, {error:e}");
            count += 1;
        }
        println!("{count} values, worst {worst:e}");
        assert!(count > 300);
    }

    #[test]
    fn the_parts_of_the_series_agree_with_mpmath() {
        // A(z^2) = (pi mu/sin(pi mu)) 2^mu 0F1(1 - mu, z^2/4)/Gamma(1 - mu), mpmath, 25 digits.
        for (order, z, exact) in [
            (0.0, 3.0, 4.880_792_585_865_024),
            (0.0, 12.0, 18_948.925_349_296_308),
            (0.3, 0.0, 1.104_916_033_898_245),
            (0.3, 20.0, 124_362_721.109_929),
            (-0.4, 7.0, 101.022_022_619_987_64),
        ] {
            let found = SmallArgument::new(order).factor_anywhere(z);
            assert!((found / exact - 1.0f64).abs() < 2e-15, "{order} {z}: {found} {exact}");
        }
        // Both sides of a split by another unit of length agree.
        for order in [-0.45, -1e-9, 0.0, 1e-12, 0.2, 0.49] {
            let series = SmallArgument::new(order);
            for scale in [1e-12, 0.3, 1.0, 1.122_918_967_133_770_4, 40.0, 1e9] {
                let exact = series.factor[0] * sigma(2.0 * order, scale) + series.rest[0];
                let size = exact.abs() + series.factor[0];
                let found = series.rest_at_origin(scale) * scale.powf(-order);
                assert!((found - exact).abs() < 1e-14 * size, "{order} {scale}: {found} {exact}");
            }
        }
    }

    #[test]
    fn nothing_outside_its_range() {
        assert!(macdonald(0.5, 1.0).is_nan() && macdonald(0.0, -1.0).is_nan());
        assert!(macdonald(f64::NAN, 1.0).is_nan() && macdonald(0.1, f64::NAN).is_nan());
        assert_eq!(macdonald(0.3, 0.0), f64::INFINITY);
        assert_eq!(macdonald(0.3, f64::INFINITY), 0.0);
        assert_eq!(macdonald(0.3, 800.0), 0.0);
        // The limit 2^(-mu-1) Gamma(-mu) of the bounded kernel at mu = -1/4.
        let limit = 2f64.powf(-0.75) * 3.625_609_908_221_908;
        assert!((macdonald(-0.25, 0.0) / limit - 1.0).abs() < 1e-15);
    }
}
