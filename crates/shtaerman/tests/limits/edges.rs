//! Edges of the contact near the smooth limit.

use std::f64::consts::{LN_2, PI};

use crate::limits::support::PARABOLA;

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;

fn near(one: f64, other: f64, tolerance: f64, what: &str) {
    assert!((one - other).abs() <= tolerance * other.abs(), "{what}: {one} {other}");
}

#[test]
fn edges_of_the_parabola() {
    // a/a_H = 1 + c [ln(1/c) + gamma + 4 ln 2 - 1]/(2 pi), c = chi E*/a_H: recognised in digits found numerically, 0.3739830
    let exact = (EULER + 4.0 * LN_2 - 1.0) / (2.0 * PI);
    let hertz = PARABOLA.solve(0.0).zones()[0][1];
    near(hertz, (4.0 / (16.0 * PI)).sqrt(), 1e-12, "Hertz");
    let constant = |c: f64| {
        let edge = PARABOLA.solve(c * hertz).zones()[0][1];
        (edge / hertz - 1.0) / c - (1.0 / c).ln() / (2.0 * PI)
    };
    for (c, tolerance) in [(1e-4, 2e-6), (1e-5, 3e-7), (1e-6, 1e-6)] {
        let found = constant(c);
        assert!((found - exact).abs() < tolerance, "{c:e}: {found}");
    }
}
