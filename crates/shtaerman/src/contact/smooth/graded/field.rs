//! Pressure and displacement of a zone.

use std::f64::consts::PI;

use super::edges::{self, Settled};
use super::strip::{Ground, Strip};
use crate::contact::smooth::disk::transform::Transform;
use crate::contact::smooth::problem::Base;
use crate::contact::smooth::system::Place;
use crate::contact::smooth::zones::Zone;

/// A solved zone.
#[derive(Debug, Clone)]
pub(super) struct Field {
    pub(super) strip: Strip,
    pub(super) ground: Ground,
    /// Even and odd.
    pub(super) transforms: [Transform; 2],
    /// Densities at the left and the right end; none at free ones.
    pub(super) densities: [f64; 2],
    /// How fast the density falls when an end moves outwards.
    pub(super) slopes: [f64; 2],
    /// Where the profile bends inside.
    pub(super) breaks: Vec<f64>,
}

impl Field {
    pub(super) fn new(base: &Base<'_>, ground: &Ground, zone: Zone, settled: &Settled) -> Self {
        let Settled { strip, halves } = settled;
        let half = strip.half();
        let density = |side: usize| {
            if zone.is_free[side] { 0.0 } else { strip.end_density(side) }
        };
        let transforms =
            [halves.even(ground), halves.odd(ground)].map(|shape| Transform::new(&shape, half));
        let inside = |at: &f64| zone.left() < *at && *at < zone.right();
        Self {
            strip: Strip { zone, ..*strip },
            ground: ground.clone(),
            transforms,
            densities: [density(0), density(1)],
            slopes: [0, 1].map(|side| edges::slope(ground, settled, side)),
            breaks: base.problem.profile.breaks.iter().copied().filter(inside).collect(),
        }
    }

    /// The same with less of each series.
    pub(super) fn truncated(&self) -> Self {
        Self { transforms: self.transforms.each_ref().map(Transform::truncated), ..self.clone() }
    }

    pub(super) fn place(&self, xi: f64) -> Place {
        let [left, right] = self.strip.zone.ends;
        Place { from_left: (xi - left).max(0.0), from_right: (right - xi).max(0.0) }
    }

    /// `(b^2 - s^2)^beta`.
    fn taper(&self, place: Place) -> f64 {
        self.ground.powers.taper(place.from_left.sqrt() * place.from_right.sqrt())
    }

    /// `b^(2 beta)`.
    pub(super) fn whole_taper(&self) -> f64 {
        self.ground.powers.taper(self.strip.half())
    }

    /// `p0` in the zone; infinite at a singular end.
    pub(super) fn pressure(&self, place: Place) -> f64 {
        let Place { from_left, from_right } = place;
        let length = from_left + from_right;
        let density =
            self.densities[0] * (from_right / length) + self.densities[1] * (from_left / length);
        if from_left == 0.0 || from_right == 0.0 {
            return if density == 0.0 { 0.0 } else { density * f64::INFINITY };
        }
        let corners = if density == 0.0 { 0.0 } else { density / self.taper(place) };
        let s = 0.5 * (from_left - from_right);
        let r = s.abs().min(self.strip.half());
        let [even, odd] = self.transforms.each_ref().map(|transform| transform.pressure(r));
        self.ground.modulus / PI * (corners + even + s * odd)
    }

    /// `p0` without its singularity at corners.
    pub(super) fn regular(&self, place: Place) -> f64 {
        let factor =
            if self.densities == [0.0; 2] { 1.0 } else { self.taper(place) / self.whole_taper() };
        factor * self.pressure(place)
    }

    /// `lim (1 - s^2/b^2)^beta p0` at an end.
    pub(super) fn corner(&self, side: usize) -> f64 {
        self.ground.modulus / PI * self.densities[side] / self.whole_taper()
    }

    /// `lim sqrt(2 pi) d^beta p0` at an end.
    pub(super) fn intensity(&self, side: usize) -> f64 {
        let scale = self.ground.powers.corner(self.strip.half());
        self.ground.modulus / PI * self.densities[side] * scale
    }

    /// What a density of this size adds in the middle.
    pub(super) fn flat_pressure(&self, density: f64) -> f64 {
        self.ground.modulus / PI * density / self.whole_taper()
    }

    /// The displacement of the surface beside the zone.
    pub(super) fn displacement_outside(&self, xi: f64) -> f64 {
        let s = xi - self.strip.centre();
        let r = s.abs().max(self.strip.half());
        let [even, odd] =
            [0, 1].map(|part| self.transforms[part].displacement(r, self.strip.levels[part]));
        even + odd * s.signum()
    }
}
