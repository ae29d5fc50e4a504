//! The equation of the second kind with conditions, by GMRES.

mod least;
mod run;
#[cfg(test)]
mod tests;

use run::Run;

use super::groups::Groups;
use super::operator::PanelOperator;
use super::threads::{each, parts_of};
use crate::Error;
use crate::linear::vector::add;

/// Most steps between two restarts, and values at nodes that their directions have: for each of three functions a quarter of a gigabyte. Most products altogether, and conditions.
const STEPS: usize = 80;
const VALUES: usize = 32_000_000;
const MOST_PRODUCTS: usize = 5 * STEPS;
const MOST_CONDITIONS: usize = 2;
/// Multiplications for each node between two products, about.
const STEP: usize = 30;
/// A residual that a restart has left no less than this share of does not fall any more.
const STAGNANT: f64 = 0.5;
/// To this share of what is added up in it a residual is rounding: that of potentials, as the tests of the operator show.
const ROUNDING: f64 = 256.0 * f64::EPSILON;

/// `phi + theta K w phi - sum_k mu_k c_k = b`, `int r_k w phi = v_k`, with a weight `w >= 0`: the modulus of a law that bends.
#[derive(Debug)]
pub struct PanelEquation<'a> {
    /// `K`.
    pub operator: &'a PanelOperator,
    /// `theta >= 0`.
    pub parameter: f64,
    /// `w` at the nodes; none for 1.
    pub weight: Option<&'a [f64]>,
    /// The approximate inverse, for the same panels or others of the same number.
    pub groups: &'a Groups,
}

/// A condition `int r w phi = v` and the column that goes with its multiplier.
#[derive(Debug, Clone)]
pub struct PanelCondition {
    /// `r` at the nodes.
    pub row: Vec<f64>,
    /// `c` at the nodes.
    pub column: Vec<f64>,
    /// `v`.
    pub value: f64,
}

/// Values at the nodes, and multipliers.
#[derive(Debug, Clone)]
pub struct PanelSolution {
    /// `phi` at the nodes.
    pub values: Vec<f64>,
    /// `mu`, one for each condition.
    pub multipliers: Vec<f64>,
    /// `K w phi` at the nodes.
    pub potential: Vec<f64>,
    /// Root of the integral of the squared residual.
    pub residual: f64,
    /// Products with the operator.
    pub products: usize,
}

/// A right-hand side with where to begin, and the norm of the residual that is small enough.
#[derive(Debug, Clone, Copy)]
pub struct PanelTask<'t> {
    /// `b` at the nodes.
    pub right: &'t [f64],
    /// `phi` at the nodes to begin with.
    pub start: &'t [f64],
    /// Root of the integral of the squared residual.
    pub tolerance: f64,
}

/// The conditions with the responses that meet them.
struct Border<'c> {
    conditions: &'c [PanelCondition],
    responses: Vec<Vec<f64>>,
    /// Inverse of `int r_i response_j`, row by row.
    inverse: Vec<f64>,
}

impl PanelCondition {
    /// `int c w phi = v` with the multiplier of `c` itself.
    #[must_use]
    pub fn symmetric(column: Vec<f64>, value: f64) -> Self {
        Self { row: column.clone(), column, value }
    }
}

impl PanelEquation<'_> {
    /// From a start, to a residual of the norm `tolerance` or to where rounding ends it.
    ///
    /// # Errors
    /// [`Error::WrongLength`] for lists that do not fit the nodes or more than two conditions, [`Error::InvalidParameter`] for conditions that depend on each other,
    /// [`Error::NotConverged`] where the residual stays above both, its numbers relative to what is added up in it.
    pub fn solve(
        &self,
        right: &[f64],
        conditions: &[PanelCondition],
        start: &[f64],
        tolerance: f64,
    ) -> Result<PanelSolution, Error> {
        let task = PanelTask { right, start, tolerance };
        let mut found = self.solve_together(&[task], conditions)?;
        Ok(found.swap_remove(0))
    }

    /// [Solves](Self::solve) for several right-hand sides under the same conditions, each to the last bit as by itself: in products taken together the operator is read once for all.
    ///
    /// # Errors
    /// Those of [`PanelEquation::solve`].
    pub fn solve_together(
        &self,
        tasks: &[PanelTask<'_>],
        conditions: &[PanelCondition],
    ) -> Result<Vec<PanelSolution>, Error> {
        for task in tasks {
            self.check(task.right, conditions, task.start)?;
        }
        let border = self.border(conditions)?;
        let mut runs: Vec<Run<'_>> =
            tasks.iter().map(|task| Run::new(self, &border, task)).collect();
        loop {
            let open = || runs.iter().filter_map(Run::wanted);
            let wanted: Vec<&[f64]> = open().collect();
            if wanted.is_empty() {
                break;
            }
            let potentials = self.potentials(&wanted);
            let mut taken: Vec<Result<(), Error>> = potentials.iter().map(|_| Ok(())).collect();
            let open = runs.iter_mut().filter(|run| run.wanted().is_some());
            let mut open: Vec<_> = open.zip(potentials).zip(&mut taken).collect();
            let work = STEP * open.len() * self.operator.panels().count();
            let share = open.len().div_ceil(parts_of(work));
            each(open.chunks_mut(share).collect(), |share| {
                for ((run, potential), taken) in share {
                    **taken = run.take(std::mem::take(potential));
                }
            });
            taken.into_iter().collect::<Result<(), Error>>()?;
        }
        Ok(runs.into_iter().map(Run::into_solution).collect())
    }

    fn check(
        &self,
        right: &[f64],
        conditions: &[PanelCondition],
        start: &[f64],
    ) -> Result<(), Error> {
        let expected = self.operator.panels().count();
        let weight = self.weight.map_or(expected, <[f64]>::len);
        let lists = [("right-hand side", right.len()), ("start", start.len()), ("weight", weight)];
        let rows = conditions.iter().map(|c| ("row of a condition", c.row.len()));
        let columns = conditions.iter().map(|c| ("column of a condition", c.column.len()));
        for (what, found) in lists.into_iter().chain(rows).chain(columns) {
            if found != expected {
                return Err(Error::WrongLength { what, found, expected });
            }
        }
        if conditions.len() > MOST_CONDITIONS {
            let found = conditions.len();
            let what = "list of conditions";
            return Err(Error::WrongLength { what, found, expected: MOST_CONDITIONS });
        }
        Ok(())
    }

    /// `int u v` over the panels.
    fn product(&self, u: &[f64], v: &[f64]) -> f64 {
        weighted(self.operator.panels().weights(), u, v)
    }

    /// `int u w v`.
    fn carried(&self, u: &[f64], v: &[f64]) -> f64 {
        match self.weight {
            None => self.product(u, v),
            Some(weight) => self.product(u, &times(weight, v)),
        }
    }

    /// `K w v` of each of these.
    fn potentials(&self, all: &[&[f64]]) -> Vec<Vec<f64>> {
        let Some(weight) = self.weight else { return self.operator.potentials(all) };
        let weighted: Vec<Vec<f64>> = all.iter().map(|values| times(weight, values)).collect();
        let weighted: Vec<&[f64]> = weighted.iter().map(Vec::as_slice).collect();
        self.operator.potentials(&weighted)
    }

    fn residual(
        &self,
        right: &[f64],
        conditions: &[PanelCondition],
        values: &[f64],
        multipliers: &[f64],
        potential: &[f64],
    ) -> Vec<f64> {
        let mut residual: Vec<f64> = (right.iter().zip(values).zip(potential))
            .map(|((b, v), u)| b - v - self.parameter * u)
            .collect();
        for (condition, mu) in conditions.iter().zip(multipliers) {
            add(&mut residual, *mu, &condition.column);
        }
        residual
    }

    /// The norms of what is added up in the residual.
    fn size(
        &self,
        right: &[f64],
        conditions: &[PanelCondition],
        values: &[f64],
        multipliers: &[f64],
        potential: &[f64],
    ) -> f64 {
        let norm = |list: &[f64]| self.product(list, list).sqrt();
        let columns = conditions.iter().zip(multipliers);
        let shifts: f64 = columns.map(|(c, mu)| mu.abs() * norm(&c.column)).sum();
        // Of a kernel with both signs the potential is less than what is added up in it.
        let sizes: Vec<f64> = values.iter().map(|value| value.abs()).collect();
        let ones = vec![1.0; sizes.len()];
        let added = norm(potential).max(self.carried(&ones, &sizes));
        norm(right) + norm(values) + self.parameter * added + shifts
    }

    fn border<'c>(&self, conditions: &'c [PanelCondition]) -> Result<Border<'c>, Error> {
        let responses: Vec<Vec<f64>> =
            conditions.iter().map(|c| self.groups.roughly_inverted(&c.column)).collect();
        let entry = |i: usize, j: usize| self.carried(&conditions[i].row, &responses[j]);
        let inverse = match conditions.len() {
            0 => Vec::new(),
            1 => vec![1.0 / entry(0, 0)],
            _ => {
                let [a, b, c, d] = [entry(0, 0), entry(0, 1), entry(1, 0), entry(1, 1)];
                let determinant = a * d - b * c;
                [d, -b, -c, a].map(|value| value / determinant).to_vec()
            }
        };
        match inverse.iter().find(|value| !value.is_finite()) {
            Some(&value) => Err(Error::InvalidParameter {
                name: "inverse of the matrix of the conditions",
                value,
                requirement: "finite: the conditions must not depend on each other",
            }),
            None => Ok(Border { conditions, responses, inverse }),
        }
    }

    /// About the solution with its multipliers, with the integrals of the conditions exactly these.
    fn roughly_inverted(
        &self,
        border: &Border<'_>,
        right: &[f64],
        integrals: &[f64],
    ) -> (Vec<f64>, Vec<f64>) {
        let mut values = self.groups.roughly_inverted(right);
        let lacking: Vec<f64> = (border.conditions.iter().zip(integrals))
            .map(|(condition, integral)| integral - self.carried(&condition.row, &values))
            .collect();
        let multipliers: Vec<f64> = (border.inverse.chunks_exact(lacking.len().max(1)))
            .map(|row| row.iter().zip(&lacking).map(|(a, b)| a * b).sum())
            .collect();
        for (response, mu) in border.responses.iter().zip(&multipliers) {
            add(&mut values, *mu, response);
        }
        (values, multipliers)
    }
}

fn times(weight: &[f64], values: &[f64]) -> Vec<f64> {
    weight.iter().zip(values).map(|(w, v)| w * v).collect()
}

fn weighted(weights: &[f64], u: &[f64], v: &[f64]) -> f64 {
    const LANES: usize = 8;
    let mut sums = [0.0; LANES];
    let (w8, w_rest) = weights.as_chunks::<LANES>();
    let (u8, u_rest) = u.as_chunks::<LANES>();
    let (v8, v_rest) = v.as_chunks::<LANES>();
    for ((w, u), v) in w8.iter().zip(u8).zip(v8) {
        for lane in 0..LANES {
            sums[lane] += w[lane] * u[lane] * v[lane];
        }
    }
    let rest: f64 = w_rest.iter().zip(u_rest).zip(v_rest).map(|((w, u), v)| w * u * v).sum();
    sums.iter().sum::<f64>() + rest
}
