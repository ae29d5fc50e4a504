//! Command lines, parsed and not run.

use std::sync::OnceLock;

use clap::error::ErrorKind;
use clap::{Command, CommandFactory, Parser};
use shtaerman_cli::arguments::Arguments;

use crate::broken::broken;
use crate::check::Outcome;
use crate::{Random, check, written};

/// What people write beside commands and options, some of it wrong.
const VALUES: &[&str] = &[
    "slove",
    "punch.toml",
    "-",
    "--",
    "json",
    "csv",
    "table",
    "-o",
    "out.svg",
    "2x2",
    "power",
    "yukawa",
    "log",
    "-x",
    "--format=json",
    "--points=-1",
    "--fromat",
    "",
];

/// The commands, and after them the options of all of them.
fn known() -> &'static [Vec<String>; 2] {
    static KNOWN: OnceLock<[Vec<String>; 2]> = OnceLock::new();
    KNOWN.get_or_init(|| {
        let mut known = [Vec::new(), Vec::new()];
        let mut program = Arguments::command();
        program.build();
        collect(&program, &mut known);
        known
    })
}

fn collect(command: &Command, known: &mut [Vec<String>; 2]) {
    let options = command.get_arguments().filter_map(|option| option.get_long());
    known[1].extend(options.map(|name| format!("--{name}")));
    for inner in command.get_subcommands() {
        known[0].push(inner.get_name().to_owned());
        collect(inner, known);
    }
}

/// Parses a line of arguments: what is refused has a printable message, and only help and version are no errors.
pub(super) fn case(random: &mut Random) -> Result<Outcome, String> {
    let mut line = vec!["shtaerman".to_owned()];
    let [commands, options] = known();
    if !random.one_in(16) {
        line.push(commands[random.below(commands.len())].clone());
    }
    for _ in 0..random.below(8) {
        let part = match random.below(8) {
            0 => written::number(random),
            1 => written::quantity(random),
            2 => commands[random.below(commands.len())].clone(),
            3 | 4 => random.of(VALUES).to_owned(),
            _ => options[random.below(options.len())].clone(),
        };
        line.push(if random.one_in(6) { broken(random, &part) } else { part });
    }
    let input = line.join(" | ");
    let Err(error) = Arguments::try_parse_from(&line) else { return Ok(Outcome::Accepted) };
    let is_shown = matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion);
    check::holds(error.exit_code() == if is_shown { 0 } else { 2 }, "exit code", &input)?;
    let message = error.render().to_string();
    check::holds(!message.trim().is_empty(), "no message", &input)?;
    Ok(Outcome::Refused)
}
