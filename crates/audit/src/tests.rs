//! Bounds against solutions by product integration on graded panels.

use crate::density::Density;
use crate::kernel::Kernel;
use crate::legendre::{ORDER, RULE};
use crate::panel::Panel;
use crate::slow::{Seen, potentials};
use crate::{Answer, Prescribed, Problem, Profile, audit, audit_on_halved_panels};

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

    fn looks(&self, _: [f64; 2]) -> u64 {
        0
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

/// Responses of the pressure on zones to settlement, tilt and profile by collocation at the nodes of panels: `p = delta p_1 - alpha p_x - p_f`.
struct Reference {
    kernel: Kernel,
    theta: f64,
    cells: Vec<[f64; 2]>,
    /// Values at the nodes.
    responses: [Vec<f64>; 3],
}

impl Reference {
    fn new(kernel: Kernel, theta: f64, zones: &[[f64; 2]], f: &dyn Fn(f64) -> f64) -> Self {
        let cells: Vec<[f64; 2]> = zones.iter().flat_map(|zone| graded(*zone, 40)).collect();
        let n = cells.len() * ORDER;
        let mut a = vec![0.0; n * n];
        let singularity = kernel.singularity();
        // The polynomials that are 1 at one node.
        let units: [[f64; ORDER]; ORDER] = std::array::from_fn(|m| {
            RULE.expand(&std::array::from_fn(|k| if k == m { 1.0 } else { 0.0 }))
        });
        for i in 0..n {
            let x = node(&cells, i).0;
            for (j, [l, r]) in cells.iter().enumerate() {
                let half = 0.5 * (r - l);
                let at = Seen {
                    z: ((x - l) - (r - x)) / (2.0 * half),
                    from_left: (x - l) / half,
                    to_right: (r - x) / half,
                };
                let moments =
                    if at.z.abs() < 3.0 { potentials(singularity, at) } else { far(kernel, at.z) };
                for (m, c) in units.iter().enumerate() {
                    let sum: f64 = c.iter().zip(&moments).map(|(a, b)| a * b).sum();
                    let singular = match kernel {
                        Kernel::Power { exponent } => half.powf(1.0 - exponent) * sum,
                        _ => -(half * sum + 2.0 * half * c[0] * half.ln()),
                    };
                    let (s, weight) = node(&cells, j * ORDER + m);
                    let regular = match kernel {
                        Kernel::Row { period } if s != x => {
                            let d = (x - s).abs();
                            -(2.0 * (std::f64::consts::PI * d / period).sin() / d).ln() * weight
                        }
                        Kernel::Row { period } => -(std::f64::consts::TAU / period).ln() * weight,
                        _ => 0.0,
                    };
                    a[i * n + j * ORDER + m] = theta * (singular + regular);
                }
            }
            a[i * n + i] += 1.0;
        }
        let places: Vec<f64> = (0..n).map(|i| node(&cells, i).0).collect();
        let right = [vec![1.0; n], places.clone(), places.iter().map(|x| f(*x)).collect()];
        let responses = eliminate(a, right);
        Self { kernel, theta, cells, responses }
    }

    fn panels(&self, settlement: f64, tilt: f64) -> Vec<Panel> {
        let [one, x, f] = &self.responses;
        (self.cells.iter().enumerate())
            .map(|(j, [l, r])| {
                let mut values = [0.0; ORDER];
                for (m, value) in values.iter_mut().enumerate() {
                    let i = j * ORDER + m;
                    *value = settlement * one[i] - tilt * x[i] - f[i];
                }
                Panel::new(*l, *r, RULE.expand(&values))
            })
            .collect()
    }

    /// `int u p` of each response.
    fn integrals(&self, u: &dyn Fn(f64) -> f64) -> [f64; 3] {
        let sum = |values: &Vec<f64>| -> f64 {
            values
                .iter()
                .enumerate()
                .map(|(i, p)| {
                    let (x, weight) = node(&self.cells, i);
                    weight * u(x) * p
                })
                .sum()
        };
        [sum(&self.responses[0]), sum(&self.responses[1]), sum(&self.responses[2])]
    }

    /// Settlement and tilt under a force and a moment.
    fn loaded(&self, force: f64, moment: f64) -> [f64; 2] {
        let [a, b, c] = self.integrals(&|_| 1.0);
        let [d, e, f] = self.integrals(&|x| x);
        solve_two([[a, -b], [d, -e]], [force + c, moment + f])
    }

    /// Settlement and tilt with which the pressure vanishes at both ends, by the first and the last node.
    fn free(&self) -> [f64; 2] {
        let n = self.responses[0].len() - 1;
        let [one, x, f] = &self.responses;
        solve_two([[one[0], -x[0]], [one[n], -x[n]]], [f[0], f[n]])
    }
}

fn solve_two([[a, b], [c, d]]: [[f64; 2]; 2], [e, f]: [f64; 2]) -> [f64; 2] {
    let determinant = a * d - b * c;
    [(e * d - b * f) / determinant, (a * f - c * e) / determinant]
}

fn node(cells: &[[f64; 2]], i: usize) -> (f64, f64) {
    let [l, r] = cells[i / ORDER];
    let half = 0.5 * (r - l);
    (0.5 * (l + r) + half * RULE.nodes[i % ORDER], half * RULE.weights[i % ORDER])
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

/// Rows that are reduced together, so that those above them are read once for all.
const TOGETHER: usize = 8;

/// Gauss's elimination. The matrix is close to a positive one in a weighted norm: its diagonal serves as pivots.
fn eliminate(mut a: Vec<f64>, mut right: [Vec<f64>; 3]) -> [Vec<f64>; 3] {
    let n = right[0].len();
    let reduce = |(row, b): (&mut [f64], &mut [f64; 3]),
                  (pivot, c): (&[f64], &[f64; 3]),
                  k: usize| {
        let factor = row[k] / pivot[k];
        row[k..].iter_mut().zip(&pivot[k..]).for_each(|(entry, known)| *entry -= factor * known);
        b.iter_mut().zip(c).for_each(|(entry, known)| *entry -= factor * known);
    };
    let mut beside: Vec<[f64; 3]> = (0..n).map(|i| right.each_ref().map(|b| b[i])).collect();
    for first in (0..n).step_by(TOGETHER) {
        let last = n.min(first + TOGETHER);
        let (above, rest) = a.split_at_mut(first * n);
        let (known, rows) = beside.split_at_mut(first);
        for k in 0..first {
            for (row, b) in rest.chunks_mut(n).zip(&mut *rows).take(last - first) {
                reduce((row, b), (&above[k * n..(k + 1) * n], &known[k]), k);
            }
        }
        for i in 1..last - first {
            let (above, rest) = rest.split_at_mut(i * n);
            let (known, rows) = rows.split_at_mut(i);
            for k in 0..i {
                let pivot = (&above[k * n..(k + 1) * n], &known[k]);
                reduce((&mut rest[..n], &mut rows[0]), pivot, first + k);
            }
        }
    }
    for (j, b) in right.iter_mut().enumerate() {
        for k in (0..n).rev() {
            let sum: f64 = (k + 1..n).map(|j| a[k * n + j] * b[j]).sum();
            b[k] = (beside[k][j] - sum) / a[k * n + k];
        }
    }
    right
}

/// An answer that is off by `size` in its own way, and what is known of it: bounds hold, and are not idle.
fn check(
    reference: &Reference,
    profile: &Parabola,
    pieces: &[[f64; 2]],
    zones: &[[f64; 2]],
    [settlement, tilt]: [f64; 2],
    size: f64,
) -> crate::Bound {
    let truth = Density::new(reference.kernel, reference.panels(settlement, tilt));
    let sums = |u: &dyn Fn(f64) -> f64| {
        let [a, b, c] = reference.integrals(u);
        settlement * a - tilt * b - c
    };
    let (force, moment) = (sums(&|_| 1.0), sums(&|x| x));
    let pressure = |x: f64| truth.evaluate(x) * (1.0 + size * (3.0 * x + 0.4).cos());
    let is_full = zones == pieces;
    let problem = Problem {
        kernel: reference.kernel,
        ground: None,
        theta: reference.theta,
        scaled: 0.0,
        pieces,
        is_bilateral: false,
        prescribed: Prescribed { force: Some(force), moment: Some(moment) },
        profile,
        cuts: &[],
    };
    let answer = Answer {
        zones,
        pressure: &pressure,
        settlement: settlement + size,
        tilt: tilt - 0.7 * size,
        force,
        moment,
    };
    let start = std::time::Instant::now();
    let bound = audit(&problem, &answer).unwrap();
    println!(
        "{:?} theta {} full {is_full} size {size:e}: {:?} {bound:?}",
        reference.kernel,
        reference.theta,
        start.elapsed()
    );
    let mut worst = 0.0f64;
    for panel in &truth.panels {
        for (x, _) in panel.nodes() {
            worst = worst.max((pressure(x) - truth.evaluate(x)).abs());
        }
    }
    let halved = audit_on_halved_panels(&problem, &answer).unwrap();
    assert!(halved.panels > bound.panels);
    // The reference's own error is some roundings.
    let slack = 1e-13 * (1.0 + reference.theta) * truth.largest();
    assert!(bound.pressure >= worst - slack, "pressure {worst:e} {bound:?}");
    assert!(halved.pressure >= worst - slack, "pressure {worst:e} {halved:?}");
    assert!(bound.settlement >= size - slack && bound.tilt >= 0.7 * size - slack, "{bound:?}");
    if size > 1e-9 {
        assert!(
            bound.pressure <= 300.0 * (1.0 + reference.theta) * worst,
            "idle: {worst:e} {bound:?}"
        );
    }
    bound
}

#[test]
fn full_contact() {
    for (theta, kernel) in [
        (1.0, Kernel::Logarithm),
        (60.0, Kernel::Logarithm),
        (5.0, Kernel::Row { period: 3.0 }),
        (2.0, Kernel::Power { exponent: 0.3 }),
    ] {
        let profile = Parabola { c: 0.2, s: 0.1 };
        let base = [[-1.0, 1.0]];
        let reference = Reference::new(kernel, theta, &base, &|x| 0.2 * x * x + 0.1 * x);
        let state = reference.loaded(3.0, 0.1);
        for size in [0.0, 1e-8, 1e-4] {
            check(&reference, &profile, &base, &base, state, size);
        }
    }
}

#[test]
fn contact_that_lifts_off() {
    for (theta, kernel) in [
        (1.0, Kernel::Logarithm),
        (40.0, Kernel::Logarithm),
        (3.0, Kernel::Row { period: 2.5 }),
        (2.0, Kernel::Power { exponent: 0.3 }),
    ] {
        let profile = Parabola { c: 0.5, s: 0.0 };
        let zone = [[-0.4, 0.6]];
        let reference = Reference::new(kernel, theta, &zone, &|x| 0.5 * x * x);
        let state = reference.free();
        for size in [0.0, 1e-8, 1e-4] {
            let bound = check(&reference, &profile, &[[-1.0, 1.0]], &zone, state, size);
            assert!(bound.ends.is_some_and(|ends| ends < 0.1), "{bound:?}");
        }
    }
}

#[test]
fn a_pair() {
    let profile = Parabola { c: 0.1, s: 0.0 };
    let pieces = [[-1.0, -0.3], [0.3, 1.0]];
    let reference = Reference::new(Kernel::Logarithm, 7.0, &pieces, &|x| 0.1 * x * x);
    let state = reference.loaded(2.0, 0.2);
    check(&reference, &profile, &pieces, &pieces, state, 1e-7);
}

/// A cut where the base is smooth and flat: heights beside it differ by their rounding only, which is no jump that windows have to shrink to. `int ln(1/|x - s|) sqrt(1 - s^2) ds =
/// pi/2 (ln 2 + 1/2 - x^2)`.
#[test]
fn flat_places_are_no_jumps() {
    use std::f64::consts::{FRAC_PI_2, LN_2, PI};
    let theta = 2.0;
    let base = crate::closed::Base { c: 1.0, bend: theta * FRAC_PI_2, kappa: 1.0 };
    let pressure = |x: f64| ((1.0 - x) * (1.0 + x)).max(0.0).sqrt();
    let answer = Answer {
        zones: &[[-1.0, 1.0]],
        pressure: &pressure,
        settlement: theta * FRAC_PI_2 * (LN_2 + 0.5),
        tilt: 0.0,
        force: FRAC_PI_2,
        moment: 0.0,
    };
    let [whole, cut] = [&[][..], &[0.0]].map(|cuts| {
        let problem = Problem {
            kernel: Kernel::Logarithm,
            ground: None,
            theta,
            scaled: 0.0,
            pieces: &[[-1.0, 1.0]],
            is_bilateral: false,
            prescribed: Prescribed { force: Some(0.5 * PI), moment: Some(0.0) },
            profile: &base,
            cuts,
        };
        audit(&problem, &answer).unwrap()
    });
    assert!(cut.windows <= 2 * whole.windows, "{} {}", whole.windows, cut.windows);
    assert!(cut.mean_square < 1e-12 && whole.mean_square < 1e-12);
}
