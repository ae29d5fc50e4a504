//! Layers that bend, `v = p0^kappa`.

use std::f64::consts::{LN_2, PI};

use shtaerman::{Error, Geometry, Rotational, Solver, Vertical};

use crate::geometries::support::{
    assert_near, assert_stiffness, attempt, pressed, solve, solve_bilateral,
};

const PLANE: Geometry = Geometry::Plane;

#[test]
fn the_layer_alone_has_a_closed_form() {
    // v = delta - c xi^2: P = int v^2 = (16/15) delta^(5/2)/sqrt(c) for kappa = 1/2
    let settlement = (0.3 * 15.0 / 16.0 * 40f64.sqrt()).powf(0.4);
    let contact = solve((PLANE, 0.0, 0.5), "40*xi^2", pressed(0.3));
    assert_near(contact.dimensionless().settlement(), settlement, 1e-12);
    let edge = (settlement / 40.0).sqrt();
    assert_near(contact.dimensionless().zones()[0][0], -edge, 1e-13);
    assert_near(contact.dimensionless().pressure(0.1).unwrap(), (settlement - 0.4).powi(2), 1e-12);
    // Flat: p is uniform, and so is its displacement.
    for exponent in [0.1, 0.5, 0.9] {
        let flat = solve((PLANE, 0.0, exponent), "0", pressed(3.0));
        assert_near(flat.dimensionless().settlement(), 1.5f64.powf(exponent), 1e-13);
    }
    // On a disk P = 2 pi int (delta - c r^2)^2 r dr = pi delta^3/(3 c).
    let disk = solve((Geometry::Circular, 0.0, 0.5), "40*xi^2", pressed(0.3));
    assert_near(disk.dimensionless().settlement(), (0.3 * 3.0 * 40.0 / PI).cbrt(), 1e-12);
}

#[test]
fn a_pressure_made_up_comes_back_in_the_plane() {
    // p = q^(3/2), q = 1 - y^2, y = xi/b; kappa = 2/3 has v = q. With y = cos t the integral of ln 1/|y - s| times p is
    // pi [3/8 ln 2 - T_2(y)/4 + T_4(y)/32], from sin^4 t = 3/8 - cos(2t)/2 + cos(4t)/8.
    let b: f64 = 0.7;
    for theta in [0.1, 3.0, 20.0] {
        let y = format!("(xi/{b})");
        let potential =
            format!("({} - (2*{y}^2 - 1)/4 + (8*{y}^4 - 8*{y}^2 + 1)/32)", 0.375 * LN_2);
        // A little beyond the zone the base turns away.
        let away = format!("{}*max(abs(xi) - {}, 0)^2", 1e3 * (1.0 + theta), b + 0.01);
        let profile = format!("{y}^2 - {}*{potential} + {away}", theta * b * PI);
        let force = b * 3.0 * PI / 8.0;
        let contact = solve((PLANE, theta, 2.0 / 3.0), &profile, pressed(force));
        let [left, right] = contact.dimensionless().zones()[0];
        // What is aimed at is 1e-12; the edges state their own error.
        let tolerance = 1e-12 * (1.0 + theta);
        let beside = contact.dimensionless().error().and_then(|error| error.zones).unwrap();
        assert!(beside < 3e-11);
        assert_near(left, -b, beside);
        assert_near(right, b, beside);
        // K of b p dy has -ln b beside the local kernel.
        assert_near(
            contact.dimensionless().settlement(),
            1.0 - theta * force * b.ln(),
            3.0 * tolerance,
        );
        for xi in [-0.69, -0.3, 0.0, 0.5, 0.65] {
            assert_near(
                contact.dimensionless().pressure(xi).unwrap(),
                (1.0 - (xi / b).powi(2)).powf(1.5),
                tolerance,
            );
        }
        assert!(contact.relative_error() < 1e-12 * (1.0 + theta));
    }
}

#[test]
fn a_pressure_made_up_comes_back_on_a_disk() {
    // p = q^(3/2), q = 1 - y^2: with P_n^(0,-1/2)(1 - 2 y^2) = P_2n(sqrt q) and lambda_n = Gamma(n + 1/2)^2/(2 n!^2),
    // q^2 = 1/5 + (4/7) P_2 + (8/35) P_4 of sqrt q.
    let b: f64 = 0.8;
    for theta in [0.1, 3.0, 20.0] {
        let q = format!("(1 - (xi/{b})^2)");
        let lambda = |gamma: f64, factorial: f64| 0.5 * PI * (gamma / factorial).powi(2);
        let (l0, l1, l2) = (lambda(1.0, 1.0), lambda(0.5, 1.0), lambda(0.75, 2.0));
        let potential = format!(
            "({}*(3*{q} - 1)/2 + {}*(35*{q}^2 - 30*{q} + 3)/8)",
            l1 * 4.0 / 7.0,
            l2 * 8.0 / 35.0
        );
        // u = pi theta0 b int W p s ds
        let scale = PI * theta * b;
        let away = format!("{}*max(abs(xi) - {}, 0)^2", 1e3 * (1.0 + theta), b + 0.01);
        let profile = format!("1 - {q} - {scale}*{potential} + {away}");
        let force = 2.0 * PI * b * b / 5.0;
        let contact = solve((Geometry::Circular, theta, 2.0 / 3.0), &profile, pressed(force));
        let tolerance = 1e-12 * (1.0 + theta);
        let beside = contact.dimensionless().error().and_then(|error| error.zones).unwrap();
        assert!(beside < 3e-11);
        assert_near(contact.dimensionless().zones()[0][1], b, beside);
        assert_near(contact.dimensionless().settlement(), 1.0 + scale * l0 / 5.0, 3.0 * tolerance);
        for xi in [-0.7, -0.3, 0.0, 0.5] {
            assert_near(
                contact.dimensionless().pressure(xi).unwrap(),
                (1.0 - (xi / b).powi(2)).powf(1.5),
                tolerance,
            );
        }
    }
}

#[test]
fn agrees_with_cells() {
    // Edge, settlement and pressure in the middle by constant pressures on up to 4000 cells, extrapolated; another program.
    for (exponent, theta, force, edge, settlement, top) in [
        (0.5, 1.0, 0.2, 0.319_399_261, 1.268_179_242, 0.552_647_101_5),
        (0.2, 1.0, 0.2, 0.353_722_021_4, 1.470_223_558_4, 0.645_520_997_7),
        (0.5, 50.0, 0.02, 0.367_892_940, 2.496_195_036_9, 0.038_785_328_44),
        (0.2, 50.0, 0.02, 0.432_780_322_9, 2.807_263_488_6, 0.038_458_040_9),
    ] {
        let contact = solve((PLANE, theta, exponent), "10*xi^2", pressed(force));
        assert_near(contact.dimensionless().zones()[0][1], edge, 1e-9);
        assert_near(contact.dimensionless().settlement(), settlement, 1e-9);
        assert_near(contact.dimensionless().pressure(0.0).unwrap(), top, 1e-9);
    }
}

#[test]
fn exponents_near_one_are_nearly_linear() {
    let load = (Vertical::Force(0.4), Rotational::Moment(0.05));
    for geometry in
        [PLANE, Geometry::Pair { inner_half_gap: 0.3 }, Geometry::Periodic { period: 2.5 }]
    {
        let linear = solve((geometry, 2.0, 1.0), "3*xi^2", load);
        let mut before = f64::INFINITY;
        for power in [4, 6, 8] {
            let exponent = 1.0 - 0.1f64.powi(power);
            let contact = solve((geometry, 2.0, exponent), "3*xi^2", load);
            let error = (contact.dimensionless().pressure(0.4).unwrap()
                - linear.dimensionless().pressure(0.4).unwrap())
            .abs();
            assert!(
                error < 0.02 * before && error < 2.0 * (1.0 - exponent),
                "{geometry:?} {error}"
            );
            before = error;
        }
    }
}

#[test]
fn units_of_pressure_do_not_matter() {
    // p -> s p: v -> s^kappa v, theta -> s^(kappa - 1) theta
    for exponent in [0.2, 0.5, 0.8] {
        for s in [1e-3, 1e4f64] {
            let unit = s.powf(exponent);
            let one = solve((PLANE, 2.0, exponent), "3*xi^2 + sin(6*xi)", pressed(0.2));
            let profile = format!("{unit}*(3*xi^2 + sin(6*xi))");
            let theta = 2.0 * unit / s;
            let other = solve((PLANE, theta, exponent), &profile, pressed(0.2 * s));
            assert_near(
                other.dimensionless().settlement() / unit,
                one.dimensionless().settlement(),
                1e-11,
            );
            let one_bare = one.dimensionless();
            let top = (one_bare.peak_pressure_at(), one_bare.peak_pressure());
            assert_near(other.dimensionless().pressure(top.0).unwrap() / s, top.1, 1e-10);
            for (one, other) in one
                .dimensionless()
                .zones()
                .concat()
                .iter()
                .zip(other.dimensionless().zones().concat())
            {
                assert_near(other, *one, 1e-11);
            }
        }
    }
}

#[test]
fn what_is_prescribed_does_not_matter() {
    let body = (PLANE, 5.0, 0.4);
    let profile = "4*xi^2 - 2*xi";
    let first = solve(body, profile, (Vertical::Force(0.7), Rotational::Moment(0.1)));
    let (delta, alpha) = (first.dimensionless().settlement(), first.dimensionless().tilt());
    for load in [
        (Vertical::Settlement(delta), Rotational::Tilt(alpha)),
        (Vertical::Settlement(delta), Rotational::Moment(0.1)),
        (Vertical::Force(0.7), Rotational::Tilt(alpha)),
        (Vertical::Force(0.7), Rotational::Eccentricity(0.1 / 0.7)),
    ] {
        let contact = solve(body, profile, load);
        for (one, other) in [
            (contact.dimensionless().settlement(), delta),
            (contact.dimensionless().tilt(), alpha),
            (contact.dimensionless().force(), 0.7),
            (contact.dimensionless().moment(), 0.1),
            (
                contact.dimensionless().pressure(0.1).unwrap(),
                first.dimensionless().pressure(0.1).unwrap(),
            ),
        ] {
            assert_near(one, other, 1e-11);
        }
    }
    assert_stiffness(body, profile, &first, 1e-6);
}

#[test]
fn full_contact_must_not_pull() {
    let body = (PLANE, 1.0, 0.5);
    let load = |moment: f64| (Vertical::Force(1.0), Rotational::Moment(moment));
    let one = solve(body, "0", load(0.1));
    let other = solve_bilateral(body, "0", load(0.1));
    assert_near(
        one.dimensionless().pressure(-0.9).unwrap(),
        other.dimensionless().pressure(-0.9).unwrap(),
        1e-12,
    );
    let refused = attempt(body, "0", load(0.7), Solver::bilateral());
    let Err(Error::Pulls { at, .. }) = refused else { panic!("{refused:?}") };
    assert!((-1.0..0.0).contains(&at));
}

#[test]
fn a_circular_punch_on_it_must_not_tilt() {
    let load = (Vertical::Force(1.0), Rotational::Moment(0.01));
    let refused = attempt((Geometry::Circular, 1.0, 0.5), "0", load, Solver::default());
    assert!(refused.unwrap_err().to_string().contains("harmonics"));
}
