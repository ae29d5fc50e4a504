//! What is prescribed: one of each pair.

use serde::{Deserialize, Serialize};

use crate::Error;
use crate::error::finite;

/// The vertical half of the load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Vertical {
    /// Force `P` per unit length, positive into the body (N/m).
    Force(f64),
    /// Settlement `delta` in the gauge `ln(a/|x-s|)` (m).
    Settlement(f64),
}

/// The rotational half of the load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Rotational {
    /// Moment `M = int x p dx` per unit length (N m/m).
    Moment(f64),
    /// Eccentricity `e` of the force, `M = P e` (m).
    Eccentricity(f64),
    /// Tilt `alpha` (rad); zero keeps the punch level, (5.1).
    Tilt(f64),
}

/// One of force and settlement, and one of moment, eccentricity and tilt.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Load {
    /// Force or settlement.
    pub vertical: Vertical,
    /// Moment, eccentricity or tilt.
    pub rotational: Rotational,
}

impl Load {
    /// The load, checked.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] with the field when a value is not finite.
    pub fn new(vertical: Vertical, rotational: Rotational) -> Result<Self, Error> {
        match vertical {
            Vertical::Force(value) => finite("force", value)?,
            Vertical::Settlement(value) => finite("settlement", value)?,
        };
        match rotational {
            Rotational::Moment(value) => finite("moment", value)?,
            Rotational::Eccentricity(value) => finite("eccentricity", value)?,
            Rotational::Tilt(value) => finite("tilt", value)?,
        };
        Ok(Self { vertical, rotational })
    }
}
