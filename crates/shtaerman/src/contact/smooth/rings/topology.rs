//! Which parts of the base touch: a complementarity problem on rings of cells, with a layer too thin to matter, refined where zones are short.

use std::f64::consts::{LN_2, PI};

use fredholm::special::arithmetic_geometric_mean as mean;

use super::base::Base;
use crate::contact::cells::{Cell, Cells, LIMITS, solve_thin};
use crate::contact::valleys;
use crate::{Error, Load, Rotational, Vertical};

/// The intervals of contact to about a cell, each of which has several; `count` is the number of cells to begin with.
pub(super) fn find(base: &Base<'_>, count: usize) -> Result<Vec<[f64; 2]>, Error> {
    let mut cells = cells(base, count);
    cells.settle(|cells| solve(base, cells))?;
    Ok(cells.intervals())
}

/// Whether so many cells touch as one disk.
pub(super) fn is_disk(base: &Base<'_>, count: usize) -> Result<bool, Error> {
    let mut cells = cells(base, count);
    cells.mark(&solve(base, &cells)?);
    Ok(matches!(cells.runs()[..], [[0, _]]))
}

/// Rings of the base, with the disk at the axis.
fn cells(base: &Base<'_>, count: usize) -> Cells {
    let valleys: Vec<f64> = valleys::valleys(&base.samples).collect();
    let mut cuts = valleys::cuts(&valleys, [0.0, 1.0], count);
    cuts.extend(&base.problem.breaks);
    Cells::new([([0.0, 1.0], cuts)], LIMITS)
}

/// `int r dr`.
fn measure(cell: &Cell) -> f64 {
    cell.centre() * cell.width()
}

/// `pi W_0` between the cells, times the roots of their measures: at their middles, but with the mean of its logarithm.
fn matrix(cells: &Cells) -> Result<Vec<f64>, Error> {
    let mut matrix = cells.logarithms()?;
    let stride = cells.cells().len();
    for (i, one) in cells.cells().iter().enumerate() {
        for (j, other) in cells.cells().iter().enumerate() {
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
            *entry = means / root * (measure(one) * measure(other)).sqrt();
        }
    }
    Ok(matrix)
}

fn solve(base: &Base<'_>, cells: &Cells) -> Result<Vec<f64>, Error> {
    let roots: Vec<f64> = cells.cells().iter().map(|cell| measure(cell).sqrt()).collect();
    let vertical = match base.problem.load.vertical {
        Vertical::Force(force) => Vertical::Force(force / (2.0 * PI)),
        Vertical::Settlement(settlement) => Vertical::Settlement(settlement),
    };
    let load = Load { vertical, rotational: Rotational::Tilt(0.0) };
    let equations = (roots, matrix(cells)?);
    let deadline = &base.problem.deadline;
    solve_thin(deadline, cells, equations, load, base.problem.theta0, |r| base.height(r))
}
