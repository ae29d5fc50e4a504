//! The far part of a potential: boxes of halved lengths whose charges act on each other through interpolation at Chebyshev points.

use std::array;
use std::f64::consts::PI;
use std::ops::Range;
use std::sync::{Arc, LazyLock};

use super::kernel::PanelKernel;
use super::rings::Rings;
use super::threads::{each, parts_of};

/// Chebyshev points of a box. Boxes that act on each other lie at least a box apart: interpolation converges by `(3 + sqrt 8)^-1` with each point.
pub(super) const POINTS: usize = 18;
/// Multiplications for a value of a cardinal polynomial, about: a quotient is worth several.
const CARDINAL: usize = 8;
/// Multiplications for a value of the kernel of rings, about.
const BETWEEN: usize = 30;
/// The offsets of boxes that act on each other: those of the neighbours of the parent that are no neighbours.
pub(super) const OFFSETS: [isize; 4] = [-3, -2, 2, 3];
/// Most halvings.
const DEEPEST: u32 = 18;
/// The same of rings, whose boxes have matrices of their own: these take 60 megabytes at most.
const DEEPEST_OF_RINGS: u32 = 13;
pub(super) const SHALLOWEST: u32 = 2;

/// A matrix between points by its columns, each filled up with zeros to whole vectors.
pub(super) type Square = [[f64; WIDE]; POINTS];
pub(super) const WIDE: usize = POINTS.next_multiple_of(8);

/// A tree of boxes from -1 to 1, or beyond: its leaves have the length that is asked for, and their number is a power of 2.
#[derive(Debug, Clone)]
pub(super) struct Tree {
    pub(super) depth: u32,
    /// Number of leaves on `[-1, 1]`; of a circle all.
    pub(super) covering: usize,
    /// First node of each leaf, and the number of nodes.
    starts: Vec<usize>,
    /// Values of the cardinal polynomials of its leaf at each node.
    cardinal: Vec<[f64; POINTS]>,
    /// Whether the first box is a neighbour of the last.
    pub(super) is_closed: bool,
    pub(super) across: Across,
    /// Values of the parent's cardinal polynomials at the points of the left and right child.
    pub(super) halves: &'static [Square; 2],
    /// The same with rows for columns.
    pub(super) gathers: &'static [Square; 2],
}

/// Between points of boxes by their offsets.
#[derive(Debug, Clone)]
pub(super) enum Across {
    /// `K(h (t_i - (2 offset + t_k)))`, level by level, `h` half of a box.
    Shifted(Vec<[Square; 4]>),
    /// Of rings `h^(1 + mu) K`, box by box from the axis on: for boxes of any size the same; with `1 + mu`.
    Rings(Arc<Vec<[Square; 4]>>, f64),
}

/// A value of each of some functions at each point of a box.
pub(super) type AtPoints<const N: usize> = [[f64; POINTS]; N];

impl Tree {
    /// The boxes for nodes from left to right, with leaves of at least `length` and about `crowd` nodes.
    pub(super) fn new(kernel: &PanelKernel, nodes: &[f64], length: f64, crowd: usize) -> Self {
        let is_closed = kernel.is_closed();
        let fewest = 1usize << SHALLOWEST;
        let crowded = nodes.len().div_ceil(crowd).clamp(fewest, 1 << DEEPEST);
        let mut covering = crowded.min((2.0 / length) as usize).max(fewest);
        if kernel.rings().is_some() {
            // Boxes before the axis are empty.
            let most = (2 * crowded).min(1 << DEEPEST_OF_RINGS);
            covering = most.min((2.0 / length) as usize).max(fewest);
        }
        if is_closed || kernel.rings().is_some() {
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
        let [halves, gathers] = &CHEBYSHEV.halves;
        let (across, cardinal) = (Across::Shifted(Vec::new()), Vec::new());
        Self { depth, covering, starts, cardinal, is_closed, across, halves, gathers }
    }

    /// With all that products take.
    pub(super) fn filled(
        mut self,
        kernel: &PanelKernel,
        nodes: &[f64],
        other: Option<&Self>,
    ) -> Self {
        // Of the same kernel on as many boxes they are the same.
        self.across = match (kernel.rings(), other.map(|other| &other.across)) {
            (Some(_), Some(known @ Across::Rings(..))) => known.clone(),
            (Some(rings), _) => self.rings(rings),
            (None, _) => self.shifted(kernel),
        };
        let mut values = vec![[0.0; POINTS]; nodes.len()];
        let mut rest = &mut values[..];
        let leaves = (0..self.leaves()).map(|leaf| {
            let own = self.nodes_of(leaf, leaf);
            let values = rest.split_off_mut(..own.len()).unwrap_or_default();
            (leaf, own, values)
        });
        let mut leaves: Vec<_> = leaves.collect();
        let share = leaves.len().div_ceil(parts_of(CARDINAL * POINTS * nodes.len()));
        each(leaves.chunks_mut(share).collect(), |leaves| {
            for (leaf, own, values) in leaves {
                for (x, values) in nodes[own.clone()].iter().zip(&mut **values) {
                    cardinal(self.inside(*leaf, *x), values);
                }
            }
        });
        self.cardinal = values;
        self
    }

    fn shifted(&self, kernel: &PanelKernel) -> Across {
        let points = &CHEBYSHEV.points;
        let across = (SHALLOWEST..=self.depth).map(|level| {
            let half = (self.leaves() >> level) as f64 / self.covering as f64;
            OFFSETS.map(|offset| {
                square(|i, k| kernel.value(half * (points[i] - (2.0 * offset as f64 + points[k]))))
            })
        });
        Across::Shifted(across.collect())
    }

    fn rings(&self, rings: &Rings) -> Across {
        let points = &CHEBYSHEV.points;
        let mut across = vec![[[[0.0; WIDE]; POINTS]; 4]; self.leaves() / 2];
        let share = across.len().div_ceil(parts_of(BETWEEN * POINTS * POINTS * across.len()));
        each(across.chunks_mut(share).enumerate().collect(), |(part, across)| {
            for (within, own) in across.iter_mut().enumerate() {
                let target = (part * share + within) as isize;
                for (matrix, offset) in own.iter_mut().zip(OFFSETS) {
                    // The child on the left acts on the third on its right, the one on the right on the third on its left.
                    let is_apart =
                        if offset.abs() == 3 { (offset > 0) == (target % 2 == 0) } else { true };
                    let source = target + offset;
                    if source < 0 || !is_apart {
                        continue;
                    }
                    let radius = |of: isize, t: f64| (2 * of + 1) as f64 + t;
                    let apart = |i: usize, k: usize| {
                        let (x, s) = (radius(target, points[i]), radius(source, points[k]));
                        rings.apart(x, s, x - s)
                    };
                    // All logarithms or powers of a box at once.
                    let mut values = [[0.0; POINTS]; POINTS];
                    for (k, column) in values.iter_mut().enumerate() {
                        *column = array::from_fn(|i| apart(i, k)[0]);
                    }
                    rings.values(values.as_flattened_mut());
                    *matrix = square(|i, k| apart(i, k)[1] * values[k][i]);
                }
            }
        });
        Across::Rings(Arc::new(across), 1.0 + rings.exponent())
    }

    /// The matrices of a box of a level with those in reach, and the factor that they lack.
    #[inline(always)]
    pub(super) fn across(&self, b: usize, level: u32) -> (&[Square; 4], f64) {
        match &self.across {
            Across::Shifted(across) => (&across[(level - SHALLOWEST) as usize], 1.0),
            Across::Rings(across, power) => {
                let axis = 1usize << (level - 1);
                // Half a box has the length 1/2^level.
                (&across[b.saturating_sub(axis)], ((2 * axis) as f64).powf(*power))
            }
        }
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

    /// What a node takes of the values at the points of its leaf, and gives to the charges there.
    #[inline(always)]
    pub(super) fn at_node(&self, node: usize) -> &[f64; POINTS] {
        &self.cardinal[node]
    }
}

fn square(entry: impl Fn(usize, usize) -> f64) -> Square {
    let column = |k: usize| array::from_fn(|i| if i < POINTS { entry(i, k) } else { 0.0 });
    array::from_fn(column)
}

/// The Chebyshev points of the first kind, the weights of the barycentric formula, and from whole boxes to halves and back.
struct Chebyshev {
    points: [f64; POINTS],
    weights: [f64; POINTS],
    halves: [[Square; 2]; 2],
}

static CHEBYSHEV: LazyLock<Chebyshev> = LazyLock::new(|| {
    let points: [f64; POINTS] =
        array::from_fn(|k| -((2 * k + 1) as f64 * PI / (2 * POINTS) as f64).cos());
    let weight = |k: usize| {
        let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * (1.0 - points[k] * points[k]).sqrt()
    };
    let weights = array::from_fn(weight);
    let halves = [-1.0, 1.0].map(|side| {
        let rows = points.map(|t| {
            let mut row = [0.0; POINTS];
            cardinal_of((&points, &weights), 0.5 * (t + side), &mut row);
            row
        });
        [square(|i, k| rows[i][k]), square(|i, k| rows[k][i])]
    });
    let [[left, to_left], [right, to_right]] = halves;
    Chebyshev { points, weights, halves: [[left, right], [to_left, to_right]] }
});

/// The points of a box, from -1 to 1.
pub(super) fn points() -> &'static [f64; POINTS] {
    &CHEBYSHEV.points
}

/// The values of the cardinal polynomials at a place.
fn cardinal(t: f64, values: &mut [f64; POINTS]) {
    cardinal_of((&CHEBYSHEV.points, &CHEBYSHEV.weights), t, values);
}

/// The same by the barycentric formula with these points and weights.
fn cardinal_of(
    (points, weights): (&[f64; POINTS], &[f64; POINTS]),
    t: f64,
    values: &mut [f64; POINTS],
) {
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
    let Chebyshev { points, weights, .. } = &*CHEBYSHEV;
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
