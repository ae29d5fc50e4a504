//! Complementarity on many equal cells: an active set whose equations are solved by projected conjugate gradients.

use super::equal_cells::EqualCells;
use super::small::Conditions;
use crate::Error;
use crate::linear::dot;

/// Most exchanges, and after how many only the worst half of the cells is exchanged.
const MOST_EXCHANGES: usize = 120;
const CAREFUL: usize = 25;
/// Most steps of conjugate gradients between two exchanges.
const MOST_STEPS: usize = 2000;
/// How far the residual falls between exchanges, relative to what the exchange left, until the set stands.
const FALL: f64 = 1e-2;
/// Residual, tension and penetration of a solution, relative to the size of the terms.
const TOLERANCE: f64 = 1e-11;

/// A condition `c . phi = v` on the mean values of the cells; `c` is also the column of its multiplier.
#[derive(Debug, Clone, PartialEq)]
pub struct CellCondition {
    /// `c`.
    pub row: Vec<f64>,
    /// `v`.
    pub value: f64,
}

/// What a complementarity problem on equal cells leads to.
#[derive(Debug, Clone, PartialEq)]
pub struct CellSolution {
    /// Mean values, none negative.
    pub values: Vec<f64>,
    /// Which cells carry.
    pub carrying: Vec<bool>,
    /// `mu`, one for each condition.
    pub multipliers: Vec<f64>,
    /// Products with the matrix.
    pub products: usize,
}

impl EqualCells {
    /// `phi >= 0`, `w = (1 + theta S) phi - b - sum_k mu_k c_k >= 0`, `phi . w = 0`, `c_k . phi = v_k`, beginning with the values and cells of `start`.
    ///
    /// # Errors
    /// [`Error::WrongLength`] for lists that are not as long as there are cells, [`Error::NotConverged`] when the exchanges do not end.
    pub fn complementary(
        &self,
        right: &[f64],
        conditions: &[CellCondition],
        start: &[f64],
        carrying: &[bool],
    ) -> Result<CellSolution, Error> {
        let rows = conditions.iter().map(|condition| condition.row.len());
        let lists = [right.len(), start.len(), carrying.len()].into_iter().chain(rows);
        for found in lists {
            if found != self.count() {
                return Err(Error::WrongLength { what: "list", found, expected: self.count() });
            }
        }
        Search::new(self, right, conditions, start, carrying).run()
    }

    /// `(1 + theta S) phi = b` on the cells of a set, `phi = 0` elsewhere.
    ///
    /// # Errors
    /// As [`EqualCells::complementary`].
    pub fn restricted(&self, right: &[f64], carrying: &[bool]) -> Result<Vec<f64>, Error> {
        let zero = vec![0.0; self.count()];
        if right.len() != self.count() || carrying.len() != self.count() {
            let found = right.len().min(carrying.len());
            return Err(Error::WrongLength { what: "list", found, expected: self.count() });
        }
        let mut search = Search::new(self, right, &[], &zero, carrying);
        search.begin().ok_or_else(|| search.failed())?;
        search.descend(TOLERANCE * search.size);
        Ok(search.values)
    }
}

struct Search<'s> {
    cells: &'s EqualCells,
    right: &'s [f64],
    conditions: &'s [CellCondition],
    carrying: Vec<bool>,
    values: Vec<f64>,
    /// `b + sum mu c - A phi`, on all cells.
    residual: Vec<f64>,
    multipliers: Vec<f64>,
    constraint: Conditions,
    /// Largest term of the equations.
    size: f64,
    products: usize,
}

impl<'s> Search<'s> {
    fn new(
        cells: &'s EqualCells,
        right: &'s [f64],
        conditions: &'s [CellCondition],
        start: &[f64],
        carrying: &[bool],
    ) -> Self {
        Self {
            cells,
            right,
            conditions,
            carrying: carrying.to_vec(),
            values: start.to_vec(),
            residual: vec![0.0; right.len()],
            multipliers: vec![0.0; conditions.len()],
            constraint: Conditions::default(),
            size: 0.0,
            products: 0,
        }
    }

    fn run(mut self) -> Result<CellSolution, Error> {
        let mut tolerance = 0.0f64;
        for exchanges in 0..MOST_EXCHANGES {
            self.begin().ok_or_else(|| self.failed())?;
            let least = TOLERANCE * self.size;
            let wanted = if exchanges == 0 { FALL * self.largest_inside() } else { tolerance };
            self.descend(wanted.max(least));
            let worst = self.violation();
            if worst <= least && self.largest_inside() <= 2.0 * least {
                return Ok(self.finished());
            }
            // The set stands for now: the equations on it to the end.
            tolerance =
                if worst <= FALL * self.largest_inside().max(least) { least } else { FALL * worst };
            self.exchange(if exchanges < CAREFUL { 0.0 } else { 0.5 * worst });
        }
        Err(self.failed())
    }

    fn failed(&self) -> Error {
        Error::NotConverged {
            iterations: self.products,
            residual: self.violation() / self.size.max(f64::MIN_POSITIVE),
            tolerance: TOLERANCE,
        }
    }

    /// Makes the values meet the conditions on the set, with the residual there; `None` where the set is too small for them.
    fn begin(&mut self) -> Option<()> {
        for (value, inside) in self.values.iter_mut().zip(&self.carrying) {
            if !inside || *value < 0.0 {
                *value = 0.0;
            }
        }
        let rows: Vec<Vec<f64>> = self.conditions.iter().map(|c| self.inside(&c.row)).collect();
        let images = rows.iter().map(|row| self.preconditioned(row)).collect();
        self.constraint = Conditions::new(rows, images)?;
        let missing: Vec<f64> =
            self.conditions.iter().map(|c| c.value - dot(&c.row, &self.values)).collect();
        let shares = self.constraint.solve(&missing);
        self.constraint.add_images(&shares, &mut self.values);
        let image = self.cells.product(&self.values);
        self.products += 1;
        self.size = (image.iter().chain(self.right)).fold(0.0, |most: f64, v| most.max(v.abs()));
        for (i, residual) in self.residual.iter_mut().enumerate() {
            let columns = self.conditions.iter().zip(&self.multipliers);
            *residual =
                self.right[i] + columns.map(|(c, mu)| mu * c.row[i]).sum::<f64>() - image[i];
        }
        Some(())
    }

    /// Conjugate gradients on the set, along which the conditions stay met, to a residual.
    fn descend(&mut self, tolerance: f64) {
        let mut gradient = self.projected_gradient();
        let mut direction = gradient.clone();
        let mut energy = dot(&self.residual, &gradient);
        for _ in 0..MOST_STEPS {
            if self.largest_inside() <= tolerance || energy <= 0.0 {
                break;
            }
            let image = self.cells.product(&direction);
            self.products += 1;
            let curvature = dot(&direction, &image);
            if curvature <= 0.0 || !curvature.is_finite() {
                break;
            }
            let step = energy / curvature;
            for i in 0..self.values.len() {
                self.values[i] += step * direction[i];
                self.residual[i] -= step * image[i];
            }
            gradient = self.projected_gradient();
            let next = dot(&self.residual, &gradient);
            let share = next / energy;
            energy = next;
            direction.iter_mut().zip(&gradient).for_each(|(d, g)| *d = g + share * *d);
        }
    }

    /// The preconditioned residual within the conditions; what they take of the residual goes into the multipliers.
    fn projected_gradient(&mut self) -> Vec<f64> {
        let inside = self.inside(&self.residual);
        let mut gradient = self.preconditioned(&inside);
        let along: Vec<f64> =
            self.conditions.iter().map(|condition| dot(&condition.row, &gradient)).collect();
        let mut shares = self.constraint.solve(&along);
        shares.iter_mut().for_each(|share| *share = -*share);
        self.constraint.add_images(&shares, &mut gradient);
        for ((condition, share), multiplier) in
            self.conditions.iter().zip(&shares).zip(&mut self.multipliers)
        {
            *multiplier += share;
            self.residual.iter_mut().zip(&condition.row).for_each(|(r, c)| *r += share * c);
        }
        gradient
    }

    fn inside(&self, list: &[f64]) -> Vec<f64> {
        list.iter().zip(&self.carrying).map(|(v, inside)| if *inside { *v } else { 0.0 }).collect()
    }

    fn preconditioned(&self, list: &[f64]) -> Vec<f64> {
        self.inside(&self.cells.roughly_inverted(list))
    }

    fn largest_inside(&self) -> f64 {
        let inside = self.residual.iter().zip(&self.carrying).filter(|(_, inside)| **inside);
        inside.fold(0.0, |most, (r, _)| most.max(r.abs()))
    }

    /// Tension of a cell of the set, penetration of another.
    fn wrong(&self, i: usize) -> f64 {
        if self.carrying[i] { -self.values[i] } else { self.residual[i] }
    }

    fn violation(&self) -> f64 {
        (0..self.values.len()).fold(0.0, |most, i| most.max(self.wrong(i)))
    }

    /// Cells that pull leave the set, those that penetrate come in.
    fn exchange(&mut self, threshold: f64) {
        let wrong: Vec<bool> = (0..self.values.len()).map(|i| self.wrong(i) > threshold).collect();
        self.carrying.iter_mut().zip(wrong).for_each(|(inside, wrong)| *inside ^= wrong);
    }

    fn finished(mut self) -> CellSolution {
        self.values.iter_mut().for_each(|value| *value = value.max(0.0));
        let Self { values, carrying, multipliers, products, .. } = self;
        CellSolution { values, carrying, multipliers, products }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Complementarity, Condition, logarithm_cells};
    use super::*;

    #[test]
    fn agrees_with_the_dense_method() {
        const COUNT: usize = 120;
        let width = 2.0 / COUNT as f64;
        let boundaries: Vec<f64> = (0..=COUNT).map(|i| width * i as f64 - 1.0).collect();
        let x: Vec<f64> = boundaries[..COUNT].iter().map(|x| x + 0.5 * width).collect();
        for (parameter, e, waves) in
            [(0.0, 0.3, 9.0), (1.0, 0.0, 30.0), (100.0, -0.6, 30.0), (1e5, 0.9, 4.0)]
        {
            let right: Vec<f64> = (x.iter())
                .map(|x| -(1.0 + parameter) * (3.0 * x * x + 0.4 * (waves * x).sin()))
                .collect();
            let (level, arms) = (vec![width; COUNT], x.iter().map(|x| width * x).collect());
            let conditions = [(level, 1.0), (arms, e)];
            let cells = EqualCells::new(COUNT, parameter).unwrap();
            let found = cells
                .complementary(
                    &right,
                    &conditions.clone().map(|(row, value)| CellCondition { row, value }),
                    &[0.0; COUNT],
                    &[true; COUNT],
                )
                .unwrap();

            // The dense method counts in roots of the widths.
            let root = width.sqrt();
            let scaled = |list: &[f64]| -> Vec<f64> { list.iter().map(|v| v * root).collect() };
            let dense = Complementarity::new(logarithm_cells(&boundaries).unwrap(), parameter)
                .unwrap()
                .solve(
                    &scaled(&right),
                    &conditions.map(|(row, value)| {
                        let row: Vec<f64> = row.iter().map(|v| v / root).collect();
                        Condition { row: row.clone(), column: row, value }
                    }),
                    &[true; COUNT],
                    &vec![0.0; COUNT],
                )
                .unwrap();
            let largest = dense.values.iter().fold(0.0f64, |most, z| most.max(*z)) / root;
            for (one, other) in found.values.iter().zip(&dense.values) {
                assert!((one - other / root).abs() < 1e-7 * largest, "{parameter} {one}");
            }
            assert!(found.values.contains(&0.0));
        }
    }

    #[test]
    fn refuses_lists_of_the_wrong_length() {
        let cells = EqualCells::new(8, 1.0).unwrap();
        assert!(cells.complementary(&[0.0; 7], &[], &[0.0; 8], &[true; 8]).is_err());
        assert!(cells.restricted(&[0.0; 7], &[true; 8]).is_err());
    }
}
