//! `shtaerman sweep` of equations, the schema of study files, and folders in which runs were killed.

use std::fs::File;
use std::time::{Duration, SystemTime};

use crate::cli::support::{
    DIMENSIONLESS, Folder, UNILATERAL, assert_valid, number, repository, schema, toml_as_json,
};

const EQUATION: &str = r#"[equation]
kind = "second"
lambda = 1.0
rhs = "exp(x) * cos(3*x)"

[kernel]
name = "power"
a = 1.0
mu = 0.3

[study]
vary."kernel.mu" = [0.2, 0.4]
vary."equation.lambda" = { from = 0.5, to = 2.0, count = 2, scale = "log" }
outputs = ["integral", "phi(0.25)", "phi(-1)"]
audited_sample = 1
part_size = 3
"#;

/// A moment is bounded by the force that varies with it, not by that of the file.
#[test]
fn values_that_hold_together_are_no_fault_of_each_alone() {
    let folder = Folder::new();
    let small = UNILATERAL.replace("0.8 MN/m", "0.1 MN/m");
    let vary = |moments: &str| {
        format!(
            "{small}\n[study]\nvary.\"load.force\" = [\"1 MN/m\", \"2 MN/m\"]\nvary.\"load.moment\" = [{moments}]\noutputs = [\"tilt\"]\n"
        )
    };
    folder.write("study.toml", vary("\"1 kN\", \"2 kN\""));
    let text = folder.run(&["sweep", "study.toml", "-o", "out"]).answer();
    assert!(text.contains("4 cases answered, 0 refused"), "{text}");
    folder.write("study.toml", vary("\"1 kN\", \"2 mm\""));
    let run = folder.run(&["sweep", "study.toml", "-o", "other"]);
    let refusal = run.refusal();
    assert!(refusal.contains("load.moment") && refusal.contains("is refused"), "{refusal}");
}

#[test]
fn every_equation_is_what_the_command_says_to_the_last_bit() {
    let folder = Folder::new();
    folder.write("study.toml", EQUATION);
    folder.write("equation.toml", EQUATION.split("[study]").next().unwrap());
    let text = folder.run(&["sweep", "study.toml", "-o", "out"]).answer();
    assert!(text.contains("4 cases answered, 0 refused"), "{text}");
    assert!(text.contains("audit of a sample of 1 case: 0 not kept"), "{text}");
    let lines: Vec<String> = ["out/part-00000000.csv", "out/part-00000001.csv"]
        .iter()
        .flat_map(|part| folder.read(part).lines().skip(1).map(str::to_owned).collect::<Vec<_>>())
        .collect();
    assert_eq!(lines.len(), 4);
    for line in lines {
        let fields: Vec<&str> = line.split(',').collect();
        let set = [format!("equation.lambda={}", fields[1]), format!("kernel.mu={}", fields[2])];
        let more = ["--set", &set[0], "--set", &set[1], "--no-audit", "--format", "json"];
        let json = folder
            .run(&[&["equation", "equation.toml", "--at", "0.25,-1"], more.as_slice()].concat())
            .json();
        let told = [
            ("/integral", 3),
            ("/error/integral", 4),
            ("/solution/phi/0", 5),
            ("/error/solution_sup", 6),
            ("/solution/phi/1", 7),
            ("/error/solution_sup", 8),
        ];
        for (pointer, column) in told {
            let value: f64 = fields[column].parse().unwrap();
            assert_eq!(value.to_bits(), number(&json, pointer).to_bits(), "{pointer}: {line}");
        }
        assert_eq!(json["error"]["kind"], fields[9]);
    }
    let valid = folder.run(&["validate", "study.toml"]).answer();
    assert!(valid.contains("study of 4 cases over equation.lambda, kernel.mu"), "{valid}");
    for command in ["equation", "solve"] {
        let refused = folder.run(&[command, "study.toml"]);
        assert!(refused.refusal().contains("study"), "{}", refused.stderr);
    }
}

#[test]
fn the_example_of_an_equation_runs_and_is_drawn() {
    let folder = Folder::new();
    let study = repository().join("examples/studies/graded_ground.toml");
    let study = study.to_str().unwrap();
    let text = folder.run(&["sweep", study, "-o", "out", "--plot", "graded.svg"]).answer();
    assert!(text.contains("25 cases answered, 0 refused"), "{text}");
    // No unit is told of what has none.
    assert!(!text.contains(" [SI]") && !text.contains(" [m]"), "{text}");
    let drawn = folder.read("graded.svg");
    roxmltree::Document::parse(&drawn).unwrap();
    assert!(drawn.contains("phi(1)"), "the outputs are named");
}

/// What the program takes the schema takes, and what it refuses for its keys the schema refuses as well.
#[test]
fn the_schema_of_studies_is_as_strict_as_the_program() {
    let schema = schema("study");
    for entry in std::fs::read_dir(repository().join("examples/studies")).unwrap() {
        let text = std::fs::read_to_string(entry.unwrap().path()).unwrap();
        assert_valid(&schema, &toml_as_json(&text), &text);
    }
    let force = "vary.\"load.force\" = { from = 1e5, to = \"1 MN/m\", count = 3 }\n";
    let drawn = "vary.\"load.force\" = { distribution = \"normal\", mean = 5e5, standard_deviation = 1e4 }\n";
    let study = |more: &str| format!("{UNILATERAL}\n[study]\n{more}");
    let bare = |more: &str| format!("{DIMENSIONLESS}\n[study]\n{more}");
    let equation = |more: &str| {
        let problem = EQUATION.split("vary.").next().unwrap();
        format!("{problem}vary.\"kernel.mu\" = [0.2, 0.4]\n{more}")
    };
    for text in [
        study(force),
        study(
            "vary.\"load.force\" = [1e5, \"1 MN/m\"]\nvary.\"solver.contact\" = [\"bilateral\"]\n",
        ),
        study(&format!(
            "{force}design = \"grid\"\noutputs = [\"pressure(2 mm)\", \"max_shear\"]\n"
        )),
        study(&format!("{drawn}design = \"sobol-indices\"\ncount = 16\nseed = 3\naudit = true\n")),
        study(&format!(
            "{force}design = \"random\"\ncount = 4\naudited_sample = 0\npart_size = 1\n"
        )),
        study("vary.\"load.force\" = { from = 1e5, to = 2e5 }\ndesign = \"sobol\"\ncount = 8\n"),
        study(
            "vary.\"foundation.young_modulus\" = [1e9]\nfind.force = { peak_pressure = \"90 MPa\" }\noutputs = [\"found\"]\n",
        ),
        // What varies may be missing in the problem.
        study(force).replace("force = \"0.8 MN/m\"\n", ""),
        bare("vary.\"dimensionless.theta0\" = { from = 1, to = 2, count = 2 }\n"),
        equation(""),
        equation("outputs = [\"integral\", \"phi(0.5)\"]\n"),
    ] {
        assert_valid(&schema, &toml_as_json(&text), &text);
        let folder = Folder::new();
        folder.write("study.toml", &text);
        folder.run(&["validate", "study.toml"]).answer();
    }
    for text in [
        UNILATERAL.replace("[load]", "[study]\n[load]"),
        study("outputs = [\"settlement\"]\n"),
        study("vary.force = [1.0]\n"),
        study("vary.\"study.count\" = [1]\n"),
        study("vary.\"load.force\" = []\n"),
        study("vary.\"load.force\" = 3\n"),
        study("vary.\"load.force\" = [[1.0]]\n"),
        study("vary.\"load.force\" = { from = 1, to = 2 }\n"),
        study("vary.\"load.force\" = { from = 1, count = 2 }\n"),
        study("vary.\"load.force\" = { from = 1, to = 2, count = 2.5 }\n"),
        study("vary.\"load.force\" = { from = 1, to = 2, count = 2, step = 1 }\n"),
        study("vary.\"load.force\" = { from = 1, to = 2, count = 2, scale = \"cubic\" }\n"),
        study(drawn),
        study(&format!("{drawn}design = \"sobol\"\n")),
        study(&format!("{drawn}design = \"sobol\"\ncount = 70000\n")),
        study(&format!("{drawn}design = \"sobol-indices\"\ncount = 4\n")),
        study(&format!("{}design = \"sobol\"\ncount = 4\n", drawn.replace("normal", "gauss"))),
        study(&format!("{}design = \"sobol\"\ncount = 4\n", drawn.replace("mean", "middle"))),
        study(&format!("{force}design = \"sobel\"\ncount = 4\n")),
        study(&format!("{force}count = 4\n")),
        study(&format!("{force}outputs = []\n")),
        study(&format!("{force}outputs = [\"peak\"]\n")),
        study(&format!("{force}outputs = [\"tilt\", \"tilt\"]\n")),
        study(&format!("{force}outputs = [\"phi(0)\"]\n")),
        study(&format!("{force}outputs = [\"integral\"]\n")),
        study(&format!("{force}part_size = 0\n")),
        study(&format!("{force}audit = 1\n")),
        study(&format!("{force}parts = 3\n")),
        study(&format!("{force}find.crown = {{ }}\n")),
        study(&format!("{force}find.roughness = {{ settlement = 1, contact_width = 1 }}\n")),
        equation("outputs = [\"settlement\"]\n"),
        equation("find.force = { peak_pressure = 1 }\n"),
    ] {
        assert!(!schema.is_valid(&toml_as_json(&text)), "the schema takes {text}");
        let folder = Folder::new();
        folder.write("study.toml", &text);
        folder.run(&["validate", "study.toml"]).refusal();
    }
}

#[test]
fn one_key_with_very_many_values_is_estimated_too() {
    let folder = Folder::new();
    let force = "vary.\"load.force\" = { from = 1e5, to = 1e6, count = 1000000000000 }\n";
    folder.write("study.toml", format!("{UNILATERAL}\n[study]\n{force}"));
    let run = folder.run(&["sweep", "study.toml", "-o", "out"]);
    assert!(run.refusal().contains("1000000000000 cases"), "{run:?}");
    assert!(run.stderr.contains("hours") && run.stderr.contains("--yes"), "{run:?}");
    assert!(!folder.path("out").exists());
}

#[test]
fn what_killed_runs_left_is_removed_once_it_is_old_and_nobody_has_it() {
    let folder = Folder::new();
    folder.write("study.toml", EQUATION);
    folder.run(&["sweep", "study.toml", "-o", "out"]).answer();
    let old = SystemTime::now() - Duration::from_secs(3600);
    let left = |name: &str, time: SystemTime| {
        let file = File::create(folder.path(&format!("out/{name}"))).unwrap();
        file.set_modified(time).unwrap();
        file
    };
    drop(left(".shtaerman-old", old));
    drop(left(".shtaerman-new", SystemTime::now()));
    drop(left(".other", old));
    let held = left(".shtaerman-held", old);
    held.lock().unwrap();
    folder.run(&["sweep", "study.toml", "-o", "out"]).answer();
    let names: Vec<String> = std::fs::read_dir(folder.path("out"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.starts_with('.'))
        .collect();
    let is_there = |name: &str| names.iter().any(|known| known == name);
    assert!(!is_there(".shtaerman-old"), "{names:?}");
    assert!([".shtaerman-new", ".shtaerman-held", ".other"].into_iter().all(is_there), "{names:?}");
}

/// With `cargo test -p shtaerman-cli --features parquet --test all -- parquet`; pyarrow reads the same files in `python/tests/test_parquet.py`.
#[cfg(feature = "parquet")]
#[test]
fn parquet_parts_hold_the_numbers_of_the_others_and_are_done_again_where_they_are_cut() {
    let folder = Folder::new();
    folder.write("study.toml", EQUATION);
    let sweep = |more: &[&str]| folder.run(&[&["sweep", "study.toml"], more].concat());
    let text = sweep(&["-o", "text"]).answer();
    let told = sweep(&["-o", "out", "--format", "parquet"]).answer();
    assert_eq!(text, told);
    let part = folder.path("out/part-00000000.parquet");
    let whole = std::fs::read(&part).unwrap();
    assert!(whole.starts_with(b"PAR1") && whole.ends_with(b"PAR1"));
    // The extremes are read back from the files, not computed.
    let summary = sweep(&["-o", "out", "--format", "parquet", "--summary"]).answer();
    let extremes = |text: &str| {
        text.lines().filter(|line| line.contains("phi(")).map(str::to_owned).collect::<Vec<_>>()
    };
    assert!(summary.contains("0 computed, 2 kept"), "{summary}");
    assert_eq!(extremes(&summary)[..2], extremes(&text)[..2]);
    let mut flipped = whole.clone();
    flipped[whole.len() / 2] ^= 1;
    for broken in [&whole[..whole.len() - 40], &whole[..3], &flipped] {
        std::fs::write(&part, broken).unwrap();
        let again = sweep(&["-o", "out", "--format", "parquet"]);
        assert!(again.stderr.contains("it is computed again"), "{}", again.stderr);
        assert!(std::fs::read(&part).unwrap() == whole);
    }
    let other = sweep(&["-o", "out", "--format", "npz"]);
    assert!(other.refusal().contains("as parquet, not npz"), "{}", other.stderr);
}

/// Without roughness the pressure at a corner is infinite: it is said so, and drawn as what runs out of the frame.
#[test]
fn what_is_infinite_in_a_study_is_shown_as_such() {
    let folder = Folder::new();
    let smooth = "[foundation]\nyoung_modulus = \"210 GPa\"\npoisson_ratio = 0.3\nroughness = 0\n[punch]\nhalf_width = \"5 mm\"\nprofile = \"0\"\n[load]\nforce = \"0.5 MN/m\"\nmoment = 0\n";
    folder.write("smooth.toml", smooth);
    folder.write(
        "study.toml",
        format!("{smooth}\n[study]\nvary.\"foundation.roughness\" = [\"0 m/Pa\", \"1e-14 m/Pa\", \"1e-13 m/Pa\"]\noutputs = [\"settlement\", \"peak_pressure\"]\n"),
    );
    let text = folder.run(&["sweep", "study.toml", "-o", "out", "--plot", "out.svg"]).answer();
    assert!(text.contains("peak_pressure is infinite in 1 case:"), "{text}");
    assert!(!text.contains("NaN") && !text.contains("inf "), "{text}");
    let drawn = folder.read("out.svg");
    assert!(drawn.contains(">infinite<") && drawn.contains("peak pressure [MPa]"), "{drawn}");

    let vary = ["solve", "smooth.toml", "--vary", "load.force=1,2 MN/m"];
    let table = folder.run(&[&vary[..], &["--plot", "all.svg"]].concat()).answer();
    assert!(table.contains(" infinite") && table.contains("[Pa]"), "{table}");
    assert!(folder.read("all.svg").contains("peak pressure is infinite"), "the note");
    let csv = folder.run(&[&vary[..], &["--outputs", "peak_pressure", "--format", "csv"]].concat());
    let csv = csv.answer();
    assert!(csv.lines().nth(1).unwrap().starts_with("0,1000000.0,inf,,"), "{csv}");
    let none = ["--outputs", "peak_pressure", "--plot", "none.svg"];
    let refused = folder.run(&[&vary[..], &none].concat());
    assert!(refused.refusal().contains("peak pressure is infinite"), "{refused:?}");
}
