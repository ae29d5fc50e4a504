//! `shtaerman init`.

use std::path::Path;

use crate::Failure;
use crate::arguments::{ExampleGeometry, InitArguments};
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
        outputs.result(None, text);
        return outputs.write();
    }
    // A link that leads nowhere is there as well.
    if path.symlink_metadata().is_ok() && !arguments.force {
        return Err(Failure::Usage(format!(
            "{} exists already: name another file, or overwrite it with --force",
            path.display()
        )));
    }
    outputs.file(path, text);
    let name = shown(path);
    outputs.result(None, format!("wrote {name}\nsolve it with: shtaerman {command} {name}\n"));
    outputs.write()
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
