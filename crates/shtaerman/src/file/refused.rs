//! Values that a constructor refused, as faults of their fields.

use crate::Error;
use crate::document::{Field, FileError};
use crate::quantity::{Dimension, engineering, plain};

/// The fault of a field whose value a constructor refused.
pub(super) fn refused(field: &Field<'_>, error: &Error) -> FileError {
    match error {
        Error::InvalidValue { field: name, value, requirement } if field.name().ends_with(name) => {
            field.error(format!("is {}: must be {requirement}", shown(name, *value)))
        }
        other => field.error(other),
    }
}

/// A value as people write it, in the unit of the key.
pub(super) fn shown(key: &str, value: f64) -> String {
    match key {
        "young_modulus" | "grading_modulus" | "yield_stress" | "pressure" => {
            engineering(value, Dimension::PRESSURE)
        }
        "half_width" => engineering(value, Dimension::LENGTH),
        "roughness" => engineering(value, Dimension::COMPLIANCE),
        "subgrade_modulus" => engineering(value, Dimension::SUBGRADE_MODULUS),
        _ => plain(value),
    }
}
