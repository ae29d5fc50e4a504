//! `[load]`, and the load keys of `[dimensionless]`.

use crate::bodies::Bodies;
use crate::document::{Field, FileError, TableReader};
use crate::quantity::Dimension;
use crate::{Load, Rotational, Vertical};

pub(super) fn read(table: &TableReader<'_>, bodies: &Bodies) -> Result<Load, FileError> {
    let vertical = table.exactly_one(&["force", "settlement"])?;
    let rotational = table.exactly_one(&["moment", "eccentricity", "tilt"]).map_err(|error| {
        match error.help() {
            Some(_) => error,
            None => error.with_help("moment = 0 is a central load"),
        }
    })?;
    let [force, moment] = if bodies.is_circular() {
        [Dimension::FORCE, Dimension::MOMENT]
    } else {
        [Dimension::FORCE_PER_LENGTH, Dimension::MOMENT_PER_LENGTH]
    };
    let value = |field: &Field<'_>, dimension| {
        if bodies.scaling().is_some() {
            field.quantity(dimension)
        } else {
            field.quantity(Dimension::NONE)
        }
    };
    let vertical = if vertical.name().ends_with("force") {
        Vertical::Force(value(&vertical, force)?)
    } else {
        Vertical::Settlement(value(&vertical, Dimension::LENGTH)?)
    };
    let rotational = if rotational.name().ends_with("moment") {
        Rotational::Moment(value(&rotational, moment)?)
    } else if rotational.name().ends_with("eccentricity") {
        Rotational::Eccentricity(value(&rotational, Dimension::LENGTH)?)
    } else {
        Rotational::Tilt(value(&rotational, Dimension::NONE)?)
    };
    Ok(Load { vertical, rotational })
}
