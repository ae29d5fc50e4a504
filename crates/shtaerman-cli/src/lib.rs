//! Command line of Shtaerman: the commands, their reports and their plots.

pub mod plot;

use std::process::ExitCode;

/// Runs the command line on the arguments of this process.
#[must_use]
pub fn run() -> ExitCode {
    ExitCode::SUCCESS
}
