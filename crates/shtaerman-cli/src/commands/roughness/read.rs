//! Quantities given as options.

use clap::Args;
use shtaerman::Error;
use shtaerman::quantity::{self, Dimension, plain};

use crate::Failure;
use crate::arguments::RoughnessArguments;

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

pub(super) fn optional_unit(
    name: &str,
    text: Option<&String>,
    dimension: Dimension,
) -> Result<Option<f64>, Failure> {
    text.map(|text| unit(name, text, dimension)).transpose()
}

/// Whether `shtaerman roughness` has an option of this name: a law has quantities that are none.
fn is_option(name: &str) -> bool {
    let command = RoughnessArguments::augment_args(clap::Command::new("roughness"));
    command
        .get_subcommands()
        .flat_map(clap::Command::get_arguments)
        .any(|argument| argument.get_long() == Some(name))
}

/// Values that make no sense are the fault of the options, and named as they are written there.
pub(super) fn usage(error: Error) -> Failure {
    match error {
        Error::InvalidValue { field, value, requirement } if is_option(field) => Failure::Usage(
            format!("--{field}: {} (in SI units) must be {requirement}", plain(value)),
        ),
        Error::InvalidValue { field, value, requirement } => Failure::Usage(format!(
            "the {field} of the law comes out as {}: it must be {requirement}; the values of the options are too large or too small together",
            plain(value)
        )),
        other => Failure::Problem(other),
    }
}
