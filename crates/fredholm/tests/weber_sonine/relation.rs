//! The spectral relation.

use fredholm::kernel::{Gram, SpectralRelation, WeberSonine};

use super::{Worst, index, kernel, list, name, number, numbers, reference};

/// Largest error of what double precision can hold.
const EXACT: f64 = 1e-13;

#[test]
fn eigenvalues_norms_and_eigenfunctions_agree_with_mpmath() {
    let mut eigenvalues = Worst::new("eigenvalues, relative");
    let mut norms = Worst::new("norms, relative");
    let mut factors = Worst::new("lambda/h, relative");
    let mut functions = Worst::new("eigenfunctions, of the largest value");
    for case in list(&reference()["kernels"]) {
        let kernel = kernel(case);
        let exact = numbers(&case["eigenvalues"]).into_iter().zip(numbers(&case["norms"]));
        for (n, (eigenvalue, norm)) in list(&case["n"]).iter().map(index).zip(exact) {
            let at = || format!("{} n = {n}", name(case));
            eigenvalues.add((kernel.eigenvalue(n) / eigenvalue - 1.0).abs(), at);
            norms.add((kernel.norm(n) / norm - 1.0).abs(), at);
            factors.add((kernel.expansion_factor(n) * norm / eigenvalue - 1.0).abs(), at);
        }
        let rows: Vec<Vec<f64>> = list(&case["phi"]).iter().map(numbers).collect();
        for (xi, row) in numbers(&case["xi"]).into_iter().zip(&rows) {
            let mut found = vec![0.0; row.len()];
            let x = xi * kernel.radius();
            kernel.eigenfunctions(x, &mut found);
            for (n, (found, exact)) in found.iter().zip(row).enumerate() {
                let largest = rows.iter().map(|row| row[n].abs()).fold(0.0, f64::max);
                let at = || format!("{} phi_{n}({xi})", name(case));
                functions.add((found - exact).abs() / largest, at);
                let mut unit = vec![0.0; n + 1];
                unit[n] = 1.0;
                functions.add((kernel.sum(&unit, x) - found).abs() / largest, at);
            }
        }
    }
    eigenvalues.require(EXACT);
    norms.require(EXACT);
    factors.require(EXACT);
    functions.require(EXACT);
}

#[test]
fn the_gram_matrix_agrees_with_mpmath() {
    let mut worst = Worst::new("Gram matrix, of the diagonal");
    for case in list(&reference()["kernels"]) {
        let gram = kernel(case).gram(101).unwrap();
        let mut check = |k: usize, m: usize, exact: f64| {
            let size = (gram.entry(k, k) * gram.entry(m, m)).sqrt();
            let error = (gram.entry(k, m) - exact).abs() / size;
            worst.add(error, || format!("{} R_{k},{m}", name(case)));
        };
        for (k, row) in list(&case["gram"]).iter().enumerate() {
            numbers(row).into_iter().enumerate().for_each(|(m, exact)| check(k, m, exact));
        }
        for entry in list(&case["gram_large"]) {
            check(index(&entry[0]), index(&entry[1]), number(&entry[2]));
        }
    }
    worst.require(EXACT);
}

/// The general sum against the closed form, at an exponent so small that both are the same to rounding.
#[test]
fn the_sum_for_the_gram_matrix_is_stable() {
    let mut worst = Worst::new("Gram matrix of order 1000 by the general sum");
    for order in [0.0, 0.5, 3.0, 20.0, 100.0] {
        let exact = WeberSonine::new(1.0, order, 0.0).unwrap().gram(1000).unwrap();
        let found = WeberSonine::new(1.0, order, 1e-17).unwrap().gram(1000).unwrap();
        let (Gram::Dense { entries: exact, .. }, Gram::Dense { entries: found, .. }) =
            (exact, found)
        else {
            panic!("not dense");
        };
        let root = |k: usize| exact[k * 1001].sqrt();
        for (i, (found, exact)) in found.iter().zip(&exact).enumerate() {
            let error = (found - exact).abs() / (root(i / 1000) * root(i % 1000));
            worst.add(error, || format!("mu = {order}, R_{},{}", i / 1000, i % 1000));
        }
    }
    worst.require(1e-12);
}

#[test]
fn functions_are_expanded() {
    // f = phi_0 - 3 phi_2 + phi_7 / 4; and x^mu exp(x^2), resolved.
    let mut worst = Worst::new("coefficients of sums of eigenfunctions");
    let mut between = Worst::new("expansion of x^mu exp(x^2)");
    for order in [0.0, 0.3, 0.5, 1.0, 2.5, 5.0, 30.0] {
        for gamma in [-0.49, -0.1, 0.0, 0.3, 0.49] {
            let kernel = WeberSonine::new(1.3, order, gamma).unwrap();
            let mut given = vec![1.0, 0.0, -3.0];
            given.resize(8, 0.25);
            let found = kernel.expand(&|x| kernel.sum(&given, x)).unwrap();
            assert!(found.resolved);
            let size = (given.iter().enumerate()).map(|(n, c)| c * c * kernel.norm(n)).sum::<f64>();
            for (n, c) in found.coefficients.iter().enumerate() {
                let exact = given.get(n).copied().unwrap_or(0.0);
                let error = (c - exact).abs() * (kernel.norm(n) / size).sqrt();
                worst.add(error, || format!("{order} {gamma} {n}"));
            }
            let f = |x: f64| x.powf(order) * (x * x).exp();
            let found = kernel.expand(&f).unwrap();
            assert!(found.resolved, "{order} {gamma} {:e}", found.error);
            for i in 0..=20 {
                let x = 1.3 * f64::from(i) / 20.0;
                let error = (kernel.sum(&found.coefficients, x) - f(x)).abs() / f(1.3);
                between.add(error, || format!("{order} {gamma} {x}"));
            }
        }
    }
    worst.require(1e-13);
    between.require(1e-12);
}
