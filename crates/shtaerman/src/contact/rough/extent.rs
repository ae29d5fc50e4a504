//! How large the contact is, and the pressure that goes with it: what a layer that bends is made linear at.

use super::base::Base;
use crate::Vertical;

/// Length of the zones, and the area that carries the force.
pub(super) struct Extent {
    pub(super) length: f64,
    pub(super) area: f64,
}

impl Base<'_> {
    /// Length and area of intervals.
    pub(super) fn extent(&self, intervals: impl Iterator<Item = [f64; 2]>) -> Extent {
        let (mut length, mut rings) = (0.0, 0.0);
        for [left, right] in intervals {
            length += right - left;
            rings += (right - left) * (right + left);
        }
        let area = if self.ground.is_disk() { std::f64::consts::PI * rings } else { length };
        Extent { length, area }
    }

    /// The same of the whole base.
    pub(super) fn whole_extent(&self) -> Extent {
        self.extent(self.pieces.iter().copied())
    }
}

/// The pressure about which a layer that bends is made linear: the mean one, or what the settlement makes of a layer on the body.
pub(super) fn reference_pressure(base: &Base<'_>, extent: &Extent) -> f64 {
    match base.load.vertical {
        Vertical::Force(force) => force.abs() / extent.area,
        Vertical::Settlement(settlement) => {
            let deepest = (base.samples.iter())
                .map(|(xi, height)| settlement - base.tilt() * xi - height)
                .fold(0.0, f64::max);
            let compliance = base.theta * extent.length;
            let depth = |p: f64| base.layer.displacement(p) + compliance * p;
            let (mut low, mut high) =
                (f64::MIN_POSITIVE, deepest.powf(1.0 / base.layer.exponent()));
            for _ in 0..200 {
                let middle = (low * high).sqrt();
                if depth(middle) < deepest { low = middle } else { high = middle }
            }
            low
        }
    }
    .max(f64::MIN_POSITIVE)
}

impl Base<'_> {
    /// `k theta0 dp0/dv`, about: how strong the body is against the layer.
    pub(super) fn steepness(&self) -> f64 {
        let strength = self.ground.strength() * self.theta;
        if self.layer.is_linear() {
            return strength;
        }
        let pressure = reference_pressure(self, &self.whole_extent());
        strength * self.layer.slope(self.layer.displacement(pressure))
    }
}
