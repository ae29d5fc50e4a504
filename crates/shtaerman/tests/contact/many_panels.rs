//! Waves whose panels are very many, or crowd beside each other.

use std::f64::consts::PI;

use shtaerman::{ErrorKind, Problem, Profile, file};

fn problem(profile: &str, theta0: f64) -> Problem {
    let toml = format!(
        "[dimensionless]\ntheta0 = {theta0}\ngeometry = \"periodic\"\nperiod = 2\nprofile = \"{profile}\"\nforce = 1\nmoment = 0\n[solver]\ncontact = \"bilateral\"\n"
    );
    file::parse(&toml, "test").unwrap()
}

/// Fifty thousand measured points of `sum f_m cos(m pi xi)`: `p = P/2 - sum f_m/(1 + theta0/m) cos(m pi xi)`, as the kernel of a wave divides each by `m`. There are too many panels for the highest orders.
#[test]
fn a_wave_of_fifty_thousand_points() {
    const POINTS: usize = 50_000;
    let (theta0, terms) = (3.0, [(1.0, 0.05), (5.0, -0.02), (40.0, 0.003)]);
    let sum = |x: f64, of: &dyn Fn(f64) -> f64| -> f64 {
        terms.iter().map(|(m, f)| f * of(*m) * (m * PI * x).cos()).sum()
    };
    let places: Vec<f64> =
        (0..POINTS).map(|i| 2.0 * i as f64 / (POINTS - 1) as f64 - 1.0).collect();
    // theta0 = 2 a/(pi E* chi), and heights are in lengths chi E*.
    let chi = 2.0 / (PI * theta0);
    let heights = places.iter().map(|x| chi * sum(*x, &|_| 1.0)).collect();
    let trace = Profile::from_points(places, heights).unwrap();
    let flat = file::parse(
        &format!(
            "[foundation]\nyoung_modulus = 1\npoisson_ratio = 0\nroughness = {chi}\n[punch]\ngeometry = \"periodic\"\nperiod = 2\nprofile = \"0\"\n[load]\nforce = 1\nmoment = 0\n[solver]\ncontact = \"bilateral\"\n"
        ),
        "test",
    )
    .unwrap();
    let punch = flat.punch().clone().with_profile(trace);
    let problem = Problem::new(flat.foundation().clone(), punch, *flat.load()).unwrap();
    let contact = problem.with_solver(*flat.solver()).solve().unwrap();
    let contact = contact.dimensionless();
    let stated = contact.error().unwrap();
    // Between measured points the spline is off by `5/384 h^4 |f''''|`.
    let spline = 5.0 / 384.0
        * (2.0 / POINTS as f64).powi(4)
        * terms.iter().map(|(m, f)| f.abs() * (m * PI).powi(4)).sum::<f64>();
    for x in [-0.987_654, -0.5, 0.0, 1e-4, 0.123_4, 0.77] {
        let exact = 0.5 - sum(x, &|m| 1.0 / (1.0 + theta0 / m));
        let off = (contact.pressure(x).unwrap() - exact).abs();
        assert!(off <= stated.pressure + 2.0 * spline, "{x}: {off:e} {stated:?}");
    }
    assert!(stated.pressure < 1e-8, "{stated:?}");
}

/// Kinks beside the seam, and a ramp that is steep: panels crowd there beside long ones. At rest the settlement is `P/2` and the mean height, as the kernel of a wave has no mean.
#[test]
fn kinks_beside_the_seam_of_a_wave() {
    for theta0 in [0.6, 20.0] {
        for (gap, profile) in [
            (1e-4, "0.01*abs(abs(xi) - 0.9999)"),
            (1e-6, "0.01*abs(abs(xi) - 0.999999)"),
            (1e-4, "0.01*min(1, max(0, (abs(xi) - 0.3)/1e-4))"),
        ] {
            let contact = problem(profile, theta0).solve().unwrap().audited().unwrap();
            let contact = contact.dimensionless();
            let stated = contact.error().unwrap();
            assert_eq!(stated.kind, ErrorKind::Bound);
            assert!(stated.pressure < 1e-8, "{profile}: {stated:?}");
            let mean = if profile.contains("min") {
                0.01 * (0.7 - 0.5 * gap)
            } else {
                0.005 * ((1.0 - gap) * (1.0 - gap) + gap * gap)
            };
            let off = (contact.settlement() - 0.5 - mean).abs();
            assert!(off <= stated.settlement + 1e-15, "{profile}: {off:e} {stated:?}");
            // Either side sees the same.
            let [left, right] = [-0.2, 0.2].map(|xi| contact.pressure(xi).unwrap());
            assert!((left - right).abs() <= 2.0 * stated.pressure, "{profile}: {left} {right}");
        }
    }
}
