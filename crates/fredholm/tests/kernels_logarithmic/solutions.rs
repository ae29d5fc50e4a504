//! Equations of the second kind, by collocation and by the degenerate kernel.

use fredholm::DegenerateSystem;
use fredholm::collocation::{solve_adaptive, solve_adaptive_with_breaks};
use fredholm::kernel::{
    Kernel, Logarithm, LogarithmRatio, LogarithmRatioLimit, LogarithmSine, LogarithmSquare,
    SpectralRelation,
};

use crate::kernels_logarithmic::reference::{
    SOLUTION, Worst, kernel, kernels_2_3, more, number, numbers, placed, ratio_of_one, sine_of_one,
    square, square_of_identity, square_of_one,
};

fn by_name(name: &str) -> fn(f64) -> f64 {
    match name {
        "1" => |_| 1.0,
        "x" => |x| x,
        "1+x" => |x| 1.0 + x,
        other => panic!("right-hand side {other}"),
    }
}

#[test]
fn collocation_gives_the_reference_solutions() {
    let data = kernels_2_3();
    let mut worst = Worst::default();
    let cases = data["solutions"].as_array().unwrap();
    assert_eq!(cases.len(), 12);
    for case in cases {
        let (kernel, f) = (kernel(case), by_name(case["f"].as_str().unwrap()));
        let found = solve_adaptive(&*kernel, number(&case["parameter"]), f, 1e-12).unwrap();
        assert!(found.converged, "{case}");
        let exact = numbers(&case["phi"]);
        let largest = exact.iter().fold(0.0, |most: f64, phi| most.max(phi.abs()));
        for (x, exact) in numbers(&case["x"]).into_iter().zip(exact) {
            worst.note((found.solution.evaluate(x, f(x)) - exact).abs() / largest);
        }
        let integral = found.solution.integral(|_| 1.0);
        worst.note((integral - number(&case["integral"])).abs() / largest);
    }
    worst.require("solutions", SOLUTION);
}

/// Solves for `f = phi + lambda potential(phi)`, and notes the difference from `phi`, over the whole interval.
fn manufactured(
    kernel: &dyn Kernel,
    parameter: f64,
    phi: impl Fn(f64) -> f64,
    potential: impl Fn(f64) -> f64,
    worst: &mut Worst,
) {
    let f = |x: f64| phi(x) + parameter * potential(x);
    // Rounding of the kernel may leave 2e-12 of the largest value.
    let found = solve_adaptive(kernel, parameter, f, 3e-12).unwrap();
    let (left, right) = (kernel.interval().left(), kernel.interval().right());
    let mut places = vec![left, right];
    for i in 1..60 {
        let share = 0.5f64.powi(i);
        places.extend([left + share * (right - left), right - share * (right - left)]);
    }
    places.extend((0..=100).map(|i| left + (right - left) * (f64::from(i) / 100.0)));
    let largest = phi(left).abs().max(phi(right).abs());
    let mut own = Worst::default();
    for x in places {
        let x = x.clamp(left, right);
        own.note((found.solution.evaluate(x, f(x)) - phi(x)).abs() / largest);
    }
    println!(
        "{:?} at {parameter}: {} nodes a side, converged: {}, estimate {:.1e}, error {:.1e}",
        kernel.interval(),
        found.half_count,
        found.converged,
        found.estimate.solution,
        own.0
    );
    assert!(found.converged, "{:?} {parameter}", kernel.interval());
    // Beside a corner at 0 or near the whole circle the error falls as exp(-c sqrt(N)), more slowly than the estimate assumes; and f itself
    // carries the rounding of its large terms.
    let allowed = (5.0 * found.estimate.solution / largest).max(1e-12);
    assert!(own.0 <= allowed, "the estimate is too small");
    worst.note(own.0);
}

#[test]
fn potentials_of_constants_agree_with_mpmath() {
    let mut worst = Worst::default();
    for case in kernels_2_3()["potentials"].as_array().unwrap() {
        for (x, exact) in placed(&case["potential_of_one"]) {
            let parameter = |name: &str| number(&case["params"][name]);
            let found = match case["kernel"].as_i64().unwrap() {
                2 => ratio_of_one(parameter("b"), parameter("a"), x),
                _ => sine_of_one(parameter("alpha"), x),
            };
            worst.note((found - number(exact)).abs());
        }
    }
    for case in more()["square"].as_array().unwrap() {
        let parameter = |name: &str| number(&case[name]);
        let (b, a, gauge) = (parameter("inner"), parameter("outer"), parameter("gauge"));
        for table in case["potentials"].as_array().unwrap() {
            let x = number(&table["x"]);
            worst.note((square_of_one(b, a, gauge, x) - number(&table["one"])).abs());
            worst.note((square_of_identity(b, a, gauge, x) - number(&table["identity"])).abs());
        }
    }
    worst.require("potentials", 1e-14);
}

#[test]
fn collocation_gives_manufactured_solutions() {
    let mut worst = Worst::default();
    for parameter in [0.2, 1.0, 30.0] {
        for (b, a) in [(0.25, 1.0), (1.0, 2.0), (1e-2, 1.0), (1e-6, 1.0), (1e-8, 1.0), (0.999, 1.0)]
        {
            let kernel = LogarithmRatio::new(b, a).unwrap();
            manufactured(&kernel, parameter, |_| 1.0, |x| ratio_of_one(b, a, x), &mut worst);
        }
        for a in [0.01, 1.0, 3.0] {
            let kernel = LogarithmRatioLimit::new(a).unwrap();
            manufactured(&kernel, parameter, |_| 1.0, |x| ratio_of_one(0.0, a, x), &mut worst);
        }
        for alpha in [0.3, 1.5, 2.8, 3.1, 3.14, 3.141592] {
            let kernel = LogarithmSine::new(alpha).unwrap();
            manufactured(&kernel, parameter, |_| 1.0, |x| sine_of_one(alpha, x), &mut worst);
        }
        for case in more()["square"].as_array().unwrap() {
            let kernel = square(case);
            let (b, a, gauge) = (kernel.inner(), kernel.outer(), number(&case["gauge"]));
            let one = |x: f64| square_of_one(b, a, gauge, x);
            manufactured(&kernel, parameter, |_| 1.0, one, &mut worst);
            let identity = |x: f64| square_of_identity(b, a, gauge, x);
            manufactured(&kernel, parameter, |x| x, identity, &mut worst);
        }
    }
    worst.require("manufactured", SOLUTION);
}

#[test]
fn halves_of_the_logarithm_make_the_whole() {
    // On (-a, a) an odd function sees the limit of kernel 2, an even one its companion.
    let (a, parameter) = (1.3, 2.0);
    let whole = Logarithm::new(a).unwrap();
    let (odd, even) = (LogarithmRatioLimit::new(a).unwrap(), LogarithmSquare::new(0.0, a).unwrap());
    let mut worst = Worst::default();
    for (f, kernel, sign) in [
        (f64::sin as fn(f64) -> f64, &odd as &dyn Kernel, -1.0),
        (|x: f64| 1.0 + x.abs(), &odd, -1.0),
        (f64::cos, &even, 1.0),
        (f64::exp, &even, 1.0),
    ] {
        let continued = |x: f64| if x < 0.0 { sign * f(-x) } else { f(x) };
        let exact =
            solve_adaptive_with_breaks(&whole, &[0.0], parameter, continued, 1e-13).unwrap();
        let found = solve_adaptive(kernel, parameter, f, 1e-12).unwrap();
        assert!(found.converged);
        for i in 0..=100 {
            let x = a * f64::from(i) / 100.0 + 1e-14;
            let x = x.min(a);
            let difference = found.solution.evaluate(x, f(x)) - exact.solution.evaluate(x, f(x));
            worst.note(difference.abs());
        }
    }
    worst.require("halves", SOLUTION);
}

#[test]
fn degenerate_kernel_converges_to_collocation() {
    // Ends with N^-2, inside N^-3.
    let relations: [Box<dyn Fn(usize) -> f64>; 4] = [
        Box::new(|n| degenerate_error(&LogarithmRatio::new(0.25, 1.0).unwrap(), n)),
        Box::new(|n| degenerate_error(&LogarithmRatioLimit::new(1.0).unwrap(), n)),
        Box::new(|n| degenerate_error(&LogarithmSine::new(1.5).unwrap(), n)),
        Box::new(|n| degenerate_error(&LogarithmSquare::new(0.25, 1.0).unwrap(), n)),
    ];
    for error in relations {
        let (coarse, fine) = (error(60), error(240));
        println!("{coarse:.1e} {fine:.1e}");
        assert!(fine < 1e-4 && (coarse / fine).log2() > 3.7 && (coarse / fine).log2() < 4.5);
    }
}

/// Largest error of the degenerate kernel at the ends for `f = exp`.
fn degenerate_error<K: SpectralRelation>(kernel: &K, degree: usize) -> f64 {
    let exact = solve_adaptive(kernel, 1.0, f64::exp, 1e-12).unwrap().solution;
    let system = DegenerateSystem::new(kernel, 1.0, degree).unwrap();
    let found = system.solve(&kernel.moments(&f64::exp, degree + 1).unwrap().values);
    let ends = [kernel.interval().left(), kernel.interval().right()];
    ends.into_iter()
        .map(|x| (found.evaluate(x, x.exp()) - exact.evaluate(x, x.exp())).abs())
        .fold(0.0, f64::max)
}
