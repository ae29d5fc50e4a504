//! A problem that remembers where its values were written.

use std::path::{Path, PathBuf};

use super::profile;
use super::read::{ReadProblem, read};
use super::section::whole;
use super::sense::advised;
use crate::document::{Document, FileError, load_bytes, overridden};
use crate::quantity::OutputUnits;
use crate::{Contact, Error, Problem, Warning};

/// Keys of which a file has one; an override of one replaces the other.
pub const ALTERNATIVES: [&[&str]; 9] = [
    &["load.force", "load.settlement"],
    &["load.moment", "load.eccentricity", "load.tilt"],
    &["foundation.roughness", "foundation.subgrade_modulus"],
    &["foundation.young_modulus", "foundation.grading_modulus"],
    &["foundation.young_modulus", "foundation.grading_exponent"],
    &["dimensionless.theta0", "dimensionless.lambda0"],
    &["dimensionless.force", "dimensionless.settlement"],
    &["dimensionless.moment", "dimensionless.eccentricity", "dimensionless.tilt"],
    &["dimensionless.theta0", "dimensionless.poisson_ratio"],
];

/// An override, for messages.
pub(super) const OVERRIDE: &str = "load.force=\"1 MN/m\"";

/// A problem with the document it was read from, so that a fault found while solving still names file, line and field.
#[derive(Debug, Clone, PartialEq)]
pub struct ProblemFile {
    pub(super) problem: Problem,
    units: OutputUnits,
    document: Document,
    measured: Option<PathBuf>,
    /// What is doubtful about the units of a trace.
    pub(super) doubts: Vec<Warning>,
}

impl ProblemFile {
    /// Reads a problem file, with overrides `KEY=VALUE`.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn open(path: &Path, overrides: &[String]) -> Result<Self, Error> {
        let name = path.display().to_string();
        let bytes =
            load_bytes(path).map_err(|message| FileError::new(message).in_file(Some(&name)))?;
        Self::from_bytes(&bytes, &name, path.parent().unwrap_or(Path::new("")), overrides)
    }

    /// Reads a problem from the bytes of a file, with overrides `KEY=VALUE`; `folder` is where a measured profile is looked for, `name`
    /// is for messages.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn from_bytes(
        bytes: &[u8],
        name: &str,
        folder: &Path,
        overrides: &[String],
    ) -> Result<Self, Error> {
        let document = overridden(bytes, name, overrides, OVERRIDE)
            .map_err(|error| Self::explained(error, bytes))?;
        Self::from_document(document, folder)
    }

    /// The fault of a text that is no document, with all the lines that it lacks where it has none.
    #[must_use]
    pub fn explained(error: FileError, bytes: &[u8]) -> FileError {
        if bytes.iter().all(u8::is_ascii_whitespace) { error.with_help(whole()) } else { error }
    }

    /// Reads a problem from a document with its overrides; `folder` is where a measured profile is looked for.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn from_document(mut document: Document, folder: &Path) -> Result<Self, Error> {
        // Poisson's ratio goes with theta0 where it is that of a bonded layer.
        let has_layer = document.get("dimensionless.base").is_some();
        for group in ALTERNATIVES {
            if !(has_layer && group.contains(&"dimensionless.poisson_ratio")) {
                document.prefer_overrides(group);
            }
        }
        Self::read(document, folder)
    }

    pub(super) fn read(document: Document, folder: &Path) -> Result<Self, Error> {
        let ReadProblem { problem, units, doubts } = read(&document, folder)
            .map_err(|error| advised(&document, locate(&document, error)))?;
        let measured = profile::measured_path(&document, folder);
        Ok(Self { problem, units, document, measured, doubts })
    }

    /// The file of a measured profile, which was read as well.
    #[must_use]
    pub fn measured_profile(&self) -> Option<&Path> {
        self.measured.as_deref()
    }

    /// The document, overrides included.
    #[must_use]
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The problem.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// The units in which results are wanted: `units` of `[output]`, or SI.
    #[must_use]
    pub fn units(&self) -> &OutputUnits {
        &self.units
    }

    /// Solves the problem as [`Problem::solve`] does.
    ///
    /// # Errors
    /// Those of [`Problem::solve`]; bad input as [`Error::File`].
    pub fn solve(&self) -> Result<Contact, Error> {
        self.problem.solve().map_err(|error| self.locate(error))
    }

    /// The error with the file, and line and field where they are known; a failed numerical promise stays as it is.
    #[must_use]
    pub fn locate(&self, error: Error) -> Error {
        locate(&self.document, error)
    }
}

fn locate(document: &Document, error: Error) -> Error {
    let keys: &[&str] = match &error {
        Error::File(_) => return error,
        Error::Equation(fredholm::Error::TooLarge { .. }) => &["solver.n"],
        numerical if numerical.is_numerical() => return error,
        Error::InvalidValue { field, .. } | Error::TipsOver { field, .. } => match *field {
            "force" => &["load.force", "dimensionless.force"],
            "settlement" => &["load.settlement", "dimensionless.settlement"],
            "moment" => &["load.moment", "dimensionless.moment"],
            "eccentricity" => &["load.eccentricity", "dimensionless.eccentricity"],
            "tilt" => &["load.tilt", "dimensionless.tilt"],
            "grading_exponent" => &["foundation.grading_exponent"],
            "roughness" => &["foundation.roughness"],
            "thickness" => {
                &["foundation.coating.thickness", "foundation.thickness", "dimensionless.thickness"]
            }
            _ => &[],
        },
        Error::NoContact => &["load.settlement", "dimensionless.settlement"],
        _ => &[],
    };
    let written = keys.iter().find_map(|key| Some((key, document.get(key)?)));
    let message = match &error {
        // No file can hold it, so it came out on the way to the answer.
        Error::InvalidValue { field, value, .. } if !value.is_finite() => {
            Error::Overflow { quantity: field, value: *value }.to_string()
        }
        other => other.to_string(),
    };
    let fault = FileError::new(message).in_file(document.file_name());
    let fault = match written {
        Some((key, value)) => fault.of_field(*key).at(value.origin()),
        None => fault,
    };
    if error.is_numerical() { Error::Beyond(fault) } else { fault.into() }
}
