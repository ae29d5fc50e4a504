//! Studies of every kind: equations, searches, stresses, functions of places.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use std::f64::consts::{LN_2, PI};
use std::path::Path;

use shtaerman::Error;
use shtaerman_study::{Row, Study};

fn read(text: &str) -> Result<Study, Error> {
    Study::from_bytes(text.as_bytes(), "study.toml", Path::new(""), &[])
}

fn solved(text: &str) -> (Study, Vec<Row>) {
    let study = read(text).unwrap();
    let rows = study.solve(0..study.cases());
    for row in &rows {
        assert!(row.is_answered(), "{row:?}");
    }
    (study, rows)
}

fn input(row: &Row, place: usize) -> f64 {
    row.inputs[place].number().unwrap()
}

/// `int ln 1/|x - s| phi ds = c` on `(-a, a)` has `phi = c/(pi ln(2/a) sqrt(a^2 - x^2))` with the integral `c/ln(2/a)`.
#[test]
fn equations_of_the_first_kind_are_the_closed_form_within_their_errors() {
    let (_, rows) = solved(
        r#"
        [equation]
        kind = "first"
        rhs = "1"
        [kernel]
        name = "log"
        a = 1.0
        [study]
        vary."kernel.a" = [0.5, 1.0, 1.7]
        vary."equation.rhs" = ["1", "3/2"]
        outputs = ["integral", "phi(0)", "phi(0.4999)", "phi( -0.25 )"]
        "#,
    );
    assert_eq!(rows.len(), 6);
    for row in &rows {
        // Keys in alphabetical order.
        let c = if row.inputs[0].to_string() == "1" { 1.0 } else { 1.5 };
        let a = input(row, 1);
        let exact = |x: f64| c / (PI * (2.0 / a).ln() * ((a - x) * (a + x)).sqrt());
        let expected = [c / (2.0 / a).ln(), exact(0.0), exact(0.4999), exact(-0.25)];
        for ((value, error), exact) in row.outputs.iter().zip(&row.errors).zip(expected) {
            let error = error.unwrap();
            let rounding = 1e-15 * exact.abs();
            assert!((value - exact).abs() <= error + rounding, "{row:?}: {exact}");
            // Near the end the weight makes values and errors larger.
            assert!(error > 0.0 && error < 1e-11 * exact.abs(), "{row:?}");
        }
        assert_eq!(row.error_kind, "estimate");
    }
}

/// The error of the first kind is that of `phi/w`: at a place it grows with the weight, of which `phi` is a multiple here.
#[test]
fn errors_of_the_first_kind_go_with_the_weight() {
    let (_, rows) = solved(
        "[equation]\nkind = \"first\"\nrhs = \"1\"\n[kernel]\nname = \"log\"\na = 1.0\n\
         [study]\nvary.\"kernel.a\" = [1.0]\noutputs = [\"phi(0)\", \"phi(0.99)\", \"phi(1)\"]\n",
    );
    let row = &rows[0];
    let share = |place: usize| row.errors[place].unwrap() / row.outputs[place];
    assert!((share(1) / share(0) - 1.0).abs() < 1e-9, "{row:?}");
    assert!(row.outputs[2] == f64::INFINITY && row.errors[2].is_none(), "{row:?}");
    assert!((row.outputs[0] - 1.0 / (PI * LN_2)).abs() < 1e-13);
}

/// Twice the right-hand side is twice the solution, within the bounds of both.
#[test]
fn equations_of_the_second_kind_are_linear_and_their_audits_bounds() {
    let text = r#"
        [equation]
        kind = "second"
        lambda = 1.0
        rhs = "x"
        [kernel]
        name = "log"
        a = 1.0
        [study]
        vary."equation.rhs" = ["exp(x)", "2*exp(x)"]
        vary."equation.lambda" = { from = 0.5, to = 2.0, count = 2 }
        outputs = ["phi(0.3)", "integral"]
        audit = true
        "#;
    let (study, rows) = solved(text);
    assert_eq!(study.variables()[0].key, "equation.lambda");
    for pair in rows.chunks(2) {
        for (place, name) in ["phi", "integral"].iter().enumerate() {
            let [one, two] = [&pair[0], &pair[1]].map(|row| row.outputs[place]);
            let room = 2.0 * pair[0].errors[place].unwrap() + pair[1].errors[place].unwrap();
            assert!((2.0 * one - two).abs() <= room && room < 1e-10, "{name}: {pair:?}");
        }
        assert!(pair.iter().all(|row| row.error_kind == "bound"), "{pair:?}");
    }
    // lambda matters.
    assert!((rows[0].outputs[0] - rows[2].outputs[0]).abs() > 0.1);
}

const CYLINDER: &str = r#"
    [foundation]
    young_modulus = "200 GPa"
    poisson_ratio = 0.3
    roughness = 0
    [punch]
    half_width = "5 mm"
    profile = "x^2 / (2*0.5)"
    [load]
    force = "0.2 MN/m"
    moment = 0
    [study]
"#;

/// H. Hertz: a half-width `sqrt(4 P R/(pi E*))`, the largest pressure `2 P/(pi a)`, the largest shear stress 0.300 of it in the depth 0.786 a (K. L. Johnson, Contact Mechanics, 4.49).
#[test]
fn places_and_stresses_are_those_of_hertz() {
    let (_, rows) = solved(&format!(
        "{CYLINDER}
        vary.\"load.force\" = [\"0.2 MN/m\", 1e5]
        outputs = [\"pressure(0.2 mm)\", \"pressure(-0.0002)\", \"pressure(5 mm)\", \"max_shear\", \"max_shear_depth\", \"max_von_mises\", \"peak_pressure\", \"displacement(0)\", \"settlement\"]
        "
    ));
    let contact_modulus = 200e9 / (1.0 - 0.09);
    for row in &rows {
        let force = input(row, 0);
        let a = (4.0 * force * 0.5 / (PI * contact_modulus)).sqrt();
        let peak = 2.0 * force / (PI * a);
        let at = peak * (1.0 - (2e-4 / a).powi(2)).sqrt();
        let near = |place: usize, exact: f64, room: f64| {
            let value = row.outputs[place];
            assert!((value / exact - 1.0).abs() < room, "{place}: {value} {exact}");
        };
        near(0, at, 1e-9);
        near(1, at, 1e-9);
        assert_eq!(row.outputs[2], 0.0);
        near(3, 0.3003 * peak, 1e-3);
        near(4, 0.786 * a, 2e-3);
        assert!((0.5..0.6).contains(&(row.outputs[5] / peak)), "{row:?}");
        near(6, peak, 1e-9);
        // A smooth punch touches the surface.
        near(7, row.outputs[8], 1e-9);
        assert!(row.errors[0].is_some() && row.errors[3].is_some() && row.errors[7].is_none());
        assert_eq!(row.error_kind, "estimate");
    }
}

/// The largest pressure of Hertz is `sqrt(P E*/(pi R))`: the force for a pressure is `pi R p^2/E*`.
#[test]
fn forces_are_found_in_every_case() {
    let (study, rows) = solved(&format!(
        "{CYLINDER}
        vary.\"foundation.young_modulus\" = [\"100 GPa\", \"200 GPa\"]
        find.force = {{ peak_pressure = \"300 MPa\" }}
        "
    ));
    let names: Vec<&str> = study.outputs().iter().map(|output| output.name.as_str()).collect();
    assert_eq!(names[..2], ["found", "settlement"]);
    for row in &rows {
        let exact = PI * 0.5 * 3e8f64.powi(2) / (input(row, 0) / (1.0 - 0.09));
        assert!((row.outputs[0] / exact - 1.0).abs() < 1e-6, "{row:?} {exact}");
        // The outputs are those of the contact under that force.
        assert_eq!(row.outputs[0], row.outputs[3]);
        assert!((row.outputs[4] / 3e8 - 1.0).abs() < 1e-6);
    }
    let rough = CYLINDER.replace("roughness = 0", "roughness = 1e-14");
    let (_, rows) = solved(&format!(
        "{rough}\nvary.\"load.force\" = [2e5, 3e5]\nfind.roughness = {{ settlement = \"3 um\" }}\noutputs = [\"found\", \"settlement\"]\n"
    ));
    assert!(rows.iter().all(|row| (row.outputs[1] / 3e-6 - 1.0).abs() < 1e-6), "{rows:?}");
    assert!(rows[1].outputs[0] < rows[0].outputs[0], "more force, less roughness: {rows:?}");
}

/// A value whose problem has no answer is refused as its case, written as a number or with a unit; a unit that the key does not take before any.
#[test]
fn values_without_an_answer_are_cases_with_or_without_units() {
    let study = |values: &str| {
        format!(
            "[foundation]\nyoung_modulus = 2e11\npoisson_ratio = 0.3\nroughness = 1.2e-14\n[punch]\nhalf_width = 5e-3\nprofile = \"x^2/40\"\n[load]\nforce = 8e5\neccentricity = 0\n\
             [study]\nvary.\"load.eccentricity\" = {values}\noutputs = [\"settlement\"]\n"
        )
    };
    for values in [
        "[0, 0.002, 0.006]",
        "[\"0 mm\", \"2 mm\", \"6 mm\"]",
        "{ from = \"0 mm\", to = \"6 mm\", count = 3 }",
    ] {
        let study = read(&study(values)).unwrap();
        let answered: Vec<bool> = study.solve(0..3).iter().map(Row::is_answered).collect();
        assert_eq!(answered, [true, true, false], "{values}");
    }
    for (values, said) in
        [("[\"2 MPa\"]", "got MPa, a pressure"), ("[\"6 mn\"]", "unknown unit mn")]
    {
        let refused = read(&study(values)).unwrap_err().to_string();
        assert!(refused.contains(said), "{refused}");
    }
}

#[test]
fn what_a_study_cannot_tell_is_refused() {
    let equation = "[equation]\nkind = \"second\"\nlambda = 1.0\nrhs = \"x\"\n[kernel]\nname = \"log\"\na = 1.0\n[study]\n";
    let lambda = "vary.\"equation.lambda\" = [1.0, 2.0]\n";
    let force = "vary.\"load.force\" = [1e5, 2e5]\n";
    let bare = "[dimensionless]\ntheta0 = 1.0\nprofile = \"xi^2\"\nforce = 1.0\nmoment = 0\n[study]\nvary.\"dimensionless.force\" = [1.0]\n";
    for (text, said) in [
        (format!("{equation}{lambda}outputs = [\"settlement\"]"), "phi(x)"),
        (format!("{equation}{lambda}outputs = [\"phi\"]"), "phi(x)"),
        (format!("{equation}{lambda}outputs = [\"phi(x)\"]"), "phi(0.5)"),
        (format!("{equation}{lambda}outputs = [\"phi(0.5 mm)\"]"), "phi(0.5 mm)"),
        (format!("{equation}{lambda}outputs = [\"phi(0.5\"]"), "no bracket"),
        (format!("{equation}{lambda}outputs = [\"phi(2)\"]"), "cannot be told"),
        (format!("{equation}{lambda}outputs = [\"phi(nan)\"]"), "phi(nan)"),
        (format!("{equation}{lambda}outputs = [\"pressure(0)\"]"), "at a place there is phi(x)"),
        (format!("{equation}{lambda}find.force = {{ peak_pressure = 1 }}"), "find"),
        (format!("{equation}vary.\"kernel.mu\" = [0.1]"), "kernel.mu"),
        (format!("{equation}vary.\"equation.lambda\" = [\"1 mm\"]"), "equation.lambda"),
        (format!("{equation}vary.\"load.force\" = [1.0]"), "load.force"),
        (format!("{CYLINDER}{force}outputs = [\"phi(0)\"]"), "pressure(x) and displacement(x)"),
        (format!("{CYLINDER}{force}outputs = [\"pressure(1 MPa)\"]"), "pressure(2 mm)"),
        (format!("{CYLINDER}{force}outputs = [\"pressure(6 mm)\"]"), "beyond the punch"),
        (format!("{CYLINDER}{force}outputs = [\"found\"]"), "outputs"),
        (format!("{CYLINDER}{force}outputs = [3]"), "string"),
        (format!("{CYLINDER}{force}outputs = [\"pressure(0)\", \"pressure(0)\"]"), "twice"),
        (format!("{CYLINDER}{force}find.force = {{ peak_pressure = \"1 GPa\" }}"), "cannot vary"),
        (format!("{CYLINDER}{force}find.crown = {{ }}"), "find.force = "),
        (format!("{CYLINDER}{force}find.roughness = {{ peak_pressure = 0 }}"), "greater than zero"),
        (format!("{CYLINDER}{force}find.roughness = {{ settlement = \"1 MPa\" }}"), "settlement"),
        (
            format!("{CYLINDER}{force}find.roughness = {{ settlement = 1, contact_width = 1 }}"),
            "one of them",
        ),
        (format!("{bare}find.roughness = {{ settlement = 1 }}"), "scale of its displacements"),
        (format!("{bare}outputs = [\"max_shear\"]"), "Poisson"),
        (format!("{bare}outputs = [\"pressure(1 mm)\"]"), "pressure(0.5)"),
        (
            format!(
                "{}{force}outputs = [\"max_shear\"]",
                CYLINDER.replace("half_width", "geometry = \"circular\"\nradius")
            ),
            "half-space only",
        ),
    ] {
        let Err(error) = read(&text) else { panic!("{text}") };
        let told = match &error {
            Error::File(fault) => format!("{error} {}", fault.help().unwrap_or("")),
            _ => error.to_string(),
        };
        assert!(told.contains(said), "{text}: {told}");
        assert!(told.contains("study.toml:"), "{text}: {told}");
    }
    // What other cases may have is no fault of the study.
    let study = read(&format!(
        "{CYLINDER}vary.\"punch.half_width\" = [\"5 mm\", \"7 mm\"]\noutputs = [\"pressure(6 mm)\"]\n"
    ));
    let rows = study.unwrap().solve(0..2);
    assert!(rows[0].reason.contains("beyond the punch") && rows[1].is_answered(), "{rows:?}");
}

#[test]
fn ranges_of_any_length_take_no_room_and_their_ends_are_exact() {
    let count = 9_007_199_254_740_991_usize;
    let study = read(&format!(
        "{CYLINDER}vary.\"load.force\" = {{ from = 1e5, to = 3.3e5, count = {count}, scale = \"log\" }}\n"
    ))
    .unwrap();
    assert_eq!(study.cases(), count);
    let force = |case: usize| study.inputs(case)[0].number().unwrap();
    assert_eq!([force(0), force(count - 1)], [1e5, 3.3e5]);
    let middle = (1e5f64 * 3.3e5).sqrt();
    assert!((force(count / 2) / middle - 1.0).abs() < 1e-14);
    assert!(study.solve(count - 1..count)[0].is_answered());
    let random = format!(
        "{CYLINDER}design = \"random\"\ncount = {count}\nvary.\"load.force\" = {{ from = 1e5, to = 2e5 }}\n"
    );
    assert_eq!(read(&random).unwrap().cases(), count);
}

#[test]
fn every_trace_of_a_study_belongs_to_it() {
    let folder = std::env::temp_dir().join(format!("shtaerman-kinds-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let trace = |name: &str, height: f64| {
        let lines = (-5..=5).map(|i| format!("{}e-3,{}\n", i, height * f64::from(i * i)));
        std::fs::write(folder.join(name), lines.collect::<String>()).unwrap();
    };
    trace("a.csv", 1e-8);
    trace("b.csv", 2e-8);
    let text = CYLINDER.replace("\"x^2 / (2*0.5)\"", "{ csv = \"a.csv\" }")
        + "vary.\"punch.profile.csv\" = [\"a.csv\", \"b.csv\"]\n";
    let digest = || {
        let study = Study::from_bytes(text.as_bytes(), "study.toml", &folder, &[]).unwrap();
        study.manifest("study.toml", "csv").unwrap().digest
    };
    let first = digest();
    assert_eq!(first, digest());
    trace("b.csv", 3e-8);
    assert_ne!(first, digest());
    std::fs::remove_dir_all(folder).unwrap();
}
