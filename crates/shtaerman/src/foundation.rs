//! What the punch is pressed into.

use crate::error::require;
use crate::quantity::{Dimension, DisplayUnit, engineering};
use crate::roughness::Law;
use crate::{Elastic, Error, Grading, Influence, Layering, Roughness};

/// The body under the punch: its elastic material and what its rough surface gives.
///
/// ```
/// use shtaerman::{Elastic, Foundation, Grading, Roughness};
///
/// // Ground steel: Young's modulus (Pa), Poisson's ratio, roughness compliance (m/Pa).
/// let steel = Foundation::new(Elastic::new(200e9, 0.3)?).with_roughness(1.2e-14)?;
/// assert_eq!(steel.roughness(), Roughness::Linear { compliance: 1.2e-14 });
///
/// // Sand whose modulus grows with the square root of the depth, 40 MPa at 1 m; its surface is smooth.
/// let sand = Foundation::graded(Grading::new(0.5, 40e6)?, 0.25)?;
/// assert_eq!(sand.roughness(), Roughness::Smooth);
///
/// // Numbers without dimensions: theta0 stands for material, roughness and half-width.
/// let bare = Foundation::dimensionless(5.0)?.with_exponent(0.5)?;
/// assert_eq!(bare.theta0(), Some(5.0));
/// # Ok::<(), shtaerman::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Foundation {
    ground: GroundKind,
    layering: Option<Layering>,
    roughness: Roughness,
}

/// What the body below the rough layer is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum GroundKind {
    /// A homogeneous half-space.
    Homogeneous(Elastic),
    /// A half-space whose modulus grows with depth, with the exponent greater than 0, and Poisson's ratio.
    Graded(Grading, f64),
    /// Numbers without dimensions: a homogeneous half-space of `theta0`.
    Dimensionless(f64),
}

impl Foundation {
    /// A homogeneous body with a smooth surface.
    #[must_use]
    pub fn new(material: Elastic) -> Self {
        let (ground, roughness) = (GroundKind::Homogeneous(material), Roughness::Smooth);
        Self { ground, layering: None, roughness }
    }

    /// A body with a smooth surface whose modulus grows with depth. The exponent 0 is a homogeneous body.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a Poisson's ratio beyond `(-1, 0.5]`.
    pub fn graded(grading: Grading, poisson_ratio: f64) -> Result<Self, Error> {
        let material = Elastic::new(grading.modulus(), poisson_ratio)?;
        if grading.is_homogeneous() {
            return Ok(Self::new(material));
        }
        let ground = GroundKind::Graded(grading, poisson_ratio);
        Ok(Self { ground, layering: None, roughness: Roughness::Smooth })
    }

    /// The foundation of a dimensionless problem, `theta0 = 2 a/(pi E* chi)`, with the law `p0` of the layer. `theta0 = 0` is the layer alone, on a rigid
    /// body. Lengths are in half-widths: the [`Punch`](crate::Punch) has the half-width 1.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `theta0` is finite and not negative.
    pub fn dimensionless(theta0: f64) -> Result<Self, Error> {
        require(theta0.is_finite() && theta0 >= 0.0, "theta0", theta0, "finite and not negative")?;
        let roughness = Roughness::Linear { compliance: 1.0 };
        Ok(Self { ground: GroundKind::Dimensionless(theta0), layering: None, roughness })
    }

    /// The same with a rough layer: a compliance `chi` (m/Pa; 0 for a smooth surface) or another [`Roughness`].
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a roughness out of range; [`Error::NotDimensionless`] for a dimensionless foundation, whose scale it is.
    pub fn with_roughness(&self, roughness: impl Into<Roughness>) -> Result<Self, Error> {
        if self.theta0().is_some() {
            return Err(stands_for_all("roughness"));
        }
        let roughness = roughness.into();
        roughness.check()?;
        Ok(Self { roughness, ..self.clone() })
    }

    /// The same dimensionless foundation with the law `p0^exponent` of the layer.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `0 < exponent <= 1`, and for a physical foundation.
    pub fn with_exponent(&self, exponent: f64) -> Result<Self, Error> {
        if self.theta0().is_none() {
            let requirement =
                "given with the coefficient of the layer: with_roughness(Roughness::power(..))";
            return Err(Error::InvalidValue { field: "exponent", value: exponent, requirement });
        }
        Ok(Self { roughness: Roughness::power(1.0, exponent)?, ..self.clone() })
    }

    /// The same in two pieces: a layer of finite thickness on a rigid base, of the material of this foundation, or a coating on it. Lengths are in metres, of a dimensionless
    /// foundation in half-widths. What does not go with it is refused by [`Problem::new`](crate::Problem::new): a smooth surface, a periodic row, a coating under a circular
    /// punch, an elastic punch, grading, a thickness below 0.01 half-widths (0.05 radii), and another material than this one: a bonded layer has
    /// its Poisson's ratio, and it lies below a coating.
    ///
    /// ```
    /// use shtaerman::{Elastic, Foundation, LayerBase, Layering};
    ///
    /// let sheet = Layering::layer(2e-3, LayerBase::Frictionless)?;
    /// let rubber = Foundation::new(Elastic::new(5e6, 0.49)?).with_roughness(1e-11)?.with_layering(sheet.clone());
    /// assert_eq!(rubber.layering(), Some(&sheet));
    /// # Ok::<(), shtaerman::Error>(())
    /// ```
    #[must_use]
    pub fn with_layering(&self, layering: Layering) -> Self {
        Self { layering: Some(layering), ..self.clone() }
    }

    /// The same on ground of one's own, given by its [influence function](Influence): the material is that at the surface. What does not go with it is refused by
    /// [`Problem::new`](crate::Problem::new), as with a [layering](Self::with_layering); a circular punch, too.
    #[must_use]
    pub fn with_influence(&self, influence: Influence) -> Self {
        self.with_layering(Layering::Own(influence))
    }

    /// The layer of finite thickness or the coating; none of a foundation in one piece.
    #[must_use]
    pub fn layering(&self) -> Option<&Layering> {
        self.layering.as_ref()
    }

    /// What the rough layer gives; of a dimensionless foundation in units of `chi`.
    #[must_use]
    pub fn roughness(&self) -> Roughness {
        self.roughness
    }

    /// The law of the rough layer without its coefficient.
    #[must_use]
    pub fn law(&self) -> Law {
        self.roughness.law()
    }

    /// The material of a homogeneous foundation; none of a graded and of a dimensionless one.
    #[must_use]
    pub fn material(&self) -> Option<Elastic> {
        match self.ground {
            GroundKind::Homogeneous(material) => Some(material),
            GroundKind::Graded(..) | GroundKind::Dimensionless(_) => None,
        }
    }

    /// How the modulus grows with depth; none of a homogeneous foundation.
    #[must_use]
    pub fn grading(&self) -> Option<Grading> {
        match self.ground {
            GroundKind::Graded(grading, _) => Some(grading),
            GroundKind::Homogeneous(_) | GroundKind::Dimensionless(_) => None,
        }
    }

    /// Poisson's ratio; a dimensionless foundation has none.
    #[must_use]
    pub fn poisson_ratio(&self) -> Option<f64> {
        match self.ground {
            GroundKind::Homogeneous(material) => Some(material.poisson_ratio()),
            GroundKind::Graded(_, poisson_ratio) => Some(poisson_ratio),
            GroundKind::Dimensionless(_) => None,
        }
    }

    /// `theta0` of a dimensionless foundation; of a physical one it follows from the half-width as well: [`Problem::theta0`](crate::Problem::theta0).
    #[must_use]
    pub fn theta0(&self) -> Option<f64> {
        match self.ground {
            GroundKind::Dimensionless(theta0) => Some(theta0),
            GroundKind::Homogeneous(_) | GroundKind::Graded(..) => None,
        }
    }

    /// `beta` of the pressure `K/(sqrt(2 pi) d^beta)` at the distance `d` from a corner of a smooth surface: 1/2, on graded ground `(1-mu)/2`.
    #[must_use]
    pub fn corner_exponent(&self) -> f64 {
        corner_exponent(self.grading())
    }

    /// The unit of that `K`, `Pa sqrt(m)` or `Pa m^beta`.
    #[must_use]
    pub fn corner_unit(&self) -> DisplayUnit {
        corner_unit(self.grading())
    }

    pub(crate) fn ground(&self) -> GroundKind {
        self.ground
    }
}

pub(crate) fn corner_exponent(grading: Option<Grading>) -> f64 {
    0.5 * (1.0 - grading.map_or(0.0, |grading| grading.exponent()))
}

pub(crate) fn corner_unit(grading: Option<Grading>) -> DisplayUnit {
    if grading.is_none() {
        return DisplayUnit::prefixed("Pa sqrt(m)");
    }
    let beta = engineering(corner_exponent(grading), Dimension::NONE);
    DisplayUnit::prefixed(&format!("Pa m^{beta}"))
}

/// The fault of a quantity that a dimensionless problem has not.
pub(crate) fn stands_for_all(field: &'static str) -> Error {
    Error::NotDimensionless { field }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grading_of_exponent_zero_is_homogeneous() {
        let flat = Foundation::graded(Grading::new(0.0, 2e9).unwrap(), 0.3).unwrap();
        assert_eq!(flat, Foundation::new(Elastic::new(2e9, 0.3).unwrap()));
        assert!(Foundation::graded(Grading::new(0.4, 2e9).unwrap(), 0.7).is_err());
    }

    #[test]
    fn a_dimensionless_foundation_has_no_roughness_of_its_own() {
        let bare = Foundation::dimensionless(3.0).unwrap();
        assert!(bare.with_roughness(1e-12).is_err());
        assert_eq!(bare.with_exponent(0.5).unwrap().law(), Law::Power(0.5));
        assert!(bare.with_exponent(1.5).is_err());
        assert!(Foundation::dimensionless(-1.0).is_err());
        let steel = Foundation::new(Elastic::new(2e11, 0.3).unwrap());
        assert!(steel.with_exponent(0.5).is_err() && steel.with_roughness(-1e-12).is_err());
        assert_eq!(steel.with_roughness(1e-12).unwrap().with_roughness(0.0), Ok(steel));
    }
}
