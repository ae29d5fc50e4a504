//! `shtaerman solve`.

use std::fmt::Write;

use shtaerman::quantity::{Dimension, axis_unit};
use shtaerman::{Answer, Contact, PressureCurve};

use super::problem_file;
use crate::Failure;
use crate::arguments::{ReportFormat, SolveArguments};
use crate::output::{Outputs, check_writable};
use crate::plot::{ContactPlot, Format, Size, render};
use crate::report;

/// Points of the plotted curves.
const PLOT_POINTS: usize = 401;
/// Most places one `--at` may name.
const MOST_PLACES: usize = 1_000_000;
/// How far beside the punch the surface is drawn, in half-widths.
const PLOT_MARGIN: f64 = 0.6;

pub(super) fn run(arguments: &SolveArguments) -> Result<(), Failure> {
    let format = arguments.plot.as_deref().map(Format::of_file).transpose()?;
    check_writable(&[arguments.output.output.as_deref(), arguments.plot.as_deref()])?;
    if arguments.points > MOST_PLACES {
        return Err(Failure::Usage(format!(
            "--points {}: at most {MOST_PLACES}",
            arguments.points
        )));
    }
    let problem = problem_file::read(&arguments.problem)?;
    let places = arguments
        .at
        .as_deref()
        .map(|text| parse_places(text, problem.frame().scaling().is_some()))
        .transpose()?;
    let contact = problem.solve()?;
    let curve = match places {
        Some(places) => PressureCurve::at(&contact, places)?,
        None => PressureCurve::along(&contact, arguments.points)?,
    };
    let answer = Answer::new(&contact, curve);
    let text = match arguments.output.format {
        ReportFormat::Table => {
            let name = problem_file::name(&arguments.problem.file);
            let mut text = report::answer_table(&name, &contact, &answer, arguments.at.is_some());
            if let Some(path) = &arguments.plot {
                let _ = writeln!(text, "plot: {}", path.display());
            }
            text
        }
        ReportFormat::Json => report::json(&answer)?,
        ReportFormat::Csv => report::answer_csv(&answer)?,
    };
    let mut outputs = Outputs::default();
    outputs.result(arguments.output.output.as_deref(), text);
    if let (Some(path), Some(format)) = (&arguments.plot, format) {
        outputs.file(path, render(&plot(&contact)?, format, Size::default())?);
    }
    outputs.write()?;
    if arguments.output.format != ReportFormat::Table || arguments.output.output.is_some() {
        for warning in contact.warnings() {
            eprintln!("warning: {}", warning.message);
        }
    }
    Ok(())
}

/// The places of `--at`: lengths, or bare numbers for a dimensionless problem.
fn parse_places(text: &str, physical: bool) -> Result<Vec<f64>, Failure> {
    let parts: Vec<&str> = text.split(',').collect();
    if parts.len() > MOST_PLACES {
        return Err(Failure::Usage(format!(
            "--at names {} places: at most {MOST_PLACES}",
            parts.len()
        )));
    }
    parts
        .into_iter()
        .map(|part| {
            let part = part.trim();
            let dimension = if physical { Dimension::LENGTH } else { Dimension::NONE };
            let quantity = shtaerman::quantity::parse(part)
                .map_err(|error| Failure::Usage(format!("--at {part}: {error}")))?;
            quantity
                .expect(dimension, "place", part)
                .map_err(|error| Failure::Usage(format!("--at {part}: {error}")))
        })
        .collect()
}

fn plot(contact: &Contact) -> Result<ContactPlot, Failure> {
    let half_width = contact.problem().frame().half_width();
    let physical = contact.problem().frame().scaling().is_some();
    let curve = PressureCurve::along(contact, PLOT_POINTS)?;
    let places = curve.places();
    let base: Vec<f64> = places.iter().map(|&x| contact.base_depth(x)).collect();
    let beside = (1..=80).map(|i| half_width * (1.0 + PLOT_MARGIN * (f64::from(i) / 80.0).powi(2)));
    let mut surface: Vec<(f64, f64)> = beside
        .clone()
        .map(|x| -x)
        .chain(places.iter().copied())
        .chain(beside)
        .map(|x| (x, contact.elastic_displacement(x)))
        .collect();
    surface.sort_by(|one, two| one.0.total_cmp(&two.0));
    let unit =
        |values: &mut dyn Iterator<Item = f64>, dimension: Dimension, symbol: &str, plain: &str| {
            let largest = values.fold(0.0f64, |largest, value| largest.max(value.abs()));
            if physical {
                let unit = axis_unit(largest, dimension);
                (unit.factor, format!("{symbol} [{}]", unit.label))
            } else {
                (1.0, plain.to_owned())
            }
        };
    let (length, position_label) =
        unit(&mut std::iter::once(half_width), Dimension::LENGTH, "x", "ξ = x/a");
    let (stress, pressure_label) = unit(
        &mut curve.pressures().iter().copied(),
        Dimension::PRESSURE,
        "pressure p",
        "pressure p₀ = p/E",
    );
    let depths = &mut base.iter().copied().chain(surface.iter().map(|point| point.1));
    let (depth, displacement_label) = unit(depths, Dimension::LENGTH, "depth", "depth / (χE)");
    Ok(ContactPlot {
        title: "Contact of a rigid punch with a rough elastic body".to_owned(),
        notes: notes(contact),
        position: places.iter().map(|x| x * length).collect(),
        pressure: curve.pressures().iter().map(|p| p * stress).collect(),
        pressure_band: None,
        punch_base: base.iter().map(|u| u * depth).collect(),
        body_surface: surface.iter().map(|(x, u)| (x * length, u * depth)).collect(),
        contact_zone: None,
        position_label,
        pressure_label,
        displacement_label,
    })
}

fn notes(contact: &Contact) -> Vec<String> {
    let mut notes = vec![format!(
        "θ₀ = {}, degenerate kernel with n = {}; bilateral",
        report::significant(contact.theta0(), 5),
        contact.method().n
    )];
    if !contact.tension().is_empty() {
        notes.push(
            "the pressure is negative where the area is shaded: the punch would lift off there"
                .to_owned(),
        );
    }
    notes
}
