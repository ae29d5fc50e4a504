//! The free edges of disk and rings, where the corner intensity vanishes.
//!
//! As in plane contact (see [`edges`](crate::contact::smooth::edges)) each intensity depends on its own edge only where all of them vanish, to first order as the slope
//! of the density there says: Newton's method takes each edge by itself.

use std::f64::consts::PI;

use super::system::{Part, Solved};
use crate::contact::edges::EndState;
use crate::contact::smooth::edges::{BESIDE, even_slope};

/// The angle at which the slope of the density is taken, as share of that up to a bend of the base, and at least. At half or twice 1 of 10 answers change, within what they state (survey).
const SHARE: f64 = 0.1;
const NEAREST: f64 = 1e-4;

/// What is known at the ends of all zones.
pub(super) fn ends(solved: &Solved) -> Vec<[EndState; 2]> {
    let scale = scale(solved);
    let end = |zone: usize, side: usize| {
        let value = density(solved, zone, side);
        let rounding = rounding(solved, zone) + f64::EPSILON * scale;
        EndState {
            value,
            rounding,
            scale,
            none: 0.0,
            enough: 0.0,
            step: outwards(solved, zone, side),
        }
    };
    (0..solved.zones.len()).map(|zone| [end(zone, 0), end(zone, 1)]).collect()
}

/// Newton's step outwards, on a ring in the logarithm of the radius.
fn outwards(solved: &Solved, zone: usize, side: usize) -> f64 {
    match (solved.ring(zone), &solved.core) {
        (Some(part), _) => {
            let ring = part.ring();
            let step = -2.0 * ring.half * part.end_density(side) / slope(part, side);
            let sign = if side == 0 { -1.0 } else { 1.0 };
            sign * ring.zone.ends[side] * (sign * step).exp_m1()
        }
        (None, Some(core)) => -core.corner / core.slope,
        (None, None) => 0.0,
    }
}

/// What the density at edges is held against.
fn scale(solved: &Solved) -> f64 {
    let ring = |part: &Part| part.smooth.iter().map(|s| s.abs()).fold(0.0, f64::max);
    let rings = solved.parts.iter().map(ring).fold(f64::MIN_POSITIVE, f64::max);
    solved
        .core
        .as_ref()
        .map_or(rings, |core| rings.max(core.slope.abs() * core.radius).max(core.corner.abs()))
}

/// The density at an end of a zone, `G` or `d(c)`.
fn density(solved: &Solved, zone: usize, side: usize) -> f64 {
    match (solved.ring(zone), &solved.core) {
        (Some(part), _) => part.end_density(side),
        (None, Some(core)) if side == 1 => core.corner,
        _ => 0.0,
    }
}

/// Its rounding.
fn rounding(solved: &Solved, zone: usize) -> f64 {
    match (solved.ring(zone), &solved.core) {
        (Some(part), _) => part.end_rounding(),
        (None, Some(core)) => 64.0 * f64::EPSILON * core.level.abs(),
        (None, None) => 0.0,
    }
}

/// Estimated error of the free edges of a zone, in `r`, by that of the density there.
pub(super) fn end_error(solved: &Solved, zone: usize, error: f64) -> f64 {
    let error = error + rounding(solved, zone);
    solved.zones[zone].free_ends().fold(0.0, |most: f64, (side, _)| {
        let density = density(solved, zone, side).abs() + error;
        let shift = match (solved.ring(zone), &solved.core) {
            (Some(part), _) => {
                let ring = part.ring();
                density / slope(part, side) * 2.0 * ring.half * ring.zone.ends[side]
            }
            (None, Some(core)) => density / core.slope,
            (None, None) => 0.0,
        };
        most.max(shift.abs())
    })
}

/// `dG/dcos(phi)` outwards at an edge of a ring.
fn slope(part: &Part, side: usize) -> f64 {
    // A bend of the base is none of the edge.
    let beside = BESIDE.min(SHARE * part.straight(side)).max(NEAREST);
    even_slope(|offset| part.density(if side == 0 { PI - offset } else { offset }), beside)
}
