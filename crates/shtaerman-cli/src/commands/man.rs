//! `shtaerman man`.

use clap::{Command, CommandFactory};

use crate::Failure;
use crate::arguments::{Arguments, ManArguments};
use crate::failure::shown;
use crate::output::Outputs;

pub(super) fn run(arguments: &ManArguments) -> Result<(), Failure> {
    let mut outputs = Outputs::default();
    let mut root = Arguments::command();
    root.build();
    let commands = with_subcommands(&root);
    let count = commands.len();
    for command in commands {
        let page = clap_mangen::Man::new(command.clone());
        let mut text = Vec::new();
        let path = arguments.folder.join(page.get_filename());
        page.render(&mut text).map_err(|error| Failure::unwritten(&path, &error))?;
        outputs.file(&path, text);
    }
    outputs.result(None, format!("wrote {count} pages to {}\n", shown(&arguments.folder)));
    outputs.write()
}

/// A command and all below it, but the `help` that clap adds.
fn with_subcommands(command: &Command) -> Vec<&Command> {
    let below = command.get_subcommands().filter(|command| command.get_name() != "help");
    std::iter::once(command).chain(below.flat_map(with_subcommands)).collect()
}
