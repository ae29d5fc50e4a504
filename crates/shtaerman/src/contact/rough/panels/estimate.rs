//! The error of the answer, from three finenesses.

use super::level::Level;
use crate::contact::accuracy::{Accuracy, ROUNDING, Sizes};
use crate::contact::parts::Smoothness;
use crate::contact::resolutions::{Change, Trust, UNKNOWN};
use crate::contact::rough::base::Base;
use crate::contact::zones::Zone;

/// Places on each panel where levels are compared. At half or twice 27 of 32 answers change, within what they state (survey).
const PLACES: [f64; 2] = [0.11, 0.63];

/// The error of the last level, and that of its edges.
pub(super) fn estimate(base: &Base<'_>, levels: &[Level; 3]) -> (Accuracy, f64) {
    let [first, coarse, fine] = levels;
    let bounds = fine.bounds();
    let places: Vec<f64> = (bounds.iter())
        .flat_map(|[left, right]| PLACES.map(|share| left + share * (right - left)))
        .collect();
    let displaced = |level: &Level| -> Vec<f64> {
        places.iter().map(|xi| displaced(base, level, *xi)).collect()
    };
    let [one, two, three] = levels.each_ref().map(displaced);
    let change = |levels: [&Level; 2], [one, other]: [&[f64]; 2]| {
        let differences = one.iter().zip(other).map(|(a, b)| (a - b).abs());
        let pressure = differences.fold(0.0, f64::max);
        Change::between(levels.map(|level| (&level.state, &level.zones[..])), pressure)
    };
    let changes = [&change([coarse, first], [&two, &one]), &change([fine, coarse], [&three, &two])];
    let (size, state) = (fine.size(), &fine.state);
    // What is added up in the displacements, and in force and moment.
    let sizes = Sizes { displacement: size, ..state.sizes(fine.highest()) };
    let length = fine.zones.iter().map(Zone::length).sum();
    let (accuracy, edge) = Trust::plain().accuracy(base.load, changes, &sizes, length);
    let firmest = fine.layer.slope(fine.largest());
    let pressure = accuracy.pressure.max(ROUNDING * size * firmest) + at_corners(base, fine);
    let accuracy = Accuracy { pressure, ..accuracy };
    let is_unknown = base.smoothness == Smoothness::Unknown;
    let sizes = state.sizes(fine.highest());
    let accuracy = if is_unknown { accuracy.of_the_unknown(UNKNOWN, &sizes) } else { accuracy };
    // By rounding an edge is off as the pressure over its slope.
    (accuracy, edge.max(ROUNDING * size / fine.gentlest()))
}

/// What the panels at corners miss. There the pressure goes on as a power of the distance of its own size, which no polynomial shows; at all finenesses they may be as short as numbers allow,
/// so that no difference tells. The pressure changes by `V` on such a panel because the potential of a pressure `p` does by `V`: that of what is missed, `s V`, changes by `s V^2/p` at most. Of a power
/// `d^nu` polynomials of the degree `n` miss `s = n^(-2 nu)`, some.
fn at_corners(base: &Base<'_>, level: &Level) -> f64 {
    let bounds = level.bounds();
    let order = level.pressures.len() as f64 / bounds.len() as f64;
    let share = order.powf(-2.0 * (1.0 - base.ground.exponent()));
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
