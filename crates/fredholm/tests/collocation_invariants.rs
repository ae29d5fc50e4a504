//! What must hold of collocation whatever the numbers: symmetry, linearity, reciprocity, agreement of its own routes.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use crate::common::{Disguised, Layered};
use fredholm::collocation::{Place, PointSet, SweepValue};
use fredholm::kernel::{Kernel, Logarithm, Power};
use fredholm::{DegenerateSystem, Interval, SincOperator, SincSolution};
use proptest::prelude::*;

type Function = fn(f64) -> f64;

fn grid_points(count: usize) -> impl Iterator<Item = f64> {
    // Not symmetric, crowded at both ends, ends included.
    (0..count)
        .map(move |i| (std::f64::consts::PI * (i as f64 / (count - 1) as f64).powf(1.1)).cos())
}

fn solve(operator: &SincOperator, parameter: f64, f: impl Fn(f64) -> f64) -> SincSolution {
    operator.factor(parameter).unwrap().solve(&operator.sample(f).unwrap()).unwrap()
}

fn largest_difference(a: &SincSolution, b: &SincSolution, f: impl Fn(f64) -> f64) -> f64 {
    let difference = |x: f64| (a.evaluate(x, f(x)) - b.evaluate(x, f(x))).abs();
    grid_points(1000).map(difference).fold(0.0, f64::max)
}

fn scale(solution: &SincSolution) -> f64 {
    solution.values().iter().fold(0.0, |a: f64, b| a.max(b.abs()))
}

#[test]
fn profiles_have_12_digits_between_1000_points() {
    let kernel = Logarithm::unit();
    let profiles: [(&str, Function); 4] =
        [("1", |_| 1.0), ("x", |x| x), ("cosh", f64::cosh), ("1/(2-x)", |x| 1.0 / (2.0 - x))];
    for (theta, half_counts) in
        [(1e-3, [40, 55]), (1.0, [40, 55]), (60.0, [56, 75]), (1e4, [110, 151]), (1e5, [140, 190])]
    {
        let [coarse, fine] = half_counts.map(|n| SincOperator::new(&kernel, n).unwrap());
        for (name, f) in profiles {
            let (a, b) = (solve(&coarse, theta, f), solve(&fine, theta, f));
            let difference = largest_difference(&a, &b, f) / scale(&b);
            println!("{theta} {name}: {difference:.1e}");
            assert!(difference < 1e-12, "{theta} {name}: {difference:e}");
        }
    }
}

#[test]
fn kinks_have_11_digits_up_to_1e4() {
    let (kernel, kink) = (Logarithm::unit(), |x: f64| (x - 0.2).abs() + (x + 0.7).abs());
    for (theta, half_counts) in [(1.0, [30, 41]), (100.0, [50, 70]), (1e4, [90, 125])] {
        let [a, b] = half_counts.map(|half_count| {
            let operator = SincOperator::with_breaks(&kernel, half_count, &[0.2, -0.7]).unwrap();
            solve(&operator, theta, kink)
        });
        let difference = largest_difference(&a, &b, kink) / scale(&b);
        println!("kink, {theta}: {difference:.1e}");
        assert!(difference < 1e-11, "{theta}: {difference:e}");
    }
}

#[test]
fn places_keep_the_digits_a_position_loses() {
    let operator = SincOperator::new(&Logarithm::unit(), 50).unwrap();
    let solution = solve(&operator, 10.0, |_| 1.0);
    let near = Place { position: 1.0, from_left: 2.0, from_right: 1e-9, panel: 0 };
    let (end, found) = (solution.evaluate(1.0, 1.0), solution.evaluate_place(near, 1.0));
    // phi' ~ lambda phi(1) ln(d): phi(1 - d) - phi(1) = lambda phi(1) d ln d + O(d)
    let slope = (found - end) / (10.0 * end * 1e-9 * 1e-9f64.ln());
    assert!((slope - 1.0).abs() < 0.1, "{slope}");
    for (place, value) in operator.places().zip(solution.values()) {
        assert!((solution.evaluate_place(place, 1.0) - value).abs() < 1e-14);
    }
}

#[test]
fn parity_and_shift_change_nothing() {
    let shifted = |even| Disguised { kernel: Logarithm::unit(), shift: 3.0, even };
    let plain = SincOperator::new(&Logarithm::unit(), 50).unwrap();
    let expected = solve(&plain, 20.0, f64::exp);
    for even in [false, true] {
        let operator = SincOperator::new(&shifted(even), 50).unwrap();
        let found = solve(&operator, 20.0, |x| (x - 3.0).exp());
        assert!((found.integral(|_| 1.0) - expected.integral(|_| 1.0)).abs() < 1e-14);
        for x in grid_points(101) {
            let f = x.exp();
            assert!((found.evaluate(x + 3.0, f) - expected.evaluate(x, f)).abs() < 2e-12);
        }
    }
}

#[test]
fn a_breakpoint_too_many_costs_no_accuracy() {
    let kernel = Logarithm::unit();
    let expected = solve(&SincOperator::new(&kernel, 60).unwrap(), 10.0, f64::exp);
    for breaks in [vec![0.0], vec![0.3], vec![-0.999, 0.1, 0.5]] {
        let operator = SincOperator::with_breaks(&kernel, 60, &breaks).unwrap();
        let found = solve(&operator, 10.0, f64::exp);
        let difference = largest_difference(&found, &expected, f64::exp);
        assert!(difference < 1e-12, "{breaks:?}: {difference:e}");
    }
}

#[test]
fn a_jump_is_resolved_from_both_sides() {
    // f = sign(x - c): its solution plus that of -f is zero, and the jump of phi is the jump of f.
    let (c, kernel) = (0.3, Logarithm::unit());
    let step = |x: f64| if x < c { -1.0 } else { 1.0 };
    let coarse = SincOperator::with_breaks(&kernel, 40, &[c]).unwrap();
    let fine = SincOperator::with_breaks(&kernel, 70, &[c]).unwrap();
    let (a, b) = (solve(&coarse, 2.0, step), solve(&fine, 2.0, step));
    assert!(largest_difference(&a, &b, step) < 1e-13);
    assert!((b.evaluate(c, 1.0) - b.evaluate(c, -1.0) - 2.0).abs() < 1e-15);
    let unbroken = solve(&SincOperator::new(&kernel, 70).unwrap(), 2.0, step);
    assert!(largest_difference(&unbroken, &b, step) > 1e-3, "the breakpoint is needed");
}

#[test]
fn a_kink_agrees_with_the_degenerate_kernel() {
    // int_{-1}^1 |x| T_n dx for even n, from int_0^1 T_m for odd m
    let half = |m: f64| {
        let cosine = |k: f64| (k * std::f64::consts::FRAC_PI_2).cos();
        let upper = (1.0 - cosine(m + 1.0)) / (2.0 * (m + 1.0));
        if m == 1.0 { upper } else { upper - (1.0 - cosine(m - 1.0)) / (2.0 * (m - 1.0)) }
    };
    let moment = |n: usize| match n {
        _ if n % 2 == 1 => 0.0,
        0 => 2.0 * half(1.0),
        _ => half(n as f64 + 1.0) + half(n as f64 - 1.0),
    };
    let (kernel, theta) = (Logarithm::unit(), 3.0);
    let operator = SincOperator::with_breaks(&kernel, 50, &[0.0]).unwrap();
    let exact = solve(&operator, theta, f64::abs).integral(|_| 1.0);
    let error = |degree: usize| {
        let system = DegenerateSystem::new(&kernel, theta, degree).unwrap();
        let moments: Vec<f64> = (0..=degree).map(moment).collect();
        (system.solve(&moments).projections()[0] - exact).abs()
    };
    let (coarse, fine) = (error(200), error(400));
    let order = (coarse / fine).log2();
    assert!(fine < 1e-9 && (order - 4.0).abs() < 0.2, "{coarse:e} {fine:e} {order}");
}

#[test]
fn an_indefinite_kernel_is_solved_and_a_singular_parameter_refused() {
    // ln 1/|x - s| on (-4, 4) has one negative eigenvalue.
    let kernel = Logarithm::new(4.0).unwrap();
    let operator = SincOperator::new(&kernel, 60).unwrap();
    let spectrum = operator.spectrum().unwrap();
    let eigenvalues = spectrum.eigenvalues();
    let negative = eigenvalues[0];
    assert!(negative < -1.0 && eigenvalues[1] > -1e-12);
    let factor = operator.factor(3.0).unwrap();
    assert!(!factor.is_positive());
    let f = operator.sample(f64::cos).unwrap();
    let (a, b) = (factor.solve(&f).unwrap(), spectrum.solve(3.0, &f).unwrap());
    assert!(largest_difference(&a, &b, f64::cos) < 1e-11 * scale(&a));
    // On (-a, a) the kernel is that of (-1, 1) less ln a: the rank-one step by hand.
    let unit = SincOperator::new(&Logarithm::unit(), 60).unwrap();
    let (one, g) = (solve(&unit, 12.0, |_| 1.0), solve(&unit, 12.0, |x| (4.0 * x).cos()));
    let shift = 12.0 * 4f64.ln();
    let force = g.integral(|_| 1.0) / (1.0 - shift * one.integral(|_| 1.0));
    for x in [-4.0, -1.0, 0.5, 4.0] {
        let exact = g.evaluate(x / 4.0, x.cos()) + shift * force * one.evaluate(x / 4.0, 1.0);
        assert!((a.evaluate(x, x.cos()) - exact).abs() < 1e-11, "{x}");
    }
    for eigenvalue in [negative, eigenvalues[eigenvalues.len() - 1]] {
        let parameter = -1.0 / eigenvalue;
        for error in [operator.factor(parameter).err(), spectrum.solve(parameter, &f).err()] {
            assert!(matches!(error, Some(fredholm::Error::Singular { .. })), "{error:?}");
        }
        assert!(operator.factor(parameter * 1.01).is_ok());
    }
    let error = spectrum.sweep(&f, [0.0, 0.0], 10.0).unwrap_err();
    assert!(matches!(error, fredholm::Error::NotPositiveDefinite { .. }));
}

#[test]
fn smooth_kernels_without_parity_are_solved() {
    // K = x s on (0, 2) has the single eigenvalue 8/3: phi = f - lambda x <x, f>/(1 + 8 lambda/3).
    struct Product;
    impl Kernel for Product {
        fn interval(&self) -> Interval {
            Interval::new(0.0, 2.0).unwrap()
        }
        fn singularity(&self) -> fredholm::kernel::Singularity {
            fredholm::kernel::Singularity::None
        }
        fn split(&self, x: f64, s: f64, _distance: f64) -> fredholm::kernel::Split {
            fredholm::kernel::Split { factor: 0.0, rest: x * s }
        }
    }
    let operator = SincOperator::new(&Product, 40).unwrap();
    let spectrum = operator.spectrum().unwrap();
    let eigenvalues = spectrum.eigenvalues();
    assert!((eigenvalues[eigenvalues.len() - 1] - 8.0 / 3.0).abs() < 1e-14);
    let parameter = 0.7;
    let found = solve(&operator, parameter, f64::sqrt);
    let product = 2f64.powf(2.5) / 2.5;
    for x in [0.0_f64, 0.3, 1.7, 2.0] {
        let exact = x.sqrt() - parameter * x * product / (1.0 + parameter * 8.0 / 3.0);
        assert!((found.evaluate(x, x.sqrt()) - exact).abs() < 1e-14, "{x}");
    }
    let f = operator.sample(f64::sqrt).unwrap();
    check_sweep(&operator, &f, [0.0, std::f64::consts::SQRT_2], f64::sqrt, &[0.0, 0.1, 5.0]);
}

fn check_sweep(
    operator: &SincOperator,
    f: &[f64],
    ends: [f64; 2],
    function: impl Fn(f64) -> f64,
    parameters: &[f64],
) {
    let sweep =
        operator.spectrum().unwrap().sweep(f, ends, parameters[parameters.len() - 1]).unwrap();
    let interval = operator.interval();
    let edges = [interval.left(), interval.right()];
    for &parameter in parameters {
        let value = sweep.at(parameter);
        let [one, x] = [solve(operator, parameter, |_| 1.0), solve(operator, parameter, |x| x)];
        let phi = solve(operator, parameter, &function);
        let mut pairs = vec![
            (value.one_one, one.integral(|_| 1.0)),
            (value.one_x, x.integral(|_| 1.0)),
            (value.one_x, one.integral(|x| x)),
            (value.x_x, x.integral(|x| x)),
            (value.one_f, phi.integral(|_| 1.0)),
            (value.x_f, phi.integral(|x| x)),
        ];
        for (k, &edge) in edges.iter().enumerate() {
            pairs.push((value.ends_one[k], one.evaluate(edge, 1.0)));
            pairs.push((value.ends_x[k], x.evaluate(edge, edge)));
            pairs.push((value.ends_f[k], phi.evaluate(edge, ends[k])));
        }
        for (k, (found, exact)) in pairs.iter().enumerate() {
            assert!((found - exact).abs() < 1e-12, "{parameter}, {k}: {found} {exact}");
        }
        // Both integrals prescribed: the combination really has them.
        let found = value.prescribe(0.4, -0.1, -1.0);
        let combined = |u: fn(f64) -> f64| {
            found.constant * one.integral(u) + found.slope * x.integral(u) - phi.integral(u)
        };
        let size = found.constant.abs() + found.slope.abs() + 1.0;
        assert!((combined(|_| 1.0) - 0.4).abs() < 1e-12 * size);
        assert!((combined(|x| x) + 0.1).abs() < 1e-12 * size);
    }
    let count = parameters.len() * 7 + 3;
    let many: Vec<f64> = (0..count).map(|i| parameters[i % parameters.len()]).collect();
    let mut serial = vec![SweepValue::default(); count];
    let mut threaded = serial.clone();
    sweep.run(&many, &mut serial);
    for threads in [1, 2, 3, 7] {
        threaded.fill(SweepValue::default());
        sweep.run_on_threads(&many, &mut threaded, threads);
        assert_eq!(serial, threaded, "{threads} threads");
    }
    assert_eq!(serial[1], sweep.at(many[1]));
    assert!(sweep.at(-1.0).one_one.is_nan() && sweep.at(f64::NAN).one_one.is_nan());
}

#[test]
fn sweeps_agree_with_single_solutions() {
    let f = |x: f64| x.exp() + x * x;
    let parameters = [0.0, 1e-3, 1.0, 60.0, 1e4];
    for even in [true, false] {
        for shift in [0.0, 0.5] {
            let kernel = Disguised { kernel: Logarithm::unit(), shift, even };
            let operator = SincOperator::new(&kernel, 80).unwrap();
            let values = operator.sample(f).unwrap();
            let ends = [f(shift - 1.0), f(shift + 1.0)];
            check_sweep(&operator, &values, ends, f, &parameters);
        }
    }
    let operator = SincOperator::with_breaks(&Layered, 50, &[0.0]).unwrap();
    let values = operator.sample(f64::abs).unwrap();
    check_sweep(&operator, &values, [1.0, 1.0], f64::abs, &parameters[..4]);
}

#[test]
fn fixed_points_agree_with_evaluation() {
    let operator = SincOperator::with_breaks(&Logarithm::unit(), 40, &[-0.2, 0.6]).unwrap();
    let solution = solve(&operator, 5.0, f64::abs);
    let mut points: Vec<f64> = grid_points(300).collect();
    points.extend([-1.0, 1.0, -0.2, 0.6, 0.0, -5.0, 7.0]);
    points.extend(operator.positions().step_by(7));
    let f: Vec<f64> = points.iter().map(|x| x.abs()).collect();
    let set = PointSet::new(&operator, &points).unwrap();
    let mut values = vec![0.0; set.count()];
    set.evaluate_into(&solution, &f, &mut values).unwrap();
    for ((x, f), value) in points.iter().zip(&f).zip(&values) {
        assert!((value - solution.evaluate(*x, *f)).abs() < 1e-14, "{x}");
    }
    let other = SincOperator::new(&Logarithm::unit(), 40).unwrap();
    assert!(set.evaluate_into(&solve(&other, 5.0, f64::abs), &f, &mut values).is_err());
    assert!(set.evaluate_into(&solution, &f[1..], &mut values).is_err());
    assert!(PointSet::new(&operator, &[0.0, f64::NAN]).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn reciprocity_linearity_and_reflection(
        decades in -3.0f64..4.0, a in -2.0f64..2.0, b in 0.1f64..5.0, exponent in 0.05f64..0.6, kind in 0..3,
    ) {
        let parameter = 10f64.powf(decades);
        let power = Power::new(Interval::unit(), exponent).unwrap();
        let kernel: &dyn Kernel = match kind { 0 => &Logarithm::unit(), 1 => &power, _ => &Layered };
        let operator = SincOperator::new(kernel, 60).unwrap();
        let (f, g) = (|x: f64| (a * x).exp(), |x: f64| (b * x).cos() + x);
        let (p, q) = (solve(&operator, parameter, f), solve(&operator, parameter, g));
        let (left, right) = (p.integral(g), q.integral(f));
        // phi = f - lambda K phi carries rounding of f, not of the much smaller phi.
        let tolerance = 1e-14 + 1e-12 * p.integral(f);
        prop_assert!((left - right).abs() < tolerance, "{left} {right}");
        prop_assert!(p.integral(f) > 0.0);
        let sum = solve(&operator, parameter, |x| f(x) + 2.0 * g(x));
        let mirrored = solve(&operator, parameter, |x| f(-x));
        for x in grid_points(37) {
            let combined = p.evaluate(x, f(x)) + 2.0 * q.evaluate(x, g(x));
            let tolerance = 1e-12 * (1.0 + f(x).abs() + g(x).abs());
            prop_assert!((sum.evaluate(x, f(x) + 2.0 * g(x)) - combined).abs() < tolerance);
            prop_assert!((mirrored.evaluate(-x, f(x)) - p.evaluate(x, f(x))).abs() < tolerance);
        }
    }
}
