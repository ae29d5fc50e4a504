//! One value with its dotted name, read by type.

use std::cell::RefCell;
use std::fmt::Display;
use std::ops::Range;
use std::path::Path;
use std::rc::Rc;

use super::Document;
use super::error::FileError;
use super::load::load_bytes;
use super::reader::TableReader;
use super::source::Origin;
use super::value::{Value, ValueKind};
use super::vocabulary::Vocabulary;
use crate::nearest;
use crate::quantity::{self, Dimension, Quantity};

/// A value of a document, with its dotted name for messages.
#[derive(Debug, Clone)]
pub struct Field<'d> {
    pub(super) document: &'d Document,
    pub(super) name: String,
    pub(super) value: &'d Value,
    pub(super) vocabulary: Rc<RefCell<Vocabulary>>,
}

impl<'d> Field<'d> {
    /// The dotted name, such as `punch.half_width`.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The value as it was read.
    #[must_use]
    pub fn value(&self) -> &'d Value {
        self.value
    }

    /// Where the value was written.
    #[must_use]
    pub fn origin(&self) -> &'d Origin {
        self.value.origin()
    }

    /// A fault of this field. The message reads on after the name: `is not positive: -3`.
    #[must_use]
    pub fn error(&self, message: impl Display) -> FileError {
        FileError::new(message.to_string()).of_field(self.name.as_str()).at(self.origin())
    }

    /// A fault of bytes `inner` of this field's string, such as of an expression.
    #[must_use]
    pub fn error_within(&self, message: impl Display, inner: Range<usize>) -> FileError {
        let fault = self.error(message);
        match self.value.kind() {
            ValueKind::String(text) => fault.within(text, inner),
            _ => fault,
        }
    }

    fn mismatch(&self, expected: &str) -> FileError {
        self.error(format!("is {expected}, got {}", self.value.description()))
    }

    /// The string.
    ///
    /// # Errors
    /// If the value is not a string.
    pub fn string(&self) -> Result<&'d str, FileError> {
        match self.value.kind() {
            ValueKind::String(text) => Ok(text),
            _ => Err(self.mismatch("a string (in quotes)")),
        }
    }

    /// The string, which must be one of `choices`.
    ///
    /// # Errors
    /// If the value is not a string or none of the choices; the message names them all.
    pub fn one_of<'c>(&self, choices: &[&'c str]) -> Result<&'c str, FileError> {
        let text = self.string()?;
        if let Some(choice) = choices.iter().find(|choice| **choice == text) {
            return Ok(choice);
        }
        let quoted: Vec<String> = choices.iter().map(|choice| format!("\"{choice}\"")).collect();
        let fault = self.mismatch(&format!("one of {}", quoted.join(", ")));
        Err(match nearest(text, choices.iter().copied()) {
            Some(choice) => fault.with_help(format!("did you mean \"{choice}\"?")),
            None => fault,
        })
    }

    /// The number, whole or not; finite.
    ///
    /// # Errors
    /// If the value is not a number.
    pub fn number(&self) -> Result<f64, FileError> {
        match self.value.kind() {
            ValueKind::Integer(value) => Ok(*value as f64),
            ValueKind::Float(value) => Ok(*value),
            _ => Err(self.unquoted(self.mismatch("a number"))),
        }
    }

    /// The whole number.
    ///
    /// # Errors
    /// If the value is not a whole number; `5.0` is none.
    pub fn integer(&self) -> Result<i64, FileError> {
        match self.value.kind() {
            ValueKind::Integer(value) => Ok(*value),
            _ => Err(self.unquoted(self.mismatch("a whole number"))),
        }
    }

    /// The number of things: a whole number within `range`.
    ///
    /// # Errors
    /// If the value is not a whole number or out of the range.
    pub fn count(&self, range: std::ops::RangeInclusive<usize>) -> Result<usize, FileError> {
        let value = self.integer()?;
        usize::try_from(value).ok().filter(|count| range.contains(count)).ok_or_else(|| {
            let (least, most) = range.into_inner();
            self.error(format!("is a whole number from {least} to {most}, got {value}"))
        })
    }

    /// A relative error that is asked for: a number between 0 and 1.
    ///
    /// # Errors
    /// If the value is no number or out of that range.
    pub fn tolerance(&self) -> Result<f64, FileError> {
        let value = self.number()?;
        if value > 0.0 && value < 1.0 {
            return Ok(value);
        }
        Err(self.error(format!("is {value}: must be greater than 0 and less than 1, like 1e-10")))
    }

    /// The truth value.
    ///
    /// # Errors
    /// If the value is neither `true` nor `false`.
    pub fn boolean(&self) -> Result<bool, FileError> {
        match self.value.kind() {
            ValueKind::Boolean(value) => Ok(*value),
            _ => Err(self.unquoted(self.mismatch("true or false"))),
        }
    }

    /// The value in SI units: a number counts as SI, a string is a number with a unit of the
    /// dimension `expected` (`"5 mm"`), or a number without a unit.
    ///
    /// # Errors
    /// If the value is neither, or the unit is unknown or of another dimension.
    pub fn quantity(&self, expected: Dimension) -> Result<f64, FileError> {
        self.written_quantity(expected).map(|quantity| quantity.value)
    }

    /// As [`Field::quantity`], with the dimension that was written.
    ///
    /// # Errors
    /// As [`Field::quantity`].
    pub fn written_quantity(&self, expected: Dimension) -> Result<Quantity, FileError> {
        let text = match self.value.kind() {
            ValueKind::Integer(value) => return Ok(Quantity::bare(*value as f64)),
            ValueKind::Float(value) => return Ok(Quantity::bare(*value)),
            ValueKind::String(text) => text,
            _ => {
                let name = expected.name().map_or_else(|| expected.to_string(), str::to_owned);
                return Err(self.mismatch(&format!("{name} (like {})", expected.example())));
            }
        };
        let read = quantity::parse(text)
            .and_then(|quantity| quantity.of(expected, text).map(|_| quantity));
        read.map_err(|error| {
            FileError::from_quantity(&error)
                .of_field(self.name.as_str())
                .at(self.origin())
                .within(text, error.span())
        })
    }

    /// The items of an array, named `field[0]`, `field(1)` and so on.
    ///
    /// # Errors
    /// If the value is not an array.
    pub fn items(&self) -> Result<Vec<Self>, FileError> {
        let ValueKind::Array(items) = self.value.kind() else {
            return Err(self.mismatch("an array (in square brackets)"));
        };
        let item = |(index, value)| Self {
            name: format!("{}[{index}]", self.name),
            value,
            ..self.clone()
        };
        Ok(items.iter().enumerate().map(item).collect())
    }

    /// A reader of the table.
    ///
    /// # Errors
    /// If the value is not a table.
    pub fn table(&self) -> Result<TableReader<'d>, FileError> {
        match self.value.kind() {
            ValueKind::Table(table) => Ok(TableReader::new(self, table)),
            _ => Err(self.mismatch(&format!("a table ([{}])", self.name))),
        }
    }

    /// The name and the bytes of the file that this string names: of those that are [attached](Document::with_attached), where the document has some, else relative to `folder`.
    ///
    /// # Errors
    /// If the value is no string, or the file cannot be read.
    pub fn load(&self, folder: &Path) -> Result<(String, Vec<u8>), FileError> {
        let name = self.string()?;
        if let Some(files) = &self.document.attached {
            return match files.get(name) {
                Some(bytes) => Ok((name.to_owned(), bytes.to_owned())),
                None => Err(self.error(format!("{name} is not there: give this file, too"))),
            };
        }
        let path = folder.join(name);
        let name = path.display().to_string();
        let bytes = load_bytes(&path).map_err(|message| self.error(format!("{name} {message}")))?;
        Ok((name, bytes))
    }

    /// Whether the value is a table, for fields that may be a table or something else.
    #[must_use]
    pub fn is_table(&self) -> bool {
        matches!(self.value.kind(), ValueKind::Table(_))
    }

    /// Whether the value is a string, for fields that may be a string or something else.
    #[must_use]
    pub fn is_string(&self) -> bool {
        matches!(self.value.kind(), ValueKind::String(_))
    }

    /// Advises to drop the quotes where the string inside them would do.
    fn unquoted(&self, fault: FileError) -> FileError {
        match self.value.kind() {
            ValueKind::String(text) if text.parse::<f64>().is_ok_and(f64::is_finite) => {
                fault.with_help(format!("write {text} without quotes"))
            }
            ValueKind::String(text) if text == "true" || text == "false" => {
                fault.with_help(format!("write {text} without quotes"))
            }
            _ => fault,
        }
    }
}
