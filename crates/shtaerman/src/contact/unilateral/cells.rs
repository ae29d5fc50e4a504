//! The complementarity problem on cells that are refined where zones are short.

use fredholm::complementarity::{
    Complementarity, ComplementaritySolution, Condition, logarithm_cells,
};

use super::base::Base;
use super::zones::Zone;
use crate::{Error, Load, Rotational, Vertical};

/// Fewest cells of a zone.
const CELLS_A_ZONE: usize = 6;
/// Parts of a cell that is refined.
const PARTS: usize = 4;
/// Most cells.
const MOST_CELLS: usize = 1400;
/// Cells shorter than this are not refined.
const SHORTEST: f64 = 1e-13;

/// Cells of the base, and which of them carry.
pub(super) struct Cells {
    boundaries: Vec<f64>,
    carrying: Vec<bool>,
}

impl Cells {
    pub(super) fn new(base: &Base<'_>, count: usize) -> Self {
        let mut boundaries: Vec<f64> =
            (0..=count).map(|i| 2.0 * i as f64 / count as f64 - 1.0).collect();
        boundaries.extend(&base.breaks);
        boundaries.extend(graded(base, 2.0 / count as f64));
        boundaries.sort_by(f64::total_cmp);
        boundaries.dedup_by(|right, left| *right - *left < SHORTEST);
        // The last edge of the punch is exact whatever was dropped.
        if let Some(last) = boundaries.last_mut() {
            *last = 1.0;
        }
        let carrying = vec![true; boundaries.len() - 1];
        Self { boundaries, carrying }
    }

    fn count(&self) -> usize {
        self.carrying.len()
    }

    fn width(&self, i: usize) -> f64 {
        self.boundaries[i + 1] - self.boundaries[i]
    }

    fn centre(&self, i: usize) -> f64 {
        0.5 * (self.boundaries[i] + self.boundaries[i + 1])
    }

    /// Pressures times the roots of the widths; of the multipliers the settlement comes first if the force is prescribed.
    pub(super) fn solve(
        &mut self,
        base: &Base<'_>,
        load: Load,
    ) -> Result<ComplementaritySolution, Error> {
        let roots: Vec<f64> = (0..self.count()).map(|i| self.width(i).sqrt()).collect();
        let centres: Vec<f64> = (0..self.count()).map(|i| self.centre(i)).collect();
        let weighted = |f: &dyn Fn(f64) -> f64| -> Vec<f64> {
            roots.iter().zip(&centres).map(|(root, x)| root * f(*x)).collect()
        };
        let ones = weighted(&|_| 1.0);
        let lever = weighted(&|x| x);
        let negative = weighted(&|x| -x);
        let mut right: Vec<f64> = (0..self.count())
            .map(|i| -roots[i] * base.mean_height(centres[i], 0.5 * self.width(i)))
            .collect();
        let mut add = |column: &[f64], by: f64| {
            right.iter_mut().zip(column).for_each(|(value, c)| *value += by * c);
        };
        let mut conditions = Vec::new();
        match load.vertical {
            Vertical::Force(value) => {
                conditions.push(Condition { row: ones.clone(), column: ones.clone(), value });
            }
            Vertical::Settlement(settlement) => add(&ones, settlement),
        }
        let force = match load.vertical {
            Vertical::Force(force) => Some(force),
            Vertical::Settlement(_) => None,
        };
        match (load.rotational, force) {
            (Rotational::Moment(value), _) => {
                conditions.push(Condition { row: lever.clone(), column: lever, value });
            }
            (Rotational::Eccentricity(e), Some(force)) => {
                conditions.push(Condition { row: lever.clone(), column: lever, value: e * force });
            }
            // Without a force, as `topology` has seen to, only that on the middle is left.
            (Rotational::Eccentricity(_), None) => {
                conditions.push(Condition { row: lever.clone(), column: lever, value: 0.0 });
            }
            (Rotational::Tilt(tilt), _) => add(&negative, tilt),
        }
        let feasible = self.feasible(load, &roots, &centres);
        let matrix = Complementarity::new(logarithm_cells(&self.boundaries)?, base.theta)?;
        let solution = matrix.solve(&right, &conditions, &self.carrying, &feasible)?;
        self.carrying = solution.values.iter().map(|z| *z > 0.0).collect();
        Ok(solution)
    }

    /// A pressure that is not negative and meets the conditions, times the roots of the widths.
    fn feasible(&self, load: Load, roots: &[f64], centres: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.count()];
        let last = self.count() - 1;
        match (load.vertical, load.rotational) {
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
                let density = balanced(centres, roots, arm);
                let carried: f64 = density.iter().zip(roots).map(|(p, root)| p * root * root).sum();
                for i in 0..=last {
                    values[i] = force * density[i] / carried * roots[i];
                }
            }
        }
        values
    }

    /// Splits the cells of zones that have few, and their neighbours; whether there were any.
    pub(super) fn refine(&mut self) -> bool {
        let mut split = vec![false; self.count()];
        for [first, end] in self.runs() {
            if end - first < CELLS_A_ZONE {
                let from = first.saturating_sub(1);
                let to = (end + 1).min(self.count());
                (from..to)
                    .filter(|&i| self.width(i) > PARTS as f64 * SHORTEST)
                    .for_each(|i| split[i] = true);
            }
        }
        let splits = split.iter().filter(|split| **split).count();
        if splits == 0 || self.count() + (PARTS - 1) * splits > MOST_CELLS {
            return false;
        }
        let (mut boundaries, mut carrying) = (vec![self.boundaries[0]], Vec::new());
        for (i, is_split) in split.into_iter().enumerate() {
            let parts = if is_split { PARTS } else { 1 };
            for part in 1..parts {
                boundaries.push(self.boundaries[i] + self.width(i) * part as f64 / parts as f64);
            }
            boundaries.push(self.boundaries[i + 1]);
            carrying.extend(vec![self.carrying[i]; parts]);
        }
        (self.boundaries, self.carrying) = (boundaries, carrying);
        true
    }

    /// The zones to about a cell.
    pub(super) fn zones(&self) -> Vec<Zone> {
        let boundaries = &self.boundaries;
        self.runs().into_iter().map(|[i, j]| Zone::new(boundaries[i], boundaries[j])).collect()
    }

    /// Runs of carrying cells, as ranges of indices.
    fn runs(&self) -> Vec<[usize; 2]> {
        let mut runs: Vec<[usize; 2]> = Vec::new();
        for i in (0..self.count()).filter(|&i| self.carrying[i]) {
            match runs.last_mut() {
                Some(run) if run[1] == i => run[1] = i + 1,
                _ => runs.push([i, i + 1]),
            }
        }
        runs
    }
}

/// Boundaries that close in on an edge of the punch until a cell fits between it and the line of the force.
fn graded(base: &Base<'_>, width: f64) -> Vec<f64> {
    let arm = match (base.load.vertical, base.load.rotational) {
        (Vertical::Force(force), Rotational::Moment(moment)) => moment / force,
        (_, Rotational::Eccentricity(e)) => e,
        _ => 0.0,
    };
    let room = 0.25 * (1.0 - arm.abs());
    let halvings = std::iter::successors(Some(0.5 * width), |width| Some(0.5 * width));
    halvings
        .take_while(|width| *width > room.max(SHORTEST))
        .map(|width| (1.0 - 0.5 * width).copysign(arm))
        .collect()
}

/// `exp(b x)` with its centre at `arm`: positive whatever the arm.
pub(super) fn balanced(centres: &[f64], roots: &[f64], arm: f64) -> Vec<f64> {
    let density = |slope: f64| -> Vec<f64> {
        centres.iter().map(|x| (slope * (x - 1f64.copysign(slope))).exp()).collect()
    };
    let excess = |slope: f64| -> f64 {
        let weights = density(slope);
        weights
            .iter()
            .zip(roots)
            .zip(centres)
            .map(|((p, root), x)| p * root * root * (x - arm))
            .sum()
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
