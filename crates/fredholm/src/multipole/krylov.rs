//! The equation of the second kind with conditions, by GMRES.

use super::groups::Groups;
use super::operator::PanelOperator;
use crate::Error;
use crate::linear::vector::add;

/// Most steps between two restarts, products altogether, and conditions.
const STEPS: usize = 80;
const MOST_PRODUCTS: usize = 5 * STEPS;
const MOST_CONDITIONS: usize = 2;
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
        self.check(right, conditions, start)?;
        let border = self.border(conditions)?;
        let (mut values, mut multipliers) = (start.to_vec(), vec![0.0; conditions.len()]);
        let mut potential = self.potential(&values);
        let mut residual = self.residual(right, conditions, &values, &multipliers, &potential);
        // The first step meets the conditions, later ones keep them.
        let mut missing: Vec<f64> =
            conditions.iter().map(|c| c.value - self.carried(&c.row, &values)).collect();
        let (mut products, mut before) = (1, f64::INFINITY);
        let mut direction = residual;
        loop {
            let (step, shift) = self.roughly_inverted(&border, &direction, &missing);
            missing.fill(0.0);
            add(&mut values, 1.0, &step);
            add(&mut multipliers, 1.0, &shift);
            potential = self.potential(&values);
            products += 1;
            residual = self.residual(right, conditions, &values, &multipliers, &potential);
            let norm = self.product(&residual, &residual).sqrt();
            let falls = norm <= STAGNANT * before && products <= MOST_PRODUCTS;
            if norm > tolerance && falls {
                before = norm;
                let steps;
                (direction, steps) = self.krylov(&border, residual, norm, tolerance);
                products += steps;
                continue;
            }
            let size = self.size(right, conditions, &values, &multipliers, &potential);
            if norm.is_nan() || norm > tolerance.max(ROUNDING * size) {
                return Err(Error::NotConverged {
                    iterations: products,
                    residual: norm / size,
                    tolerance: (tolerance / size).max(ROUNDING),
                });
            }
            let residual = norm;
            return Ok(PanelSolution { values, multipliers, potential, residual, products });
        }
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

    /// `K w v`.
    fn potential(&self, values: &[f64]) -> Vec<f64> {
        match self.weight {
            None => self.operator.potential(values),
            Some(weight) => self.operator.potential(&times(weight, values)),
        }
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

    /// The combination of directions whose step leaves the least residual, before the approximate inverse; and the number of products.
    fn krylov(
        &self,
        border: &Border<'_>,
        mut residual: Vec<f64>,
        norm: f64,
        tolerance: f64,
    ) -> (Vec<f64>, usize) {
        let none = vec![0.0; border.conditions.len()];
        residual.iter_mut().for_each(|value| *value /= norm);
        let mut basis = vec![residual];
        let mut least = LeastSquares::new(norm);
        while least.residual().abs() > 0.5 * tolerance && basis.len() <= STEPS {
            let last = &basis[basis.len() - 1];
            let (step, shift) = self.roughly_inverted(border, last, &none);
            let mut next = self.potential(&step);
            next.iter_mut().zip(&step).for_each(|(u, v)| *u = v + self.parameter * *u);
            for (condition, mu) in border.conditions.iter().zip(&shift) {
                add(&mut next, -mu, &condition.column);
            }
            let mut column = Vec::with_capacity(basis.len() + 1);
            for vector in &basis {
                let part = self.product(vector, &next);
                add(&mut next, -part, vector);
                column.push(part);
            }
            let length = self.product(&next, &next).sqrt();
            column.push(length);
            least.add(column);
            if length.is_nan() || length <= 0.0 {
                break;
            }
            next.iter_mut().for_each(|value| *value /= length);
            basis.push(next);
        }
        let mut combined = vec![0.0; basis[0].len()];
        for (vector, factor) in basis.iter().zip(least.factors()) {
            add(&mut combined, factor, vector);
        }
        (combined, least.columns.len())
    }
}

/// The small least-squares problem of GMRES, by Givens rotations.
struct LeastSquares {
    /// Columns of the triangle.
    columns: Vec<Vec<f64>>,
    rotations: Vec<[f64; 2]>,
    right: Vec<f64>,
}

impl LeastSquares {
    fn new(norm: f64) -> Self {
        Self { columns: Vec::new(), rotations: Vec::new(), right: vec![norm] }
    }

    fn residual(&self) -> f64 {
        self.right[self.right.len() - 1]
    }

    fn add(&mut self, mut column: Vec<f64>) {
        for (k, [c, s]) in self.rotations.iter().enumerate() {
            let [above, below] = [column[k], column[k + 1]];
            (column[k], column[k + 1]) = (c * above + s * below, c * below - s * above);
        }
        let last = column.len() - 2;
        let radius = column[last].hypot(column[last + 1]);
        let [c, s] = if radius > 0.0 {
            [column[last] / radius, column[last + 1] / radius]
        } else {
            [1.0, 0.0]
        };
        column.pop();
        column[last] = radius;
        self.columns.push(column);
        self.rotations.push([c, s]);
        let residual = self.right[last];
        self.right[last] = c * residual;
        self.right.push(-s * residual);
    }

    fn factors(&self) -> Vec<f64> {
        let count = self.columns.len();
        let mut factors = self.right[..count].to_vec();
        for k in (0..count).rev() {
            let pivot = self.columns[k][k];
            factors[k] = if pivot > 0.0 { factors[k] / pivot } else { 0.0 };
            for i in 0..k {
                factors[i] -= self.columns[k][i] * factors[k];
            }
        }
        factors
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

#[cfg(test)]
mod tests;
