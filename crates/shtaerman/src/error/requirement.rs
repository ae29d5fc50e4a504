//! What is required of a quantity.

use super::Error;

/// Refuses a value that is not finite and positive.
pub(crate) fn positive(field: &'static str, value: f64) -> Result<f64, Error> {
    require(value.is_finite() && value > 0.0, field, value, "finite and greater than zero")
}

/// Refuses a value that is not finite.
pub(crate) fn finite(field: &'static str, value: f64) -> Result<f64, Error> {
    require(value.is_finite(), field, value, "finite")
}

/// The value, or the error that says what would be right.
pub(crate) fn require(
    holds: bool,
    field: &'static str,
    value: f64,
    requirement: &'static str,
) -> Result<f64, Error> {
    if holds { Ok(value) } else { Err(Error::InvalidValue { field, value, requirement }) }
}
