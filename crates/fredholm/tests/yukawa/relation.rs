//! The spectral relation.

use fredholm::kernel::{Kernel, SpectralRelation, Yukawa};
use fredholm::quadrature::double_exponential;
use fredholm::{Error, conformance};

use super::{kernel, numbers, reference, rows};

/// Keeps the largest error under a name.
struct Worst(&'static str, f64);

impl Worst {
    fn note(&mut self, error: f64) {
        assert!(!error.is_nan(), "{}", self.0);
        self.1 = self.1.max(error);
    }

    fn require(&self, limit: f64) {
        println!("{}: {:e}", self.0, self.1);
        assert!(self.1 < limit, "{}: {:e}", self.0, self.1);
    }
}

#[test]
fn every_number_of_the_reference() {
    let mut separation = Worst("separation constants, relative", 0.0);
    let mut eigenvalues = Worst("eigenvalues over the largest", 0.0);
    let mut own = Worst("eigenvalues, each relative", 0.0);
    let mut norms = Worst("norms", 0.0);
    let mut functions = Worst("eigenfunctions over the root of the norm per radius", 0.0);
    let mut coefficients = Worst("coefficients", 0.0);
    let mut gram = Worst("Gram matrix over the root of the diagonal", 0.0);
    for entry in rows(&reference()["relations"]) {
        let kernel = kernel(entry);
        let a = kernel.radius();
        let relation = kernel.relation(13).unwrap();
        let exact = numbers(&entry["lambda"]);
        for (n, exact) in numbers(&entry["Lambda"]).iter().enumerate() {
            separation.note((relation.separation_constants()[n] / exact - 1.0).abs());
        }
        for (n, lambda) in exact.iter().enumerate() {
            eigenvalues.note((relation.eigenvalue(n) - lambda).abs() / exact[0]);
            own.note((relation.eigenvalue(n) / lambda - 1.0).abs());
        }
        for (n, h) in numbers(&entry["h"]).iter().enumerate() {
            norms.note((relation.norm(n) / h - 1.0).abs());
        }
        for (xi, row) in numbers(&entry["xi"]).iter().zip(rows(&entry["phi"])) {
            let mut found = vec![0.0; 9];
            relation.eigenfunctions(xi * a, &mut found);
            for (n, phi) in numbers(row).iter().enumerate() {
                functions.note((found[n] - phi).abs());
                let mut unit = vec![0.0; n + 1];
                unit[n] = 1.0;
                functions.note((relation.sum(&unit, xi * a) - phi).abs());
            }
        }
        for (n, name) in [(0, "coef_n0"), (3, "coef_n3")] {
            let found = relation.legendre_coefficients(n);
            for (j, exact) in numbers(&entry[name]).iter().enumerate() {
                coefficients.note((found.get(j).unwrap_or(&0.0) - exact).abs());
            }
        }
        let found = relation.gram(6).unwrap();
        let exact: Vec<Vec<f64>> = rows(&entry["R_xdx"]).iter().map(numbers).collect();
        for (k, row) in exact.iter().enumerate() {
            for (m, entry) in row.iter().enumerate() {
                gram.note((found.entry(k, m) - entry).abs() / (exact[k][k] * exact[m][m]).sqrt());
            }
        }
    }
    separation.require(1e-13);
    eigenvalues.require(1e-13);
    own.require(1e-13);
    norms.require(1e-15);
    functions.require(1e-13);
    coefficients.require(1e-13);
    gram.require(1e-13);
}

/// `pi Gamma(n + 1/2) Gamma(n + m + 1/2) / (n! (n + m)!)`.
fn without_screening(m: u32, n: u32) -> f64 {
    let quotients =
        |count: u32| -> f64 { (1..=count).map(|k| (f64::from(k) - 0.5) / f64::from(k)).product() };
    std::f64::consts::PI.powi(2) * quotients(n) * quotients(n + m)
}

#[test]
fn without_screening_it_is_the_kernel_of_weber_and_sonine() {
    for m in [0, 1, 3, 50] {
        let relation = Yukawa::new(2.0, 0.0, m).unwrap().relation(60).unwrap();
        for n in 0..60 {
            let exact = without_screening(m, n as u32);
            let l = f64::from(m) + 2.0 * n as f64;
            assert!((relation.eigenvalue(n) / exact - 1.0).abs() < 5e-14, "{m} {n}");
            let separation = relation.separation_constants()[n];
            assert!((separation - l * (l + 1.0)).abs() <= 1e-15 * separation + 1e-300);
        }
    }
}

#[test]
fn eigenvalues_behave_as_theory_says() {
    // They fall with n and with the screening, stay below those without screening, and tend to pi/n and pi Gamma(n + 1/2)/(n! sqrt(kappa)).
    let mut before: Option<Vec<f64>> = None;
    for chi in [0.0, 1e-3, 1.0, 30.0, 400.0, 1e4] {
        let relation = Yukawa::new(1.0, chi, 1).unwrap().relation(40).unwrap();
        let values: Vec<f64> = (0..40).map(|n| relation.eigenvalue(n)).collect();
        assert!(values.windows(2).all(|pair| pair[0] > pair[1] && pair[1] > 0.0));
        if let Some(before) = before {
            assert!(values.iter().zip(&before).all(|(now, before)| now < before));
        }
        before = Some(values);
    }
    let relation = Yukawa::new(1.0, 2.0, 0).unwrap().relation(300).unwrap();
    assert!((relation.eigenvalue(299) * 299.25 / std::f64::consts::PI - 1.0).abs() < 1e-5);
    let relation = Yukawa::new(1.0, 2000.0, 0).unwrap().relation(2).unwrap();
    let limit = std::f64::consts::PI.powf(1.5) / 2000f64.sqrt();
    assert!((relation.eigenvalue(0) / limit - 1.0).abs() < 5e-4);
}

#[test]
fn the_exact_identity_of_the_symmetric_harmonic() {
    // lambda_n = pi^2 (1 - gamma_n) (S_n(0)/S_n(1))^2 with gamma_n = (2 kappa/pi) (int_0^1 S_n/S_n(0))^2.
    for (chi, count, limit) in [(0.5, 8, 1e-13), (3.0, 8, 1e-12)] {
        let relation = Yukawa::new(1.0, chi, 0).unwrap().relation(count).unwrap();
        let (mut centre, mut edge) = (vec![0.0; count], vec![0.0; count]);
        relation.eigenfunctions(0.0, &mut centre);
        relation.eigenfunctions(1.0, &mut edge);
        for n in 0..count {
            let concentration =
                2.0 * chi / std::f64::consts::PI * (relation.mass(n) / edge[n]).powi(2);
            let exact = std::f64::consts::PI.powi(2)
                * (1.0 - concentration)
                * (edge[n] / centre[n]).powi(2);
            assert!((relation.eigenvalue(n) / exact - 1.0).abs() < limit, "{chi} {n}");
        }
    }
}

#[test]
fn the_suite() {
    let cases = [
        (1.0, 1.0, 0, 40),
        (1.0, 1e-9, 0, 20),
        (0.02, 3000.0, 0, 100),
        (1.0, 200.0, 0, 120),
        (7.0, 0.3, 1, 30),
        (1.0, 4.0, 2, 1),
        (1.0, 20.0, 5, 60),
        (1.0, 1.0, 20, 20),
        (1.0, 0.0, 3, 30),
    ];
    for (a, chi, m, count) in cases {
        let kernel = Yukawa::new(a, chi, m).unwrap();
        let mut report = conformance::check_kernel(&kernel).unwrap();
        let verification = conformance::verify(&kernel.relation(count).unwrap(), count).unwrap();
        println!("a = {a}, chi = {chi}, m = {m}: {verification:?}");
        // Few terms do not sum to the kernel.
        let mut checks = verification.report(conformance::LIMIT);
        checks.checks.retain(|check| check.name != "bilinear sum" || count >= 400);
        report.extend(checks);
        assert!(report.passes(), "a = {a}, chi = {chi}, m = {m}, {count} functions:\n{report}");
    }
}

#[test]
fn the_bilinear_sum_is_the_kernel() {
    for (chi, m) in [(1.0, 0), (3.0, 1), (10.0, 0), (2.0, 5)] {
        let kernel = Yukawa::new(1.0, chi, m).unwrap();
        let count = 500;
        let relation = kernel.relation(count).unwrap();
        for (x, s) in [(0.3, 0.95), (0.8, 0.2)] {
            let (mut at_x, mut at_s) = (vec![0.0; count], vec![0.0; count]);
            relation.eigenfunctions(x, &mut at_x);
            relation.eigenfunctions(s, &mut at_s);
            let sum: f64 = (0..count)
                .map(|n| {
                    let cutoff = 0.5 * libm::erfc((n as f64 / count as f64 - 0.55) / 0.07);
                    cutoff * relation.expansion_factor(n) * at_x[n] * at_s[n]
                })
                .sum();
            let exact = kernel.value(x, s);
            println!("{chi} {m}: {:e}", sum - exact);
            assert!((sum - exact).abs() < 2e-11, "{chi} {m}: {sum} {exact}");
        }
    }
}

#[test]
fn masses_moments_and_expansions() {
    for (a, chi, m) in [(1.0, 2.0, 0), (0.5, 60.0, 0), (2.0, 3.0, 2), (1.5, 1.0, 7)] {
        let kernel = Yukawa::new(a, chi, m).unwrap();
        let relation = kernel.relation(60).unwrap();
        let u = |x: f64| kernel.mass_function(x);
        let (mut masses, mut moments) = (vec![0.0; 60], vec![0.0; 60]);
        let mut phi = vec![0.0; 60];
        for node in double_exponential(200) {
            // s ds w = a d eta on s = a sqrt(1 - eta^2).
            let eta = 0.5 * node.from_left;
            let x = a * (0.5 * node.from_right * (1.0 + eta)).sqrt();
            relation.eigenfunctions(x, &mut phi);
            for n in 0..60 {
                let product = 0.5 * a * node.weight * u(x) * phi[n];
                masses[n] += product;
                moments[n] += product * a * eta;
            }
        }
        let scale = u(a) * a * a;
        let found = relation.moments(&u, 60).unwrap();
        assert!(found.resolved);
        for n in 0..60 {
            assert!((relation.mass(n) - masses[n]).abs() < 1e-13 * u(a) * a, "{a} {chi} {m} {n}");
            assert!((found.values[n] - moments[n]).abs() < 1e-13 * scale, "{a} {chi} {m} {n}");
        }
        let f = |x: f64| u(x) * (1.0 + x * x).ln();
        let expansion = relation.expand(&f).unwrap();
        for i in 0..=50 {
            let x = a * f64::from(i) / 50.0;
            let error = (relation.sum(&expansion.coefficients, x) - f(x)).abs();
            assert!(error < 2e-12 * f(a).max(1e-3), "{a} {chi} {m} {x}: {error:e}");
        }
    }
}

#[test]
fn limits_of_the_count() {
    let kernel = Yukawa::new(1.0, 5.0, 0).unwrap();
    assert!(matches!(kernel.relation(0), Err(Error::InvalidParameter { name: "count", .. })));
    assert!(matches!(kernel.relation(usize::MAX), Err(Error::TooLarge { .. })));
    let relation = kernel.relation(3).unwrap();
    assert_eq!(relation.available(), 3);
    assert!(matches!(relation.gram(4), Err(Error::TooFew { needed: 4, available: 3 })));
    assert!(matches!(relation.moments(&|_| 1.0, 4), Err(Error::TooFew { .. })));
    assert!(matches!(relation.moments(&|_| f64::NAN, 2), Err(Error::NotFinite { .. })));
    let mut values = [0.0; 5];
    relation.eigenfunctions(0.4, &mut values);
    assert!(values[2].is_finite() && values[3].is_nan() && values[4].is_nan());
    assert!(relation.sum(&[1.0; 4], 0.4).is_nan() && relation.eigenvalue(3).is_nan());
    assert!(relation.norm(3).is_nan() && relation.mass(3).is_nan());
    assert!(relation.legendre_coefficients(3).is_empty());
}
