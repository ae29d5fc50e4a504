//! Problem files: TOML with units, read into a [`Problem`].
//!
//! ```
//! let problem = shtaerman::file::parse(
//!     r#"
//!     [foundation]
//!     young_modulus = "200 GPa"
//!     poisson_ratio = 0.3
//!     roughness = "1.2e-13 m/Pa"
//!
//!     [punch]
//!     half_width = "5 mm"
//!     profile = "x^2 / (2*0.8)"
//!
//!     [load]
//!     force = "0.8 MN/m"
//!     moment = "100 N"
//!
//!     [solver]
//!     contact = "bilateral"
//!     "#,
//!     "punch.toml",
//! )?;
//! assert_eq!(problem.punch().half_width(), 5e-3);
//! # Ok::<(), shtaerman::Error>(())
//! ```

mod any;
mod geometry;
mod layering;
mod load;
mod located;
mod physical;
mod profile;
mod solver;

use std::path::Path;

use crate::document::{Document, Field, FileError, MAXIMUM_BYTES, TableReader};
use crate::equation::is_equation;
use crate::frame::Frame;
use crate::quantity::{Dimension, engineering};
use crate::{Error, Foundation, Layering, Problem, Punch};

pub use any::AnyFile;
pub use located::ProblemFile;

/// Reads a problem from text; a measured profile is looked for in the current folder. `name` is for messages.
///
/// # Errors
/// [`Error::File`] with file, line and field.
pub fn parse(text: &str, name: &str) -> Result<Problem, Error> {
    Ok(ProblemFile::read(Document::parse(text, name)?, Path::new(""))?.problem)
}

/// Reads a problem from the bytes of a file, with overrides `KEY=VALUE`; `folder` is where a measured profile is looked for.
///
/// # Errors
/// [`Error::File`] with file, line and field.
pub fn from_bytes(
    bytes: &[u8],
    name: &str,
    folder: &Path,
    overrides: &[String],
) -> Result<Problem, Error> {
    Ok(ProblemFile::from_bytes(bytes, name, folder, overrides)?.problem)
}

/// Reads a problem file, with overrides `KEY=VALUE`.
///
/// # Errors
/// [`Error::File`] with file, line and field.
pub fn open(path: &Path, overrides: &[String]) -> Result<Problem, Error> {
    Ok(ProblemFile::open(path, overrides)?.problem)
}

/// The bytes of a file of at most [`MAXIMUM_BYTES`], or what is wrong with it.
pub(crate) fn load_bytes(path: &Path) -> Result<Vec<u8>, String> {
    let readable = |error: std::io::Error| format!("cannot be read: {error}");
    let metadata = std::fs::metadata(path).map_err(readable)?;
    if metadata.is_dir() {
        return Err("is a folder, not a file".to_owned());
    }
    if metadata.len() > MAXIMUM_BYTES as u64 {
        return Err(format!(
            "has {} bytes, more than the {MAXIMUM_BYTES} that are read",
            metadata.len()
        ));
    }
    std::fs::read(path).map_err(readable)
}

/// The document in the bytes of a file, with overrides `KEY=VALUE`, of which `example` is one.
pub(crate) fn overridden(
    bytes: &[u8],
    name: &str,
    overrides: &[String],
    example: &str,
) -> Result<Document, FileError> {
    let mut document = Document::from_bytes(bytes, name)?;
    for text in overrides {
        let (key, value) = text.split_once('=').ok_or_else(|| {
            FileError::new(format!("--set {text}: has no `=`"))
                .with_help(format!("write --set {example}"))
        })?;
        document.set(key.trim(), value.trim())?;
    }
    Ok(document)
}

/// A foundation and a flat punch with the frame that both make.
struct Stated {
    foundation: Foundation,
    punch: Punch,
    frame: Frame,
}

impl Stated {
    fn new(foundation: Foundation, punch: Punch) -> Result<Self, Error> {
        let frame = Frame::new(&foundation, &punch)?;
        Ok(Self { foundation, punch, frame })
    }

    /// The same on a foundation in two pieces.
    fn on(self, layering: Layering) -> Result<Self, Error> {
        Self::new(self.foundation.with_layering(layering), self.punch)
    }
}

fn read(document: &Document, folder: &Path) -> Result<Problem, Error> {
    if is_equation(document) {
        let fault = FileError::new("is an equation, not a contact problem");
        let help = "use `shtaerman equation`";
        return Err(fault.in_file(document.file_name()).with_help(help).into());
    }
    let reader = document.reader();
    let solver = solver::read(&reader)?;
    let problem = if let Some(table) = reader.table("dimensionless")? {
        for name in ["foundation", "punch", "load", "body"] {
            if let Some(field) = reader.optional(name) {
                let message =
                    "does not go with [dimensionless]: a problem is physical or dimensionless";
                return Err(field.error(message).into());
            }
        }
        let stated = dimensionless(&table)?;
        let profile = profile::read(&table, &stated.frame, folder)?;
        let load = load::read(&table, &stated.frame)?;
        reader.finish()?;
        profile.problem(stated, load, solver)?
    } else {
        if !reader.has("foundation") && !reader.has("punch") && !reader.has("load") {
            let message = "has neither [foundation], [punch], [load] nor [dimensionless]";
            let help = "`shtaerman init` writes an example";
            return Err(FileError::new(message)
                .in_file(document.file_name())
                .with_help(help)
                .into());
        }
        let stated = physical::read(&reader)?;
        let profile = profile::read(&reader.required("punch")?.table()?, &stated.frame, folder)?;
        let load = load::read(&reader.required("load")?.table()?, &stated.frame)?;
        reader.finish()?;
        profile.problem(stated, load, solver)?
    };
    problem.check_balance()?;
    Ok(problem)
}

/// The foundation and the flat punch of `[dimensionless]`, with their frame.
fn dimensionless(table: &TableReader<'_>) -> Result<Stated, FileError> {
    let field = table.exactly_one(&["theta0", "lambda0"])?;
    let poisson_ratio = table.optional("poisson_ratio");
    let value = field.number()?;
    let by_theta0 = field.name().ends_with("theta0");
    let theta0 = if by_theta0 {
        if let Some(ratio) = poisson_ratio.filter(|_| !layering::is_bonded(table)) {
            return Err(ratio.error("goes with lambda0; theta0 alone is enough"));
        }
        value
    } else {
        let ratio_field = table.required("poisson_ratio")?;
        let ratio = ratio_field.number()?;
        if !(ratio > -1.0 && ratio <= 0.5) {
            return Err(
                ratio_field.error(format!("is {ratio}: must be greater than -1 and at most 0.5"))
            );
        }
        // theta0 = 2 (1 - nu^2)/pi lambda0
        2.0 * (1.0 - ratio * ratio) / std::f64::consts::PI * value
    };
    let geometry = geometry::read_dimensionless(table)?;
    let exponent_field = table.optional("exponent");
    let exponent = exponent_field.as_ref().map_or(Ok(1.0), Field::number)?;
    let stated = || {
        let foundation = Foundation::dimensionless(theta0)?.with_exponent(exponent)?;
        Stated::new(foundation, Punch::in_geometry(geometry, 1.0)?)
    };
    let stated = stated().map_err(|error: Error| match &error {
        Error::InvalidValue { field: "theta0", .. } if by_theta0 => refused(&field, &error),
        Error::InvalidValue { field: "theta0", .. } => {
            field.error(format!("is {value}: must be finite and not negative"))
        }
        _ => refused(exponent_field.as_ref().unwrap_or(&field), &error),
    })?;
    layering::dimensionless(table, stated)
}

/// The fault of a field whose value a constructor refused.
fn refused(field: &Field<'_>, error: &Error) -> FileError {
    match error {
        Error::InvalidValue { field: name, value, requirement } if field.name().ends_with(name) => {
            field.error(format!("is {}: must be {requirement}", shown(name, *value)))
        }
        other => field.error(other),
    }
}

/// A value as people write it, in the unit of the key.
fn shown(key: &str, value: f64) -> String {
    match key {
        "young_modulus" | "grading_modulus" | "yield_stress" => {
            engineering(value, Dimension::PRESSURE)
        }
        "half_width" => engineering(value, Dimension::LENGTH),
        "roughness" => engineering(value, Dimension::COMPLIANCE),
        "subgrade_modulus" => engineering(value, Dimension::SUBGRADE_MODULUS),
        _ => value.to_string(),
    }
}
