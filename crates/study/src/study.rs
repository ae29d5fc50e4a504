//! A study and its cases.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use shtaerman::Error;
use shtaerman::document::{Document, FileError, load_bytes, overridden};
use shtaerman::file::ProblemFile;

use crate::design::{Shares, sample};
use crate::way::Way;
use crate::{Design, Input, Output, Variable, Variation, read};

/// An override of a study, for messages.
const OVERRIDE: &str = "study.count=100";

/// A problem file with some of its values varied.
#[derive(Debug, Clone)]
pub struct Study {
    /// The problem, without the table `[study]`.
    pub(crate) problem: Document,
    /// Where a measured profile is looked for.
    pub(crate) folder: PathBuf,
    pub(crate) variables: Vec<Variable>,
    pub(crate) design: Design,
    pub(crate) outputs: Vec<Output>,
    pub(crate) is_audited: bool,
    pub(crate) audited_sample: usize,
    pub(crate) part_size: usize,
    pub(crate) cases: usize,
    pub(crate) shares: Shares,
    /// The text of the file and its overrides: two studies are the same where these are.
    pub(crate) text: String,
    pub(crate) way: OnceLock<Way>,
}

impl Study {
    /// Reads a study file, with overrides `KEY=VALUE`.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn open(path: &Path, overrides: &[String]) -> Result<Self, Error> {
        let name = path.display().to_string();
        let bytes =
            load_bytes(path).map_err(|message| FileError::new(message).in_file(Some(&name)))?;
        Self::from_bytes(&bytes, &name, path.parent().unwrap_or(Path::new("")), overrides)
    }

    /// Reads a study from the bytes of a file, with overrides `KEY=VALUE`; `folder` is where a measured profile is looked for, `name` is for messages.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field: of the study, and of the problem with the first value of every variable.
    pub fn from_bytes(
        bytes: &[u8],
        name: &str,
        folder: &Path,
        overrides: &[String],
    ) -> Result<Self, Error> {
        let document = overridden(bytes, name, overrides, OVERRIDE)?;
        Self::from_document(document, folder, overrides)
    }

    /// Reads a study from a document with its overrides, which are told apart from the text of the file.
    ///
    /// # Errors
    /// As [`Study::from_bytes`].
    pub fn from_document(
        document: Document,
        folder: &Path,
        overrides: &[String],
    ) -> Result<Self, Error> {
        read::study(document, folder, overrides)
    }

    /// The document of the problem that is varied, without the table `[study]`.
    #[must_use]
    pub fn problem(&self) -> &Document {
        &self.problem
    }

    /// Number of cases.
    #[must_use]
    pub fn cases(&self) -> usize {
        self.cases
    }

    /// The varied keys.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The outputs.
    #[must_use]
    pub fn outputs(&self) -> &[Output] {
        &self.outputs
    }

    /// Which cases there are.
    #[must_use]
    pub fn design(&self) -> Design {
        self.design
    }

    /// Whether the problem has no units.
    #[must_use]
    pub fn is_dimensionless(&self) -> bool {
        self.problem.get("dimensionless").is_some()
    }

    /// Whether every case is audited.
    #[must_use]
    pub fn is_audited(&self) -> bool {
        self.is_audited
    }

    /// The cases that are audited whether or not the others are, in ascending order.
    #[must_use]
    pub fn audited_sample(&self) -> Vec<usize> {
        let seed = match self.design {
            Design::Grid => 0,
            Design::Sobol { seed, .. } | Design::SobolIndices { seed, .. } => u64::from(seed),
            Design::LatinHypercube { seed, .. } | Design::Random { seed, .. } => seed,
        };
        sample(self.cases, self.audited_sample, seed)
    }

    /// The file of a measured profile, which is read for every case.
    ///
    /// # Errors
    /// As [`ProblemFile::from_document`].
    pub fn measured_profile(&self) -> Result<Option<PathBuf>, Error> {
        Ok(self.file(&self.inputs(0))?.measured_profile().map(Path::to_owned))
    }

    /// The problem of the first case, with overrides `KEY=VALUE` that are no part of the study, such as the units in which results are shown.
    ///
    /// # Errors
    /// As [`ProblemFile::from_document`].
    pub fn first(&self, overrides: &[String]) -> Result<ProblemFile, Error> {
        let mut document = self.document(&self.inputs(0))?;
        for (key, value) in overrides.iter().filter_map(|text| text.split_once('=')) {
            document.set(key, value)?;
        }
        ProblemFile::from_document(document, &self.folder)
    }

    /// The varied values of a case.
    #[must_use]
    pub fn inputs(&self, case: usize) -> Vec<Input> {
        // In a grid the last variable changes fastest.
        let mut rest = case;
        let mut inputs: Vec<Input> = Vec::with_capacity(self.variables.len());
        for (index, variable) in self.variables.iter().enumerate().rev() {
            inputs.push(match &variable.variation {
                Variation::Values(values) if self.design == Design::Grid => {
                    let value = values[rest % values.len()].clone();
                    rest /= values.len();
                    value
                }
                Variation::Values(values) => {
                    let place = self.shares.at(case, index) * values.len() as f64;
                    values[(place as usize).min(values.len() - 1)].clone()
                }
                Variation::Drawn(distribution) => {
                    Input::Number(distribution.quantile(self.shares.at(case, index)))
                }
            });
        }
        inputs.reverse();
        inputs
    }

    /// The problem with these values.
    pub(crate) fn file(&self, inputs: &[Input]) -> Result<ProblemFile, Error> {
        ProblemFile::from_document(self.document(inputs)?, &self.folder)
    }

    fn document(&self, inputs: &[Input]) -> Result<Document, Error> {
        let mut document = self.problem.clone();
        for (variable, input) in self.variables.iter().zip(inputs) {
            document.set(&variable.key, &input.to_string())?;
        }
        Ok(document)
    }
}
