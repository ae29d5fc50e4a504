use std::f64::consts::PI;

use crate::{Break, Kernel, Layer, Problem, Reference, Refusal, Rotational, Vertical, potential};

const BASE: [[f64; 2]; 1] = [[-1.0, 1.0]];

fn problem<'a>(
    kernel: Kernel<'static>,
    theta: f64,
    base: &'a dyn Fn(f64) -> f64,
    vertical: Vertical,
    rotational: Rotational,
) -> Problem<'a> {
    Problem {
        kernel,
        theta,
        layer: Layer::Linear,
        pieces: &BASE,
        is_bilateral: false,
        vertical,
        rotational,
        base,
        breaks: &[],
    }
}

fn near(found: f64, truth: f64, allowed: f64) {
    assert!((found - truth).abs() <= allowed, "{found} {truth} {:e}", found - truth);
}

fn even(found: &Reference<'_>, pressure: f64) {
    for x in [0.01, 0.3, 0.9, 0.9999, 1.0] {
        let [p, error] = found.pressure(x);
        near(p, pressure, error);
        assert!(error < 1e-12, "{x} {error}");
    }
}

#[test]
fn bases_that_press_evenly() {
    // The base is less by the potential of an even pressure.
    let linear = Vertical::Settlement(5.0);
    for theta in [0.3, 8.0] {
        let part = |y: f64| if y > 0.0 { y * y.ln() } else { 0.0 };
        let line = |x: f64| 4.0 - theta * (2.0 - part(1.0 + x) - part(1.0 - x));
        let plane = problem(Kernel::Logarithm, theta, &line, linear, Rotational::Tilt(0.0));
        even(&plane.solve(None).unwrap(), 1.0);
        // 2 E(r) with E = K (1 - sum 2^(n-1) c_n^2)
        let round = |r: f64| 4.0 - 2.0 * theta * complete(r);
        let kernel = Kernel::Disk { exponent: 0.0, harmonic: 0 };
        let disk = Problem {
            pieces: &[[0.0, 1.0]],
            vertical: Vertical::Force(PI),
            ..problem(kernel, theta, &round, linear, Rotational::Tilt(0.0))
        };
        let found = disk.solve(None).unwrap();
        even(&found, 1.0);
        near(found.settlement, 5.0, found.errors.settlement);
        // Under a law p^(1/2) one as well.
        let law = Problem { layer: Layer::Power { exponent: 0.5 }, base: &round, ..disk };
        even(&law.solve(None).unwrap(), 1.0);
        let law = Problem { layer: Layer::Power { exponent: 0.5 }, base: &line, ..plane };
        even(&law.solve(None).unwrap(), 1.0);
    }
}

#[test]
fn graded_ground() {
    // p = (1 - x^2)^2, whose potential bends little at the ends; potentials have tests of their own.
    let kernel = Kernel::Power { exponent: 0.4 };
    let pressure = |x: f64| (1.0 - x * x).powi(2);
    let cuts = [[-1.0, 0.0], [0.0, 1.0]];
    let base = |x: f64| 4.0 - pressure(x) - 3.0 * potential(&kernel, &cuts, &pressure, x);
    let posed = problem(kernel, 3.0, &base, Vertical::Force(16.0 / 15.0), Rotational::Moment(0.0));
    let posed = Problem { is_bilateral: true, ..posed };
    let found = posed.solve(None).unwrap();
    near(found.settlement, 4.0, found.errors.settlement);
    for x in [-0.999, -0.3, 0.1, 0.8] {
        let [p, error] = found.pressure(x);
        near(p, pressure(x), error);
        assert!(error < 1e-12, "{error}");
    }
}

/// The complete elliptic integral of the second kind by the arithmetic-geometric mean.
fn complete(k: f64) -> f64 {
    let (mut a, mut b, mut c) = (1.0, ((1.0 - k) * (1.0 + k)).sqrt(), k);
    if b == 0.0 {
        return 1.0;
    }
    let (mut sum, mut power) = (0.0, 0.5);
    for _ in 0..12 {
        sum += power * c * c;
        power *= 2.0;
        (a, b, c) = (0.5 * (a + b), (a * b).sqrt(), 0.5 * (a - b));
    }
    0.5 * PI / a * (1.0 - sum)
}

#[test]
fn rough_waves_by_their_modes() {
    // p_m = -f_m/(1 + theta L/(2 m)), L = 2
    let wave = |x: f64| 0.3 * (PI * x).cos() - 0.2 * (2.0 * PI * x).sin();
    let kernel = Kernel::Row { period: 2.0 };
    let (force, tilt) = (Vertical::Force(4.0), Rotational::Tilt(0.0));
    let posed = problem(kernel, 3.0, &wave, force, tilt);
    let found = posed.solve(None).unwrap();
    for x in [-1.0, -0.7, 0.0, 0.35, 0.99] {
        let truth = 2.0 - 0.3 / 4.0 * (PI * x).cos() + 0.2 / 2.5 * (2.0 * PI * x).sin();
        let [p, error] = found.pressure(x);
        near(p, truth, error);
        assert!(error < 1e-13, "{error}");
    }
}

#[test]
fn a_rough_cylinder() {
    // Half-width and largest pressure over Hertz's, from double-precision collocation and two programs of boundary elements (8 digits): E* = R = 1, P = pi/4e-4.
    for (layer, width, pressure) in
        [(0.01, 1.01107, 0.996834), (0.1, 1.0741908, 0.96991644), (1.0, 1.39306501, 0.802671925)]
    {
        // In units of 4 a_H: xi^2 16 a_H^2/2 over chi E*.
        let (unit, chi) = (0.04, layer * 0.01);
        let base = |x: f64| x * x * unit * unit / (2.0 * chi);
        let theta = 2.0 * unit / (PI * chi);
        let force = PI / 4.0 * 1e-4 / unit;
        let posed = problem(
            Kernel::Logarithm,
            theta,
            &base,
            Vertical::Force(force),
            Rotational::Moment(0.0),
        );
        let found = posed.solve(None).unwrap();
        let digits = if layer < 0.1 { 6e-6 } else { 6e-8 };
        near(found.zones[0][1] * 4.0, width, digits);
        near(found.pressure(0.0)[0] / 0.005, pressure, digits);
        assert!(found.errors.ends < 1e-11 && found.violation[1] < 1e-11, "{:?}", found.errors);
    }
}

#[test]
fn full_contact_by_exact_moments() {
    // theta0 = 13, f = x^4 - x/2, P = 1.7, M = -0.31, bilateral: a NumPy program with exact Legendre moments of the logarithm on 82 panels of 16 nodes.
    let base = |x: f64| x.powi(4) - 0.5 * x;
    let (force, moment) = (Vertical::Force(1.7), Rotational::Moment(-0.31));
    let posed = problem(Kernel::Logarithm, 13.0, &base, force, moment);
    let posed = Problem { is_bilateral: true, ..posed };
    let found = posed.solve(None).unwrap();
    near(found.settlement, 16.95675016351342, 1e-13);
    near(found.tilt, 9.273582756401433, 1e-13);
    for (x, p) in [(-1.0, 5.8572946), (0.0, 0.57572613), (0.5, 0.54712293), (1.0, 2.50177744)] {
        near(found.pressure(x)[0], p, 6e-9);
    }
}

#[test]
fn several_zones_keep_the_conditions() {
    let base = |x: f64| x.abs() + 0.3 * (9.0 * x).cos();
    let breaks = [Break { at: 0.0, is_sharp: true }];
    let posed =
        problem(Kernel::Logarithm, 2.0, &base, Vertical::Force(0.4), Rotational::Eccentricity(0.1));
    let posed = Problem { breaks: &breaks, ..posed };
    let found = posed.solve(None).unwrap();
    assert!(found.zones.len() > 1, "{:?}", found.zones);
    assert!(found.violation.iter().all(|v| *v < 1e-11), "{:?}", found.violation);
    near(found.moment, 0.04, 1e-14);
    // The same displacements are the same contact.
    let held = Problem {
        vertical: Vertical::Settlement(found.settlement),
        rotational: Rotational::Tilt(found.tilt),
        ..posed
    };
    let held = held.solve(None).unwrap();
    near(held.force, 0.4, held.errors.force + 1e-13);
    near(held.moment, 0.04, held.errors.moment + 1e-13);
}

#[test]
fn refuses_what_is_too_large() {
    let base = |x: f64| 1e-3 * (900.0 * x).sin();
    let posed = problem(Kernel::Logarithm, 2.0, &base, Vertical::Force(1.0), Rotational::Tilt(0.0));
    let bilateral = Problem { is_bilateral: true, ..posed };
    assert!(matches!(bilateral.solve(None), Err(Refusal::TooLarge { .. })));
    let level = |_: f64| 0.0;
    let clear = Problem { vertical: Vertical::Settlement(-1.0), base: &level, ..posed };
    assert!(matches!(clear.solve(None), Err(Refusal::NoContact | Refusal::ZonesNotFound)));
}

#[test]
fn a_dent_bends_the_pressure_beside_it() {
    // Panels beside the dent must be as short: otherwise two resolutions agree on what is wrong. With the dent in two halves, cut in its middle or not, the answers are alike.
    let base = |x: f64| 3.0 * (x * x + 0.07 * (-((x + 0.49752) / 2.47e-4).powi(2)).exp());
    let mild = |places: &[f64]| -> Vec<Break> {
        places.iter().map(|at| Break { at: *at, is_sharp: false }).collect()
    };
    let (one, other) = (mild(&[-0.499, -0.49752, -0.496]), mild(&[-0.51, -0.4985, -0.4972]));
    let (force, moment) = (Vertical::Force(0.7), Rotational::Moment(-0.4));
    let posed = problem(Kernel::Logarithm, 10.0, &base, force, moment);
    let [first, second] =
        [&one, &other].map(|breaks| Problem { breaks, ..posed }.solve(None).unwrap().settlement);
    near(first, second, 1e-12);
}
