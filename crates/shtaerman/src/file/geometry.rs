//! The geometry of `[punch]`: which lengths it takes depends on it.

use crate::Geometry;
use crate::document::{Field, FileError, TableReader};
use crate::quantity::{Dimension, engineering};

/// The geometry with its (outer) half-width or radius, and the field of that.
pub(super) fn read_physical<'d>(
    punch: &TableReader<'d>,
) -> Result<(Geometry, f64, Field<'d>), FileError> {
    let length = |name: &str| -> Result<(f64, Field<'d>), FileError> {
        let field = punch.required(name)?;
        let length = field.quantity(Dimension::LENGTH)?;
        if length > 0.0 && length.is_finite() {
            return Ok((length, field));
        }
        let length = engineering(length, Dimension::LENGTH);
        Err(field.error(format!("is {length}: must be finite and greater than zero")))
    };
    Ok(match name(punch)? {
        "pair" => {
            let (outer, field) = length("outer_half_width")?;
            let (inner_half_gap, gap) = length("inner_half_gap")?;
            check(&gap, inner_half_gap > 0.0 && inner_half_gap < outer, GAP)?;
            (Geometry::Pair { inner_half_gap }, outer, field)
        }
        "periodic" => {
            let (period, field) = length("period")?;
            let (half_width, width) = match punch.has("half_width") {
                true => length("half_width")?,
                false => (0.5 * period, field.clone()),
            };
            check(&field, period >= 2.0 * half_width, PERIOD)?;
            (Geometry::Periodic { period }, half_width, width)
        }
        "circular" => {
            let (radius, field) = length("radius")?;
            (Geometry::Circular, radius, field)
        }
        _ => {
            let (half_width, field) = length("half_width")?;
            (Geometry::Plane, half_width, field)
        }
    })
}

/// The geometry of a dimensionless problem, lengths in half-widths.
pub(super) fn read_dimensionless(table: &TableReader<'_>) -> Result<Geometry, FileError> {
    Ok(match name(table)? {
        "pair" => {
            let field = table.required("inner_half_gap")?;
            let inner_half_gap = field.number()?;
            check(&field, inner_half_gap > 0.0 && inner_half_gap < 1.0, GAP)?;
            Geometry::Pair { inner_half_gap }
        }
        "periodic" => {
            let field = table.required("period")?;
            let period = field.number()?;
            check(&field, period >= 2.0, PERIOD)?;
            Geometry::Periodic { period }
        }
        "circular" => Geometry::Circular,
        _ => Geometry::Plane,
    })
}

const GAP: &str =
    "must be greater than zero and less than outer_half_width (1 in a dimensionless problem)";
const PERIOD: &str = "must be at least twice half_width (2 in a dimensionless problem)";

fn name(table: &TableReader<'_>) -> Result<&'static str, FileError> {
    match table.optional("geometry") {
        Some(field) => field.one_of(&["plane", "pair", "periodic", "circular"]),
        None => Ok("plane"),
    }
}

fn check(field: &Field<'_>, holds: bool, requirement: &str) -> Result<(), FileError> {
    if holds { Ok(()) } else { Err(field.error(requirement)) }
}
