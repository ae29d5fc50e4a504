//! Zones to begin with where a settlement is prescribed together with an eccentricity.
//!
//! The least such force is bracketed on few cells ([`eccentric`]); on many it follows by Newton's method with their stiffness. On panels force and tilt are unknown together.

use crate::contact::unilateral::base::Base;
use crate::contact::unilateral::eccentric;
use crate::contact::unilateral::fine;
use crate::contact::unilateral::zones::Zone;
use crate::{Error, Load, Rotational, Vertical};

/// Steps towards the force, the largest of them as a factor, and one that is small enough.
const STEPS: usize = 12;
const LARGEST: f64 = 2.0;
const SMALL: f64 = 1e-4;

/// The zones under about the least force at `e` with this settlement; none where it is not found.
pub(super) fn first_zones(
    base: &Base<'_>,
    settlement: f64,
    e: f64,
) -> Result<Option<Vec<Zone>>, Error> {
    let Some(mut force) = eccentric::least_force(base, settlement, e)? else { return Ok(None) };
    for _ in 0..STEPS {
        let load =
            Load { vertical: Vertical::Force(force), rotational: Rotational::Eccentricity(e) };
        let Some(level) = fine::first_level(&base.under(load))? else { return Ok(None) };
        let [raise, _] = level.stiffness.displaced(&load, [1.0, 0.0]);
        let wanted = force + (settlement - level.state.settlement) / raise;
        let next = wanted.clamp(force / LARGEST, force * LARGEST);
        if (next - force).abs() <= SMALL * force {
            return Ok(Some(level.zones));
        }
        force = next;
    }
    Ok(None)
}
