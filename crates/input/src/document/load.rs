//! Bytes of files.

use std::fs::File;
use std::io::Read;
use std::path::Path;

/// The largest file that is read, in bytes (200 MB).
pub const MAXIMUM_BYTES: usize = 200_000_000;

/// The bytes of a file of at most [`MAXIMUM_BYTES`].
///
/// # Errors
/// What is wrong with the file, as a text that reads on after its name.
pub fn load_bytes(path: &Path) -> Result<Vec<u8>, String> {
    let readable = |error: std::io::Error| format!("cannot be read: {error}");
    let file = File::open(path).map_err(readable)?;
    let metadata = file.metadata().map_err(readable)?;
    if metadata.is_dir() {
        return Err("is a folder, not a file".to_owned());
    }
    if metadata.len() > MAXIMUM_BYTES as u64 {
        return Err(format!(
            "has {} bytes, more than the {MAXIMUM_BYTES} that are read",
            metadata.len()
        ));
    }
    read_bytes(file)
}

/// All bytes of a stream, of at most [`MAXIMUM_BYTES`]: devices and pipes do not say how long they are, and some never end.
///
/// # Errors
/// What is wrong with the stream, as a text that reads on after its name.
pub fn read_bytes(stream: impl Read) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    stream
        .take(MAXIMUM_BYTES as u64 + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| format!("cannot be read: {error}"))?;
    if bytes.len() > MAXIMUM_BYTES {
        return Err(format!("has more than the {MAXIMUM_BYTES} bytes that are read"));
    }
    Ok(bytes)
}
