//! Which parts of the base touch, on any ground and layer: complementarity on cells, a layer that bends made linear at about the mean pressure.

use fredholm::complementarity::Complementarity;

use super::base::Base;
use super::layer::reference_pressure;
use crate::contact::cells::{Cells, Loaded};
use crate::{Error, Load};

/// The intervals of contact to about a cell, given about how many cells to begin with.
pub(super) fn intervals(base: &Base, count: usize) -> Result<Vec<[f64; 2]>, Error> {
    let valleys: Vec<f64> = base.valleys().collect();
    let vertical = base.load.vertical.mapped(|force| force / base.ground.area(), |given| given);
    let load = Load { vertical, ..base.load };
    // v = p/gain
    let reference = reference_pressure(base, base.pieces.iter().copied());
    let gain = reference / base.layer.displacement(reference);
    let cells = Cells::of_base(&base.pieces, &valleys, base.load, count, |_| base.breaks.clone());
    let deadline = base.problem().deadline();
    cells.settled((base.ground.as_ref(), deadline), |cells, roots, matrix| {
        let means = cells.means(|places| base.surface.heights(places));
        let loaded = Loaded::new(cells, &roots, load, gain, &means);
        loaded.solve((cells, deadline), &Complementarity::new(matrix, gain * base.strength())?)
    })
}
