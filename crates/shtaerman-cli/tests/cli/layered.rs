//! Layers of finite thickness and coatings: read, solved, refused at their field.

use crate::cli::support::{Folder, assert_valid, number, schema, toml_as_json};

const LAYER: &str = r#"[foundation]
young_modulus = "3 MPa"
poisson_ratio = 0.49
roughness = "2 um/MPa"
thickness = "8 mm"
base = "bonded"

[punch]
half_width = "20 mm"
profile = "0"

[load]
force = "10 kN/m"
moment = 0
"#;

const COATING: &str = r#"[foundation]
young_modulus = "3 MPa"
poisson_ratio = 0.49
roughness = "2 um/MPa"

[foundation.coating]
thickness = "4 mm"
young_modulus = "30 MPa"
poisson_ratio = 0.3

[punch]
half_width = "20 mm"
profile = "0"

[load]
force = "10 kN/m"
moment = 0
"#;

#[test]
fn solve_and_match_the_schemas() {
    let circular =
        LAYER.replace("half_width", "geometry = \"circular\"\nradius").replace("10 kN/m", "100 N");
    let tilted = circular.replace("moment = 0", "moment = 0.1");
    for (text, gauge) in [
        (LAYER, "the rigid base"),
        (&circular, "the rigid base"),
        (&tilted, "the rigid base"),
        (COATING, "uncoated foundation"),
    ] {
        assert_valid(&schema("problem"), &toml_as_json(text), text);
        let folder = Folder::with(text);
        let json = folder.run(&["solve", "punch.toml", "--format", "json"]).json();
        assert_valid(&schema("answer"), &json, text);
        assert!(json["physical"]["gauge"].as_str().unwrap().contains(gauge));
        assert!(number(&json, "/physical/settlement") > 0.0);
        let said = folder.run(&["solve", "punch.toml"]).answer();
        let audit = if text.contains("circular") {
            "audit (none): the residual on a layer"
        } else {
            "audit (estimate): the residual of the answer"
        };
        assert!(said.contains(audit), "{said}");
        let run = folder.run(&["stress", "punch.toml"]);
        assert!(run.refusal().contains("homogeneous half-space only"), "{run:?}");
    }
}

#[test]
fn dimensionless_layers_are_those_of_materials() {
    // theta0 = 2 a (1 - nu^2)/(pi E chi), f0 and P0 over chi E
    let theta0 = 2.0 * 0.02 * (1.0 - 0.49 * 0.49) / (std::f64::consts::PI * 3e6 * 2e-12);
    let bare = format!(
        "[dimensionless]\ntheta0 = {theta0:?}\nthickness = 0.4\nbase = \"bonded\"\npoisson_ratio = 0.49\nprofile = 0\nforce = {:?}\nmoment = 0\n",
        10e3 / (0.02 * 3e6)
    );
    assert_valid(&schema("problem"), &toml_as_json(&bare), &bare);
    let [one, two] = [LAYER, &bare].map(|text| {
        let json = Folder::with(text).run(&["solve", "punch.toml", "--format", "json"]).json();
        number(&json, "/dimensionless/settlement")
    });
    assert!((one / two - 1.0).abs() < 1e-11, "{one} {two}");
}

#[test]
fn refusals_name_the_field() {
    for (text, from, to, place, said) in [
        (LAYER, "base = \"bonded\"\n", "", ":5: foundation.thickness", "\"frictionless\" where"),
        (LAYER, "\"bonded\"", "\"glued\"", ":6: foundation.base", "frictionless"),
        (LAYER, "thickness = \"8 mm\"\n", "", ":5: foundation.base", "goes with thickness"),
        (LAYER, "8 mm", "8 um", ":5: foundation.thickness", "a bed of springs"),
        (LAYER, "8 mm", "-8 mm", ":5: foundation.thickness", "greater than zero"),
        (LAYER, "2 um/MPa", "0 m/Pa", ":4: foundation.roughness", "smooth contact is not solved"),
        (
            LAYER,
            "half_width",
            "geometry = \"periodic\"\nperiod = 1\nhalf_width",
            ":5: foundation.thickness",
            "periodic row",
        ),
        (
            LAYER,
            "[load]",
            "[body]\nyoung_modulus = 1\npoisson_ratio = 0\n\n[load]",
            "body",
            "does not go with a layer",
        ),
        (
            LAYER,
            "young_modulus = \"3 MPa\"",
            "grading_exponent = 0.3\ngrading_modulus = 1",
            "foundation.thickness",
            "does not go with grading",
        ),
        (
            COATING,
            "roughness",
            "thickness = 1\nbase = \"bonded\"\nroughness",
            "coating",
            "rigid base or",
        ),
        (COATING, "4 mm", "4 nm", ":7: foundation.coating.thickness", "leave a thinner one out"),
        (COATING, "30 MPa", "3 TPa", ":8: foundation.coating.young_modulus", "1e4 times"),
        (COATING, "4 mm", "400 mm", ":7: foundation.coating.thickness", "larger half_width"),
        (
            COATING,
            "half_width",
            "geometry = \"circular\"\nradius",
            ":7: foundation.coating.thickness",
            "circular punch",
        ),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text, "{from}");
        let run = Folder::with(&changed).run(&["solve", "punch.toml"]);
        let message = run.refusal();
        assert!(message.contains(place) && run.stderr.contains(said), "{to}: {}", run.stderr);
    }
}
