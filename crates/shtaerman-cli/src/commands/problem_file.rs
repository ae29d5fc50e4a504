//! The problem or equation file of a command.

use std::path::Path;
use std::time::Duration;

use shtaerman::document::{Document, FileError, load_bytes, read_bytes};
use shtaerman::equation::EquationFile;
use shtaerman::file::{AnyFile, ProblemFile};
use shtaerman::quantity::{Dimension, OutputUnits};
use shtaerman::{Contact, Error, Problem, Warning};
use shtaerman_study::Study;

use super::places;
use crate::arguments::{ProblemArguments, SenseArguments, UnitArguments};
use crate::failure::{self, shown};
use crate::output::{Input, check_writable, interrupt};
use crate::{Failure, clock};

/// The field that `--units` is, and how its override begins.
const FIELD: &str = "output.units";
const UNITS: &str = "output.units=";
/// The field that `--time-limit` is.
pub(super) const LIMIT: &str = "solver.time_limit";
/// The table that makes a problem file a study.
const STUDY: &str = "study";

/// Reads the problem, with its overrides; `-` is standard input. The outputs must be writable, and none of them a file that is read.
pub(super) fn read(
    arguments: &ProblemArguments,
    units: &UnitArguments,
    outputs: &[Option<&Path>],
) -> Result<ProblemFile, Failure> {
    let input = Input { what: "the problem file", path: &arguments.file };
    check_writable(outputs, &[input])?;
    let file = read_problem(arguments, units)?;
    let early = |limit| Error::TimeLimit { limit }.into();
    clock::start(file.problem().solver().time_limit(), early, interrupt);
    if let Some(path) = file.measured_profile() {
        check_writable(outputs, &[Input { what: "the measured profile", path }])?;
    }
    Ok(file)
}

/// The overrides, with those of units and of the time limit.
fn overrides(arguments: &ProblemArguments, units: &UnitArguments) -> Result<Vec<String>, Failure> {
    let mut overrides = arguments.overrides.clone();
    overrides.extend(units_override(units)?);
    overrides.extend(limit_override(arguments.time_limit.as_deref())?);
    Ok(overrides)
}

/// `--time-limit` as an override.
pub(super) fn limit_override(text: Option<&str>) -> Result<Option<String>, Failure> {
    let limit = text.map(time_limit).transpose()?;
    Ok(limit.map(|limit| format!("{LIMIT}={limit:e}")))
}

/// The seconds of `--time-limit`.
pub(super) fn time_limit(text: &str) -> Result<f64, Failure> {
    let limit = places::quantity("--time-limit", text, Dimension::TIME)?;
    if limit.is_nan() || limit <= 0.0 {
        let message = format!("--time-limit `{text}`: must be greater than 0, like \"10 s\"");
        return Err(Failure::Usage(message));
    }
    Ok(limit)
}

/// `--units` as an override: a system, or `KEY=UNIT` with commas between.
pub(super) fn units_override(arguments: &UnitArguments) -> Result<Option<String>, Failure> {
    let Some(text) = &arguments.units else { return Ok(None) };
    let quoted = |text: &str| serde_json::Value::from(text.trim()).to_string();
    if !text.contains('=') {
        let names = OutputUnits::SYSTEMS;
        if !names.contains(&text.trim()) {
            return Err(Failure::Usage(format!(
                "--units `{text}`: must be {}, or units of your own such as \"length=in, pressure=ksi\"",
                names.join(", ")
            )));
        }
        // As a table it takes the place of a table in the file, too.
        return Ok(Some(format!("{UNITS}{{ system = {} }}", quoted(text))));
    }
    if let Some(twice) = stated_twice(text) {
        return Err(Failure::Usage(format!("--units `{text}`: states {twice} twice")));
    }
    let pair = |part: &str| {
        let (key, unit) = part.split_once('=')?;
        Some(format!("{} = {}", quoted(key), quoted(unit)))
    };
    let pairs: Option<Vec<String>> = text.split(',').map(pair).collect();
    let pairs = pairs.ok_or_else(|| {
        Failure::Usage(format!(
            "--units `{text}`: must be KEY=UNIT with commas between, such as \"length=in, pressure=ksi\""
        ))
    })?;
    Ok(Some(format!("{UNITS}{{ {} }}", pairs.join(", "))))
}

/// What has more than one unit of `KEY=UNIT,KEY=UNIT`.
pub(super) fn stated_twice(text: &str) -> Option<&str> {
    let keys: Vec<&str> = text
        .split(',')
        .filter_map(|part| part.split_once('='))
        .map(|(key, _)| key.trim())
        .collect();
    let again = |(index, key): (usize, &&str)| keys[..index].contains(key);
    keys.iter().enumerate().find(|pair| again(*pair)).map(|(_, key)| *key)
}

/// The bytes of the problem, and its overrides.
pub(super) fn content(
    arguments: &ProblemArguments,
    units: &UnitArguments,
) -> Result<(Vec<u8>, Vec<String>), Failure> {
    let overrides = overrides(arguments, units)?;
    if arguments.file == Path::new("-") {
        return Ok((standard_input()?, overrides));
    }
    let name = arguments.file.display().to_string();
    let bytes = load_bytes(&arguments.file)
        .map_err(|message| Error::from(FileError::new(message).in_file(Some(&name))))?;
    Ok((bytes, overrides))
}

fn read_problem(
    arguments: &ProblemArguments,
    units: &UnitArguments,
) -> Result<ProblemFile, Failure> {
    let overrides = overrides(arguments, units)?;
    if arguments.file != Path::new("-") {
        return ProblemFile::open(&arguments.file, &overrides)
            .map_err(|error| of_units(units, error).unwrap_or_else(advised));
    }
    let bytes = standard_input()?;
    ProblemFile::from_bytes(&bytes, &name(&arguments.file), Path::new(""), &overrides)
        .map_err(|error| of_units(units, error).unwrap_or_else(advised))
}

/// A fault of `--units`, which is read as an override, as one of that option; else the error.
pub(super) fn of_units(units: &UnitArguments, error: Error) -> Result<Failure, Error> {
    let (Some(text), Error::File(fault)) = (&units.units, &error) else { return Err(error) };
    let is_override = fault.source_text().is_some_and(|source| source.starts_with(UNITS));
    let Some(key) = fault.field().filter(|_| is_override).and_then(|key| key.strip_prefix(FIELD))
    else {
        return Err(error);
    };
    let key = key.strip_prefix('.').map_or(String::new(), |key| format!("{key}: "));
    Ok(Failure::Usage(format!("--units `{text}`: {key}{}", fault.message())))
}

/// The fault, with the command for a file that states a study.
fn advised(error: Error) -> Failure {
    Failure::Problem(match error {
        Error::File(fault) if fault.field() == Some(STUDY) => Error::File(
            fault.with_help("a study is computed by `shtaerman sweep STUDY.toml --output FOLDER`"),
        ),
        other => other,
    })
}

/// The study of a file that states one, with its overrides.
pub(super) fn read_study(arguments: &ProblemArguments) -> Result<Option<Study>, Failure> {
    let (bytes, overrides) = content(arguments, &UnitArguments::default())?;
    let name = name(&arguments.file);
    let is_study = Document::from_bytes(&bytes, &name).is_ok_and(|file| file.get(STUDY).is_some());
    let folder = arguments.file.parent().unwrap_or(Path::new(""));
    let study = is_study.then(|| Study::from_bytes(&bytes, &name, folder, &overrides));
    Ok(study.transpose()?)
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

/// The name of the file without its folder and suffix, for titles; none for standard input.
pub(super) fn stem(path: &Path) -> String {
    if path == Path::new("-") {
        return String::new();
    }
    path.file_stem().map_or(String::new(), |stem| shown(Path::new(stem)))
}

/// What came of a solve.
pub(super) enum Solved {
    Answer(Contact),
    /// The best so far at the time limit: what the search had come to, or an answer whose audit did not end.
    Unfinished(Contact, Duration),
}

/// Share of the time limit that the search may take: the rest is for the audit of what it comes to.
const SEARCH: f64 = 0.6;
/// The same without an audit: the rest is for the curves.
const UNAUDITED_SEARCH: f64 = 0.9;

/// Solves the problem, with its audit if that is wanted, or comes as far as the time limit allows.
pub(super) fn solved(file: &ProblemFile, is_audited: bool) -> Result<Solved, Failure> {
    solved_as(file, file.problem(), is_audited)
}

/// The same of the problem of a file with another solver.
pub(super) fn solved_as(
    file: &ProblemFile,
    problem: &Problem,
    is_audited: bool,
) -> Result<Solved, Failure> {
    let located = |error| Failure::from(file.locate(error));
    let Some(limit) = problem.solver().time_limit() else {
        let contact = problem.solve().map_err(located)?;
        let audited = if is_audited { contact.audited().map_err(located)? } else { contact };
        return Ok(Solved::Answer(audited));
    };
    let share = if is_audited { SEARCH } else { UNAUDITED_SEARCH };
    let solver = problem.solver().with_time_limit(limit.mul_f64(share))?;
    match problem.with_solver(solver).solve_or_best() {
        Ok(contact) if contact.is_unfinished() => {
            let best = contact.clone();
            let audit = || clock::in_time(move || best.with_audit());
            let audited = if is_audited { audit() } else { None };
            Ok(Solved::Unfinished(audited.unwrap_or(contact), limit))
        }
        Ok(contact) if !is_audited => Ok(Solved::Answer(contact)),
        Ok(contact) => {
            let audited = contact.clone();
            match clock::in_time(move || audited.audited()) {
                Some(audited) => Ok(Solved::Answer(audited.map_err(located)?)),
                None => Ok(Solved::Unfinished(contact, limit)),
            }
        }
        Err(Error::TimeLimit { .. }) => Err(Error::TimeLimit { limit }.into()),
        Err(error) => Err(located(error)),
    }
}

/// The answer, with its audit if that is wanted.
pub(super) fn solve(file: &ProblemFile, is_audited: bool) -> Result<Contact, Failure> {
    match solved(file, is_audited)? {
        Solved::Answer(contact) => Ok(contact),
        Solved::Unfinished(_, limit) => Err(Error::TimeLimit { limit }.into()),
    }
}

/// What is doubtful about the file alone: refused with `--strict`, before anything is solved, and said where the result will not show it itself.
pub(super) fn check_input(
    file: &ProblemFile,
    sense: &SenseArguments,
    is_shown: bool,
) -> Result<(), Failure> {
    check_doubts(file.input_checks(), sense, is_shown)
}

/// The same of doubts that were found, those of options among them.
pub(super) fn check_doubts(
    doubts: Vec<Warning>,
    sense: &SenseArguments,
    is_shown: bool,
) -> Result<(), Failure> {
    let doubts = refuse(sense, doubts)?;
    if is_shown {
        failure::hold(doubts.into_iter().map(|doubt| doubt.message));
    } else {
        doubts.iter().for_each(|doubt| failure::warn(&doubt.message));
    }
    Ok(())
}

/// The doubts about an answer, which `--strict` refuses.
pub(super) fn doubts(
    file: &ProblemFile,
    contact: &Contact,
    sense: &SenseArguments,
) -> Result<Vec<Warning>, Failure> {
    refuse(sense, file.sense_checks(contact))
}

/// Doubts, unless they end the command.
pub(super) fn refuse(
    sense: &SenseArguments,
    doubts: Vec<Warning>,
) -> Result<Vec<Warning>, Failure> {
    if !sense.strict || doubts.is_empty() {
        return Ok(doubts);
    }
    let said: Vec<&str> = doubts.iter().map(|doubt| doubt.message.as_str()).collect();
    Err(Failure::Usage(format!("--strict: {}", said.join("; "))))
}
