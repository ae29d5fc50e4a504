//! Products of a tree with charges: from the nodes up to the boxes of all levels, across between boxes, and down to the leaves.
//!
//! Below one level the parts of the tree under its boxes go up and down by themselves, on all processors.

use super::threads::{each, parts_of};
use super::tree::{AtPoints, OFFSETS, POINTS, SHALLOWEST, Square, Tree, WIDE, points};
use crate::linear::vectorised;

/// The level under whose boxes parts go by themselves: some for each processor.
const PARTED: u32 = SHALLOWEST + 4;
/// Products with matrices for each leaf, about: the boxes above are as many again.
const PRODUCTS: usize = 10;

/// Charges at the points of the boxes of a level.
pub(super) type Level<const N: usize> = Vec<AtPoints<N>>;

impl Tree {
    /// The potentials of the charges of some functions at all nodes but those of neighbouring leaves, at the points of the leaves; `everywhere`, or where there are nodes. Of each the same to the last bit
    /// as by itself.
    pub(super) fn locals<const N: usize>(
        &self,
        charges: [&[f64]; N],
        everywhere: bool,
    ) -> Level<N> {
        let levels = self.gathered(charges);
        let parted = PARTED.min(self.depth);
        let mut above = vec![[[0.0; POINTS]; N]; 2];
        for level in SHALLOWEST..=parted {
            let mut locals = vec![[[0.0; POINTS]; N]; 1 << level];
            self.descend((level, 0), &levels, everywhere, &above, &mut locals);
            above = locals;
        }
        if parted == self.depth {
            return above;
        }
        let mut found = vec![[[0.0; POINTS]; N]; self.leaves()];
        let parts = above.iter().zip(found.chunks_mut(self.leaves() >> parted)).enumerate();
        self.in_parts(
            N,
            parts.collect(),
            #[inline(always)]
            |(part, (above, found))| {
                let mut above = vec![**above];
                for level in parted + 1..=self.depth {
                    let boxes = 1 << (level - parted);
                    let mut locals = vec![[[0.0; POINTS]; N]; boxes];
                    self.descend((level, *part * boxes), &levels, everywhere, &above, &mut locals);
                    above = locals;
                }
                found.copy_from_slice(&above);
            },
        );
        found
    }

    /// Does parts of the tree for so many functions.
    fn in_parts<T: Send>(&self, functions: usize, mut parts: Vec<T>, work: impl Fn(&mut T) + Sync) {
        let products = functions * PRODUCTS * self.leaves();
        let share = parts.len().div_ceil(parts_of(products * POINTS * POINTS));
        each(parts.chunks_mut(share).collect(), |parts| {
            vectorised(
                #[inline(always)]
                || {
                    for part in parts {
                        work(part);
                    }
                },
            );
        });
    }

    /// The potentials in neighbouring boxes of a level from that of their parents, and from the boxes in reach.
    #[inline(always)]
    fn descend<const N: usize>(
        &self,
        (level, first): (u32, usize),
        levels: &[Level<N>],
        everywhere: bool,
        above: &[AtPoints<N>],
        locals: &mut [AtPoints<N>],
    ) {
        let span = self.leaves() >> level;
        let moments = &levels[(level - SHALLOWEST) as usize];
        for (place, local) in locals.iter_mut().enumerate() {
            let b = first + place;
            let is_beyond = b * span >= self.covering;
            if is_beyond || !everywhere && self.nodes_of(b * span, (b + 1) * span - 1).is_empty() {
                continue;
            }
            if level > SHALLOWEST {
                add_product(&self.halves[b % 2], &above[place / 2], local);
            }
            self.gather_far(moments, b, level, local);
        }
    }

    /// What the boxes in reach of this one give: children of neighbours of the parent that are no neighbours themselves.
    #[inline(always)]
    fn gather_far<const N: usize>(
        &self,
        moments: &[AtPoints<N>],
        b: usize,
        level: u32,
        local: &mut AtPoints<N>,
    ) {
        let (across, factor) = self.across(b, level);
        for (matrix, other) in across.iter().zip(self.in_reach(b, level)) {
            let Some(source) = other.map(|other| &moments[other]).filter(|m| !is_nothing(m)) else {
                continue;
            };
            if factor == 1.0 {
                add_product(matrix, source, local);
            } else {
                let scaled = source.map(|charges| charges.map(|charge| factor * charge));
                add_product(matrix, &scaled, local);
            }
        }
    }

    /// The boxes in reach of this one, by their offsets.
    #[inline(always)]
    fn in_reach(&self, b: usize, level: u32) -> [Option<usize>; OFFSETS.len()] {
        let boxes = 1usize << level;
        let mut found = [None; OFFSETS.len()];
        for (k, offset) in OFFSETS.into_iter().enumerate() {
            let other = b as isize + offset;
            let other = if self.is_closed { other.rem_euclid(boxes as isize) } else { other };
            let other = usize::try_from(other).ok().filter(|other| *other < boxes);
            // Of a circle of four boxes the opposite one is met twice, and three boxes on is the neighbour.
            found[k] = other.filter(|&other| {
                self.distance(b, other, boxes) >= 2
                    && self.distance(b / 2, other / 2, boxes / 2) <= 1
                    && !found[..k].contains(&Some(other))
            });
        }
        found
    }

    /// The middle of a box, and half its length.
    fn middle(&self, b: usize, level: u32) -> (f64, f64) {
        let half = (self.leaves() >> level) as f64 / self.covering as f64;
        ((2 * b + 1) as f64 * half - 1.0, half)
    }

    /// Calls with the places of charges that stand for those in all boxes in reach of a leaf and of the boxes that hold it.
    pub(super) fn far_of(
        &self,
        leaf: usize,
        levels: &[Level<1>],
        mut charge: impl FnMut(f64, f64),
    ) {
        for (level, moments) in (SHALLOWEST..).zip(levels) {
            let b = leaf >> (self.depth - level);
            for other in self.in_reach(b, level).into_iter().flatten() {
                let (middle, half) = self.middle(other, level);
                let [own] = &moments[other];
                if !is_nothing(&moments[other]) {
                    points().iter().zip(own).for_each(|(t, own)| charge(middle + half * t, *own));
                }
            }
        }
    }

    /// Number of boxes from one to another, by the shorter way.
    fn distance(&self, one: usize, other: usize, boxes: usize) -> usize {
        let steps = one.abs_diff(other);
        if self.is_closed { steps.min(boxes - steps) } else { steps }
    }

    /// The charges at the points of the boxes, from the coarsest level to the leaves.
    pub(super) fn gathered<const N: usize>(&self, charges: [&[f64]; N]) -> Vec<Level<N>> {
        let level = |level: u32| vec![[[0.0; POINTS]; N]; 1 << level];
        let mut levels: Vec<Level<N>> = (SHALLOWEST..=self.depth).map(level).collect();
        let parted = PARTED.min(self.depth);
        let (tops, parts) = levels.split_at_mut((parted - SHALLOWEST) as usize);
        let mut rest: Vec<_> = (parts.iter_mut().enumerate())
            .map(|(below, level)| level.chunks_exact_mut(1 << below))
            .collect();
        let parts = (0..1usize << parted).map(|part| {
            let levels = rest.iter_mut().filter_map(Iterator::next).collect();
            (part, levels)
        });
        let parts: Vec<(usize, Vec<&mut [AtPoints<N>]>)> = parts.collect();
        self.in_parts(
            N,
            parts,
            #[inline(always)]
            |(part, levels)| self.gather(*part, charges, levels),
        );
        for level in (0..tops.len()).rev() {
            let (upper, lower) = levels.split_at_mut(level + 1);
            self.ascend(&lower[0], &mut upper[level]);
        }
        levels
    }

    /// The charges of the boxes under one, from those of the nodes.
    #[inline(always)]
    fn gather<const N: usize>(
        &self,
        part: usize,
        charges: [&[f64]; N],
        levels: &mut [&mut [AtPoints<N>]],
    ) {
        let Some((leaves, upper)) = levels.split_last_mut() else { return };
        let first = part * leaves.len();
        for (leaf, moments) in leaves.iter_mut().enumerate() {
            for j in self.nodes_of(first + leaf, first + leaf) {
                let row = self.at_node(j);
                for (moments, charges) in moments.iter_mut().zip(charges) {
                    moments.iter_mut().zip(row).for_each(|(m, v)| *m += charges[j] * v);
                }
            }
        }
        let mut below = &mut **leaves;
        for level in upper.iter_mut().rev() {
            self.ascend(below, level);
            below = &mut **level;
        }
    }

    /// The charges of boxes from those of their halves.
    #[inline(always)]
    fn ascend<const N: usize>(&self, halves: &[AtPoints<N>], boxes: &mut [AtPoints<N>]) {
        for (pair, whole) in halves.chunks_exact(2).zip(boxes) {
            for (half, gather) in pair.iter().zip(self.gathers) {
                if !is_nothing(half) {
                    add_product(gather, half, whole);
                }
            }
        }
    }
}

fn is_nothing<const N: usize>(charges: &AtPoints<N>) -> bool {
    charges.as_flattened().iter().all(|charge| *charge == 0.0)
}

/// Adds a matrix times the values of each function: all rows advance together, and even and odd columns, as each sum waits for the product before.
#[inline(always)]
fn add_product<const N: usize>(matrix: &Square, values: &AtPoints<N>, targets: &mut AtPoints<N>) {
    for (values, target) in values.iter().zip(targets) {
        let mut sums = [[0.0; WIDE]; 2];
        for (columns, values) in matrix.as_chunks::<2>().0.iter().zip(values.as_chunks::<2>().0) {
            for ((sums, column), value) in sums.iter_mut().zip(columns).zip(values) {
                for (sum, entry) in sums.iter_mut().zip(column) {
                    *sum += value * entry;
                }
            }
        }
        let [even, odd] = sums;
        for ((target, even), odd) in target.iter_mut().zip(even).zip(odd) {
            *target += even + odd;
        }
    }
}

/// Columns go in pairs.
const _: () = assert!(POINTS.is_multiple_of(2));
