//! `shtaerman init`.

use std::path::Path;

use crate::Failure;
use crate::arguments::InitArguments;
use crate::output::Outputs;

const EXAMPLE: &str = include_str!("../../data/example.toml");
const DIMENSIONLESS: &str = include_str!("../../data/example_dimensionless.toml");

pub(super) fn run(arguments: &InitArguments) -> Result<(), Failure> {
    let text = if arguments.dimensionless { DIMENSIONLESS } else { EXAMPLE };
    let mut outputs = Outputs::default();
    let path = arguments.file.as_path();
    if path == Path::new("-") {
        outputs.result(None, text);
        return outputs.write();
    }
    if path.exists() && !arguments.force {
        return Err(Failure::Usage(format!(
            "{} exists already: name another file, or overwrite it with --force",
            path.display()
        )));
    }
    outputs.file(path, text);
    outputs
        .result(None, format!("wrote {0}\nsolve it with: shtaerman solve {0}\n", path.display()));
    outputs.write()
}
