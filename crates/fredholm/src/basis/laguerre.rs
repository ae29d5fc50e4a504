//! Laguerre functions `e^{-y/2} L_n^{(alpha)}(y)` on the half-line, and what belongs to them.

use std::f64::consts::LOG2_E;

/// `ln 2` in two parts; the first has 21 trailing zero bits, so that its product with a whole number below `2^21` is exact.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];
/// Beyond this `e^{-y/2}` outweighs every polynomial of a degree below a million.
const LARGEST_EXPONENT: f64 = 1e6;
/// The recurrence is scaled back by this power of two when it exceeds it.
const SCALE_POWER: i32 = 64;
/// From here on `Gamma(n + a)/n!` by Stirling's series.
const STIRLING: usize = 40;

/// The functions `e^{-y/2} L_k^{(alpha)}(y)`, `k = 0, 1, ...`, one after the other, for `alpha > -1`, `y >= 0`.
///
/// They are all of the order of 1, but for large `y` the exponential underflows and the polynomial overflows: both are
/// kept with their powers of two apart. The recurrence runs over differences,
///
/// `(k+1) (L_{k+1} - L_k) = (k + alpha) (L_k - L_{k-1}) - y L_k`,
///
/// which keeps all digits near `y = 0`. (NIST Digital Library of Mathematical Functions, 18.9.1 with 18.9.2.)
#[derive(Debug, Clone)]
pub(crate) struct Functions {
    alpha: f64,
    y: f64,
    k: f64,
    /// `L_k` and `L_k - L_{k-1}`, times `2^-power`.
    value: f64,
    difference: f64,
    power: i32,
    /// `e^{-y/2} 2^exponent`, between 0.7 and 1.5.
    exponential: f64,
    exponent: i32,
    /// `exponential * 2^(power - exponent)`.
    factor: f64,
}

impl Functions {
    /// At `y`; points left of 0 count as 0, and beyond two million all functions do.
    pub(crate) fn at(alpha: f64, y: f64) -> Self {
        let (exponential, exponent) = decaying_exponential(0.5 * y.max(0.0));
        let y = if exponential == 0.0 { 0.0 } else { y.max(0.0) };
        let mut functions = Self {
            alpha,
            y,
            k: 0.0,
            value: 1.0,
            difference: 0.0,
            power: 0,
            exponential,
            exponent,
            factor: 0.0,
        };
        functions.set_factor();
        functions
    }

    fn set_factor(&mut self) {
        self.factor = libm::scalbn(self.exponential, self.power - self.exponent);
    }
}

impl Iterator for Functions {
    type Item = f64;

    #[inline]
    fn next(&mut self) -> Option<f64> {
        let result = self.value * self.factor;
        // Apart from the chain of the recurrence, which then does not wait for the division.
        let next = self.k + 1.0;
        let inverse = 1.0 / next;
        self.difference = ((self.k + self.alpha) * self.difference - self.y * self.value) * inverse;
        if self.k == 0.0 {
            // L_1 - L_0 = alpha - y: the recurrence has no L_{-1} to start from.
            self.difference = self.alpha - self.y;
        }
        self.value += self.difference;
        self.k = next;
        let large = f64::from_bits(((1023 + SCALE_POWER) as u64) << 52);
        if self.value.abs() > large {
            self.value /= large;
            self.difference /= large;
            self.power += SCALE_POWER;
            self.set_factor();
        }
        Some(result)
    }
}

/// `e^-p = m 2^-k` with `m` between 0.7 and 1.5, for any `p >= 0`; 0 beyond the largest exponent.
fn decaying_exponential(p: f64) -> (f64, i32) {
    if p > LARGEST_EXPONENT {
        return (0.0, 0);
    }
    let turns = (p * LOG2_E).round();
    let rest = (p - turns * LN_2[0]) - turns * LN_2[1];
    ((-rest).exp(), turns as i32)
}

/// `sum_m coefficients[m] e^{-y/2} L_m^{(alpha)}(y)`.
pub(crate) fn sum(alpha: f64, coefficients: &[f64], y: f64) -> f64 {
    coefficients.iter().zip(Functions::at(alpha, y)).map(|(c, phi)| c * phi).sum()
}

/// `(a)_n / n!` for `n = 0 .. count-1`, `|a| < 1`.
pub(crate) fn binomials(a: f64, count: usize) -> Vec<f64> {
    let mut value = 1.0;
    (0..count)
        .map(|n| {
            let current = value;
            value *= (a + n as f64) / (n as f64 + 1.0);
            current
        })
        .collect()
}

/// `Gamma(n + a) / n!`, `0 < a < 1`, without overflow: by products, or for large `n` by the difference of two series of Stirling.
pub(crate) fn gamma_ratio(n: usize, a: f64) -> f64 {
    if n < STIRLING {
        let start = libm::tgamma(a);
        return (0..n).fold(start, |value, k| value * ((k as f64 + a) / (k as f64 + 1.0)));
    }
    // ln Gamma(z) = (z - 1/2) ln z - z + series(z) with z = n + a and z = n + 1
    let (low, high) = (n as f64 + a, n as f64 + 1.0);
    let logarithm = (a - 1.0) * high.ln() + (low - 0.5) * ((a - 1.0) / high).ln_1p() - (a - 1.0)
        + (stirling(low) - stirling(high));
    logarithm.exp()
}

/// `ln Gamma(z) - (z - 1/2) ln z + z - ln(2 pi)/2`, large `z`.
fn stirling(z: f64) -> f64 {
    let w = 1.0 / (z * z);
    (1.0 / 12.0 - w * (1.0 / 360.0 - w * (1.0 / 1260.0 - w / 1680.0))) / z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_of_the_order_minus_one_half_are_hermite_functions() {
        // H_2n(u) = (-1)^n 4^n n! L_n^(-1/2)(u^2), and the Hermite functions have a recurrence of their own, here with
        // e^{-u^2/2} underflowing at the start.
        for u in [0.0f64, 0.3, 2.0, 11.0, 41.0, 60.0] {
            let count = 2200;
            let mut exponent = 0.0;
            let (mut previous, mut current) = (0.0f64, 1.0f64);
            // h_k = H_k / sqrt(2^k k!), scaled
            let mut ratio = 1.0f64;
            for (n, found) in Functions::at(-0.5, u * u).take(count).enumerate() {
                let k = 2 * n;
                // L_n = (-1)^n h_2n sqrt(2^2n (2n)!)/(4^n n!) = (-1)^n h_2n sqrt((2n)!/(4^n n!^2))
                let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
                let exact = sign * current * ratio.sqrt() * (exponent - 0.5 * u * u).exp();
                assert!((found - exact).abs() < 4e-12, "u = {u}, n = {n}: {found} {exact}");
                for j in [k + 1, k + 2] {
                    let j = j as f64;
                    let next = (2.0 / j).sqrt() * u * current - ((j - 1.0) / j).sqrt() * previous;
                    (previous, current) = (current, next);
                }
                if current.abs() > 1e100 {
                    (previous, current) = (previous * 1e-100, current * 1e-100);
                    exponent += 100.0 * std::f64::consts::LN_10;
                }
                let m = (n + 1) as f64;
                ratio *= (2.0 * m - 1.0) / (2.0 * m);
            }
        }
    }

    #[test]
    fn extremes_are_no_trouble() {
        for y in [0.0, -1.0, 5e-324, 1e-300, 1490.0, 3000.0, 1e5, 1e12, 1e308, f64::INFINITY] {
            for alpha in [-0.999_999, -0.5, 0.0] {
                for (n, value) in Functions::at(alpha, y).take(3000).enumerate() {
                    assert!(
                        value.abs() < 1.0 + 1e-10,
                        "alpha = {alpha}, y = {y}, n = {n}: {value}"
                    );
                }
            }
        }
    }

    #[test]
    fn gamma_ratios_follow_their_recurrence() {
        for a in [1e-6f64, 0.05, 0.5, 0.8, 0.999] {
            let mut exact = libm::tgamma(a);
            for n in 0..3000usize {
                let found = gamma_ratio(n, a);
                assert!((found - exact).abs() < 2e-13 * exact, "a = {a}, n = {n}: {found} {exact}");
                exact *= (n as f64 + a) / (n as f64 + 1.0);
            }
        }
        // mpmath
        assert!((gamma_ratio(1000, 0.3) - 0.007_942_448_290_814_225).abs() < 1e-17);
        assert!((gamma_ratio(1 << 60, 0.5) * (1u64 << 30) as f64 - 1.0).abs() < 1e-14);
    }
}
