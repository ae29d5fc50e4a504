//! What `solve` says of lifted, smooth and other contacts.

use std::f64::consts::PI;

use crate::cli::support::{Folder, UNILATERAL, assert_valid, schema};

fn near(value: &serde_json::Value, exact: f64, tolerance: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - exact).abs() <= tolerance * exact.abs(), "{value} instead of {exact}");
}

#[test]
fn a_smooth_flat_punch_has_singular_edges() {
    let text = UNILATERAL.replace("x^2 / (2*20)", "0").replace("\"1.2e-14 m/Pa\"", "0");
    let folder = Folder::with(&text);
    let run = folder.run(&["solve", "punch.toml", "--format", "json", "--at", "-5 mm,0"]);
    let json = run.json();
    assert!(json["dimensionless"].is_null());
    assert!(
        json["physical"]["pressure_left"].is_null() && json["pressure"]["pressure"][0].is_null()
    );
    assert_eq!(json["warnings"][0]["code"], "singular_edge");
    // P = 0.8 MN/m, M = 100 N, a = 5 mm: K = (P -+ 2 M/a)/sqrt(pi a), p(0) = P/(pi a)
    let intensity = &json["physical"]["corner_intensity"][0];
    let root = (PI * 5e-3).sqrt();
    near(&intensity[0], (0.8e6 - 0.04e6) / root, 1e-12);
    near(&intensity[1], (0.8e6 + 0.04e6) / root, 1e-12);
    near(&json["pressure"]["pressure"][1], 0.8e6 / (PI * 5e-3), 1e-12);
    let table = folder.run(&["solve", "punch.toml"]).answer();
    assert!(table.contains("infinite") && table.contains("MPa sqrt(m)"), "{table}");
}

#[test]
fn the_pressure_under_a_kink_of_a_smooth_punch_is_infinite() {
    let text =
        UNILATERAL.replace("\"1.2e-14 m/Pa\"", "0").replace("moment = \"100 N\"", "moment = 0");
    let wedge = Folder::with(&text.replace("x^2 / (2*20)", "1e-3*abs(x)"));
    let json = wedge.run(&["solve", "punch.toml", "--format", "json", "--at", "0,1 um"]).json();
    assert!(
        json["physical"]["pressure_middle"].is_null()
            && json["physical"]["peak_pressure"].is_null()
    );
    assert!(json["physical"]["peak_pressure_at"].as_f64().unwrap().abs() < 1e-15);
    assert!(json["pressure"]["pressure"][0].is_null());
    assert_eq!(json["warnings"][0]["code"], "singular_kink");
    // p = (E* t/pi) arccosh(c/|x|), P = c E* t
    let modulus = 200e9 / (1.0 - 0.09);
    let c = 0.8e6 / (modulus * 1e-3);
    near(&json["pressure"]["pressure"][1], modulus * 1e-3 / PI * (c / 1e-6).acosh(), 1e-9);
    let table = wedge.run(&["solve", "punch.toml"]).answer();
    assert!(table.contains("infinite"), "{table}");
    // A breakpoint without a jump of the slope is no kink, and a layer takes the infinity.
    let round = Folder::with(&text.replace("x^2 / (2*20)", "0.01*abs(x)^1.5"));
    let rough = wedge.run(&[
        "solve",
        "punch.toml",
        "--set",
        "foundation.roughness=1e-13",
        "--format",
        "json",
    ]);
    for json in [round.run(&["solve", "punch.toml", "--format", "json"]).json(), rough.json()] {
        assert!(json["physical"]["pressure_middle"].as_f64().unwrap() > 0.0, "{json}");
        let warnings = json["warnings"].as_array().unwrap();
        assert!(warnings.iter().all(|warning| warning["code"] != "singular_kink"));
    }
    // Where only the curvature jumps the largest pressure keeps its derivatives, and under the smallest force a kink stays one.
    let json = round
        .run(&[
            "solve",
            "punch.toml",
            "--format",
            "json",
            "--set",
            "punch.profile='x^2/2 + abs(x)^3'",
        ])
        .json();
    assert!(json["physical"]["sensitivities"]["peak_pressure"].is_object(), "{json}");
    let json =
        wedge.run(&["solve", "punch.toml", "--format", "json", "--set", "load.force=1e-3"]).json();
    assert_eq!(json["warnings"][0]["code"], "singular_kink");
    // Hollow under a bilateral contact: minus infinity beside the truth that it pulls there.
    let hollow = text.replace("x^2 / (2*20)", "-1e-3*abs(x)");
    let hollow = Folder::with(&format!("{hollow}[solver]\ncontact = \"bilateral\"\n"));
    let json = hollow.run(&["solve", "punch.toml", "--format", "json"]).json();
    let codes: Vec<&str> = (json["warnings"].as_array().unwrap().iter())
        .filter_map(|warning| warning["code"].as_str())
        .collect();
    assert!(codes.contains(&"singular_kink") && codes.contains(&"negative_pressure"), "{codes:?}");
}

#[test]
fn hertz_by_the_command() {
    // Cylinder of 0.1 m: a_H^2 = 4 P R/(pi E*), p0 = 2 P/(pi a_H).
    let text = UNILATERAL
        .replace("x^2 / (2*20)", "x^2 / (2*0.1)")
        .replace("\"1.2e-14 m/Pa\"", "0")
        .replace("moment = \"100 N\"", "moment = 0");
    let folder = Folder::with(&text);
    let json = folder.run(&["solve", "punch.toml", "--format", "json"]).json();
    let modulus = 200e9 / (1.0 - 0.09);
    let half = (4.0 * 0.8e6 * 0.1 / (PI * modulus)).sqrt();
    near(&json["physical"]["zones"][0][1], half, 1e-12);
    near(&json["physical"]["peak_pressure"], 2.0 * 0.8e6 / (PI * half), 1e-11);
    near(&json["physical"]["pressure_left"], 0.0, 0.0);
    assert!(json["warnings"].as_array().unwrap().is_empty());
    assert!(json["complementarity"]["penetration"].as_f64().unwrap() < 1e-9);
}

#[test]
fn a_lifted_punch_reports_its_zone() {
    // Layer alone in effect: chi E*/a = 1e3, force at 0.6 a beyond the middle third: width 3 (a - e), within 1 %.
    let text = UNILATERAL
        .replace("x^2 / (2*20)", "0")
        .replace("\"1.2e-14 m/Pa\"", "\"2.275e-11 m/Pa\"")
        .replace("moment = \"100 N\"", "eccentricity = \"3 mm\"");
    let folder = Folder::with(&text);
    let json = folder.run(&["solve", "punch.toml", "--format", "json"]).json();
    near(&json["physical"]["contact_width"], 3.0 * 2e-3, 1e-2);
    near(&json["physical"]["pressure_left"], 0.0, 0.0);
    let table = folder.run(&["solve", "punch.toml"]).answer();
    assert!(table.contains("lifted on the left") && table.contains("unilateral"), "{table}");
}

#[test]
fn cross_checks_say_how_far_the_reference_reaches() {
    let folder = Folder::with(
        "[dimensionless]\ntheta0 = 2\nprofile = \"xi^2\"\nforce = 0.2\nmoment = 0.02\n",
    );
    let json = folder.run(&["solve", "punch.toml", "--cross-check", "--format", "json"]).json();
    assert_valid(&schema("answer"), &json, "cross-check");
    let check = &json["cross_check"];
    assert_eq!((&check["method"], &check["agrees"]), (&"product_integration".into(), &true.into()));
    let table = folder.run(&["solve", "punch.toml", "--cross-check"]).answer();
    assert!(table.contains("cross-check by product integration") && table.contains("agrees"));
    // Too many waves for the reference: no answer to compare with is no agreement.
    let folder = Folder::with(
        "[dimensionless]\ntheta0 = 2\nprofile = \"0.001*cos(900*xi)\"\nforce = 1\nmoment = 0\n[solver]\ncontact = \"bilateral\"\n",
    );
    let run = folder.run(&["solve", "punch.toml", "--cross-check"]);
    assert_eq!(run.code, Some(3));
    assert!(run.stderr.contains("nothing to compare with"), "{}", run.stderr);
    assert!(run.stdout.contains("pressure, largest"), "the answer itself: {}", run.stdout);
}
