//! The pressure of nearly smooth contact.
//!
//! At ends of zones and at kinks of the base the pressure turns within a distance of about `1/theta0`. There, at a fixed `s = theta0 d`, it is compared with the
//! smooth pressure at `d + 1/theta0`, by their quotient at ends and by their difference at kinks. Far from them it is `p(y) + (A ln theta0 + B)/theta0`.
//! In between the excess falls as `(a ln s + b)/s`, and `s` times it goes linearly with `ln d` from one to the other.

use std::f64::consts::LN_2;

use super::companion::Companions;
use super::fit::{Fitted, beside_limit_early, through};

/// `s` up to which a layer is compared, and the share of the shortest stretch beyond which there is none.
const WITHIN: f64 = 300.0;
const BEYOND: f64 = 0.1;

/// A place in the contact.
#[derive(Debug, Clone, Copy)]
struct Place {
    zone: usize,
    /// Index of the stretch between marks.
    stretch: usize,
    /// Which end of the stretch is nearer.
    side: usize,
    /// From the left, as a share of the stretch.
    share: f64,
}

/// Marks of all zones for one `theta0`: ends as they are, kinks of the base.
pub(super) type Marks = Vec<Vec<f64>>;

/// The pressure.
#[derive(Debug, Clone)]
pub(super) struct Pressure {
    pub(super) companions: Companions,
    pub(super) theta0: f64,
    /// Of this contact, and of the rough companions.
    pub(super) marks: Marks,
    pub(super) others: [Marks; 4],
}

impl Pressure {
    /// `p0` with its error at `xi` in a zone.
    pub(super) fn at(&self, zone: usize, xi: f64) -> Fitted {
        let marks = &self.marks[zone];
        let stretch = marks.partition_point(|at| *at <= xi).clamp(1, marks.len() - 1) - 1;
        let [left, right] = [marks[stretch], marks[stretch + 1]];
        let [from_left, from_right] = [(xi - left).max(0.0), (right - xi).max(0.0)];
        let side = usize::from(from_right < from_left);
        let distance = from_left.min(from_right);
        let share = from_left / (right - left);
        let place = Place { zone, stretch, side, share };
        let [near, far] = [WITHIN / self.theta0, BEYOND * self.companions.shortest];
        if distance >= far {
            return self.outside_layers(place);
        }
        let reference = self.reference(place, distance, self.theta0);
        let scale = if self.is_kink(place) { 1.0 } else { reference };
        if distance <= near {
            let Fitted { value, error } = self.excess(place, distance * self.theta0);
            return Fitted { value: reference + scale * value, error: scale.abs() * error };
        }
        // s times the excess at both ends of the range.
        let first = self.excess(place, WITHIN);
        let length = right - left;
        let share = if side == 0 { far / length } else { 1.0 - far / length };
        let last = self.outside_layers(Place { share, ..place });
        let beyond = self.reference(place, far, self.theta0);
        let last_scale = if self.is_kink(place) { 1.0 } else { beyond };
        let ends = [first.value * WITHIN, (last.value - beyond) / last_scale * far * self.theta0];
        let width = (far / near).ln();
        let way = (distance / near).ln() / width;
        let s = distance * self.theta0;
        let excess = (ends[0] + way * (ends[1] - ends[0])) / s;
        // How far the straight line on from the layer misses the other end.
        let slope = (ends[0] - 0.5 * WITHIN * self.excess(place, 0.5 * WITHIN).value) / LN_2;
        let missed = way * (ends[0] + slope * width - ends[1]).abs();
        let [one, two] = [first.error * WITHIN, last.error / last_scale.abs() * far * self.theta0];
        let error = ((1.0 - way) * one + way * two + missed) / s;
        Fitted { value: reference + scale * excess, error: scale.abs() * error }
    }

    fn is_kink(&self, place: Place) -> bool {
        let mark = place.stretch + place.side;
        mark > 0 && mark + 1 < self.marks[place.zone].len()
    }

    /// The smooth pressure a little farther from the mark than `distance`, so that it is finite.
    fn reference(&self, place: Place, distance: f64, theta0: f64) -> f64 {
        let marks = &self.companions.marks[place.zone];
        let [left, right] = [marks[0], marks[marks.len() - 1]];
        let inward = distance + 1.0 / theta0;
        let mark = marks[place.stretch + place.side];
        let (from_left, from_right) = if place.side == 0 {
            (mark - left + inward, right - mark - inward)
        } else {
            (mark - left - inward, right - mark + inward)
        };
        self.companions.smooth.pressure_beside0(place.zone, from_left, from_right)
    }

    /// What the pressure has more than the reference at `s` from a mark, as a share of it at ends.
    fn excess(&self, place: Place, s: f64) -> Fitted {
        let at = self.companions.at;
        let values = [0, 1, 2, 3].map(|i| {
            let distance = s / at[i];
            let mark = self.others[i][place.zone][place.stretch + place.side];
            let xi = if place.side == 0 { mark + distance } else { mark - distance };
            let reference = self.reference(place, distance, at[i]);
            let difference = self.companions.rough[i].pressure0(xi) - reference;
            if self.is_kink(place) { difference } else { difference / reference }
        });
        through(values, at, self.theta0)
    }

    /// At a fixed share of a stretch.
    fn outside_layers(&self, place: Place) -> Fitted {
        let Place { zone, stretch, share, .. } = place;
        let between =
            |marks: &[f64]| marks[stretch] + share * (marks[stretch + 1] - marks[stretch]);
        let limit = self.companions.smooth.pressure0(between(&self.companions.marks[zone]));
        let values = [0, 1, 2, 3]
            .map(|i| self.companions.rough[i].pressure0(between(&self.others[i][zone])));
        beside_limit_early(limit, values, self.companions.at, self.theta0)
    }
}
