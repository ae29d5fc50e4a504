//! What a foundation and a punch are made of: elastic materials, moduli that grow with depth, rough layers.

use serde::{Deserialize, Serialize};

use crate::Error;
use crate::error::{positive, require};

pub use crate::grading::Grading;
pub use crate::influence::Influence;
pub use crate::layering::{LayerBase, Layering};
pub use crate::roughness::{Law, Roughness};

/// Moduli and yield stresses below this (Pa) are those of gels: rubber begins at about 1 MPa.
pub(crate) const SOFTEST: f64 = 1e6;
/// No solid is stiffer than this (GPa): diamond has 1,100.
pub(crate) const STIFFEST: f64 = 1500.0;
/// No metal yields at more than this (MPa).
pub(crate) const HARDEST: f64 = 5000.0;

/// A linear elastic, isotropic material.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Elastic {
    young_modulus: f64,
    poisson_ratio: f64,
}

impl Elastic {
    /// Young's modulus in Pa and Poisson's ratio.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless the modulus is finite and positive and the ratio lies in `(-1, 0.5]`.
    pub fn new(young_modulus: f64, poisson_ratio: f64) -> Result<Self, Error> {
        positive("young_modulus", young_modulus)?;
        require(
            poisson_ratio > -1.0 && poisson_ratio <= 0.5,
            "poisson_ratio",
            poisson_ratio,
            "greater than -1 and at most 0.5",
        )?;
        Ok(Self { young_modulus, poisson_ratio })
    }

    /// `E` (Pa).
    #[must_use]
    pub fn young_modulus(&self) -> f64 {
        self.young_modulus
    }

    /// `nu`.
    #[must_use]
    pub fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// The plane-strain modulus `E/(1 - nu^2)` (Pa).
    ///
    /// ```
    /// let steel = shtaerman::Elastic::new(200e9, 0.3)?;
    /// assert!((steel.plane_strain_modulus() - 219.78e9).abs() < 0.01e9);
    /// # Ok::<(), shtaerman::Error>(())
    /// ```
    #[must_use]
    pub fn plane_strain_modulus(&self) -> f64 {
        self.young_modulus / (1.0 - self.poisson_ratio * self.poisson_ratio)
    }

    /// The composite modulus `E*` of two elastic bodies (Pa), `1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2` (K. L. Johnson,
    /// *Contact Mechanics*, 4.2). Valid where both bodies deform like half-planes.
    #[must_use]
    pub fn composite_modulus(&self, other: &Self) -> f64 {
        let (one, two) = (self.plane_strain_modulus(), other.plane_strain_modulus());
        one / (1.0 + one / two)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn composite_of_equal_bodies_is_half_of_either() {
        let steel = Elastic::new(210e9, 0.3).unwrap();
        let composite = steel.composite_modulus(&steel);
        assert!((composite - 0.5 * steel.plane_strain_modulus()).abs() < 1e-3);
        let stiff = Elastic::new(1e30, 0.0).unwrap();
        assert!(
            (steel.composite_modulus(&stiff) / steel.plane_strain_modulus() - 1.0).abs() < 1e-15
        );
    }

    #[test]
    fn refuses_what_is_not_a_material() {
        for (modulus, ratio) in [(0.0, 0.3), (-1.0, 0.3), (f64::NAN, 0.3), (f64::INFINITY, 0.3)] {
            assert!(matches!(
                Elastic::new(modulus, ratio),
                Err(Error::InvalidValue { field: "young_modulus", .. })
            ));
        }
        for ratio in [-1.0, 0.500001, f64::NAN, f64::INFINITY] {
            assert!(matches!(
                Elastic::new(1.0, ratio),
                Err(Error::InvalidValue { field: "poisson_ratio", .. })
            ));
        }
        assert!(Elastic::new(1.0, 0.5).is_ok() && Elastic::new(1.0, -0.99).is_ok());
    }
}
