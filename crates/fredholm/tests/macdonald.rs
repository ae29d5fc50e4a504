//! The Macdonald kernel on a finite interval: collocation and the spectral relation against references.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use fredholm::collocation::solve_adaptive;
use fredholm::kernel::{Kernel as _, Macdonald, SpectralRelation};
use fredholm::quadrature::double_exponential;
use fredholm::special::macdonald;
use fredholm::{DegenerateSystem, SincOperator};
use serde_json::Value;

fn data() -> Value {
    serde_json::from_str(include_str!("data/kernel_macdonald.json")).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().unwrap().parse().unwrap())
}

fn list(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn right_hand_side(name: &str) -> fn(f64) -> f64 {
    match name {
        "1" => |_| 1.0,
        "1+x" => |x| 1.0 + x,
        other => panic!("unknown right-hand side {other}"),
    }
}

/// `int_0^d u^-mu K_mu(kappa u) du`, with the power at 0 and the decay smoothed away: `u = v^p`, panels of a few decay lengths.
fn integral_to(order: f64, decay: f64, distance: f64) -> f64 {
    let power = (4.0 / (1.0 - 2.0 * order.max(0.0))).ceil();
    let end = (distance * decay).min(60.0);
    let panels = (end / 3.0).ceil().max(1.0);
    let mut sum = 0.0;
    for panel in 0..panels as usize {
        let (left, right) = (end * panel as f64 / panels, end * (panel as f64 + 1.0) / panels);
        for node in double_exponential(40) {
            let half = 0.5 * (right - left);
            if panel == 0 {
                // u = right t^p
                let t = 0.5 * node.from_left;
                let u = right * t.powf(power);
                // What underflows does not count.
                if u > 1e-300 {
                    let derivative = right * power * t.powf(power - 1.0);
                    sum += 0.5 * node.weight * macdonald(order, u) * derivative;
                }
            } else {
                sum += half * node.weight * macdonald(order, left + half * node.from_left);
            }
        }
    }
    // u^-mu K_mu(kappa u) du = kappa^(mu - 1) z^-mu K_mu(z) dz
    decay.powf(order - 1.0) * sum
}

#[test]
fn the_integral_of_the_tests_is_right() {
    let mut worst = 0.0f64;
    let data = data();
    for case in data["integrals"].as_array().unwrap() {
        let [order, decay, half_length, x, exact] =
            ["order", "decay", "half_length", "x", "integral"].map(|key| number(&case[key]));
        let found =
            integral_to(order, decay, half_length + x) + integral_to(order, decay, half_length - x);
        worst = worst.max((found / exact - 1.0).abs());
        assert!((found / exact - 1.0).abs() < 1e-13, "{case}: {found}");
    }
    println!("worst {worst:e}");
}

#[test]
fn collocation_agrees_with_two_nystrom_methods() {
    let data = data();
    let mut worst = 0.0f64;
    for case in data["solutions"].as_array().unwrap() {
        let [order, decay, half_length] =
            ["mu", "kappa", "a"].map(|key| number(&case["params"][key]));
        let kernel = Macdonald::new(half_length, order, decay).unwrap();
        let f = right_hand_side(case["f"].as_str().unwrap());
        let parameter = number(&case["parameter"]);
        let start = std::time::Instant::now();
        let found = solve_adaptive(&kernel, parameter, f, 1e-11).unwrap();
        let time = start.elapsed();
        let (points, values) = (list(&case["x"]), list(&case["phi"]));
        let scale = values.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let error =
            |(x, exact): (&f64, &f64)| (found.solution.evaluate(*x, f(*x)) - exact).abs() / scale;
        let error = points.iter().zip(&values).map(error).fold(0.0, f64::max);
        let integral = (found.solution.integral(|_| 1.0) - number(&case["integral"])).abs() / scale;
        println!(
            "mu {order} kappa a {}: {error:.1e}, integral {integral:.1e}, half count {}, {time:?}, estimate {:.1e}",
            decay * half_length,
            found.half_count,
            found.estimate.solution
        );
        assert!(found.converged, "{case}");
        let allowed = 1e-11;
        assert!(error < allowed && integral < allowed, "{case}");
        worst = worst.max(error.max(integral));
    }
    println!("worst {worst:e}");
}

#[test]
fn a_constant_is_the_solution_of_the_equation_made_for_it() {
    for (order, decay, half_length, half_count) in [
        (0.0, 1.0, 1.0, 31),
        (0.2, 1.0, 1.0, 44),
        (-0.3, 2.0, 1.0, 31),
        (0.35, 1.0, 1.0, 88),
        (0.0, 40.0, 1.0, 352),
        (0.2, 40.0, 1.0, 352),
        (-0.3, 40.0, 1.0, 352),
        (0.35, 40.0, 1.0, 496),
        (0.0, 0.01, 1.0, 31),
        (1e-9, 0.01, 1.0, 31),
        (1e-7, 20.0, 2.0, 352),
        (0.45, 0.01, 1.0, 352),
        (-0.45, 0.01, 1.0, 31),
        (0.1, 4.0, 2.5, 88),
        (0.0, 13.0, 0.5, 62),
        (-0.1, 1e-6, 1.0, 31),
        (0.1, 1e-20, 1.0, 40),
    ] {
        let kernel = Macdonald::new(half_length, order, decay).unwrap();
        let parameter = 0.5;
        let f = |left: f64, right: f64| {
            let integral = |distance: f64| integral_to(order, decay, distance.max(0.0));
            1.0 + parameter * (integral(left) + integral(right))
        };
        let operator = SincOperator::new(&kernel, half_count).unwrap();
        let values = operator.sample_places(|p| f(p.from_left, p.from_right)).unwrap();
        let solution = &operator.solve(parameter, &[values]).unwrap()[0];
        let mut worst = 0.0f64;
        for i in 0..=100 {
            let x = half_length * (f64::from(i) * 0.02 - 1.0);
            let f = f(half_length + x, half_length - x);
            worst = worst.max((solution.evaluate(x, f) - 1.0).abs() / f);
        }
        println!("mu {order} kappa a {}: {worst:.1e}", decay * half_length);
        assert!(worst < 1e-12, "mu {order} kappa {decay} a {half_length}: {worst:e}");
    }
}

/// Largest errors of eigenvalues, eigenfunctions and Gram matrix in the measures the file's numbers are meant in.
fn spectral_errors(case: &Value) -> [f64; 4] {
    let [order, c, half_length] = ["mu", "c", "a"].map(|key| number(&case["params"][key]));
    let kernel = Macdonald::new(half_length, order, c / half_length).unwrap();
    let relation = kernel.relation(11).unwrap();
    let each = |key: &str| {
        let entries = case[key].as_object().unwrap();
        let entry = |(n, v): (&String, &Value)| (n.clone(), number(v));
        entries.iter().map(entry).collect::<Vec<_>>()
    };
    let mut errors = [0.0f64; 4];
    let mut note = |kind: usize, error: f64| errors[kind] = errors[kind].max(error);
    for (n, exact) in each("chi") {
        let found = relation.characteristic_value(n.parse().unwrap());
        note(0, (found - exact).abs() / (exact.abs() + c * c));
    }
    for (n, exact) in each("lam") {
        let found = relation.eigenvalue(n.parse().unwrap());
        note(1, (found - exact).abs() / relation.eigenvalue(0));
    }
    for (x, row) in case["phi"].as_object().unwrap() {
        let mut values = [0.0; 11];
        relation.eigenfunctions(x.parse().unwrap(), &mut values);
        for (n, exact) in row.as_object().unwrap() {
            let found = values[n.parse::<usize>().unwrap()];
            note(2, (found - number(exact)).abs() / number(exact).abs().max(1.0));
        }
    }
    let gram = relation.gram(11).unwrap();
    for (place, exact) in each("R") {
        let (k, m) = place.split_once(',').unwrap();
        let (k, m): (usize, usize) = (k.parse().unwrap(), m.parse().unwrap());
        let size = (gram.entry(k, k) * gram.entry(m, m)).sqrt();
        note(3, (gram.entry(k, m) - exact).abs() / size);
    }
    assert!(
        (0..11).all(|n| (relation.norm(n) / half_length.powf(2.0 * order) - 1.0).abs() < 1e-15)
    );
    errors
}

#[test]
fn the_spectral_relation_agrees_with_mpmath() {
    let data = data();
    for case in data["spectral"].as_array().unwrap() {
        let errors = spectral_errors(case);
        println!(
            "{}: chi, lambda, phi, R {:?}",
            case["params"],
            errors.map(|e| format!("{e:.1e}"))
        );
        assert!(errors.iter().all(|error| *error < 1e-13), "{}: {errors:?}", case["params"]);
    }
}

/// `int K(x, s) phi_n(s) w(s) ds` by quadrature in two pieces with the exact distance.
fn applied(relation: &impl SpectralRelation, n: usize, x: f64) -> f64 {
    let interval = relation.interval();
    let exponent = relation.weight_exponents().left;
    let (left, right) = (x - interval.left(), interval.right() - x);
    let mut values = vec![0.0; n + 1];
    let mut sum = 0.0;
    for node in double_exponential(300) {
        // From x to the right and to the left; the rule knows the distances to both ends of the piece.
        for (length, other, sign) in [(right, left, 1.0), (left, right, -1.0)] {
            let (distance, rest) = (0.5 * length * node.from_left, 0.5 * length * node.from_right);
            let s = x + sign * distance;
            relation.eigenfunctions(s, &mut values);
            let weight = (rest * (other + distance)).powf(exponent);
            let kernel = relation.pair(x, s, distance).value;
            sum += 0.5 * length * node.weight * kernel * weight * values[n];
        }
    }
    sum
}

#[test]
fn the_relation_holds_by_quadrature() {
    for (order, c) in [(0.0, 3.0), (-0.2, 0.5), (0.1, 20.0), (1e-9, 1e-3), (-0.05, 60.0)] {
        let relation = Macdonald::new(1.5, order, c / 1.5).unwrap().relation(60).unwrap();
        for n in [0, 1, 2, 7, 30, 59] {
            for x in [-1.2, 0.1, 0.8] {
                let mut values = vec![0.0; n + 1];
                relation.eigenfunctions(x, &mut values);
                let exact = relation.eigenvalue(n) * values[n];
                let found = applied(&relation, n, x);
                let error = (found - exact).abs() / relation.eigenvalue(0);
                // The rule ends 2e-17 before the ends, where the weight is a root.
                let left_out = 2e-17f64.powf(0.5 + order.min(-order)) * 10.0;
                assert!(error < 1e-12 + left_out, "mu {order} c {c} n {n} x {x}: {found} {exact}");
            }
        }
    }
}

/// `Gamma(x)` for `0 < x <= 1`, from `x Gamma(x) = int_0^inf t^x e^-t dt`.
fn gamma(x: f64) -> f64 {
    let term = |node: fredholm::quadrature::Node| {
        let t = 20.0 * node.from_left;
        20.0 * node.weight * (-t).exp() * t.powf(x)
    };
    double_exponential(400).map(term).sum::<f64>() / x
}

#[test]
fn many_eigenvalues_fall_and_follow_their_law() {
    for (order, c) in
        [(0.2, 1.0), (0.0, 40.0), (-0.3, 2.0), (1e-7, 500.0), (0.499, 3.0), (-0.499, 3.0)]
    {
        let relation = Macdonald::new(1.0, order, c).unwrap().relation(200).unwrap();
        // sqrt(pi) (2c)^-mu Gamma(1/2 - mu) (chi_n + c^2)^(mu - 1/2), the symbol of the kernel at the frequency of phi_n
        let law = |n: usize| {
            let frequency = relation.characteristic_value(n) + c * c;
            std::f64::consts::PI.sqrt()
                * (2.0 * c).powf(-order)
                * gamma(0.5 - order)
                * frequency.powf(order - 0.5)
        };
        for n in [150, 199] {
            let error = relation.eigenvalue(n) / law(n) - 1.0;
            assert!(error.abs() < 5e-6, "mu {order} c {c} n {n}: {error:e}");
        }
        for n in 1..200 {
            let (value, before) = (relation.eigenvalue(n), relation.eigenvalue(n - 1));
            assert!(value > 0.0 && value <= before * (1.0 + 1e-13), "mu {order} c {c} n {n}");
        }
    }
}

#[test]
fn the_trace_of_the_bounded_kernel_is_the_sum_of_its_eigenvalues() {
    // sum lambda_n = K(0) int w, Mercer, with the tail of the law n^(2 mu - 1) summed by an integral.
    for (order, c) in [(-0.45, 1.0), (-0.3, 5.0)] {
        let relation = Macdonald::new(1.0, order, c).unwrap().relation(400).unwrap();
        let sum: f64 = (0..400).map(|n| relation.eigenvalue(n)).sum();
        let tail = relation.eigenvalue(399) * 399.5f64.powf(1.0 - 2.0 * order)
            / ((-2.0 * order) * 400f64.powf(-2.0 * order));
        let at_zero = relation.split(0.0, 0.0, 0.0);
        // sigma(0) = 1/(2 |mu|)
        let kernel = at_zero.rest + at_zero.factor / (-2.0 * order);
        let weight = relation.mass(0) * relation.mass(0)
            + (1..200).map(|n| relation.mass(2 * n).powi(2)).sum::<f64>();
        let exact = kernel * weight;
        let error = ((sum + tail) / exact - 1.0).abs();
        println!("mu {order} c {c}: {error:e}, tail {:e}", tail / exact);
        assert!(error < 0.05 * tail / exact, "mu {order} c {c}: {error:e}");
    }
}

#[test]
fn functions_expand_and_have_their_masses() {
    for (order, c, half_length) in [(0.2, 1.0, 2.0), (0.0, 20.0, 0.5), (-0.4, 3.0, 1.0)] {
        let kernel = Macdonald::new(half_length, order, c / half_length).unwrap();
        let relation = kernel.relation(120).unwrap();
        let f = |x: f64| (1.0 + x / half_length).exp();
        let expansion = relation.expand(&f).unwrap();
        assert!(expansion.resolved, "{}", expansion.error);
        let mut mass = 0.0;
        for (n, coefficient) in expansion.coefficients.iter().enumerate() {
            mass += coefficient * relation.mass(n);
        }
        for x in [-1.0, -0.4, 0.3, 1.0] {
            let x = half_length * x;
            let error = (relation.sum(&expansion.coefficients, x) / f(x) - 1.0).abs();
            assert!(error < 1e-12, "mu {order} c {c} x {x}: {error:e}");
        }
        // int f w: by quadrature with the exact distances to the ends.
        let term = |node: fredholm::quadrature::Node| {
            let (left, right) = (0.5 * node.from_left, 0.5 * node.from_right);
            // x = -a + 2 a left^p/(left^p + right^p): the powers at the ends smoothed away
            let p = (8.0f64).max(4.0 / (order + 0.5));
            let sum = left.powf(p) + right.powf(p);
            let [u, v] = [left, right].map(|d| 2.0 * d.powf(p) / sum);
            // What underflows does not count.
            if u.min(v) < 1e-290 {
                return 0.0;
            }
            let derivative = 0.5 * p * u * v * (0.5 / left + 0.5 / right) * half_length;
            node.weight
                * derivative
                * f(half_length * (u - 1.0))
                * (half_length * half_length * u * v).powf(order - 0.5)
        };
        let exact: f64 = double_exponential(1200).map(term).sum();
        assert!((mass / exact - 1.0).abs() < 1e-12, "mu {order} c {c}: {mass} {exact}");
        let unit = |x: f64| {
            let mut values = [0.0; 8];
            relation.eigenfunctions(x, &mut values);
            values[7]
        };
        for (n, c) in relation.expand(&unit).unwrap().coefficients.iter().enumerate() {
            assert!((c - f64::from(u8::from(n == 7))).abs() < 1e-13, "{n} {c}");
        }
    }
}

#[test]
fn both_methods_agree() {
    for (order, c, degree, tolerance) in [
        (0.0, 1.0, 100, 2e-5),
        (-0.3, 2.0, 100, 1e-6),
        (0.0, 40.0, 199, 2e-5),
        (0.3, 1.0, 199, 5e-4),
    ] {
        let kernel = Macdonald::new(1.0, order, c).unwrap();
        let relation = kernel.relation(degree + 1).unwrap();
        let f = |x: f64| 1.0 + x * x;
        let system = DegenerateSystem::new(&relation, 0.5, degree).unwrap();
        let solution = system.solve(&relation.moments(&f, degree + 1).unwrap().values);
        let independent = solve_adaptive(&relation, 0.5, f, 1e-11).unwrap().solution;
        for x in [-0.9, 0.0, 0.5] {
            let (found, exact) = (solution.evaluate(x, f(x)), independent.evaluate(x, f(x)));
            let error = (found - exact).abs();
            println!("mu {order} c {c}: {error:.1e}");
            assert!(error < tolerance, "mu {order} c {c} x {x}: {error:e}");
        }
    }
}

#[test]
fn says_what_was_wrong() {
    for order in [0.5, -0.5, 3.0, f64::NAN] {
        assert!(Macdonald::new(1.0, order, 1.0).is_err());
    }
    for decay in [0.0, -1.0, f64::INFINITY, f64::NAN, 1e-21, 1e6] {
        assert!(Macdonald::new(1.0, 0.1, decay).is_err());
    }
    assert!(Macdonald::new(f64::NAN, 0.1, 1.0).is_err());
    let kernel = Macdonald::new(1.0, 0.24, 1000.0).unwrap();
    assert!(kernel.is_square_summable());
    assert!(!Macdonald::new(1.0, 0.25, 1.0).unwrap().is_square_summable());
    // Below the smallest number; NaN stays.
    assert_eq!(kernel.value(-0.9, 0.9), 0.0);
    assert!(kernel.value(f64::NAN, 0.0).is_nan());
    let relation = kernel.relation(12).unwrap();
    assert_eq!(relation.available(), 12);
    assert!(kernel.relation(0).is_err() && kernel.relation(5000).is_err());
    assert!(relation.gram(13).is_err());
    assert!(relation.eigenvalue(12).is_nan() && relation.norm(12).is_nan());
    assert!(relation.mass(12).is_nan() && relation.characteristic_value(12).is_nan());
    assert!(relation.sum(&[0.0; 13], 0.1).is_nan());
    let mut values = [0.0; 13];
    relation.eigenfunctions(0.1, &mut values);
    assert!(values[12].is_nan() && values[..12].iter().all(|value| value.is_finite()));
}

/// The message speaks of the kernel, not of breakpoints that nobody gave.
#[test]
fn a_kernel_too_narrow_for_collocation_is_named() {
    let kernel = Macdonald::new(1.0, 0.25, 1000.0).unwrap();
    let error = solve_adaptive(&kernel, 1.0, |_| 1.0, 1e-9).unwrap_err();
    let said = "the number of nodes on either side that so narrow a kernel needs comes out as 1532, and the method takes at most 1500";
    assert!(error.to_string().starts_with(said), "{error}");
    assert!(solve_adaptive(&Macdonald::new(1.0, 0.25, 300.0).unwrap(), 1.0, |_| 1.0, 1e-9).is_ok());
}
