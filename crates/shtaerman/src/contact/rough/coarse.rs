//! Which parts of the base touch, on any ground and layer: complementarity on cells, a layer that bends made linear at about the mean pressure.

use super::base::Base;
use super::layer::reference_pressure;
use crate::contact::cells::{Cell, Cells, Loaded};
use crate::contact::steps::BESIDE;
use crate::{Error, Load};

/// The intervals of contact to about a cell, given about how many cells to begin with.
pub(super) fn intervals(base: &Base, count: usize) -> Result<Vec<[f64; 2]>, Error> {
    let valleys: Vec<f64> = base.valleys().collect();
    let vertical = base.load.vertical.mapped(|force| force / base.ground.area(), |given| given);
    let load = Load { vertical, ..base.load };
    // v = p/gain
    let reference = reference_pressure(base, base.pieces.iter().copied());
    let gain = reference / base.layer.displacement(reference);
    let mut cells =
        Cells::of_base(&base.pieces, &valleys, base.load, count, |_| base.breaks.clone());
    cells.settle(|cells| {
        let places: Vec<[f64; 2]> = cells.cells().iter().map(Cell::ends).collect();
        let (matrix, masses) = base.ground.cells(&places);
        let roots: Vec<f64> = masses.iter().map(|mass| mass.sqrt()).collect();
        let loaded = Loaded::new(cells, &roots, load, gain, |xi| base.height(xi));
        let (deadline, theta) = (base.problem().deadline(), gain * base.strength());
        Ok(loaded.solve(deadline, cells, matrix, theta)?.values)
    })?;
    Ok(cells.intervals())
}

/// The middle of the longest gap of a wave that is one with its images; none where all of it touches.
pub(super) fn gap(intervals: &[[f64; 2]]) -> Option<f64> {
    let [.., last] = intervals else { return None };
    let mut before = last[1] - 2.0;
    let gaps =
        intervals.iter().map(|[left, right]| [std::mem::replace(&mut before, *right), *left]);
    let longest = gaps.max_by(|one, two| (one[1] - one[0]).total_cmp(&(two[1] - two[0])))?;
    (longest[1] - longest[0] > BESIDE).then(|| 0.5 * (longest[0] + longest[1]))
}
