//! Messages are short, on lines of their own, and nothing in them moves a terminal.

use crate::cli::support::{Folder, PHYSICAL, Run};

/// Begins a title of the window, rings, colours, goes up a line; the last are one character each that terminals obey or that turns the text round.
const HOSTILE: &str = "\u{1b}]0;owned\u{7}\u{1b}[31m\u{1b}[1A\r\u{9b}2J\u{202e}";

/// The same as a string of TOML writes it.
const ESCAPED: &str = "\\u001b]0;owned\\u0007\\u001b[31m\\u001b[1A\\r\\u009b2J\\u202e";

#[track_caller]
fn assert_harmless(run: &Run) {
    for text in [&run.stdout, &run.stderr] {
        let foreign = |sign: char| sign.is_control() && sign != '\n' || sign == '\u{202e}';
        assert!(!text.contains(foreign), "{text:?}");
    }
    let message = run.stderr.lines().next().unwrap_or_default();
    assert!(message.starts_with("error: ") || run.code == Some(0), "{run:?}");
}

#[test]
fn control_characters_of_files_are_escaped() {
    let csv = PHYSICAL.replace("\"x^2 / (2*20)\"", "{ csv = \"trace.csv\" }");
    for (from, to) in [
        ("[solver]".to_owned(), format!("[solver]\n\"{ESCAPED}\" = 1")),
        ("[solver]".to_owned(), format!("[\"{ESCAPED}\"]\na = 1\n[solver]")),
        ("[solver]".to_owned(), format!("{HOSTILE}\n[solver]")),
        ("[solver]".to_owned(), format!("# {HOSTILE}\n[solver]")),
        ("\"bilateral\"".to_owned(), format!("\"{ESCAPED}\"")),
        ("\"bilateral\"".to_owned(), format!("\"{HOSTILE}\"")),
        ("5 mm".to_owned(), format!("5 {ESCAPED}")),
        ("5 mm".to_owned(), format!("{ESCAPED}5 mm")),
        ("x^2 / (2*20)".to_owned(), format!("x^2 + {ESCAPED}(x)")),
        ("x^2 / (2*20)".to_owned(), format!("x{ESCAPED}")),
        ("\"x^2 / (2*20)\"".to_owned(), format!("{{ csv = \"{ESCAPED}\" }}")),
        (
            "\"x^2 / (2*20)\"".to_owned(),
            format!("{{ csv = \"trace.csv\", x_unit = \"{ESCAPED}\" }}"),
        ),
        ("n = 40".to_owned(), format!("n = \"{ESCAPED}\"")),
    ] {
        let folder = Folder::with(&PHYSICAL.replace(&from, &to));
        let run = folder.run(&["solve", "punch.toml"]);
        assert_eq!(run.code, Some(2), "{to:?}");
        assert_harmless(&run);
    }
    let folder = Folder::with(&csv);
    folder.write("trace.csv", format!("-6,1\n0,{HOSTILE}\n6,1\n"));
    assert_harmless(&folder.run(&["solve", "punch.toml"]));
    let run = folder.run(&["roughness", "table", "trace.csv"]);
    assert!(run.refusal().contains("is not a number: `0.\\u{1b}]0`"), "{}", run.stderr);
    assert_harmless(&run);
}

/// The caret stands under what is at fault, though what is before it has grown.
#[test]
fn carets_stand_where_they_should_beside_escapes() {
    let line = "profile = 5 # \u{202e} \u{1b}";
    let folder = Folder::with(&PHYSICAL.replace("profile = \"x^2 / (2*20)\"", line));
    let run = folder.run(&["solve", "punch.toml"]);
    assert_harmless(&run);
    let shown = run.stderr.lines().find(|line| line.contains(" 8 │ ")).unwrap();
    assert!(shown.ends_with("profile = 5 # \\u{202e} \\u{1b}"), "{}", run.stderr);
    let long = "half_width = \"5 mm\" # ";
    let folder = Folder::with(&PHYSICAL.replace("[load]", &format!("{long}\u{202e}\n[load]")));
    assert_harmless(&folder.run(&["solve", "punch.toml"]));
    let set = format!("{HOSTILE}=1");
    assert_harmless(&folder.run(&["solve", "punch.toml", "--set", &set]));
}

#[cfg(unix)]
#[test]
fn names_and_arguments_are_escaped() {
    let folder = Folder::with(PHYSICAL);
    let name = format!("{HOSTILE}.toml");
    folder.write(&name, PHYSICAL);
    for arguments in [
        ["solve", &name].as_slice(),
        &["validate", &name],
        &["stress", &name],
        &["convergence", &name, "--max-n", "32"],
        &["find", "profile", &name, "--pressure", "1"],
        &["solve", &name, "--set", "load.force=1 mm"],
        &["solve", &name, "--output", &name],
        &["init", &name],
        &["init", &format!("{HOSTILE}2.toml")],
        &["solve", "punch.toml", "--plot", &format!("{HOSTILE}.svg")],
        &["solve", "punch.toml", "--plot", &name],
        &["solve", "punch.toml", "--at", HOSTILE],
        &["solve", "punch.toml", "--points", HOSTILE],
        &["solve", "punch.toml", &format!("--{HOSTILE}")],
        &["solve", "punch.toml", "--set", HOSTILE],
        &["solve", HOSTILE],
        &["stress", "punch.toml", "--grid", HOSTILE],
        &["find", "profile", "punch.toml", "--pressure", HOSTILE],
        &["spectrum", HOSTILE],
        &["spectrum", "log", "--a", HOSTILE],
        &["roughness", "table", HOSTILE],
        &[HOSTILE],
    ] {
        assert_harmless(&folder.run(arguments));
    }
}

#[test]
fn names_of_50_kilobytes_are_not_repeated() {
    let name = "a".repeat(50_000);
    let folder = Folder::with(PHYSICAL);
    let short = |run: &Run, what: &str| {
        assert_eq!(run.code, Some(2), "{what}");
        assert!(run.stderr.len() < 2000, "{what}: {} bytes", run.stderr.len());
        assert!(run.stderr.starts_with("error: "), "{what}: {}", run.stderr);
    };
    for (from, to) in [
        ("[solver]", format!("[{name}]\na = 1\n[{name}b]\n[solver]")),
        ("[solver]", format!("[solver]\n{name} = 1")),
        ("n = 40", format!("n = 1{}", "0".repeat(50_000))),
        ("n = 40", format!("n = {name}")),
        ("\"bilateral\"", format!("\"{name}\"")),
        ("5 mm", format!("5 {name}")),
        ("\"x^2 / (2*20)\"", format!("{{ csv = \"{name}\" }}")),
        ("x^2 / (2*20)", format!("{name}(x)")),
    ] {
        let folder = Folder::with(&PHYSICAL.replace(from, &to));
        short(&folder.run(&["solve", "punch.toml"]), from);
    }
    let set = format!("load.{name}=1");
    let option = format!("--{name}");
    let gw = ["roughness", "gw", "--density", "1", "--radius", "1", "--modulus", "1"];
    for arguments in [
        ["solve", &name].as_slice(),
        &["solve", "punch.toml", "--set", &name],
        &["solve", "punch.toml", "--set", &set],
        &["solve", "punch.toml", "--at", &name],
        &["solve", "punch.toml", "--points", &name],
        &["solve", "punch.toml", "--format", &name],
        &["solve", "punch.toml", "--plot", &name],
        &["solve", "punch.toml", "--output", &name],
        &["solve", "punch.toml", &option],
        &["stress", "punch.toml", "--grid", &name],
        &["find", "profile", "punch.toml", "--pressure", &name],
        &["init", &name],
        &["regularity", "--theta0", &name],
        &["spectrum", &name],
        &["spectrum", "log", "--a", "1", "--interval", &name],
        &[&gw[..], &["--pressure", "1", "--deviation", &name]].concat(),
        &[&name],
    ] {
        short(&folder.run(arguments), &arguments.join(" ").replace(&name, "NAME"));
    }
}

#[test]
fn quantities_that_are_no_options_are_named_as_what_they_are() {
    let folder = Folder::new();
    let bearing = |b: &str, nu: &str, height: &str, more: &[&str]| {
        let given = ["roughness", "bearing", "--b", b, "--nu", nu, "--height", height];
        folder.run(&[&given, more].concat())
    };
    for run in [
        bearing("1", "1e6", "1 m", &["--modulus", "1 GPa", "--radius", "1 mm"]),
        bearing("1e-300", "1", "1e300 m", &["--hardness", "1e-300 Pa"]),
    ] {
        let message = run.refusal();
        assert!(message.starts_with("error: the coefficient of the law comes out as"), "{message}");
        assert!(message.contains("the values of the options are too large or too small"));
    }
    let run = bearing("1", "-1", "1 m", &["--hardness", "1 GPa"]);
    assert!(run.refusal().starts_with("error: --nu: -1 (in SI units) must be"), "{}", run.stderr);
}

/// What is missing is said with the file and with what belongs there.
#[test]
fn missing_sections_say_what_they_hold() {
    let without = |name: &str| {
        let (front, back) = PHYSICAL.split_once(&format!("[{name}]")).unwrap();
        let rest = back.split_once("\n[").map_or("", |(_, rest)| rest);
        format!("{front}[{rest}")
    };
    for name in ["foundation", "punch", "load"] {
        let folder = Folder::new();
        for (run, file) in [
            (folder.run_with_input(&["solve", "-"], &without(name)), "standard input"),
            (Folder::with(&without(name)).run(&["validate", "punch.toml"]), "punch.toml"),
        ] {
            assert_eq!(run.refusal(), format!("error: {file}: {name}: is missing"));
            let lines = format!("help: add these lines, with values of your own:\n  [{name}]\n");
            assert!(run.stderr.contains(&lines), "{}", run.stderr);
        }
    }
    let folder = Folder::new();
    folder.write("e.toml", "[equation]\nkind = \"first\"\nrhs = \"1\"\n");
    let run = folder.run(&["equation", "e.toml"]);
    assert_eq!(run.refusal(), "error: e.toml: kernel: is missing");
    assert!(run.stderr.contains("  [kernel]\n  name = \"log\"\n"), "{}", run.stderr);
}

/// Infinite and undefined values are of no file: they are said to come out, with the field they belong to and no 300 digits.
#[test]
fn values_beyond_double_precision_are_named() {
    let folder = Folder::with(PHYSICAL);
    let solve = |command: &[&str], set: &[&str]| {
        let set = set.iter().flat_map(|set| ["--set", set]);
        folder.run(&command.iter().copied().chain(set).collect::<Vec<_>>())
    };
    let find = ["find", "force", "punch.toml", "--peak-pressure", "1 MPa"];
    for (run, said) in [
        (
            solve(&["solve", "punch.toml"], &["load.settlement=1e308"]),
            "load.settlement: the settlement comes out as inf: load, profile and moduli",
        ),
        (
            solve(&find, &["load.force=1e-300", "load.moment=1e300"]),
            "punch.toml: the eccentricity comes out as inf: load, profile and moduli",
        ),
        (
            solve(
                &["solve", "punch.toml"],
                &["load.force=1e-300", "load.moment=1e300", "solver={}"],
            ),
            "moment = 1e300: tips the punch over: its magnitude must be less than P a = 5",
        ),
        (
            solve(&["convergence", "punch.toml", "--max-n", "100000000000"], &[]),
            "error: --max-n 100000000000: must be at most 4194304",
        ),
    ] {
        let message = run.refusal();
        assert!(message.contains(said) && message.len() < 300, "{message}");
    }
}
