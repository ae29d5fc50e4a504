//! The deformed surface under and beside the base as data.

use serde::Serialize;

use crate::{Contact, Error, Geometry, Scaling};

/// How far the surface is shown, in half-widths.
const REACH: f64 = 3.0;

/// The surface at points from `-3a` to `3a`, of a periodic row within one period; in SI units, or in numbers for a dimensionless problem.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SurfaceCurve {
    /// Places (m).
    pub x: Vec<f64>,
    /// Pressures (Pa), zero beside the base.
    pub pressure: Vec<f64>,
    /// Elastic displacements of the surface (m), without the layer; positive into the body, in the gauge of the settlement.
    pub displacement: Vec<f64>,
    /// Gaps between base and body (m), zero in the zones of contact; none beside the base.
    pub gap: Vec<Option<f64>>,
}

impl SurfaceCurve {
    /// The surface at `count` points, equally spaced.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for fewer than two points.
    pub fn new(contact: &Contact, count: usize) -> Result<Self, Error> {
        crate::error::require(count >= 2, "surface", count as f64, "at least 2 points")?;
        let last = (count - 1) as f64;
        let bodies = contact.problem().bodies();
        let reach = match bodies.geometry().scaled(bodies.half_width()) {
            Geometry::Periodic { period } => REACH.min(0.5 * period),
            _ => REACH,
        };
        // From the middle, so that the curve of a mirror image is the mirror image of the curve; the punch's edges are exact.
        let places: Vec<f64> = (0..count)
            .map(|i| reach * (2.0 * i as f64 - last) / last)
            .map(|xi| if (xi.abs() - 1.0).abs() < 1e-12 { xi.signum() } else { xi })
            .collect();
        let [length, pressure, depth] =
            [Scaling::half_width, Scaling::pressure, Scaling::displacement]
                .map(|unit: fn(&Scaling) -> f64| contact.scale(unit));
        let pieces = contact.problem().punch().pieces();
        let under = |xi: f64| pieces.iter().any(|[left, right]| *left <= xi && xi <= *right);
        let bare = contact.dimensionless();
        let p = |xi: f64| if under(xi) { contact.pressure_at(xi) * pressure } else { 0.0 };
        Ok(Self {
            x: places.iter().map(|xi| xi * length).collect(),
            pressure: places.iter().map(|&xi| p(xi)).collect(),
            displacement: places.iter().map(|&xi| bare.elastic_displacement(xi) * depth).collect(),
            gap: places.iter().map(|&xi| under(xi).then(|| contact.gap_at(xi) * depth)).collect(),
        })
    }
}
