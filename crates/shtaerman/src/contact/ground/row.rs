//! A row of punches on a homogeneous half-plane: `K = ln 1/(2 sin(pi |xi - eta|/L))` with the period `L` in half-widths. Local coordinates are the angle
//! `2 pi (xi - origin)/L`, whatever the zones.

use std::f64::consts::{PI, TAU};

use fredholm::complementarity::mean_logarithm;
use fredholm::kernel::{Kernel, LogarithmSine};
use fredholm::multipole::PanelKernel;

use super::{Ground, Hull};
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

    fn mean(&self, left: [f64; 2], right: [f64; 2]) -> f64 {
        let period = self.period;
        let middle = |cell: [f64; 2]| 0.5 * (cell[0] + cell[1]);
        let distance = middle(right) - middle(left);
        // Of K with both logarithms taken out, the near one and the one through the gap to the image of the left cell.
        let ratio = if distance == 0.0 {
            TAU / (period * period)
        } else {
            2.0 * (PI * distance / period).sin() / (distance * (period - distance))
        };
        let image = left.map(|end| end + period);
        mean_logarithm(left, right) + mean_logarithm(right, image) - ratio.ln()
    }

    fn is_closed(&self) -> bool {
        self.period <= 2.0
    }

    fn panel_kernel(&self) -> Option<(PanelKernel, f64)> {
        Some((PanelKernel::Sine, 0.5 * self.period))
    }
}
