//! What tables look like: their width, their colours, what they leave out.

use std::f64::consts::PI;

use crate::cli::support::{Folder, UNILATERAL, finished, number, repository};

/// The longest line that is not to be copied.
fn widest(text: &str) -> usize {
    let lines = text.lines().filter(|line| !line.starts_with("set: "));
    lines.map(|line| line.chars().count()).max().unwrap_or(0)
}

#[test]
fn pages_keep_to_80_columns() {
    let folder = Folder::with(&UNILATERAL.replace("moment = \"100 N\"", "moment = 0"));
    let examples = repository().join("examples");
    for entry in std::fs::read_dir(examples).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|suffix| suffix != "toml") {
            continue;
        }
        let name = path.to_str().unwrap();
        let command = if name.contains("equation_") { "equation" } else { "solve" };
        let page = folder.run(&[command, name, "--no-audit"]).answer();
        // The name of a file is not broken.
        let page = page.replace(name, "FILE");
        assert!(widest(&page) <= 80, "{name}: {page}");
    }
    for command in [
        &["solve", "punch.toml", "--sensitivities", "--at", "0,1 mm", "--units", "inch"][..],
        &["find", "crown", "punch.toml", "--no-audit"],
        &["find", "profile", "punch.toml", "--pressure", "1"],
        &["stress", "punch.toml", "--at", "0,1 mm; 1 mm,2 mm", "--yield-stress", "350 MPa"],
        &["convergence", "punch.toml", "--max-n", "32", "--set", "solver.contact=bilateral"],
        &["regularity", "--theta0", "13"],
        &["reproduce"],
        &["spectrum", "log", "--a", "1", "--verify"],
        &["solve", "punch.toml", "--vary", "load.force=0.1,0.8 MN/m", "--no-audit"],
    ] {
        let page = folder.run(command).answer();
        assert!(widest(&page) <= 80, "{command:?}: {page}");
    }
}

#[test]
fn colours_are_for_terminals_and_for_who_wants_them() {
    let folder = Folder::with(UNILATERAL);
    let run = |name: &str, value: &str| {
        let mut command = folder.command(&["solve", "punch.toml", "--no-audit"]);
        command.env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE").env(name, value);
        finished(command.output().unwrap()).answer()
    };
    let plain = run("TERM", "xterm");
    assert!(!plain.contains('\u{1b}'));
    let painted = run("CLICOLOR_FORCE", "1");
    assert!(painted.contains("\u{1b}[1mmethod"), "{painted:?}");
    let mut both = folder.command(&["solve", "punch.toml", "--no-audit"]);
    both.env("NO_COLOR", "1").env("CLICOLOR_FORCE", "0");
    assert_eq!(finished(both.output().unwrap()).answer(), plain);
    // A file has none, whoever wants them.
    let mut command = folder.command(&["solve", "punch.toml", "--no-audit", "-o", "out.txt"]);
    command.env("CLICOLOR_FORCE", "1");
    finished(command.output().unwrap()).answer();
    assert_eq!(folder.read("out.txt"), plain);
}

#[test]
fn what_lies_below_its_error_is_shown_as_zero() {
    // The tilt that so small a moment makes is below what the answer states of its error.
    let folder = Folder::with(&UNILATERAL.replace("moment = \"100 N\"", "moment = 1e-12"));
    let solve = ["solve", "punch.toml", "--no-audit"];
    let json = folder.run(&[&solve[..], &["--format", "json"]].concat()).json();
    let tilt = number(&json, "/physical/tilt");
    let error = number(&json, "/error/physical/tilt");
    assert!(tilt != 0.0 && tilt.abs() < error, "{tilt} {error}");
    let table = folder.run(&solve).answer();
    let row = |name: &str| {
        let line = table.lines().find(|line| line.starts_with(&format!(" {name} "))).unwrap();
        line.split_whitespace().nth(1).unwrap().to_owned()
    };
    assert_eq!(row("tilt"), "0", "{table}");
    // What the load prescribes has no error, however small it is.
    assert_eq!(row("moment"), "1", "{table}");
}

#[test]
fn the_mean_over_the_contact_is_the_force_over_its_width_or_area() {
    let folder = Folder::new();
    for (example, is_round) in
        [("rough_ball", true), ("power_layer", false), ("two_punches", false)]
    {
        let path = repository().join(format!("examples/{example}.toml"));
        let path = path.to_str().unwrap();
        let json = folder.run(&["solve", path, "--format", "json", "--no-audit"]).json();
        for part in ["physical", "dimensionless"] {
            let of = |key: &str| number(&json, &format!("/{part}/{key}"));
            let measure = if is_round { PI * of("zones/0/1").powi(2) } else { of("contact_width") };
            let mean = of("force") / measure;
            assert!((of("mean_contact_pressure") / mean - 1.0).abs() < 1e-12, "{example} {part}");
            assert!(of("mean_contact_pressure") > of("mean_pressure"), "{example}");
        }
    }
    let ball = repository().join("examples/rough_ball.toml");
    let table = folder.run(&["solve", ball.to_str().unwrap(), "--no-audit"]).answer();
    assert!(table.contains(" contact                     radius 190.94 µm  a disk"), "{table}");
    assert!(table.contains("over the contact"), "{table}");
}

#[test]
fn sensitivities_are_per_cent_for_each_per_cent() {
    let folder = Folder::with(UNILATERAL);
    let table = folder.run(&["solve", "punch.toml", "--sensitivities", "--no-audit"]).answer();
    let row = |name: &str| -> Vec<f64> {
        let line = table.lines().rfind(|line| line.starts_with(&format!(" {name} "))).unwrap();
        line.trim_start_matches(' ')
            .trim_start_matches(name)
            .split_whitespace()
            .map(|word| word.parse().unwrap())
            .collect()
    };
    let answer = |roughness: f64, force: f64, pointer: &str| {
        let roughness = format!("foundation.roughness={roughness:e}");
        let force = format!("load.force={force:e}");
        let run = ["solve", "punch.toml", "--set", &roughness, "--set", &force];
        let json = folder.run(&[&run[..], &["--format", "json", "--no-audit"]].concat()).json();
        number(&json, pointer)
    };
    // The head of the table: roughness, Young's modulus, force.
    for (name, pointer) in
        [("settlement", "/physical/settlement"), ("largest pressure", "/physical/peak_pressure")]
    {
        let step = 1e-3;
        let central = |up: f64, down: f64| (up / down).ln() / ((1.0 + step) / (1.0f64 - step)).ln();
        let by_roughness = central(
            answer(1.2e-14 * (1.0 + step), 0.8e6, pointer),
            answer(1.2e-14 * (1.0 - step), 0.8e6, pointer),
        );
        let by_force = central(
            answer(1.2e-14, 0.8e6 * (1.0 + step), pointer),
            answer(1.2e-14, 0.8e6 * (1.0 - step), pointer),
        );
        let found = row(name);
        assert!(
            (found[0] - by_roughness).abs() < 1e-3,
            "{name}: {found:?} {by_roughness}\n{table}"
        );
        assert!((found[2] - by_force).abs() < 1e-3, "{name}: {found:?} {by_force}\n{table}");
    }
    assert!(table.contains("per cent for each per cent (estimate)"), "{table}");
}

#[test]
fn missing_tables_show_the_lines_to_add() {
    let folder = Folder::new();
    let parts: Vec<&str> = UNILATERAL.split("\n[").collect();
    for (index, name) in ["foundation", "punch", "load"].into_iter().enumerate() {
        let kept: Vec<&str> =
            (0..3).filter(|part| *part != index).map(|part| parts[part]).collect();
        let text = kept.join("\n[");
        let text = if text.starts_with('[') { text } else { format!("[{text}") };
        folder.write("part.toml", &text);
        let run = folder.run(&["solve", "part.toml"]);
        assert!(
            run.refusal().starts_with(&format!("error: part.toml: {name}: is missing")),
            "{}",
            run.stderr
        );
        let lines: Vec<&str> =
            run.stderr.lines().skip_while(|line| !line.starts_with("help: ")).skip(1).collect();
        assert_eq!(lines.first().copied(), Some(format!("  [{name}]").as_str()), "{}", run.stderr);
        // With the lines added it is a problem.
        let added: Vec<&str> = lines.iter().map(|line| line.trim_start()).collect();
        folder.write("whole.toml", format!("{text}\n{}\n", added.join("\n")));
        folder.run(&["validate", "whole.toml"]).answer();
    }
}

#[test]
fn doubts_end_every_command_that_solves_when_asked() {
    let folder = Folder::with(UNILATERAL);
    let set = ["--set", "foundation.young_modulus=200", "--strict"];
    for command in [
        &["find", "force", "punch.toml", "--contact-width", "10 mm", "--no-audit"][..],
        &["find", "roughness", "punch.toml", "--settlement", "3 um", "--no-audit"],
        &["stress", "punch.toml", "--no-audit"],
        &["export", "abaqus", "punch.toml", "--units", "mm"],
    ] {
        let run = folder.run(&[command, &set[..]].concat());
        // What cannot be found with such a slip is refused anyway.
        assert_eq!(run.code, Some(2), "{command:?}: {run:?}");
        assert_eq!(run.stdout, "", "{command:?}");
        folder.run(&[command, &["--strict"]].concat()).answer();
    }
    let gw = [
        "roughness",
        "gw",
        "--deviation",
        "0.5 um",
        "--density",
        "1e6 1/mm^2",
        "--radius",
        "10 um",
    ];
    let gw = [&gw[..], &["--modulus", "110 GPa", "--pressure", "20 GPa"]].concat();
    let said = folder.run(&gw).answer();
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("surface in contact at the highest pressure"), "{said}");
    assert!(
        folder
            .run(&[&gw[..], &["--strict"]].concat())
            .refusal()
            .contains("--strict: the model has")
    );
}
