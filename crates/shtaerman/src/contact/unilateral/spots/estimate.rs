//! The error of the answer, from three finenesses.

use super::ROUNDING;
use super::level::Level;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::parts::Smoothness;
use crate::contact::resolutions::UNKNOWN;
use crate::contact::unilateral::base::Base;

/// Places on each panel where levels are compared.
const PLACES: [f64; 2] = [0.11, 0.63];
/// Differences that fall by less have not begun to, and what is stated over them.
const SLOW: f64 = 0.5;
const SAFETY: f64 = 2.0;

/// Differences between two levels.
struct Change {
    pressure: f64,
    settlement: f64,
    tilt: f64,
    force: f64,
    moment: f64,
    edge: f64,
}

/// The error of the last level, and that of its edges.
pub(super) fn estimate(base: &Base<'_>, levels: &[Level; 3]) -> (Accuracy, f64) {
    let [first, coarse, fine] = levels;
    let bounds = fine.bounds();
    let places: Vec<f64> = (bounds.iter())
        .flat_map(|[left, right]| PLACES.map(|share| left + share * (right - left)))
        .collect();
    let displacements = levels
        .each_ref()
        .map(|level| places.iter().map(|xi| displaced(base, level, *xi)).collect());
    let pressure = |one: &Vec<f64>, other: &Vec<f64>| {
        one.iter().zip(other).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()))
    };
    let [u0, u1, u2] = &displacements;
    let before = difference(coarse, first, pressure(u1, u0));
    let change = difference(fine, coarse, pressure(u2, u1));
    let size = fine.size();
    let firmest = fine.layer.slope(fine.largest());
    let state = &fine.state;
    let carried = state.force.abs() + state.moment.abs();
    // Of two that belong together one may agree by chance.
    let of = |part: fn(&Change) -> f64, other: fn(&Change) -> f64, size: f64| {
        let both = |change: &Change| part(change).max(other(change));
        // What is prescribed does not change at all.
        let is_given = part(&before) == 0.0 && part(&change) == 0.0;
        if is_given { 0.0 } else { left(both(&before), both(&change)).max(ROUNDING * size) }
    };
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure: left(before.pressure, change.pressure).max(ROUNDING * size * firmest)
            + at_corners(base, fine),
        settlement: of(|c| c.settlement, |c| c.tilt, size),
        tilt: of(|c| c.tilt, |c| c.settlement, size),
        force: of(|c| c.force, |c| c.moment, carried),
        moment: of(|c| c.moment, |c| c.force, carried),
    };
    let is_unknown = base.smoothness == Smoothness::Unknown;
    let sizes = state.sizes(fine.highest());
    let accuracy = if is_unknown { accuracy.of_the_unknown(UNKNOWN, &sizes) } else { accuracy };
    // By rounding an edge is off as the pressure over its slope.
    let rounding = ROUNDING * size / fine.gentlest();
    (accuracy, left(before.edge, change.edge).max(rounding).max(ROUNDING))
}

/// What the finest level is off: its difference from the level before, which is far coarser. A rate is not assumed, as that of the ends of zones and that of what is smooth differ.
fn left(before: f64, change: f64) -> f64 {
    if change <= SLOW * before { change } else { SAFETY * change.max(before) }
}

/// What the panels at corners miss. There the pressure goes on as a power of the distance of its own size, which no polynomial shows; at all finenesses they may be as short as numbers allow,
/// so that no difference tells. The pressure changes by `V` on such a panel because the potential of a pressure `p` does by `V`: that of what is missed, `s V`, changes by `s V^2/p` at most. Of a power
/// `d^nu` polynomials of the degree `n` miss `s = n^(-2 nu)`, some.
fn at_corners(base: &Base<'_>, level: &Level) -> f64 {
    let bounds = level.bounds();
    let order = level.pressures.len() as f64 / bounds.len() as f64;
    let share = order.powf(-2.0 * (1.0 - base.medium.exponent()));
    let missed = |side: usize, end: f64| -> Option<f64> {
        let panel = bounds.iter().find(|panel| panel[side] == end)?;
        let inner = panel[1 - side];
        let change = (displaced(base, level, end) - displaced(base, level, inner)).abs();
        let pressure = level.pressure_at(inner, base.height(inner)).abs();
        Some(if change == 0.0 { 0.0 } else { share * change * (change / pressure.max(change)) })
    };
    let walls = level.zones.iter().flat_map(|zone| {
        (0..2).filter(|&side| !zone.is_free(side)).map(|side| (side, zone.ends[side]))
    });
    walls.filter_map(|(side, end)| missed(side, end)).fold(0.0, f64::max)
}

/// The pressure, of a linear layer with the profile taken out.
fn displaced(base: &Base<'_>, level: &Level, xi: f64) -> f64 {
    let height = if level.layer.is_linear() { 0.0 } else { base.height(xi) };
    level.pressure_at(xi, height)
}

fn difference(one: &Level, other: &Level, pressure: f64) -> Change {
    let ends = |level: &Level| -> Vec<f64> {
        level.zones.iter().flat_map(|zone| [zone.left(), zone.right()]).collect()
    };
    let is_alike = one.zones.len() == other.zones.len();
    let edge = (ends(one).into_iter().zip(ends(other)))
        .map(|(one, other)| (one - other).abs())
        .fold(if is_alike { 0.0 } else { 2.0 }, f64::max);
    let (one, other) = (&one.state, &other.state);
    Change {
        pressure,
        settlement: (one.settlement - other.settlement).abs(),
        tilt: (one.tilt - other.tilt).abs(),
        force: (one.force - other.force).abs(),
        moment: (one.moment - other.moment).abs(),
        edge,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_is_no_less_than_what_is_left() {
        assert_eq!(left(1e-4, 4e-6), 4e-6);
        assert_eq!(left(1e-8, 2e-8), 4e-8);
        assert_eq!(left(1e-8, 0.9e-8), 2e-8);
        assert_eq!(left(1e-8, 0.0), 0.0);
    }
}
