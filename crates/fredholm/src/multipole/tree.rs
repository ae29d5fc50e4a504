//! The far part of a potential: boxes of halved lengths whose charges act on each other through interpolation at Chebyshev points.

use std::f64::consts::PI;
use std::ops::Range;
use std::sync::LazyLock;

use super::kernel::PanelKernel;

/// Chebyshev points of a box. Boxes that act on each other lie at least a box apart: interpolation converges by `(3 + sqrt 8)^-1` with each point.
pub(super) const POINTS: usize = 18;
/// The offsets of boxes that act on each other: those of the neighbours of the parent that are no neighbours.
const OFFSETS: [isize; 4] = [-3, -2, 2, 3];
/// Most halvings.
const DEEPEST: u32 = 18;
const SHALLOWEST: u32 = 2;

/// A matrix between points by its columns, each filled up with zeros to whole vectors.
type Square = Vec<[f64; WIDE]>;
const WIDE: usize = POINTS.next_multiple_of(8);

/// A tree of boxes from -1 to 1, or beyond: its leaves have the length that is asked for, and their number is a power of 2.
#[derive(Debug, Clone)]
pub(super) struct Tree {
    depth: u32,
    /// Number of leaves on `[-1, 1]`; of a circle all.
    covering: usize,
    /// First node of each leaf, and the number of nodes.
    starts: Vec<usize>,
    /// Values of the cardinal polynomials of its leaf at each node.
    cardinal: Vec<f64>,
    /// Whether the first box is a neighbour of the last.
    is_closed: bool,
    /// `K(h (t_i - (2 offset + t_k)))` for the offsets, level by level, `h` half of a box.
    across: Vec<[Square; 4]>,
    /// Values of the parent's cardinal polynomials at the points of the left and right child.
    halves: [Square; 2],
    /// The same with rows for columns.
    gathers: [Square; 2],
}

/// Values at the points of all leaves.
pub(super) type Locals = Vec<f64>;

impl Tree {
    /// For nodes from left to right, with leaves of at least `length` and about `crowd` nodes.
    pub(super) fn new(kernel: PanelKernel, nodes: &[f64], length: f64, crowd: usize) -> Self {
        let is_closed = kernel.is_closed();
        let fewest = 1usize << SHALLOWEST;
        let crowded = nodes.len().div_ceil(crowd).clamp(fewest, 1 << DEEPEST);
        let mut covering = crowded.min((2.0 / length) as usize).max(fewest);
        if is_closed {
            covering = 1 << covering.ilog2();
        }
        let depth = covering.next_power_of_two().ilog2();
        let leaves = 1usize << depth;
        let mut starts = vec![nodes.len(); leaves + 1];
        let mut next = 0;
        for (leaf, start) in starts.iter_mut().enumerate().take(covering) {
            let left = 2.0 * leaf as f64 / covering as f64 - 1.0;
            while next < nodes.len() && nodes[next] < left {
                next += 1;
            }
            *start = next;
        }
        let points = &CHEBYSHEV.points;
        let across = (SHALLOWEST..=depth).map(|level| {
            let half = (leaves >> level) as f64 / covering as f64;
            OFFSETS.map(|offset| {
                square(|i, k| kernel.value(half * (points[i] - (2.0 * offset as f64 + points[k]))))
            })
        });
        let across = across.collect();
        let halves = [-1.0, 1.0].map(|side| {
            let rows = points.map(|t| {
                let mut row = [0.0; POINTS];
                cardinal(0.5 * (t + side), &mut row);
                row
            });
            [square(|i, k| rows[i][k]), square(|i, k| rows[k][i])]
        });
        let [[left, to_left], [right, to_right]] = halves;
        let (halves, gathers) = ([left, right], [to_left, to_right]);
        let mut tree = Self {
            depth,
            covering,
            starts,
            cardinal: Vec::new(),
            is_closed,
            across,
            halves,
            gathers,
        };
        let mut values = vec![0.0; POINTS * nodes.len()];
        for leaf in 0..leaves {
            for j in tree.nodes_of(leaf, leaf) {
                let t = tree.inside(leaf, nodes[j]);
                cardinal(t, &mut values[j * POINTS..(j + 1) * POINTS]);
            }
        }
        tree.cardinal = values;
        tree
    }

    pub(super) fn leaves(&self) -> usize {
        1 << self.depth
    }

    /// The leaf of a place in `[-1, 1]`.
    pub(super) fn leaf(&self, x: f64) -> usize {
        ((0.5 * (x + 1.0) * self.covering as f64) as usize).min(self.covering - 1)
    }

    /// The nodes of leaves from the first to the last.
    pub(super) fn nodes_of(&self, first: usize, last: usize) -> Range<usize> {
        self.starts[first]..self.starts[last + 1]
    }

    /// The nodes of a leaf and its neighbours, which act directly; the second part are those across the seam of a circle.
    pub(super) fn near(&self, leaf: usize) -> [Range<usize>; 2] {
        let last = self.leaves() - 1;
        let beside = self.nodes_of(leaf.saturating_sub(1), (leaf + 1).min(last));
        let across = match leaf {
            0 if self.is_closed => self.nodes_of(last, last),
            leaf if self.is_closed && leaf == last => self.nodes_of(0, 0),
            _ => 0..0,
        };
        [beside, across]
    }

    /// The place in a leaf, from -1 to 1.
    pub(super) fn inside(&self, leaf: usize, x: f64) -> f64 {
        (x + 1.0) * self.covering as f64 - (2 * leaf + 1) as f64
    }

    /// Values at the points of a leaf and what a node takes of each: the far potential there is the sum of their products.
    #[inline(always)]
    pub(super) fn at_node<'t>(
        &'t self,
        locals: &'t Locals,
        leaf: usize,
        node: usize,
    ) -> [&'t [f64]; 2] {
        let local = &locals[leaf * POINTS..(leaf + 1) * POINTS];
        [local, &self.cardinal[node * POINTS..(node + 1) * POINTS]]
    }

    /// The potential of charges at all nodes but those of neighbouring leaves, at the points of the leaves; `everywhere`, or where there are nodes.
    #[inline(always)]
    pub(super) fn locals(&self, charges: &[f64], everywhere: bool) -> Locals {
        let levels = self.gathered(charges);
        let mut above: Locals = vec![0.0; POINTS * 2];
        for level in SHALLOWEST..=self.depth {
            let boxes = 1usize << level;
            let span = self.leaves() / boxes;
            let moments = &levels[(level - SHALLOWEST) as usize];
            let mut locals = vec![0.0; POINTS * boxes];
            for (b, local) in locals.chunks_exact_mut(POINTS).enumerate() {
                let is_beyond = b * span >= self.covering;
                if is_beyond
                    || !everywhere && self.nodes_of(b * span, (b + 1) * span - 1).is_empty()
                {
                    continue;
                }
                if level > SHALLOWEST {
                    let parent = &above[(b / 2) * POINTS..(b / 2 + 1) * POINTS];
                    add_product(&self.halves[b % 2], parent, local);
                }
                self.gather_far(moments, b, level, local);
            }
            above = locals;
        }
        above
    }

    /// What the boxes in reach of this one give: children of neighbours of the parent that are no neighbours themselves.
    #[inline(always)]
    fn gather_far(&self, moments: &[f64], b: usize, level: u32, local: &mut [f64]) {
        let boxes = 1usize << level;
        let across = &self.across[(level - SHALLOWEST) as usize];
        let mut seen = None;
        for (offset, matrix) in OFFSETS.iter().zip(across) {
            let other = b as isize + offset;
            let other = if self.is_closed { other.rem_euclid(boxes as isize) } else { other };
            let Some(other) = usize::try_from(other).ok().filter(|other| *other < boxes) else {
                continue;
            };
            // Of a circle of four boxes the opposite one is met twice, and three boxes on is the neighbour.
            let is_reached = self.distance(b, other, boxes) >= 2
                && self.distance(b / 2, other / 2, boxes / 2) <= 1
                && seen != Some(other);
            let source = &moments[other * POINTS..(other + 1) * POINTS];
            if !is_reached || source.iter().all(|m| *m == 0.0) {
                continue;
            }
            seen = Some(other);
            add_product(matrix, source, local);
        }
    }

    /// Number of boxes from one to another, by the shorter way.
    fn distance(&self, one: usize, other: usize, boxes: usize) -> usize {
        let steps = one.abs_diff(other);
        if self.is_closed { steps.min(boxes - steps) } else { steps }
    }

    /// The charges at the points of the boxes, from the coarsest level to the leaves.
    #[inline(always)]
    fn gathered(&self, charges: &[f64]) -> Vec<Vec<f64>> {
        let mut finest = vec![0.0; POINTS * self.leaves()];
        for (leaf, moments) in finest.chunks_exact_mut(POINTS).enumerate() {
            for j in self.nodes_of(leaf, leaf) {
                add(moments, charges[j], &self.cardinal[j * POINTS..(j + 1) * POINTS]);
            }
        }
        let mut levels = vec![finest];
        for level in (SHALLOWEST..self.depth).rev() {
            let children = &levels[levels.len() - 1];
            let mut parents = vec![0.0; POINTS << level];
            for (b, child) in children.chunks_exact(POINTS).enumerate() {
                if child.iter().all(|m| *m == 0.0) {
                    continue;
                }
                let parent = &mut parents[(b / 2) * POINTS..(b / 2 + 1) * POINTS];
                add_product(&self.gathers[b % 2], child, parent);
            }
            levels.push(parents);
        }
        levels.reverse();
        levels
    }
}

#[inline(always)]
fn add(target: &mut [f64], factor: f64, vector: &[f64]) {
    target.iter_mut().zip(vector).for_each(|(t, v)| *t += factor * v);
}

/// Adds a matrix times values: all rows advance together.
#[inline(always)]
fn add_product(matrix: &Square, values: &[f64], target: &mut [f64]) {
    let mut sums = [0.0; WIDE];
    for (column, value) in matrix.iter().zip(values) {
        for (sum, entry) in sums.iter_mut().zip(column) {
            *sum += value * entry;
        }
    }
    target.iter_mut().zip(&sums).for_each(|(t, sum)| *t += sum);
}

fn square(entry: impl Fn(usize, usize) -> f64) -> Square {
    let column = |k: usize| std::array::from_fn(|i| if i < POINTS { entry(i, k) } else { 0.0 });
    (0..POINTS).map(column).collect()
}

/// The Chebyshev points of the first kind, and the weights of the barycentric formula.
struct Chebyshev {
    points: [f64; POINTS],
    weights: [f64; POINTS],
}

static CHEBYSHEV: LazyLock<Chebyshev> = LazyLock::new(|| {
    let points: [f64; POINTS] =
        std::array::from_fn(|k| -((2 * k + 1) as f64 * PI / (2 * POINTS) as f64).cos());
    let weight = |k: usize| {
        let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * (1.0 - points[k] * points[k]).sqrt()
    };
    Chebyshev { points, weights: std::array::from_fn(weight) }
});

/// The values of the cardinal polynomials at a place, by the barycentric formula.
fn cardinal(t: f64, values: &mut [f64]) {
    let Chebyshev { points, weights } = &*CHEBYSHEV;
    if let Some(k) = points.iter().position(|point| *point == t) {
        values.fill(0.0);
        values[k] = 1.0;
        return;
    }
    let mut sum = 0.0;
    for (value, (point, weight)) in values.iter_mut().zip(points.iter().zip(weights)) {
        *value = weight / (t - point);
        sum += *value;
    }
    values.iter_mut().for_each(|value| *value /= sum);
}

/// The polynomial through values at the points.
pub(super) fn interpolate(values: &[f64], t: f64) -> f64 {
    let Chebyshev { points, weights } = &*CHEBYSHEV;
    let (mut above, mut below) = (0.0, 0.0);
    for (value, (point, weight)) in values.iter().zip(points.iter().zip(weights)) {
        if t == *point {
            return *value;
        }
        let weight = weight / (t - point);
        above += weight * value;
        below += weight;
    }
    above / below
}
