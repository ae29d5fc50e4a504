//! The problem file of a command.

use std::io::Read;
use std::path::Path;

use shtaerman::document::MAXIMUM_BYTES;
use shtaerman::file::ProblemFile;

use crate::Failure;
use crate::arguments::ProblemArguments;

/// Reads the problem, with its overrides; `-` is standard input.
pub(super) fn read(arguments: &ProblemArguments) -> Result<ProblemFile, Failure> {
    if arguments.file != Path::new("-") {
        return Ok(ProblemFile::open(&arguments.file, &arguments.overrides)?);
    }
    let mut bytes = Vec::new();
    std::io::stdin()
        .lock()
        .take(MAXIMUM_BYTES as u64 + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| Failure::Usage(format!("standard input cannot be read: {error}")))?;
    Ok(ProblemFile::from_bytes(
        &bytes,
        &name(&arguments.file),
        Path::new(""),
        &arguments.overrides,
    )?)
}

/// What to call the file in messages.
pub(super) fn name(path: &Path) -> String {
    if path == Path::new("-") { "standard input".to_owned() } else { path.display().to_string() }
}
