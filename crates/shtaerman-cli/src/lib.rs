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

pub use arguments::PartFormat;
use arguments::{Arguments, Command};
pub use commands::explore::PageEngine;
use failure::Failure;
pub use failure::{Refusal, told};
pub use report::{ContactPicture, contact_picture, contact_plot};
pub use results::StudyResults;
use shtaerman::file::ProblemFile;
use shtaerman::{Problem, legible};

/// Exit code of bad input.
const BAD_INPUT: u8 = 2;

/// Runs the command line on the arguments of this process.
#[must_use]
pub fn run() -> ExitCode {
    shtaerman::keep_freed_blocks();
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
    let found = commands::json_of(&parsed(arguments)?.command);
    found.map_err(Refusal::from)
}

/// What `shtaerman export` with these arguments writes, of a problem that was read before; the file among the arguments gives it its name.
///
/// # Errors
/// [`Refusal`] with its exit code.
///
/// ```
/// use std::path::Path;
/// use shtaerman::file::ProblemFile;
///
/// let text = r#"
/// [foundation]
/// young_modulus = "200 GPa"
/// poisson_ratio = 0.3
/// roughness = "1.2e-14 m/Pa"
///
/// [punch]
/// half_width = "5 mm"
/// profile = "0"
///
/// [load]
/// force = "0.8 MN/m"
/// moment = 0
/// "#;
/// let file = ProblemFile::from_bytes(text.as_bytes(), "punch.toml", Path::new(""), &[])?;
/// let arguments = ["export", "calculix", "punch.toml", "--units=mm"].map(str::to_owned);
/// let model = shtaerman_cli::export_of(&arguments, file.problem(), &file)?;
/// assert!(model.contains("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn export_of(
    arguments: &[String],
    problem: &Problem,
    file: &ProblemFile,
) -> Result<String, Refusal> {
    let Command::Export(arguments) = parsed(arguments)?.command else {
        return Err(Refusal::new(BAD_INPUT, "only export is taken here"));
    };
    Ok(commands::exported(&arguments, problem, file)?)
}

/// The arguments of a command that another program gives.
fn parsed(arguments: &[String]) -> Result<Arguments, Refusal> {
    let name = std::iter::once("shtaerman");
    let parsed = Arguments::try_parse_from(name.chain(arguments.iter().map(String::as_str)));
    parsed.map_err(|error| {
        let text = error.render().to_string();
        let shown: Vec<String> = text.lines().map(legible).collect();
        Refusal::new(BAD_INPUT, &shown.join("\n"))
    })
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
