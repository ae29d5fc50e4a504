//! A quantity: its value in SI units and its dimension.

use std::ops::Range;

use super::dimension::Dimension;
use super::error::{QuantityError, QuantityErrorKind};

/// A value in SI units with its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// The value in SI units; finite.
    pub value: f64,
    /// The dimension of the unit; [`Dimension::NONE`] when no unit was written.
    pub dimension: Dimension,
    pub(super) unit: Option<(usize, usize)>,
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
