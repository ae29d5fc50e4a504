//! JSON and CSV as text.

use serde::Serialize;

use crate::Failure;

/// Pretty JSON with a final newline.
///
/// # Errors
/// [`Failure::Usage`] for a value that JSON cannot hold; none of ours is.
pub(crate) fn json(value: &impl Serialize) -> Result<String, Failure> {
    let mut text =
        serde_json::to_string_pretty(value).map_err(|error| Failure::Usage(error.to_string()))?;
    text.push('\n');
    Ok(text)
}

/// CSV with a header.
///
/// # Errors
/// [`Failure::Usage`] should writing to memory fail.
pub(crate) fn csv(
    header: &[&str],
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<String, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let failure = |error: csv::Error| Failure::Usage(error.to_string());
    writer.write_record(header).map_err(failure)?;
    for row in rows {
        writer.write_record(row).map_err(failure)?;
    }
    let bytes = writer.into_inner().map_err(|error| Failure::Usage(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| Failure::Usage(error.to_string()))
}
