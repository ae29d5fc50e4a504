//! Temporary files that an interrupt removes.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

/// Every temporary file of this run; those that are gone do no harm.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn pending() -> MutexGuard<'static, Vec<PathBuf>> {
    PENDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes a temporary file. An interrupt meanwhile waits until it is known.
pub(super) fn create(
    builder: &tempfile::Builder<'_, '_>,
    folder: &Path,
) -> io::Result<NamedTempFile> {
    let mut pending = pending();
    let file = builder.tempfile_in(folder)?;
    pending.push(file.path().to_owned());
    Ok(file)
}

/// Does what an interrupt must not cut in two: it comes before or after.
pub(super) fn whole<T>(act: impl FnOnce() -> T) -> T {
    let _pending = pending();
    act()
}

/// Ends the process with this exit code and leaves no temporary file.
pub(crate) fn interrupt(code: i32) -> ! {
    let pending = pending();
    for path in pending.iter() {
        // What is in its place already has this name no more.
        let _ = std::fs::remove_file(path);
    }
    std::process::exit(code)
}
