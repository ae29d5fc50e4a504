//! The zones to begin with, on cells.

use super::base::Base;
use super::{coarse, topology};
use crate::Error;
use crate::contact::search::Equation;
use crate::contact::zones::Zone;

impl Base<'_> {
    /// The intervals of contact to about a cell, on about so many.
    pub(super) fn first_intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error> {
        if self.is_plain() { topology::find(self, cells) } else { coarse::find(self, cells) }
    }

    /// The same as zones.
    pub(super) fn first_zones(&self, cells: usize) -> Result<Vec<Zone>, Error> {
        Ok(self.first_intervals(cells)?.into_iter().map(|ends| self.zone(ends)).collect())
    }
}
