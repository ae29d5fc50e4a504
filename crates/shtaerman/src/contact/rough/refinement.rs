//! The answer on growing numbers of nodes, with its error.

use fredholm::collocation::first_half_count;

use super::base::Base;
use super::between::PLACES;
use super::between::between_nodes;
use super::solved::{Solved, Stated};
use super::system::Resolution;
use crate::Error;
use crate::contact::accuracy::{Accuracy, ROUNDING, STAGNANT};
use crate::contact::edges::settle;
use crate::contact::resolutions::{Change, Trust};
use crate::contact::zones::Zone;
use crate::solver::AIM;

/// Nodes on either side of the middle of a panel for each valley of the whole base: `cos(k xi)` needs about `4 k`, and has `k/pi` valleys; and most of them. At half or twice 2 of 32 answers change, within what they state (survey).
const NODES_A_VALLEY: f64 = 12.0;
const MOST_FOR_VALLEYS: f64 = 160.0;
/// Growth of the number of nodes from one resolution to the next. At half or twice 4 of 32 answers are lost, 17 of 32 differ beyond what is stated, stated errors grow up to 1e+06 times and time grows by 401 % (survey).
pub(super) const RATIO: f64 = std::f64::consts::SQRT_2;
/// Noise of the pressure, relative to its largest, with which there is none: complementarity would be allowed everything.
pub(super) const ALL_NOISE: f64 = 0.1;

/// Nodes on either side of the middle of a panel that are about right for the longest panel.
pub(super) fn strength(base: &Base<'_>, zones: &[Zone]) -> f64 {
    let longest = zones
        .iter()
        .flat_map(|zone| zone.panels(&base.breaks))
        .fold(0.0f64, |most, (left, right)| most.max(right - left));
    let count = first_half_count(0.5 * base.steepness() * longest);
    // The pressure of a layer that bends ends with another power.
    let count = if base.layer.is_linear() { count } else { RATIO * count };
    // On fewer nodes a wavy base shows tension where there is none, and zones would be cut there.
    let waves = NODES_A_VALLEY * base.valleys() as f64 * 0.5 * longest;
    count.max(waves.min(MOST_FOR_VALLEYS)).max(base.ground.first_half_count(longest))
}

/// The answer on growing numbers of nodes, from one on fewer: `start` is the first number on either side of the middle of a panel.
pub(super) fn refined(base: &Base<'_>, coarse: &Solved, start: f64) -> Result<Solved, Error> {
    let tolerance = base.problem.solver().tolerance.unwrap_or(AIM);
    let strength = |power: i32| start * RATIO.powi(power);
    let level = |zones: &[Zone], power: i32| {
        settle(base, zones, &Resolution::new(&base.ground, strength(power))?)
    };
    let mut fine = level(&coarse.zones, 0)?;
    let mut before = difference(base, &fine, coarse);
    let mut best: Option<Solved> = None;
    for power in 1.. {
        let mut finer = level(&fine.zones, power)?;
        let change = difference(base, &finer, &fine);
        let (accuracy, edge) = estimate(base, &finer, &before, &change);
        finer.stated = Stated { accuracy, edge };
        let sizes = finer.state.sizes(finer.largest());
        let met = accuracy.relative(&sizes) <= tolerance;
        let settled = change.pressure <= 2.0 * finer.pressure_rounding()
            && resolved(&finer, &change)
            || (change.pressure > 0.5 * before.pressure
                && change.pressure <= STAGNANT * finer.largest());
        let next = strength(power + 1) * 2.0 * finer.panels.len() as f64;
        let last = next > base.effort.nodes as f64
            || base.work.spent() > base.effort.work
            || base.problem.deadline().is_past();
        fine = finer;
        let known = |best: &Solved| best.stated.accuracy.pressure;
        if best.as_ref().is_none_or(|best| accuracy.pressure <= known(best)) {
            best = Some(fine.clone());
        }
        if met || settled || last {
            break;
        }
        before = change;
    }
    Ok(best.unwrap_or_else(|| unreachable!("the first round sets it")))
}

/// Whether the integrals have settled with the pressure: where the body gives nothing, the pressure of a layer that bends is exact on any nodes, its force is not.
fn resolved(solved: &Solved, change: &Change) -> bool {
    let state = &solved.state;
    let small = |change: f64, size: f64| change <= ROUNDING * size;
    solved.layer.is_linear()
        || (small(change.force.max(change.moment), state.force.abs().max(state.moment.abs()))
            && small(
                change.settlement.max(change.tilt),
                state.settlement.abs().max(state.tilt.abs()),
            ))
}

fn difference(base: &Base<'_>, fine: &Solved, coarse: &Solved) -> Change {
    let pressure = (fine.panels.iter())
        .flat_map(|panel| {
            let (middle, half) =
                (0.5 * (panel.left + panel.right), 0.5 * (panel.right - panel.left));
            between_nodes(PLACES).map(move |y| (middle + half * y).clamp(panel.left, panel.right))
        })
        .map(|xi| {
            let height = base.height(xi);
            let covered = coarse.zones.iter().any(|zone| zone.left() <= xi && xi <= zone.right());
            let other = if covered { coarse.pressure_at(xi, height) } else { 0.0 };
            (fine.pressure_at(xi, height) - other).abs()
        })
        .fold(0.0, f64::max);
    Change::between([fine, coarse].map(|solved| (&solved.state, &solved.zones[..])), pressure)
}

/// The error of the finest of three resolutions, and that of its edges.
fn estimate(base: &Base<'_>, fine: &Solved, before: &Change, change: &Change) -> (Accuracy, f64) {
    let largest = fine.largest();
    let pressures = [before.pressure, change.pressure];
    let trust = Trust::new(base.smoothness, RATIO, pressures, fine.pressure_rounding(), largest);
    let length = fine.zones.iter().map(Zone::length).sum();
    let (accuracy, edge) =
        trust.accuracy(base.load, [before, change], &fine.state.sizes(largest), length);
    let pressure = accuracy.pressure.max(fine.pressure_rounding());
    (Accuracy { pressure, ..accuracy }, edge.max(fine.edge_rounding()))
}
