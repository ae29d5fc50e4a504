//! What the rough layer gives under pressure.

use serde::{Deserialize, Serialize};

use crate::Error;
use crate::error::{positive, require};

/// The local displacement of the rough surface under the pressure `p`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Roughness {
    /// None: a smooth surface, the equation is of the first kind.
    Smooth,
    /// `chi p`, Shtaerman's law (2.1).
    Linear {
        /// `chi` (m/Pa).
        compliance: f64,
    },
    /// `B p^kappa` (Galanov; Goryacheva; cited from memory).
    Power {
        /// `B` (m/Pa^kappa).
        coefficient: f64,
        /// `kappa`, `0 < kappa <= 1`.
        exponent: f64,
    },
}

/// The law without dimensions: what the layer gives under `p0`, over the scale of displacements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Law {
    /// 0.
    Smooth,
    /// `p0`.
    Linear,
    /// `p0^kappa` with `0 < kappa < 1`.
    Power(f64),
}

impl Law {
    /// What the layer gives under `p0`; a power bears no tension.
    pub(crate) fn displacement(self, pressure: f64) -> f64 {
        match self {
            Self::Smooth => 0.0,
            Self::Linear => pressure,
            Self::Power(exponent) => pressure.max(0.0).powf(exponent),
        }
    }

    /// `kappa`; none of a smooth surface.
    pub(crate) fn exponent(self) -> Option<f64> {
        match self {
            Self::Smooth => None,
            Self::Linear => Some(1.0),
            Self::Power(exponent) => Some(exponent),
        }
    }
}

impl Roughness {
    /// `B p^kappa`; the exponent 1 is Shtaerman's law.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless the coefficient is finite and positive and `0 < kappa <= 1`.
    pub fn power(coefficient: f64, exponent: f64) -> Result<Self, Error> {
        positive("coefficient", coefficient)?;
        require(
            exponent > 0.0 && exponent <= 1.0,
            "exponent",
            exponent,
            "greater than 0 and at most 1: asperities stiffen under load",
        )?;
        Ok(if exponent == 1.0 {
            Self::Linear { compliance: coefficient }
        } else {
            Self::Power { coefficient, exponent }
        })
    }

    /// The law without dimensions.
    #[must_use]
    pub fn law(&self) -> Law {
        match *self {
            Self::Smooth => Law::Smooth,
            Self::Linear { .. } => Law::Linear,
            Self::Power { exponent, .. } => Law::Power(exponent),
        }
    }

    /// What the layer gives under a pressure (m).
    #[must_use]
    pub fn displacement(&self, pressure: f64) -> f64 {
        match *self {
            Self::Smooth => 0.0,
            Self::Linear { compliance } => compliance * pressure,
            Self::Power { coefficient, exponent } => coefficient * pressure.powf(exponent),
        }
    }

    /// `B` and `kappa`; none of a smooth surface.
    pub(crate) fn coefficients(&self) -> Option<(f64, f64)> {
        match *self {
            Self::Smooth => None,
            Self::Linear { compliance } => Some((compliance, 1.0)),
            Self::Power { coefficient, exponent } => Some((coefficient, exponent)),
        }
    }

    pub(crate) fn check(&self) -> Result<(), Error> {
        match *self {
            Self::Smooth => Ok(()),
            Self::Linear { compliance } => positive("roughness", compliance).map(|_| ()),
            Self::Power { coefficient, exponent } => Self::power(coefficient, exponent).map(|_| ()),
        }
    }
}

/// A compliance `chi` (m/Pa); zero is a smooth surface.
impl From<f64> for Roughness {
    fn from(compliance: f64) -> Self {
        if compliance == 0.0 { Self::Smooth } else { Self::Linear { compliance } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponent_one_is_shtaermans_law() {
        assert_eq!(Roughness::power(2e-12, 1.0), Ok(Roughness::Linear { compliance: 2e-12 }));
        assert_eq!(Roughness::from(0.0), Roughness::Smooth);
        let power = Roughness::power(3.0, 0.5).unwrap();
        assert_eq!((power.law(), power.displacement(4.0)), (Law::Power(0.5), 6.0));
    }

    #[test]
    fn refuses_what_is_no_law() {
        for (coefficient, exponent) in [(0.0, 0.5), (1.0, 0.0), (1.0, 1.5), (1.0, f64::NAN)] {
            assert!(Roughness::power(coefficient, exponent).is_err(), "{coefficient} {exponent}");
        }
        assert!(Roughness::from(-1.0).check().is_err());
    }
}
