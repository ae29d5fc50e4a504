//! Quantities given as options.

use shtaerman::Error;
use shtaerman::quantity::{self, Dimension};

use crate::Failure;

/// The SI value of `--name text`.
pub(super) fn quantity(name: &str, text: &str, dimension: Dimension) -> Result<f64, Failure> {
    let text = text.trim();
    quantity::parse(text)
        .and_then(|quantity| quantity.of(dimension, text))
        .map_err(|error| Failure::Usage(format!("--{name} `{text}`: {error}")))
}

pub(super) fn number(name: &str, text: &str) -> Result<f64, Failure> {
    quantity(name, text, Dimension::NONE)
}

pub(super) fn optional_quantity(
    name: &str,
    text: Option<&String>,
    dimension: Dimension,
) -> Result<Option<f64>, Failure> {
    text.map(|text| quantity(name, text, dimension)).transpose()
}

/// The two values of `--name one,two`.
pub(super) fn pair(name: &str, text: &str, dimension: Dimension) -> Result<[f64; 2], Failure> {
    let Some((one, two)) = text.split_once(',') else {
        return Err(Failure::Usage(format!(
            "--{name} `{text}`: needs two values with a comma between"
        )));
    };
    Ok([quantity(name, one, dimension)?, quantity(name, two, dimension)?])
}

/// The SI value of a unit.
pub(super) fn unit(name: &str, text: &str, dimension: Dimension) -> Result<f64, Failure> {
    let value = quantity(name, &format!("1 {text}"), dimension)?;
    if value > 0.0 {
        Ok(value)
    } else {
        Err(Failure::Usage(format!("--{name} `{text}`: is no unit")))
    }
}

/// Values that make no sense are the fault of the options, and named as they are written there.
pub(super) fn usage(error: Error) -> Failure {
    match error {
        Error::InvalidValue { field, value, requirement } => {
            Failure::Usage(format!("--{field}: {value} (in SI units) must be {requirement}"))
        }
        other => Failure::Problem(other),
    }
}
