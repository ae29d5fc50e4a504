//! Kernels given by a transfer function `M`: what a wave of the wavenumber `u/h` is multiplied by, beside what the logarithm or one over the distance make of it.

mod disk;
mod local;
mod plane;
mod spectrum;
mod table;

pub use disk::TransferDisk;
pub use plane::TransferPlane;
pub use spectrum::LAST_WAVENUMBER;

use crate::Error;

/// A length that both kernels take.
fn require_thickness(thickness: f64, least: f64, requirement: &'static str) -> Result<(), Error> {
    if thickness.is_finite() && thickness >= least {
        return Ok(());
    }
    Err(Error::InvalidParameter { name: "thickness", value: thickness, requirement })
}
