//! Quantities with units: `5 mm`, `200GPa`, `0.1 µm/MPa`, `1 MN/m`.
//!
//! [`parse`] reads a number with a unit into SI, [`Quantity::expect`] checks what it measures, and
//! [`engineering`] writes SI values for people. A number without a unit is in SI units whatever is
//! expected.
//!
//! ```
//! use shtaerman_input::quantity::{Dimension, engineering, parse};
//!
//! let half_width = parse("5 mm")?.expect(Dimension::LENGTH, "half_width", "5 mm")?;
//! assert_eq!(half_width, 0.005);
//! assert_eq!(engineering(3.1234e-6, Dimension::LENGTH), "3.1234 µm");
//!
//! let wrong = parse("5 Pa")?.expect(Dimension::LENGTH, "half_width", "5 Pa");
//! assert_eq!(
//!     wrong.unwrap_err().to_string(),
//!     "half_width is a length (like \"5 mm\"), got Pa, a pressure",
//! );
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Units
//!
//! | what | units |
//! |---|---|
//! | length | `m`, `in`, `ft`, `yd`, `mil` = `thou`, `uin` |
//! | force | `N`, `dyn`, `kgf`, `lbf`, `ozf`, `kip` |
//! | pressure | `Pa`, `bar`, `atm`, `psi`, `ksi`, `Msi`, `psf` |
//! | mass, time, energy | `g`, `t` (1000 kg), `s`, `J` |
//! | angle | `rad`, `deg` = `°` |
//!
//! SI prefixes `p n u µ m c k M G T` go with `m`, `Pa`, `N`, `g`, `s`, `J` and `bar`, besides `dm`
//! and `hPa`; `rad` takes `n u µ m`.

mod dimension;
mod error;
mod format;
mod number;
mod parse;
#[cfg(test)]
mod tests;
mod units;

use std::ops::Range;

pub use dimension::Dimension;
pub use error::{QuantityError, QuantityErrorKind};
pub use format::{AxisUnit, DisplayUnit, axis_unit, engineering, engineering_with_digits};
pub use parse::parse;

/// The longest text that [`parse`] reads, in bytes.
pub const MAXIMUM_LENGTH: usize = 256;

/// The greatest power of a unit, up or down.
pub const MAXIMUM_POWER: u8 = 9;

/// A value in SI units with its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// The value in SI units; finite.
    pub value: f64,
    /// The dimension of the unit; [`Dimension::NONE`] when no unit was written.
    pub dimension: Dimension,
    unit: Option<(usize, usize)>,
}

/// A quantity of the wrong dimension for the field it was meant for.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{field} {error}")]
pub struct FieldError {
    /// The field the quantity was meant for.
    pub field: String,
    /// What was wrong with it.
    #[source]
    pub error: QuantityError,
}

impl Quantity {
    /// A bare number, in SI units whatever is expected.
    #[must_use]
    pub const fn bare(value: f64) -> Self {
        Self { value, dimension: Dimension::NONE, unit: None }
    }

    /// Whether a unit was written. Without one the value counts as SI of any dimension.
    #[must_use]
    pub const fn unit_written(&self) -> bool {
        self.unit.is_some()
    }

    /// Where the unit stands in the text that was parsed, in bytes.
    #[must_use]
    pub fn unit_span(&self) -> Option<Range<usize>> {
        self.unit.map(|(start, end)| start..end)
    }

    /// The SI value, provided that no unit was written or that it has the dimension `expected`.
    /// `text` is what was parsed, for the message.
    ///
    /// # Errors
    /// [`QuantityErrorKind::WrongDimension`] naming both dimensions and an example of the right one.
    pub fn of(&self, expected: Dimension, text: &str) -> Result<f64, QuantityError> {
        let Some(span) = self.unit_span().filter(|_| self.dimension != expected) else {
            return Ok(self.value);
        };
        let unit = text.get(span.clone()).map_or_else(|| self.dimension.unit(), str::to_owned);
        let kind = QuantityErrorKind::WrongDimension { expected, got: self.dimension, unit };
        Err(QuantityError::new(kind, span))
    }

    /// As [`Quantity::of`], for the field named `field`.
    ///
    /// # Errors
    /// As [`Quantity::of`]; the message begins with the name of the field.
    pub fn expect(&self, expected: Dimension, field: &str, text: &str) -> Result<f64, FieldError> {
        self.of(expected, text).map_err(|error| FieldError { field: field.to_owned(), error })
    }
}
