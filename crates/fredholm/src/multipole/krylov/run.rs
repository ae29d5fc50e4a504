//! One right-hand side on its way to its solution, product by product.

use super::least::LeastSquares;
use super::{
    Border, MOST_PRODUCTS, PanelEquation, PanelSolution, PanelTask, ROUNDING, STAGNANT, STEPS,
    VALUES,
};
use crate::Error;
use crate::linear::vector::add;

/// A solution with what is to be done to it next.
pub(super) struct Run<'r> {
    equation: &'r PanelEquation<'r>,
    border: &'r Border<'r>,
    right: &'r [f64],
    tolerance: f64,
    values: Vec<f64>,
    multipliers: Vec<f64>,
    potential: Vec<f64>,
    /// The norm of the residual, and that before the last restart.
    norm: f64,
    before: f64,
    products: usize,
    step: Step,
}

/// Of what the potential is wanted next.
enum Step {
    /// Of the values to begin with.
    Start,
    /// Of a direction.
    Direction(Krylov),
    /// Of the values after a step.
    Values,
    Done,
}

/// Directions since a restart.
struct Krylov {
    basis: Vec<Vec<f64>>,
    least: LeastSquares,
    /// The last of them through the approximate inverse, with its multipliers.
    direction: Vec<f64>,
    shift: Vec<f64>,
}

impl<'r> Run<'r> {
    pub(super) fn new(
        equation: &'r PanelEquation<'r>,
        border: &'r Border<'r>,
        task: &PanelTask<'r>,
    ) -> Self {
        Self {
            equation,
            border,
            right: task.right,
            tolerance: task.tolerance,
            values: task.start.to_vec(),
            multipliers: vec![0.0; border.conditions.len()],
            potential: Vec::new(),
            norm: f64::INFINITY,
            before: f64::INFINITY,
            products: 0,
            step: Step::Start,
        }
    }

    /// The function whose potential is to be taken; none once all is done.
    pub(super) fn wanted(&self) -> Option<&[f64]> {
        match &self.step {
            Step::Start | Step::Values => Some(&self.values),
            Step::Direction(krylov) => Some(&krylov.direction),
            Step::Done => None,
        }
    }

    /// Goes on with the potential that was wanted.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub(super) fn take(&mut self, potential: Vec<f64>) -> Result<(), Error> {
        self.products += 1;
        match std::mem::replace(&mut self.step, Step::Done) {
            Step::Start => {
                self.potential = potential;
                let residual = self.first_residual();
                // The first step meets the conditions, later ones keep them.
                let conditions = self.border.conditions.iter();
                let missing: Vec<f64> = conditions
                    .map(|c| c.value - self.equation.carried(&c.row, &self.values))
                    .collect();
                self.go(&residual, &missing);
            }
            Step::Values => {
                self.potential = potential;
                return self.judge();
            }
            Step::Direction(krylov) => self.learn(krylov, potential),
            Step::Done => {}
        }
        Ok(())
    }

    /// The residual of the start, or of nothing where that leaves less: the right-hand side may be nothing itself.
    fn first_residual(&mut self) -> Vec<f64> {
        let residual = self.residual();
        let square = |list: &[f64]| self.equation.product(list, list);
        // Of a start with conditions their columns take away most.
        if !self.border.conditions.is_empty() || square(&residual) <= square(self.right) {
            return residual;
        }
        self.values.fill(0.0);
        self.potential.fill(0.0);
        self.right.to_vec()
    }

    fn residual(&self) -> Vec<f64> {
        let Self { right, values, multipliers, potential, .. } = self;
        let conditions = self.border.conditions;
        self.equation.residual(right, conditions, values, multipliers, potential)
    }

    /// A step along a direction.
    fn go(&mut self, direction: &[f64], missing: &[f64]) {
        let (step, shift) = self.equation.roughly_inverted(self.border, direction, missing);
        add(&mut self.values, 1.0, &step);
        add(&mut self.multipliers, 1.0, &shift);
        self.step = Step::Values;
    }

    /// Whether the values are good enough, or directions are to be looked for.
    fn judge(&mut self) -> Result<(), Error> {
        let mut residual = self.residual();
        self.norm = self.equation.product(&residual, &residual).sqrt();
        let (norm, tolerance) = (self.norm, self.tolerance);
        let falls = norm <= STAGNANT * self.before && self.products <= MOST_PRODUCTS;
        if norm > tolerance && falls {
            self.before = norm;
            residual.iter_mut().for_each(|value| *value /= norm);
            let least = LeastSquares::new(norm);
            self.look(Krylov { basis: vec![residual], least, direction: vec![], shift: vec![] });
            return Ok(());
        }
        let Self { right, values, multipliers, potential, .. } = &*self;
        let conditions = self.border.conditions;
        let size = self.equation.size(right, conditions, values, multipliers, potential);
        if norm.is_nan() || norm > tolerance.max(ROUNDING * size) {
            return Err(Error::NotConverged {
                iterations: self.products,
                residual: norm / size,
                tolerance: (tolerance / size).max(ROUNDING),
            });
        }
        Ok(())
    }

    /// Another direction, unless those there are leave little enough: then a step along their combination whose step leaves the least residual, before the approximate inverse.
    fn look(&mut self, mut krylov: Krylov) {
        let Krylov { basis, least, .. } = &krylov;
        let steps = STEPS.min(VALUES / basis[0].len());
        if least.residual().abs() > 0.5 * self.tolerance && basis.len() <= steps {
            let none = vec![0.0; self.border.conditions.len()];
            let last = &basis[basis.len() - 1];
            (krylov.direction, krylov.shift) =
                self.equation.roughly_inverted(self.border, last, &none);
            self.step = Step::Direction(krylov);
        } else {
            self.combine(&krylov);
        }
    }

    fn combine(&mut self, krylov: &Krylov) {
        let mut combined = vec![0.0; krylov.basis[0].len()];
        for (vector, factor) in krylov.basis.iter().zip(krylov.least.factors()) {
            add(&mut combined, factor, vector);
        }
        self.go(&combined, &vec![0.0; self.border.conditions.len()]);
    }

    /// Takes in a direction with its potential.
    fn learn(&mut self, mut krylov: Krylov, mut next: Vec<f64>) {
        let equation = self.equation;
        let Krylov { basis, least, direction, shift } = &mut krylov;
        next.iter_mut().zip(&*direction).for_each(|(u, v)| *u = v + equation.parameter * *u);
        for (condition, mu) in self.border.conditions.iter().zip(&*shift) {
            add(&mut next, -mu, &condition.column);
        }
        let mut column = Vec::with_capacity(basis.len() + 1);
        for vector in &*basis {
            let part = equation.product(vector, &next);
            add(&mut next, -part, vector);
            column.push(part);
        }
        let length = equation.product(&next, &next).sqrt();
        column.push(length);
        least.add(column);
        if length.is_nan() || length <= 0.0 {
            return self.combine(&krylov);
        }
        next.iter_mut().for_each(|value| *value /= length);
        basis.push(next);
        self.look(krylov);
    }

    pub(super) fn into_solution(self) -> PanelSolution {
        let Self { values, multipliers, potential, norm: residual, products, .. } = self;
        PanelSolution { values, multipliers, potential, residual, products }
    }
}
