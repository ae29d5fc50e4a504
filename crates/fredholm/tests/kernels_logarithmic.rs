//! Kernels 2 and 3, the limit of kernel 2 and its companion: relations and solutions against mpmath and against each other.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use std::f64::consts::PI;

use fredholm::collocation::{solve_adaptive, solve_adaptive_with_breaks};
use fredholm::kernel::{
    Kernel, Logarithm, LogarithmRatio, LogarithmRatioLimit, LogarithmSine, LogarithmSquare,
    SpectralRelation,
};
use fredholm::quadrature::double_exponential;
use fredholm::{DegenerateSystem, Error};
use serde_json::Value;

/// Tolerance of everything that double precision can hold.
const EXACT: f64 = 1e-13;
/// Tolerance of solutions of the second kind, of their largest value.
const SOLUTION: f64 = 1e-11;

fn read(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// Relations, solutions and integrals of kernels 2 and 3; origin in the file.
fn kernels_2_3() -> Value {
    read(include_str!("data/kernels_2_3.json"))
}

/// The companion of kernel 2, and Gram integrals of kernels 2 and 3 in long ranges; origin in the file.
fn more() -> Value {
    read(include_str!("data/logarithmic_kernels.json"))
}

fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().unwrap(),
        value => value.as_f64().unwrap(),
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

/// Pairs of an index and a value.
fn indexed(value: &Value) -> Vec<(usize, f64)> {
    let pairs = value.as_object().unwrap().iter();
    pairs.map(|(key, value)| (key.parse().unwrap(), number(value))).collect()
}

/// Pairs of a place and a value.
fn placed(value: &Value) -> Vec<(f64, &Value)> {
    value.as_object().unwrap().iter().map(|(key, value)| (key.parse().unwrap(), value)).collect()
}

fn kernel(case: &Value) -> Box<dyn SpectralRelation> {
    let parameter = |name: &str| number(&case["params"][name]);
    match case["kernel"].as_i64().unwrap() {
        2 => Box::new(LogarithmRatio::new(parameter("b"), parameter("a")).unwrap()),
        3 => Box::new(LogarithmSine::new(parameter("alpha")).unwrap()),
        other => panic!("kernel {other}"),
    }
}

fn square(case: &Value) -> LogarithmSquare {
    let parameter = |name: &str| number(&case[name]);
    LogarithmSquare::with_gauge(parameter("inner"), parameter("outer"), parameter("gauge")).unwrap()
}

/// The largest of what it is given.
#[derive(Default)]
struct Worst(f64);

impl Worst {
    fn note(&mut self, error: f64) {
        assert!(!error.is_nan());
        self.0 = self.0.max(error);
    }

    fn require(self, what: &str, tolerance: f64) {
        println!("{what}: {:.1e}", self.0);
        assert!(self.0 < tolerance, "{what}: {:e}", self.0);
    }
}

fn check_gram(relation: &dyn SpectralRelation, table: &Value, worst: &mut Worst) {
    let gram = relation.gram(64).unwrap();
    for (key, exact) in table.as_object().unwrap() {
        let (k, m) = key.split_once(',').unwrap();
        let (k, m): (usize, usize) = (k.parse().unwrap(), m.parse().unwrap());
        let scale = (gram.entry(k, k) * gram.entry(m, m)).sqrt();
        worst.note((gram.entry(k, m) - number(exact)).abs() / scale);
    }
}

#[test]
fn relations_of_kernels_2_and_3_agree_with_mpmath() {
    let data = kernels_2_3();
    let [mut eigenvalues, mut norms, mut factors, mut functions, mut gram]: [Worst; 5] =
        Default::default();
    let cases = data["relations"].as_array().unwrap();
    assert_eq!(cases.len(), 9);
    for case in cases {
        let relation = kernel(case);
        let largest = relation.eigenvalue(0).max(relation.eigenvalue(1));
        for (n, exact) in indexed(&case["lam"]) {
            eigenvalues.note((relation.eigenvalue(n) - exact).abs() / largest);
        }
        for (n, exact) in indexed(&case["h"]) {
            norms.note((relation.norm(n) / exact - 1.0).abs());
        }
        for (n, exact) in indexed(&case["lam_over_h"]) {
            factors.note((relation.expansion_factor(n) / exact - 1.0).abs());
        }
        for (x, table) in placed(&case["phi"]) {
            let mut values = vec![0.0; 32];
            relation.eigenfunctions(x, &mut values);
            for (n, exact) in indexed(table) {
                // The places are decimals: their rounding counts where x is a small part of b - a.
                let interval = relation.interval();
                let steep = f64::EPSILON * (n * n) as f64 * x.abs() / interval.half_length();
                functions.note(((values[n] - exact).abs() - steep).max(0.0));
                let mut unit = vec![0.0; n + 1];
                unit[n] = 1.0;
                functions.note((relation.sum(&unit, x) - values[n]).abs());
            }
        }
        check_gram(&*relation, &case["R"], &mut gram);
        // c_j, e_j, o_j by the entries they make up.
        let entries = relation.gram(64).unwrap();
        for (name, first, step) in [("c", 0, 1), ("e", 0, 2), ("o", 1, 2)] {
            let Some(table) = case.get(name) else { continue };
            let table = indexed(table);
            let at = |j: usize| table.iter().find(|(i, _)| *i == j).map(|(_, value)| *value);
            for k in 0..30 {
                for m in 0..30 {
                    let (Some(p), Some(q)) = (at(k + m + first), at(k.abs_diff(m))) else {
                        continue;
                    };
                    let (k, m) = (step * k + first, step * m + first);
                    let scale = (entries.entry(k, k) * entries.entry(m, m)).sqrt();
                    gram.note((entries.entry(k, m) - 0.5 * (p + q)).abs() / scale);
                }
            }
        }
    }
    eigenvalues.require("eigenvalues", EXACT);
    norms.require("norms", EXACT);
    factors.require("factors", EXACT);
    functions.require("eigenfunctions", EXACT);
    gram.require("Gram", EXACT);
}

#[test]
fn relation_of_the_companion_agrees_with_mpmath() {
    let data = more();
    let [mut eigenvalues, mut norms, mut functions, mut gram]: [Worst; 4] = Default::default();
    let cases = data["square"].as_array().unwrap();
    assert_eq!(cases.len(), 8);
    for case in cases {
        let relation = square(case);
        for (n, exact) in numbers(&case["eigenvalues"]).into_iter().enumerate() {
            eigenvalues.note((relation.eigenvalue(n) - exact).abs() / PI);
            norms.note((relation.norm(n) / numbers(&case["norms"])[n] - 1.0).abs());
        }
        for table in case["functions"].as_array().unwrap() {
            let mut values = vec![0.0; 32];
            relation.eigenfunctions(number(&table["x"]), &mut values);
            for (n, exact) in indexed(&table["values"]) {
                functions.note((values[n] - exact).abs());
            }
        }
        check_gram(&relation, &case["gram"], &mut gram);
        let entries = relation.gram(128).unwrap();
        for (j, exact) in indexed(&case["integrals"]) {
            gram.note((entries.entry(0, j) - exact).abs() / entries.entry(j, j));
        }
    }
    eigenvalues.require("eigenvalues", EXACT);
    norms.require("norms", EXACT);
    functions.require("eigenfunctions", EXACT);
    gram.require("Gram", EXACT);
}

#[test]
fn gram_integrals_hold_in_long_ranges() {
    let data = more();
    let [mut ratio, mut sine]: [Worst; 2] = Default::default();
    for case in data["ratio"].as_array().unwrap() {
        let (inner, outer) = (number(&case["inner"]), number(&case["outer"]));
        let gram = LogarithmRatio::new(inner, outer).unwrap().gram(201).unwrap();
        for (j, exact) in indexed(&case["integrals"]) {
            // The length of a short interval carries the rounding of its ends.
            ratio.note((gram.entry(0, j) - exact).abs() / gram.entry(j, j));
        }
    }
    for case in data["sine"].as_array().unwrap() {
        let kernel = LogarithmSine::new(number(&case["alpha"])).unwrap();
        let gram = kernel.gram(402).unwrap();
        for (j, exact) in indexed(&case["even"]) {
            sine.note((gram.entry(0, 2 * j) - exact).abs() / gram.entry(2 * j, 2 * j));
        }
        // R_{2k+1,2k+1} = (o_{2k+1} + o_0)/2 and R_{2k+1,2k-1} = (o_{2k} + o_1)/2
        let odd = indexed(&case["odd"]);
        let at = |j: usize| odd.iter().find(|(i, _)| *i == j).unwrap().1;
        for j in [2, 3, 10, 50, 200] {
            let (k, m, other) = if j % 2 == 1 { (j, j, at(0)) } else { (j + 1, j - 1, at(1)) };
            let scale = (gram.entry(k, k) * gram.entry(m, m)).sqrt();
            sine.note((gram.entry(k, m) - 0.5 * (at(j) + other)).abs() / scale);
        }
    }
    ratio.require("ratio", EXACT);
    sine.require("sine", EXACT);
}

/// `z ln z`, 0 at 0.
fn x_log(z: f64) -> f64 {
    if z > 0.0 { z * z.ln() } else { 0.0 }
}

/// Clausen's integral `Cl_2(t) = -int_0^t ln(2 sin(u/2)) du`, `0 <= t <= 2 pi`: `t - t ln t + t sum zeta(2k) (t/2 pi)^(2k)/(k (2k + 1))`.
fn clausen(t: f64) -> f64 {
    if t > PI {
        return -clausen(2.0 * PI - t);
    }
    let ratio = (t / (2.0 * PI)).powi(2);
    let mut sum = 0.0;
    for k in (1..40).rev() {
        let zeta: f64 = match k {
            1 => PI * PI / 6.0,
            2 => PI.powi(4) / 90.0,
            3 => PI.powi(6) / 945.0,
            _ => (1..60).rev().map(|n| f64::from(n).powi(-2 * k)).sum(),
        };
        sum += zeta * ratio.powi(k) / (f64::from(k) * (2.0 * f64::from(k) + 1.0));
    }
    t - x_log(t) + t * sum
}

/// `int_b^a K ds` of kernel 2, `b = 0` included.
fn ratio_of_one(b: f64, a: f64, x: f64) -> f64 {
    x_log(a + x) - x_log(b + x) - x_log(a - x) - x_log(x - b)
}

fn sine_of_one(alpha: f64, x: f64) -> f64 {
    clausen(alpha - x) + clausen(alpha + x)
}

fn square_of_one(b: f64, a: f64, gauge: f64, x: f64) -> f64 {
    2.0 * (a - b) * (1.0 + gauge.ln()) - x_log(a - x) - x_log(x - b) - x_log(a + x) + x_log(b + x)
}

/// `int_b^a K s ds` of the companion.
fn square_of_identity(b: f64, a: f64, gauge: f64, x: f64) -> f64 {
    let (outer, inner) = ((a - x) * (a + x), (x - b) * (x + b));
    (a - b) * (a + b) * (0.5 + gauge.ln()) - 0.5 * (x_log(outer) + x_log(inner))
}

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
    kernel: &(impl Kernel + ?Sized),
    parameter: f64,
    phi: impl Fn(f64) -> f64,
    potential: impl Fn(f64) -> f64,
    worst: &mut Worst,
) {
    let f = |x: f64| phi(x) + parameter * potential(x);
    let found = solve_adaptive(kernel, parameter, f, 1e-11).unwrap();
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
    assert!(own.0 <= found.estimate.solution / largest * 1.5, "the estimate is too small");
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
fn relations_hold_under_the_integral() {
    // int K phi_n w ds = lambda_n phi_n at the left end, where K is singular at most at that end.
    let mut worst = Worst::default();
    let relations: [Box<dyn SpectralRelation>; 8] = [
        Box::new(LogarithmRatio::new(0.25, 1.0).unwrap()),
        Box::new(LogarithmRatio::new(1e-3, 1.0).unwrap()),
        Box::new(LogarithmRatio::new(0.9, 1.0).unwrap()),
        Box::new(LogarithmRatioLimit::new(1.7).unwrap()),
        Box::new(LogarithmSine::new(1.5).unwrap()),
        Box::new(LogarithmSine::new(3.1).unwrap()),
        Box::new(LogarithmSquare::new(0.0, 1.2).unwrap()),
        Box::new(LogarithmSquare::with_gauge(0.3, 1.0, 2.0).unwrap()),
    ];
    for relation in relations {
        let (left, half) = (relation.interval().left(), relation.interval().half_length());
        let exponents = relation.weight_exponents();
        for n in 0..6 {
            let (mut integral, mut mass, mut norm) = (0.0, 0.0, 0.0);
            let mut values = [0.0; 6];
            let mut at_left = [0.0; 6];
            relation.eigenfunctions(left, &mut at_left);
            for node in double_exponential(200) {
                let (from_left, from_right) = (half * node.from_left, half * node.from_right);
                let s = left + from_left;
                relation.eigenfunctions(s, &mut values);
                let weight = relation.weight_rest(n, s)
                    * from_left.powf(exponents.left)
                    * from_right.powf(exponents.right)
                    * half
                    * node.weight;
                integral += weight * values[n] * relation.pair(left, s, from_left).value;
                mass += weight * values[n];
                norm += weight * values[n] * values[n];
            }
            // The rule ends 2e-17 from the ends: the inverse root there has a mass of 1e-8.
            worst.note((integral - relation.eigenvalue(n) * at_left[n]).abs() * 1e-7);
            worst.note((mass - relation.mass(n)).abs() * 1e-7);
            worst.note((norm - relation.norm(n)).abs() * 1e-7);
        }
    }
    worst.require("relations by quadrature, times 1e-7", 1e-13);
}

#[test]
fn first_kind_right_hand_sides_are_expanded() {
    let mut worst = Worst::default();
    let mut check = |relation: &dyn SpectralRelation, f: &dyn Fn(f64) -> f64, exact: &[f64]| {
        let expansion = relation.expand(f).unwrap();
        assert!(expansion.resolved, "{:?}: {}", relation.interval(), expansion.error);
        for n in 0..exact.len().max(expansion.coefficients.len()) {
            let at = |list: &[f64]| list.get(n).copied().unwrap_or(0.0);
            worst.note((at(&expansion.coefficients) - at(exact)).abs());
        }
    };
    let relations: [Box<dyn SpectralRelation>; 9] = [
        Box::new(LogarithmRatio::new(0.25, 1.0).unwrap()),
        Box::new(LogarithmRatio::new(1e-8, 1.0).unwrap()),
        Box::new(LogarithmRatio::new(0.999, 1.0).unwrap()),
        Box::new(LogarithmRatioLimit::new(1.7).unwrap()),
        Box::new(LogarithmSine::new(1.5).unwrap()),
        Box::new(LogarithmSine::new(3.1).unwrap()),
        Box::new(LogarithmSine::new(3.14).unwrap()),
        Box::new(LogarithmSquare::new(0.0, 1.2).unwrap()),
        Box::new(LogarithmSquare::with_gauge(0.3, 1.0, 2.0).unwrap()),
    ];
    for relation in &relations {
        for n in [0, 1, 2, 5, 12] {
            let mut unit = vec![0.0; n + 1];
            unit[n] = 1.0;
            check(&**relation, &|x| relation.sum(&unit, x), &unit);
        }
    }
    // x = a dn: the Fourier series of dn
    for (b, a) in [(0.25, 1.0), (1e-8, 2.0), (0.9, 1.0)] {
        let kernel = LogarithmRatio::new(b, a).unwrap();
        // pi K'/K and K/a from the relation, whose numbers are tested against mpmath.
        let (decay, complete) = (kernel.expansion_factor(0), kernel.norm(0) * a);
        let exact: Vec<f64> = (0..400)
            .map(|n| {
                let share = if n == 0 { 0.5 } else { 1.0 };
                share * PI * a / complete / (f64::from(n) * decay).cosh()
            })
            .collect();
        check(&kernel, &|x| x, &exact);
    }
    let limit = LogarithmRatioLimit::new(2.0).unwrap();
    // x^3 = a^3 (3 T_1 + T_3)/4
    check(&limit, &|x| x.powi(3), &[6.0, 2.0]);
    let companion = LogarithmSquare::new(1.0, 2.0).unwrap();
    check(&companion, &|x| x * x, &[2.5, 1.5]);
    for alpha in [0.7f64, 2.0, 3.1] {
        let kernel = LogarithmSine::new(alpha).unwrap();
        let sigma = (0.5 * alpha).sin();
        // cos x = 1 - 2 sigma^2 xi^2
        check(&kernel, &f64::cos, &[1.0 - sigma * sigma, 0.0, -sigma * sigma]);
        let tangent = |x: f64| (0.5 * x).tan() / (0.5 * alpha).tan();
        check(&kernel, &|x| 2.0 + tangent(x), &[2.0, 1.0]);
    }
    worst.require("expansions", 1e-12);
}

#[test]
fn moments_agree_with_quadrature() {
    let mut worst = Worst::default();
    let relations: [Box<dyn SpectralRelation>; 8] = [
        Box::new(LogarithmRatio::new(0.25, 1.0).unwrap()),
        Box::new(LogarithmRatio::new(1e-4, 1.0).unwrap()),
        Box::new(LogarithmRatioLimit::new(1.7).unwrap()),
        Box::new(LogarithmSine::new(1.5).unwrap()),
        Box::new(LogarithmSine::new(3.1).unwrap()),
        Box::new(LogarithmSquare::new(0.0, 1.2).unwrap()),
        Box::new(LogarithmSquare::new(1e-6, 1.2).unwrap()),
        Box::new(LogarithmSquare::new(0.3, 1.0).unwrap()),
    ];
    for relation in relations {
        let (centre, half) = (relation.interval().centre(), relation.interval().half_length());
        for f in [|_: f64| 1.0, |x: f64| x, f64::exp] as [fn(f64) -> f64; 3] {
            let moments = relation.moments(&f, 24).unwrap();
            assert!(moments.resolved);
            let mut exact = vec![0.0; 24];
            let mut values = vec![0.0; 24];
            for node in double_exponential(400) {
                let x = if node.position < 0.0 {
                    relation.interval().left() + half * node.from_left
                } else {
                    centre + half * node.position
                };
                relation.eigenfunctions(x, &mut values);
                let weight = half * node.weight * f(x);
                exact.iter_mut().zip(&values).for_each(|(sum, phi)| *sum += weight * phi);
            }
            let scale = half * f(relation.interval().right());
            for (found, exact) in moments.values.iter().zip(&exact) {
                worst.note((found - exact).abs() / scale);
            }
        }
    }
    worst.require("moments", EXACT);
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

#[test]
fn values_are_right_at_the_corner() {
    let limit = LogarithmRatioLimit::new(1.0).unwrap();
    assert_eq!(limit.value(0.0, 0.0), 0.0);
    assert_eq!(limit.value(0.0, 0.3), 0.0);
    for (x, s, exact) in [
        (1e-300, 1.0, 2e-300),
        (1.0, 1e-20, 2e-20),
        (3e-200, 1e-200, 2f64.ln()),
        (0.75, 0.25, 2f64.ln()),
    ] {
        assert!((limit.value(x, s) / exact - 1.0).abs() < 1e-15, "{x} {s}");
        assert_eq!(limit.value(x, s), limit.value(s, x));
    }
    let companion = LogarithmSquare::new(0.0, 1.0).unwrap();
    assert!((companion.value(1e-200, 0.0) - 400.0 * 10f64.ln()).abs() < 1e-12);
}

#[test]
fn parameters_out_of_range_are_refused() {
    let refused = |result: Result<(), Error>, name: &str| match result {
        Err(Error::InvalidParameter { name: found, .. }) => assert_eq!(found, name),
        other => panic!("{other:?}"),
    };
    for b in [0.0, -1.0, f64::NAN, f64::INFINITY, 1.0, 2.0, 1e-151] {
        refused(LogarithmRatio::new(b, 1.0).map(|_| ()), "inner end");
    }
    let message = LogarithmRatio::new(0.0, 1.0).unwrap_err().to_string();
    assert!(message.contains("LogarithmRatioLimit"), "{message}");
    for a in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-200, 1e200] {
        refused(LogarithmRatio::new(0.5 * a, a).map(|_| ()), "outer end");
        refused(LogarithmSquare::new(0.5 * a, a).map(|_| ()), "outer end");
        refused(LogarithmSquare::with_gauge(0.5, 1.0, a).map(|_| ()), "gauge");
        refused(LogarithmRatioLimit::new(a).map(|_| ()), "length");
    }
    for b in [-1e-9, f64::NAN, 1.0, f64::INFINITY] {
        refused(LogarithmSquare::new(b, 1.0).map(|_| ()), "inner end");
    }
    for alpha in [0.0, -1.0, f64::NAN, PI, 3.2, f64::INFINITY, 1e-160] {
        refused(LogarithmSine::new(alpha).map(|_| ()), "alpha");
    }
}

#[test]
fn extreme_parameters_stay_finite() {
    let relations: [Box<dyn SpectralRelation>; 9] = [
        Box::new(LogarithmRatio::new(1e-150, 1.0).unwrap()),
        Box::new(LogarithmRatio::new(1.0f64.next_down(), 1.0).unwrap()),
        Box::new(LogarithmRatio::new(1e149, 1e150).unwrap()),
        Box::new(LogarithmRatioLimit::new(1e-150).unwrap()),
        Box::new(LogarithmSine::new(1e-150).unwrap()),
        Box::new(LogarithmSine::new(PI.next_down()).unwrap()),
        Box::new(LogarithmSquare::new(1.0f64.next_down(), 1.0).unwrap()),
        Box::new(LogarithmSquare::new(5e-324, 1.0).unwrap()),
        Box::new(LogarithmSquare::with_gauge(1e-150, 1e150, 1e-150).unwrap()),
    ];
    for relation in relations {
        let gram = relation.gram(12).unwrap();
        let (left, right) = (relation.interval().left(), relation.interval().right());
        for n in 0..12 {
            assert!(relation.eigenvalue(n).is_finite() && relation.norm(n) > 0.0);
            assert!((0..12).all(|m| gram.entry(n, m).is_finite()), "{:?}", relation.interval());
            assert!(gram.entry(n, n) > 0.0, "{:?} {n}", relation.interval());
        }
        for x in [left, relation.interval().centre(), right] {
            let mut values = [0.0; 12];
            relation.eigenfunctions(x, &mut values);
            assert!(values.iter().all(|value| value.abs() <= 1.0 + 1e-13), "{values:?}");
            assert!(relation.weight_rest(0, x).is_finite() && relation.weight_rest(1, x) >= 0.0);
        }
        let moments = relation.moments(&|_| 1.0, 12).unwrap();
        let scale = gram.entry(0, 0);
        for (k, moment) in moments.values.iter().enumerate() {
            assert!(moment.is_finite(), "{:?} {k}", relation.interval());
            assert!(moment.abs() <= 1.01 * scale.max(right - left));
        }
    }
    for count in [usize::MAX, usize::MAX / 2, 1 << 40] {
        let relations: [Box<dyn SpectralRelation>; 4] = [
            Box::new(LogarithmRatio::new(0.5, 1.0).unwrap()),
            Box::new(LogarithmRatioLimit::new(1.0).unwrap()),
            Box::new(LogarithmSine::new(1.0).unwrap()),
            Box::new(LogarithmSquare::new(0.5, 1.0).unwrap()),
        ];
        for relation in relations {
            assert!(matches!(relation.gram(count), Err(Error::TooLarge { .. })));
            assert!(matches!(relation.moments(&|_| 1.0, count), Err(Error::TooLarge { .. })));
        }
    }
}
