//! Logarithms and exponentials of several numbers together, without branches.
//!
//! Both follow the textbook: a power of 2 is taken out, and what is left is summed by its series. They are off by at most two units of the machine, as the functions of the machine are
//! assumed to be.

/// `ln 2` in two parts, the first of so few digits that multiples of it are exact.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];
/// The square root of one half: numbers are taken between it and its double.
const ROOT: u64 = std::f64::consts::FRAC_1_SQRT_2.to_bits();
/// Bits of the fraction of a number, and the exponent of 1.
const FRACTION: u32 = 52;
const ONE: u64 = 1023;
/// Terms of the series of the logarithm, `2/(2k+1) s^(2k+1)` with `s^2 <= 0.0295`, from the second on, the last first.
const TERMS: [f64; 10] = [
    2.0 / 21.0,
    2.0 / 19.0,
    2.0 / 17.0,
    2.0 / 15.0,
    2.0 / 13.0,
    2.0 / 11.0,
    2.0 / 9.0,
    2.0 / 7.0,
    2.0 / 5.0,
    2.0 / 3.0,
];
/// `1/k!` for `k` from 13 down to 2.
const FACTORIALS: [f64; 12] = [
    1.0 / 6_227_020_800.0,
    1.0 / 479_001_600.0,
    1.0 / 39_916_800.0,
    1.0 / 3_628_800.0,
    1.0 / 362_880.0,
    1.0 / 40_320.0,
    1.0 / 5_040.0,
    1.0 / 720.0,
    1.0 / 120.0,
    1.0 / 24.0,
    1.0 / 6.0,
    0.5,
];
/// What is added to a number and taken away again to round it.
const ROUNDER: f64 = 6_755_399_441_055_744.0;
/// Exponentials are asked for within this range.
const LARGEST: f64 = 700.0;

/// `ln|x|` of normal numbers; of 0, and of what is no normal number, some finite number.
#[inline(always)]
pub(crate) fn ln<const N: usize>(x: &[f64; N]) -> [f64; N] {
    let mut found = [0.0; N];
    for i in 0..N {
        found[i] = ln_one(x[i]);
    }
    found
}

#[inline(always)]
fn ln_one(x: f64) -> f64 {
    // |x| = 2^k (1 + f), between the root of 1/2 and that of 2.
    let bits = x.to_bits() & (u64::MAX >> 1);
    let shifted = bits.wrapping_sub(ROOT).wrapping_add(ONE << FRACTION);
    let exponent = shifted >> FRACTION;
    let rest =
        f64::from_bits(bits.wrapping_sub(exponent << FRACTION).wrapping_add(ONE << FRACTION));
    // The exponent as a number, by bits that are its digits.
    let k =
        f64::from_bits(0x4330_0000_0000_0000 | exponent) - (4_503_599_627_370_496.0 + ONE as f64);
    let f = rest - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let mut sum = 0.0;
    for term in TERMS {
        sum = sum * z + term;
    }
    // ln(1 + f) = 2 s + s z sum = f - (f^2/2 - s (f^2/2 + z sum))
    let half = 0.5 * f * f;
    k * LN_2[0] - ((half - (s * (half + z * sum) + k * LN_2[1])) - f)
}

/// `exp x` for `|x| <= 700`, beyond that as there.
#[inline(always)]
pub(crate) fn exp<const N: usize>(x: &[f64; N]) -> [f64; N] {
    let mut found = [0.0; N];
    for i in 0..N {
        found[i] = exp_one(x[i]);
    }
    found
}

#[inline(always)]
fn exp_one(x: f64) -> f64 {
    let x = if x > LARGEST { LARGEST } else { x };
    let x = if x < -LARGEST { -LARGEST } else { x };
    let shifted = x * std::f64::consts::LOG2_E + ROUNDER;
    let k = shifted - ROUNDER;
    let high = x - k * LN_2[0];
    let low = k * LN_2[1];
    let r = high - low;
    let lost = (high - r) - low;
    let mut sum = 0.0;
    for term in FACTORIALS {
        sum = sum * r + term;
    }
    let value = 1.0 + (r + (r * r * sum + lost));
    // 2^k from the lowest bits of what was rounded.
    let power = f64::from_bits(shifted.to_bits().wrapping_add(ONE) << FRACTION);
    value * power
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::allowance::UNIT;

    /// Numbers of all sizes, and many about 1.
    fn numbers() -> Vec<f64> {
        let mut state = 1u64;
        let mut random = move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut found = vec![1.0, 2.0, 0.5, f64::MIN_POSITIVE, 1e300, 0.707_106_781_186_547_5];
        for _ in 0..20_000 {
            found.push(10f64.powf(600.0 * random() - 300.0));
            found.push(4.0 * random());
            found.push(1.0 + 1e-3 * (random() - 0.5));
            found.push(1.0 + 1e-9 * (random() - 0.5));
        }
        found
    }

    /// The functions of the machine are within one unit, as the tests of 25 digits show: these may be off by that more.
    #[test]
    fn functions_are_those_of_the_machine() {
        let mut worst = [0.0f64; 2];
        for x in numbers() {
            let [found] = ln(&[x]);
            let exact = x.ln();
            let off = (found - exact).abs();
            worst[0] = worst[0].max(if exact == 0.0 { off } else { off / (UNIT * exact.abs()) });
            assert_eq!(found.to_bits(), ln(&[-x])[0].to_bits());
            let y = x.ln();
            if y.abs() < 700.0 {
                let [found] = exp(&[y]);
                worst[1] = worst[1].max((found - y.exp()).abs() / (UNIT * y.exp()));
            }
        }
        println!("units: {worst:?}");
        assert!(worst[0] <= 2.0 && worst[1] <= 2.0, "{worst:?}");
        assert!(ln(&[0.0])[0].is_finite() && exp(&[-1e9])[0] < 1e-300);
    }
}
