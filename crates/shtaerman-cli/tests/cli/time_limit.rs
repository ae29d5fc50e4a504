//! `--time-limit` and `solver.time_limit`.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::cli::support::{Folder, UNILATERAL, assert_valid, repository, schema};

/// A trace of this many points, waves of random phase, whose contact takes seconds.
fn trace(folder: &Folder, points: usize) {
    const WAVES: usize = 200;
    let mut state = 20_261_123u64;
    let phases: [f64; WAVES] = std::array::from_fn(|_| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        TAU * (state >> 33) as f64 / f64::from(u32::MAX)
    });
    let mut text = "x,f\n".to_owned();
    for i in 0..points {
        let t = 2.0 * i as f64 / (points - 1) as f64 - 1.0;
        let wave = |(k, phase): (usize, &f64)| {
            let k = (k + 1) as f64;
            (PI * k * t + phase).cos() / k.sqrt()
        };
        let height: f64 = phases.iter().enumerate().map(wave).sum();
        let _ = writeln!(text, "{:e},{:e}", 0.01 * t, 1e-6 * height);
    }
    std::fs::write(folder.path("trace.csv"), text).unwrap();
    let problem = UNILATERAL
        .replace("half_width = \"5 mm\"", "half_width = 0.01")
        .replace("\"x^2 / (2*20)\"", "{ csv = \"trace.csv\" }")
        .replace("moment = \"100 N\"", "moment = 0");
    std::fs::write(folder.path("punch.toml"), problem).unwrap();
}

#[test]
fn a_search_that_takes_longer_ends_in_time_and_writes_no_file() {
    let folder = Folder::with(UNILATERAL);
    trace(&folder, 60_000);
    for (option, format) in [("20 ms", "json"), ("0.9 s", "json"), ("0.4 s", "table")] {
        let start = Instant::now();
        let run = folder.run(&[
            "solve",
            "punch.toml",
            "--time-limit",
            option,
            "--format",
            format,
            "-o",
            "out.txt",
        ]);
        // The machine may be busy; without the limit it is a minute.
        assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
        assert_eq!(run.code, Some(3), "{run:?}");
        assert!(run.stderr.contains("time limit"), "{run:?}");
        assert!(!folder.path("out.txt").exists());
        if format == "json" && !run.stdout.is_empty() {
            let best: Value = serde_json::from_str(&run.stdout).unwrap();
            assert_valid(&schema("answer"), &best, "the best so far");
            let codes = best["warnings"].as_array().unwrap().iter();
            assert!(codes.map(|warning| &warning["code"]).any(|code| code == "time_limit"));
        }
    }
    let run = folder.run(&[
        "find",
        "force",
        "punch.toml",
        "--peak-pressure",
        "1 MPa",
        "--time-limit",
        "0.1 s",
    ]);
    assert_eq!(run.code, Some(3), "{run:?}");
}

/// What is asked for beside the answer takes a minute; the message says that it was this.
#[test]
fn an_answer_that_was_found_is_not_told_to_be_missing() {
    let folder = Folder::with(UNILATERAL);
    let stress = ["stress", "punch.toml", "--grid", "2000x2000", "--no-audit", "--format", "csv"];
    let run = folder.run(&[stress.as_slice(), &["--time-limit", "3 s", "-o", "s.csv"]].concat());
    let said = run.failure(3);
    let begins = "error: the answer was found, and its stresses did not end within the time limit of 3 s: no file was written";
    assert!(said.starts_with(begins), "{said}");
    assert_eq!(folder.files(), ["punch.toml"]);
}

#[test]
fn a_limit_that_is_not_reached_changes_nothing() {
    let folder = Folder::with(UNILATERAL);
    let plain = folder.run(&["solve", "punch.toml", "--format", "json"]).answer();
    let limit = ["--time-limit", "10 min"];
    let by_option = [&["solve", "punch.toml", "--format", "json"], limit.as_slice()].concat();
    assert_eq!(folder.run(&by_option).answer(), plain);
    let text = format!("{UNILATERAL}\n[solver]\ntime_limit = \"1 h\"\n");
    let folder = Folder::with(&text);
    assert_eq!(folder.run(&["solve", "punch.toml", "--format", "json"]).answer(), plain);
}

#[test]
fn what_is_no_time_is_refused() {
    let folder = Folder::with(UNILATERAL);
    for (text, says) in [
        ("0 s", "greater than 0"),
        ("-1 s", "greater than 0"),
        ("10 mm", "got mm, a length"),
        ("soon", "soon"),
        ("1e400 s", "1e400"),
    ] {
        let option = format!("--time-limit={text}");
        let run = folder.run(&["solve", "punch.toml", &option]);
        let said = run.refusal();
        assert!(said.contains("--time-limit") && said.contains(says), "{said}");
    }
    let folder = Folder::with(UNILATERAL);
    let run = folder.run(&["solve", "punch.toml", "--time-limit", "-1 s"]);
    let said = run.refusal();
    assert!(said.contains("greater than 0"), "{said}");
    let run = folder.run(&["solve", "punch.toml", "--time-limit", "1e20 h"]);
    assert_eq!(run.code, Some(0), "longer than any clock tells is no limit");
    for value in ["0", "\"-3 s\"", "\"3 m\"", "true", "nan"] {
        let folder = Folder::with(&format!("{UNILATERAL}\n[solver]\ntime_limit = {value}\n"));
        let run = folder.run(&["solve", "punch.toml"]);
        let said = run.refusal();
        assert!(said.contains("punch.toml:15") && said.contains("time_limit"), "{said}");
    }
}

/// Twenty thousand modes of this kernel take minutes.
#[test]
fn equations_end_in_time_and_cases_of_a_sweep_do_too() {
    let folder = Folder::new();
    folder.run(&["init", "--equation"]).answer();
    let power = repository().join("examples/equation_power.toml");
    let equation = ["equation", power.to_str().unwrap(), "--no-audit", "-o", "out.txt"];
    let slow =
        ["--set", "solver.method=spectral", "--set", "solver.n=20000", "--time-limit", "0.3 s"];
    let start = Instant::now();
    let run = folder.run(&[&equation[..], &slow].concat());
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
    let said = run.failure(3);
    assert!(said.contains("no solution was found within the time limit of 0.3 s"), "{said}");
    assert!(!folder.path("out.txt").exists());
    folder.run(&[&equation[..], &["--time-limit", "10 min"]].concat()).answer();
    let run = folder.run(&["equation", "equation.toml", "--time-limit", "3 m"]);
    assert!(run.refusal().contains("--time-limit `3 m`"), "{}", run.stderr);

    trace(&folder, 40_000);
    let study = std::fs::read_to_string(folder.path("punch.toml")).unwrap();
    let sweep = |limit: &str, output: &str| {
        folder.run(&["sweep", "study.toml", "--output", output, "--time-limit", limit])
    };
    let vary = "\n[study]\nvary.\"load.force\" = [\"0.8 MN/m\"]\naudited_sample = 0\n";
    folder.write("study.toml", study + vary);
    sweep("50 ms", "cut").answer();
    let part = std::fs::read_to_string(folder.path("cut/part-00000000.csv")).unwrap();
    assert!(part.contains("no answer was found within the time limit of 0.05 s"), "{part}");
    // An equation of a study has no limit of its own.
    let text = std::fs::read_to_string(folder.path("equation.toml")).unwrap();
    folder.write("study.toml", text + "\n[study]\nvary.\"equation.lambda\" = [1.0, 2.0]\n");
    let run = sweep("1 s", "equations");
    assert!(run.refusal().contains("--time-limit: "), "{}", run.stderr);
}
