//! The problem or equation file of a command.

use std::path::Path;

use shtaerman::Contact;
use shtaerman::document::read_bytes;
use shtaerman::equation::EquationFile;
use shtaerman::file::{AnyFile, ProblemFile};

use crate::Failure;
use crate::arguments::ProblemArguments;
use crate::failure::shown;
use crate::output::{Input, check_writable};

/// Reads the problem, with its overrides; `-` is standard input. The outputs must be writable, and none of them a file that is read.
pub(super) fn read(
    arguments: &ProblemArguments,
    outputs: &[Option<&Path>],
) -> Result<ProblemFile, Failure> {
    let input = Input { what: "the problem file", path: &arguments.file };
    check_writable(outputs, &[input])?;
    let file = read_problem(arguments)?;
    if let Some(path) = file.measured_profile() {
        check_writable(outputs, &[Input { what: "the measured profile", path }])?;
    }
    Ok(file)
}

fn read_problem(arguments: &ProblemArguments) -> Result<ProblemFile, Failure> {
    if arguments.file != Path::new("-") {
        return Ok(ProblemFile::open(&arguments.file, &arguments.overrides)?);
    }
    Ok(ProblemFile::from_bytes(
        &standard_input()?,
        &name(&arguments.file),
        Path::new(""),
        &arguments.overrides,
    )?)
}

/// Reads the equation, with its overrides; `-` is standard input.
pub(super) fn read_equation(file: &Path, overrides: &[String]) -> Result<EquationFile, Failure> {
    if file != Path::new("-") {
        return Ok(EquationFile::open(file, overrides)?);
    }
    Ok(EquationFile::from_bytes(&standard_input()?, &name(file), overrides)?)
}

/// Reads a file of either kind.
pub(super) fn read_any(arguments: &ProblemArguments) -> Result<AnyFile, Failure> {
    if arguments.file != Path::new("-") {
        return Ok(AnyFile::open(&arguments.file, &arguments.overrides)?);
    }
    Ok(AnyFile::from_bytes(
        &standard_input()?,
        &name(&arguments.file),
        Path::new(""),
        &arguments.overrides,
    )?)
}

fn standard_input() -> Result<Vec<u8>, Failure> {
    read_bytes(std::io::stdin().lock())
        .map_err(|message| Failure::Usage(format!("standard input {message}")))
}

/// What to call the file in messages.
pub(super) fn name(path: &Path) -> String {
    if path == Path::new("-") { "standard input".to_owned() } else { shown(path) }
}

/// Solves the problem, with its audit if that is wanted.
pub(super) fn solve(file: &ProblemFile, is_audited: bool) -> Result<Contact, Failure> {
    let contact = file.solve()?;
    if !is_audited {
        return Ok(contact);
    }
    Ok(contact.audited().map_err(|error| file.locate(error))?)
}
