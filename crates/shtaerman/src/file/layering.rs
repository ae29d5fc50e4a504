//! A foundation in two pieces: `thickness` and `base`, or `[foundation.coating]`.

use super::stated::Stated;
use crate::document::{Field, FileError, TableReader};
use crate::quantity::{Dimension, engineering};
use crate::{Elastic, Error, LayerBase, Layering};

/// Keys of `[foundation]` that belong here.
const KEYS: [&str; 3] = ["thickness", "base", "coating"];

/// Refuses a layer and a coating where something else is written that they do not go with.
pub(super) fn refuse(foundation: &TableReader<'_>, message: &str) -> Result<(), FileError> {
    match KEYS.into_iter().find_map(|key| foundation.optional(key)) {
        Some(field) => Err(field.error(message)),
        None => Ok(()),
    }
}

/// The foundation that the table says, whose material is the layer's, or what lies below the coating.
pub(super) fn on_foundation(
    reader: &TableReader<'_>,
    foundation: &TableReader<'_>,
    material: Elastic,
    stated: Stated,
) -> Result<Stated, FileError> {
    let layer = layer(
        foundation,
        || Ok(material.poisson_ratio()),
        |field| field.quantity(Dimension::LENGTH),
    )?;
    let coating = foundation.optional("coating");
    let (field, layering) = match (layer, coating) {
        (None, None) => return Ok(stated),
        (Some(layer), None) => layer,
        (Some(_), Some(coating)) => {
            return Err(coating.error(
                "does not go with thickness and base: a foundation is a layer on a rigid base or a half-plane with a coating",
            ));
        }
        (None, Some(coating)) => {
            let table = coating.table()?;
            let thickness = table.required("thickness")?;
            let modulus = table.required("young_modulus")?;
            let upper = super::physical::elastic(&table)?;
            let value = thickness.quantity(Dimension::LENGTH)?;
            let layering = Layering::coating(value, upper, material).map_err(|error| {
                let is_modulus =
                    matches!(error, Error::InvalidValue { field: "young_modulus", .. });
                refused(if is_modulus { &modulus } else { &thickness }, &error)
            })?;
            (thickness, layering)
        }
    };
    if let Some(body) = reader.optional("body") {
        return Err(body.error(
            "does not go with a layer or a coating: an elastic punch has no composite modulus with them; leave it out for a rigid punch",
        ));
    }
    stated.on(layering).map_err(|error| match &error {
        Error::InvalidValue { field: "roughness", .. } => foundation
            .optional("roughness")
            .map_or_else(|| field.error(&error), |at| refused(&at, &error)),
        _ => refused(&field, &error),
    })
}

/// A dimensionless problem on the layer that its table says, lengths in half-widths; `poisson_ratio` is asked for by a bonded one.
pub(super) fn dimensionless(table: &TableReader<'_>, stated: Stated) -> Result<Stated, FileError> {
    let poisson_ratio = || table.required("poisson_ratio")?.number();
    let layer = layer(table, poisson_ratio, Field::number)?;
    let Some((field, layering)) = layer else { return Ok(stated) };
    stated.on(layering).map_err(|error| refused(&field, &error))
}

/// Whether the table says a bonded layer, which needs Poisson's ratio.
pub(super) fn is_bonded(table: &TableReader<'_>) -> bool {
    table.optional("base").is_some_and(|field| field.string() == Ok("bonded"))
}

/// `thickness` and `base`.
fn layer<'d>(
    table: &TableReader<'d>,
    poisson_ratio: impl Fn() -> Result<f64, FileError>,
    length: impl Fn(&Field<'d>) -> Result<f64, FileError>,
) -> Result<Option<(Field<'d>, Layering)>, FileError> {
    let base = table.optional("base");
    let Some(field) = table.optional("thickness") else {
        let message = "goes with thickness: a layer that lies on a rigid base";
        return base.map_or(Ok(None), |base| Err(base.error(message)));
    };
    let base = base.ok_or_else(|| {
        field
            .error("goes with base, which is missing")
            .with_help("write base = \"bonded\" where the layer is held by its rigid base, base = \"frictionless\" where it slides on it")
    })?;
    let base = match base.one_of(&["bonded", "frictionless"])? {
        "bonded" => LayerBase::Bonded { poisson_ratio: poisson_ratio()? },
        _ => LayerBase::Frictionless,
    };
    let layering = Layering::layer(length(&field)?, base).map_err(|error| {
        let ratio = table.optional("poisson_ratio");
        let is_ratio = matches!(error, Error::InvalidValue { field: "poisson_ratio", .. });
        refused(ratio.as_ref().filter(|_| is_ratio).unwrap_or(&field), &error)
    })?;
    Ok(Some((field, layering)))
}

/// The fault of a field whose value was refused.
fn refused(field: &Field<'_>, error: &Error) -> FileError {
    let Error::InvalidValue { value, requirement, field: name } = error else {
        return field.error(error);
    };
    let dimension = match *name {
        "thickness" if field.is_string() => Dimension::LENGTH,
        "young_modulus" => Dimension::PRESSURE,
        _ => Dimension::NONE,
    };
    field.error(format!("is {}: must be {requirement}", engineering(*value, dimension)))
}
