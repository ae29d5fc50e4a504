//! Boxes of halved lengths: cut where nodes crowd, and so that neighbours differ by one halving at most.
//!
//! A leaf acts directly on itself and on the leaves beside it, on all others through the boxes that hold them: at each level on those of its length that lie at least a box apart, unless boxes above do so
//! already (J. Carrier, L. Greengard, V. Rokhlin, *A fast adaptive multipole algorithm for particle simulations*, SIAM J. Sci. Stat. Comput. 9 (1988) 669). Where the box beside a leaf is cut, one of its
//! halves is no neighbour of the leaf but half as long: the leaf is halved for it, as far as boxes act on each other.

use std::ops::Range;

use super::panels::Panels;

/// Most nodes of a leaf: of twelve problems on panels with 20 they take 3 % longer, with 40 as much, with 64 7 % (survey).
pub(super) const CROWD: usize = 28;
/// Shortest leaf, in lengths of the longest panel with a node in the box that is cut: then few leaves beyond its neighbours are so near to a panel that its nodes alone do not integrate the kernel. With 0.5 the same problems take 2 % longer (survey).
const SHORTEST: f64 = 0.85;
/// Most halvings: places in the shortest boxes are still known to some digits (rounding).
const DEEPEST: usize = 40;
const SHALLOWEST: usize = 2;
/// The offsets of boxes that act on each other: those of the neighbours of the parent that are no neighbours.
pub(super) const OFFSETS: [isize; 4] = [-3, -2, 2, 3];

/// A box of `[-1, 1]`.
#[derive(Debug, Clone)]
pub(super) struct Cell {
    /// The number of halvings, and that of boxes of this length on its left.
    pub(super) level: usize,
    pub(super) index: usize,
    /// By its place among all boxes the one of twice the length that holds it; on the shallowest level of no use.
    pub(super) parent: usize,
    /// The same of the left one of its halves, after which the right one follows.
    pub(super) halves: Option<usize>,
    pub(super) nodes: Range<usize>,
    /// The boxes that act on it, by their offsets.
    pub(super) sources: [Option<usize>; OFFSETS.len()],
    /// Whether it is half of a leaf.
    is_part: bool,
}

impl Cell {
    /// The middle, and half the length: both are exact.
    pub(super) fn middle(&self) -> (f64, f64) {
        let half = 1.0 / (1u64 << self.level) as f64;
        ((2 * self.index + 1) as f64 * half - 1.0, half)
    }

    fn left(&self) -> f64 {
        let (middle, half) = self.middle();
        middle - half
    }
}

/// Nodes near to a leaf.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Part {
    pub(super) nodes: Range<usize>,
    /// Whether boxes act for them as well: they are here as their panel is near to places of the leaf.
    pub(super) is_far: bool,
}

/// A box that acts directly on itself and its neighbours.
#[derive(Debug, Clone)]
pub(super) struct Leaf {
    /// Level and index of the box.
    pub(super) name: (usize, usize),
    pub(super) nodes: Range<usize>,
    pub(super) near: Vec<Part>,
    /// The box or its halves, by their places among all.
    pub(super) ends: Range<usize>,
}

impl Leaf {
    /// Number of nodes near to it.
    pub(super) fn count(&self) -> usize {
        self.near.iter().map(|part| part.nodes.len()).sum()
    }

    /// Whether a leaf of another tree has as much of the same panels near to it; both have as many nodes.
    pub(super) fn is_like(&self, panels: &Panels, other: &Self, others: &Panels) -> bool {
        let order = panels.order();
        let is_same = |one: &Range<usize>, other: &Range<usize>| {
            [one.start % order, one.len()] == [other.start % order, other.len()]
                && panels.touched(one) == others.touched(other)
        };
        let are_same = |(one, other): (&Part, &Part)| {
            one.is_far == other.is_far && is_same(&one.nodes, &other.nodes)
        };
        self.near.len() == other.near.len()
            && is_same(&self.nodes, &other.nodes)
            && self.near.iter().zip(&other.near).all(are_same)
    }

    /// Adds the nodes of a panel that no part has.
    fn add_beyond(&mut self, panel: Range<usize>) {
        let mut left = vec![panel];
        for Part { nodes: Range { start, end }, .. } in &self.near {
            let outside = |of: Range<usize>| {
                let sides = [of.start..of.end.min(*start), of.start.max(*end)..of.end];
                sides.into_iter().filter(|side| !side.is_empty())
            };
            left = left.into_iter().flat_map(outside).collect();
        }
        self.near.extend(left.into_iter().map(|nodes| Part { nodes, is_far: true }));
    }
}

/// All boxes, level by level and from left to right.
#[derive(Debug, Clone)]
pub(super) struct Boxes {
    pub(super) cells: Vec<Cell>,
    pub(super) leaves: Vec<Leaf>,
    /// Where each level begins, from the shallowest on, and the number of boxes.
    starts: Vec<usize>,
    /// Where the leaves begin.
    lefts: Vec<f64>,
    is_closed: bool,
}

impl Boxes {
    /// For the nodes of panels, at most so many of them in a leaf unless a panel is longer; of a circle, whose first box is a neighbour of its last.
    pub(super) fn new(panels: &Panels, crowd: usize, is_closed: bool) -> Self {
        let mut boxes =
            Self { cells: vec![], leaves: vec![], starts: vec![], lefts: vec![], is_closed };
        let mut cuts = cuts(panels, crowd);
        boxes.balance(&mut cuts);
        boxes.fill(panels.nodes(), &cuts);
        for cell in 0..boxes.cells.len() {
            boxes.cells[cell].sources = boxes.sources(cell);
        }
        boxes.find_leaves();
        boxes.find_near(panels);
        boxes
    }

    /// The boxes of each level from the shallowest on.
    pub(super) fn levels(&self) -> impl DoubleEndedIterator<Item = Range<usize>> {
        self.starts.windows(2).map(|pair| pair[0]..pair[1])
    }

    /// The most halvings.
    pub(super) fn deepest(&self) -> usize {
        SHALLOWEST + self.starts.len() - 2
    }

    /// The leaf of a place.
    pub(super) fn leaf(&self, x: f64) -> usize {
        self.lefts.partition_point(|left| *left <= x).saturating_sub(1)
    }

    /// The box of a leaf, or its half, that holds a place.
    pub(super) fn end(&self, leaf: usize, x: f64) -> usize {
        let Range { start, end } = self.leaves[leaf].ends;
        let right = start + 1;
        if right < end && self.cells[right].left() <= x { right } else { start }
    }

    /// The leaf of a level and an index, if there is one.
    pub(super) fn find(&self, name: (usize, usize)) -> Option<usize> {
        let (level, index) = name;
        let left = 2.0 * index as f64 / (1u64 << level) as f64 - 1.0;
        Some(self.leaf(left)).filter(|leaf| self.leaves[*leaf].name == name)
    }

    /// Cuts boxes beside those whose halves are cut.
    fn balance(&self, cuts: &mut [Vec<usize>]) {
        for level in (1..cuts.len()).rev() {
            let asked = |index: &usize| {
                let beside = neighbours(*index, 1 << level, self.is_closed);
                beside.chain([*index]).map(|index| index / 2)
            };
            let asked: Vec<usize> = cuts[level].iter().flat_map(asked).collect();
            cuts[level - 1].extend(asked);
            cuts[level - 1].sort_unstable();
            cuts[level - 1].dedup();
        }
    }

    /// Boxes of all levels: of each that is cut the halves, and of each leaf beside one that is.
    fn fill(&mut self, nodes: &[f64], cuts: &[Vec<usize>]) {
        let mut above = vec![Cell {
            level: 0,
            index: 0,
            parent: 0,
            halves: None,
            nodes: 0..nodes.len(),
            sources: [None; OFFSETS.len()],
            is_part: false,
        }];
        for level in 0.. {
            let begin = self.cells.len();
            let is_kept = level >= SHALLOWEST;
            let next = begin + if is_kept { above.len() } else { 0 };
            let is_cut = |index| {
                cuts.get(level).is_some_and(|cut: &Vec<usize>| cut.binary_search(&index).is_ok())
            };
            let mut below = Vec::new();
            for (place, cell) in above.iter_mut().enumerate() {
                let is_own = is_cut(cell.index);
                let mut beside = neighbours(cell.index, 1 << level, self.is_closed);
                if cell.is_part || !is_own && !beside.any(is_cut) {
                    continue;
                }
                cell.halves = Some(next + below.len());
                let Range { start, end } = cell.nodes;
                let (middle, _) = cell.middle();
                let cut = start + nodes[start..end].partition_point(|x| *x < middle);
                for (side, nodes) in [start..cut, cut..end].into_iter().enumerate() {
                    below.push(Cell {
                        level: level + 1,
                        index: 2 * cell.index + side,
                        parent: begin + place,
                        halves: None,
                        nodes,
                        sources: [None; OFFSETS.len()],
                        is_part: !is_own,
                    });
                }
            }
            if is_kept {
                self.starts.push(begin);
                self.cells.append(&mut above);
            }
            if below.is_empty() {
                break;
            }
            above = below;
        }
        self.starts.push(self.cells.len());
    }

    /// The boxes of the same length that act on this one.
    fn sources(&self, cell: usize) -> [Option<usize>; OFFSETS.len()] {
        let Cell { level, index, is_part, .. } = self.cells[cell];
        let boxes = 1usize << level;
        let steps = |one: usize, other: usize, boxes: usize| {
            let steps = one.abs_diff(other);
            if self.is_closed { steps.min(boxes - steps) } else { steps }
        };
        let all = self.starts[level - SHALLOWEST]..self.starts[level - SHALLOWEST + 1];
        let mut found = [None; OFFSETS.len()];
        for (k, offset) in OFFSETS.into_iter().enumerate() {
            let other = index as isize + offset;
            let other = if self.is_closed { other.rem_euclid(boxes as isize) } else { other };
            let other = usize::try_from(other).ok().filter(|other| {
                *other < boxes
                    && steps(index, *other, boxes) >= 2
                    && steps(index / 2, *other / 2, boxes / 2) <= 1
            });
            let place = other.and_then(|other| {
                // Of boxes no farther away than this there are no more between.
                let most = other.abs_diff(index);
                let among =
                    cell.saturating_sub(most).max(all.start)..(cell + most + 1).min(all.end);
                let own = &self.cells[among.clone()];
                Some(among.start + own.binary_search_by_key(&other, |cell| cell.index).ok()?)
            });
            // A leaf and its neighbour act on each other directly, also where one of them is halved.
            let acts = |place: &usize| {
                let Cell { index: other, is_part: is_other_part, .. } = self.cells[*place];
                let is_beside_own = is_part && steps(index ^ 1, other, boxes) <= 1;
                let is_beside_other = is_other_part && steps(index, other ^ 1, boxes) <= 1;
                !(is_part && is_other_part || is_beside_own || is_beside_other)
            };
            // Of a circle of four boxes the opposite one is met twice.
            found[k] = place.filter(acts).filter(|place| !found[..k].contains(&Some(*place)));
        }
        found
    }

    fn find_leaves(&mut self) {
        let is_leaf =
            |cell: &Cell| !cell.is_part && cell.halves.is_none_or(|half| self.cells[half].is_part);
        let own = self.cells.iter().enumerate().filter(|(_, cell)| is_leaf(cell));
        let leaf = |(place, cell): (usize, &Cell)| {
            let ends = cell.halves.map_or(place..place + 1, |first| first..first + 2);
            let (name, nodes) = ((cell.level, cell.index), cell.nodes.clone());
            (cell.left(), Leaf { name, nodes, near: Vec::new(), ends })
        };
        let mut leaves: Vec<(f64, Leaf)> = own.map(leaf).collect();
        leaves.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        (self.lefts, self.leaves) = leaves.into_iter().unzip();
    }

    /// What is near to the leaves: they themselves and their neighbours, and of panels near to their places the nodes that neither has.
    fn find_near(&mut self, panels: &Panels) {
        let all: Vec<Range<usize>> = self.leaves.iter().map(|leaf| leaf.nodes.clone()).collect();
        let last = all.len() - 1;
        for (leaf, own) in self.leaves.iter_mut().enumerate() {
            let beside = all[leaf.saturating_sub(1)].start..all[(leaf + 1).min(last)].end;
            let across = match leaf {
                0 if self.is_closed => all[last].clone(),
                leaf if self.is_closed && leaf == last => all[0].clone(),
                _ => 0..0,
            };
            let direct = [beside, across].into_iter().filter(|nodes| !nodes.is_empty());
            own.near = direct.map(|nodes| Part { nodes, is_far: false }).collect();
        }
        let turns = if self.is_closed { &[-2.0, 0.0, 2.0][..] } else { &[0.0] };
        for panel in 0..panels.bounds().len() {
            let (middle, _) = panels.middle(panel);
            let reach = panels.reach(panel);
            for turn in turns {
                let [from, to] = [middle + turn - reach, middle + turn + reach];
                if from <= 1.0 && to >= -1.0 {
                    let own = panel * panels.order()..(panel + 1) * panels.order();
                    for leaf in self.leaf(from)..=self.leaf(to) {
                        self.leaves[leaf].add_beyond(own.clone());
                    }
                }
            }
        }
    }
}

/// The boxes beside another.
fn neighbours(index: usize, boxes: usize, is_closed: bool) -> impl Iterator<Item = usize> {
    let left = index.checked_sub(1).or(is_closed.then_some(boxes - 1));
    let right = Some(index + 1).filter(|right| *right < boxes).or(is_closed.then_some(0));
    [left, right].into_iter().flatten()
}

/// Of each level the boxes that are cut for their nodes, from left to right.
fn cuts(panels: &Panels, crowd: usize) -> Vec<Vec<usize>> {
    let (nodes, order) = (panels.nodes(), panels.order());
    let longest = |own: &Range<usize>| {
        let halves = (own.start / order..own.end.div_ceil(order)).map(|k| panels.middle(k).1);
        2.0 * halves.fold(0.0, f64::max)
    };
    let mut cuts: Vec<Vec<usize>> = Vec::new();
    let mut open = vec![(0, 0..nodes.len())];
    for level in 0..DEEPEST {
        let half = 1.0 / (1u64 << level) as f64;
        let is_cut = |(_, own): &(usize, Range<usize>)| {
            level < SHALLOWEST || own.len() > crowd && SHORTEST * longest(own) <= half
        };
        open.retain(is_cut);
        if open.is_empty() {
            break;
        }
        cuts.push(open.iter().map(|(index, _)| *index).collect());
        let halves = |(index, own): (usize, Range<usize>)| {
            let middle = (2 * index + 1) as f64 * half - 1.0;
            let cut = own.start + nodes[own.clone()].partition_point(|x| *x < middle);
            [(2 * index, own.start..cut), (2 * index + 1, cut..own.end)]
        };
        open = open.into_iter().flat_map(halves).collect();
    }
    cuts
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Panels that get shorter towards some places, by a factor each, with gaps.
    fn towards(places: &[f64], factor: f64, order: usize) -> Panels {
        let mut ends = vec![-1.0, 1.0];
        for place in places {
            for side in [-1.0, 1.0] {
                ends.extend((0..60).map(|k| place + side * 0.3 * factor.powi(k)));
            }
            ends.push(*place);
        }
        ends.extend((1..60).map(|k| f64::from(k) / 30.0 - 1.0));
        ends.retain(|end| end.abs() <= 1.0);
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|one, other| *one - *other < 1e-13);
        let panels = ends.windows(2).map(|pair| [pair[0], pair[1]]).enumerate();
        let panels = panels.filter(|(k, _)| k % 11 != 7).map(|(_, panel)| panel);
        Panels::new(panels.collect(), order).unwrap()
    }

    #[test]
    fn every_pair_of_nodes_acts_on_each_other_once() {
        let places: [&[f64]; 5] = [&[], &[0.31], &[-1.0, 1.0], &[-0.2, -0.2 + 1e-7, 0.9], &[0.0]];
        for (case, places) in places.iter().enumerate() {
            for (order, crowd, is_closed) in [(4, 5, false), (10, 12, true), (13, 40, false)] {
                let panels = towards(places, 0.5 + 0.08 * case as f64, order);
                let boxes = Boxes::new(&panels, crowd, is_closed);
                let count = panels.count();
                let mut times = vec![0u8; count * count];
                let mut add = |targets: &Range<usize>, sources: &Range<usize>| {
                    for target in targets.clone() {
                        sources.clone().for_each(|source| times[target * count + source] += 1);
                    }
                };
                for cell in &boxes.cells {
                    for source in cell.sources.iter().flatten() {
                        add(&cell.nodes, &boxes.cells[*source].nodes);
                    }
                }
                for leaf in &boxes.leaves {
                    let direct = leaf.near.iter().filter(|part| !part.is_far);
                    direct.for_each(|part| add(&leaf.nodes, &part.nodes));
                }
                assert!(times.iter().all(|times| *times == 1), "{case} {order}");
                // Neighbours differ by one halving, and all nodes have a leaf that holds them.
                let levels: Vec<usize> = boxes.leaves.iter().map(|leaf| leaf.name.0).collect();
                assert!(levels.windows(2).all(|pair| pair[0].abs_diff(pair[1]) <= 1), "{levels:?}");
                for (node, x) in panels.nodes().iter().enumerate() {
                    let leaf = boxes.leaf(*x);
                    assert!(boxes.leaves[leaf].nodes.contains(&node), "{case} {order} {x}");
                    assert!(boxes.cells[boxes.end(leaf, *x)].nodes.contains(&node), "{x}");
                    assert_eq!(boxes.find(boxes.leaves[leaf].name), Some(leaf));
                }
            }
        }
    }

    #[test]
    fn panels_near_to_a_place_are_near_to_its_leaf() {
        for order in [4, 13] {
            let panels = towards(&[0.31, -1.0], 0.6, order);
            let boxes = Boxes::new(&panels, CROWD, false);
            for i in 0..=4000 {
                let x =
                    if i % 2 == 0 { f64::from(i) / 2000.0 - 1.0 } else { 0.31 + 0.995f64.powi(i) };
                if x > 1.0 {
                    continue;
                }
                let leaf = &boxes.leaves[boxes.leaf(x)];
                for panel in 0..panels.bounds().len() {
                    let (middle, half) = panels.middle(panel);
                    if (x - middle).abs() < panels.rule.far * half {
                        let own = panel * order..(panel + 1) * order;
                        let has = |node| leaf.near.iter().any(|part| part.nodes.contains(&node));
                        assert!(own.into_iter().all(has), "{order} {x} {panel}");
                    }
                }
            }
            // Neighbours have most of them: the tree is of use.
            let all: usize = boxes.leaves.iter().map(|leaf| leaf.nodes.len() * leaf.count()).sum();
            assert!(all < 250 * panels.count(), "{order}: {} a node", all / panels.count());
        }
    }
}
