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
mod output;
mod physical;
mod profile;
mod read;
mod refused;
mod section;
mod sense;
mod solver;
mod stated;
mod trace;

use std::path::Path;

use crate::document::Document;
use crate::{Error, Problem};

pub use any::AnyFile;
pub use located::{ALTERNATIVES, ProblemFile};

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
