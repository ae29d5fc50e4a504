//! The arguments of `shtaerman export`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::common::ProblemArguments;
use super::units::SenseArguments;

/// The program that reads the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Program {
    /// Abaqus.
    Abaqus,
    /// `CalculiX`.
    #[value(name = "calculix", help = "CalculiX")]
    CalculiX,
}

/// What a finite-element model takes over.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Exported {
    /// The rough layer: pressure against overclosure, and the penalty stiffness that may stand beside it.
    Surface,
    /// The whole contact: force against settlement since lift-off.
    Force,
    /// The whole contact: moment against rotation, under the force of the file.
    Moment,
}

/// Units of the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ModelUnits {
    /// N, m, Pa.
    Si,
    /// N, mm, MPa.
    Mm,
}

/// `shtaerman export`.
#[derive(Debug, Args)]
pub struct ExportArguments {
    /// The program that reads the file.
    #[arg(value_enum, value_name = "PROGRAM")]
    pub program: Program,
    #[command(flatten)]
    /// The problem.
    pub problem: ProblemArguments,
    /// What the model takes over; several with commas between.
    #[arg(
        long,
        value_enum,
        value_name = "CONTENT,...",
        default_value = "surface",
        value_delimiter = ','
    )]
    pub content: Vec<Exported>,
    /// Units of the model; the file tells them.
    #[arg(long, value_enum, value_name = "UNITS", default_value = "si")]
    pub units: ModelUnits,
    /// What straight lines between the points of a table may be off by, and what the penalty may take of the settlement.
    #[arg(long, value_name = "SHARE", default_value = "0.001", allow_hyphen_values = true)]
    pub share: String,
    /// Largest pressure of the table over the largest of the file's own contact.
    #[arg(long, value_name = "FACTOR", default_value = "10", allow_hyphen_values = true)]
    pub reach: String,
    /// Largest force of the force curve over that of the file.
    #[arg(long, value_name = "FACTOR", default_value = "1", allow_hyphen_values = true)]
    pub load_factor: String,
    /// Largest moment of the moment curve over P a, at which the punch tips over.
    #[arg(long, value_name = "SHARE", default_value = "0.5", allow_hyphen_values = true)]
    pub moment_share: String,
    /// Length of a plane punch out of the plane, such as "40 mm", for forces and moments [default: the unit of length].
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub length: Option<String>,
    /// Count the settlement relative to the surface at this x, such as "1 m".
    #[arg(long, value_name = "X", allow_hyphen_values = true, conflicts_with = "datum_depth")]
    pub datum_distance: Option<String>,
    /// Count the settlement relative to the point at this depth under the middle of the punch, such as "0.5 m".
    #[arg(long, value_name = "DEPTH", allow_hyphen_values = true)]
    pub datum_depth: Option<String>,
    /// Write the result to this file instead of the terminal.
    #[arg(long, short, value_name = "FILE.inp")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    /// What becomes of doubts.
    pub sense: SenseArguments,
}
