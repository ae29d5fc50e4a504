//! Equations of the second kind.

use fredholm::DegenerateSystem;
use fredholm::collocation::solve_adaptive;
use fredholm::kernel::{Kernel, SpectralRelation, Yukawa};
use fredholm::quadrature::double_exponential;
use serde_json::Value;

use super::{kernel, number, numbers, reference, rows};
use crate::common::together;

/// `x^m sum f_j x^(2j)`.
fn right_hand_side(entry: &Value) -> impl Fn(f64) -> f64 {
    let coefficients = numbers(&entry["f"]);
    let m = number(&entry["m"]) as i32;
    move |x: f64| x.powi(m) * coefficients.iter().rev().fold(0.0, |sum, c| sum * x * x + c)
}

#[test]
fn collocation_agrees_with_product_integration() {
    for entry in rows(&reference()["solutions"]) {
        let kernel = kernel(entry);
        let f = right_hand_side(entry);
        let found = solve_adaptive(&kernel, number(&entry["lambda"]), &f, 1e-11).unwrap();
        let (x, p) = (numbers(&entry["x"]), numbers(&entry["p"]));
        let largest = p.iter().fold(0.0f64, |most, p| most.max(p.abs()));
        let error = (x.iter().zip(&p))
            .map(|(&x, p)| (found.solution.evaluate(x, f(x)) - p).abs() / largest)
            .fold(0.0, f64::max);
        let exact = number(&entry["integral"]);
        let integral = found.solution.integral(|x| kernel.mass_function(x)) / exact - 1.0;
        println!(
            "chi = {}, m = {}: error {error:e}, integral {integral:e}, half_count {}",
            kernel.screening(),
            kernel.harmonic(),
            found.half_count
        );
        assert!(found.converged && error < 1e-11 && integral.abs() < 1e-11);
    }
}

#[test]
fn the_degenerate_kernel_agrees_with_product_integration() {
    for entry in rows(&reference()["solutions"]) {
        let relation = kernel(entry).relation(301).unwrap();
        let f = right_hand_side(entry);
        let system = DegenerateSystem::new(&relation, number(&entry["lambda"]), 300).unwrap();
        let moments = relation.moments(&f, 301).unwrap();
        let solution = system.solve(&moments.values);
        let (x, p) = (numbers(&entry["x"]), numbers(&entry["p"]));
        let largest = p.iter().fold(0.0f64, |most, p| most.max(p.abs()));
        let errors: Vec<f64> = (x.iter().zip(&p))
            .map(|(&x, p)| (solution.evaluate(x, f(x)) - p).abs() / largest)
            .collect();
        println!("{errors:?}");
        // Truncation: N^-2 at the edge, N^-(5/2) at the centre, N^-3 between.
        assert!(errors[..7].iter().all(|error| *error < 3e-6) && errors[7] < 3e-5);
    }
}

/// `int_0^a K(x, s) u(s) s ds` on both sides of `x` by the double-exponential rule, which does not mind the logarithm.
fn image(kernel: &Yukawa, u: impl Fn(f64) -> f64, x: f64) -> f64 {
    let a = kernel.radius();
    let term = |s: f64, distance: f64, weight: f64| {
        if weight * s == 0.0 || distance == 0.0 {
            return 0.0;
        }
        weight * s * u(s) * kernel.pair(x, s, distance).value
    };
    let half_count = 60 + (3.0 * kernel.screening() * a) as usize;
    double_exponential(half_count)
        .map(|node| {
            let (left, right) = (0.5 * node.from_left, 0.5 * node.from_right);
            let inner = term(x * left, x * right, 0.5 * x * node.weight);
            let gap = a - x;
            inner + term(x + gap * left, gap * left, 0.5 * gap * node.weight)
        })
        .sum()
}

#[test]
fn manufactured_solutions() {
    let cases = [(1.0, 1.0, 0, 0.5), (1.0, 30.0, 0, 3.0), (2.0, 4.0, 3, 1.0), (1.0, 2.0, 1, -0.1)];
    together(cases, |(a, chi, m, lambda)| {
        let kernel = Yukawa::new(a, chi, m).unwrap();
        let exact = |x: f64| x.powi(m as i32) * (1.0 - 0.4 * (x / a).powi(2)).exp();
        let f = |x: f64| exact(x) + lambda * image(&kernel, exact, x);
        let found = solve_adaptive(&kernel, lambda, f, 1e-11).unwrap();
        let largest = exact(a).abs();
        for i in 0..=40 {
            let x = a * f64::from(i) / 40.0;
            let error = (found.solution.evaluate(x, f(x)) - exact(x)).abs() / largest;
            assert!(error < 1e-11, "chi = {chi}, m = {m}, x = {x}: {error:e}");
        }
        assert!(found.converged);
    });
}

#[test]
fn first_kind() {
    // f = phi_n: K (w phi_n / lambda_n) = phi_n; the density has the edge singularity of a smooth punch.
    let kernel = Yukawa::new(1.3, 4.0, 1).unwrap();
    let relation = kernel.relation(40).unwrap();
    for n in [0, 3, 11] {
        let phi = |x: f64| {
            let mut values = vec![0.0; n + 1];
            relation.eigenfunctions(x, &mut values);
            values[n]
        };
        let expansion = relation.expand(&phi).unwrap();
        for (k, c) in expansion.coefficients.iter().enumerate() {
            let exact = f64::from(u8::from(k == n));
            assert!((c - exact).abs() < 1e-13, "{n} {k}: {c}");
        }
    }
}
