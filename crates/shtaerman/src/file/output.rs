//! `[output]`: the units in which results are shown.

use crate::bodies::Bodies;
use crate::document::{Field, FileError, TableReader};
use crate::quantity::{Measure, OutputUnits};

/// The units of `[output]`; SI where there are none.
pub(super) fn read(reader: &TableReader<'_>, bodies: &Bodies) -> Result<OutputUnits, FileError> {
    let Some(table) = reader.table("output")? else { return Ok(OutputUnits::default()) };
    let Some(field) = table.optional("units") else { return Ok(OutputUnits::default()) };
    if bodies.scaling().is_none() {
        return Err(field.error("has no place in a dimensionless problem: its numbers have none"));
    }
    if !field.is_table() {
        return system(&field);
    }
    let table = field.table()?;
    let mut units = match table.optional("system") {
        Some(field) => system(&field)?,
        None => OutputUnits::default(),
    };
    for (key, measures) in keys(bodies.is_circular()) {
        let Some(field) = table.optional(key) else { continue };
        let text = field.string()?;
        for measure in measures {
            units = units.with(*measure, text).map_err(|error| field.error(error))?;
        }
    }
    Ok(units)
}

fn system(field: &Field<'_>) -> Result<OutputUnits, FileError> {
    let name = field.one_of(&OutputUnits::SYSTEMS)?;
    Ok(OutputUnits::named(name).unwrap_or_default())
}

/// The keys of the table and what they set; a displacement has the unit of a length unless it has its own, which comes later.
fn keys(is_circular: bool) -> [(&'static str, &'static [Measure]); 7] {
    let [force, moment]: [&[Measure]; 2] = if is_circular {
        [&[Measure::Force], &[Measure::Moment]]
    } else {
        [&[Measure::ForcePerLength], &[Measure::MomentPerLength]]
    };
    [
        ("length", &[Measure::Length, Measure::Displacement]),
        ("displacement", &[Measure::Displacement]),
        ("pressure", &[Measure::Pressure]),
        ("force", force),
        ("moment", moment),
        ("angle", &[Measure::Angle]),
        ("roughness", &[Measure::Compliance]),
    ]
}
