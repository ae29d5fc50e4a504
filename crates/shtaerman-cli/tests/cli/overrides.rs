//! `--set`.

use serde_json::Value;

use crate::cli::support::{DIMENSIONLESS, Folder, PHYSICAL, number};

/// The answer with overrides, and the answer of the file that says the same.
fn both(problem: &str, overrides: &[&str], from_to: &[(&str, &str)]) -> [Value; 2] {
    let folder = Folder::with(problem);
    let mut arguments = vec!["solve", "punch.toml", "--format", "json", "--points", "5"];
    for text in overrides {
        arguments.extend(["--set", text]);
    }
    let overridden = folder.run(&arguments).json();
    let mut written = problem.to_owned();
    for (from, to) in from_to {
        assert!(written.contains(from), "{from}");
        written = written.replace(from, to);
    }
    folder.write("punch.toml", written);
    [overridden, folder.run(&arguments[..6]).json()]
}

/// Problem, overrides, and what the file would say instead of what.
type Row<'t> = (&'t str, &'t [&'t str], &'t [(&'t str, &'t str)]);

#[test]
fn an_override_is_as_good_as_the_file() {
    let rows: &[Row<'_>] = &[
        (PHYSICAL, &["load.force=1 MN/m"], &[("0.8 MN/m", "1 MN/m")]),
        (PHYSICAL, &["load.force=\"1 MN/m\""], &[("0.8 MN/m", "1 MN/m")]),
        (PHYSICAL, &["load.force = 1e6"], &[("\"0.8 MN/m\"", "1e6")]),
        (PHYSICAL, &["solver.n=60"], &[("n = 40", "n = 60")]),
        (PHYSICAL, &["punch.profile=0"], &[("x^2 / (2*20)", "0")]),
        (PHYSICAL, &["punch.profile=x^2/(2*2)"], &[("x^2 / (2*20)", "x^2/(2*2)")]),
        (PHYSICAL, &["load.settlement=3 um"], &[("force = \"0.8 MN/m\"", "settlement = \"3 um\"")]),
        (PHYSICAL, &["load.tilt=0"], &[("moment = \"100 N\"", "tilt = 0")]),
        (
            PHYSICAL,
            &["load.eccentricity=0.1 mm"],
            &[("moment = \"100 N\"", "eccentricity = \"0.1 mm\"")],
        ),
        (
            PHYSICAL,
            &["foundation.subgrade_modulus=8e13 Pa/m"],
            &[("roughness = \"1.2e-14 m/Pa\"", "subgrade_modulus = \"8e13 Pa/m\"")],
        ),
        (
            PHYSICAL,
            &["body.young_modulus=70 GPa", "body.poisson_ratio=0.33"],
            &[("[punch]", "[body]\nyoung_modulus = \"70 GPa\"\npoisson_ratio = 0.33\n[punch]")],
        ),
        (PHYSICAL, &["load.force=1", "load.force=2 MN/m"], &[("0.8 MN/m", "2 MN/m")]),
        (DIMENSIONLESS, &["dimensionless.theta0=0"], &[("13.0", "0")]),
        (
            DIMENSIONLESS,
            &["dimensionless.lambda0=10", "dimensionless.poisson_ratio=0.25"],
            &[("theta0 = 13.0", "lambda0 = 10\npoisson_ratio = 0.25")],
        ),
        (
            DIMENSIONLESS,
            &["dimensionless.settlement=5", "dimensionless.tilt=0.1"],
            &[("force = 1.7", "settlement = 5"), ("moment = -0.31", "tilt = 0.1")],
        ),
    ];
    for (problem, overrides, from_to) in rows {
        let [overridden, written] = both(problem, overrides, from_to);
        assert_eq!(overridden, written, "{overrides:?}");
    }
}

#[test]
fn a_level_punch_tells_its_moment() {
    let folder = Folder::with(&PHYSICAL.replace("x^2 / (2*20)", "1e-6*(xi^2 + xi^3)"));
    let json =
        folder.run(&["solve", "punch.toml", "--format", "json", "--set", "load.tilt=0"]).json();
    assert_eq!(number(&json, "/physical/tilt"), 0.0);
    // The base is higher on the right, so the right carries less: M = int x p < 0.
    assert!(number(&json, "/physical/moment") < -1.0);
}

#[test]
fn a_measured_profile_is_found_beside_the_problem_file() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("part")).unwrap();
    folder.write("part/punch.toml", PHYSICAL);
    // Three points of x^2/40: the spline through them is the parabola.
    folder.write("part/trace.csv", "x_mm,f_um\n-5,0.625\n0,0\n5,0.625\n");
    let solve = ["solve", "part/punch.toml", "--format", "json", "--points", "3"];
    let formula = folder.run(&solve).json();
    let profile = "punch.profile={ csv = \"trace.csv\", x_unit = \"mm\", f_unit = \"um\" }";
    let measured = folder.run(&[&solve[..], &["--set", profile]].concat()).json();
    let flipped = profile.replace(" }", ", flip = true }");
    let flipped = folder.run(&[&solve[..], &["--set", &flipped]].concat()).json();
    for key in ["/physical/settlement", "/physical/pressure_middle", "/physical/pressure_right"] {
        let (formula, measured) = (number(&formula, key), number(&measured, key));
        assert!((formula - measured).abs() < 1e-12 * formula.abs(), "{key}: {formula} {measured}");
    }
    assert!(
        number(&flipped, "/physical/pressure_middle")
            < number(&formula, "/physical/pressure_middle")
    );
    // From standard input the path is relative to the current folder.
    let profile = profile.replace("trace", "part/trace");
    let arguments = ["solve", "-", "--format", "json", "--points", "3", "--set", &profile];
    assert_eq!(folder.run_with_input(&arguments, PHYSICAL).json(), measured);
}

#[test]
fn a_formula_takes_the_place_of_a_measured_profile() {
    let table = "profile = { csv = \"trace.csv\" }";
    let folder = Folder::with(&PHYSICAL.replace("profile = \"x^2 / (2*20)\"", table));
    assert!(std::fs::read_to_string(folder.path("punch.toml")).unwrap().contains(table));
    let solve = ["solve", "punch.toml", "--no-audit", "--format", "json", "--set"];
    let plain = Folder::with(PHYSICAL);
    for profile in ["punch.profile=0", "punch.profile=x^2/40"] {
        let solve = [&solve[..], &[profile]].concat();
        assert_eq!(folder.run(&solve).json(), plain.run(&solve).json(), "{profile}");
    }
    let vary = ["solve", "punch.toml", "--no-audit", "--vary", "punch.profile=0,x^2/40"];
    assert_eq!(folder.run(&vary).answer(), plain.run(&vary).answer());
    let run = folder.run(&[&solve[..], &["punch.profile=Trace.csv"]].concat());
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("profile = { csv = \"Trace.csv\" }"), "{}", run.stderr);
}

#[test]
fn bad_overrides_are_refused() {
    for (text, said) in [
        ("load.force", "has no `=`"),
        ("load.forc=3", "load.forc: is not a known key, did you mean force?"),
        ("lod.force=3", "lod: is not a known key, did you mean load?"),
        (
            "load.force=3 mm",
            "load.force: is a force per length (like \"1 MN/m\"), got mm, a length",
        ),
        ("load.force=", "has no value"),
        ("load.force=nan", "is nan"),
        ("load=3", "load: is a table, got the number 3"),
        ("foundation.coating=3", "foundation.coating: is a table ([foundation.coating]), got"),
        (".=3", "nothing between its dots"),
        ("punch.profile=1/xi", "is infinite at x = 0"),
        ("punch.profile={csv=\"nowhere.csv\"}", "nowhere.csv cannot be read"),
        ("solver.contact=full", "one of \"unilateral\", \"bilateral\""),
    ] {
        let folder = Folder::with(PHYSICAL);
        for command in ["solve", "validate", "convergence"] {
            let run = folder.run(&[command, "punch.toml", "--set", text]);
            let message = run.refusal();
            assert!(message.contains("--set") && message.contains(said), "{text}: {message}");
        }
    }
    // Sound, and beyond this machine.
    let folder = Folder::with(PHYSICAL);
    for command in ["solve", "validate", "convergence"] {
        let run = folder.run(&[command, "punch.toml", "--set", "solver.n=1000000000000"]);
        let message = run.failure(3);
        assert!(message.contains("--set"), "{message}");
        assert!(message.contains("solver.n: is 1000000000000: that needs"), "{message}");
    }
}
