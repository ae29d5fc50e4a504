//! Eigenvalues, norms, eigenfunctions and Gram matrices.

use std::f64::consts::PI;

use fredholm::kernel::{
    LogarithmRatio, LogarithmRatioLimit, LogarithmSine, LogarithmSquare, SpectralRelation,
};
use fredholm::quadrature::double_exponential;
use serde_json::Value;

use crate::kernels_logarithmic::reference::{
    EXACT, Worst, indexed, kernel, kernels_2_3, more, number, numbers, placed, square,
};

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

#[test]
fn relations_hold_under_the_integral() {
    // int K phi_n w ds = lambda_n phi_n at the left end, where K is singular at most there.
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
                // s = left + (right - left) sin^2(t), which takes the inverse roots away.
                let quarter = 0.25 * PI;
                let (sine, cosine) =
                    ((quarter * node.from_left).sin(), (quarter * node.from_right).sin());
                let (from_left, from_right) =
                    (2.0 * half * sine * sine, 2.0 * half * cosine * cosine);
                let s = left + from_left;
                relation.eigenfunctions(s, &mut values);
                let weight = relation.weight_rest(n, s)
                    * from_left.powf(exponents.left)
                    * from_right.powf(exponents.right)
                    * (4.0 * half * sine * cosine * quarter * node.weight);
                integral += weight * values[n] * relation.pair(left, s, from_left).value;
                mass += weight * values[n];
                norm += weight * values[n] * values[n];
            }
            let largest = relation.eigenvalue(0).max(relation.eigenvalue(1));
            worst.note((integral - relation.eigenvalue(n) * at_left[n]).abs() / largest);
            worst.note((mass - relation.mass(n)).abs() / relation.norm(0));
            worst.note((norm - relation.norm(n)).abs() / relation.norm(0));
        }
    }
    worst.require("relations by quadrature", EXACT);
}
