//! Which ground a problem stands on.

use std::sync::Arc;

use super::{Ground, disk, graded, layered, layered_disk, line, row};
use crate::{Error, Geometry, Problem};

/// The ground of a problem.
pub(in crate::contact) fn ground(problem: &Problem) -> Result<Arc<dyn Ground>, Error> {
    let bodies = problem.bodies();
    let exponent = bodies.grading().map_or(0.0, |grading| grading.exponent());
    if let Some(layering) = bodies.layering() {
        let layering = layering.clone().scaled(bodies.half_width());
        return Ok(match bodies.geometry() {
            Geometry::Circular => Arc::new(layered_disk::LayeredDisk::new(layering)?),
            _ => Arc::new(layered::Layered::new(&layering)?),
        });
    }
    Ok(match bodies.geometry().scaled(bodies.half_width()) {
        Geometry::Plane | Geometry::Pair { .. } if exponent > 0.0 => {
            Arc::new(graded::Graded::new(exponent)?)
        }
        Geometry::Plane | Geometry::Pair { .. } => Arc::new(line::Line::new()),
        Geometry::Periodic { period } => Arc::new(row::Row::new(period)?),
        Geometry::Circular => Arc::new(disk::Disk::new(exponent)?),
    })
}
