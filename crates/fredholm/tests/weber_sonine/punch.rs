//! The circular punch on a rough half-space: `epsilon q + int_0^1 W q s ds = d - A xi^2`.

use fredholm::collocation::{AdaptiveSolution, solve_adaptive};
use fredholm::kernel::WeberSonine;

use super::{Worst, list, number, solutions};

/// `(epsilon + W)^-1 f` times `epsilon`.
fn resolve(kernel: &WeberSonine, epsilon: f64, f: fn(f64) -> f64) -> AdaptiveSolution {
    solve_adaptive(kernel, 1.0 / epsilon, f, 1e-12).unwrap()
}

#[test]
fn settlement_and_pressure_agree_with_product_integration() {
    let flat = WeberSonine::new(1.0, 0.0, 0.0).unwrap();
    let tilted = WeberSonine::new(1.0, 1.0, 0.0).unwrap();
    let mut worst = Worst::new("circular punch, of the largest value");
    let mut smooth = Worst::new("almost smooth circular punch, of the largest value");
    for case in list(&solutions()["punch"]) {
        let epsilon = number(&case["epsilon"]);
        let start = std::time::Instant::now();
        let (one, square) = (resolve(&flat, epsilon, |_| 1.0), resolve(&flat, epsilon, |x| x * x));
        let tilt = resolve(&tilted, epsilon, |x| x);
        println!(
            "epsilon {epsilon}: {} {} {} nodes a side, {:.0} ms",
            one.half_count,
            square.half_count,
            tilt.half_count,
            1e3 * start.elapsed().as_secs_f64()
        );
        let u = |x: f64| one.solution.evaluate(x, 1.0) / epsilon;
        let v = |x: f64| square.solution.evaluate(x, x * x) / epsilon;
        let (mass_u, mass_v) =
            (one.solution.integral(|_| 1.0) / epsilon, square.solution.integral(|_| 1.0) / epsilon);
        let mut check = |key: &str, found: f64, size: f64| {
            let error = (found - number(&case[key])).abs() / size;
            let table = if epsilon < 1e-3 { &mut smooth } else { &mut worst };
            table.add(error, || format!("epsilon = {epsilon}, {key}"));
        };
        let mut pressure = |name: &str, d: f64, a: f64, points: &[(&str, f64)]| {
            check(&format!("{name}.d"), d, d);
            let q = |x: f64| d * u(x) - a * v(x);
            let largest = points.iter().fold(0.0, |most: f64, (_, x)| most.max(q(*x).abs()));
            for (key, x) in points {
                check(&format!("{name}.q({key})"), q(*x), largest);
            }
        };
        let points = [("0", 0.0), ("0.5", 0.5), ("1", 1.0)];
        pressure("flat", 0.5 / mass_u, 0.0, &points);
        pressure("parab(A=0.3)", (0.5 + 0.3 * mass_v) / mass_u, 0.3, &points);
        // d u(1) = A v(1)
        let share = v(1.0) / u(1.0);
        let a = 0.5 / (share * mass_u - mass_v);
        pressure("freeedge", share * a, a, &points[..2]);
        check("freeedge.A", a, a);
        let w = |x: f64| tilt.solution.evaluate(x, x) / epsilon;
        let alpha = epsilon / tilt.solution.integral(|x| x);
        check("tilt.alpha", alpha, alpha);
        let largest = alpha * w(1.0);
        check("tilt.q1(0.5)", alpha * w(0.5), largest);
        check("tilt.q1(1)", largest, largest);
    }
    worst.require(1e-12);
    // The reference itself agrees to 8e-12 only.
    smooth.require(1.2e-11);
}

/// Differentiating the equation of the parabola with a free edge gives that of the tilt: `q_1 = -dq/dxi`, `alpha = 2 A`.
#[test]
fn the_tilt_is_the_derivative_of_the_parabola_with_a_free_edge() {
    let flat = WeberSonine::new(1.0, 0.0, 0.0).unwrap();
    let tilted = WeberSonine::new(1.0, 1.0, 0.0).unwrap();
    for epsilon in [0.03, 0.7] {
        let (one, square) = (resolve(&flat, epsilon, |_| 1.0), resolve(&flat, epsilon, |x| x * x));
        let share = square.solution.evaluate(1.0, 1.0) / one.solution.evaluate(1.0, 1.0);
        let mass = share * one.solution.integral(|_| 1.0) - square.solution.integral(|_| 1.0);
        let a = 0.5 * epsilon / mass;
        let alpha = epsilon / resolve(&tilted, epsilon, |x| x).solution.integral(|x| x);
        assert!((alpha / (2.0 * a) - 1.0).abs() < 1e-12, "{epsilon}: {alpha} {a}");
    }
}
