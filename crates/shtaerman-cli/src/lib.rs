//! Command line of Shtaerman: the commands, their reports and their plots.
//!
//! ```text
//! shtaerman solve punch.toml --plot punch.svg
//! ```

pub mod arguments;
mod clock;
mod commands;
mod failure;
mod output;
pub mod plot;
mod report;

use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;
use clap::error::ErrorKind;

use arguments::Arguments;
use failure::Failure;
use shtaerman::legible;

/// Exit code of bad input.
const BAD_INPUT: u8 = 2;

/// Runs the command line on the arguments of this process.
#[must_use]
pub fn run() -> ExitCode {
    output::watch_signals();
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return explain(&error),
    };
    let done = commands::execute(&arguments.command);
    clock::stop();
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

/// Prints help, the version, or what is wrong with the arguments.
fn explain(error: &clap::Error) -> ExitCode {
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        let printed = error.print().and_then(|()| std::io::stdout().flush());
        return match printed {
            // The reader of a pipe (`head`) may leave when it has enough.
            Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
                Failure::unwritten(Path::new("standard output"), &error).report()
            }
            _ => ExitCode::SUCCESS,
        };
    }
    let text = error.render().to_string();
    let shown: String = text.lines().map(|line| legible(line) + "\n").collect();
    // Only what holds nothing strange keeps its colours.
    if shown == text {
        let _ = error.print();
    } else {
        failure::print(&shown);
    }
    ExitCode::from(BAD_INPUT)
}
