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
                prepare(path, content).map_err(|error| Failure::unwritable(path, &error))
            })
            .collect::<Result<Vec<_>, _>>()?;
        for (file, (path, _)) in prepared.into_iter().zip(&self.files) {
            file.persist(path).map_err(|error| Failure::unwritable(path, &error.error))?;
        }
        print(&self.terminal)
    }
}

/// Fails early, before anything is computed, where an output cannot be written.
///
/// # Errors
/// [`Failure::Unwritable`] when the folder does not exist or does not take files, or the path is a folder;
/// [`Failure::Usage`] when two outputs are the same file.
pub(crate) fn check_writable(paths: &[Option<&Path>]) -> Result<(), Failure> {
    let paths: Vec<&Path> = paths.iter().copied().flatten().collect();
    for (i, path) in paths.iter().enumerate() {
        if paths[..i].contains(path) {
            return Err(Failure::Usage(format!(
                "two outputs would be written to {}",
                path.display()
            )));
        }
        prepare(path, b"").map_err(|error| Failure::unwritable(path, &error))?;
    }
    Ok(())
}

/// A temporary file in the folder of `path`, so that the rename is atomic.
fn prepare(path: &Path, content: &[u8]) -> std::io::Result<NamedTempFile> {
    if path.is_dir() {
        return Err(std::io::Error::other("it is a folder"));
    }
    if path.file_name().is_none() {
        return Err(std::io::Error::other("it names no file"));
    }
    let folder =
        path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".shtaerman-");
    permit_as_usual(&mut builder);
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(content)?;
    file.flush()?;
    Ok(file)
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
