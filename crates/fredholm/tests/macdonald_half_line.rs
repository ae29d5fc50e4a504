//! The Macdonald kernel on the half-line against mpmath: `data/macdonald_half_line.json` says how.

use fredholm::collocation::{HalfLineSolution, solve_half_line};
use fredholm::kernel::{Gram, Kernel, MacdonaldHalfLine, SpectralRelation};
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
    println!("eigenvalues, norms, functions, Gram matrix: {worst:?}");
    assert!(worst.iter().all(|error| *error < 1e-14), "{worst:?}");
}

#[test]
fn solutions_agree_with_wiener_and_hopf() {
    for equation in Equation::all() {
        let started = std::time::Instant::now();
        let solution = equation.solve(1e-12);
        let elapsed = started.elapsed();
        let [largest, error] = equation.error(|x, f| solution.evaluate(x, f));
        for [x, exact] in &equation.points {
            print!("{x}: {:.1e}  ", solution.evaluate(*x, equation.f(*x)) - exact);
        }
        println!();
        let integral = match (equation.integral, solution.integral()) {
            (Some(exact), Some(found)) => (found / exact - 1.0).abs(),
            (None, None) => 0.0,
            other => panic!("{}: {other:?}", equation.name()),
        };
        let estimate = solution.estimate();
        println!(
            "{}: {:e} (estimate {:e} = {:e}, {:e}), integral {integral:e} ({:e}), {} nodes, {elapsed:?}",
            equation.name(),
            error / largest,
            estimate.solution / largest,
            estimate.nodes / largest,
            estimate.section / largest,
            estimate.integral / equation.integral.unwrap_or(1.0),
            solution.node_count(),
        );
    }
}

#[test]
fn the_degenerate_kernel_errs_as_expected() {
    for (case, equation) in reference("solutions").iter().zip(Equation::all()) {
        let Some(errors) = case["degenerate_kernel_error"].as_object() else { continue };
        for (terms, expected) in errors {
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
            let found = [error(true), error(false)];
            let expected = [number(&expected["interior"]), number(&expected["endpoint0"])];
            println!("{}, {terms} terms: {found:?} {expected:?}", equation.name());
        }
    }
}
