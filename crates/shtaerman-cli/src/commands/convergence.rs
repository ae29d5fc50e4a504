//! `shtaerman convergence`.

use serde_json::json;
use shtaerman::convergence::{Convergence, FIRST_DEGREE, Quantity};
use shtaerman::quantity::Measure;
use shtaerman::{Error, Problem};

use super::picture::Picture;
use super::problem_file;
use crate::Failure;
use crate::arguments::{ConvergenceArguments, ReportFormat, SenseArguments};
use crate::output::{Content, Outputs};
use crate::plot::{ConvergencePlot, ConvergenceSeries};
use crate::report::{self, Shown, Table};

/// Lowest `--max-n`.
const LEAST_DEGREE: usize = 4 * FIRST_DEGREE;

pub(super) fn run(arguments: &ConvergenceArguments) -> Result<(), Failure> {
    let picture = Picture::new(arguments.plot.as_deref(), &arguments.picture)?;
    let outputs = [arguments.output.output.as_deref(), arguments.plot.as_deref()];
    if arguments.max_n < LEAST_DEGREE {
        return Err(Failure::Usage(format!(
            "--max-n {}: must be at least {LEAST_DEGREE}, as an order takes three degrees",
            arguments.max_n
        )));
    }
    let file = problem_file::read(&arguments.problem, &arguments.units, &outputs)?;
    problem_file::check_input(&file, &SenseArguments::default(), false)?;
    let problem = file.problem();
    let study = Convergence::study(problem, arguments.max_n).map_err(|error| match error {
        Error::InvalidValue { field: "max_n", value, requirement } => {
            Failure::Usage(format!("--max-n {value}: must be {requirement}"))
        }
        other => file.locate(other).into(),
    })?;
    let shown = Shown::of(problem, file.units());
    let text = match arguments.output.format {
        ReportFormat::Table => Content::page(&table(problem, &study, &shown)),
        ReportFormat::Json => Content::json(json!({
            "schema": "shtaerman-convergence/2",
            "theta0": problem.theta0(),
            "quantities": study.quantities,
            "expected_orders": study.quantities.iter().map(|quantity| quantity.expected_order()).collect::<Vec<_>>(),
            "rows": study.rows,
        })),
        ReportFormat::Csv => csv(&study, &shown),
    };
    let mut outputs = Outputs::default();
    outputs.result(arguments.output.output.as_deref(), text);
    if let Some(picture) = picture {
        picture.draw(&plot(problem, &study), &mut outputs)?;
    }
    outputs.write()
}

fn name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Settlement => "settlement",
        Quantity::Force => "force",
        Quantity::PressureRight => "pressure at right edge",
        Quantity::PressureMiddle => "pressure in the middle",
        Quantity::PressureRightIterated => "right edge, iterated",
    }
}

/// The name of a column with its unit, and what its values are multiplied by.
fn column(quantity: Quantity, shown: &Shown) -> (String, f64) {
    let measure = match quantity {
        Quantity::Settlement => Measure::Displacement,
        Quantity::Force => shown.force(),
        Quantity::PressureRight | Quantity::PressureMiddle | Quantity::PressureRightIterated => {
            Measure::Pressure
        }
    };
    if shown.is_physical && !shown.units.are_chosen() {
        let unit = shown.units.column(measure);
        return (format!("{} [{}]", name(quantity), unit.label), unit.factor);
    }
    shown.column(name(quantity), measure)
}

fn table(problem: &Problem, study: &Convergence, shown: &Shown) -> String {
    let columns: Vec<(String, f64)> =
        study.quantities.iter().map(|quantity| column(*quantity, shown)).collect();
    let mut heads = vec!["n".to_owned()];
    for (name, _) in &columns {
        heads.push(name.clone());
        heads.push("difference".to_owned());
        heads.push("order".to_owned());
    }
    let mut table = Table::new(&heads);
    for row in &study.rows {
        let mut cells = vec![row.n.to_string()];
        for (entry, (_, factor)) in row.entries.iter().zip(&columns) {
            cells.push(report::significant(entry.value * factor, 13));
            let difference = entry.difference.map(|difference| difference * factor);
            cells.push(difference.map_or(String::new(), |difference| format!("{difference:.1e}")));
            cells.push(entry.order.map_or(String::new(), |order| format!("{order:.2}")));
        }
        table.row(cells);
    }
    let expected: Vec<String> = (study.quantities.iter())
        .map(|&quantity| format!("{} {}", name(quantity), quantity.expected_order()))
        .collect();
    format!(
        "Degenerate kernel of degree n at theta0 = {}: difference from the row above, and its order in 1/n\n{table}Orders of the theory: {}.\n",
        report::significant(problem.theta0(), 8),
        expected.join(", ")
    )
}

fn csv<'a>(study: &'a Convergence, shown: &Shown) -> Content<'a> {
    let columns: Vec<(String, f64)> = study
        .quantities
        .iter()
        .map(|quantity| match shown.units.are_chosen() {
            true => column(*quantity, shown),
            false => (name(*quantity).to_owned(), 1.0),
        })
        .collect();
    let header = ["n", "quantity", "value", "difference", "order"];
    let optional = move |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
    let rows = study.rows.iter().flat_map(move |row| {
        let cells = row.entries.iter().zip(&columns).map(|(entry, (name, factor))| {
            vec![
                row.n.to_string(),
                name.clone(),
                (entry.value * factor).to_string(),
                optional(entry.difference.map(|difference| difference * factor)),
                optional(entry.order),
            ]
        });
        cells.collect::<Vec<_>>()
    });
    Content::csv(&header, rows)
}

fn plot(problem: &Problem, study: &Convergence) -> ConvergencePlot {
    let series = study.quantities.iter().enumerate().map(|(i, &quantity)| {
        let points = study.rows.iter().filter_map(|row| {
            row.entries[i].difference.map(|d| (row.n as f64, d / row.entries[i].value.abs()))
        });
        let (n, difference) = points.unzip();
        ConvergenceSeries { name: name(quantity).to_owned(), n, difference }
    });
    ConvergencePlot {
        title: "Convergence of the degenerate kernel".to_owned(),
        notes: vec![format!("θ₀ = {}", report::significant(problem.theta0(), 6))],
        series: series.collect(),
        count_label: "n, highest Chebyshev degree".to_owned(),
        difference_label: "relative difference from n/2".to_owned(),
    }
}
