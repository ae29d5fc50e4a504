use std::f64::consts::PI;

use crate::{Break, Kernel, Layer, Problem, Reference, Rotational, Vertical};

fn plane<'a>(
    theta: f64,
    base: &'a dyn Fn(f64) -> f64,
    vertical: Vertical,
    rotational: Rotational,
) -> Problem<'a> {
    Problem {
        kernel: Kernel::Logarithm,
        theta,
        layer: Layer::Linear,
        pieces: &[[-1.0, 1.0]],
        is_bilateral: false,
        vertical,
        rotational,
        base,
        breaks: &[],
    }
}

fn show(name: &str, r: &Reference<'_>, begin: std::time::Instant) {
    println!(
        "{name}: {:?} n {} zones {:?} delta {} alpha {} P {} M {} {:?} viol {:?} p0 {:?}",
        begin.elapsed(),
        r.unknowns,
        r.zones,
        r.settlement,
        r.tilt,
        r.force,
        r.moment,
        r.errors,
        r.violation,
        r.pressure(0.1)
    );
}

#[test]
fn dbg() {
    let begin = std::time::Instant::now();
    let f = |x: f64| x.powi(4) - 0.5 * x;
    let mut p = plane(13.0, &f, Vertical::Force(1.7), Rotational::Moment(-0.31));
    p.is_bilateral = true;
    show("python main", &p.solve(None).unwrap(), begin);
    let begin = std::time::Instant::now();
    let f = |x: f64| 3.0 * x * x + 0.2 * (7.0 * x).sin();
    for theta in [0.05, 1.0, 60.0, 1e4] {
        let p = plane(theta, &f, Vertical::Force(1.7), Rotational::Moment(-0.31));
        show("uni", &p.solve(None).unwrap(), begin);
    }
    let f = |x: f64| x.abs() + 0.3 * (20.0 * x).cos();
    let breaks = [Break { at: 0.0, is_sharp: true }];
    let mut p = plane(5.0, &f, Vertical::Force(1.7), Rotational::Tilt(0.1));
    p.breaks = &breaks;
    let begin = std::time::Instant::now();
    show("zones", &p.solve(None).unwrap(), begin);
    let begin = std::time::Instant::now();
    p.layer = Layer::Power { exponent: 0.5 };
    show("power", &p.solve(None).unwrap(), begin);
    let begin = std::time::Instant::now();
    p.layer = Layer::Linear;
    p.kernel = Kernel::Power { exponent: 0.4 };
    show("graded", &p.solve(None).unwrap(), begin);
    let begin = std::time::Instant::now();
    p.kernel = Kernel::Row { period: 2.0 };
    p.rotational = Rotational::Tilt(0.0);
    show("wave", &p.solve(None).unwrap(), begin);
    p.kernel = Kernel::Disk { exponent: 0.0, harmonic: 0 };
    p.pieces = &[[0.0, 1.0]];
    p.breaks = &[];
    let begin = std::time::Instant::now();
    show("disk", &p.solve(None).unwrap(), begin);
    assert!(PI > 0.0);
}
