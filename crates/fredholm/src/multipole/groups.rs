//! An approximate inverse of the operator: exact for means over groups of panels, and on each group by itself for what deviates from them.
//!
//! What deviates from its mean over a group is felt by other groups as a dipole only. Means and deviations, each solved by themselves, leave a condition that grows as the logarithm of the number of
//! panels of a group (T. Tran, E. P. Stephan, *Additive Schwarz methods for the h-version boundary element method*, Appl. Anal. 60 (1996) 63).

use std::ops::Range;

use super::boxes::Part;
use super::kernel::PanelKernel;
use super::near::NearEntries;
use super::panels::Panels;
use super::threads::{each, parts_of};
use crate::Error;
use crate::linear::{Cholesky, Factored, dot};

/// `theta K` on half a group up to which deviations from the mean are as good as solved: as they are.
const THIN: f64 = 0.25;
/// Most nodes of a longer group: its matrix is dense.
const MOST_NODES: usize = 128;

/// Groups of neighbouring panels without gaps, the operator `1 + theta K w` on functions that are constant on each, and on each of them.
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
    /// The operator on the groups that are not thin.
    deviations: Vec<Option<Deviations>>,
    /// With them, for one function.
    multiplications: usize,
}

/// `1 + theta K w` on a group, for functions whose weighted mean is zero.
#[derive(Debug)]
struct Deviations {
    factored: Factored,
    /// What the constant 1 leads to, over its integral.
    response: Vec<f64>,
}

impl Deviations {
    /// None where rounding makes the matrix of the group singular.
    fn new(
        near: &NearEntries<'_>,
        theta: f64,
        (weight, weights): (Option<&[f64]>, &[f64]),
        part: Range<usize>,
    ) -> Option<Self> {
        let count = part.len();
        let mut rows = vec![0.0; count * count];
        near.fill(part.clone(), &[Part { nodes: part.clone(), is_far: false }], &mut rows);
        if let Some(weight) = weight {
            for row in rows.chunks_exact_mut(count) {
                row.iter_mut().zip(&weight[part.clone()]).for_each(|(entry, w)| *entry *= w);
            }
        }
        let columns: Vec<f64> =
            (0..count * count).map(|k| rows[k % count * count + k / count]).collect();
        let factored = Factored::indefinite(&columns, count, theta).ok()?;
        let mut response = vec![1.0; count];
        factored.solve(&mut response);
        let integral = dot(&response, &weights[part]);
        response.iter_mut().for_each(|value| *value /= integral);
        (integral > 0.0 && integral.is_finite()).then_some(Self { factored, response })
    }

    /// Overwrites values with the function of mean zero that they, but for a constant, are of.
    fn solve(&self, weights: &[f64], values: &mut [f64]) {
        self.factored.solve(values);
        let integral = dot(values, weights);
        values.iter_mut().zip(&self.response).for_each(|(value, r)| *value -= integral * r);
    }
}

impl Groups {
    /// Groups no longer than `longest`, at least one for each run of panels without gaps, for a weight `w >= 0` at the nodes or 1; those longer than the layer have few nodes.
    ///
    /// # Errors
    /// [`Error::WrongLength`] for a weight that does not fit the nodes, [`Error::NotPositiveDefinite`] where rounding makes the matrix of the groups not positive.
    pub fn new(
        kernel: &PanelKernel,
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
        let heaviest = weight.map_or(1.0, |weight| weight.iter().fold(0.0, |a, b| b.max(a)));
        let strength = theta * heaviest;
        let is_thin =
            |[left, right]: [f64; 2]| strength * kernel.scale(0.5 * (right - left))[0] <= THIN;
        for (k, [left, right]) in panels.bounds().iter().copied().enumerate() {
            let nodes = |firsts: &[usize]| (k + 1) * panels.order() - firsts.last().unwrap_or(&0);
            let fits = |from: f64| {
                let is_short = right - from <= longest;
                is_short && (nodes(&firsts) <= MOST_NODES || is_thin([from, right]))
            };
            match intervals.last_mut() {
                Some(last) if last[1] == left && fits(last[0]) => last[1] = right,
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
        let mean = |i: usize, j: usize| kernel.mean(intervals[i.min(j)], intervals[i.max(j)]);
        // On a whole circle constants have no potential, of which the means fall short.
        let is_whole = kernel.is_closed() && panels.are_whole();
        let lengths: Vec<f64> =
            intervals.iter().map(|[left, right]| 0.5 * (right - left)).collect();
        let constants: Vec<f64> = (0..intervals.len())
            .map(|i| (0..lengths.len()).filter(|_| is_whole).map(|j| mean(i, j) * lengths[j]).sum())
            .collect();
        let level = dot(&constants, &lengths);
        let factor = Cholesky::new(intervals.len(), |i, j| {
            let layer = if i == j { 1.0 } else { 0.0 };
            let potential = mean(i, j) - constants[i] - constants[j] + level;
            layer + theta * roots[i] * roots[j] * potential
        })?;
        let near = NearEntries::new(kernel, panels);
        let mut deviations: Vec<Option<Deviations>> = intervals.iter().map(|_| None).collect();
        let mut thick: Vec<(&mut Option<Deviations>, Range<usize>)> =
            (deviations.iter_mut().zip(firsts.windows(2)).zip(&intervals))
                .filter(|(_, interval)| !is_thin(**interval))
                .map(|((place, pair), _)| (place, pair[0]..pair[1]))
                .collect();
        let powers = |power: u32| thick.iter().map(|(_, part)| part.len().pow(power)).sum();
        let multiplications = powers(2);
        let share = thick.len().div_ceil(parts_of(powers(3))).max(1);
        each(thick.chunks_mut(share).collect(), |share| {
            for (place, part) in share {
                **place = Deviations::new(&near, theta, (weight, &weights), part.clone());
            }
        });
        Ok(Self { starts: firsts, masses, weights, factor, deviations, multiplications })
    }

    /// Number of groups.
    #[must_use]
    pub fn count(&self) -> usize {
        self.masses.len()
    }

    /// About `(1 + theta K w)^-1 phi`: the weighted means through the matrix, what deviates from them group by group.
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
        let mut rest = &mut result[..];
        let mut groups: Vec<(usize, Range<usize>, &mut [f64])> = (parts().enumerate())
            .map(|(k, part)| {
                let own = rest.split_off_mut(..part.len()).unwrap_or_default();
                (k, part, own)
            })
            .collect();
        let share = groups.len().div_ceil(parts_of(self.multiplications)).max(1);
        each(groups.chunks_mut(share).collect(), |share| {
            for (k, part, values) in share {
                let mean = match &self.deviations[*k] {
                    Some(deviations) => {
                        deviations.solve(&self.weights[part.clone()], values);
                        0.0
                    }
                    None => sums[*k],
                };
                let shift = if roots[*k] > 0.0 { (solved[*k] - mean) / roots[*k] } else { 0.0 };
                values.iter_mut().for_each(|value| *value += shift);
            }
        });
        result
    }
}
