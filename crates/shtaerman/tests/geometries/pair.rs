//! Two punches of one body.

use std::f64::consts::PI;

use fredholm::collocation::solve_adaptive;
use fredholm::kernel::{LogarithmRatio, LogarithmSquare};
use shtaerman::{Geometry, Rotational, Solver, Vertical};

use crate::geometries::support::{
    assert_near, assert_stiffness, attempt, pressed, solve, solve_bilateral,
};

fn pair(inner_half_gap: f64) -> Geometry {
    Geometry::Pair { inner_half_gap }
}

#[test]
fn agrees_with_its_symmetric_and_its_skew_part() {
    // On (b, 1): p+ + theta int ln(1/|x^2 - s^2|) p+ ds = delta - f+, p- + theta int ln((x + s)/|x - s|) p- ds = -alpha x - f-
    for (b, theta) in [(0.05, 0.3), (0.4, 3.0), (0.4, 200.0), (0.9, 30.0)] {
        let (delta, alpha) = (1.0, 0.2);
        let body = (pair(b), theta, 1.0);
        let load = (Vertical::Settlement(delta), Rotational::Tilt(alpha));
        let contact = solve_bilateral(body, "0.3*xi^2 + 0.1*xi^3", load);
        let even = |x: f64| delta - 0.3 * x * x;
        let odd = |x: f64| -alpha * x - 0.1 * x.powi(3);
        let square = LogarithmSquare::new(b, 1.0).unwrap();
        let ratio = LogarithmRatio::new(b, 1.0).unwrap();
        let symmetric = solve_adaptive(&square, theta, even, 1e-13).unwrap().solution;
        let skew = solve_adaptive(&ratio, theta, odd, 1e-13).unwrap().solution;
        for i in 0..=10 {
            let x = b + (1.0 - b) * f64::from(i) / 10.0;
            let (p, q) = (symmetric.evaluate(x, even(x)), skew.evaluate(x, odd(x)));
            assert_near(contact.dimensionless().pressure(x).unwrap(), p + q, 1e-11);
            assert_near(contact.dimensionless().pressure(-x).unwrap(), p - q, 1e-11);
        }
        assert_near(contact.dimensionless().force(), 2.0 * symmetric.integral(|_| 1.0), 1e-12);
        assert_near(contact.dimensionless().moment(), 2.0 * skew.integral(|x| x), 1e-12);
    }
}

#[test]
fn a_layer_alone_is_statics() {
    let b: f64 = 0.4;
    let (length, inertia) = (2.0 * (1.0 - b), 2.0 / 3.0 * (1.0 - b.powi(3)));
    let body = (pair(b), 0.0, 1.0);
    let contact = solve(body, "0", (Vertical::Force(1.0), Rotational::Moment(0.1)));
    assert_eq!(contact.dimensionless().zones(), [[-1.0, -b], [b, 1.0]]);
    for x in [-1.0, -0.6, -b, b, 0.8] {
        assert_near(
            contact.dimensionless().pressure(x).unwrap(),
            1.0 / length + 0.1 * x / inertia,
            1e-14,
        );
    }
    assert!(contact.dimensionless().pressure(0.0).unwrap() == 0.0);
    // One punch has lifted, the other carries a triangle whose centre is in the line of the force.
    let contact = solve(body, "0", (Vertical::Force(1.0), Rotational::Moment(0.85)));
    let [left, right] = contact.dimensionless().zones()[0];
    assert_near(left, 1.0 - 3.0 * 0.15, 1e-10);
    assert!(right == 1.0 && contact.dimensionless().zones().len() == 1);
    assert_near(contact.dimensionless().pressure(1.0).unwrap(), 2.0 / 0.45, 1e-9);
}

#[test]
fn the_smooth_limit_is_elementary() {
    // p = P |x|/(pi sqrt((1 - x^2)(x^2 - b^2))), delta = theta P/2 ln(4/(1 - b^2))
    let b: f64 = 0.4;
    let mut before = f64::INFINITY;
    for theta in [1e3, 1e5, 1e7] {
        let contact = solve((pair(b), theta, 1.0), "0", pressed(1.0));
        let x: f64 = 0.7;
        let exact = x / (PI * ((1.0 - x * x) * (x * x - b * b)).sqrt());
        let error = (contact.dimensionless().pressure(x).unwrap() / exact - 1.0).abs();
        assert!(error < 0.1 * before && error < 10.0 / theta, "{theta} {error}");
        before = error;
        let settlement = 0.5 * (4.0 / (1.0 - b * b)).ln();
        assert_near(contact.dimensionless().settlement() / theta, settlement, 10.0 / theta);
    }
}

#[test]
fn crowned_punches_have_free_edges() {
    let body = (pair(0.4), 2.0, 1.0);
    let profile = "20*(abs(xi) - 0.7)^2";
    let contact = solve(body, profile, (Vertical::Force(0.1), Rotational::Moment(0.01)));
    let edges = contact.dimensionless().zones();
    assert_eq!(edges.len(), 2);
    for [left, right] in &edges {
        // To both sides of an edge: pressure within, gap without.
        for (edge, inwards) in [(*left, 1.0), (*right, -1.0)] {
            assert!(contact.dimensionless().pressure(edge).unwrap() == 0.0);
            assert!(contact.dimensionless().pressure(edge + 1e-3 * inwards).unwrap() > 0.0);
            assert!(contact.dimensionless().gap(edge - 1e-3 * inwards).unwrap() > 0.0);
            // The equation goes on: a gap as a power 3/2 or 2, a pressure that begins at zero.
            assert!(contact.dimensionless().gap(edge - 1e-6 * inwards).unwrap() < 1e-4);
        }
    }
    let mirrored = solve(body, profile, (Vertical::Force(0.1), Rotational::Moment(-0.01)));
    for ([left, right], [other, another]) in
        edges.iter().zip(mirrored.dimensionless().zones().iter().rev())
    {
        assert!((left + another).abs() < 1e-13 && (right + other).abs() < 1e-13);
    }
    assert_stiffness(body, profile, &contact, 1e-6);
    // The narrower the gap between them, the more they are one punch.
    let wide = solve((Geometry::Plane, 2.0, 1.0), "0.1*xi", pressed(1.0));
    let near = solve((pair(1e-7), 2.0, 1.0), "0.1*xi", pressed(1.0));
    assert_near(
        near.dimensionless().pressure(0.5).unwrap(),
        wide.dimensionless().pressure(0.5).unwrap(),
        1e-6,
    );
    assert_near(near.dimensionless().settlement(), wide.dimensionless().settlement(), 1e-6);
}

#[test]
fn tips_over_beyond_its_edge() {
    let load = (Vertical::Force(1.0), Rotational::Moment(1.1));
    assert!(attempt((pair(0.4), 1.0, 1.0), "0", load, Solver::default()).is_err());
    // Full contact may pull.
    let contact = solve_bilateral((pair(0.4), 1.0, 1.0), "0", load);
    assert!(contact.dimensionless().pressure(-1.0).unwrap() < 0.0 && !contact.tension().is_empty());
}
