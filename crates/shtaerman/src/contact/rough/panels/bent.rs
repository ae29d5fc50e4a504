//! A layer that bends, `v = p0^kappa`, on given panels: Newton's method for `v + theta0 K p(v) - sum_k mu_k c_k = b`, `int r_k p(v) = v_k`.
//!
//! `p(v)` is convex, and 0 for `v < 0`. Where a step raises `v` it is taken as one of the pressure, of which the elastic displacement is linear: else a steep law makes far too much of it. Steps are
//! cut until what is left falls.

use fredholm::multipole::{PanelCondition, PanelEquation};

use super::chart::Chart;
use super::level::{Found, Known, Task};
use crate::Error;
use crate::contact::accuracy::STAGNANT;
use crate::contact::iteration::{CUTS, STEPS};
use crate::contact::rough::extent::reference_pressure;
use crate::contact::rough::layer::FAINT;

/// Residuals of a step relative to what it is to take away: by the square of what the step before left, within these. At half or twice stated errors grow up to 1.7 times (survey).
const INEXACT: [f64; 2] = [1e-4, 0.1];

/// The solution on these panels from a start where one is known; none where steps do not end.
pub(super) fn solve(
    task: &Task<'_, '_, '_>,
    chart: &Chart,
    start: &[Option<f64>],
    known: Known<'_>,
) -> Result<Option<Found>, Error> {
    let law = task.base.layer;
    let uniform = law.displacement(reference_pressure(task.base, &task.base.whole_extent()));
    let newton = Newton { task, chart, uniform };
    let multipliers = vec![0.0; task.given.conditions.len()];
    let mut trial = newton.trial(newton.start(start, known), multipliers);
    let mut before = f64::INFINITY;
    for step in 0..STEPS {
        if !trial.norm.is_finite() {
            return Ok(None);
        }
        let size = task.norm(&trial.given);
        let tolerance = task.tolerance(size);
        let is_met = trial.norm <= tolerance || trial.norm > 0.5 * before;
        // The first step finds the multipliers.
        if step > 0 && is_met && trial.norm <= tolerance.max(STAGNANT * size) {
            return newton.found(trial).map(Some);
        }
        let [least, most] = INEXACT;
        let share = (trial.norm / before).powi(2).clamp(least, most);
        before = trial.norm;
        let change = newton.step(&trial, (share * trial.norm).max(0.3 * tolerance))?;
        let Some(next) = newton.shortened(&trial, &change, step == 0) else {
            let is_rounding = trial.norm <= STAGNANT * size;
            return if is_rounding { newton.found(trial).map(Some) } else { Ok(None) };
        };
        trial = next;
    }
    Ok(None)
}

/// A guess with what it leaves of the equations.
struct Trial {
    given: Vec<f64>,
    multipliers: Vec<f64>,
    pressures: Vec<f64>,
    /// `K p`.
    potential: Vec<f64>,
    residual: Vec<f64>,
    norm: f64,
    /// What the conditions lack, and their sizes.
    lacking: Vec<f64>,
    lack: f64,
}

/// A step.
struct Change {
    given: Vec<f64>,
    multipliers: Vec<f64>,
}

struct Newton<'n, 't, 'b, 'p> {
    task: &'n Task<'t, 'b, 'p>,
    chart: &'n Chart,
    /// What the layer gives under about the mean pressure.
    uniform: f64,
}

impl Newton<'_, '_, '_, '_> {
    /// From other panels, from cells, or uniform.
    fn start(&self, start: &[Option<f64>], known: Known<'_>) -> Vec<f64> {
        let (base, law) = (self.task.base, self.task.base.layer);
        let continued = |y: f64| {
            let xi = self.chart.place(y);
            match known {
                // On firm ground a penetration beside the zones is far more than the layer will give there.
                Known { level: Some(level), .. } => {
                    level.layer_at(xi, base.height(xi)).min(FAINT * self.uniform)
                }
                Known { coarse: Some(coarse), .. } => {
                    coarse.pressure(xi).map_or(0.0, |p| law.displacement(p.max(0.0)))
                }
                Known { .. } => self.uniform,
            }
        };
        let nodes = self.task.operator.panels().nodes();
        let values = start.iter().zip(nodes);
        values.map(|(value, y)| value.unwrap_or_else(|| continued(*y))).collect()
    }

    fn modulus(&self, given: &[f64]) -> Vec<f64> {
        given.iter().map(|v| self.task.base.layer.slope(*v)).collect()
    }

    fn trial(&self, given: Vec<f64>, multipliers: Vec<f64>) -> Trial {
        let Task { base, operator, parameter, given: asked, .. } = self.task;
        let panels = operator.panels();
        let pressures: Vec<f64> = given.iter().map(|v| base.layer.pressure(*v)).collect();
        let potential = operator.potential(&pressures);
        let mut residual: Vec<f64> = (asked.right.iter().zip(&given).zip(&potential))
            .map(|((b, v), u)| b - v - parameter * u)
            .collect();
        let (mut lacking, mut lack) = (Vec::new(), 0.0f64);
        for (condition, mu) in asked.conditions.iter().zip(&multipliers) {
            residual.iter_mut().zip(&condition.column).for_each(|(r, c)| *r += mu * c);
            let carried = |sign: fn(f64) -> f64| -> f64 {
                let values = condition.row.iter().zip(&pressures).map(|(r, p)| sign(r * p));
                let values: Vec<f64> = values.collect();
                panels.integral(&values, |_| 1.0)
            };
            let missing = condition.value - carried(|value| value);
            lack = lack.max(missing.abs() / (condition.value.abs() + carried(f64::abs)));
            lacking.push(missing);
        }
        let norm = self.task.norm(&residual);
        Trial { given, multipliers, pressures, potential, residual, norm, lacking, lack }
    }

    /// Newton's step, to this residual.
    fn step(&self, trial: &Trial, enough: f64) -> Result<Change, Error> {
        let Task { operator, parameter, given, .. } = self.task;
        let modulus = self.modulus(&trial.given);
        let groups = self.task.groups(self.chart, Some(&modulus))?;
        let conditions: Vec<PanelCondition> = (given.conditions.iter().zip(&trial.lacking))
            .map(|(condition, value)| PanelCondition { value: *value, ..condition.clone() })
            .collect();
        let equation = PanelEquation {
            operator,
            parameter: *parameter,
            weight: Some(&modulus),
            groups: &groups,
        };
        let none = vec![0.0; trial.given.len()];
        let solution = equation.solve(&trial.residual, &conditions, &none, enough)?;
        Ok(Change { given: solution.values, multipliers: solution.multipliers })
    }

    /// The longest of the halved steps that lowers what is left; the first is taken as it is where multipliers are looked for.
    fn shortened(&self, trial: &Trial, change: &Change, is_first: bool) -> Option<Trial> {
        let size = self.task.norm(&trial.given).max(f64::MIN_POSITIVE);
        let merit = |trial: &Trial| (trial.norm / size).hypot(trial.lack);
        let is_first = is_first && !change.multipliers.is_empty();
        (0..CUTS as i32).find_map(|cut| {
            let share = 0.5f64.powi(cut);
            let steps = trial.given.iter().zip(&change.given);
            let law = self.task.base.layer;
            let raised = |(v, dv): (&f64, &f64)| law.raised(*v, share * dv, self.uniform);
            let given = steps.map(raised).collect();
            // These are linear, and the first are unknown altogether.
            let share_of_all = if is_first { 1.0 } else { share };
            let steps = trial.multipliers.iter().zip(&change.multipliers);
            let multipliers = steps.map(|(mu, dmu)| mu + share_of_all * dmu).collect();
            let next = self.trial(given, multipliers);
            let falls = merit(&next) <= (1.0 - 0.1 * share) * merit(trial);
            (next.norm.is_finite() && falls).then_some(next)
        })
    }

    fn found(&self, trial: Trial) -> Result<Found, Error> {
        let modulus = self.modulus(&trial.given);
        let groups = self.task.groups(self.chart, Some(&modulus))?;
        Ok(Found {
            given: trial.given,
            pressures: trial.pressures,
            multipliers: trial.multipliers,
            potential: trial.potential,
            modulus: Some(modulus),
            groups,
        })
    }
}
