//! The Macdonald kernel on the half-line against mpmath: `data/macdonald_half_line.json` says how.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use fredholm::collocation::{HalfLineSolution, solve_half_line};
use fredholm::kernel::{Kernel, MacdonaldHalfLine, SpectralRelation};
use fredholm::{DegenerateSystem, Error};
use serde_json::Value;

fn reference(part: &str) -> Vec<Value> {
    let text = include_str!("data/macdonald_half_line.json");
    let data: Value = serde_json::from_str(text).unwrap();
    data[part].as_array().unwrap().clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().unwrap().parse().unwrap())
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn relation(case: &Value) -> MacdonaldHalfLine {
    let params = &case["params"];
    MacdonaldHalfLine::new(number(&params["mu"]), number(&params["kappa"])).unwrap()
}

/// An equation of the second kind with its exact solution.
struct Equation {
    kernel: MacdonaldHalfLine,
    parameter: f64,
    beta: f64,
    frequency: f64,
    points: Vec<[f64; 2]>,
    integral: Option<f64>,
}

impl Equation {
    fn all() -> Vec<Self> {
        let given = reference("solutions").into_iter().map(|case| {
            let beta = case["f"].as_str().unwrap().split([' ', '-']).nth(1).unwrap().to_owned();
            Self {
                kernel: relation(&case),
                parameter: number(&case["lam"]),
                beta: beta.parse().unwrap(),
                frequency: 0.0,
                points: points(&case),
                integral: case.get("integral_phi").map(number),
            }
        });
        let more = reference("more_solutions").into_iter().map(|case| Self {
            kernel: MacdonaldHalfLine::new(number(&case["mu"]), number(&case["kappa"])).unwrap(),
            parameter: number(&case["parameter"]),
            beta: number(&case["beta"]),
            frequency: case.get("frequency").map_or(0.0, number),
            points: points(&case),
            integral: case
                .get("integral")
                .and_then(|v| if v.is_null() { None } else { Some(number(v)) }),
        });
        given.chain(more).collect()
    }

    fn f(&self, x: f64) -> f64 {
        (-self.beta * x).exp() * (self.frequency * x).cos()
    }

    fn name(&self) -> String {
        let (mu, kappa) = (self.kernel.order(), self.kernel.decay());
        let Self { parameter, beta, frequency, .. } = self;
        format!("mu {mu}, kappa {kappa}, lambda {parameter}, beta {beta} +- {frequency} i")
    }

    fn solve(&self, tolerance: f64) -> HalfLineSolution {
        let end = self.points.iter().fold(0.0, |most: f64, [x, _]| most.max(*x));
        solve_half_line(&self.kernel, self.parameter, |x| self.f(x), end, tolerance).unwrap()
    }

    /// The largest value and the largest error.
    fn error(&self, evaluate: impl Fn(f64, f64) -> f64) -> [f64; 2] {
        self.points.iter().fold([0.0f64; 2], |[largest, error], [x, exact]| {
            [largest.max(exact.abs()), error.max((evaluate(*x, self.f(*x)) - exact).abs())]
        })
    }
}

fn points(case: &Value) -> Vec<[f64; 2]> {
    numbers(&case["x"]).into_iter().zip(numbers(&case["phi"])).map(|(x, phi)| [x, phi]).collect()
}

#[test]
fn the_relation_agrees_with_mpmath() {
    let mut worst = [0.0f64; 4];
    for case in reference("relations") {
        let kernel = relation(&case);
        let largest = kernel.eigenvalue(0).abs();
        for (n, exact) in case["lam"].as_object().unwrap() {
            let found = kernel.eigenvalue(n.parse().unwrap());
            worst[0] = worst[0].max((found - number(exact)).abs() / largest);
        }
        for (n, exact) in case["h"].as_object().unwrap() {
            let found = kernel.norm(n.parse().unwrap());
            worst[1] = worst[1].max((found / number(exact) - 1.0).abs());
        }
        let factor = number(&case["lam_over_h"]);
        assert!((kernel.expansion_factor(7) / factor - 1.0).abs() < 1e-15 * 4.0);
        for (x, row) in case["phi"].as_object().unwrap() {
            let x: f64 = x.parse().unwrap();
            let mut values = [0.0; 21];
            kernel.eigenfunctions(x, &mut values);
            for (n, exact) in row.as_object().unwrap() {
                let n: usize = n.parse().unwrap();
                let mut unit = [0.0; 21];
                unit[n] = 1.0;
                for found in [values[n], kernel.sum(&unit, x)] {
                    worst[2] = worst[2].max((found - number(exact)).abs());
                }
            }
        }
        let gram = kernel.gram(40).unwrap();
        for (indices, exact) in case["R"].as_object().unwrap() {
            let (k, m) = indices.split_once(',').unwrap();
            let (k, m): (usize, usize) = (k.parse().unwrap(), m.parse().unwrap());
            let scale = (gram.entry(k, k) * gram.entry(m, m)).sqrt();
            for found in [gram.entry(k, m), gram.entry(m, k)] {
                worst[3] = worst[3].max((found - number(exact)).abs() / scale);
            }
        }
    }
    assert!(worst.iter().all(|error| *error < 1e-14), "{worst:?}");
}

#[test]
fn solutions_agree_with_wiener_and_hopf() {
    for equation in Equation::all() {
        for tolerance in [1e-9, 1e-12] {
            let solution = equation.solve(tolerance);
            let [largest, error] = equation.error(|x, f| solution.evaluate(x, f));
            let estimate = solution.estimate();
            let relative = match (equation.integral, solution.integral()) {
                (Some(exact), Some(found)) => {
                    let error = (found - exact).abs();
                    assert!(error <= estimate.integral, "{}: {error:e}", equation.name());
                    error / exact.abs()
                }
                (None, None) => 0.0,
                other => panic!("{}: {other:?}", equation.name()),
            };
            assert!(solution.converged(), "{}", equation.name());
            assert!(error < tolerance * largest, "{}: {error:e}", equation.name());
            assert!(error <= estimate.solution, "{}: {error:e}", equation.name());
            assert!(relative < tolerance.min(1e-10), "{}: {relative:e}", equation.name());
        }
    }
}

#[test]
fn the_degenerate_kernel_errs_as_expected() {
    let mut count = 0;
    for (case, equation) in reference("solutions").iter().zip(Equation::all()) {
        let Some(errors) = case["degenerate_kernel_error"].as_object() else { continue };
        for terms in errors.keys() {
            let degree = terms.parse::<usize>().unwrap() - 1;
            let system =
                DegenerateSystem::new(&equation.kernel, equation.parameter, degree).unwrap();
            let moments = equation.kernel.moments(&|x| equation.f(x), degree + 1).unwrap();
            assert!(moments.resolved);
            let solution = system.solve(&moments.values);
            let error = |inside: bool| {
                (equation.points.iter().filter(|[x, _]| (*x > 0.0) == inside))
                    .map(|[x, exact]| (solution.evaluate(*x, equation.f(*x)) - exact).abs())
                    .fold(0.0, f64::max)
            };
            for (found, expected) in [(error(true), "interior"), (error(false), "endpoint0")] {
                let expected = number(&errors[terms][expected]);
                // Two digits are given.
                let agree = (found / expected - 1.0).abs() < 0.06;
                assert!(agree, "{}, {terms} terms: {found} {expected}", equation.name());
                count += 1;
            }
        }
    }
    assert_eq!(count, 42);
}

/// `(a)_j/j!`.
fn binomial(a: f64, j: usize) -> f64 {
    (0..j).fold(1.0, |value, i| value * (a + i as f64) / (i as f64 + 1.0))
}

#[test]
fn moments_of_exponentials_have_a_closed_form() {
    for (order, decay, beta) in
        [(0.0, 1.0, 0.5), (0.3, 2.0, 0.0), (-0.4, 0.5, 3.0), (0.45, 1.0, 1.0), (0.1, 1e-3, 2e-4)]
    {
        let kernel = MacdonaldHalfLine::new(order, decay).unwrap();
        let count = 400;
        let moments = kernel.moments(&|x| (-beta * x).exp(), count).unwrap();
        assert!(moments.resolved);
        // f_k = sum_j A_kj (beta - kappa)^j/(beta + kappa)^(j+1)
        let ratio: f64 = (beta - decay) / (beta + decay);
        let column: Vec<f64> = (0..count).map(|j| binomial(order - 0.5, j)).collect();
        for (k, found) in moments.values.iter().enumerate() {
            let exact: f64 =
                (0..=k).map(|j| column[k - j] * ratio.powi(j as i32)).sum::<f64>() / (beta + decay);
            let error = (found - exact).abs() * decay;
            assert!(error < 1e-13, "{order} {decay} {beta}, {k}: {found} {exact}");
        }
    }
}

#[test]
fn moments_resolve_what_oscillates_and_jumps() {
    let kernel = MacdonaldHalfLine::new(0.0, 1.0).unwrap();
    // int e^(-x) cos(w x) dx = Re 1/(1 - i w)
    let moments = kernel.moments(&|x| (40.0 * x).cos(), 8).unwrap();
    assert!(moments.resolved && (moments.values[0] - 1.0 / 1601.0).abs() < 1e-14);
    let jump = kernel.moments(&|x| if x < 1.0 { 1.0 } else { 0.0 }, 4).unwrap();
    assert!((jump.values[0] - (1.0 - (-1f64).exp())).abs() < 1e-12);
    // Once more with the expansion: the moments of a resolved function are R c.
    let f = |x: f64| (-0.8 * x).exp() * (1.0 + x);
    let expansion = kernel.expand(&f).unwrap();
    let (gram, moments) = (kernel.gram(200).unwrap(), kernel.moments(&f, 30).unwrap());
    assert!(expansion.resolved);
    for (k, found) in moments.values.iter().enumerate() {
        let coefficients = expansion.coefficients.iter().enumerate();
        let exact: f64 = coefficients.map(|(n, c)| c * gram.entry(k, n)).sum();
        assert!((found - exact).abs() < 1e-13, "{k}: {found} {exact}");
    }
    // A constant has no convergent expansion.
    assert!(!kernel.expand(&|_| 1.0).unwrap().resolved);
    let error = kernel.moments(&|x| 1.0 / (x - x), 3).unwrap_err();
    assert!(matches!(error, Error::NotFinite { .. }));
}

/// Distances to both ends and weights on `(0, 1)`, down to `1e-250`.
fn double_exponential() -> impl Iterator<Item = [f64; 3]> {
    (-320..=320).map(|j| {
        let (step, t) = (1.0 / 61.0, f64::from(j) / 61.0);
        let argument = std::f64::consts::PI * t.sinh();
        let (left, right) = (1.0 / (1.0 + (-argument).exp()), 1.0 / (1.0 + argument.exp()));
        [left, right, step * std::f64::consts::PI * t.cosh() * left * right]
    })
}

#[test]
fn the_kernel_and_its_relation_agree_by_quadrature() {
    for (order, decay, x) in [(0.3, 2.0, 0.4), (0.0, 0.7, 3.0), (-0.35, 1.0, 0.05)] {
        let kernel = MacdonaldHalfLine::new(order, decay).unwrap();
        for n in [0, 1, 6] {
            let density = |s: f64, d: f64| {
                let mut values = vec![0.0; n + 1];
                kernel.eigenfunctions(s, &mut values);
                kernel.pair(x, s, d).value * values[n] * s.powf(order - 0.5)
            };
            let mut sum = 0.0;
            for [left, right, weight] in double_exponential() {
                sum += x * weight * density(x * left, x * right);
                let d = 28.0 / decay * left;
                sum += 28.0 / decay * weight * density(x + d, d);
            }
            let mut values = vec![0.0; n + 1];
            kernel.eigenfunctions(x, &mut values);
            let exact = kernel.eigenvalue(n) * values[n];
            let error = (sum - exact).abs() / kernel.eigenvalue(0);
            assert!(error < 1e-12, "{order} {decay} {n}: {sum} {exact}, {error:e}");
        }
    }
}

#[test]
fn the_equation_of_the_first_kind_has_closed_forms() {
    for (order, decay, beta) in [(0.0, 1.0, 0.5), (0.3, 2.0, 3.0), (-0.4, 0.5, 0.3)] {
        let kernel = MacdonaldHalfLine::new(order, decay).unwrap();
        let expansion = kernel.expand(&|x| (-beta * x).exp()).unwrap();
        assert!(expansion.resolved && expansion.error < 1e-13, "{}", expansion.error);
        let coefficients: Vec<f64> = (expansion.coefficients.iter().enumerate())
            .map(|(n, c)| c / kernel.eigenvalue(n))
            .collect();
        // Wiener and Hopf: p = (kappa+beta)^delta/(G Gamma(1-delta)) e^(-kappa x) x^-delta 1F1(1; 1-delta; (kappa-beta) x),
        // G = sqrt(pi) (2 kappa)^-mu Gamma(delta), delta = 1/2 - mu.
        let delta = 0.5 - order;
        let g = std::f64::consts::PI.sqrt() * (2.0 * decay).powf(-order) * gamma(delta);
        let scale = (decay + beta).powf(delta) / (g * gamma(1.0 - delta));
        for x in [0.0, 0.1 / decay, 1.0 / decay, 4.0 / decay] {
            let z = (decay - beta) * x;
            let mut term = 1.0;
            let mut sum = 1.0;
            for k in 0..200 {
                term *= z / (1.0 - delta + f64::from(k));
                sum += term;
            }
            let exact = scale * (-decay * x).exp() * sum;
            let found = kernel.sum(&coefficients, x);
            assert!((found - exact).abs() < 1e-12 * scale, "{order} {x}: {found} {exact}");
        }
        // f = phi_n gives one term.
        let f = |x: f64| {
            let mut values = [0.0; 10];
            kernel.eigenfunctions(x, &mut values);
            values[9]
        };
        let expansion = kernel.expand(&f).unwrap();
        assert!(expansion.resolved);
        for (n, c) in expansion.coefficients.iter().enumerate() {
            let exact = f64::from(u8::from(n == 9));
            let share = (kernel.norm(n) / kernel.norm(9)).sqrt();
            assert!((c - exact).abs() * share < 1e-13, "{order} {n}: {c}");
        }
    }
}

/// Gamma by its product formula of Lanczos would be a second library; the reflection formula and a recurrence bring the argument to where Stirling's series
/// holds.
fn gamma(x: f64) -> f64 {
    let shifted = x + 20.0;
    let series = 1.0 / (12.0 * shifted) - 1.0 / (360.0 * shifted.powi(3))
        + 1.0 / (1260.0 * shifted.powi(5))
        - 1.0 / (1680.0 * shifted.powi(7));
    let logarithm =
        (shifted - 0.5) * shifted.ln() - shifted + 0.5 * (2.0 * std::f64::consts::PI).ln() + series;
    let product: f64 = (0..20).map(|k| x + f64::from(k)).product();
    logarithm.exp() / product
}

#[test]
fn constants_tend_to_their_far_value() {
    let kernel = MacdonaldHalfLine::new(0.2, 3.0).unwrap();
    let far = 1.0 / (1.0 + 2.0 * kernel.symbol_at_zero());
    let solution = solve_half_line(&kernel, 2.0, |_| 1.0, 20.0, 1e-11).unwrap();
    assert!((solution.evaluate(20.0, 1.0) - far).abs() < 1e-13);
    assert_eq!(solution.integral(), None);
    assert_eq!(solution.estimate().integral, f64::INFINITY);
    // phi(0) = 1/M_+(0) = (1 + lambda G^(0))^(-1/2)
    assert!((solution.evaluate(0.0, 1.0) - far.sqrt()).abs() < 1e-12);
}

#[test]
fn growing_right_hand_sides_are_estimated_honestly() {
    // f = e^(x/2): the closed form with beta = -1/2 has M_+(-1/2) = M(1/2)/M_+(1/2); phi(0) = M_+(1/2)/M(1/2).
    let kernel = MacdonaldHalfLine::new(0.0, 1.0).unwrap();
    let f = |x: f64| (0.5 * x).exp();
    let grown = solve_half_line(&kernel, 0.5, f, 3.0, 1e-10).unwrap();
    let decayed = solve_half_line(&kernel, 0.5, |x| 1.0 / f(x), 3.0, 1e-10).unwrap();
    let symbol = 1.0 + 0.5 * std::f64::consts::PI / 0.75f64.sqrt();
    let exact = 1.0 / (decayed.evaluate(0.0, 1.0) * symbol);
    let error = (grown.evaluate(0.0, 1.0) - exact).abs();
    assert!(error < grown.estimate().solution && error < 1e-8, "{error:e}");
    assert_eq!(grown.integral(), None);
}

#[test]
fn refusals_say_why() {
    for (order, decay) in [
        (0.5, 1.0),
        (-0.5, 1.0),
        (f64::NAN, 1.0),
        (0.0, 0.0),
        (0.0, -1.0),
        (0.0, 1e60),
        (0.0, f64::NAN),
    ] {
        let error = MacdonaldHalfLine::new(order, decay).unwrap_err();
        assert!(matches!(error, Error::InvalidParameter { .. }), "{order} {decay}");
    }
    let kernel = MacdonaldHalfLine::new(0.0, 1.0).unwrap();
    let solve = |parameter: f64, x_max: f64, tolerance: f64| {
        solve_half_line(&kernel, parameter, |x| (-x).exp(), x_max, tolerance)
    };
    for parameter in [-0.4, -1.0, -1e300] {
        let error = solve(parameter, 1.0, 1e-9).unwrap_err();
        assert!(matches!(error, Error::InSpectrum { .. }), "{error}");
        assert!(error.to_string().contains("-0.318309886"), "{error}");
    }
    for (parameter, x_max, tolerance) in [
        (f64::NAN, 1.0, 1e-9),
        (f64::INFINITY, 1.0, 1e-9),
        (1.0, -1.0, 1e-9),
        (1.0, f64::NAN, 1e-9),
        (1.0, f64::INFINITY, 1e-9),
        (1.0, 1.0, 0.0),
        (1.0, 1.0, f64::NAN),
    ] {
        let error = solve(parameter, x_max, tolerance).unwrap_err();
        assert!(matches!(error, Error::InvalidParameter { .. }), "{parameter} {x_max}: {error}");
    }
    for (parameter, x_max) in [(1.0, 1e9), (-0.99999999999 / std::f64::consts::PI, 1.0)] {
        let error = solve(parameter, x_max, 1e-9).unwrap_err();
        assert!(matches!(error, Error::BeyondMethod { value, .. } if value > 30_000.0), "{error}");
    }
    let error = solve_half_line(&kernel, 1.0, |_| f64::NAN, 1.0, 1e-9).unwrap_err();
    assert!(matches!(error, Error::NotFinite { .. }));
    let solution = solve(1.0, 1.0, 1e-9).unwrap();
    assert!(solution.evaluate(1.5, 0.0).is_nan() && solution.evaluate(-1.0, 0.0).is_nan());
    let end = solve(1.0, 0.0, 1e-9).unwrap();
    assert!((end.evaluate(0.0, 1.0) - solution.evaluate(0.0, 1.0)).abs() < 1e-12);
    // Nothing at all.
    let zero = solve_half_line(&kernel, 1.0, |_| 0.0, 1.0, 1e-9).unwrap();
    assert!(zero.converged() && zero.evaluate(0.5, 0.0) == 0.0);
    assert_eq!(zero.integral(), Some(0.0));
}

#[test]
fn extremes_give_numbers_or_refusals() {
    for (order, decay) in [(0.4999, 1.0), (-0.4999, 1.0), (0.0, 1e50), (0.3, 1e-50), (-0.3, 1e50)] {
        let kernel = MacdonaldHalfLine::new(order, decay).unwrap();
        let mut values = vec![0.0; 500];
        for x in [0.0, 1e-300, 1.0 / decay, 800.0 / decay, 1e308, f64::INFINITY] {
            kernel.eigenfunctions(x, &mut values);
            assert!(values.iter().all(|value| value.abs() < 1.1), "{order} {decay} {x}");
        }
        for n in [0, 1, 1000, 1 << 40] {
            assert!(kernel.eigenvalue(n) > 0.0 && kernel.eigenvalue(n).is_finite());
            assert!(kernel.norm(n) > 0.0 && kernel.mass(n).is_finite());
        }
    }
}

#[test]
fn the_unit_of_length_does_not_matter() {
    let solve = |order: f64, decay: f64, strength: f64| {
        let kernel = MacdonaldHalfLine::new(order, decay)?;
        let f = |x: f64| 1.0 / (1.0 + decay * decay * x * x);
        let parameter = strength / kernel.symbol_at_zero();
        let solution = solve_half_line(&kernel, parameter, f, 1.0 / decay, 1e-9)?;
        assert!(solution.converged(), "{order} {decay} {strength}");
        let x = 0.5 / decay;
        Ok::<_, Error>([solution.evaluate(x, f(x)), solution.integral().unwrap() * decay])
    };
    for order in [0.3, 0.0, -0.4999] {
        for strength in [1e-300, 1e-3, 1.0, 1e5, -0.5] {
            let unit = solve(order, 1.0, strength).unwrap();
            for decay in [1e-50, 1e50, 0.3] {
                let found = solve(order, decay, strength).unwrap();
                for (found, unit) in found.iter().zip(unit) {
                    let error = (found / unit - 1.0).abs();
                    assert!(error < 1e-9, "{order} {decay} {strength}: {found} {unit}");
                }
            }
        }
    }
    let error = solve(0.4999, 1.0, 1.0).unwrap_err();
    assert!(matches!(error, Error::InvalidParameter { name: "order", .. }));
}

/// Far from 0 the solution for 1 is that of a convolution over the whole line, `1/(1 + lambda int K)`; orders near 0.48 leave the end value so slowly that the first nodes lie at the smallest numbers.
#[test]
fn orders_up_to_the_largest_are_solved() {
    let many = (0..40).map(f64::from);
    let many = many.map(|k| (0.44 + 0.001 * k, 1.3 + 0.037 * k, 0.2 + 0.013 * k));
    for (order, decay, parameter) in many.chain([(0.4709, 2.039, 0.3081)]) {
        let kernel = MacdonaldHalfLine::new(order, decay).unwrap();
        let reach = 60.0 / kernel.decay();
        let solution = solve_half_line(&kernel, parameter, |_| 1.0, reach, 1e-9).unwrap();
        let far = 1.0 / (1.0 + parameter * kernel.symbol_at_zero());
        let off = (solution.evaluate(reach, 1.0) - far).abs();
        assert!(off <= solution.estimate().solution, "{order}: {off:e}");
    }
}

/// The place that was asked for is inside, however the product with the decay is rounded.
#[test]
fn the_solution_is_known_where_it_was_asked_for() {
    for k in 0..200 {
        let kernel = MacdonaldHalfLine::new(0.1779, 1.851 + 0.001 * f64::from(k)).unwrap();
        let reach = 12.918_545_904_399_247 + 0.01 * f64::from(k);
        let solution = solve_half_line(&kernel, 0.1759, |x| x * (-x).exp(), reach, 1e-6).unwrap();
        assert_eq!(solution.end(), reach);
        let f = reach * (-reach).exp();
        assert!(solution.evaluate(reach, f).is_finite(), "{k}");
        assert!(solution.evaluate(reach.next_up(), f).is_nan(), "{k}");
    }
}
