//! `reproduce`, `regularity`, `convergence`, `validate`, and an interrupt.

use serde_json::Value;

use crate::cli::support::{
    DIMENSIONLESS, Folder, PHYSICAL, assert_valid, is_ignored, number, schema,
};

#[test]
fn reproduce_counts_143_of_144() {
    let folder = Folder::new();
    let table = folder.run(&["reproduce", "--plot", "fig2.svg"]).answer();
    assert!(table.contains("143 of 144"), "{table}");
    assert!(folder.read("fig2.svg").contains("<svg"));

    let json = folder.run(&["reproduce", "--format", "json"]).json();
    assert_valid(&schema("reproduction"), &json, "reproduce");
    let figures = json["figures"].as_array().unwrap();
    assert_eq!(figures.len(), 144);
    let agree = |figure: &&Value| figure["agrees"] == true;
    assert_eq!(figures.iter().filter(agree).count(), 143);
    assert_eq!((json["agreeing"].as_u64(), json["total"].as_u64()), (Some(143), Some(144)));
    // Agreement by the digits themselves: our figure rounded to the printed decimals is the printed one, give or take half a unit.
    for figure in figures {
        let printed = figure["printed"].as_str().unwrap();
        let decimals = printed.split_once('.').map_or(0, |(_, digits)| digits.len());
        let unit = 10f64.powi(-i32::try_from(decimals).unwrap());
        let error = (number(figure, "/as_the_paper") - printed.parse::<f64>().unwrap()).abs();
        assert_eq!(error <= unit, figure["agrees"] == true, "{figure}");
    }

    let csv = folder.run(&["reproduce", "--format", "csv"]).answer();
    assert_eq!(csv.lines().count(), 145);
}

#[test]
fn regularity_tells_the_verdict() {
    let folder = Folder::new();
    let schema = schema("regularity");
    for (theta0, kind) in [
        ("0", "completely_regular"),
        ("0.1", "completely_regular"),
        ("1", "quasi_completely_regular"),
        ("13", "quasi_completely_regular"),
        ("1e6", "quasi_completely_regular"),
    ] {
        let json = folder.run(&["regularity", "--theta0", theta0, "--format", "json"]).json();
        assert_valid(&schema, &json, theta0);
        assert_eq!(json["verdict"]["kind"], kind, "theta0 = {theta0}");
        assert_eq!(json["even"]["rows"].as_array().unwrap().len(), 10);
        // The row sum of degree 0 in closed form: theta0 (2 ln 2 + sum over even m of (2/m) 2/(m^2 - 1)).
        let tail: f64 =
            (1..200_000).map(|k| f64::from(2 * k)).map(|m| 4.0 / (m * (m * m - 1.0))).sum();
        let exact = theta0.parse::<f64>().unwrap() * (2.0 * 2f64.ln() + tail);
        let sum = number(&json, "/even/rows/0/sum");
        assert!((sum - exact).abs() <= 1e-9 * exact, "theta0 = {theta0}: {sum} for {exact}");
    }
    let table = folder.run(&["regularity", "--theta0", "13", "--rows", "3"]).answer();
    assert!(table.contains("quasi-completely regular"), "{table}");
    let csv =
        folder.run(&["regularity", "--theta0", "13", "--rows", "3", "--format", "csv"]).answer();
    assert_eq!(csv.lines().count(), 7);
}

#[test]
fn bad_parameters_of_regularity() {
    for (arguments, said) in [
        (["--theta0", "nan"].as_slice(), "theta0 must be a finite number"),
        (&["--theta0", "-1"], "is -1"),
        (&["--theta0", "inf"], "is inf"),
        (&["--theta0", "text"], "'text'"),
        (&["--theta0", "1e300"], "1e300"),
        (&[], "--theta0"),
        (&["--theta0", "1", "--q0", "2"], "q0"),
        (&["--theta0", "1", "--q0", "0"], "q0"),
        (&["--theta0", "1", "--q0", "nan"], "q0"),
        (&["--theta0", "1", "--rows", "10000000000"], "rows"),
        (&["--theta0", "1", "--rows", "-1"], "-1"),
    ] {
        let folder = Folder::new();
        let run = folder.run(&[&["regularity", "--output", "out.txt"], arguments].concat());
        run.refusal();
        assert!(run.stderr.contains(said) && run.stderr.len() < 500, "{}", run.stderr);
        assert_eq!(folder.files(), Vec::<String>::new());
    }
}

#[test]
fn convergence_observes_the_orders_of_the_theory() {
    let schema = schema("convergence");
    for (problem, first) in [
        (PHYSICAL.to_owned(), "settlement"),
        (PHYSICAL.replace("force = \"0.8 MN/m\"", "settlement = \"3 um\""), "force"),
        (DIMENSIONLESS.to_owned(), "settlement"),
    ] {
        let folder = Folder::with(&problem);
        let json = folder
            .run(&[
                "convergence",
                "punch.toml",
                "--max-n",
                "512",
                "--format",
                "json",
                "--plot",
                "c.svg",
            ])
            .json();
        assert_valid(&schema, &json, &problem);
        assert_eq!(json["quantities"][0], first);
        let rows = json["rows"].as_array().unwrap();
        let degrees: Vec<u64> = rows.iter().map(|row| row["n"].as_u64().unwrap()).collect();
        assert_eq!(degrees, [8, 16, 32, 64, 128, 256, 512]);
        // The iterated edge pressure falls as n^-4 ln n: its observed order stays below 4 for long.
        for (i, expected) in [4.0, 2.0, 3.0, 4.0].into_iter().enumerate() {
            assert_eq!(json["expected_orders"][i].as_f64(), Some(expected));
            let observed = number(&rows[5], &format!("/entries/{i}/order"));
            let slack = if i == 3 { 0.4 } else { 0.25 };
            assert!((observed - expected).abs() < slack, "{}: {observed}", json["quantities"][i]);
        }
        assert!(folder.read("c.svg").contains("<svg"));
        let table = folder.run(&["convergence", "punch.toml", "--max-n", "64"]).answer();
        assert!(table.contains("Orders of the theory"), "{table}");
        let csv =
            folder.run(&["convergence", "punch.toml", "--max-n", "64", "--format", "csv"]).answer();
        assert_eq!(csv.lines().next(), Some("n,quantity,value,difference,order"));
        assert_eq!(csv.lines().count(), 1 + 4 * 4);
    }
}

#[test]
fn bad_arguments_of_convergence() {
    let folder = Folder::with(PHYSICAL);
    for (max_n, said) in
        [("16", "--max-n 16: must be at least 32"), ("0", "--max-n 0"), ("-1", "-1")]
    {
        let run = folder.run(&["convergence", "punch.toml", "--max-n", max_n]);
        run.refusal();
        assert!(run.stderr.contains(said), "{}", run.stderr);
    }
    let run = folder.run(&["convergence", "nowhere.toml"]);
    assert!(run.refusal().contains("nowhere.toml"));
}

#[test]
fn validate_says_what_it_read() {
    for (problem, said) in [
        (PHYSICAL, "punch.toml: valid; physical problem, theta0 = 1.206925, n = 40\n"),
        (DIMENSIONLESS, "punch.toml: valid; dimensionless problem, theta0 = 13, n = 40\n"),
    ] {
        let folder = Folder::with(problem);
        assert_eq!(folder.run(&["validate", "punch.toml"]).answer(), said);
        assert_eq!(folder.run_with_input(&["validate", "-"], problem).code, Some(0));
        assert_eq!(folder.files(), ["punch.toml"]);
    }
}

/// The run waits for the end of its input when the signal comes: more than a pipe holds has been read from it by then.
#[cfg(unix)]
#[test]
fn an_interrupt_ends_with_130() {
    use std::io::Write;
    use std::process::Stdio;
    let folder = Folder::new();
    let mut child = folder
        .command(&["solve", "-", "--output", "out.txt"])
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    input.write_all("# a comment\n".repeat(200_000).as_bytes()).unwrap();
    let id = child.id().to_string();
    let signal = if is_ignored(2) { "-TERM" } else { "-INT" };
    let sent = std::process::Command::new("kill").args([signal, &id]).status().unwrap();
    assert!(sent.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    drop(input);
    assert_eq!(folder.files(), Vec::<String>::new());
}

#[test]
fn comments_of_a_file_that_init_writes_have_its_name() {
    let folder = Folder::new();
    for more in [&[][..], &["--geometry", "circular"], &["--equation"], &["--dimensionless"]] {
        folder.run(&[&["init", "plate.toml", "--force"], more].concat()).answer();
        let text = folder.read("plate.toml");
        assert!(text.contains("plate.toml"), "{more:?}: {text}");
        let usual = ["punch.toml", "equation.toml", "punch.svg", "equation.svg"];
        assert!(usual.iter().all(|name| !text.contains(name)), "{more:?}: {text}");
    }
}
