//! Foundations whose modulus grows with depth: read, solved, refused at their field.

use crate::support::{Folder, assert_valid, number, schema, toml_as_json};

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
        ("\"1 um/kPa\"", "0", ":5: foundation.roughness", "not solved yet"),
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
