//! The error of the answer, from three finenesses.

use super::ROUNDING;
use super::level::Level;
use crate::contact::accuracy::{Accuracy, ErrorKind};

/// Places on each panel where levels are compared.
const PLACES: [f64; 2] = [0.11, 0.63];
/// Differences that fall by less have not begun to.
const SLOW: f64 = 0.5;
/// However fast they fall at first, what the ends of zones leave does not fall faster than with the third power of the panels there, which are halved.
const FASTEST: f64 = 0.125;

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
pub(super) fn estimate(levels: &[Level; 3]) -> (Accuracy, f64) {
    let [first, coarse, fine] = levels;
    let bounds = fine.field.panels().bounds();
    let places: Vec<f64> = (bounds.iter())
        .flat_map(|[left, right]| PLACES.map(|share| left + share * (right - left)))
        .collect();
    let displacements =
        levels.each_ref().map(|level| places.iter().map(|xi| displaced(level, *xi)).collect());
    let pressure = |one: &Vec<f64>, other: &Vec<f64>| {
        one.iter().zip(other).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()))
    };
    let [u0, u1, u2] = &displacements;
    let before = difference(coarse, first, pressure(u1, u0));
    let change = difference(fine, coarse, pressure(u2, u1));
    let size = fine.size();
    let state = &fine.state;
    let carried = state.force.abs() + state.moment.abs();
    let of = |part: fn(&Change) -> f64, size: f64| {
        let (one, two) = (part(&before), part(&change));
        // What is prescribed does not change at all.
        let is_given = one == 0.0 && two == 0.0;
        if is_given { 0.0 } else { left(one, two).max(ROUNDING * size) }
    };
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure: left(before.pressure, change.pressure).max(ROUNDING * size),
        settlement: of(|c| c.settlement, size),
        tilt: of(|c| c.tilt, size),
        force: of(|c| c.force, carried),
        moment: of(|c| c.moment, carried),
    };
    // By rounding an edge is off as the pressure over its slope.
    let rounding = ROUNDING * size / fine.gentlest();
    (accuracy, left(before.edge, change.edge).max(rounding).max(ROUNDING))
}

/// What the finest level is off, by the differences between the three: less than the last of them, and more than if the next were smaller in the same ratio.
/// The first difference is that of what is smooth, the last that of the ends of zones.
fn left(before: f64, change: f64) -> f64 {
    let rate = change / before;
    if rate <= SLOW { change * rate.sqrt().max(FASTEST) } else { change.max(before) }
}

/// The pressure with the profile taken out.
fn displaced(level: &Level, xi: f64) -> f64 {
    level.pressure_at(xi, 0.0)
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
    fn what_is_left_lies_between_the_last_difference_and_the_next() {
        assert!((left(1e-4, 4e-6) / 8e-7 - 1.0).abs() < 1e-12);
        assert!((left(1e-4, 1e-8) / 1.25e-9 - 1.0).abs() < 1e-12);
        assert_eq!(left(1e-8, 2e-8), 2e-8);
        assert_eq!(left(1e-8, 0.9e-8), 1e-8);
        assert_eq!(left(1e-8, 0.0), 0.0);
    }
}
