//! What a study found: extremes for people, and the response as a plot.

use std::fmt::Write;

use shtaerman_study::{Column, Design, Indices, Manifest, Output, Row, Study, Summary};

use super::{Table, significant};
use crate::plot::{
    Bars, Figure, Plot, ResponseCurve, ResponseMap, ResponsePlot, ResponseSurface, Size,
    TornadoPlot,
};

/// Significant digits of a value, and of an error.
const DIGITS: usize = 6;
const ERROR_DIGITS: usize = 2;
/// Most rows that are kept for a plot.
const MOST_PLOTTED: usize = 20_000;

/// A study that was run, or looked at.
pub(crate) struct SweepReport<'r> {
    /// Of all rows that there are.
    pub(crate) summary: &'r Summary,
    /// Parts in all; of those that were there, were computed and are missing.
    pub(crate) parts: usize,
    pub(crate) kept: usize,
    pub(crate) computed: usize,
    pub(crate) missing: usize,
    /// Cases of the sample, without and with their audits.
    pub(crate) audited: &'r [(Row, Row)],
}

/// Keeps rows for a plot.
pub(crate) fn keep(kept: &mut Vec<Row>, rows: Vec<Row>) {
    let room = MOST_PLOTTED.saturating_sub(kept.len());
    kept.extend(rows.into_iter().take(room));
}

/// The study for people; SI units.
pub(crate) fn sweep_table(study: &Study, manifest: &Manifest, report: &SweepReport<'_>) -> String {
    let SweepReport { summary, .. } = report;
    let design = match study.design() {
        Design::Grid => "a grid".to_owned(),
        Design::LatinHypercube { seed, .. } => format!("a Latin hypercube with seed {seed}"),
        Design::Sobol { seed, .. } => format!("a Sobol sequence with seed {seed}"),
        Design::SobolIndices { seed, .. } => {
            format!("groups of a Sobol sequence with seed {seed}")
        }
        Design::Random { seed, .. } => format!("random cases with seed {seed}"),
    };
    let mut text = format!(
        "{}: {} cases, {design} over {}\n\n",
        manifest.study,
        manifest.cases,
        manifest.variables.join(", ")
    );
    let units = units(study);
    let mut table = Table::new(&[
        &format!("output{units}"),
        "least",
        "case",
        "largest",
        "case",
        "mean",
        "deviation",
        "error, largest",
    ]);
    for extreme in summary.extremes.iter().filter(|_| summary.answered > 0) {
        table.row(vec![
            extreme.name.clone(),
            significant(extreme.least.0, DIGITS),
            extreme.least.1.to_string(),
            significant(extreme.largest.0, DIGITS),
            extreme.largest.1.to_string(),
            significant(extreme.mean, DIGITS),
            significant(extreme.standard_deviation, DIGITS),
            extreme.error.map_or(String::new(), |error| significant(error, ERROR_DIGITS)),
        ]);
    }
    let _ = writeln!(text, "{table}");
    let _ = writeln!(
        text,
        "parts: {} computed, {} kept, {} missing, of {}; {} cases answered, {} refused",
        report.computed,
        report.kept,
        report.missing,
        report.parts,
        summary.answered,
        summary.refused
    );
    for (reason, first, count) in &summary.reasons {
        let _ = writeln!(text, "refused {count} times, first case {first}: {reason}");
    }
    if !study.is_audited() {
        let _ = writeln!(
            text,
            "errors: those that the method states of itself; audit = true in [study] audits every case"
        );
    }
    text.push_str(&indices(study, summary));
    text.push_str(&audits(study, report.audited));
    text
}

/// What varies and the outputs of each case.
pub(crate) fn rows_table(study: &Study, rows: &[Row]) -> String {
    let units = units(study);
    let keys = study.variables().iter().map(|variable| variable.key.clone());
    let names = study.outputs().iter().map(|output| format!("{}{units}", output.name));
    let heads: Vec<String> = keys.chain(names).collect();
    let mut table = Table::new(&heads.iter().map(String::as_str).collect::<Vec<_>>());
    for row in rows {
        let inputs = row.inputs.iter().map(|input| match input.number() {
            Some(value) => significant(value, DIGITS),
            None => input.to_string(),
        });
        let outputs = row.outputs.iter().map(|value| significant(*value, DIGITS));
        table.row(inputs.chain(outputs).collect());
    }
    format!("{table}\n")
}

/// The columns of rows as a JSON object of arrays.
pub(crate) fn columns(study: &Study, rows: &[Row]) -> serde_json::Value {
    let array = |column: Column| match column {
        Column::Whole(values) => serde_json::Value::from(values),
        // NaN becomes null.
        Column::Number(values) => serde_json::Value::from(values),
        Column::Text(values) => serde_json::Value::from(values),
    };
    let arrays = study.arrays(rows).into_iter().map(array);
    serde_json::Value::Object(study.columns().into_iter().zip(arrays).collect())
}

/// What is said of units behind a name.
fn units(study: &Study) -> &'static str {
    if study.is_dimensionless() { "" } else { ", SI" }
}

/// The share of the variance of each output that each varied value has, alone and with all others.
fn indices(study: &Study, summary: &Summary) -> String {
    let Some(indices) = &summary.indices else { return String::new() };
    let mut table = Table::new(&["output", "varied value", "first order", "+-", "total", "+-"]);
    for (output, index) in study.outputs().iter().zip(0..) {
        for (variable, found) in study.variables().iter().zip(indices.of(index)) {
            table.row(vec![
                output.name.clone(),
                variable.key.clone(),
                format!("{:.4}", found.first),
                format!("{:.4}", found.first_error),
                format!("{:.4}", found.total),
                format!("{:.4}", found.total_error),
            ]);
        }
    }
    format!(
        "\nSobol's indices from {} groups, with their standard errors for independent groups: estimates\n{table}\n",
        indices.groups()
    )
}

/// One line for each output: how the errors of the sample compare with those of its audits.
fn audits(study: &Study, audited: &[(Row, Row)]) -> String {
    if audited.is_empty() {
        return String::new();
    }
    let refused = audited.iter().filter(|(_, row)| !row.is_answered()).count();
    let mut text = format!("audit of a sample of {} cases: {refused} not kept", audited.len());
    for (index, output) in study.outputs().iter().enumerate() {
        let largest = |row: fn(&(Row, Row)) -> &Row| {
            audited.iter().filter_map(|pair| row(pair).errors[index]).reduce(f64::max)
        };
        if let (Some(stated), Some(found)) = (largest(|pair| &pair.0), largest(|pair| &pair.1)) {
            let _ = write!(
                text,
                "; {} stated to {}, audited {}",
                output.name,
                significant(stated, ERROR_DIGITS),
                significant(found, ERROR_DIGITS)
            );
        }
    }
    text.push('\n');
    for (_, row) in audited.iter().filter(|(_, row)| !row.is_answered()) {
        let _ = writeln!(text, "audit of case {}: {}", row.case, row.reason);
    }
    text
}

/// The outputs over the varied values: bars for Sobol's indices, bands of colour over a grid of two numbers, else over the first variable that is a number, as a curve where it is the only one.
///
/// # Errors
/// Why there is nothing to draw.
pub(crate) fn response(
    study: &Study,
    rows: &[Row],
    summary: Option<&Summary>,
) -> Result<(Figure, Size), String> {
    if let Some(indices) = summary.and_then(|summary| summary.indices.as_ref()) {
        return Ok((tornado(study, indices).figure(), Size::default()));
    }
    let variables = study.variables();
    let numeric = |index: usize| rows.iter().all(|row| row.inputs[index].number().is_some());
    if variables.len() == 2
        && rows.len() == study.cases()
        && numeric(0)
        && numeric(1)
        && let Some(map) = response_map(study, rows)
    {
        return Ok((map.figure(), map.size()));
    }
    let Some(variable) = (0..variables.len()).find(|index| numeric(*index)) else {
        return Err("--plot: none of the varied values is a number".to_owned());
    };
    let units = units(study);
    let curves = study.outputs().iter().enumerate().map(|(index, output)| ResponseCurve {
        label: format!("{}{units}", output.name),
        points: rows
            .iter()
            .filter(|row| row.is_answered())
            .filter_map(|row| Some((row.inputs[variable].number()?, row.outputs[index])))
            .collect(),
    });
    let plot = ResponsePlot {
        title: "Response".to_owned(),
        horizontal_label: format!("{}{units}", variables[variable].key),
        is_connected: variables.len() == 1 && study.design() == Design::Grid,
        curves: curves.collect(),
    };
    Ok((plot.figure(), Size::default()))
}

/// The outputs over a whole grid of two numbers; none unless both have at least two different values in increasing order.
fn response_map(study: &Study, rows: &[Row]) -> Option<ResponseMap> {
    let values = |index: usize| {
        if study.design() != Design::Grid {
            return None;
        }
        let numbers: Vec<f64> = study.variables()[index].variation.numbers().collect();
        let is_increasing = numbers.len() > 1 && numbers.is_sorted_by(|a, b| a < b);
        is_increasing.then_some(numbers)
    };
    // The last variable changes fastest: it goes along.
    let (up, along) = (values(0)?, values(1)?);
    let units = units(study);
    let label = |index: usize| format!("{}{units}", study.variables()[index].key);
    let surface = |(index, output): (usize, &Output)| ResponseSurface {
        label: format!("{}{units}", output.name),
        values: rows.iter().map(|row| row.outputs[index]).collect(),
    };
    Some(ResponseMap {
        title: "Response".to_owned(),
        labels: [label(1), label(0)],
        values: [along, up],
        // What is the same everywhere, such as a prescribed value, has no map.
        surfaces: study.outputs().iter().enumerate().map(surface).filter(is_varied).collect(),
    })
    .filter(|map| !map.surfaces.is_empty())
}

fn is_varied(surface: &ResponseSurface) -> bool {
    surface.values.iter().any(|value| *value != surface.values[0])
}

fn tornado(study: &Study, indices: &Indices) -> TornadoPlot {
    let bars = |(index, output): (usize, &Output)| Bars {
        name: output.name.clone(),
        shares: indices.of(index).map(|found| [found.first, found.total]).collect(),
    };
    TornadoPlot {
        title: "Which value matters".to_owned(),
        notes: vec![format!("Sobol's indices from {} groups: estimates", indices.groups())],
        names: study.variables().iter().map(|variable| variable.key.clone()).collect(),
        outputs: study.outputs().iter().enumerate().map(bars).collect(),
    }
}
