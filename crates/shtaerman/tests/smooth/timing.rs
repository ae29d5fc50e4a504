//! Timing, by hand.
use crate::support::{With, balanced, level, punch};
use std::time::Instant;

#[test]
fn timing() {
    let f = |x: f64| 8.0 * x * x + 0.1 * x.powi(3);
    for (name, problem) in [
        ("parabola", punch(1.0, f, balanced(1.0, 0.1))),
        ("flat", punch(1.0, |_| 0.0, balanced(1.0, 0.1))),
        ("full", punch(1.0, |x: f64| 0.1 * x * x, balanced(1.0, 0.1))),
        ("wave", punch(1.0, |x: f64| -0.3 * (3.14159265358979 * x).cos(), level(0.2)).period(2.0)),
        ("pair", punch(1.0, |x: f64| x * x, balanced(1.0, 0.1)).gap(0.2)),
        (
            "many",
            punch(
                1.0,
                |x: f64| 0.5 * (1.0 - (40.0 * x + 0.3).cos()) + 0.3 * x * x,
                balanced(0.5, 0.05),
            ),
        ),
    ] {
        problem.solve().unwrap();
        let start = Instant::now();
        let contact = problem.solve().unwrap();
        println!(
            "TIME {name} {:?} zones {} modes {} err {:e}",
            start.elapsed(),
            contact.zones().len(),
            contact.modes(),
            contact.relative_error()
        );
    }
}
