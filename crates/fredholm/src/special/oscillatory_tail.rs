//! Tails of `int v^{a-1} cos v dv` at the multiples of pi, which the exact sinc weights of singular functions need.

use std::f64::consts::PI;

/// From here on the asymptotic series reaches rounding before its terms grow again.
const ASYMPTOTIC_FROM: usize = 12;

/// `(-1)^j int_{pi j}^inf v^{a-1} cos(v) dv / (pi j)^a`, `-1 < a < 1`, `j >= 1`.
///
/// It is the real part of `e^z z^{-a} Gamma(a, z)` at `z = i pi j`: its asymptotic series (DLMF 8.11.2) for `j >= 12`,
/// before that its continued fraction (DLMF 8.9.2). Absolute error below 2e-16. `j = 0` gives infinity.
pub(crate) fn oscillatory_tail(a: f64, j: usize) -> f64 {
    match j {
        0 => f64::INFINITY,
        1..ASYMPTOTIC_FROM => continued_fraction(a, PI * j as f64),
        _ => asymptotic(a, PI * j as f64),
    }
}

/// `(1-a)/x^2 - (1-a)(2-a)(3-a)/x^4 + ...`.
fn asymptotic(a: f64, x: f64) -> f64 {
    let inverse_square = 1.0 / (x * x);
    let first = (1.0 - a) * inverse_square;
    let mut term = first;
    let mut sum = 0.0;
    let mut k = 1.0;
    while term.abs() > 1e-18 * first && k < 40.0 {
        sum += term;
        term *= -(k + 1.0 - a) * (k + 2.0 - a) * inverse_square;
        k += 2.0;
    }
    sum
}

/// Real part of `1/(z + 1 - a - (1 - a)/(z + 3 - a - 2 (2 - a)/(z + 5 - a - ...)))` at `z = i x`, by Lentz's method.
fn continued_fraction(a: f64, x: f64) -> f64 {
    let mut b = Complex { re: 1.0 - a, im: x };
    let mut c = Complex { re: 1e300, im: 0.0 };
    let mut d = b.inverse();
    let mut fraction = d;
    for i in 1..500 {
        let i = f64::from(i);
        let numerator = -i * (i - a);
        b.re += 2.0;
        d = Complex { re: numerator * d.re + b.re, im: numerator * d.im + b.im }.inverse();
        let back = c.inverse();
        c = Complex { re: b.re + numerator * back.re, im: b.im + numerator * back.im };
        let factor = c.times(d);
        fraction = fraction.times(factor);
        if (factor.re - 1.0).abs() + factor.im.abs() < 1e-16 {
            break;
        }
    }
    fraction.re
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
