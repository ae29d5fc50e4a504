//! Values, the factor of the logarithm and the diagonal.

use fredholm::Error;
use fredholm::kernel::{Kernel, Yukawa};

use super::{kernel, number, numbers, reference, rows};

fn table() -> serde_json::Value {
    serde_json::from_str(include_str!("../data/yukawa_values.json")).unwrap()
}

#[test]
fn values_hold_to_their_last_digits_everywhere() {
    let table = table();
    let mut worst = 0.0f64;
    let mut checked = 0;
    for row in rows(&table["values"]) {
        let row: Vec<f64> = rows(row)[..6].iter().map(number).collect();
        let [m, chi, x, s, distance, exact] = row[..].try_into().unwrap();
        let kernel = Yukawa::new(1.0, chi, m as u32).unwrap();
        let found = kernel.pair(x, s, distance).value;
        assert_eq!(found, kernel.pair(s, x, distance).value);
        // The exponent carries the rounding of chi d.
        let error = (found - exact).abs()
            / exact.abs().max(f64::MIN_POSITIVE)
            / (1.0 + 0.1 * chi * distance);
        worst = worst.max(error);
        checked += 1;
        assert!(
            error < 1e-13,
            "m = {m}, chi = {chi}, {x} {s} {distance}: {found:e} {exact:e} {error:e}"
        );
    }
    assert!(checked > 350, "{checked}");
    println!("{checked} values, largest relative error {worst:e}");
}

#[test]
fn the_factor_of_the_logarithm_is_that_of_mpmath() {
    let table = table();
    let mut checked = 0;
    for row in rows(&table["values"]).iter().filter(|row| !row[6].is_null()) {
        let row: Vec<f64> = rows(row).iter().map(number).collect();
        let [m, chi, x, s, distance, _, exact] = row[..].try_into().unwrap();
        let kernel = Yukawa::new(1.0, chi, m as u32).unwrap();
        // Away from the diagonal it is cut off.
        let logarithm = (s / x).ln().abs();
        if chi * distance > 1e-3 || logarithm * m.max(1.0) > 1e-3 {
            continue;
        }
        let found = kernel.pair(x, s, distance).factor;
        checked += 1;
        assert!((found / exact - 1.0).abs() < 3e-15, "{m} {chi} {x} {s}: {found} {exact}");
    }
    assert!(checked > 100, "{checked}");
}

#[test]
fn the_split_is_smooth_across_the_diagonal() {
    // K - A ln d tends to B with the square of the distance times its logarithm.
    for (chi, m) in [(0.0, 0), (3.0, 1), (100.0, 0), (20.0, 6)] {
        let kernel = Yukawa::new(1.0, chi, m).unwrap();
        let x = 0.37;
        let rest = kernel.split(x, x, 0.0).rest;
        let scale = 1.0 + chi + f64::from(m) / x;
        for distance in [1e-4, 1e-5, 1e-6] {
            // The mean of both sides: the first order drops out.
            let mean = 0.5
                * (kernel.split(x, x + distance, distance).rest
                    + kernel.split(x, x - distance, distance).rest);
            let allowed = 20.0 * (scale * distance).powi(2) / x + 1e-12;
            assert!((mean - rest).abs() < allowed, "{chi} {m} {distance}: {mean} {rest}");
        }
    }
}

#[test]
fn refuses_what_it_cannot_do() {
    for (radius, screening, harmonic, name) in [
        (0.0, 1.0, 0, "radius"),
        (f64::NAN, 1.0, 0, "radius"),
        (1e200, 1.0, 0, "radius"),
        (1.0, -1.0, 0, "screening"),
        (1.0, f64::INFINITY, 0, "screening"),
        (10.0, 1e5, 0, "screening * radius"),
        (1.0, 1.0, 201, "harmonic"),
    ] {
        let error = Yukawa::new(radius, screening, harmonic).unwrap_err();
        assert!(matches!(error, Error::InvalidParameter { name: found, .. } if found == name));
    }
}

#[test]
fn no_values_that_are_no_numbers() {
    let points = [0.0, 1e-320, 1e-200, 1e-30, 1e-3, 0.5, 1.0f64.next_down(), 1.0];
    for (chi, m) in [(0.0, 0), (1e-300, 1), (1.0, 0), (1e5, 0), (1e5, 200), (3.0, 200)] {
        let kernel = Yukawa::new(1.0, chi, m).unwrap();
        for x in points {
            for s in points {
                let value = kernel.value(x, s);
                assert!(value >= 0.0, "{chi} {m} {x} {s}: {value}");
                let split = kernel.split(x, s, (x - s).abs());
                assert!(!split.factor.is_nan() && !split.rest.is_nan(), "{chi} {m} {x} {s}");
                assert!(x == s || s < 1e-300 || x < 1e-300 || value.is_finite());
            }
        }
    }
}

#[test]
fn nonsense_does_not_panic() {
    for (chi, m) in [(0.0, 0), (2.0, 1), (1e5, 200)] {
        let kernel = Yukawa::new(1.0, chi, m).unwrap();
        for x in [f64::NAN, f64::INFINITY, -1.0, 0.0, 1e300] {
            for distance in [f64::NAN, 0.0, 1e-300, 0.5, 1e300, f64::INFINITY] {
                for s in [0.5, x] {
                    let _ = (kernel.pair(x, s, distance), kernel.split(x, s, distance));
                    let _ = (kernel.value(x, s), kernel.value(s, x));
                }
            }
        }
    }
}

#[test]
fn the_centre() {
    let kernel = Yukawa::new(1.0, 3.0, 0).unwrap();
    for s in [1e-8, 0.2, 1.0f64] {
        let exact = std::f64::consts::TAU * (-3.0 * s).exp() / s;
        assert!((kernel.value(0.0, s) / exact - 1.0).abs() < 1e-15);
        assert!((kernel.value(1e-30, s) / exact - 1.0).abs() < 1e-15);
    }
    assert_eq!(Yukawa::new(1.0, 3.0, 2).unwrap().value(0.0, 0.5), 0.0);
}

#[test]
fn the_rest_on_the_diagonal() {
    let table = table();
    let mut worst = 0.0f64;
    for row in rows(&table["diagonal"]) {
        let [m, chi, x, exact] = numbers(row)[..].try_into().unwrap();
        let kernel = Yukawa::new(1.0, chi, m as u32).unwrap();
        let split = kernel.split(x, x, 0.0);
        assert_eq!(split.factor, -2.0 / x);
        let size = 2.0 / x * (1.0 + x.ln().abs()) + exact.abs();
        let error = (split.rest - exact).abs() / size;
        worst = worst.max(error);
        assert!(error < 5e-15, "m = {m}, chi = {chi}, x = {x}: {} {exact}", split.rest);
    }
    println!("largest error {worst:e}");
}

#[test]
fn values_of_the_reference() {
    for entry in rows(&reference()["relations"]) {
        let kernel = kernel(entry);
        for row in rows(&entry["kernel"]) {
            let [x, s, exact] = numbers(row)[..].try_into().unwrap();
            let found = kernel.value(x, s);
            let slack = 1.0 + kernel.screening() * (x - s).abs();
            assert!((found - exact).abs() < 1e-13 * exact * slack, "{x} {s}: {found} {exact}");
        }
    }
}
