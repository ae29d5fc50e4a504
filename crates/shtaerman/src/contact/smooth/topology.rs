//! Which parts of the base touch: a complementarity problem on cells, with a layer too thin to matter, refined where zones are short.

use fredholm::complementarity::{
    Complementarity, ComplementaritySolution, Condition, logarithm_cells,
};

use super::problem::Base;
use crate::contact::unilateral::mean_power;
use crate::{Error, Load, Rotational, Vertical};

/// `theta0` of the layer.
const LAYER: f64 = 1e9;
/// Fewest cells of a zone.
const CELLS_A_ZONE: usize = 6;
/// Parts of a cell that is refined.
const PARTS: usize = 4;
/// Most rounds of refinement, and most cells.
const ROUNDS: usize = 40;
const MOST_CELLS: usize = 1400;
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
        let total: f64 = base.problem.pieces.iter().map(|[left, right]| right - left).sum();
        let mut cells = Vec::new();
        for &[left, right] in &base.problem.pieces {
            let count = (count as f64 * (right - left) / total).ceil().max(4.0);
            let width = (right - left) / count;
            let mut inside: Vec<f64> =
                (1..count as usize).map(|i| left + width * i as f64).collect();
            let beside = base.problem.profile.breaks.iter().copied();
            inside.extend(beside.chain(graded(base, width)));
            inside.retain(|at| *at > left + SHORTEST && *at < right - SHORTEST);
            inside.sort_by(f64::total_cmp);
            inside.dedup_by(|next, last| *next - *last < SHORTEST);
            inside.push(right);
            let mut from = left;
            for to in inside {
                cells.push(Cell { left: from, right: to, is_carrying: true });
                from = to;
            }
        }
        Self { cells }
    }

    /// The kernel on the cells: its logarithm without the gaps of the base, and what a row adds.
    fn matrix(&self, base: &Base<'_>) -> Result<Vec<f64>, Error> {
        let mut boundaries = vec![self.cells[0].left];
        let mut kept = Vec::new();
        for cell in &self.cells {
            if boundaries.last().is_some_and(|last| *last < cell.left) {
                boundaries.push(cell.left);
            }
            kept.push(boundaries.len() - 1);
            boundaries.push(cell.right);
        }
        let all = match base.grading {
            Some(exponent) => {
                let is_forced = matches!(base.problem.load.vertical, Vertical::Force(_));
                power_cells(&boundaries, exponent, is_forced)
            }
            None => logarithm_cells(&boundaries)?,
        };
        let stride = boundaries.len() - 1;
        let kernel = base.problem.kernel;
        let mut matrix = Vec::with_capacity(kept.len() * kept.len());
        for (i, one) in self.cells.iter().enumerate() {
            for (j, other) in self.cells.iter().enumerate() {
                let mut entry = all[kept[i] * stride + kept[j]];
                if let (Some(period), Some(remainder)) = (kernel.period(), kernel.remainder()) {
                    let d = one.centre() - other.centre();
                    let least = 0.25 * (one.width() + other.width());
                    let image = |shift: f64| -(d + shift).abs().max(least).ln();
                    let added = image(period) + image(-period) + remainder.at(d);
                    entry += added * (one.width() * other.width()).sqrt();
                }
                matrix.push(entry);
            }
        }
        Ok(matrix)
    }

    fn solve(&self, base: &Base<'_>) -> Result<ComplementaritySolution, Error> {
        let roots: Vec<f64> = self.cells.iter().map(|cell| cell.width().sqrt()).collect();
        let weighted = |f: &dyn Fn(f64) -> f64| -> Vec<f64> {
            roots.iter().zip(&self.cells).map(|(root, cell)| root * f(cell.centre())).collect()
        };
        let (ones, lever) = (weighted(&|_| 1.0), weighted(&|x| x));
        let kernel = match (base.grading, base.problem.load.vertical) {
            (Some(exponent), Vertical::Force(_)) => exponent,
            _ => 1.0,
        };
        let gain = LAYER / (kernel * base.problem.theta0);
        let mut right: Vec<f64> = (roots.iter().zip(&self.cells))
            .map(|(root, cell)| -gain * root * cell.mean_height(base))
            .collect();
        let mut add = |column: &[f64], by: f64| {
            right.iter_mut().zip(column).for_each(|(value, c)| *value += gain * by * c);
        };
        let Load { vertical, rotational } = base.problem.load;
        let mut conditions = Vec::new();
        let mut prescribed = None;
        match vertical {
            Vertical::Force(value) => {
                conditions.push(Condition { row: ones.clone(), column: ones.clone(), value });
                prescribed = Some(value);
            }
            Vertical::Settlement(settlement) => add(&ones, settlement),
        }
        match (rotational, prescribed) {
            (Rotational::Moment(value), _) => {
                conditions.push(Condition { row: lever.clone(), column: lever, value });
            }
            (Rotational::Eccentricity(e), Some(force)) => {
                conditions.push(Condition { row: lever.clone(), column: lever, value: e * force });
            }
            (Rotational::Eccentricity(e), None) => {
                conditions.push(Condition { row: weighted(&|x| x - e), column: lever, value: 0.0 });
            }
            (Rotational::Tilt(tilt), _) => add(&lever, -tilt),
        }
        let feasible = self.feasible(base, &roots);
        let start: Vec<bool> = self.cells.iter().map(|cell| cell.is_carrying).collect();
        let matrix = Complementarity::new(self.matrix(base)?, LAYER)?;
        Ok(matrix.solve(&right, &conditions, &start, &feasible)?)
    }

    /// A pressure that is not negative and meets the conditions, times the roots of the widths.
    fn feasible(&self, base: &Base<'_>, roots: &[f64]) -> Vec<f64> {
        let centres: Vec<f64> = self.cells.iter().map(Cell::centre).collect();
        let mut values = vec![0.0; centres.len()];
        let last = centres.len() - 1;
        let Load { vertical, rotational } = base.problem.load;
        match (vertical, rotational) {
            (Vertical::Settlement(_), Rotational::Moment(moment)) if moment != 0.0 => {
                let cell = if moment > 0.0 { last } else { 0 };
                values[cell] = moment / (centres[cell] * roots[cell]);
            }
            (Vertical::Settlement(_), _) => {}
            (Vertical::Force(force), rotational) => {
                let arm = match rotational {
                    Rotational::Moment(moment) => moment / force,
                    Rotational::Eccentricity(e) => e,
                    Rotational::Tilt(_) => 0.0,
                };
                let density = balanced(&centres, roots, arm);
                let carried: f64 = density.iter().zip(roots).map(|(p, root)| p * root * root).sum();
                for i in 0..=last {
                    values[i] = force * density[i] / carried * roots[i];
                }
            }
        }
        values
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
                Some(run) if run[1] == i && self.cells[i - 1].right == self.cells[i].left => {
                    run[1] = i + 1;
                }
                _ => runs.push([i, i + 1]),
            }
        }
        runs
    }
}

/// The means of `d^-mu`, `d = |x - s|`, over cells, times the roots of their widths. Where the force is prescribed those of `(d^-mu - 4^-mu)/mu`: a constant adds to the settlement alone,
/// and of a small `mu` it would leave few digits for the rest.
fn power_cells(boundaries: &[f64], exponent: f64, is_forced: bool) -> Vec<f64> {
    let (level, scale) = if is_forced { (4f64.powf(-exponent), exponent) } else { (0.0, 1.0) };
    let count = boundaries.len() - 1;
    let cell = |i: usize| [boundaries[i], boundaries[i + 1]];
    let root = |i: usize| (boundaries[i + 1] - boundaries[i]).sqrt();
    let entry = |i: usize, j: usize| {
        let mean = mean_power(cell(i.min(j)), cell(i.max(j)), exponent);
        (mean - level) / scale * root(i) * root(j)
    };
    (0..count * count).map(|place| entry(place / count, place % count)).collect()
}

/// Boundaries that close in on an edge of the punch until a cell fits between it and the line of the force.
fn graded(base: &Base<'_>, width: f64) -> impl Iterator<Item = f64> {
    let Load { vertical, rotational } = base.problem.load;
    let arm = match (vertical, rotational) {
        (Vertical::Force(force), Rotational::Moment(moment)) => moment / force,
        (_, Rotational::Eccentricity(e)) => e,
        _ => 0.0,
    };
    let room = 0.25 * (1.0 - arm.abs());
    let halvings = std::iter::successors(Some(0.5 * width), |width| Some(0.5 * width));
    halvings
        .take_while(move |width| *width > room.max(SHORTEST))
        .map(move |width| (1.0 - 0.5 * width).copysign(arm))
}

/// `exp(b x)` with its centre at `arm`: positive whatever the arm.
fn balanced(centres: &[f64], roots: &[f64], arm: f64) -> Vec<f64> {
    let density = |slope: f64| -> Vec<f64> {
        centres.iter().map(|x| (slope * (x - 1f64.copysign(slope))).exp()).collect()
    };
    let excess = |slope: f64| -> f64 {
        let weights = density(slope);
        let terms = weights.iter().zip(roots).zip(centres);
        terms.map(|((p, root), x)| p * root * root * (x - arm)).sum()
    };
    let (mut low, mut high) = (-1.0, 1.0);
    while excess(low) > 0.0 && low > -1e15 {
        low *= 4.0;
    }
    while excess(high) < 0.0 && high < 1e15 {
        high *= 4.0;
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 { low = middle } else { high = middle }
    }
    density(0.5 * (low + high))
}
