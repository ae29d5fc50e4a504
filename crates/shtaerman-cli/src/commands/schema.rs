//! `shtaerman schema`.

use crate::Failure;
use crate::arguments::{SchemaArguments, SchemaName};
use crate::output::Outputs;

pub(super) fn run(arguments: &SchemaArguments) -> Result<(), Failure> {
    let mut outputs = Outputs::default();
    outputs.result(arguments.output.as_deref(), text(arguments.name));
    outputs.write()
}

/// The JSON Schema of a kind of files.
pub(super) fn text(name: SchemaName) -> &'static str {
    macro_rules! schema {
        ($name:literal) => {
            include_str!(concat!("../../../../schema/", $name, ".schema.json"))
        };
    }
    match name {
        SchemaName::Problem => schema!("problem"),
        SchemaName::EquationFile => schema!("equation_file"),
        SchemaName::Study => schema!("study"),
        SchemaName::Answer => schema!("answer"),
        SchemaName::Find => schema!("find"),
        SchemaName::Stress => schema!("stress"),
        SchemaName::Equation => schema!("equation"),
        SchemaName::Spectrum => schema!("spectrum"),
        SchemaName::Roughness => schema!("roughness"),
        SchemaName::Convergence => schema!("convergence"),
        SchemaName::Regularity => schema!("regularity"),
        SchemaName::Reproduction => schema!("reproduction"),
        SchemaName::Trace => schema!("trace"),
    }
}

/// The name of its file.
pub(super) fn file_name(name: SchemaName) -> &'static str {
    match name {
        SchemaName::EquationFile => "equation_file.schema.json",
        _ => "problem.schema.json",
    }
}
