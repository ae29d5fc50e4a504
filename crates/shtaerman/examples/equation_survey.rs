//! Audited solutions of random equations of the second kind against product integration that shares no code with solvers and audits but values of the kernels.
//!
//! ```text
//! cargo run --release -p shtaerman --example equation_survey -- 300 [seed [kernel]]
//! ```
//!
//! For each kernel: equations, refusals, statements below the true error, the largest quotient of true over stated error, and the median of stated over true where that is above 1e-11.

#![allow(clippy::unwrap_used, reason = "an example may fail by panicking")]

use std::f64::consts::PI;
use std::process::ExitCode;

use fredholm::kernel::{Kernel, Singularity};
use shtaerman::equation::EquationFile;

/// Random numbers (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn logarithmic(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }
}

const KERNELS: [&str; 9] = [
    "log",
    "log-ratio",
    "log-ratio-limit",
    "log-square",
    "log-sine",
    "power",
    "macdonald",
    "weber-sonine",
    "yukawa",
];

/// The parameters of a kernel as they stand in a file, and its interval.
fn kernel(name: &str, random: &mut Random) -> (String, [f64; 2]) {
    let a = random.logarithmic(0.1, 1.9);
    let b = a * random.between(0.05, 0.8);
    let text = match name {
        "log" => format!("a = {a}"),
        "log-ratio-limit" => return (format!("a = {a}"), [0.0, a]),
        "log-ratio" | "log-square" => return (format!("a = {a}\nb = {b}"), [b, a]),
        "log-sine" => {
            let alpha = random.between(0.2, 3.1);
            return (format!("alpha = {alpha}"), [-alpha, alpha]);
        }
        "power" => format!("a = {a}\nmu = {}", random.between(0.05, 0.6)),
        "macdonald" => {
            let (mu, kappa) = (random.between(-0.3, 0.3), random.logarithmic(0.2, 3.0));
            format!("a = {a}\nmu = {mu}\nkappa = {kappa}")
        }
        "weber-sonine" => {
            let (mu, gamma) = (random.between(0.0, 2.0).round(), random.between(-0.3, 0.2));
            return (format!("a = {a}\nmu = {mu}\ngamma = {gamma}"), [0.0, a]);
        }
        _ => {
            let (chi, m) = (random.between(0.0, 3.0), random.between(0.0, 2.0).round());
            return (format!("a = {a}\nchi0 = {chi}\nm = {m}"), [0.0, a]);
        }
    };
    (text, [-a, a])
}

/// A right-hand side with the places where it bends, each with the width of what is there.
fn right_hand_side([left, right]: [f64; 2], random: &mut Random) -> (String, Vec<(f64, f64)>) {
    let length = right - left;
    let c = left + length * random.between(0.1, 0.9);
    let smooth = format!("{} + {}*x", random.between(-1.0, 1.0), random.between(-1.0, 1.0));
    let kind = (6.0 * random.unit()) as usize;
    let size = random.logarithmic(1e-3, 1.0);
    let width = length * random.logarithmic(1e-4, 0.1);
    match kind {
        0 => (smooth, vec![]),
        1 => (format!("{smooth} + cos({}*x)", random.between(1.0, 12.0) / length), vec![]),
        2 => (format!("{smooth} + {size}*exp(-((x - {c})/{width})^2)"), vec![(c, width)]),
        3 => (format!("{smooth} + {size}*abs(x - {c})"), vec![(c, 0.0)]),
        4 => (format!("{smooth} + {size}*sign(x - {c})"), vec![(c, 0.0)]),
        _ => (format!("{smooth} + {size}/(1 + ((x - {c})/{width})^2)"), vec![(c, width)]),
    }
}

/// Gauss and Legendre on `(-1, 1)` by Newton's method.
fn gauss(count: usize) -> Vec<(f64, f64)> {
    (0..count)
        .map(|i| {
            let mut t = (PI * (i as f64 + 0.75) / (count as f64 + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..100 {
                let (mut p, mut before) = (1.0, 0.0);
                for k in 0..count {
                    let n = k as f64;
                    (p, before) = (((2.0 * n + 1.0) * t * p - n * before) / (n + 1.0), p);
                }
                slope = count as f64 * (t * p - before) / (t * t - 1.0);
                t -= p / slope;
            }
            (t, 2.0 / ((1.0 - t * t) * slope * slope))
        })
        .collect()
}

struct Reference<'a> {
    kernel: &'a dyn Kernel,
    lambda: f64,
    f: &'a dyn Fn(f64) -> f64,
    panels: Vec<[f64; 2]>,
    rule: Vec<(f64, f64)>,
    fine: Vec<(f64, f64)>,
    barycentric: Vec<f64>,
    values: Vec<f64>,
}

/// Panels graded to both ends and to all features.
fn graded([left, right]: [f64; 2], features: &[(f64, f64)]) -> Vec<[f64; 2]> {
    let length = right - left;
    let mut panels = Vec::new();
    let mut stack = vec![[left, right]];
    while let Some([l, r]) = stack.pop() {
        let inside = features.iter().find(|(c, w)| *w == 0.0 && l < *c && *c < r);
        let m = inside.map_or(0.5 * (l + r), |(c, _)| *c);
        let apart = |x: f64| (l - x).max(x - r).max(0.0);
        let least = |x: f64, shortest: f64| (1.01 * apart(x)).max(shortest);
        let most = [(left, 1e-11 * length), (right, 1e-11 * length)]
            .into_iter()
            .chain(features.iter().map(|(c, w)| (*c, if *w > 0.0 { *w } else { 1e-9 * length })))
            .map(|(x, shortest)| least(x, shortest))
            .fold(0.35 * length, f64::min);
        if inside.is_some() || r - l > most {
            stack.push([m, r]);
            stack.push([l, m]);
        } else {
            panels.push([l, r]);
        }
    }
    panels
}

impl<'a> Reference<'a> {
    fn new(
        kernel: &'a dyn Kernel,
        lambda: f64,
        f: &'a dyn Fn(f64) -> f64,
        panels: Vec<[f64; 2]>,
        count: usize,
    ) -> Self {
        let (rule, fine) = (gauss(count), gauss(16));
        let barycentric = (0..count)
            .map(|j| {
                let others = rule.iter().enumerate().filter(|(k, _)| *k != j);
                1.0 / others.map(|(_, (u, _))| rule[j].0 - u).product::<f64>()
            })
            .collect();
        let mut reference =
            Self { kernel, lambda, f, panels, rule, fine, barycentric, values: Vec::new() };
        let n = reference.panels.len() * count;
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(n);
        for i in 0..n {
            let x = reference.node(i);
            let mut row = reference.row(x);
            row.iter_mut().for_each(|entry| *entry *= lambda);
            row[i] += 1.0;
            row.push(f(x));
            rows.push(row);
        }
        reference.values = eliminate(rows);
        reference
    }

    fn node(&self, i: usize) -> f64 {
        let [l, r] = self.panels[i / self.rule.len()];
        0.5 * (l + r) + 0.5 * (r - l) * self.rule[i % self.rule.len()].0
    }

    /// `int K(x, s) L_j(s) dm(s)` for all nodes.
    fn row(&self, x: f64) -> Vec<f64> {
        let count = self.rule.len();
        let mut row = vec![0.0; self.panels.len() * count];
        for (panel, [l, r]) in self.panels.iter().enumerate() {
            let entries = &mut row[panel * count..(panel + 1) * count];
            let distance = (l - x).max(x - r);
            if distance > r - l {
                for (entry, (t, w)) in entries.iter_mut().zip(&self.rule) {
                    let s = 0.5 * (l + r) + 0.5 * (r - l) * t;
                    *entry = 0.5 * (r - l) * w * self.at(x, s, (x - s).abs());
                }
            } else if distance < 0.0 {
                self.graded(x, [*l, *r], x - l, -1.0, 0.0, entries);
                self.graded(x, [*l, *r], r - x, 1.0, 0.0, entries);
            } else if *l >= x {
                self.graded(x, [*l, *r], r - x, 1.0, distance, entries);
            } else {
                self.graded(x, [*l, *r], x - l, -1.0, distance, entries);
            }
        }
        row
    }

    fn at(&self, x: f64, s: f64, distance: f64) -> f64 {
        self.kernel.pair(x, s, distance).value * self.kernel.measure(s)
    }

    /// Adds the integrals over `x + side d`, `nearest < d < far`, on shells that shrink to `x`.
    fn graded(
        &self,
        x: f64,
        [l, r]: [f64; 2],
        far: f64,
        side: f64,
        nearest: f64,
        entries: &mut [f64],
    ) {
        let strength = match self.kernel.singularity() {
            Singularity::Power { exponent } => exponent,
            _ => 0.0,
        };
        let least = (far * 1e-17f64.powf(1.0 / (1.0 - strength))).max(nearest);
        let mut outer = far;
        while outer > nearest {
            let inner = if 0.25 * outer <= least { nearest } else { 0.25 * outer };
            for (t, w) in &self.fine {
                let d = 0.5 * (inner + outer) + 0.5 * (outer - inner) * t;
                let s = x + side * d;
                let value = 0.5 * (outer - inner) * w * self.at(x, s, d);
                let own = ((s - 0.5 * (l + r)) / (0.5 * (r - l))).clamp(-1.0, 1.0);
                self.spread(own, value, entries);
            }
            outer = inner;
        }
    }

    fn spread(&self, t: f64, value: f64, entries: &mut [f64]) {
        if let Some(j) = self.rule.iter().position(|(u, _)| *u == t) {
            entries[j] += value;
            return;
        }
        let total: f64 =
            self.rule.iter().zip(&self.barycentric).map(|((u, _), b)| b / (t - u)).sum();
        for ((entry, (u, _)), b) in entries.iter_mut().zip(&self.rule).zip(&self.barycentric) {
            *entry += value * b / ((t - u) * total);
        }
    }

    fn evaluate(&self, x: f64) -> f64 {
        let row = self.row(x);
        let sum: f64 = row.iter().zip(&self.values).map(|(k, phi)| k * phi).sum();
        (self.f)(x) - self.lambda * sum
    }

    fn integral(&self) -> f64 {
        let values = self.values.iter().enumerate();
        let terms = values.map(|(i, phi)| {
            let [l, r] = self.panels[i / self.rule.len()];
            let weight = 0.5 * (r - l) * self.rule[i % self.rule.len()].1;
            let x = self.node(i);
            weight * self.kernel.mass_function(x) * self.kernel.measure(x) * phi
        });
        terms.sum()
    }
}

/// The solution of a system whose right-hand side is the last column.
fn eliminate(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs())).unwrap();
        rows.swap(k, pivot);
        let (top, rest) = rows.split_at_mut(k + 1);
        let row = &top[k];
        for other in rest {
            let factor = other[k] / row[k];
            if factor != 0.0 {
                for (entry, known) in other[k..].iter_mut().zip(&row[k..]) {
                    *entry -= factor * known;
                }
            }
        }
    }
    let mut found = vec![0.0; n];
    for k in (0..n).rev() {
        let sum: f64 = (k + 1..n).map(|j| rows[k][j] * found[j]).sum();
        found[k] = (rows[k][n] - sum) / rows[k][k];
    }
    found
}

/// What one equation gave.
struct Outcome {
    /// True over stated error, of the solution and of the integral, after the reference's own error was taken off.
    ratios: [f64; 2],
    /// Stated over true where that is above 1e-11 of the solution.
    sharpness: Option<f64>,
    text: String,
    kind: &'static str,
}

fn outcome(name: &str, random: &mut Random) -> Result<Outcome, String> {
    let (parameters, interval) = kernel(name, random);
    let (rhs, features) = right_hand_side(interval, random);
    let lambda = random.logarithmic(0.01, 1000.0);
    // As good as it gets, as poor as it may be, and truncated.
    let solver = match (3.0 * random.unit()) as usize {
        0 => String::new(),
        1 => format!("tolerance = {:e}", random.logarithmic(1e-10, 1e-2)),
        _ => format!("method = \"spectral\"\nn = {}", random.logarithmic(8.0, 300.0) as usize),
    };
    let text = format!(
        "[equation]\nkind = \"second\"\nlambda = {lambda}\nrhs = \"{rhs}\"\n[kernel]\nname = \"{name}\"\n{parameters}\n[solver]\n{solver}\n"
    );
    let file = EquationFile::parse(&text, "survey").map_err(|error| error.to_string())?;
    let solved = file.equation().solve().and_then(shtaerman::equation::SolvedEquation::audited);
    let solved = solved.map_err(|error| format!("{error}\n{text}"))?;
    let f = |x: f64| file.equation().right_hand_side().evaluate(&[x]);
    let panels = graded(interval, &features);
    let kernel = file.equation().kernel().kernel();
    let [one, two] = [12, 9].map(|count| Reference::new(kernel, lambda, &f, panels.clone(), count));
    let [left, right] = interval;
    let mut places: Vec<f64> =
        (0..24).map(|_| left + (right - left) * random.between(1e-4, 1.0 - 1e-4)).collect();
    for (c, w) in &features {
        places.extend([-2.2, -0.7, 0.1, 0.9].map(|share| c + share * w.max(1e-5)));
    }
    places.retain(|x| left < *x && *x < right);
    let (mut worst, mut own, mut largest) = (0.0f64, 0.0f64, 0.0f64);
    for x in places {
        let [exact, other] = [one.evaluate(x), two.evaluate(x)];
        assert!(exact.is_finite() && other.is_finite(), "the reference is not finite");
        let found = solved.evaluate(x).unwrap().unwrap();
        worst = worst.max((found - exact).abs());
        own = own.max((exact - other).abs());
        largest = largest.max(exact.abs());
    }
    let report = solved.audit_report().cloned().unwrap();
    let stated = solved.error().solution;
    let floor = 1e-14 * largest * (1.0 + lambda).min(100.0);
    let sharpness = (worst > 1e-11 * largest && worst > 10.0 * own).then_some(stated / worst);
    let exact = one.integral();
    let own_integral = (exact - two.integral()).abs();
    let integral = solved.integral().map_or(0.0, |found| {
        let missed = (found - exact).abs() - own_integral - 1e-14 * exact.abs();
        missed.max(0.0) / solved.error().integral
    });
    let kind = report.kind.map_or("none", shtaerman::ErrorKind::name);
    Ok(Outcome {
        ratios: [(worst - own - floor).max(0.0) / stated, integral],
        sharpness,
        text: format!("{text}true {worst:e} reference {own:e} stated {stated:e}\n{report:?}"),
        kind,
    })
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let count: u64 = arguments.first().and_then(|text| text.parse().ok()).unwrap_or(20);
    let seed: u64 = arguments.get(1).and_then(|text| text.parse().ok()).unwrap_or(1);
    println!("{count} equations a kernel, seed {seed}");
    let mut all_broken = 0;
    for name in KERNELS {
        if arguments.get(2).is_some_and(|chosen| chosen != name) {
            continue;
        }
        let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        for _ in 0..100 {
            random.unit();
        }
        let (mut refused, mut broken, mut bounds) = (0, 0, 0);
        let mut worst = [0.0f64; 2];
        let mut sharpness = Vec::new();
        for _ in 0..count {
            match outcome(name, &mut random) {
                Err(error) => {
                    refused += 1;
                    println!("  refused: {error}");
                }
                Ok(found) => {
                    if arguments.len() > 3 {
                        println!("{}", found.text);
                    }
                    bounds += usize::from(found.kind == "bound");
                    sharpness.extend(found.sharpness);
                    worst = [worst[0].max(found.ratios[0]), worst[1].max(found.ratios[1])];
                    if found.ratios.iter().any(|ratio| ratio.is_nan() || *ratio > 1.0) {
                        broken += 1;
                        println!("  broken {:?}: {}", found.ratios, found.text);
                    }
                }
            }
        }
        all_broken += broken;
        sharpness.sort_by(f64::total_cmp);
        let median = sharpness.get(sharpness.len() / 2).copied().unwrap_or(f64::NAN);
        println!(
            "{name:<16} bounds {bounds}, refused {refused}, broken {broken}, true/stated: solution {:.2}, integral {:.2}; stated/true, median of {}: {median:.1}",
            worst[0],
            worst[1],
            sharpness.len()
        );
    }
    if all_broken == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
