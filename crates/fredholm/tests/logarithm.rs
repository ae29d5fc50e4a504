//! Kernel 1 solved by two independent methods, against each other and against references.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;

use fredholm::kernel::{Logarithm, SpectralRelation};
use fredholm::{DegenerateSystem, SincOperator};

/// Settlement, end and centre pressure of the parabola at `lambda0 = 100`, `nu = 0.25`, `P0 = 0.001`, symmetric part.
fn parabola(projections: [f64; 2], ends: [f64; 2], middles: [f64; 2], lambda0: f64) -> [f64; 3] {
    // p = delta phi_1 - lambda0 phi_2, int p = P0
    let delta = (0.001 + lambda0 * projections[1]) / projections[0];
    [delta, delta * ends[0] - lambda0 * ends[1], delta * middles[0] - lambda0 * middles[1]]
}

fn by_sinc(lambda0: f64, half_count: usize) -> [f64; 3] {
    let operator = SincOperator::new(&Logarithm::unit(), half_count).unwrap();
    let x: Vec<f64> = operator.positions().collect();
    let right = vec![vec![1.0; x.len()], x.iter().map(|x| x * x).collect()];
    let solutions = operator.solve(15.0 / (8.0 * PI) * lambda0, &right).unwrap();
    let [one, square] = &solutions[..] else { unreachable!() };
    parabola(
        [one.integral(|_| 1.0), square.integral(|_| 1.0)],
        [one.evaluate(1.0, 1.0), square.evaluate(1.0, 1.0)],
        [one.evaluate(0.0, 1.0), square.evaluate(0.0, 0.0)],
        lambda0,
    )
}

fn by_degenerate_kernel(lambda0: f64, degree: usize) -> [f64; 3] {
    let kernel = Logarithm::unit();
    let system = DegenerateSystem::new(&kernel, 15.0 / (8.0 * PI) * lambda0, degree).unwrap();
    let one = system.solve(&kernel.moments(&|_| 1.0, degree + 1).unwrap().values);
    let square = system.solve(&kernel.moments(&|x| x * x, degree + 1).unwrap().values);
    parabola(
        [one.projections()[0], square.projections()[0]],
        [one.evaluate(1.0, 1.0), square.evaluate(1.0, 1.0)],
        [one.evaluate(0.0, 1.0), square.evaluate(0.0, 0.0)],
        lambda0,
    )
}

#[test]
fn sinc_collocation_gives_the_reference_digits() {
    // NumPy prototype of the same equation, 141 nodes, and the spectral method at n = 1638400 (to its 10-12 digits).
    let [delta, end, middle] = by_sinc(100.0, 70);
    assert!((delta - 49.2156124973957).abs() < 1e-11, "{delta}");
    assert!((end + 8.99524832047766).abs() < 1e-11, "{end}");
    assert!((middle - 0.523837336836152).abs() < 1e-11, "{middle}");
}

#[test]
fn degenerate_kernel_gives_the_references_of_its_own_truncation() {
    // f0 = lambda0 xi^2, n = 45: an independent NumPy solution of (3.5)
    let [delta, end, middle] = by_degenerate_kernel(100.0, 45);
    assert!((delta - 49.21673898).abs() < 5e-9, "{delta}");
    assert!((end + 8.64769504).abs() < 5e-9, "{end}");
    assert!((middle - 0.51711269).abs() < 5e-9, "{middle}");
}

#[test]
fn degenerate_kernel_converges_with_the_orders_of_the_theory() {
    let exact = by_sinc(10.0, 70);
    let error = |degree| {
        let found = by_degenerate_kernel(10.0, degree);
        [0, 1, 2].map(|i| (found[i] - exact[i]).abs())
    };
    let (coarse, fine) = (error(400), error(800));
    for (i, order) in [4.0, 2.0, 3.0].into_iter().enumerate() {
        let observed = (coarse[i] / fine[i]).log2();
        assert!((observed - order).abs() < 0.15, "quantity {i}: order {observed}");
    }
}

#[test]
fn both_methods_satisfy_the_scaling_of_the_interval() {
    // On (-a, a): K_a(ax, as) = K_1(x, s) - ln a, so a theta shifts by the force.
    let (a, lambda) = (0.37, 4.0);
    let (kernel, unit) = (Logarithm::new(a).unwrap(), Logarithm::unit());
    let degree = 300;
    let short = DegenerateSystem::new(&kernel, lambda, degree).unwrap();
    let p = short.solve(&kernel.moments(&f64::exp, degree + 1).unwrap().values);
    let force = p.projections()[0];
    let scaled = DegenerateSystem::new(&unit, lambda * a, degree).unwrap();
    let shift = lambda * force * a.ln();
    let q = scaled.solve(&unit.moments(&|x| (a * x).exp() + shift, degree + 1).unwrap().values);
    for xi in [-1.0, -0.4, 0.0, 0.9, 1.0] {
        let (left, right) =
            (p.evaluate(a * xi, (a * xi).exp()), q.evaluate(xi, (a * xi).exp() + shift));
        assert!((left - right).abs() < 1e-12, "xi = {xi}: {left} {right}");
    }
    let operator = SincOperator::new(&kernel, 50).unwrap();
    let f: Vec<f64> = operator.positions().map(f64::exp).collect();
    let s = &operator.solve(lambda, &[f]).unwrap()[0];
    assert!((s.integral(|_| 1.0) - force).abs() < 1e-9);
}

#[test]
fn systems_that_are_not_positive_agree_with_collocation() {
    // A negative parameter; a negative eigenvalue; an eigenvalue that vanishes.
    for (a, lambda) in [(1.0, -0.2), (1.0, -1.3), (2.5, 0.4), (10.0, -0.3), (2.0, 1.0), (2.0, -0.7)]
    {
        let kernel = Logarithm::new(a).unwrap();
        let system = DegenerateSystem::new(&kernel, lambda, 500).unwrap();
        assert!(!system.is_positive() || lambda > 0.0 || a == 1.0);
        let f = |x: f64| 1.0 + (x / a).powi(3);
        let spectral = system.solve(&kernel.moments(&f, 501).unwrap().values);
        let operator = SincOperator::new(&kernel, 70).unwrap();
        let sinc = &operator.solve(lambda, &[operator.sample(f).unwrap()]).unwrap()[0];
        let scale = sinc.values().iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        assert!((spectral.projections()[0] - sinc.integral(|_| 1.0)).abs() < 1e-8 * a * scale);
        for x in [-a, -0.4 * a, 0.0, 0.9 * a, a] {
            let (one, two) = (spectral.evaluate(x, f(x)), sinc.evaluate(x, f(x)));
            assert!(
                (one - two).abs() < 2e-4 * scale,
                "a = {a}, lambda = {lambda}, x = {x}: {one} {two}"
            );
        }
    }
}

#[test]
fn a_parameter_in_the_spectrum_is_refused() {
    let kernel = Logarithm::unit();
    // The response to 1 goes through infinity and changes its sign where -1/lambda is an eigenvalue.
    let response = |lambda: f64| {
        let system = DegenerateSystem::new(&kernel, lambda, 40)?;
        Ok(system.solve(&kernel.moments(&|_| 1.0, 41)?.values).projections()[0])
    };
    let (mut inside, mut outside) = (-0.1, -1.0);
    for _ in 0..200 {
        let middle = 0.5 * (inside + outside);
        match response(middle) {
            Ok(value) if value > 0.0 => inside = middle,
            Ok(_) => outside = middle,
            Err(error) => {
                assert!(matches!(error, fredholm::Error::Singular { .. }), "{error}");
                return;
            }
        }
    }
    panic!("never singular between {inside} and {outside}");
}

#[test]
fn bad_parameters_and_huge_degrees_are_refused() {
    let kernel = Logarithm::unit();
    for parameter in [f64::NAN, f64::INFINITY] {
        assert!(DegenerateSystem::new(&kernel, parameter, 8).is_err());
    }
    for degree in [100_000_000, usize::MAX - 1] {
        let error = DegenerateSystem::new(&kernel, 1.0, degree).unwrap_err();
        assert!(matches!(error, fredholm::Error::TooLarge { .. }), "{error}");
    }
    assert!(Logarithm::new(0.0).is_err() && Logarithm::new(f64::NAN).is_err());
}
