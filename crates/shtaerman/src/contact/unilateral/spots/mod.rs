//! Contact in many zones ("contact spots") with exact edges.
//!
//! Each zone is cut into panels at the measured points, where the third derivative of the spline jumps, and towards its ends, where the pressure goes on as `d^2 ln d`; on each
//! the pressure is a polynomial through Gauss nodes. The equation on all zones is solved by GMRES with products by a fast multipole method
//! ([`fredholm::multipole`]). The zones that come next are where `g = delta0 - alpha0 xi - f0 - theta0 K p0` is positive: as the pressure vanishes at a free edge, an edge that is off
//! by `e` changes the rest by `e^2` only, and this is Newton's method. Cells give the zones to begin with.

mod answer;
mod level;
mod mesh;

pub(super) use answer::SpotContact;

use super::answer::Complementarity;
use super::base::Base;
use super::fine;
use super::zones::Zone;
use crate::Error;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use level::Level;
use mesh::Fineness;

/// Most rounds on the way to the zones.
const ROUNDS: usize = 14;
/// Relative residuals: of the first rounds, and of the last ones.
const LOOSE: f64 = 1e-7;
const TIGHT: f64 = 1e-13;
/// Pressure at free edges over the largest that is none.
const NONE: f64 = 1e-13;
/// Panels whose answer is compared, and those of the answer.
const COARSE: Fineness = Fineness { order: 6, ends: 4.0 };
const FINE: Fineness = Fineness { order: 8, ends: 1.0 };
/// Most zones.
const MOST_ZONES: usize = 2000;

/// The answer on panels; none where the zones are not found or too many.
pub(super) fn solve(base: &Base<'_>) -> Result<Option<SpotContact>, Error> {
    let log = std::env::var("SPOTS").is_ok();
    let clock = std::time::Instant::now();
    let Some(zones) = fine::first_zones(base)? else { return Ok(None) };
    if log {
        eprintln!("first zones {:?}", clock.elapsed());
    }
    let mut joints = base.problem.profile().joints(base.problem.frame().half_width());
    joints.sort_by(f64::total_cmp);
    let Some((coarse, _)) = settle(base, &joints, zones, COARSE, None)? else { return Ok(None) };
    if log {
        eprintln!("coarse {:?}", clock.elapsed());
    }
    let zones = coarse.zones.clone();
    let Some((fine, left)) = settle(base, &joints, zones, FINE, Some(&coarse))? else {
        return Ok(None);
    };
    if log {
        eprintln!("fine {:?}", clock.elapsed());
    }
    let (accuracy, edge_error) = estimate(&fine, &coarse);
    Ok(Some(SpotContact { level: fine, accuracy, edge_error, complementarity: left }))
}

/// The zones that agree with their own pressure, and what is left of tension and penetration.
fn settle(
    base: &Base<'_>,
    joints: &[f64],
    mut zones: Vec<Zone>,
    fineness: Fineness,
    start: Option<&Level>,
) -> Result<Option<(Level, Complementarity)>, Error> {
    let mut known: Option<Level> = start.cloned();
    let mut best = f64::INFINITY;
    let mut tolerance = if start.is_some() { TIGHT } else { LOOSE };
    for round in 0..ROUNDS {
        if zones.is_empty() || zones.len() > MOST_ZONES {
            return Ok(None);
        }
        let level = Level::new(base, joints, &zones, fineness, (known.as_ref(), tolerance))?;
        let Some(level) = level else { return Ok(None) };
        let sampled = level.sampled(base, joints);
        let next = level.next_zones(base, &sampled);
        let off = level.at_ends(base) / level.largest();
        let left = complementarity(&level, &sampled);
        if std::env::var("SPOTS").is_ok() {
            eprintln!("  round {round} off {off:e} next {} {left:?}", next.len());
        }
        let same = next.len() == zones.len();
        if same && tolerance <= TIGHT && (off <= NONE || off >= 0.1 * best) {
            return Ok(Some((level, left)));
        }
        best = if same && tolerance <= TIGHT { off } else { f64::INFINITY };
        if same {
            tolerance = if off < 1e-3 { TIGHT } else { LOOSE };
        }
        known = Some(level);
        zones = next;
    }
    Ok(None)
}

/// Tension in the zones and penetration beside them.
fn complementarity(level: &Level, (at, values): &(Vec<f64>, Vec<f64>)) -> Complementarity {
    let (mut tension, mut penetration) = (0.0f64, 0.0f64);
    for (xi, pressure) in at.iter().zip(values) {
        if level.touches(*xi) {
            tension = tension.max(-pressure);
        } else {
            penetration = penetration.max(*pressure);
        }
    }
    let largest = level.largest().max(f64::MIN_POSITIVE);
    let size = largest + level.state.settlement.abs() + level.state.tilt.abs();
    Complementarity { tension: tension / largest, penetration: penetration / size }
}

/// The differences between two finenesses, and that of the edges.
fn estimate(fine: &Level, coarse: &Level) -> (Accuracy, f64) {
    let nodes = fine.field.panels().nodes();
    let pressure = nodes
        .iter()
        .zip(&fine.pressures)
        .map(|(xi, p)| (p - coarse.inside(*xi).unwrap_or(0.0)).abs())
        .fold(0.0, f64::max);
    let ends = |level: &Level| -> Vec<f64> {
        level.zones.iter().flat_map(|zone| [zone.left(), zone.right()]).collect()
    };
    let edge = ends(fine)
        .into_iter()
        .zip(ends(coarse))
        .map(|(one, two)| (one - two).abs())
        .fold(0.0, f64::max);
    let (one, other) = (&fine.state, &coarse.state);
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure,
        settlement: (one.settlement - other.settlement).abs(),
        tilt: (one.tilt - other.tilt).abs(),
        force: (one.force - other.force).abs(),
        moment: (one.moment - other.moment).abs(),
    };
    (accuracy, edge)
}
