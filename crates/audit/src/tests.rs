//! Bounds against solutions by product integration on graded panels.

use crate::density::{Density, Panel};
use crate::kernel::Kernel;
use crate::legendre::{ORDER, RULE, Seen, potentials};
use crate::{Answer, Prescribed, Problem, Profile, audit};

/// `c x^2 + s x`, with derivatives as they are.
struct Parabola {
    c: f64,
    s: f64,
}

impl Profile for Parabola {
    fn height(&self, x: f64) -> [f64; 2] {
        let f = self.c * x * x + self.s * x;
        let error = f64::EPSILON * (self.c * x * x).abs().max((self.s * x).abs());
        [f - error, f + error]
    }

    fn range(&self, [left, right]: [f64; 2]) -> [f64; 2] {
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let slope = (2.0 * self.c * middle + self.s).abs() + 2.0 * self.c.abs() * half;
        let [low, high] = self.height(middle);
        [low - slope * half, high + slope * half]
    }

    fn taylor_bounds(&self, [left, right]: [f64; 2], order: usize) -> Vec<f64> {
        let x = left.abs().max(right.abs());
        let mut bounds = vec![0.0; order + 1];
        bounds[0] = self.c.abs() * x * x + self.s.abs() * x;
        bounds[1] = 2.0 * self.c.abs() * x + self.s.abs();
        bounds[2] = self.c.abs();
        bounds
    }
}

/// Panels graded to both ends of `[l, r]`.
fn graded([l, r]: [f64; 2], levels: i32) -> Vec<[f64; 2]> {
    let half = 0.5 * (r - l);
    let mut ends: Vec<f64> = vec![l];
    ends.extend((0..=levels).rev().map(|k| l + half * 0.5f64.powi(k)));
    ends.extend((1..=levels).map(|k| r - half * 0.5f64.powi(k)));
    ends.push(r);
    ends.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// The pressure on a zone under a force and a moment by collocation at the nodes of panels: panels, settlement, tilt.
fn solved(
    kernel: Kernel,
    theta: f64,
    zone: [f64; 2],
    f: &dyn Fn(f64) -> f64,
    load: [f64; 2],
) -> (Vec<Panel>, f64, f64) {
    let cells = graded(zone, 44);
    let n = cells.len() * ORDER;
    let place = |i: usize| {
        let [l, r] = cells[i / ORDER];
        (
            0.5 * (l + r) + 0.5 * (r - l) * RULE.nodes[i % ORDER],
            0.5 * (r - l) * RULE.weights[i % ORDER],
        )
    };
    let size = n + 2;
    let mut a = vec![0.0; size * size];
    let mut b = vec![0.0; size];
    let singularity = kernel.singularity();
    for i in 0..n {
        let (x, weight) = place(i);
        for (j, [l, r]) in cells.iter().enumerate() {
            let half = 0.5 * (r - l);
            let at = Seen {
                z: ((x - l) - (r - x)) / (2.0 * half),
                from_left: (x - l) / half,
                to_right: (r - x) / half,
            };
            let moments =
                if at.z.abs() < 3.0 { potentials(singularity, at) } else { far(kernel, at.z) };
            for node in 0..ORDER {
                let mut unit = [0.0; ORDER];
                unit[node] = 1.0;
                let c = RULE.expand(&unit);
                let sum: f64 = c.iter().zip(&moments).map(|(a, b)| a * b).sum();
                a[i * size + j * ORDER + node] = theta
                    * match kernel {
                        Kernel::Power { exponent } => half.powf(1.0 - exponent) * sum,
                        _ => -(half * sum + 2.0 * half * c[0] * half.ln()),
                    };
            }
        }
        a[i * size + i] += 1.0;
        a[i * size + n] = -1.0;
        a[i * size + n + 1] = x;
        b[i] = -f(x);
        a[n * size + i] = weight;
        a[(n + 1) * size + i] = weight * x;
    }
    b[n] = load[0];
    b[n + 1] = load[1];
    let s = eliminate(a, b);
    let panels = cells
        .iter()
        .enumerate()
        .map(|(j, [l, r])| {
            let mut values = [0.0; ORDER];
            values.copy_from_slice(&s[j * ORDER..(j + 1) * ORDER]);
            Panel::new(*l, *r, RULE.expand(&values))
        })
        .collect();
    (panels, s[n], s[n + 1])
}

/// The same as [`potentials`] far from the panel, by Gauss quadrature.
fn far(kernel: Kernel, z: f64) -> [f64; ORDER] {
    let mut found = [0.0; ORDER];
    for (t, w) in RULE.nodes.iter().zip(&RULE.weights) {
        let value = kernel.singularity().value((z - t).abs());
        for (entry, p) in found.iter_mut().zip(crate::legendre::polynomials(*t)) {
            *entry += w * p * value;
        }
    }
    found
}

fn eliminate(mut a: Vec<f64>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let pivot =
            (k..n).max_by(|i, j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs())).unwrap();
        if pivot != k {
            for j in 0..n {
                a.swap(k * n + j, pivot * n + j);
            }
            b.swap(k, pivot);
        }
        let (top, rest) = a.split_at_mut((k + 1) * n);
        let row = &top[k * n..];
        for i in 0..n - k - 1 {
            let factor = rest[i * n + k] / row[k];
            if factor != 0.0 {
                for j in k..n {
                    rest[i * n + j] -= factor * row[j];
                }
                b[k + 1 + i] -= factor * b[k];
            }
        }
    }
    for k in (0..n).rev() {
        let sum: f64 = (k + 1..n).map(|j| a[k * n + j] * b[j]).sum();
        b[k] = (b[k] - sum) / a[k * n + k];
    }
    b
}

#[test]
fn full_contact_of_a_parabola() {
    for (theta, kernel) in [
        (1.0, Kernel::Logarithm),
        (60.0, Kernel::Logarithm),
        (2.0, Kernel::Power { exponent: 0.3 }),
    ] {
        let profile = Parabola { c: 0.5, s: 0.1 };
        let f = |x: f64| 0.5 * x * x + 0.1 * x;
        let (panels, settlement, tilt) = solved(kernel, theta, [-1.0, 1.0], &f, [3.0, 0.1]);
        let density = Density::new(kernel, panels);
        let pressure = |x: f64| density.evaluate(x);
        let start = std::time::Instant::now();
        let bound = audit(
            &Problem {
                kernel,
                theta,
                scaled: 0.0,
                pieces: &[[-1.0, 1.0]],
                is_bilateral: false,
                prescribed: Prescribed { force: Some(3.0), moment: Some(0.1) },
                profile: &profile,
                cuts: &[],
            },
            &Answer {
                zones: &[[-1.0, 1.0]],
                pressure: &pressure,
                settlement,
                tilt,
                force: 3.0,
                moment: 0.1,
            },
        );
        println!("{theta} {kernel:?} {:?} {bound:?}", start.elapsed());
    }
}
