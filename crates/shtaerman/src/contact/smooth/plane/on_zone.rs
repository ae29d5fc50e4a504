//! The profile on a zone as function of the angle.

use std::f64::consts::{FRAC_PI_2, PI};

use fredholm::inversion::Angular;

use super::super::base::Base;
use crate::contact::zones::Zone;
use crate::rounding::OF_A_VALUE;

/// About a mean slope, which is taken away as it is large where the punch rolls onto a flank.
pub(super) struct OnZone<'b> {
    base: &'b Base,
    zone: Zone,
    mean: f64,
}

impl<'b> OnZone<'b> {
    pub(super) fn new(base: &'b Base, zone: Zone) -> Self {
        let mut on_zone = Self { base, zone, mean: 0.0 };
        let mean = if base.has_slope() {
            // By Gauss's two places: in the middle may be a kink or a cusp.
            let angle = 3f64.sqrt().recip().acos();
            let at = |angle: f64| base.slope(on_zone.position(angle));
            0.5 * (at(angle) + at(PI - angle))
        } else {
            let at = |angle: f64| base.height(on_zone.position(angle));
            (at(0.0) - at(PI)) / zone.length()
        };
        on_zone.mean = if mean.is_finite() { mean } else { 0.0 };
        on_zone
    }

    pub(super) fn mean(&self) -> f64 {
        self.mean
    }

    fn position(&self, angle: f64) -> f64 {
        let (sine, cosine) = (0.5 * angle).sin_cos();
        let xi = if angle < FRAC_PI_2 {
            self.zone.right() - self.zone.length() * sine * sine
        } else {
            self.zone.left() + self.zone.length() * cosine * cosine
        };
        self.zone.inside(xi)
    }

    /// `df/dt` given that of the place.
    fn turned(&self, slope: f64, angle: f64) -> f64 {
        (self.mean - slope) * 0.5 * self.zone.length() * angle.sin()
    }

    /// What is taken away from the height.
    fn level(&self, angle: f64) -> f64 {
        self.mean * 0.5 * self.zone.length() * angle.cos()
    }

    fn farthest(&self) -> f64 {
        self.zone.ends.iter().fold(0.0, |most, end| self.base.distance(*end).max(most))
    }
}

impl Angular for OnZone<'_> {
    fn height(&self, angle: f64) -> f64 {
        self.base.height(self.position(angle)) - self.level(angle)
    }

    fn rounding(&self, height: f64, slope: f64) -> f64 {
        let steepest = self.mean.abs() + 2.0 * slope / self.zone.length();
        OF_A_VALUE * (height + steepest * self.farthest())
    }

    fn taken_slope(&self) -> f64 {
        self.mean.abs() * 0.5 * self.zone.length()
    }

    fn blur(&self, angle: f64) -> f64 {
        f64::EPSILON * (1.0 + self.farthest() / (self.zone.length() * angle.sin().abs()))
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        let slope = self.base.has_slope().then(|| self.base.slope(self.position(angle)))?;
        Some(self.turned(slope, angle))
    }

    fn tangents(&self, angles: &[f64]) -> Vec<(f64, Option<f64>)> {
        let places: Vec<f64> = angles.iter().map(|angle| self.position(*angle)).collect();
        let tangents = self.base.tangents(&places).into_iter().zip(angles);
        let tangent = |((height, slope), angle): ((f64, Option<f64>), &f64)| {
            (height - self.level(*angle), slope.map(|slope| self.turned(slope, *angle)))
        };
        tangents.map(tangent).collect()
    }
}
