//! Estimates against closed forms: `p = sqrt(c^2 - r^2)` has `int K_0 p s ds = pi^2/8 (2 c^2 - r^2)` for `r < c` (H. Hertz, J. reine angew. Math. 92 (1882) 156), and less beyond.

use std::f64::consts::PI;

use crate::closed::Base;
use crate::{Answer, Bound, DiskProblem, Prescribed, audit_disk};

/// A base on homogeneous ground that may lift off, under a force or a settlement.
fn problem(base: &Base, theta: f64, force: Option<f64>) -> DiskProblem<'_> {
    DiskProblem {
        exponent: 0.0,
        theta,
        layer: base.kappa,
        scaled: 0.0,
        is_bilateral: false,
        prescribed: Prescribed { force, moment: None },
        profile: base,
        cuts: &[],
    }
}

/// What is stated of an answer that is off by `size` in its own way, beside what is true.
fn judged(base: &Base, theta: f64, size: f64, by_force: bool) -> (Bound, [f64; 3]) {
    let exact = |r: f64| ((base.c - r) * (base.c + r)).max(0.0).sqrt();
    let pressure = |r: f64| exact(r.abs()) * (1.0 + size * (3.0 * r.abs() + 0.4).cos());
    let settlement = 2.0 * base.bend * base.c * base.c;
    let force = 2.0 * PI / 3.0 * base.c.powi(3);
    let problem = problem(base, theta, by_force.then_some(force));
    let off = if by_force { size } else { 0.0 };
    // The force of the disturbed pressure, by a rule of its own: r = c sin t.
    let count = 4000;
    let own: f64 = (0..count)
        .map(|k| {
            let t = 0.5 * PI * (f64::from(k) + 0.5) / f64::from(count);
            let r = base.c * t.sin();
            2.0 * PI * pressure(r) * r * base.c * t.cos() * 0.5 * PI / f64::from(count)
        })
        .sum();
    let answer = Answer {
        zones: &[[-base.c, base.c]],
        pressure: &pressure,
        settlement: settlement + off,
        tilt: 0.0,
        force: if by_force { force } else { own },
        moment: 0.0,
    };
    let bound = audit_disk(&problem, &answer).unwrap();
    let worst = (0..=1000)
        .map(|k| base.c * f64::from(k) / 1000.0)
        .map(|r| (pressure(r) - exact(r)).abs())
        .fold(0.0, f64::max);
    (bound, [worst, off, if by_force { 0.0 } else { (own - force).abs() }])
}

#[test]
fn disturbed_answers_are_found_out() {
    for (c, theta, kappa) in [
        (1.0, 1.0, 1.0),
        (1.0, 60.0, 1.0),
        (0.6, 2.0, 1.0),
        (0.6, 200.0, 1.0),
        (1.0, 3.0, 0.5),
        (0.7, 3.0, 0.8),
    ] {
        let base = Base { c, bend: theta * PI * PI / 8.0, kappa };
        for by_force in [true, false] {
            for size in [0.0, 1e-9, 1e-4] {
                let (bound, [pressure, settlement, force]) = judged(&base, theta, size, by_force);
                println!(
                    "{c} {theta} {kappa} {by_force} {size:e}: {pressure:e} {force:e} {bound:?}"
                );
                // The truth is known to rounding.
                let slack = 1e-15 * (1.0 + theta);
                assert!(bound.pressure >= pressure - slack, "{pressure:e}");
                assert!(bound.settlement >= settlement - slack, "{settlement:e}");
                assert!(bound.force >= force - slack - 1e-6 * size, "{force:e}");
                if size > 0.0 {
                    let most = 20.0 * (1.0 + theta);
                    assert!(bound.pressure <= most * pressure + 1e-12 * theta, "idle {pressure:e}");
                } else {
                    assert!(bound.pressure <= 1e-11 * (1.0 + theta), "idle without an error");
                }
            }
        }
    }
}

#[test]
fn edges_are_near_where_they_are() {
    let base = Base { c: 0.6, bend: 2.0 * PI * PI / 8.0, kappa: 1.0 };
    let (bound, _) = judged(&base, 2.0, 0.0, true);
    assert!(bound.ends.is_some_and(|ends| ends < 1e-7), "{bound:?}");
}

/// An answer that is off in a layer beside the axis, where no node of a panel lies: it has no weight in any integral.
#[test]
fn layers_beside_the_axis_are_seen() {
    let (theta, off) = (2.0, 1e-9);
    let base = Base { c: 1.0, bend: theta * PI * PI / 8.0, kappa: 1.0 };
    for width in [1e-6, 1e-5] {
        let layer = |r: f64| off * (-(r / width).powi(2)).exp();
        let pressure = |r: f64| ((1.0 - r) * (1.0 + r)).max(0.0).sqrt() + layer(r);
        let problem = problem(&base, theta, None);
        let answer = Answer {
            zones: &[[-1.0, 1.0]],
            pressure: &pressure,
            settlement: 2.0 * base.bend,
            tilt: 0.0,
            force: 2.0 * PI / 3.0,
            moment: 0.0,
        };
        let bound = audit_disk(&problem, &answer).unwrap();
        assert!(bound.pressure >= 0.9 * off && bound.pressure < 30.0 * off, "{width:e}: {bound:?}");
    }
}
