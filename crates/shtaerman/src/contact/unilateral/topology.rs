//! Which parts of the base touch, for one punch with a linear layer.

use fredholm::complementarity::ComplementaritySolution;

use super::base::Base;
use crate::contact::cells::{Cells, Limits, Loaded, closing_in};
use crate::contact::valleys;
use crate::{Error, Load};

/// How far cells are refined.
const LIMITS: Limits = Limits { shortest: 1e-13, most: 1400, rounds: 40 };

/// The intervals of contact to about a cell, each of which has several; `count` is the number of cells to begin with.
pub(super) fn find(base: &Base<'_>, count: usize) -> Result<Vec<[f64; 2]>, Error> {
    let mut cells = cells(base, count);
    cells.settle(|cells| Ok(solve(base, cells, base.load)?.values))?;
    Ok(cells.intervals())
}

/// About so many cells of the base.
pub(super) fn cells(base: &Base<'_>, count: usize) -> Cells {
    let valleys: Vec<f64> = valleys::valleys(&base.samples).collect();
    let mut cuts = valleys::cuts(&valleys, [-1.0, 1.0], count);
    cuts.extend(&base.breaks);
    cuts.extend(closing_in(base.load, 2.0 / count as f64, LIMITS.shortest));
    Cells::new([([-1.0, 1.0], cuts)], LIMITS)
}

/// Pressures times the roots of the widths; of the multipliers the settlement comes first if the force is prescribed.
pub(super) fn solve(
    base: &Base<'_>,
    cells: &Cells,
    load: Load,
) -> Result<ComplementaritySolution, Error> {
    let loaded = Loaded::new(cells, cells.roots(), load, 1.0, |xi| base.height(xi));
    loaded.solve(cells, cells.logarithms()?, base.theta)
}
