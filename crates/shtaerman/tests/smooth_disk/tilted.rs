//! The tilt of a circular punch.

use std::f64::consts::PI;

use crate::smooth_disk::support::{A, MODULUS, attempt, close, problem, solve, solve_bilateral};
use shtaerman::{Error, Profile, Rotational, Solver, Vertical};

#[test]
fn a_flat_punch_tilts() {
    // M = -(4/3) E* a^3 alpha, p = (F + 3 M x/a^2)/(2 pi a sqrt(a^2 - r^2))
    let (force, moment) = (2e4, 25.0);
    let alpha = -moment / (4.0 / 3.0 * MODULUS * A.powi(3));
    for rotational in [
        Rotational::Moment(moment),
        Rotational::Tilt(alpha),
        Rotational::Eccentricity(moment / force),
    ] {
        let contact = solve("0", (Vertical::Force(force), rotational));
        close(contact.tilt(), alpha, 1e-14, "tilt");
        close(contact.moment(), moment, 1e-14, "moment");
        for x in [-4.9e-3f64, -1e-3, 0.0, 4e-3] {
            let root = (A * A - x * x).sqrt();
            let exact = (force + 3.0 * moment * x / (A * A)) / (2.0 * PI * A * root);
            close(contact.pressure(x).unwrap(), exact, 1e-12, "pressure");
        }
        // Far away a couple: u = M x/(pi E* r^3), on the axis of the tilt
        let odd = contact.elastic_displacement(2.0) - contact.elastic_displacement(-2.0);
        close(0.5 * odd, moment / (PI * MODULUS * 4.0), 1e-5, "couple");
        let beside = contact.elastic_displacement(A * (1.0 + 1e-13))
            - contact.elastic_displacement(-A * (1.0 + 1e-13));
        close(0.5 * beside, -alpha * A, 1e-5, "edge");
    }
}

#[test]
fn the_surface_follows_the_tilt_beside() {
    // u1 = int int p1/(pi E* |x - y|) with p1 = k y1/sqrt(a^2 - y^2): over y = a sin t, with polar angles
    let moment = 10.0;
    let contact = solve("0", (Vertical::Force(1e4), Rotational::Moment(moment)));
    let k = 3.0 * moment / (2.0 * PI * A.powi(3));
    for x in [1.2 * A, 3.0 * A] {
        let count = 400;
        let mut sum = 0.0;
        for i in 0..count {
            let t = 0.5 * PI * (f64::from(i) + 0.5) / f64::from(count);
            let s = A * t.sin();
            for j in 0..count {
                let phi = 2.0 * PI * f64::from(j) / f64::from(count);
                let distance = (x * x + s * s - 2.0 * x * s * phi.cos()).sqrt();
                sum += k * s * phi.cos() * s / distance;
            }
        }
        let exact = sum * PI * PI / f64::from(count * count) / (PI * MODULUS);
        let odd = 0.5 * (contact.elastic_displacement(x) - contact.elastic_displacement(-x));
        close(odd, exact, 1e-5, "displacement");
    }
}

#[test]
fn a_moment_lifts_beyond_a_third_of_the_radius() {
    let force = 2e4;
    let limit = force * A / 3.0;
    let with = |moment: f64| attempt("0", (Vertical::Force(force), Rotational::Moment(moment)));
    for moment in [1.01 * limit, -2.5 * limit] {
        let Err(Error::LiftsOff { field: "moment", value, limit: found }) = with(moment) else {
            panic!("{moment}");
        };
        assert!(value == moment);
        close(found, limit, 1e-12, "limit");
    }
    assert!(with(limit * (1.0 - 1e-6)).is_ok());
    let refused = attempt("0", (Vertical::Force(force), Rotational::Eccentricity(2e-3)));
    let Err(Error::LiftsOff { field: "eccentricity", limit, .. }) = refused else { panic!() };
    close(limit, A / 3.0, 1e-12, "eccentricity");
    // The edge of a rounded punch is free: there is no such moment.
    let refused = attempt("x^2", (Vertical::Force(1.0), Rotational::Tilt(1e-6)));
    assert!(matches!(refused, Err(Error::LiftsOff { field: "tilt", limit: 0.0, .. })));
    // Bilateral contact may pull.
    let load = (Vertical::Force(force), Rotational::Moment(2.0 * limit * force));
    assert!(solve_bilateral("0", load).pressure(-0.9 * A).unwrap() < 0.0);
}

#[test]
fn a_parabola_lifts_where_its_pressure_ends() {
    // p0 w = (E*/pi)[(delta - a^2/R) + 2 w^2/R], |p1| w = (2/pi) E* alpha r: at the corner alpha = (delta - a^2/R)/(2 a)
    let radius = 2.0;
    let delta = 3.0 * A * A / radius;
    let exact = (delta - A * A / radius) / (2.0 * A);
    let with = |tilt: f64| attempt("x^2/4", (Vertical::Settlement(delta), Rotational::Tilt(tilt)));
    let Err(Error::LiftsOff { limit, .. }) = with(1.5 * exact) else { panic!() };
    close(limit, exact, 1e-11, "limit");
    assert!(with(0.999 * exact).is_ok() && with(-1.001 * exact).is_err());
    // A hollow base, f = -x^2/4: d = delta + x^2/R; p0 w = (E*/pi)[delta + a^2/R - 2 w^2/R], lowest over r at r^2 = R delta'/2 ..
    let hollow = 3.0 * A * A / radius;
    let share = |r: f64| (hollow + A * A / radius - 2.0 * (A * A - r * r) / radius) / (2.0 * r);
    let exact = (1..=5000).map(|i| share(A * f64::from(i) / 5000.0)).fold(f64::INFINITY, f64::min);
    let with =
        |tilt: f64| attempt("-x^2/4", (Vertical::Settlement(hollow), Rotational::Tilt(tilt)));
    let Err(Error::LiftsOff { limit, .. }) = with(2.0 * exact) else { panic!() };
    close(limit, exact, 1e-7, "limit of a hollow base");
}

#[test]
fn the_tilt_does_not_change_the_rest() {
    let straight = problem(
        Profile::expression("x^2/4").unwrap(),
        0.0,
        (Vertical::Force(2e5), Rotational::Tilt(0.0)),
        Solver::bilateral(),
    );
    let one = straight.solve().unwrap();
    let two = solve_bilateral("x^2/4", (Vertical::Force(2e5), Rotational::Tilt(1e-4)));
    close(two.settlement(), one.settlement(), 1e-15, "settlement");
    let mean = 0.5 * (two.pressure(2e-3).unwrap() + two.pressure(-2e-3).unwrap());
    close(mean, one.pressure(2e-3).unwrap(), 1e-13, "mean");
}
