//! What is prescribed: one of each pair.

use serde::{Deserialize, Serialize};

use crate::Error;
use crate::error::{finite, require};

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

    /// Refuses what no pressure on a base of this half-width can balance: a force that lifts the punch off, and one that tips it over.
    pub(crate) fn check_balance(&self, half_width: f64) -> Result<(), Error> {
        if let Vertical::Force(force) = self.vertical {
            let requirement = "greater than zero in unilateral contact: a pull lifts the punch off";
            require(force > 0.0, "force", force, requirement)?;
            let limit = force * half_width;
            if let Rotational::Moment(value) = self.rotational
                && value.abs() >= limit
            {
                return Err(Error::TipsOver { field: "moment", value, limit, name: "P a" });
            }
        }
        match self.rotational {
            Rotational::Eccentricity(value) if value.abs() >= half_width => {
                let (field, name) = ("eccentricity", "a");
                Err(Error::TipsOver { field, value, limit: half_width, name })
            }
            _ => Ok(()),
        }
    }

    /// Whether prescribed displacements leave a base with these samples `(xi, f0)` clear of the body.
    pub(crate) fn keeps_clear<'s>(
        &self,
        mut samples: impl Iterator<Item = &'s (f64, f64)>,
    ) -> bool {
        let Vertical::Settlement(settlement) = self.vertical else { return false };
        match self.rotational {
            Rotational::Tilt(tilt) => samples.all(|(xi, height)| settlement - tilt * xi <= *height),
            Rotational::Moment(moment) if moment != 0.0 => false,
            Rotational::Moment(_) | Rotational::Eccentricity(_) => {
                // Without contact there is no moment: is there a tilt that keeps clear?
                let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
                for &(xi, height) in samples {
                    if xi > 0.0 {
                        least = least.max((settlement - height) / xi);
                    } else if xi < 0.0 {
                        most = most.min((height - settlement) / -xi);
                    } else if settlement > height {
                        return false;
                    }
                }
                least <= most
            }
        }
    }
}
