//! Products of a kernel with functions on panels.

use std::mem;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

use super::boxes::{Boxes, Leaf, Part};
use super::far::OfBoxes;
use super::kernel::PanelKernel;
use super::near::NearEntries;
use super::on_panel::OnPanel;
use super::panels::Panels;
use super::rings::Rings;
use super::sums::{Lanes, PlainSum};
use super::threads::{each, parts_of};
use super::tree::{self, AtPoints, Tree, interpolate};
use crate::Error;
use crate::linear::{dot, vectorised};
use crate::quadrature::{Node, gauss_power};

/// Multiplications that an entry of the near part takes to be found, about.
const FILLING: usize = 30;
/// The same of the potential at a place.
const EVALUATION: usize = 600;
/// Most entries of the near part: with those of the operator before, and the directions of a solution, they stay below a gigabyte.
const MOST_ENTRIES: usize = 40_000_000;
/// Longest panel, as a share of `[-1, 1]`: on a circle what it is near to may not reach around.
pub(super) const LONGEST: f64 = 0.05;

/// `phi -> int K(x - s) phi(s) ds` for functions on [`Panels`]: near panels by exact moments of the polynomials, far ones through a tree of boxes, in time
/// proportional to the number of nodes.
#[derive(Debug)]
pub struct PanelOperator {
    kernel: PanelKernel,
    panels: Arc<Panels>,
    tree: Arc<Tree>,
    /// The matrices of the leaves, each by itself: those of panels that stay are shared with the operator before, and one block for all would be given back to the system and asked for again with every
    /// operator, which takes longer than a product.
    near: Vec<Arc<Vec<f64>>>,
    /// How many entries those before a leaf have.
    near_starts: Vec<usize>,
}

impl PanelOperator {
    /// For these panels, none of which may be longer than 0.1.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for longer panels and exponents that are not between 0 and 1, [`Error::TooLarge`] where the nodes crowd so much that the near part does not fit into memory.
    pub fn new(kernel: PanelKernel, panels: Panels) -> Result<Self, Error> {
        Self::beside(kernel, panels, None)
    }

    /// The same to the last bit, faster where another operator has the same panels in many places.
    ///
    /// # Errors
    /// Those of [`PanelOperator::new`].
    pub fn beside(
        kernel: PanelKernel,
        panels: Panels,
        other: Option<&Self>,
    ) -> Result<Self, Error> {
        let (boxes, near_starts) = Self::boxes(&kernel, &panels)?;
        let other = other.filter(|other| other.kernel == kernel);
        let tree = Tree::new(&kernel, &panels, boxes, other.map(|other| &*other.tree));
        let other = other.filter(|other| other.panels.order() == panels.order());
        let entries = NearEntries::new(&kernel, &panels);
        let lengths = near_starts.windows(2).map(|pair| pair[1] - pair[0]);
        // Asked for by one thread: libraries give back less of what that frees.
        let mut new: Vec<Vec<f64>> = lengths.clone().map(Vec::with_capacity).collect();
        let leaves = &tree.boxes.leaves;
        let mut near: Vec<Arc<Vec<f64>>> = vec![Arc::default(); leaves.len()];
        let mut rest = near.iter_mut().zip(leaves).zip(&mut new).zip(lengths);
        let parts = shares(&near_starts, FILLING);
        let parts = parts.into_iter().map(|leaves| rest.by_ref().take(leaves.len()).collect());
        each(parts.collect(), |part: Vec<_>| {
            for (((block, leaf), new), length) in part {
                let known = other.and_then(|other| other.block(leaf, &panels));
                *block = known.unwrap_or_else(|| {
                    new.resize(length, 0.0);
                    entries.fill(leaf.nodes.clone(), &leaf.near, new);
                    Arc::new(mem::take(new))
                });
            }
        });
        Ok(Self { kernel, panels: Arc::new(panels), tree: Arc::new(tree), near, near_starts })
    }

    /// Whether there can be one for these panels.
    ///
    /// # Errors
    /// Those of [`PanelOperator::new`].
    pub fn check(kernel: &PanelKernel, panels: &Panels) -> Result<(), Error> {
        Self::boxes(kernel, panels).map(drop)
    }

    /// The boxes, and where the matrices of the leaves begin.
    fn boxes(kernel: &PanelKernel, panels: &Panels) -> Result<(Boxes, Vec<usize>), Error> {
        kernel.check()?;
        if kernel.rings().is_some() != panels.are_rings {
            return Err(Error::InvalidParameter {
                name: "begin of the first panel",
                value: panels.bounds[0][0],
                requirement: "that of rings about an axis for their kernel, and for no other",
            });
        }
        let longest =
            panels.bounds.iter().fold(0.0f64, |most, [left, right]| most.max(right - left));
        if longest > 2.0 * LONGEST {
            return Err(Error::InvalidParameter {
                name: "length of a panel",
                value: longest,
                requirement: "at most 0.1",
            });
        }
        let boxes = tree::boxes(kernel, panels);
        let mut near_starts = vec![0];
        let mut entries = 0;
        for leaf in &boxes.leaves {
            entries += leaf.nodes.len() * leaf.count();
            near_starts.push(entries);
        }
        if entries > MOST_ENTRIES {
            return Err(Error::TooLarge {
                degree: panels.count(),
                needed: 8 * entries as u64,
                available: 8 * MOST_ENTRIES as u64,
            });
        }
        Ok((boxes, near_starts))
    }

    /// The matrix of a leaf of another tree, if it is that of these panels, too.
    fn block(&self, other: &Leaf, others: &Panels) -> Option<Arc<Vec<f64>>> {
        let leaf = self.tree.boxes.find(other.name)?;
        let own = &self.tree.boxes.leaves[leaf];
        let is_same = own.is_like(&self.panels, other, others);
        is_same.then(|| Arc::clone(&self.near[leaf]))
    }

    /// The panels.
    #[must_use]
    pub fn panels(&self) -> &Panels {
        &self.panels
    }

    /// The number of pairs of nodes that are so near that the kernel is integrated for them by themselves: as long as a product takes, and the more so to find the operator.
    #[must_use]
    pub fn near_pairs(&self) -> usize {
        self.near_starts[self.near.len()]
    }

    /// The potential at the nodes of a function with these values there. Missing values are zero, others ignored.
    #[must_use]
    pub fn potential(&self, values: &[f64]) -> Vec<f64> {
        self.potentials(&[values]).swap_remove(0)
    }

    /// The same of several functions, each to the last bit as by itself: what is known of the nodes is read once for all.
    #[must_use]
    pub fn potentials(&self, all: &[&[f64]]) -> Vec<Vec<f64>> {
        let mut found = Vec::with_capacity(all.len());
        let (threes, rest) = all.as_chunks::<3>();
        threes.iter().for_each(|some| found.extend(self.potentials_of(some)));
        match rest {
            [one, two] => found.extend(self.potentials_of(&[one, two])),
            [one] => found.extend(self.potentials_of(&[one])),
            _ => {}
        }
        found
    }

    fn potentials_of<const N: usize>(&self, all: &[&[f64]; N]) -> [Vec<f64>; N] {
        let values = all.map(|values| self.without_mean(values));
        let charges = values.each_ref().map(|values| self.panels.charges(values));
        let mut results = [(); N].map(|()| vec![0.0; self.panels.count()]);
        let locals = self.tree.locals(charges.each_ref().map(Vec::as_slice), false);
        let mut rest = results.each_mut().map(|result| &mut result[..]);
        let parts = shares(&self.near_starts, N).into_iter().map(|leaves| {
            let own = &self.tree.boxes.leaves[leaves.clone()];
            let length = own.iter().map(|leaf| leaf.nodes.len()).sum();
            let own = rest.each_mut().map(|rest| rest.split_off_mut(..length).unwrap_or_default());
            (leaves, own)
        });
        each(parts.collect(), |(leaves, mut own)| {
            vectorised(
                #[inline(always)]
                || self.add_up(leaves, &values, &locals, &mut own),
            );
        });
        results
    }

    /// The potentials at the nodes of some leaves.
    #[inline(always)]
    fn add_up<const N: usize>(
        &self,
        leaves: Range<usize>,
        values: &[Vec<f64>; N],
        locals: &[AtPoints<N>],
        results: &mut [&mut [f64]; N],
    ) {
        let Boxes { cells, leaves: all, .. } = &self.tree.boxes;
        let first = all[leaves.start].nodes.start;
        for (leaf, near) in all[leaves.clone()].iter().zip(&self.near[leaves]) {
            let mut rows = near.chunks_exact(leaf.count().max(1));
            for end in leaf.ends.clone() {
                for (node, row) in cells[end].nodes.clone().zip(&mut rows) {
                    for k in 0..N {
                        let mut sum = Lanes::default();
                        sum.add(&locals[end][k], self.tree.at_node(node));
                        let mut row = row;
                        for Part { nodes, .. } in &leaf.near {
                            let (own, rest) = row.split_at(nodes.len());
                            sum.add(own, &values[k][nodes.clone()]);
                            row = rest;
                        }
                        results[k][node - first] = sum.total();
                    }
                }
            }
        }
    }

    /// The values, on a whole circle less their mean, whose potential is zero: what products make of it is rounding.
    fn without_mean(&self, values: &[f64]) -> Vec<f64> {
        let mut values = values.to_vec();
        values.resize(self.panels.count(), 0.0);
        if self.kernel.is_closed() && self.panels.are_whole() {
            let mean = 0.5 * self.panels.charges(&values).iter().sum::<f64>();
            values.iter_mut().for_each(|value| *value -= mean);
        }
        values
    }

    /// The potential at any place of a function with these values at the nodes.
    #[must_use]
    pub fn field(&self, values: &[f64]) -> PanelField {
        let values = self.without_mean(values);
        let (panels, tree) = (Arc::clone(&self.panels), Arc::clone(&self.tree));
        PanelField { kernel: self.kernel.clone(), panels, tree, values, sources: OnceLock::new() }
    }
}

/// The leaves in parts with about as many entries each, an entry being worth so many multiplications.
fn shares(starts: &[usize], worth: usize) -> Vec<Range<usize>> {
    let leaves = starts.len() - 1;
    let entries = starts[leaves];
    let parts = parts_of(worth * entries);
    let mut ends: Vec<usize> = (1..parts)
        .map(|part| starts.partition_point(|start| *start < entries / parts * part))
        .collect();
    ends.push(leaves);
    let mut first = 0;
    let mut shares = Vec::with_capacity(parts);
    for end in ends {
        if end > first {
            shares.push(first..end.min(leaves));
            first = end.min(leaves);
        }
    }
    shares
}

/// `int K(x - s) phi(s) ds` at any place.
#[derive(Debug, Clone)]
pub struct PanelField {
    kernel: PanelKernel,
    panels: Arc<Panels>,
    tree: Arc<Tree>,
    values: Vec<f64>,
    /// Found once a potential is asked for: of many functions only their values are.
    sources: OnceLock<Sources>,
}

/// What gives the potential of a function.
#[derive(Debug, Clone)]
struct Sources {
    locals: OfBoxes<1>,
    charges: Vec<f64>,
    /// Legendre coefficients, panel by panel.
    coefficients: Vec<f64>,
}

impl Sources {
    fn new(panels: &Panels, tree: &Tree, values: &[f64]) -> Self {
        let charges = panels.charges(values);
        let locals = tree.locals([&charges], true);
        let order = panels.order();
        let mut coefficients = vec![0.0; values.len()];
        for (c, v) in coefficients.chunks_exact_mut(order).zip(values.chunks_exact(order)) {
            panels.rule.coefficients(v, c);
        }
        Self { locals, charges, coefficients }
    }
}

impl PanelField {
    fn sources(&self) -> &Sources {
        self.sources.get_or_init(|| Sources::new(&self.panels, &self.tree, &self.values))
    }

    /// The panels.
    #[must_use]
    pub fn panels(&self) -> &Panels {
        &self.panels
    }

    /// The potential at a place, inside the panels or beside them; beyond `[-1, 1]` by the sum over all panels, on a circle that of its image.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        let x = self.kernel.shortest(x);
        if x.is_nan() || x.abs() > 1.0 {
            return self.direct(x, 0..self.panels.count());
        }
        let boxes = &self.tree.boxes;
        let leaf = boxes.leaf(x);
        let end = boxes.end(leaf, x);
        let [local] = &self.sources().locals[end];
        let (middle, half) = boxes.cells[end].middle();
        interpolate(local, (x - middle) / half) + self.near(x, &boxes.leaves[leaf].near)
    }

    /// The potential of what is near to a leaf, but for what boxes have of it.
    fn near(&self, x: f64, parts: &[Part]) -> f64 {
        let order = self.panels.order();
        let mut sum = 0.0;
        for Part { nodes, is_far } in parts {
            let panel = nodes.start / order;
            if !is_far {
                sum += self.direct(x, nodes.clone());
            } else if self.panels.local(&self.kernel, panel, x).z.abs() < self.panels.rule.far {
                let own = panel * order..(panel + 1) * order;
                let meets = |part: &Part| part.nodes.start < own.end && own.start < part.nodes.end;
                // Of a panel that has nodes in a neighbour that gave all of it.
                if !parts.iter().any(|part| !part.is_far && meets(part)) {
                    sum += self.direct(x, own.clone());
                }
                let mut plain = PlainSum::new(&self.kernel);
                let charges = &self.sources().charges[nodes.clone()];
                for (place, charge) in self.panels.nodes()[nodes.clone()].iter().zip(charges) {
                    plain.add((x, *place), *charge);
                }
                sum -= plain.total();
            }
        }
        sum
    }

    /// The same at many places.
    #[must_use]
    pub fn values(&self, places: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; places.len()];
        // All processors make them, which within a part would be one.
        self.sources();
        let share = places.len().div_ceil(parts_of(EVALUATION * places.len())).max(1);
        let parts = places.chunks(share).zip(values.chunks_mut(share));
        each(parts.collect(), |(places, values)| {
            places.iter().zip(values).for_each(|(x, value)| *value = self.at(*x));
        });
        values
    }

    /// The slope of the potential at places in `[-1, 1]` where the function vanishes, each with the sum of the sizes of what is added up in it: near such places panels have to get shorter. A panel that ends there has a
    /// rule for the power of the distance that it begins with, others are integrated by their nodes.
    #[must_use]
    pub fn slopes(&self, places: &[f64]) -> Vec<[f64; 2]> {
        if places.is_empty() {
            return Vec::new();
        }
        let charges = &self.sources().charges;
        let moments = self.tree.gathered([charges]);
        let order = self.panels.order();
        let rule = gauss_power(order, -self.kernel.exponent()).unwrap_or_default();
        let slope_at = |x: &f64| {
            let (x, ending) = (*x, self.panels.ending_at(*x));
            let mut sums = [0.0; 2];
            let mut add = |place: f64, charge: f64| {
                let part = charge * self.kernel.slope(x, place);
                sums = [sums[0] + part, sums[1] + part.abs()];
            };
            let boxes = &self.tree.boxes;
            let leaf = boxes.leaf(x);
            self.tree.far_of(boxes.end(leaf, x), &moments, &mut add);
            let is_ending = |panel: usize| ending.is_some_and(|(own, _)| own == panel);
            let near = boxes.leaves[leaf].near.iter().filter(|part| !part.is_far);
            let others = near.flat_map(|part| part.nodes.clone());
            for node in others.filter(|node| !is_ending(node / order)) {
                add(self.panels.nodes()[node], charges[node]);
            }
            if let Some(end) = ending {
                for part in self.slopes_from_end(x, end, &rule) {
                    sums = [sums[0] + part, sums[1] + part.abs()];
                }
            }
            sums
        };
        places.iter().map(slope_at).collect()
    }

    /// The parts of the slope at the end of a panel where the function vanishes: `int dK/dx phi ds`, whose factors are `d^(-1 - mu)` and `d` times what is smooth.
    fn slopes_from_end(
        &self,
        x: f64,
        (panel, side): (usize, usize),
        rule: &[Node],
    ) -> impl Iterator<Item = f64> {
        let order = self.panels.order();
        let own = panel * order..(panel + 1) * order;
        let of_nodes = self.panels.nodes()[own.clone()].iter().zip(&self.values[own]);
        let falls: Vec<f64> = of_nodes.map(|(s, value)| value / (s - x)).collect();
        let (length, (middle, half)) =
            (self.panels.bounds[panel][1 - side] - x, self.panels.middle(panel));
        rule.iter().map(move |node| {
            let distance = length * node.from_left;
            let s = x + distance;
            let around = if self.panels.are_rings { s } else { 1.0 };
            let weight = length.abs() * node.weight * node.from_left.powf(self.kernel.exponent());
            let fall = self.panels.rule.interpolate(&falls, ((x - middle) + distance) / half);
            weight * around * self.kernel.slope_across(x, s, -distance) * fall * distance
        })
    }

    /// The potential of some nodes.
    fn direct(&self, x: f64, nodes: Range<usize>) -> f64 {
        let order = self.panels.order();
        let Sources { charges, coefficients, .. } = self.sources();
        let mut moments = [0.0; super::rule::MOST];
        let moments = &mut moments[..order];
        let mut sum = 0.0;
        let mut plain = PlainSum::new(&self.kernel);
        for panel in nodes.start / order..nodes.end.div_ceil(order) {
            let all = panel * order..(panel + 1) * order;
            let (_, half) = self.panels.middle(panel);
            let local = self.panels.local(&self.kernel, panel, x);
            let places = self.panels.nodes();
            if local.z.abs() >= self.panels.rule.far {
                let part = all.start.max(nodes.start)..all.end.min(nodes.end);
                for (place, charge) in places[part.clone()].iter().zip(&charges[part]) {
                    plain.add((x, *place), *charge);
                }
                continue;
            }
            if let Some(rings) = self.kernel.rings() {
                sum += self.of_rings(rings, (x, panel, local));
                continue;
            }
            self.kernel.moments(local, moments);
            let c = &coefficients[all.clone()];
            let moment: f64 = moments.iter().zip(c).map(|(m, c)| m * c).sum();
            let [factor, level] = self.kernel.scale(half);
            sum += factor * moment + half * level * 2.0 * c[0];
            if self.kernel.is_closed() {
                let terms = all.map(|node| charges[node] * self.kernel.remainder(x - places[node]));
                sum += terms.sum::<f64>();
            }
        }
        sum + plain.total()
    }

    /// The potential of a panel of rings near to a place.
    fn of_rings(&self, rings: &Rings, (x, panel, local): (f64, usize, OnPanel)) -> f64 {
        let (rule, order) = (&self.panels.rule, self.panels.order());
        let all = panel * order..(panel + 1) * order;
        let mut weights = [0.0; super::rule::MOST];
        let weights = &mut weights[..order];
        if let Some(radius) = self.panels.radius_from_axis(panel) {
            rule.weights_from_axis(
                rings,
                [x, x - radius].map(|distance| distance / radius),
                weights,
            );
            let scale = radius.powf(1.0 - self.kernel.exponent());
            return scale * dot(weights, &self.values[all]);
        }
        rule.weights_at(&self.kernel, local, weights);
        let (_, half) = self.panels.middle(panel);
        let [factor, level] = self.kernel.scale(half);
        let places = self.panels.nodes()[all.clone()].iter();
        let own = self.panels.weights()[all.clone()].iter();
        for ((exact, place), weight) in weights.iter_mut().zip(places).zip(own) {
            *exact = self.kernel.entry((x, *place), factor * *exact, level, *weight);
        }
        dot(weights, &self.values[all])
    }
}

#[cfg(test)]
mod tests;
