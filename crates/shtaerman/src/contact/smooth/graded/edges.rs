//! The free ends of a zone, where the corner intensity vanishes.
//!
//! An end that lies inside by `e` has the density `G' e`, `G'` the slope of the transform there, as the pressure beyond is `d^(1-beta)` moved by `e`: so each end has its own
//! Newton step, exact to first order where the densities vanish.

use super::strip::{Ground, Halves, Strip};
use crate::Error;
use crate::contact::smooth::problem::Base;
use crate::contact::smooth::zones::Zone;

/// Most Newton steps.
const STEPS: usize = 160;
/// A density below this share of what is added up is as good as none, if it does not fall any more.
const SMALL: f64 = 1e-9;
/// Share of the zone that an edge may cross in one step inwards.
const STRIDE: f64 = 0.4;
/// Share of the half-width over which slopes are taken.
const BESIDE: f64 = 1e-3;
/// Rounding of a density.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A zone with what its pressure is made of.
pub(super) struct Settled {
    pub(super) strip: Strip,
    pub(super) halves: Halves,
}

/// A zone that stays as it is.
pub(super) fn fixed(base: &Base<'_>, ground: &Ground, zone: &Zone) -> Result<Settled, Error> {
    let halves = Halves::new(base, zone);
    let strip = Strip::new(base, ground, *zone, &halves);
    require_finite(&strip)?;
    Ok(Settled { strip, halves })
}

fn require_finite(strip: &Strip) -> Result<(), Error> {
    let densities = [strip.end_density(0), strip.end_density(1), strip.depth, strip.state.tilt];
    if densities.iter().all(|value| value.is_finite()) {
        return Ok(());
    }
    let (parameter, smallest) = (strip.half(), 0.0);
    Err(Error::Equation(fredholm::Error::Singular { parameter, smallest }))
}

/// Moves the free ends until the intensity vanishes there; ends that come to a wall stay there and leave it again if it pulls.
pub(super) fn settle(
    base: &Base<'_>,
    ground: &Ground,
    mut zone: Zone,
) -> Result<(Zone, Settled), Error> {
    let mut best: Option<(f64, Zone, Settled)> = None;
    for _ in 0..STEPS {
        let settled = fixed(base, ground, &zone)?;
        let strip = &settled.strip;
        let scale = strip.density_scale();
        let released = release(&mut zone, strip);
        let free = (0..2).filter(|&side| zone.is_free[side]);
        let worst = free.fold(0.0f64, |most, side| most.max(strip.end_density(side).abs()));
        let is_small = worst <= SMALL * scale && !released;
        if worst == 0.0 && !released {
            return Ok((zone, settled));
        }
        if let Some((before, ..)) = best.as_ref().filter(|_| is_small)
            && worst >= 0.5 * before
        {
            break;
        }
        let next = moved(base, ground, &zone, &settled);
        if is_small {
            best = Some((worst, zone, settled));
        } else {
            best = None;
        }
        zone = next;
    }
    match best {
        Some((_, zone, settled)) => Ok((zone, settled)),
        None => Err(Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN }),
    }
}

/// Ends at walls that pull become free; whether there were any.
fn release(zone: &mut Zone, strip: &Strip) -> bool {
    let floor = ROUNDING * strip.density_scale();
    let mut released = false;
    for side in 0..2 {
        if !zone.is_free[side] && strip.end_density(side) < -floor {
            zone.is_free[side] = true;
            released = true;
        }
    }
    released
}

/// `G_e' +- (x G_o)'` at the left (0) or right (1) end, from inside, and what the other end's density adds: by how much the density falls when the end moves outwards.
pub(super) fn slope(ground: &Ground, settled: &Settled, side: usize) -> f64 {
    let (even, odd) = (settled.halves.even(ground), settled.halves.odd(ground));
    let b = settled.strip.half();
    let at = |steps: f64| {
        let x = b * (1.0 - BESIDE * steps);
        let arm = if side == 0 { -x } else { x };
        even.transform(x) + arm * odd.transform(x)
    };
    let own = (3.0 * at(0.0) - 4.0 * at(1.0) + at(2.0)) / (2.0 * BESIDE * b);
    let other = settled.strip.end_density(1 - side) - settled.strip.end_density(side);
    own + (1.0 - ground.powers.corner_exponent()) * other / (2.0 * b)
}

/// The zone after a step that neither empties it nor passes a wall.
fn moved(base: &Base<'_>, ground: &Ground, zone: &Zone, settled: &Settled) -> Zone {
    let mut target = *zone;
    let length = zone.length();
    let middle = 0.5 * (zone.left() + zone.right());
    for side in (0..2).filter(|&side| zone.is_free[side]) {
        let density = settled.strip.end_density(side);
        let slope = slope(ground, settled, side);
        let step = density / slope;
        let outward = if slope > 0.0 && step.is_finite() {
            step.clamp(-STRIDE * length, length)
        } else {
            (STRIDE * length).copysign(density)
        };
        let at = zone.ends[side];
        let to = if side == 0 { at - outward } else { at + outward };
        let wall = base.wall(side, middle);
        let beyond = if side == 0 { to <= wall } else { to >= wall };
        target.ends[side] = if beyond { wall } else { to };
        target.is_free[side] = !beyond;
    }
    target
}
