//! Products of a tree with charges: from the nodes up to the boxes of all levels, across between boxes, and down to those of the nodes.
//!
//! The boxes of a level are shared among all processors.

use std::ops::Range;

use super::boxes::Cell;
use super::threads::{each, parts_of};
use super::tree::{AtPoints, POINTS, Square, Tree, WIDE, points};
use crate::linear::vectorised;

/// Products with matrices for each box, about.
const PRODUCTS: usize = 4;

/// Values at the points of all boxes.
pub(super) type OfBoxes<const N: usize> = Vec<AtPoints<N>>;

impl Tree {
    /// The potentials of the charges of some functions, but for those of nodes near by, at the points of all boxes; `everywhere`, or where there are nodes. Of each the same to the last bit as by itself.
    pub(super) fn locals<const N: usize>(
        &self,
        charges: [&[f64]; N],
        everywhere: bool,
    ) -> OfBoxes<N> {
        let moments = self.gathered(charges);
        let cells = &self.boxes.cells;
        let mut locals = vec![[[0.0; POINTS]; N]; cells.len()];
        for (k, level) in self.boxes.levels().enumerate() {
            let (above, own) = locals.split_at_mut(level.start);
            in_parts(
                &mut own[..level.len()],
                #[inline(always)]
                |place, local| {
                    let place = level.start + place;
                    let cell = &cells[place];
                    if !everywhere && cell.nodes.is_empty() {
                        return;
                    }
                    if k > 0 {
                        add_product(&self.halves[cell.index % 2], &above[cell.parent], local);
                    }
                    self.gather_far(&moments, place, local);
                },
            );
        }
        locals
    }

    /// What the boxes in reach of this one give.
    #[inline(always)]
    fn gather_far<const N: usize>(
        &self,
        moments: &[AtPoints<N>],
        place: usize,
        local: &mut AtPoints<N>,
    ) {
        let cell = &self.boxes.cells[place];
        let is_something = |other: &usize| !self.boxes.cells[*other].nodes.is_empty();
        if !cell.sources.iter().flatten().any(is_something) {
            return;
        }
        let (across, factor) = self.across(place);
        for (matrix, other) in across.iter().zip(cell.sources) {
            let Some(source) = other.filter(is_something).map(|other| &moments[other]) else {
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

    /// Calls with the places of charges that stand for those in all boxes that act on one and on those that hold it.
    pub(super) fn far_of(
        &self,
        end: usize,
        moments: &[AtPoints<1>],
        mut charge: impl FnMut(f64, f64),
    ) {
        let deeper = self.boxes.levels().next().map_or(0, |level| level.end);
        let mut place = end;
        loop {
            let cell = &self.boxes.cells[place];
            for other in cell.sources.into_iter().flatten() {
                let (middle, half) = self.boxes.cells[other].middle();
                let [own] = &moments[other];
                if own.iter().any(|own| *own != 0.0) {
                    points().iter().zip(own).for_each(|(t, own)| charge(middle + half * t, *own));
                }
            }
            if place < deeper {
                break;
            }
            place = cell.parent;
        }
    }

    /// The charges at the points of all boxes.
    pub(super) fn gathered<const N: usize>(&self, charges: [&[f64]; N]) -> OfBoxes<N> {
        let cells = &self.boxes.cells;
        let mut moments = vec![[[0.0; POINTS]; N]; cells.len()];
        for level in self.boxes.levels().rev() {
            let (own, below) = moments.split_at_mut(level.end);
            in_parts(
                &mut own[level.start..],
                #[inline(always)]
                |place, moments| {
                    let cell = &cells[level.start + place];
                    self.gather(cell, charges, (below, level.end), moments);
                },
            );
        }
        moments
    }

    /// The charges of a box from those of its halves, which are among boxes from the first of these on, or of its nodes.
    #[inline(always)]
    fn gather<const N: usize>(
        &self,
        cell: &Cell,
        charges: [&[f64]; N],
        (below, first): (&[AtPoints<N>], usize),
        moments: &mut AtPoints<N>,
    ) {
        let Range { start, end } = cell.nodes;
        if start == end {
            return;
        }
        if let Some(halves) = cell.halves {
            for (half, gather) in below[halves - first..].iter().zip(self.gathers) {
                add_product(gather, half, moments);
            }
            return;
        }
        for node in start..end {
            let row = self.at_node(node);
            for (moments, charges) in moments.iter_mut().zip(charges) {
                moments.iter_mut().zip(row).for_each(|(m, v)| *m += charges[node] * v);
            }
        }
    }
}

/// Does the work for each box of a level, by its place there.
fn in_parts<const N: usize>(
    boxes: &mut [AtPoints<N>],
    work: impl Fn(usize, &mut AtPoints<N>) + Sync,
) {
    let parts = parts_of(N * PRODUCTS * boxes.len() * POINTS * POINTS);
    let share = boxes.len().div_ceil(parts).max(1);
    each(boxes.chunks_mut(share).enumerate().collect(), |(part, boxes)| {
        vectorised(
            #[inline(always)]
            || {
                for (place, own) in boxes.iter_mut().enumerate() {
                    work(part * share + place, own);
                }
            },
        );
    });
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
