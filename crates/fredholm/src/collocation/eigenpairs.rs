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
        let boundaries = solution.boundaries().iter().map(|u| u / eigenvalue);
        let sign = if boundaries.clone().next_back().unwrap_or(0.0) < 0.0 { -1.0 } else { 1.0 };
        let boundaries: Vec<f64> = boundaries.map(|phi| sign * phi).collect();
        let turn = if self.count().is_multiple_of(2) { Part::Even } else { Part::Odd };
        self.alternating &= operator.blocks()[block].part == turn;
        self.eigenvalues.push(eigenvalue);
        let share = (eigenvalue / self.eigenvalues[0]).abs();
        let nodes = self.mesh.places().zip(operator.node_masses()).zip(solution.masses());
        for (((place, mass), product), potential) in nodes.zip(solution.potential()) {
            // The vector has an error of 1e-16 over the root of the mass, `K phi` over the eigenvalue one of 1e-16 over the share: the smaller serves.
            let phi = if mass.sqrt() > share { product / mass } else { potential / eigenvalue };
            self.bubbles.push(sign * phi - line(&boundaries, place));
        }
        self.masses.extend(solution.masses().iter().map(|mass| sign * mass));
        self.boundaries.extend(boundaries);
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

    /// `int phi_n dm`.
    pub(crate) fn mass(&self, n: usize) -> f64 {
        self.masses[n * self.nodes()..(n + 1) * self.nodes()].iter().sum()
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
            *value = line(boundaries, place) + dot(&row, &bubble[first..first + count]);
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

    /// How far the pairs, given at the nodes of a finer operator, are from being its eigenpairs, relative to the largest eigenvalue: the largest `||K phi_n - nu_n phi_n||`
    /// and the largest `sqrt|nu_k nu_m| |<phi_k, phi_m> - delta_km|`.
    pub(crate) fn defect(&self, rows: &[f64], finer: &SincOperator) -> f64 {
        let scaled: Vec<Vec<Vec<f64>>> = (rows.chunks_exact(finer.count()))
            .map(|row| finer.blocks().iter().map(|block| block.scaled(row)).collect())
            .collect();
        let product = |left: &[Vec<f64>], right: &[Vec<f64>]| -> f64 {
            (finer.blocks().iter().zip(left.iter().zip(right)))
                .map(|(block, (l, r))| block.multiplicity() * dot(l, r))
                .sum()
        };
        let mut worst = 0.0f64;
        for (n, (z, eigenvalue)) in scaled.iter().zip(&self.eigenvalues).enumerate() {
            let residual: Vec<Vec<f64>> = (finer.blocks().iter().zip(z))
                .map(|(block, z)| {
                    let image = multiply_rows(&block.matrix, z);
                    image.iter().zip(z).map(|(image, z)| image - eigenvalue * z).collect()
                })
                .collect();
            worst = larger(worst, product(&residual, &residual).sqrt());
            for (m, (other, other_eigenvalue)) in
                scaled[..=n].iter().zip(&self.eigenvalues).enumerate()
            {
                let expected = f64::from(u8::from(m == n));
                let weight = (eigenvalue * other_eigenvalue).abs().sqrt();
                worst = larger(worst, weight * (product(z, other) - expected).abs());
            }
        }
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
