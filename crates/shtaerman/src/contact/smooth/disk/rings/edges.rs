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
use crate::contact::smooth::zones::Zone;

/// Most Newton steps on the way to the edges.
const STEPS: usize = 120;
/// A density at a free edge below this share of the largest is as good as none, if it does not fall any more.
const SMALL: f64 = 1e-8;
/// Share of a zone, or of a gap, that an edge may cross in one step.
const STRIDE: f64 = 0.4;
/// Zones shorter than this share of the longest are none, and so is a hole at the axis.
const VANISHING: f64 = 1e-9;
/// Zones closer than this share of the shorter one are one.
const CLOSE: f64 = 1e-5;
/// Angles at which the slope of the density is taken.
const BESIDE: f64 = 0.06;
/// The same as share of the angle up to a bend of the base, and at least.
const SHARE: f64 = 0.1;
const NEAREST: f64 = 1e-4;

/// Moves the free edges until the intensity vanishes there. Zones that carry nothing disappear, those that meet become one, a ring whose hole closes becomes
/// a disk, edges that come to a wall stay there and leave it again if it pulls.
pub(super) fn settle(base: &Base<'_>, start: &[Zone], detail: Detail) -> Result<Solved, Error> {
    let mut zones = start.to_vec();
    let mut best: Option<(f64, Solved)> = None;
    for _ in 0..STEPS {
        let solved = Solved::new(base, &zones, detail)?;
        if drop_idle(&mut zones, &solved) {
            best = None;
            continue;
        }
        let released = release(&mut zones, &solved);
        let worst = worst_density(&solved, &zones);
        let is_small = worst <= SMALL && !released;
        if is_small && let Some((before, known)) = best.take() {
            if worst >= 0.5 * before {
                return Ok(if before <= worst { known } else { solved });
            }
        } else if worst == 0.0 && !released {
            return Ok(solved);
        }
        zones = moved(base, &solved, &zones);
        best = is_small.then_some((worst, solved));
    }
    match best {
        Some((_, solved)) => Ok(solved),
        None => Solved::new(base, &zones, detail),
    }
}

/// Drops zones without force, if there are others; whether there were any.
fn drop_idle(zones: &mut Vec<Zone>, solved: &Solved) -> bool {
    let carries: Vec<bool> = (0..zones.len()).map(|j| solved.force(j) > 0.0).collect();
    let drops = carries.contains(&true) && carries.contains(&false);
    if drops {
        let mut carries = carries.into_iter();
        zones.retain(|_| carries.next().unwrap_or(true));
    }
    drops
}

/// What the density at edges is held against.
pub(super) fn scale(solved: &Solved) -> f64 {
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

/// Edges at walls that pull become free; whether there were any.
fn release(zones: &mut [Zone], solved: &Solved) -> bool {
    let mut released = false;
    let least = f64::EPSILON * scale(solved);
    for (j, zone) in zones.iter_mut().enumerate() {
        let floor = rounding(solved, j) + least;
        for side in 0..2 {
            if !zone.is_free[side] && density(solved, j, side) < -floor {
                zone.is_free[side] = true;
                released = true;
            }
        }
    }
    released
}

/// Largest density at a free edge over the scale.
fn worst_density(solved: &Solved, zones: &[Zone]) -> f64 {
    let scale = scale(solved);
    let ends = zones
        .iter()
        .enumerate()
        .flat_map(|(j, zone)| (0..2).filter(|&side| zone.is_free[side]).map(move |side| (j, side)));
    ends.map(|(j, side)| density(solved, j, side).abs() / scale).fold(0.0, f64::max)
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
    let at = |offset: f64| part.density(if side == 0 { PI - offset } else { offset });
    let end = at(0.0);
    // A bend of the base is none of the edge.
    let beside = BESIDE.min(SHARE * part.straight(side)).max(NEAREST);
    let one = (at(beside) - end) / (beside * beside);
    let two = (at(2.0 * beside) - end) / (4.0 * beside * beside);
    // cos is 1 - phi^2/2
    -2.0 * (4.0 * one - two) / 3.0
}

/// Where an edge of a zone is to go, between neighbours.
fn target(solved: &Solved, zone: usize, side: usize, gap: Option<[f64; 2]>) -> f64 {
    let step = |density: f64, slope: f64| {
        let step = -density / slope;
        if slope < 0.0 && step.is_finite() { step } else { STRIDE.copysign(density) }
    };
    match (solved.ring(zone), &solved.core) {
        (Some(part), _) => {
            let ring = part.ring();
            let length = 2.0 * ring.half;
            let wanted = length * step(part.end_density(side), slope(part, side));
            let room = gap.map_or(f64::INFINITY, |[from, to]| 0.5 * distance(from, to - from));
            let limited = wanted.clamp(-STRIDE * length, room.min(length));
            ring.zone.ends[side] * if side == 0 { -limited } else { limited }.exp()
        }
        (None, Some(core)) => {
            let wanted = core.radius * step(core.corner, core.slope * core.radius);
            let room = gap.map_or(f64::INFINITY, |[from, to]| 0.5 * (to - from));
            core.radius + wanted.clamp(-STRIDE * core.radius, room.min(core.radius))
        }
        (None, None) => solved.zones[zone].ends[side],
    }
}

/// The zones after steps that neither empty a zone nor jump over a gap.
fn moved(base: &Base<'_>, solved: &Solved, zones: &[Zone]) -> Vec<Zone> {
    let mut next: Vec<Zone> = Vec::with_capacity(zones.len());
    for (j, zone) in zones.iter().enumerate() {
        let mut moved = *zone;
        for side in (0..2).filter(|&side| zone.is_free[side]) {
            let gap = match side {
                0 => j.checked_sub(1).map(|before| [zones[before].right(), zone.left()]),
                _ => zones.get(j + 1).map(|after| [zone.right(), after.left()]),
            };
            let to = target(solved, j, side, gap);
            let wall = base.wall(side, 0.5 * (zone.left() + zone.right()));
            let beyond = if side == 0 { to <= wall } else { to >= wall };
            moved.ends[side] = if beyond { wall } else { to };
            moved.is_free[side] = !beyond;
        }
        if moved.left() < VANISHING * moved.right() {
            (moved.ends[0], moved.is_free[0]) = (0.0, false);
        }
        match next.last_mut() {
            Some(last)
                if moved.left() - last.right() <= CLOSE * moved.length().min(last.length())
                    && (last.is_free[1] && moved.is_free[0]) =>
            {
                last.ends[1] = moved.ends[1];
                last.is_free[1] = moved.is_free[1];
            }
            _ => next.push(moved),
        }
    }
    // A zone that goes on shrinking beside others is about to vanish.
    let longest = next.iter().fold(0.0f64, |most, zone| most.max(zone.length()));
    next.retain(|zone| zone.length() > VANISHING * longest);
    next
}
