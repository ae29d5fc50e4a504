//! A layer of finite thickness under a circular punch: `K` of [`TransferDisk`], `dm = eta deta`, in which `h` is the thickness in radii.
//!
//! The part that a half-space has is homogeneous, and moves as [there](super::disk); the smooth rest is moved by differences.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use fredholm::kernel::{Kernel, TransferDisk};

use super::disk::Disk;
use super::shared::layered_disk;
use super::{Ground, Hull, SharedKernel, half_count_of_layer, middle};
use super::{KERNEL, STEP};
use crate::{Error, Layering, deadline::work};

#[derive(Debug)]
pub(super) struct LayeredDisk {
    layering: Layering,
    kernel: Arc<TransferDisk>,
    whole: Disk,
    step: f64,
}

impl LayeredDisk {
    /// # Errors
    /// [`Error::Equation`] for a transfer function that is not finite.
    pub(super) fn new(layering: Layering) -> Result<Self, Error> {
        let kernel = layered_disk(0, &layering)?;
        let step = STEP * layering.thickness().min(1.0);
        Ok(Self { layering, kernel, whole: Disk::new(0.0)?, step })
    }

    /// `dB/dxi` of the smooth part `B`, which is even in `xi`.
    fn remainder_slope(&self, xi: f64, eta: f64) -> f64 {
        let at = |x: f64| self.kernel.remainder(x.abs(), eta);
        let rise = |k: f64| at(xi + k * self.step) - at(xi - k * self.step);
        (8.0 * rise(1.0) - rise(2.0)) / (12.0 * self.step)
    }
}

impl Ground for LayeredDisk {
    fn kernel(&self) -> &dyn Kernel {
        self.kernel.as_ref()
    }

    fn hull(&self, _left: f64, _right: f64, _origin: f64) -> Hull {
        Hull { centre: 0.0, half: 1.0 }
    }

    fn reduced_slope(&self, xi: f64, eta: f64) -> f64 {
        self.whole.reduced_slope(xi, eta) + (xi - eta) * self.remainder_slope(xi, eta)
    }

    fn means(&self, lefts: &[[f64; 2]], right: [f64; 2]) -> Vec<f64> {
        let remainder = |left: &[f64; 2]| self.kernel.remainder(middle(right), middle(*left));
        let means = self.whole.means(lefts, right).into_iter().zip(lefts);
        means.map(|(mean, left)| mean + remainder(left)).collect()
    }

    fn entry(&self) -> f64 {
        work::LAYERED_RING
    }

    fn is_disk(&self) -> bool {
        true
    }

    fn strength(&self) -> f64 {
        PI
    }

    fn area(&self) -> f64 {
        TAU
    }

    fn turned_kernel(&self) -> Result<Option<SharedKernel>, Error> {
        let kernel: SharedKernel = layered_disk(1, &self.layering)?;
        Ok(Some(kernel))
    }

    fn slope(&self, xi: f64, eta: f64) -> f64 {
        if xi == eta {
            return 0.0;
        }
        self.whole.slope(xi, eta) + self.remainder_slope(xi, eta)
    }

    fn kernel_error(&self) -> f64 {
        KERNEL * (1.0 + 1.0 / self.kernel.thickness())
    }

    fn first_half_count(&self, length: f64) -> f64 {
        half_count_of_layer(length, self.kernel.thickness())
    }
}
