//! Files are written whole or not at all.

mod content;
mod identity;
pub(crate) mod npz;
mod pending;
mod prepared;
mod printer;
mod signals;

use std::path::{Path, PathBuf};

use crate::terminal::has_colours;
use crate::{Failure, clock, failure};
use identity::identity;
use prepared::{Prepared, folder};

pub(crate) use content::Content;
pub(crate) use pending::{TEMPORARY, interrupt, sweep_out};
pub(crate) use printer::Printer;
pub(crate) use signals::watch_signals;

/// Everything a command writes: prepared first, then put in place together.
#[derive(Debug, Default)]
pub(crate) struct Outputs<'a> {
    files: Vec<(PathBuf, Content<'a>)>,
    terminal: Vec<Content<'a>>,
}

impl<'a> Outputs<'a> {
    /// A result for `file`, or for the terminal.
    pub(crate) fn result(&mut self, file: Option<&Path>, content: impl Into<Content<'a>>) {
        match file {
            Some(path) => self.file(path, content),
            None => self.terminal.push(content.into()),
        }
    }

    /// A file.
    pub(crate) fn file(&mut self, path: &Path, content: impl Into<Content<'a>>) {
        self.files.push((path.to_owned(), content.into()));
    }

    /// Writes all files beside their places, then renames them, then prints.
    ///
    /// # Errors
    /// [`Failure::Unwritable`] or [`Failure::Unwritten`] with the path; no file has been changed unless a rename itself failed.
    pub(crate) fn write(self) -> Result<(), Failure> {
        clock::stop();
        let mut written = Vec::new();
        for (path, content) in self.files {
            let mut file =
                Prepared::new(&path).map_err(|error| Failure::unwritable(&path, &error))?;
            file.fill(content).map_err(|error| Failure::unwritten(&path, &error))?;
            written.push((path, file));
        }
        pending::whole(|| {
            written.into_iter().try_for_each(|(path, file)| {
                file.finish().map_err(|error| Failure::unwritten(&path, &error))
            })
        })?;
        self.terminal.into_iter().try_for_each(print)?;
        failure::release();
        Ok(())
    }
}

/// A file that a command reads.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Input<'a> {
    /// What it is to the user.
    pub(crate) what: &'static str,
    /// Its path; `-` is standard input.
    pub(crate) path: &'a Path,
}

/// Fails early, before anything is computed, where an output cannot be written.
///
/// # Errors
/// [`Failure::Unwritable`] when the folder does not exist or does not take files, the path is a folder or the file read-only;
/// [`Failure::Usage`] when two outputs are the same file, or one is an input.
pub(crate) fn check_writable(paths: &[Option<&Path>], inputs: &[Input<'_>]) -> Result<(), Failure> {
    let mut places = Vec::new();
    for path in paths.iter().copied().flatten() {
        let target =
            Prepared::new(path).map_err(|error| Failure::unwritable(path, &error))?.into_target();
        check_spared(path, inputs)?;
        let place = target.and_then(|target| place(&target));
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

/// Refuses an output that is an input, by whatever name.
fn check_spared(path: &Path, inputs: &[Input<'_>]) -> Result<(), Failure> {
    let Some(output) = identity(path) else { return Ok(()) };
    match inputs.iter().find(|input| identity(input.path).as_ref() == Some(&output)) {
        Some(input) => Err(Failure::Usage(format!(
            "{} is {}: the result would overwrite it",
            path.display(),
            input.what
        ))),
        None => Ok(()),
    }
}

/// The same for all spellings of a path: `out.svg` and `./out.svg`.
fn place(path: &Path) -> Option<PathBuf> {
    Some(folder(path).canonicalize().ok()?.join(path.file_name()?))
}

fn print(content: Content<'_>) -> Result<(), Failure> {
    let content = if has_colours(&std::io::stdout()) { content.painted() } else { content };
    match content.write_to(&mut std::io::stdout().lock()) {
        // The reader of a pipe (`head`) may leave when it has enough.
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::unwritten(Path::new("standard output"), &error))
        }
        _ => Ok(()),
    }
}
