//! Settlements relative to a datum, sensitivities and the surface in the answer of `solve`.

use serde_json::Value;

use crate::cli::support::{
    DIMENSIONLESS, Folder, PHYSICAL, UNILATERAL, assert_valid, number, schema,
};

fn solve(folder: &Folder, options: &[&str]) -> Value {
    let json = folder.run(&[&["solve", "punch.toml", "--format", "json"], options].concat()).json();
    assert_valid(&schema("answer"), &json, &options.join(" "));
    json
}

#[test]
fn settlements_relative_to_a_datum() {
    let folder = Folder::with(UNILATERAL);
    let options = ["--datum-distance", "1 m", "--datum-depth", "0.5 m"];
    let json = solve(&folder, &options);
    let relative = json["physical"]["relative_settlement"].as_array().unwrap();
    assert_eq!(
        (&relative[0]["datum"], &relative[1]["datum"]),
        (&"distance".into(), &"depth".into())
    );
    assert_eq!((relative[0]["at"].as_f64(), relative[1]["at"].as_f64()), (Some(1.0), Some(0.5)));
    // Far away a line load, with its moment.
    let theta = 2.0 / (std::f64::consts::PI * 200e9 / 0.91);
    let line = theta * (0.8e6 * 5e-3f64.ln() + 100.0);
    assert!(
        (number(&json, "/physical/relative_settlement/0/displacement") / line - 1.0).abs() < 1e-5
    );
    let settlement = number(&json, "/physical/settlement");
    for relative in relative {
        let sum = number(relative, "/settlement") + number(relative, "/displacement");
        assert!((sum / settlement - 1.0).abs() < 1e-12);
    }
    let table = folder.run(&[&["solve", "punch.toml"], options.as_slice()].concat()).answer();
    assert!(
        table.contains("the surface at 1 m") && table.contains("the depth of 500 mm"),
        "{table}"
    );
    let bare = solve(&Folder::with(DIMENSIONLESS), &["--datum-distance", "-40"]);
    assert!(number(&bare, "/dimensionless/relative_settlement/0/settlement").is_finite());
    let plain = solve(&folder, &[]);
    assert!(plain["physical"].get("relative_settlement").is_none());
}

#[test]
fn sensitivities_are_given_on_request() {
    for problem in [UNILATERAL, PHYSICAL] {
        let folder = Folder::with(problem);
        let json = solve(&folder, &["--sensitivities"]);
        let at = |pointer: &str| number(&json, &format!("/physical/sensitivities{pointer}"));
        assert_eq!(json["physical"]["sensitivities"]["held"], "moment");
        // chi, E and P act on the settlement by the scaling of the equations: the moment is held, so its share is that of the tilt, d delta/dM.
        let stiffness = |i: usize, j: usize| number(&json, &format!("/physical/stiffness/{i}/{j}"));
        let determinant = stiffness(0, 0) * stiffness(1, 1) - stiffness(0, 1) * stiffness(0, 1);
        let by_force = stiffness(1, 1) / determinant;
        assert!((at("/settlement/force") / by_force - 1.0).abs() < 1e-7);
        let by_moment = -stiffness(0, 1) / determinant;
        let layer = 1.2e-14 * at("/settlement/roughness");
        let elastic = -200e9 * at("/settlement/young_modulus");
        let load = 0.8e6 * by_force + 100.0 * by_moment;
        assert!(((layer + elastic) / load - 1.0).abs() < 1e-7, "{layer} {elastic} {load}");
        assert!(at("/peak_pressure/roughness") < 0.0 && at("/peak_pressure/force") > 0.0);
        let table = folder.run(&["solve", "punch.toml", "--sensitivities"]).answer();
        assert!(
            table.contains("by Young's modulus") && table.contains("largest pressure"),
            "{table}"
        );
        // JSON has them anyway, the table where they are asked for.
        assert_eq!(
            solve(&folder, &[])["physical"]["sensitivities"],
            json["physical"]["sensitivities"]
        );
        let table = folder.run(&["solve", "punch.toml"]).answer();
        assert!(!table.contains("by Young's modulus"), "{table}");
    }
    let json = solve(&Folder::with(DIMENSIONLESS), &["--sensitivities"]);
    assert!(number(&json, "/dimensionless/sensitivities/settlement/theta0").is_finite());
}

#[test]
fn the_surface_is_data() {
    let folder = Folder::with(&UNILATERAL.replace("(2*20)", "(2*0.5)"));
    let json = solve(&folder, &["--surface", "61"]);
    let list = |key: &str| json["surface"][key].as_array().unwrap().clone();
    let (x, gap) = (list("x"), list("gap"));
    assert_eq!((x.len(), x[0].as_f64(), x[60].as_f64()), (61, Some(-15e-3), Some(15e-3)));
    for (x, gap) in x.iter().zip(&gap) {
        assert_eq!(gap.is_null(), x.as_f64().unwrap().abs() > 5e-3);
    }
    let csv = folder.run(&["solve", "punch.toml", "--surface", "61", "--format", "csv"]).answer();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!((lines[0], lines.len()), ("x,pressure,displacement,gap", 62));
    let cells: Vec<&str> = lines[31].split(',').collect();
    assert_eq!((cells[0], cells[3]), ("0", "0"));
    assert!(lines[1].starts_with("-0.015,0,") && lines[1].ends_with(','), "{}", lines[1]);
    let bare = Folder::with(DIMENSIONLESS);
    let csv = bare.run(&["solve", "punch.toml", "--surface", "7", "--format", "csv"]).answer();
    assert!(csv.starts_with("x,pressure,displacement,gap\n-3,0,"), "{csv}");
    // Without the option the columns are as ever.
    let csv = folder.run(&["solve", "punch.toml", "--format", "csv"]).answer();
    assert!(csv.starts_with("x,pressure\n"));
}

#[test]
fn bad_extras_are_refused() {
    let elastic =
        format!("{UNILATERAL}\n[body]\nyoung_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n");
    for (problem, options, said) in [
        (UNILATERAL, ["--datum-distance", "0"].as_slice(), "datum distance = 0"),
        (UNILATERAL, &["--datum-distance", "far"], "--datum-distance `far`"),
        (UNILATERAL, &["--datum-distance", "1 MPa"], "is a length"),
        (
            UNILATERAL,
            &["--datum-depth", "-1 m"],
            "datum depth = -1: must be finite and greater than zero",
        ),
        (UNILATERAL, &["--datum-depth", "inf"], "--datum-depth `inf`"),
        (
            DIMENSIONLESS,
            &["--datum-depth", "3"],
            "a datum in the depth belongs to a physical problem",
        ),
        (&elastic, &["--datum-distance", "1 m"], "a datum belongs to a rigid punch"),
        (UNILATERAL, &["--surface", "1", "--format", "json"], "--surface 1: must be from 2"),
        (UNILATERAL, &["--surface", "61"], "--surface goes with --format json or csv"),
    ] {
        let folder = Folder::with(problem);
        let all = [&["solve", "punch.toml", "--output", "out.txt"], options].concat();
        let run = folder.run(&all);
        assert!(run.refusal().contains(said), "{options:?}: {}", run.stderr);
        assert_eq!(folder.files(), ["punch.toml"]);
    }
}

#[test]
fn a_long_trace_has_its_sensitivities() {
    let folder = Folder::with(
        &UNILATERAL
            .replace("\"x^2 / (2*20)\"", "{ csv = \"p.csv\", x_unit = \"mm\", f_unit = \"um\" }"),
    );
    let row = |i: i32| {
        let x = f64::from(i) / 100.0;
        format!("{x},{}\n", 0.3 * x * x + 1.5 * (3.0 * x).cos() + 0.1 * (40.0 * x).cos())
    };
    folder.write("p.csv", (-500..=500).map(row).collect::<String>());
    let json = solve(&folder, &[]);
    assert_eq!(json["method"]["name"], "panels");
    let at = |pointer: &str| number(&json, pointer);
    let stiffness = |i: usize, j: usize| at(&format!("/physical/stiffness/{i}/{j}"));
    let error = |i: usize, j: usize| at(&format!("/error/physical/stiffness/{i}/{j}"));
    assert!(error(0, 0) < 1e-6 * stiffness(0, 0) && error(1, 1) < 1e-6 * stiffness(1, 1));
    let determinant = stiffness(0, 0) * stiffness(1, 1) - stiffness(0, 1) * stiffness(1, 0);
    let by_force = at("/physical/sensitivities/settlement/force");
    assert!((by_force * determinant / stiffness(1, 1) - 1.0).abs() < 1e-12);
    // A larger force, by the rate at its middle.
    let raised = solve(&folder, &["--set", "load.force=\"0.8008 MN/m\""]);
    for (quantity, pointer) in [
        ("settlement", "/physical/settlement"),
        ("peak_pressure", "/physical/peak_pressure"),
        ("contact_width", "/physical/contact_width"),
    ] {
        let rate =
            |json: &Value| number(json, &format!("/physical/sensitivities/{quantity}/force"));
        let change = number(&raised, pointer) - at(pointer);
        let predicted = 0.5 * (rate(&json) + rate(&raised)) * 800.0;
        assert!((change / predicted - 1.0).abs() < 1e-4, "{quantity}: {change} {predicted}");
    }
}
