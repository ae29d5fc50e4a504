//! Entries of the matrix of a kernel on a mesh.

use std::ops::Range;

use super::mesh::Mesh;
use super::weights::{Differences, SincWeights};
use crate::kernel::Kernel;

/// Entries of the unscaled matrix, less the weights.
pub(super) struct Entries<'k> {
    kernel: &'k dyn Kernel,
    pub(super) mesh: &'k Mesh,
    /// Weights of the nodes times the density of the measure. Nodes without mass have empty rows and columns: there the kernel may overflow.
    pub(super) masses: &'k [f64],
    weights: SincWeights,
}

/// What a row needs beside itself.
pub(super) struct Scratch {
    distances: Vec<f64>,
    factors: Vec<f64>,
}

impl Scratch {
    pub(super) fn new(count: usize) -> Self {
        Self { distances: vec![0.0; count], factors: vec![0.0; count] }
    }
}

impl<'k> Entries<'k> {
    pub(super) fn new(kernel: &'k dyn Kernel, mesh: &'k Mesh, masses: &'k [f64]) -> Self {
        let weights = SincWeights::new(kernel.singularity(), mesh.panel_count());
        Self { kernel, mesh, masses, weights }
    }

    /// The entry on the diagonal.
    pub(super) fn diagonal(&self, i: usize) -> f64 {
        if self.masses[i] == 0.0 {
            return 0.0;
        }
        let x = self.mesh.positions()[i];
        self.weights.at_node(self.kernel.split(x, x, 0.0), self.mesh.weights()[i])
    }

    /// The entries `(i, j)` for the nodes `j` of a range that ends before `i` or begins after it.
    pub(super) fn row(
        &self,
        i: usize,
        range: Range<usize>,
        row: &mut [f64],
        scratch: &mut Scratch,
    ) {
        row[..range.len()].fill(0.0);
        if self.masses[i] == 0.0 {
            return;
        }
        let x = self.mesh.positions()[i];
        for segment in self.mesh.segments(range.clone()) {
            let Some(segment) = with_mass(self.masses, segment) else { continue };
            let Scratch { distances, factors } = scratch;
            let (distances, factors) =
                (&mut distances[..segment.len()], &mut factors[..segment.len()]);
            let entries = &mut row[segment.start - range.start..segment.end - range.start];
            self.mesh.distances(i, segment.clone(), distances);
            let points = &self.mesh.positions()[segment.clone()];
            if self.mesh.panel(i) != self.mesh.panel(segment.start) {
                self.kernel.values(x, points, distances, entries, factors);
            } else {
                self.kernel.pairs(x, points, distances, entries, factors);
                let differences = if segment.start > i {
                    Differences::Growing(segment.start - i..segment.end - i)
                } else {
                    Differences::Falling(i + 1 - segment.end..i + 1 - segment.start)
                };
                self.weights.apart_in_row(entries, factors, distances, differences);
            }
            for (entry, mass) in entries.iter_mut().zip(&self.masses[segment]) {
                // Chosen, not skipped: a store that may not take place keeps loops from vector units.
                *entry = if *mass == 0.0 { 0.0 } else { *entry };
            }
        }
    }
}

/// A range of nodes without those at its ends that have no mass.
pub(super) fn with_mass(masses: &[f64], range: Range<usize>) -> Option<Range<usize>> {
    let masses = &masses[range.clone()];
    let first = masses.iter().position(|mass| *mass > 0.0)?;
    let last = masses.iter().rposition(|mass| *mass > 0.0)?;
    Some(range.start + first..range.start + last + 1)
}
