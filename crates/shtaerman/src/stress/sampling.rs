//! As many nodes as the pressure needs.

use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::PI;

use super::complex::Complex;
use super::panel::Panel;
use crate::Error;
use crate::golden::GOLDEN;

/// The least first step: `e^(-pi^2/h) = 5e-16` is its error where the pressure is analytic off the line of the panel.
const FIRST_STEP: f64 = 0.28;
/// Difference of both sets of nodes, relative to the mean pressure, that is small enough, and below which it may be rounding.
const AIM: f64 = 2e-14;
const STAGNANT: f64 = 1e-8;
/// A difference that does not fall to this share has stopped to fall.
const FALL: f64 = 0.5;
/// The largest accuracy for which the rate of convergence says anything.
const LARGEST: f64 = 1e-3;
/// How far sampling goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    /// An error that is small enough.
    pub(super) enough: f64,
    /// The same as a share of the mean pressure.
    pub(super) accuracy: f64,
    /// Most nodes of one panel, and most of all together unless each has its first.
    pub(super) most: usize,
}

impl Effort {
    /// As far as it leads.
    pub(super) const FULL: Self = Self { enough: 0.0, accuracy: 0.0, most: 16_384 };

    /// The step of the first nodes.
    fn first_step(self) -> f64 {
        (PI * PI / -self.accuracy.clamp(f64::MIN_POSITIVE, LARGEST).ln()).max(FIRST_STEP)
    }
}

/// Test points: as far out, and how many along and up.
const OUTERMOST: f64 = 30.0;
const ALONG: usize = 24;
const ANGLES: [f64; 3] = [0.0, 0.3, 1.2];
/// And how many on the surface, evenly: a trace bends at each of its points.
const ACROSS: usize = 256;

type Pressure<'f> = &'f dyn Fn(usize, f64, f64) -> f64;

/// The panels, sampled, and the estimated error of their stresses.
pub(super) fn resolved(
    panels: &[[f64; 2]],
    period: Option<f64>,
    effort: Effort,
    pressure: Pressure<'_>,
) -> Result<(Vec<Panel>, f64), Error> {
    // Of the nodes of half the step every second is one of the step before, to the last bit.
    let known = RefCell::new(HashMap::new());
    let sample = |index: usize, step: f64| {
        Panel::new(panels[index], step, period, &|left, right| {
            let place = (index, left.to_bits(), right.to_bits());
            *known.borrow_mut().entry(place).or_insert_with(|| pressure(index, left, right))
        })
    };
    let first = effort.first_step();
    let mut sampled =
        (0..panels.len()).map(|index| sample(index, first)).collect::<Result<Vec<_>, _>>()?;
    let length: f64 = sampled.iter().map(Panel::length).sum();
    let mean = sampled.iter().map(Panel::absolute_force).sum::<f64>() / length;
    if !mean.is_finite() {
        return Err(Error::Overflow { quantity: "mean pressure", value: mean });
    }
    let mut error = 0.0;
    if mean > 0.0 {
        let most = effort.most / panels.len();
        let aim = AIM.max(effort.accuracy).max(effort.enough / (mean * panels.len() as f64));
        for (index, panel) in sampled.iter_mut().enumerate() {
            error += refine(panel, [mean, aim], most, |step| sample(index, step))?;
        }
    }
    Ok((sampled, error * mean))
}

/// Halves the step until two sets of nodes agree; the difference that is left.
fn refine(
    panel: &mut Panel,
    [scale, aim]: [f64; 2],
    most: usize,
    sample: impl Fn(f64) -> Result<Panel, Error>,
) -> Result<f64, Error> {
    let mut error = difference(panel, scale);
    let (mut step, mut nodes) = (panel.step(), panel.nodes());
    while error > aim && 2 * nodes <= most {
        // The step falls also where the finer nodes were no better: waves may be missed by several.
        step *= 0.5;
        let finer = sample(step)?;
        nodes = finer.nodes();
        let left = difference(&finer, scale);
        let stopped = left > FALL * error && error < STAGNANT;
        if left < error {
            error = left;
            *panel = finer;
        }
        if stopped {
            break;
        }
    }
    Ok(error)
}

/// The largest difference of both sets of nodes, at places between the nodes of either.
fn difference(panel: &Panel, scale: f64) -> f64 {
    let step = panel.step();
    let outermost = (OUTERMOST / step) as i64;
    let stride = (2 * outermost / ALONG as i64).max(1);
    let along = (-outermost..=outermost).step_by(stride as usize);
    let at = |index: f64, angle: f64| Complex::new((index + 0.25) * step, angle);
    let inside = along.flat_map(|index| ANGLES.map(|angle| at(index as f64, angle)));
    let count = (panel.nodes() / 2).min(ACROSS);
    let across = (0..count).map(|k| {
        let share = (k as f64 + GOLDEN) / count as f64;
        at(((share / (1.0 - share)).ln() / step).floor(), 0.0)
    });
    let differences = inside.chain(across).map(|tau| panel.grid_difference(tau, scale));
    differences.fold(0.0, f64::max)
}
