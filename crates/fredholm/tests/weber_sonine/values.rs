//! Values of the kernel.

use std::f64::consts::{FRAC_1_PI, PI};

use fredholm::kernel::{Kernel, WeberSonine};

use super::{Worst, kernel, list, name, numbers, reference};

#[test]
fn agree_with_the_tables() {
    let mut worst = Worst::new("values of the kernel, table of relations");
    for case in list(&reference()["kernels"]) {
        let kernel = kernel(case);
        for row in list(&case["values"]).iter().map(numbers) {
            let found = kernel.value(row[0], row[1]);
            worst.add((found / row[2] - 1.0).abs(), || format!("{} {row:?}", name(case)));
        }
    }
    worst.require(2e-14);
}

#[test]
fn agree_with_mpmath_for_all_parameters_and_distances() {
    let text = include_str!("../data/weber_sonine_values.txt");
    let mut worst = Worst::new("values of the kernel, all parameters");
    let mut deep = Worst::new("values of the kernel, deep in the corner");
    let mut kernel: Option<WeberSonine> = None;
    let mut compared = 0;
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let row: Vec<f64> = line.split_whitespace().map(|field| field.parse().unwrap()).collect();
        let same = kernel.as_ref().is_some_and(|k| k.order() == row[0] && k.exponent() == row[1]);
        if !same {
            kernel = Some(WeberSonine::new(1.0, row[0], row[1]).unwrap());
        }
        let kernel = kernel.as_ref().unwrap();
        let (x, s, exact) = (row[2], row[3], row[4]);
        for found in [kernel.value(x, s), kernel.value(s, x)] {
            let table = if x > 1e-30 { &mut worst } else { &mut deep };
            table.add((found / exact - 1.0).abs(), || line.to_owned());
        }
        compared += 1;
    }
    assert_eq!(compared, 1386);
    worst.require(5e-14);
    // Powers of 1e-90: ln x has the size 200, and its rounding counts.
    deep.require(3e-13);
}

#[test]
fn order_one_half_has_its_closed_form() {
    // sqrt(x s) W = Gamma(2 gamma) cos(pi gamma)/pi [|x-s|^(-2 gamma) - (x+s)^(-2 gamma)]; (1/pi) ln((x+s)/|x-s|)
    let mut worst = Worst::new("values of order 1/2 against the closed form");
    for gamma in [-0.45, -0.2, 0.0, 1e-9, 0.05, 0.25, 0.45] {
        let kernel = WeberSonine::new(3.0, 0.5, gamma).unwrap();
        for (x, ratio) in [(3.0f64, 0.01), (0.3, 0.4), (2.0, 0.75), (1e-3, 0.95), (1.7, 0.9999)] {
            let s = x * ratio;
            let quotient = ((x + s) / (x - s)).ln();
            let q = 2.0 * gamma;
            // Gamma(q) [e^(q u) - e^(q v)] = Gamma(1+q) e^(q v) (e^(q (u-v)) - 1)/q
            let difference = if gamma == 0.0 {
                quotient
            } else {
                (q * quotient).exp_m1() / q * (x + s).powf(-q)
            };
            let exact = libm::tgamma(1.0 + q) * (PI * gamma).cos() * FRAC_1_PI * difference
                / (x * s).sqrt();
            let found = kernel.value(x, s);
            worst.add((found / exact - 1.0).abs(), || format!("{gamma} {x} {s}"));
        }
    }
    worst.require(1e-14);
}

#[test]
fn order_zero_is_an_elliptic_integral() {
    // W_0 = (2/pi) K(k)/(x+s), complementary modulus |x-s|/(x+s): 1/(agm(1, k') (x+s))
    let kernel = WeberSonine::new(1.0, 0.0, 0.0).unwrap();
    let mut worst = Worst::new("values of order 0 against the elliptic integral");
    for i in 0..2000 {
        let x = 0.3 + 0.7 * f64::from(i % 40) / 40.0;
        let distance = x * 0.985f64.powi(i);
        let s = x - distance;
        if s <= 0.0 {
            continue;
        }
        let (mut a, mut b) = (1.0, distance / (x + s));
        for _ in 0..12 {
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        let exact = 1.0 / (a * (x + s));
        let found = kernel.pair(x, s, distance).value;
        worst.add((found / exact - 1.0).abs(), || format!("{x} {distance}"));
    }
    worst.require(5e-15);
}

#[test]
fn the_diagonal_is_the_limit() {
    let mut worst = Worst::new("split on the diagonal against values near it");
    for order in [0.0, 0.5, 1.0, 5.0] {
        for gamma in [-0.45, -0.2, -1e-7, 0.0, 1e-12, 1e-3, 0.2, 0.45] {
            let kernel = WeberSonine::new(2.0, order, gamma).unwrap();
            for x in [1.9, 0.4, 1e-5] {
                let split = kernel.split(x, x, 0.0);
                // A and B change by the square of d over x, beside a linear part in x.
                let share = 1e-9;
                let (left, right) = (x * (1.0 - 0.5 * share), x * (1.0 + 0.5 * share));
                let distance = right - left;
                let exact = kernel.pair(left, right, distance).value;
                let found = split.value(kernel.singularity(), distance);
                let size = (split.factor * kernel.singularity().value(distance)).abs();
                worst.add((found - exact).abs() / size, || format!("{order} {gamma} {x}"));
                let pair = kernel.pair(left, right, distance);
                worst
                    .add((pair.factor / split.factor - 1.0).abs(), || format!("A {order} {gamma}"));
            }
        }
    }
    worst.require(1e-13);
}

#[test]
fn limits_at_the_centre_and_in_the_corners() {
    for gamma in [-0.4, 0.0, 0.4] {
        let flat = WeberSonine::new(1.0, 0.0, gamma).unwrap();
        let limit = flat.value(0.0, 0.7);
        assert!((flat.value(1e-200, 0.7) / limit - 1.0).abs() < 1e-13);
        assert_eq!(flat.value(0.7, 0.0), limit);
        for order in [0.3, 1.0, 5.0] {
            let kernel = WeberSonine::new(1.0, order, gamma).unwrap();
            assert_eq!(kernel.value(0.0, 0.7), 0.0);
            // W ~ x^mu
            let [one, other] = [1e-9, 1e-7].map(|x| kernel.value(x, 0.7));
            assert!(((other / one).log10() - 2.0 * order).abs() < 1e-12);
        }
    }
    for order in [0.0, 1e-3, 0.5, 1.0, 5.0, 100.0] {
        for gamma in [-0.4999, -0.3, 0.0, 1e-300, 0.3, 0.4999] {
            let kernel = WeberSonine::new(1.0, order, gamma).unwrap();
            for x in [1.0, 0.5, 1e-100, 1e-300, 5e-324, 0.0] {
                let at = kernel.split(x, x, 0.0);
                assert!(at.factor.is_finite() && at.rest.is_finite(), "{order} {gamma} {x}");
                assert!(kernel.value(x, x) > 0.0, "{order} {gamma} {x}");
                for s in [1.0, 0.999, 1e-80, 2e-300, 5e-324, 0.0] {
                    let pair = kernel.pair(x, s, (x - s).abs());
                    let finite = x == s || pair.value.is_finite();
                    assert!(finite && pair.value >= 0.0, "{order} {gamma} {x} {s}: {pair:?}");
                    assert!(pair.factor.is_finite(), "{order} {gamma} {x} {s}: {pair:?}");
                }
            }
        }
    }
}

#[test]
fn parameters_out_of_range_are_refused_with_reasons() {
    let refused = |a, mu, gamma| WeberSonine::new(a, mu, gamma).unwrap_err().to_string();
    for a in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(refused(a, 0.0, 0.0).contains("radius"), "{a}");
    }
    for mu in [-0.1, 100.5, f64::NAN, f64::INFINITY] {
        assert!(refused(1.0, mu, 0.0).contains("positive"), "{mu}");
    }
    for gamma in [-0.5, 0.5, 3.0, f64::NAN] {
        assert!(refused(1.0, 0.0, gamma).contains("integrable"), "{gamma}");
    }
    assert!(refused(1e-6, 60.0, 0.0).contains("scale lengths"));
    assert!(WeberSonine::new(1e-6, 5.0, 0.0).is_ok());
}
