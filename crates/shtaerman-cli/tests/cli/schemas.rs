//! Every kind of answer is what the schema says, and what is said of it is in its units.

use crate::cli::support::{Folder, assert_valid, schema};

/// A file of a geometry, a surface and a base.
fn file(geometry: &str, surface: &str, profile: &str, force: &str, contact: &str) -> String {
    let size = match geometry {
        _ if geometry.contains("circular") => "radius",
        _ if geometry.contains("pair") => "outer_half_width",
        _ => "half_width",
    };
    format!(
        "[foundation]\n{surface}\n[punch]\n{size} = \"5 mm\"\n{geometry}\nprofile = \"{profile}\"\n\
         [load]\nforce = \"{force}\"\nmoment = 0\n[solver]\ncontact = \"{contact}\"\n"
    )
}

const BODY: &str = "young_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n";
const GRADED: &str = "grading_exponent = 0.3\ngrading_modulus = 3e12\npoisson_ratio = 0.3\n";

/// Answers of every kind under one geometry.
#[track_caller]
fn answers_match_the_schema(geometry: &str) {
    let schema = schema("answer");
    let mut answers = 0;
    let force = if geometry.contains("circular") { "8 kN" } else { "8 MN/m" };
    for surface in [
        format!("{BODY}roughness = 0"),
        format!("{BODY}roughness = 1.2e-14"),
        format!("{BODY}roughness = {{ coefficient = 1e-10, exponent = 0.5 }}"),
        format!("{GRADED}roughness = 0"),
        format!("{GRADED}roughness = 1.2e-14"),
    ] {
        // Waves of a micrometre touch as a whole, those of a millimetre in parts; the flat base has corners, the tent a kink.
        for profile in ["0", "1e-6*cos(pi*x/0.005)", "1e-3*cos(pi*x/0.005)", "abs(x)/100"] {
            for contact in ["unilateral", "bilateral"] {
                let text = file(geometry, &surface, profile, force, contact);
                let run = Folder::with(&text).run(&["solve", "punch.toml", "--format", "json"]);
                if run.code == Some(0) {
                    answers += 1;
                    assert_valid(&schema, &run.json(), &text);
                } else {
                    assert!(matches!(run.code, Some(2 | 3)), "{text}: {}", run.stderr);
                }
            }
        }
    }
    assert!(answers > 15, "{answers}");
}

#[test]
fn answers_of_one_punch_match_the_schema() {
    answers_match_the_schema("");
}

#[test]
fn answers_of_a_pair_match_the_schema() {
    answers_match_the_schema("geometry = \"pair\"\ninner_half_gap = \"2 mm\"");
}

#[test]
fn answers_of_a_row_match_the_schema() {
    answers_match_the_schema("geometry = \"periodic\"\nperiod = \"30 mm\"");
}

#[test]
fn answers_of_a_wave_match_the_schema() {
    answers_match_the_schema("geometry = \"periodic\"\nperiod = \"10 mm\"");
}

#[test]
fn answers_of_a_circular_punch_match_the_schema() {
    answers_match_the_schema("geometry = \"circular\"");
}

#[test]
fn a_smooth_wave_in_full_contact_does_not_yield() {
    let wave = "geometry = \"periodic\"\nperiod = \"10 mm\"";
    let surface = format!("{BODY}roughness = 0");
    let text = file(wave, &surface, "1e-6*cos(pi*x/0.005)", "20 MN/m", "unilateral");
    let folder = Folder::with(&text);
    let json = folder.run(&["solve", "punch.toml", "--format", "json"]).json();
    assert_valid(&schema("answer"), &json, "wave");
    assert!(json["physical"]["stiffness"][0][0].is_null());
    assert_eq!(json["method"]["n"], 0);
    // The mean height is zero, and the settlement is that: nothing is amiss.
    assert_eq!(json["warnings"].as_array().map(Vec::len), Some(0), "{json}");
    let settlement = json["physical"]["settlement"].as_f64().unwrap();
    let stated = json["error"]["physical"]["settlement"].as_f64().unwrap();
    assert!(settlement.abs() <= stated && stated < 1e-19, "{settlement} {stated}");
}

#[test]
fn forces_of_circular_punches_are_no_moments() {
    let surface = format!("{BODY}roughness = 1.2e-14");
    let text = file("geometry = \"circular\"", &surface, "x^2/2", "200 N", "unilateral");
    let folder = Folder::with(&text);
    let arguments = ["find", "force", "punch.toml", "--contact-width", "1 mm"];
    let table = folder.run(&arguments).answer();
    let force = table.lines().find(|line| line.trim_start().starts_with("force")).unwrap();
    assert!(force.contains(" N") && !force.contains("m/m"), "{force}");
    let moment = table.lines().find(|line| line.trim_start().starts_with("moment")).unwrap();
    assert!(moment.contains("N m") && !moment.contains("m/m"), "{moment}");
}

#[test]
fn smooth_surfaces_have_no_theta0() {
    for (roughness, said) in [("0", "smooth surface"), ("1.2e-14", "theta0 = ")] {
        let surface = format!("{BODY}roughness = {roughness}");
        let folder = Folder::with(&file("", &surface, "x^2/2", "1 MN/m", "unilateral"));
        let valid = folder.run(&["validate", "punch.toml"]).answer();
        assert!(valid.contains(said), "{valid}");
        assert_eq!(valid.contains("theta0"), roughness != "0", "{valid}");
    }
}

#[test]
fn convergence_is_that_of_the_file_or_refused() {
    let rough = format!("{BODY}roughness = 1.2e-14");
    let smooth = format!("{BODY}roughness = 0");
    let power = format!("{BODY}roughness = {{ coefficient = 1e-10, exponent = 0.5 }}");
    let pair = "geometry = \"pair\"\ninner_half_gap = \"2 mm\"";
    for (geometry, surface, profile, contact, said) in [
        ("geometry = \"circular\"", &rough, "x^2/2", "unilateral", "geometry"),
        (pair, &rough, "0", "unilateral", "geometry"),
        ("", &smooth, "x^2/2", "unilateral", "smooth"),
        ("", &smooth, "x^2/2", "bilateral", "smooth"),
        ("", &power, "0", "unilateral", "power law"),
        ("", &format!("{GRADED}roughness = 1.2e-14"), "0", "unilateral", "graded"),
        ("", &rough, "x^2/2", "unilateral", "lifts off"),
    ] {
        let force = if geometry.contains("circular") { "2 kN" } else { "1 MN/m" };
        let folder = Folder::with(&file(geometry, surface, profile, force, contact));
        let run = folder.run(&["convergence", "punch.toml", "--max-n", "32"]);
        run.refusal();
        assert_eq!(run.code, Some(2), "{}", run.stderr);
        let text = run.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(said), "{text}");
    }
    // What touches as a whole anyway is what the degenerate kernel solves.
    for (profile, contact) in [("0", "unilateral"), ("x^2/2", "bilateral")] {
        let folder = Folder::with(&file("", &rough, profile, "1 MN/m", contact));
        folder.run(&["convergence", "punch.toml", "--max-n", "32"]).answer();
    }
}
