//! The cosine integral at the multiples of pi, which the exact sinc weights of the logarithm need.

use std::sync::LazyLock;

use super::oscillatory_tail::oscillatory_tail;

/// The first values cost a continued fraction each.
static FIRST: LazyLock<[f64; 12]> = LazyLock::new(|| std::array::from_fn(by_tail));

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
    FIRST.get(j).copied().unwrap_or_else(|| by_tail(j))
}

fn by_tail(j: usize) -> f64 {
    let tail = oscillatory_tail(0.0, j);
    if j.is_multiple_of(2) { -tail } else { tail }
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
