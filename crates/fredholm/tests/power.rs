//! The power kernel: its spectral relation and both methods against references.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use crate::common::together;
use fredholm::collocation::{solve_adaptive, solve_adaptive_with_breaks};
use fredholm::kernel::{Kernel as _, Power, SpectralRelation};
use fredholm::{DegenerateSystem, Interval};
use serde_json::Value;

fn data() -> Value {
    serde_json::from_str(include_str!("data/kernel_power.json")).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().unwrap().parse().unwrap())
}

fn each(value: &Value) -> Vec<(String, f64)> {
    value.as_object().unwrap().iter().map(|(key, v)| (key.clone(), number(v))).collect()
}

fn power(half_length: f64, exponent: f64) -> Power {
    Power::new(Interval::symmetric(half_length).unwrap(), exponent).unwrap()
}

/// `(mu)_n/n! = C_n^(mu/2)(1)`, what turns the normalised polynomials into those of the file.
fn at_one(exponent: f64, n: usize) -> f64 {
    (0..n).map(|j| (exponent + j as f64) / (j as f64 + 1.0)).product()
}

#[test]
fn the_spectral_relation_agrees_with_mpmath() {
    let data = data();
    for case in data["spectral"].as_array().unwrap() {
        let [exponent, half_length] = ["mu", "a"].map(|key| number(&case["params"][key]));
        let kernel = power(half_length, exponent);
        let mut errors = [0.0f64; 5];
        let mut note = |kind: usize, error: f64| errors[kind] = errors[kind].max(error.abs());
        for (n, exact) in each(&case["lam"]) {
            let n = n.parse().unwrap();
            note(0, kernel.eigenvalue(n) / exact - 1.0);
        }
        for (n, exact) in each(&case["h"]) {
            let n = n.parse().unwrap();
            note(1, kernel.norm(n) * at_one(exponent, n).powi(2) / exact - 1.0);
        }
        for (n, exact) in each(&case["lam_over_h"]) {
            let n = n.parse().unwrap();
            note(2, kernel.expansion_factor(n) / at_one(exponent, n).powi(2) / exact - 1.0);
        }
        for (x, row) in case["phi"].as_object().unwrap() {
            let mut values = [0.0; 21];
            kernel.eigenfunctions(x.parse().unwrap(), &mut values);
            for (n, exact) in each(row) {
                let n: usize = n.parse().unwrap();
                note(3, values[n] - exact / at_one(exponent, n));
            }
        }
        let gram = kernel.gram(21).unwrap();
        for (place, exact) in each(&case["R"]) {
            let (k, m) = place.split_once(',').unwrap();
            let (k, m) = (k.parse().unwrap(), m.parse().unwrap());
            let size = (gram.entry(k, k) * gram.entry(m, m)).sqrt();
            let exact = exact / (at_one(exponent, k) * at_one(exponent, m));
            note(4, (gram.entry(k, m) - exact) / size);
        }
        println!("{}: {:?}", case["params"], errors.map(|e| format!("{e:.1e}")));
        // The change of normalisation rounds up to 200 factors.
        assert!(errors.iter().all(|error| *error < 3e-14), "{}: {errors:?}", case["params"]);
    }
}

#[test]
fn eigenvalues_and_norms_of_high_index_follow_their_recurrence() {
    for exponent in [1e-9, 0.001, 0.3, 0.9, 1.0 - 1e-9] {
        let kernel = power(2.0, exponent);
        // The product of the ratios in twice the precision: head and tail of every factor.
        let (mut logarithm, mut carry) = (0.0f64, 0.0f64);
        let mut worst = 0.0f64;
        for n in 1..100_000usize {
            let term = ((exponent - 1.0) / (n as f64 + 1.0)).ln_1p() - carry;
            let sum = logarithm + term;
            carry = (sum - logarithm) - term;
            logarithm = sum;
            if n % 997 == 0 || n < 40 {
                let exact = kernel.eigenvalue(1) * logarithm.exp();
                worst = worst.max((kernel.eigenvalue(n + 1) / exact - 1.0).abs());
                // lambda_n h_n (n + mu/2) does not depend on n
                let [at_n, at_one] = [n as f64, 1.0].map(|m| {
                    kernel.eigenvalue(m as usize) * kernel.norm(m as usize) * (m + 0.5 * exponent)
                });
                worst = worst.max((at_n / at_one - 1.0).abs());
            }
        }
        println!("mu {exponent}: {worst:e}");
        assert!(worst < 1e-14, "mu = {exponent}: {worst:e}");
        let first = kernel.eigenvalue(1) / kernel.eigenvalue(0);
        assert!((first / exponent - 1.0).abs() < 1e-15);
    }
}

#[test]
fn near_the_logarithm_the_relation_is_that_of_the_logarithm() {
    // |x - s|^-mu = 1 - mu ln|x - s| + O(mu^2): beside the constant, mu times the eigenvalues pi/n and norms pi/2.
    let mu = 1e-9;
    let kernel = power(1.0, mu);
    for n in [1, 2, 30, 1000] {
        let eigenvalue = mu * std::f64::consts::PI / n as f64;
        assert!((kernel.eigenvalue(n) / eigenvalue - 1.0).abs() < 1e-7);
        assert!((kernel.norm(n) / std::f64::consts::FRAC_PI_2 - 1.0).abs() < 1e-7);
    }
    let gram = kernel.gram(30).unwrap();
    for (k, m) in [(0, 0), (1, 3), (7, 29), (12, 20)] {
        let [sum, difference] = [(k + m) as f64, k as f64 - m as f64].map(|j| j * j);
        let exact = -1.0 / (sum - 1.0) - 1.0 / (difference - 1.0);
        assert!((gram.entry(k, m) - exact).abs() < 1e-8);
    }
}

#[test]
fn functions_expand_on_any_interval() {
    let interval = Interval::new(0.5, 3.0).unwrap();
    for exponent in [1e-9, 0.3, 0.9] {
        let kernel = Power::new(interval, exponent).unwrap();
        let expansion = kernel.expand(&|x| (2.0 * x).cos()).unwrap();
        assert!(expansion.resolved, "{}", expansion.error);
        for x in [0.5, 0.77, 2.0, 3.0] {
            let found = kernel.sum(&expansion.coefficients, x);
            assert!((found - (2.0 * x).cos()).abs() < 5e-13, "mu {exponent} x {x}: {found}");
        }
        // An eigenfunction has one coefficient.
        let phi = |x: f64| {
            let mut values = [0.0; 6];
            kernel.eigenfunctions(x, &mut values);
            values[5]
        };
        let coefficients = kernel.expand(&phi).unwrap().coefficients;
        assert!(coefficients.len() >= 6);
        for (n, c) in coefficients.iter().enumerate() {
            assert!((c - f64::from(u8::from(n == 5))).abs() < 1e-13, "mu {exponent}: {n} {c}");
        }
        // int_L x phi_0 dx and the mass of the weight.
        let moments = kernel.moments(&|x| x, 3).unwrap();
        assert!((moments.values[0] - 0.5 * (9.0 - 0.25)).abs() < 1e-12);
        assert_eq!(kernel.mass(0), kernel.norm(0));
    }
}

#[test]
fn both_methods_agree_with_the_references() {
    let data = data();
    for case in data["solutions"].as_array().unwrap() {
        let [exponent, half_length] = ["mu", "a"].map(|key| number(&case["params"][key]));
        let kernel = power(half_length, exponent);
        let slope = if case["f"] == "1+x" { 1.0 } else { 0.0 };
        let f = |x: f64| 1.0 + slope * x;
        let parameter = number(&case["parameter"]);
        let exact = number(&case["integral"]);
        let list = |key: &str| case[key].as_array().unwrap().iter().map(number);
        let scale = list("phi").fold(0.0, |a: f64, b| a.max(b.abs()));
        let found = solve_adaptive(&kernel, parameter, f, 1e-11).unwrap();
        let mut worst = (found.solution.integral(|_| 1.0) - exact).abs() / scale;
        for (x, phi) in list("x").zip(list("phi")) {
            worst = worst.max((found.solution.evaluate(x, f(x)) - phi).abs() / scale);
        }
        let system = DegenerateSystem::new(&kernel, parameter, 160).unwrap();
        let solution = system.solve(&kernel.moments(&f, 161).unwrap().values);
        let force = (solution.projections()[0] / exact - 1.0).abs();
        println!("{}: collocation {worst:.1e}, degenerate force {force:.1e}", case["params"]);
        assert!(found.converged && worst < 1e-11, "{case}: {worst:e}");
        // The force converges at least by one order faster than the solution inside, N^-(3 - 3 mu/2), does.
        assert!(force < 160f64.powf(-4.0 + 1.5 * exponent), "{case}: {force:e}");
    }
    for case in data["integrals"].as_array().unwrap() {
        let [exponent, half_length, x, exact] =
            ["exponent", "half_length", "x", "integral"].map(|key| number(&case[key]));
        // K 1 at x, to which the operator is applied by the solution that was made to be 1.
        let kernel = power(half_length, exponent);
        let power_of = |d: f64| d.powf(1.0 - exponent) / (1.0 - exponent);
        let operator = fredholm::SincOperator::new(&kernel, 124).unwrap();
        let f = operator
            .sample_places(|p| 1.0 + power_of(p.from_left) + power_of(p.from_right))
            .unwrap();
        let solution = &operator.solve(1.0, &[f]).unwrap()[0];
        assert!((solution.evaluate_potential(x) / exact - 1.0).abs() < 1e-13, "{case}");
    }
}

#[test]
fn says_what_was_wrong() {
    for exponent in [0.0, 1.0, -0.1, f64::NAN] {
        assert!(Power::new(Interval::unit(), exponent).is_err());
    }
    assert!(Power::new(Interval::half_line(0.0).unwrap(), 0.3).is_err());
    let kernel = power(1.0, 0.49);
    assert!(kernel.is_square_summable() && !power(1.0, 0.5).is_square_summable());
    assert!(kernel.gram(10_000_000).is_err());
    assert!(kernel.expand(&|x| 1.0 / (x - x)).is_err());
    assert_eq!(kernel.interval(), Interval::unit());
}

/// Exponents with parameters for which what lies between neighbouring numbers counts.
const STEEP: [(f64, f64); 4] = [(0.6, 1.0), (0.8, 0.2), (0.85, 1.0), (0.95, 0.1)];

/// `int |x - s|^-mu ds` over a side of the length `d`.
fn side(exponent: f64, d: f64) -> f64 {
    d.powf(1.0 - exponent) / (1.0 - exponent)
}

fn require_stated(exponent: f64, error: f64, stated: f64) {
    println!("mu {exponent}: {error:.1e}, stated {stated:.1e}");
    assert!(error <= stated && stated <= 30.0 * error + 1e-8, "{exponent}: {error:e} {stated:e}");
}

/// Closer to an end than numbers lie nothing is known of a right-hand side, and `d^(1-mu)` changes there by much: the error that is stated knows. The solution is made to be 1.
#[test]
fn the_error_covers_what_lies_between_neighbouring_numbers() {
    together(STEEP, |(exponent, parameter)| {
        let kernel = power(1.0, exponent);
        let f = |x: f64| 1.0 + parameter * (side(exponent, 1.0 - x) + side(exponent, 1.0 + x));
        let found = solve_adaptive(&kernel, parameter, f, 1e-11).unwrap();
        let at = |x: f64| found.solution.evaluate(x, f(x));
        let places = [-1.0, (-1.0f64).next_up(), -1.0 + 1e-15, -0.3, 1.0 - 1e-12, 1.0];
        let error = places.into_iter().fold(0.0, |most: f64, x| most.max((at(x) - 1.0).abs()));
        require_stated(exponent, error, found.estimate.solution);
    });
}

/// The same with a jump inside: the solution is made to be 1 and 2.
#[test]
fn the_error_covers_what_lies_between_numbers_beside_a_jump() {
    together(STEEP, |(exponent, parameter)| {
        let kernel = power(1.0, exponent);
        let u = |d: f64| side(exponent, d);
        let cut = 0.3;
        let f = |x: f64| {
            let [density, side] = if x < cut { [1.0, -1.0] } else { [2.0, 1.0] };
            density + parameter * (u(1.0 + x) + 2.0 * u(1.0 - x) + side * u((x - cut).abs()))
        };
        let found = solve_adaptive_with_breaks(&kernel, &[cut], parameter, f, 1e-11).unwrap();
        let places = [-1.0, 0.0, cut.next_down(), cut, cut.next_up(), cut + 1e-14, 0.7, 1.0];
        let error = places.into_iter().fold(0.0, |most: f64, x| {
            most.max((found.solution.evaluate(x, f(x)) - if x < cut { 1.0 } else { 2.0 }).abs())
        });
        require_stated(exponent, error, found.estimate.solution);
    });
}
