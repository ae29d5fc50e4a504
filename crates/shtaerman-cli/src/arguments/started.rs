//! What one runs before the first problem: an example, completions, manual pages.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// `shtaerman init`.
#[derive(Debug, Args)]
pub struct InitArguments {
    /// File to write; `-` for the terminal [default: punch.toml, equation.toml with --equation].
    #[arg(value_name = "FILE.toml")]
    pub file: Option<PathBuf>,
    /// Write the dimensionless form.
    #[arg(long, conflicts_with = "equation")]
    pub dimensionless: bool,
    /// Write an equation file, for `shtaerman equation`.
    #[arg(long)]
    pub equation: bool,
    /// Whose base is pressed.
    #[arg(long, value_enum, default_value_t = ExampleGeometry::Plane, conflicts_with_all = ["dimensionless", "equation"])]
    pub geometry: ExampleGeometry,
    /// Overwrite an existing file.
    #[arg(long)]
    pub force: bool,
}

/// The geometries of which there is an example.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ExampleGeometry {
    /// A long punch.
    Plane,
    /// A round punch.
    Circular,
    /// A wavy face.
    Periodic,
    /// Two feet of one body.
    Pair,
}

/// `shtaerman completions`.
#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell.
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
    /// File to write [default: the terminal].
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// `shtaerman man`.
#[derive(Debug, Args)]
pub struct ManArguments {
    /// Folder that is there, into which `shtaerman.1`, `shtaerman-solve.1` and the others are written.
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
}
