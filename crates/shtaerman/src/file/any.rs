//! A file of either kind.

use std::path::Path;

use super::located::{OVERRIDE, ProblemFile};
use crate::Error;
use crate::document::{Document, FileError, load_bytes, overridden};
use crate::equation::{EquationFile, is_equation};

/// A contact problem or an equation: whichever the file turns out to be.
#[derive(Debug)]
pub enum AnyFile {
    /// A contact problem.
    Problem(Box<ProblemFile>),
    /// An equation.
    Equation(Box<EquationFile>),
}

impl AnyFile {
    /// Reads a file, with overrides `KEY=VALUE`.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn open(path: &Path, overrides: &[String]) -> Result<Self, Error> {
        let name = path.display().to_string();
        let bytes =
            load_bytes(path).map_err(|message| FileError::new(message).in_file(Some(&name)))?;
        Self::from_bytes(&bytes, &name, path.parent().unwrap_or(Path::new("")), overrides)
    }

    /// Reads the bytes of a file, with overrides `KEY=VALUE`; `folder` is where a measured profile is looked for, `name` is for messages.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn from_bytes(
        bytes: &[u8],
        name: &str,
        folder: &Path,
        overrides: &[String],
    ) -> Result<Self, Error> {
        Self::from_document(overridden(bytes, name, overrides, OVERRIDE)?, folder)
    }

    /// Reads a document; `folder` is where a measured profile is looked for.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn from_document(document: Document, folder: &Path) -> Result<Self, Error> {
        if is_equation(&document) {
            return Ok(Self::Equation(Box::new(EquationFile::read(document)?)));
        }
        Ok(Self::Problem(Box::new(ProblemFile::from_document(document, folder)?)))
    }
}
