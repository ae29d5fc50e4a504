//! The cosine integral at the multiples of pi, which the exact sinc weights of the logarithm need.

use std::f64::consts::PI;

/// From here on the asymptotic series reaches rounding before its terms grow again.
const ASYMPTOTIC_FROM: usize = 12;

/// `Ci(pi j) = -int_{pi j}^inf cos(t)/t dt`, `j >= 1`.
///
/// With `sin(pi j) = 0` only the auxiliary function `g(x) = int_0^inf t e^{-xt}/(1 + t^2) dt` remains,
/// `Ci(pi j) = -(-1)^j g(pi j)` (DLMF 6.5.5): its asymptotic series (DLMF 6.12.4) for `j >= 12`, before that the
/// continued fraction of `E_1(i pi j)` (DLMF 6.9.1). Absolute error below 2e-16.
///
/// `j = 0` gives negative infinity, the limit.
///
/// ```
/// let exact = 0.073667912046425486;   // Ci(pi)
/// assert!((fredholm::special::cosine_integral_pi(1) - exact).abs() < 2e-16);
/// ```
#[must_use]
pub fn cosine_integral_pi(j: usize) -> f64 {
    match j {
        0 => f64::NEG_INFINITY,
        1..ASYMPTOTIC_FROM => continued_fraction(PI * j as f64, j),
        _ => {
            let g = auxiliary_asymptotic(PI * j as f64);
            if j.is_multiple_of(2) { -g } else { g }
        }
    }
}

/// `g(x) ~ x^-2 (1 - 3!/x^2 + 5!/x^4 - ...)`.
fn auxiliary_asymptotic(x: f64) -> f64 {
    let inverse_square = 1.0 / (x * x);
    let mut term = inverse_square;
    let mut sum = 0.0;
    let mut k = 1.0;
    while term.abs() > 1e-18 * inverse_square && k < 40.0 {
        sum += term;
        term *= -(k + 1.0) * (k + 2.0) * inverse_square;
        k += 2.0;
    }
    sum
}

/// `-Re E_1(i x)` at `x = pi j` by Lentz's evaluation of
/// `E_1(z) = e^-z / (z + 1 - 1/(z + 3 - 4/(z + 5 - ...)))`; `e^{-i pi j} = (-1)^j`.
fn continued_fraction(x: f64, j: usize) -> f64 {
    let mut b = Complex { re: 1.0, im: x };
    let mut c = Complex { re: 1e300, im: 0.0 };
    let mut d = b.inverse();
    let mut fraction = d;
    for i in 1..500 {
        let a = -f64::from(i * i);
        b.re += 2.0;
        d = Complex { re: a * d.re + b.re, im: a * d.im + b.im }.inverse();
        let back = c.inverse();
        c = Complex { re: b.re + a * back.re, im: b.im + a * back.im };
        let factor = c.times(d);
        fraction = fraction.times(factor);
        if (factor.re - 1.0).abs() + factor.im.abs() < 1e-16 {
            break;
        }
    }
    if j.is_multiple_of(2) { -fraction.re } else { fraction.re }
}

#[derive(Clone, Copy)]
struct Complex {
    re: f64,
    im: f64,
}

impl Complex {
    fn inverse(self) -> Self {
        let square = self.re * self.re + self.im * self.im;
        // The start value 1e300 would overflow when squared.
        if square.is_infinite() {
            Self { re: 1.0 / self.re, im: 0.0 }
        } else {
            Self { re: self.re / square, im: -self.im / square }
        }
    }

    fn times(self, other: Self) -> Self {
        Self {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_mpmath() {
        // mpmath 1.3, ci(pi*j), 25 digits
        let reference = [
            (1, 0.073_667_912_046_425_49),
            (2, -0.022_560_661_746_346_067),
            (3, 0.010_620_202_965_250_288),
            (5, 0.003_961_206_174_030_446),
            (8, -0.001_568_553_021_292_536_4),
            (11, 0.000_833_226_188_182_299_7),
            (12, -0.000_700_689_474_507_742),
            (13, 0.000_597_402_222_430_300_3),
            (40, -0.000_063_301_709_273_349_6),
            (200, -2.532_991_095_575_084_7e-6),
        ];
        for (j, exact) in reference {
            assert!(
                (cosine_integral_pi(j) - exact).abs() < 2e-16,
                "j = {j}: {}",
                cosine_integral_pi(j)
            );
        }
    }
}
