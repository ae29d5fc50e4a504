//! `[solver]`.

use fredholm::degenerate::BYTES_A_DEGREE;

use crate::document::{Field, FileError, TableReader};
use crate::{MethodChoice, Solver};

/// Share of the free memory that a solve may take.
const MEMORY_SHARE: f64 = 0.9;

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
        Some(field) => Some(degree_of(&field)?),
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

/// A degree whose solve fits into memory.
fn degree_of(field: &Field<'_>) -> Result<usize, FileError> {
    let degree = field.count(1..=usize::MAX >> 12)?;
    let available = fredholm::memory::available();
    let needed = BYTES_A_DEGREE * degree as f64;
    if needed > MEMORY_SHARE * available as f64 {
        return Err(field.error(format!(
            "is {degree}: that needs {:.3} GB of memory, and {:.3} GB are free",
            needed / 1e9,
            available as f64 / 1e9
        )));
    }
    Ok(degree)
}

/// What to write, unless the help names a misspelt key already.
fn with_contact_help(error: FileError) -> FileError {
    if error.help().is_some() { error } else { error.with_help(CONTACT_HELP) }
}
