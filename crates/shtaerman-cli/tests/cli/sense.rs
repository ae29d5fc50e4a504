//! Sense checks: slips of the input are doubted, plain work is not.

use crate::support::{Folder, repository};

const STEEL: &str = r#"
[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.2e-14 m/Pa"
yield_stress = "350 MPa"

[punch]
half_width = "5 mm"
profile = "x^2 / 40"

[load]
force = "0.8 MN/m"
moment = 0
"#;

#[test]
fn no_example_is_doubted() {
    let mut count = 0;
    for entry in std::fs::read_dir(repository().join("examples")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if !name.ends_with(".toml") || name.starts_with("equation_") {
            continue;
        }
        count += 1;
        let folder = Folder::new();
        let run = folder.run(&["solve", path.to_str().unwrap(), "--strict", "--no-audit"]);
        assert_eq!(run.code, Some(0), "{name}: {}", run.stderr);
    }
    assert!(count >= 8, "{count} examples");
}

#[test]
fn slips_are_doubted_with_their_number_and_refused_when_asked() {
    let folder = Folder::new();
    folder.write("steel.toml", STEEL);
    assert_eq!(folder.run(&["solve", "steel.toml", "--strict"]).code, Some(0));
    for (slip, code, said) in [
        ("load.force=62 GN/m", "high_pressure", "is above a tenth of the modulus that resists it"),
        ("foundation.young_modulus=200", "soft_modulus", "is \"200 GPa\" meant?"),
        ("punch.half_width=5", "wide_base", "the half-width is 5 m: are millimetres meant?"),
        ("load.force=4 MN/m", "above_yield", "is above the yield stress, 350 MPa"),
        ("punch.profile=x^2/(2*0.0001)", "steep_base", "small slopes are assumed"),
    ] {
        let run =
            folder.run(&["solve", "steel.toml", "--set", slip, "--format", "json", "--no-audit"]);
        let stderr = run.stderr.clone();
        let json = run.json();
        let codes: Vec<&str> = json["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .map(|warning| warning["code"].as_str().unwrap())
            .collect();
        assert!(codes.contains(&code), "{slip}: {codes:?}");
        assert!(stderr.contains(said), "{slip}: {stderr}");
        let strict = folder.run(&[
            "solve",
            "steel.toml",
            "--set",
            slip,
            "--no-audit",
            "--strict",
            "-o",
            "out.txt",
        ]);
        assert_eq!(strict.code, Some(2), "{slip}");
        assert!(
            strict.stderr.starts_with("error: --strict: ") && strict.stderr.contains(said),
            "{}",
            strict.stderr
        );
        assert!(!folder.path("out.txt").exists());
    }
    // With its unit a soft modulus is meant.
    let gel = folder.run(&[
        "solve",
        "steel.toml",
        "--set",
        "foundation.young_modulus=50 kPa",
        "--set",
        "load.force=1 N/m",
    ]);
    assert!(!gel.stdout.contains("softer than rubber"), "{}", gel.stdout);
}

#[test]
fn a_yield_stress_without_its_unit_is_doubted() {
    let folder = Folder::new();
    folder.write("steel.toml", STEEL);
    let run =
        |yield_stress: &str| folder.run(&["stress", "steel.toml", "--yield-stress", yield_stress]);
    let doubted = run("350").answer();
    assert!(doubted.contains("is \"350 MPa\" meant?"), "{doubted}");
    let plain = run("350 MPa").answer();
    assert!(!plain.contains("meant?"), "{plain}");
}

#[test]
fn a_header_with_another_unit_is_refused() {
    let folder = Folder::new();
    folder.write("trace.csv", "x [mm],height [um]\n-6,1\n-2,0.2\n2,0.1\n6,1.2\n");
    let set = |units: &str| format!("punch.profile={{ csv = \"trace.csv\"{units} }}");
    folder.write("steel.toml", STEEL);
    let refused = folder.run(&["solve", "steel.toml", "--set", &set("")]);
    assert!(
        refused.refusal().contains("trace.csv: line 1: the header has the position in mm"),
        "{}",
        refused.stderr
    );
    let right = set(", x_unit = \"mm\", f_unit = \"um\"");
    folder.run(&["solve", "steel.toml", "--set", &right, "--no-audit"]).answer();
}
