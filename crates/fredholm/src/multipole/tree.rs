//! The far part of a potential: boxes of halved lengths whose charges act on each other through interpolation at Chebyshev points.

use std::array;
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::{Arc, LazyLock, OnceLock};

use super::boxes::{Boxes, CROWD, Cell, OFFSETS};
use super::kernel::PanelKernel;
use super::panels::Panels;
use super::rings::Rings;
use super::threads::{each, parts_of};

/// Chebyshev points of a box. Boxes that act on each other lie at least a box apart: interpolation converges by `(3 + sqrt 8)^-1` with each point.
pub(super) const POINTS: usize = 18;
/// Multiplications for a value of a cardinal polynomial, about: a quotient is worth several.
const CARDINAL: usize = 8;
/// Nodes of a leaf of rings over all: their boxes have matrices of their own, which so take about 60 megabytes.
const CROWD_OF_RINGS: f64 = 1.0 / 320.0;

/// A matrix between points by its columns, each filled up with zeros to whole vectors.
pub(super) type Square = [[f64; WIDE]; POINTS];
pub(super) const WIDE: usize = POINTS.next_multiple_of(8);
/// From the boxes at all offsets to one.
pub(super) type Squares = [Square; OFFSETS.len()];

/// Boxes with all that products take.
#[derive(Debug, Clone)]
pub(super) struct Tree {
    pub(super) boxes: Boxes,
    /// Values of the cardinal polynomials of its box at each node.
    cardinal: Vec<[f64; POINTS]>,
    across: Across,
    /// Values of the parent's cardinal polynomials at the points of the left and right child.
    pub(super) halves: &'static [Square; 2],
    /// The same with rows for columns.
    pub(super) gathers: &'static [Square; 2],
}

/// Between points of boxes by their offsets.
#[derive(Debug, Clone)]
enum Across {
    /// `K(h (t_i - (2 offset + t_k)))`, `h` half of a box, for each number of halvings.
    Shifted(Arc<Vec<Squares>>),
    Rings(BetweenRings),
}

/// Of rings `h^(1 + mu) K`, which for boxes of any size are the same as far from the axis in their lengths: each is made when a product first asks for it.
#[derive(Debug, Clone)]
struct BetweenRings {
    rings: Rings,
    /// By the number of boxes between them and the axis.
    known: BTreeMap<usize, Matrices>,
    of_cell: Vec<Matrices>,
}

type Matrices = Arc<OnceLock<Box<Squares>>>;

/// A value of each of some functions at each point of a box.
pub(super) type AtPoints<const N: usize> = [[f64; POINTS]; N];

/// The boxes for the nodes of panels.
pub(super) fn boxes(kernel: &PanelKernel, panels: &Panels) -> Boxes {
    let share = if kernel.rings().is_some() { CROWD_OF_RINGS } else { 0.0 };
    let crowd = CROWD.max((share * panels.count() as f64) as usize);
    Boxes::new(panels, crowd, kernel.is_closed())
}

impl Tree {
    /// With what is known of another of the same kernel.
    pub(super) fn new(
        kernel: &PanelKernel,
        panels: &Panels,
        boxes: Boxes,
        other: Option<&Self>,
    ) -> Self {
        let across = match (kernel.rings(), other.map(|other| &other.across)) {
            (Some(rings), Some(Across::Rings(known))) => {
                Across::Rings(BetweenRings::new(rings, &boxes, Some(&known.known)))
            }
            (Some(rings), _) => Across::Rings(BetweenRings::new(rings, &boxes, None)),
            (None, Some(Across::Shifted(known))) if known.len() > boxes.deepest() => {
                Across::Shifted(Arc::clone(known))
            }
            (None, _) => Across::Shifted(Arc::new(shifted(kernel, boxes.deepest()))),
        };
        let cardinal = cardinals(&boxes, panels.nodes());
        let [halves, gathers] = &CHEBYSHEV.halves;
        Self { boxes, cardinal, across, halves, gathers }
    }

    /// The matrices of a box with those in reach, and the factor that they lack.
    #[inline(always)]
    pub(super) fn across(&self, place: usize) -> (&Squares, f64) {
        let Cell { level, index, .. } = self.boxes.cells[place];
        match &self.across {
            Across::Shifted(across) => (&across[level], 1.0),
            Across::Rings(between) => between.at(place, level, index),
        }
    }

    /// What a node takes of the values at the points of its box, and gives to the charges there.
    #[inline(always)]
    pub(super) fn at_node(&self, node: usize) -> &[f64; POINTS] {
        &self.cardinal[node]
    }
}

/// The values of the cardinal polynomials of their boxes at all nodes.
fn cardinals(boxes: &Boxes, nodes: &[f64]) -> Vec<[f64; POINTS]> {
    let mut values = vec![[0.0; POINTS]; nodes.len()];
    let mut rest = &mut values[..];
    let ends = boxes.leaves.iter().flat_map(|leaf| &boxes.cells[leaf.ends.clone()]);
    let mut ends: Vec<_> = ends
        .map(|cell| (cell, rest.split_off_mut(..cell.nodes.len()).unwrap_or_default()))
        .collect();
    let share = ends.len().div_ceil(parts_of(CARDINAL * POINTS * nodes.len()));
    each(ends.chunks_mut(share).collect(), |ends| {
        for (cell, values) in ends {
            let (middle, half) = cell.middle();
            for (x, values) in nodes[cell.nodes.clone()].iter().zip(&mut **values) {
                cardinal((x - middle) / half, values);
            }
        }
    });
    values
}

/// Matrices by differences of places, for each number of halvings.
fn shifted(kernel: &PanelKernel, deepest: usize) -> Vec<Squares> {
    let points = &CHEBYSHEV.points;
    let of_level = |level: usize| {
        let half = 1.0 / (1u64 << level) as f64;
        OFFSETS.map(|offset| {
            let mut distances = [[0.0; POINTS]; POINTS];
            for (column, t) in distances.iter_mut().zip(points) {
                *column = points.map(|own| half * (own - (2.0 * offset as f64 + t)));
            }
            kernel.values(distances.as_flattened_mut());
            square(|i, k| distances[k][i])
        })
    };
    (0..=deepest).map(of_level).collect()
}

impl BetweenRings {
    fn new(rings: &Rings, boxes: &Boxes, others: Option<&BTreeMap<usize, Matrices>>) -> Self {
        let mut known: BTreeMap<usize, Matrices> = BTreeMap::new();
        let of_cell = boxes.cells.iter().map(|cell| {
            // Boxes before the axis are empty: no product asks for theirs.
            let target = cell.index.saturating_sub(axis(cell.level));
            let other = || others.and_then(|others| others.get(&target)).cloned();
            Arc::clone(known.entry(target).or_insert_with(|| other().unwrap_or_default()))
        });
        let of_cell = of_cell.collect();
        Self { rings: rings.clone(), known, of_cell }
    }

    #[inline(always)]
    fn at(&self, place: usize, level: usize, index: usize) -> (&Squares, f64) {
        let target = index.saturating_sub(axis(level));
        let squares = self.of_cell[place].get_or_init(|| self.squares(target as isize));
        // Half a box has the length 1/2^level.
        (squares, ((2 * axis(level)) as f64).powf(1.0 + self.rings.exponent()))
    }

    #[cold]
    fn squares(&self, target: isize) -> Box<Squares> {
        let points = &CHEBYSHEV.points;
        let radius = |of: isize, t: f64| (2 * of + 1) as f64 + t;
        let mut squares = Box::new([[[0.0; WIDE]; POINTS]; OFFSETS.len()]);
        for (matrix, offset) in squares.iter_mut().zip(OFFSETS) {
            // The child on the left acts on the third on its right, the one on the right on the third on its left.
            let is_apart = offset.abs() < 3 || (offset > 0) == (target % 2 == 0);
            let source = target + offset;
            if source < 0 || !is_apart {
                continue;
            }
            let apart = |i: usize, k: usize| {
                let (x, s) = (radius(target, points[i]), radius(source, points[k]));
                self.rings.apart(x, s, x - s)
            };
            // All logarithms or powers of a box at once.
            let mut values = [[0.0; POINTS]; POINTS];
            for (k, column) in values.iter_mut().enumerate() {
                *column = array::from_fn(|i| apart(i, k)[0]);
            }
            self.rings.values(values.as_flattened_mut());
            *matrix = square(|i, k| apart(i, k)[1] * values[k][i]);
        }
        squares
    }
}

/// The first box of a level beyond the axis.
fn axis(level: usize) -> usize {
    (1 << level) / 2
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
