//! A problem from a document.

use std::path::Path;

use super::refused::refused;
use super::stated::Stated;
use super::{geometry, layering, load, output, physical, profile, section, solver};
use crate::document::{Document, Field, FileError, TableReader};
use crate::equation::is_equation;
use crate::quantity::OutputUnits;
use crate::{Error, Foundation, Problem, Punch, Warning};

/// What a document states.
pub(super) struct ReadProblem {
    pub(super) problem: Problem,
    /// The units in which results are wanted.
    pub(super) units: OutputUnits,
    /// What is doubtful about the units of a trace.
    pub(super) doubts: Vec<Warning>,
}

/// The problem of a document.
pub(super) fn read(document: &Document, folder: &Path) -> Result<ReadProblem, Error> {
    if is_equation(document) {
        let fault = FileError::new("is an equation, not a contact problem");
        let help = "use `shtaerman equation`";
        return Err(fault.in_file(document.file_name()).with_help(help).into());
    }
    let reader = document.reader();
    let solver = solver::read(&reader)?;
    let table = reader.table("dimensionless")?;
    let is_bare = table.is_some();
    let (stated, punch) = if let Some(table) = table {
        for name in ["foundation", "punch", "load", "body"] {
            if let Some(field) = reader.optional(name) {
                let message =
                    "does not go with [dimensionless]: a problem is physical or dimensionless";
                return Err(field.error(message).into());
            }
        }
        (dimensionless(&table)?, table)
    } else {
        if !reader.has("foundation") && !reader.has("punch") && !reader.has("load") {
            let message = "has neither [foundation], [punch], [load] nor [dimensionless]";
            let help = "`shtaerman init` writes an example";
            return Err(FileError::new(message)
                .in_file(document.file_name())
                .with_help(help)
                .into());
        }
        (physical::read(&reader)?, section::required(&reader, "punch")?)
    };
    solver::require_degenerate_kernel(&reader, &stated.bodies)?;
    let mut profile = profile::read(&punch, &stated.bodies, folder)?;
    let doubts = std::mem::take(&mut profile.doubts);
    let load = if is_bare { punch } else { section::required(&reader, "load")? };
    let load = load::read(&load, &stated.bodies)?;
    let units = output::read(&reader, &stated.bodies)?;
    reader.finish()?;
    let problem = profile.problem(stated, load, solver)?;
    problem.check_balance()?;
    Ok(ReadProblem { problem, units, doubts })
}

/// The foundation and the flat punch of `[dimensionless]`, with the bodies that they are.
fn dimensionless(table: &TableReader<'_>) -> Result<Stated, FileError> {
    let field = table.exactly_one(&["theta0", "lambda0"])?;
    let poisson_ratio = table.optional("poisson_ratio");
    let value = field.number()?;
    let by_theta0 = field.name().ends_with("theta0");
    let theta0 = if by_theta0 {
        if let Some(ratio) = poisson_ratio.filter(|_| !layering::is_bonded(table)) {
            return Err(
                ratio.error("goes with lambda0 and with base = \"bonded\"; theta0 alone is enough")
            );
        }
        value
    } else {
        let ratio_field = table.required("poisson_ratio")?;
        let ratio = ratio_field.number()?;
        if !(ratio > -1.0 && ratio <= 0.5) {
            return Err(
                ratio_field.error(format!("is {ratio}: must be greater than -1 and at most 0.5"))
            );
        }
        // theta0 = 2 (1 - nu^2)/pi lambda0
        2.0 * (1.0 - ratio * ratio) / std::f64::consts::PI * value
    };
    let geometry = geometry::read_dimensionless(table)?;
    let exponent_field = table.optional("exponent");
    let exponent = exponent_field.as_ref().map_or(Ok(1.0), Field::number)?;
    let stated = || {
        let foundation = Foundation::dimensionless(theta0)?.with_exponent(exponent)?;
        Stated::new(foundation, Punch::in_geometry(geometry, 1.0)?)
    };
    let stated = stated().map_err(|error: Error| match &error {
        Error::InvalidValue { field: "theta0", .. } if by_theta0 => refused(&field, &error),
        Error::InvalidValue { field: "theta0", .. } => {
            field.error(format!("is {value}: must be finite and not negative"))
        }
        _ => refused(exponent_field.as_ref().unwrap_or(&field), &error),
    })?;
    layering::dimensionless(table, stated)
}
