//! Whether two paths lead to the same file.

use std::path::Path;

/// What tells a file from every other, whatever name, link or hard link leads to it.
#[cfg(unix)]
pub(super) type Identity = (u64, u64);

#[cfg(not(unix))]
pub(super) type Identity = std::path::PathBuf;

/// The file that a path leads to; none for a device, which writing does not destroy, and where there is none.
#[cfg(unix)]
pub(super) fn identity(path: &Path) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    // A file that the shell gives as standard input.
    let path = if path == Path::new("-") { Path::new("/dev/stdin") } else { path };
    let metadata = path.metadata().ok().filter(std::fs::Metadata::is_file)?;
    Some((metadata.dev(), metadata.ino()))
}

#[cfg(not(unix))]
pub(super) fn identity(path: &Path) -> Option<Identity> {
    path.canonicalize().ok().filter(|path| path.is_file())
}
