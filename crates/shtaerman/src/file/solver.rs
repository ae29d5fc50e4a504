//! `[solver]`.

use crate::document::{FileError, TableReader};
use crate::{DEFAULT_DEGREE, Solver};

/// Highest degree a file may ask for; memory refuses far below.
const MOST_DEGREE: usize = 1 << 40;

const CONTACT_HELP: &str = "write contact = \"bilateral\" in [solver]: the full base stays in contact and the pressure may pull";

pub(super) fn read(reader: &TableReader<'_>) -> Result<Solver, FileError> {
    let table =
        reader.required("solver").map_err(|error| error.with_help(CONTACT_HELP))?.table()?;
    let contact = table.required("contact").map_err(|error| match error.help() {
        Some(_) => error,
        None => error.with_help(CONTACT_HELP),
    })?;
    if contact.string()? == "unilateral" {
        let message = "is \"unilateral\", which is not solved yet: must be \"bilateral\"";
        return Err(contact
            .error(message)
            .with_help("a warning tells where the bilateral pressure pulls"));
    }
    contact.one_of(&["bilateral"])?;
    if let Some(method) = table.optional("method") {
        method.one_of(&["spectral"])?;
    }
    let degree = match table.optional("n") {
        Some(field) => field.count(1..=MOST_DEGREE)?,
        None => DEFAULT_DEGREE,
    };
    Ok(Solver { degree })
}
