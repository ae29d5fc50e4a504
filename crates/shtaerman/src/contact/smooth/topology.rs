//! Which parts of the base touch: a complementarity problem on cells, with a layer too thin to matter, refined where zones are short.

use super::base::Base;
use crate::contact::cells::{Cells, solve_thin};
use crate::{Error, Load, Vertical};

/// The intervals of contact to about a cell, each of which has several; `count` is the number of cells to begin with.
pub(super) fn find(base: &Base, count: usize) -> Result<Vec<[f64; 2]>, Error> {
    let ground = &base.ground;
    let vertical = base.load.vertical.mapped(|force| force / ground.area(), |given| given);
    let load = Load { vertical, ..base.load };
    let is_forced = matches!(vertical, Vertical::Force(_));
    let theta = ground.strength() * base.setting.theta0();
    let valleys: Vec<f64> = base.valleys().collect();
    let cells = Cells::of_base(&base.pieces, &valleys, base.load, count, |width| {
        // Cells show what lies between measured points, but not what is narrower than they are.
        let narrow = base.joints.windows(2).filter(|pair| pair[1] - pair[0] < width);
        let is_few = narrow.clone().count() < count / 2;
        let narrow = narrow.flatten().filter(|_| is_few);
        base.breaks.iter().chain(narrow).copied().collect()
    });
    cells.settled((ground.as_ref(), base.deadline()), |cells, roots, mut matrix| {
        let mut strength = theta;
        if is_forced && ground.exponent() > 0.0 && !ground.is_disk() {
            strength *= ground.exponent();
            without_constant(&mut matrix, &roots, ground.exponent());
        }
        let heights = |places: &[f64]| base.heights(places);
        solve_thin((cells, base.deadline()), (roots, matrix), load, strength, heights)
    })
}

/// `(d^-mu - 4^-mu)/mu` in the place of `d^-mu`: where the force is prescribed a constant adds to the settlement alone, and of a small `mu` it would leave few digits for the rest.
fn without_constant(matrix: &mut [f64], roots: &[f64], exponent: f64) {
    let level = 4f64.powf(-exponent);
    for (row, root) in matrix.chunks_exact_mut(roots.len().max(1)).zip(roots) {
        for (entry, other) in row.iter_mut().zip(roots) {
            *entry = (*entry - level * root * other) / exponent;
        }
    }
}
