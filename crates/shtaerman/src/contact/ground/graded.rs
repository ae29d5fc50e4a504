//! A half-plane whose modulus grows with depth, `E ~ y^mu`, under one punch or a pair: `K = |xi - eta|^-mu`.

use fredholm::Interval;
use fredholm::complementarity::mean_powers;
use fredholm::kernel::{Kernel, Power};
use fredholm::multipole::PanelKernel;

use super::Ground;
use crate::Error;

#[derive(Debug)]
pub(super) struct Graded {
    kernel: Power,
}

impl Graded {
    /// # Errors
    /// [`Error::Equation`] unless `0 < mu < 1`.
    pub(super) fn new(exponent: f64) -> Result<Self, Error> {
        Ok(Self { kernel: Power::new(Interval::unit(), exponent)? })
    }
}

impl Ground for Graded {
    fn kernel(&self) -> &dyn Kernel {
        &self.kernel
    }

    fn reduced_slope(&self, xi: f64, eta: f64) -> f64 {
        -self.exponent() * self.value(xi, eta)
    }

    fn means(&self, lefts: &[[f64; 2]], right: [f64; 2]) -> Vec<f64> {
        mean_powers(lefts, right, self.exponent())
    }

    fn exponent(&self) -> f64 {
        self.kernel.exponent()
    }

    fn local_ends(&self) -> Option<[f64; 2]> {
        Some([-1.0, 1.0])
    }

    fn panel_kernel(&self) -> Option<(PanelKernel, f64)> {
        Some((PanelKernel::Power { exponent: self.exponent() }, 1.0))
    }
}
