//! `[load]`, and the load keys of `[dimensionless]`.

use crate::document::{Field, FileError, TableReader};
use crate::quantity::Dimension;
use crate::{Load, Rotational, Vertical};

pub(super) fn read(table: &TableReader<'_>, physical: bool) -> Result<Load, FileError> {
    let vertical = table.exactly_one(&["force", "settlement"])?;
    let rotational = table.exactly_one(&["moment", "eccentricity", "tilt"])?;
    let value = |field: &Field<'_>, dimension| {
        if physical { field.quantity(dimension) } else { field.quantity(Dimension::NONE) }
    };
    let vertical = if vertical.name().ends_with("force") {
        Vertical::Force(value(&vertical, Dimension::FORCE_PER_LENGTH)?)
    } else {
        Vertical::Settlement(value(&vertical, Dimension::LENGTH)?)
    };
    let rotational = if rotational.name().ends_with("moment") {
        Rotational::Moment(value(&rotational, Dimension::MOMENT_PER_LENGTH)?)
    } else if rotational.name().ends_with("eccentricity") {
        Rotational::Eccentricity(value(&rotational, Dimension::LENGTH)?)
    } else {
        Rotational::Tilt(value(&rotational, Dimension::NONE)?)
    };
    Ok(Load { vertical, rotational })
}
