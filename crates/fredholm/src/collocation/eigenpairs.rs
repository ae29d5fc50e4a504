//! Eigenfunctions of a collocated kernel, which can be evaluated anywhere.

use std::sync::Arc;

use super::assembly::Part;
use super::mesh::Mesh;
use super::points::sinc_row;
use super::solution::line;
use super::{Place, SincOperator};
use crate::Error;
use crate::linear::{Eigensystem, dot, multiply_rows};

/// The eigenpairs of largest magnitude of a collocated kernel, orthonormal in `L2(dm)`, by falling magnitude.
///
/// An eigenfunction solves `phi - (1/nu) K phi = 0`, so it is evaluated as any solution is: the line through its end values `(K phi)/nu` and sinc functions.
#[derive(Debug, Clone)]
pub(crate) struct Eigenpairs {
    mesh: Arc<Mesh>,
    eigenvalues: Vec<f64>,
    /// `m_j phi_n(x_j)` with the masses of the nodes, a row for each pair.
    masses: Vec<f64>,
    /// `phi_n` at the nodes less its lines, a row for each pair.
    bubbles: Vec<f64>,
    /// `phi_n` at the boundaries of the panels, a row for each pair.
    boundaries: Vec<f64>,
    /// Whether they are even and odd in turn about the middle of the interval.
    alternating: bool,
}

impl Eigenpairs {
    /// At most `most` pairs, with eigenvalues above the share `negligible` of the largest.
    pub(crate) fn new(
        operator: &SincOperator,
        most: usize,
        negligible: f64,
    ) -> Result<Self, Error> {
        let systems: Vec<Eigensystem> = (operator.blocks().iter())
            .map(|block| Eigensystem::new(&block.matrix, block.order()))
            .collect::<Result<_, _>>()?;
        let mut found = Self {
            mesh: Arc::clone(operator.mesh()),
            eigenvalues: Vec::new(),
            masses: Vec::new(),
            bubbles: Vec::new(),
            boundaries: Vec::new(),
            alternating: operator.blocks().len() == 2,
        };
        for (block, index) in by_magnitude(&systems, most, negligible) {
            found.push(operator, &systems, block, index);
        }
        Ok(found)
    }

    fn push(
        &mut self,
        operator: &SincOperator,
        systems: &[Eigensystem],
        block: usize,
        index: usize,
    ) {
        let order = operator.blocks()[block].order();
        let eigenvalue = systems[block].values[index];
        // The vector has length 1 on its block, the function on all nodes.
        let scale = 1.0 / operator.blocks()[block].multiplicity().sqrt();
        let vector = systems[block].vectors[index * order..(index + 1) * order].iter();
        let mut scaled: Vec<Vec<f64>> =
            operator.blocks().iter().map(|block| vec![0.0; block.order()]).collect();
        scaled[block] = vector.map(|z| scale * z).collect();
        let zero = vec![0.0; operator.count()];
        let solution = operator.finish(-1.0 / eigenvalue, &zero, &scaled);
        // Rayleigh's quotient, which norms the function where rounding of a small eigenvalue would not.
        let quotient = dot(solution.masses(), solution.potential());
        let last = solution.boundaries().last().copied().unwrap_or(0.0);
        let sign = if last / quotient < 0.0 { -1.0 } else { 1.0 };
        let normed = |u: &[f64]| u.iter().map(|u| sign * u / quotient).collect::<Vec<f64>>();
        let (mut bubble, mut boundaries) =
            (normed(solution.bubble()), normed(solution.boundaries()));
        self.clean(&normed(solution.potential()), &mut bubble, &mut boundaries);
        let turn = if self.count().is_multiple_of(2) { Part::Even } else { Part::Odd };
        self.alternating &= operator.blocks()[block].part == turn;
        self.eigenvalues.push(eigenvalue);
        self.bubbles.extend(bubble);
        self.boundaries.extend(boundaries);
        self.masses.extend(solution.masses().iter().map(|mass| sign * mass));
    }

    /// Takes the share of the pairs found before out of a function: rounding of `K phi` divided by a small eigenvalue, which lies along the large ones and
    /// which the vector, orthogonal to them to rounding, does not have.
    fn clean(&self, values: &[f64], bubble: &mut [f64], boundaries: &mut [f64]) {
        let before = self.masses.chunks_exact(self.nodes()).zip(
            self.bubbles
                .chunks_exact(self.nodes())
                .zip(self.boundaries.chunks_exact(boundaries.len())),
        );
        for (masses, (other, other_boundaries)) in before {
            let share = dot(masses, values);
            bubble.iter_mut().zip(other).for_each(|(v, other)| *v -= share * other);
            boundaries.iter_mut().zip(other_boundaries).for_each(|(u, other)| *u -= share * other);
        }
    }

    pub(crate) fn count(&self) -> usize {
        self.eigenvalues.len()
    }

    /// `nu_n`.
    pub(crate) fn eigenvalues(&self) -> &[f64] {
        &self.eigenvalues
    }

    /// Whether they are even and odd in turn about the middle of the interval.
    pub(crate) fn is_alternating(&self) -> bool {
        self.alternating
    }

    /// Number of nodes.
    pub(crate) fn nodes(&self) -> usize {
        self.mesh.count()
    }

    /// `int f phi_n dm` for every pair, given `f` at the nodes.
    pub(crate) fn moments(&self, f: &[f64]) -> Vec<f64> {
        self.masses.chunks_exact(self.nodes()).map(|row| dot(row, f)).collect()
    }

    /// `int u phi_n dm`; NaN where there is no such pair.
    pub(crate) fn integral(&self, n: usize, u: impl Fn(f64) -> f64) -> f64 {
        let Some(row) = self.masses.chunks_exact(self.nodes()).nth(n) else { return f64::NAN };
        self.places().zip(row).map(|(place, mass)| u(place.position) * mass).sum()
    }

    /// The nodes.
    pub(crate) fn places(&self) -> impl ExactSizeIterator<Item = Place> + '_ {
        self.mesh.places()
    }

    /// `phi_n(x)` for the first pairs.
    pub(crate) fn evaluate(&self, x: f64, values: &mut [f64]) {
        self.evaluate_at(self.mesh.locate(x), values);
    }

    /// `sum_n coefficients[n] phi_n(x)`.
    pub(crate) fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        let mut values = vec![0.0; coefficients.len().min(self.count())];
        self.evaluate(x, &mut values);
        dot(coefficients, &values)
    }

    fn evaluate_at(&self, place: Place, values: &mut [f64]) {
        let count = self.mesh.panel_count();
        let first = place.panel * count;
        let row: Vec<f64> = sinc_row(&self.mesh, place).collect();
        let bubbles = self.bubbles.chunks_exact(self.nodes());
        let boundaries = self.boundaries.chunks_exact(self.mesh.boundaries().len());
        for ((value, bubble), boundaries) in values.iter_mut().zip(bubbles).zip(boundaries) {
            *value = line(boundaries, self.mesh.left_end(place.panel), place)
                + dot(&row, &bubble[first..first + count]);
        }
    }

    /// `phi_n` at the nodes of another operator, a row for each pair.
    pub(crate) fn on_nodes_of(&self, operator: &SincOperator) -> Vec<f64> {
        let (pairs, nodes) = (self.count(), operator.count());
        let mut rows = vec![0.0; pairs * nodes];
        let mut values = vec![0.0; pairs];
        for (j, place) in operator.places().enumerate() {
            self.evaluate_at(place, &mut values);
            for (row, value) in rows.chunks_exact_mut(nodes).zip(&values) {
                row[j] = *value;
            }
        }
        rows
    }

    /// The largest `||(K - K_N) phi_n||` over the largest eigenvalue on the nodes of a finer operator, `K_N = sum nu_m phi_m phi_m` the degenerate kernel, `rows` the `phi_n` there.
    pub(crate) fn defect(&self, rows: &[f64], finer: &SincOperator) -> f64 {
        let mut sums = vec![0.0; self.count()];
        for block in finer.blocks() {
            let functions: Vec<Vec<f64>> =
                rows.chunks_exact(finer.count()).map(|row| block.scaled(row)).collect();
            for (z, sum) in functions.iter().zip(&mut sums) {
                let mut image = multiply_rows(&block.matrix, z);
                for (other, eigenvalue) in functions.iter().zip(&self.eigenvalues) {
                    let share = eigenvalue * block.multiplicity() * dot(z, other);
                    image.iter_mut().zip(other).for_each(|(image, other)| *image -= share * other);
                }
                *sum += block.multiplicity() * dot(&image, &image);
            }
        }
        let worst = sums.into_iter().fold(0.0, larger).sqrt();
        worst / self.eigenvalues.first().map_or(1.0, |largest| largest.abs())
    }
}

/// The larger of two numbers; NaN if there is one.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// Blocks and indices of the eigenvalues of largest magnitude.
fn by_magnitude(
    systems: &[Eigensystem],
    most: usize,
    negligible: f64,
) -> impl Iterator<Item = (usize, usize)> + use<> {
    let mut all: Vec<(f64, usize, usize)> = (systems.iter().enumerate())
        .flat_map(|(block, system)| {
            system.values.iter().enumerate().map(move |(index, nu)| (nu.abs(), block, index))
        })
        .collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let least = negligible * all.first().map_or(0.0, |largest| largest.0);
    all.into_iter()
        .take_while(move |(magnitude, ..)| *magnitude > least)
        .take(most)
        .map(|(_, block, index)| (block, index))
}
