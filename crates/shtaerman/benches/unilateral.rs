//! Times of unilateral contact and of its audit on one thread: `cargo bench --workspace --bench unilateral`.

#![allow(clippy::unwrap_used, reason = "a benchmark may fail by panicking")]
#![allow(missing_docs, reason = "a benchmark has no readers")]

use std::hint::black_box;
use std::time::Instant;

use shtaerman::{
    Elastic, Foundation, Geometry, Grading, Load, Problem, Profile, Punch, Rotational, Vertical,
};

fn main() {
    shtaerman::keep_freed_blocks();
    println!("{:<58} {:>12} {:>12}", "one thread, best of many, milliseconds", "solve", "audit");
    let force = Vertical::Force(1.0);
    let centric = Rotational::Moment(0.0);
    // Rough parabola with chi E*/a_H = 1: theta0 = 2 a/(pi a_H), f0 = 2 theta0 P0 (a/a_H)^2 xi^2, here with a = 4 a_H.
    let theta0 = 8.0 / std::f64::consts::PI;
    let parabola = format!("{}*xi^2", 32.0 * theta0);
    let wedge = format!("{}*abs(xi)", 4.0 * theta0);
    time("parabola, chi E*/a_H = 1", &expression(theta0, &parabola, centric));
    let eccentric = Load::new(force, Rotational::Eccentricity(0.6)).unwrap();
    time("flat punch, eccentricity 0.6, theta0 = 30", &problem(30.0, Profile::flat(), eccentric));
    time("wedge, theta0 = 2.5", &expression(theta0, &wedge, centric));
    let general = format!("{}*(xi^2 + 0.3*xi^4 + 0.2*sin(xi))", 32.0 * theta0);
    time("general profile, theta0 = 2.5", &expression(theta0, &general, centric));
    rough_elsewhere(theta0, &parabola);
    smooth();
    smooth_graded();
    let waves = format!("{}*(xi^2 + 0.2*cos(14*xi))", 2.0 * theta0);
    time("waves, several zones, theta0 = 2.5", &expression(theta0, &waves, centric));
    let load = Load::new(force, Rotational::Moment(0.2)).unwrap();
    for theta0 in [1.0, 30.0, 1000.0] {
        time(
            &format!("measured profile, 10,000 points, theta0 = {theta0}"),
            &problem(theta0, measured(theta0), load),
        );
    }
}

/// Other geometries and laws with a rough layer.
fn rough_elsewhere(theta0: f64, parabola: &str) {
    let load = Load::new(Vertical::Force(1.0), Rotational::Moment(0.0)).unwrap();
    let solve = |name: &str, geometry: Geometry, theta0: f64, exponent: f64, parabola: &str| {
        let (foundation, punch) = (
            Foundation::dimensionless(theta0).unwrap().with_exponent(exponent).unwrap(),
            Punch::in_geometry(geometry, 1.0).unwrap(),
        );
        let profile = Profile::expression(parabola).unwrap();
        time(name, &Problem::new(foundation, punch.with_profile(profile), load).unwrap());
    };
    solve("circular parabola, theta0 = 2.5", Geometry::Circular, theta0, 1.0, parabola);
    solve("parabola, power law, exponent 0.5", Geometry::Plane, theta0, 0.5, parabola);
    let steep = format!("{}*xi^2", 32.0 * 1e10);
    solve("parabola, nearly smooth, theta0 = 1e10", Geometry::Plane, 1e10, 1.0, &steep);
}

/// Smooth surfaces, `E* = 1`, `a = 1`.
fn smooth() {
    let solve = |name: &str, geometry: Geometry, profile: &str, force: f64, moment: f64| {
        let body = Elastic::new(1.0, 0.0).unwrap();
        let (foundation, punch) = (
            Foundation::new(body).with_roughness(0.0).unwrap(),
            Punch::in_geometry(geometry, 1.0).unwrap(),
        );
        let load = Load::new(Vertical::Force(force), Rotational::Moment(moment)).unwrap();
        let profile = Profile::expression(profile).unwrap();
        time(name, &Problem::new(foundation, punch.with_profile(profile), load).unwrap());
    };
    let plane = Geometry::Plane;
    solve("smooth parabola", plane, "x^2", 0.4, 0.0);
    solve("smooth wedge", plane, "0.5*abs(x)", 0.25, 0.0);
    solve("smooth flat punch with moment", plane, "0", 1.0, 0.3);
    solve("smooth flat punch that tips up", plane, "0", 1.0, 0.7);
    solve("smooth general profile", plane, "x^2 + 0.3*x^4 + 0.2*sin(x)", 0.3, 0.0);
    solve("smooth circular parabola", Geometry::Circular, "x^2", 0.4, 0.0);
    solve("smooth wave", Geometry::Periodic { period: 2.0 }, "-0.1*cos(pi*x)", 0.1, 0.0);
}

/// Smooth surfaces on graded ground, `E = y^0.3`, `a = 1`.
fn smooth_graded() {
    let solve = |name: &str, geometry: Geometry, profile: &str, force: f64, moment: f64| {
        let grading = Grading::new(0.3, 1.0).unwrap();
        let (foundation, punch) = (
            Foundation::graded(grading, 0.3).unwrap().with_roughness(0.0).unwrap(),
            Punch::in_geometry(geometry, 1.0).unwrap(),
        );
        let load = Load::new(Vertical::Force(force), Rotational::Moment(moment)).unwrap();
        let profile = Profile::expression(profile).unwrap();
        time(name, &Problem::new(foundation, punch.with_profile(profile), load).unwrap());
    };
    let plane = Geometry::Plane;
    solve("smooth parabola, graded", plane, "x^2", 0.1, 0.0);
    solve("smooth wedge, graded", plane, "0.5*abs(x)", 0.05, 0.0);
    solve("smooth wedge off the middle, graded", plane, "0.5*abs(x - 0.2)", 0.05, 0.0);
    solve("smooth wedge hardly off the middle, graded", plane, "0.5*abs(x)", 0.05, 5e-11);
    solve("smooth flat that tips up, graded", plane, "0", 0.05, 0.035);
    solve("smooth flat with rounded ends, graded", plane, "max(abs(x) - 0.2, 0)^2", 0.05, 0.0);
    solve("smooth general profile, graded", plane, "x^2 + 0.3*x^4 + 0.2*sin(x)", 0.1, 0.0);
    solve("smooth waves, several zones, graded", plane, "x^2 + 0.02*cos(20*x)", 0.0005, 0.0);
    solve("smooth wedges, two zones, graded", plane, "abs(abs(x) - 0.3)/5", 0.004, 0.0);
    solve("smooth circular parabola, graded", Geometry::Circular, "x^2", 0.1, 0.0);
    solve("smooth circular cone, graded", Geometry::Circular, "0.5*abs(x)", 0.05, 0.0);
}

/// Best time of one call, if the name has the part that the command line asks for, if any.
fn time(name: &str, problem: &Problem) {
    let is_flag = |argument: &String| argument.starts_with('-');
    let mut wanted = std::env::args().skip(1).filter(|argument| !is_flag(argument));
    if wanted.next().is_some_and(|part| !name.contains(&part)) {
        return;
    }
    let solve = best(&|| drop(black_box(problem.solve().unwrap())));
    let contact = problem.solve().unwrap();
    let (audited, bound) = match contact.audit() {
        Ok(_) => (
            format!("{:>12.3}", 1e3 * best(&|| drop(black_box(contact.audit())))),
            format!(", by the audit {:.1e}", contact.clone().with_audit().relative_error()),
        ),
        Err(_) => (format!("{:>12}", "none"), String::new()),
    };
    println!(
        "{name:<58} {:>12.3} {audited}   {} zones, {}, {} nodes, error {:.1e}{bound}",
        1e3 * solve,
        contact.dimensionless().zones().len(),
        contact.method().name,
        contact.method().n,
        contact.relative_error()
    );
}

/// Seconds of the quickest of the calls that a second has room for.
fn best(call: &dyn Fn()) -> f64 {
    let (mut best, mut spent) = (f64::INFINITY, 0.0);
    while spent < 1.0 {
        let start = Instant::now();
        call();
        let time = start.elapsed().as_secs_f64();
        best = best.min(time);
        spent += time;
    }
    best
}

fn problem(theta0: f64, profile: Profile, load: Load) -> Problem {
    Problem::new(
        Foundation::dimensionless(theta0).unwrap(),
        Punch::new(1.0).unwrap().with_profile(profile),
        load,
    )
    .unwrap()
}

fn expression(theta0: f64, profile: &str, rotational: Rotational) -> Problem {
    let load = Load::new(Vertical::Force(1.0), rotational).unwrap();
    problem(theta0, Profile::expression(profile).unwrap(), load)
}

/// A crowned base with waves whose amplitudes fall as their number to the power -3/2, and noise at each point.
fn measured(theta0: f64) -> Profile {
    const POINTS: i32 = 10_000;
    let positions: Vec<f64> =
        (0..POINTS).map(|i| 2.0 * f64::from(i) / f64::from(POINTS - 1) - 1.0).collect();
    let height = |(i, x): (usize, &f64)| {
        let waves: f64 = (1..=100)
            .map(f64::from)
            .map(|k| 0.5 * k.powf(-1.5) * (3.1 * k * x + k * k).sin())
            .sum();
        let noise = 0.005 * (1e4 * (i as f64).sin()).fract();
        2.0 * (1.0 + theta0) * (0.3 * x * x + waves + noise)
    };
    let heights = positions.iter().enumerate().map(height).collect();
    Profile::from_points(positions, heights).unwrap()
}
