//! Kernels given by a transfer function `M`: what a wave of the wavenumber `u/h` is multiplied by, beside what the logarithm or one over the distance make of it.

mod disk;
mod plane;
mod table;

pub use disk::TransferDisk;
pub use plane::TransferPlane;

use crate::Error;

/// Beyond this `u` a transfer function counts as 1: what it lacks falls as `exp(-2u)`, times a power of `u`, and `exp(-2u) u^2` is 1e-19 there.
pub const LAST_WAVENUMBER: f64 = 25.0;

/// A length that both kernels take.
fn require_thickness(thickness: f64, least: f64, requirement: &'static str) -> Result<(), Error> {
    if thickness.is_finite() && thickness >= least {
        return Ok(());
    }
    Err(Error::InvalidParameter { name: "thickness", value: thickness, requirement })
}
