//! The arguments of `shtaerman sweep`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::common::ReportArguments;
use super::picture::PictureArguments;
use super::units::{SenseArguments, UnitArguments};

/// The format of the parts of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum PartFormat {
    /// Text, a line for each case.
    #[default]
    Csv,
    /// Arrays for `NumPy`, one for each column.
    Npz,
    /// Columns, for tools that take many files as one table.
    Parquet,
}

/// `shtaerman sweep`.
#[derive(Debug, Args)]
pub struct SweepArguments {
    /// Study file: a problem file (TOML) with a table [study].
    #[arg(value_name = "STUDY.toml")]
    pub file: PathBuf,
    /// Folder for the results, made where it is not there; parts of the same study that are in it are kept, so that a run that was ended goes on.
    #[arg(long, short, value_name = "FOLDER")]
    pub output: PathBuf,
    /// Format of the parts.
    #[arg(long, value_enum, default_value_t)]
    pub format: PartFormat,
    /// Override a key of the file, such as load.moment=0 or study.design=sobol; may be given again.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub overrides: Vec<String>,
    /// Time that each case may take, such as "10 s"; one that takes more has no answer. In place of the key `solver.time_limit`, and a part of the study as that is.
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub time_limit: Option<String>,
    /// Compute only the i-th of N shares of the parts, such as 2/4; the shares fill one folder, or several that are then copied together.
    #[arg(long, value_name = "I/N")]
    pub shard: Option<String>,
    /// Number of threads [default: one for each core]. The results are the same for any.
    #[arg(long, value_name = "COUNT")]
    pub threads: Option<usize>,
    /// Compute nothing: tell what the folder has, its extremes and the parts that are missing.
    #[arg(long, conflicts_with = "shard")]
    pub summary: bool,
    /// Draw the outputs over the varied value, or over one of several, to this file (.svg, .png, or .pdf, which takes a Chromium or a build with the feature `pdf`).
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    #[command(flatten)]
    /// The report.
    pub report: ReportArguments,
    /// Run studies of more than a million cases.
    #[arg(long)]
    pub yes: bool,
    #[command(flatten)]
    /// The units of the result.
    pub units: UnitArguments,
    #[command(flatten)]
    /// What becomes of doubts about the cases with the least and the largest varied values and outputs.
    pub sense: SenseArguments,
    #[command(flatten)]
    /// How the picture looks.
    pub picture: PictureArguments,
}
