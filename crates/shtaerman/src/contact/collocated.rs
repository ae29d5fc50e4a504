//! Bilateral contact by sinc collocation, independent of the spectral relation.

use fredholm::collocation::{first_half_count, rounding};
use fredholm::kernel::Logarithm;
use fredholm::{SincOperator, SincSolution};

use super::accuracy::{Accuracy, ErrorKind};
use super::balance::Balance;
use super::method::Method;
use super::parts::{Parts, Smoothness};
use super::potential::{Potential, between_nodes};
use super::resolutions::Trust;
use super::stiffness::Stiffness;
use super::{Draft, Target};
use crate::expression::Reflection;
use crate::{Error, Load, Problem, Rotational, Vertical};

/// Growth of the number of nodes from one resolution to the next.
const RATIO: f64 = std::f64::consts::SQRT_2;
/// Most nodes on either side of the middle of a panel, and of all panels together.
const MOST_HALF_COUNT: usize = 1000;
/// Differences that no longer fall and are below this share of the solution are rounding.
const STAGNANT: f64 = 1e-9;
/// Rounding of settlement, tilt, force and moment relative to their size.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Points per node at which two resolutions are compared.
const COMPARED_PER_NODE: usize = 4;

/// One resolution.
#[derive(Clone)]
struct Level {
    balance: Balance,
    state: super::balance::State,
    solution: SincSolution,
    count: usize,
}

/// Refines the nodes, on panels of these parts, until the estimate meets the target or rounding is reached.
pub(super) fn solve(problem: &Problem, parts: &Parts, target: Target) -> Result<Draft, Error> {
    let breaks = &parts.joints;
    let start = first_half_count(problem.frame().theta0());
    let most = MOST_HALF_COUNT / (breaks.len() + 1);
    let half_count = |power: i32| ((start * RATIO.powi(power)).round() as usize).clamp(4, most);
    let load = problem.dimensionless_load();
    let mut coarse = Level::new(problem, breaks, half_count(-2))?;
    let mut fine = Level::new(problem, breaks, half_count(-1))?;
    let mut before = fine.difference(&coarse);
    let mut best: Option<(Level, Accuracy)> = None;
    for power in 0.. {
        let finer = Level::new(problem, breaks, half_count(power))?;
        (coarse, fine) = (fine, finer);
        let difference = fine.difference(&coarse);
        let floor = rounding(&fine.solution);
        let accuracy = fine.accuracy(&load, [&before, &difference], floor, parts.smoothness);
        let met = fine.meets(&accuracy, target.tolerance);
        // Past the rounding floor more nodes only add noise.
        let settled = difference.pressure <= 2.0 * floor
            || (difference.pressure > 0.5 * before.pressure
                && difference.pressure <= STAGNANT * largest(&fine.solution));
        let last = half_count(power + 1) == half_count(power);
        let improves = best.as_ref().is_none_or(|(_, known)| accuracy.pressure < known.pressure);
        if improves {
            best = Some((fine.clone(), accuracy));
        }
        if met || settled || last {
            break;
        }
        before = difference;
    }
    let (level, accuracy) = best.unwrap_or_else(|| unreachable!("the first round sets it"));
    Ok(level.draft(accuracy))
}

impl Level {
    fn new(problem: &Problem, breaks: &[f64], half_count: usize) -> Result<Self, Error> {
        let operator = SincOperator::with_breaks(&Logarithm::unit(), half_count, breaks)?;
        let factor = operator.factor(problem.frame().theta0())?;
        let ones = vec![1.0; operator.count()];
        let positions: Vec<f64> = operator.positions().collect();
        let heights: Vec<f64> =
            positions.iter().map(|&xi| problem.finite_profile(xi)).collect::<Result<_, _>>()?;
        let level = factor.solve(&ones)?;
        let tilted = factor.solve(&positions)?;
        let profile = factor.solve(&heights)?;
        let balance = Balance {
            stiffness: Stiffness {
                force_settlement: level.integral(|_| 1.0),
                // The kernel is even: a level base calls for no moment.
                coupling: 0.0,
                moment_tilt: tilted.integral(|xi| xi),
            },
            free: free(&profile, problem.reflection()),
        };
        let state = balance.state(&problem.dimensionless_load());
        let combined: Vec<f64> = (positions.iter().zip(&heights))
            .map(|(xi, height)| state.settlement - state.tilt * xi - height)
            .collect();
        let solution = factor.solve(&combined)?;
        Ok(Self { balance, state, solution, count: operator.count() })
    }

    /// Differences from a coarser level, the pressure's between the nodes of both: force and end pressures converge long before it where the
    /// profile oscillates.
    fn difference(&self, coarse: &Self) -> Accuracy {
        let settlement = self.state.settlement - coarse.state.settlement;
        let tilt = self.state.tilt - coarse.state.tilt;
        let theta0 = self.solution.parameter();
        let signed = |xi: f64| {
            let potential =
                self.solution.evaluate_potential(xi) - coarse.solution.evaluate_potential(xi);
            (settlement - tilt * xi - theta0 * potential).abs()
        };
        Accuracy {
            kind: ErrorKind::Estimate,
            pressure: between_nodes(COMPARED_PER_NODE * self.count).map(signed).fold(0.0, f64::max),
            settlement: settlement.abs(),
            tilt: tilt.abs(),
            force: (self.state.force - coarse.state.force).abs(),
            moment: (self.state.moment - coarse.state.moment).abs(),
        }
    }

    /// The error of this level from its difference and the one before; none for what the load prescribes.
    fn accuracy(
        &self,
        load: &Load,
        [before, difference]: [&Accuracy; 2],
        floor: f64,
        smoothness: Smoothness,
    ) -> Accuracy {
        let largest = largest(&self.solution);
        let pressures = [before.pressure, difference.pressure];
        let trust = Trust::new(smoothness, RATIO, pressures, floor, largest);
        let of = |unknown: bool, part: fn(&Accuracy) -> f64, scale: f64, share: f64| {
            let estimate = trust.left_of_one([part(before), part(difference)], scale, share);
            if unknown { estimate.max(ROUNDING * scale) } else { 0.0 }
        };
        let displacement = self.state.settlement.abs().max(self.state.tilt.abs());
        let force = self.state.force.abs().max(self.state.moment.abs());
        let by_force = matches!(load.vertical, Vertical::Force(_));
        let by_tilt = matches!(load.rotational, Rotational::Tilt(_));
        let by_moment = matches!(load.rotational, Rotational::Moment(_));
        // Symmetry makes one of the two vanish without a word about the other.
        let displaced = |a: &Accuracy| a.settlement.max(a.tilt);
        let carried = |a: &Accuracy| a.force.max(a.moment);
        Accuracy {
            kind: ErrorKind::Estimate,
            pressure: trust.left(pressures, largest).max(floor),
            settlement: of(by_force, displaced, displacement, 1.0),
            tilt: of(!by_tilt, displaced, displacement, 1.0),
            force: of(!by_force, carried, force, 2.0),
            moment: of(!by_moment, carried, force, 2.0),
        }
    }

    fn meets(&self, accuracy: &Accuracy, tolerance: f64) -> bool {
        accuracy.relative(&self.state.sizes(largest(&self.solution))) <= tolerance
    }

    fn draft(self, accuracy: Accuracy) -> Draft {
        Draft {
            theta0: self.solution.parameter(),
            balance: self.balance,
            state: self.state,
            potential: Potential::collocated(self.solution),
            method: Method { name: "sinc", n: self.count },
            accuracy: Some(accuracy),
            edges: None,
        }
    }
}

/// Force and moment of the response to the profile; exactly zero where its symmetry is proved.
fn free(profile: &SincSolution, reflection: Reflection) -> [f64; 2] {
    [
        if reflection.is_odd { 0.0 } else { profile.integral(|_| 1.0) },
        if reflection.is_even { 0.0 } else { profile.integral(|xi| xi) },
    ]
}

fn largest(solution: &SincSolution) -> f64 {
    solution.values().iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}
