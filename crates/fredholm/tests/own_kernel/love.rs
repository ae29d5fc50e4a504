//! Love's equation against published values and expansions.

use std::f64::consts::PI;

use fredholm::conformance;
use fredholm::kernel::{ComputedRelation, Kernel, SpectralRelation};

use crate::own_kernel::love_example::equation::{
    Love, PUBLISHED, by_collocation, by_degenerate_kernel, capacitance, close_disks, energy,
    published_series, strong_coupling,
};

#[test]
fn published_series_of_the_condenser() {
    for (sign, coefficients) in PUBLISHED {
        for found in
            [by_collocation(1.0, sign).unwrap(), by_degenerate_kernel(1.0, sign, 100).unwrap()]
        {
            for (value, x) in found.values.into_iter().zip([0.0, 1.0]) {
                let published = published_series(coefficients, x);
                // Seven rounded terms; Abbott's series leaves out T_10.
                assert!((value - published).abs() < 2e-7, "{sign} {x}: {value} {published}");
            }
        }
    }
}

#[test]
fn capacitance_of_close_disks_tends_to_kirchhoffs_formula() {
    // What the three terms leave out is kappa^2 but for logarithms: ten times closer, some hundred times less.
    let error = |kappa: f64| {
        let found = by_collocation(kappa, -1.0).unwrap();
        assert!(found.error < 1e-12);
        (capacitance(&found) - close_disks(kappa)) / kappa.powi(2)
    };
    let (far, near) = (error(0.4), error(0.08));
    assert!((0.1..1.5).contains(&far) && (0.1..1.5).contains(&near), "{far} {near}");
}

#[test]
fn far_disks_are_lone_disks() {
    // The kernel is 1/(pi kappa) to order kappa^-3, so phi = 1/(1 + sign 2/(pi kappa)).
    for (kappa, sign) in [(300.0, 1.0), (300.0, -1.0), (1e4, -1.0)] {
        let expected = 4.0 / (1.0 + sign * 2.0 / (PI * kappa));
        let found = capacitance(&by_collocation(kappa, sign).unwrap());
        assert!((found - expected).abs() < 4.0 * kappa.powi(-3), "{kappa} {sign}: {found}");
    }
}

#[test]
fn both_methods_agree_to_rounding() {
    for kappa in [10.0, 1.0, 0.3, 0.1] {
        for sign in [1.0, -1.0] {
            let sinc = by_collocation(kappa, sign).unwrap();
            let degenerate = by_degenerate_kernel(kappa, sign, 150).unwrap();
            assert!((sinc.zeroth / degenerate.zeroth - 1.0).abs() < 1e-12, "{kappa} {sign}");
            for (one, other) in sinc.values.iter().zip(degenerate.values) {
                // 150 pairs do not hold all of the kernel at kappa = 0.1: its least eigenvalue is 1e-10.
                assert!((one / other - 1.0).abs() < 1e-9, "{kappa} {sign}: {one} {other}");
            }
        }
    }
}

#[test]
fn energy_of_the_gas_as_published() {
    // The program `bethe` of Uni20-dev (docs/tutorials/data/ll-c1-n1.csv and ll-c10-n1.csv), Gauss-Legendre.
    for (gamma, published) in [(1.0, 0.639_151_285_272_074_9), (10.0, 2.310_780_380_427_122_5)] {
        let sinc = energy(gamma, |kappa| by_collocation(kappa, -1.0)).unwrap();
        let degenerate = energy(gamma, |kappa| by_degenerate_kernel(kappa, -1.0, 100)).unwrap();
        assert!((sinc / published - 1.0).abs() < 2e-13, "{gamma}: {sinc}");
        assert!((degenerate / published - 1.0).abs() < 2e-13, "{gamma}: {degenerate}");
    }
}

#[test]
fn energy_at_strong_coupling() {
    for gamma in [1e2, 1e3, 1e4] {
        let found = energy(gamma, |kappa| by_collocation(kappa, -1.0)).unwrap();
        // The next term is of the order 100 pi^2/3 gamma^-4.
        let gap = (found - strong_coupling(gamma)).abs();
        assert!(gap < 2e3 * gamma.powi(-4) + 1e-13, "{gamma}: {gap:e}");
    }
}

#[test]
fn the_coefficient_of_weak_coupling() {
    // (e - gamma + 4 gamma^(3/2)/(3 pi) - (1/6 - 1/pi^2) gamma^2)/gamma^(5/2) is a series in sqrt gamma whose constant S. Prolhac (arXiv:1610.08912) found to be -0.00158769986550594498929.
    let roots = [0.5, 0.4, 0.32, 0.25];
    let remainders: Vec<f64> = roots
        .iter()
        .map(|root: &f64| {
            let gamma = root * root;
            let energy = energy(gamma, |kappa| by_collocation(kappa, -1.0)).unwrap();
            let known = gamma - 4.0 * gamma * root / (3.0 * PI)
                + (1.0 / 6.0 - 1.0 / (PI * PI)) * gamma * gamma;
            (energy - known) / (gamma * gamma * root)
        })
        .collect();
    // Lagrange's polynomial at 0.
    let constant: f64 = (0..roots.len())
        .map(|i| {
            let others = (0..roots.len()).filter(|j| *j != i);
            remainders[i] * others.map(|j| roots[j] / (roots[j] - roots[i])).product::<f64>()
        })
        .sum();
    assert!((constant + 0.001_587_699_865_505_945).abs() < 1e-7, "{constant}");
}

#[test]
fn traces_of_the_kernel() {
    for separation in [2.0, 0.5, 0.2] {
        let relation = ComputedRelation::up_to(Love { separation }, 200).unwrap();
        let nu: Vec<f64> = (0..relation.available()).map(|n| relation.eigenvalue(n)).collect();
        assert!(nu.iter().all(|nu| *nu > 0.0));
        // int K(x, x) dx and int int K^2 dx ds.
        let trace = 2.0 / (PI * separation);
        let square = 2.0 / (PI * PI) * (2.0 / separation).atan() / separation;
        assert!((nu.iter().sum::<f64>() / trace - 1.0).abs() < 1e-13);
        assert!((nu.iter().map(|nu| nu * nu).sum::<f64>() / square - 1.0).abs() < 1e-13);
    }
}

#[test]
fn passes_the_suite() {
    for separation in [2.0, 0.5] {
        let relation = ComputedRelation::up_to(Love { separation }, 60).unwrap();
        // A function has an error of 2e-16 nu_0/nu_n: beyond, orthogonality has fewer than 12 digits.
        let resolved = |n: &usize| relation.eigenvalue(*n) > 1e-8 * relation.eigenvalue(0);
        let count = (0..relation.available()).take_while(resolved).count();
        let report = conformance::run(relation.kernel(), &relation, count).unwrap();
        // The suite's sum has a cutoff for singular kernels, which costs a smooth one its last terms; its plain sum is below.
        for check in report.checks.iter().filter(|check| check.name != "bilinear sum") {
            assert!(check.passes(), "{separation}: {check:?}");
        }
        let coefficients = |x: f64| {
            let mut values = vec![0.0; relation.available()];
            relation.eigenfunctions(x, &mut values);
            values.iter_mut().enumerate().for_each(|(n, phi)| *phi *= relation.eigenvalue(n));
            values
        };
        for (x, s) in [(-1.0, 1.0), (0.2, 0.2), (0.97, 0.31), (1.0, 1.0)] {
            let sum = relation.sum(&coefficients(x), s);
            let largest = relation.value(0.0, 0.0);
            // The eigenvalues left out are below 2e-14 nu_0, the squares of their functions some ten times 1/length at the ends.
            assert!((sum - relation.value(x, s)).abs() < 1e-11 * largest, "{separation} {x} {s}");
        }
    }
}
