//! The kernels of rings in the logarithm of the radius, where they depend on differences only.
//!
//! With `y = ln(r/s)` the displacement at `r` of a load on the ring `s` is, but for powers of `r` and `s`, the Legendre function `Q_(m - 1/2)(cosh y)`: `m = 0`
//! without angle, `m = 1` for the first harmonic. It is `-P_(m - 1/2)(cosh y) ln|y|` and a function without singularity for real `y`. Where a disk
//! `r <= c` touches inside the rings, `c` is the end of the integrals
//!
//! `H_0 = 2 sqrt(r s) int_0^c dx/sqrt((r^2 - x^2) (s^2 - x^2))`, `H_1 = 2/sqrt(r s) int_0^c x^2 dx/sqrt((r^2 - x^2) (s^2 - x^2))`
//!
//! that the disk takes away (B. C. Carlson's forms of elliptic integrals, 1979).

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, LN_2, PI};

use crate::special::arithmetic_geometric_mean as mean;
use crate::special::elliptic::{carlson_first_kind, carlson_second_kind};

/// A harmonic of the angle about the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RingKernel {
    /// Without angle: settlement.
    Axisymmetric,
    /// The cosine: tilt.
    Tilted,
}

impl RingKernel {
    /// `Q_(m - 1/2)(cosh y)`.
    pub fn whole(self, y: f64) -> f64 {
        match self {
            Self::Axisymmetric => FRAC_PI_2 / mean((0.5 * y).cosh(), (0.5 * y).sinh().abs()),
            Self::Tilted => {
                let y = y.abs();
                let second = carlson_second_kind(0.0, -(-2.0 * y).exp_m1(), 1.0);
                2.0 / 3.0 * (-1.5 * y).exp() * second
            }
        }
    }

    /// `P_(m - 1/2)(cosh y)`.
    pub fn factor(self, y: f64) -> f64 {
        match self {
            Self::Axisymmetric => 1.0 / mean((0.5 * y).cosh(), 1.0),
            Self::Tilted => {
                let y = y.abs();
                let (square, rest) = ((-2.0 * y).exp(), -(-2.0 * y).exp_m1());
                let first = carlson_first_kind(0.0, square, 1.0);
                let second = carlson_second_kind(0.0, square, 1.0);
                FRAC_2_PI * (0.5 * y).exp() * (first - rest / 3.0 * second)
            }
        }
    }

    /// `Q + P ln|y|`.
    pub fn rest(self, y: f64) -> f64 {
        if y == 0.0 {
            return match self {
                Self::Axisymmetric => 3.0 * LN_2,
                Self::Tilted => 3.0 * LN_2 - 2.0,
            };
        }
        self.whole(y) + self.factor(y) * y.abs().ln()
    }

    /// Both of these, the factor first.
    pub fn parts(self, y: f64) -> [f64; 2] {
        let factor = self.factor(y);
        let rest = if y == 0.0 { self.rest(y) } else { self.whole(y) + factor * y.abs().ln() };
        [factor, rest]
    }

    /// `H_m` of a disk of radius `c`; places by radius and distance from the disk.
    pub fn taken(self, c: f64, [r, beside_r]: [f64; 2], [s, beside_s]: [f64; 2]) -> f64 {
        if c == 0.0 {
            return 0.0;
        }
        let root = (r * s).sqrt();
        let [x, y] =
            [(r, beside_r), (s, beside_s)].map(|(at, beside)| beside / at * ((at + c) / at));
        match self {
            Self::Axisymmetric => 2.0 * c / root * carlson_first_kind(x, y, 1.0),
            Self::Tilted => 2.0 / 3.0 * (c / root).powi(3) * carlson_second_kind(x, y, 1.0),
        }
    }

    /// The part of a unit settlement, or tilt, at `r` that a disk of radius `c` leaves to the rings.
    pub fn left(self, c: f64, [r, beside]: [f64; 2]) -> f64 {
        let root = (beside * (r + c)).sqrt();
        let angle = root.atan2(c);
        match self {
            Self::Axisymmetric => FRAC_2_PI * angle,
            Self::Tilted => FRAC_2_PI * (r * angle + c * (root / r)),
        }
    }

    /// Force, or moment, of the density that belongs to the part left, per its integral over the angle.
    pub fn weight(self) -> f64 {
        match self {
            Self::Axisymmetric => 2.0 * PI,
            Self::Tilted => PI,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `int_0^{pi/2} f dt` of a periodic `f`, by the trapezoidal rule.
    fn quarter(f: impl Fn(f64) -> f64) -> f64 {
        let count = 400;
        let step = FRAC_PI_2 / f64::from(count);
        (0..count).map(|i| f((f64::from(i) + 0.5) * step)).sum::<f64>() * step
    }

    #[test]
    fn kernels_are_integrals_of_bessel_functions() {
        // Q_(m - 1/2)(cosh y) = int_0^pi cos(m t) dt/sqrt(2 (cosh y - cos t)), P_(n)(cosh y) = (1/pi) int_0^pi (cosh y + sinh y cos t)^n dt
        for (harmonic, m) in [(RingKernel::Axisymmetric, 0.0), (RingKernel::Tilted, 1.0)] {
            for y in [0.3f64, -1.0, 4.0] {
                let first = quarter(|t| {
                    2.0 * (m * 2.0 * t).cos() / (2.0 * (y.cosh() - (2.0 * t).cos())).sqrt()
                });
                assert!((harmonic.whole(y) / first - 1.0).abs() < 1e-13, "{m} {y}");
                let second =
                    quarter(|t| FRAC_2_PI * (y.cosh() + y.sinh() * (2.0 * t).cos()).powf(m - 0.5));
                assert!((harmonic.factor(y) / second - 1.0).abs() < 1e-13, "{m} {y}");
            }
            assert!((harmonic.rest(1e-7) - harmonic.rest(0.0)).abs() < 1e-13);
        }
    }

    #[test]
    fn what_a_disk_takes() {
        // x = c sin t
        let (c, r, s) = (0.4f64, 0.5f64, 0.9f64);
        for (harmonic, m) in [(RingKernel::Axisymmetric, 0), (RingKernel::Tilted, 1)] {
            let sum = quarter(|t| {
                let x = c * t.sin();
                let roots = ((r * r - x * x) * (s * s - x * x)).sqrt();
                (x * x / (r * s)).powi(m) * c * t.cos() / roots
            });
            let exact = 2.0 * (r * s).sqrt() * sum;
            let found = harmonic.taken(c, [r, r - c], [s, s - c]);
            assert!((found / exact - 1.0).abs() < 1e-5, "{m}: {found} {exact}");
        }
        // With the disk up to the nearer place nothing is left.
        for harmonic in [RingKernel::Axisymmetric, RingKernel::Tilted] {
            let whole = harmonic.whole((0.9f64 / 0.4).ln());
            assert!((harmonic.taken(0.4, [0.4, 0.0], [0.9, 0.5]) / whole - 1.0).abs() < 1e-14);
        }
    }
}
