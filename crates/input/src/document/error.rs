//! The one error of reading a document.

use std::ops::Range;

use super::source::Origin;
use crate::quantity::QuantityError;
use crate::{legible, shortened};

/// Longest text of a value that a message quotes.
pub(super) const LONGEST_QUOTE: usize = 60;

/// A fault of a problem file or of an override: where it is, what is wrong, what would be right.
///
/// Its display is one line, `punch.toml:7: punch.half_width: is a length (like "5 mm"), got Pa, a
/// pressure`; the accessors give a front end what it needs to draw the line with a caret.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{}", .0.sentence())]
pub struct FileError(Box<Fault>);

#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct Fault {
    file_name: Option<String>,
    origin: Option<Origin>,
    field: Option<String>,
    message: String,
    help: Option<String>,
    /// The bytes of the string value that are at fault, and the same bytes of the source.
    inner: Option<(Range<usize>, Range<usize>)>,
}

impl FileError {
    /// A fault that is nowhere in particular, such as of a file that cannot be read at all.
    #[must_use]
    pub fn new(message: impl Into<String>) -> Self {
        Self(Box::new(Fault { message: message.into(), ..Fault::default() }))
    }

    /// The same fault, in the file of this name.
    #[must_use]
    pub fn in_file(mut self, name: Option<&str>) -> Self {
        self.0.file_name = name.map(str::to_owned);
        self
    }

    /// The same fault, of the field with this dotted name.
    #[must_use]
    pub fn of_field(mut self, field: impl Into<String>) -> Self {
        self.0.field = Some(field.into()).filter(|field| !field.is_empty());
        self
    }

    /// The same fault, at this place.
    #[must_use]
    pub fn at(mut self, origin: &Origin) -> Self {
        self.0.origin = Some(origin.clone());
        self
    }

    /// The same fault, with advice.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.0.help = Some(help.into());
        self
    }

    /// The same fault, at bytes `inner` of the string `value` that stands at the origin.
    #[must_use]
    pub fn within(mut self, value: &str, inner: Range<usize>) -> Self {
        if let Some(origin) = &self.0.origin {
            let absolute = origin.locate(value, inner.clone());
            self.0.inner = Some((inner, absolute));
        }
        self
    }

    pub(super) fn from_quantity(error: &QuantityError) -> Self {
        let (message, help) = (error.to_string(), error.help());
        Self(Box::new(Fault { message, help, ..Fault::default() }))
    }

    /// The name of the file, if there is one.
    #[must_use]
    pub fn file_name(&self) -> Option<&str> {
        self.0.origin.as_ref().and_then(Origin::file_name).or(self.0.file_name.as_deref())
    }

    /// The place of the value at fault; none if the fault has no place.
    #[must_use]
    pub fn origin(&self) -> Option<&Origin> {
        self.0.origin.as_ref()
    }

    /// The line in the file, from 1; none for overrides.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        self.caret().filter(|origin| !origin.is_override()).map(|origin| origin.line())
    }

    /// The column of [`FileError::span`] in characters, from 1; none for overrides.
    #[must_use]
    pub fn column(&self) -> Option<usize> {
        self.caret().filter(|origin| !origin.is_override()).map(|origin| origin.column())
    }

    /// The dotted name of the field at fault, such as `punch.half_width`.
    #[must_use]
    pub fn field(&self) -> Option<&str> {
        self.0.field.as_deref()
    }

    /// What is wrong, without place and field.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// What to do about it.
    #[must_use]
    pub fn help(&self) -> Option<&str> {
        self.0.help.as_deref()
    }

    /// The text that [`FileError::span`] counts in: the whole file, or `key=value` of an override.
    #[must_use]
    pub fn source_text(&self) -> Option<&str> {
        self.0.origin.as_ref().map(Origin::source_text)
    }

    /// What to call the source above a snippet of it: the name of the file, or `--set`.
    #[must_use]
    pub fn source_name(&self) -> &str {
        match &self.0.origin {
            Some(origin) if origin.is_override() => "--set",
            _ => self.file_name().unwrap_or("input"),
        }
    }

    /// The bytes of [`FileError::source_text`] to point at: the part of a string that is at fault
    /// where it is known, otherwise the whole value.
    #[must_use]
    pub fn span(&self) -> Option<Range<usize>> {
        self.caret().map(|origin| origin.span())
    }

    /// The bytes at fault counted within the string value itself, if the fault is inside a string.
    #[must_use]
    pub fn inner_span(&self) -> Option<Range<usize>> {
        self.0.inner.as_ref().map(|(inner, _)| inner.clone())
    }

    fn caret(&self) -> Option<Origin> {
        let origin = self.0.origin.clone()?;
        Some(match &self.0.inner {
            Some((_, absolute)) => Origin { span: (absolute.start, absolute.end), ..origin },
            None => origin,
        })
    }
}

impl Fault {
    fn sentence(&self) -> String {
        let mut parts = Vec::new();
        match &self.origin {
            Some(origin) if origin.is_override() => {
                parts.push(format!("--set {}", shortened(origin.source_text(), LONGEST_QUOTE)));
            }
            Some(origin) => {
                let name = origin.file_name().unwrap_or("line");
                parts.push(format!("{name}:{}", origin.line()));
            }
            None => parts.extend(self.file_name.clone()),
        }
        parts.extend(self.field.clone());
        parts.push(self.message.clone());
        legible(&parts.join(": "))
    }
}
