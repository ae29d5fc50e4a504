//! The Macdonald kernel on a finite interval: collocation and the spectral relation against references.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use fredholm::collocation::solve_adaptive;
use fredholm::kernel::{Kernel, Macdonald};
use fredholm::quadrature::double_exponential;
use fredholm::special::macdonald;
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
                sum +=
                    0.5 * node.weight * macdonald(order, u) * right * power * t.powf(power - 1.0);
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
    for (order, decay, half_length) in [
        (0.0, 1.0, 1.0),
        (0.2, 1.0, 1.0),
        (-0.3, 2.0, 1.0),
        (0.35, 1.0, 1.0),
        (0.0, 40.0, 1.0),
        (0.2, 40.0, 1.0),
        (-0.3, 40.0, 1.0),
        (0.35, 40.0, 1.0),
        (0.0, 0.01, 1.0),
        (1e-9, 0.01, 1.0),
        (1e-7, 20.0, 2.0),
        (0.45, 0.01, 1.0),
        (-0.45, 0.01, 1.0),
        (0.1, 4.0, 2.5),
        (0.0, 13.0, 0.5),
        (0.0, 120.0, 1.0),
        (-0.1, 1e-6, 1.0),
    ] {
        let kernel = Macdonald::new(half_length, order, decay).unwrap();
        let parameter = 0.5;
        let f = |left: f64, right: f64| {
            1.0 + parameter
                * (integral_to(order, decay, left.max(0.0))
                    + integral_to(order, decay, right.max(0.0)))
        };
        let start = std::time::Instant::now();
        let _ = Macdonald::new(half_length, order, decay).unwrap();
        let made = start.elapsed();
        for half_count in [16, 22, 31, 44, 62, 88, 124, 176, 248, 352, 496] {
            let start = std::time::Instant::now();
            let operator = fredholm::SincOperator::new(&kernel, half_count).unwrap();
            let values = operator.sample_places(|p| f(p.from_left, p.from_right)).unwrap();
            let start2 = std::time::Instant::now();
            let solution = &operator.solve(parameter, &[values]).unwrap()[0];
            let times = (start2 - start, start2.elapsed());
            let mut worst = 0.0f64;
            for i in 0..=100 {
                let x = half_length * (f64::from(i) * 0.02 - 1.0);
                let f = f(half_length + x, half_length - x);
                worst = worst.max((solution.evaluate(x, f) - 1.0).abs() / f);
            }
            println!(
                "mu {order} kappa a {}: {half_count} {worst:.1e} {made:?} {times:?}",
                decay * half_length
            );
            if worst < 1e-13 {
                break;
            }
        }
    }
}
