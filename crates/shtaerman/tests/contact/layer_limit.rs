//! The pure layer, `theta0 -> 0`: `p = (delta - alpha x - f)/chi`, exact at `theta0 = 0`, with its first-order term beyond.

use crate::contact::support::{
    assert_near, force_and_moment, integral, settlement_and_tilt, solve,
};

type Base = fn(f64) -> f64;

const PLACES: [f64; 7] = [-1.0, -0.7, -0.2, 0.0, 0.4, 0.9, 1.0];

#[test]
fn a_layer_under_force_and_moment_is_exact() {
    let (force, moment) = (1.7, -0.31);
    // f0, its mean over the base, and int xi f0
    let cases: [(&str, Base, f64, f64); 4] = [
        ("0", |_| 0.0, 0.0, 0.0),
        ("3*xi^2", |xi| 3.0 * xi * xi, 1.0, 0.0),
        ("xi^3 - 2", |xi| xi.powi(3) - 2.0, -2.0, 0.4),
        ("exp(xi)", f64::exp, 1f64.sinh(), 2.0 / 1f64.exp()),
    ];
    for (text, base, mean, first_moment) in cases {
        let contact = solve(0.0, text, force_and_moment(force, moment), 16);
        let settlement = 0.5 * force + mean;
        let tilt = -1.5 * (moment + first_moment);
        assert_near(contact.dimensionless().settlement(), settlement, 1e-14, text);
        assert_near(contact.dimensionless().tilt(), tilt, 1e-14, text);
        for xi in PLACES {
            let exact = settlement - tilt * xi - base(xi);
            assert_near(contact.dimensionless().pressure(xi).unwrap(), exact, 1e-14, text);
        }
        let [[c11, c12], [_, c22]] = contact.dimensionless().stiffness().matrix();
        assert_near(c11, 2.0, 1e-15, text);
        assert_near(c22, 2.0 / 3.0, 1e-15, text);
        assert_eq!(c12, 0.0, "{text}");
    }
}

#[test]
fn flat_and_parabolic_punch_on_a_layer_have_the_textbook_pressure() {
    // p = P/2a + 3 M x/(2 a^3) + (a^2/3 - x^2)/(2 R chi), chi so large that theta0 = 4e-12
    let text = |profile: &str| {
        format!(
            "[foundation]\nyoung_modulus = 2e11\npoisson_ratio = 0.3\nroughness = 3.6e-3\n\
             [punch]\nhalf_width = 5e-3\nprofile = \"{profile}\"\n[load]\nforce = 8e5\nmoment = 900\n\
             [solver]\ncontact = \"bilateral\"\nn = 8"
        )
    };
    let (a, force, moment, chi): (f64, f64, f64, f64) = (5e-3, 8e5, 900.0, 3.6e-3);
    for (profile, radius) in [("0", f64::INFINITY), ("x^2/(2*1e-10)", 1e-10)] {
        let contact =
            shtaerman::file::parse(&text(profile), "layer.toml").unwrap().solve().unwrap();
        for xi in PLACES {
            let x = a * xi;
            let exact = force / (2.0 * a)
                + 3.0 * moment * x / (2.0 * a.powi(3))
                + (a * a / 3.0 - x * x) / (2.0 * radius * chi);
            assert_near(contact.pressure(x).unwrap() / exact, 1.0, 1e-10, profile);
        }
    }
}

#[test]
fn a_flat_punch_on_a_layer_presses_everywhere_within_the_middle_third() {
    for (eccentricity, pulls) in [(0.333, false), (-0.333, false), (0.334, true), (-0.334, true)] {
        let contact = solve(0.0, "0", force_and_moment(1.0, eccentricity), 8);
        assert_eq!(!contact.tension().is_empty(), pulls, "e = {eccentricity}");
    }
    // Beyond it the zero of p = 1/2 + 3 e xi/2 is where the tension begins.
    let contact = solve(0.0, "0", force_and_moment(1.0, 0.5), 8);
    let [[left, right]] = contact.tension()[..] else { panic!("one zone of tension") };
    assert_eq!(left, -1.0);
    assert_near(right, -2.0 / 3.0, 1e-14, "right end");
}

#[test]
fn a_crowned_punch_on_a_layer_stops_pressing_at_the_edges_where_the_book_says() {
    // a^3 = 3 R chi P/2: without dimensions k = 3 P0/4 for f0 = k xi^2.
    assert!(solve(0.0, "0.7499*xi^2", force_and_moment(1.0, 0.0), 8).tension().is_empty());
    let pulling = solve(0.0, "0.7501*xi^2", force_and_moment(1.0, 0.0), 8).tension();
    assert!(matches!(pulling[..], [[-1.0, _], [_, 1.0]]), "{pulling:?}");
}

/// `int ln(1/|xi - eta|) deta` and `int eta ln(1/|xi - eta|) deta`.
fn level_potential(xi: f64) -> f64 {
    let end = |d: f64| if d == 0.0 { 0.0 } else { d * d.ln() };
    2.0 - end(1.0 - xi) - end(1.0 + xi)
}

fn tilted_potential(xi: f64) -> f64 {
    if xi.abs() == 1.0 {
        return xi;
    }
    xi + 0.5 * (1.0 - xi * xi) * ((1.0 + xi) / (1.0 - xi)).ln()
}

#[test]
fn the_first_order_term_in_theta0_is_right() {
    // What remains after the first-order term falls as theta0^2; the degree leaves about 1e-6 theta0 at the edges.
    let remainder = |theta0: f64| {
        let (settlement, tilt) = (1.0, -0.6);
        let contact = solve(theta0, "0", settlement_and_tilt(settlement, tilt), 400);
        let pressure = PLACES.map(|xi| {
            let first = settlement * level_potential(xi) - tilt * tilted_potential(xi);
            (contact.dimensionless().pressure(xi).unwrap()
                - (settlement - tilt * xi - theta0 * first))
                .abs()
        });
        let [[c11, _], [_, c22]] = contact.dimensionless().stiffness().matrix();
        let level = (c11 - (2.0 - (6.0 - 4.0 * 2f64.ln()) * theta0)).abs();
        let tilted = (c22 - (2.0 / 3.0 - theta0)).abs();
        [pressure.into_iter().fold(0.0, f64::max), level, tilted]
    };
    for (coarse, fine) in remainder(1e-2).into_iter().zip(remainder(1e-3)) {
        let ratio = coarse / fine;
        assert!((80.0..105.0).contains(&ratio), "{coarse:e} / {fine:e} = {ratio}");
    }
}

#[test]
fn the_error_of_the_layer_itself_is_proportional_to_theta0() {
    let profile = |xi: f64| 0.3 * xi * xi;
    let error = |theta0: f64| {
        let contact = solve(theta0, "0.3*xi^2", force_and_moment(1.0, 0.1), 200);
        let layer = |xi: f64| 0.5 + 0.15 * xi + 0.1 - profile(xi);
        integral(|xi| (contact.dimensionless().pressure(xi).unwrap() - layer(xi)).powi(2)).sqrt()
    };
    let errors = [1e-3, 1e-4, 1e-5].map(error);
    for pair in errors.windows(2) {
        assert_near(pair[0] / pair[1], 10.0, 0.05, "ratio of errors a decade apart");
    }
}
