//! Kernels, their spectra and equations on them for the page.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::{Value, json};
use shtaerman::equation::{Family, NamedKernel, Spectrum};

use super::asked::{self, Asked};
use crate::Failure;
use crate::commands::{equation, spectrum};
use crate::report;

/// Eigenvalues that are asked for at most.
const MOST: usize = 200;
/// Eigenfunctions that are drawn at most.
const MOST_DRAWN: usize = 12;

/// A kernel.
#[derive(Debug, Deserialize)]
pub(super) struct AskedKernel {
    name: String,
    #[serde(default)]
    half_line: bool,
    parameters: BTreeMap<String, f64>,
    count: usize,
    drawn: usize,
}

/// All kernels with their parameters.
pub(super) fn families() -> Value {
    let family = |family: &Family| {
        let parameters = family.parameters.iter().map(|parameter| {
            json!({ "name": parameter.name, "range": parameter.range, "is_whole": parameter.is_whole })
        });
        json!({
            "name": family.name,
            "half_line": family.is_half_line,
            "title": family.title(),
            "formula": family.formula,
            "interval": family.interval,
            "weight": family.weight,
            "measure": family.measure,
            "parameters": parameters.collect::<Vec<_>>(),
        })
    };
    Value::Array(Family::all().iter().map(family).collect())
}

/// The spectrum as `spectrum --format json` writes it, with the first eigenfunctions.
pub(super) fn told(asked: &AskedKernel) -> Result<Value, Failure> {
    let kernel = kernel(asked)?;
    let count = asked.count.clamp(1, MOST);
    let spectrum = Spectrum::new(&kernel, count, false).map_err(spectrum::usage)?;
    let plot = spectrum::curves(&spectrum, asked.drawn.clamp(1, MOST_DRAWN));
    Ok(json!({
        "spectrum": serde_json::to_value(&spectrum).map_err(asked::unwritable)?,
        "title": kernel.title(),
        "functions": plot,
        "command": command(asked),
    }))
}

fn kernel(asked: &AskedKernel) -> Result<NamedKernel, Failure> {
    let family = Family::find(&asked.name, asked.half_line)
        .ok_or_else(|| Failure::Usage(format!("{:?} is no kernel", asked.name)))?;
    let values = family.parameters.iter().map(|parameter| {
        asked.parameters.get(parameter.name).copied().ok_or_else(|| {
            Failure::Usage(format!("{} is missing: {}", parameter.name, parameter.range))
        })
    });
    spectrum::named(family, &values.collect::<Result<Vec<_>, _>>()?)
}

fn command(asked: &AskedKernel) -> String {
    let half_line = if asked.half_line { " --interval half-line" } else { "" };
    let parameters = asked.parameters.iter().map(|(name, value)| format!(" --{name} {value}"));
    format!("shtaerman spectrum {}{half_line}{}", asked.name, parameters.collect::<String>())
}

/// An equation as `equation` solves it.
pub(super) fn equation(asked: &Asked) -> Result<Value, Failure> {
    let file = asked.equation()?;
    let solved = file.equation().solve_to(0.0).map_err(|error| file.locate(error))?;
    let solved = solved.audited().map_err(|error| file.locate(error))?;
    let places = solved.places(equation::POINTS)?;
    let answer = solved.answer(places).map_err(|error| file.locate(error))?;
    Ok(json!({
        "answer": serde_json::to_value(&answer).map_err(asked::unwritable)?,
        "text": report::equation_table(&asked.name, &solved, &answer, false)?.to_string(),
    }))
}
