//! Rows of punches, and waves without gaps.

use std::f64::consts::PI;

use shtaerman::{
    Elastic, Foundation, Geometry, Load, Problem, Profile, Punch, Rotational, Roughness, Solver,
    Vertical,
};

use crate::geometries::support::{
    assert_near, assert_stiffness, attempt, pressed, solve, solve_bilateral,
};

fn row(period: f64) -> Geometry {
    Geometry::Periodic { period }
}

#[test]
fn a_rough_wave() {
    // h = 0.01, L = E* = 1, mean pressure 0.3 pi E* h/L, chi E*/L = 0.1: an independent boundary element code, converged to 1e-7.
    let scale = PI * 0.01;
    for (profile, top) in [("0.01*(1 - cos(2*pi*x))", 0.0), ("0.01*(1 + cos(2*pi*x))", 0.5)] {
        let body = Elastic::new(1.0, 0.0).unwrap();
        let (foundation, punch) = (
            Foundation::new(body).with_roughness(0.1).unwrap(),
            Punch::in_geometry(row(1.0), 0.5).unwrap(),
        );
        let load = Load::new(Vertical::Force(0.3 * scale), Rotational::Moment(0.0)).unwrap();
        let profile = Profile::expression(profile).unwrap();
        let contact =
            Problem::new(foundation, punch.with_profile(profile), load).unwrap().solve().unwrap();
        assert_near(contact.pressure(top).unwrap() / scale, 0.9304655, 1e-7);
        assert_near(contact.peak_pressure() / scale, 0.9304655, 1e-7);
        assert!(contact.dimensionless().gap(if top == 0.0 { 1.0 } else { 0.0 }).unwrap() > 0.0);
        assert!(contact.dimensionless().gap(top / 0.5).unwrap() == 0.0);
    }
}

#[test]
fn ends_of_a_wave_that_steps_where_it_is_joined_keep_their_sides() {
    for theta in [0.3, 40.0] {
        let body = (row(2.0), theta, 1.0);
        // The displacement goes on over the step, so that the layer bears it: and the mean is that of both ends.
        let full = solve(body, "0.1*xi", pressed(1.0));
        assert_near(full.dimensionless().pressure(-1.0).unwrap(), 0.6, 1e-12);
        assert_near(full.dimensionless().pressure(1.0).unwrap(), 0.4, 1e-12);
        let mut parted = 0;
        for (profile, force) in
            [("xi", 0.1), ("-xi", 0.1), ("cos(pi*xi) + 0.3*xi", 0.5), ("0.3*xi - cos(pi*xi)", 0.2)]
        {
            let contact = solve(body, profile, pressed(force));
            for end in [-1.0, 1.0] {
                let [at, beside] = [end, end * (1.0 - 1e-13)]
                    .map(|xi| contact.dimensionless().pressure(xi).unwrap());
                assert_near(at, beside, 1e-9);
                parted += usize::from(at == 0.0);
            }
        }
        assert!(parted >= 3, "{parted}");
    }
}

/// Contact that ends at the step, seen from a slit beside it: the slit is no edge of the base.
#[test]
fn contact_of_a_wave_reaches_a_step_where_it_is_joined() {
    for (exponent, settlement) in [(0.4, 6.2664979874286e-6), (0.7, 8e-6)] {
        let ground = Foundation::new(Elastic::new(200e9, 0.3).unwrap())
            .with_roughness(Roughness::power(6.154e-11, exponent).unwrap())
            .unwrap();
        let punch = Punch::in_geometry(row(2.0), 1.0)
            .unwrap()
            .with_profile(Profile::expression("1.28846e-05*(x-0.4)^2").unwrap());
        let load = Load::settlement(settlement).unwrap();
        let contact = Problem::new(ground.clone(), punch.clone(), load).unwrap().solve().unwrap();
        let zones = contact.zones();
        println!("{exponent} {settlement:e} {zones:?} {:e}", contact.pressure(1.0).unwrap());
        let [.., last] = &zones[..] else { panic!("no contact") };
        assert_eq!(last[1], 1.0, "{exponent} {settlement:e}");
        // What the layer bears at its end, and just before it.
        let [end, beside] = [1.0, 1.0 - 1e-13].map(|x| contact.pressure(x).unwrap());
        assert!(end > 1e6 && (end / beside - 1.0).abs() < 1e-3, "{exponent}: {end:e} {beside:e}");
        let force = Load::force(contact.force()).unwrap();
        let again = Problem::new(ground.clone(), punch.clone(), force).unwrap().solve().unwrap();
        assert!((again.settlement() / settlement - 1.0).abs() < 1e-9, "{exponent}");
    }
}

#[test]
fn waves_in_full_contact_stand_alone() {
    // K turns cos(m pi xi) into cos(m pi xi)/m over a period of 2.
    for theta in [0.0, 0.3, 40.0, 1e4] {
        let body = (row(2.0), theta, 1.0);
        let profile = "0.1*cos(pi*xi + 0.4) + 0.02*sin(3*pi*xi)";
        let contact = solve(body, profile, pressed(1.0));
        assert_eq!(contact.dimensionless().zones(), [[-1.0, 1.0]]);
        assert_near(contact.dimensionless().settlement(), 0.5, 1e-14);
        for xi in [-1.0, -0.3, 0.0, 0.77, 1.0] {
            let wave = 0.1 * (PI * xi + 0.4).cos() / (1.0 + theta)
                + 0.02 * (3.0 * PI * xi).sin() / (1.0 + theta / 3.0);
            assert_near(
                contact.dimensionless().pressure(xi).unwrap(),
                0.5 - wave,
                1e-14 * (1.0 + theta),
            );
        }
        // A pull is met by tension where the punch may not lift off.
        let pulled = solve_bilateral(body, profile, pressed(-1.0));
        assert_near(
            pulled.dimensionless().pressure(0.3).unwrap(),
            contact.dimensionless().pressure(0.3).unwrap() - 1.0,
            1e-13 * (1.0 + theta),
        );
    }
}

#[test]
fn nearly_smooth_waves_are_westergaards() {
    // f = A (1 - cos pi xi): p* = A/theta, mean/p* = sin^2(pi a/2), p = 2 mean cos(u) sqrt(s^2 - sin^2 u)/s^2 with u = pi xi/2
    let mut before = [f64::INFINITY; 2];
    for theta in [1e2, 1e4, 1e6] {
        let profile = format!("{theta}*(1 - cos(pi*xi))");
        let contact = solve((row(2.0), theta, 1.0), &profile, pressed(0.6));
        let s = 0.3f64.sqrt();
        let [left, right] = contact.dimensionless().zones()[0];
        let u = 0.2 * PI / 2.0;
        let exact = 0.6 * u.cos() * (s * s - u.sin().powi(2)).sqrt() / (s * s);
        let errors = [
            (0.5 * (right - left) - 2.0 / PI * s.asin()).abs(),
            (contact.dimensionless().pressure(0.2).unwrap() / exact - 1.0).abs(),
        ];
        for (error, before) in errors.iter().zip(before) {
            assert!(*error < 0.05 * before && *error < 30.0 / theta, "{theta}: {errors:?}");
        }
        before = errors;
    }
}

#[test]
fn where_a_wave_begins_does_not_matter() {
    for exponent in [1.0, 0.5] {
        for (theta, force) in [(0.5, 2.0), (20.0, 1.0)] {
            let body = (row(2.0), theta, exponent);
            let wave = |shift: f64| {
                format!("20*(1 - cos(pi*(xi - {shift}))) + 6*sin(2*pi*(xi - {shift}))")
            };
            let first = solve(body, &wave(0.0), pressed(force));
            assert!(first.dimensionless().zones().len() == 1 && first.contact_width() < 2.0);
            for shift in [0.3, 0.9, 1.0] {
                let other = solve(body, &wave(shift), pressed(force));
                assert_near(
                    other.dimensionless().settlement(),
                    first.dimensionless().settlement(),
                    1e-11,
                );
                assert_near(other.contact_width(), first.contact_width(), 1e-11);
                for xi in [-0.1, 0.0, 0.1] {
                    let image = xi + shift;
                    let image = if image > 1.0 { image - 2.0 } else { image };
                    assert_near(
                        other.dimensionless().pressure(image).unwrap(),
                        first.dimensionless().pressure(xi).unwrap(),
                        1e-10,
                    );
                }
            }
            assert_stiffness(body, &wave(0.9), &first, 1e-5);
        }
    }
}

#[test]
fn many_crests_are_one_that_repeats() {
    // 10 crests in a period are one in a tenth of it, the body as much stiffer.
    let crests = 10.0;
    for (theta, depth, force) in [(5.0, 1.0, 0.4), (400.0, 20.0, 0.2), (1e5, 1e4, 0.3)] {
        let one =
            solve((row(2.0), theta / crests, 1.0), &format!("-{depth}*cos(pi*xi)"), pressed(force));
        let profile = format!("-{depth}*cos({crests}*pi*xi)");
        let many = solve((row(2.0), theta, 1.0), &profile, pressed(force));
        let [left, right] = one.dimensionless().zones()[0];
        assert!(right < 1.0);
        let zones = many.dimensionless().zones();
        assert_eq!(zones.len(), 10);
        for zone in &zones {
            let crest = (0.5 * (zone[0] + zone[1]) * 0.5 * crests).round() * 2.0 / crests;
            assert_near(zone[0] - crest, left / crests, 1e-12);
            assert_near(zone[1] - crest, right / crests, 1e-12);
        }
        assert_near(
            many.dimensionless().settlement(),
            one.dimensionless().settlement(),
            1e-11 * depth,
        );
        let largest = one.dimensionless().pressure(0.0).unwrap();
        for share in [0.0, 0.3, 0.9] {
            let exact = one.dimensionless().pressure(share * right).unwrap();
            assert_near(
                many.dimensionless().pressure((4.0 + share * right) / crests).unwrap(),
                exact,
                1e-9 * largest,
            );
        }
    }
}

#[test]
fn far_punches_are_alone() {
    // ln 1/(2 sin(pi d/L)) = ln 1/d + ln(L/(2 pi)) + O(d^2/L^2)
    let load = (Vertical::Force(1.0), Rotational::Moment(0.2));
    let alone = solve((Geometry::Plane, 5.0, 1.0), "3*xi^2", load);
    let mut before = f64::INFINITY;
    for period in [1e1, 1e2, 1e3] {
        let contact = solve((row(period), 5.0, 1.0), "3*xi^2", load);
        let gauge = 5.0 * (period / (2.0 * PI)).ln();
        let error =
            (contact.dimensionless().settlement() - gauge - alone.dimensionless().settlement())
                .abs();
        assert!(error < 0.02 * before && error < 10.0 / period.powi(2), "{period}: {error}");
        assert_near(
            contact.dimensionless().pressure(0.3).unwrap(),
            alone.dimensionless().pressure(0.3).unwrap(),
            10.0 / period.powi(2),
        );
        assert_near(
            contact.dimensionless().tilt(),
            alone.dimensionless().tilt(),
            50.0 / period.powi(2),
        );
        before = error;
    }
}

#[test]
fn nearly_smooth_flat_punches_are_koiters() {
    // p = (P/L) cos u/sqrt(s^2 - sin^2 u), u = pi xi/L, s = sin(pi/L), settlement -theta P ln s
    let (period, theta) = (3.0, 1e7);
    let contact = solve((row(period), theta, 1.0), "0", pressed(1.0));
    let s = (PI / period).sin();
    for xi in [0.0, 0.4, -0.7] {
        let u = PI * xi / period;
        let exact = u.cos() / (period * (s * s - u.sin().powi(2)).sqrt());
        assert_near(contact.dimensionless().pressure(xi).unwrap() / exact, 1.0, 1e-6);
    }
    assert_near(contact.dimensionless().settlement() / theta, -s.ln(), 1e-6);
}

#[test]
fn a_wave_does_not_tilt() {
    for rotational in
        [Rotational::Moment(0.1), Rotational::Tilt(0.1), Rotational::Eccentricity(0.1)]
    {
        let load = (Vertical::Force(1.0), rotational);
        let error = attempt((row(2.0), 1.0, 1.0), "0", load, Solver::default()).unwrap_err();
        assert!(error.to_string().contains("cannot tilt"), "{error}");
        // With gaps between the punches it does.
        assert!(attempt((row(2.5), 1.0, 1.0), "0", load, Solver::default()).is_ok());
    }
}
