//! The free ends of zones, where the corner intensity vanishes.
//!
//! An end that lies inside by `e` has the density `G' e`, `G'` the slope of the transform there, as the pressure beyond is `d^(1-beta)` moved by `e`: so each end has its own
//! Newton step, exact to first order where the densities vanish.

use super::settled::{Settled, fixed};
use super::strip::Ground;
use crate::Error;
use crate::contact::smooth::edges::moved;
use crate::contact::smooth::problem::Base;
use crate::contact::smooth::zones::Zone;
use crate::contact::smooth::{COARSE, FINE};
use crate::contact::unilateral::damping::{Damping, Edge};

/// Most Newton steps.
const STEPS: usize = 160;
/// A density below this share of what is added up is as good as none, if it does not fall any more.
const SMALL: f64 = 1e-9;
/// The same from which on all digits are kept: those of the first steps are more, and the steps after it converge by squares.
const NEAR: f64 = 1e-6;
/// Share of the zone that an edge moves where no step is known.
const STRIDE: f64 = 0.4;
/// Rounding of a density.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Moves the free ends until the intensity vanishes there; ends that come to a wall stay there and leave it again if it pulls, zones without force disappear, those that meet
/// become one.
pub(super) fn settle(
    base: &Base<'_>,
    ground: &Ground,
    start: &[Zone],
) -> Result<Vec<Settled>, Error> {
    let mut zones = start.to_vec();
    let mut best: Option<(f64, Vec<Settled>)> = None;
    let mut damping = Damping::default();
    // On the way there fewer polynomials do, and what they cost grows with the cube of their number.
    let mut digits = COARSE.digits;
    for _ in 0..STEPS {
        let mut settled = fixed(base, ground, &zones, digits)?;
        if drop_idle(&mut zones, &settled) {
            best = None;
            continue;
        }
        let released = release(&mut zones, &mut settled);
        let (mut worst, mut is_small) = (0.0f64, !released);
        for Settled { strip, .. } in &settled {
            for side in (0..2).filter(|&side| strip.zone.is_free[side]) {
                let density = strip.end_density(side).abs();
                worst = worst.max(density / strip.density_scale());
                is_small &= density <= SMALL * strip.density_scale();
            }
        }
        if digits < FINE.digits {
            if worst <= NEAR && !released {
                digits = FINE.digits;
                if zones.len() > 1 {
                    continue;
                }
            }
            is_small &= digits >= FINE.digits;
        }
        if worst == 0.0 && !released {
            return Ok(settled);
        }
        if let Some((before, ..)) = best.as_ref().filter(|_| is_small)
            && worst >= 0.5 * before
        {
            break;
        }
        let (steps, edges): (Vec<f64>, Vec<Edge>) =
            settled.iter().flat_map(|settled| own_steps(ground, settled)).unzip();
        let steps = damping.damped(steps, &edges);
        zones = moved(base, &zones, |j, side| {
            let end = 2 * j + side;
            edges[end].outwards * steps[end] / settled[j].strip.zone.length()
        });
        best = is_small.then_some((worst, settled));
    }
    match best {
        Some((_, settled)) => Ok(settled),
        None => Err(Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN }),
    }
}

/// The steps of both ends to the right, with what is known there; none of an end that is not free.
fn own_steps(ground: &Ground, settled: &Settled) -> [(f64, Edge); 2] {
    let (strip, slopes) = (&settled.strip, slopes(ground, settled));
    let length = strip.zone.length();
    [(0, -1.0), (1, 1.0)].map(|(side, outwards)| {
        let (density, slope) = (strip.end_density(side), slopes[side]);
        let step = density / slope;
        let step = if !strip.zone.is_free[side] {
            0.0
        } else if slope > 0.0 && step.is_finite() {
            step.clamp(-STRIDE * length, STRIDE * length)
        } else {
            STRIDE.copysign(density) * length
        };
        let edge = Edge { at: strip.zone.ends[side], outwards, layer: density };
        (outwards * step, edge)
    })
}

/// Drops zones without force, if there are others; whether there were any.
fn drop_idle(zones: &mut Vec<Zone>, settled: &[Settled]) -> bool {
    let carrying = || settled.iter().filter(|settled| settled.strip.force > 0.0);
    let drops = carrying().count() > 0 && carrying().count() < settled.len();
    if drops {
        *zones = carrying().map(|settled| settled.strip.zone).collect();
    }
    drops
}

/// Ends at walls that pull become free; whether there were any.
fn release(zones: &mut [Zone], settled: &mut [Settled]) -> bool {
    let mut released = false;
    for (zone, Settled { strip, .. }) in zones.iter_mut().zip(settled) {
        let floor = ROUNDING * strip.density_scale();
        for side in 0..2 {
            if !zone.is_free[side] && strip.end_density(side) < -floor {
                zone.is_free[side] = true;
                released = true;
            }
        }
        strip.zone = *zone;
    }
    released
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
