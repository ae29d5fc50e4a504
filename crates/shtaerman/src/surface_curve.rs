//! The deformed surface under and beside the base as data.

use serde::Serialize;

use crate::{Contact, Error, Geometry, Scaling};

/// How far the surface is shown, in half-widths.
const REACH: f64 = 3.0;

/// The surface at points from `-3a` to `3a`; of a periodic row within one period.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum SurfaceCurve {
    /// SI units.
    Physical {
        /// Places (m).
        x: Vec<f64>,
        /// Pressures (Pa), zero beside the base.
        p: Vec<f64>,
        /// Elastic displacements of the surface (m), without the layer; positive into the body, in the gauge of the settlement.
        displacement: Vec<f64>,
        /// Gaps between base and body (m), zero in the zones of contact; none beside the base.
        gap: Vec<Option<f64>>,
    },
    /// No dimensions.
    Dimensionless {
        /// Places.
        xi: Vec<f64>,
        /// Pressures over `E`.
        p0: Vec<f64>,
        /// Elastic displacements of the surface.
        displacement0: Vec<f64>,
        /// Gaps.
        gap0: Vec<Option<f64>>,
    },
}

impl SurfaceCurve {
    /// The surface at `count` points, equally spaced.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for fewer than two points.
    pub fn new(contact: &Contact, count: usize) -> Result<Self, Error> {
        crate::error::require(count >= 2, "surface", count as f64, "at least 2 points")?;
        let last = (count - 1) as f64;
        let frame = contact.problem().frame();
        let reach = match frame.geometry().scaled(frame.half_width()) {
            Geometry::Periodic { period } => REACH.min(0.5 * period),
            _ => REACH,
        };
        // From the middle, so that the curve of a mirror image is the mirror image of the curve; the punch's edges are exact.
        let places: Vec<f64> = (0..count)
            .map(|i| reach * (2.0 * i as f64 - last) / last)
            .map(|xi| if (xi.abs() - 1.0).abs() < 1e-12 { xi.signum() } else { xi })
            .collect();
        let scale = |unit: fn(&Scaling) -> f64| frame.scaling().map_or(1.0, unit);
        let (length, pressure) = (frame.half_width(), scale(Scaling::pressure));
        let depth = scale(Scaling::displacement);
        let pieces = frame.pieces();
        let under = |xi: f64| pieces.iter().any(|[left, right]| *left <= xi && xi <= *right);
        let x = places.iter().map(|xi| xi * length).collect();
        let p = (places.iter())
            .map(|&xi| if under(xi) { contact.pressure0(xi) * pressure } else { 0.0 })
            .collect();
        let displacement =
            places.iter().map(|&xi| contact.elastic_displacement0(xi) * depth).collect();
        let gap = places.iter().map(|&xi| under(xi).then(|| contact.gap0(xi) * depth)).collect();
        Ok(match frame.scaling() {
            Some(_) => Self::Physical { x, p, displacement, gap },
            None => Self::Dimensionless { xi: x, p0: p, displacement0: displacement, gap0: gap },
        })
    }
}
