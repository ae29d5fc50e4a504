//! The tables that a problem file must have.

use crate::document::{FileError, TableReader};

/// What stands in each, for those who left one out.
const SECTIONS: [(&str, &str); 3] = [
    ("foundation", "young_modulus, poisson_ratio, and roughness or subgrade_modulus"),
    ("punch", "half_width and profile"),
    ("load", "force or settlement, and moment, eccentricity or tilt"),
];

/// A table at the top of a file.
pub(super) fn required<'d>(
    reader: &TableReader<'d>,
    name: &'static str,
) -> Result<TableReader<'d>, FileError> {
    let field = reader.required(name).map_err(|error| {
        let content = SECTIONS.iter().find(|(section, _)| *section == name);
        match content.filter(|_| error.help().is_none()) {
            Some((_, content)) => error.with_help(format!(
                "[{name}] states {content}; `shtaerman init` writes an example"
            )),
            None => error,
        }
    })?;
    field.table()
}
