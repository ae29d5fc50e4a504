//! A pressure on given zones, whatever the ground.

use std::f64::consts::TAU;
use std::fmt::Debug;

use fredholm::inversion::Place;

use crate::contact::balance::State;
use crate::contact::edges::EndState;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;

/// What a zone is known to.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct Known {
    /// Rounding of the densities at its ends.
    pub(super) density: f64,
    /// Rounding of the pressure without its singularity.
    pub(super) pressure: f64,
}

/// What is known at an end of a zone.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct Density {
    /// The density, in proportion to the intensity of the singular pressure; at a free end it vanishes.
    pub(super) value: f64,
    /// By how much it falls as the end moves outwards, over `xi`.
    pub(super) fall: f64,
    /// The error of that.
    pub(super) fall_error: f64,
}

/// The pressure on given zones under the load; at free ends it need not vanish yet.
pub(in crate::contact) trait Pressure:
    Debug + Send + Sync + Sized + 'static
{
    /// From left to right.
    fn zones(&self) -> Vec<Zone>;

    fn state(&self) -> State;

    fn stiffness(&self) -> Stiffness;

    /// `theta0` times the force on a zone, or a multiple of it.
    fn force(&self, zone: usize) -> f64;

    /// `p0` at a place of a zone; infinite at a singular end, 0 at a free one.
    fn at(&self, zone: usize, place: Place) -> f64;

    /// The power `beta` of the distance with which it is singular.
    fn corner_exponent(&self) -> f64 {
        0.5
    }

    /// What the surface is displaced by at a place beside the zones.
    fn outside(&self, xi: f64) -> f64;

    /// The same on the side of the axis where `xi` has this sign: a tilt of a disk presses one and relieves the other.
    fn on_side(&self, zone: usize, place: Place, _side: f64) -> f64 {
        self.at(zone, place)
    }

    /// What of the tilt of a disk the surface follows beside it, on the side where `xi` is positive.
    fn turned_outside(&self, _r: f64) -> f64 {
        0.0
    }

    /// What it adds to the intensity at the edge.
    fn turned_intensity(&self, _zone: usize) -> f64 {
        0.0
    }

    /// For Newton's method.
    fn end(&self, zone: usize, side: usize) -> EndState;

    /// The same for the answer.
    fn density(&self, zone: usize, side: usize) -> Density;

    /// `lim sqrt(2 pi) d^beta p0` of a density 1 at an end, `d` in `xi`.
    fn intensity(&self, zone: usize, side: usize) -> f64;

    /// What a density 1 at an end is there of the [regular](Self::regular) pressure.
    fn singular(&self, zone: usize, side: usize) -> f64 {
        let length = self.zones()[zone].length();
        self.intensity(zone, side) * (4.0 / length).powf(self.corner_exponent()) / TAU.sqrt()
    }

    /// What a zone is known to, given the largest pressure.
    fn known(&self, zone: usize, largest: f64) -> Known;

    /// Rounding of settlement and tilt by that of the heights.
    fn displacement_rounding(&self) -> [f64; 2];

    /// What a settlement and a turn, minus a tilt, of a flat base add on these zones.
    fn change(&self, raise: f64, turn: f64) -> Self;

    /// Number of unknowns.
    fn unknowns(&self) -> usize;

    /// About how many terms are summed for a value.
    fn terms(&self) -> usize {
        self.unknowns()
    }

    /// How many of them a dense system couples.
    fn coupled(&self) -> usize {
        self.unknowns()
    }

    /// Whether more detail adds nothing.
    fn is_fine(&self) -> bool {
        false
    }

    /// `p0` at a place of a zone without its singularity at the ends: times the power of `4 y (1 - y)` that takes it away, `y` the share of the length.
    fn regular(&self, zone: usize, place: Place) -> f64 {
        let length = place.from_left + place.from_right;
        let share = 4.0 * (place.from_left / length) * (place.from_right / length);
        if share == 0.0 {
            let side = usize::from(place.from_left > 0.0);
            let is_free = self.zones()[zone].is_free(side);
            let density = if is_free { 0.0 } else { self.end(zone, side).value };
            return density * self.singular(zone, side);
        }
        share.powf(self.corner_exponent()) * self.at(zone, place)
    }
}

/// A place of a zone.
pub(super) fn place(zone: &Zone, xi: f64) -> Place {
    Place { from_left: (xi - zone.left()).max(0.0), from_right: (zone.right() - xi).max(0.0) }
}

/// The place at an angle from the right end.
pub(super) fn at_angle(zone: &Zone, angle: f64) -> Place {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    let length = zone.length();
    Place { from_left: length * cosine * cosine, from_right: length * sine * sine }
}
