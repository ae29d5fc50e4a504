//! `[foundation]`, `[body]`, and the geometry of `[punch]`.

use super::refused::{refused, shown};
use super::stated::Stated;
use super::{geometry, layering, section};
use crate::document::{FileError, TableReader};
use crate::quantity::Dimension;
use crate::{Elastic, Error, Foundation, Geometry, Grading, Punch, Roughness};

pub(super) fn read(reader: &TableReader<'_>) -> Result<Stated, FileError> {
    let foundation = section::required(reader, "foundation")?;
    if foundation.has("grading_exponent") || foundation.has("grading_modulus") {
        return graded(reader, &foundation);
    }
    let material = elastic(&foundation)?;
    let roughness = roughness(&foundation)?;
    yield_stress(&foundation)?;
    let body = reader.table("body")?.map(|table| elastic(&table)).transpose()?;
    let punch = section::required(reader, "punch")?;
    let (geometry, half_width, field) = geometry::read_physical(&punch)?;
    let stated = stated(&Foundation::new(material), roughness, geometry, half_width, body)
        .map_err(|error| refused(&field, &error))?;
    layering::on_foundation(reader, &foundation, material, stated)
}

fn stated(
    foundation: &Foundation,
    roughness: Roughness,
    geometry: Geometry,
    half_width: f64,
    body: Option<Elastic>,
) -> Result<Stated, Error> {
    let punch = Punch::in_geometry(geometry, half_width)?;
    let punch = if let Some(body) = body { punch.with_body(body) } else { punch };
    Stated::new(foundation.with_roughness(roughness)?, punch)
}

/// `E = E0 y^mu` under a rigid punch.
fn graded(reader: &TableReader<'_>, foundation: &TableReader<'_>) -> Result<Stated, FileError> {
    if let Some(modulus) = foundation.optional("young_modulus") {
        return Err(modulus
            .error("does not go with grading: the modulus depends on the depth")
            .with_help("grading_modulus is Young's modulus at the depth of 1 m"));
    }
    layering::refuse(foundation, "does not go with grading: leave one of both out")?;
    let exponent = foundation.required("grading_exponent")?;
    let modulus = foundation.required("grading_modulus")?;
    let ratio = foundation.required("poisson_ratio")?;
    let grading = Grading::new(exponent.number()?, modulus.quantity(Dimension::PRESSURE)?)
        .map_err(|error| {
            let at_modulus = matches!(error, Error::InvalidValue { field: "grading_modulus", .. });
            refused(if at_modulus { &modulus } else { &exponent }, &error)
        })?;
    let poisson_ratio = ratio.quantity(Dimension::NONE)?;
    // The ratio alone, so that a fault is located there.
    Elastic::new(1.0, poisson_ratio).map_err(|error| refused(&ratio, &error))?;
    if let Some(body) = reader.optional("body").filter(|_| !grading.is_homogeneous()) {
        return Err(body.error(
            "does not go with grading: an elastic punch has no composite modulus with a graded foundation; leave it out for a rigid punch",
        ));
    }
    let body = reader.table("body")?.map(|table| elastic(&table)).transpose()?;
    let roughness = roughness(foundation)?;
    let punch = section::required(reader, "punch")?;
    let (geometry, half_width, field) = geometry::read_physical(&punch)?;
    let foundation = Foundation::graded(grading, poisson_ratio);
    let stated = foundation
        .and_then(|foundation| stated(&foundation, roughness, geometry, half_width, body));
    stated.map_err(|error| {
        let at_exponent = matches!(error, Error::InvalidValue { field: "grading_exponent", .. });
        refused(if at_exponent { &exponent } else { &field }, &error)
    })
}

pub(super) fn elastic(table: &TableReader<'_>) -> Result<Elastic, FileError> {
    let modulus = table.required("young_modulus")?;
    let ratio = table.required("poisson_ratio")?;
    Elastic::new(modulus.quantity(Dimension::PRESSURE)?, ratio.quantity(Dimension::NONE)?).map_err(
        |error| {
            let at_ratio = matches!(error, Error::InvalidValue { field: "poisson_ratio", .. });
            refused(if at_ratio { &ratio } else { &modulus }, &error)
        },
    )
}

/// The yield stress (Pa), which only stresses below the surface are compared with.
pub(super) fn yield_stress(foundation: &TableReader<'_>) -> Result<Option<f64>, FileError> {
    let Some(field) = foundation.optional("yield_stress") else { return Ok(None) };
    let value = field.quantity(Dimension::PRESSURE)?;
    if value.is_finite() && value > 0.0 {
        return Ok(Some(value));
    }
    let value = shown("yield_stress", value);
    Err(field.error(format!("is {value}: must be finite and greater than zero")))
}

/// The law of the rough layer: `chi` (m/Pa), its inverse, or a table with a coefficient and an exponent.
fn roughness(table: &TableReader<'_>) -> Result<Roughness, FileError> {
    let field = table.exactly_one(&["roughness", "subgrade_modulus"])?;
    if field.name().ends_with("subgrade_modulus") {
        let modulus = field.quantity(Dimension::SUBGRADE_MODULUS)?;
        let compliance = 1.0 / modulus;
        if modulus > 0.0 && compliance.is_finite() {
            return Ok(Roughness::Linear { compliance });
        }
        return Err(field.error(format!(
            "is {}: must be greater than zero (its inverse is chi)",
            shown("subgrade_modulus", modulus)
        )));
    }
    if field.is_table() {
        return power_law(&field.table()?);
    }
    let compliance = field.quantity(Dimension::COMPLIANCE)?;
    if compliance < 0.0 {
        let value = shown("roughness", compliance);
        return Err(field.error(format!("is {value}: must be zero (a smooth surface) or greater")));
    }
    Ok(Roughness::from(compliance))
}

/// `B p^kappa`: `coefficient` in m/Pa^kappa, or a `displacement` under a `pressure`.
fn power_law(table: &TableReader<'_>) -> Result<Roughness, FileError> {
    let exponent_field = table.required("exponent")?;
    let exponent = exponent_field.number()?;
    let field = table.exactly_one(&["coefficient", "displacement"])?;
    let coefficient = if field.name().ends_with("coefficient") {
        field.number()?
    } else {
        let pressure = table.required("pressure")?;
        let value = pressure.quantity(Dimension::PRESSURE)?;
        if !(value.is_finite() && value > 0.0) {
            let value = shown("pressure", value);
            return Err(pressure.error(format!("is {value}: must be greater than zero")));
        }
        field.quantity(Dimension::LENGTH)? / value.powf(exponent)
    };
    Roughness::power(coefficient, exponent).map_err(|error| match &error {
        Error::InvalidValue { field: "exponent", .. } => refused(&exponent_field, &error),
        _ => field.error(format!(
            "makes the coefficient {coefficient}: must be finite and greater than zero"
        )),
    })
}
