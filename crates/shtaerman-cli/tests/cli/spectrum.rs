//! `spectrum`: eigenvalues and norms, and their verification.

use std::f64::consts::PI;

use serde_json::Value;

use crate::cli::support::{Folder, assert_valid, schema};

/// Every kernel with parameters.
const KERNELS: [&[&str]; 10] = [
    &["log", "--a", "0.7"],
    &["log-ratio", "--a", "2", "--b", "0.5"],
    &["log-ratio-limit", "--a", "2"],
    &["log-square", "--a", "1", "--b", "0.2"],
    &["log-sine", "--alpha", "150 deg"],
    &["power", "--a", "1", "--mu", "0.3"],
    &["macdonald", "--a", "1", "--mu", "0.2", "--kappa", "3"],
    &["macdonald", "--interval", "half-line", "--mu", "-0.3", "--kappa", "2"],
    &["weber-sonine", "--a", "1", "--mu", "0.5", "--gamma", "0.2"],
    &["yukawa", "--a", "1", "--chi0", "5", "--m", "2"],
];

#[track_caller]
fn spectrum(kernel: &[&str], more: &[&str]) -> Value {
    let folder = Folder::new();
    let json = folder.run(&[&["spectrum"], kernel, &["--format", "json"], more].concat()).json();
    assert_valid(&schema("spectrum"), &json, kernel[0]);
    json
}

fn floats(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

#[test]
fn every_kernel_is_verified() {
    for kernel in KERNELS {
        let json = spectrum(kernel, &["--verify", "--count", "12"]);
        assert_eq!(json["verify"]["passes"], true);
        // Double precision does better than the limits of the command for these parameters.
        for (check, limit) in
            [("relation", 1e-12), ("orthogonality", 1e-12), ("norms", 1e-12), ("gram", 1e-12)]
        {
            let error = json["verify"][check].as_f64().unwrap();
            assert!(error < limit, "{kernel:?}: {check} {error:.1e}");
        }
        let (eigenvalues, norms) = (floats(&json["eigenvalue"]), floats(&json["norm"]));
        assert_eq!((eigenvalues.len(), norms.len()), (12, 12));
        for (n, factor) in floats(&json["expansion_factor"]).iter().enumerate() {
            let quotient = eigenvalues[n] / norms[n];
            assert!((factor - quotient).abs() <= 1e-14 * quotient.abs(), "{kernel:?}, {n}");
        }
    }
}

/// Many eigenfunctions, and parameters near the ends of their ranges.
#[test]
fn hard_parameters_are_verified() {
    for kernel in [
        ["weber-sonine", "--a", "1", "--mu", "20", "--gamma", "-0.4", "--count", "60"].as_slice(),
        &["macdonald", "--a", "1", "--mu", "0.49", "--kappa", "50", "--count", "40"],
        &["macdonald", "--interval", "half-line", "--mu", "0.45", "--kappa", "3", "--count", "300"],
        &["log-ratio", "--a", "1", "--b", "1e-6", "--count", "50"],
        &["log-sine", "--alpha", "3.1", "--count", "100"],
        &["power", "--a", "3", "--mu", "0.95", "--count", "200"],
    ] {
        assert_eq!(spectrum(kernel, &["--verify"])["verify"]["passes"], true, "{kernel:?}");
    }
}

/// Closed forms of the first eigenvalues, and for kernels without them values by mpmath (22 digits and more).
#[test]
fn eigenvalues_are_those_of_the_theory() {
    let root = (0.5 * PI).sqrt();
    for (kernel, expected) in [
        (["log", "--a", "0.5"].as_slice(), [PI * 4f64.ln(), PI, PI / 2.0]),
        (&["log-ratio-limit", "--a", "3"], [PI, PI / 3.0, PI / 5.0]),
        (&["log-square", "--a", "1", "--b", "0"], [PI * 4f64.ln(), PI, PI / 2.0]),
        (&["log-sine", "--alpha", "90 deg"], [0.5 * PI * 2f64.ln(), PI, PI / 2.0]),
        // pi/cos(pi mu/2) Gamma(n + mu)/(Gamma(mu) n!)
        (
            &["power", "--a", "7", "--mu", "0.5"],
            [PI * 2f64.sqrt(), 0.5 * PI * 2f64.sqrt(), 0.375 * PI * 2f64.sqrt()],
        ),
        // sqrt(pi/(2 kappa)) Gamma(1/2) Gamma(n + 1/2)/n!
        (
            &["macdonald", "--interval", "half-line", "--mu", "0", "--kappa", "1"],
            [root * PI, 0.5 * root * PI, 0.375 * root * PI],
        ),
        (
            &["weber-sonine", "--a", "2", "--mu", "0", "--gamma", "0"],
            [PI / 2.0, PI / 8.0, 9.0 * PI / 128.0],
        ),
    ] {
        let found = floats(&spectrum(kernel, &["--count", "3"])["eigenvalue"]);
        for (value, exact) in found.iter().zip(expected) {
            assert!(
                (value - exact).abs() <= 1e-14 * expected[0].abs().max(expected[1]),
                "{kernel:?}: {value} for {exact}"
            );
        }
    }
}

#[test]
fn outputs() {
    let folder = Folder::new();
    let arguments = ["spectrum", "log", "--a", "1", "--verify", "--count", "4", "--plot", "s.svg"];
    let table = folder.run(&arguments).answer();
    for said in ["log kernel, a = 1", "1/sqrt(a^2 - x^2)", "bilinear sum", "ok", "expansion factor"]
    {
        assert!(table.contains(said), "{table}");
    }
    assert!(!table.contains("FAILS"));
    let svg = folder.read("s.svg");
    for n in 0..4 {
        assert!(svg.contains(&format!("n = {n}")), "the legend names n = {n}");
    }
    let csv =
        folder.run(&["spectrum", "log", "--a", "1", "--count", "3", "--format", "csv"]).answer();
    assert_eq!(csv.lines().next(), Some("index,eigenvalue,norm,expansion_factor"));
    assert_eq!(csv.lines().count(), 4);
    let output = ["spectrum", "log", "--a", "1", "--format", "json", "-o", "s.json"];
    assert_eq!(folder.run(&output).answer(), "");
    let first = folder.read("s.json");
    folder.run(&output).answer();
    assert_eq!(folder.read("s.json"), first);
    for kernel in KERNELS {
        folder
            .run(&[&["spectrum"], kernel, &["--plot", "k.svg", "--count", "2"]].concat())
            .answer();
        assert!(folder.read("k.svg").contains("n = 1"), "{kernel:?}");
    }
    folder.run(&["spectrum", "log", "--a", "1", "--plot", "k.png", "--count", "2"]).answer();
    assert!(std::fs::read(folder.path("k.png")).unwrap().starts_with(b"\x89PNG"));
}

#[test]
fn bad_arguments() {
    for (arguments, said) in [
        (["pwoer", "--a", "1", "--mu", "0.3"].as_slice(), "did you mean power?"),
        (&["nothing"], "Kernels: log, log-ratio"),
        (&["4"], "is no kernel"),
        (&["power", "--a", "1"], "--mu is missing: kernel power takes --a"),
        (&["log", "--a", "1", "--mu", "0.3"], "--mu does not belong here: kernel log takes --a"),
        (&["log", "--a", "-1"], "--a -1: must be finite and positive"),
        (&["log", "--a", "nan"], "--a nan"),
        (&["log", "--a", "inf"], "--a inf"),
        (&["log", "--a", "1e400"], "--a 1e400"),
        (&["log", "--a", "5 mm"], "--a 5 mm"),
        (&["log", "--a", "one"], "--a one"),
        (&["log-ratio", "--a", "1", "--b", "0"], "log-ratio-limit"),
        (&["power", "--a", "1", "--mu", "1"], "--mu 1: must be"),
        (&["yukawa", "--a", "1", "--chi0", "1", "--m", "0.5"], "--m 0.5: is a whole number"),
        (&["macdonald", "--interval", "whole", "--mu", "0", "--kappa", "1"], "\"half-line\""),
        (&["log", "--interval", "half-line", "--a", "1"], "macdonald has"),
        (
            &["macdonald", "--interval", "half-line", "--a", "1", "--mu", "0", "--kappa", "1"],
            "--a does not belong",
        ),
        (&["log", "--a", "1", "--count", "0"], "--count 0: must be from 1"),
        (&["log", "--a", "1", "--count", "10001"], "--count 10001"),
        (
            &["log", "--a", "1", "--count", "2001", "--verify"],
            "--count 2001: must be from 1 to 2000",
        ),
        (&["yukawa", "--a", "1", "--chi0", "1", "--m", "0", "--count", "2001"], "from 1 to 2000"),
        (&["log", "--a", "1", "--count", "99999999999999999999"], "--count"),
        (&["log", "--a", "1", "--plot", "s.bmp"], "use .svg"),
        (&["log", "--a", "1", "--output", "nowhere/s.json"], "there is no folder"),
        (&[], "KERNEL"),
    ] {
        let folder = Folder::new();
        let run = folder.run(&[&["spectrum"], arguments].concat());
        run.refusal();
        assert!(
            run.stderr.contains(said) && run.stderr.len() < 900,
            "{arguments:?}: {}",
            run.stderr
        );
        assert_eq!(folder.files(), Vec::<String>::new());
    }
}
