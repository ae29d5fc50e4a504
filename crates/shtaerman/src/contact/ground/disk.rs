//! A half-space under a circular punch, homogeneous or with `E ~ y^mu`: `K = int_0^inf t^mu J_0(xi t) J_0(eta t) dt`, `dm = eta deta`, for pressures without angle.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use fredholm::SincOperator;
use fredholm::complementarity::{mean_logarithms, mean_powers};
use fredholm::kernel::{Kernel, WeberSonine};
use fredholm::multipole::{PanelKernel, Rings};

use super::shared::{disk_harmonic, disk_operator};
use super::{Ground, Hull, SharedKernel, smooth_means};
use crate::Error;

#[derive(Debug)]
pub(super) struct Disk {
    kernel: WeberSonine,
    /// The same on panels, and what it begins with where rings of the radius 1 meet, as a logarithm or a power.
    rings: Rings,
    share: f64,
}

impl Disk {
    /// # Errors
    /// [`Error::Equation`] unless `0 <= mu < 1`.
    pub(super) fn new(exponent: f64) -> Result<Self, Error> {
        let kernel = disk_harmonic(0, exponent)?;
        let strength = kernel.split(1.0, 1.0, 0.0).factor;
        let share = if exponent > 0.0 { strength / exponent } else { strength };
        Ok(Self { rings: Rings::of(&kernel)?, kernel, share })
    }
}

impl Ground for Disk {
    fn kernel(&self) -> &dyn Kernel {
        &self.kernel
    }

    fn hull(&self, _left: f64, right: f64, _origin: f64) -> Hull {
        Hull { centre: 0.0, half: right }
    }

    fn reduced_slope(&self, xi: f64, eta: f64) -> f64 {
        match xi - eta {
            0.0 => -self.kernel.split(xi, xi, 0.0).factor,
            difference => difference * self.share * self.rings.slope(xi, eta),
        }
    }

    fn means(&self, lefts: &[[f64; 2]], right: [f64; 2]) -> Vec<f64> {
        let exponent = self.exponent();
        // sigma = (d^-mu - 1)/mu
        let singular = if exponent > 0.0 {
            let powers = mean_powers(lefts, right, exponent).into_iter();
            powers.map(|mean| (mean - 1.0) / exponent).collect()
        } else {
            mean_logarithms(lefts, right)
        };
        smooth_means(&self.kernel, (lefts, right), singular)
    }

    fn is_disk(&self) -> bool {
        true
    }

    fn exponent(&self) -> f64 {
        2.0 * self.kernel.exponent()
    }

    fn strength(&self) -> f64 {
        PI
    }

    fn local_ends(&self) -> Option<[f64; 2]> {
        Some([0.0, 1.0])
    }

    fn measure(&self, hull: &Hull) -> f64 {
        hull.half * hull.half
    }

    fn area(&self) -> f64 {
        TAU
    }

    fn known_operator(&self, half_count: usize) -> Option<Result<Arc<SincOperator>, Error>> {
        Some(disk_operator(0, self.exponent(), half_count))
    }

    fn panel_kernel(&self) -> Option<(PanelKernel, f64)> {
        let serves = self.exponent() < Rings::SHARPEST;
        serves.then(|| (PanelKernel::Ring(self.rings.clone()), 1.0))
    }

    fn panel_share(&self) -> f64 {
        self.share
    }

    fn turned_panel_kernel(&self) -> Result<Option<PanelKernel>, Error> {
        let kernel = disk_harmonic(1, self.exponent())?;
        Ok(Some(PanelKernel::Ring(Rings::of(&kernel)?)))
    }

    fn turned_kernel(&self) -> Result<Option<SharedKernel>, Error> {
        Ok(Some(Arc::new(disk_harmonic(1, self.exponent())?)))
    }

    fn known_turned_operator(&self, half_count: usize) -> Option<Result<Arc<SincOperator>, Error>> {
        Some(disk_operator(1, self.exponent(), half_count))
    }

    fn value(&self, y: f64, t: f64) -> f64 {
        if y != t {
            return self.kernel.value(y, t);
        }
        self.kernel.pair(y, t, f64::MIN_POSITIVE).value
    }
}
