//! Integrals of the resampled pressure, and the correction that gives it the prescribed force and moment.

use crate::allowance::UNIT;
use crate::panel::Panel;
use crate::problem::{Prescribed, Problem, Refusal};
use crate::sample::adjusted;
use crate::sum::{Sum, two_product, two_sum};

/// Roundings of the parts of a moment, and of their compensated sum.
const SUMMED: f64 = 5.0;
/// A pressure of both signs is corrected in proportion to itself where its integral is at least this share of that of its size; else by a line.
const ONE_SIGN: f64 = 0.5;

/// What a last correction adds to the pressure: `psi (a + b (x - m))`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Correction {
    /// `psi = q`.
    Proportional,
    /// `psi = 1`.
    Line,
}

/// Integrals of the pressure.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shape {
    /// How force and moment are met.
    pub(crate) correction: Correction,
    /// `<1, psi>`, the mean place `m`, and `<(x - m)^2, psi>`.
    pub(crate) mass: f64,
    pub(crate) mean: f64,
    pub(crate) square: f64,
    /// The largest `|x - m|` in the zones.
    pub(crate) reach: f64,
    /// `<1, q>` and `<x, q>`, and bounds of their roundings.
    pub(crate) force: f64,
    pub(crate) moment: f64,
    pub(crate) rounding: [f64; 2],
    /// `||psi||` and `||(x - m) psi||`.
    pub(crate) norm: f64,
    pub(crate) leaning: f64,
    /// Length of the zones.
    pub(crate) length: f64,
}

impl Shape {
    pub(crate) fn new(panels: &[Panel], is_bilateral: bool) -> Self {
        let nodes: Vec<(f64, f64, f64)> = (panels.iter())
            .flat_map(|panel| panel.nodes().zip(panel.at_nodes()))
            .map(|((x, length), q)| (x, length, q))
            .collect();
        let integral = |u: &dyn Fn(f64, f64) -> f64| -> f64 {
            nodes.iter().map(|(x, length, q)| length * u(*x, *q)).sum()
        };
        let ([force, moment], turned) = loads(panels);
        let total = integral(&|_, q| q.abs());
        let mut mean = moment / force;
        let spread = |mean: f64| {
            [
                integral(&|x, q| (x - mean) * (x - mean) * q),
                integral(&|x, q| (x - mean) * (x - mean) * q.abs()),
            ]
        };
        let [around, size] = spread(mean);
        let is_one_sign = force.abs() >= ONE_SIGN * total && around.abs() >= ONE_SIGN * size;
        let correction =
            if is_one_sign || !is_bilateral { Correction::Proportional } else { Correction::Line };
        let psi = |q: f64| if correction == Correction::Line { 1.0 } else { q };
        let mass = integral(&|_, q| psi(q));
        if correction == Correction::Line {
            mean = integral(&|x, _| x) / mass;
        }
        let (first, last) = (panels[0].left, panels[panels.len() - 1].right);
        Self {
            correction,
            mass,
            mean,
            square: integral(&|x, q| (x - mean) * (x - mean) * psi(q)),
            reach: (mean - first).abs().max((last - mean).abs()),
            force,
            moment,
            rounding: [2.0 * UNIT * force.abs() + UNIT * UNIT * total, SUMMED * UNIT * turned],
            norm: integral(&|_, q| psi(q) * psi(q)).sqrt(),
            leaning: integral(&|x, q| ((x - mean) * psi(q)).powi(2)).sqrt(),
            length: panels.iter().map(|panel| panel.right - panel.left).sum(),
        }
    }
}

/// `<1, q>` and `<x, q>` from the coefficients, `int P_0 = 2` and `int t P_1 = 2/3`; and the sizes of the parts of the moment.
fn loads(panels: &[Panel]) -> ([f64; 2], f64) {
    let (mut force, mut moment, mut size) = (Sum::default(), Sum::default(), 0.0);
    for panel in panels {
        let c = &panel.coefficients;
        let (width, lost) = two_sum(panel.right, -panel.left);
        let (product, error) = two_product(c[0], width);
        force.add(product);
        force.add(error + c[0] * lost);
        for part in [panel.middle() * product, width * width * c[1] / 6.0] {
            moment.add(part);
            size += part.abs();
        }
    }
    ([force.value(), moment.value()], size)
}

/// The pressure with `psi (a + b (x - m))` added, so that it has the prescribed force and moment to rounding.
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
    let most = if shape.correction == Correction::Line { 0.5 * largest } else { 0.5 };
    if change.is_nan() || change > most {
        return Err(Refusal::LoadNotMet);
    }
    let line = [a - b * shape.mean, b];
    let panels: Vec<Panel> = (sampled.iter())
        .map(|panel| match shape.correction {
            Correction::Line => adjusted(panel, [1.0, 0.0], line),
            Correction::Proportional => adjusted(panel, [1.0 + line[0], line[1]], [0.0; 2]),
        })
        .collect();
    let shape = Shape::new(&panels, problem.is_bilateral);
    Ok((panels, shape))
}
