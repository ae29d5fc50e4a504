//! What is to be reached.

use crate::error::positive;
use crate::quantity::Dimension;
use crate::{Contact, Error, Problem};

/// A quantity of the answer with the value it is to have, in the units of the problem.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Goal {
    /// The largest pressure (Pa), positive.
    PeakPressure(f64),
    /// The width of all zones of contact together (m), positive.
    ContactWidth(f64),
    /// The settlement in its gauge (m), of either sign.
    Settlement(f64),
}

impl Goal {
    /// The value wanted.
    #[must_use]
    pub fn wanted(self) -> f64 {
        match self {
            Self::PeakPressure(value) | Self::ContactWidth(value) | Self::Settlement(value) => {
                value
            }
        }
    }

    /// The value that a contact has.
    #[must_use]
    pub fn of(self, contact: &Contact) -> f64 {
        match self {
            Self::PeakPressure(_) => contact.peak_pressure(),
            Self::ContactWidth(_) => contact.contact_width(),
            Self::Settlement(_) => contact.settlement(),
        }
    }

    /// Name in words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::PeakPressure(_) => "peak pressure",
            Self::ContactWidth(_) => "contact width",
            Self::Settlement(_) => "settlement",
        }
    }

    /// Name as a key.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::PeakPressure(_) => "peak_pressure",
            Self::ContactWidth(_) => "contact_width",
            Self::Settlement(_) => "settlement",
        }
    }

    /// What it measures, in a problem in SI units.
    #[must_use]
    pub fn dimension(self) -> Dimension {
        match self {
            Self::PeakPressure(_) => Dimension::PRESSURE,
            Self::ContactWidth(_) | Self::Settlement(_) => Dimension::LENGTH,
        }
    }

    /// What it measures in this problem.
    pub(super) fn dimension_in(self, problem: &Problem) -> Dimension {
        if problem.bodies().scaling().is_some() { self.dimension() } else { Dimension::NONE }
    }

    pub(super) fn check(self) -> Result<(), Error> {
        match self {
            Self::PeakPressure(value) => positive("peak pressure", value)?,
            Self::ContactWidth(value) => positive("contact width", value)?,
            Self::Settlement(value) => crate::error::finite("settlement", value)?,
        };
        Ok(())
    }
}
