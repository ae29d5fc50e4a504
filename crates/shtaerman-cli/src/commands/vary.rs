//! `shtaerman solve --vary`: a small study without a file of its own.

use std::fmt::Write;
use std::path::Path;

use shtaerman_study::{Row, Study, Summary};

use super::picture::{Picture, Titled};
use super::problem_file;
use super::study_sense;
use crate::Failure;
use crate::arguments::{ReportFormat, SolveArguments};
use crate::failure;
use crate::output::{Content, Input, Outputs, check_writable};
use crate::report::StudyUnits;
use crate::{report, results};

/// Most cases; more belong into a folder.
const MOST: usize = 10_000;
/// How a variation is written.
const FORM: &str = "write KEY=FROM..TO:COUNT, such as load.force=\"0.1..2 MN/m:20\", with :log behind it for a logarithmic scale, or KEY=VALUE,VALUE,.. with a unit behind the last";

pub(super) fn run(arguments: &SolveArguments) -> Result<(), Failure> {
    let picture = Picture::new(arguments.plot.as_deref(), &arguments.picture)?;
    let outputs = [arguments.output.output.as_deref(), arguments.plot.as_deref()];
    let path = &arguments.problem.file;
    check_writable(&outputs, &[Input { what: "the problem file", path }])?;
    let study = study(arguments)?;
    study_sense::check_input(&study, &[], arguments.sense)?;
    for path in study.measured_profiles()? {
        check_writable(&outputs, &[Input { what: "the measured profile", path: &path }])?;
    }
    if study.cases() > MOST {
        return Err(Failure::Usage(format!(
            "--vary: makes {} cases, at most {MOST}: `shtaerman sweep` takes more, into a folder that a run can go on with",
            study.cases()
        )));
    }
    let rows = results::solved(&study, 0..study.cases(), results::processors(), &|_| ());
    let mut summary = Summary::new(&study);
    rows.iter().for_each(|row| summary.add(row));
    let (_, doubts) = study_sense::doubts(&study, &summary, &[], arguments.sense)?;
    if let Some(refused) = rows.iter().find(|row| !row.is_answered()) {
        let count = rows.iter().filter(|row| !row.is_answered()).count();
        let message = format!(
            "{count} of {} cases have no answer; case {}: {}",
            rows.len(),
            refused.case,
            refused.reason
        );
        if count == rows.len() {
            doubts.iter().for_each(|doubt| failure::warn(doubt));
            return Err(Failure::Check(message));
        }
        failure::warn(&message);
    }
    let units = StudyUnits::new(&study, &[])?;
    let mut outputs = Outputs::default();
    let content = match arguments.output.format {
        ReportFormat::Table => {
            let warnings: String =
                doubts.iter().map(|doubt| format!("warning: {doubt}\n")).collect();
            Content::page(&format!("{}{warnings}", table(&study, &units, &rows)))
        }
        ReportFormat::Json => Content::json(report::columns(&study, &rows)),
        ReportFormat::Csv => report::rows_csv(&study, &units, &rows),
    };
    outputs.result(arguments.output.output.as_deref(), content);
    if let Some(picture) = picture {
        let name = problem_file::stem(&arguments.problem.file);
        let (figure, size) =
            report::response(&name, &study, &units, &rows, None).map_err(Failure::Usage)?;
        picture.draw(&Titled { figure, size }, &mut outputs)?;
    }
    outputs.write()?;
    if !arguments.output.is_table() {
        doubts.iter().for_each(|doubt| failure::warn(doubt));
    }
    Ok(())
}

/// The problem with a table `[study]` behind it.
fn study(arguments: &SolveArguments) -> Result<Study, Failure> {
    let (mut bytes, overrides) = problem_file::content(&arguments.problem, &arguments.units)?;
    let mut table = String::from("\n[study]\n");
    for text in &arguments.vary {
        let fault = || Failure::Usage(format!("--vary `{text}`: {FORM}"));
        let (key, values) = text.split_once('=').ok_or_else(fault)?;
        let values = variation(values).ok_or_else(fault)?;
        let _ = writeln!(table, "vary.{} = {values}", quoted(key.trim()));
    }
    if let Some(names) = &arguments.outputs {
        let names: Vec<String> = names.split(',').map(|name| quoted(name.trim())).collect();
        let _ = writeln!(table, "outputs = [{}]", names.join(", "));
    }
    let _ = writeln!(table, "audit = {}", !arguments.no_audit);
    bytes.extend(table.as_bytes());
    let path = &arguments.problem.file;
    let folder = path.parent().unwrap_or(Path::new(""));
    let name = format!("{} with --vary", problem_file::name(path));
    Study::from_bytes(&bytes, &name, folder, &overrides).map_err(|error| {
        problem_file::of_units(&arguments.units, error).unwrap_or_else(Failure::from)
    })
}

/// Text as TOML has it.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// `FROM..TO UNIT:COUNT`, with `:log` behind it, as a table; `VALUE,VALUE UNIT` as a list.
fn variation(text: &str) -> Option<String> {
    let Some((from, rest)) = text.split_once("..") else {
        let values: Vec<&str> = text.split(',').map(str::trim).collect();
        let unit = unit(values.last()?);
        let listed = values.iter().map(|value| with_unit(value, unit));
        return values
            .iter()
            .all(|value| !value.is_empty())
            .then(|| format!("[{}]", listed.collect::<Vec<_>>().join(", ")));
    };
    let (rest, scale) = match rest.strip_suffix(":log") {
        Some(rest) => (rest, "log"),
        None => (rest, "linear"),
    };
    let (to, count) = rest.rsplit_once(':')?;
    let count: usize = count.trim().parse().ok()?;
    let (from, to) = (from.trim(), to.trim());
    let unit = unit(to);
    (!from.is_empty() && !to.is_empty()).then(|| {
        let (from, to) = (with_unit(from, unit), with_unit(to, unit));
        format!("{{ from = {from}, to = {to}, count = {count}, scale = \"{scale}\" }}")
    })
}

/// The unit behind a number; empty where there is none.
fn unit(text: &str) -> &str {
    text.split_once(char::is_whitespace).map_or("", |(_, unit)| unit.trim())
}

/// A number with this unit unless it has its own; what is no number is left as it is.
fn with_unit(text: &str, unit: &str) -> String {
    match text.parse::<f64>() {
        Ok(_) if unit.is_empty() => text.to_owned(),
        Ok(_) => quoted(&format!("{text} {unit}")),
        Err(_) => quoted(text),
    }
}

/// The rows for people: what varies and the outputs, in SI units or without dimensions, and the largest error of each.
fn table(study: &Study, units: &StudyUnits, rows: &[Row]) -> String {
    let mut text = report::rows_table(study, units, rows);
    let stated = study.outputs().iter().enumerate().filter_map(|(index, output)| {
        let largest = rows.iter().filter_map(|row| row.errors[index]).reduce(f64::max)?;
        let scaled = units.column(&output.name);
        Some(format!("{} {:.1e}", output.name, largest * scaled.factor))
    });
    let stated: Vec<String> = stated.collect();
    let kinds: Vec<&str> = ["bound", "estimate"]
        .into_iter()
        .filter(|kind| rows.iter().any(|row| row.error_kind == *kind))
        .collect();
    if !stated.is_empty() {
        let _ = writeln!(text, "largest errors ({}s): {}", kinds.join("s and "), stated.join(", "));
    }
    text
}
