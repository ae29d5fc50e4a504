//! The conjugate of a slope against closed forms.

use std::f64::consts::PI;

use fredholm::inversion::{Angular, Conjugate};

/// `max(0, |x| - c)^n` on `-b .. b`.
struct Power {
    b: f64,
    c: f64,
    n: f64,
}

impl Power {
    fn place(&self, angle: f64) -> f64 {
        let folded = angle.min(PI - angle);
        (self.b - 2.0 * self.b * (0.5 * folded).sin().powi(2)).copysign(0.5 * PI - angle)
    }

    fn beyond(&self, angle: f64) -> f64 {
        (self.place(angle).abs() - self.c).max(0.0)
    }
}

impl Angular for Power {
    fn height(&self, angle: f64) -> f64 {
        self.beyond(angle).powf(self.n)
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        let slope = self.n * self.beyond(angle).powf(self.n - 1.0);
        Some(-self.b * angle.sin() * slope.copysign(self.place(angle)))
    }
}

#[test]
fn a_root_beside_a_flat_is_integrated() {
    // (2/pi) int_c^b x n (x - c)^(n - 1) / sqrt(b^2 - x^2) dx, by mpmath. The panel of the flat is long, that of the root beside it next to nothing.
    for (n, b, exact) in [
        (1.2, 0.93, 0.079_573_017_936_124_18),
        (1.2, 0.901, 0.007_293_040_207_205_176),
        (1.2, 0.90001, 0.000_290_251_965_055_277_2),
        (1.5, 0.93, 0.030_499_680_465_350_25),
        (1.5, 0.901, 0.001_006_579_912_436_621),
        (1.5, 0.90001, 1.006_234_083_720_232_5e-5),
    ] {
        let power = Power { b, c: 0.9, n };
        let bend = 2.0 * ((b - 0.9) / (2.0 * b)).sqrt().asin();
        let slopes = Conjugate::resolve(&power, [&[bend, PI - bend], &[]], [8, 1], 0.0);
        // Heights beyond the bend are rounded to this share.
        let tolerance = 1e-14 + f64::EPSILON / (b - 0.9);
        for angle in [0.0, PI] {
            let found = slopes.conjugate(angle);
            assert!((found / exact - 1.0).abs() < tolerance, "{n} {b} {angle}: {found:e}");
        }
    }
}
