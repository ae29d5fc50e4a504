//! A layer that bends, `v = p0^kappa`, on given zones: Newton's method for `v + theta K p(v) = D - beta y - f0`.
//!
//! The solution is where a convex energy of the pressure is least, and Newton's step for `v` is one for that; steps are cut until the residual falls. Where a step raises `v` it is taken as
//! one of the pressure, of which the elastic displacement is linear: else a steep law makes far too much of it.

use fredholm::SincOperator;

use super::extent::reference_pressure;
use super::layer::Layer;
use super::solved::Solved;
use super::system::{Direction, Factor, Found, System};
use crate::contact::accuracy::{ROUNDING, STAGNANT};
use crate::contact::ground::Hull;
use crate::contact::iteration::{CUTS, STEPS};
use crate::{Error, Vertical};

/// What is looked for.
#[derive(Debug, Clone)]
struct Guess {
    /// `v` at the nodes.
    layer: Vec<f64>,
    /// `D` and `beta`.
    local: [f64; 2],
}

/// A guess with what it leaves of the equations.
struct Trial {
    guess: Guess,
    solution: fredholm::SincSolution,
    /// `v` less what the equation makes of it.
    residual: Vec<f64>,
    /// What the conditions of the load lack.
    lack: [f64; 2],
    merit: f64,
}

pub(super) fn solve(
    system: &System<'_, '_>,
    operator: &SincOperator,
    before: Option<&Solved>,
) -> Result<Found, Error> {
    let law = system.base.layer;
    let uniform = law.displacement(reference_pressure(system.base, &system.extent()));
    let newton = Newton { system, operator, uniform };
    if let Some(before) = before
        && let Ok(found) = newton.settle(continued(system, before), false)
    {
        return Ok(found);
    }
    let layer = vec![uniform; system.positions.len()];
    newton.settle(Guess { layer, local: [0.0; 2] }, true)
}

/// The layer of a solution on other zones or nodes; outside its zones less the gap.
fn continued(system: &System<'_, '_>, before: &Solved) -> Guess {
    let state = before.state;
    let layer = (system.positions.iter().zip(&system.heights))
        .map(|(&xi, height)| {
            if before.zones.iter().any(|zone| zone.left() <= xi && xi <= zone.right()) {
                before.layer_at(xi, *height)
            } else {
                state.settlement - state.tilt * xi - height - before.displacement_outside(xi)
            }
        })
        .collect();
    let Hull { centre, half } = system.hull;
    let gauge = system.base.theta * system.gauge() * state.force;
    Guess { layer, local: [state.settlement - state.tilt * centre + gauge, half * state.tilt] }
}

struct Newton<'s, 'b, 'p, 'o> {
    system: &'s System<'b, 'p>,
    operator: &'o SincOperator,
    /// What the layer gives under about the mean pressure.
    uniform: f64,
}

impl<'s, 'b, 'p, 'o> Newton<'s, 'b, 'p, 'o> {
    fn law(&self) -> Layer {
        self.system.base.layer
    }

    /// From a guess, whose `D` and `beta` may be unknown.
    fn settle(&self, guess: Guess, mut is_blind: bool) -> Result<Found, Error> {
        let scales = self.scales(&guess);
        let mut trial = self.trial(guess, &scales)?;
        for _ in 0..STEPS {
            let factor = self.factor(&trial.guess)?;
            let frame = self.system.frame(&factor)?;
            let (step, local) = self.step(&trial, &factor, &frame)?;
            let largest = |values: &[f64]| values.iter().fold(0.0f64, |most, v| most.max(v.abs()));
            // Rounding of all that is added up.
            let [constant, slope] = trial.guess.local;
            let size = largest(&trial.guess.layer)
                + self.system.parameter() * largest(trial.solution.potential())
                + largest(&self.system.heights)
                + constant.abs()
                + slope.abs();
            let is_still = largest(&step) <= ROUNDING * size
                || trial.merit.sqrt() * scales[2] <= ROUNDING * size;
            let next = self.shortened(&trial, &step, (local, is_blind), &scales);
            is_blind = false;
            let found = |trial: Trial, frame| Found {
                local: trial.guess.local,
                solution: trial.solution,
                frame,
            };
            let is_over = self.system.base.problem.deadline().is_past();
            match next {
                Some(next) if !is_still && !is_over => trial = next,
                Some(next) => return Ok(found(next, frame)),
                None if is_still || trial.merit.sqrt() <= STAGNANT => {
                    return Ok(found(trial, frame));
                }
                None => break,
            }
        }
        Err(fredholm::Error::NotConverged {
            iterations: STEPS,
            residual: trial.merit.sqrt(),
            tolerance: STAGNANT,
        }
        .into())
    }

    fn factor(&self, guess: &Guess) -> Result<Factor<'o>, Error> {
        let mut weights: Vec<f64> = guess.layer.iter().map(|v| self.law().slope(*v)).collect();
        if self.system.base.is_mirrored {
            // Even but for rounding: to the last bit they keep factors of half the size.
            let last = weights.len() - 1;
            for i in 0..weights.len() / 2 {
                let mean = 0.5 * (weights[i] + weights[last - i]);
                (weights[i], weights[last - i]) = (mean, mean);
            }
        }
        Ok(Factor::Weighted(self.operator.factor_weighted(self.system.parameter(), &weights)?))
    }

    /// Newton's step of the layer, and of `D` and `beta`.
    fn step(
        &self,
        trial: &Trial,
        factor: &Factor<'_>,
        frame: &[Direction; 2],
    ) -> Result<(Vec<f64>, [f64; 2]), Error> {
        let free = self.system.direction(&factor.solve(&trial.residual)?, -1.0, [0.0, 0.0]);
        let local = self.system.met(frame, &free, trial.lack)?;
        let step = (0..free.values.len())
            .map(|i| free.values[i] + local[0] * frame[0].values[i] + local[1] * frame[1].values[i])
            .collect();
        Ok((step, local))
    }

    /// The longest of the halved steps that lowers the residual; `D` and `beta`, which are linear, are taken as they are while they are unknown.
    fn shortened(
        &self,
        trial: &Trial,
        step: &[f64],
        (local, is_blind): ([f64; 2], bool),
        scales: &[f64; 3],
    ) -> Option<Trial> {
        (0..CUTS as i32).find_map(|cut| {
            let share = 0.5f64.powi(cut);
            let linear = if is_blind { 1.0 } else { share };
            let steps = trial.guess.layer.iter().zip(step);
            let guess = Guess {
                layer: steps
                    .map(|(v, dv)| self.law().raised(*v, share * dv, self.uniform))
                    .collect(),
                local: std::array::from_fn(|k| trial.guess.local[k] + linear * local[k]),
            };
            // A step too long may leave the range of double precision.
            let next = self.trial(guess, scales).ok()?;
            (next.merit <= (1.0 - 0.2 * share) * trial.merit).then_some(next)
        })
    }

    fn trial(&self, guess: Guess, scales: &[f64; 3]) -> Result<Trial, Error> {
        let system = self.system;
        let right = system.right_hand_side(guess.local);
        let pressures: Vec<f64> = guess.layer.iter().map(|v| self.law().pressure(*v)).collect();
        let solution = self.operator.response(system.parameter(), &right, &pressures)?;
        let residual: Vec<f64> =
            guess.layer.iter().zip(solution.values()).map(|(v, target)| v - target).collect();
        let reached = system.conditions(&system.direction(&solution, 1.0, guess.local));
        let prescribed = system.prescribed();
        let lack = std::array::from_fn(|k| prescribed[k] - reached[k]);
        let mean = residual.iter().map(|r| r * r).sum::<f64>() / residual.len() as f64;
        let merit = mean / scales[2].powi(2)
            + (lack[0] / scales[0]).powi(2)
            + (lack[1] / scales[1]).powi(2);
        Ok(Trial { guess, solution, residual, lack, merit })
    }

    /// What the conditions of the load and the residual are held against.
    fn scales(&self, guess: &Guess) -> [f64; 3] {
        let layer = guess.layer.iter().fold(0.0f64, |most, v| most.max(v.abs()));
        let layer = layer.max(f64::MIN_POSITIVE);
        let extent = self.system.extent();
        let force = match self.system.base.load.vertical {
            Vertical::Force(force) if force != 0.0 => force.abs(),
            _ => extent.area * self.law().pressure(layer).max(f64::MIN_POSITIVE),
        };
        let by = |is_force: bool| if is_force { force } else { layer };
        [by(self.system.is_by_force()), by(self.system.is_by_moment()), layer]
    }
}
