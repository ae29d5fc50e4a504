//! Overrides of single values by dotted keys.

use std::sync::Arc;

use toml::de::DeValue;

use super::Document;
use super::error::FileError;
use super::guard::{self, MAXIMUM_KEY_PARTS};
use super::parsed::check_size;
use super::source::{Origin, Source};
use super::value::{Conversion, Entry, Table, Value, ValueKind};

impl Document {
    /// Overrides the value at a dotted key such as `load.force`.
    ///
    /// `text` is read as a TOML value if it is one (`5`, `true`, `"flat"`, `[1, 2]`), and is taken as
    /// a string otherwise (`1 MN/m`, `x^2/2`). Tables on the way are made; where a plain value stood
    /// (`punch.profile = "flat"` under `punch.profile.csv`) a table takes its place, and a plain value
    /// that of a table below the top. Key parts are bare: letters, digits, `_` and `-`.
    ///
    /// # Errors
    /// If the key is malformed, goes through an array, or names a table at the top while the value is
    /// none; if the value has a number that is not finite. The document is then unchanged.
    ///
    /// ```
    /// use shtaerman_input::document::Document;
    /// let mut document = Document::parse("[load]\nsettlement = 1e-6", "a.toml")?;
    /// document.set("load.force", "1 MN/m")?;
    /// document.prefer_overrides(&["load.force", "load.settlement"]);
    /// assert!(document.get("load.settlement").is_none());
    /// # Ok::<(), shtaerman_input::document::FileError>(())
    /// ```
    pub fn set(&mut self, key: &str, text: &str) -> Result<(), FileError> {
        check_size(key.len().saturating_add(text.len()))?;
        let source = Arc::new(Source::Override { text: format!("{key}={text}") });
        let parts = key_parts(&source, key)?;
        let value = override_value(&source, key, text, parts.len())?;
        let key_origin = Origin::new(&source, 0..key.len());
        insert(&mut self.root, &parts, key_origin, value)
    }

    /// Removes the value or table at a dotted key and returns it, if there was one.
    pub fn remove(&mut self, key: &str) -> Option<Value> {
        let mut parts: Vec<&str> = key.split('.').map(str::trim).collect();
        let last = parts.pop()?;
        let mut table = &mut self.root;
        for part in parts {
            let entry = table.entries.get_mut(part)?;
            let ValueKind::Table(inner) = &mut entry.value.kind else { return None };
            table = inner;
        }
        table.entries.remove(last).map(|entry| entry.value)
    }

    /// Of keys that exclude each other, removes those of the file if any is overridden.
    ///
    /// So `--set load.force=...` replaces a `load.settlement` of the file. Two overrides of the same
    /// group both stay, for the reader to refuse.
    pub fn prefer_overrides(&mut self, alternatives: &[&str]) {
        let overridden =
            |document: &Self, key: &str| document.get(key).is_some_and(Value::has_override);
        if alternatives.iter().any(|key| overridden(self, key)) {
            for key in alternatives {
                if !overridden(self, key) {
                    self.remove(key);
                }
            }
        }
    }
}

impl Value {
    /// Whether this value, or one inside it, came from an override.
    #[must_use]
    pub fn has_override(&self) -> bool {
        match &self.kind {
            ValueKind::Table(table) => {
                table.entries.values().any(|entry| entry.value.has_override())
                    || self.origin.is_override()
            }
            _ => self.origin.is_override(),
        }
    }
}

fn key_parts<'a>(source: &Arc<Source>, key: &'a str) -> Result<Vec<&'a str>, FileError> {
    let fail = |message: String, span| {
        let help = "write KEY=VALUE with a dotted key, as in load.force=1e6";
        Err(FileError::new(message).at(&Origin::new(source, span)).with_help(help))
    };
    let parts: Vec<&str> = key.split('.').map(str::trim).collect();
    if parts.len() > MAXIMUM_KEY_PARTS {
        let message = format!("has a key of more than {MAXIMUM_KEY_PARTS} parts between dots");
        return fail(message, 0..key.len());
    }
    for part in &parts {
        if part.is_empty() {
            return fail("has a key with nothing between its dots".to_owned(), 0..key.len());
        }
        let foreign = |sign: char| !(sign.is_ascii_alphanumeric() || sign == '_' || sign == '-');
        if let Some(sign) = part.chars().find(|sign| foreign(*sign)) {
            let message = format!("has a key with {sign:?}, letters, digits, _ and - are allowed");
            return fail(message, 0..key.len());
        }
    }
    Ok(parts)
}

fn override_value(
    source: &Arc<Source>,
    key: &str,
    text: &str,
    depth: usize,
) -> Result<Value, FileError> {
    let trimmed = text.trim();
    let start = key.len() + 1 + (text.len() - text.trim_start().len());
    if trimmed.is_empty() {
        let fault = FileError::new("has no value behind the =").of_field(key);
        return Err(fault.at(&Origin::new(source, start..start)));
    }
    guard::check_text(source, trimmed, start)?;
    match DeValue::parse(trimmed) {
        Ok(value) => Conversion { source, offset: start }.value(&value, key, depth),
        Err(_) => Ok(Value {
            kind: ValueKind::String(trimmed.to_owned()),
            origin: Origin::new(source, start..start + trimmed.len()),
        }),
    }
}

fn insert(
    root: &mut Table,
    parts: &[&str],
    key_origin: Origin,
    value: Value,
) -> Result<(), FileError> {
    let Some((last, path)) = parts.split_last() else { return Ok(()) };
    let mut table = root;
    for (index, part) in path.iter().enumerate() {
        let entry = table.entries.entry((*part).to_owned()).or_insert_with(|| Entry {
            key: key_origin.clone(),
            value: Value { kind: ValueKind::Table(Table::default()), origin: key_origin.clone() },
        });
        match &entry.value.kind {
            ValueKind::Table(_) => {}
            ValueKind::Array(_) => {
                let message = "is an array, whose items cannot be set one by one";
                let field = parts[..=index].join(".");
                return Err(FileError::new(message).of_field(field).at(&key_origin));
            }
            _ => {
                entry.key = key_origin.clone();
                entry.value.origin = key_origin.clone();
                entry.value.kind = ValueKind::Table(Table::default());
            }
        }
        let ValueKind::Table(inner) = &mut entry.value.kind else { return Ok(()) };
        table = inner;
    }
    // A table at the top is a section, and nothing else can be one; elsewhere whoever reads the key knows what it may be.
    if path.is_empty()
        && let Some(ValueKind::Table(old)) = table.get(last).map(Value::kind)
        && !matches!(value.kind, ValueKind::Table(_))
    {
        return Err(table_replaced(old, &parts.join("."), &value));
    }
    table.entries.insert((*last).to_owned(), Entry { key: key_origin, value });
    Ok(())
}

fn table_replaced(old: &Table, field: &str, value: &Value) -> FileError {
    let message = format!("is a table, got {}", value.description());
    let keys: Vec<String> = old.keys().map(|key| format!("{field}.{key}")).collect();
    let fault = FileError::new(message).of_field(field).at(&value.origin);
    if keys.is_empty() { fault } else { fault.with_help(format!("set {}", keys.join(" or "))) }
}
