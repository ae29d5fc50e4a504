//! What the answer of nearly smooth contact may be wrong by: by how much two ways to the same value differ.

use super::answer::NearlySmooth;
use super::companion::Rough;
use super::fit::{Three, beside_limit};
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::solution::Solution;
use crate::{Problem, Rotational, Vertical};

/// Rounding of settlement, tilt, force, moment and pressure relative to their size.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Nodes of the second solution, where there are no companions to compare with.
const COARSE: f64 = 1.0;
/// Places of each stretch at which the pressure between the layers is compared.
const SHARES: usize = 16;
/// Coarse and fine expansions that differ by more than this share of what they add tell of companions that are not resolved.
const UNRESOLVED: f64 = 0.03;
/// How much more than at the places compared the layers may be wrong elsewhere.
const SAFETY: f64 = 2.0;

/// The errors: by another solution where nothing is expanded, else by the expansion. None where the other solution fails.
pub(super) fn stated(
    contact: &NearlySmooth,
    problem: &Problem,
    places: &[(usize, f64)],
    values: &[f64],
) -> Option<Accuracy> {
    let pressure = &contact.pressure;
    let (other, between) = match &pressure.companions.rough {
        Some(rough) => (expanded_state(contact, rough), between(contact, rough)),
        None => {
            let zones = pressure.companions.zones(&contact.zones());
            let coarse = problem.solved_on(&zones, COARSE)?;
            let state = coarse.state();
            let mut other = pressure.clone();
            other.direct = Rough { problem: problem.clone(), contact: coarse };
            let differences =
                places.iter().zip(values).map(|((zone, xi), p)| (other.at(*zone, *xi) - p).abs());
            (state, differences.fold(0.0, f64::max))
        }
    };
    let is_free = pressure.companions.is_free.as_flattened();
    let at_walls = if is_free.contains(&false) { pressure.direct.contact.rounding() } else { 0.0 };
    // Under a kink the pressure of the companions stays as it is, and so does their rounding.
    let has_kinks = pressure.companions.marks.iter().any(|marks| marks.len() > 2);
    let companions = pressure.companions.rough.as_ref().filter(|_| has_kinks);
    let at_kinks = companions.map_or(0.0, |rough| SAFETY * rough[2].contact.rounding());
    let state = contact.state();
    let error = |part: fn(&State) -> f64, scale: f64| {
        (part(&state) - part(&other)).abs() + ROUNDING * scale
    };
    let displacement = state.settlement.abs().max(state.tilt.abs());
    let carried = state.force.abs().max(state.moment.abs());
    let load = problem.load();
    let by_force = matches!(load.vertical, Vertical::Force(_));
    let by_tilt = matches!(load.rotational, Rotational::Tilt(_));
    let by_moment = match load.rotational {
        Rotational::Moment(_) => true,
        Rotational::Eccentricity(_) => by_force,
        Rotational::Tilt(_) => false,
    };
    let unless = |known: bool, error: f64| if known { 0.0 } else { error };
    Some(Accuracy {
        kind: ErrorKind::Estimate,
        pressure: between
            + SAFETY * pressure.mismatch()
            + at_walls
            + at_kinks
            + ROUNDING * contact.largest(),
        settlement: unless(!by_force, error(|state| state.settlement, displacement)),
        tilt: unless(by_tilt || problem.is_symmetric(), error(|state| state.tilt, displacement)),
        force: unless(by_force, error(|state| state.force, carried)),
        moment: unless(by_moment || problem.is_symmetric(), error(|state| state.moment, carried)),
    })
}

/// Settlement, tilt, force and moment by the expansion; displacements are compared in units of the smooth problem.
fn expanded_state(contact: &NearlySmooth, rough: &[Rough; 3]) -> State {
    let companions = &contact.pressure.companions;
    let (smooth, theta0) = (companions.smooth.state(), contact.pressure.theta0);
    let states = [0, 1, 2].map(|i| rough[i].contact.state());
    let fitted = |part: fn(&State) -> f64, unit: fn(f64) -> f64| {
        let values: Three = [0, 1, 2].map(|i| part(&states[i]) / unit(companions.at[i]));
        beside_limit(part(&smooth), values, companions.at, theta0).value * unit(theta0)
    };
    State {
        settlement: fitted(|state| state.settlement, |theta0| theta0),
        tilt: fitted(|state| state.tilt, |theta0| theta0),
        force: fitted(|state| state.force, |_| 1.0),
        moment: fitted(|state| state.moment, |_| 1.0),
    }
}

/// Of the pressure between the layers, at fixed shares of the stretches.
fn between(contact: &NearlySmooth, rough: &[Rough; 3]) -> f64 {
    let pressure = &contact.pressure;
    let companions = &pressure.companions;
    let (mut differs, mut unresolved, mut added) = (0.0f64, 0.0f64, 0.0f64);
    for zone in 0..companions.marks.len() {
        for stretch in 0..companions.marks[zone].len() - 1 {
            for k in 2..SHARES - 1 {
                let share = k as f64 / SHARES as f64;
                let at =
                    |marks: &[f64]| marks[stretch] + share * (marks[stretch + 1] - marks[stretch]);
                let limit = companions.smooth.pressure0(at(&companions.marks[zone]));
                let values =
                    [0, 1, 2].map(|i| rough[i].contact.density(at(&pressure.others[i][zone])));
                let fitted = beside_limit(limit, values, companions.at, pressure.theta0);
                let density = pressure.direct.contact.density(at(&pressure.marks[zone]));
                differs = differs.max((density - fitted.value).abs());
                unresolved = unresolved.max(fitted.error);
                added = added.max((fitted.value - limit).abs());
            }
        }
    }
    let rounding = companions.smooth.accuracy().pressure;
    differs + if unresolved > UNRESOLVED * added + rounding { unresolved } else { 0.0 }
}
