//! Where a value was written: a file or an override, with line and column.

use std::ops::Range;
use std::sync::Arc;

/// A text that values were read from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Source {
    /// A file, with its name if it has one.
    File { name: Option<String>, text: String },
    /// An override `key=value`; its text is the whole.
    Override { text: String },
}

impl Source {
    /// The name of the file, if it is one that has one.
    pub(super) fn file_name(&self) -> Option<&str> {
        match self {
            Self::File { name, .. } => name.as_deref(),
            Self::Override { .. } => None,
        }
    }

    pub(super) fn text(&self) -> &str {
        match self {
            Self::File { text, .. } | Self::Override { text } => text,
        }
    }
}

/// The place where a value was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Origin {
    pub(super) source: Arc<Source>,
    pub(super) span: (usize, usize),
}

impl Origin {
    pub(super) fn new(source: &Arc<Source>, span: Range<usize>) -> Self {
        let text = source.text();
        let start = boundary(text, span.start);
        let end = boundary(text, span.end).max(start);
        Self { source: Arc::clone(source), span: (start, end) }
    }

    /// Whether the value came from an override (`--set`) and not from the file.
    #[must_use]
    pub fn is_override(&self) -> bool {
        matches!(*self.source, Source::Override { .. })
    }

    /// The name of the file, if the value came from a file that has one.
    #[must_use]
    pub fn file_name(&self) -> Option<&str> {
        self.source.file_name()
    }

    /// The whole text of the file, or `key=value` of the override.
    #[must_use]
    pub fn source_text(&self) -> &str {
        self.source.text()
    }

    /// The bytes of [`Origin::source_text`] that hold the value, quotes included.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        self.span.0..self.span.1
    }

    /// The line, from 1.
    #[must_use]
    pub fn line(&self) -> usize {
        self.before().bytes().filter(|byte| *byte == b'\n').count() + 1
    }

    /// The column in characters, from 1.
    #[must_use]
    pub fn column(&self) -> usize {
        let line = self.before().rsplit('\n').next().unwrap_or_default();
        line.chars().filter(|sign| *sign != BYTE_ORDER_MARK).count() + 1
    }

    fn before(&self) -> &str {
        &self.source.text()[..self.span.0]
    }

    /// The bytes of the source that hold bytes `inner` of the string `value` written here.
    ///
    /// Only where the string stands in the source as it is: with escapes or a continued line, bytes
    /// of the value do not match bytes of the source, and the whole value is the answer.
    pub(super) fn locate(&self, value: &str, inner: Range<usize>) -> Range<usize> {
        let span = self.span();
        let Some(offset) = offset_of_string(&self.source.text()[span.clone()], value) else {
            return span;
        };
        match value.get(inner.clone()) {
            Some(_) => span.start + offset + inner.start..span.start + offset + inner.end,
            None => span,
        }
    }
}

pub(super) const BYTE_ORDER_MARK: char = '\u{feff}';

/// The greatest character boundary of `text` that is not behind byte `at`.
fn boundary(text: &str, at: usize) -> usize {
    let at = at.min(text.len());
    (0..=at).rev().find(|place| text.is_char_boundary(*place)).unwrap_or(0)
}

/// Where a string begins within its TOML literal, if it stands there unchanged.
fn offset_of_string(literal: &str, value: &str) -> Option<usize> {
    if literal == value {
        return Some(0);
    }
    let openings = ["\"\"\"\r\n", "\"\"\"\n", "\"\"\"", "'''\r\n", "'''\n", "'''", "\"", "'"];
    let opening = openings.into_iter().find(|opening| literal.starts_with(opening))?;
    let closing = opening.trim_end();
    let content = literal.get(opening.len()..)?.strip_suffix(closing)?;
    (content == value).then_some(opening.len())
}
