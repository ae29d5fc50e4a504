//! Problem files with one fault each: one message with file, line and field, exit code 2, no output file.

use crate::cli::support::{DIMENSIONLESS, Folder, PHYSICAL};

/// Solves the faulty file with both kinds of output, and checks all but the words of the message.
#[track_caller]
pub(crate) fn refusal(folder: &Folder, place: &str) -> String {
    let before = folder.files();
    let run = folder.run(&[
        "solve",
        "punch.toml",
        "--format",
        "json",
        "--output",
        "out.json",
        "--plot",
        "out.svg",
    ]);
    let message = run.refusal();
    assert!(message.starts_with(&format!("error: {place}: ")), "{place}: {message}");
    assert_eq!(folder.files(), before, "{message}");
    run.stderr
}

/// Problem, what is written instead of what, place and field, words of the message.
pub(crate) type Row = (&'static str, &'static str, &'static str, &'static str, &'static str);

#[track_caller]
pub(crate) fn check(rows: &[Row]) {
    for (problem, from, to, place, said) in rows {
        let text = problem.replace(from, to);
        assert_ne!(&text, problem, "{from}");
        let folder = Folder::with(&text);
        let stderr = refusal(&folder, place);
        assert!(stderr.contains(said), "{to}: {stderr}");
        // `validate` finds all that `solve` finds, in the same words.
        let validated = folder.run(&["validate", "punch.toml"]);
        validated.refusal();
        assert_eq!(validated.stderr, stderr);
    }
}

/// A wave, for the rows below.
const WAVE: &str = r#"[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.2e-14 m/Pa"

[punch]
geometry = "periodic"
period = "10 mm"
profile = "1e-6*cos(2*pi*x/10e-3)"

[load]
force = "0.8 MN/m"
tilt = 0
"#;

/// A disk on a layer with a power law.
const DISK: &str = r#"[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = { coefficient = 2e-10, exponent = 0.6 }

[punch]
geometry = "circular"
radius = "5 mm"
profile = "x^2/(2*20)"

[load]
force = "0.8 kN"
tilt = 0
"#;

/// What a geometry does not know needs no solution to be told.
#[test]
fn geometries() {
    let tilt = "tilt = 1e-6";
    check(&[
        (
            WAVE,
            "tilt = 0",
            tilt,
            "punch.toml:13: load.tilt",
            "zero where the base fills the period",
        ),
        (DISK, "tilt = 0", tilt, "punch.toml:13: load.tilt", "mixes the harmonics"),
        (DISK, "x^2", "x^3", "punch.toml", "even in x"),
    ]);
}

#[test]
fn keys() {
    check(&[
        (
            PHYSICAL,
            "young_modulus = \"200 GPa\"\n",
            "",
            "punch.toml:1: foundation.young_modulus",
            "is missing",
        ),
        (PHYSICAL, "half_width = \"5 mm\"\n", "", "punch.toml:6: punch.half_width", "is missing"),
        (
            PHYSICAL,
            "profile = \"x^2 / (2*20)\"\n",
            "",
            "punch.toml:6: punch.profile",
            "\"0\" is a flat base",
        ),
        (
            PHYSICAL,
            "[load]\nforce = \"0.8 MN/m\"\nmoment = \"100 N\"\n",
            "",
            "punch.toml: load",
            "is missing",
        ),
        (
            PHYSICAL,
            "half_width",
            "half_witdh",
            "punch.toml:7: punch.half_width",
            "did you mean half_width?",
        ),
        (PHYSICAL, "roughness = ", "roughnes = ", "punch.toml:4", "did you mean roughness?"),
        (PHYSICAL, "n = 40", "nn = 40", "punch.toml:16: solver.nn", "did you mean n?"),
        (
            PHYSICAL,
            "n = 40",
            "n = 40\nmehtod = \"spectral\"",
            "punch.toml:17: solver.mehtod",
            "did you mean method?",
        ),
        (PHYSICAL, "[solver]", "[solvr]", "punch.toml:14: solvr", "did you mean solver?"),
        (PHYSICAL, "[solver]", "[notes]\n[solver]", "punch.toml:14: notes", "not a known key"),
        (DIMENSIONLESS, "force", "forse", "punch.toml:4", "did you mean force?"),
        (
            DIMENSIONLESS,
            "n = 40",
            "n = 40\n[load]\nforce = 1",
            "punch.toml:10: load",
            "does not go with [dimensionless]",
        ),
        (
            PHYSICAL,
            "[solver]",
            "[dimensionless]\ntheta0 = 1\n[solver]",
            "punch.toml:1: foundation",
            "does not go with",
        ),
        (
            DIMENSIONLESS,
            "theta0 = 13.0",
            "theta0 = 1\npoisson_ratio = 0.3",
            "punch.toml:3: dimensionless.poisson_ratio",
            "lambda0",
        ),
        (
            DIMENSIONLESS,
            "theta0 = 13.0",
            "lambda0 = 1",
            "punch.toml:1: dimensionless.poisson_ratio",
            "is missing",
        ),
    ]);
}

#[test]
fn pairs() {
    check(&[
        (
            PHYSICAL,
            "force = \"0.8 MN/m\"\n",
            "",
            "punch.toml:10",
            "force or settlement is missing in [load]",
        ),
        (
            PHYSICAL,
            "moment = \"100 N\"\n",
            "",
            "punch.toml:10",
            "moment or eccentricity or tilt is missing in [load]",
        ),
        (
            PHYSICAL,
            "moment",
            "settlement = 1e-6\nmoment",
            "punch.toml:12: load.settlement",
            "is written besides load.force",
        ),
        (PHYSICAL, "moment", "tilt = 0\nmoment", "punch.toml:12: load.tilt", "besides load.moment"),
        (
            PHYSICAL,
            "moment",
            "eccentricity = 0\nmoment",
            "punch.toml:12: load.eccentricity",
            "besides load.moment",
        ),
        (
            PHYSICAL,
            "roughness = \"1.2e-14 m/Pa\"\n",
            "",
            "punch.toml:1",
            "roughness or subgrade_modulus is missing",
        ),
        (
            PHYSICAL,
            "[punch]",
            "subgrade_modulus = 1e14\n[punch]",
            "punch.toml:6: foundation.subgrade_modulus",
            "besides",
        ),
        (
            DIMENSIONLESS,
            "theta0 = 13.0",
            "theta0 = 1\nlambda0 = 1",
            "punch.toml:3: dimensionless.lambda0",
            "besides",
        ),
        (DIMENSIONLESS, "theta0 = 13.0\n", "", "punch.toml:1", "theta0 or lambda0 is missing"),
        (
            DIMENSIONLESS,
            "moment",
            "tilt = 0\nmoment",
            "punch.toml:5: dimensionless.tilt",
            "besides dimensionless.moment",
        ),
    ]);
}

#[test]
fn expressions() {
    let profile = |from: &'static str| move |to: &str| PHYSICAL.replace(from, to);
    let written = profile("x^2 / (2*20)");
    // The caret stands under what is wrong.
    for (expression, said, caret) in [
        ("x^2 + sin(x", "this bracket is never closed", "(x"),
        ("x^2 + bogus(x)", "there is no function `bogus`", "bogus"),
        ("x^2 + y", "y", "y\""),
        ("2x", "an operator is missing between `2` and `x`", "2x"),
        ("x^2 + ", "", "\""),
        ("x + * 2", "", "* 2"),
        ("sin(x, x)", "sin", "sin"),
        ("1..2", "", "1..2"),
        ("x @ 2", "@", "@"),
    ] {
        let folder = Folder::with(&written(expression));
        let stderr = refusal(&folder, "punch.toml:8: punch.profile");
        assert!(stderr.contains(said), "{expression}: {stderr}");
        let mut lines = stderr.lines().skip_while(|line| !line.contains(" 8 │ "));
        let (source, marks) = (lines.next().unwrap(), lines.next().unwrap());
        assert!(source.ends_with(&format!("profile = \"{expression}\"")), "{stderr}");
        let column = |line: &str, byte: usize| line[..byte].chars().count();
        let mark = column(marks, marks.find(['─', '▲']).unwrap());
        let start = column(source, source.find("= \"").unwrap() + 3);
        let wanted = column(source, source.rfind(caret).unwrap());
        assert!(mark >= start && mark <= wanted, "{expression}: {stderr}");
    }
}

#[test]
fn profiles_that_are_not_finite() {
    check(&[
        (
            PHYSICAL,
            "x^2 / (2*20)",
            "1e-9/xi",
            "punch.toml:8: punch.profile",
            "is infinite at x = 0",
        ),
        (
            PHYSICAL,
            "x^2 / (2*20)",
            "1/(xi - 0.3)",
            "punch.toml:8: punch.profile",
            "is infinite at x = 0.0015",
        ),
        (
            PHYSICAL,
            "x^2 / (2*20)",
            "ln(x)",
            "punch.toml:8: punch.profile",
            "is undefined at x = -0.005",
        ),
        (PHYSICAL, "x^2 / (2*20)", "sqrt(x)", "punch.toml:8: punch.profile", "is undefined"),
        (
            PHYSICAL,
            "x^2 / (2*20)",
            "1/(1 - xi)",
            "punch.toml:8: punch.profile",
            "is infinite at x = 0.005",
        ),
        (PHYSICAL, "x^2 / (2*20)", "exp(1000*xi)", "punch.toml:8: punch.profile", "is infinite"),
        (
            DIMENSIONLESS,
            "xi^4 - xi/2",
            "1/(xi - 0.123456789)",
            "punch.toml:3: dimensionless.profile",
            "is infinite at xi = 0.1234",
        ),
        (
            DIMENSIONLESS,
            "\"xi^4 - xi/2\"",
            "\"\"",
            "punch.toml:3: dimensionless.profile",
            "the expression is empty",
        ),
        (
            DIMENSIONLESS,
            "\"xi^4 - xi/2\"",
            "true",
            "punch.toml:3: dimensionless.profile",
            "is a string",
        ),
    ]);
}

#[test]
fn measured_profiles() {
    let problem = PHYSICAL.replace("\"x^2 / (2*20)\"", "{ csv = \"p.csv\", x_unit = \"mm\" }");
    for (csv, said) in [
        ("x,f\n-5,1\n", "p.csv: a profile needs at least two rows of numbers, got 1"),
        ("", "p.csv: a profile needs at least two rows of numbers, the file is empty"),
        ("x,f\n", "two rows of numbers, got 0: there is nothing behind the header"),
        (
            "x [mm],f [m]\nmm,m\n-5,1\n5,1\n",
            "line 2: the position is not a number: `mm`; skip = 1 makes this line the header",
        ),
        ("-5,1\n0,high\n5,1\n", "p.csv: line 2: the height is not a number: `high`"),
        ("-5,1\n1,1\n0,1\n5,1\n", "p.csv: line 3: positions must increase"),
        ("-5,1\n0,1\n0,1\n5,1\n", "p.csv: line 3: positions must increase"),
        (
            "-4,1\n0,0\n5,1\n",
            "p.csv: does not cover the punch: the rows reach from -4 mm to 5 mm, the punch from -5 mm to 5 mm",
        ),
        ("-5,1\n0,0\n4.9,1\n", "p.csv: does not cover the punch"),
        // Numbers of 32 bits.
        ("-4.9999998,1\n0,0\n4.9999998,1\n", "; they end 2e-7 mm too early"),
        ("-5,1\n0,nan\n5,1\n", "p.csv: line 2: the height is NaN"),
        ("-5,1\n0\n5,1\n", "p.csv: line 2: needs two columns"),
    ] {
        let folder = Folder::with(&problem);
        folder.write("p.csv", csv);
        let stderr = refusal(&folder, "punch.toml:8: punch.profile.csv");
        assert!(stderr.contains(said), "{csv}: {stderr}");
    }
    let folder = Folder::with(&problem);
    assert!(refusal(&folder, "punch.toml:8: punch.profile.csv").contains("p.csv cannot be read"));
    folder.write("p.csv", [b'1', b',', 0xff]);
    let said = "p.csv: line 1: needs two columns";
    let header = "p.csv: a profile needs at least two rows";
    let stderr = refusal(&folder, "punch.toml:8: punch.profile.csv");
    assert!(
        stderr.contains(said) || stderr.contains(header) || stderr.contains("is not a number"),
        "{stderr}"
    );
    for (from, to, field, said) in [
        ("\"mm\"", "\"Pa\"", "punch.profile.x_unit", "unit of length"),
        ("\"mm\"", "5", "punch.profile.x_unit", "is a string"),
        ("x_unit", "x_unt", "punch.profile.x_unt", "did you mean x_unit?"),
        ("\"p.csv\"", "\".\"", "punch.profile.csv", "is a folder"),
    ] {
        let folder = Folder::with(&problem.replace(from, to));
        // Without a unit the positions are metres.
        folder.write("p.csv", "-5,0\n5,0\n");
        let stderr = refusal(&folder, &format!("punch.toml:8: {field}"));
        assert!(stderr.contains(said), "{to}: {stderr}");
    }
}
