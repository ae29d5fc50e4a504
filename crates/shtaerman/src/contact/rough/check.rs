//! Complementarity between the nodes: where the answer pulls and where the base penetrates.

use super::base::Base;
use super::nodes::{Field, between_nodes};
use super::solved::Solved;
use crate::contact::accuracy::SAFETY;
use crate::contact::check::{Check, POINTS, with_tops};
use crate::contact::steps::INSIDE;
use crate::contact::zones::{are_images, outside};
use crate::line_search::Point;

/// Tension and penetration beyond `allowed`, relative to their scales, and beyond rounding are listed for correction.
pub(super) fn check<F: Field>(base: &Base, solved: &Solved<F>, allowed: f64) -> Check {
    // Of the layer, which shows how far it is from touching also where pressures are small.
    let largest = solved.deepest().max(f64::MIN_POSITIVE);
    let floor = SAFETY * solved.rounding();
    let layer = |xi: f64| solved.layer_at(xi, base.sampled_height(xi));
    let mut check = Check { largest, ..Check::none() };
    let zones = &solved.nodes.zones;
    // Of what is its own mirror image one half tells all.
    let is_half = are_images(zones) && base.is_mirrored();
    let from = if is_half { 0.0 } else { f64::NEG_INFINITY };
    let within = |[left, right]: [f64; 2]| (right > from).then_some([left.max(from), right]);
    let inside: Vec<[f64; 2]> = zones.iter().filter_map(|zone| within(zone.ends)).collect();
    let gaps: Vec<[f64; 2]> = outside(&base.pieces, zones).into_iter().filter_map(within).collect();
    // All at once, for as many processors as there are.
    let parts: Vec<Vec<Point>> =
        inside.iter().chain(&gaps).map(|[left, right]| points(base, *left, *right)).collect();
    let mut layers = solved.layers_at(&parts.concat()).into_iter();
    let mut parts = parts.into_iter().map(|mut part| {
        part.iter_mut().zip(&mut layers).for_each(|(point, layer)| point.1 = layer);
        part
    });
    for mut part in parts.by_ref().take(inside.len()) {
        part.iter_mut().for_each(|point| point.1 = -point.1);
        let (points, values) = with_tops(&part, |xi| -layer(xi));
        check.add_tension(&points, &values, [largest, allowed * largest + floor]);
    }
    check.missed = check.missed.max(check.tension * largest - floor);
    let pulls = |at: &f64, given: &f64| {
        -given > allowed * largest + floor
            && check.pulling.iter().any(|[left, right]| left <= at && at <= right)
    };
    let nodes = &mut solved.nodes.places.iter().zip(&solved.given);
    check.is_between_nodes =
        !check.pulling.is_empty() && !nodes.any(|(at, given)| pulls(at, given));
    // What is compared outside is of the size of its terms.
    let scale = solved.size() + solved.state.settlement.abs() + solved.state.tilt.abs();
    for part in parts {
        let (points, values) = with_tops(&part, layer);
        check.add_penetration(&points, &values, [scale, allowed, floor]);
    }
    if is_half { check.with_images() } else { check }
}

/// Of every part both ends, places between that are closer near the ends, and the samples of the profile; with their heights.
fn points(base: &Base, left: f64, right: f64) -> Vec<Point> {
    let inside = base.breaks.iter().copied().filter(|at| *at > left && *at < right);
    let mut places: Vec<f64> = Vec::new();
    let mut points: Vec<Point> = Vec::new();
    for [left, right] in crate::order::parts([left, right], inside) {
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let reach = half * (1.0 - INSIDE);
        places.extend(between_nodes(POINTS).map(|y| (middle + reach * y).clamp(left, right)));
        let [from, to] =
            [left, right].map(|end| base.samples.partition_point(|(at, _)| *at <= end));
        points.extend(base.samples[from..to].iter().filter(|(at, _)| *at < right));
    }
    points.extend(base.points(places));
    crate::order::sort_by_number(&mut points, |one| one.0);
    points.dedup_by(|next, before| next.0 == before.0);
    points
}
