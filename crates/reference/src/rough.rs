//! The equation of a rough layer on given panels.

use faer::linalg::solvers::Solve;

use crate::grid::Grid;
use crate::panel::{BESIDE, Panel, Place};
use crate::problem::{Layer, Problem, Refusal, Rotational, Vertical};

/// Most steps of Newton's method.
const MOST_STEPS: usize = 60;
/// A step is halved at most so often.
const MOST_HALVINGS: usize = 8;

impl Problem<'_> {
    /// The pressure under which the layer gives by `v`, and its derivative: `p = max(v, 0)^(1/kappa)`, of a bilateral contact without the maximum.
    pub(crate) fn pressure(&self, v: f64) -> [f64; 2] {
        match self.layer {
            Layer::Linear if v < 0.0 && !self.is_bilateral => [0.0, 0.0],
            Layer::Linear | Layer::None => [v, 1.0],
            Layer::Power { exponent } => {
                let v = v.max(0.0);
                [v.powf(1.0 / exponent), v.powf(1.0 / exponent - 1.0) / exponent]
            }
        }
    }

    /// What is prescribed of the pressures: weights of each in the force's line and in the moment's, and what they add to.
    pub(crate) fn balances(&self, nodes: &[(Place, f64)]) -> [Option<(Vec<f64>, f64)>; 2] {
        let weigh = |part: &dyn Fn([f64; 2]) -> f64| -> Vec<f64> {
            nodes
                .iter()
                .map(|(place, weight)| weight * part(self.kernel.weights(place.x())))
                .collect()
        };
        let force = match self.vertical {
            Vertical::Force(force) => Some((weigh(&|w| w[0]), force)),
            Vertical::Settlement(_) => None,
        };
        let moment = match self.rotational {
            Rotational::Moment(moment) => Some((weigh(&|w| w[1]), moment)),
            Rotational::Eccentricity(e) => Some((weigh(&|w| w[1] - e * w[0]), 0.0)),
            Rotational::Tilt(_) => None,
        };
        [force, moment]
    }

    /// Settlement and tilt where they are prescribed.
    pub(crate) fn given(&self) -> [f64; 2] {
        let settlement = match self.vertical {
            Vertical::Settlement(settlement) => settlement,
            Vertical::Force(_) => 0.0,
        };
        let tilt = match self.rotational {
            Rotational::Tilt(tilt) => tilt,
            Rotational::Moment(_) | Rotational::Eccentricity(_) => 0.0,
        };
        [settlement, tilt]
    }
}

/// Pressures at the nodes, with respect to the variable of their chart, settlement and tilt.
#[derive(Debug, Clone)]
pub(crate) struct Solved {
    pub(crate) grid: Grid,
    pub(crate) pressures: Vec<f64>,
    pub(crate) settlement: f64,
    pub(crate) tilt: f64,
}

impl Solved {
    /// `v = delta - alpha x - f - theta K p`: what the layer gives under the pressure, less than 0 the gap.
    pub(crate) fn layer(&self, problem: &Problem<'_>, x: f64) -> f64 {
        let row = self.grid.row(&problem.kernel, Place::on_line(x));
        let potential: f64 = row.iter().zip(&self.pressures).map(|(a, p)| a * p).sum();
        problem.depth(x, self.settlement, self.tilt) - problem.theta * potential
    }
}

/// How far the pressures of two solutions differ on each panel of the second, at places all over the panel: at one they may meet by chance, at all of them not.
pub(crate) fn differences(problem: &Problem<'_>, first: &Solved, second: &Solved) -> Vec<f64> {
    let of_panel = |panel: &Panel| {
        BESIDE.iter().fold(0.0f64, |most, t| {
            let x = panel.at(*t).x();
            let [one, two] =
                [first, second].map(|solved| problem.pressure(solved.layer(problem, x))[0]);
            most.max((one - two).abs())
        })
    };
    second.grid.panels.iter().map(of_panel).collect()
}

/// Solves `v + theta K p(v) = delta - alpha x - f` at the nodes by Newton's method. Where `v` comes out negative there is no contact.
pub(crate) fn solve(problem: &Problem<'_>, grid: Grid) -> Result<Solved, Refusal> {
    let nodes = grid.nodes();
    let n = nodes.len();
    let rows: Vec<Vec<f64>> =
        nodes.iter().map(|(place, _)| grid.row(&problem.kernel, *place)).collect();
    let system = System {
        problem,
        lifts: nodes.iter().map(|(place, _)| problem.kernel.lifts(place.x())).collect(),
        heights: nodes.iter().map(|(place, _)| problem.height(place.x())).collect(),
        weights: nodes.iter().map(|(_, weight)| *weight).collect(),
        balances: problem.balances(&nodes),
        rows,
    };
    let mut unknowns = system.start();
    let mut residual = system.residual(&unknowns);
    for _ in 0..MOST_STEPS {
        let size = system.norm(&residual);
        let step = system.step(&unknowns, &residual)?;
        let mut share = 1.0;
        for halving in 0..=MOST_HALVINGS {
            let tried: Vec<f64> = unknowns.iter().zip(&step).map(|(u, s)| u - share * s).collect();
            let left = system.residual(&tried);
            if system.norm(&left) < (1.0 - 0.1 * share) * size || halving == MOST_HALVINGS {
                (unknowns, residual) = (tried, left);
                break;
            }
            share *= 0.5;
        }
        let moved = step
            .iter()
            .zip(&unknowns)
            .all(|(s, _)| s.abs() * share <= 1e-10 * system.scale(&unknowns));
        if moved && share == 1.0 || system.norm(&residual) <= 1e-16 * system.scale(&unknowns) {
            break;
        }
    }
    let pressures: Vec<f64> = unknowns[..n].iter().map(|v| problem.pressure(*v)[0]).collect();
    if !unknowns.iter().all(|u| u.is_finite()) {
        return Err(Refusal::NotFinite);
    }
    Ok(Solved { grid, pressures, settlement: unknowns[n], tilt: unknowns[n + 1] })
}

struct System<'a> {
    problem: &'a Problem<'a>,
    rows: Vec<Vec<f64>>,
    lifts: Vec<[f64; 2]>,
    heights: Vec<f64>,
    weights: Vec<f64>,
    balances: [Option<(Vec<f64>, f64)>; 2],
}

impl System<'_> {
    /// The pressure that carries the force evenly, or what the depths are.
    fn start(&self) -> Vec<f64> {
        let [settlement, tilt] = self.problem.given();
        let width: f64 = match &self.balances[0] {
            Some((weights, _)) => weights.iter().sum(),
            None => 1.0,
        };
        let even = match self.problem.vertical {
            Vertical::Force(force) => (force / width).abs(),
            Vertical::Settlement(_) => {
                (settlement - self.heights.iter().copied().fold(f64::INFINITY, f64::min)).abs()
            }
        };
        let kappa = match self.problem.layer {
            Layer::Linear | Layer::None => 1.0,
            Layer::Power { exponent } => exponent,
        };
        let v = match self.problem.vertical {
            Vertical::Force(_) => even.powf(kappa),
            Vertical::Settlement(_) => even / (1.0 + self.problem.theta),
        };
        let mut start = vec![v.max(f64::MIN_POSITIVE); self.heights.len()];
        start.extend([settlement, tilt]);
        start
    }

    fn scale(&self, unknowns: &[f64]) -> f64 {
        unknowns.iter().fold(0.0f64, |most, u| most.max(u.abs()))
    }

    fn norm(&self, residual: &[f64]) -> f64 {
        let n = self.heights.len();
        let mean: f64 = residual[..n].iter().zip(&self.weights).map(|(r, w)| w * r * r).sum();
        mean.sqrt() + residual[n].abs() + residual[n + 1].abs()
    }

    fn residual(&self, unknowns: &[f64]) -> Vec<f64> {
        let n = self.heights.len();
        let p: Vec<f64> = unknowns[..n].iter().map(|v| self.problem.pressure(*v)[0]).collect();
        let dot = |row: &[f64]| -> f64 { row.iter().zip(&p).map(|(a, p)| a * p).sum() };
        let [settlement, tilt] = [unknowns[n], unknowns[n + 1]];
        let mut left: Vec<f64> = (0..n)
            .map(|i| {
                let depth =
                    settlement * self.lifts[i][0] - tilt * self.lifts[i][1] - self.heights[i];
                unknowns[i] + self.problem.theta * dot(&self.rows[i]) - depth
            })
            .collect();
        for (k, balance) in self.balances.iter().enumerate() {
            left.push(match balance {
                Some((weights, total)) => dot(weights) - total,
                None => unknowns[n + k] - self.problem.given()[k],
            });
        }
        left
    }

    /// Newton's step.
    fn step(&self, unknowns: &[f64], residual: &[f64]) -> Result<Vec<f64>, Refusal> {
        let n = self.heights.len();
        let slopes: Vec<f64> = unknowns[..n].iter().map(|v| self.problem.pressure(*v)[1]).collect();
        let entry = |i: usize, j: usize| match (i < n, j < n) {
            (true, true) => {
                self.problem.theta * self.rows[i][j] * slopes[j] + if i == j { 1.0 } else { 0.0 }
            }
            (true, false) => {
                if j == n {
                    -self.lifts[i][0]
                } else {
                    self.lifts[i][1]
                }
            }
            (false, true) => {
                self.balances[i - n].as_ref().map_or(0.0, |(weights, _)| weights[j] * slopes[j])
            }
            (false, false) => {
                if i == j && self.balances[i - n].is_none() {
                    1.0
                } else {
                    0.0
                }
            }
        };
        solve_dense(n + 2, entry, residual)
    }
}

/// Elimination with pivots.
pub(crate) fn solve_dense(
    order: usize,
    entry: impl Fn(usize, usize) -> f64,
    right: &[f64],
) -> Result<Vec<f64>, Refusal> {
    let lu = faer::Mat::from_fn(order, order, entry).partial_piv_lu();
    let right = faer::Mat::from_fn(order, 1, |i, _| right[i]);
    let found = lu.solve(&right);
    let found: Vec<f64> = (0..order).map(|i| found[(i, 0)]).collect();
    if found.iter().all(|value| value.is_finite()) { Ok(found) } else { Err(Refusal::NotFinite) }
}
