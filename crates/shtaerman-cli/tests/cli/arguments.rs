//! `--help`, `--version`, and arguments that make no sense.

use clap::{Command, CommandFactory};
use shtaerman_cli::arguments::Arguments;

use crate::cli::support::{Folder, PHYSICAL};

#[test]
fn help_and_version_are_answers() {
    let folder = Folder::new();
    let version = folder.run(&["--version"]).answer();
    assert_eq!(version.trim_end(), concat!("shtaerman ", env!("CARGO_PKG_VERSION")));
    let help = folder.run(&["--help"]).answer();
    let program = Arguments::command();
    let commands: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
    assert!(commands.contains(&"solve"), "{commands:?}");
    for command in commands {
        assert!(help.contains(command), "{help}");
        let help = folder.run(&[command, "--help"]).answer();
        assert!(help.contains("Usage: shtaerman"), "{help}");
    }
    assert!(help.contains("130"), "exit codes: {help}");
}

#[test]
fn wrong_arguments_end_with_2() {
    let folder = Folder::with(PHYSICAL);
    for (arguments, said) in [
        (["slove", "punch.toml"].as_slice(), "'solve'"),
        (&["solve"], "FILE.toml"),
        (&["solve", "punch.toml", "more.toml"], "more.toml"),
        (&["solve", "punch.toml", "--format", "xml"], "json"),
        (&["solve", "punch.toml", "--fromat", "json"], "--format"),
        (&["solve", "punch.toml", "--points", "0"], "--points 0: must be from 2"),
        (&["solve", "punch.toml", "--points", "1"], "--points 1: must be from 2"),
        (&["solve", "punch.toml", "--points", "100000000"], "--points 100000000"),
        (&["solve", "punch.toml", "--points", "-3"], "-3"),
        (&["solve", "punch.toml", "--points", "few"], "few"),
        (&["solve", "punch.toml", "--points", "9", "--at", "0"], "--at"),
        (&["solve", "punch.toml", "--set"], "--set"),
        (&["validate", "punch.toml", "--format", "json"], "--format"),
        (&["convergence", "punch.toml", "--max-n", "many"], "many"),
    ] {
        let run = folder.run(arguments);
        run.refusal();
        assert!(run.stderr.contains(said), "{arguments:?}: {}", run.stderr);
    }
    let run = folder.run(&[]);
    assert_eq!((run.code, run.stdout.as_str()), (Some(2), ""));
    assert!(run.stderr.contains("Usage: shtaerman"), "{}", run.stderr);
    assert_eq!(folder.files(), ["punch.toml"]);
}
