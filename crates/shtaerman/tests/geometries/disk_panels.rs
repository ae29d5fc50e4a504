//! Disks on panels against closed forms and against collocation: kinks that are next to none bend a base so often that panels are taken, and change nothing else.

use std::f64::consts::PI;

use shtaerman::{Contact, Errors, Geometry, MethodName};

use crate::geometries::support::{assert_near, pressed, solve};

/// So many kinks that a base with them is for panels, and so faint that nothing else shows them.
fn with_kinks(profile: &str) -> String {
    let kinks: Vec<String> =
        (0..17).map(|k| format!("abs(xi - {:.3})", 0.05 + 0.055 * f64::from(k))).collect();
    format!("{profile} + 1e-18*({})", kinks.join(" + "))
}

#[test]
fn a_pressure_made_up_comes_back() {
    // As in `power.rs`: v = q, q = 1 - y^2, and p = q^(1/kappa) with the potential of (1 - y^2)^(3/2); of (1 - y^2)^(5/2) with P_2, P_4 and P_6 of sqrt q, q^3 = 1/7 + (10/21) P_2 + (24/77) P_4 + (16/231) P_6.
    let b: f64 = 0.8;
    let lambda = |gamma: f64, factorial: f64| 0.5 * PI * (gamma / factorial).powi(2);
    let l = [lambda(1.0, 1.0), lambda(0.5, 1.0), lambda(0.75, 2.0), lambda(1.875, 6.0)];
    let q = format!("(1 - (xi/{b})^2)");
    let legendre = [
        "1".to_owned(),
        format!("(3*{q} - 1)/2"),
        format!("(35*{q}^2 - 30*{q} + 3)/8"),
        format!("(231*{q}^3 - 315*{q}^2 + 105*{q} - 5)/16"),
    ];
    for (exponent, shares, volume) in [
        (2.0 / 3.0, [1.0 / 5.0, 4.0 / 7.0, 8.0 / 35.0, 0.0], 1.0 / 5.0),
        (2.0 / 5.0, [1.0 / 7.0, 10.0 / 21.0, 24.0 / 77.0, 16.0 / 231.0], 1.0 / 7.0),
    ] {
        let terms = (1..4).map(|n| format!("{}*{}", shares[n] * l[n], legendre[n]));
        let potential = terms.collect::<Vec<_>>().join(" + ");
        for theta in [0.1, 3.0, 20.0] {
            let scale = PI * theta * b;
            let away = format!("{}*max(abs(xi) - {}, 0)^2", 1e3 * (1.0 + theta), b + 0.01);
            let profile = with_kinks(&format!("1 - {q} - {scale}*({potential}) + {away}"));
            let force = 2.0 * PI * b * b * volume;
            let contact = solve((Geometry::Circular, theta, exponent), &profile, pressed(force));
            assert_eq!(contact.method().name, MethodName::Panels);
            let stated = contact.dimensionless().error().unwrap();
            let beside = stated.zones.unwrap();
            assert!(beside < 1e-10, "{beside:e}");
            assert!(contact.relative_error() < 1e-11 * (1.0 + theta));
            assert_near(contact.dimensionless().zones()[0][1], b, beside);
            let settlement = 1.0 + scale * shares[0] * l[0];
            assert_near(contact.dimensionless().settlement(), settlement, stated.settlement);
            for xi in [-0.7f64, -0.3, 0.0, 1e-9, 0.5, 0.79] {
                let exact = (1.0 - (xi / b).powi(2)).powf(1.0 / exponent);
                let found = contact.dimensionless().pressure(xi).unwrap();
                assert_near(found, exact, stated.pressure);
            }
        }
    }
}

#[test]
fn panels_agree_with_collocation() {
    for profile in ["2*xi^2", "0.5*xi^2 + 0.2*cos(9*pi*xi)", "0.3*abs(xi) + 0.1*cos(5*pi*xi)"] {
        for (theta, exponent) in [(1.0, 1.0), (100.0, 1.0), (3.0, 0.5), (100.0, 0.7)] {
            let body = (Geometry::Circular, theta, exponent);
            let known = solve(body, profile, pressed(0.3));
            let found = solve(body, &with_kinks(profile), pressed(0.3));
            let names = [&known, &found].map(|contact| contact.method().name);
            assert_eq!(names, [MethodName::Sinc, MethodName::Panels]);
            let (one, other) = (&known.dimensionless(), &found.dimensionless());
            let errors = [one, other].map(|contact| contact.error().unwrap());
            let stated = |of: &dyn Fn(&Errors) -> f64| -> f64 { errors.iter().map(of).sum() };
            assert_near(other.settlement(), one.settlement(), stated(&|error| error.settlement));
            let edges = stated(&|error| error.zones.unwrap_or(0.0)) + 1e-15;
            assert_eq!(one.zones().len(), other.zones().len(), "{profile} {theta}");
            for (a, b) in one.zones().iter().flatten().zip(other.zones().iter().flatten()) {
                assert_near(*a, *b, edges);
            }
            let pressure = stated(&|error| error.pressure);
            assert!(pressure < 1e-8 * one.peak_pressure(), "{profile} {theta}: {pressure:e}");
            for i in 0..=50 {
                let xi = 0.0199 * f64::from(i);
                assert_near(other.pressure(xi).unwrap(), one.pressure(xi).unwrap(), pressure);
                let [a, b] = [one, other].map(|contact| contact.elastic_displacement(xi));
                assert_near(a, b, 1e-12 * (1.0 + theta));
            }
            let [a, b] = [one, other].map(Contact::stiffness);
            assert_near(b.force_settlement, a.force_settlement, 1e-9 * a.force_settlement);
            assert_near(b.moment_tilt, a.moment_tilt, 1e-9 * a.moment_tilt);
        }
    }
}

/// The sensitivity of the width of rings about a small hole, by collocation and on panels, against differences of the answer.
#[test]
fn the_width_of_rings_with_small_holes() {
    let profile = "20*(xi^2 - 0.09)^2";
    let solved =
        |base: &str, force: f64| solve((Geometry::Circular, 5.0, 1.0), base, pressed(force));
    let zones = |force: f64| solved(profile, force).dimensionless().zones();
    let width = |force: f64| -> f64 { zones(force).iter().map(|[left, right]| right - left).sum() };
    for hole in [2e-4, 3e-3, 0.05] {
        // The force under which the hole is as small.
        let (mut force, mut more) = (1e-6, 10.0);
        for _ in 0..40 {
            let middle = 0.5 * (force + more);
            let [left, _] = zones(middle).pop().unwrap();
            if left > hole { force = middle } else { more = middle }
        }
        let step = 1e-4 * force * hole;
        let difference = (width(force + step) - width(force - step)) / (2.0 * step);
        for base in [profile.to_owned(), with_kinks(profile)] {
            let contact = solved(&base, force);
            let found = contact.dimensionless().sensitivities().unwrap().contact_width;
            let found = found.force.unwrap();
            let off = (found - difference).abs();
            assert!(off < 1e-4 * difference.abs(), "{hole}: {found} {difference}");
        }
    }
}
