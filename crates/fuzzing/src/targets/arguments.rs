//! Command lines, parsed and not run.

use clap::Parser;
use clap::error::ErrorKind;
use shtaerman_cli::arguments::Arguments;

use crate::broken::broken;
use crate::check::Outcome;
use crate::{Random, check, written};

const COMMANDS: &[&str] = &[
    "solve",
    "find",
    "validate",
    "init",
    "reproduce",
    "regularity",
    "convergence",
    "equation",
    "stress",
    "spectrum",
    "roughness",
    "help",
    "slove",
];

const PARTS: &[&str] = &[
    "force",
    "roughness",
    "crown",
    "profile",
    "bearing",
    "table",
    "greenwood-williamson",
    "punch.toml",
    "-",
    "--",
    "--set",
    "--at",
    "--format",
    "json",
    "csv",
    "table",
    "--output",
    "-o",
    "out.svg",
    "--plot",
    "--points",
    "--no-audit",
    "--cross-check",
    "--surface",
    "--sensitivities",
    "--datum-distance",
    "--datum-depth",
    "--grid",
    "2x2",
    "--rows",
    "--count",
    "--a",
    "--chi0",
    "--m",
    "--mu",
    "--verify",
    "--help",
    "-h",
    "--version",
    "-V",
    "power",
    "yukawa",
    "log",
    "--peak-pressure",
    "--contact-width",
    "--max-n",
    "--hardness",
    "--trace",
    "-x",
    "--coefficient",
    "--format=json",
    "--points=-1",
    "",
];

/// Parses a line of arguments: what is refused has a printable message, and only help and version are no errors.
pub(super) fn case(random: &mut Random) -> Result<Outcome, String> {
    let mut line = vec!["shtaerman".to_owned()];
    if !random.one_in(16) {
        line.push(random.of(COMMANDS).to_owned());
    }
    for _ in 0..random.below(8) {
        let part = match random.below(6) {
            0 => written::number(random),
            1 => written::quantity(random),
            _ => random.of(PARTS).to_owned(),
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
