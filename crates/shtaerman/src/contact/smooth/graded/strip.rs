//! A zone on graded ground with its pressure.
//!
//! On `xi = c + s`, `|s| <= b`, with the slopes `h_e`, `h_o` of the even and the odd part of the profile about `c`, the depth `D = delta0 - alpha0 c - f0(c)`,
//! `S(t) = int_0^t sin^mu`, `B = S(pi/2)`,
//!
//! - `G_e(x) = x int_0^{pi/2} h_e(x cos t) (cos t sin^mu t + mu sin t S(t)) dt`, `G_o(x) = int_0^{pi/2} h_o(x cos t) sin^mu t dt`;
//! - `p0 = (e/pi) [d_e(b) (b^2 - s^2)^-beta + int_|s|^b G_e' (x^2 - s^2)^-beta dx + s (the same of d_o, G_o)]`, `d_e = mu B D - G_e`, `d_o = -alpha0 B - G_o`;
//! - `P0 = (2e/pi) B b^mu (mu B D - mu b int h_e sin t S dt)`,
//!   `M0 = c P0 + (2e/pi) B b^(2+mu) (-alpha0 B/(2+mu) - int h_o sin^(2+mu) t dt/(1+mu))`.

use std::f64::consts::PI;
use std::sync::{Arc, OnceLock};

use fredholm::inversion::ultraspherical::{Ripple, displaced, felt};
use fredholm::inversion::{AbelTransform, Kink, Place};

use super::Ground;
use super::on_zone::{FELT, OnZone};
use crate::contact::accuracy::ROUNDING;
use crate::contact::zones::Zone;
use crate::rounding::OF_A_VALUE;

/// Even and odd, of what is neither kink nor polynomial.
type Halves = Option<[AbelTransform; 2]>;

#[derive(Debug, Clone)]
pub(super) struct Strip {
    pub(super) zone: Zone,
    ground: Ground,
    /// None for a flat base.
    profile: Option<Arc<OnZone>>,
    /// The even and the odd density without the profile's: of one zone `mu B D` and `-alpha0 B`.
    levels: [f64; 2],
    /// `G_e(b)`, `G_o(b)`, of a smooth profile those of its first two polynomials.
    transforms: [f64; 2],
    /// The other polynomials, those of other zones and of the profile.
    ripple: Ripple,
    /// The coefficients of the first two.
    lowest: [f64; 2],
    /// Made when the pressure is looked at.
    halves: OnceLock<Halves>,
    /// `a_n` of the displacement but for halves and kinks, and less those of the kinks; made when the surface beside is looked at.
    heights: OnceLock<[Vec<f64>; 2]>,
}

impl Strip {
    /// From the coefficients of the polynomials that depth, tilt and other zones make, the first two and the rest.
    pub(super) fn new(
        ground: &Ground,
        zone: Zone,
        profile: Option<Arc<OnZone>>,
        lowest: [f64; 2],
        others: Vec<f64>,
    ) -> Self {
        let half = 0.5 * zone.length();
        let powers = &ground.powers;
        let (taken, transforms, modes) = match &profile {
            Some(own) => (own.lowest(), own.transforms(powers), own.modes()),
            None => ([0.0; 2], [0.0; 2], &[][..]),
        };
        let ripple = Ripple::new(powers, modes, others);
        Self {
            zone,
            ground: ground.clone(),
            levels: [lowest[0], lowest[1] / half],
            lowest: [lowest[0] - taken[0], lowest[1] - taken[1]],
            transforms,
            ripple,
            profile,
            halves: OnceLock::new(),
            heights: OnceLock::new(),
        }
    }

    pub(super) fn half(&self) -> f64 {
        0.5 * self.zone.length()
    }

    fn halves(&self) -> &Halves {
        let powers = &self.ground.powers;
        let made = || self.profile.as_ref().and_then(|profile| profile.on_panels(powers));
        self.halves.get_or_init(made)
    }

    fn kinks(&self) -> &[Kink] {
        self.profile.as_ref().map_or(&[], |profile| profile.kinks())
    }

    /// The same with less of each series.
    pub(super) fn truncated(&self) -> Self {
        let less = self.halves().as_ref().map(less);
        let ripple = self.ripple.truncated(&self.ground.powers);
        let heights = OnceLock::new();
        Self { halves: OnceLock::from(less), ripple, heights, ..self.clone() }
    }

    /// Whether there is anything that could be left out.
    pub(super) fn is_truncated(&self) -> bool {
        self.halves().is_some() || self.ripple.is_moved()
    }

    /// `d_e(b) -+ b d_o(b)` at the left (0) or right (1) end.
    pub(super) fn end_density(&self, side: usize) -> f64 {
        let [even, odd] = [0, 1].map(|part| self.levels[part] - self.transforms[part]);
        let arm = if side == 0 { -self.half() } else { self.half() };
        even + arm * odd + self.ripple.ends()[side]
    }

    /// Size of what is added up in that.
    pub(super) fn density_scale(&self) -> f64 {
        let [even, odd] = [0, 1].map(|part| self.levels[part].abs() + self.transforms[part].abs());
        let steepest = self.profile.as_ref().map_or(0.0, |profile| profile.steepest);
        even + self.half() * (odd + steepest) + self.ripple.size()
    }

    /// By how much the densities at both ends fall as they move outwards, `G_e' +- b G_o'` and what is added by the other end's and by other zones, without panels: from inside. An end that lies inside by
    /// `e` has the density `G' e`, as the pressure beyond is `d^(1-beta)` moved by `e`: so each end has its own Newton step, exact to first order where the densities vanish.
    pub(super) fn falls(&self) -> [f64; 2] {
        let powers = &self.ground.powers;
        let rises = |profile: &Arc<OnZone>| profile.rises(powers, self.transforms);
        self.with_others(self.profile.as_ref().map_or([0.0; 2], rises))
    }

    /// The same from the panels, with its error.
    pub(super) fn known_falls(&self) -> [[f64; 2]; 2] {
        let powers = &self.ground.powers;
        let kinks = self.profile.as_ref().map_or([0.0; 2], |profile| profile.kink_rises(powers));
        let falls = |halves: &Halves| {
            let ends = halves.as_ref().map(|all| all.each_ref().map(AbelTransform::end_slope));
            let [even, odd] = ends.unwrap_or_default();
            self.with_others([even + kinks[0], odd + kinks[1]])
        };
        let (found, other) = (falls(self.halves()), falls(&self.halves().as_ref().map(less)));
        let rounding = self.slope_rounding()
            + ROUNDING * (kinks[0].abs() + self.half() * kinks[1].abs())
            + self.ripple.bend_rounding() / self.half();
        [0, 1].map(|side| [found[side], (found[side] - other[side]).abs() + rounding])
    }

    /// From `G_e'` and `G_o'` at the end.
    fn with_others(&self, [even, odd]: [f64; 2]) -> [f64; 2] {
        let share = (1.0 - self.ground.powers.corner_exponent()) / (2.0 * self.half());
        [0, 1].map(|side| {
            let sign = if side == 0 { -1.0 } else { 1.0 };
            let other = self.end_density(1 - side) - self.end_density(side);
            even + sign * self.half() * odd + share * (other + 4.0 * self.ripple.bend(sign))
        })
    }

    /// What rounding of the transforms makes of their slopes, over the half-length.
    pub(super) fn slope_rounding(&self) -> f64 {
        let all =
            self.halves().as_ref().map(|all| all.each_ref().map(AbelTransform::slope_rounding));
        all.map_or(0.0, |[even, odd]| even + self.half() * odd)
    }

    /// Number of coefficients.
    pub(super) fn size(&self) -> usize {
        let halves = self.halves().iter().flatten().map(AbelTransform::size);
        halves.sum::<usize>() + self.ripple.count() + self.kinks().len()
    }

    /// `p0` in the zone; infinite at a singular end.
    pub(super) fn pressure(&self, place: Place) -> f64 {
        let Place { from_left, from_right } = place;
        let length = from_left + from_right;
        // At free ends the densities are rounding.
        let end = |side: usize| if self.zone.is_free(side) { 0.0 } else { self.end_density(side) };
        let [left, right] = [from_left / length, from_right / length];
        let line = end(0) * right + end(1) * left;
        if from_left == 0.0 || from_right == 0.0 {
            return if line == 0.0 { 0.0 } else { line * f64::INFINITY };
        }
        // What is no line between the densities at the ends.
        let is_bent = self.ripple.size() != 0.0;
        let bent = if is_bent { 4.0 * left * right * self.ripple.bend(left - right) } else { 0.0 };
        let powers = &self.ground.powers;
        let corners = if line + bent == 0.0 {
            0.0
        } else {
            (line + bent) / powers.taper(from_left.sqrt() * from_right.sqrt())
        };
        let s = 0.5 * (from_left - from_right);
        let halves = self.halves().as_ref().map_or(0.0, |halves| {
            let r = s.abs().min(self.half());
            let at = |half: &AbelTransform| half.pressure_about(r, OF_A_VALUE * self.farthest());
            let [even, odd] = halves.each_ref().map(at);
            even + s * odd
        });
        let kinks = self.kinks().iter();
        let kinks =
            kinks.map(|kink| kink.pressure(powers, place, self.distance_from_kink(kink, place)));
        self.ground.modulus / PI * (corners + halves + kinks.sum::<f64>())
    }

    /// What the pressure beside bends may be off by.
    pub(super) fn bend_error(&self) -> f64 {
        let all = self.halves().as_ref().map(|all| all.each_ref().map(AbelTransform::bend_error));
        all.map_or(0.0, |[even, odd]| self.ground.modulus / PI * (even + self.half() * odd))
    }

    fn distance_from_kink(&self, kink: &Kink, place: Place) -> f64 {
        let distance = if place.from_left < place.from_right {
            place.from_left - kink.place.from_left
        } else {
            kink.place.from_right - place.from_right
        };
        let rounded = OF_A_VALUE * self.farthest();
        if distance.abs() <= rounded { 0.0 } else { distance }
    }

    pub(super) fn farthest(&self) -> f64 {
        self.zone.left().abs().max(self.zone.right().abs())
    }

    /// `lim sqrt(2 pi) d^beta p0` of a density 1 at an end.
    pub(super) fn intensity(&self) -> f64 {
        self.ground.modulus / PI * self.ground.powers.corner(self.half())
    }

    /// What a density of this size adds in the middle.
    pub(super) fn flat_pressure(&self, density: f64) -> f64 {
        self.ground.modulus / PI * density / self.ground.powers.taper(self.half())
    }

    /// The displacement of the surface beside the zone by its own pressure.
    pub(super) fn outside(&self, xi: f64) -> f64 {
        let s = xi - self.zone.middle();
        let (r, side) = (s.abs().max(self.half()), s.signum());
        let excess = (r - self.half()) / self.half();
        let powers = &self.ground.powers;
        let near = self.profile.as_ref().filter(|_| felt(excess) >= FELT as f64);
        let [all, less] = self.heights.get_or_init(|| self.heights());
        let series = displaced(powers, if near.is_some() { all } else { less }, excess, side);
        let halves = self.halves().as_ref().map_or(0.0, |halves| {
            let [even, odd] = halves.each_ref().map(|half| half.displacement(r, 0.0));
            even + odd * side
        });
        series + halves + near.map_or(0.0, |own| own.beside(powers, excess, side))
    }

    fn heights(&self) -> [Vec<f64>; 2] {
        let all = self.ripple.heights(&self.ground.powers, self.lowest);
        let kinks = self.profile.as_ref().map_or(&[][..], |own| own.felt(&self.ground.powers));
        let mut less = all.clone();
        less.resize(all.len().max(kinks.len()), 0.0);
        less.iter_mut().zip(kinks).for_each(|(height, kink)| *height -= kink);
        [all, less]
    }
}

fn less(halves: &[AbelTransform; 2]) -> [AbelTransform; 2] {
    halves.each_ref().map(AbelTransform::truncated)
}
