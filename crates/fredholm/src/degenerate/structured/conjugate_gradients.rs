//! Preconditioned conjugate gradients that vouch for their residual.

use crate::Error;
use crate::linear::vector::{add, dot, norm};

/// How well an iterative solution satisfies its system.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Convergence {
    /// Iterations done, all parities together.
    pub iterations: usize,
    /// `|b - A y| / |b|` in the Euclidean norm of the symmetric form, recomputed from the solution (the largest over the parities).
    pub residual: f64,
    /// Whether the residual stopped at rounding before it reached the tolerance: no iteration makes it smaller.
    pub limited_by_rounding: bool,
}

/// Where to stop.
#[derive(Debug, Clone, Copy)]
pub(super) struct Goal {
    /// Relative residual.
    pub(super) tolerance: f64,
    /// Iterations.
    pub(super) maximum: usize,
}

/// A symmetric positive definite matrix with its preconditioner.
pub(super) trait Iterable {
    /// `image = A vector`.
    fn apply(&mut self, vector: &[f64], image: &mut [f64]);

    /// Overwrites `vector` with `M^{-1} vector`.
    fn precondition(&self, vector: &mut [f64]);

    /// The norm of the rounding errors to be expected in `A vector`.
    fn rounding(&self, vector: &[f64]) -> f64;
}

/// The solution of `A y = right`, `right` not zero.
///
/// The recurrence for the residual drifts from the truth by rounding, so once it claims success the true residual is
/// formed; if that is too large the iteration starts again from there, until it succeeds, stops at rounding or no longer halves it.
pub(super) fn solve(
    matrix: &mut impl Iterable,
    right: &[f64],
    goal: Goal,
) -> Result<(Vec<f64>, Convergence), Error> {
    let size = norm(right);
    let mut solution = vec![0.0; right.len()];
    let mut rest = right.to_vec();
    let mut image = vec![0.0; right.len()];
    let (mut iterations, mut previous) = (0, f64::INFINITY);
    loop {
        let left = Goal { maximum: goal.maximum - iterations, ..goal };
        iterations += descend(matrix, &mut solution, &mut rest, &mut image, size, left);
        matrix.apply(&solution, &mut image);
        for ((rest, right), image) in rest.iter_mut().zip(right).zip(&image) {
            *rest = right - image;
        }
        let residual = norm(&rest) / size;
        if residual <= goal.tolerance {
            let found = Convergence { iterations, residual, limited_by_rounding: false };
            return Ok((solution, found));
        }
        if residual <= matrix.rounding(&solution) / size {
            return Ok((solution, Convergence { iterations, residual, limited_by_rounding: true }));
        }
        let stagnant = residual.is_nan() || residual >= 0.5 * previous;
        if iterations >= goal.maximum || stagnant {
            let tolerance = goal.tolerance;
            return Err(Error::NotConverged { iterations, residual, tolerance });
        }
        previous = residual;
    }
}

/// Conjugate gradients from `solution` with residual `rest`, until its recurrence meets the goal; the number of
/// iterations done. `size` is the norm that the tolerance refers to.
fn descend(
    matrix: &mut impl Iterable,
    solution: &mut [f64],
    rest: &mut [f64],
    image: &mut [f64],
    size: f64,
    goal: Goal,
) -> usize {
    let mut direction = rest.to_vec();
    matrix.precondition(&mut direction);
    let mut decrease = dot(rest, &direction);
    for iteration in 0..goal.maximum {
        matrix.apply(&direction, image);
        let step = decrease / dot(&direction, image);
        if !step.is_finite() {
            return iteration;
        }
        add(solution, step, &direction);
        add(rest, -step, image);
        if norm(rest) <= goal.tolerance * size {
            return iteration + 1;
        }
        image.copy_from_slice(rest);
        matrix.precondition(image);
        let next = dot(rest, image);
        let ratio = next / decrease;
        for (direction, image) in direction.iter_mut().zip(&*image) {
            *direction = image + ratio * *direction;
        }
        decrease = next;
    }
    goal.maximum
}
