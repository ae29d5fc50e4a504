//! The free edges of disk and rings, where the corner intensity vanishes.
//!
//! As in plane contact (see [`edges`](crate::contact::smooth::edges)) each intensity depends on its own edge only where all of them vanish, to first order as the slope
//! of the density there says: Newton's method takes each edge by itself.

use std::f64::consts::PI;

use super::base::Base;
use super::ring::distance;
use super::system::{Part, Solved};
use crate::Error;
use crate::contact::smooth::Detail;
use crate::contact::smooth::free_ends::{self, FreeEnds, STRIDE, VANISHING, step};
use crate::contact::smooth::zones::Zone;

/// Angles at which the slope of the density is taken.
const BESIDE: f64 = 0.06;
/// The same as share of the angle up to a bend of the base, and at least.
const SHARE: f64 = 0.1;
const NEAREST: f64 = 1e-4;

impl FreeEnds for Solved {
    fn modes(&self) -> usize {
        self.modes()
    }

    fn carried(&self, zone: usize) -> f64 {
        self.force(zone)
    }

    fn density_at(&self, zone: usize, side: usize) -> f64 {
        density(self, zone, side)
    }

    fn floor(&self, zone: usize) -> f64 {
        rounding(self, zone)
    }

    fn scale(&self) -> f64 {
        scale(self)
    }

    fn none(&self) -> f64 {
        0.0
    }
}

/// Moves the free edges until the intensity vanishes there; a ring whose hole closes becomes a disk.
pub(super) fn settle(base: &Base<'_>, start: &[Zone], detail: Detail) -> Result<Solved, Error> {
    let solve = |zones: &[Zone]| Solved::new(base, zones, detail);
    free_ends::settle(start, &base.work, solve, |solved, zones| moved(base, solved, zones))
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
    (0..2).filter(|&side| solved.zones[zone].is_free[side]).fold(0.0, |most: f64, side| {
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
    free_ends::slope(|offset| part.density(if side == 0 { PI - offset } else { offset }), beside)
}

/// A step outwards that neither empties a zone of this length nor crosses the gap beside it; beside a narrow gap densities change within it.
fn within(wanted: f64, length: f64, gap: f64) -> f64 {
    wanted.clamp(-STRIDE * length.min(gap), (0.5 * gap).min(length))
}

/// Where an edge of a zone is to go, between neighbours.
fn target(solved: &Solved, zone: usize, side: usize, gap: Option<[f64; 2]>) -> f64 {
    match (solved.ring(zone), &solved.core) {
        (Some(part), _) => {
            let ring = part.ring();
            let length = 2.0 * ring.half;
            let wanted = length * step(part.end_density(side), slope(part, side));
            let gap = gap.map_or(f64::INFINITY, |[from, to]| distance(from, to - from));
            let limited = within(wanted, length, gap);
            ring.zone.ends[side] * if side == 0 { -limited } else { limited }.exp()
        }
        (None, Some(core)) => {
            let wanted = core.radius * step(core.corner, core.slope * core.radius);
            let gap = gap.map_or(f64::INFINITY, |[from, to]| to - from);
            core.radius + within(wanted, core.radius, gap)
        }
        (None, None) => solved.zones[zone].ends[side],
    }
}

/// The zones after steps that neither empty a zone nor jump over a gap.
fn moved(base: &Base<'_>, solved: &Solved, zones: &[Zone]) -> Vec<Zone> {
    let target = |j: usize, side: usize, gap| target(solved, j, side, gap);
    let without_hole = |zone: &mut Zone| {
        if zone.left() < VANISHING * zone.right() {
            (zone.ends[0], zone.is_free[0]) = (0.0, false);
        }
    };
    free_ends::moved(zones, |side, inside| base.wall(side, inside), target, without_hole)
}
