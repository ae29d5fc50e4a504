//! The kernels of a half-plane under one punch, a pair, or a row.

use std::f64::consts::{FRAC_1_SQRT_2, LN_2, PI, TAU};

/// The kernel `ln 1/|d|`, or `ln 1/(2 sin(pi |d|/L))` of what repeats with a period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Kernel {
    /// `L >= 2` in half-widths.
    pub(super) period: Option<f64>,
}

impl Kernel {
    /// The shifts of the sources of `ln 1/|d|` that are taken exactly: the zones and, in a row, their neighbours on either side.
    pub(super) fn shifts(self) -> impl Iterator<Item = f64> {
        let period = self.period.unwrap_or(0.0);
        let images: &[f64] = if self.period.is_some() { &[0.0, -1.0, 1.0] } else { &[0.0] };
        images.iter().map(move |m| m * period)
    }

    /// The sizes of the logarithms whose sum is the potential of a zone of this half-length with its images: in a row whose gaps close they cancel.
    pub(super) fn images(self, half: f64) -> f64 {
        self.period.map_or(0.0, |l| 3.0 * ((LN_2 - half.ln()).abs() + TAU.ln()) + 5.0 * l.ln())
    }

    /// What these leave of the kernel, smooth for `|d| < 2L`; nothing on the plane.
    pub(super) fn remainder(self) -> Option<Remainder> {
        let period = self.period?;
        Some(Remainder { period, level: 3.0 * period.ln() - (2.0 * PI).ln() })
    }
}

/// `3 ln L - ln(2 pi) - ln[sin(pi z)/(pi z (1 - z^2))]`, `z = d/L`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Remainder {
    period: f64,
    level: f64,
}

/// `(zeta(2k) - 1)/k` from `k = 1`: `-ln[sin(pi z)/(pi z (1 - z^2))]` is their sum with `z^(2k)`, to rounding for
/// `z < 0.85`.
const BENDS: [f64; 22] = [
    0.644_934_066_848_226_4,
    0.041_161_616_855_569_09,
    0.005_781_020_661_483_047,
    0.001_019_339_049_486_085,
    0.000_198_915_025_563_617_06,
    4.101_442_555_134_138e-5,
    8.749_733_579_814_976e-6,
    1.910_282_426_081_484e-6,
    4.241_436_961_110_933e-7,
    9.539_620_338_727_961e-8,
    2.167_731_842_979_391e-8,
    4.967_349_087_604_957e-9,
    1.146_273_448_335_772_5e-9,
    2.660_952_874_848_898e-10,
    6.208_849_549_464_455e-11,
    1.455_194_896_047_815_8e-11,
    3.423_983_581_119_236e-12,
    8.084_401_050_578_88e-13,
    1.914_726_077_567_711e-13,
    4.547_473_920_131_945e-14,
    1.082_731_831_345_072_7e-14,
    2.583_791_812_557_993_7e-15,
];

impl Remainder {
    pub(super) fn at(self, distance: f64) -> f64 {
        let z = (distance / self.period).abs();
        let square = z * z;
        if square < FRAC_1_SQRT_2 {
            return self.level + BENDS.iter().rev().fold(0.0, |sum, b| square * (b + sum));
        }
        // About its nearer zero.
        self.level - (sine_quotient(1.0 - z) / (z * (1.0 + z))).ln()
    }
}

/// `sin(pi z)/(pi z)`.
fn sine_quotient(z: f64) -> f64 {
    if z == 0.0 { 1.0 } else { (PI * z).sin() / (PI * z) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_add_up() {
        let kernel = Kernel { period: Some(2.7) };
        for d in [1e-9f64, 0.3, 1.0, 1.349_999, 1.35, 2.0, 2.2949, 2.2951, 2.699, 3.1] {
            let images: f64 = kernel.shifts().map(|shift| -(d + shift).abs().ln()).sum();
            let exact = -(2.0 * (PI * d / 2.7).sin().abs()).ln();
            let found = images + kernel.remainder().unwrap().at(d);
            assert!((found - exact).abs() < 1e-13 * (1.0 + exact.abs()), "{d}: {found} {exact}");
        }
        assert!(Kernel { period: None }.remainder().is_none());
    }
}
