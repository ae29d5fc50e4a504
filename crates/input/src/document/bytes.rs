//! Documents from bytes, with overrides.

use super::{Document, FileError};

/// The document in the bytes of a file, with overrides `KEY=VALUE`, of which `example` is one.
///
/// # Errors
/// [`FileError`] as [`Document::from_bytes`] and [`Document::set`], and for an override without `=`.
pub fn overridden(
    bytes: &[u8],
    name: &str,
    overrides: &[String],
    example: &str,
) -> Result<Document, FileError> {
    let mut document = Document::from_bytes(bytes, name)?;
    for text in overrides {
        let (key, value) = text.split_once('=').ok_or_else(|| {
            FileError::new(format!("--set {text}: has no `=`"))
                .with_help(format!("write --set {example}"))
        })?;
        document.set(key.trim(), value.trim())?;
    }
    Ok(document)
}
