//! `shtaerman regularity`.

use fredholm::degenerate::regularity::{
    Condition, RegularityReport, RowSums, SystemReport, Verdict,
};
use serde::{Serialize, Serializer};
use serde_json::{Value, json};

use crate::Failure;
use crate::arguments::{RegularityArguments, ReportFormat};
use crate::output::{Content, Outputs, check_writable};
use crate::report::{self, Table};
use crate::terminal::folded;

pub(super) fn run(arguments: &RegularityArguments) -> Result<(), Failure> {
    check_writable(&[arguments.output.output.as_deref()], &[])?;
    let study = match arguments.q0 {
        Some(q0) => RegularityReport::with_constant(arguments.theta0, q0, arguments.rows),
        None => RegularityReport::new(arguments.theta0, arguments.rows),
    };
    let study = study.map_err(|error| Failure::Usage(error.to_string()))?;
    let text = match arguments.output.format {
        ReportFormat::Table => table(&study),
        ReportFormat::Json => Content::json(Data::new(&study)),
        ReportFormat::Csv => csv(&study),
    };
    let mut outputs = Outputs::default();
    outputs.result(arguments.output.output.as_deref(), text);
    outputs.write()
}

const SYSTEMS: [(&str, &str); 2] = [("even", "(3.10)"), ("odd", "(3.11)")];

fn systems(study: &RegularityReport) -> [(&'static str, &'static str, &SystemReport); 2] {
    let [(even, even_number), (odd, odd_number)] = SYSTEMS;
    [(even, even_number, &study.even), (odd, odd_number, &study.odd)]
}

fn table(study: &RegularityReport) -> Content<'_> {
    Content::stream(|out| {
        writeln!(out, "Regularity of the infinite systems at theta0 = {}", study.theta0)?;
        for (name, number, system) in systems(study) {
            writeln!(
                out,
                "\nThe {name} system {number}: row sums (theta0 times the sum of |a_m R_km|)"
            )?;
            let heads =
                ["row", "degree", "row sum", "paper's majorant (4.1)", "first sum", "second sum"];
            Table::write_long(out, &heads, || {
                system.rows.iter().map(|row| {
                    vec![
                        row.row.to_string(),
                        row.degree.to_string(),
                        report::significant(row.sum, 8),
                        report::significant(row.majorant, 8),
                        report::significant(row.first_sum, 8),
                        report::significant(row.second_sum, 8),
                    ]
                })
            })?;
            let words = format!(
                "{}Completely regular from row {} (degree {}) on.\nVerdict: {}.\n",
                conditions(system),
                system.first_row,
                system.first_degree,
                verdict(&system.verdict)
            );
            out.write_all(folded(&words).as_bytes())?;
        }
        let words = format!(
            "\nBoth systems: {}.\nThe truncated systems have one solution at every theta0 >= 0, regular or not: the kernel is positive.\n",
            verdict(&study.verdict)
        );
        out.write_all(folded(&words).as_bytes())
    })
}

fn conditions(system: &SystemReport) -> String {
    let mut table = Table::new(&[
        "condition",
        "supremum of row sum / theta0",
        "complete regularity for theta0 up to",
        "met",
    ]);
    for (name, condition) in named_conditions(system) {
        table.row(vec![
            name.to_owned(),
            report::significant(condition.supremum, 8),
            report::significant(condition.critical_theta0, 8),
            if condition.met { "yes" } else { "no" }.to_owned(),
        ]);
    }
    table.to_string()
}

fn named_conditions(system: &SystemReport) -> Vec<(&'static str, &Condition)> {
    let conditions = &system.conditions;
    let printed = conditions.printed.as_ref().map(|printed| ("paper's (4.7), as printed", printed));
    printed
        .into_iter()
        .chain([
            ("paper's chain, corrected", &conditions.corrected),
            ("sharp for the majorant (4.1)", &conditions.majorant),
            ("sharp", &conditions.sharp),
        ])
        .collect()
}

fn verdict(verdict: &Verdict) -> String {
    match verdict {
        Verdict::CompletelyRegular { constant } => {
            format!("completely regular, with constant {}", report::significant(*constant, 8))
        }
        Verdict::QuasiCompletelyRegular { from_degree } => {
            format!("quasi-completely regular: completely regular from degree {from_degree} on")
        }
    }
}

/// What `regularity --format json` writes.
#[derive(Serialize)]
struct Data<'a> {
    schema: &'static str,
    theta0: f64,
    constant: f64,
    even: SystemData<'a>,
    odd: SystemData<'a>,
    first_degree: Value,
    verdict: Value,
}

#[derive(Serialize)]
struct SystemData<'a> {
    system: &'static str,
    #[serde(serialize_with = "rows")]
    rows: &'a [RowSums],
    conditions: Value,
    first_row: Value,
    first_degree: Value,
    verdict: Value,
}

#[derive(Serialize)]
struct RowData {
    row: Value,
    degree: Value,
    sum: f64,
    majorant: f64,
    constant_share: f64,
    first_sum: f64,
    second_sum: f64,
}

impl<'a> Data<'a> {
    fn new(study: &'a RegularityReport) -> Self {
        let [even, odd] = systems(study).map(|(_, number, system)| SystemData::new(number, system));
        Self {
            schema: "shtaerman-regularity/1",
            theta0: study.theta0,
            constant: study.constant,
            even,
            odd,
            first_degree: json!(study.first_degree),
            verdict: verdict_data(&study.verdict),
        }
    }
}

impl<'a> SystemData<'a> {
    fn new(number: &'static str, system: &'a SystemReport) -> Self {
        let condition = |condition: &Condition| json!({ "supremum": condition.supremum, "critical_theta0": condition.critical_theta0, "met": condition.met });
        Self {
            system: number,
            rows: &system.rows,
            conditions: json!({
                "printed": system.conditions.printed.as_ref().map(condition),
                "corrected": condition(&system.conditions.corrected),
                "majorant": condition(&system.conditions.majorant),
                "sharp": condition(&system.conditions.sharp),
            }),
            first_row: json!(system.first_row),
            first_degree: json!(system.first_degree),
            verdict: verdict_data(&system.verdict),
        }
    }
}

/// Rows are made one by one as they are written.
fn rows<S: Serializer>(rows: &&[RowSums], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(rows.iter().map(|row| RowData {
        row: json!(row.row),
        degree: json!(row.degree),
        sum: row.sum,
        majorant: row.majorant,
        constant_share: row.constant_share,
        first_sum: row.first_sum,
        second_sum: row.second_sum,
    }))
}

fn verdict_data(verdict: &Verdict) -> Value {
    match verdict {
        Verdict::CompletelyRegular { constant } => {
            json!({ "kind": "completely_regular", "constant": constant })
        }
        Verdict::QuasiCompletelyRegular { from_degree } => {
            json!({ "kind": "quasi_completely_regular", "from_degree": from_degree })
        }
    }
}

fn csv(study: &RegularityReport) -> Content<'_> {
    let header =
        ["system", "row", "degree", "sum", "majorant", "constant_share", "first_sum", "second_sum"];
    let rows = systems(study).into_iter().flat_map(|(name, _, system)| {
        system.rows.iter().map(move |row| {
            vec![
                name.to_owned(),
                row.row.to_string(),
                row.degree.to_string(),
                row.sum.to_string(),
                row.majorant.to_string(),
                row.constant_share.to_string(),
                row.first_sum.to_string(),
                row.second_sum.to_string(),
            ]
        })
    });
    Content::csv(&header, rows)
}
