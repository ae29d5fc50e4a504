//! Which parts of the base touch.

use super::base::Base;
use super::cells::Cells;
use super::eccentric;
use super::zones::Zone;
use crate::Error;

/// Most rounds of refinement.
const ROUNDS: usize = 40;

/// The zones of contact to about a cell, each of which has several; `cells` is the number of cells to begin with.
pub(super) fn find(base: &Base<'_>, cells: usize) -> Result<Vec<Zone>, Error> {
    let mut cells = Cells::new(base, cells);
    if let Some((settlement, e)) = base.settlement_at_eccentricity() {
        return eccentric::zones(base, cells, settlement, e);
    }
    for _ in 0..ROUNDS {
        cells.solve(base, base.load)?;
        if !cells.refine() {
            break;
        }
    }
    Ok(cells.zones())
}
