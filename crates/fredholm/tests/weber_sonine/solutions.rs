//! Equations of the second and first kind.

use std::f64::consts::FRAC_2_PI;

use fredholm::collocation::{AdaptiveSolution, Place, solve_adaptive};
use fredholm::equation::{degenerate, first_kind};
use fredholm::kernel::{Kernel, SpectralRelation, WeberSonine};
use fredholm::{Error, SincOperator};
use serde_json::Value;

use super::{Worst, kernel, list, name, number, numbers, reference, solutions};

const TOLERANCE: f64 = 1e-11;

fn right_hand_side(case: &Value) -> impl Fn(f64) -> f64 {
    let power = number(&case["power"]);
    let coefficients = numbers(&case["coefficients"]);
    move |x: f64| {
        let sum = coefficients.iter().rev().fold(0.0, |sum, c| sum * x * x + c);
        if power == 0.0 { sum } else { sum * x.powf(power) }
    }
}

fn solve(
    kernel: &WeberSonine,
    parameter: f64,
    f: impl Fn(f64) -> f64,
) -> Result<AdaptiveSolution, Error> {
    let start = std::time::Instant::now();
    let found = solve_adaptive(kernel, parameter, f, TOLERANCE)?;
    println!(
        "mu {} gamma {} lambda {parameter}: {} a side, converged {}, estimate {:.1e}, {:.0} ms",
        kernel.order(),
        kernel.exponent(),
        found.half_count,
        found.converged,
        found.estimate.solution,
        1e3 * start.elapsed().as_secs_f64()
    );
    Ok(found)
}

#[test]
fn collocation_agrees_with_product_integration() {
    let mut worst = Worst::new("solutions of the second kind, of the largest value");
    let mut integrals = Worst::new("their integrals, relative");
    for case in list(&solutions()["solutions"]) {
        let kernel = kernel(case);
        let f = right_hand_side(case);
        let found = solve(&kernel, number(&case["parameter"]), &f).unwrap();
        assert!(found.converged, "{}", name(case));
        let (x, p) = (numbers(&case["x"]), numbers(&case["p"]));
        let largest = p.iter().fold(0.0, |most: f64, p| most.max(p.abs()));
        for (x, p) in x.iter().zip(&p) {
            let error = (found.solution.evaluate(*x, f(*x)) - p).abs() / largest;
            worst.add(error, || format!("{} x = {x}", name(case)));
        }
        let integral = number(&case["integral"]);
        let error = found.solution.integral(|x| kernel.mass_function(x)) / integral - 1.0;
        integrals.add(error.abs(), || name(case));
    }
    worst.require(1e-11);
    integrals.require(1e-11);
}

#[test]
fn the_degenerate_kernel_agrees_within_its_error() {
    for case in list(&solutions()["solutions"]) {
        let kernel = kernel(case);
        let f = right_hand_side(case);
        let found = degenerate(&kernel, number(&case["parameter"]), &f, 300).unwrap();
        for (x, p) in numbers(&case["x"]).into_iter().zip(numbers(&case["p"])) {
            let error = (found.evaluate(x) - p).abs();
            assert!(error <= found.error.solution, "{} {x}: {error:e} {:?}", name(case), found);
        }
        let error = (found.integral.unwrap() - number(&case["integral"])).abs();
        assert!(error <= found.error.integral + 1e-13, "{}: {error:e} {found:?}", name(case));
        println!("{}: integral {error:.1e}, stated {:.1e}", name(case), found.error.integral);
    }
}

/// `F(a, b; c; z)` from `z` and `1 - z`, by series at 0 or, for `c - a - b` apart from integers, at 1.
fn hypergeometric(a: f64, b: f64, c: f64, z: f64, rest: f64) -> f64 {
    let series = |a: f64, b: f64, c: f64, z: f64| {
        let (mut term, mut sum) = (1.0, 1.0);
        for k in (0..80).map(f64::from) {
            term *= (a + k) * (b + k) / ((c + k) * (k + 1.0)) * z;
            sum += term;
        }
        sum
    };
    if z < 0.5 {
        return series(a, b, c, z);
    }
    let (gamma, d) = (libm::tgamma, c - a - b);
    gamma(c) * gamma(d) / (gamma(c - a) * gamma(c - b)) * series(a, b, 1.0 - d, rest)
        + rest.powf(d) * gamma(c) * gamma(-d) / (gamma(a) * gamma(b))
            * series(c - a, c - b, 1.0 + d, rest)
}

/// `int_0^1 W(x, s) s^(mu+1) ds = x^mu 2^(2 gamma-1) Gamma(mu+gamma+1/2) / (Gamma(3/2-gamma) Gamma(mu+1)) F(mu+gamma+1/2, gamma-1/2; mu+1; x^2)`, the integral of Weber and
/// Schafheitlin (DLMF 10.22.56).
fn potential_of_power(mu: f64, gamma: f64, from_centre: f64, from_rim: f64) -> f64 {
    let (z, rest) = (from_centre * from_centre, from_rim * (1.0 + from_centre));
    let function = hypergeometric(mu + gamma + 0.5, gamma - 0.5, mu + 1.0, z, rest);
    let strength = libm::tgamma(mu + gamma + 0.5) / libm::tgamma(mu + 1.0);
    from_centre.powf(mu) * 4f64.powf(gamma) * 0.5 * strength / libm::tgamma(1.5 - gamma) * function
}

/// `int_0^1 W_0(x, s) s ds = (2/pi) E(x)` for `gamma = 0`, by the arithmetic-geometric mean.
fn potential_of_one(from_centre: f64, from_rim: f64) -> f64 {
    if from_rim == 0.0 {
        return FRAC_2_PI;
    }
    let mut complement = (from_rim * (1.0 + from_centre)).sqrt();
    let (mut a, mut sum, mut power) = (1.0, 0.5 * from_centre * from_centre, 0.5);
    for _ in 0..12 {
        let c = 0.5 * (a - complement);
        (a, complement) = (0.5 * (a + complement), (a * complement).sqrt());
        power *= 2.0;
        sum += power * c * c;
    }
    (1.0 - sum) / a
}

/// The solution `x^mu` of the equation made for it, by operators of given size.
fn manufactured(kernel: &WeberSonine, half_count: usize, worst: &mut Worst) {
    let (mu, gamma) = (kernel.order(), kernel.exponent());
    let operator = SincOperator::new(kernel, half_count).unwrap();
    let potential = |place: Place| {
        if (mu, gamma) == (0.0, 0.0) {
            potential_of_one(place.from_left, place.from_right)
        } else {
            potential_of_power(mu, gamma, place.from_left, place.from_right)
        }
    };
    for parameter in [0.5, 40.0] {
        let f = |place: Place| place.from_left.powf(mu) + parameter * potential(place);
        let values = operator.sample_places(f).unwrap();
        let solution = &operator.solve(parameter, &[values]).unwrap()[0];
        for i in 0..=200 {
            let x = f64::from(i) / 200.0;
            let place = Place { position: x, from_left: x, from_right: 1.0 - x, panel: 0 };
            let size =
                1.0 + parameter * potential(Place { from_left: 0.5, from_right: 0.5, ..place });
            let error = (solution.evaluate(x, f(place)) - x.powf(mu)).abs() / size;
            worst.add(error, || format!("mu {mu} gamma {gamma} lambda {parameter} x {x}"));
        }
    }
}

#[test]
fn powers_are_the_solutions_of_equations_made_for_them() {
    let mut worst = Worst::new("x^mu recovered");
    for (mu, gamma, half_count) in [
        (0.0, 0.0, 60),
        (0.0, 0.2, 110),
        (0.0, -0.3, 60),
        (0.0, 0.35, 220),
        (0.0, 0.45, 600),
        (0.5, 0.2, 130),
        (0.5, -0.3, 90),
        (1.0, -0.2, 90),
        (1.0, 0.3, 220),
        (2.0, 0.1, 130),
        (2.5, -0.1, 130),
        (5.0, 0.2, 220),
        (5.0, -0.4, 200),
    ] {
        manufactured(&WeberSonine::new(1.0, mu, gamma).unwrap(), half_count, &mut worst);
    }
    worst.require(1e-11);
}

/// `e_n = sqrt(2 (mu+2n+1)) x^mu P_n^(mu,0)(1-2x^2)`, by the finite sum (DLMF 18.5.7).
fn zernike(mu: f64, n: usize, x: f64) -> f64 {
    let order = n as f64;
    let (mut term, mut k) = (1.0, 0.0);
    (0..n).for_each(|j| term *= (mu + 1.0 + j as f64) / (1.0 + j as f64));
    let mut sum = 0.0;
    while k <= order {
        sum += term;
        term *= -(order - k) * (order + mu + 1.0 + k) / ((mu + 1.0 + k) * (k + 1.0)) * x * x;
        k += 1.0;
    }
    (2.0 * (mu + 2.0 * order + 1.0)).sqrt() * x.powf(mu) * sum
}

#[test]
fn collocation_gives_the_matrix_in_the_basis_of_zernike() {
    let mut worst = Worst::new("matrix of the operator in the basis of Zernike");
    for case in list(&reference()["kernels"]) {
        let (mu, gamma) = (number(&case["order"]), number(&case["exponent"]));
        // Beyond, distances to the ends underflow before their powers matter no more.
        if gamma > 0.45 {
            continue;
        }
        let kernel = WeberSonine::new(1.0, mu, gamma).unwrap();
        let operator = SincOperator::new(&kernel, 160).unwrap();
        let rows: Vec<Vec<f64>> = list(&case["zernike"]).iter().map(numbers).collect();
        for n in 0..rows.len() {
            let e = operator.sample(|x| zernike(mu, n, x)).unwrap();
            let potential = operator.solve(0.0, &[e]).unwrap()[0].potential().to_vec();
            let applied = &operator.solve(0.0, &[potential]).unwrap()[0];
            for (k, row) in rows.iter().enumerate() {
                let found = applied.integral(|x| zernike(mu, k, x));
                worst
                    .add((found - row[n]).abs() / rows[0][0], || format!("{} {k} {n}", name(case)));
            }
        }
    }
    worst.require(1e-12);
}

#[test]
fn the_first_kind_has_closed_forms() {
    // W_0 w = pi/2: the flat punch; and any phi_n: the solution over its weight is phi_n/lambda_n.
    let flat = WeberSonine::new(1.0, 0.0, 0.0).unwrap();
    let found = first_kind(&flat, &|_| 1.0, 40).unwrap();
    for x in [0.0f64, 0.4, 0.9] {
        let exact = FRAC_2_PI / (1.0 - x * x).sqrt();
        assert!((found.evaluate(x) / exact - 1.0).abs() < 1e-12, "{} {exact}", found.evaluate(x));
    }
    assert!((found.integral.unwrap() - FRAC_2_PI).abs() < 1e-14);
    let mut worst = Worst::new("first kind");
    for case in list(&reference()["kernels"]) {
        let kernel = kernel(case);
        for n in [0, 1, 4, 9] {
            let mut phi = vec![0.0; n + 1];
            phi[n] = 1.0;
            let f = |x: f64| kernel.sum(&phi, x);
            let found = first_kind(&kernel, &f, 60).unwrap();
            let largest = (found.largest * kernel.eigenvalue(n)).abs();
            for share in [0.05, 0.3, 0.55, 0.8, 0.95] {
                let x = share * kernel.radius();
                let over_weight = found.evaluate(x) / kernel.weight(n, x);
                let error = (over_weight - f(x) / kernel.eigenvalue(n)).abs();
                assert!(error <= found.error.solution, "{} {n}: {error:e} {found:?}", name(case));
                // Towards -1/2 eigenvalues differ by 1e6 within twenty, and so do the errors of coefficients.
                if kernel.exponent() > -0.3 {
                    let error = error * kernel.eigenvalue(n) / largest;
                    worst.add(error, || format!("{} {n}", name(case)));
                }
            }
        }
    }
    worst.require(1e-12);
}
