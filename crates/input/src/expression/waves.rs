//! Sines and cosines by additions and multiplications alone, which vector units do side by side: a rough base is often a sum of many waves.
//!
//! The library of the system takes one number at a time, and its last digit goes by the system. These have the same bits for every width of the vectors and everywhere.

use std::f64::consts::FRAC_2_PI;

/// `pi/2` to 42 bits, 42 more, and the rest: products with whole numbers of ten bits are exact.
const QUARTER: [f64; 3] =
    [1.570_796_326_794_607, 2.896_073_971_621_817_5e-13, 1.644_625_693_632_425_8e-26];
/// Quarters of turns below `2^10`; beyond, the library of the system counts them.
const LARGEST: f64 = 1600.0;
/// Numbers next to it are whole: adding and taking it away rounds, and the last bits of the sum are the number.
const WHOLE: f64 = 1.5 * (1u64 << 52) as f64;

/// `sin x`, to 1 unit in the last place.
#[inline(always)]
pub(super) fn sine(x: f64) -> f64 {
    if is_small(x) { wave(x, 0) } else { x.sin() }
}

/// `cos x`, to 1 unit in the last place.
#[inline(always)]
pub(super) fn cosine(x: f64) -> f64 {
    if is_small(x) { wave(x, 1) } else { x.cos() }
}

/// The sine of each.
#[inline(always)]
pub(super) fn sines<const COUNT: usize>(x: [f64; COUNT]) -> [f64; COUNT] {
    if are_small(&x) { turns(x, 0) } else { x.map(sine) }
}

/// The cosine of each.
#[inline(always)]
pub(super) fn cosines<const COUNT: usize>(x: [f64; COUNT]) -> [f64; COUNT] {
    if are_small(&x) { turns(x, 1) } else { x.map(cosine) }
}

/// Sine and cosine of each, those of [`sines`] and [`cosines`] to the last bit.
#[inline(always)]
pub(super) fn both<const COUNT: usize>(x: [f64; COUNT]) -> [[f64; COUNT]; 2] {
    let mut found = [[0.0; COUNT]; 2];
    let are_small = are_small(&x);
    for k in 0..COUNT {
        let pair = if are_small { waves(x[k]) } else { [sine(x[k]), cosine(x[k])] };
        (found[0][k], found[1][k]) = (pair[0], pair[1]);
    }
    found
}

#[inline(always)]
fn is_small(x: f64) -> bool {
    x.abs() <= LARGEST
}

#[inline(always)]
fn are_small(x: &[f64]) -> bool {
    x.iter().fold(true, |all, x| all & is_small(*x))
}

/// `sin(x + n pi/2)` of each, all of them small; by a loop, which is compiled for the vectors of its surroundings: a closure of `array::map` may not be.
#[inline(always)]
fn turns<const COUNT: usize>(x: [f64; COUNT], n: u64) -> [f64; COUNT] {
    let mut found = [0.0; COUNT];
    for k in 0..COUNT {
        found[k] = wave(x[k], n);
    }
    found
}

/// `sin(x + n pi/2)` where `x` is small.
#[inline(always)]
fn wave(x: f64, n: u64) -> f64 {
    let (quarters, rest) = reduced(x);
    turned(rest, quarters.wrapping_add(n))
}

/// `sin x` and `cos x` where `x` is small.
#[inline(always)]
fn waves(x: f64) -> [f64; 2] {
    let (quarters, rest) = reduced(x);
    [turned(rest, quarters), turned(rest, quarters.wrapping_add(1))]
}

/// The number of quarters of turns in the last bits, with sine and cosine of the rest.
#[inline(always)]
fn reduced(x: f64) -> (u64, [f64; 2]) {
    let shifted = x * FRAC_2_PI + WHOLE;
    let quarters = shifted - WHOLE;
    // The rest to twice the digits of one number: `a` and `b` are exact, and so is what their difference has lost.
    let (a, b) = (x - quarters * QUARTER[0], quarters * QUARTER[1]);
    let difference = a - b;
    let back = a - difference;
    let lost = (a - (difference + back)) + (back - b);
    let beyond = lost - quarters * QUARTER[2];
    let y = difference + beyond;
    let tail = (difference - y) + beyond;
    (shifted.to_bits(), [sine_of_rest(y, tail), cosine_of_rest(y, tail)])
}

/// The sine of so many quarters beyond the rest: of an odd number of quarters the other one, of two or three the negative.
#[inline(always)]
fn turned([sine, cosine]: [f64; 2], n: u64) -> f64 {
    let odd = (n & 1).wrapping_neg();
    let sign = (n & 2) << 62;
    f64::from_bits(((sine.to_bits() & !odd) | (cosine.to_bits() & odd)) ^ sign)
}

/// `sin(y + tail)` for `|y| <= pi/4`. The first term left out is 1e-19 of it.
#[inline(always)]
fn sine_of_rest(y: f64, tail: f64) -> f64 {
    let z = y * y;
    let w = z * z;
    let even = ((term(15) * w + term(11)) * w + term(7)) * w + term(3);
    let odd = ((term(17) * w + term(13)) * w + term(9)) * w + term(5);
    y + (y * z * (even + z * odd) + tail * (1.0 - 0.5 * z))
}

/// `cos(y + tail)` for `|y| <= pi/4`. The first term left out is 3e-18 of it.
#[inline(always)]
fn cosine_of_rest(y: f64, tail: f64) -> f64 {
    let z = y * y;
    let w = z * z;
    let even = ((term(16) * w + term(12)) * w + term(8)) * w + term(4);
    let odd = (term(14) * w + term(10)) * w + term(6);
    let half = 0.5 * z;
    let first = 1.0 - half;
    first + (((1.0 - first) - half) + (w * (even + z * odd) - y * tail))
}

/// The term of the power `n`: `1/n!` with the sign that it has in both series.
const fn term(n: u32) -> f64 {
    let (mut product, mut k) = (1.0, 2);
    while k <= n {
        product *= k as f64;
        k += 1;
    }
    if n & 2 == 0 { 1.0 / product } else { -1.0 / product }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of all sizes, multiples of `pi/2`, and those next to both and to where the ways part.
    fn numbers() -> Vec<f64> {
        let mut numbers = vec![0.0, LARGEST, 2000.0, 1e22, 5e-324, f64::MIN_POSITIVE];
        for index in 1..40_000 {
            let turn = (f64::from(index) * 0.618_033_988_749_894_9).fract();
            numbers.extend([LARGEST * turn, 0.5f64.powi(index % 60) * turn, 7.0 * turn]);
        }
        numbers.extend((0..1100).map(|n| f64::from(n) * std::f64::consts::FRAC_PI_2));
        numbers.extend((0..1100).map(|n| f64::from(n) * std::f64::consts::FRAC_PI_4));
        for x in numbers.clone() {
            numbers.extend([x.next_up(), x.next_down(), -x]);
        }
        numbers
    }

    /// Units in the last place of the exact value between two numbers.
    fn units(found: f64, exact: f64) -> f64 {
        (found - exact).abs() / (exact.abs().next_up() - exact.abs())
    }

    #[test]
    fn waves_are_those_of_the_system() {
        for x in numbers() {
            let (sine, cosine) = (sine(x), cosine(x));
            assert!(units(sine, x.sin()) <= 1.0, "sin {x:e}: {sine:e} {:e}", x.sin());
            assert!(units(cosine, x.cos()) <= 1.0, "cos {x:e}: {cosine:e} {:e}", x.cos());
        }
        for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert!(sine(x).is_nan() && cosine(x).is_nan());
        }
    }

    /// Side by side, in any company, and for every width of the vectors.
    #[test]
    fn waves_have_the_same_bits_side_by_side() {
        let numbers = numbers();
        for beside in numbers.as_chunks::<8>().0 {
            let [mut large, mut infinite] = [*beside; 2];
            (large[3], infinite[5]) = (1e9, f64::INFINITY);
            for x in [*beside, large, infinite] {
                let found = pulp::Arch::new().dispatch(
                    #[inline(always)]
                    || [sines(x), cosines(x)],
                );
                let pairs = pulp::Arch::new().dispatch(
                    #[inline(always)]
                    || both(x),
                );
                let alone = [x.map(sine), x.map(cosine)];
                let bits = |values: [[f64; 8]; 2]| values.map(|values| values.map(f64::to_bits));
                assert_eq!(bits(found), bits(alone), "{x:?}");
                assert_eq!(bits(pairs), bits(alone), "{x:?}");
            }
        }
    }

    /// Digits from an arithmetic of 60: far from zero, next to a zero, next to a zero far away.
    #[test]
    fn digits_of_waves() {
        assert_eq!(sine(1.0), 0.841_470_984_807_896_5);
        assert_eq!(cosine(1.0), 0.540_302_305_868_139_8);
        assert_eq!(sine(std::f64::consts::PI), 1.224_646_799_147_353_2e-16);
        assert_eq!(cosine(std::f64::consts::FRAC_PI_2), 6.123_233_995_736_766e-17);
        assert_eq!(sine(355.0), -3.014_435_335_948_845e-5);
    }
}
