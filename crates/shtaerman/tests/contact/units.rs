//! Problem files: units, alternatives and forms that say the same give the same physics.

use crate::contact::support::assert_near;
use shtaerman::{Contact, file};

fn solve(text: &str) -> Contact {
    file::parse(text, "units.toml").unwrap().solve().unwrap()
}

fn assert_same(one: &Contact, other: &Contact) {
    for (found, exact, what) in [
        (other.settlement(), one.settlement(), "settlement"),
        (other.tilt(), one.tilt(), "tilt"),
        (other.force(), one.force(), "force"),
        (other.moment(), one.moment(), "moment"),
        (other.pressure_left(), one.pressure_left(), "left"),
        (other.pressure_middle(), one.pressure_middle(), "mid"),
        (other.pressure_right(), one.pressure_right(), "right"),
        (other.stiffness().force_settlement, one.stiffness().force_settlement, "c11"),
        (other.stiffness().moment_tilt, one.stiffness().moment_tilt, "c22"),
    ] {
        assert_near(found / exact, 1.0, 1e-10, what);
    }
}

const IMPERIAL: &str = r#"
[foundation]
young_modulus = "29e6 psi"
poisson_ratio = 0.3
roughness = "3e-9 in/psi"
[punch]
half_width = "0.2 in"
profile = "x^2/(2*0.8)"
[load]
force = "4500 lbf/in"
moment = "60 lbf*in/in"
[solver]
contact = "bilateral"
n = 100
"#;

/// The same in SI, by the definitions of inch and pound-force.
fn imperial_in_si() -> String {
    let (inch, pound) = (0.0254, 4.448_221_615_260_5);
    let psi = pound / (inch * inch);
    format!(
        "[foundation]\nyoung_modulus = {:e}\npoisson_ratio = 0.3\nroughness = {:e}\n\
         [punch]\nhalf_width = {:e}\nprofile = \"x^2/(2*0.8)\"\n\
         [load]\nforce = {:e}\nmoment = {:e}\n[solver]\ncontact = \"bilateral\"\nn = 100",
        29e6 * psi,
        3e-9 * inch / psi,
        0.2 * inch,
        4500.0 * pound / inch,
        60.0 * pound
    )
}

#[test]
fn imperial_and_si_give_the_same_physics() {
    assert_same(&solve(&imperial_in_si()), &solve(IMPERIAL));
}

const STEEL: &str = r#"
[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.25e-14 m/Pa"
[punch]
half_width = "5 mm"
profile = "x^2/(2*0.8)"
[load]
force = "0.8 MN/m"
moment = "160 N"
[solver]
contact = "bilateral"
n = 100
"#;

#[test]
fn one_quantity_written_in_many_ways_is_one_quantity() {
    let reference = solve(STEEL);
    for (written, instead) in [
        ("\"200 GPa\"", "2e11"),
        ("\"200 GPa\"", "\"200000 N/mm^2\""),
        ("roughness = \"1.25e-14 m/Pa\"", "subgrade_modulus = \"80 TPa/m\""),
        ("roughness = \"1.25e-14 m/Pa\"", "roughness = \"0.0125 um/MPa\""),
        ("\"5 mm\"", "\"0.5 cm\""),
        ("\"x^2/(2*0.8)\"", "\"(a*xi)^2/1.6\""),
        ("\"x^2/(2*0.8)\"", "\"0.625*x*x\""),
        ("\"0.8 MN/m\"", "\"800 N/mm\""),
        ("moment = \"160 N\"", "moment = \"160 N*m/m\""),
        ("moment = \"160 N\"", "eccentricity = \"0.2 mm\""),
    ] {
        assert!(STEEL.contains(written), "{written}");
        assert_same(&reference, &solve(&STEEL.replace(written, instead)));
    }
}

#[test]
fn overrides_say_what_the_file_would_say() {
    let overrides = ["load.force=\"1 MN/m\"", "load.eccentricity=\"1 mm\"", "solver.n=80"];
    let overridden = file::from_bytes(
        STEEL.as_bytes(),
        "units.toml",
        std::path::Path::new(""),
        &overrides.map(str::to_owned),
    );
    let written = STEEL
        .replace("0.8 MN/m", "1 MN/m")
        .replace("moment = \"160 N\"", "eccentricity = \"1 mm\"")
        .replace("n = 100", "n = 80");
    assert_same(&solve(&written), &overridden.unwrap().solve().unwrap());
}

#[test]
fn theta0_and_lambda0_state_the_same_dimensionless_problem() {
    let text = |parameter: &str| {
        format!(
            "[dimensionless]\n{parameter}\nprofile = \"xi^4 - xi/2\"\nforce = 1.7\nmoment = -0.31\n\
             [solver]\ncontact = \"bilateral\"\nn = 64"
        )
    };
    // nu = 0.25: theta0 = 15/(8 pi) lambda0, sec. 5
    let theta0 = 15.0 / (8.0 * std::f64::consts::PI) * 20.0;
    let one = solve(&text(&format!("theta0 = {theta0}")));
    assert_same(&one, &solve(&text("lambda0 = 20\npoisson_ratio = 0.25")));
}

#[test]
fn settlement_and_tilt_come_back_through_a_file() {
    let first = solve(STEEL);
    let prescribed = STEEL
        .replace(
            "force = \"0.8 MN/m\"",
            &format!("settlement = \"{} um\"", first.settlement() * 1e6),
        )
        .replace("moment = \"160 N\"", &format!("tilt = {}", first.tilt()));
    assert_same(&first, &solve(&prescribed));
}
