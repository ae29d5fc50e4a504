//! Which components are positive: a primal-dual active set method, made safe by a primal one.

use crate::Error;
use crate::linear::{Factored, dot};

/// Most exchanges of the primal-dual method before the safe one takes over: it needs about ten where it converges.
const MOST_EXCHANGES: usize = 40;
/// Most steps of the safe one for each component, and some more (survey of 307: one at most; what takes more comes and goes by rounding).
const MOST_STEPS: [usize; 2] = [3, 100];
/// A component or multiplier this small, relative to the largest, has no sign.
const NO_SIGN: f64 = 1e-13;

/// A condition `row . z = value` with the column `c` by which its multiplier enters the equations.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    /// `r`.
    pub row: Vec<f64>,
    /// `c`; where it equals the row the problem is one of least energy, and has one solution.
    pub column: Vec<f64>,
    /// `v`.
    pub value: f64,
}

/// The matrix `1 + theta S` of a complementarity problem.
#[derive(Debug, Clone)]
pub struct Complementarity {
    order: usize,
    matrix: Vec<f64>,
    parameter: f64,
}

/// What a complementarity problem leads to.
#[derive(Debug, Clone, PartialEq)]
pub struct ComplementaritySolution {
    /// `z >= 0`.
    pub values: Vec<f64>,
    /// `mu`, one for each condition.
    pub multipliers: Vec<f64>,
    /// Systems solved.
    pub iterations: usize,
}

/// The solution with `z = 0` outside a set.
struct Restricted {
    values: Vec<f64>,
    multipliers: Vec<f64>,
}

impl Complementarity {
    /// For a symmetric positive matrix `S` with all its entries, and `theta >= 0`.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless the matrix is square, [`Error::InvalidParameter`] for a parameter that is negative or not finite.
    pub fn new(matrix: Vec<f64>, parameter: f64) -> Result<Self, Error> {
        let order = matrix.len().isqrt();
        if order * order != matrix.len() || order == 0 {
            let expected = (order + 1) * (order + 1);
            return Err(Error::WrongLength { what: "matrix", found: matrix.len(), expected });
        }
        if !(parameter >= 0.0 && parameter.is_finite()) {
            return Err(Error::InvalidParameter {
                name: "parameter",
                value: parameter,
                requirement: "finite and not negative",
            });
        }
        Ok(Self { order, matrix, parameter })
    }

    /// Solves for the right-hand side `b`, beginning with the components of `start`.
    ///
    /// `feasible`, a `z >= 0` that meets the conditions, is where the safe method begins. That one lowers the energy at each step, and so ends, where all
    /// columns equal their rows.
    ///
    /// # Errors
    /// [`Error::WrongLength`] for lists that are not as long as the matrix is wide, [`Error::NotPositiveDefinite`] when a matrix cannot be factored,
    /// [`Error::NotConverged`] when both methods stop short.
    pub fn solve(
        &self,
        right: &[f64],
        conditions: &[Condition],
        start: &[bool],
        feasible: &[f64],
    ) -> Result<ComplementaritySolution, Error> {
        self.solve_until(&|_| false, right, conditions, start, feasible)
    }

    /// The same; where the safe method is needed, which can take many steps, and `is_over`, asked with the order of each system that was solved, says meanwhile that there is no more time for it, what it has come to: `z >= 0` that meets
    /// the conditions.
    ///
    /// # Errors
    /// Those of [`Complementarity::solve`].
    pub fn solve_until(
        &self,
        is_over: &dyn Fn(usize) -> bool,
        right: &[f64],
        conditions: &[Condition],
        start: &[bool],
        feasible: &[f64],
    ) -> Result<ComplementaritySolution, Error> {
        let lists = [right.len(), start.len(), feasible.len()];
        let rows = conditions.iter().flat_map(|c| [c.row.len(), c.column.len()]);
        if let Some(found) = lists.into_iter().chain(rows).find(|&found| found != self.order) {
            return Err(Error::WrongLength { what: "list", found, expected: self.order });
        }
        let problem = Problem { matrix: self, right, conditions };
        match problem.exchanged(start)? {
            Some(solution) => Ok(solution),
            None => problem.descended(feasible, is_over),
        }
    }

    /// `(1 + theta S) z`.
    fn product(&self, z: &[f64]) -> Vec<f64> {
        let rows = self.matrix.chunks_exact(self.order);
        rows.zip(z).map(|(row, z_i)| z_i + self.parameter * dot(row, z)).collect()
    }
}

struct Problem<'p> {
    matrix: &'p Complementarity,
    right: &'p [f64],
    conditions: &'p [Condition],
}

impl Problem<'_> {
    /// Each step solves on the set, drops what pulls and takes in what penetrates: ends after few steps, or circles (`None`).
    fn exchanged(&self, start: &[bool]) -> Result<Option<ComplementaritySolution>, Error> {
        let mut set = start.to_vec();
        let mut seen: Vec<Vec<bool>> = Vec::new();
        for iterations in 1..=MOST_EXCHANGES {
            let Some(Restricted { values, multipliers }) = self.restricted(&set)? else {
                return Ok(None);
            };
            let excess = self.excess(&values, &multipliers);
            let next: Vec<bool> = (0..set.len())
                .map(|i| if set[i] { values[i] > 0.0 } else { excess.below(i) })
                .collect();
            if next == set {
                return Ok(Some(ComplementaritySolution { values, multipliers, iterations }));
            }
            seen.push(set);
            if seen.contains(&next) {
                return Ok(None);
            }
            set = next;
        }
        Ok(None)
    }

    /// The primal active set method: from a point that meets the conditions, towards the solution on the set as far as signs
    /// allow; a component that becomes zero leaves, and when the solution is reached all that penetrate come in.
    fn descended(
        &self,
        feasible: &[f64],
        is_over: &dyn Fn(usize) -> bool,
    ) -> Result<ComplementaritySolution, Error> {
        let mut z = feasible.to_vec();
        let mut set: Vec<bool> = z.iter().map(|z| *z > 0.0).collect();
        let most = MOST_STEPS[0] * self.matrix.order + MOST_STEPS[1];
        let mut left = f64::INFINITY;
        for iterations in 1..=most {
            let Some(Restricted { values, multipliers }) = self.restricted(&set)? else { break };
            if is_over(set.iter().filter(|is_in| **is_in).count()) {
                return Ok(ComplementaritySolution { values: z, multipliers, iterations });
            }
            // Those that came in at zero and would become negative are sent back at once.
            let blocked: Vec<usize> =
                (0..z.len()).filter(|&i| set[i] && z[i] == 0.0 && values[i] < 0.0).collect();
            if !blocked.is_empty() {
                blocked.into_iter().for_each(|i| set[i] = false);
                continue;
            }
            let step = (0..z.len())
                .filter(|&i| set[i] && values[i] < 0.0)
                .map(|i| z[i] / (z[i] - values[i]))
                .fold(1.0, f64::min);
            if step < 1.0 {
                for i in 0..z.len() {
                    let blocks = values[i] < 0.0 && z[i] / (z[i] - values[i]) <= step;
                    z[i] = if blocks { 0.0 } else { z[i] + step * (values[i] - z[i]) };
                    set[i] &= !blocks;
                }
                continue;
            }
            z = values;
            let excess = self.excess(&z, &multipliers);
            let mut added: Vec<usize> =
                (0..z.len()).filter(|&i| !set[i] && excess.below(i)).collect();
            if added.is_empty() {
                return Ok(ComplementaritySolution { values: z, multipliers, iterations });
            }
            // One at a time towards the end: rounding can make many come and go.
            if iterations > most / 2 {
                added.sort_by(|&i, &j| excess.values[i].total_cmp(&excess.values[j]));
                added.truncate(1);
            }
            left = left.min(added.iter().fold(0.0, |most, &i| most.max(excess.below_by(i))));
            added.into_iter().for_each(|i| set[i] = true);
        }
        Err(Error::NotConverged { iterations: most, residual: left, tolerance: NO_SIGN })
    }

    /// `w` with the size of its terms.
    fn excess(&self, z: &[f64], multipliers: &[f64]) -> Excess {
        let mut values = self.matrix.product(z);
        let mut size = 0.0f64;
        for (i, value) in values.iter_mut().enumerate() {
            let columns = self.conditions.iter().zip(multipliers);
            let shift = self.right[i] + columns.map(|(c, mu)| mu * c.column[i]).sum::<f64>();
            size = size.max(value.abs()).max(self.right[i].abs());
            *value -= shift;
        }
        Excess { values, threshold: -NO_SIGN * size }
    }

    /// The equations on a set, zero outside; `None` where the set is too small for the conditions.
    fn restricted(&self, set: &[bool]) -> Result<Option<Restricted>, Error> {
        let inside: Vec<usize> = (0..set.len()).filter(|&i| set[i]).collect();
        let conditions = self.conditions.len();
        let mut values = vec![0.0; set.len()];
        if inside.len() < conditions {
            return Ok(None);
        }
        if inside.is_empty() {
            return Ok(Some(Restricted { values, multipliers: Vec::new() }));
        }
        let order = self.matrix.order;
        let part: Vec<f64> = inside
            .iter()
            .flat_map(|&i| inside.iter().map(move |&j| self.matrix.matrix[i * order + j]))
            .collect();
        let factored = Factored::shifted(&part, inside.len(), self.matrix.parameter)?;
        let solved = |f: &[f64]| {
            let mut z: Vec<f64> = inside.iter().map(|&i| f[i]).collect();
            factored.solve(&mut z);
            z
        };
        let mut z = solved(self.right);
        let columns: Vec<Vec<f64>> = self.conditions.iter().map(|c| solved(&c.column)).collect();
        let Some(multipliers) = self.multipliers(&inside, &z, &columns) else { return Ok(None) };
        for (column, mu) in columns.iter().zip(&multipliers) {
            z.iter_mut().zip(column).for_each(|(z, c)| *z += mu * c);
        }
        inside.iter().zip(&z).for_each(|(&i, z)| values[i] = *z);
        Ok(Some(Restricted { values, multipliers }))
    }

    /// `mu` from `r_k . (z + sum mu_l u_l) = v_k` by elimination with pivots.
    fn multipliers(&self, inside: &[usize], z: &[f64], columns: &[Vec<f64>]) -> Option<Vec<f64>> {
        let along = |condition: &Condition, vector: &[f64]| {
            inside.iter().zip(vector).map(|(&i, v)| condition.row[i] * v).sum::<f64>()
        };
        let mut rows: Vec<Vec<f64>> = (self.conditions.iter())
            .map(|condition| {
                let mut row: Vec<f64> = columns.iter().map(|u| along(condition, u)).collect();
                row.push(condition.value - along(condition, z));
                row
            })
            .collect();
        let count = rows.len();
        for k in 0..count {
            let size = |row: &Vec<f64>| row[k].abs();
            let pivot = (k..count).max_by(|&i, &j| size(&rows[i]).total_cmp(&size(&rows[j])))?;
            rows.swap(k, pivot);
            let top = rows[k].clone();
            if top[k] == 0.0 || !top[k].is_finite() {
                return None;
            }
            for row in &mut rows[k + 1..] {
                let factor = row[k] / top[k];
                row.iter_mut().zip(&top).for_each(|(value, above)| *value -= factor * above);
            }
        }
        let mut multipliers = vec![0.0; count];
        for k in (0..count).rev() {
            let known: f64 = (k + 1..count).map(|l| rows[k][l] * multipliers[l]).sum();
            multipliers[k] = (rows[k][count] - known) / rows[k][k];
        }
        multipliers.iter().all(|mu| mu.is_finite()).then_some(multipliers)
    }
}

struct Excess {
    values: Vec<f64>,
    threshold: f64,
}

impl Excess {
    /// Whether a component penetrates beyond rounding.
    fn below(&self, i: usize) -> bool {
        self.values[i] < self.threshold
    }

    /// By how much, over the size of its terms.
    fn below_by(&self, i: usize) -> f64 {
        NO_SIGN * self.values[i] / self.threshold
    }
}

#[cfg(test)]
mod tests {
    use super::super::logarithm_cells;
    use super::*;

    struct Case {
        matrix: Complementarity,
        right: Vec<f64>,
        conditions: Vec<Condition>,
        feasible: Vec<f64>,
    }

    /// Force 1 and moment `e` on a base `f` over `n` cells.
    fn case(n: usize, parameter: f64, e: f64, f: impl Fn(f64) -> f64) -> Case {
        let boundaries: Vec<f64> = (0..=n).map(|i| 2.0 * i as f64 / n as f64 - 1.0).collect();
        let width = 2.0 / n as f64;
        let x: Vec<f64> = boundaries[..n].iter().map(|x| x + 0.5 * width).collect();
        let ones = vec![width.sqrt(); n];
        let arms: Vec<f64> = x.iter().map(|x| width.sqrt() * x).collect();
        // Two cells that balance, symmetric about 0 after the shift by e.
        let mut feasible = vec![0.0; n];
        let share = (e - x[0]) / (x[n - 1] - x[0]);
        feasible[0] = (1.0 - share) / width.sqrt();
        feasible[n - 1] = share / width.sqrt();
        let condition =
            |row: &Vec<f64>, value| Condition { row: row.clone(), column: row.clone(), value };
        Case {
            matrix: Complementarity::new(logarithm_cells(&boundaries).unwrap(), parameter).unwrap(),
            right: x.iter().map(|&x| -width.sqrt() * f(x)).collect(),
            conditions: vec![condition(&ones, 1.0), condition(&arms, e)],
            feasible,
        }
    }

    fn check(case: &Case, solution: &ComplementaritySolution) {
        let Case { matrix, right, conditions, .. } = case;
        let problem = Problem { matrix, right, conditions };
        let excess = problem.excess(&solution.values, &solution.multipliers);
        let largest = solution.values.iter().fold(0.0f64, |most, z| most.max(*z));
        for (z, w) in solution.values.iter().zip(&excess.values) {
            assert!(*z >= 0.0 && *w > 10.0 * excess.threshold);
            assert!(z * w <= -10.0 * largest * excess.threshold);
        }
        for condition in &case.conditions {
            let sum = dot(&condition.row, &solution.values);
            assert!((sum - condition.value).abs() < 1e-12);
        }
    }

    #[test]
    fn both_methods_find_the_same_set() {
        for parameter in [0.0, 1e-3, 1.0, 1e3, 1e7] {
            for e in [0.0, 0.4, -0.9] {
                for (stiffness, waves) in [(0.0, 0.0), (50.0, 0.0), (1.0, 9.0), (1e4, 14.0)] {
                    let f =
                        |x: f64| stiffness * (x * x + 0.2 * (waves * x).sin()) * (1.0 + parameter);
                    let case = case(90, parameter, e, f);
                    let Case { matrix, right, conditions, feasible } = &case;
                    let found = matrix.solve(right, conditions, &[true; 90], feasible).unwrap();
                    check(&case, &found);
                    let problem = Problem { matrix, right, conditions };
                    let safe = problem.descended(feasible, &|_| false).unwrap();
                    check(&case, &safe);
                    let difference = (found.values.iter().zip(&safe.values))
                        .fold(0.0f64, |most, (one, two)| most.max((one - two).abs()));
                    assert!(difference < 1e-6, "{parameter} {e} {stiffness}: {difference:e}");
                }
            }
        }
    }

    #[test]
    fn without_time_the_safe_method_has_a_pressure_that_carries_the_load() {
        let case = case(60, 1.0, 0.3, |x| 40.0 * (x * x + 0.2 * (9.0 * x).sin()));
        let Case { matrix, right, conditions, feasible } = &case;
        let problem = Problem { matrix, right, conditions };
        let whole = problem.descended(feasible, &|_| false).unwrap();
        for steps in 0..whole.iterations {
            let left = std::cell::Cell::new(steps);
            let is_over = |_| left.replace(left.get().saturating_sub(1)) == 0;
            let ended = problem.descended(feasible, &is_over).unwrap();
            assert!(ended.iterations == steps + 1 && ended.values.iter().all(|z| *z >= 0.0));
            for condition in conditions {
                let sum = dot(&condition.row, &ended.values);
                assert!((sum - condition.value).abs() < 1e-12, "{steps}: {sum}");
            }
        }
    }

    #[test]
    fn refuses_lists_of_the_wrong_length() {
        let case = case(8, 1.0, 0.0, |_| 0.0);
        assert!(case.matrix.solve(&[0.0; 7], &[], &[true; 8], &[0.0; 8]).is_err());
        assert!(Complementarity::new(vec![1.0; 5], 1.0).is_err());
        assert!(Complementarity::new(vec![1.0; 4], f64::NAN).is_err());
    }
}
