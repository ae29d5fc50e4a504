//! The edges of the contact to full precision.

use super::base::Base;
use super::damping::Damping;
use super::system::{Resolution, Solved};
use super::zones::{End, Zone};
use crate::Error;

/// Most Newton steps on the way to the edges.
const STEPS: usize = 40;
/// A pressure at a free edge below this share of the largest is as good as none, if it does not fall any more.
const SMALL: f64 = 1e-9;
/// Share of a zone that an edge may cross in one step.
const STRIDE: f64 = 0.4;
/// Share of a gap that each of its edges may cross: a step too far must leave something to come back to.
const APPROACH: f64 = 0.45;
/// Zones shorter than this share of the longest are none.
const VANISHING: f64 = 1e-9;
/// Zones closer than this share of the shorter one are one.
const CLOSE: f64 = 1e-7;

/// Moves the free edges until the pressure vanishes there. Zones that carry nothing disappear, those that meet become one, edges that come to
/// a wall stay there and leave it again if it pulls.
pub(super) fn settle(
    base: &Base<'_>,
    resolution: &Resolution,
    start: &[Zone],
) -> Result<(Solved, usize), Error> {
    let mut zones = start.to_vec();
    let mut best: Option<(f64, Solved)> = None;
    let mut damping = Damping::default();
    for iterations in 1..=STEPS {
        let (mut solved, mut steps) = Solved::new(base, resolution, &zones, true)?;
        let vanished: Vec<bool> = (0..zones.len())
            .map(|zone| zones.len() > 1 && solved.zone_force(zone) <= 0.0)
            .collect();
        if vanished.contains(&true) && vanished.contains(&false) {
            let mut vanished = vanished.into_iter();
            zones.retain(|_| !vanished.next().unwrap_or(false));
            best = None;
            continue;
        }
        let floor = solved.rounding();
        let released = release(&mut zones, &solved, floor);
        let worst = worst_pressure(&zones, &solved);
        if worst <= 0.5 * floor && !released {
            return Ok((solved, iterations));
        }
        let small = worst <= SMALL * solved.largest() + floor;
        if let Some((before, known)) = best.take()
            && small
            && !released
            && before <= 2.0 * worst
        {
            return Ok((if before <= worst { known } else { solved }, iterations));
        }
        if released {
            (solved, steps) = Solved::new(base, resolution, &zones, true)?;
        }
        let still = steps
            .iter()
            .zip(zones.iter().flat_map(|zone| [zone.length(); 2]))
            .all(|(step, length)| step.abs() <= 0.5 * f64::EPSILON * length);
        if still {
            return Ok((solved, iterations));
        }
        zones = moved(base, &zones, &damping.damped(steps));
        best = small.then_some((worst, solved));
    }
    let (solved, _) = Solved::new(base, resolution, &zones, false)?;
    Ok((solved, STEPS))
}

/// Ends at walls that pull become free; whether there were any.
fn release(zones: &mut [Zone], solved: &Solved, floor: f64) -> bool {
    let mut released = false;
    for (zone, place) in zones.iter_mut().enumerate() {
        for (side, end) in place.ends.iter_mut().enumerate() {
            if !end.is_free && solved.end_pressure(zone, side) < -floor {
                end.is_free = true;
                released = true;
            }
        }
    }
    released
}

/// Largest `|p0|` at a free edge.
fn worst_pressure(zones: &[Zone], solved: &Solved) -> f64 {
    (zones.iter().enumerate())
        .flat_map(|(zone, place)| [(zone, 0, place.ends[0]), (zone, 1, place.ends[1])])
        .filter(|(_, _, end)| end.is_free)
        .fold(0.0, |most, (zone, side, _)| most.max(solved.end_pressure(zone, side).abs()))
}

/// The zones after steps that neither empty a zone nor jump over a gap.
fn moved(base: &Base<'_>, zones: &[Zone], steps: &[f64]) -> Vec<Zone> {
    let mut ends: Vec<End> = Vec::with_capacity(2 * zones.len());
    for (k, zone) in zones.iter().enumerate() {
        let length = zone.length();
        for side in 0..2 {
            let End { at, is_free } = zone.ends[side];
            if !is_free {
                ends.push(zone.ends[side]);
                continue;
            }
            let wall = base.wall(side, 0.5 * (zone.left() + zone.right()));
            let neighbour = match side {
                0 => k.checked_sub(1).map(|before| at - zones[before].right()),
                _ => zones.get(k + 1).map(|next| next.left() - at),
            };
            let room = neighbour.map_or(f64::INFINITY, |gap| APPROACH * gap);
            let outward = if side == 0 { -steps[2 * k] } else { steps[2 * k + 1] };
            let outward = outward.clamp(-STRIDE * length, room.min(length.max(1e-3)));
            let to = if side == 0 { at - outward } else { at + outward };
            let beyond = if side == 0 { to <= wall } else { to >= wall };
            ends.push(if beyond {
                End { at: wall, is_free: false }
            } else {
                End { at: to, is_free }
            });
        }
    }
    let mut moved: Vec<Zone> = Vec::with_capacity(zones.len());
    for pair in ends.chunks_exact(2) {
        let zone = Zone { ends: [pair[0], pair[1]] };
        match moved.last_mut() {
            Some(last)
                if zone.left() - last.right() <= CLOSE * zone.length().min(last.length()) =>
            {
                last.ends[1] = zone.ends[1];
            }
            _ => moved.push(zone),
        }
    }
    // A zone that goes on shrinking beside others is about to vanish.
    let longest = moved.iter().fold(0.0f64, |most, zone| most.max(zone.length()));
    moved.retain(|zone| zone.length() > VANISHING * longest);
    moved
}
