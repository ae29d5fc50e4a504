//! Contact in many zones ("contact spots") with exact edges.
//!
//! Each zone is cut into panels at the measured points, where the third derivative of the spline jumps, and towards its ends, where the pressure goes on as `d^2 ln d`; on each
//! the pressure is a polynomial through Gauss nodes. The equation on all zones is solved by GMRES with products by a fast multipole method
//! ([`fredholm::multipole`]). The zones that come next are where `g = delta0 - alpha0 xi - f0 - theta0 K p0` is positive: as the pressure vanishes at a free edge, an edge that is off
//! by `e` changes the rest by `e^2` only, and this is Newton's method. Cells give the zones to begin with.

use crate::contact::accuracy::OF_A_VALUE;
use crate::contact::promise::ROUGHEST;

mod answer;
mod bent;
mod chart;
mod estimate;
mod level;
mod mesh;
mod positive;
mod responses;
#[cfg(test)]
mod tests;

pub(super) use answer::SpotContact;

use super::base::Base;
use super::coarse::Coarse;
use crate::Error;
use crate::contact::complementarity::Complementarity;
use crate::contact::solution::Solution;
use crate::contact::zones::Zone;
use estimate::estimate;
use level::{Effort, Known, Level, Sampled, System};
use mesh::{Fineness, LONGEST, STRAIGHT};
use responses::Responses;

/// Most rounds on the way to the zones: an edge that is off by many lengths of the layer comes nearer by a half each, from a cell to the thinnest layers twenty times, and then by squares. Half and twice change none of 32 answers (survey).
const ROUNDS: usize = 28;
/// Panels on which the zones are found, those whose answer is compared, and those of the answer: with the relative residuals. Heights are resolved to a tenth of what zones are [found](GOOD) to: with
/// 1e-8 rows take 1.3 times as long, with 1e-4 no less time.
const LADDER: [Effort; 3] = [
    Effort {
        fineness: Fineness { order: 4, ends: 4.0, longest: LONGEST, straight: 1e-5 },
        residual: 1e-6,
        has_responses: false,
    },
    Effort {
        fineness: Fineness { order: 10, ends: 2.0, longest: LONGEST, straight: STRAIGHT },
        residual: 1e-11,
        has_responses: true,
    },
    Effort {
        fineness: Fineness { order: 13, ends: 1.0, longest: LONGEST, straight: STRAIGHT },
        residual: 1e-14,
        has_responses: true,
    },
];
/// Pressure at free edges over the largest, at which the zones are good enough: its square is what the pressure elsewhere is off. At half or twice stated errors grow up to 2.6 times (survey).
const GOOD: [f64; 3] = [1e-4, 1e-6, 1e-7];
/// Most zones.
const MOST_ZONES: usize = 2000;

/// The answer on panels; none where they do not serve: where the zones are not found or too many.
pub(super) fn solve(base: &Base<'_>) -> Result<Option<SpotContact>, Error> {
    if !base.has_panels() {
        return Ok(None);
    }
    if !base.layer.is_linear() {
        return solve_bent(base);
    }
    let zones = base.coarse()?.zones(base);
    solve_from(base, zones, None)
}

/// The answer for a layer that bends, from what cells find, or where they find nothing from the whole base: it has no pressure where it would pull.
fn solve_bent(base: &Base<'_>) -> Result<Option<SpotContact>, Error> {
    let coarse = base.coarse().ok().filter(|found| !found.is_empty());
    let zones = coarse.as_ref().map_or_else(|| base.whole(), |found| found.zones(base));
    solve_from(base, zones, coarse.as_deref())
}

/// The answer on the whole base; none where panels do not serve.
pub(super) fn solve_whole(base: &Base<'_>) -> Result<Option<SpotContact>, Error> {
    if !base.has_panels() {
        return Ok(None);
    }
    solve_from(base, base.whole(), None)
}

/// The answer from zones that are nearly right.
fn solve_from(
    base: &Base<'_>,
    mut zones: Vec<Zone>,
    coarse: Option<&Coarse>,
) -> Result<Option<SpotContact>, Error> {
    let joints = joints(base);
    let mut levels: Vec<Level> = Vec::new();
    let mut responses: Vec<Responses> = Vec::new();
    let mut left = None;
    for (effort, good) in LADDER.into_iter().zip(GOOD) {
        let settled = settle(base, &joints, zones, (effort, good), (levels.last(), coarse))?;
        let Some((level, system, complementarity)) = settled else { return Ok(None) };
        let is_over = base.problem.deadline().is_past();
        if effort.has_responses || is_over {
            let found = Responses::new(base, &level, &system, responses.last())?;
            responses.push(found);
        }
        zones = level.zones.clone();
        left = Some(complementarity);
        levels.push(level);
        if is_over {
            // Its error is not asked for.
            levels.resize(LADDER.len(), levels[levels.len() - 1].clone());
            responses.resize(LADDER.len() - 1, responses[responses.len() - 1].clone());
            break;
        }
    }
    let (Ok(levels), Ok(responses), Some(complementarity)) =
        (<[Level; 3]>::try_from(levels), <[Responses; 2]>::try_from(responses), left)
    else {
        return Ok(None);
    };
    let (accuracy, edge_error) = estimate(base, &levels);
    let [_, _, level] = levels;
    let complementarity = (!base.is_bilateral).then_some(complementarity);
    let setting = base.setting.clone();
    let contact = SpotContact { setting, level, responses, accuracy, edge_error, complementarity };
    Ok((contact.relative_error() <= ROUGHEST).then_some(contact))
}

/// Where the profile bends.
fn joints(base: &Base<'_>) -> Vec<f64> {
    if base.problem.profile().measured_points().is_none() {
        return base.breaks.clone();
    }
    let mut joints = base.problem.profile().joints(base.problem.frame().half_width());
    if base.ground.is_closed() {
        // A wave is seen from elsewhere than it was measured, and bends at its seam as well.
        joints.push(1.0);
        let images = |at: &f64| [at - 2.0, *at, at + 2.0];
        joints = joints.iter().flat_map(images).collect();
    }
    joints.sort_by(f64::total_cmp);
    joints
}

/// The zones that agree with their own pressure, and what is left of tension and penetration.
fn settle(
    base: &Base<'_>,
    joints: &[f64],
    mut zones: Vec<Zone>,
    (effort, good): (Effort, f64),
    (start, coarse): (Option<&Level>, Option<&Coarse>),
) -> Result<Option<(Level, System, Complementarity)>, Error> {
    let mut latest: Option<Level> = None;
    for _ in 0..ROUNDS {
        if zones.is_empty() || zones.len() > MOST_ZONES {
            return Ok(None);
        }
        let known = Known { level: latest.as_ref().or(start), coarse };
        let Some((mut level, system)) = Level::new(base, joints, &zones, effort, known)? else {
            return Ok(None);
        };
        if base.is_bilateral {
            let none = Complementarity { tension: 0.0, penetration: 0.0 };
            return Ok(Some((level, system, none)));
        }
        let sampled = level.sampled(base, joints);
        let next = level.next_zones(base, &sampled, OF_A_VALUE * level.size());
        let is_same = next.len() == zones.len();
        zones = next;
        let is_good = is_same && level.at_ends(base) <= good * level.largest();
        if is_good || !zones.is_empty() && base.problem.deadline().is_past() {
            // The pressure outside of the panels goes on as the negative gap: these edges are its own.
            level.zones = zones;
            let left = complementarity(&level, &sampled);
            return Ok(Some((level, system, left)));
        }
        latest = Some(level);
    }
    Ok(None)
}

/// Tension in the zones and penetration beside them.
fn complementarity(level: &Level, sampled: &[Sampled]) -> Complementarity {
    let (mut tension, mut penetration) = (0.0f64, 0.0f64);
    let all = sampled.iter().flat_map(|piece| piece.at.iter().zip(&piece.values));
    let inside = all.filter(|(xi, _)| level.end_at(**xi).is_none());
    for (xi, pressure) in inside {
        if level.touches(*xi) {
            tension = tension.max(-pressure);
        } else {
            penetration = penetration.max(*pressure);
        }
    }
    let largest = level.largest().max(f64::MIN_POSITIVE);
    Complementarity { tension: tension / largest, penetration: penetration / level.size() }
}
