//! Bytes of files, and documents from them.

use std::path::Path;

use super::{Document, FileError, MAXIMUM_BYTES};

/// The bytes of a file of at most [`MAXIMUM_BYTES`].
///
/// # Errors
/// What is wrong with the file, as a text that reads on after its name.
pub fn load_bytes(path: &Path) -> Result<Vec<u8>, String> {
    let readable = |error: std::io::Error| format!("cannot be read: {error}");
    let metadata = std::fs::metadata(path).map_err(readable)?;
    if metadata.is_dir() {
        return Err("is a folder, not a file".to_owned());
    }
    if metadata.len() > MAXIMUM_BYTES as u64 {
        return Err(format!(
            "has {} bytes, more than the {MAXIMUM_BYTES} that are read",
            metadata.len()
        ));
    }
    std::fs::read(path).map_err(readable)
}

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
