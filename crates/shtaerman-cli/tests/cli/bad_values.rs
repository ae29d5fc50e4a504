//! Problem files with a value out of range, of the wrong dimension or not finite.

use crate::cli::bad_input::{check, refusal};
use crate::cli::support::{DIMENSIONLESS, Folder, PHYSICAL, UNILATERAL};

#[test]
fn values_out_of_range() {
    check(&[
        (
            PHYSICAL,
            "\"5 mm\"",
            "\"-5 mm\"",
            "punch.toml:7: punch.half_width",
            "is -5 mm: must be finite and greater than zero",
        ),
        (PHYSICAL, "\"5 mm\"", "0", "punch.toml:7: punch.half_width", "greater than zero"),
        (
            PHYSICAL,
            "half_width = \"5 mm\"",
            "geometry = \"circular\"\nradius = \"-5 mm\"",
            "punch.toml:8: punch.radius",
            "punch.radius: is -5 mm: must be finite and greater than zero",
        ),
        (
            PHYSICAL,
            "\"200 GPa\"",
            "\"-200 GPa\"",
            "punch.toml:2: foundation.young_modulus",
            "is -200 GPa",
        ),
        (
            PHYSICAL,
            "\"200 GPa\"",
            "0",
            "punch.toml:2: foundation.young_modulus",
            "greater than zero",
        ),
        (
            PHYSICAL,
            "= 0.3",
            "= 0.51",
            "punch.toml:3: foundation.poisson_ratio",
            "greater than -1 and at most 0.5",
        ),
        (
            PHYSICAL,
            "= 0.3",
            "= -1",
            "punch.toml:3: foundation.poisson_ratio",
            "greater than -1 and at most 0.5",
        ),
        (
            PHYSICAL,
            "\"1.2e-14 m/Pa\"",
            "\"-1 um/MPa\"",
            "punch.toml:4: foundation.roughness",
            "is -1 µm/MPa: must be zero (a smooth surface) or greater",
        ),
        (
            PHYSICAL,
            "\"1.2e-14 m/Pa\"",
            "{ coefficient = 1e-9, exponent = 1.5 }",
            "punch.toml:4: foundation.roughness.exponent",
            "greater than 0 and at most 1",
        ),
        (
            PHYSICAL,
            "\"1.2e-14 m/Pa\"",
            "{ coefficient = 0, exponent = 0.5 }",
            "punch.toml:4: foundation.roughness.coefficient",
            "must be finite and greater than zero",
        ),
        (
            PHYSICAL,
            "\"1.2e-14 m/Pa\"",
            "{ displacement = \"1 um\", pressure = 0, exponent = 0.5 }",
            "punch.toml:4: foundation.roughness.pressure",
            "must be greater than zero",
        ),
        (
            PHYSICAL,
            "roughness = \"1.2e-14 m/Pa\"",
            "subgrade_modulus = 0",
            "punch.toml:4: foundation.subgrade_modulus",
            "greater",
        ),
        (
            PHYSICAL,
            "[punch]",
            "[body]\nyoung_modulus = -1\npoisson_ratio = 0\n[punch]",
            "punch.toml:7: body.young_modulus",
            "greater",
        ),
        (
            DIMENSIONLESS,
            "13.0",
            "-1.0",
            "punch.toml:2: dimensionless.theta0",
            "is -1: must be finite and not negative",
        ),
        (
            DIMENSIONLESS,
            "theta0 = 13.0",
            "lambda0 = -1\npoisson_ratio = 0",
            "punch.toml:2: dimensionless.lambda0",
            "not negative",
        ),
        (
            DIMENSIONLESS,
            "theta0 = 13.0",
            "lambda0 = 1\npoisson_ratio = 0.6",
            "punch.toml:3: dimensionless.poisson_ratio",
            "at most 0.5",
        ),
        // Beyond double precision only together.
        (
            PHYSICAL,
            "\"200 GPa\"",
            "1e-300",
            "punch.toml:7: punch.half_width",
            "theta0 = inf: must be representable",
        ),
        (
            PHYSICAL,
            "half_width",
            "geometry = \"circular\"\nradius",
            "punch.toml:17: solver.n",
            "asks for the degenerate kernel",
        ),
        (
            PHYSICAL,
            "n = 40",
            "method = \"spectral\"\nn = 40\n[foundation.coating]\npoisson_ratio = 0.3\nthickness = 1e-3\nyoung_modulus = 1e9",
            "punch.toml:16: solver.method",
            "here the ground is layered",
        ),
        (
            PHYSICAL,
            "young_modulus = \"200 GPa\"",
            "grading_exponent = 0.5\ngrading_modulus = 1e9",
            "punch.toml:17: solver.n",
            "here the ground is graded",
        ),
        (PHYSICAL, "n = 40", "n = 0", "punch.toml:16: solver.n", "a whole number from 1"),
        (PHYSICAL, "n = 40", "n = -3", "punch.toml:16: solver.n", "got -3"),
        (PHYSICAL, "n = 40", "n = \"many\"", "punch.toml:16: solver.n", "got the string \"many\""),
        (
            PHYSICAL,
            "n = 40",
            "n = 40.0",
            "punch.toml:16: solver.n",
            "is a whole number, got the number 40.0",
        ),
        (
            PHYSICAL,
            "n = 40",
            "n = 99999999999999999999",
            "punch.toml:16: solver.n",
            "beyond 64-bit whole numbers",
        ),
        (
            PHYSICAL,
            "\"bilateral\"",
            "\"unilateral\"",
            "punch.toml:16: solver.n",
            "belongs to contact = \"bilateral\"",
        ),
        (
            UNILATERAL,
            "\"0.8 MN/m\"",
            "0",
            "punch.toml:11: load.force",
            "greater than zero in unilateral contact",
        ),
        (
            UNILATERAL,
            "\"100 N\"",
            "\"4 kN\"",
            "punch.toml:12: load.moment",
            "tips the punch over: its magnitude must be less than P a = 4000",
        ),
        (
            UNILATERAL,
            "moment = \"100 N\"",
            "eccentricity = \"-5 mm\"",
            "punch.toml:12: load.eccentricity",
            "must be less than a = 0.005",
        ),
        (
            PHYSICAL,
            "half_width = \"5 mm\"",
            "geometry = \"pair\"\nouter_half_width = \"5 mm\"\ninner_half_gap = \"5 mm\"",
            "punch.toml:9: punch.inner_half_gap",
            "less than outer_half_width",
        ),
        (
            PHYSICAL,
            "half_width = \"5 mm\"",
            "geometry = \"periodic\"\nhalf_width = \"5 mm\"\nperiod = \"9 mm\"",
            "punch.toml:9: punch.period",
            "at least twice half_width",
        ),
        (
            PHYSICAL,
            "half_width = \"5 mm\"",
            "geometry = \"disk\"\nradius = 1",
            "punch.toml:7: punch.geometry",
            "one of \"plane\", \"pair\", \"periodic\", \"circular\"",
        ),
        (
            PHYSICAL,
            "\"bilateral\"",
            "\"bilatral\"",
            "punch.toml:15: solver.contact",
            "did you mean \"bilateral\"?",
        ),
        (
            PHYSICAL,
            "n = 40",
            "method = \"magic\"",
            "punch.toml:16: solver.method",
            "is one of \"auto\", \"spectral\", \"sinc\"",
        ),
    ]);
}

/// What would turn a base that fills its period is named as it was written, on a rough surface and on a smooth one.
#[test]
fn a_wave_does_not_turn() {
    let wave = "geometry = \"periodic\"\nperiod = \"10 mm\"";
    let wave = UNILATERAL.replace("half_width = \"5 mm\"", wave);
    let smooth = wave.replace("\"1.2e-14 m/Pa\"", "0");
    for problem in [&wave, &smooth] {
        for (load, place) in [
            ("moment = \"100 N\"", "punch.toml:13: load.moment"),
            ("eccentricity = \"1 um\"", "punch.toml:13: load.eccentricity"),
            ("tilt = 1e-6", "punch.toml:13: load.tilt"),
        ] {
            let folder = Folder::with(&problem.replace("moment = \"100 N\"", load));
            let stderr = refusal(&folder, place);
            assert!(stderr.contains("zero where the base fills the period"), "{stderr}");
        }
    }
}

#[test]
fn units() {
    check(&[
        (
            PHYSICAL,
            "\"5 mm\"",
            "\"5 Pa\"",
            "punch.toml:7: punch.half_width",
            "is a length (like \"5 mm\"), got Pa, a pressure",
        ),
        (
            PHYSICAL,
            "\"200 GPa\"",
            "\"200 N\"",
            "punch.toml:2: foundation.young_modulus",
            "got N, a force or a moment per length",
        ),
        (
            PHYSICAL,
            "\"1.2e-14 m/Pa\"",
            "\"1.2e-14 Pa/m\"",
            "punch.toml:4: foundation.roughness",
            "got Pa/m",
        ),
        (
            PHYSICAL,
            "\"0.8 MN/m\"",
            "\"0.8 MN\"",
            "punch.toml:11: load.force",
            "is a force per length",
        ),
        (PHYSICAL, "\"100 N\"", "\"100 mm\"", "punch.toml:12: load.moment", "got mm, a length"),
        (
            PHYSICAL,
            "moment = \"100 N\"",
            "tilt = \"1 mm\"",
            "punch.toml:12: load.tilt",
            "got mm, a length",
        ),
        (
            PHYSICAL,
            "= 0.3",
            "= \"0.3 m\"",
            "punch.toml:3: foundation.poisson_ratio",
            "got m, a length",
        ),
        (PHYSICAL, "\"5 mm\"", "\"5 mmm\"", "punch.toml:7: punch.half_width", "mmm"),
        (
            PHYSICAL,
            "\"5 mm\"",
            "\"five mm\"",
            "punch.toml:7: punch.half_width",
            "does not begin with a number",
        ),
        (PHYSICAL, "\"5 mm\"", "true", "punch.toml:7: punch.half_width", "got"),
        (DIMENSIONLESS, "13.0", "\"13 m\"", "punch.toml:2: dimensionless.theta0", "is a number"),
        (
            DIMENSIONLESS,
            "1.7",
            "\"1.7 N\"",
            "punch.toml:4: dimensionless.force",
            "got N, a force or a moment per length",
        ),
    ]);
}

#[test]
fn not_finite() {
    for value in ["nan", "inf", "-inf", "1e999", "\"nan\"", "\"inf\"", "\"1e999\""] {
        for (problem, line, field, from) in [
            (PHYSICAL, 2, "foundation.young_modulus", "\"200 GPa\""),
            (PHYSICAL, 3, "foundation.poisson_ratio", "0.3"),
            (PHYSICAL, 4, "foundation.roughness", "\"1.2e-14 m/Pa\""),
            (PHYSICAL, 7, "punch.half_width", "\"5 mm\""),
            (PHYSICAL, 11, "load.force", "\"0.8 MN/m\""),
            (PHYSICAL, 12, "load.moment", "\"100 N\""),
            (DIMENSIONLESS, 2, "dimensionless.theta0", "13.0"),
            (DIMENSIONLESS, 4, "dimensionless.force", "1.7"),
        ] {
            let folder = Folder::with(&problem.replace(from, value));
            refusal(&folder, &format!("punch.toml:{line}: {field}"));
        }
    }
    check(&[
        (
            PHYSICAL,
            "\"5 mm\"",
            "\"nan m\"",
            "punch.toml:7: punch.half_width",
            "is nan, a finite number was expected",
        ),
        (PHYSICAL, "\"x^2 / (2*20)\"", "nan", "punch.toml:8: punch.profile", "is nan"),
        (PHYSICAL, "\"x^2 / (2*20)\"", "\"1e999\"", "punch.toml:8: punch.profile", "1e999"),
        (PHYSICAL, "n = 40", "n = nan", "punch.toml:16: solver.n", "nan"),
    ]);
}
