//! The kernels of smooth plane contact.

use std::f64::consts::PI;

/// The kernel `K(d)` of the elastic displacement, without dimensions.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum SmoothKernel {
    /// `ln 1/|d|`.
    #[default]
    Plane,
    /// `ln 1/(2 sin(pi |d|/L))`: what repeats with the period `L >= 2`.
    Periodic {
        /// `L` in half-widths.
        period: f64,
    },
}

impl SmoothKernel {
    pub(super) fn period(self) -> Option<f64> {
        match self {
            Self::Plane => None,
            Self::Periodic { period } => Some(period),
        }
    }

    /// The sources of `ln 1/|d|` that are taken exactly: the zones and, in a row, their neighbours on either side.
    pub(super) fn images(self) -> &'static [f64] {
        match self {
            Self::Plane => &[0.0],
            Self::Periodic { .. } => &[0.0, -1.0, 1.0],
        }
    }

    /// What the [images](Self::images) leave of the kernel, smooth for `|d| < 2L`.
    pub(super) fn remainder(self, distance: f64) -> f64 {
        let Some(period) = self.period() else { return 0.0 };
        let z = (distance / period).abs();
        // sin(pi z)/(pi z (1 - z^2)), about its nearer zero
        let ratio = if z < 0.5 {
            sine_quotient(z) / (1.0 - z * z)
        } else {
            sine_quotient(1.0 - z) / (z * (1.0 + z))
        };
        3.0 * period.ln() - (2.0 * PI).ln() - ratio.ln()
    }

    /// A place moved by whole periods to within half a period of zero.
    pub(super) fn reduced(self, xi: f64) -> f64 {
        self.period().map_or(xi, |period| xi - period * (xi / period).round())
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
        let kernel = SmoothKernel::Periodic { period: 2.7 };
        for d in [1e-9f64, 0.3, 1.0, 1.35, 2.0, 2.699, 3.1] {
            let images: f64 = kernel.images().iter().map(|m| -(d + m * 2.7).abs().ln()).sum();
            let exact = -(2.0 * (PI * d / 2.7).sin().abs()).ln();
            let found = images + kernel.remainder(d);
            assert!((found - exact).abs() < 1e-13 * (1.0 + exact.abs()), "{d}: {found} {exact}");
        }
        assert_eq!(SmoothKernel::Plane.remainder(0.7), 0.0);
    }
}
