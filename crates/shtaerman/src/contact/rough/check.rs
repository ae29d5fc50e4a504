//! Complementarity between the nodes: where the answer pulls and where the base penetrates.

use super::base::Base;
use super::between::between_nodes;
use super::solved::Solved;
use crate::contact::check::POINTS;
use crate::contact::check::{Check, with_tops};
use crate::contact::steps::INSIDE;
use crate::contact::zones::outside;

/// Tension and penetration beyond `allowed`, relative to their scales, and beyond rounding are listed for correction.
pub(super) fn check(base: &Base<'_>, solved: &Solved, allowed: f64) -> Check {
    // Of the layer, which shows how far it is from touching also where pressures are small.
    let largest = solved.deepest().max(f64::MIN_POSITIVE);
    let floor = 4.0 * solved.rounding();
    let mut check = Check { largest, ..Check::none() };
    for panel in &solved.panels {
        let points = points(base, panel.left, panel.right);
        let (points, values) = with_tops(&points, |xi| -solved.layer(base, xi));
        check.add_tension(&points, &values, [largest, allowed * largest + floor]);
    }
    let depth = |xi: f64| solved.state.settlement - solved.state.tilt * xi - base.height(xi);
    // What is compared outside is of the size of its terms.
    let scale = largest
        + solved.state.settlement.abs()
        + solved.state.tilt.abs()
        + solved.solution.parameter()
            * solved.solution.potential().iter().fold(0.0f64, |most, u| most.max(u.abs()));
    for [left, right] in outside(&base.pieces, &solved.zones) {
        let points = points(base, left, right);
        let (points, values) = with_tops(&points, |xi| depth(xi) - solved.displacement_outside(xi));
        check.add_penetration(&points, &values, [scale, allowed * scale + floor]);
    }
    check
}

/// Both ends of every part and points between, closer near the ends, dense enough for the samples of the profile.
fn points(base: &Base<'_>, left: f64, right: f64) -> Vec<f64> {
    let mut cuts = vec![left];
    cuts.extend(base.breaks.iter().filter(|at| **at > left && **at < right));
    cuts.push(right);
    let mut points: Vec<f64> = Vec::new();
    for pair in cuts.windows(2) {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        let samples = (half * base.samples.len() as f64 / 2.0) as usize;
        let reach = half * (1.0 - INSIDE);
        let between = between_nodes(POINTS.max(samples));
        points.extend(between.map(|y| (middle + reach * y).clamp(pair[0], pair[1])));
    }
    points.sort_by(f64::total_cmp);
    points
}
