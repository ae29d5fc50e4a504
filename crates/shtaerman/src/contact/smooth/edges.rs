//! The free ends of the zones, where the corner intensity vanishes.
//!
//! The pressure that an end gains when it moves is a solution without load, singular as `d^(-3/2)` with the intensity there as factor. Where the
//! intensities vanish there is none, so each depends on its own end only: `dG/d(end) = G'/(2 b)` outwards, `G'` the slope of
//! `G` over `(xi - c)/b` at the end, and Newton's method needs no more than that.

use std::f64::consts::PI;

use super::Detail;
use super::problem::Base;
use super::system::Solved;
use super::zones::Zone;
use crate::Error;

/// Most Newton steps on the way to the edges.
const STEPS: usize = 120;
/// A density at a free end below this share of the largest is as good as none, if it does not fall any more.
const SMALL: f64 = 1e-8;
/// Below this share it is none, where slopes are known: at an end the density is no better known.
const NONE: f64 = 8.0 * f64::EPSILON;
/// Share of a zone, or of a gap, that an edge may cross in one step.
const STRIDE: f64 = 0.4;
/// Zones shorter than this share of the longest are none.
const VANISHING: f64 = 1e-9;
/// Zones closer than this share of the shorter one are one.
const CLOSE: f64 = 1e-5;
/// Angles at which the slope of the density is taken.
const BESIDE: f64 = 0.06;
/// The same times the number of modes: beside a close neighbour the density changes as fast as these do.
const BESIDE_OF_MODES: f64 = 10.0;

/// Moves the free ends until the intensity vanishes there. Zones that carry nothing disappear, those that meet become one, ends that come to
/// a wall stay there and leave it again if it pulls.
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
        let none = if solved.is_sampled() { NONE } else { 0.0 };
        let is_small = worst <= SMALL && !released;
        if is_small && let Some((before, known)) = best.take() {
            if worst >= 0.5 * before || worst <= none {
                return Ok(if before <= worst { known } else { solved });
            }
        } else if worst <= none && !released {
            return Ok(solved);
        }
        zones = moved(base, &zones, |j, side| outward(&solved, j, side));
        best = is_small.then_some((worst, solved));
    }
    match best {
        Some((_, solved)) => Ok(solved),
        None => Solved::new(base, &zones, detail),
    }
}

/// Drops zones without force, if there are others; whether there were any.
fn drop_idle(zones: &mut Vec<Zone>, solved: &Solved) -> bool {
    let carries: Vec<bool> = solved.parts.iter().map(|part| part.force() > 0.0).collect();
    let drops = carries.contains(&true) && carries.contains(&false);
    if drops {
        let mut carries = carries.into_iter();
        zones.retain(|_| carries.next().unwrap_or(true));
    }
    drops
}

/// Ends at walls that pull become free; whether there were any.
fn release(zones: &mut [Zone], solved: &Solved) -> bool {
    let mut released = false;
    for (j, zone) in zones.iter_mut().enumerate() {
        let floor = solved.rounding(j) + f64::EPSILON * solved.density_scale();
        for side in 0..2 {
            if !zone.is_free[side] && solved.end_density(j, side) < -floor {
                zone.is_free[side] = true;
                released = true;
            }
        }
    }
    released
}

/// Largest `|G|` at a free end over its own zone's.
fn worst_density(solved: &Solved, zones: &[Zone]) -> f64 {
    let scale = solved.density_scale();
    let mut worst = 0.0f64;
    for (j, zone) in zones.iter().enumerate() {
        for side in (0..2).filter(|&side| zone.is_free[side]) {
            worst = worst.max(solved.end_density(j, side).abs() / scale);
        }
    }
    worst
}

/// Estimated error of the free ends of a zone, in `xi`.
pub(super) fn end_error(solved: &Solved, j: usize, density_error: f64) -> f64 {
    let zone = solved.parts[j].zone;
    (0..2).filter(|&side| zone.is_free[side]).fold(0.0, |most: f64, side| {
        let density = solved.end_density(j, side).abs() + density_error;
        most.max((density / slope(solved, j, side)).abs() * zone.length())
    })
}

/// How far an end is to move outwards, in lengths of the zone.
fn outward(solved: &Solved, j: usize, side: usize) -> f64 {
    let end = solved.end_density(j, side);
    let slope = slope(solved, j, side);
    let step = -end / slope;
    if slope < 0.0 && step.is_finite() { step } else { STRIDE.copysign(end) }
}

/// `dG/dy` outwards at an end of a zone, `y = (xi - c)/b`.
fn slope(solved: &Solved, j: usize, side: usize) -> f64 {
    let part = &solved.parts[j];
    let at = |offset: f64| part.density(if side == 0 { PI - offset } else { offset });
    let beside = BESIDE.min(BESIDE_OF_MODES / part.count() as f64);
    let end = at(0.0);
    let one = (at(beside) - end) / (beside * beside);
    let two = (at(2.0 * beside) - end) / (4.0 * beside * beside);
    // cos is 1 - phi^2/2
    -2.0 * (4.0 * one - two) / 3.0
}

/// The zones after steps that neither empty a zone nor jump over a gap; `outward` is that of a zone and side in lengths of the zone.
pub(super) fn moved(
    base: &Base<'_>,
    zones: &[Zone],
    outward: impl Fn(usize, usize) -> f64,
) -> Vec<Zone> {
    let mut next: Vec<Zone> = Vec::with_capacity(zones.len());
    for (j, zone) in zones.iter().enumerate() {
        let mut target = *zone;
        let length = zone.length();
        for side in (0..2).filter(|&side| zone.is_free[side]) {
            let at = zone.ends[side];
            let gap = match side {
                0 => j.checked_sub(1).map(|before| at - zones[before].right()),
                _ => zones.get(j + 1).map(|after| after.left() - at),
            };
            let room = gap.map_or(f64::INFINITY, |gap| 0.5 * gap);
            let step = (outward(j, side) * length).clamp(-STRIDE * length, room.min(length));
            let to = if side == 0 { at - step } else { at + step };
            let wall = base.wall(side, 0.5 * (zone.left() + zone.right()));
            let beyond = if side == 0 { to <= wall } else { to >= wall };
            target.ends[side] = if beyond { wall } else { to };
            target.is_free[side] = !beyond;
        }
        match next.last_mut() {
            Some(last)
                if target.left() - last.right() <= CLOSE * target.length().min(last.length())
                    && (last.is_free[1] && target.is_free[0]) =>
            {
                last.ends[1] = target.ends[1];
                last.is_free[1] = target.is_free[1];
            }
            _ => next.push(target),
        }
    }
    // A zone that goes on shrinking beside others is about to vanish.
    let longest = next.iter().fold(0.0f64, |most, zone| most.max(zone.length()));
    next.retain(|zone| zone.length() > VANISHING * longest);
    next
}
