//! The arguments of `shtaerman schema`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// `shtaerman schema`.
#[derive(Debug, Args)]
pub struct SchemaArguments {
    /// Of which files.
    #[arg(value_enum, default_value_t = SchemaName::Problem)]
    pub name: SchemaName,
    /// File to write [default: the terminal].
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// The schemas.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SchemaName {
    /// Problem files.
    Problem,
    /// Equation files.
    EquationFile,
    /// Study files.
    Study,
    /// JSON of `solve`.
    Answer,
    /// JSON of `find`.
    Find,
    /// JSON of `stress`.
    Stress,
    /// JSON of `equation`.
    Equation,
    /// JSON of `spectrum`.
    Spectrum,
    /// JSON of `roughness`.
    Roughness,
    /// JSON of `convergence`.
    Convergence,
    /// JSON of `regularity`.
    Regularity,
    /// JSON of `reproduce`.
    Reproduction,
    /// JSON of `trace`.
    Trace,
}
