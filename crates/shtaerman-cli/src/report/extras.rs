//! What `solve` adds where it is asked for: settlements relative to a datum, sensitivities, the surface.

use shtaerman::quantity::Measure;
use shtaerman::{
    Answer, Contact, Datum, Derivatives, Errors, Quantities, Roughness, Sensitivities, SurfaceCurve,
};

use super::{Shown, Table, Told, significant};
use crate::output::Content;

/// Significant digits of a derivative.
const DIGITS: usize = 4;

/// The tables of what was asked for, each after an empty line.
#[must_use]
pub(crate) fn extras(contact: &Contact, answer: &Answer, shown: &Shown) -> Told {
    let quantities = match (&answer.physical, &answer.dimensionless) {
        (Some(physical), _) => physical,
        (None, Some(bare)) => bare,
        (None, None) => return Told::default(),
    };
    let Quantities { relative_settlement: relative, sensitivities, .. } = quantities;
    let mut text = Told::default();
    let length = |value: f64| shown.value(value, Measure::Displacement);
    if !relative.is_empty() {
        let mut table = Table::new(&["settlement relative to", "", "which itself moves by"]);
        for relative in relative {
            let datum = match relative.datum {
                Datum::Distance(x) => format!("the surface at {}", length(x)),
                Datum::Depth(depth) => format!("the depth of {}", length(depth)),
            };
            table.row(vec![datum, length(relative.settlement), length(relative.displacement)]);
        }
        text.push('\n');
        text.table(table);
    }
    if let Some(sensitivities) = sensitivities {
        text.push('\n');
        text.table(sensitivity_table(sensitivities, quantities, contact));
        text.push_str(&format!(
            "per cent for each per cent (estimate), the {} kept; what is zero has no per cent\n",
            sensitivities.held
        ));
    }
    text
}

/// A derivative of [`Derivatives`].
type Derivative = fn(&Derivatives) -> Option<f64>;

/// By how many per cent a quantity changes for each per cent of what it depends on: `(x/y) dy/dx`; what lies below its stated error is 0.
fn sensitivity_table(
    sensitivities: &Sensitivities,
    quantities: &Quantities,
    contact: &Contact,
) -> Table {
    let Sensitivities { settlement, force, tilt, peak_pressure, contact_width, .. } = sensitivities;
    let problem = contact.problem();
    let roughness = problem.scaling().map(|scaling| match scaling.roughness() {
        Roughness::Power { coefficient, .. } => coefficient,
        Roughness::Linear { compliance } => compliance,
        _ => f64::NAN,
    });
    let material = problem.foundation().material();
    let grading = problem.foundation().grading();
    let modulus = material.map(|one| one.young_modulus()).or(grading.map(|one| one.modulus()));
    let inputs: [(&str, Derivative, Option<f64>); 5] = [
        ("by roughness", |d| d.roughness, roughness),
        ("by Young's modulus", |d| d.young_modulus, modulus),
        ("by theta0", |d| d.theta0, Some(contact.theta0())),
        ("by force", |d| d.force, Some(quantities.force)),
        ("by settlement", |d| d.settlement, Some(quantities.settlement)),
    ];
    let errors = contact.error();
    let error = |of: fn(&Errors) -> f64| errors.as_ref().map_or(0.0, of);
    let rows = [
        ("settlement", settlement.as_ref(), quantities.settlement, error(|e| e.settlement)),
        ("force", force.as_ref(), quantities.force, error(|e| e.force)),
        ("tilt", tilt.as_ref(), quantities.tilt, error(|e| e.tilt)),
        ("largest pressure", peak_pressure.as_ref(), quantities.peak_pressure, 0.0),
        ("contact width", Some(contact_width), quantities.contact_width, 0.0),
    ];
    let used: Vec<_> =
        inputs.into_iter().filter(|(_, slope, _)| slope(contact_width).is_some()).collect();
    let heads: Vec<&str> = ["change of"].into_iter().chain(used.iter().map(|one| one.0)).collect();
    let mut table = Table::new(&heads);
    for (name, row, value, error) in rows {
        let Some(row) = row else { continue };
        let elasticity = |slope: Derivative, input: Option<f64>| {
            let found = slope(row)? * input? / value;
            (found.is_finite() && value.abs() > error).then_some(found)
        };
        let found: Vec<Option<f64>> =
            used.iter().map(|(_, slope, input)| elasticity(*slope, *input)).collect();
        let largest = found.iter().flatten().fold(1.0f64, |most, one| most.max(one.abs()));
        let cell = |found: Option<f64>| {
            let certain = |one: f64| if one.abs() <= row.error * largest { 0.0 } else { one };
            found.map_or(String::new(), |one| significant(certain(one), DIGITS))
        };
        table.row([name.to_owned()].into_iter().chain(found.into_iter().map(cell)).collect());
    }
    table
}

/// The surface as CSV: `x,pressure,displacement,gap`, in SI units, in those chosen, or without dimensions as the problem is; no gap beside the punch.
pub(crate) fn surface_csv<'a>(surface: &'a SurfaceCurve, shown: &Shown) -> Content<'a> {
    let SurfaceCurve { x, pressure, displacement, gap } = surface;
    let columns = [
        shown.column("x", Measure::Length),
        shown.column("pressure", Measure::Pressure),
        shown.column("displacement", Measure::Displacement),
        shown.column("gap", Measure::Displacement),
    ];
    let [length, stress, depth, height] = columns.each_ref().map(|column| column.1);
    let rows = (0..x.len()).map(move |i| {
        let gap = gap[i].map_or(String::new(), |gap| (gap * height).to_string());
        let [x, p, u] = [x[i] * length, pressure[i] * stress, displacement[i] * depth];
        vec![x.to_string(), p.to_string(), u.to_string(), gap]
    });
    Content::csv(&columns.map(|column| column.0), rows)
}
