//! Temporary files that an interrupt removes.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tempfile::NamedTempFile;

/// How names of temporary files begin.
pub(crate) const TEMPORARY: &str = ".shtaerman-";
/// Temporary files that were left alone so long may be those of a run that was killed.
const LEFT: Duration = Duration::from_secs(60);

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
    // Says to others that it is in use; where files cannot be locked, nobody removes it.
    let _ = file.as_file().try_lock();
    pending.push(file.path().to_owned());
    Ok(file)
}

/// Removes the temporary files that runs which were killed have left in a folder: old ones that no process holds.
pub(crate) fn sweep_out(folder: &Path) {
    let Ok(entries) = folder.read_dir() else { return };
    for entry in entries.flatten() {
        let is_temporary = entry.file_name().to_string_lossy().starts_with(TEMPORARY);
        let age =
            |entry: &std::fs::DirEntry| entry.metadata().ok()?.modified().ok()?.elapsed().ok();
        if is_temporary
            && age(&entry).is_some_and(|age| age > LEFT)
            && File::open(entry.path()).is_ok_and(|file| file.try_lock().is_ok())
        {
            let _ = std::fs::remove_file(entry.path());
        }
    }
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
