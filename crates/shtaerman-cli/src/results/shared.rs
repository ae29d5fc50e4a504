//! Folders of results for other programs.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use shtaerman_study::{Part, Row, Study};

use super::Results;
use super::solving::solved_unless;
use crate::arguments::PartFormat;
use crate::failure::Refusal;

/// The results of a study in a folder, as `shtaerman sweep` keeps them.
///
/// ```
/// use std::path::Path;
/// use shtaerman_cli::{PartFormat, StudyResults};
/// use shtaerman_study::Study;
///
/// let text = r#"
/// [dimensionless]
/// theta0 = 1.0
/// profile = "xi^2"
/// force = 1.0
/// moment = 0
///
/// [study]
/// vary."dimensionless.theta0" = [1.0, 2.0]
/// "#;
/// let study = Study::from_bytes(text.as_bytes(), "study.toml", Path::new(""), &[])?;
/// let part = study.parts().next().unwrap();
/// let folder = tempfile::tempdir()?;
/// let results = StudyResults::open(study, "study.toml", folder.path(), PartFormat::Csv, false)?;
/// assert!(results.rows(&part)?.is_none());
/// let rows = results.solve(&part, 1);
/// results.write(&part, &rows)?;
/// assert_eq!(results.rows(&part)?, Some(rows));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StudyResults(Results);

impl StudyResults {
    /// The folder of a study of this name: made unless only results that are there are wanted, or found to belong to the study.
    ///
    /// # Errors
    /// [`Refusal`] where it has something else, such as results of another study or version.
    pub fn open(
        study: Study,
        name: &str,
        folder: &Path,
        format: PartFormat,
        is_read_only: bool,
    ) -> Result<Self, Refusal> {
        Ok(Self(Results::open(study, name, folder, format, is_read_only)?))
    }

    /// The study.
    #[must_use]
    pub fn study(&self) -> &Study {
        self.0.study()
    }

    /// Where a part is, or will be.
    #[must_use]
    pub fn path(&self, part: &Part) -> PathBuf {
        self.0.path(part)
    }

    /// The rows of a part that is there and whole.
    ///
    /// # Errors
    /// [`Refusal`] where its file cannot be read.
    pub fn rows(&self, part: &Part) -> Result<Option<Vec<Row>>, Refusal> {
        Ok(self.0.known(part)?.and_then(Result::ok))
    }

    /// The rows of a part, computed on so many threads.
    #[must_use]
    pub fn solve(&self, part: &Part, threads: usize) -> Vec<Row> {
        self.0.solve(part, threads, &|_| ())
    }

    /// The same, or none where the flag is set before all of them are: it is looked at between cases.
    #[must_use]
    pub fn solve_unless(&self, part: &Part, threads: usize, stop: &AtomicBool) -> Option<Vec<Row>> {
        solved_unless(self.0.study(), part.cases.clone(), threads, &|_| (), stop)
    }

    /// Writes a part whole, or not at all.
    ///
    /// # Errors
    /// [`Refusal`] with the path, where it cannot be written.
    pub fn write(&self, part: &Part, rows: &[Row]) -> Result<(), Refusal> {
        Ok(self.0.write(part, rows)?)
    }

    /// Removes what runs that were killed have left of files they wrote: temporary files that are a minute old and that no process holds.
    pub fn sweep_out(&self) {
        self.0.sweep_out();
    }
}
