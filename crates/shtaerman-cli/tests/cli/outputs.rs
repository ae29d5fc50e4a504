//! Where results go: whole or not at all, the same bytes each time.

use crate::cli::support::{DIMENSIONLESS, Folder, PHYSICAL};

#[test]
fn a_result_goes_to_the_file_and_nothing_to_the_terminal() {
    let folder = Folder::with(PHYSICAL);
    for format in ["table", "json", "csv"] {
        let solve = ["solve", "punch.toml", "--format", format];
        let shown = folder.run(&solve).answer();
        let written = folder.run(&[&solve[..], &["-o", "out.txt"]].concat()).answer();
        assert_eq!(written, "");
        assert_eq!(folder.read("out.txt"), shown);
    }
    assert_eq!(folder.files(), ["out.txt", "punch.toml"]);
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let folder = Folder::with(PHYSICAL);
    let bytes = |arguments: &[&str]| {
        folder.run(&[arguments, &["--output", "out.txt"]].concat()).answer();
        let plot = std::fs::read(folder.path(arguments.last().unwrap())).unwrap();
        (std::fs::read(folder.path("out.txt")).unwrap(), plot)
    };
    for arguments in [
        ["solve", "punch.toml", "--format", "json", "--plot", "plot.svg"].as_slice(),
        &["solve", "punch.toml", "--format", "csv", "--plot", "plot.png"],
        &["convergence", "punch.toml", "--max-n", "64", "--format", "json", "--plot", "plot.svg"],
        &["reproduce", "--format", "json", "--plot", "plot.svg"],
    ] {
        let (result, plot) = bytes(arguments);
        assert!(!result.is_empty() && !plot.is_empty());
        assert!((result, plot) == bytes(arguments), "{arguments:?}");
    }
}

#[test]
fn plots_are_what_their_suffix_says() {
    let folder = Folder::with(PHYSICAL);
    for (name, start) in [("a.svg", b"<".as_slice()), ("a.png", b"\x89PNG"), ("A.SVG", b"<")] {
        let table = folder.run(&["solve", "punch.toml", "--plot", name]).answer();
        assert!(table.contains(&format!("plot: {name}")), "{table}");
        assert!(std::fs::read(folder.path(name)).unwrap().starts_with(start));
    }
    for (name, said) in [("a.bmp", "use .svg, .png or .pdf"), ("a", "use .svg, .png or .pdf")] {
        let folder = Folder::with(PHYSICAL);
        let run = folder.run(&["solve", "punch.toml", "--plot", name, "--output", "out.txt"]);
        assert!(run.refusal().contains(said), "{}", run.stderr);
        assert_eq!(folder.files(), ["punch.toml"]);
    }
}

#[test]
fn unwritable_outputs_are_refused_by_the_name_asked_for() {
    for (path, said) in [
        ("nowhere/out.svg", "nowhere/out.svg cannot be written: there is no folder"),
        ("folder.svg", "folder.svg cannot be written: it is a folder"),
        ("file/out.svg", "file/out.svg cannot be written: there is no folder"),
        ("folder.svg/..", "cannot be written"),
    ] {
        let folder = Folder::with(PHYSICAL);
        std::fs::create_dir(folder.path("folder.svg")).unwrap();
        folder.write("file", "mine");
        let before = folder.files();
        let commands: [&[&str]; 5] = [
            &["solve", "punch.toml", "--output", path],
            &["solve", "punch.toml", "--output", "out.txt", "--plot", path],
            &["convergence", "punch.toml", "--output", path],
            &["regularity", "--theta0", "1", "--output", path],
            &["reproduce", "--output", path],
        ];
        for command in commands {
            let run = folder.run(command);
            let message = run.refusal();
            if command.contains(&"--plot") && path.ends_with("..") {
                continue;
            }
            assert!(message.contains(said), "{command:?}: {message}");
            assert!(!run.stderr.contains(".shtaerman-"), "{}", run.stderr);
            assert_eq!(folder.files(), before, "{command:?}");
        }
        assert_eq!(folder.read("file"), "mine");
    }
    let run = Folder::new().run(&["init", "nowhere/punch.toml"]);
    assert!(run.refusal().contains("nowhere/punch.toml cannot be written"));
}

#[test]
fn a_failed_command_leaves_old_results_alone() {
    let folder = Folder::with(&PHYSICAL.replace("\"0.8 MN/m\"", "\"0.8 MPa\""));
    folder.write("out.json", "old");
    folder.write("out.svg", "old");
    let arguments = ["solve", "punch.toml", "--output", "out.json", "--plot", "out.svg"];
    folder.run(&arguments).refusal();
    assert_eq!((folder.read("out.json"), folder.read("out.svg")), ("old".into(), "old".into()));
    folder.write("punch.toml", PHYSICAL);
    folder.run(&arguments).answer();
    assert!(
        folder.read("out.json").contains("settlement") && folder.read("out.svg").contains("<svg")
    );
    assert_eq!(folder.files(), ["out.json", "out.svg", "punch.toml"]);
}

#[test]
fn outputs_do_not_overwrite_one_another_or_the_input() {
    for (arguments, said) in [
        (
            ["--output", "out.svg", "--plot", "out.svg"].as_slice(),
            "two outputs would be written to out.svg",
        ),
        (&["--output", "./out.svg", "--plot", "out.svg"], "two outputs"),
        (&["--output", "punch.toml"], "punch.toml is the problem file"),
        (&["--output", "./punch.toml"], "is the problem file"),
    ] {
        let folder = Folder::with(PHYSICAL);
        let run = folder.run(&[&["solve", "punch.toml"], arguments].concat());
        assert!(run.refusal().contains(said), "{}", run.stderr);
        assert_eq!(folder.files(), ["punch.toml"]);
        assert_eq!(folder.read("punch.toml"), PHYSICAL);
    }
}

#[cfg(unix)]
#[test]
fn devices_are_written_and_not_replaced() {
    use std::os::unix::fs::{FileTypeExt, symlink};
    let folder = Folder::with(PHYSICAL);
    symlink("/dev/null", folder.path("null")).unwrap();
    assert_eq!(folder.run(&["solve", "punch.toml", "--output", "null"]).answer(), "");
    assert!(folder.path("null").is_symlink());
    assert!(std::fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    // A link to a file stays a link.
    folder.write("old.txt", "old");
    symlink("old.txt", folder.path("link.txt")).unwrap();
    folder.run(&["solve", "punch.toml", "--output", "link.txt"]).answer();
    assert!(folder.path("link.txt").is_symlink());
    assert!(folder.read("old.txt").contains("settlement"));
}

#[test]
fn standard_input_is_as_good_as_a_file() {
    for problem in [PHYSICAL, DIMENSIONLESS] {
        let folder = Folder::with(problem);
        let from_file = folder.run(&["solve", "punch.toml", "--format", "json"]).answer();
        let from_input =
            folder.run_with_input(&["solve", "-", "--format", "json"], problem).answer();
        assert_eq!(from_file, from_input);
    }
    let run = Folder::new().run_with_input(&["solve", "-"], &PHYSICAL.replace("5 mm", "5 Pa"));
    assert!(run.refusal().contains("standard input:7: punch.half_width: is a length"));
}

#[cfg(target_os = "linux")]
#[test]
fn full_and_closed_streams_do_not_panic() {
    use std::fs::File;
    let folder = Folder::with(PHYSICAL);
    let full = || File::options().write(true).open("/dev/full").unwrap();
    let run = folder.command(&["solve", "punch.toml"]).stdout(full()).output().unwrap();
    assert_eq!(run.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&run.stderr).contains("standard output cannot be written"));
    let run = folder.command(&["solve", "nowhere.toml"]).stderr(full()).output().unwrap();
    assert_eq!(run.status.code(), Some(2));
}

#[test]
fn warnings_go_where_people_see_them_and_change_no_exit_code() {
    let pulls = PHYSICAL.replace("(2*20)", "(2*0.5)");
    let folder = Folder::with(&pulls);
    let table = folder.run(&["solve", "punch.toml"]);
    assert_eq!((table.code, table.stderr.as_str()), (Some(0), ""));
    assert!(
        table.stdout.contains("warning: the pressure is negative at x = -5 mm to -"),
        "{}",
        table.stdout
    );
    let json = folder.run(&["solve", "punch.toml", "--format", "json"]);
    assert!(
        json.stderr.starts_with("warning: the pressure is negative at x = "),
        "{}",
        json.stderr
    );
    let json = json.json();
    assert_eq!(json["warnings"][0]["code"], "negative_pressure");
    // Where it says, the pressure is negative.
    let message = json["warnings"][0]["message"].as_str().unwrap();
    let inner = message.split(" to ").nth(1).unwrap().split(" mm").next().unwrap();
    let edge: f64 = inner.parse().unwrap();
    let at = format!("{} mm,{} mm", edge - 0.001, edge + 0.001);
    let csv = folder.run(&["solve", "punch.toml", "--format", "csv", "--at", &at]).answer();
    let signs: Vec<bool> = csv.lines().skip(1).map(|line| line.contains(",-")).collect();
    assert_eq!(signs, [true, false], "{csv}");

    for (from, to, code) in
        [("xi^4 - xi/2", "abs(xi)", "profile_not_resolved"), ("13.0", "300.0", "low_degree")]
    {
        let folder = Folder::with(&DIMENSIONLESS.replace(from, to));
        let json = folder.run(&["solve", "punch.toml", "--format", "json"]).json();
        let warnings = json["warnings"].as_array().unwrap();
        assert!(warnings.iter().any(|warning| warning["code"] == code), "{warnings:?}");
    }
}
