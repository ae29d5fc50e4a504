//! Files are written whole or not at all.

use std::io::Write;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::Failure;

/// Everything a command writes: prepared first, then put in place together.
#[derive(Debug, Default)]
pub(crate) struct Outputs {
    files: Vec<(PathBuf, Vec<u8>)>,
    terminal: Vec<u8>,
}

impl Outputs {
    /// A result for `file`, or for the terminal.
    pub(crate) fn result(&mut self, file: Option<&Path>, content: impl Into<Vec<u8>>) {
        match file {
            Some(path) => self.file(path, content),
            None => self.terminal.extend(content.into()),
        }
    }

    /// A file.
    pub(crate) fn file(&mut self, path: &Path, content: impl Into<Vec<u8>>) {
        self.files.push((path.to_owned(), content.into()));
    }

    /// Writes all files beside their places, then renames them, then prints.
    ///
    /// # Errors
    /// [`Failure::Unwritable`] with the path; nothing has been changed unless a rename itself failed.
    pub(crate) fn write(self) -> Result<(), Failure> {
        let prepared = self
            .files
            .iter()
            .map(|(path, content)| {
                Prepared::new(path, content).map_err(|error| Failure::unwritable(path, &error))
            })
            .collect::<Result<Vec<_>, _>>()?;
        for (file, (path, content)) in prepared.into_iter().zip(&self.files) {
            file.finish(content).map_err(|error| Failure::unwritable(path, &error))?;
        }
        print(&self.terminal)
    }
}

/// Fails early, before anything is computed, where an output cannot be written.
///
/// # Errors
/// [`Failure::Unwritable`] when the folder does not exist or does not take files, or the path is a folder;
/// [`Failure::Usage`] when two outputs are the same file, or one is the input.
pub(crate) fn check_writable(paths: &[Option<&Path>], input: Option<&Path>) -> Result<(), Failure> {
    let input = input.and_then(|input| input.canonicalize().ok());
    let mut places = Vec::new();
    for path in paths.iter().copied().flatten() {
        let target = Prepared::new(path, b"")
            .map_err(|error| Failure::unwritable(path, &error))?
            .into_target();
        let place = target.and_then(|target| place(&target));
        if place.is_some() && place == input {
            return Err(Failure::Usage(format!(
                "{} is the problem file: the result would overwrite it",
                path.display()
            )));
        }
        if place.is_some() && places.contains(&place) {
            return Err(Failure::Usage(format!(
                "two outputs would be written to {}",
                path.display()
            )));
        }
        places.push(place);
    }
    Ok(())
}

/// The same for all spellings of a path: `out.svg` and `./out.svg`.
fn place(path: &Path) -> Option<PathBuf> {
    Some(folder(path).canonicalize().ok()?.join(path.file_name()?))
}

fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Content on its way to a file.
#[derive(Debug)]
enum Prepared {
    /// Written to a temporary file in the folder of its target, so that the rename is atomic.
    Beside { file: NamedTempFile, target: PathBuf },
    /// A device or a pipe (`/dev/null`) is written to: a rename would put a file in its place.
    Device(PathBuf),
}

impl Prepared {
    fn new(path: &Path, content: &[u8]) -> std::io::Result<Self> {
        if path.is_dir() {
            return Err(std::io::Error::other("it is a folder"));
        }
        if path.file_name().is_none() {
            return Err(std::io::Error::other("it names no file"));
        }
        if path.metadata().is_ok_and(|metadata| !metadata.is_file()) {
            return Ok(Self::Device(path.to_owned()));
        }
        // A link keeps pointing where it points; the file there is replaced.
        let target = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let folder = folder(&target);
        if !folder.is_dir() {
            return Err(std::io::Error::other(format!("there is no folder {}", folder.display())));
        }
        let mut builder = tempfile::Builder::new();
        builder.prefix(".shtaerman-");
        permit_as_usual(&mut builder);
        // The error of the system names a temporary file, which nobody asked for.
        let mut file = builder.tempfile_in(folder).map_err(|error| bare(&error))?;
        file.write_all(content).and_then(|()| file.flush()).map_err(|error| bare(&error))?;
        Ok(Self::Beside { file, target })
    }

    /// Where the file will be; none for a device.
    fn into_target(self) -> Option<PathBuf> {
        match self {
            Self::Beside { target, .. } => Some(target),
            Self::Device(_) => None,
        }
    }

    fn finish(self, content: &[u8]) -> std::io::Result<()> {
        match self {
            Self::Beside { file, target } => {
                file.persist(target).map(drop).map_err(|error| error.error)
            }
            Self::Device(path) => {
                std::fs::OpenOptions::new().write(true).open(path)?.write_all(content)
            }
        }
    }
}

/// What the system says, without the path that a wrapper put behind it.
fn bare(error: &std::io::Error) -> std::io::Error {
    let code = error.raw_os_error().or_else(|| {
        let inner = error.get_ref()?.source()?.downcast_ref::<std::io::Error>()?;
        inner.raw_os_error()
    });
    code.map_or_else(|| error.kind().into(), std::io::Error::from_raw_os_error)
}

/// Temporary files are private by default; results get what the umask leaves of 0666, like any other file.
#[cfg(unix)]
fn permit_as_usual(builder: &mut tempfile::Builder<'_, '_>) {
    use std::os::unix::fs::PermissionsExt;
    builder.permissions(std::fs::Permissions::from_mode(0o666));
}

#[cfg(not(unix))]
fn permit_as_usual(_builder: &mut tempfile::Builder<'_, '_>) {}

fn print(content: &[u8]) -> Result<(), Failure> {
    let mut terminal = std::io::stdout().lock();
    match terminal.write_all(content).and_then(|()| terminal.flush()) {
        // The reader of a pipe (`head`) may leave when it has enough.
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::unwritable(Path::new("standard output"), &error))
        }
        _ => Ok(()),
    }
}
