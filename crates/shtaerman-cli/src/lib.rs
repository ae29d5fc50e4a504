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
mod results;
mod snippets;
mod terminal;

use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;
use clap::error::ErrorKind;

use arguments::Arguments;
pub use commands::explore::PageEngine;
use failure::Failure;
pub use failure::{Refusal, told};
pub use report::{ContactPicture, contact_picture, contact_plot};
pub use results::{PartFormat, StudyResults};
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
    if arguments.quiet {
        failure::be_quiet();
    }
    let done = commands::execute(&arguments.command);
    clock::stop();
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

/// The JSON of a command that finds all from its arguments, `spectrum` or `roughness`, as it would print it.
///
/// # Errors
/// [`Refusal`] with its exit code.
///
/// ```
/// let arguments = ["spectrum", "log", "--a", "1", "--count", "2"].map(str::to_owned);
/// let spectrum = shtaerman_cli::json_of(&arguments)?;
/// assert!(spectrum.contains("eigenvalue"));
/// # Ok::<(), shtaerman_cli::Refusal>(())
/// ```
pub fn json_of(arguments: &[String]) -> Result<String, Refusal> {
    let name = std::iter::once("shtaerman");
    let parsed = Arguments::try_parse_from(name.chain(arguments.iter().map(String::as_str)));
    let parsed = parsed.map_err(|error| {
        let text = error.render().to_string();
        let shown: Vec<String> = text.lines().map(legible).collect();
        Refusal::new(BAD_INPUT, &shown.join("\n"))
    })?;
    let found = commands::json_of(&parsed.command);
    found.map_err(Refusal::from)
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
