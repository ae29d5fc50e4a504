//! Which ground a problem stands on.

use std::sync::Arc;

use super::{Ground, disk, graded, layered, layered_disk, line, row};
use crate::{Error, Geometry, Problem};

/// The ground of a problem.
pub(in crate::contact) fn ground(problem: &Problem) -> Result<Arc<dyn Ground>, Error> {
    let frame = problem.frame();
    let exponent = frame.grading().map_or(0.0, |grading| grading.exponent());
    if let Some(layering) = frame.layering() {
        let layering = layering.clone().scaled(frame.half_width());
        return Ok(match frame.geometry() {
            Geometry::Circular => Arc::new(layered_disk::LayeredDisk::new(layering)?),
            _ => Arc::new(layered::Layered::new(&layering)?),
        });
    }
    Ok(match frame.geometry().scaled(frame.half_width()) {
        Geometry::Plane | Geometry::Pair { .. } if exponent > 0.0 => {
            Arc::new(graded::Graded::new(exponent)?)
        }
        Geometry::Plane | Geometry::Pair { .. } => Arc::new(line::Line::new()),
        Geometry::Periodic { period } => Arc::new(row::Row::new(period)?),
        Geometry::Circular => Arc::new(disk::Disk::new(exponent)?),
    })
}
