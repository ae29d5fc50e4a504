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
pub use failure::told;
pub use report::contact_plot;
use shtaerman::legible;

/// Exit code of bad input.
const BAD_INPUT: u8 = 2;
/// Exit code of an interrupted run.
const INTERRUPTED: i32 = 130;

/// Runs the command line on the arguments of this process.
#[must_use]
pub fn run() -> ExitCode {
    // Without a handler the run still ends on an interrupt, only without our exit code.
    let _ = ctrlc::set_handler(|| output::interrupt(INTERRUPTED));
    survive_size_limits();
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

/// A file that grows beyond the limit of the process is then an error of writing, which is reported; by default it ends the process
/// with its temporary file left behind.
#[cfg(unix)]
fn survive_size_limits() {
    let seen = std::sync::Arc::default();
    // Without a handler all is as before.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, seen);
}

#[cfg(not(unix))]
fn survive_size_limits() {}
