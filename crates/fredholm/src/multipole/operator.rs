//! Products of a kernel with functions on panels.

use std::ops::Range;
use std::sync::Arc;

use super::kernel::PanelKernel;
use super::near::NearEntries;
use super::panels::Panels;
use super::sums::{Lanes, PlainSum};
use super::threads::{each, parts_of};
use super::tree::{Locals, Tree, interpolate};
use crate::Error;
use crate::linear::vectorised;

/// Nodes of a leaf, about.
const CROWD: usize = 12;
/// Multiplications that an entry of the near part takes to be found, about.
const FILLING: usize = 30;
/// The same of the potential at a place.
const EVALUATION: usize = 600;
/// Most entries of the near part.
const MOST_ENTRIES: usize = 60_000_000;
/// Longest panel, as a share of `[-1, 1]`: it must lie in a leaf and its neighbours with all places that it is near to.
pub(super) const LONGEST: f64 = 0.05;

/// `phi -> int K(x - s) phi(s) ds` for functions on [`Panels`]: near panels by exact moments of the polynomials, far ones through a tree of boxes, in time
/// proportional to the number of nodes.
#[derive(Debug)]
pub struct PanelOperator {
    kernel: PanelKernel,
    panels: Arc<Panels>,
    tree: Arc<Tree>,
    /// The matrices of the leaves, one after the other.
    near: Vec<f64>,
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
        kernel.check()?;
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
        let tree = Tree::new(kernel, panels.nodes(), reach, CROWD);
        let mut near_starts = vec![0];
        for leaf in 0..tree.leaves() {
            let entries = tree.nodes_of(leaf, leaf).len() * count(&tree.near(leaf));
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
        let entries = NearEntries::new(kernel, &panels);
        let other = other.filter(|other| {
            let is_same_tree = other.tree.leaves() == tree.leaves();
            other.kernel == kernel && other.panels.order() == panels.order() && is_same_tree
        });
        let shares = shares(&near_starts, FILLING);
        let mut rest = &mut near[..];
        let parts = shares.into_iter().map(|leaves| {
            let length = near_starts[leaves.end] - near_starts[leaves.start];
            (leaves, rest.split_off_mut(..length).unwrap_or_default())
        });
        each(parts.collect(), |(leaves, mut part)| {
            for leaf in leaves {
                let length = near_starts[leaf + 1] - near_starts[leaf];
                let block = part.split_off_mut(..length).unwrap_or_default();
                match other.and_then(|other| other.block(leaf, &panels, &tree)) {
                    Some(known) => block.copy_from_slice(known),
                    None => entries.fill(tree.nodes_of(leaf, leaf), &tree.near(leaf), block),
                }
            }
        });
        Ok(Self { kernel, panels: Arc::new(panels), tree: Arc::new(tree), near, near_starts })
    }

    /// The matrix of a leaf, if it is that of these panels, too.
    fn block(&self, leaf: usize, panels: &Panels, tree: &Tree) -> Option<&[f64]> {
        let order = panels.order();
        let is_same = |one: Range<usize>, other: Range<usize>| {
            [one.start % order, one.len()] == [other.start % order, other.len()]
                && self.panels.touched(&one) == panels.touched(&other)
        };
        let own = [self.tree.nodes_of(leaf, leaf), tree.nodes_of(leaf, leaf)];
        let near = self.tree.near(leaf).into_iter().zip(tree.near(leaf));
        let pairs = near.chain([(own[0].clone(), own[1].clone())]);
        let are_same = pairs.into_iter().all(|(one, other)| is_same(one, other));
        are_same.then(|| &self.near[self.near_starts[leaf]..self.near_starts[leaf + 1]])
    }

    /// The panels.
    #[must_use]
    pub fn panels(&self) -> &Panels {
        &self.panels
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
        let charges = values.each_ref().map(|values| self.charges(values));
        let mut results = [(); N].map(|()| vec![0.0; self.panels.count()]);
        let mut locals = [(); N].map(|()| Locals::new());
        let share = N.div_ceil(parts_of(N * self.near.len() / 2));
        let parts = charges.chunks(share).zip(locals.chunks_mut(share));
        each(parts.collect(), |(charges, locals)| {
            vectorised(
                #[inline(always)]
                || {
                    for (charges, local) in charges.iter().zip(locals) {
                        *local = self.tree.locals(charges, false);
                    }
                },
            );
        });
        let mut rest = results.each_mut().map(|result| &mut result[..]);
        let parts = shares(&self.near_starts, N).into_iter().map(|leaves| {
            let length = self.tree.nodes_of(leaves.start, leaves.end - 1).len();
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
        locals: &[Locals; N],
        results: &mut [&mut [f64]; N],
    ) {
        let first = self.tree.nodes_of(leaves.start, leaves.start).start;
        for leaf in leaves {
            let near = self.tree.near(leaf);
            let block = &self.near[self.near_starts[leaf]..self.near_starts[leaf + 1]];
            let rows = block.chunks_exact(count(&near).max(1));
            for (node, row) in self.tree.nodes_of(leaf, leaf).zip(rows) {
                for k in 0..N {
                    let mut sum = Lanes::default();
                    let [local, own] = self.tree.at_node(&locals[k], leaf, node);
                    sum.add(local, own);
                    let mut row = row;
                    for part in &near {
                        let (own, rest) = row.split_at(part.len());
                        sum.add(own, &values[k][part.clone()]);
                        row = rest;
                    }
                    results[k][node - first] = sum.total();
                }
            }
        }
    }

    /// The values, on a whole circle less their mean, whose potential is zero: what products make of it is rounding.
    fn without_mean(&self, values: &[f64]) -> Vec<f64> {
        let mut values = values.to_vec();
        values.resize(self.panels.count(), 0.0);
        if self.kernel.is_closed() && self.panels.are_whole() {
            let mean = 0.5 * self.charges(&values).iter().sum::<f64>();
            values.iter_mut().for_each(|value| *value -= mean);
        }
        values
    }

    fn charges(&self, values: &[f64]) -> Vec<f64> {
        self.panels.weights().iter().zip(values).map(|(w, value)| w * value).collect()
    }

    /// The potential at any place of a function with these values at the nodes.
    #[must_use]
    pub fn field(&self, values: &[f64]) -> PanelField {
        let order = self.panels.order();
        let values = self.without_mean(values);
        let charges = self.charges(&values);
        let locals = self.tree.locals(&charges, true);
        let mut coefficients = vec![0.0; values.len()];
        for (c, v) in coefficients.chunks_exact_mut(order).zip(values.chunks_exact(order)) {
            self.panels.rule.coefficients(v, c);
        }
        let (panels, tree) = (Arc::clone(&self.panels), Arc::clone(&self.tree));
        PanelField { kernel: self.kernel, panels, tree, locals, charges, coefficients }
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

/// Number of nodes of both parts.
fn count(near: &[Range<usize>; 2]) -> usize {
    near.iter().map(Range::len).sum()
}

/// `int K(x - s) phi(s) ds` at any place.
#[derive(Debug, Clone)]
pub struct PanelField {
    kernel: PanelKernel,
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

    /// The potential at a place, inside the panels or beside them; beyond `[-1, 1]` by the sum over all panels, on a circle that of its image.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        let x = self.kernel.shortest(x);
        if x.is_nan() || x.abs() > 1.0 {
            return self.direct(x, 0..self.panels.count());
        }
        let leaf = self.tree.leaf(x);
        let points = super::tree::POINTS;
        let local = &self.locals[leaf * points..(leaf + 1) * points];
        let near: f64 = self.tree.near(leaf).into_iter().map(|part| self.direct(x, part)).sum();
        interpolate(local, self.tree.inside(leaf, x)) + near
    }

    /// The same at many places.
    #[must_use]
    pub fn values(&self, places: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; places.len()];
        let share = places.len().div_ceil(parts_of(EVALUATION * places.len())).max(1);
        let parts = places.chunks(share).zip(values.chunks_mut(share));
        each(parts.collect(), |(places, values)| {
            places.iter().zip(values).for_each(|(x, value)| *value = self.at(*x));
        });
        values
    }

    /// The potential of some nodes.
    fn direct(&self, x: f64, nodes: Range<usize>) -> f64 {
        let order = self.panels.order();
        let mut moments = [0.0; super::rule::MOST];
        let moments = &mut moments[..order];
        let mut sum = 0.0;
        let mut plain = PlainSum::new(self.kernel);
        for panel in nodes.start / order..nodes.end.div_ceil(order) {
            let all = panel * order..(panel + 1) * order;
            let (_, half) = self.panels.middle(panel);
            let z = self.panels.local(self.kernel, panel, x);
            let places = self.panels.nodes();
            if z.abs() >= self.panels.rule.far {
                let part = all.start.max(nodes.start)..all.end.min(nodes.end);
                for (place, charge) in places[part.clone()].iter().zip(&self.charges[part]) {
                    plain.add(x - place, *charge);
                }
                continue;
            }
            self.kernel.moments(z, moments);
            let c = &self.coefficients[all.clone()];
            let moment: f64 = moments.iter().zip(c).map(|(m, c)| m * c).sum();
            let [factor, level] = self.kernel.scale(half);
            sum += factor * moment + half * level * 2.0 * c[0];
            if self.kernel.is_closed() {
                let charges =
                    all.map(|node| self.charges[node] * self.kernel.remainder(x - places[node]));
                sum += charges.sum::<f64>();
            }
        }
        sum + plain.total()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Panels of very different lengths, with gaps, the last ones ever shorter.
    fn uneven(closing: i32) -> Vec<[f64; 2]> {
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
        for i in 0..closing {
            let [from, to] = [1.0 - 0.1 * 0.4f64.powi(i), 1.0 - 0.1 * 0.4f64.powi(i + 1)];
            bounds.push([from, to]);
        }
        bounds
    }

    #[test]
    fn products_agree_with_those_in_closed_form() {
        // phi = 2 + x: int ln(1/|x - s|) (2 + s) ds by its primitive on each panel
        let panels = Panels::new(uneven(20), 6).unwrap();
        let operator = PanelOperator::new(PanelKernel::Logarithm, panels).unwrap();
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

    #[test]
    fn panels_of_one_length_have_the_potentials_of_others() {
        // int ln(1/|x - s|) ds over [left, right] by its primitive; most nodes are seen from panels of the same length beside them.
        let bounds: Vec<[f64; 2]> = (0..300)
            .map(|i| [-0.9 + 0.005 * f64::from(i), -0.9 + 0.005 * f64::from(i + 1)])
            .collect();
        let [from, to] = [bounds[0][0], bounds[299][1]];
        let primitive = |d: f64| if d == 0.0 { 0.0 } else { d * (1.0 - d.abs().ln()) };
        for order in [6, 10, 13] {
            let panels = Panels::new(bounds.clone(), order).unwrap();
            let operator = PanelOperator::new(PanelKernel::Logarithm, panels).unwrap();
            let ones = vec![1.0; operator.panels().count()];
            for (x, found) in operator.panels().nodes().iter().zip(operator.potential(&ones)) {
                let exact = primitive(x - from) + primitive(to - x);
                assert!((found - exact).abs() < 4e-14, "{order} {x}: {found} {exact}");
            }
        }
    }

    #[test]
    fn what_is_shared_among_processors_has_the_bits_of_one() {
        let bounds: Vec<[f64; 2]> = (0..1500)
            .map(|i| [-0.9 + 0.0011 * f64::from(i), -0.9 + 0.0011 * f64::from(i + 1)])
            .collect();
        let panels = Panels::new(bounds, 10).unwrap();
        let operator = PanelOperator::new(PanelKernel::Logarithm, panels).unwrap();
        let own = |turns: f64| -> Vec<f64> {
            operator.panels().nodes().iter().map(|x| (turns * x).sin()).collect()
        };
        let [one, other] = [own(3.0), own(40.0)];
        let together = operator.potentials(&[&one, &other]);
        for (values, shared) in [one, other].into_iter().zip(together) {
            let locals = operator.tree.locals(&operator.charges(&values), false);
            let mut alone = vec![0.0; values.len()];
            operator.add_up(0..operator.tree.leaves(), &[values], &[locals], &mut [&mut alone]);
            assert_eq!(shared, alone);
        }
        let field = operator.field(&own(7.0));
        let places: Vec<f64> = (0..20_000).map(|i| f64::from(i) / 10_000.0 - 1.0).collect();
        let alone: Vec<f64> = places.iter().map(|x| field.at(*x)).collect();
        assert_eq!(field.values(&places), alone);
        // Enough for more than one part.
        assert!(operator.near.len() > 1 << 19, "{}", operator.near.len());
    }

    #[test]
    fn an_operator_beside_another_is_its_own_to_the_last_bit() {
        let before = uneven(0);
        let mut after = before.clone();
        after[120][1] -= 1e-4;
        after.remove(200);
        let halved = 0.5 * (after[300][0] + after[300][1]);
        let right = std::mem::replace(&mut after[300][1], halved);
        after.insert(301, [halved, right]);
        let kernels =
            [PanelKernel::Logarithm, PanelKernel::Sine, PanelKernel::Power { exponent: 0.4 }];
        for kernel in kernels {
            let other =
                PanelOperator::new(kernel, Panels::new(before.clone(), 4).unwrap()).unwrap();
            let panels = || Panels::new(after.clone(), 4).unwrap();
            let fresh = PanelOperator::new(kernel, panels()).unwrap();
            let beside = PanelOperator::beside(kernel, panels(), Some(&other)).unwrap();
            assert!(fresh.near.iter().all(|entry| entry.is_finite()));
            assert_eq!(fresh.near, beside.near, "{kernel:?}");
            let known = (0..fresh.tree.leaves())
                .filter(|leaf| other.block(*leaf, fresh.panels(), &fresh.tree).is_some());
            let known = known.count();
            assert!(
                known > fresh.tree.leaves() / 2,
                "{kernel:?}: {known} of {}",
                fresh.tree.leaves()
            );
        }
    }

    #[test]
    fn potentials_at_the_end_of_the_shortest_panels_are_exact() {
        // phi = 1: int (1 - s)^-mu ds from 1 - d to 1 is d^(1-mu)/(1-mu). Lengths of some thousand roundings, whose middles are off by a share of them.
        for closing in 24..=34 {
            let from = |i: i32| 1.0 - 0.05 * 0.4f64.powi(i);
            let mut bounds: Vec<[f64; 2]> = (0..closing).map(|i| [from(i), from(i + 1)]).collect();
            bounds.push([from(closing), 1.0]);
            let panels = Panels::new(bounds, 6).unwrap();
            let operator =
                PanelOperator::new(PanelKernel::Power { exponent: 0.8 }, panels).unwrap();
            let field = operator.field(&vec![1.0; operator.panels().count()]);
            let exact = (1.0 - from(0)).powf(0.2) / 0.2;
            assert!((field.at(1.0) / exact - 1.0).abs() < 1e-12, "{closing}: {}", field.at(1.0));
        }
    }

    #[test]
    fn products_with_powers_agree_with_those_in_closed_form() {
        for exponent in [0.05, 0.5, 0.8] {
            // Beside the singularity rounded distances show in what the primitive gives.
            let panels = Panels::new(uneven(8), 6).unwrap();
            let operator = PanelOperator::new(PanelKernel::Power { exponent }, panels).unwrap();
            // phi = 2 + x by its primitive on each panel
            let power = 1.0 - exponent;
            let primitive = |x: f64, s: f64| {
                let d = s - x;
                let near = d.abs().powf(power).copysign(d);
                (2.0 + x) * near / power + near * d / (1.0 + power)
            };
            let exact = |x: f64| -> f64 {
                let bounds = operator.panels().bounds();
                bounds.iter().map(|[left, right]| primitive(x, *right) - primitive(x, *left)).sum()
            };
            let values: Vec<f64> = operator.panels().nodes().iter().map(|x| 2.0 + x).collect();
            let size = 4.0 / power;
            for (x, found) in operator.panels().nodes().iter().zip(operator.potential(&values)) {
                assert!((found - exact(*x)).abs() < 2e-13 * size, "{exponent} {x}: {found}");
            }
            let field = operator.field(&values);
            for i in -60..=60 {
                let x = f64::from(i) / 57.3;
                let found = field.at(x);
                assert!((found - exact(x)).abs() < 2e-13 * size, "{exponent} {x}: {found}");
            }
        }
        let panels = || Panels::new(uneven(8), 6).unwrap();
        for exponent in [0.0, 1.0, f64::NAN] {
            assert!(PanelOperator::new(PanelKernel::Power { exponent }, panels()).is_err());
        }
    }

    #[test]
    fn on_a_circle_waves_are_divided_by_their_number() {
        // ln 1/(2 sin(y/2)) = sum cos(m y)/m: over the whole turn cos(m pi s) becomes cos(m pi x)/m.
        let mut cuts: Vec<f64> = (0..=60).map(|i| f64::from(i) / 30.0 - 1.0).collect();
        cuts.extend((1..12).map(|i| 1.0 - 0.03 * 0.4f64.powi(i)));
        cuts.sort_by(f64::total_cmp);
        let bounds = cuts.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let panels = Panels::new(bounds, 13).unwrap();
        let operator = PanelOperator::new(PanelKernel::Sine, panels).unwrap();
        let pi = std::f64::consts::PI;
        for m in [1.0, 2.0, 5.0] {
            let wave = |x: f64| (m * pi * x + 0.3).cos();
            let values: Vec<f64> = operator.panels().nodes().iter().map(|x| wave(*x)).collect();
            for (x, found) in operator.panels().nodes().iter().zip(operator.potential(&values)) {
                assert!((found - wave(*x) / m).abs() < 1e-13, "{m} {x}: {found}");
            }
            let field = operator.field(&values);
            for x in [-1.7, -1.0, -0.99, -0.3, 0.0, 0.77, 1.0, 2.4] {
                assert!((field.at(x) - wave(x) / m).abs() < 1e-13, "{m} {x}: {}", field.at(x));
            }
        }
    }
}
