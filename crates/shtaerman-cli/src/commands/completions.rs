//! `shtaerman completions`.

use clap::CommandFactory;

use crate::Failure;
use crate::arguments::{Arguments, CompletionsArguments};
use crate::output::Outputs;

pub(super) fn run(arguments: &CompletionsArguments) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "shtaerman", &mut script);
    let mut outputs = Outputs::default();
    outputs.result(arguments.output.as_deref(), script);
    outputs.write()
}
