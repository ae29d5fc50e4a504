//! Problem files: TOML with the place of every value, and overrides of it.
//!
//! A [`Document`] is a TOML file read into a tree that remembers where each value was written, so
//! that a fault found much later can still point at its line. [`Document::set`] overrides values by
//! dotted keys (`--set load.force="1 MN/m"`). A [`TableReader`] takes values out by type, records
//! which keys were asked for and at the end reports those that nobody knows. All faults are one
//! type, [`FileError`].
//!
//! ```
//! use shtaerman_input::document::Document;
//! use shtaerman_input::quantity::Dimension;
//!
//! let text = r#"
//! [punch]
//! half_width = "5 mm"
//! profile = "flat"
//! [load]
//! force = "1 MN/m"
//! "#;
//! let mut document = Document::parse(text, "punch.toml")?;
//! document.set("load.force", "2 MN/m")?;
//!
//! let root = document.reader();
//! let punch = root.required("punch")?.table()?;
//! assert_eq!(punch.required("half_width")?.quantity(Dimension::LENGTH)?, 0.005);
//! assert_eq!(punch.required("profile")?.one_of(&["flat", "parabola"])?, "flat");
//! assert_eq!(punch.quantity("radius", Dimension::LENGTH)?, None);
//! let load = root.required("load")?.table()?;
//! assert_eq!(load.quantity("force", Dimension::FORCE_PER_LENGTH)?, Some(2e6));
//! root.finish()?;
//!
//! let wrong = Document::parse("[punch]\nhalf_width = \"5 Pa\"\n", "punch.toml")?;
//! let punch = wrong.reader().required("punch")?.table()?;
//! let error = punch.quantity("half_width", Dimension::LENGTH).unwrap_err();
//! assert_eq!(
//!     error.to_string(),
//!     "punch.toml:2: punch.half_width: is a length (like \"5 mm\"), got Pa, a pressure",
//! );
//! assert_eq!(error.source_text().unwrap().get(error.span().unwrap()), Some("Pa"));
//! # Ok::<(), shtaerman_input::document::FileError>(())
//! ```

mod bytes;
mod error;
mod field;
mod guard;
mod overrides;
mod reader;
mod source;
#[cfg(test)]
mod tests;
mod value;
mod vocabulary;

use std::sync::Arc;

use toml::de::DeTable;

pub use bytes::{load_bytes, overridden};
pub use error::FileError;
pub use field::Field;
pub use guard::{MAXIMUM_KEY_PARTS, MAXIMUM_TOKENS};
pub use reader::TableReader;
pub use source::Origin;
pub use value::{MAXIMUM_DEPTH, Table, Value, ValueKind};

use source::{BYTE_ORDER_MARK, Source};
use value::Conversion;

/// The largest file that is read, in bytes (200 MB).
pub const MAXIMUM_BYTES: usize = 200_000_000;

/// A TOML document with the origin of each value.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    source: Arc<Source>,
    root: Table,
}

impl Document {
    /// A document without keys and without a file, to be filled by [`Document::set`].
    #[must_use]
    pub fn empty() -> Self {
        let source = Source::File { name: None, text: String::new() };
        Self { source: Arc::new(source), root: Table::default() }
    }

    /// Reads a document from the bytes of a file.
    ///
    /// # Errors
    /// As [`Document::parse`], and if the bytes are not UTF-8.
    pub fn from_bytes(bytes: &[u8], file_name: &str) -> Result<Self, FileError> {
        check_size(bytes.len()).map_err(|error| error.in_file(Some(file_name)))?;
        let text = std::str::from_utf8(bytes).map_err(|error| not_utf8(bytes, error, file_name))?;
        Self::parse(text, file_name)
    }

    /// Reads a document from text; `file_name` is for messages alone.
    ///
    /// # Errors
    /// If the text is longer than [`MAXIMUM_BYTES`], has more tokens than [`MAXIMUM_TOKENS`] or no keys, is no TOML, nests deeper than
    /// [`MAXIMUM_DEPTH`], has keys of more than [`MAXIMUM_KEY_PARTS`] parts, or holds a number that
    /// is not finite.
    pub fn parse(text: &str, file_name: &str) -> Result<Self, FileError> {
        let in_file = |error: FileError| error.in_file(Some(file_name));
        check_size(text.len()).map_err(in_file)?;
        if text.trim_start_matches(BYTE_ORDER_MARK).trim().is_empty() {
            return Err(in_file(FileError::new("the file is empty")));
        }
        let name = Some(file_name.to_owned());
        let source = Arc::new(Source::File { name, text: text.to_owned() });
        guard::check_text(&source, text, 0)?;
        let table = DeTable::parse(text).map_err(|error| not_toml(&source, &error))?;
        let conversion = Conversion { source: &source, offset: 0 };
        let root = conversion.table(table.get_ref(), "", 0)?;
        if root.is_empty() {
            return Err(in_file(FileError::new("the file has comments but no keys")));
        }
        Ok(Self { source, root })
    }

    /// The name of the file, if the document came from one.
    #[must_use]
    pub fn file_name(&self) -> Option<&str> {
        match &*self.source {
            Source::File { name, .. } => name.as_deref(),
            Source::Override { .. } => None,
        }
    }

    /// The text of the file, without overrides.
    #[must_use]
    pub fn source_text(&self) -> &str {
        self.source.text()
    }

    /// The table at the top, overrides included.
    #[must_use]
    pub fn root(&self) -> &Table {
        &self.root
    }

    /// The value at a dotted key, such as `load.force`.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Value> {
        let (path, last) =
            key.rsplit_once('.').map_or((None, key), |(path, last)| (Some(path), last));
        let mut table = &self.root;
        for part in path.into_iter().flat_map(|path| path.split('.')) {
            let ValueKind::Table(inner) = table.get(part.trim())?.kind() else { return None };
            table = inner;
        }
        table.get(last.trim())
    }

    /// A reader of the table at the top.
    #[must_use]
    pub fn reader(&self) -> TableReader<'_> {
        TableReader::of_root(self)
    }
}

fn check_size(bytes: usize) -> Result<(), FileError> {
    if bytes <= MAXIMUM_BYTES {
        return Ok(());
    }
    let message =
        format!("the file has {bytes} bytes, more than the {MAXIMUM_BYTES} that are read");
    Err(FileError::new(message).with_help("keep long tables of numbers in a CSV file"))
}

fn not_utf8(bytes: &[u8], error: std::str::Utf8Error, file_name: &str) -> FileError {
    let at = error.valid_up_to();
    let before = bytes.get(..at).unwrap_or_default();
    let line = before.iter().filter(|byte| **byte == b'\n').count() + 1;
    let byte = bytes.get(at).copied().unwrap_or_default();
    let message = format!("the file is not UTF-8: byte 0x{byte:02x} at offset {at}, line {line}");
    let fault = FileError::new(message).in_file(Some(file_name));
    let utf16 = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
    if utf16 { fault.with_help("it looks like UTF-16, save it as UTF-8") } else { fault }
}

fn not_toml(source: &Arc<Source>, error: &toml::de::Error) -> FileError {
    let message = format!("is not valid TOML: {}", error.message().replace(['\n', '\r'], " "));
    let end = source.text().len();
    let span = error.span().unwrap_or(end..end);
    FileError::new(message).at(&Origin::new(source, span))
}
