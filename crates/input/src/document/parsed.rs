//! A parsed document: its text, and the tree of its values with overrides.

use std::sync::Arc;

use toml::de::DeTable;

use super::attached::Attached;
use super::error::FileError;
use super::guard;
use super::load::MAXIMUM_BYTES;
use super::reader::TableReader;
use super::source::{BYTE_ORDER_MARK, Origin, Source};
use super::value::{Conversion, Table, Value, ValueKind};

/// A TOML document with the origin of each value.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    source: Arc<Source>,
    pub(super) root: Table,
    /// The files that it may name, where it was not read from a disk.
    pub(super) attached: Option<Attached>,
}

impl Document {
    /// A document without keys and without a file, to be filled by [`Document::set`].
    #[must_use]
    pub fn empty() -> Self {
        let source = Source::File { name: None, text: String::new() };
        Self { source: Arc::new(source), root: Table::default(), attached: None }
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
        Ok(Self { source, root, attached: None })
    }

    /// The document with the files that it names. No other file is read for it, and none from a disk.
    #[must_use]
    pub fn with_attached(self, files: Attached) -> Self {
        Self { attached: Some(files), ..self }
    }

    /// The name of the file, if the document came from one.
    #[must_use]
    pub fn file_name(&self) -> Option<&str> {
        self.source.file_name()
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

pub(super) fn check_size(bytes: usize) -> Result<(), FileError> {
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
