//! The profile of a punch.

use std::path::{Path, PathBuf};

use super::stated::Stated;
use super::trace;
use crate::bodies::Bodies;
use crate::document::{Document, Field, FileError, TableReader, ValueKind};
use crate::{Error, Load, Problem, Profile, Solver, Warning};

/// A profile with its field, for messages that need the finished problem.
pub(super) struct ReadProfile<'d> {
    field: Field<'d>,
    profile: Profile,
    /// What is doubtful about the units of a trace.
    pub(super) doubts: Vec<Warning>,
}

pub(super) fn read<'d>(
    table: &TableReader<'d>,
    bodies: &Bodies,
    folder: &Path,
) -> Result<ReadProfile<'d>, FileError> {
    let field = table.required("profile").map_err(|error| match error.help() {
        Some(_) => error,
        None => error.with_help("profile = \"0\" is a flat base"),
    })?;
    let (profile, doubts) = if field.is_table() {
        trace::read(&field, bodies, folder)?
    } else {
        (expression(&field, bodies)?, Vec::new())
    };
    Ok(ReadProfile { field, profile, doubts })
}

impl ReadProfile<'_> {
    /// The problem; what it finds wrong with the profile is told at the profile.
    pub(super) fn problem(
        self,
        stated: Stated,
        load: Load,
        solver: Solver,
    ) -> Result<Problem, Error> {
        let punch = stated.punch.with_profile(self.profile);
        let problem = Problem::new(stated.foundation, punch, load);
        problem.map(|problem| problem.with_solver(solver)).map_err(|error| match error {
            Error::ProfileNotFinite { .. } => {
                let message = error.to_string();
                self.field.error(message.strip_prefix("the profile ").unwrap_or(&message)).into()
            }
            other => other,
        })
    }
}

/// A formula; a bare number is a constant, so that `--set punch.profile=0` needs no quotes within quotes.
fn expression(field: &Field<'_>, bodies: &Bodies) -> Result<Profile, FileError> {
    let constant = field.number().ok().map(|value| format!("{value:e}"));
    let text = if let Some(text) = &constant { text } else { field.string()? };
    let parsed =
        if bodies.is_circular() { Profile::radial(text) } else { Profile::expression(text) };
    parsed.map_err(|error| {
        let fault = field.error_within(&error, error.span.clone());
        match error.help() {
            _ if is_file_name(text) => {
                let name = serde_json::Value::from(text.trim());
                fault.with_help(format!(
                    "a measured profile is a table:\nprofile = {{ csv = {name} }}"
                ))
            }
            Some(help) => fault.with_help(help),
            None => fault,
        }
    })
}

/// Whether what is no formula ends as files of measured profiles do.
fn is_file_name(text: &str) -> bool {
    let endings = ["csv", "txt", "tsv", "dat", "asc", "prf"];
    let ending = text.trim().rsplit_once('.').map(|(_, ending)| ending.to_lowercase());
    ending.is_some_and(|ending| endings.contains(&ending.as_str()))
}

/// The file that `profile = { csv = ".." }` names in a document that was read.
pub(super) fn measured_path(document: &Document, folder: &Path) -> Option<PathBuf> {
    let written = ["punch.profile.csv", "dimensionless.profile.csv"];
    let value = written.into_iter().find_map(|key| document.get(key))?;
    match value.kind() {
        ValueKind::String(name) => Some(folder.join(name)),
        _ => None,
    }
}
