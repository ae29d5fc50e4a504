//! The load on cells.

use fredholm::complementarity::{Complementarity, Condition, centred};

use super::super::accuracy::STAGNANT;
use super::{Cell, Cells};
use crate::deadline::{Deadline, work};
use crate::lower_hull::lower_hull;
use crate::{Error, Load, Rotational, Vertical};

/// The equations on cells for `z = sqrt(m) p`, `m` the masses of the cells, but for their matrix: what a load and a profile amount to.
#[derive(Debug, Clone)]
pub(in crate::contact) struct Loaded {
    conditions: Vec<Condition>,
    right: Vec<f64>,
    /// A pressure that is not negative and meets the conditions, times the roots.
    feasible: Vec<f64>,
}

impl Loaded {
    /// Equations times `gain` for the mean heights over the cells; a force is that of `sum m p`.
    pub(in crate::contact) fn new(
        cells: &Cells,
        roots: &[f64],
        load: Load,
        gain: f64,
        means: &[f64],
    ) -> Self {
        let centres: Vec<f64> = cells.cells().iter().map(Cell::centre).collect();
        let weighted = |f: &dyn Fn(f64) -> f64| -> Vec<f64> {
            roots.iter().zip(&centres).map(|(root, x)| root * f(*x)).collect()
        };
        let (ones, lever) = (weighted(&|_| 1.0), weighted(&|x| x));
        let mut right: Vec<f64> =
            roots.iter().zip(means).map(|(root, mean)| -gain * root * mean).collect();
        let mut add = |column: &[f64], by: f64| {
            right.iter_mut().zip(column).for_each(|(value, c)| *value += gain * by * c);
        };
        let mut conditions = Vec::new();
        match load.vertical {
            Vertical::Force(value) => {
                conditions.push(Condition { row: ones.clone(), column: ones, value });
            }
            Vertical::Settlement(settlement) => add(&ones, settlement),
        }
        match (load.rotational, load.vertical.force()) {
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
        let feasible = feasible(load, roots, &centres);
        Self { conditions, right, feasible }
    }

    /// Begins with the cells that carry.
    pub(in crate::contact) fn solve(
        &self,
        (cells, deadline): (&Cells, &Deadline),
        matrix: &Complementarity,
    ) -> Result<Vec<f64>, Error> {
        let is_over = |order: usize| {
            deadline.spend(work::CELLS * (order as f64).powi(3));
            deadline.is_past()
        };
        let Self { right, conditions, feasible } = self;
        Ok(matrix.solve_until(&is_over, right, conditions, &cells.carrying(), feasible)?.values)
    }
}

/// Solves without a layer, `theta K p = delta0 - alpha0 xi - f0`, for `z`: with one too thin to matter.
pub(in crate::contact) fn solve_thin(
    (cells, deadline): (&Cells, &Deadline),
    (roots, matrix): (Vec<f64>, Vec<f64>),
    load: Load,
    theta: f64,
    heights: impl Fn(&[f64]) -> Vec<f64>,
) -> Result<Vec<f64>, Error> {
    let [level, slope] = resting(cells, load, &cells.means(&heights));
    let above = |places: &[f64]| -> Vec<f64> {
        places.iter().zip(heights(places)).map(|(x, height)| height - (level + slope * x)).collect()
    };
    // Of a layer too thin to matter: its share is rounding.
    let thin = 1.0 / STAGNANT;
    let loaded = Loaded::new(cells, &roots, load, thin / theta, &cells.means(above));
    loaded.solve((cells, deadline), &Complementarity::new(matrix, thin)?)
}

/// The line on which the base would rest on rigid ground under the force, `level + slope x`: heights counted from it keep their digits where the base is nearly flat against what is
/// beside, and the pressure is the same. None but zero where it is not free to move there.
fn resting(cells: &Cells, load: Load, means: &[f64]) -> [f64; 2] {
    let (Vertical::Force(_), Some(arm)) = (load.vertical, load.arm()) else { return [0.0; 2] };
    let corner = |(cell, mean): (&Cell, &f64)| [cell.centre(), *mean];
    let hull = lower_hull(cells.cells().iter().zip(means).map(corner));
    let beside = hull.partition_point(|[x, _]| *x < arm).clamp(1, hull.len().max(2) - 1);
    match hull.get(beside - 1..=beside) {
        Some([left, right]) => {
            let slope = (right[1] - left[1]) / (right[0] - left[0]);
            [left[1] - slope * left[0], slope]
        }
        _ => [0.0; 2],
    }
}

/// Boundaries that close in on an edge of the base from cells of this width, until a cell fits between it and the line of the force.
pub(super) fn closing_in(load: Load, width: f64, shortest: f64) -> impl Iterator<Item = f64> {
    let arm = load.arm().unwrap_or(0.0);
    let room = 0.25 * (1.0 - arm.abs());
    std::iter::successors(Some(0.5 * width), |width| Some(0.5 * width))
        .take_while(move |width| *width > room.max(shortest))
        .map(move |width| (1.0 - 0.5 * width).copysign(arm))
}

/// A pressure that is not negative and meets the conditions, times the roots.
fn feasible(load: Load, roots: &[f64], centres: &[f64]) -> Vec<f64> {
    let mut values = vec![0.0; roots.len()];
    match (load.vertical, load.rotational) {
        (Vertical::Settlement(_), Rotational::Moment(moment)) if moment != 0.0 => {
            let cell = if moment > 0.0 { roots.len() - 1 } else { 0 };
            values[cell] = moment / (centres[cell] * roots[cell]);
        }
        (Vertical::Settlement(_), Rotational::Tilt(_)) => {}
        (vertical, _) => {
            // A force in its line, without one an even pressure; at a settlement any force will do that acts in the line.
            let masses: Vec<f64> = roots.iter().map(|root| root * root).collect();
            let moment =
                |values: &[f64]| values.iter().zip(&masses).map(|(v, m)| v * m).sum::<f64>();
            let mass: f64 = masses.iter().sum();
            let (force, middle) = match vertical {
                Vertical::Force(force) => (force, moment(centres) / mass),
                Vertical::Settlement(settlement) => (settlement.abs() * mass, 0.0),
            };
            let density = centred(centres, &masses, load.arm().unwrap_or(middle));
            let carried = moment(&density);
            for (value, (p, root)) in values.iter_mut().zip(density.iter().zip(roots)) {
                *value = force * p / carried * root;
            }
        }
    }
    values
}
