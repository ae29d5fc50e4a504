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
        "{}: {} cases, {design} over {}\n\n",
        manifest.study,
        manifest.cases,
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
        let Scaled { name, factor } = units.column(study, &extreme.name);
        let shown = |value: f64, digits: usize| significant(value * factor, digits);
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
    text.push_str(&audits(study, units, report.audited));
    if let Some((looked_at, doubts)) = report.sense.filter(|(looked_at, _)| *looked_at > 0) {
        let found = match doubts.len() {
            0 => "nothing to doubt there".to_owned(),
            1 => "1 doubt".to_owned(),
            count => format!("{count} doubts"),
        };
        let _ = writeln!(
            text,
            "sense checks of {looked_at} of {} cases, those with the least and the largest varied values and outputs: {found}",
            manifest.cases
        );
        for doubt in doubts {
            let _ = writeln!(text, "warning: {doubt}");
        }
    }
    text
}

/// What varies and the outputs of each case.
pub(crate) fn rows_table(study: &Study, units: &StudyUnits, rows: &[Row]) -> String {
    let (inputs, outputs) = scaled(study, units);
    let heads: Vec<&str> = inputs.iter().chain(&outputs).map(|one| one.name.as_str()).collect();
    let mut table = Table::new(&heads).with_keys(inputs.len());
    for row in rows {
        let varied = row.inputs.iter().zip(&inputs).map(|(input, scaled)| match input.number() {
            Some(value) => significant(value * scaled.factor, DIGITS),
            None => input.to_string(),
        });
        let found = row.outputs.iter().zip(&outputs);
        let found = found.map(|(value, scaled)| significant(value * scaled.factor, DIGITS));
        table.row(varied.chain(found).collect());
    }
    format!("{table}\n")
}

/// The varied keys and the outputs with their units.
fn scaled(study: &Study, units: &StudyUnits) -> (Vec<Scaled>, Vec<Scaled>) {
    let inputs = study.variables().iter().map(|variable| units.column(study, &variable.key));
    let outputs = study.outputs().iter().map(|output| units.column(study, &output.name));
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
    let (inputs, outputs) = scaled(study, units);
    let of = |name: &str| {
        let error = name.strip_suffix("_error");
        let names = study.outputs().iter().map(|output| output.name.as_str());
        let keys = study.variables().iter().map(|variable| variable.key.as_str());
        let position = |mut all: Box<dyn Iterator<Item = &str> + '_>, name: &str| {
            all.position(|known| known == name)
        };
        match position(Box::new(names), error.unwrap_or(name)) {
            Some(index) => Some(outputs[index].clone()),
            None => position(Box::new(keys), name).map(|index| inputs[index].clone()),
        }
    };
    let column = |name: String| match of(&name).and_then(|scaled| unit_of(&scaled)) {
        Some((unit, factor)) => Scaled { name: format!("{name} {unit}"), factor },
        None => Scaled { name, factor: 1.0 },
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

/// The unit in brackets behind a name.
fn unit_of(scaled: &Scaled) -> Option<(String, f64)> {
    let at = scaled.name.rfind(" [")?;
    Some((scaled.name[at + 1..].to_owned(), scaled.factor))
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
    let mut text = format!("audit of a sample of {} cases: {refused} not kept", audited.len());
    for (index, output) in study.outputs().iter().enumerate() {
        let largest = |row: fn(&(Row, Row)) -> &Row| {
            audited.iter().filter_map(|pair| row(pair).errors[index]).reduce(f64::max)
        };
        if let (Some(stated), Some(found)) = (largest(|pair| &pair.0), largest(|pair| &pair.1)) {
            let factor = units.column(study, &output.name).factor;
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
    let (inputs, outputs) = scaled(study, units);
    let input = &inputs[variable];
    let curves = outputs.iter().enumerate().map(|(index, output)| ResponseCurve {
        label: words(&output.name),
        points: rows
            .iter()
            .filter(|row| row.is_answered())
            .filter_map(|row| {
                let x = row.inputs[variable].number()? * input.factor;
                Some((x, row.outputs[index] * output.factor))
            })
            .collect(),
    });
    let plot = ResponsePlot {
        title: titled(name, &format!("response to {}", variables[variable].key)),
        horizontal_label: input.name.clone(),
        is_connected: variables.len() == 1 && study.design() == Design::Grid,
        curves: curves.collect(),
    };
    Ok((plot.figure(), None))
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
    let (inputs, outputs) = scaled(study, units);
    let label = |index: usize| inputs[index].name.clone();
    let surface = |(index, output): (usize, &Scaled)| ResponseSurface {
        label: words(&output.name),
        values: rows.iter().map(|row| row.outputs[index] * output.factor).collect(),
    };
    let along = along.into_iter().map(|value| value * inputs[1].factor).collect();
    let up = up.into_iter().map(|value| value * inputs[0].factor).collect();
    Some(ResponseMap {
        title: titled(
            name,
            &format!("response to {} and {}", study.variables()[0].key, study.variables()[1].key),
        ),
        labels: [label(1), label(0)],
        values: [along, up],
        // What is the same everywhere, such as a prescribed value, has no map.
        surfaces: outputs.iter().enumerate().map(surface).filter(is_varied).collect(),
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
    surface.values.iter().any(|value| *value != surface.values[0])
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
