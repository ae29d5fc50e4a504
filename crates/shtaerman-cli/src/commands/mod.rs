//! One file a command.

mod book;
mod completions;
mod convergence;
mod equation;
pub(crate) mod explore;
mod export;
mod find;
mod init;
mod man;
mod picture;
mod places;
mod problem_file;
mod regularity;
mod reproduce;
mod roughness;
mod schema;
mod sheet;
mod solve;
mod spectrum;
mod stress;
mod study_sense;
mod sweep;
mod trace;
mod validate;
mod vary;

use crate::Failure;
use crate::arguments::Command;

/// Runs a command.
pub(crate) fn execute(command: &Command) -> Result<(), Failure> {
    match command {
        Command::Solve(arguments) => solve::run(arguments),
        Command::Find(arguments) => find::run(arguments),
        Command::Validate(arguments) => validate::run(arguments),
        Command::Init(arguments) => init::run(arguments),
        Command::Reproduce(arguments) => reproduce::run(arguments),
        Command::Regularity(arguments) => regularity::run(arguments),
        Command::Convergence(arguments) => convergence::run(arguments),
        Command::Equation(arguments) => equation::run(arguments),
        Command::Stress(arguments) => stress::run(arguments),
        Command::Spectrum(arguments) => spectrum::run(arguments),
        Command::Sweep(arguments) => sweep::run(arguments),
        Command::Explore(arguments) => explore::run(arguments),
        Command::Book(arguments) => book::run(arguments),
        Command::Roughness(arguments) => roughness::run(arguments),
        Command::Export(arguments) => export::run(arguments),
        Command::Trace(arguments) => trace::run(arguments),
        Command::Schema(arguments) => schema::run(arguments),
        Command::Completions(arguments) => completions::run(arguments),
        Command::Man(arguments) => man::run(arguments),
    }
}

pub(crate) use export::exported;

/// The JSON of a command that finds all from its arguments.
pub(crate) fn json_of(command: &Command) -> Result<String, Failure> {
    match command {
        Command::Spectrum(arguments) => spectrum::json(arguments),
        Command::Roughness(arguments) => roughness::json(arguments),
        _ => Err(Failure::Usage("only spectrum and roughness take no problem file".to_owned())),
    }
}
