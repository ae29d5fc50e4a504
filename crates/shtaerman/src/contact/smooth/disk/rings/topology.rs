//! Which parts of the base touch: a complementarity problem on rings of cells, with a layer too thin to matter, refined where zones are short.

use std::f64::consts::{LN_2, PI};

use fredholm::complementarity::{
    Complementarity, ComplementaritySolution, Condition, logarithm_cells,
};

use super::base::Base;
use super::kernel::mean;
use crate::{Error, Vertical};

/// `theta0` of the layer.
const LAYER: f64 = 1e9;
/// Fewest cells of a zone.
const CELLS_A_ZONE: usize = 6;
/// Parts of a cell that is refined.
const PARTS: usize = 4;
/// Most rounds of refinement, and most cells.
const ROUNDS: usize = 40;
pub(super) const MOST_CELLS: usize = 800;
/// Cells shorter than this are not refined.
const SHORTEST: f64 = 1e-13;

/// The intervals of contact to about a cell, each of which has several; `count` is the number of cells to begin with.
pub(super) fn find(base: &Base<'_>, count: usize) -> Result<Vec<[f64; 2]>, Error> {
    let mut cells = Cells::new(base, count);
    for _ in 0..ROUNDS {
        let solution = cells.solve(base)?;
        for (cell, z) in cells.cells.iter_mut().zip(&solution.values) {
            cell.is_carrying = *z > 0.0;
        }
        if !cells.refine() {
            break;
        }
    }
    let run = |[i, j]: [usize; 2]| [cells.cells[i].left, cells.cells[j - 1].right];
    Ok(cells.runs().into_iter().map(run).collect())
}

/// Whether so many cells touch as one disk.
pub(super) fn is_disk(base: &Base<'_>, count: usize) -> Result<bool, Error> {
    let mut cells = Cells::new(base, count);
    let solution = cells.solve(base)?;
    for (cell, z) in cells.cells.iter_mut().zip(&solution.values) {
        cell.is_carrying = *z > 0.0;
    }
    Ok(matches!(cells.runs()[..], [[0, _]]))
}

/// A ring, or the disk at the axis.
#[derive(Debug, Clone, Copy)]
struct Cell {
    left: f64,
    right: f64,
    is_carrying: bool,
}

impl Cell {
    fn width(&self) -> f64 {
        self.right - self.left
    }

    fn centre(&self) -> f64 {
        0.5 * (self.left + self.right)
    }

    /// `int r dr`.
    fn measure(&self) -> f64 {
        self.centre() * self.width()
    }

    /// Simpson's mean of the profile, from inside the cell.
    fn mean_height(&self, base: &Base<'_>) -> f64 {
        let inside = 0.5 * self.width() * (1.0 - 1e-6);
        let at = |side: f64| base.height(self.centre() + side * inside);
        (at(-1.0) + 4.0 * at(0.0) + at(1.0)) / 6.0
    }

    fn parts(self, count: usize) -> impl Iterator<Item = Cell> {
        let at = move |part: usize| match part {
            0 => self.left,
            _ if part == count => self.right,
            _ => self.left + self.width() * part as f64 / count as f64,
        };
        (0..count).map(move |part| Cell { left: at(part), right: at(part + 1), ..self })
    }
}

struct Cells {
    cells: Vec<Cell>,
}

impl Cells {
    fn new(base: &Base<'_>, count: usize) -> Self {
        let mut places: Vec<f64> = (1..count).map(|i| i as f64 / count as f64).collect();
        places.extend(base.problem.breaks.iter().copied());
        places.retain(|at| *at > SHORTEST && *at < 1.0 - SHORTEST);
        places.sort_by(f64::total_cmp);
        places.dedup_by(|next, last| *next - *last < SHORTEST);
        places.push(1.0);
        let mut left = 0.0;
        let cells = places
            .into_iter()
            .map(|right| Cell {
                left: std::mem::replace(&mut left, right),
                right,
                is_carrying: true,
            })
            .collect();
        Self { cells }
    }

    /// `pi W_0` between the cells, times the roots of their measures: at their middles, but with the mean of its logarithm.
    fn matrix(&self) -> Result<Vec<f64>, Error> {
        let mut boundaries = vec![0.0];
        boundaries.extend(self.cells.iter().map(|cell| cell.right));
        let mut matrix = logarithm_cells(&boundaries)?;
        let stride = self.cells.len();
        for (i, one) in self.cells.iter().enumerate() {
            for (j, other) in self.cells.iter().enumerate() {
                let (r, s) = (one.centre(), other.centre());
                let root = (r * s).sqrt();
                let widths = (one.width() * other.width()).sqrt();
                let beside = if i == j {
                    3.0 * LN_2 + r.ln()
                } else {
                    let middle = PI * root / (2.0 * mean(0.5 * (r + s), 0.5 * (r - s).abs()));
                    middle + (r - s).abs().ln()
                };
                let entry = &mut matrix[i * stride + j];
                let means = *entry / widths + beside;
                *entry = means / root * (one.measure() * other.measure()).sqrt();
            }
        }
        Ok(matrix)
    }

    fn solve(&self, base: &Base<'_>) -> Result<ComplementaritySolution, Error> {
        let roots: Vec<f64> = self.cells.iter().map(|cell| cell.measure().sqrt()).collect();
        let gain = LAYER / base.problem.theta0;
        let mut right: Vec<f64> = (roots.iter().zip(&self.cells))
            .map(|(root, cell)| -gain * root * cell.mean_height(base))
            .collect();
        let mut conditions = Vec::new();
        let mut feasible = vec![0.0; roots.len()];
        match base.problem.load.vertical {
            Vertical::Force(force) => {
                let value = force / (2.0 * PI);
                let row = roots.clone();
                conditions.push(Condition { row, column: roots.clone(), value });
                // An even pressure.
                let whole: f64 = roots.iter().map(|root| root * root).sum();
                feasible = roots.iter().map(|root| value / whole * root).collect();
            }
            Vertical::Settlement(settlement) => {
                let added = roots.iter().map(|root| gain * settlement * root);
                right.iter_mut().zip(added).for_each(|(value, by)| *value += by);
            }
        }
        let start: Vec<bool> = self.cells.iter().map(|cell| cell.is_carrying).collect();
        let matrix = Complementarity::new(self.matrix()?, LAYER)?;
        Ok(matrix.solve(&right, &conditions, &start, &feasible)?)
    }

    /// Splits the cells of zones that have few, and their neighbours; whether there were any.
    fn refine(&mut self) -> bool {
        let mut split = vec![false; self.cells.len()];
        for [first, end] in self.runs() {
            if end - first < CELLS_A_ZONE {
                (first.saturating_sub(1)..(end + 1).min(self.cells.len()))
                    .filter(|&i| self.cells[i].width() > PARTS as f64 * SHORTEST)
                    .for_each(|i| split[i] = true);
            }
        }
        let splits = split.iter().filter(|split| **split).count();
        if splits == 0 || self.cells.len() + (PARTS - 1) * splits > MOST_CELLS {
            return false;
        }
        let parts = self.cells.iter().zip(split);
        self.cells =
            parts.flat_map(|(cell, split)| cell.parts(if split { PARTS } else { 1 })).collect();
        true
    }

    /// Runs of carrying cells without a gap, as ranges of indices.
    fn runs(&self) -> Vec<[usize; 2]> {
        let mut runs: Vec<[usize; 2]> = Vec::new();
        for i in (0..self.cells.len()).filter(|&i| self.cells[i].is_carrying) {
            match runs.last_mut() {
                Some(run) if run[1] == i => run[1] = i + 1,
                _ => runs.push([i, i + 1]),
            }
        }
        runs
    }
}
