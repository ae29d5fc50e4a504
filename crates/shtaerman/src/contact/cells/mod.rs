//! Cells of a base on which complementarity shows what touches, refined where zones are short.
//!
//! Every geometry brings its own kernel between cells; their [load] and what is done with the solutions is the same for all.

mod load;

use load::closing_in;
pub(super) use load::{Loaded, solve_thin};

use super::ground::Ground;
use super::valleys::{self, CELLS_A_ZONE};
use crate::deadline::Deadline;
use crate::line_search::STEPS;
use crate::{Error, Load};

/// Parts of a cell that is refined (survey).
const PARTS: usize = 4;
/// A cell is looked at from inside it: this share of its half-width lies between (survey).
const INSIDE: f64 = 1e-6;

/// How far cells are refined, but where memory allows less: down to lengths of which ten roundings of a place are a hundredth.
const LIMITS: Limits = Limits { shortest: 1e-13, most: 1400, rounds: STEPS };

/// How far cells are refined.
#[derive(Debug, Clone, Copy)]
struct Limits {
    /// Cells shorter than this are not refined.
    shortest: f64,
    /// Most cells after a refinement.
    most: usize,
    /// Most rounds of refinement.
    rounds: usize,
}

/// A cell, on a disk a ring or the disk at the axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    pub(super) left: f64,
    pub(super) right: f64,
    is_carrying: bool,
}

impl Cell {
    pub(super) fn ends(&self) -> [f64; 2] {
        [self.left, self.right]
    }

    pub(super) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(super) fn centre(&self) -> f64 {
        0.5 * (self.left + self.right)
    }

    /// Places of Simpson's rule, inside the cell.
    fn places(&self) -> [f64; 3] {
        let inside = 0.5 * self.width() * (1.0 - INSIDE);
        [-1.0, 0.0, 1.0].map(|side| self.centre() + side * inside)
    }

    fn parts(self, count: usize) -> impl Iterator<Item = Self> {
        let at = move |part: usize| match part {
            0 => self.left,
            _ if part == count => self.right,
            _ => self.left + self.width() * part as f64 / count as f64,
        };
        (0..count).map(move |part| Self { left: at(part), right: at(part + 1), ..self })
    }
}

/// Cells from left to right, with or without gaps between them, and which of them carry.
#[derive(Debug, Clone)]
pub(super) struct Cells {
    cells: Vec<Cell>,
    limits: Limits,
}

impl Cells {
    /// Simpson's means of a profile over the cells, from its heights at many places.
    pub(super) fn means(&self, heights: impl Fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
        let places: Vec<f64> = self.cells.iter().flat_map(Cell::places).collect();
        let heights = heights(&places);
        let cells = heights.as_chunks().0.iter();
        cells.map(|[left, at, right]| (left + 4.0 * at + right) / 6.0).collect()
    }

    /// Pieces of a base, each cut at places in any order, of which those too close to one another or to an end are left out. At first all cells carry.
    fn new(pieces: impl IntoIterator<Item = ([f64; 2], Vec<f64>)>, limits: Limits) -> Self {
        let shortest = limits.shortest;
        let mut cells = Vec::new();
        for ([first, last], mut cuts) in pieces {
            cuts.retain(|at| *at > first + shortest && *at < last - shortest);
            cuts.sort_by(f64::total_cmp);
            cuts.dedup_by(|next, before| *next - *before < shortest);
            cuts.push(last);
            let mut left = first;
            for right in cuts {
                cells.push(Cell { left, right, is_carrying: true });
                left = right;
            }
        }
        Self { cells, limits }
    }

    /// About so many cells of the pieces of a base, cut at its valleys, at places that are asked for given the width of a cell, and ever closer towards where the load acts.
    pub(super) fn of_base(
        pieces: &[[f64; 2]],
        valleys: &[f64],
        load: Load,
        count: usize,
        places: impl Fn(f64) -> Vec<f64>,
    ) -> Self {
        let total: f64 = pieces.iter().map(|[left, right]| right - left).sum();
        let pieces = pieces.iter().map(|&[left, right]| {
            let own = (count as f64 * (right - left) / total).ceil().max(CELLS_A_ZONE as f64);
            let width = (right - left) / own;
            let inside: Vec<f64> =
                valleys.iter().copied().filter(|at| left < *at && *at < right).collect();
            let mut cuts = valleys::cuts(&inside, [left, right], own as usize);
            cuts.extend(places(width));
            cuts.extend(closing_in(load, width, LIMITS.shortest));
            ([left, right], cuts)
        });
        Self::new(pieces, LIMITS)
    }

    pub(super) fn cells(&self) -> &[Cell] {
        &self.cells
    }

    pub(super) fn carrying(&self) -> Vec<bool> {
        self.cells.iter().map(|cell| cell.is_carrying).collect()
    }

    /// The cells with a positive value carry.
    pub(super) fn mark(&mut self, values: &[f64]) {
        for (cell, value) in self.cells.iter_mut().zip(values) {
            cell.is_carrying = *value > 0.0;
        }
    }

    /// Solves with the roots of masses and the matrix of a ground, marks the cells that carry and refines, until every zone has enough of them: the intervals of contact.
    pub(super) fn settled(
        mut self,
        (ground, deadline): (&dyn Ground, &Deadline),
        solve: impl Fn(&Self, Vec<f64>, Vec<f64>) -> Result<Vec<f64>, Error>,
    ) -> Result<Vec<[f64; 2]>, Error> {
        for _ in 0..self.limits.rounds {
            let places: Vec<[f64; 2]> = self.cells.iter().map(Cell::ends).collect();
            let (matrix, masses) = ground.cells(&places);
            let roots = masses.iter().map(|mass| mass.sqrt()).collect();
            let values = solve(&self, roots, matrix)?;
            self.mark(&values);
            deadline.spend(ground.entry() * (places.len() as f64).powi(2));
            if deadline.is_past() || !self.refine() {
                break;
            }
        }
        Ok(self.intervals())
    }

    /// Splits the cells of zones that have few, and their neighbours; whether there were any.
    pub(super) fn refine(&mut self) -> bool {
        let Limits { shortest, most, .. } = self.limits;
        let mut split = vec![false; self.cells.len()];
        for [first, end] in self.runs() {
            if end - first < CELLS_A_ZONE {
                (first.saturating_sub(1)..(end + 1).min(self.cells.len()))
                    .filter(|&i| self.cells[i].width() > PARTS as f64 * shortest)
                    .for_each(|i| split[i] = true);
            }
        }
        let splits = split.iter().filter(|split| **split).count();
        if splits == 0 || self.cells.len() + (PARTS - 1) * splits > most {
            return false;
        }
        let parts = self.cells.iter().zip(split);
        self.cells =
            parts.flat_map(|(cell, split)| cell.parts(if split { PARTS } else { 1 })).collect();
        true
    }

    /// Runs of carrying cells without a gap, as ranges of indices.
    pub(super) fn runs(&self) -> Vec<[usize; 2]> {
        let mut runs: Vec<[usize; 2]> = Vec::new();
        for i in (0..self.cells.len()).filter(|&i| self.cells[i].is_carrying) {
            match runs.last_mut() {
                Some(run) if run[1] == i && self.cells[i - 1].right == self.cells[i].left => {
                    run[1] = i + 1;
                }
                _ => runs.push([i, i + 1]),
            }
        }
        runs
    }

    /// The intervals of contact to about a cell.
    pub(super) fn intervals(&self) -> Vec<[f64; 2]> {
        let of = |[i, j]: [usize; 2]| [self.cells[i].left, self.cells[j - 1].right];
        self.runs().into_iter().map(of).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FEW: Limits = Limits { shortest: 1e-9, most: 40, rounds: 10 };

    #[test]
    fn zones_with_few_cells_are_refined_and_gaps_part_them() {
        let cuts = |left: f64| (1..4).map(|i| left + 0.25 * f64::from(i)).collect::<Vec<f64>>();
        let mut cells = Cells::new([([-1.0, 0.0], cuts(-1.0)), ([0.5, 1.5], cuts(0.5))], FEW);
        assert_eq!(cells.cells().len(), 8);
        // The last cell of the first piece and the first one of the second.
        cells.mark(&[0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
        assert_eq!(cells.intervals(), [[-0.25, 0.0], [0.5, 0.75]]);
        assert!(cells.refine());
        assert_eq!(cells.cells().len(), 8 + 3 * 4);
        assert_eq!(cells.intervals(), [[-0.25, 0.0], [0.5, 0.75]]);
        let lengths: f64 = cells.cells().iter().map(Cell::width).sum();
        assert!((lengths - 2.0).abs() < 1e-15);
        // No more than the limit.
        cells.mark(&[0.0; 20]);
        assert!(!cells.refine());
    }

    #[test]
    fn cuts_too_close_make_no_cells() {
        let cuts = vec![0.5, 0.5 + 1e-10, 1e-10, 1.0 - 1e-10, 0.2];
        let cells = Cells::new([([0.0, 1.0], cuts)], FEW);
        let ends: Vec<[f64; 2]> = cells.cells().iter().map(Cell::ends).collect();
        assert_eq!(ends, [[0.0, 0.2], [0.2, 0.5], [0.5, 1.0]]);
    }
}
