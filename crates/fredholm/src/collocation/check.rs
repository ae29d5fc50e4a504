//! The error of a solution, from what a rule on twice as many nodes makes of it.
//!
//! A solution of collocation satisfies its equation with the integral taken by its nodes. Put into the equation with the integral taken by twice as many, it leaves a residual
//! `r = f - phi - lambda K phi`, and its error is `(1 + lambda K)^-1 r`, which the factorisation at hand gives. The rule converges exponentially: with twice as many nodes its own error is
//! negligible beside `r`. The residual is taken at some of the finer nodes, by turns at a node of the solution and between two.
//!
//! (Nodes moved by half a step would not do: where corners matter most their solutions have the same error.)

use super::assembly::boundary_rows;
use super::entries::{Entries, Scratch};
use super::estimate::{Estimate, largest};
use super::mesh::Mesh;
use super::operator::masses;
use super::{SincFactor, SincOperator, SincSolution};
use crate::Error;
use crate::kernel::Kernel;
use crate::linear::dot;

/// The residual is taken at about so many of the finer nodes of a panel, for `|t| < 3.4` every tenth of a unit: it may be a packet of waves some tenths wide, where the error of the rule in the depths of a
/// corner takes over from that in the heights.
const ROWS: usize = 64;
/// Every so many of the finer nodes at least.
const LEAST_STRIDE: usize = 3;

/// What is asked of an equation on a mesh.
pub(super) struct Check<'c> {
    pub(super) kernel: &'c dyn Kernel,
    pub(super) operator: &'c SincOperator,
    /// With twice as many nodes on each panel as the operator.
    pub(super) finer: Mesh,
}

/// A solution on the finer nodes.
struct Finer {
    /// Weights of the finer nodes.
    masses: Vec<f64>,
    /// `K phi` as the solution has it.
    potential: Vec<f64>,
    /// `w_j m_j phi_j`.
    density: Vec<f64>,
    /// `phi`.
    values: Vec<f64>,
}

/// The residual where it was taken.
struct Residual {
    /// At finer nodes, from left to right.
    inside: Vec<(usize, f64)>,
    /// At the boundaries of the panels.
    boundaries: Vec<f64>,
}

impl Check<'_> {
    /// The largest error of a solution and those of its integrals, in size.
    ///
    /// # Errors
    /// [`Error::NotFinite`] where the right-hand side or the kernel is not finite on the finer nodes.
    pub(super) fn error(
        &self,
        factor: &SincFactor<'_>,
        solution: &SincSolution,
        f: &dyn Fn(f64) -> f64,
    ) -> Result<Estimate, Error> {
        let finer = self.finer(solution, f)?;
        let residual = self.residual(solution, &finer)?;
        let error = factor.solve(&self.at_nodes(&residual.inside))?;
        let at_boundaries = residual.boundaries.iter().zip(error.boundaries());
        let at_boundaries = at_boundaries.map(|(r, u)| (r - solution.parameter() * u).abs());
        let centre = self.operator.interval().centre();
        // Of an integral there is that of the error, and what the nodes make of the integral itself.
        let integral = |u: &dyn Fn(f64) -> f64| {
            let terms = self.finer.positions().iter().zip(&finer.density);
            let exact: f64 = terms.map(|(x, density)| u(*x) * density).sum();
            error.integral(u).abs() + (exact - solution.integral(u)).abs()
        };
        Ok(Estimate {
            solution: at_boundaries.fold(largest(error.values()), f64::max),
            integral: integral(&|x| self.kernel.mass_function(x)),
            first_moment: integral(&|x| x - centre),
        })
    }

    /// The node of the operator that a finer node is, or none between two.
    fn node(&self, index: usize) -> Option<usize> {
        let local = index % self.finer.panel_count();
        let first = self.finer.panel(index) * self.operator.mesh().panel_count();
        local.is_multiple_of(2).then_some(first + local / 2)
    }

    /// `K phi` of a solution at the finer nodes.
    fn potential(&self, solution: &SincSolution) -> Vec<f64> {
        let between = |index: &usize| self.node(*index).is_none();
        let places = (0..self.finer.count()).filter(between).map(|index| self.finer.place(index));
        let mut halfway = solution.potential_halfway(places).into_iter();
        let at = |index| match self.node(index) {
            Some(node) => solution.potential()[node],
            None => halfway.next().unwrap_or(f64::NAN),
        };
        (0..self.finer.count()).map(at).collect()
    }

    fn finer(&self, solution: &SincSolution, f: &dyn Fn(f64) -> f64) -> Result<Finer, Error> {
        let masses = masses(self.kernel, &self.finer)?;
        let count = self.finer.count();
        let potential = self.potential(solution);
        let value = |index: usize| {
            if let Some(node) = self.node(index) {
                return Ok(solution.values()[node]);
            }
            let at = self.finer.positions()[index];
            let value = f(at) - solution.parameter() * potential[index];
            let what = "right-hand side";
            if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { what, at, value }) }
        };
        let values: Vec<f64> = (0..count).map(value).collect::<Result<_, _>>()?;
        let density = values.iter().zip(&masses).map(|(phi, mass)| phi * mass).collect();
        Ok(Finer { masses, potential, density, values })
    }

    fn residual(&self, solution: &SincSolution, finer: &Finer) -> Result<Residual, Error> {
        let Finer { masses, potential, density, values } = finer;
        let count = self.finer.count();
        let is_even = self.operator.blocks().len() == 2;
        let entries = Entries::new(self.kernel, &self.finer, masses);
        let mirrored: Vec<f64> = density.iter().rev().copied().collect();
        let (mut row, mut scratch) = (vec![0.0; count], Scratch::new(count));
        let mut inside = Vec::new();
        let difference = |index: usize, found: f64| {
            let value = solution.parameter() * (potential[index] - found);
            let at = self.finer.positions()[index];
            if value.is_finite() {
                Ok(value)
            } else {
                Err(Error::NotFinite { what: "kernel", at, value })
            }
        };
        // An odd number, so that they lie on nodes and between them by turns.
        let stride = (self.finer.panel_count() / ROWS).max(LEAST_STRIDE) | 1;
        let first = if is_even { count / 2 } else { stride / 2 };
        let mut mirror_images = Vec::new();
        for index in (first..count).step_by(stride) {
            if self.operator.is_corner(masses[index], self.finer.place(index)) {
                continue;
            }
            entries.row(index, 0..index, &mut row, &mut scratch);
            row[index] = entries.diagonal(index);
            entries.row(index, index + 1..count, &mut row[index + 1..], &mut scratch);
            inside.push((index, difference(index, dot(&row, density))?));
            let image = count - 1 - index;
            if is_even && image != index {
                mirror_images.push((image, difference(image, dot(&row, &mirrored))?));
            }
        }
        let inside = mirror_images.into_iter().rev().chain(inside).collect();
        let rows = boundary_rows(self.kernel, &self.finer, masses);
        let boundaries = rows.chunks_exact(count).zip(solution.boundaries());
        let boundaries = boundaries.map(|(row, u)| solution.parameter() * (u - dot(row, values)));
        Ok(Residual { inside, boundaries: boundaries.collect() })
    }

    /// The residual at the nodes of the operator, from cubic polynomials through the nearest values: where it is large because its rounding is, it is smooth, and the error is a small part of it.
    fn at_nodes(&self, inside: &[(usize, f64)]) -> Vec<f64> {
        let count = self.finer.panel_count();
        let mut values = Vec::with_capacity(self.operator.count());
        for panel in 0..self.finer.panels() {
            let first = panel * count;
            let start = inside.partition_point(|(index, _)| *index < first);
            let end = inside.partition_point(|(index, _)| *index < first + count);
            let points = &inside[start..end];
            let mut right = 0;
            for index in (first..first + count).step_by(2) {
                right += points[right..].iter().take_while(|(point, _)| *point < index).count();
                values.push(between(points, right, index));
            }
        }
        values
    }
}

/// The polynomial through the values at two points on either side of an index, or as many as there are; beyond the last the value there. `right` is the first point that is not left of it.
fn between(points: &[(usize, f64)], right: usize, index: usize) -> f64 {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return 0.0 };
    if right == 0 || right == points.len() {
        return if right == 0 { first.1 } else { last.1 };
    }
    let nearest = &points[right.saturating_sub(2)..points.len().min(right + 2)];
    let count = nearest.len();
    // Newton's divided differences.
    let (mut at, mut differences) = ([0.0; 4], [0.0; 4]);
    for (k, (point, value)) in nearest.iter().enumerate() {
        (at[k], differences[k]) = (*point as f64 - index as f64, *value);
    }
    for order in 1..count {
        for k in (order..count).rev() {
            differences[k] = (differences[k] - differences[k - 1]) / (at[k] - at[k - order]);
        }
    }
    (0..count).rev().fold(0.0, |sum, k| differences[k] - at[k] * sum)
}
