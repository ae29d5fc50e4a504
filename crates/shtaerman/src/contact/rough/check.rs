//! Complementarity between the nodes: where the answer pulls and where the base penetrates.

use super::base::Base;
use super::nodes::{Field, between_nodes};
use super::solved::Solved;
use crate::contact::check::{Check, POINTS, with_tops};
use crate::contact::steps::INSIDE;
use crate::contact::zones::outside;

/// Rounding of the layer over what it is told to be: of a difference of two.
const FLOOR: f64 = 4.0;

/// Tension and penetration beyond `allowed`, relative to their scales, and beyond rounding are listed for correction.
pub(super) fn check<F: Field>(base: &Base, solved: &Solved<F>, allowed: f64) -> Check {
    // Of the layer, which shows how far it is from touching also where pressures are small.
    let largest = solved.deepest().max(f64::MIN_POSITIVE);
    let floor = FLOOR * solved.rounding();
    let layer = |xi: f64| solved.layer_at(xi, base.sampled_height(xi));
    let mut check = Check { largest, ..Check::none() };
    for zone in &solved.nodes.zones {
        let points = points(base, zone.left(), zone.right());
        let (points, values) = with_tops(&points, |xi| -layer(xi));
        check.add_tension(&points, &values, [largest, allowed * largest + floor]);
    }
    // What is compared outside is of the size of its terms.
    let scale = solved.size() + solved.state.settlement.abs() + solved.state.tilt.abs();
    for [left, right] in outside(&base.pieces, &solved.nodes.zones) {
        let (points, values) = with_tops(&points(base, left, right), layer);
        check.add_penetration(&points, &values, [scale, allowed * scale + floor]);
    }
    check
}

/// Of every part both ends, places between that are closer near the ends, and the samples of the profile.
fn points(base: &Base, left: f64, right: f64) -> Vec<f64> {
    let mut cuts = vec![left];
    cuts.extend(base.breaks.iter().filter(|at| **at > left && **at < right));
    cuts.push(right);
    let mut points: Vec<f64> = Vec::new();
    for pair in cuts.windows(2) {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        let reach = half * (1.0 - INSIDE);
        points.extend(between_nodes(POINTS).map(|y| (middle + reach * y).clamp(pair[0], pair[1])));
        let [from, to] =
            [pair[0], pair[1]].map(|end| base.samples.partition_point(|(at, _)| *at <= end));
        points.extend(base.samples[from..to].iter().map(|(at, _)| *at).filter(|at| *at < pair[1]));
    }
    points.sort_by(f64::total_cmp);
    points.dedup();
    points
}
