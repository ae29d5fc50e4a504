//! Foundations whose modulus grows with depth: read, solved, refused at their field.

use std::f64::consts::PI;

use crate::cli::support::{Folder, assert_valid, number, schema, toml_as_json};

const GRADED: &str = r#"[foundation]
grading_exponent = 0.3
grading_modulus = "60 MPa"
poisson_ratio = 0.3
roughness = "1 um/kPa"

[punch]
half_width = "0.4 m"
profile = "x^2/(2*50)"

[load]
force = "20 kN/m"
moment = 0
"#;

#[test]
fn solves_and_matches_the_schemas() {
    let circular =
        GRADED.replace("half_width", "geometry = \"circular\"\nradius").replace("20 kN/m", "20 kN");
    for text in [GRADED, &circular] {
        assert_valid(&schema("problem"), &toml_as_json(text), text);
        let folder = Folder::with(text);
        let json = folder.run(&["solve", "punch.toml", "--format", "json"]).json();
        assert_valid(&schema("answer"), &json, text);
        assert_eq!(json["physical"]["gauge"], "zero at infinity");
        assert!(number(&json, "/physical/settlement") > 0.0);
        // E(a)/(1 - nu^2)
        let modulus = 60e6 * 0.4f64.powf(0.3) / 0.91;
        assert!((number(&json, "/physical/contact_modulus") / modulus - 1.0).abs() < 1e-14);
    }
}

#[test]
fn smooth_surfaces_are_solved() {
    let smooth = GRADED.replace("\"1 um/kPa\"", "0").replace("x^2/(2*50)", "0");
    let circular =
        smooth.replace("half_width", "geometry = \"circular\"\nradius").replace("20 kN/m", "20 kN");
    // beta = (1 - mu)/2; flat, p = c (a^2 - x^2)^-beta, its factor by the force and int (1 - t^2)^-beta dt = sqrt(pi) Gamma(0.65)/Gamma(1.15)
    let (beta, a) = (0.35f64, 0.4f64);
    let strip = 20e3 / (a.powf(0.3) * 2.630_629_942_877_865);
    let disk = 20e3 * 1.3 / (2.0 * PI * a.powf(1.3));
    for (text, factor) in [(smooth, strip), (circular, disk)] {
        let folder = Folder::with(&text);
        let json = folder.run(&["solve", "punch.toml", "--format", "json", "--at", "0,0.2"]).json();
        assert_valid(&schema("answer"), &json, &text);
        assert!(json["dimensionless"].is_null() && json["physical"]["pressure_left"].is_null());
        assert_eq!(json["warnings"][0]["code"], "singular_edge");
        let said = json["warnings"][0]["message"].as_str().unwrap();
        assert!(said.contains("d^0.35") && !said.contains("sqrt(E* chi)"), "{said}");
        let near = |path: &str, exact: f64| {
            assert!((number(&json, path) / exact - 1.0).abs() < 1e-12, "{path}");
        };
        near("/physical/corner_exponent", beta);
        near("/physical/corner_intensity/0/1", factor * (2.0 * PI).sqrt() * (2.0 * a).powf(-beta));
        near("/pressure/pressure/0", factor * (a * a).powf(-beta));
        near("/pressure/pressure/1", factor * (a * a - 0.04).powf(-beta));
        let table = folder.run(&["solve", "punch.toml"]).answer();
        assert!(table.contains("Pa m^0.35"), "{table}");
        // There is no stress field of graded ground.
        let run = folder.run(&["stress", "punch.toml"]);
        assert!(run.refusal().contains("homogeneous half-space only"), "{run:?}");
    }
    let wavy = GRADED.replace("\"1 um/kPa\"", "0").replace("x^2/(2*50)", "cos(20*x)");
    let json = Folder::with(&wavy).run(&["solve", "punch.toml", "--format", "json"]).json();
    assert_eq!(json["physical"]["zones"].as_array().unwrap().len(), 2);
    // The crests of two waves, mirror images of one another.
    let edge = |path: &str| number(&json, &format!("/physical/zones/{path}"));
    assert!((edge("0/0") + edge("1/1")).abs() < 1e-12 && (edge("0/1") + edge("1/0")).abs() < 1e-12);
    assert!(edge("1/0") < PI / 20.0 && PI / 20.0 < edge("1/1"));
}

#[test]
fn exponent_zero_is_homogeneous() {
    let zero = Folder::with(&GRADED.replace("= 0.3\ngrading", "= 0\ngrading"));
    let plain =
        GRADED.replace("grading_exponent = 0.3\n", "").replace("grading_modulus", "young_modulus");
    let run = |folder: &Folder| folder.run(&["solve", "punch.toml", "--format", "json"]).answer();
    assert_eq!(run(&zero), run(&Folder::with(&plain)));
    // Overrides change one kind into the other.
    let graded = Folder::with(&plain).run(&[
        "solve",
        "punch.toml",
        "--format",
        "json",
        "--set",
        "foundation.grading_exponent=0.3",
        "--set",
        "foundation.grading_modulus=\"60 MPa\"",
    ]);
    assert_eq!(graded.answer(), run(&Folder::with(GRADED)));
}

#[test]
fn refusals_name_the_field() {
    for (from, to, place, said) in [
        (
            "= 0.3\ngrading",
            "= -0.2\ngrading",
            ":2: foundation.grading_exponent",
            "no finite settlement",
        ),
        (
            "= 0.3\ngrading",
            "= 1\ngrading",
            ":2: foundation.grading_exponent",
            "no finite settlement",
        ),
        ("\"60 MPa\"", "\"-60 MPa\"", ":3: foundation.grading_modulus", "is -60 MPa"),
        ("\"60 MPa\"", "\"60 m\"", ":3: foundation.grading_modulus", "pressure"),
        ("grading_modulus = \"60 MPa\"\n", "", ":1: foundation.grading_modulus", "missing"),
        ("grading_exponent = 0.3\n", "", ":1: foundation.grading_exponent", "missing"),
        (
            "poisson_ratio = 0.3",
            "poisson_ratio = 0.6",
            ":4: foundation.poisson_ratio",
            "at most 0.5",
        ),
        (
            "poisson_ratio",
            "young_modulus = 1\npoisson_ratio",
            ":4: foundation.young_modulus",
            "does not go with grading",
        ),
        (
            "[load]",
            "[body]\nyoung_modulus = 1\npoisson_ratio = 0\n\n[load]",
            "body",
            "does not go with grading",
        ),
        (
            "half_width",
            "geometry = \"periodic\"\nperiod = 1\nhalf_width",
            ":2: foundation.grading_exponent",
            "periodic row",
        ),
    ] {
        let text = GRADED.replacen(from, to, 1);
        assert_ne!(text, GRADED, "{from}");
        let run = Folder::with(&text).run(&["solve", "punch.toml"]);
        let message = run.refusal();
        assert!(message.contains(place) && run.stderr.contains(said), "{to}: {}", run.stderr);
    }
}
