//! Every kernel passes the suite, with the parameters that hurt.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use fredholm::conformance;
use fredholm::kernel::{
    EndExponents, Expansion, Gram, Kernel, Logarithm, LogarithmRatio, LogarithmRatioLimit,
    LogarithmSine, LogarithmSquare, Macdonald, MacdonaldHalfLine, Parity, Power, Singularity,
    SpectralRelation, Split, WeberSonine, Yukawa,
};
use fredholm::{Error, Interval};

fn require(name: &str, kernel: &dyn Kernel, relation: &dyn SpectralRelation, count: usize) {
    require_within(conformance::LIMIT, name, kernel, relation, count);
}

fn require_within(
    limit: f64,
    name: &str,
    kernel: &dyn Kernel,
    relation: &dyn SpectralRelation,
    count: usize,
) {
    let report = conformance::run_with(kernel, relation, count, limit).unwrap();
    assert!(report.passes(), "{name}, {count} eigenfunctions:\n{report}");
    println!("{name}, {count} eigenfunctions\n{report}");
}

#[test]
fn kernel_1_logarithm() {
    for (a, gauge) in [(1.0, 1.0), (0.3, 1.0), (1.9, 1.0), (50.0, 60.0), (1e-6, 1.0)] {
        let kernel = Logarithm::with_gauge(a, gauge).unwrap();
        for count in [20, 200] {
            require(&format!("a = {a}"), &kernel, &kernel, count);
        }
    }
}

/// A point of `(b, a)` is known to `eps a/(a - b)` of the interval, and `phi_200` turns 200 times as fast.
fn rounding(b: f64, a: f64) -> f64 {
    conformance::LIMIT.max(200.0 * f64::EPSILON * a / (a - b))
}

#[test]
fn kernel_2_ratio() {
    for (b, a) in [(0.25, 1.0), (1.0, 2.0), (1e-6, 1.0), (0.999, 1.0), (1e-2, 40.0)] {
        let kernel = LogarithmRatio::new(b, a).unwrap();
        for count in [20, 200] {
            require_within(rounding(b, a), &format!("b = {b}, a = {a}"), &kernel, &kernel, count);
        }
    }
    for a in [1.0, 30.0] {
        let kernel = LogarithmRatioLimit::new(a).unwrap();
        require(&format!("b = 0, a = {a}"), &kernel, &kernel, 200);
    }
}

#[test]
fn kernel_2_companion() {
    for (b, a) in [(0.25, 1.0), (0.0, 1.0), (1e-6, 1.0), (0.999, 1.0), (2.0, 5.0)] {
        let kernel = LogarithmSquare::new(b, a).unwrap();
        require_within(rounding(b, a), &format!("b = {b}, a = {a}"), &kernel, &kernel, 200);
    }
}

#[test]
fn kernel_3_sine() {
    for alpha in [1e-3, 0.3, 1.5, 2.8, 3.1] {
        let kernel = LogarithmSine::new(alpha).unwrap();
        for count in [20, 200] {
            require(&format!("alpha = {alpha}"), &kernel, &kernel, count);
        }
    }
}

#[test]
fn kernel_4_power() {
    for (mu, a) in [(0.3, 1.0), (0.49, 2.5), (0.9, 1.0), (1e-3, 1.0), (1e-9, 1.0), (0.7, 1e-3)] {
        let kernel = Power::new(Interval::symmetric(a).unwrap(), mu).unwrap();
        for count in [20, 200] {
            require(&format!("mu = {mu}, a = {a}"), &kernel, &kernel, count);
        }
    }
}

#[test]
fn kernel_5_macdonald() {
    for (mu, kappa, a) in [
        (0.2, 1.0, 1.0),
        (0.0, 1.0, 1.0),
        (-0.3, 2.0, 1.0),
        (0.45, 0.5, 1.0),
        (-0.45, 1.0, 1.0),
        (0.1, 1e-2, 1.0),
        (0.0, 40.0, 1.0),
        (0.1, 4.0, 10.0),
    ] {
        let kernel = Macdonald::new(a, mu, kappa).unwrap();
        let relation = kernel.relation(TERMS).unwrap();
        for count in [20, 200] {
            let name = format!("mu = {mu}, kappa = {kappa}, a = {a}");
            require(&name, &kernel, &relation, count);
        }
    }
}

#[test]
fn kernel_5_half_line() {
    for (mu, kappa) in
        [(0.3, 1.0), (0.0, 1.0), (1e-9, 1.0), (-0.4, 2.0), (0.45, 0.5), (-0.45, 30.0)]
    {
        let kernel = MacdonaldHalfLine::new(mu, kappa).unwrap();
        for count in [20, 100] {
            require(&format!("mu = {mu}, kappa = {kappa}"), &kernel, &kernel, count);
        }
    }
}

#[test]
fn kernel_6_weber_sonine() {
    for (mu, gamma, a) in [
        (0.0, 0.0, 1.0),
        (1.0, 0.0, 1.0),
        (5.0, 0.0, 2.0),
        (0.0, 0.25, 1.0),
        (0.0, -0.4, 1.0),
        (0.0, 0.49, 1.0),
        (0.0, -0.49, 1.0),
        (0.0, 1e-6, 1.0),
        (0.5, 0.2, 1.0),
        (2.5, -0.1, 1e-2),
        (5.0, 0.45, 1.0),
    ] {
        let kernel = WeberSonine::new(a, mu, gamma).unwrap();
        for count in [20, 200] {
            let name = format!("mu = {mu}, gamma = {gamma}, a = {a}");
            require(&name, &kernel, &kernel, count);
        }
    }
}

#[test]
fn kernel_7_yukawa() {
    for (chi0, m, a) in
        [(1.0, 0, 1.0), (10.0, 0, 1.0), (1.0, 1, 1.0), (2.5, 5, 2.0), (40.0, 2, 1.0)]
    {
        let kernel = Yukawa::new(a, chi0, m).unwrap();
        let relation = kernel.relation(TERMS).unwrap();
        for count in [20, 200] {
            require(&format!("chi0 = {chi0}, m = {m}, a = {a}"), &kernel, &relation, count);
        }
    }
}

/// Terms that the bilinear sum takes to reach its limit.
const TERMS: usize = 500;

/// What is false about a kernel.
#[derive(Clone, Copy, PartialEq)]
enum Fault {
    Eigenvalue,
    Norm,
    Weight,
    Gram,
    Split,
    Asymmetry,
}

struct Faulty {
    kernel: Logarithm,
    fault: Fault,
}

impl Faulty {
    fn slip(&self, fault: Fault) -> f64 {
        if self.fault == fault { 1.0 + 1e-9 } else { 1.0 }
    }
}

impl Kernel for Faulty {
    fn interval(&self) -> Interval {
        self.kernel.interval()
    }
    fn singularity(&self) -> Singularity {
        self.kernel.singularity()
    }
    fn split(&self, x: f64, s: f64, distance: f64) -> Split {
        let mut split = self.kernel.split(x, s, distance);
        if self.fault == Fault::Split && distance == 0.0 {
            split.rest += 1e-3;
        }
        if self.fault == Fault::Asymmetry && x > s {
            split.rest += 1e-12;
        }
        split
    }
    fn is_even(&self) -> bool {
        true
    }
}

impl SpectralRelation for Faulty {
    fn weight_exponents(&self) -> EndExponents {
        self.kernel.weight_exponents()
    }
    fn weight_rest(&self, n: usize, x: f64) -> f64 {
        if self.fault == Fault::Weight { 1.0 + 1e-9 * x } else { self.kernel.weight_rest(n, x) }
    }
    fn eigenvalue(&self, n: usize) -> f64 {
        self.kernel.eigenvalue(n) * self.slip(Fault::Eigenvalue)
    }
    fn expansion_factor(&self, n: usize) -> f64 {
        self.kernel.expansion_factor(n)
    }
    fn norm(&self, n: usize) -> f64 {
        self.kernel.norm(n) * self.slip(Fault::Norm)
    }
    fn parity(&self) -> Parity {
        self.kernel.parity()
    }
    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        self.kernel.eigenfunctions(x, values);
    }
    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        self.kernel.sum(coefficients, x)
    }
    fn gram(&self, count: usize) -> Result<Gram, Error> {
        let gram = self.kernel.gram(count)?;
        let entry = |i: usize| gram.entry(i / count, i % count) * self.slip(Fault::Gram);
        Ok(Gram::Dense { order: count, entries: (0..count * count).map(entry).collect() })
    }
    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        self.kernel.expand(f)
    }
}

#[test]
fn the_suite_finds_small_faults() {
    for (fault, names) in [
        (Fault::Eigenvalue, &["relation"][..]),
        (Fault::Norm, &["norms"]),
        (Fault::Weight, &["relation", "orthogonality"]),
        (Fault::Gram, &["Gram matrix"]),
        (Fault::Split, &["split at the diagonal"]),
        (Fault::Asymmetry, &["symmetry"]),
    ] {
        let faulty = Faulty { kernel: Logarithm::unit(), fault };
        let report = conformance::run(&faulty, &faulty, 20).unwrap();
        let failed: Vec<&str> =
            report.checks.iter().filter(|check| !check.passes()).map(|check| check.name).collect();
        for name in names {
            assert!(failed.contains(name), "{name}:\n{report}");
        }
    }
}

/// A smooth kernel by its values.
struct Smooth(fn(f64, f64) -> f64);

impl Kernel for Smooth {
    fn interval(&self) -> Interval {
        Interval::unit()
    }
    fn singularity(&self) -> Singularity {
        Singularity::None
    }
    fn split(&self, x: f64, s: f64, _distance: f64) -> Split {
        Split { factor: 0.0, rest: (self.0)(x, s) }
    }
}

/// What is small on the diagonal, or at a place of it, is held against its size beside it.
#[test]
fn smooth_kernels_may_vanish_on_the_diagonal() {
    let good: [fn(f64, f64) -> f64; 4] =
        [|x, s| (x - s).powi(2), |x, s| x + s, |x, s| x * s, |x, s| (x - s).cos() - 1.0];
    for kernel in good {
        let report = conformance::check_kernel(&Smooth(kernel)).unwrap();
        assert!(report.passes(), "{report}");
    }
    let other: fn(f64, f64) -> f64 = |x, s| if x == s { 0.0 } else { 1.0 + x * s };
    assert!(!conformance::check_kernel(&Smooth(other)).unwrap().passes());
}
