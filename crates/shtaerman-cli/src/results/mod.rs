//! Folders of results of a study: a manifest, and parts that are each computed and written whole.

mod format;
mod parquet;
mod scaled;
mod shared;
mod solving;

use std::path::{Path, PathBuf};

use shtaerman_study::{Manifest, Part, PartFault, Row, Study};

use crate::Failure;
use crate::arguments::PartFormat;
use crate::failure::shown;
use crate::output::{self, Content, Outputs};
use scaled::PartColumns;

pub use shared::StudyResults;
pub(crate) use solving::{processors, solved};

/// What the folder says of itself. Programs that read a folder of Parquet parts as one table leave out what begins with an underscore.
const MANIFEST: &str = "_study.json";
/// Largest manifest and part that are read, in bytes.
const LARGEST_FILE: u64 = 1 << 30;

/// The results of a study in a folder.
#[derive(Debug)]
pub(crate) struct Results {
    study: Study,
    folder: PathBuf,
    manifest: Manifest,
    format: PartFormat,
    columns: PartColumns,
}

impl Results {
    /// The folder of a study of this name: made where it is not there, or found to belong to it.
    ///
    /// # Errors
    /// [`Failure::Usage`] where it has something else, or nothing although only its results are wanted.
    pub(crate) fn open(
        study: Study,
        name: &str,
        folder: &Path,
        format: PartFormat,
        is_read_only: bool,
    ) -> Result<Self, Failure> {
        let manifest = study.manifest(name, format.name())?;
        prepare(folder, &manifest, is_read_only)?;
        let columns = PartColumns::new(&study);
        Ok(Self { study, folder: folder.to_owned(), manifest, format, columns })
    }

    pub(crate) fn study(&self) -> &Study {
        &self.study
    }

    pub(crate) fn manifest(&self) -> &Manifest {
        &self.manifest
    }

    /// Where a part is, or will be.
    pub(crate) fn path(&self, part: &Part) -> PathBuf {
        self.folder.join(part.file_name(self.format.name()))
    }

    /// The rows of a part that is there and whole; none where it is not there.
    ///
    /// # Errors
    /// [`Failure`] where the file cannot be read, and, inside, why what is there does not count.
    pub(crate) fn known(
        &self,
        part: &Part,
    ) -> Result<Option<Result<Vec<Row>, PartFault>>, Failure> {
        let Some(bytes) = read(&self.path(part))? else { return Ok(None) };
        let rows = match self.format.rows(&self.study, &self.columns, part, &bytes) {
            Ok(rows) => rows,
            Err(fault) => return Ok(Some(Err(fault))),
        };
        // What says the same in other bytes was not written by this program as it is.
        let ours = self.format.content(&self.study, &self.columns, &rows)?.bytes()?;
        let is_kept = ours == bytes || self.format.is_of_another(&bytes);
        Ok(Some(if is_kept { Ok(rows) } else { Err(PartFault("was changed".to_owned())) }))
    }

    /// Writes a part whole, or not at all.
    ///
    /// # Errors
    /// [`Failure::Unwritten`] with its path.
    pub(crate) fn write(&self, part: &Part, rows: &[Row]) -> Result<(), Failure> {
        let mut outputs = Outputs::default();
        outputs.file(&self.path(part), self.format.content(&self.study, &self.columns, rows)?);
        outputs.write()
    }

    /// Removes what runs that were killed have left of files they wrote.
    pub(crate) fn sweep_out(&self) {
        output::sweep_out(&self.folder);
    }

    /// The cases of a part on so many threads, in order; `tell` hears how many are done.
    pub(crate) fn solve(
        &self,
        part: &Part,
        threads: usize,
        tell: &(dyn Fn(usize) + Sync),
    ) -> Vec<Row> {
        solved(&self.study, part.cases.clone(), threads, tell)
    }
}

/// Makes the folder, or finds it to belong to this study.
fn prepare(folder: &Path, manifest: &Manifest, is_read_only: bool) -> Result<(), Failure> {
    let path = folder.join(MANIFEST);
    if !folder.exists() {
        if is_read_only {
            return Err(Failure::Usage(format!("there is no folder {}", shown(folder))));
        }
        std::fs::create_dir(folder).or_else(|error| {
            // Several shares of one study may begin together.
            if folder.is_dir() { Ok(()) } else { Err(Failure::unwritable(folder, &error)) }
        })?;
    }
    if !folder.is_dir() {
        return Err(Failure::Usage(format!(
            "{} is a file: --output names a folder",
            shown(folder)
        )));
    }
    let Some(bytes) = read(&path)? else {
        if has_foreign_files(folder)? || is_read_only {
            return Err(Failure::Usage(format!(
                "{} has no {MANIFEST}: it is no folder of results, take an empty one",
                shown(folder)
            )));
        }
        let mut outputs = Outputs::default();
        outputs.file(&path, Content::json(manifest));
        return outputs.write();
    };
    let known: Option<Manifest> = serde_json::from_slice(&bytes).ok();
    match known {
        Some(known) if known.belongs_with(manifest) => Ok(()),
        Some(known) => Err(Failure::Usage(different(folder, &known, manifest))),
        None => Err(Failure::Usage(format!(
            "{} is no manifest of a study: take another folder",
            shown(&path)
        ))),
    }
}

/// Whether a folder without a manifest has files, but for the temporary ones that a killed run left.
fn has_foreign_files(folder: &Path) -> Result<bool, Failure> {
    let failed = |error: std::io::Error| Failure::unwritable(folder, &error);
    for entry in folder.read_dir().map_err(failed)? {
        let name = entry.map_err(failed)?.file_name();
        if !name.to_string_lossy().starts_with(output::TEMPORARY) {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Says in what a folder differs from the study.
fn different(folder: &Path, known: &Manifest, manifest: &Manifest) -> String {
    let what = if known.version != manifest.version {
        format!("version {} of the program", known.version)
    } else if known.format != manifest.format && known.digest == manifest.digest {
        format!("this study as {}, not {}", known.format, manifest.format)
    } else {
        format!("another study, {} with {} cases as it was then", known.study, known.cases)
    };
    format!("{} has results of {what}: take another folder, or remove it", shown(folder))
}

/// The bytes of a file; none where it is not there.
fn read(path: &Path) -> Result<Option<Vec<u8>>, Failure> {
    match path.metadata() {
        Ok(metadata) if metadata.is_file() && metadata.len() <= LARGEST_FILE => {
            std::fs::read(path).map(Some).map_err(|error| Failure::unwritable(path, &error))
        }
        Ok(_) => Err(Failure::Usage(format!("{} is no file of results", shown(path)))),
        Err(_) => Ok(None),
    }
}
