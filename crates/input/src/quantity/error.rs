//! What can be wrong with a written quantity.

use std::ops::Range;

use super::dimension::Dimension;
use super::limits::{MAXIMUM_LENGTH, MAXIMUM_POWER};

/// A text that is not a quantity, or not the one that was asked for.
///
/// The message reads on after the name of a field: "`half_width` is a length (like "5 mm"), got Pa,
/// a pressure". [`QuantityError::span`] is the place in the text, in bytes, for a caret.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{kind}")]
pub struct QuantityError {
    kind: QuantityErrorKind,
    start: usize,
    end: usize,
}

impl QuantityError {
    pub(super) fn new(kind: QuantityErrorKind, span: Range<usize>) -> Self {
        Self { kind, start: span.start, end: span.end }
    }

    /// What was wrong.
    #[must_use]
    pub fn kind(&self) -> &QuantityErrorKind {
        &self.kind
    }

    /// Where in the text, in bytes; always on character boundaries and within the text.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        self.start..self.end
    }

    /// What to write instead, where that can be said.
    #[must_use]
    pub fn help(&self) -> Option<String> {
        match &self.kind {
            QuantityErrorKind::NoNumber => {
                Some("write the number before the unit, as in \"200 GPa\"".to_owned())
            }
            QuantityErrorKind::UnknownUnit { suggestion: None, .. } => {
                Some(format!("known units: {}", super::units::catalogue()))
            }
            _ => None,
        }
    }
}

/// The kinds of [`QuantityError`], with the values that were found.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum QuantityErrorKind {
    /// Nothing but spaces was written.
    #[error("is empty, a number with a unit was expected, such as \"5 mm\"")]
    Empty,
    /// More bytes than any quantity needs.
    #[error("is {0} bytes long, a quantity has at most {MAXIMUM_LENGTH}")]
    TooLong(usize),
    /// A unit, or something else, where the number should be.
    #[error("does not begin with a number")]
    NoNumber,
    /// `nan`, `inf` or a relative of theirs.
    #[error("is {0}, a finite number was expected")]
    NotFinite(String),
    /// A decimal comma, an underscore or a number in two pieces.
    #[error("has the number {written:?}, write {instead}")]
    NumberForm {
        /// The number as it was written.
        written: String,
        /// The number as it should be written.
        instead: String,
    },
    /// The value in SI units exceeds the range of a 64-bit float.
    #[error("is too large: in SI units it exceeds 1.8e308")]
    TooLarge,
    /// A number other than zero that a 64-bit float can only hold as zero.
    #[error("is too small: in SI units it is below 5e-324, yet not zero")]
    TooSmall,
    /// A unit that is not known.
    #[error("has the unknown unit {unit}{}", suggested(.suggestion.as_deref()))]
    UnknownUnit {
        /// The unit as it was written.
        unit: String,
        /// A unit that was perhaps meant.
        suggestion: Option<String>,
    },
    /// A number where a unit should be.
    #[error("has the number {0} where a unit was expected")]
    NumberInUnit(String),
    /// A unit with a digit behind it, such as `mm2`.
    #[error("has {unit}{digits}, write {unit}^{digits} for a power")]
    BareDigit {
        /// The unit before the digit.
        unit: String,
        /// The digits behind it.
        digits: String,
    },
    /// A sign that belongs to no unit.
    #[error("has {0:?}, which is no part of a unit")]
    UnknownCharacter(char),
    /// An operator at the end, or two of them in a row.
    #[error("has no unit after {0:?}")]
    UnitMissing(String),
    /// A parenthesis that is not closed, or was not opened.
    #[error("has a parenthesis without its partner")]
    Parenthesis,
    /// `^` without a whole number behind it.
    #[error("has a power that is not a whole number from -{limit} to {limit}, as in m^2 or m^-1", limit = MAXIMUM_POWER)]
    Power,
    /// A product by a space behind a division, which readers take in two ways.
    #[error("has the unit {written}, which can be read in two ways: write {grouped} or {chained}")]
    Ambiguous {
        /// The part as it was written.
        written: String,
        /// The reading that divides by both.
        grouped: String,
        /// The reading from left to right.
        chained: String,
    },
    /// Powers that no quantity has.
    #[error("has a unit whose powers are beyond any quantity")]
    PowerOverflow,
    /// A unit of another dimension than was asked for.
    #[error("is {}, got {unit}, {}", wanted(*.expected), found(*.got))]
    WrongDimension {
        /// The dimension that was asked for.
        expected: Dimension,
        /// The dimension of the unit.
        got: Dimension,
        /// The unit as it was written.
        unit: String,
    },
}

fn suggested(suggestion: Option<&str>) -> String {
    suggestion.map_or_else(String::new, |unit| format!(", did you mean {unit}?"))
}

fn wanted(expected: Dimension) -> String {
    match expected.name() {
        Some(name) => format!("{name} (like {})", expected.example()),
        None => format!("{expected} (like {})", expected.example()),
    }
}

fn found(got: Dimension) -> String {
    got.name().map_or_else(|| got.to_string(), str::to_owned)
}
