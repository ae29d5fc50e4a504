//! The free ends of zones, where the corner intensity vanishes.
//!
//! An end that lies inside by `e` has the density `G' e`, `G'` the slope of the transform there, as the pressure beyond is `d^(1-beta)` moved by `e`: so each end has its own
//! Newton step, exact to first order where the densities vanish.

use super::settled::Settled;
use super::strip::Ground;
use crate::contact::accuracy::ROUNDING;
use crate::contact::edges::EndState;

/// What is known at both ends of a zone.
pub(super) fn ends(ground: &Ground, settled: &Settled) -> [EndState; 2] {
    let (strip, slopes) = (&settled.strip, slopes(ground, settled));
    let scale = strip.density_scale();
    [0, 1].map(|side| {
        let value = strip.end_density(side);
        let (rounding, step) = (ROUNDING * scale, value / slopes[side]);
        EndState { value, rounding, scale, none: 0.0, enough: 0.0, step }
    })
}

/// By how much the densities at both ends fall when they move outwards: `G_e' +- b G_o'`, from inside, and what is added by the other end's and by other zones.
fn slopes(ground: &Ground, settled: &Settled) -> [f64; 2] {
    with_others(ground, settled, settled.parts.rises(ground, settled.strip.transforms))
}

/// The same from `G_e'` and `G_o'` at the end.
pub(super) fn with_others(ground: &Ground, settled: &Settled, [even, odd]: [f64; 2]) -> [f64; 2] {
    let Settled { strip, ripple, .. } = settled;
    let share = (1.0 - ground.powers.corner_exponent()) / (2.0 * strip.half());
    [0, 1].map(|side| {
        let sign = if side == 0 { -1.0 } else { 1.0 };
        let other = strip.end_density(1 - side) - strip.end_density(side);
        even + sign * strip.half() * odd + share * (other + 4.0 * ripple.bend(sign))
    })
}
