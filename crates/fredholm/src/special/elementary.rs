//! Logarithms, sines, exponentials and powers of many numbers at once, by additions, multiplications and divisions alone, which vector units do side by side.
//!
//! The library of the system takes one number at a time, and its last digit goes by the system. These have the same bits for every width of the vectors and everywhere.

use std::f64::consts::{FRAC_PI_2, LN_2, LOG2_E, PI, SQRT_2};

use crate::linear::vectorised;

/// `ln 2` to 32 bits, so that products with exponents are exact, and the rest.
const LN_2_HIGH: f64 = 0.693_147_180_369_123_8;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
/// `pi` less its nearest double.
const PI_REST: f64 = 1.224_646_799_147_353_2e-16;
/// Bits of a mantissa, and how many there are.
const MANTISSA: u64 = (1 << MANTISSA_BITS) - 1;
const MANTISSA_BITS: u32 = 52;
/// Numbers next to it are whole: adding and taking it away rounds, and the last bits of the sum are the number.
const WHOLE: f64 = 1.5 * (1u64 << MANTISSA_BITS) as f64;
/// `2^52`: with a whole number in the last of its bits it is `2^52` and that number.
const SHIFTED: f64 = (1u64 << MANTISSA_BITS) as f64;
/// Bias of exponents.
const BIAS: u64 = 1023;
/// Up to here 1 can be added without overflow.
const LARGE: f64 = 1e300;
/// Bits of an exponent of a power that are multiplied exactly with a power of 2 in any double.
const HIGH_BITS: u64 = !((1 << 13) - 1);

/// Numbers looked at and replaced at once.
const AT_ONCE: usize = 64;

/// Replaces each number by its logarithm, to 1 unit in the last place; NaN for negative numbers.
pub(crate) fn logarithms(numbers: &mut [f64]) {
    vectorised(
        #[inline(always)]
        || replace(numbers, logarithm, f64::ln),
    );
}

/// Replaces each number `x >= 0` by `ln(1 + x)`, to 2 units in the last place.
pub(crate) fn logarithms_of_one_and(numbers: &mut [f64]) {
    let is_large = numbers.iter().any(|x| !(0.0..=LARGE).contains(x));
    if is_large {
        return numbers.iter_mut().for_each(|x| *x = x.ln_1p());
    }
    vectorised(
        #[inline(always)]
        || {
            for x in numbers.iter_mut() {
                let sum = 1.0 + *x;
                // What the sum has lost, exactly.
                let lost = if *x < 1.0 { *x - (sum - 1.0) } else { 1.0 - (sum - *x) };
                *x = logarithm(sum) + lost / sum;
            }
        },
    );
}

/// Replaces each angle, from 0 to `pi`, by its sine, to 2 units in the last place.
pub(crate) fn sines(angles: &mut [f64]) {
    vectorised(
        #[inline(always)]
        || angles.iter_mut().for_each(|angle| *angle = sine(*angle)),
    );
}

/// Replaces each number `d`, up to a thousand turns, by `|sin(pi d/2)|`, to 3 units in the last place.
pub(crate) fn sines_of_half_turns(numbers: &mut [f64]) {
    let shorter = |d: f64| (d - 2.0 * ((0.5 * d + WHOLE) - WHOLE)).abs();
    vectorised(
        #[inline(always)]
        || numbers.iter_mut().for_each(|d| *d = sine(FRAC_PI_2 * shorter(*d))),
    );
}

/// Replaces each number by its power, `x^exponent`, to 2 units in the last place. `|exponent| <= 1`.
pub(crate) fn powers(numbers: &mut [f64], exponent: f64) {
    vectorised(
        #[inline(always)]
        || powers_within(numbers, exponent),
    );
}

/// The same as part of a function that is vectorised itself.
#[inline(always)]
pub(crate) fn powers_within(numbers: &mut [f64], exponent: f64) {
    let power = Power::new(exponent);
    replace(
        numbers,
        #[inline(always)]
        |x| power.of(x),
        |x| x.powf(exponent),
    );
}

/// Replaces each number by its value: of normal ones, some at once, and of others.
#[inline(always)]
fn replace(numbers: &mut [f64], normal: impl Fn(f64) -> f64, other: impl Fn(f64) -> f64) {
    for numbers in numbers.chunks_mut(AT_ONCE) {
        if are_normal(numbers) {
            for x in numbers.iter_mut() {
                *x = normal(*x);
            }
        } else {
            for x in numbers.iter_mut() {
                *x = if are_normal(&[*x]) { normal(*x) } else { other(*x) };
            }
        }
    }
}

/// Whether all are positive, finite and not so small that they lose digits.
#[inline(always)]
fn are_normal(numbers: &[f64]) -> bool {
    let outside = |x: f64| u64::from(!(f64::MIN_POSITIVE..=f64::MAX).contains(&x));
    numbers.iter().fold(0, |any, x| any | outside(*x)) == 0
}

/// `x = 2^k (1 + f)`, `1 + f` between the roots of 1/2 and of 2: `k` and `f`.
#[inline(always)]
fn parts(x: f64) -> (f64, f64) {
    let root = (0.5 * SQRT_2).to_bits();
    let shifted = x.to_bits().wrapping_add((BIAS << MANTISSA_BITS) - root);
    let k =
        f64::from_bits((shifted >> MANTISSA_BITS) | SHIFTED.to_bits()) - (SHIFTED + BIAS as f64);
    let mantissa = f64::from_bits((shifted & MANTISSA) + root);
    (k, mantissa - 1.0)
}

/// `ln(1 + f) - f` for `1 + f` between the roots of 1/2 and of 2: with `s = f/(2 + f)` the logarithm is `2 artanh s = f - f^2/2 + s (f^2/2 + R)`, `R = 2 s^2 sum_k s^(2k)/(2k + 3)`.
#[inline(always)]
fn beyond_linear(f: f64) -> f64 {
    let s = f / (2.0 + f);
    let (z, half_square) = (s * s, 0.5 * f * f);
    let w = z * z;
    // Two chains; the first term left out is 2e-19 of f at the ends.
    let even = ((((term(19) * w + term(15)) * w + term(11)) * w + term(7)) * w + term(3)) * z;
    let odd = ((((term(21) * w + term(17)) * w + term(13)) * w + term(9)) * w + term(5)) * w;
    s * (half_square + (even + odd)) - half_square
}

/// `2/n`.
const fn term(n: u32) -> f64 {
    2.0 / n as f64
}

/// `ln x` for a positive normal number.
#[inline(always)]
fn logarithm(x: f64) -> f64 {
    let (k, f) = parts(x);
    k * LN_2_HIGH + (f + (beyond_linear(f) + k * LN_2_LOW))
}

/// `sin x` by its series from the nearer of 0 and `pi`, of which the first term left out is 1e-18.
#[inline(always)]
fn sine(x: f64) -> f64 {
    let y = if x > FRAC_PI_2 { (PI - x) + PI_REST } else { x };
    let z = y * y;
    let w = z * z;
    // Two chains.
    let odd = (((inverse_factorial(19) * w + inverse_factorial(15)) * w + inverse_factorial(11))
        * w
        + inverse_factorial(7))
        * w
        + inverse_factorial(3);
    let even = (((inverse_factorial(21) * w + inverse_factorial(17)) * w + inverse_factorial(13))
        * w
        + inverse_factorial(9))
        * w
        + inverse_factorial(5);
    y + y * z * (even * z - odd)
}

/// `2^n e^y` for a whole `n` and `|y| < 0.36`, where it is normal.
#[inline(always)]
fn scaled_exponential(n: f64, y: f64) -> f64 {
    let w = y * y;
    let even = ((((inverse_factorial(12) * w + inverse_factorial(10)) * w + inverse_factorial(8))
        * w
        + inverse_factorial(6))
        * w
        + inverse_factorial(4))
        * w
        + inverse_factorial(2);
    let odd = ((((inverse_factorial(13) * w + inverse_factorial(11)) * w + inverse_factorial(9))
        * w
        + inverse_factorial(7))
        * w
        + inverse_factorial(5))
        * w
        + inverse_factorial(3);
    let exponential = 1.0 + (y + w * (even + y * odd));
    let exponent = (n + WHOLE).to_bits() << MANTISSA_BITS;
    f64::from_bits(exponential.to_bits().wrapping_add(exponent))
}

/// `1/n!`; up to 13 the factorial is exact.
const fn inverse_factorial(n: u32) -> f64 {
    let (mut product, mut k) = (1.0, 2);
    while k <= n {
        product *= k as f64;
        k += 1;
    }
    1.0 / product
}

/// The nearest whole number.
#[inline(always)]
fn whole(x: f64) -> f64 {
    (x + WHOLE) - WHOLE
}

/// Powers with one exponent.
struct Power {
    /// The exponent to 40 bits, so that products with the exponents of numbers are exact, and the rest.
    high: f64,
    low: f64,
    /// The exponent over `ln 2`.
    binary: f64,
}

impl Power {
    fn new(exponent: f64) -> Self {
        let high = f64::from_bits(exponent.to_bits() & HIGH_BITS);
        Self { high, low: exponent - high, binary: exponent * LOG2_E }
    }

    /// `x^p = 2^(p k) (1 + f)^p`: of `p k` the whole part is exact and the rest has all its digits.
    #[inline(always)]
    fn of(&self, x: f64) -> f64 {
        let (k, f) = parts(x);
        let product = self.high * k;
        let n = whole(product);
        let rest = (product - n) + (self.low * k + self.binary * (f + beyond_linear(f)));
        let m = whole(rest);
        scaled_exponential(n + m, (rest - m) * LN_2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of all sizes, and those next to where the ways part.
    fn numbers() -> Vec<f64> {
        let mut numbers = vec![1.0, 0.5 * SQRT_2, SQRT_2, f64::MIN_POSITIVE, f64::MAX, 2.0, 0.1];
        for (index, turn) in
            (1..40_000).map(|i| (i, (f64::from(i) * 0.618_033_988_749_894_9).fract()))
        {
            let wide = (1380.0 * turn - 690.0).exp();
            let near = 1.0 + (turn - 0.5) * 0.5f64.powi(index % 50);
            numbers.extend([wide, near, 0.5 + turn]);
        }
        for x in numbers.clone() {
            numbers.extend([x.next_up(), x.next_down()]);
        }
        numbers.retain(|x| x.is_normal());
        numbers
    }

    /// Units in the last place of the exact value between two numbers.
    fn units(found: f64, exact: f64) -> f64 {
        (found - exact).abs() / (exact.abs().next_up() - exact.abs())
    }

    #[test]
    fn logarithms_are_those_of_the_system() {
        let numbers = numbers();
        let mut found = numbers.clone();
        logarithms(&mut found);
        for (x, found) in numbers.iter().zip(found) {
            assert!(units(found, x.ln()) <= 1.0, "{x:e}: {found} {}", x.ln());
        }
    }

    #[test]
    fn logarithms_of_one_and_a_number_are_those_of_the_system() {
        let mut numbers = numbers();
        numbers.retain(|x| *x < LARGE);
        numbers.extend([0.0, 5e-324]);
        let mut found = numbers.clone();
        logarithms_of_one_and(&mut found);
        for (x, found) in numbers.iter().zip(found) {
            assert!(units(found, x.ln_1p()) <= 2.0, "{x:e}: {found} {}", x.ln_1p());
        }
    }

    #[test]
    fn sines_are_those_of_the_system() {
        let mut angles: Vec<f64> = numbers().into_iter().filter(|x| *x <= PI).collect();
        angles.extend((0..40_000).map(|i| PI / 40_000.0 * f64::from(i)));
        angles.extend((1..50).map(|k| PI - PI * 0.5f64.powi(k)));
        angles.extend([0.0, FRAC_PI_2.next_up(), FRAC_PI_2, PI, PI.next_down()]);
        let mut found = angles.clone();
        sines(&mut found);
        for (x, found) in angles.iter().zip(found) {
            assert!(units(found, x.sin()) <= 2.0, "{x:e}: {found} {}", x.sin());
        }
        // Whole turns are exact, and so are these parts of one.
        for turns in [-2.0, 0.0, 1.0, 7.0] {
            let parts = (-64..=64).map(|k| f64::from(k) / 64.0);
            let mut found: Vec<f64> = parts.clone().map(|part| 2.0 * turns + part).collect();
            sines_of_half_turns(&mut found);
            for (part, found) in parts.zip(found) {
                let exact = (FRAC_PI_2 * part).sin().abs();
                assert!(units(found, exact) <= 3.0, "{turns} {part}: {found} {exact}");
            }
        }
    }

    #[test]
    fn powers_are_those_of_the_system() {
        let numbers = numbers();
        for exponent in [-0.9, -0.3, 1e-3, -1e-12, 0.5, -0.999, 1.0, -1.0, 0.0] {
            let mut found = numbers.clone();
            powers(&mut found, exponent);
            for (x, found) in numbers.iter().zip(found) {
                let exact = x.powf(exponent);
                if exact.is_normal() {
                    assert!(units(found, exact) <= 2.0, "{x:e}^{exponent}: {found} {exact}");
                }
            }
        }
    }

    #[test]
    fn what_is_not_normal_has_its_value_too() {
        let numbers = [0.0, f64::INFINITY, 5e-324, -1.0, f64::NAN, 2.0];
        let mut found = numbers;
        logarithms(&mut found);
        assert_eq!(found[..3], [f64::NEG_INFINITY, f64::INFINITY, 5e-324f64.ln()]);
        assert!(found[3].is_nan() && found[4].is_nan() && found[5] == LN_2);
        let mut found = numbers;
        powers(&mut found, -0.5);
        assert_eq!(found[..2], [f64::INFINITY, 0.0]);
        assert!(found[2].is_finite() && found[3].is_nan());
    }
}
