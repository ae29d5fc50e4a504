//! Narrow contacts far from the middle, which a search from the whole base would have to come to by their own lengths, and edges next to a corner.

use shtaerman::{Contact, file};

const GRADED: &str = "grading_exponent = 0.37\ngrading_modulus = 1e9";
const PLAIN: &str = "young_modulus = 1e10";
const PLANE: &str = "half_width = 5e-3";
const PAIR: &str = "geometry = \"pair\"\nouter_half_width = 5e-3\ninner_half_gap = 1e-3";
const ROW: &str = "geometry = \"periodic\"\nperiod = 1.31e-2\nhalf_width = 5e-3";

fn solved(ground: &str, geometry: &str, profile: &str, load: &str) -> Contact {
    let text = format!(
        "[foundation]\n{ground}\npoisson_ratio = 0.3\nroughness = 0\n[punch]\n{geometry}\nprofile = \"{profile}\"\n[load]\n{load}\n"
    );
    file::parse(&text, "test").unwrap().solve().map_err(|error| format!("{text}{error}")).unwrap()
}

/// A parabola `(x - c)^2/(2 R)` under a force `P` and a moment `M` touches about `M/P`, whatever the ground, and so leans by `(c - M/P)/R`.
#[test]
fn a_light_contact_lies_about_its_force_and_leans_as_the_base_does_there() {
    let (radius, apex, arm) = (2.0, 1.3e-3, -3.1e-3);
    for ground in [GRADED, PLAIN] {
        for geometry in [PLANE, PAIR] {
            for force in [1e2, 1.0, 1e-2, 1e-4] {
                let profile = format!("(x - {apex})^2/(2*{radius})");
                let load = format!("force = {force}\nmoment = {}", arm * force);
                let contact = solved(ground, geometry, &profile, &load);
                let (stated, exact) = (contact.error().unwrap(), (apex - arm) / radius);
                // The moment is rounded, too.
                let allowed = stated.tilt + 4.0 * f64::EPSILON * exact;
                let off = (contact.tilt() - exact).abs();
                assert!(off <= allowed, "{geometry} {force}: {off:e} for {:e}", stated.tilt);
                let [left, right] = contact.zones()[0];
                let width = right - left;
                assert!((0.5 * (left + right) - arm).abs() < 1e-9 * width, "{geometry} {force}");
                assert!(allowed < 1e-4 * width / radius, "{geometry} {force}: {allowed:e}");
            }
        }
    }
}

/// By the settlement that a force leads to, there is that force.
#[test]
fn narrow_zones_are_found_by_their_settlement() {
    for (ground, geometry) in
        [(PLAIN, PLANE), (PLAIN, PAIR), (PLAIN, ROW), (GRADED, PLANE), (GRADED, PAIR)]
    {
        for apex in [3e-3, 2.7e-3, -1.2e-3] {
            let profile = format!("(x - {apex})^2/4");
            for force in [1e3, 10.0, 0.3] {
                let load = format!("force = {force}\ntilt = 0");
                let by_force = solved(ground, geometry, &profile, &load);
                let load = format!("settlement = {:e}\ntilt = 0", by_force.settlement());
                let found = solved(ground, geometry, &profile, &load);
                let known = by_force.error().unwrap().settlement;
                let rounding = f64::EPSILON * by_force.settlement().abs();
                let stiffness = found.stiffness().force_settlement;
                let stated = found.error().unwrap().force + stiffness * (known + rounding);
                let off = (found.force() - force).abs();
                assert!(off <= stated, "{geometry} {apex} {force}: {off:e} for {stated:e}");
                assert!(stated < 1e-7 * force, "{geometry} {apex} {force}: {stated:e}");
            }
        }
    }
}

/// All forces about that with which the edges reach the corners.
#[test]
fn edges_reach_corners_on_graded_ground() {
    let profile = "x^2/2";
    let width = |exponent: f64, force: f64| {
        let ground = format!("grading_exponent = {exponent}\ngrading_modulus = 1e10");
        solved(&ground, PLANE, profile, &format!("force = {force}\nmoment = 0")).contact_width()
    };
    for exponent in [0.1, 0.4, 0.75] {
        // The width goes as P^(1/(2 + mu)) until then.
        let power = 1.0 / (2.0 + exponent);
        let full = (1e-2 / width(exponent, 1.0)).powf(1.0 / power);
        for share in [-1e-3, -1e-4, -1e-5, -1e-6, -1e-8, 1e-8, 1e-6, 1e-3] {
            let exact = 1e-2 * (1.0f64 + share).powf(power).min(1.0);
            let found = width(exponent, full * (1.0 + share));
            assert!((found / exact - 1.0).abs() < 1e-10, "{exponent} {share}: {found}");
        }
    }
}

/// A base with a constant is pressed in by a settlement that is hardly more: what the rounding of both decimal numbers leaves is stated.
#[test]
fn rounding_of_decimal_numbers_is_stated() {
    let disk = "geometry = \"circular\"\nradius = 5e-3";
    let numbers = [
        ["0.000928", "0.00092800001", "1e-11"],
        ["0.0123", "0.0123000007", "7e-10"],
        ["7.1e-5", "7.100003e-5", "3e-11"],
    ];
    for geometry in [PLANE, disk] {
        for [level, settlement, depth] in numbers {
            let variable = if geometry == disk { "r" } else { "x" };
            let by = |constant: &str, settlement: &str| {
                let profile = format!("{variable}^2/4{constant}");
                solved(PLAIN, geometry, &profile, &format!("settlement = {settlement}\ntilt = 0"))
            };
            let [plain, raised] = [by("", depth), by(&format!(" + {level}"), settlement)];
            let [one, other] = [&plain, &raised].map(|contact| contact.error().unwrap());
            let values = [
                (plain.force(), raised.force(), one.force + other.force),
                (plain.contact_width(), raised.contact_width(), 4.0 * other.zones.unwrap()),
                (plain.peak_pressure(), raised.peak_pressure(), one.pressure + other.pressure),
            ];
            for (exact, found, stated) in values {
                let off = (found - exact).abs();
                assert!(off <= stated, "{geometry} {level}: {off:e} for {stated:e} of {exact:e}");
                assert!(stated < 1e-3 * exact, "{geometry} {level}: {stated:e} of {exact:e}");
            }
        }
    }
}
