//! Which parts of the base touch: a complementarity problem on cells, with a layer too thin to matter, refined where zones are short.

use super::problem::Base;
use crate::contact::cells::{Cell, Cells, LIMITS, closing_in, solve_thin};
use crate::contact::valleys::{self, CELLS_A_ZONE};
use crate::{Error, Vertical};
use fredholm::complementarity::mean_power;

/// The intervals of contact to about a cell, each of which has several; `count` is the number of cells to begin with.
pub(super) fn find(base: &Base<'_>, count: usize) -> Result<Vec<[f64; 2]>, Error> {
    let load = base.problem.load;
    let factor = match (base.grading, load.vertical) {
        (Some(exponent), Vertical::Force(_)) => exponent,
        _ => 1.0,
    };
    let mut cells = cells(base, count);
    cells.settle(|cells| {
        let equations = (cells.roots(), matrix(base, cells)?);
        let theta = factor * base.problem.theta0;
        solve_thin(&base.problem.deadline, cells, equations, load, theta, |xi| base.height(xi))
    })?;
    Ok(cells.intervals())
}

/// About so many cells of the base.
fn cells(base: &Base<'_>, count: usize) -> Cells {
    let total: f64 = base.problem.pieces.iter().map(|[left, right]| right - left).sum();
    let pieces = base.problem.pieces.iter().zip(&base.samples).map(|(&[left, right], samples)| {
        let count = (count as f64 * (right - left) / total).ceil().max(CELLS_A_ZONE as f64);
        let width = (right - left) / count;
        let valleys: Vec<f64> = valleys::valleys(samples).collect();
        let mut cuts = valleys::cuts(&valleys, [left, right], count as usize);
        cuts.extend(&base.problem.profile.breaks);
        // Cells show what lies between measured points, but not what is narrower than they are.
        let joints = base.problem.profile.joints.windows(2);
        let narrow = joints.filter(|pair| pair[1] - pair[0] < width);
        if narrow.clone().count() < count as usize / 2 {
            cuts.extend(narrow.flatten());
        }
        cuts.extend(closing_in(base.problem.load, width, LIMITS.shortest));
        ([left, right], cuts)
    });
    Cells::new(pieces, LIMITS)
}

/// The kernel on the cells: its logarithm, and what a row adds; or the power of graded ground.
fn matrix(base: &Base<'_>, cells: &Cells) -> Result<Vec<f64>, Error> {
    if let Some(exponent) = base.grading {
        let is_forced = matches!(base.problem.load.vertical, Vertical::Force(_));
        return Ok(power_cells(cells.cells(), exponent, is_forced));
    }
    let mut matrix = cells.logarithms()?;
    let kernel = base.problem.kernel;
    if let (Some(period), Some(remainder)) = (kernel.period(), kernel.remainder()) {
        let cells = cells.cells();
        let pairs = cells.iter().flat_map(|one| cells.iter().map(move |other| (one, other)));
        for (entry, (one, other)) in matrix.iter_mut().zip(pairs) {
            let d = one.centre() - other.centre();
            let least = 0.25 * (one.width() + other.width());
            let image = |shift: f64| -(d + shift).abs().max(least).ln();
            let added = image(period) + image(-period) + remainder.at(d);
            *entry += added * (one.width() * other.width()).sqrt();
        }
    }
    Ok(matrix)
}

/// The means of `d^-mu`, `d = |x - s|`, over cells, times the roots of their widths. Where the force is prescribed those of `(d^-mu - 4^-mu)/mu`: a constant adds to the settlement alone,
/// and of a small `mu` it would leave few digits for the rest.
fn power_cells(cells: &[Cell], exponent: f64, is_forced: bool) -> Vec<f64> {
    let (level, scale) = if is_forced { (4f64.powf(-exponent), exponent) } else { (0.0, 1.0) };
    let entry = |i: usize, j: usize| {
        let mean = mean_power(cells[i.min(j)].ends(), cells[i.max(j)].ends(), exponent);
        (mean - level) / scale * cells[i].width().sqrt() * cells[j].width().sqrt()
    };
    let count = cells.len();
    (0..count * count).map(|place| entry(place / count, place % count)).collect()
}
