//! The audit of solutions of the second kind against differences of methods that share nothing with it.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use fredholm::equation::{Solution, audit, collocate, degenerate};
use fredholm::kernel::{
    Kernel, Logarithm, LogarithmRatio, LogarithmRatioLimit, LogarithmSine, LogarithmSquare,
    Macdonald, Power, SpectralRelation, WeberSonine, Yukawa,
};
use fredholm::{Error, Interval};

type Both = (Box<dyn Kernel>, Box<dyn SpectralRelation>);

/// A kernel with its relation, and the power with which natural right-hand sides begin at the axis of a disk.
fn kernels() -> Vec<(Both, i32)> {
    fn closed<K: SpectralRelation + Clone + 'static>(kernel: K) -> Both {
        (Box::new(kernel.clone()), Box::new(kernel))
    }
    let macdonald = Macdonald::new(1.2, 0.1, 3.0).unwrap();
    let yukawa = Yukawa::new(1.0, 1.5, 1).unwrap();
    vec![
        (closed(Logarithm::new(0.8).unwrap()), 0),
        (closed(LogarithmRatio::new(0.3, 1.7).unwrap()), 0),
        (closed(LogarithmRatioLimit::new(1.3).unwrap()), 1),
        (closed(LogarithmSquare::new(0.1, 1.1).unwrap()), 0),
        (closed(LogarithmSine::new(2.9).unwrap()), 0),
        (closed(Power::new(Interval::symmetric(1.0).unwrap(), 0.35).unwrap()), 0),
        ((Box::new(macdonald.clone()), Box::new(macdonald.relation(120).unwrap())), 0),
        (closed(WeberSonine::new(1.0, 1.0, 0.1).unwrap()), 1),
        ((Box::new(yukawa.clone()), Box::new(yukawa.relation(120).unwrap())), 1),
    ]
}

/// The largest difference of two solutions from end to end, denser there.
fn difference(kernel: &dyn Kernel, one: &Solution<'_>, other: &Solution<'_>) -> f64 {
    let interval = kernel.interval();
    let (centre, half) = (interval.centre(), interval.half_length());
    (0..=3000)
        .map(|i| centre - half * (f64::from(i) / 3000.0 * std::f64::consts::PI).cos())
        .map(|x| x.clamp(interval.left(), interval.right()))
        .map(|x| (one.evaluate(x) - other.evaluate(x)).abs())
        .fold(0.0, f64::max)
}

#[test]
fn degenerate_kernels_are_no_worse_than_the_audit_says() {
    for (index, ((kernel, relation), power)) in kernels().into_iter().enumerate() {
        for lambda in [0.3, 7.0, 90.0] {
            let f = |x: f64| x.powi(power) * (1.0 + 0.4 * x + (3.0 * x).cos());
            let exact = collocate(&*kernel, lambda, &f, &[], 1e-12).unwrap();
            let rough = degenerate(&*relation, lambda, &f, 40).unwrap();
            let found = audit(&*kernel, lambda, &f, [&[], &[]], &rough).unwrap();
            let error = difference(&*kernel, &rough, &exact);
            let integral = (rough.integral.unwrap() - exact.integral.unwrap()).abs();
            println!("{index} {lambda}: {error:.1e} {found:?}");
            assert!(error <= found.solution && integral <= found.integral);
            assert!(found.least <= error && found.solution < 300.0 * error);
            // Of the good solution it says that it is good.
            let found = audit(&*kernel, lambda, &f, [&[], &[]], &exact).unwrap();
            assert!(
                found.mean_square < 1e-11 && found.integral < 2e-11,
                "{index} {lambda}: {found:?}"
            );
            assert!(found.solution < 2e-9 && found.least <= exact.error.solution);
        }
    }
}

#[test]
fn what_a_solution_has_not_seen_is_found() {
    // The solution is that of another right-hand side, without the dent.
    let (centre, width) = (0.6686, 0.002);
    for (index, ((kernel, _), power)) in kernels().into_iter().enumerate() {
        let smooth = |x: f64| x.powi(power);
        let dented = |x: f64| smooth(x) * (1.0 + 0.3 * (-((x - centre) / width).powi(2)).exp());
        let blind = collocate(&*kernel, 4.0, &smooth, &[], 1e-12).unwrap();
        let exact = collocate(&*kernel, 4.0, &dented, &[centre], 1e-12).unwrap();
        let found = audit(&*kernel, 4.0, &dented, [&[], &[]], &blind).unwrap();
        let integral = (blind.integral.unwrap() - exact.integral.unwrap()).abs();
        assert!(integral > 1e-6 && integral <= found.integral, "{index}: {integral:.1e} {found:?}");
        assert!(difference(&*kernel, &blind, &exact) <= found.solution, "{index}: {found:?}");
        assert!(found.least > 1e-3, "{index}: {found:?}");
    }
}

#[test]
fn refuses_what_residuals_do_not_bound() {
    let kernel = Logarithm::unit();
    let solution = collocate(&kernel, 1.0, &f64::cos, &[], 1e-10).unwrap();
    for parameter in [-0.1, f64::NAN, f64::INFINITY] {
        let refused = audit(&kernel, parameter, &f64::cos, [&[], &[]], &solution);
        assert!(matches!(refused, Err(Error::InvalidParameter { .. })));
    }
}
