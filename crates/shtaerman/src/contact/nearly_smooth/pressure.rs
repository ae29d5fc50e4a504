//! The pressure of nearly smooth contact.
//!
//! A solution of the system at this `theta0` has the pressure itself between the ends of its panels, to about `eps/d` at the distance `d` from them. At free edges and at
//! kinks of the base the pressure turns within about `1/theta0`, and that is too little there: at a fixed `s = theta0 d` it is compared with the smooth pressure at
//! `d + 1/theta0`, by their quotient at edges and by their difference at kinks, which follow `q0 + (A ln theta0 + B)/theta0`. At walls the pressure is of the size of
//! `sqrt(theta0)`, and the direct solution serves up to the end.

use super::companion::{Companions, Rough};
use super::fit::through;

/// `s` up to which a layer is expanded, at least and at most: what is left out grows with `s`, the error of the direct solution with `theta0/s`.
const WITHIN: [f64; 2] = [100.0, 1000.0];
const LEAST_THETA0: f64 = 2e6;
const GROWTH: f64 = 0.6;
/// `s` below which a wall has the pressure of the equation.
const BESIDE_WALL: f64 = 1.0;
/// `s`, as shares of the width of the layer, at which both ways are compared.
const COMPARED: [f64; 6] = [1.0, 0.85, 0.7, 0.55, 0.4, 0.3];

/// A place in the contact.
#[derive(Debug, Clone, Copy)]
struct Place {
    zone: usize,
    /// Index of the nearest mark.
    mark: usize,
    /// Which side of it: 0 is right of it.
    side: usize,
    distance: f64,
}

/// What happens at a mark.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Mark {
    Wall,
    Edge,
    Kink,
}

/// Marks of all zones for one `theta0`: ends as they are, kinks of the base.
pub(super) type Marks = Vec<Vec<f64>>;

/// The pressure.
#[derive(Debug, Clone)]
pub(super) struct Pressure {
    pub(super) companions: Companions,
    /// The solution at this `theta0`.
    pub(super) direct: Rough,
    pub(super) theta0: f64,
    /// Of this contact, and of the rough companions.
    pub(super) marks: Marks,
    pub(super) others: [Marks; 3],
}

impl Pressure {
    /// `p0` at `xi` in a zone.
    pub(super) fn at(&self, zone: usize, xi: f64) -> f64 {
        let place = self.place(zone, xi);
        let s = place.distance * self.theta0;
        match self.kind(place) {
            Mark::Wall if s < BESIDE_WALL => self.direct.pressure(xi),
            Mark::Edge | Mark::Kink if s <= self.within() => self.in_layer(place, s),
            _ => self.direct.contact.density(xi),
        }
    }

    /// By how much the layers and the pressure between them differ where they meet.
    pub(super) fn mismatch(&self) -> f64 {
        let mut worst = 0.0f64;
        for (zone, marks) in self.marks.iter().enumerate() {
            for (mark, &at) in marks.iter().enumerate() {
                for side in 0..2 {
                    let is_outside = if side == 0 { mark + 1 == marks.len() } else { mark == 0 };
                    let place = Place { zone, mark, side, distance: 0.0 };
                    if is_outside || self.kind(place) == Mark::Wall {
                        continue;
                    }
                    for share in COMPARED {
                        let s = share * self.within();
                        let distance = s / self.theta0;
                        let xi = if side == 0 { at + distance } else { at - distance };
                        let density = self.direct.contact.density(xi);
                        worst = worst.max((self.in_layer(place, s) - density).abs());
                    }
                }
            }
        }
        worst
    }

    /// `s` up to which a layer is expanded.
    fn within(&self) -> f64 {
        let [least, most] = WITHIN;
        (least * (self.theta0 / LEAST_THETA0).powf(GROWTH)).clamp(least, most)
    }

    fn place(&self, zone: usize, xi: f64) -> Place {
        let marks = &self.marks[zone];
        let stretch = marks.partition_point(|at| *at <= xi).clamp(1, marks.len() - 1) - 1;
        let from_left = (xi - marks[stretch]).max(0.0);
        let from_right = (marks[stretch + 1] - xi).max(0.0);
        let side = usize::from(from_right < from_left);
        Place { zone, mark: stretch + side, side, distance: from_left.min(from_right) }
    }

    fn kind(&self, Place { zone, mark, side, .. }: Place) -> Mark {
        if mark > 0 && mark + 1 < self.marks[zone].len() {
            Mark::Kink
        } else if self.companions.is_free[zone][side] {
            Mark::Edge
        } else {
            Mark::Wall
        }
    }

    /// The pressure at `s` from an edge or a kink.
    fn in_layer(&self, place: Place, s: f64) -> f64 {
        let Some(rough) = &self.companions.rough else { return f64::NAN };
        let is_kink = self.kind(place) == Mark::Kink;
        let at = self.companions.at;
        let values = [0, 1, 2].map(|i| {
            let distance = s / at[i];
            let mark = self.others[i][place.zone][place.mark];
            let xi = if place.side == 0 { mark + distance } else { mark - distance };
            let reference = self.reference(place, distance, at[i]);
            let difference = rough[i].pressure(xi) - reference;
            if is_kink { difference } else { difference / reference }
        });
        let reference = self.reference(place, s / self.theta0, self.theta0);
        let excess = through(values, at, self.theta0);
        reference + if is_kink { excess } else { reference * excess }
    }

    /// The smooth pressure a little farther from the mark than `distance`, so that it is finite.
    fn reference(&self, place: Place, distance: f64, theta0: f64) -> f64 {
        let marks = &self.companions.marks[place.zone];
        let [left, right] = [marks[0], marks[marks.len() - 1]];
        let inward = distance + 1.0 / theta0;
        let mark = marks[place.mark];
        let (from_left, from_right) = if place.side == 0 {
            (mark - left + inward, right - mark - inward)
        } else {
            (mark - left - inward, right - mark + inward)
        };
        self.companions.smooth.pressure_beside0(place.zone, from_left, from_right)
    }
}
