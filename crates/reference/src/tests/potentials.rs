use std::f64::consts::PI;

use libm::tgamma;

use crate::{Kernel, Transferred, potential};

/// `x`, `d`, `mu`, `m`, value: mpmath 1.3, 30 digits, `2^mu Gamma((1+mu)/2)/Gamma((1-mu)/2)` times the integral over the angle from 0 to pi of `|x - s e^(i phi)|^-(1+mu) cos(m phi)`.
#[allow(clippy::excessive_precision, reason = "digits as the other program printed them")]
const KERNELS: [(f64, f64, f64, u8, f64); 10] = [
    (0.3, 0.2, 0.0, 0, 7.00301521166301005),
    (0.3, 0.2, 0.0, 1, 2.21780272311352187),
    (0.9, -0.89, 0.0, 1, 0.0193934451167757902),
    (0.5, 1e-09, 0.0, 0, 44.2191203539134831),
    (0.5, 1e-09, 0.0, 1, 40.2191203579134831),
    (0.3, 0.2, 0.4, 0, 5.89420391779085382),
    (0.3, 0.2, 0.4, 1, 2.58985483482833834),
    (0.7, -0.65, 0.4, 1, 0.148631325699836203),
    (0.5, 1e-06, 0.7, 0, 18679.3567353120388),
    (0.5, -1e-06, 0.2, 1, 128.519921571269917),
];

fn close(found: f64, truth: f64, allowed: f64) {
    assert!((found - truth).abs() <= allowed * truth.abs().max(1.0), "{found} {truth}");
}

#[test]
fn of_constants() {
    // int_{-1}^{1} -ln|x-s| ds = 2 - (1+x) ln(1+x) - (1-x) ln(1-x); int |x-s|^-mu = ((1+x)^(1-mu) + (1-x)^(1-mu))/(1-mu)
    let part = |y: f64| if y > 0.0 { y * y.ln() } else { 0.0 };
    for x in [-1.0, -1.0 + 1e-14, -0.3, 0.0, 1e-9, 0.9999, 1.0] {
        let panels = [[-1.0, 0.25], [0.25, 1.0]];
        let found = potential(&Kernel::Logarithm, &panels, &|_| 1.0, x);
        close(found, 2.0 - part(1.0 + x) - part(1.0 - x), 2e-15);
        for mu in [0.05f64, 0.5, 0.9] {
            let found = potential(&Kernel::Power { exponent: mu }, &panels, &|_| 1.0, x);
            let truth = ((1.0 + x).powf(1.0 - mu) + (1.0 - x).powf(1.0 - mu)) / (1.0 - mu);
            close(found, truth, 1e-14 / (1.0 - mu));
        }
        // The mean mode of a row is 0, the k-th is L/(2 k).
        let kernel = Kernel::Row { period: 2.0 };
        close(potential(&kernel, &panels, &|_| 1.0, x), 0.0, 6e-15);
        let wave = |s: f64| (2.0 * PI * s + 0.3).cos();
        close(potential(&kernel, &panels, &wave, x), 0.5 * wave(x), 6e-15);
    }
}

#[test]
fn of_disks() {
    // Boussinesq: a uniform pressure on the unit disk gives 2 E(r), the parameter being the modulus; int_0^1 of it at r = 0, 1: pi and 2.
    let kernel = Kernel::Disk { exponent: 0.0, harmonic: 0 };
    let panels = [[0.0, 0.5], [0.5, 1.0]];
    close(potential(&kernel, &panels, &|_| 1.0, 0.0), PI, 2e-15);
    close(potential(&kernel, &panels, &|_| 1.0, 1.0), 2.0, 2e-15);
    // E(1/2) by mpmath: ellipe(0.25) = 1.46746220933942715545979526699
    close(potential(&kernel, &panels, &|_| 1.0, 0.5), 2.0 * 1.467_462_209_339_427_2, 2e-15);
    close(potential(&kernel, &panels, &|_| 1.0, 1e-9), PI, 2e-15);
    // On the axis of graded ground, a uniform pressure: pi 2^mu Gamma((1+mu)/2)/Gamma((1-mu)/2)/(1-mu); beyond 0.89 parts of the kernel there would overflow.
    for mu in [0.2, 0.6, 0.9, 0.94] {
        let strength = PI * f64::exp2(mu) * tgamma(0.5 * (1.0 + mu)) / tgamma(0.5 * (1.0 - mu));
        let kernel = Kernel::Disk { exponent: mu, harmonic: 0 };
        let found = potential(&kernel, &panels, &|_| 1.0, 0.0);
        close(found, strength / (1.0 - mu), 1e-14 / (1.0 - mu));
    }
    // The graded kernel tends to the homogeneous one, of both harmonics.
    for harmonic in [0, 1] {
        for (x, d) in [(0.3, 0.2), (0.7, -0.69), (0.5, 1e-3), (0.4, 0.6)] {
            let plain = Kernel::Disk { exponent: 0.0, harmonic }.value(x, d);
            let near = |mu: f64| Kernel::Disk { exponent: mu, harmonic }.value(x, d);
            let limit = 2.0 * near(1e-4) - near(2e-4);
            close(limit / plain, 1.0, 1e-5);
        }
    }
    // By mpmath, pi int t^mu J_m(x t) J_m(s t) dt as an integral over the angle.
    for (x, d, mu, harmonic, truth) in KERNELS {
        let found = Kernel::Disk { exponent: mu, harmonic }.value(x, d) / (x + d);
        assert!((found / truth - 1.0).abs() < 2e-14, "{x} {d} {mu} {harmonic}: {found} {truth}");
    }
}

#[test]
fn of_square_roots() {
    let mut panels = vec![];
    for k in 0..110 {
        let (from, to) = (0.5f64.powi(k + 1), 0.5f64.powi(k));
        panels.push([from, to]);
    }
    // int_0^1 s^(-1/2) (-ln s) ds = 4
    close(potential(&Kernel::Logarithm, &panels, &|s| 1.0 / s.sqrt(), 0.0), 4.0, 1e-14);
}

/// `M = 1 - c exp(-2u)` is a line with its image: `ln(1/t) + (c/2) ln(4 + t^2)`; `M = tanh u` is `ln coth(pi t/4)`.
#[test]
fn of_transfer_functions() {
    for h in [0.01, 0.6, 30.0] {
        for c in [1.0, 0.4, -3.0] {
            let image = Transferred::new(h, 1.0 - c, &|u| 1.0 - c * (-2.0 * u).exp(), 2.0);
            let flat = Transferred::new(h, 0.0, &f64::tanh, 2.0);
            for d in [1e-9, 3e-3, 0.2, 0.77, 1.3, 2.0] {
                let t: f64 = d / h;
                let far = 0.5 * (4.0 / (t * t)).ln_1p();
                let exact = c * far - (1.0 - c) * d.ln();
                close(image.value(d), exact, 2e-14 * (1.0 + exact.abs()));
                close(flat.value(d), (2.0 / (0.5 * PI * t).exp_m1()).ln_1p(), 1e-13);
            }
        }
    }
}
