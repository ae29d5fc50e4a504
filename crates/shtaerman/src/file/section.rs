//! The tables that a problem file must have.

use crate::document::{FileError, TableReader};

/// Lines that each may have, for those who left one out.
const SECTIONS: [(&str, &str); 3] = [
    (
        "foundation",
        "[foundation]\nyoung_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nroughness = \"1.2e-14 m/Pa\"",
    ),
    ("punch", "[punch]\nhalf_width = \"5 mm\"\nprofile = \"x^2 / (2*20)\""),
    ("load", "[load]\nforce = \"0.8 MN/m\"\nmoment = 0"),
];

/// All of them, for a file that has nothing.
pub(super) fn whole() -> String {
    let lines: Vec<&str> = SECTIONS.iter().map(|(_, lines)| *lines).collect();
    format!("add these lines, with values of your own:\n{}", lines.join("\n\n"))
}

/// The load of a circular punch.
const DISK: (&str, &str) = ("load", "[load]\nforce = \"500 N\"\nmoment = 0");

fn is_circular(reader: &TableReader<'_>) -> bool {
    let punch = reader.table("punch").ok().flatten();
    let geometry = punch.and_then(|punch| punch.string("geometry").ok().flatten());
    geometry == Some("circular")
}

/// A table at the top of a file.
pub(super) fn required<'d>(
    reader: &TableReader<'d>,
    name: &'static str,
) -> Result<TableReader<'d>, FileError> {
    let field = reader.required(name).map_err(|error| {
        let lines = match (name, is_circular(reader)) {
            ("load", true) => Some(&DISK),
            _ => SECTIONS.iter().find(|(section, _)| *section == name),
        };
        match lines.filter(|_| error.help().is_none()) {
            Some((_, lines)) => {
                error.with_help(format!("add these lines, with values of your own:\n{lines}"))
            }
            None => error,
        }
    })?;
    field.table()
}
