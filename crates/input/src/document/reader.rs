//! Typed reading of a table, which knows what nobody asked for.

use std::cell::RefCell;
use std::rc::Rc;

use super::Document;
use super::error::FileError;
use super::field::Field;
use super::source::Origin;
use super::value::{Entry, Table, Value, ValueKind, dotted};
use super::vocabulary::{Vocabulary, titled};
use crate::nearest;
use crate::quantity::Dimension;

/// A reader of one table of a document.
///
/// [`TableReader::required`] and [`TableReader::optional`] give a [`Field`] to be read by type; the
/// getters by type are short for optional fields. Readers of one document share a record of the
/// keys that were asked for, so one [`TableReader::finish`] on the reader of the top reports the
/// unknown keys of all tables.
#[derive(Debug, Clone)]
pub struct TableReader<'d> {
    document: &'d Document,
    path: String,
    table: &'d Table,
    /// None for the table at the top, which is written nowhere in particular.
    origin: Option<&'d Origin>,
    vocabulary: Rc<RefCell<Vocabulary>>,
}

impl<'d> TableReader<'d> {
    pub(super) fn of_root(document: &'d Document) -> Self {
        let vocabulary = Rc::new(RefCell::new(Vocabulary::default()));
        vocabulary.borrow_mut().begin("");
        Self { document, path: String::new(), table: document.root(), origin: None, vocabulary }
    }

    pub(super) fn new(field: &Field<'d>, table: &'d Table) -> Self {
        field.vocabulary.borrow_mut().begin(&field.name);
        Self {
            document: field.document,
            path: field.name.clone(),
            table,
            origin: Some(field.origin()),
            vocabulary: Rc::clone(&field.vocabulary),
        }
    }

    /// The dotted name of this table; empty at the top.
    #[must_use]
    pub fn path(&self) -> &str {
        &self.path
    }

    /// Whether the key is written; asks for it.
    #[must_use]
    pub fn has(&self, key: &str) -> bool {
        self.optional(key).is_some()
    }

    /// The field of a key, if it is written.
    #[must_use]
    pub fn optional(&self, key: &str) -> Option<Field<'d>> {
        self.vocabulary.borrow_mut().ask(&self.path, key);
        let value = self.table.get(key)?;
        Some(Field {
            document: self.document,
            name: dotted(&self.path, key),
            value,
            vocabulary: Rc::clone(&self.vocabulary),
        })
    }

    /// The field of a key.
    ///
    /// # Errors
    /// If the key is not written; the help names a key that was perhaps written instead of it.
    pub fn required(&self, key: &str) -> Result<Field<'d>, FileError> {
        self.optional(key).ok_or_else(|| self.missing(key))
    }

    /// The one field that is written of keys that exclude each other.
    ///
    /// # Errors
    /// If none of them is written, or several are.
    pub fn exactly_one(&self, keys: &[&str]) -> Result<Field<'d>, FileError> {
        self.at_most_one(keys)?.ok_or_else(|| {
            let message = format!("{} is missing in {}", keys.join(" or "), titled(&self.path));
            let fault = FileError::new(message);
            keys.iter()
                .find_map(|key| self.perhaps_written(key, fault.clone()))
                .unwrap_or_else(|| self.located(fault))
        })
    }

    /// The one field, if any, that is written of keys that exclude each other.
    ///
    /// # Errors
    /// If several are written.
    pub fn at_most_one(&self, keys: &[&str]) -> Result<Option<Field<'d>>, FileError> {
        let mut written = keys.iter().filter_map(|key| self.optional(key)).collect::<Vec<_>>();
        if let [first, second, ..] = written.as_slice() {
            let message = format!("is written besides {}, one of them is allowed", first.name());
            return Err(second.error(message).with_help(format!("write {}", keys.join(" or "))));
        }
        Ok(written.pop())
    }

    /// The string at an optional key.
    ///
    /// # Errors
    /// As [`Field::string`].
    pub fn string(&self, key: &str) -> Result<Option<&'d str>, FileError> {
        self.optional(key).map(|field| field.string()).transpose()
    }

    /// The number at an optional key.
    ///
    /// # Errors
    /// As [`Field::number`].
    pub fn number(&self, key: &str) -> Result<Option<f64>, FileError> {
        self.optional(key).map(|field| field.number()).transpose()
    }

    /// The whole number at an optional key.
    ///
    /// # Errors
    /// As [`Field::integer`].
    pub fn integer(&self, key: &str) -> Result<Option<i64>, FileError> {
        self.optional(key).map(|field| field.integer()).transpose()
    }

    /// The truth value at an optional key.
    ///
    /// # Errors
    /// As [`Field::boolean`].
    pub fn boolean(&self, key: &str) -> Result<Option<bool>, FileError> {
        self.optional(key).map(|field| field.boolean()).transpose()
    }

    /// The quantity at an optional key, in SI units.
    ///
    /// # Errors
    /// As [`Field::quantity`].
    pub fn quantity(&self, key: &str, expected: Dimension) -> Result<Option<f64>, FileError> {
        self.optional(key).map(|field| field.quantity(expected)).transpose()
    }

    /// A reader of the table at an optional key.
    ///
    /// # Errors
    /// As [`Field::table`].
    pub fn table(&self, key: &str) -> Result<Option<Self>, FileError> {
        self.optional(key).map(|field| field.table()).transpose()
    }

    /// A fault of this table as a whole, at its heading.
    #[must_use]
    pub fn error(&self, message: impl std::fmt::Display) -> FileError {
        self.located(FileError::new(message.to_string()).of_field(self.path.as_str()))
    }

    /// Reports the first key, in the order of the file, that no reader asked for, in this table or
    /// in a table inside it that a reader was made for.
    ///
    /// # Errors
    /// If there is such a key. The message proposes a near key of the same table, names the table
    /// where the key would be right, or the help lists the keys of the table.
    pub fn finish(&self) -> Result<(), FileError> {
        let mut strangers = Vec::new();
        self.collect(&self.path, self.table, &mut strangers);
        strangers.sort_by_key(|stranger| {
            (stranger.entry.key.is_override(), stranger.entry.key.span().start)
        });
        let Some((first, rest)) = strangers.split_first() else { return Ok(()) };
        let (message, help) = self.vocabulary.borrow().unknown(&first.table, first.key);
        let fault =
            FileError::new(message).of_field(dotted(&first.table, first.key)).at(&first.entry.key);
        let others: Vec<String> =
            rest.iter().take(8).map(|other| dotted(&other.table, other.key)).collect();
        let others = (!others.is_empty()).then(|| format!("also unknown: {}", others.join(", ")));
        let help: Vec<String> = help.into_iter().chain(others).collect();
        Err(if help.is_empty() { fault } else { fault.with_help(help.join("; ")) })
    }

    fn collect(&self, path: &str, table: &'d Table, strangers: &mut Vec<Stranger<'d>>) {
        let read = self.vocabulary.borrow().is_read(path);
        for (key, entry) in &table.entries {
            if read && !self.vocabulary.borrow().knows(path, key) {
                strangers.push(Stranger { table: path.to_owned(), key, entry });
            } else {
                self.collect_inside(&dotted(path, key), &entry.value, strangers);
            }
        }
    }

    fn collect_inside(&self, path: &str, value: &'d Value, strangers: &mut Vec<Stranger<'d>>) {
        match value.kind() {
            ValueKind::Table(table) => self.collect(path, table, strangers),
            ValueKind::Array(items) => {
                for (index, item) in items.iter().enumerate() {
                    if matches!(item.kind(), ValueKind::Table(_) | ValueKind::Array(_)) {
                        self.collect_inside(&format!("{path}[{index}]"), item, strangers);
                    }
                }
            }
            _ => {}
        }
    }

    fn missing(&self, key: &str) -> FileError {
        let fault = FileError::new("is missing").of_field(dotted(&self.path, key));
        if let Some(told) = self.perhaps_written(key, fault.clone()) {
            return told;
        }
        match self.elsewhere(key) {
            Some((table, entry)) => {
                let help = format!("move it from {} to {}", titled(&table), titled(&self.path));
                let message = format!("is missing, and {key} is written in {}", titled(&table));
                let fault = FileError::new(message).of_field(dotted(&self.path, key));
                fault.at(&entry.key).with_help(help)
            }
            None => self.located(fault),
        }
    }

    /// The fault that a key is missing, at one that was perhaps written instead of it, if there is one.
    fn perhaps_written(&self, key: &str, fault: FileError) -> Option<FileError> {
        let vocabulary = self.vocabulary.borrow();
        let unread = |name: &&str| !vocabulary.knows(&self.path, name);
        let written = nearest(key, self.table.keys().filter(unread))?;
        let fault = fault.with_help(format!("{written} is written, did you mean {key}?"));
        Some(match self.table.entries.get(written) {
            Some(entry) => fault.at(&entry.key),
            None => self.located(fault),
        })
    }

    /// The table at the top, or one of its tables, that has `key` though nobody asked for it there.
    ///
    /// Only tables whose keys are known by now count: of others nobody can tell that the key is a
    /// stranger to them.
    fn elsewhere(&self, key: &str) -> Option<(String, &'d Entry)> {
        let vocabulary = self.vocabulary.borrow();
        let root = self.document.root();
        let top = std::iter::once((String::new(), root));
        let tables = root.entries.iter().filter_map(|(name, entry)| match entry.value.kind() {
            ValueKind::Table(table) => Some((name.clone(), table)),
            _ => None,
        });
        let stranger = |name: &str| vocabulary.is_described(name) && !vocabulary.knows(name, key);
        top.chain(tables)
            .filter(|(name, _)| stranger(name))
            .find_map(|(name, table)| table.entries.get(key).map(|entry| (name, entry)))
    }

    fn located(&self, fault: FileError) -> FileError {
        match self.origin {
            Some(origin) => fault.at(origin),
            None => fault.in_file(self.document.file_name()),
        }
    }
}

/// A key that nobody asked for.
struct Stranger<'d> {
    table: String,
    key: &'d str,
    entry: &'d Entry,
}
