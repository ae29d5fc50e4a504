//! Integrals of the resampled pressure, and the correction that gives it the prescribed force and moment.

use crate::bound::{Prescribed, Problem, Refusal};
use crate::density::Panel;
use crate::sample::adjusted;

/// Integrals of the pressure.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shape {
    /// `<1, q>`, the mean place `m`, and `<(x - m)^2, q>`; of bilateral contact those of 1 instead of `q`.
    pub(crate) mass: f64,
    pub(crate) mean: f64,
    pub(crate) square: f64,
    /// The largest `|x - m|` in the zones.
    pub(crate) reach: f64,
    /// `<1, q>` and `<x, q>`.
    pub(crate) force: f64,
    pub(crate) moment: f64,
    /// Of `psi = q`, or 1 in bilateral contact: `||psi||`, `||(x - m) psi||` and `int |q|`.
    pub(crate) norm: f64,
    pub(crate) leaning: f64,
    pub(crate) total: f64,
    /// Length of the zones.
    pub(crate) length: f64,
}

impl Shape {
    pub(crate) fn new(panels: &[Panel], is_bilateral: bool) -> Self {
        let weight = |q: f64| if is_bilateral { 1.0 } else { q };
        let nodes: Vec<(f64, f64, f64)> = (panels.iter())
            .flat_map(|panel| panel.nodes().zip(panel.at_nodes()))
            .map(|((x, length), q)| (x, length, q))
            .collect();
        let integral = |u: &dyn Fn(f64, f64) -> f64| -> f64 {
            let mut sum = Sum::default();
            for &(x, length, q) in &nodes {
                sum.add(length * u(x, q));
            }
            sum.value()
        };
        let mass = integral(&|_, q| weight(q));
        let mean = integral(&|x, q| x * weight(q)) / mass;
        let (first, last) = (panels[0].left, panels[panels.len() - 1].right);
        Self {
            mass,
            mean,
            square: integral(&|x, q| (x - mean) * (x - mean) * weight(q)),
            reach: (mean - first).abs().max((last - mean).abs()),
            force: integral(&|_, q| q),
            moment: integral(&|x, q| x * q),
            norm: integral(&|_, q| weight(q) * weight(q)).sqrt(),
            leaning: integral(&|x, q| ((x - mean) * weight(q)).powi(2)).sqrt(),
            total: integral(&|_, q| q.abs()),
            length: panels.iter().map(|panel| panel.right - panel.left).sum(),
        }
    }
}

/// A sum with what its additions lose (A. Neumaier, ZAMM 54 (1974) 39).
#[derive(Default)]
struct Sum {
    value: f64,
    lost: f64,
}

impl Sum {
    fn add(&mut self, term: f64) {
        let sum = self.value + term;
        self.lost += if self.value.abs() >= term.abs() {
            (self.value - sum) + term
        } else {
            (term - sum) + self.value
        };
        self.value = sum;
    }

    fn value(&self) -> f64 {
        self.value + self.lost
    }
}

/// The pressure multiplied by `1 + a + b (x - m)`, of bilateral contact with `a + b (x - m)` added, so that it has the prescribed force and moment to rounding.
pub(crate) fn restored(
    problem: &Problem<'_>,
    sampled: &[Panel],
) -> Result<(Vec<Panel>, Shape), Refusal> {
    let shape = Shape::new(sampled, problem.is_bilateral);
    let Prescribed { force, moment } = problem.prescribed;
    let a = force.map_or(0.0, |force| (force - shape.force) / shape.mass);
    // What the first correction does to the moment.
    let turned = shape.moment + a * shape.mass * shape.mean;
    let b = moment.map_or(0.0, |moment| (moment - turned) / shape.square);
    let change = a.abs() + b.abs() * shape.reach;
    let largest = sampled.iter().fold(0.0f64, |most, panel| most.max(panel.largest));
    let most = if problem.is_bilateral { 0.5 * largest } else { 0.5 };
    if change.is_nan() || change > most {
        return Err(Refusal::LoadNotMet);
    }
    let line = [a - b * shape.mean, b];
    let panels: Vec<Panel> = (sampled.iter())
        .map(|panel| {
            if problem.is_bilateral {
                adjusted(panel, [1.0, 0.0], line)
            } else {
                adjusted(panel, [1.0 + line[0], line[1]], [0.0; 2])
            }
        })
        .collect();
    let shape = Shape::new(&panels, problem.is_bilateral);
    Ok((panels, shape))
}
