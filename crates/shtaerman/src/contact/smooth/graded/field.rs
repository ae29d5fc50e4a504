//! Pressure and displacement of a zone.

use std::f64::consts::PI;

use fredholm::inversion::ultraspherical::{Ripple, inside};
use fredholm::inversion::{AbelTransform, Kink};

use super::edges;
use super::settled::Settled;
use super::strip::{Ground, Strip};
use crate::contact::accuracy::{OF_A_VALUE, ROUNDING};
use crate::contact::smooth::problem::Base;
use crate::contact::smooth::system::Place;

/// A solved zone.
#[derive(Debug, Clone)]
pub(super) struct Field {
    pub(super) strip: Strip,
    pub(super) ground: Ground,
    kinks: Vec<Kink>,
    /// Even and odd, of what is neither kink nor polynomial.
    pub(super) transforms: Option<[AbelTransform; 2]>,
    /// Densities at the left and the right end; none at free ones.
    pub(super) densities: [f64; 2],
    /// How fast the density falls when an end moves outwards, and the error of that.
    pub(super) slopes: [f64; 2],
    pub(super) slope_errors: [f64; 2],
    ripple: Ripple,
    lowest: [f64; 2],
    flat: [Vec<f64>; 2],
    middle: f64,
    /// Where the profile bends inside.
    pub(super) breaks: Vec<f64>,
}

impl Field {
    pub(super) fn new(base: &Base<'_>, ground: &Ground, settled: &Settled) -> Self {
        let strip = settled.strip;
        let half = strip.half();
        let density =
            |side: usize| if strip.zone.is_free(side) { 0.0 } else { strip.end_density(side) };
        let transforms = settled.parts.on_panels(ground);
        let kinks = settled.parts.kink_rises(ground);
        let rises = |transforms: &Option<[AbelTransform; 2]>| {
            let ends = transforms.as_ref().map(|all| all.each_ref().map(AbelTransform::end_slope));
            let [even, odd] = ends.unwrap_or_default();
            edges::with_others(ground, settled, [even + kinks[0], odd + kinks[1]])
        };
        let slopes = rises(&transforms);
        let other = rises(&transforms.as_ref().map(less));
        let rounding = slope_rounding(&transforms, half)
            + ROUNDING * (kinks[0].abs() + half * kinks[1].abs())
            + settled.ripple.bend_rounding() / half;
        let [left, right] = strip.zone.ends;
        let inside = |at: &f64| left < *at && *at < right;
        let breaks = base.problem.profile.breaks.iter().copied().filter(inside).collect();
        let densities = [density(0), density(1)];
        Self {
            strip,
            ground: ground.clone(),
            kinks: settled.parts.kinks().to_vec(),
            transforms,
            densities,
            slopes,
            slope_errors: [0, 1].map(|side| (slopes[side] - other[side]).abs() + rounding),
            ripple: settled.ripple.clone(),
            lowest: settled.lowest,
            flat: settled.flat.clone(),
            middle: settled.middle,
            breaks,
        }
    }

    /// The same with less of each series.
    pub(super) fn truncated(&self) -> Self {
        Self {
            transforms: self.transforms.as_ref().map(less),
            ripple: self.ripple.truncated(&self.ground.powers),
            ..self.clone()
        }
    }

    /// Whether there is anything that could be left out.
    pub(super) fn is_truncated(&self) -> bool {
        self.transforms.is_some() || self.ripple.is_moved()
    }

    /// What rounding of the transforms makes of their slopes, over the half-length.
    pub(super) fn slope_rounding(&self) -> f64 {
        slope_rounding(&self.transforms, self.strip.half())
    }

    /// Number of coefficients.
    pub(super) fn size(&self) -> usize {
        let transforms = self.transforms.iter().flatten().map(AbelTransform::size);
        transforms.sum::<usize>() + self.ripple.count() + self.kinks.len()
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
        let bent = self.bent(place);
        let corners =
            if density + bent == 0.0 { 0.0 } else { (density + bent) / self.taper(place) };
        let s = 0.5 * (from_left - from_right);
        let r = s.abs().min(self.strip.half());
        let mut sum = corners;
        if let Some(transforms) = &self.transforms {
            let [even, odd] = transforms.each_ref().map(|transform| transform.pressure(r));
            sum += even + s * odd;
        }
        for kink in &self.kinks {
            sum += kink.pressure(&self.ground.powers, place, self.offset(kink, place));
        }
        self.ground.modulus / PI * sum
    }

    fn offset(&self, kink: &Kink, place: Place) -> f64 {
        let distance = if place.from_left < place.from_right {
            place.from_left - kink.place.from_left
        } else {
            kink.place.from_right - place.from_right
        };
        let [left, right] = self.strip.zone.ends;
        let rounded = OF_A_VALUE * left.abs().max(right.abs());
        if distance.abs() <= rounded { 0.0 } else { distance }
    }

    /// What others add besides a line between the densities at the ends.
    fn bent(&self, place: Place) -> f64 {
        if self.ripple.size() == 0.0 {
            return 0.0;
        }
        let Place { from_left, from_right } = place;
        let length = from_left + from_right;
        let share = (from_left / length) * (from_right / length);
        4.0 * share * self.ripple.bend((from_left - from_right) / length)
    }

    /// The density of a flat base that settles by `raise` and turns by `turn` about the middle of the base.
    pub(super) fn flat_density(&self, place: Place, raise: f64, turn: f64) -> f64 {
        let Place { from_left, from_right } = place;
        let y = (from_left - from_right) / (from_left + from_right);
        let count = self.flat[0].len().max(self.flat[1].len());
        let polynomials = inside(0.5 * self.ground.powers.exponent(), count, y);
        let sum = |m: &[f64]| m.iter().zip(&polynomials).map(|(m, c)| m * c).sum::<f64>();
        (raise + turn * self.middle) * sum(&self.flat[0]) + turn * sum(&self.flat[1])
    }

    /// What that adds to the pressure.
    pub(super) fn flat_change(&self, place: Place, raise: f64, turn: f64) -> f64 {
        self.ground.modulus / PI * self.flat_density(place, raise, turn) / self.taper(place)
    }

    /// `p0` without its singularity at corners.
    pub(super) fn regular(&self, place: Place) -> f64 {
        self.regular_share(place) * self.pressure(place)
    }

    /// What that is of `p0`.
    pub(super) fn regular_share(&self, place: Place) -> f64 {
        if self.densities == [0.0; 2] { 1.0 } else { self.taper(place) / self.whole_taper() }
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

    /// The displacement of the surface beside the zone by its own pressure.
    pub(super) fn displacement_outside(&self, xi: f64) -> f64 {
        let s = xi - self.strip.centre();
        let r = s.abs().max(self.strip.half());
        let excess = (r - self.strip.half()) / self.strip.half();
        let mut sum =
            self.ripple.displacement(&self.ground.powers, self.lowest, excess, s.signum());
        if let Some(transforms) = &self.transforms {
            let [even, odd] = transforms.each_ref().map(|all| all.displacement(r, 0.0));
            sum += even + odd * s.signum();
        }
        let powers = &self.ground.powers;
        let kinks = self.kinks.iter().map(|kink| kink.displacement(powers, r, s.signum()));
        sum + powers.beside() * kinks.sum::<f64>()
    }
}

fn less(transforms: &[AbelTransform; 2]) -> [AbelTransform; 2] {
    transforms.each_ref().map(AbelTransform::truncated)
}

fn slope_rounding(transforms: &Option<[AbelTransform; 2]>, half: f64) -> f64 {
    let all = transforms.as_ref().map(|all| all.each_ref().map(AbelTransform::slope_rounding));
    all.map_or(0.0, |[even, odd]| even + half * odd)
}

/// The displacement of the surface beside all zones.
pub(super) fn displacement_outside(fields: &[Field], xi: f64) -> f64 {
    fields.iter().map(|field| field.displacement_outside(xi)).sum()
}
