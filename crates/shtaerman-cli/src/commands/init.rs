//! `shtaerman init`.

use std::fmt::Write;
use std::path::Path;

use shtaerman::document::load_bytes;

use super::schema;
use crate::Failure;
use crate::arguments::{ExampleGeometry, InitArguments, SchemaName};
use crate::failure::shown;
use crate::output::Outputs;

const EXAMPLE: &str = include_str!("../../data/example.toml");
const CIRCULAR: &str = include_str!("../../../../examples/rough_ball.toml");
const PERIODIC: &str = include_str!("../../../../examples/wave.toml");
const PAIR: &str = include_str!("../../../../examples/two_punches.toml");
const DIMENSIONLESS: &str = include_str!("../../data/example_dimensionless.toml");
const EQUATION: &str = include_str!("../../data/example_equation.toml");

pub(super) fn run(arguments: &InitArguments) -> Result<(), Failure> {
    let (text, usual, command) = match (arguments.equation, arguments.dimensionless) {
        (true, _) => (EQUATION.to_owned(), "equation.toml", "equation"),
        (false, true) => (DIMENSIONLESS.to_owned(), "punch.toml", "solve"),
        (false, false) => (example(arguments.geometry), "punch.toml", "solve"),
    };
    let mut outputs = Outputs::default();
    let path = arguments.file.as_deref().unwrap_or(Path::new(usual));
    if path == Path::new("-") {
        // No schema lies beside a terminal.
        outputs.result(None, text);
        return outputs.write();
    }
    let schema = if arguments.equation { SchemaName::EquationFile } else { SchemaName::Problem };
    let beside = path.with_file_name(schema::file_name(schema));
    // Comments name the file as it is called.
    let stem = Path::new(usual).with_extension("");
    let text = match path.file_stem() {
        Some(called) => {
            let named = |ending: &str| {
                (
                    format!("{}{ending}", shown(&stem)),
                    format!("{}{ending}", shown(Path::new(called))),
                )
            };
            [".toml", ".svg"]
                .map(named)
                .iter()
                .fold(text, |text, (old, new)| text.replace(old, new))
        }
        None => text,
    };
    let text = format!("#:schema ./{}\n{text}", schema::file_name(schema));
    // A link that leads nowhere is there as well.
    if path.symlink_metadata().is_ok() && !arguments.force {
        return Err(Failure::Usage(format!(
            "{} exists already: name another file, or overwrite it with --force",
            path.display()
        )));
    }
    outputs.file(path, text);
    let name = shown(path);
    let mut said = format!("wrote {name}\n");
    if is_to_write(&beside, schema::text(schema))? {
        outputs.file(&beside, schema::text(schema));
        let _ = writeln!(said, "wrote {}, by which editors complete and check it", shown(&beside));
    }
    let _ = writeln!(said, "solve it with: shtaerman {command} {name}");
    outputs.result(None, said);
    outputs.write()
}

/// Whether the schema is not there yet; an older one of ours is renewed, what is not ours is left alone and told.
fn is_to_write(path: &Path, schema: &str) -> Result<bool, Failure> {
    if path.symlink_metadata().is_err() {
        return Ok(true);
    }
    let known = load_bytes(path).ok().and_then(|bytes| String::from_utf8(bytes).ok());
    match known {
        Some(text) if text == schema => Ok(false),
        Some(text) if text.contains("\"title\": \"Shtaerman ") => Ok(true),
        _ => Err(Failure::Usage(format!(
            "{} is there and is no schema of ours, to which the file would refer: name a file in another folder",
            shown(path)
        ))),
    }
}

/// An example of a geometry, by the usual name of a file.
fn example(geometry: ExampleGeometry) -> String {
    let (text, name) = match geometry {
        ExampleGeometry::Plane => return EXAMPLE.to_owned(),
        ExampleGeometry::Circular => (CIRCULAR, "rough_ball"),
        ExampleGeometry::Periodic => (PERIODIC, "wave"),
        ExampleGeometry::Pair => (PAIR, "two_punches"),
    };
    text.replace(&format!("examples/{name}"), "punch").replace(name, "punch")
}
