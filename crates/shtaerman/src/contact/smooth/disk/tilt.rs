//! The tilt of a disk of contact: another harmonic of the pressure, which must not lift it off.

use super::super::check::looked_at;
use super::super::pressure::{Pressure, place};
use super::Disk;
use super::core::Core;
use super::solved::Solved;
use crate::Error;
use crate::contact::check::POINTS;
use crate::contact::search::ALLOWED;
use crate::extremes::Sampled;

/// Refuses a tilt that lifts the disk off on one side.
pub(super) fn require_contact(disk: &Disk, solved: &Solved) -> Result<(), Error> {
    let Some(core) = solved.core.as_ref().filter(|core| core.tilt != 0.0) else { return Ok(()) };
    let is_unilateral = disk.base.setting.is_unilateral();
    let limit = if core.is_free { 0.0 } else { largest_share(disk, solved, core) };
    if !is_unilateral || limit >= 1.0 - ALLOWED {
        return Ok(());
    }
    let (field, value) = disk.base.setting.problem().load().rotational.named();
    Err(Error::LiftsOff { field, value, limit: limit * value.abs() })
}

/// How much of the tilt keeps the contact as it is.
fn largest_share(disk: &Disk, solved: &Solved, core: &Core) -> f64 {
    let zone = solved.zones[0];
    let at = |r: f64| {
        let place = place(&zone, r);
        solved.at(0, place) / core.turned(place.from_right).abs()
    };
    let beside = |r: f64| {
        let gap = solved.outside(r) + disk.base.height(r) - solved.state().settlement;
        gap / (core.tilt.abs() * r * (1.0 - core.share_of_tilt(r)))
    };
    let least = |ends: [f64; 2], share: &dyn Fn(f64) -> f64| {
        let places = looked_at(&disk.base, ends, 2 * POINTS);
        let places = places[1..places.len() - 1].to_vec();
        let values = places.iter().map(|r| -share(*r)).collect();
        -Sampled::new(|r| -share(r), places, values).maximum().value
    };
    let c = core.radius;
    let corner = core.corner / (core.tilt_density().abs() * c);
    let mut limit = corner.min(least([0.0, c], &at));
    if c < 1.0 {
        limit = limit.min(least([c, 1.0], &beside));
    }
    limit.max(0.0)
}
