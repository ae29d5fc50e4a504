//! A study and its cases.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use shtaerman::Error;
use shtaerman::document::{Document, FileError, load_bytes, overridden};
use shtaerman::equation::is_equation;
use shtaerman::file::AnyFile;

use crate::design::{Shares, sample};
use crate::find::Find;
use crate::way::Way;
use crate::{Design, Input, Output, Variable, Variation, read};

/// Keys of the files of measured profiles.
const PROFILES: [&str; 2] = ["punch.profile.csv", "dimensionless.profile.csv"];
/// An override of a study, for messages.
const OVERRIDE: &str = "study.count=100";
/// Cases after the first that are read, beside the last, to see whether it alone cannot be.
const MOST_READ: usize = 64;

/// A problem file with some of its values varied.
#[derive(Debug, Clone)]
pub struct Study {
    /// The problem, without the table `[study]`.
    pub(crate) problem: Document,
    /// Where a measured profile is looked for.
    pub(crate) folder: PathBuf,
    pub(crate) variables: Vec<Variable>,
    pub(crate) design: Design,
    /// What is looked for in every case.
    pub(crate) find: Option<Find>,
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

    /// Cases of a part of the results; the last part may have fewer.
    #[must_use]
    pub fn part_size(&self) -> usize {
        self.part_size
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

    /// Whether the problem has no units, as an equation has none.
    #[must_use]
    pub fn is_dimensionless(&self) -> bool {
        is_equation(&self.problem) || self.problem.get("dimensionless").is_some()
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

    /// The files of measured profiles, which are read for every case: of the problem, or those that vary.
    ///
    /// # Errors
    /// As [`AnyFile::from_document`].
    pub fn measured_profiles(&self) -> Result<Vec<PathBuf>, Error> {
        let measured = |file: AnyFile| match file {
            AnyFile::Problem(file) => file.measured_profile().map(Path::to_owned),
            AnyFile::Equation(_) => None,
        };
        let first = self.inputs(0);
        let mut found: Vec<PathBuf> = measured(self.first(&[])?).into_iter().collect();
        for (place, variable) in self.variables.iter().enumerate() {
            let Variation::Values(values) = &variable.variation else { continue };
            if !PROFILES.contains(&variable.key.as_str()) {
                continue;
            }
            for value in values {
                let mut inputs = first.clone();
                inputs[place] = value.clone();
                // What cannot be read is the reason of its cases.
                let path = self.file(&inputs).ok().and_then(measured);
                found.extend(path.filter(|path| !found.contains(path)));
            }
        }
        Ok(found)
    }

    /// The problem of the first case that can be read, with overrides `KEY=VALUE` that are no part of the study, such as the units in which results are shown: one whose load tips the punch over has no
    /// answer, and says so by itself.
    ///
    /// # Errors
    /// As [`AnyFile::from_document`], of the first case, where none of some others can be read.
    pub fn first(&self, overrides: &[String]) -> Result<AnyFile, Error> {
        let last = self.cases().saturating_sub(1);
        let mut others = (1..last.min(MOST_READ)).chain([last]);
        self.case_file(0, overrides).or_else(|error| {
            others.find_map(|case| self.case_file(case, overrides).ok()).ok_or(error)
        })
    }

    /// The problem of a case, with such overrides.
    pub(crate) fn case_file(&self, case: usize, overrides: &[String]) -> Result<AnyFile, Error> {
        let mut document = self.document(&self.inputs(case))?;
        for (key, value) in overrides.iter().filter_map(|text| text.split_once('=')) {
            document.set(key, value)?;
        }
        AnyFile::from_document(document, &self.folder)
    }

    /// The varied values of a case.
    #[must_use]
    pub fn inputs(&self, case: usize) -> Vec<Input> {
        // In a grid the last variable changes fastest.
        let mut rest = case;
        let mut inputs: Vec<Input> = Vec::with_capacity(self.variables.len());
        for (index, variable) in self.variables.iter().enumerate().rev() {
            let variation = &variable.variation;
            inputs.push(match (variation, variation.count()) {
                (Variation::Drawn(distribution), _) => {
                    Input::Number(distribution.quantile(self.shares.at(case, index)))
                }
                (_, Some(count)) if self.design == Design::Grid => {
                    let value = variation.value(rest % count);
                    rest /= count;
                    value
                }
                (_, count) => {
                    let count = count.unwrap_or(1);
                    let place = self.shares.at(case, index) * count as f64;
                    variation.value((place as usize).min(count - 1))
                }
            });
        }
        inputs.reverse();
        inputs
    }

    /// The problem with these values.
    pub(crate) fn file(&self, inputs: &[Input]) -> Result<AnyFile, Error> {
        AnyFile::from_document(self.document(inputs)?, &self.folder)
    }

    fn document(&self, inputs: &[Input]) -> Result<Document, Error> {
        let mut document = self.problem.clone();
        for (variable, input) in self.variables.iter().zip(inputs) {
            document.set(&variable.key, &input.to_string())?;
        }
        Ok(document)
    }
}
