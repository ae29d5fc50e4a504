//! A measured profile says the same as the expression it was sampled from.

use std::path::{Path, PathBuf};

use crate::contact::support::assert_near;
use shtaerman::{Contact, file};

/// A folder of its own for each test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// `x,f` rows of `f` (metres in metres) at `count` points from -5.2 mm to 5.2 mm, in units of `x_unit`, `f_unit`.
fn sampled(f: impl Fn(f64) -> f64, count: usize, x_unit: f64, f_unit: f64) -> String {
    let row = |i: usize| {
        let x = 5.2e-3 * (2.0 * i as f64 / (count - 1) as f64 - 1.0);
        format!("{:e},{:e}\n", x / x_unit, f(x) / f_unit)
    };
    (0..count).map(row).collect()
}

fn solve(folder: &Path, profile: &str) -> Contact {
    let text = format!(
        "[foundation]\nyoung_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nroughness = \"1.2e-14 m/Pa\"\n\
         [punch]\nhalf_width = \"5 mm\"\nprofile = {profile}\n[load]\nforce = \"0.8 MN/m\"\nmoment = \"300 N\"\n\
         [solver]\ncontact = \"bilateral\"\nn = 100"
    );
    file::from_bytes(text.as_bytes(), "measured.toml", folder, &[]).unwrap().solve().unwrap()
}

fn largest_difference(one: &Contact, other: &Contact) -> f64 {
    let difference = |i: i32| {
        let x = 5e-3 * f64::from(i) / 50.0;
        (one.pressure(x).unwrap() - other.pressure(x).unwrap()).abs()
    };
    (-50..=50).map(difference).fold(0.0, f64::max) / one.mean_pressure()
}

fn parabola(x: f64) -> f64 {
    x * x / 1.6
}

#[test]
fn a_sampled_parabola_is_the_parabola() {
    let folder = folder("parabola");
    let exact = solve(&folder, "\"x^2/(2*0.8)\"");
    for (count, x_unit, f_unit, keys) in [
        (21, 1.0, 1.0, ""),
        (21, 1e-3, 1e-6, ", x_unit = \"mm\", f_unit = \"um\""),
        (401, 0.0254, 1e-9, ", x_unit = \"in\", f_unit = \"nm\""),
    ] {
        let name = format!("{count}-{x_unit}.csv");
        std::fs::write(folder.join(&name), sampled(parabola, count, x_unit, f_unit)).unwrap();
        let measured = solve(&folder, &format!("{{ csv = \"{name}\"{keys} }}"));
        // A spline has a parabola exactly; what is left is the rounding of its pieces.
        let difference = largest_difference(&exact, &measured);
        assert!(difference < 1e-9, "{count} points{keys}: {difference:e}");
        assert_near(measured.settlement() / exact.settlement(), 1.0, 1e-11, "settlement");
        assert_near(measured.tilt() / exact.tilt(), 1.0, 1e-11, "tilt");
    }
}

#[test]
fn flip_reverses_the_sign_of_the_heights() {
    let folder = folder("flip");
    std::fs::write(folder.join("up.csv"), sampled(parabola, 41, 1e-3, 1e-6)).unwrap();
    std::fs::write(folder.join("down.csv"), sampled(|x| -parabola(x), 41, 1e-3, 1e-6)).unwrap();
    let units = "x_unit = \"mm\", f_unit = \"um\"";
    let up = solve(&folder, &format!("{{ csv = \"up.csv\", {units} }}"));
    let flipped = solve(&folder, &format!("{{ csv = \"down.csv\", {units}, flip = true }}"));
    assert_eq!(largest_difference(&up, &flipped), 0.0);
    let hollow = solve(&folder, &format!("{{ csv = \"down.csv\", {units} }}"));
    let exact = solve(&folder, "\"-x^2/(2*0.8)\"");
    assert!(largest_difference(&exact, &hollow) < 1e-9);
}

#[test]
fn a_sampled_curve_tends_to_the_curve_as_the_fourth_power_of_the_spacing() {
    let folder = folder("curve");
    let exact = solve(&folder, "\"2e-6*cos(600*x)\"");
    let error = |count: usize| {
        let name = format!("{count}.csv");
        let rows = sampled(|x| 2e-6 * (600.0 * x).cos(), count, 1.0, 1.0);
        std::fs::write(folder.join(&name), rows).unwrap();
        largest_difference(&exact, &solve(&folder, &format!("{{ csv = \"{name}\" }}")))
    };
    let errors = [error(21), error(41), error(81)];
    for pair in errors.windows(2) {
        assert!((pair[0] / pair[1]).log2() > 3.5, "{errors:?}");
    }
    assert!(errors[2] < 1e-4, "{errors:?}");
}
