//! What several commands take: a problem file with overrides, and where results go.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// How results are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ReportFormat {
    /// A table for people, in engineering units.
    Table,
    /// JSON, in SI units.
    Json,
    /// CSV, in SI units.
    Csv,
}

/// Where results go.
#[derive(Debug, Args)]
pub struct OutputArguments {
    /// Format of the result.
    #[arg(long, value_enum, default_value = "table", value_name = "FORMAT")]
    pub format: ReportFormat,
    /// Write the result to this file instead of the terminal.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

impl OutputArguments {
    /// Whether a table goes to the terminal.
    #[must_use]
    pub fn is_table(&self) -> bool {
        self.format == ReportFormat::Table && self.output.is_none()
    }
}

/// A problem file with overrides.
#[derive(Debug, Args)]
pub struct ProblemArguments {
    /// Problem file (TOML); `-` reads standard input.
    #[arg(value_name = "FILE.toml")]
    pub file: PathBuf,
    /// Override a key of the file, such as load.force="1 MN/m"; may be given again.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub overrides: Vec<String>,
    /// End with exit code 3 when there is no answer after this time, such as "10 s"; `solve` shows the best so far then. In place of the key `solver.time_limit`.
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub time_limit: Option<String>,
}

/// Where a report goes.
#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Write a report to this file: inputs as given and in SI units, model, answer, pictures, error and audit, sense checks, and the command that repeats it (.html, or .pdf where there is a Chromium).
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
}
