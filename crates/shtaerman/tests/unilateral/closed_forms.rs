//! Closed forms and golden numbers.

use std::f64::consts::PI;

use crate::unilateral::support::{force_and_moment, load, solve};
use shtaerman::{Elastic, Foundation, Load, Problem, Profile, Punch, Rotational, Vertical};

#[test]
fn the_rough_parabola() {
    // E* = R = 1, P = pi/4e-4: a_H = 0.01, p_H = 2 P/(pi a_H). Figures from an independent program, confirmed to 2e-5 by a boundary
    // element code.
    let golden = [
        (0.1, 1.0741908, 0.96991644),
        (1.0, 1.39306501, 0.802671925),
        (10.0, 2.43891775, 0.4768618686),
    ];
    let (force, hertz) = (PI / 4.0 * 1e-4, 0.01);
    for (roughness, width, peak) in golden {
        for half_width in [0.03, 0.2, 10.0] {
            let body = Elastic::new(1.0, 0.0).unwrap();
            let (foundation, punch) = (
                Foundation::new(body).with_roughness(roughness * hertz).unwrap(),
                Punch::new(half_width).unwrap(),
            );
            let load = Load::new(Vertical::Force(force), Rotational::Moment(0.0)).unwrap();
            let profile = Profile::expression("x^2/2").unwrap();
            let problem = Problem::new(foundation, punch.with_profile(profile), load).unwrap();
            let contact = problem.solve().unwrap();
            let edges = contact.zones();
            assert_eq!(edges.len(), 1);
            let [left, right] = edges[0];
            let found = 0.5 * (right - left) / hertz;
            let top = contact.pressure(0.0).unwrap() / (2.0 * force / (PI * hertz));
            assert!((found - width).abs() < 6e-8, "{roughness} {half_width}: {found} {width}");
            assert!((top - peak).abs() < 6e-9, "{roughness} {half_width}: {top} {peak}");
            assert!((left + right).abs() < 1e-12 * right);
        }
    }
}

#[test]
fn the_flat_punch_begins_to_lift_at_the_known_eccentricity() {
    for (theta0, limit) in [
        (1e-3, 0.3335),
        (0.1, 0.3484),
        (1.0, 0.4134),
        (10.0, 0.4794),
        (100.0, 0.4968),
        (1e3, 0.4996),
    ] {
        let edges = |e: f64| solve(theta0, "0", force_and_moment(1.0, e)).dimensionless().zones();
        assert_eq!(edges(limit - 1e-4), [[-1.0, 1.0]], "{theta0}");
        let lifted = edges(limit + 1e-4);
        assert!(lifted[0][0] > -1.0 && lifted[0][1] == 1.0, "{theta0}: {lifted:?}");
    }
}

#[test]
fn a_flat_punch_beyond_the_limit_is_smooth_in_the_middle() {
    // theta0 -> inf: half-length b = 2 (1 - |M|/P), p = P/(pi b) sqrt((b + y)/(b - y))
    for theta0 in [1e4, 1e6] {
        let contact = solve(theta0, "0", force_and_moment(1.0, 0.75));
        let [left, right] = contact.dimensionless().zones()[0];
        let b = 0.5 * (right - left);
        assert!(right == 1.0 && (b - 0.5).abs() < 30.0 / theta0, "{theta0}: {b}");
        let y: f64 = 0.1;
        let exact = 1.0 / (PI * 0.5) * ((0.5 + y) / (0.5 - y)).sqrt();
        let found = contact.dimensionless().pressure(0.5 + y).unwrap();
        assert!((found - exact).abs() < 30.0 / theta0, "{theta0}: {found} {exact}");
    }
}

#[test]
fn without_elasticity_every_point_stands_alone() {
    // p = delta - f: the parabola's half-width is (3 P/(4 c))^(1/3) for f = c xi^2
    let contact = solve(0.0, "50*xi^2", force_and_moment(1.0, 0.0));
    let width = (3.0 / 200.0f64).cbrt();
    let [left, right] = contact.dimensionless().zones()[0];
    assert!((right - width).abs() < 1e-13 && (left + width).abs() < 1e-13);
    assert!((contact.dimensionless().settlement() - 50.0 * width * width).abs() < 1e-11);
    // A flat punch beyond the middle third: a triangle of length 3 (1 - e).
    let contact = solve(0.0, "0", force_and_moment(1.0, 0.6));
    let [left, right] = contact.dimensionless().zones()[0];
    assert!((left - (1.0 - 1.2)).abs() < 1e-13 && right == 1.0);
    assert!((contact.dimensionless().pressure(1.0).unwrap() - 2.0 / 1.2).abs() < 1e-12);
    // Nearly so at a small theta0, by first order.
    let contact = solve(1e-9, "50*xi^2", force_and_moment(1.0, 0.0));
    assert!((contact.dimensionless().zones()[0][1] - width).abs() < 1e-8);
}

#[test]
fn what_is_prescribed_does_not_matter() {
    for (theta0, profile, force, moment) in
        [(3.0, "4*xi^2 - 2*xi", 1.0, 0.3), (200.0, "3*xi^4 + cos(5*xi)", 0.2, -0.06)]
    {
        let first = solve(theta0, profile, force_and_moment(force, moment));
        let (delta, alpha) = (first.dimensionless().settlement(), first.dimensionless().tilt());
        for again in [
            load(Vertical::Settlement(delta), Rotational::Tilt(alpha)),
            load(Vertical::Settlement(delta), Rotational::Moment(moment)),
            load(Vertical::Settlement(delta), Rotational::Eccentricity(moment / force)),
            load(Vertical::Force(force), Rotational::Tilt(alpha)),
            load(Vertical::Force(force), Rotational::Eccentricity(moment / force)),
        ] {
            let contact = solve(theta0, profile, again);
            for (one, other) in [
                (contact.dimensionless().settlement(), delta),
                (contact.dimensionless().tilt(), alpha),
                (contact.dimensionless().force(), force),
                (contact.dimensionless().moment(), moment),
                (
                    contact.dimensionless().pressure(0.1).unwrap(),
                    first.dimensionless().pressure(0.1).unwrap(),
                ),
            ] {
                assert!((one - other).abs() < 1e-11 * (1.0 + theta0), "{again:?}: {one} {other}");
            }
        }
    }
}
