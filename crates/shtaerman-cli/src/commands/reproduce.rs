//! `shtaerman reproduce`.

use shtaerman::paper::{self, Figure, Reproduction};

use super::picture::Picture;
use crate::Failure;
use crate::arguments::{ReportFormat, ReproduceArguments};
use crate::output::{Content, Outputs, check_writable};
use crate::plot::{Arrangement, Curve, CurvePanel, CurveScaling, CurvesPlot};
use crate::report::{self, Table};

/// Points of each curve of Fig. 2.
const CURVE_POINTS: usize = 401;

pub(super) fn run(arguments: &ReproduceArguments) -> Result<(), Failure> {
    let picture = Picture::new(arguments.plot.as_deref(), &arguments.picture)?;
    check_writable(&[arguments.output.output.as_deref(), arguments.plot.as_deref()], &[])?;
    let reproduction = paper::reproduce()?;
    let mut outputs = Outputs::default();
    let text = match arguments.output.format {
        ReportFormat::Table => Content::page(&table(&reproduction)),
        ReportFormat::Json => json(&reproduction),
        ReportFormat::Csv => csv(&reproduction),
    };
    outputs.result(arguments.output.output.as_deref(), text);
    if let Some(picture) = picture {
        picture.draw(&figure2()?, &mut outputs)?;
    }
    outputs.write()?;
    if reproduction.is_as_expected() { Ok(()) } else { Err(Failure::Check(summary(&reproduction))) }
}

fn summary(reproduction: &Reproduction) -> String {
    format!(
        "{} of {} printed figures agree to the last printed digit",
        reproduction.agreeing(),
        reproduction.figures.len()
    )
}

fn table(reproduction: &Reproduction) -> String {
    let mut text = String::from(
        "Tables 1-3 of the paper (nu = 0.25, P0 = 0.001, M0 = 0.0001): each figure as printed, as the paper computed it\n\
         (its slips included), and as it is. The captions of Tables 1 and 2 are swapped in print.\n",
    );
    for number in 1..=3 {
        text.push_str(&format!("\nTable {number}\n"));
        let mut table = Table::new(&[
            "f0/lambda0",
            "lambda0",
            "",
            "printed",
            "as the paper",
            "true",
            "",
            "why it differs",
        ]);
        for figure in reproduction.figures.iter().filter(|figure| figure.table == number) {
            table.row(row(figure));
        }
        text.push_str(&table.to_string());
    }
    text.push_str(&format!("\n{}.\n", summary(reproduction)));
    for figure in reproduction.figures.iter().filter(|figure| !figure.agrees) {
        text.push_str(&format!(
            "The other: Table {}, lambda0 = {}, {} is printed {}, the paper's computation gives {}: a misprint.\n",
            figure.table,
            figure.lambda0,
            figure.quantity.symbol(),
            figure.printed,
            report::significant(figure.as_the_paper, 3),
        ));
    }
    text
}

fn row(figure: &Figure) -> Vec<String> {
    let mark = match (figure.agrees, figure.reason) {
        (false, _) => "!!",
        (true, Some(_)) => "*",
        (true, None) => "",
    };
    vec![
        figure.profile.to_owned(),
        figure.lambda0.to_owned(),
        figure.quantity.symbol().to_owned(),
        figure.printed.to_owned(),
        report::significant(figure.as_the_paper, 8),
        report::significant(figure.exact, 10),
        mark.to_owned(),
        figure.reason.map_or(String::new(), |reason| reason.text().to_owned()),
    ]
}

fn json(reproduction: &Reproduction) -> Content<'static> {
    let value = serde_json::json!({
        "schema": "shtaerman-reproduction/1",
        "agreeing": reproduction.agreeing(),
        "total": reproduction.figures.len(),
        "summary": summary(reproduction),
        "figures": reproduction.figures,
    });
    Content::json(value)
}

fn csv(reproduction: &Reproduction) -> Content<'_> {
    let header = [
        "table",
        "profile",
        "lambda0",
        "quantity",
        "printed",
        "as_the_paper",
        "exact",
        "n",
        "agrees",
        "reason",
    ];
    let rows = reproduction.figures.iter().map(|figure| {
        vec![
            figure.table.to_string(),
            figure.profile.to_owned(),
            figure.lambda0.to_owned(),
            figure.quantity.symbol().to_owned(),
            figure.printed.to_owned(),
            figure.as_the_paper.to_string(),
            figure.exact.to_string(),
            figure.n.to_string(),
            figure.agrees.to_string(),
            figure.reason.map_or(String::new(), |reason| reason.text().to_owned()),
        ]
    });
    Content::csv(&header, rows)
}

fn figure2() -> Result<CurvesPlot, Failure> {
    let curves = paper::figure2(CURVE_POINTS)?;
    let panel = |heading: &str, values: fn(&paper::Curve) -> &[f64]| CurvePanel {
        heading: heading.to_owned(),
        curves: curves
            .iter()
            .map(|curve| Curve {
                name: format!("λ₀ = {}", curve.lambda0),
                points: curve.xi.iter().copied().zip(values(curve).iter().copied()).collect(),
            })
            .collect(),
    };
    Ok(CurvesPlot {
        title: "Fig. 2: pressure under a parabolic punch, f₀ = λ₀ ξ²".to_owned(),
        notes: vec![
            "ν = 0.25, P₀ = 0.001, M₀ = 0.0001; pressures linear near zero, logarithmic beyond"
                .to_owned(),
        ],
        panels: vec![
            panel("as the paper computed it: (3.8) as printed, n = 45", |curve| &curve.as_printed),
            panel("as it is", |curve| &curve.exact),
        ],
        scaling: CurveScaling::default(),
        arrangement: Arrangement::Stacked,
        horizontal_label: "ξ".to_owned(),
        vertical_label: "p₀".to_owned(),
    })
}
