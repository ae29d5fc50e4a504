//! An approximate inverse of the operator: exact for means over groups of panels.

use super::kernel::PanelKernel;
use super::panels::Panels;
use crate::Error;
use crate::linear::Cholesky;

/// Groups of neighbouring panels without gaps, and the operator `1 + theta K` on functions that are constant on each.
#[derive(Debug)]
pub struct Groups {
    /// First node of each group, and the number of nodes.
    starts: Vec<usize>,
    lengths: Vec<f64>,
    factor: Cholesky,
}

impl Groups {
    /// Groups no longer than `longest`, at least one for each run of panels without gaps.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] where rounding makes the matrix of the groups not positive.
    pub fn new(
        kernel: PanelKernel,
        panels: &Panels,
        theta: f64,
        longest: f64,
    ) -> Result<Self, Error> {
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
        let lengths: Vec<f64> = intervals.iter().map(|[left, right]| right - left).collect();
        let factor = Cholesky::new(intervals.len(), |i, j| {
            let [left, right] = [intervals[i.min(j)], intervals[i.max(j)]];
            let layer = if i == j { lengths[i] } else { 0.0 };
            layer + theta * lengths[i] * lengths[j] * kernel.mean(left, right)
        })?;
        Ok(Self { starts: firsts, lengths, factor })
    }

    /// Number of groups.
    #[must_use]
    pub fn count(&self) -> usize {
        self.lengths.len()
    }

    /// About `(1 + theta K)^-1 phi`: the means through the matrix, what deviates from them as it is.
    pub(super) fn roughly_inverted(&self, panels: &Panels, values: &[f64]) -> Vec<f64> {
        let parts = || self.starts.windows(2).map(|pair| pair[0]..pair[1]);
        let sums: Vec<f64> = parts()
            .map(|part| {
                let weights = &panels.weights()[part.clone()];
                weights.iter().zip(&values[part]).map(|(w, v)| w * v).sum()
            })
            .collect();
        let mut solved = sums.clone();
        self.factor.solve(&mut solved);
        let mut result = values.to_vec();
        for (k, part) in parts().enumerate() {
            let shift = solved[k] - sums[k] / self.lengths[k];
            result[part].iter_mut().for_each(|value| *value += shift);
        }
        result
    }
}
