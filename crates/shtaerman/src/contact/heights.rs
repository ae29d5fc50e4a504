//! Heights of the base: counted from its level, and known to their rounding only.

use std::ops::Add;

use super::accuracy::{Accuracy, Sizes};
use super::setting::Setting;
use super::solution::Solution;
use crate::golden::GOLDEN;
use crate::roughness::Law;
use crate::rounding::OF_A_VALUE;
use crate::{Error, Rotational, Scaling, Vertical};

/// Places in all zones at which the rounding of heights is looked at, at least one in each, and where in its step each lies: an irrational share keeps clear of jumps (survey).
const PLACES: usize = 128;
/// The pressure in the middle of a flat punch over its mean, `2/pi` on a line and `1/2` on a disk, twice that for zones of which some take more.
const FLAT: f64 = 4.0 * std::f64::consts::FRAC_1_PI;
/// Share of a zone at whose distance from an end the pressure is that of the end, a power of the distance. At half or twice stated errors grow up to 1.3 times (survey).
const AT_END: f64 = 1.0 / 1024.0;

/// Errors that the rounding of heights, and of the moment, makes, and the sizes against which they are held.
#[derive(Debug, Clone, Copy)]
pub(super) struct OfHeights {
    accuracy: Accuracy,
    sizes: Sizes,
    /// Of the edges, in `xi`.
    edges: f64,
}

impl Setting {
    /// The largest rounding of the dimensionless heights in the zones of contact, and the largest of these.
    fn height_rounding(&self, zones: &[[f64; 2]]) -> [f64; 2] {
        let steps = (PLACES / zones.len().max(1)).max(1);
        let (profile, half_width) =
            (self.problem().profile(), self.problem().bodies().half_width());
        let in_zone = |[left, right]: &[f64; 2]| {
            let (left, length) = (*left, right - left);
            (0..steps).map(move |i| left + length * (i as f64 + GOLDEN) / steps as f64)
        };
        let places: Vec<f64> =
            zones.iter().flat_map(in_zone).map(|xi| xi.clamp(-1.0, 1.0)).collect();
        let largest =
            profile.heights(&places, half_width).iter().fold(0.0, |most, f| f.abs().max(most));
        let roundings = profile.roundings(&places, half_width);
        let rounding = roundings.into_iter().filter(|here| here.is_finite()).fold(0.0, f64::max);
        let scale = self.problem().bodies().unit(Scaling::displacement);
        [(rounding + self.problem().rounding()) / scale, largest / scale]
    }

    /// The largest rounding of the dimensionless heights beside the ends of the zones, up to half of each.
    fn rounding_at_ends(&self, zones: &[[f64; 2]]) -> f64 {
        let (profile, half_width) =
            (self.problem().profile(), self.problem().bodies().half_width());
        let ends =
            zones.iter().flat_map(|[left, right]| [(*left, right - left), (*right, left - right)]);
        let roundings =
            ends.map(|(end, into)| profile.rounding_beside(end, 0.5 * into, half_width));
        roundings.fold(0.0, f64::max) / self.problem().bodies().unit(Scaling::displacement)
    }

    /// How far the edges of a layer's contact move for a disturbance of its displacement: to where it is as large as that.
    fn edges_of_layer(&self, solution: &dyn Solution, error: f64) -> f64 {
        if error == 0.0 {
            return 0.0;
        }
        let law = self.problem().bodies().law();
        at_ends(solution, |length, pressure| {
            let distance = |k: i32| length * 0.5f64.powi(k);
            let layer = |k: i32| law.displacement(pressure(distance(k)).max(0.0));
            // From the middle towards the end while the layer is deeper than that.
            match (1..f64::MANTISSA_DIGITS as i32).take_while(|k| layer(*k) > error).last() {
                None => length,
                Some(k) if k + 1 < f64::MANTISSA_DIGITS as i32 => distance(k),
                Some(k) => distance(k) * error / layer(k),
            }
        })
    }

    /// Changes of settlement and `-alpha0` by the rounding of the moment without dimensions: a load next to an end of the base turns a narrow contact by it.
    fn of_moment(&self, solution: &dyn Solution) -> [f64; 2] {
        let load = self.load();
        if let Rotational::Tilt(_) = load.rotational {
            return [0.0; 2];
        }
        let rounding = OF_A_VALUE * solution.state().moment.abs();
        let changes = solution.stiffness().displaced(&load, [0.0, rounding]);
        if rounding > 0.0 && changes.iter().all(|change| change.is_finite()) {
            changes
        } else {
            [0.0; 2]
        }
    }

    /// What the rounding of heights, and of the moment, makes of a solution; none where the method tells no error.
    pub(super) fn of_heights(&self, solution: &dyn Solution) -> Option<OfHeights> {
        let known = *solution.accuracy()?;
        let zones = solution.zones();
        let (left, right) = (zones.first()?[0], zones.last()?[1]);
        let [rounding, height] = self.height_rounding(&zones);
        let (half, middle) = (0.5 * (right - left), 0.5 * (right + left).abs());
        let stiffness = solution.stiffness().force_settlement.abs();
        let force = if stiffness.is_finite() { stiffness * rounding } else { 0.0 };
        let [lowered, tilted] = self.of_moment(solution);
        let at_end = |end: &f64| (lowered + tilted * end).abs();
        let coupling = if tilted == 0.0 { 0.0 } else { solution.stiffness().coupling };
        let turned = zones.as_flattened().iter().map(at_end).fold(0.0, f64::max);
        let free = solution.edge_error().is_some();
        let law = self.problem().bodies().law();
        let (pressure, edges) = match law {
            // The pressure follows from slopes, and a given settlement counts from heights.
            Law::Smooth if matches!(self.problem().load().vertical, Vertical::Force(_)) => {
                (0.0, 0.0)
            }
            Law::Smooth => {
                let is_round = self.problem().bodies().is_circular();
                let measure = |[left, right]: &[f64; 2]| {
                    if is_round {
                        0.5 * std::f64::consts::PI * (right * right.abs() - left * left.abs())
                    } else {
                        right - left
                    }
                };
                let mean = force / zones.iter().map(measure).sum::<f64>();
                let mean = if mean.is_finite() { mean } else { 0.0 };
                let moved = if free { edges_of_settlement(solution, mean) } else { 0.0 };
                (FLAT * mean, moved)
            }
            Law::Linear | Law::Power(_) => {
                let kappa = law.exponent().unwrap_or(1.0);
                let steepness = solution.size().max(f64::MIN_POSITIVE).powf(1.0 - kappa) / kappa;
                let at_ends = self.rounding_at_ends(&zones);
                // A single place is disturbed by itself, which is half of what disturbances grow to.
                let error = solution.growth() * rounding.max(0.5 * at_ends) + turned;
                let edges = if free { self.edges_of_layer(solution, error) } else { 0.0 };
                (steepness * error, edges)
            }
        };
        // Of a disturbance of the heights on its way to the tilt, in half-widths of the contact: at half or twice stated errors grow up to 1.8 times (survey).
        let turn = 2.0 * rounding / half.max(f64::MIN_POSITIVE);
        let own = [
            rounding + middle * turn + lowered.abs(),
            turn + tilted.abs(),
            force + (coupling * tilted).abs(),
            (middle + half) * force,
        ];
        let accuracy = Accuracy { pressure, ..known.open(own, |_, own| own) };
        let sizes = solution.state().sizes(solution.size());
        // A settlement may be next to nothing where heights above and below cancel.
        let sizes = Sizes { displacement: sizes.displacement.max(height), ..sizes };
        Some(OfHeights { accuracy, sizes, edges })
    }
}

/// The largest of what is made at all ends of zones of the length of the zone and the pressure at a distance from its end.
fn at_ends(solution: &dyn Solution, of: impl Fn(f64, &dyn Fn(f64) -> f64) -> f64) -> f64 {
    let mut most = 0.0f64;
    for (zone, [left, right]) in solution.zones().into_iter().enumerate() {
        let length = right - left;
        let from_left = |near: f64| solution.pressure_beside(zone, near, length - near);
        let from_right = |near: f64| solution.pressure_beside(zone, length - near, near);
        most = most.max(of(length, &from_left)).max(of(length, &from_right));
    }
    most
}

/// How far the edges of a smooth contact move for a settlement that adds `mean` to the mean pressure: by what a flat punch adds there over what the pressure gains inwards.
fn edges_of_settlement(solution: &dyn Solution, mean: f64) -> f64 {
    at_ends(solution, |length, pressure| {
        let near = AT_END * length;
        let p = pressure(near);
        let moved = 2.0 * mean * (length * near).sqrt() / p;
        if p > 0.0 && moved.is_finite() { moved.min(length) } else { 0.0 }
    })
}

impl OfHeights {
    /// The error of the edges, in `xi`.
    pub(super) fn edges(&self) -> f64 {
        self.edges
    }

    /// The largest error relative to its size.
    pub(super) fn relative(&self) -> f64 {
        self.accuracy.relative(&self.sizes)
    }

    /// The larger one of an error and this.
    pub(super) fn or(&self, known: &Accuracy) -> Accuracy {
        let Accuracy { pressure, settlement, tilt, force, moment, .. } = self.accuracy;
        let opened = known.open([settlement, tilt, force, moment], f64::max);
        Accuracy { pressure: known.pressure.max(pressure), ..opened }
    }
}

impl Accuracy {
    /// With the rounding of a level that is added to the settlement.
    pub(crate) fn with_level(self, level: f64) -> Self {
        self.open([OF_A_VALUE * level.abs(), 0.0, 0.0, 0.0], f64::add)
    }
}

impl Error {
    /// The same with settlements counted from where the heights are, not from a level, in the units of the problem and without dimensions.
    pub(crate) fn with_level(self, level: f64, level0: f64) -> Self {
        match self {
            Self::SettlementOutOfReach { value, eccentricity, limit, bound } => {
                let (value, limit) = (value + level, limit + level);
                Self::SettlementOutOfReach { value, eccentricity, limit, bound }
            }
            Self::ToleranceNotMet { tolerance, reached, method, n, settlement0, tilt0 } => {
                let settlement0 = settlement0 + level0;
                Self::ToleranceNotMet { tolerance, reached, method, n, settlement0, tilt0 }
            }
            other => other,
        }
    }
}
