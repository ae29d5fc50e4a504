//! Harmonic sums over all and over odd integers, in constant time.
//!
//! Short sums are added up; long ones use the asymptotic series of the digamma function. Both series alternate
//! and enclose their sum, so the error is below the first term left out: `2e-17` where they take over.

use std::f64::consts::LN_2;

/// Euler's constant.
const EULER_GAMMA: f64 = 0.577_215_664_901_532_9;

/// Sums of at most this many terms are added up one by one, smallest first.
const SUMMED_DIRECTLY: u64 = 48;

/// `H_p = sum_{j=1}^{p} 1/j`, with `H_0 = 0`; relative error below `1e-15`.
///
/// Source: `H_p = psi(p+1) + gamma` and the asymptotic series of `psi`.
pub(crate) fn harmonic(p: u64) -> f64 {
    if p <= SUMMED_DIRECTLY {
        return (1..=p).rev().map(|j| 1.0 / j as f64).sum();
    }
    let x = p as f64;
    let y = 1.0 / (x * x);
    let series = y * (1.0 / 12.0 - y * (1.0 / 120.0 - y * (1.0 / 252.0 - y / 240.0)));
    x.ln() + (EULER_GAMMA + 0.5 / x - series)
}

/// `O_p = sum_{j=1}^{p} 1/(2j-1)`, with `O_0 = 0`; relative error below `1e-15`.
///
/// Source: `O_p = (psi(p+1/2) + gamma)/2 + ln 2` and the asymptotic series of `psi(p+1/2)` in `1/p^2`.
pub(crate) fn odd_harmonic(p: u64) -> f64 {
    if p <= SUMMED_DIRECTLY {
        return (1..=p).rev().map(|j| 1.0 / (2 * j - 1) as f64).sum();
    }
    let x = p as f64;
    let y = 1.0 / (x * x);
    let series = y * (1.0 / 24.0 - y * (7.0 / 960.0 - y * (31.0 / 8064.0 - y * (127.0 / 30720.0))));
    0.5 * (x.ln() + (EULER_GAMMA + series)) + LN_2
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Neumaier's compensated sum.
    fn compensated(terms: impl Iterator<Item = f64>) -> f64 {
        let (mut sum, mut lost) = (0.0_f64, 0.0_f64);
        for term in terms {
            let next = sum + term;
            lost += if sum.abs() >= term.abs() { (sum - next) + term } else { (term - next) + sum };
            sum = next;
        }
        sum + lost
    }

    #[test]
    fn both_sums_agree_with_compensated_summation_on_both_sides_of_the_switch() {
        for p in [0, 1, 2, 3, 20, 47, 48, 49, 50, 51, 64, 100, 1000, 1_000_000] {
            let all = compensated((1..=p).map(|j| 1.0 / j as f64));
            let odd = compensated((1..=p).map(|j| 1.0 / (2 * j - 1) as f64));
            assert!((harmonic(p) - all).abs() <= 1e-15 * all, "H at {p}: {} {all}", harmonic(p));
            assert!(
                (odd_harmonic(p) - odd).abs() <= 1e-15 * odd,
                "O at {p}: {} {odd}",
                odd_harmonic(p)
            );
        }
    }

    #[test]
    fn long_sums_agree_with_values_to_17_digits() {
        // Computed with 40 digits from the digamma function.
        let far = 100_000_000;
        assert!((harmonic(far) / 18.997_896_413_853_898 - 1.0).abs() < 4e-16);
        assert!((odd_harmonic(far) / 10.192_095_384_986_894 - 1.0).abs() < 4e-16);
    }

    #[test]
    fn the_sum_over_odd_integers_is_a_difference_of_harmonic_sums() {
        for p in [5, 48, 49, 777, 1 << 40] {
            let expected = harmonic(2 * p) - 0.5 * harmonic(p);
            assert!((odd_harmonic(p) - expected).abs() <= 2e-15 * expected, "at {p}");
        }
    }
}
