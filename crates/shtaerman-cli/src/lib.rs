//! Command line of Shtaerman: the commands, their reports and their plots.
//!
//! ```text
//! shtaerman solve punch.toml --plot punch.svg
//! ```

pub mod arguments;
mod commands;
mod failure;
mod output;
pub mod plot;
mod report;

use std::process::ExitCode;

use clap::Parser;
use clap::error::ErrorKind;

use arguments::Arguments;
use failure::Failure;

/// Exit code of bad input.
const BAD_INPUT: u8 = 2;
/// Exit code of an interrupted run.
const INTERRUPTED: i32 = 130;

/// Runs the command line on the arguments of this process.
#[must_use]
pub fn run() -> ExitCode {
    // Without a handler the run still ends on an interrupt, only without our exit code.
    let _ = ctrlc::set_handler(|| std::process::exit(INTERRUPTED));
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            let _ = error.print();
            return match error.kind() {
                ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => ExitCode::SUCCESS,
                _ => ExitCode::from(BAD_INPUT),
            };
        }
    };
    match commands::execute(&arguments.command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
