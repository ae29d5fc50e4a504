//! `[foundation]`, `[body]` and the half-width of `[punch]`.

use super::{refused, shown};
use crate::document::{FileError, TableReader};
use crate::quantity::Dimension;
use crate::{Elastic, Error, Frame};

pub(super) fn read(reader: &TableReader<'_>) -> Result<Frame, FileError> {
    let foundation = reader.required("foundation")?.table()?;
    let material = elastic(&foundation)?;
    let roughness = roughness(&foundation)?;
    let body = reader.table("body")?.map(|table| elastic(&table)).transpose()?;
    let field = reader.required("punch")?.table()?.required("half_width")?;
    let half_width = field.quantity(Dimension::LENGTH)?;
    Frame::physical(material, roughness, half_width, body).map_err(|error| refused(&field, &error))
}

fn elastic(table: &TableReader<'_>) -> Result<Elastic, FileError> {
    let modulus = table.required("young_modulus")?;
    let ratio = table.required("poisson_ratio")?;
    Elastic::new(modulus.quantity(Dimension::PRESSURE)?, ratio.quantity(Dimension::NONE)?).map_err(
        |error| {
            let at_ratio = matches!(error, Error::InvalidValue { field: "poisson_ratio", .. });
            refused(if at_ratio { &ratio } else { &modulus }, &error)
        },
    )
}

/// `chi` (m/Pa), written as such or as its inverse.
fn roughness(table: &TableReader<'_>) -> Result<f64, FileError> {
    let field = table.exactly_one(&["roughness", "subgrade_modulus"])?;
    if field.name().ends_with("subgrade_modulus") {
        let modulus = field.quantity(Dimension::SUBGRADE_MODULUS)?;
        let compliance = 1.0 / modulus;
        if modulus > 0.0 && compliance.is_finite() {
            return Ok(compliance);
        }
        return Err(field.error(format!(
            "is {}: must be greater than zero (its inverse is chi)",
            shown("subgrade_modulus", modulus)
        )));
    }
    let compliance = field.quantity(Dimension::COMPLIANCE)?;
    if compliance == 0.0 {
        let message = "is 0: the smooth limit is an equation of the first kind, not this one";
        return Err(field.error(message).with_help(
            "`shtaerman equation` solves it, with kind = \"first\" and the log kernel; or give a compliance greater than zero",
        ));
    }
    if compliance < 0.0 {
        let value = shown("roughness", compliance);
        return Err(field.error(format!("is {value}: must be greater than zero")));
    }
    Ok(compliance)
}
