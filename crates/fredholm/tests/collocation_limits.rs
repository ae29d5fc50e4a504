//! Where collocation must say no, or how far it got.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use fredholm::collocation::{Estimate, SincGrid, solve_adaptive, solve_adaptive_with_breaks};
use fredholm::kernel::{Kernel, Logarithm, Power, Singularity, Split};
use fredholm::{Error, Interval, SincOperator};

#[test]
fn the_estimate_sees_what_happens_between_nodes() {
    // cos(400 x): force and end values are right long before the values between the nodes.
    let (kernel, f) = (Logarithm::unit(), |x: f64| (400.0 * x).cos());
    let solve = |half_count: usize| {
        let operator = SincOperator::new(&kernel, half_count).unwrap();
        operator.factor(1.0).unwrap().solve(&operator.sample(f).unwrap()).unwrap()
    };
    let exact = solve(2400);
    let points: Vec<f64> = (0..2000).map(|i| f64::from(i) * 1e-3 - 0.9995).collect();
    for half_count in [300, 500, 700] {
        let (coarse, fine) = (solve(half_count * 2 / 3), solve(half_count));
        let estimate = Estimate::between(&coarse, &fine).unwrap();
        let error = points
            .iter()
            .map(|&x| (fine.evaluate(x, f(x)) - exact.evaluate(x, f(x))).abs())
            .fold(0.0, f64::max);
        println!(
            "{half_count}: estimate {:.1e} true {error:.1e}; force differs by {:.1e}",
            estimate.solution, estimate.integral
        );
        assert!(estimate.solution > 0.5 * error);
    }
    let found = solve_adaptive(&kernel, 1.0, f, 1e-9).unwrap();
    let error = points
        .iter()
        .map(|&x| (found.solution.evaluate(x, f(x)) - exact.evaluate(x, f(x))).abs())
        .fold(0.0, f64::max);
    println!("adaptive: {} {:?} true {error:.1e}", found.half_count, found.estimate);
    assert!(error <= found.estimate.solution);
}

#[test]
fn a_kink_is_solved_with_a_breakpoint_and_found_without() {
    let kernel = Logarithm::unit();
    let kink = |x: f64| (x - 0.37).abs();
    let exact = solve_adaptive_with_breaks(&kernel, &[0.37], 10.0, kink, 1e-12).unwrap();
    assert!(exact.converged);
    let blind = solve_adaptive(&kernel, 10.0, kink, 1e-10).unwrap();
    let error = (-100..=100)
        .map(|i| f64::from(i) * 0.01)
        .map(|x| {
            let f = kink(x);
            (blind.solution.evaluate(x, f) - exact.solution.evaluate(x, f)).abs()
        })
        .fold(0.0, f64::max);
    println!("half count {}: true {error:.1e}, {:?}", blind.half_count, blind.estimate);
    assert!(blind.converged && error < blind.estimate.solution);
}

#[test]
fn narrow_features_between_the_nodes_are_seen() {
    let kernel = Logarithm::unit();
    // Wide enough for the places between the nodes, far too narrow for the nodes; in the middle, where every grid has a node, as well.
    for (centre, width) in [(-0.6686, 0.000_997), (0.3, 4e-4), (0.0, 0.001), (0.9995, 3e-4)] {
        let f = |x: f64| 1.0 + 0.3 * (-((x - centre) / width).powi(2)).exp();
        let breaks: Vec<f64> =
            [-8.0, 0.0, 8.0].into_iter().map(|k| centre + k * width).filter(|x| *x < 1.0).collect();
        let exact = solve_adaptive_with_breaks(&kernel, &breaks, 4.08, f, 1e-12).unwrap().solution;
        let found = solve_adaptive(&kernel, 4.08, f, 1e-12).unwrap();
        let error = (-1000..=1000)
            .map(|i| f64::from(i) * 0.001)
            .chain((-40..=40).map(|i| (centre + 0.1 * f64::from(i) * width).min(1.0)))
            .map(|x| (found.solution.evaluate(x, f(x)) - exact.evaluate(x, f(x))).abs())
            .fold(0.0, f64::max);
        let integral = (found.solution.integral(|_| 1.0) - exact.integral(|_| 1.0)).abs();
        assert!(found.converged, "{centre}: {:?}", found.estimate);
        assert!(error <= found.estimate.solution && integral <= found.estimate.integral);
    }
}

#[test]
fn hopeless_tolerances_end_soon_and_say_so() {
    let kernel = Logarithm::unit();
    for parameter in [1e9, 1e15, 1e300] {
        let found = solve_adaptive(&kernel, parameter, f64::exp, 1e-13).unwrap();
        assert!(!found.converged, "{parameter}: {:?}", found.estimate);
    }
    let nothing = solve_adaptive(&kernel, 10.0, |_| 0.0, 1e-12).unwrap();
    assert!(nothing.converged && nothing.solution.integral(|_| 1.0) == 0.0);
    let identity = solve_adaptive(&kernel, 0.0, f64::exp, 1e-12).unwrap();
    assert!(identity.converged && identity.solution.evaluate(0.2, 3.0) == 3.0);
}

struct Broken(f64);

impl Kernel for Broken {
    fn interval(&self) -> Interval {
        Interval::unit()
    }
    fn singularity(&self) -> Singularity {
        Singularity::None
    }
    fn split(&self, x: f64, _s: f64, _distance: f64) -> Split {
        Split { factor: 0.0, rest: if x > 0.5 { self.0 } else { 1.0 } }
    }
}

#[test]
fn bad_input_is_refused_with_its_value() {
    let kernel = Logarithm::unit();
    for half_count in [0, 3, 4001, usize::MAX] {
        assert!(matches!(
            SincOperator::new(&kernel, half_count),
            Err(Error::InvalidParameter { name: "half_count", .. })
        ));
    }
    for range in [f64::NAN, 0.0, -3.0, 7.0, f64::INFINITY] {
        assert!(SincGrid::with_range(10, range).is_err());
    }
    for point in [f64::NAN, f64::INFINITY, -1.0, 1.0, 2.0, 1.0 - 1e-15] {
        let error = SincOperator::with_breaks(&kernel, 10, &[0.0, point]).unwrap_err();
        assert!(matches!(error, Error::InvalidParameter { name: "breakpoint", .. }), "{error}");
    }
    let many: Vec<f64> = (1..1000).map(|i| f64::from(i) * 0.002 - 1.0).collect();
    assert!(SincOperator::with_breaks(&kernel, 10, &many).is_err());
    assert!(solve_adaptive_with_breaks(&kernel, &many, 1.0, f64::exp, 1e-8).is_err());
    for value in [f64::NAN, f64::INFINITY] {
        let error = SincOperator::new(&Broken(value), 10).unwrap_err();
        assert!(
            matches!(error, Error::NotFinite { what: "kernel", at, .. } if at > 0.5),
            "{error}"
        );
    }
    let operator = SincOperator::new(&kernel, 10).unwrap();
    for parameter in [f64::NAN, f64::INFINITY] {
        assert!(operator.factor(parameter).is_err());
        assert!(operator.spectrum().unwrap().solve(parameter, &[0.0; 21]).is_err());
        assert!(operator.spectrum().unwrap().sweep(&[0.0; 21], [0.0; 2], parameter).is_err());
        assert!(solve_adaptive(&kernel, parameter, f64::exp, 1e-8).is_err());
    }
    let error = operator.solve(1.0, &[vec![0.0; 20]]).unwrap_err();
    assert!(matches!(error, Error::WrongLength { found: 20, expected: 21, .. }), "{error}");
    assert!(matches!(operator.sample(f64::ln), Err(Error::NotFinite { .. })));
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(solve_adaptive(&kernel, 1.0, f64::exp, tolerance).is_err());
    }
    for exponent in [0.0, 1.0, -0.2, f64::NAN] {
        assert!(Power::new(Interval::unit(), exponent).is_err());
    }
}

#[test]
fn points_outside_and_nan_do_not_panic() {
    let operator = SincOperator::with_breaks(&Logarithm::unit(), 20, &[0.1]).unwrap();
    let solution = operator.solve(1.0, &[vec![1.0; operator.count()]]).unwrap().remove(0);
    assert!(solution.evaluate(f64::NAN, 1.0).is_nan());
    for (outside, end) in [(f64::INFINITY, 1.0), (3.0, 1.0), (-1e300, -1.0)] {
        assert_eq!(
            solution.evaluate(outside, 1.0).to_bits(),
            solution.evaluate(end, 1.0).to_bits()
        );
    }
}

#[test]
fn strong_powers_lose_accuracy_but_not_finiteness() {
    for exponent in [1e-9, 0.9, 0.97, 0.999] {
        let kernel = Power::new(Interval::unit(), exponent).unwrap();
        let operator = SincOperator::new(&kernel, 200).unwrap();
        let solution = operator.solve(1.0, &[vec![1.0; operator.count()]]).unwrap().remove(0);
        assert!(solution.values().iter().all(|value| value.is_finite()), "{exponent}");
        assert!((-10..=10).all(|i| solution.evaluate(f64::from(i) * 0.1, 1.0).is_finite()));
    }
}
