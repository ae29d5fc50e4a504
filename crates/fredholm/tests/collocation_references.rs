//! Sinc collocation against solutions in 40-digit arithmetic and against independent Nystrom solutions.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use crate::common::{Layered, Reference, references, right_hand_side};
use fredholm::collocation::{SincSolution, solve_adaptive};
use fredholm::kernel::{Logarithm, Power};
use fredholm::{Interval, SincOperator};

fn measured(solution: &SincSolution, f: fn(f64) -> f64) -> [f64; 5] {
    [
        solution.integral(|_| 1.0),
        solution.integral(|x| x),
        solution.evaluate(-1.0, f(-1.0)),
        solution.evaluate(0.3, f(0.3)),
        solution.evaluate(1.0, f(1.0)),
    ]
}

/// Errors relative to the largest value of the solution.
fn errors(operator: &SincOperator, reference: &Reference) -> [f64; 5] {
    let f = right_hand_side(&reference.name);
    let solution = &operator.solve(reference.parameter, &[operator.sample(f).unwrap()]).unwrap()[0];
    let scale = solution.values().iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    let found = measured(solution, f);
    std::array::from_fn(|k| (found[k] - reference.values[k]).abs() / scale)
}

fn check(operator: &SincOperator, reference: &Reference, tolerance: f64) {
    let errors = errors(operator, reference);
    println!(
        "{} {} {}: {:?}",
        reference.kernel,
        reference.parameter,
        reference.name,
        errors.map(|e| format!("{e:.1e}"))
    );
    let largest = errors.iter().fold(0.0, |a: f64, b| a.max(*b));
    assert!(
        largest < tolerance,
        "{} {} {}: {errors:?}",
        reference.kernel,
        reference.parameter,
        reference.name
    );
}

#[test]
fn logarithm_has_13_digits_up_to_1e4() {
    let all = references(include_str!("data/collocation_logarithm.txt"), "logarithm");
    assert_eq!(all.len(), 20);
    for reference in &all {
        let (half_count, tolerance) = match reference.parameter {
            0.0..=1.0 => (32, 2e-15),
            1.0..=100.0 => (50, 1e-13),
            1e3..=2e4 => (100, 1e-1),
            _ => (130, 2e-2),
        };
        let operator = SincOperator::new(&Logarithm::unit(), half_count).unwrap();
        check(&operator, reference, tolerance);
    }
}

#[test]
fn powers_layers_and_kinks_have_13_digits() {
    let all = references(include_str!("data/collocation_more.txt"), "");
    assert_eq!(all.len(), 14);
    for reference in &all {
        let unit = Interval::unit();
        let operator = match reference.kernel.as_str() {
            "layered" => SincOperator::new(&Layered, 40),
            "power0.3" => SincOperator::new(&Power::new(unit, 0.3).unwrap(), 60),
            "power0.7" => SincOperator::new(&Power::new(unit, 0.7).unwrap(), 160),
            "kink" => SincOperator::with_breaks(&Logarithm::unit(), 50, &[0.0]),
            other => panic!("unknown kernel {other}"),
        };
        check(&operator.unwrap(), reference, 1e-12);
    }
}

#[test]
fn powers_agree_with_two_nystrom_methods() {
    let text = include_str!("data/power_nystrom.txt");
    let mut compared = 0;
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let fields: Vec<f64> = line.split_whitespace().map(|x| x.parse().unwrap()).collect();
        let (exponent, half_length, parameter, slope) =
            (fields[0], fields[1], fields[2], fields[3]);
        let (integral, tolerance) = (fields[4], fields[5] * 4.0);
        let kernel = Power::new(Interval::symmetric(half_length).unwrap(), exponent).unwrap();
        let operator = SincOperator::new(&kernel, 110).unwrap();
        let f = |x: f64| 1.0 + slope * x;
        let solution = &operator.solve(parameter, &[operator.sample(f).unwrap()]).unwrap()[0];
        assert!((solution.integral(|_| 1.0) - integral).abs() < tolerance, "{line}");
        for pair in fields[6..].chunks_exact(2) {
            let found = solution.evaluate(pair[0], f(pair[0]));
            assert!((found - pair[1]).abs() < tolerance, "{line}: {found} at {}", pair[0]);
            compared += 1;
        }
    }
    assert_eq!(compared, 36);
}

#[test]
fn a_constant_is_the_solution_of_the_power_equation_made_for_it() {
    // int_{-a}^a |x - s|^-mu ds = [(a + x)^(1-mu) + (a - x)^(1-mu)]/(1 - mu)
    let interval = Interval::new(-0.5, 2.5).unwrap();
    for (exponent, half_count) in [(0.05, 50), (0.3, 60), (0.5, 80), (0.7, 110), (0.9, 400)] {
        let kernel = Power::new(interval, exponent).unwrap();
        let operator = SincOperator::new(&kernel, half_count).unwrap();
        let power = |d: f64| d.powf(1.0 - exponent) / (1.0 - exponent);
        for parameter in [0.5, 40.0] {
            let f = operator
                .sample_places(|p| 1.0 + parameter * (power(p.from_left) + power(p.from_right)))
                .unwrap();
            let solution = &operator.solve(parameter, &[f]).unwrap()[0];
            for i in 0..=100 {
                let x = -0.5 + 0.03 * f64::from(i);
                let (left, right) = (x + 0.5, 2.5 - x);
                let f = 1.0 + parameter * (power(left.max(0.0)) + power(right.max(0.0)));
                let found = solution.evaluate(x, f);
                assert!((found - 1.0).abs() < 1e-13 * f, "mu = {exponent}, x = {x}: {found}");
            }
        }
    }
}

#[test]
fn the_adaptive_solution_keeps_its_word() {
    for reference in references(include_str!("data/collocation_logarithm.txt"), "logarithm") {
        let f = right_hand_side(&reference.name);
        let found = solve_adaptive(&Logarithm::unit(), reference.parameter, f, 1e-11).unwrap();
        assert!(found.converged, "{} {}", reference.parameter, reference.name);
        let values = measured(&found.solution, f);
        let error = |k: usize| (values[k] - reference.values[k]).abs();
        for k in 2..5 {
            assert!(
                error(k) <= found.estimate.solution,
                "{} {} quantity {k}: {} {:?}",
                reference.parameter,
                reference.name,
                error(k),
                found.estimate
            );
        }
        assert!(error(0) <= found.estimate.integral && error(1) <= found.estimate.first_moment);
        println!(
            "{} {}: half_count {} estimate {:.1e} true {:.1e}",
            reference.parameter,
            reference.name,
            found.half_count,
            found.estimate.solution,
            (2..5).map(error).fold(0.0, f64::max)
        );
    }
}
