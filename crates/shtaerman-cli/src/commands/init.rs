//! `shtaerman init`.

use std::path::Path;

use crate::Failure;
use crate::arguments::InitArguments;
use crate::failure::shown;
use crate::output::Outputs;

const EXAMPLE: &str = include_str!("../../data/example.toml");
const DIMENSIONLESS: &str = include_str!("../../data/example_dimensionless.toml");
const EQUATION: &str = include_str!("../../data/example_equation.toml");

pub(super) fn run(arguments: &InitArguments) -> Result<(), Failure> {
    let (text, usual, command) = match (arguments.equation, arguments.dimensionless) {
        (true, _) => (EQUATION, "equation.toml", "equation"),
        (false, true) => (DIMENSIONLESS, "punch.toml", "solve"),
        (false, false) => (EXAMPLE, "punch.toml", "solve"),
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
