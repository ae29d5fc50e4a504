//! The equation on given nodes under the load: at once for a linear layer, by Newton's method for one that bends.
//!
//! `v + theta K p(v) = D - beta y - f0` with `v = p0^kappa` is where a convex energy of the pressure is least, and Newton's step for `v` is one for that; steps are cut until the residual
//! falls. Where a step raises `v` it is taken as one of the pressure, of which the elastic displacement is linear: else a steep law makes far too much of it.

use super::frame::Direction;
use super::layer::{FAINT, Layer, reference_pressure};
use super::nodes::{Discrete, Field, Pressed, Step, Task};
use super::solved::{Solved, largest};
use crate::Error;
use crate::contact::accuracy::{ROUNDING, STAGNANT};
use crate::line_search::{CUTS, STEPS};

/// Residuals of a step relative to what it is to take away: by the square of what the step before left, within these (survey).
const INEXACT: [f64; 2] = [1e-4, 0.1];
/// The share of a step by which it has to lower what is left (Armijo's condition).
const DESCENT: f64 = 0.1;

/// What the layer gives at the nodes where a solution begins, and `D` and `beta` where these are known.
struct Start {
    layer: Vec<f64>,
    local: Option<[f64; 2]>,
}

/// A solution with the inverse that belongs to it.
pub(super) struct Found<'o, D: Discrete + 'o> {
    pub(super) step: Step<D::Pressure>,
    pub(super) inverse: D::Inverse<'o>,
}

/// The solution, perhaps from one nearby.
///
/// # Errors
/// Those of the discretisation; [`Error::Equation`] where steps do not end.
pub(super) fn solve<'o, D: Discrete>(
    on: &'o D,
    near: Option<&Solved<D::Field>>,
) -> Result<Found<'o, D>, Error> {
    let near = near.map(|near| continued(on, near));
    if on.base().layer.is_linear() {
        return linear(on, near);
    }
    let newton = Newton::new(on);
    if let Some(near) = near
        && let Ok(found) = newton.settle(near)
    {
        return Ok(found);
    }
    let layer = vec![newton.uniform; on.nodes().places.len()];
    newton.settle(Start { layer, local: None })
}

/// The layer of a solution on other zones or nodes; beside its zones less the gap, but no penetration, which on firm ground is far more than the layer will give.
fn continued<D: Discrete>(on: &D, near: &Solved<D::Field>) -> Start {
    let (nodes, most) = (on.nodes(), FAINT * near.deepest());
    let known = near.field.interpolated(&near.given, &nodes.places);
    let layer = (nodes.places.iter().zip(&nodes.heights).zip(known))
        .map(|((&xi, height), known)| match known {
            Some(known) => known,
            None if near.nodes.zone(xi).is_some() => near.layer_at(xi, *height),
            None => near.layer_at(xi, *height).min(most),
        })
        .collect();
    Start { layer, local: Some(nodes.frame.local_of(&near.state)) }
}

fn linear<D: Discrete>(on: &D, near: Option<Start>) -> Result<Found<'_, D>, Error> {
    let frame = &on.nodes().frame;
    let local = frame.start();
    let right = on.nodes().right(local);
    let start = near.map(|near| near.layer);
    // At least the norm of a uniform pressure.
    let area = on.base().area(on.nodes().zones.iter().map(|zone| zone.ends));
    let uniform = frame.force().map_or(0.0, |force| force / area);
    let near = start.as_ref().map_or(0.0, |start| on.norm(start));
    let size = [near, uniform, on.norm(&right)].into_iter().find(|size| *size > 0.0);
    let residual = on.residual() * size.unwrap_or(1.0);
    on.base().problem().deadline().spend(on.work());
    let inverse = on.inverse(None)?;
    let lack = frame.lack(&Direction { local, carried: [0.0; 2] });
    let task = Task { right: &right, lack, start: start.as_deref(), residual };
    let mut step = on.solve(&inverse, task)?;
    step.local = [0, 1].map(|k| step.local[k] + local[k]);
    Ok(Found { step, inverse })
}

/// A guess with what it leaves of the equations.
struct Trial<P> {
    layer: Vec<f64>,
    local: [f64; 2],
    pressed: Pressed<P>,
    /// What the equation makes of `v`, less `v`.
    residual: Vec<f64>,
    /// What the conditions of the load lack.
    lack: [f64; 2],
    /// The norms of both over their scales.
    merit: f64,
}

struct Newton<'o, D> {
    on: &'o D,
    law: Layer,
    /// What the layer gives under about the mean pressure.
    uniform: f64,
}

impl<'o, D: Discrete> Newton<'o, D> {
    fn new(on: &'o D) -> Self {
        let (base, zones) = (on.base(), on.nodes().zones.iter().map(|zone| zone.ends));
        let uniform = base.layer.displacement(reference_pressure(base, zones));
        Self { on, law: base.layer, uniform }
    }

    fn settle(&self, start: Start) -> Result<Found<'o, D>, Error> {
        let Start { layer, local } = start;
        // Displacements that are unknown altogether are taken as the first step finds them, being linear.
        let mut is_blind = local.is_none();
        let scales = self.scales(&layer);
        let local = local.unwrap_or_else(|| self.on.nodes().frame.start());
        let mut trial = self.trial(layer, local, &scales)?;
        let mut before = f64::INFINITY;
        for _ in 0..STEPS {
            let size = self.size(&trial);
            let enough = (self.on.residual() * self.on.norm(&trial.layer)).max(ROUNDING * size);
            let small = STAGNANT * size;
            // With what the load lacks: where the body gives nothing the layer alone leaves nothing.
            let left = trial.merit * scales[2];
            let is_met = left <= enough || left > 0.5 * before && left <= small;
            let deadline = self.on.base().problem().deadline();
            deadline.spend(self.on.work());
            // What is carried over from other nodes is no solution on these before a step was taken.
            let is_carried = before.is_infinite();
            if !is_blind && (is_met && !is_carried || deadline.is_past()) {
                return self.found(trial);
            }
            let [least, most] = INEXACT;
            let share = (left / before).powi(2).clamp(least, most);
            before = left;
            let inverse = self.on.inverse(Some(self.slopes(&trial)))?;
            let residual = (share * left).max(0.5 * enough);
            let Trial { residual: right, lack, .. } = &trial;
            let task = Task { right, lack: *lack, start: None, residual };
            let step = self.on.solve(&inverse, task)?;
            match self.shortened(&trial, &step, is_blind, &scales) {
                Some(next) => trial = next,
                // Where the first step is no guide, the settlement begins with what leaves nothing in the mean.
                None if is_blind && self.on.nodes().frame.is_by_force() => {
                    let Trial { layer, local, residual, .. } = trial;
                    let mean = residual.iter().sum::<f64>() / residual.len() as f64;
                    trial = self.trial(layer, [local[0] - mean, local[1]], &scales)?;
                }
                None if left <= small => return self.found(trial),
                None => break,
            }
            is_blind = false;
        }
        let (residual, tolerance) = (trial.merit, STAGNANT);
        Err(fredholm::Error::NotConverged { iterations: STEPS, residual, tolerance }.into())
    }

    fn slopes(&self, trial: &Trial<D::Pressure>) -> Vec<f64> {
        trial.layer.iter().map(|v| self.law.slope(*v)).collect()
    }

    fn found(&self, trial: Trial<D::Pressure>) -> Result<Found<'o, D>, Error> {
        let inverse = self.on.inverse(Some(self.slopes(&trial)))?;
        let Trial { layer, local, pressed, .. } = trial;
        Ok(Found { step: Step { layer, local, pressed }, inverse })
    }

    /// The norm of all that is added up in the residual.
    fn size(&self, trial: &Trial<D::Pressure>) -> f64 {
        let values = [&trial.layer, &trial.pressed.displaced, &self.on.nodes().heights];
        let local: f64 = trial.local.iter().map(|part| part.abs()).sum();
        let added: f64 = values.into_iter().map(|values| largest(values)).sum();
        added + local
    }

    /// The longest of the halved steps that lowers what is left.
    fn shortened(
        &self,
        trial: &Trial<D::Pressure>,
        step: &Step<D::Pressure>,
        is_blind: bool,
        scales: &[f64; 3],
    ) -> Option<Trial<D::Pressure>> {
        (0..CUTS as i32).find_map(|cut| {
            let share = 0.5f64.powi(cut);
            let linear = if is_blind { 1.0 } else { share };
            let raised = |(v, dv): (&f64, &f64)| self.law.raised(*v, share * dv, self.uniform);
            let layer = trial.layer.iter().zip(&step.layer).map(raised).collect();
            let local = [0, 1].map(|k| trial.local[k] + linear * step.local[k]);
            // A step too long may leave the range of double precision.
            let next = self.trial(layer, local, scales).ok()?;
            (next.merit <= (1.0 - DESCENT * share) * trial.merit).then_some(next)
        })
    }

    fn trial(
        &self,
        layer: Vec<f64>,
        local: [f64; 2],
        scales: &[f64; 3],
    ) -> Result<Trial<D::Pressure>, Error> {
        let nodes = self.on.nodes();
        let pressed = self.on.pressed(layer.iter().map(|v| self.law.pressure(*v)).collect())?;
        let right = nodes.right(local);
        let residual: Vec<f64> = (right.iter().zip(&pressed.displaced).zip(&layer))
            .map(|((right, displaced), v)| right - displaced - v)
            .collect();
        let lack = nodes.frame.lack(&Direction { local, carried: pressed.carried });
        let [vertical, rotational, size] = *scales;
        let norm = self.on.norm(&residual) / size;
        let merit = norm.hypot(lack[0] / vertical).hypot(lack[1] / rotational);
        Ok(Trial { layer, local, pressed, residual, lack, merit })
    }

    /// What the conditions of the load and the residual are held against.
    fn scales(&self, layer: &[f64]) -> [f64; 3] {
        let nodes = self.on.nodes();
        let layer = largest(layer).max(f64::MIN_POSITIVE);
        let force = nodes.frame.force().filter(|force| *force != 0.0).map(f64::abs);
        let force = force.unwrap_or_else(|| {
            let area = self.on.base().area(nodes.zones.iter().map(|zone| zone.ends));
            area * self.law.pressure(layer).max(f64::MIN_POSITIVE)
        });
        let by = |is_force: bool| if is_force { force } else { layer };
        let frame = &nodes.frame;
        [by(frame.is_by_force()), by(frame.is_by_moment()), layer]
    }
}
