//! The edges of the contact to full precision.

use super::base::Base;
use super::damping::{Damping, Edge};
use super::mirror::mirror;
use super::motion::are_many;
use super::solved::Solved;
use super::system::Resolution;
use super::zones::{End, Zone};
use crate::Error;

/// Most Newton steps on the way to the edges.
const STEPS: usize = 60;
/// A step that makes the ends so much worse is halved, this often.
const WORSE: f64 = 2.0;
const CUTS: usize = 12;
/// A pressure at a free edge below this share of the largest is as good as none, if it does not fall any more.
const SMALL: f64 = 1e-9;
/// Share of a zone, or of a gap, that an edge may cross in one step.
const STRIDE: f64 = 0.4;
/// Zones shorter than this share of the longest are none.
const VANISHING: f64 = 1e-9;
/// Ends this close to a wall, and inside of it, are there.
const BESIDE: f64 = 1e-11;
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
    rest(base, &mut zones);
    if base.is_mirrored {
        mirror(&mut zones);
    }
    if base.is_bilateral {
        let (solved, _) = Solved::new(base, resolution, &zones, false, None)?;
        return Ok((solved, 1));
    }
    let mut best: Option<(f64, Solved)> = None;
    let mut latest: Option<Solved> = None;
    let mut step: Option<Step> = None;
    let mut damping = Damping::default();
    for iterations in 1..=STEPS {
        // After a small step the next is hardly ever wanted, but single steps cost nothing.
        let wants_steps = best.is_none() || are_many(&zones);
        let (mut solved, mut steps) =
            Solved::new(base, resolution, &zones, wants_steps, latest.as_ref())?;
        let vanished: Vec<bool> = (0..zones.len())
            .map(|zone| zones.len() > 1 && solved.zone_force(zone) <= 0.0)
            .collect();
        if vanished.contains(&true) && vanished.contains(&false) {
            let mut vanished = vanished.into_iter();
            zones.retain(|_| !vanished.next().unwrap_or(false));
            (best, step) = (None, None);
            continue;
        }
        let excess = excess(&zones, &solved);
        if let Some(Step { from, steps, before, cuts }) = &mut step
            && excess > WORSE * *before
            && *cuts < CUTS
        {
            // Beyond a bend of the base the slope at the edge says nothing.
            *cuts += 1;
            steps.iter_mut().for_each(|step| *step *= 0.5);
            zones = moved(base, from, steps);
            continue;
        }
        let floor = solved.rounding();
        let released = release(base, &mut zones, &solved, floor);
        let worst = worst_layer(&zones, &solved);
        if worst <= 0.5 * floor && !released {
            return Ok((solved, iterations));
        }
        let small = worst <= SMALL * solved.deepest() + floor;
        if let Some((before, known)) = best.take()
            && small
            && !released
            && (before <= 2.0 * worst || worst <= floor)
        {
            return Ok((if before <= worst { known } else { solved }, iterations));
        }
        if released || !wants_steps {
            (solved, steps) = Solved::new(base, resolution, &zones, true, Some(&solved))?;
        }
        let still = steps
            .iter()
            .zip(zones.iter().flat_map(|zone| [zone.length(); 2]))
            .all(|(step, length)| step.abs() <= 0.5 * f64::EPSILON * length);
        if still {
            return Ok((solved, iterations));
        }
        let steps = damping.damped(steps, &places(&zones, &solved));
        let from = std::mem::take(&mut zones);
        zones = moved(base, &from, &steps);
        step = Some(Step { from, steps, before: excess, cuts: 0 });
        if !base.layer.is_linear() {
            latest = Some(solved.clone());
        }
        best = small.then_some((worst, solved));
    }
    let (solved, _) = Solved::new(base, resolution, &zones, false, latest.as_ref())?;
    Ok((solved, STEPS))
}

/// The ends of the zones as damping sees them.
fn places(zones: &[Zone], solved: &Solved) -> Vec<Edge> {
    (zones.iter().enumerate())
        .flat_map(|(zone, place)| {
            [(0, -1.0), (1, 1.0)].map(|(side, outwards)| {
                let layer = solved.end_layer(zone, side);
                Edge { at: place.ends[side].at, outwards, layer }
            })
        })
        .collect()
}

/// A step that was taken, in case it must be cut.
struct Step {
    from: Vec<Zone>,
    steps: Vec<f64>,
    /// What the ends lacked before it.
    before: f64,
    cuts: usize,
}

/// Largest displacement of the layer at a free edge, of either sign, or tension at a wall.
fn excess(zones: &[Zone], solved: &Solved) -> f64 {
    (zones.iter().enumerate())
        .flat_map(|(zone, place)| [(zone, 0, place.ends[0]), (zone, 1, place.ends[1])])
        .map(|(zone, side, end)| {
            let v = solved.end_layer(zone, side);
            if end.is_free { v.abs() } else { (-v).max(0.0) }
        })
        .fold(0.0, f64::max)
}

/// Walls, steps of the base too, hold the contact until they pull: where the pressure rises towards one a free end would be led away from it. The axis of a circular punch always holds.
fn rest(base: &Base<'_>, zones: &mut [Zone]) {
    for zone in zones {
        for (side, end) in zone.ends.iter_mut().enumerate() {
            // The check looks just inside a wall.
            if let Some(wall) = base.wall_near(side, end.at, BESIDE) {
                *end = End { at: wall, is_free: false };
            } else {
                end.is_free |= end.at.abs() >= 1.0;
            }
        }
    }
}

/// Ends at walls that pull become free; whether there were any.
fn release(base: &Base<'_>, zones: &mut [Zone], solved: &Solved, floor: f64) -> bool {
    let mut released = false;
    for (zone, place) in zones.iter_mut().enumerate() {
        for (side, end) in place.ends.iter_mut().enumerate() {
            if !end.is_free && !base.is_axis(end.at) && solved.end_layer(zone, side) < -floor {
                end.is_free = true;
                released = true;
            }
        }
    }
    released
}

/// Largest displacement of the layer at a free edge, of either sign.
fn worst_layer(zones: &[Zone], solved: &Solved) -> f64 {
    (zones.iter().enumerate())
        .flat_map(|(zone, place)| [(zone, 0, place.ends[0]), (zone, 1, place.ends[1])])
        .filter(|(_, _, end)| end.is_free)
        .fold(0.0, |most, (zone, side, _)| most.max(solved.end_layer(zone, side).abs()))
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
            let room = neighbour.map_or(f64::INFINITY, |gap| 0.5 * gap);
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
                if (zone.ends[0].is_free || last.ends[1].is_free)
                    && zone.left() - last.right() <= CLOSE * zone.length().min(last.length()) =>
            {
                last.ends[1] = zone.ends[1];
            }
            _ => moved.push(zone),
        }
    }
    if base.is_mirrored {
        mirror(&mut moved);
    }
    // A zone that goes on shrinking beside others is about to vanish.
    let longest = moved.iter().fold(0.0f64, |most, zone| most.max(zone.length()));
    moved.retain(|zone| zone.length() > VANISHING * longest);
    moved
}
