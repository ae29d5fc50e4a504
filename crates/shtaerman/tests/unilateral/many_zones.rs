//! Profiles of thousands of points.

use crate::unilateral::support::{force_and_moment, solve};
use shtaerman::{Contact, Foundation, Load, MethodName, Problem, Profile, Punch};

fn measured(theta0: f64, height: impl Fn(f64) -> f64, load: Load) -> Contact {
    const POINTS: i32 = 4000;
    let positions: Vec<f64> =
        (0..POINTS).map(|i| 2.0 * f64::from(i) / f64::from(POINTS - 1) - 1.0).collect();
    let heights = positions.iter().map(|x| height(*x)).collect();
    let profile = Profile::from_points(positions, heights).unwrap();
    Problem::new(
        Foundation::dimensionless(theta0).unwrap(),
        Punch::new(1.0).unwrap().with_profile(profile),
        load,
    )
    .unwrap()
    .solve()
    .unwrap()
}

#[test]
fn panels_agree_with_collocation() {
    let load = force_and_moment(1.0, 0.1);
    for theta0 in [0.1, 20.0] {
        let size = 2.0 * (1.0 + theta0);
        let expression = format!("{size}*(xi^2 + 0.3*cos(11*xi + 0.4))");
        let exact = solve(theta0, &expression, load);
        // The spline through the points deviates by 1e-12.
        let panels = measured(theta0, |x| size * (x * x + 0.3 * (11.0 * x + 0.4).cos()), load);
        assert_eq!(
            [exact.method().name, panels.method().name],
            [MethodName::Sinc, MethodName::Panels]
        );
        assert!(
            exact.dimensionless().zones().len() > 1
                && exact.dimensionless().zones().len() == panels.dimensionless().zones().len()
        );

        assert!(
            (panels.dimensionless().settlement() - exact.dimensionless().settlement()).abs()
                < 1e-11 * size
        );
        assert!(
            (panels.dimensionless().tilt() - exact.dimensionless().tilt()).abs() < 1e-11 * size
        );
        assert!(panels.relative_error() < 1e-11, "{:?}", panels.dimensionless().error());
        for (one, other) in panels
            .dimensionless()
            .zones()
            .iter()
            .flatten()
            .zip(exact.dimensionless().zones().iter().flatten())
        {
            assert!((one - other).abs() < 1e-11, "{one} {other}");
        }
        for i in -200..=200 {
            let xi = f64::from(i) / 200.0;
            let off = (panels.dimensionless().pressure(xi).unwrap()
                - exact.dimensionless().pressure(xi).unwrap())
            .abs();
            assert!(off < 1e-10 * size, "{xi}: {off:e}");
        }
        let (one, other) = (panels.dimensionless().stiffness(), exact.dimensionless().stiffness());
        assert!((one.force_settlement - other.force_settlement).abs() < 1e-8);
        assert!((one.moment_tilt - other.moment_tilt).abs() < 1e-8);
        let left = panels.complementarity().unwrap();
        assert!(left.tension < 1e-12 && left.penetration < 1e-12, "{left:?}");
    }
}

#[test]
fn a_profile_with_noise_in_many_zones() {
    let noise = |x: f64| 0.01 * (1e5 * (1e3 * x).sin()).fract();
    let contact = measured(5.0, |x| 10.0 * (x * x + noise(x)), force_and_moment(0.2, 0.05));
    assert!(
        contact.dimensionless().zones().len() > 20,
        "{}",
        contact.dimensionless().zones().len()
    );
    assert!(contact.relative_error() < 0.05, "{:e}", contact.relative_error());
    let left = contact.complementarity().unwrap();
    assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{left:?}");
    // Force and moment by a rule of its own, on the pressure as it is given between the cells.
    let count = 200_000;
    let (mut force, mut moment) = (0.0, 0.0);
    for i in 0..count {
        let xi = (2.0 * f64::from(i) + 1.0) / f64::from(count) - 1.0;
        let pressure = contact.dimensionless().pressure(xi).unwrap();
        assert!(
            pressure >= 0.0
                && contact.dimensionless().gap(xi).unwrap()
                    >= -1e-9 * contact.dimensionless().settlement().abs()
        );
        force += pressure * 2.0 / f64::from(count);
        moment += xi * pressure * 2.0 / f64::from(count);
    }
    assert!((force - 0.2).abs() < 1e-3 * 0.2, "{force}");
    assert!((moment - 0.05).abs() < 1e-3 * 0.05, "{moment}");
}

/// A constant that is added and taken away again costs digits, and nothing more: panels are not cut for what is rounding.
#[test]
fn heights_that_are_rounded() {
    let of = |constant: f64| {
        let terms = (1..=20).map(|k| {
            let k = f64::from(k);
            format!("{:.4}*cos({k}*pi*xi + {:.2})", 1.0 / k, (k * k) % std::f64::consts::TAU)
        });
        let waves: Vec<String> = terms.collect();
        let toml = format!(
            "[dimensionless]\ntheta0 = 2750\ngeometry = \"periodic\"\nperiod = 2\nprofile = \"{constant} + {} - {constant}\"\nforce = 0.003\ntilt = 0\n",
            waves.join(" + ")
        );
        shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap()
    };
    let [plain, rounded] = [0.0, 100.0].map(of);
    assert!(rounded.method().n < 2 * plain.method().n, "{:?}", rounded.method());
    let relative = rounded.relative_error();
    assert!(relative > 1e-12 && relative < 1e-7, "{relative:e}");
    let peak = plain.dimensionless().peak_pressure();
    for xi in (0..400).map(|i| f64::from(i) / 200.0 - 1.0) {
        let [one, other] =
            [&plain, &rounded].map(|contact| contact.dimensionless().pressure(xi).unwrap());
        assert!((one - other).abs() <= (plain.relative_error() + relative) * peak, "{xi}");
    }
}
