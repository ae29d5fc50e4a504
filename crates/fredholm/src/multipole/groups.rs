//! An approximate inverse of the operator: exact for means over groups of panels.

use super::kernel::PanelKernel;
use super::panels::Panels;
use crate::Error;
use crate::linear::Cholesky;

/// Groups of neighbouring panels without gaps, and the operator `1 + theta K w` on functions that are constant on each.
#[derive(Debug)]
pub struct Groups {
    /// First node of each group, and the number of nodes.
    starts: Vec<usize>,
    /// Integrals of the weight.
    masses: Vec<f64>,
    /// The weight by the weights of the nodes.
    weights: Vec<f64>,
    /// Of `1 + theta sqrt(mass_i mass_j) K_ij`.
    factor: Cholesky,
}

impl Groups {
    /// Groups no longer than `longest`, at least one for each run of panels without gaps, for a weight `w >= 0` at the nodes or 1.
    ///
    /// # Errors
    /// [`Error::WrongLength`] for a weight that does not fit the nodes, [`Error::NotPositiveDefinite`] where rounding makes the matrix of the groups not positive.
    pub fn new(
        kernel: PanelKernel,
        panels: &Panels,
        theta: f64,
        longest: f64,
        weight: Option<&[f64]>,
    ) -> Result<Self, Error> {
        if let Some(found) = weight.map(<[f64]>::len).filter(|found| *found != panels.count()) {
            let what = "weight";
            return Err(Error::WrongLength { what, found, expected: panels.count() });
        }
        let mut firsts: Vec<usize> = Vec::new();
        let mut intervals: Vec<[f64; 2]> = Vec::new();
        for (k, [left, right]) in panels.bounds().iter().copied().enumerate() {
            match intervals.last_mut() {
                Some(last) if last[1] == left && right - last[0] <= longest => last[1] = right,
                _ => {
                    firsts.push(k * panels.order());
                    intervals.push([left, right]);
                }
            }
        }
        firsts.push(panels.count());
        let nodes = panels.weights().iter().enumerate();
        let weights: Vec<f64> =
            nodes.map(|(k, own)| weight.map_or(*own, |weight| own * weight[k])).collect();
        let masses: Vec<f64> =
            firsts.windows(2).map(|pair| weights[pair[0]..pair[1]].iter().sum()).collect();
        let roots: Vec<f64> = masses.iter().map(|mass: &f64| mass.sqrt()).collect();
        let factor = Cholesky::new(intervals.len(), |i, j| {
            let [left, right] = [intervals[i.min(j)], intervals[i.max(j)]];
            let layer = if i == j { 1.0 } else { 0.0 };
            layer + theta * roots[i] * roots[j] * kernel.mean(left, right)
        })?;
        Ok(Self { starts: firsts, masses, weights, factor })
    }

    /// Number of groups.
    #[must_use]
    pub fn count(&self) -> usize {
        self.masses.len()
    }

    /// About `(1 + theta K w)^-1 phi`: the weighted means through the matrix, what deviates from them as it is.
    pub(super) fn roughly_inverted(&self, values: &[f64]) -> Vec<f64> {
        let parts = || self.starts.windows(2).map(|pair| pair[0]..pair[1]);
        let roots: Vec<f64> = self.masses.iter().map(|mass| mass.sqrt()).collect();
        // int w phi/sqrt(mass), and of the result the same.
        let sums: Vec<f64> = parts()
            .zip(&roots)
            .map(|(part, root)| {
                let weights = &self.weights[part.clone()];
                let sum: f64 = weights.iter().zip(&values[part]).map(|(w, v)| w * v).sum();
                if *root > 0.0 { sum / root } else { 0.0 }
            })
            .collect();
        let mut solved = sums.clone();
        self.factor.solve(&mut solved);
        let mut result = values.to_vec();
        for ((k, part), root) in parts().enumerate().zip(&roots) {
            let shift = if *root > 0.0 { (solved[k] - sums[k]) / root } else { 0.0 };
            result[part].iter_mut().for_each(|value| *value += shift);
        }
        result
    }
}
