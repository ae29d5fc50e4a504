//! Whatever way the cases of a study are computed, they are those of single solves.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::path::Path;

use shtaerman::Contact;
use shtaerman::file::ProblemFile;
use shtaerman_study::{Row, Study};

fn study(text: &str) -> Study {
    Study::from_bytes(text.as_bytes(), "study.toml", Path::new(""), &[]).unwrap()
}

/// The contact of a case, read from the problem with its values as overrides.
fn alone(problem: &str, study: &Study, row: &Row) -> Contact {
    let overrides: Vec<String> = study
        .variables()
        .iter()
        .zip(&row.inputs)
        .map(|(variable, input)| format!("{}={input}", variable.key))
        .collect();
    let file =
        ProblemFile::from_bytes(problem.as_bytes(), "problem.toml", Path::new(""), &overrides);
    file.unwrap().solve().unwrap()
}

const PHYSICAL: &str = r#"
[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.2e-14 m/Pa"

[punch]
half_width = "5 mm"
profile = "x^2 / 40"

[load]
force = "0.8 MN/m"
eccentricity = "0.1 mm"
"#;

const DIMENSIONLESS: &str = r#"
[dimensionless]
theta0 = 3.0
profile = "0.4*xi^2 + 0.1*exp(xi)"
force = 2.0
tilt = 0.1
"#;

#[test]
fn replaced_values_give_the_bits_of_files_read_anew() {
    let studies = [
        (
            PHYSICAL,
            r#"
            vary."load.force" = { from = 1e5, to = 9.1e5, count = 3 }
            vary."load.eccentricity" = ["0.03 mm", -1e-4]
            vary."foundation.roughness" = [3e-15, 7e-14]
            vary."foundation.young_modulus" = ["70 GPa", 2.1e11]
            "#,
        ),
        (
            DIMENSIONLESS,
            r#"
            vary."dimensionless.theta0" = { from = 0.3, to = 90.0, count = 4, scale = "log" }
            vary."dimensionless.force" = [1, 2.5]
            vary."dimensionless.tilt" = [0.0, -0.2]
            "#,
        ),
    ];
    for (problem, vary) in studies {
        let study = study(&format!("{problem}\n[study]\n{vary}"));
        for row in study.solve(0..study.cases()) {
            let contact = alone(problem, &study, &row);
            for (output, (value, error)) in
                study.outputs().iter().zip(row.outputs.iter().zip(&row.errors))
            {
                let (exact, stated) = output.of_contact(&contact).unwrap();
                assert_eq!(
                    value.to_bits(),
                    exact.to_bits(),
                    "{} of case {}",
                    output.name,
                    row.case
                );
                assert_eq!(*error, stated, "{} of case {}", output.name, row.case);
            }
        }
    }
}

#[test]
fn a_sweep_over_theta0_and_loads_agrees_with_single_solves_within_its_errors() {
    let cases = [
        ("force = 2.0\nmoment = 0.3", "force", "moment", [-3.0, 4.0], [-1.0, 1.5]),
        ("settlement = 0.7\ntilt = 0.0", "settlement", "tilt", [-0.5, 2.0], [-0.3, 0.2]),
        ("force = 1.0\ntilt = 0.1", "force", "tilt", [0.0, 1e3], [-1e-4, 1e-4]),
        ("settlement = 1.0\nmoment = 0.0", "settlement", "moment", [0.0, 2.0], [-30.0, 20.0]),
    ];
    for (load, vertical, rotational, [a, b], [c, d]) in cases {
        let problem = format!(
            "[dimensionless]\ntheta0 = 3.0\nprofile = \"0.4*xi^2 + 0.1*exp(2*xi)\"\n{load}\n[solver]\ncontact = \"bilateral\"\n"
        );
        let study = study(&format!(
            r#"{problem}
            [study]
            design = "random"
            count = 40
            seed = 5113
            vary."dimensionless.theta0" = {{ distribution = "log-uniform", from = 1e-3, to = 1e3 }}
            vary."dimensionless.{vertical}" = {{ from = {a}, to = {b} }}
            vary."dimensionless.{rotational}" = {{ from = {c}, to = {d} }}
            outputs = ["settlement", "tilt", "force", "moment", "pressure_left", "pressure_right", "theta0"]
            "#
        ));
        assert!(study.block() > 1, "{load}: the cases are swept");
        for row in study.solve(0..study.cases()) {
            let contact = alone(&problem, &study, &row);
            assert!(row.is_answered() && row.error_kind == "estimate");
            for (output, (value, error)) in
                study.outputs().iter().zip(row.outputs.iter().zip(&row.errors))
            {
                let (exact, stated) = output.of_contact(&contact).unwrap();
                let room = error.unwrap_or(0.0) + stated.unwrap_or(0.0);
                let apart = (value - exact).abs();
                assert!(
                    apart <= room,
                    "{} of {:?}: {apart:e}, stated {room:e}",
                    output.name,
                    row.inputs
                );
                // An error that states nothing would pass.
                assert!(
                    room <= 1e-7 * (1.0 + exact.abs() + row.outputs[0].abs() * 1e3),
                    "{room:e}"
                );
            }
        }
    }
}

#[test]
fn a_case_that_is_none_has_its_reason_among_swept_ones() {
    let study = study(
        "[dimensionless]\ntheta0 = 3.0\nprofile = \"xi^2\"\nforce = 2.0\nmoment = 0\n[solver]\ncontact = \"bilateral\"\n\
         [study]\nvary.\"dimensionless.theta0\" = [1.0, -2.0, 5.0]\noutputs = [\"settlement\"]\n",
    );
    let rows = study.solve(0..3);
    assert!(rows[0].is_answered() && rows[2].is_answered());
    assert!(rows[1].outputs[0].is_nan() && rows[1].reason.contains("theta0 = -2"), "{:?}", rows[1]);
}
