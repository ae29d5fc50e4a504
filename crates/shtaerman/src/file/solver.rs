//! `[solver]`.

use crate::document::{FileError, TableReader};
use crate::{MethodChoice, Solver};

/// Highest degree a file may ask for; memory refuses far below.
const MOST_DEGREE: usize = 1 << 40;

const CONTACT_HELP: &str = "write contact = \"bilateral\" in [solver]: the full base stays in contact and the pressure may pull";

pub(super) fn read(reader: &TableReader<'_>) -> Result<Solver, FileError> {
    let table = reader.required("solver").map_err(with_contact_help)?.table()?;
    let contact = table.required("contact").map_err(with_contact_help)?;
    if contact.string()? == "unilateral" {
        let message = "is \"unilateral\", which is not solved yet: must be \"bilateral\"";
        return Err(contact
            .error(message)
            .with_help("a warning tells where the bilateral pressure pulls"));
    }
    contact.one_of(&["bilateral"])?;
    let method = match table.optional("method") {
        Some(field) => match field.one_of(&["auto", "spectral", "sinc"])? {
            "spectral" => MethodChoice::Spectral,
            "sinc" => MethodChoice::Sinc,
            _ => MethodChoice::Auto,
        },
        None => MethodChoice::Auto,
    };
    let degree = match table.optional("n") {
        Some(field) if method == MethodChoice::Sinc => {
            return Err(field.error(
                "belongs to method = \"spectral\"; collocation chooses its nodes by the error",
            ));
        }
        Some(field) => Some(field.count(1..=MOST_DEGREE)?),
        None => None,
    };
    let tolerance = match table.optional("tolerance") {
        Some(field) => {
            let value = field.number()?;
            if !(value > 0.0 && value < 1.0) {
                return Err(field.error(format!(
                    "is {value}: must be greater than 0 and less than 1, like 1e-10"
                )));
            }
            Some(value)
        }
        None => None,
    };
    Ok(Solver { method, degree, tolerance })
}

/// What to write, unless the help names a misspelt key already.
fn with_contact_help(error: FileError) -> FileError {
    if error.help().is_some() { error } else { error.with_help(CONTACT_HELP) }
}
