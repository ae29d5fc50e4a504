//! Products of the logarithm with functions on panels.

use std::sync::Arc;

use super::panels::Panels;
use super::tree::{Locals, Tree, interpolate};
use crate::Error;
use crate::linear::dot;

/// Nodes of a leaf, about.
const CROWD: usize = 24;
/// Most entries of the near part.
const MOST_ENTRIES: usize = 60_000_000;
/// Longest panel, as a share of `[-1, 1]`: it must lie in a leaf and its neighbours with all places that it is near to.
pub(super) const LONGEST: f64 = 0.05;

/// `phi -> int ln(1/|x - s|) phi(s) ds` for functions on [`Panels`]: near panels by exact moments of the polynomials, far ones through a tree of boxes, in time
/// proportional to the number of nodes.
#[derive(Debug)]
pub struct PanelLogarithm {
    panels: Arc<Panels>,
    tree: Arc<Tree>,
    /// The matrices of the leaves, one after the other.
    near: Vec<f64>,
    near_starts: Vec<usize>,
}

impl PanelLogarithm {
    /// For these panels, none of which may be longer than 0.1.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for longer panels, [`Error::TooLarge`] where the nodes crowd so much that the near part does not fit into memory.
    pub fn new(panels: Panels) -> Result<Self, Error> {
        let longest =
            panels.bounds.iter().fold(0.0f64, |most, [left, right]| most.max(right - left));
        if longest > 2.0 * LONGEST {
            return Err(Error::InvalidParameter {
                name: "length of a panel",
                value: longest,
                requirement: "at most 0.1",
            });
        }
        let reach = 0.5 * (panels.rule.far + 1.0) * longest;
        let tree = Tree::new(panels.nodes(), reach, CROWD);
        let mut near_starts = vec![0];
        for leaf in 0..tree.leaves() {
            let entries = tree.nodes_of(leaf, leaf).len() * tree.near(leaf).len();
            near_starts.push(near_starts[leaf] + entries);
        }
        let entries = near_starts[tree.leaves()];
        if entries > MOST_ENTRIES {
            return Err(Error::TooLarge {
                degree: panels.count(),
                needed: 8 * entries as u64,
                available: 8 * MOST_ENTRIES as u64,
            });
        }
        let mut near = vec![0.0; entries];
        for leaf in 0..tree.leaves() {
            let block = &mut near[near_starts[leaf]..near_starts[leaf + 1]];
            fill_near(&panels, &tree, leaf, block);
        }
        Ok(Self { panels: Arc::new(panels), tree: Arc::new(tree), near, near_starts })
    }

    /// The panels.
    #[must_use]
    pub fn panels(&self) -> &Panels {
        &self.panels
    }

    /// The potential at the nodes of a function with these values there. Missing values are zero, others ignored.
    #[must_use]
    pub fn potential(&self, values: &[f64]) -> Vec<f64> {
        let charges = self.charges(values);
        let locals = self.tree.locals(&charges, false);
        let values: Vec<f64> =
            (0..self.panels.count()).map(|j| values.get(j).copied().unwrap_or(0.0)).collect();
        let mut result = vec![0.0; self.panels.count()];
        for leaf in 0..self.tree.leaves() {
            let near = self.tree.near(leaf);
            let block = &self.near[self.near_starts[leaf]..self.near_starts[leaf + 1]];
            let rows = block.chunks_exact(near.len().max(1));
            for (node, row) in self.tree.nodes_of(leaf, leaf).zip(rows) {
                result[node] =
                    dot(row, &values[near.clone()]) + self.tree.at_node(&locals, leaf, node);
            }
        }
        result
    }

    fn charges(&self, values: &[f64]) -> Vec<f64> {
        let value = |j: usize| values.get(j).copied().unwrap_or(0.0);
        self.panels.weights().iter().enumerate().map(|(j, w)| w * value(j)).collect()
    }

    /// The potential at any place of a function with these values at the nodes.
    #[must_use]
    pub fn field(&self, values: &[f64]) -> PanelField {
        let order = self.panels.order();
        let charges = self.charges(values);
        let locals = self.tree.locals(&charges, true);
        let mut values = values.to_vec();
        values.resize(self.panels.count(), 0.0);
        let mut coefficients = vec![0.0; values.len()];
        for (c, v) in coefficients.chunks_exact_mut(order).zip(values.chunks_exact(order)) {
            self.panels.rule.coefficients(v, c);
        }
        let (panels, tree) = (Arc::clone(&self.panels), Arc::clone(&self.tree));
        PanelField { panels, tree, locals, charges, coefficients }
    }
}

/// The rows of the nodes of a leaf, for the nodes near to it.
fn fill_near(panels: &Panels, tree: &Tree, leaf: usize, block: &mut [f64]) {
    let near = tree.near(leaf);
    let order = panels.order();
    let mut exact = vec![0.0; order];
    let rows = block.chunks_exact_mut(near.len().max(1));
    for (node, row) in tree.nodes_of(leaf, leaf).zip(rows) {
        let x = panels.nodes()[node];
        for panel in near.start / order..near.end.div_ceil(order) {
            let all = panel * order..(panel + 1) * order;
            let (middle, half) = panels.middle(panel);
            let z = (x - middle) / half;
            if z.abs() < panels.rule.far {
                if all.contains(&node) {
                    let own = (node - all.start) * order;
                    exact.copy_from_slice(&panels.rule.own[own..own + order]);
                } else {
                    panels.rule.weights_at(z, &mut exact);
                }
                let level = -half.ln();
                for (k, j) in all.enumerate().filter(|(_, j)| near.contains(j)) {
                    row[j - near.start] = half * (exact[k] + level * panels.rule.weights[k]);
                }
            } else {
                for j in all.filter(|j| near.contains(j)) {
                    row[j - near.start] = -panels.weights()[j] * (x - panels.nodes()[j]).abs().ln();
                }
            }
        }
    }
}

/// `int ln(1/|x - s|) phi(s) ds` at any place.
#[derive(Debug, Clone)]
pub struct PanelField {
    panels: Arc<Panels>,
    tree: Arc<Tree>,
    locals: Locals,
    charges: Vec<f64>,
    coefficients: Vec<f64>,
}

impl PanelField {
    /// The panels.
    #[must_use]
    pub fn panels(&self) -> &Panels {
        &self.panels
    }

    /// The potential at a place, inside the panels or beside them; beyond `[-1, 1]` by the sum over all panels.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        if x.is_nan() || x.abs() > 1.0 {
            return self.direct(x, 0..self.panels.count());
        }
        let leaf = self.tree.leaf(x);
        let points = super::tree::POINTS;
        let local = &self.locals[leaf * points..(leaf + 1) * points];
        interpolate(local, self.tree.inside(leaf, x)) + self.direct(x, self.tree.near(leaf))
    }

    /// The potential of some nodes.
    fn direct(&self, x: f64, nodes: std::ops::Range<usize>) -> f64 {
        let order = self.panels.order();
        let mut moments = [0.0; super::rule::MOST];
        let moments = &mut moments[..order];
        let mut sum = 0.0;
        for panel in nodes.start / order..nodes.end.div_ceil(order) {
            let all = panel * order..(panel + 1) * order;
            let (middle, half) = self.panels.middle(panel);
            let z = (x - middle) / half;
            if z.abs() < self.panels.rule.far {
                super::rule::logarithm_moments(z, moments);
                let c = &self.coefficients[all];
                let moment: f64 = moments.iter().zip(c).map(|(m, c)| m * c).sum();
                sum += half * (moment - half.ln() * 2.0 * c[0]);
            } else {
                let part = all.start.max(nodes.start)..all.end.min(nodes.end);
                let places = &self.panels.nodes()[part.clone()];
                for (node, charge) in places.iter().zip(&self.charges[part]) {
                    sum -= charge * (x - node).abs().ln();
                }
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Panels of very different lengths, with gaps.
    fn uneven() -> Vec<[f64; 2]> {
        let mut bounds = Vec::new();
        let mut left = -1.0;
        for i in 0..400 {
            let length = 0.004 * (1.1 + (1.7 * f64::from(i)).sin()) / 2.2;
            bounds.push([left, left + length]);
            left += length;
            if i % 7 == 3 {
                left += 0.01;
            }
        }
        for i in 0..20 {
            let [from, to] = [1.0 - 0.1 * 0.4f64.powi(i), 1.0 - 0.1 * 0.4f64.powi(i + 1)];
            bounds.push([from, to]);
        }
        bounds
    }

    #[test]
    fn products_agree_with_those_in_closed_form() {
        // phi = 2 + x: int ln(1/|x - s|) (2 + s) ds by its primitive on each panel
        let panels = Panels::new(uneven(), 6).unwrap();
        let operator = PanelLogarithm::new(panels).unwrap();
        let primitive = |x: f64, s: f64| {
            let d = s - x;
            if d == 0.0 {
                return 0.0;
            }
            let logarithm = d.abs().ln();
            (2.0 + x) * d * (1.0 - logarithm) + 0.5 * d * d * (0.5 - logarithm)
        };
        let exact = |x: f64| -> f64 {
            let bounds = operator.panels().bounds();
            bounds.iter().map(|[left, right]| primitive(x, *right) - primitive(x, *left)).sum()
        };
        let values: Vec<f64> = operator.panels().nodes().iter().map(|x| 2.0 + x).collect();
        for (x, found) in operator.panels().nodes().iter().zip(operator.potential(&values)) {
            assert!((found - exact(*x)).abs() < 2e-13, "{x}: {found} {}", exact(*x));
        }
        let field = operator.field(&values);
        for i in -60..=60 {
            let x = f64::from(i) / 57.3;
            assert!((field.at(x) - exact(x)).abs() < 2e-13, "{x}: {} {}", field.at(x), exact(x));
        }
    }
}
