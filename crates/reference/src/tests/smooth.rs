use std::f64::consts::{LN_2, PI};

use crate::{Break, Kernel, Layer, Problem, Reference, Rotational, Vertical};

const BASE: [[f64; 2]; 1] = [[-1.0, 1.0]];
const RADIUS: [[f64; 2]; 1] = [[0.0, 1.0]];
/// `theta = 2/(pi E*) = 1`
const MODULUS: f64 = 2.0 / PI;

fn problem<'a>(
    kernel: Kernel<'static>,
    pieces: &'a [[f64; 2]],
    base: &'a dyn Fn(f64) -> f64,
    force: f64,
    rotational: Rotational,
) -> Problem<'a> {
    Problem {
        kernel,
        theta: 1.0,
        layer: Layer::None,
        pieces,
        is_bilateral: false,
        vertical: Vertical::Force(force),
        rotational,
        base,
        breaks: &[],
    }
}

fn flat(_: f64) -> f64 {
    0.0
}

/// Pressures are the closed form within the error stated, and that is small.
fn check(found: &Reference<'_>, truth: &dyn Fn(f64) -> f64, places: &[f64]) {
    for x in places {
        let [p, error] = found.pressure(*x);
        assert!((p - truth(*x)).abs() <= error, "{x}: {p} +-{error} {}", truth(*x));
        assert!(error < 2e-9 * p.max(0.1), "{x}: {p} +-{error}");
    }
}

#[test]
fn flat_punches() {
    // Sadowsky; in the gauge ln(a/|x-s|) delta = P ln 2, alpha = -2 M.
    let turned = problem(Kernel::Logarithm, &BASE, &flat, 1.0, Rotational::Moment(0.2));
    let found = turned.solve(None).unwrap();
    check(&found, &|x| (1.0 + 0.4 * x) / (PI * (1.0 - x * x).sqrt()), &[0.0, 0.3, 0.99, -0.9999]);
    assert!((found.settlement - LN_2).abs() <= found.errors.settlement);
    assert!((found.tilt + 0.4).abs() <= found.errors.tilt);
    // For |M| > P a/2 half-length b = 2 (a - |M|/P), p = P/(pi b) sqrt((b+y)/(b-y)) (Johnson 2.8).
    let lifting = problem(Kernel::Logarithm, &BASE, &flat, 1.0, Rotational::Moment(0.7));
    let found = lifting.solve(None).unwrap();
    let truth = |x: f64| ((0.2 + x).max(0.0) / (1.0 - x)).sqrt() / (PI * 0.6);
    check(&found, &truth, &[0.0, 0.3, 0.99, -0.15, -0.3]);
    assert!((found.zones[0][0] + 0.2).abs() <= found.errors.ends.max(1e-12));
    // Two punches: p = P |x|/(pi sqrt((a^2-x^2)(x^2-b^2)))
    let pieces = [[-1.0, -0.4], [0.4, 1.0]];
    let pair = problem(Kernel::Logarithm, &pieces, &flat, 1.0, Rotational::Moment(0.0));
    let truth = |x: f64| x.abs() / (PI * ((1.0 - x * x) * (x * x - 0.16)).sqrt());
    check(&pair.solve(None).unwrap(), &truth, &[0.5, 0.7, 0.999]);
    // A row (Koiter): p = (P/L) cos psi/sqrt(s^2 - sin^2 psi)
    let row = Kernel::Row { period: 3.0 };
    let punches = problem(row, &BASE, &flat, 1.0, Rotational::Moment(0.0));
    let end = (PI / 3.0).sin().powi(2);
    let truth = |x: f64| (PI * x / 3.0).cos() / (end - (PI * x / 3.0).sin().powi(2)).sqrt() / 3.0;
    check(&punches.solve(None).unwrap(), &truth, &[0.5, 0.7, 0.999]);
}

#[test]
fn round_and_sharp_bases() {
    // Hertz: p = sqrt(a^2 - x^2)/(pi R), P = a^2/(2 R)
    let parabola = |x: f64| 2.0 * (x - 0.1) * (x - 0.1);
    let hertz = problem(Kernel::Logarithm, &BASE, &parabola, 0.5, Rotational::Moment(0.05));
    let truth = |x: f64| 4.0 / PI * (0.25f64 - (x - 0.1).powi(2)).max(0.0).sqrt();
    check(&hertz.solve(None).unwrap(), &truth, &[0.1, 0.3, 0.59, -0.35]);
    // Wedge (Johnson 5.2): P = a E* t, p = (E* t/pi) arccosh(a/|x|)
    let wedge = |x: f64| x.abs();
    let breaks = [Break { at: 0.0, is_sharp: true }];
    let sharp = problem(Kernel::Logarithm, &BASE, &wedge, 0.3, Rotational::Moment(0.0));
    let sharp = Problem { breaks: &breaks, ..sharp };
    let a = 0.3 / MODULUS;
    let truth = |x: f64| MODULUS / PI * (a / x.abs()).max(1.0).acosh();
    check(&sharp.solve(None).unwrap(), &truth, &[0.01, 0.3, 0.4, -0.2, 0.6]);
}

#[test]
fn waves() {
    // In full contact the first mode of the pressure is that of the base.
    let wave = Kernel::Row { period: 2.0 };
    let crest = |x: f64| 0.5 * (1.0 - (PI * x).cos());
    let full = problem(wave, &BASE, &crest, 3.0, Rotational::Tilt(0.0));
    check(&full.solve(None).unwrap(), &|x| 1.5 + 0.5 * (PI * x).cos(), &[0.5, -0.1, 0.99]);
    // Westergaard: P = L p* s^2, s = sin(pi a/L), p = 2 P/L cos psi sqrt(s^2 - sin^2 psi)/s^2, p* = 1/2; with the valley in the middle the zone goes over the seam.
    let square = 0.3;
    let truth =
        |psi: f64| 0.5 * 2.0 * psi.cos().abs() * (square - psi.sin().powi(2)).max(0.0).sqrt();
    let open = problem(wave, &BASE, &crest, square, Rotational::Tilt(0.0));
    check(&open.solve(None).unwrap(), &|x| truth(0.5 * PI * x), &[0.3, -0.1, 0.01, 0.5]);
    let valley = |x: f64| 0.5 * (1.0 + (PI * x).cos());
    let seam = problem(wave, &BASE, &valley, square, Rotational::Tilt(0.0));
    check(&seam.solve(None).unwrap(), &|x| truth(0.5 * PI * (1.0 - x)), &[0.8, -0.9, 0.99, 0.5]);
}

#[test]
fn disks() {
    let disk = Kernel::Disk { exponent: 0.0, harmonic: 0 };
    // Boussinesq: p = P/(2 pi a sqrt(a^2 - r^2)), delta = P/(2 a E*)
    let flat_ended = problem(disk, &RADIUS, &flat, 1.0, Rotational::Tilt(0.0));
    let found = flat_ended.solve(None).unwrap();
    check(&found, &|r| 1.0 / (2.0 * PI * (1.0 - r * r).sqrt()), &[0.0, 0.5, 0.99]);
    assert!((found.settlement - 0.5 / MODULUS).abs() <= found.errors.settlement);
    // Hertz: P = 4/3 E* a^3/R, p = 2 E*/(pi R) sqrt(a^2 - r^2), R = 1/2, a = 0.6
    let ball = |r: f64| r * r;
    let force = 8.0 / 3.0 * MODULUS * 0.216;
    let sphere = problem(disk, &RADIUS, &ball, force, Rotational::Tilt(0.0));
    let truth = |r: f64| 4.0 * MODULUS / PI * (0.36 - r * r).max(0.0).sqrt();
    check(&sphere.solve(None).unwrap(), &truth, &[0.0, 0.5, 0.59, 0.7]);
    // Tilted: p = -(2/pi) E* alpha r/sqrt(a^2 - r^2), M = -(4/3) E* a^3 alpha
    let kernel = Kernel::Disk { exponent: 0.0, harmonic: 1 };
    let tilted = problem(kernel, &RADIUS, &flat, 0.0, Rotational::Tilt(-0.3));
    let tilted = Problem { is_bilateral: true, vertical: Vertical::Settlement(0.0), ..tilted };
    let found = tilted.solve(None).unwrap();
    let truth = |r: f64| 0.6 / PI * MODULUS * r / (1.0 - r * r).sqrt();
    check(&found, &truth, &[0.01, 0.5, 0.99]);
    assert!((found.moment - 0.4 * MODULUS).abs() <= found.errors.moment);
}

#[test]
fn graded_ground() {
    // p = P Gamma(1 + mu/2)/(sqrt(pi) Gamma((1+mu)/2)) (1 - x^2)^((mu-1)/2) (Popov, Hess, Willert 2019, 9)
    let kernel = Kernel::Power { exponent: 0.3 };
    let strip = problem(kernel, &BASE, &flat, 1.0, Rotational::Moment(0.0));
    let lead = libm::tgamma(1.15) / (PI.sqrt() * libm::tgamma(0.65));
    check(&strip.solve(None).unwrap(), &|x| lead * (1.0 - x * x).powf(-0.35), &[0.0, 0.5, 0.99]);
}
