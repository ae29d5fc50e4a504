//! A layer of finite thickness, a coated half-plane or an influence function of the user's, under one punch or a pair: `K` of [`TransferPlane`], in which `h` is the thickness in half-widths.
//!
//! `theta0` counts by `E*` of the foundation; where the points meet a coating gives by its own, so `k` is the quotient of both.

use std::sync::Arc;

use fredholm::complementarity::mean_logarithms;
use fredholm::kernel::{Kernel, TransferPlane};

use super::KERNEL;
use super::shared::layered_plane;
use super::{Ground, Hull, half_count_of_layer, smooth_means};
use crate::error::require;
use crate::{Error, Layering};

/// Least `lim K + ln d` where points meet, under a stiffer coating: the logarithm on a base of half-length 1 is positive down to `-ln 2`. Half and twice change none of 4 answers (survey).
const LEAST_CONSTANT: f64 = -0.5;

/// An influence function is smooth and even where it is known to this, far below any tolerance that is met on it.
const SMOOTH: f64 = 1e-9;
/// Cells of the base on which it has to be positive: the matrix of the logarithm has no eigenvalue below a hundredth there.
const CELLS: usize = 48;

#[derive(Debug)]
pub(super) struct Layered {
    kernel: Arc<TransferPlane>,
    strength: f64,
}

impl Layered {
    /// # Errors
    /// [`Error::InvalidValue`] for a coating so thick and stiff that the kernel is not positive; [`Error::Equation`] for a transfer function that is not finite.
    pub(super) fn new(layering: &Layering) -> Result<Self, Error> {
        let kernel = layered_plane(layering)?;
        // Under a stiffer coating the settlement falls below that of the half-plane, whose kernel is positive by its gauge alone.
        let constant = kernel.gauge_constant() + kernel.thickness().ln();
        require(
            layering.far_share() <= 1.0 || constant >= LEAST_CONSTANT,
            "thickness",
            layering.thickness(),
            "(in half-widths) smaller: a coating so stiff and thick spreads the load beyond the punch, where the displacement against its gauge, ln(a/|x-s|), changes sign; give a larger half_width, which sets the gauge alone where the punch lifts off",
        )?;
        let ground = Self { kernel, strength: layering.strength() };
        if matches!(layering, Layering::Own(_)) {
            ground.require_sound(layering.remainder().is_some())?;
        }
        Ok(ground)
    }

    /// Refuses an influence function that is not smooth beside its logarithm, or not positive; a transfer function is positive where it was stated.
    fn require_sound(&self, is_remainder: bool) -> Result<(), Error> {
        let must = |is_so: bool, value: f64, requirement: &'static str| {
            require(is_so, "influence", value, requirement).map(|_| ())
        };
        let unresolved = self.kernel.unresolved();
        must(
            unresolved <= SMOOTH,
            unresolved,
            "smooth, a transfer function with M(0) = far_share: polynomials and quadrature of a high degree miss it by this",
        )?;
        if !is_remainder {
            return Ok(());
        }
        let slope = self.kernel.slope_at_zero();
        // A constant has its own rounding.
        let size = self.kernel.gauge_constant().abs().max(1.0);
        must(
            slope.abs() <= SMOOTH * size,
            slope,
            "smooth where points meet, as a function of both signs of the distance: without a term in d itself, which has this factor (with d in half-widths)",
        )?;
        let ends = |i: usize| -1.0 + 2.0 * i as f64 / CELLS as f64;
        let cells: Vec<[f64; 2]> = (0..CELLS).map(|i| [ends(i), ends(i + 1)]).collect();
        let least = least_pivot(self.cells(&cells).0, CELLS);
        must(
            least > 0.0,
            least,
            "positive: with this pivot of its matrix some pressure would raise the surface under itself; a constant added to the remainder, which only moves what the settlement is measured against, mends what is negative by that alone",
        )
    }
}

/// The least pivot of a symmetric matrix of this order: not positive if the matrix is not.
fn least_pivot(mut matrix: Vec<f64>, order: usize) -> f64 {
    let mut least = f64::INFINITY;
    for k in 0..order {
        let pivot = matrix[k * order + k];
        least = least.min(pivot);
        if least.is_nan() || least <= 0.0 {
            return least;
        }
        for i in k + 1..order {
            let factor = matrix[i * order + k] / pivot;
            for j in k..order {
                matrix[i * order + j] -= factor * matrix[k * order + j];
            }
        }
    }
    least
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

    fn means(&self, lefts: &[[f64; 2]], right: [f64; 2]) -> Vec<f64> {
        let singular = mean_logarithms(lefts, right).into_iter().map(|mean| -mean).collect();
        smooth_means(self.kernel.as_ref(), (lefts, right), singular)
    }

    fn strength(&self) -> f64 {
        self.strength
    }

    fn kernel_error(&self) -> f64 {
        KERNEL.max(self.kernel.unresolved())
    }

    fn first_half_count(&self, length: f64) -> f64 {
        half_count_of_layer(length, self.kernel.bend())
    }
}
