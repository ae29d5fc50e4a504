//! What a study found: extremes for people, and the response as a plot.

use std::fmt::Write;

use shtaerman_study::{Column, Design, Indices, Manifest, Output, Row, Study, Summary};

use super::{Scaled, StudyUnits, Table, Told, heading, significant};
use crate::output::Content;
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
    /// How many cases with extremes were looked at, and the doubts about them.
    pub(crate) sense: Option<&'r (usize, Vec<String>)>,
}

/// A number, if there is one: a case without an answer has none, and the pressure at a corner without roughness is infinite.
fn number(value: f64, digits: usize) -> String {
    match value {
        _ if value.is_nan() => "-".to_owned(),
        _ if value.is_infinite() => "infinite".to_owned(),
        _ => significant(value, digits),
    }
}

/// `1 case`, `2 cases`.
fn cases(count: usize) -> String {
    if count == 1 { "1 case".to_owned() } else { format!("{count} cases") }
}

/// `once`, `2 times`.
fn times_said(count: usize) -> String {
    if count == 1 { "once".to_owned() } else { format!("{count} times") }
}

/// Keeps rows for a plot.
pub(crate) fn keep(kept: &mut Vec<Row>, rows: Vec<Row>) {
    let room = MOST_PLOTTED.saturating_sub(kept.len());
    kept.extend(rows.into_iter().take(room));
}

/// The study for people.
pub(crate) fn sweep_table(
    study: &Study,
    units: &StudyUnits,
    manifest: &Manifest,
    report: &SweepReport<'_>,
) -> Told {
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
    let mut text = Told::new(format!(
        "{}: {}, {design} over {}\n\n",
        manifest.study,
        cases(manifest.cases),
        manifest.variables.join(", ")
    ));
    let mut table = Table::new(&[
        "output",
        "least",
        "case",
        "largest",
        "case",
        "mean",
        "deviation",
        "error, largest",
    ]);
    for extreme in summary.extremes.iter().filter(|_| summary.answered > 0) {
        let Scaled { name, factor } = units.column(&extreme.name);
        let shown = |value: f64, digits: usize| number(value * factor, digits);
        table.row(vec![
            name,
            shown(extreme.least.0, DIGITS),
            extreme.least.1.to_string(),
            shown(extreme.largest.0, DIGITS),
            extreme.largest.1.to_string(),
            shown(extreme.mean, DIGITS),
            shown(extreme.standard_deviation, DIGITS),
            extreme.error.map_or(String::new(), |error| shown(error, ERROR_DIGITS)),
        ]);
    }
    text.table(table);
    text.push('\n');
    for extreme in summary.extremes.iter().filter(|extreme| extreme.infinite > 0) {
        let _ = writeln!(
            text,
            "{} is infinite in {}: its mean, deviation and error are those of the others",
            extreme.name,
            cases(extreme.infinite)
        );
    }
    let _ = writeln!(
        text,
        "parts: {} computed, {} kept, {} missing, of {}; {} answered, {} refused",
        report.computed,
        report.kept,
        report.missing,
        report.parts,
        cases(summary.answered),
        summary.refused
    );
    for (reason, first, count) in &summary.reasons {
        let _ = writeln!(text, "refused {}, first case {first}: {reason}", times_said(*count));
    }
    for (code, first, count) in &summary.warnings {
        let _ = writeln!(text, "warned {}, first case {first}: {code}", times_said(*count));
    }
    if !study.is_audited() {
        let _ = writeln!(
            text,
            "errors: those that the method states of itself; audit = true in [study] audits every case"
        );
    }
    text.push_str(&indices(study, summary));
    text.push_str(&audits(study, units, report.audited));
    if let Some((looked_at, doubts)) = report.sense.filter(|(looked_at, _)| *looked_at > 0) {
        let found = match doubts.len() {
            0 => "nothing to doubt there".to_owned(),
            1 => "1 doubt".to_owned(),
            count => format!("{count} doubts"),
        };
        let _ = writeln!(
            text,
            "sense checks of {looked_at} of {}, the first with each warning and those with the least and the largest varied values and outputs: {found}",
            cases(manifest.cases)
        );
        for doubt in doubts {
            let _ = writeln!(text, "warning: {doubt}");
        }
    }
    text
}

/// What varies and the outputs of each case.
pub(crate) fn rows_table(study: &Study, units: &StudyUnits, rows: &[Row]) -> String {
    let (inputs, outputs) = columns_of(study, |name| units.column(name));
    let names = inputs.iter().chain(&outputs).map(|one| one.name.as_str());
    let heads: Vec<&str> = std::iter::once("case").chain(names).collect();
    let mut table = Table::new(&heads).with_keys(1 + inputs.len());
    for row in rows {
        let varied = row.inputs.iter().zip(&inputs).map(|(input, scaled)| match input.number() {
            Some(value) => number(value * scaled.factor, DIGITS),
            None => input.to_string(),
        });
        let found = row.outputs.iter().zip(&outputs);
        let found = found.map(|(value, scaled)| number(value * scaled.factor, DIGITS));
        table.row(std::iter::once(row.case.to_string()).chain(varied).chain(found).collect());
    }
    format!("{table}\n")
}

/// The varied keys and the outputs, each with its unit.
fn columns_of(study: &Study, unit: impl Fn(&str) -> Scaled) -> (Vec<Scaled>, Vec<Scaled>) {
    let inputs = study.variables().iter().map(|variable| unit(&variable.key));
    let outputs = study.outputs().iter().map(|output| unit(&output.name));
    (inputs.collect(), outputs.collect())
}

/// The rows as CSV: in SI units, or in those chosen, which the header says.
pub(crate) fn rows_csv<'a>(study: &'a Study, units: &StudyUnits, rows: &'a [Row]) -> Content<'a> {
    let columns = csv_columns(study, units);
    let factors: Vec<f64> = columns.iter().map(|column| column.factor).collect();
    let header: Vec<String> = columns.into_iter().map(|column| column.name).collect();
    let rows = rows.iter().map(move |row| {
        let fields = study.fields(row).into_iter().zip(&factors);
        fields.map(|(text, factor)| times(text, *factor)).collect::<Vec<String>>()
    });
    Content::csv(&header, rows)
}

/// The columns of rows as CSV, with units where some were chosen.
pub(crate) fn csv_columns(study: &Study, units: &StudyUnits) -> Vec<Scaled> {
    let outputs = study.outputs();
    let of_output = |name: &str| outputs.iter().any(|output| output.name == name);
    let column = |name: String| {
        let quantity = name.strip_suffix("_error").filter(|of| of_output(of)).unwrap_or(&name);
        units.file_column(&name, quantity)
    };
    study.columns().into_iter().map(column).collect()
}

/// A field in the unit of its column; what is no number is left as it is.
pub(crate) fn times(text: String, factor: f64) -> String {
    if factor == 1.0 {
        return text;
    }
    text.parse::<f64>().map_or(text, |value| (value * factor).to_string())
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

/// The share of the variance of each output that each varied value has, alone and with all others.
fn indices(study: &Study, summary: &Summary) -> String {
    let Some(indices) = &summary.indices else { return String::new() };
    // An output that does not vary has no share of a variance.
    let share = |value: f64| if value.is_nan() { "-".to_owned() } else { format!("{value:.4}") };
    let mut table = Table::new(&["output", "varied value", "first order", "+-", "total", "+-"]);
    for (output, index) in study.outputs().iter().zip(0..) {
        for (variable, found) in study.variables().iter().zip(indices.of(index)) {
            table.row(vec![
                output.name.clone(),
                variable.key.clone(),
                share(found.first),
                share(found.first_error),
                share(found.total),
                share(found.total_error),
            ]);
        }
    }
    format!(
        "\nSobol's indices from {} groups, with their standard errors for independent groups: estimates\n{table}\n",
        indices.groups()
    )
}

/// One line for each output: how the errors of the sample compare with those of its audits.
fn audits(study: &Study, units: &StudyUnits, audited: &[(Row, Row)]) -> String {
    if audited.is_empty() {
        return String::new();
    }
    let refused = audited.iter().filter(|(_, row)| !row.is_answered()).count();
    let mut text = format!("audit of a sample of {}: {refused} not kept", cases(audited.len()));
    for (index, output) in study.outputs().iter().enumerate() {
        let largest = |row: fn(&(Row, Row)) -> &Row| {
            audited.iter().filter_map(|pair| row(pair).errors[index]).reduce(f64::max)
        };
        if let (Some(stated), Some(found)) = (largest(|pair| &pair.0), largest(|pair| &pair.1)) {
            let factor = units.column(&output.name).factor;
            let _ = write!(
                text,
                "; {} stated to {}, audited {}",
                output.name,
                significant(stated * factor, ERROR_DIGITS),
                significant(found * factor, ERROR_DIGITS)
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
    name: &str,
    study: &Study,
    units: &StudyUnits,
    rows: &[Row],
    summary: Option<&Summary>,
) -> Result<(Figure, Option<Size>), String> {
    if let Some(indices) = summary.and_then(|summary| summary.indices.as_ref()) {
        return Ok((tornado(name, study, indices).figure(), None));
    }
    let variables = study.variables();
    let numeric = |index: usize| rows.iter().all(|row| row.inputs[index].number().is_some());
    if variables.len() == 2
        && rows.len() == study.cases()
        && numeric(0)
        && numeric(1)
        && let Some(map) = response_map(name, study, units, rows)
    {
        return Ok((map.figure(), Some(map.size())));
    }
    let Some(variable) = (0..variables.len()).find(|index| numeric(*index)) else {
        return Err("--plot: none of the varied values is a number".to_owned());
    };
    let answered: Vec<&Row> = rows.iter().filter(|row| row.is_answered()).collect();
    let along = |row: &Row| row.inputs[variable].number().unwrap_or(f64::NAN);
    let key = &variables[variable].key;
    let input = units.axis(key, largest(rows.iter().map(along)));
    let mut notes = Vec::new();
    let curve = |(index, output): (usize, &Output)| {
        let values = || answered.iter().map(|row| row.outputs[index]);
        let Scaled { name, factor } = units.axis(&output.name, largest(values()));
        if !values().any(f64::is_finite) {
            notes.extend(
                (!answered.is_empty()).then(|| format!("{} is infinite", words(&output.name))),
            );
            return None;
        }
        let places = answered.iter().map(|row| along(row) * input.factor);
        let points = places.zip(values().map(|value| value * factor)).collect();
        Some(ResponseCurve { label: words(&name), points })
    };
    let curves = study.outputs().iter().enumerate().filter_map(curve).collect();
    let plot = ResponsePlot {
        title: titled(name, &format!("response to {key}")),
        notes,
        horizontal_label: input.name,
        is_connected: variables.len() == 1 && study.design() == Design::Grid,
        curves,
    };
    if plot.curves.is_empty() {
        return Err(format!(
            "--plot: there is no number to draw: {}",
            match plot.notes.as_slice() {
                [] => "no case has an answer".to_owned(),
                notes => notes.join(", "),
            }
        ));
    }
    Ok((plot.figure(), None))
}

/// The largest finite size of values; 0 where there is none.
fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.map(f64::abs).filter(|value| value.is_finite()).fold(0.0, f64::max)
}

/// The outputs over a whole grid of two numbers; none unless both have at least two different values in increasing order.
fn response_map(
    name: &str,
    study: &Study,
    units: &StudyUnits,
    rows: &[Row],
) -> Option<ResponseMap> {
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
    let axis = |index: usize, values: &[f64]| {
        let axis = units.axis(&study.variables()[index].key, largest(values.iter().copied()));
        (axis.name, values.iter().map(|value| value * axis.factor).collect::<Vec<f64>>())
    };
    let ((up_label, up), (along_label, along)) = (axis(0, &up), axis(1, &along));
    let surface = |(index, output): (usize, &Output)| {
        let values = || rows.iter().map(|row| row.outputs[index]);
        let Scaled { name, factor } = units.axis(&output.name, largest(values()));
        ResponseSurface {
            label: words(&name),
            values: values().map(|value| value * factor).collect(),
        }
    };
    Some(ResponseMap {
        title: titled(
            name,
            &format!("response to {} and {}", study.variables()[0].key, study.variables()[1].key),
        ),
        labels: [along_label, up_label],
        values: [along, up],
        // What is the same everywhere, such as a prescribed value, has no map.
        surfaces: study.outputs().iter().enumerate().map(surface).filter(is_varied).collect(),
    })
    .filter(|map| !map.surfaces.is_empty())
}

/// The name of the file and what is drawn.
fn titled(name: &str, what: &str) -> String {
    match heading(name) {
        Some(name) => format!("{name}: {what}"),
        None => what.to_owned(),
    }
}

/// The name of an output as words.
fn words(name: &str) -> String {
    name.replace('_', " ")
}

fn is_varied(surface: &ResponseSurface) -> bool {
    let mut finite = surface.values.iter().filter(|value| value.is_finite());
    let first = finite.next();
    finite.any(|value| Some(value) != first)
}

fn tornado(name: &str, study: &Study, indices: &Indices) -> TornadoPlot {
    let bars = |(index, output): (usize, &Output)| Bars {
        name: words(&output.name),
        shares: indices.of(index).map(|found| [found.first, found.total]).collect(),
    };
    TornadoPlot {
        title: titled(name, "which value matters"),
        notes: vec![format!("Sobol's indices from {} groups: estimates", indices.groups())],
        names: study.variables().iter().map(|variable| variable.key.clone()).collect(),
        outputs: study.outputs().iter().enumerate().map(bars).collect(),
    }
}
