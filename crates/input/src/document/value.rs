//! The tree of values, each with its origin.

use std::collections::BTreeMap;
use std::sync::Arc;

use toml::Spanned;
use toml::de::{DeFloat, DeInteger, DeTable, DeValue};

use super::error::{FileError, LONGEST_QUOTE};
use super::source::{Origin, Source};
use crate::shortened;

/// Tables within tables and arrays within arrays go no deeper than this.
pub const MAXIMUM_DEPTH: usize = 32;

/// A value with the place where it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    pub(super) kind: ValueKind,
    pub(super) origin: Origin,
}

/// What a value can be. Numbers are finite.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ValueKind {
    /// A string.
    String(String),
    /// A whole number.
    Integer(i64),
    /// A finite number with a point or an exponent.
    Float(f64),
    /// `true` or `false`.
    Boolean(bool),
    /// A date or a time, as it was written.
    Datetime(String),
    /// An array.
    Array(Vec<Value>),
    /// A table.
    Table(Table),
}

/// A table: keys with their values.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    pub(super) entries: BTreeMap<String, Entry>,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Entry {
    /// Where the key was written.
    pub(super) key: Origin,
    pub(super) value: Value,
}

impl Value {
    /// What the value is.
    #[must_use]
    pub fn kind(&self) -> &ValueKind {
        &self.kind
    }

    /// Where it was written.
    #[must_use]
    pub fn origin(&self) -> &Origin {
        &self.origin
    }

    /// What the value is, for messages: `the string "5 mm"`, `the number 7`, `a table`.
    #[must_use]
    pub fn description(&self) -> String {
        match &self.kind {
            ValueKind::String(text) => format!("the string \"{}\"", shortened(text, LONGEST_QUOTE)),
            ValueKind::Integer(value) => format!("the number {value}"),
            ValueKind::Float(value) => format!("the number {value:?}"),
            ValueKind::Boolean(value) => format!("{value}"),
            ValueKind::Datetime(text) => format!("the date {text}"),
            ValueKind::Array(_) => "an array".to_owned(),
            ValueKind::Table(_) => "a table".to_owned(),
        }
    }
}

impl Table {
    /// The value of a key.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Value> {
        self.entries.get(key).map(|entry| &entry.value)
    }

    /// The keys, in alphabetical order.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.entries.keys().map(String::as_str)
    }

    /// Whether the table has no keys.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }
}

/// Copies what the parser of TOML gave into our tree, and refuses what no problem can use.
pub(super) struct Conversion<'a> {
    pub(super) source: &'a Arc<Source>,
    /// Added to spans, for a value that stands behind the key of an override.
    pub(super) offset: usize,
}

impl Conversion<'_> {
    fn origin(&self, span: std::ops::Range<usize>) -> Origin {
        Origin::new(self.source, span.start + self.offset..span.end + self.offset)
    }

    pub(super) fn table(
        &self,
        table: &DeTable<'_>,
        path: &str,
        depth: usize,
    ) -> Result<Table, FileError> {
        let mut entries = BTreeMap::new();
        for (key, value) in table {
            let field = dotted(path, key.get_ref());
            let value = self.value(value, &field, depth + 1)?;
            let key_origin = self.origin(key.span());
            entries.insert(key.get_ref().to_string(), Entry { key: key_origin, value });
        }
        Ok(Table { entries })
    }

    pub(super) fn value(
        &self,
        value: &Spanned<DeValue<'_>>,
        field: &str,
        depth: usize,
    ) -> Result<Value, FileError> {
        let origin = self.origin(value.span());
        let fail = |message: String| Err(FileError::new(message).of_field(field).at(&origin));
        if depth > MAXIMUM_DEPTH {
            return fail(format!("is nested more than {MAXIMUM_DEPTH} levels deep"));
        }
        let kind = match value.get_ref() {
            DeValue::String(text) => ValueKind::String(text.to_string()),
            DeValue::Boolean(value) => ValueKind::Boolean(*value),
            DeValue::Datetime(value) => ValueKind::Datetime(value.to_string()),
            DeValue::Integer(written) => match whole_number(written) {
                Some(value) => ValueKind::Integer(value),
                None => {
                    return fail(format!(
                        "is {}, beyond 64-bit whole numbers",
                        shortened(written.as_str(), LONGEST_QUOTE)
                    ));
                }
            },
            DeValue::Float(written) => match finite_number(written) {
                Ok(value) => ValueKind::Float(value),
                Err(message) => return fail(message),
            },
            DeValue::Array(items) => {
                let items = items
                    .iter()
                    .enumerate()
                    .map(|(index, item)| self.value(item, &format!("{field}[{index}]"), depth + 1));
                ValueKind::Array(items.collect::<Result<_, _>>()?)
            }
            DeValue::Table(table) => ValueKind::Table(self.table(table, field, depth)?),
        };
        Ok(Value { kind, origin })
    }
}

fn whole_number(written: &DeInteger<'_>) -> Option<i64> {
    i64::from_str_radix(written.as_str(), written.radix()).ok()
}

fn finite_number(written: &DeFloat<'_>) -> Result<f64, String> {
    let text = written.as_str();
    let value: f64 = text.parse().map_err(|_| format!("is {text}, which is no number"))?;
    if value.is_finite() {
        Ok(value)
    } else if text.contains("inf") || text.contains("nan") {
        Err(format!("is {text}, a finite number was expected"))
    } else {
        Err(format!("is {}, beyond 64-bit floats (1.8e308)", shortened(text, LONGEST_QUOTE)))
    }
}

/// The dotted name of a key in the table `path`.
pub(super) fn dotted(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}
