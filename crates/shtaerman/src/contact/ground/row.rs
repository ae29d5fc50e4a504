//! A row of punches on a homogeneous half-plane: `K = ln 1/(2 sin(pi |xi - eta|/L))` with the period `L` in half-widths. Local coordinates are the angle
//! `2 pi (xi - origin)/L`, whatever the zones.

use std::f64::consts::{PI, TAU};

use fredholm::complementarity::mean_logarithms;
use fredholm::kernel::{Kernel, LogarithmSine};
use fredholm::multipole::PanelKernel;

use super::{Ground, Hull, middle};
use crate::Error;

#[derive(Debug)]
pub(super) struct Row {
    period: f64,
    kernel: LogarithmSine,
}

impl Row {
    /// # Errors
    /// [`Error::Equation`] for a kernel that cannot be made; none is known.
    pub(super) fn new(period: f64) -> Result<Self, Error> {
        // Panels leave a gap, however narrow: the kernel of the whole circle has the same values.
        Ok(Self { period, kernel: LogarithmSine::new(PI.next_down())? })
    }
}

impl Ground for Row {
    fn kernel(&self) -> &dyn Kernel {
        &self.kernel
    }

    fn hull(&self, _left: f64, _right: f64, origin: f64) -> Hull {
        Hull { centre: origin, half: self.period / TAU }
    }

    fn reduced_slope(&self, xi: f64, eta: f64) -> f64 {
        let angle = PI * (xi - eta) / self.period;
        if angle == 0.0 { -1.0 } else { -angle / angle.tan() }
    }

    fn means(&self, lefts: &[[f64; 2]], right: [f64; 2]) -> Vec<f64> {
        let period = self.period;
        // Of K with both logarithms taken out, the near one and the one through the gap to the image of the left cell.
        let ratio = |distance: f64| {
            if distance == 0.0 {
                TAU / (period * period)
            } else {
                2.0 * (PI * distance / period).sin() / (distance * (period - distance))
            }
        };
        // Mirrored, the images lie on the left.
        let images: Vec<[f64; 2]> =
            lefts.iter().map(|[start, end]| [-(end + period), -(start + period)]).collect();
        let through_gap = mean_logarithms(&images, [-right[1], -right[0]]);
        let means = mean_logarithms(lefts, right).into_iter().zip(through_gap).zip(lefts);
        means
            .map(|((near, far), left)| near + far - ratio(middle(right) - middle(*left)).ln())
            .collect()
    }

    fn is_closed(&self) -> bool {
        self.period <= 2.0
    }

    fn panel_kernel(&self) -> Option<(PanelKernel, f64)> {
        Some((PanelKernel::Sine, 0.5 * self.period))
    }
}
