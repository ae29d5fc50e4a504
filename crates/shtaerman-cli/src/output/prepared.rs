//! Content on its way to a file.

use std::fs::{File, Metadata, OpenOptions};
use std::io::{Error, ErrorKind, Result};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::content::Content;
use super::pending;

/// A place that takes content.
#[derive(Debug)]
pub(super) enum Prepared {
    /// A temporary file in the folder of its target, so that the rename is atomic.
    Beside { file: NamedTempFile, target: PathBuf },
    /// A device or a pipe (`/dev/null`) is written to: a rename would put a file in its place.
    Device(PathBuf),
}

impl Prepared {
    /// The place that a path names.
    pub(super) fn new(path: &Path) -> Result<Self> {
        if path.is_dir() {
            return Err(Error::other("it is a folder"));
        }
        if path.file_name().is_none() {
            return Err(Error::other("it names no file"));
        }
        let old = match path.metadata() {
            // Such as one that is too long, which a temporary file would not show.
            Err(error) if error.kind() == ErrorKind::InvalidFilename => return Err(error),
            found => found.ok(),
        };
        if old.as_ref().is_some_and(|metadata| !metadata.is_file()) {
            return Ok(Self::Device(path.to_owned()));
        }
        let target = followed(path)?;
        let folder = folder(&target);
        if !folder.is_dir() {
            return Err(Error::other(format!("there is no folder {}", folder.display())));
        }
        if old.is_some() {
            check_permitted(&target)?;
        }
        let mut builder = tempfile::Builder::new();
        builder.prefix(pending::TEMPORARY);
        if old.is_none() {
            permit_as_usual(&mut builder);
        }
        // The error of the system names a temporary file, which nobody asked for.
        let file = pending::create(&builder, folder).map_err(|error| bare(&error))?;
        if let Some(old) = &old {
            permit_as_before(file.as_file(), old).map_err(|error| bare(&error))?;
        }
        Ok(Self::Beside { file, target })
    }

    /// Writes the content, for a file still beside its place.
    pub(super) fn fill(&mut self, content: Content<'_>) -> Result<()> {
        match self {
            Self::Beside { file, .. } => content.write_to_file(file.as_file_mut()),
            Self::Device(path) => content.write_to(&mut OpenOptions::new().write(true).open(path)?),
        }
        .map_err(|error| bare(&error))
    }

    /// Puts a file in its place.
    pub(super) fn finish(self) -> Result<()> {
        match self {
            Self::Beside { file, target } => {
                file.persist(target).map(drop).map_err(|error| error.error)
            }
            Self::Device(_) => Ok(()),
        }
    }

    /// Where the file will be; none for a device.
    pub(super) fn into_target(self) -> Option<PathBuf> {
        match self {
            Self::Beside { target, .. } => Some(target),
            Self::Device(_) => None,
        }
    }
}

pub(super) fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// The file that a path means: a link keeps pointing where it points, and the file there is replaced, or made.
fn followed(path: &Path) -> Result<PathBuf> {
    /// As many as Linux follows.
    const MOST_LINKS: usize = 40;
    if let Ok(target) = path.canonicalize() {
        return Ok(target);
    }
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        if !target.is_symlink() {
            return Ok(target);
        }
        target = folder(&target).join(target.read_link()?);
    }
    Err(Error::other("it is a link that leads to itself"))
}

/// A rename needs the permission of the folder alone; that of the file is asked for as well.
fn check_permitted(target: &Path) -> Result<()> {
    if target.metadata()?.permissions().readonly() {
        return Err(Error::other("it is read-only"));
    }
    OpenOptions::new().write(true).open(target).map(drop)
}

/// What the system says, without the path that a wrapper put behind it.
fn bare(error: &Error) -> Error {
    let code = error.raw_os_error().or_else(|| {
        let inner = error.get_ref()?.source()?.downcast_ref::<Error>()?;
        inner.raw_os_error()
    });
    code.map_or_else(|| error.kind().into(), Error::from_raw_os_error)
}

/// Temporary files are private by default; a new result gets what the umask leaves of 0666, like any other file.
#[cfg(unix)]
fn permit_as_usual(builder: &mut tempfile::Builder<'_, '_>) {
    use std::os::unix::fs::PermissionsExt;
    builder.permissions(std::fs::Permissions::from_mode(0o666));
}

#[cfg(not(unix))]
fn permit_as_usual(_builder: &mut tempfile::Builder<'_, '_>) {}

/// The permissions of the file that is replaced, and its owner where the system allows it: an administrator's run leaves a file to whom it belongs.
#[cfg(unix)]
fn permit_as_before(file: &File, old: &Metadata) -> Result<()> {
    use std::os::unix::fs::{MetadataExt, fchown};
    let new = file.metadata()?;
    if (new.uid(), new.gid()) != (old.uid(), old.gid()) {
        let _ = fchown(file, Some(old.uid()), Some(old.gid()));
    }
    file.set_permissions(old.permissions())
}

#[cfg(not(unix))]
fn permit_as_before(file: &File, old: &Metadata) -> Result<()> {
    file.set_permissions(old.permissions())
}
