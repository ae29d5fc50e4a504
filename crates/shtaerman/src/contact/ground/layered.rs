//! A layer of finite thickness, or a coated half-plane, under one punch or a pair: `K` of [`TransferPlane`], in which `h` is the thickness in half-widths.
//!
//! `theta0` counts by `E*` of the foundation; where the points meet a coating gives by its own, so `k` is the quotient of both.

use std::sync::Arc;

use fredholm::complementarity::mean_logarithm;
use fredholm::kernel::{Kernel, TransferPlane};

use super::shared::layered_plane;
use super::{Ground, Hull, half_count_of_layer};
use crate::error::require;
use crate::{Error, Layering};

/// Tables of the kernel are good to this (`cargo test -p fredholm --test transfer`).
const KERNEL: f64 = 1e-13;

/// Least `lim K + ln d` where points meet, under a stiffer coating: the logarithm on a base of half-length 1 is positive down to `-ln 2`.
const LEAST_CONSTANT: f64 = -0.5;

#[derive(Debug)]
pub(super) struct Layered {
    kernel: Arc<TransferPlane>,
    strength: f64,
}

impl Layered {
    /// # Errors
    /// [`Error::InvalidValue`] for a coating so thick and stiff that the kernel is not positive; [`Error::Equation`] for a transfer function that is not finite.
    pub(super) fn new(layering: Layering) -> Result<Self, Error> {
        let kernel = layered_plane(layering)?;
        let strength = match layering {
            Layering::Layer { .. } => 1.0,
            Layering::Coating { .. } => 1.0 / layering.far_share(),
        };
        // Under a stiffer coating the settlement falls below that of the half-plane, whose kernel is positive by its gauge alone.
        let constant = kernel.gauge_constant() + kernel.thickness().ln();
        require(
            layering.far_share() <= 1.0 || constant >= LEAST_CONSTANT,
            "thickness",
            layering.thickness(),
            "(in half-widths) smaller: a coating so stiff and thick spreads the load beyond the punch, where the displacement against its gauge, ln(a/|x-s|), changes sign; give a larger half_width, which sets the gauge alone where the punch lifts off",
        )?;
        Ok(Self { kernel, strength })
    }
}

impl Ground for Layered {
    fn kernel(&self) -> &dyn Kernel {
        self.kernel.as_ref()
    }

    fn hull(&self, _left: f64, _right: f64, origin: f64) -> Hull {
        Hull { centre: origin, half: 1.0 }
    }

    fn reduced_slope(&self, xi: f64, eta: f64) -> f64 {
        self.kernel.reduced_slope((xi - eta).abs())
    }

    fn mean(&self, left: [f64; 2], right: [f64; 2]) -> f64 {
        let middle = |cell: [f64; 2]| 0.5 * (cell[0] + cell[1]);
        let (s, x) = (middle(left), middle(right));
        let split = self.kernel.split(x, s, x - s);
        split.factor * -mean_logarithm(left, right) + split.rest
    }

    fn strength(&self) -> f64 {
        self.strength
    }

    fn kernel_error(&self) -> f64 {
        KERNEL
    }

    fn first_half_count(&self, length: f64) -> f64 {
        half_count_of_layer(length, self.kernel.thickness())
    }
}
