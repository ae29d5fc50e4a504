//! A layer that bends, `v = p0^kappa`, on given zones: Newton's method for `v + theta K p(v) = D - beta y - f0`.
//!
//! The solution is where a convex energy of the pressure is least, and Newton's step for `v` is one for that; steps are cut until the residual falls.
//! Where they stall the exponent is approached in stages from 1.

use fredholm::SincOperator;

use super::extent::reference_pressure;
use super::layer::Layer;
use super::solved::Solved;
use super::system::{Direction, Factor, Found, System};
use crate::contact::ground::Hull;
use crate::{Error, Vertical};

/// Most steps at one exponent.
const STEPS: usize = 80;
/// A step cut this often leads nowhere.
const CUTS: i32 = 12;
/// Stages on the way from the linear layer where the direct way fails.
const STAGES: [i32; 3] = [1, 6, 24];
/// A change of the layer this small beside its size and that of the displacements is rounding.
const STILL: f64 = 32.0 * f64::EPSILON;
/// A residual this small beside its terms is rounding.
const EXACT: f64 = 16.0 * f64::EPSILON;
/// A residual below this share of its scale, which does not fall any more, is rounding.
const SMALL: f64 = 1e-20;

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
    let layer = system.base.layer;
    if let Some(before) = before
        && let Ok(found) = Newton::new(system, operator, layer).settle(continued(system, before))
    {
        return Ok(found);
    }
    for stages in STAGES {
        if let Ok(found) = in_stages(system, operator, stages) {
            return Ok(found);
        }
    }
    let iterations = STEPS * STAGES.iter().sum::<i32>() as usize;
    let tolerance = SMALL.sqrt();
    Err(fredholm::Error::NotConverged { iterations, residual: f64::NAN, tolerance }.into())
}

/// From the linear layer of the same compliance under the mean pressure, by exponents in geometric steps.
fn in_stages(
    system: &System<'_, '_>,
    operator: &SincOperator,
    stages: i32,
) -> Result<Found, Error> {
    let layer = system.base.layer;
    let stage =
        |k: i32| layer.with_exponent(layer.exponent().powf(f64::from(k) / f64::from(stages)));
    let pressure = reference_pressure(system.base, &system.zones_extent());
    let mut guess = linear(system, operator, pressure)?;
    // Pressures stay as they are from one exponent to the next.
    let mut known = layer.with_exponent(1.0);
    let mut found = None;
    for k in 1..=stages {
        let next = if k == stages { layer } else { stage(k) };
        for v in &mut guess.layer {
            *v = if *v > 0.0 { next.displacement(known.pressure(*v)) } else { *v };
        }
        let settled = Newton::new(system, operator, next).settle(guess.clone())?;
        guess = Guess { layer: settled.solution.values().to_vec(), local: settled.local };
        (known, found) = (next, Some(settled));
    }
    found.ok_or_else(|| system.singular())
}

/// The linear layer `v = c p`, `c = p_r^(kappa - 1)`, with its pressures as `v`.
fn linear(system: &System<'_, '_>, operator: &SincOperator, pressure: f64) -> Result<Guess, Error> {
    let compliance = pressure.powf(system.base.layer.exponent() - 1.0);
    let factor = Factor::Linear(operator.factor(system.parameter() / compliance)?);
    let frame = system.frame(&factor)?;
    // Pressures for the unit of D are those of 1/c: the change of units is one of D and beta.
    let scaled: [Direction; 2] = frame.map(|direction| direction.per(compliance));
    let heights: Vec<f64> = system.heights.iter().map(|height| height / compliance).collect();
    let given = system.direction(&factor.solve(&heights)?, -1.0, [0.0, 0.0]);
    let local = system.balanced(&scaled, &given)?;
    let right: Vec<f64> =
        system.right_hand_side(local).into_iter().map(|value| value / compliance).collect();
    Ok(Guess { layer: factor.solve(&right)?.values().to_vec(), local })
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
    layer: Layer,
}

impl<'s, 'b, 'p, 'o> Newton<'s, 'b, 'p, 'o> {
    fn new(system: &'s System<'b, 'p>, operator: &'o SincOperator, layer: Layer) -> Self {
        Self { system, operator, layer }
    }

    fn settle(&self, guess: Guess) -> Result<Found, Error> {
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
            let is_still =
                largest(&step) <= STILL * size || trial.merit.sqrt() * scales[2] <= EXACT * size;
            let next = self.shortened(&trial, &step, local, &scales)?;
            let found = |trial: Trial, frame| Found {
                local: trial.guess.local,
                solution: trial.solution,
                frame,
            };
            match next {
                Some(next) if !is_still => trial = next,
                Some(next) => return Ok(found(next, frame)),
                None if is_still || trial.merit <= SMALL => return Ok(found(trial, frame)),
                None => break,
            }
        }
        Err(fredholm::Error::NotConverged {
            iterations: STEPS,
            residual: trial.merit.sqrt(),
            tolerance: SMALL.sqrt(),
        }
        .into())
    }

    fn factor(&self, guess: &Guess) -> Result<Factor<'o>, Error> {
        let mut weights: Vec<f64> = guess.layer.iter().map(|v| self.layer.slope(*v)).collect();
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

    /// The longest of the halved steps that lowers the residual.
    fn shortened(
        &self,
        trial: &Trial,
        step: &[f64],
        local: [f64; 2],
        scales: &[f64; 3],
    ) -> Result<Option<Trial>, Error> {
        for cut in 0..CUTS {
            let share = 0.5f64.powi(cut);
            let guess = Guess {
                layer: trial.guess.layer.iter().zip(step).map(|(v, dv)| v + share * dv).collect(),
                local: std::array::from_fn(|k| trial.guess.local[k] + share * local[k]),
            };
            let next = self.trial(guess, scales);
            // A step too long may leave the range of double precision.
            if let Ok(next) = next
                && next.merit <= (1.0 - 0.2 * share) * trial.merit
            {
                return Ok(Some(next));
            }
        }
        Ok(None)
    }

    fn trial(&self, guess: Guess, scales: &[f64; 3]) -> Result<Trial, Error> {
        let system = self.system;
        let right = system.right_hand_side(guess.local);
        let pressures: Vec<f64> = guess.layer.iter().map(|v| self.layer.pressure(*v)).collect();
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
        let extent = self.system.zones_extent();
        let force = match self.system.base.load.vertical {
            Vertical::Force(force) if force != 0.0 => force.abs(),
            _ => extent.area * self.layer.pressure(layer).max(f64::MIN_POSITIVE),
        };
        let by = |is_force: bool| if is_force { force } else { layer };
        [by(self.system.is_by_force()), by(self.system.is_by_moment()), layer]
    }
}
