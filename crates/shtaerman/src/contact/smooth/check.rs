//! Complementarity between the places where the equation holds: where the answer pulls and where the base penetrates.

use std::f64::consts::PI;

use super::base::Base;
use super::pressure::{Pressure, place};
use crate::contact::accuracy::ROUNDING;
use crate::contact::check::{Check, POINTS, between_breaks, with_tops};
use crate::contact::zones::{EndKind, Zone, outside};
use crate::deadline::work;
use crate::line_search::Point;

/// Tenths of tenths of half a zone to which places close in on a kink. At half or twice 1 of 4 answers are lost (survey).
const CLOSING: i32 = 12;
/// How near to the axis a disk is looked at, over its radius: a smaller hole changes its pressure by 1e-11 (theory).
const BESIDE_AXIS: f64 = 1e-6;

/// Tension and penetration beyond `allowed`, relative to their scales, are listed for correction. Tension is that of the pressure without its singularity where the zone has a corner.
pub(super) fn check<P: Pressure>(base: &Base, solved: &P, allowed: f64) -> Check {
    let zones = solved.zones();
    let along: Vec<Along> = (0..zones.len()).map(|j| Along::new(base, solved, j)).collect();
    let largest = (along.iter().flat_map(|zone| &zone.pulls))
        .filter(|p| p.is_finite())
        .fold(f64::MIN_POSITIVE, |most, p| most.max(p.abs()));
    let mut check = Check { largest, ..Check::none() };
    for (j, (zone, along)) in zones.iter().zip(&along).enumerate() {
        let floor = 4.0 * solved.known(j, largest).pressure * along.steepest;
        let listed = check.pulling.len();
        check.add_tension(&along.points, &along.pulls, [largest, allowed * largest + floor]);
        // Tension at the outermost points reaches to the end of the zone.
        if let [first, .., last] = along.points[..] {
            for [left, right] in &mut check.pulling[listed..] {
                *left = if *left == first { zone.left() } else { *left };
                *right = if *right == last { zone.right() } else { *right };
            }
        }
        // Slopes alone know nothing of a step.
        let beyond = base.beyond_steps(zone.ends);
        if !beyond.is_empty() {
            check.tension = check.tension.max(1.0);
        }
        check.pulling.extend(beyond);
    }
    if base.setting.is_unilateral() {
        look_beside(&mut check, base, solved, allowed);
    }
    check
}

/// Points inside a zone with the tension there.
struct Along {
    points: Vec<f64>,
    pulls: Vec<f64>,
    /// What a rounding of the regular pressure may be at the outermost points.
    steepest: f64,
}

impl Along {
    fn new<P: Pressure>(base: &Base, solved: &P, j: usize) -> Self {
        let zone = solved.zones()[j];
        let mut points = looked_at(base, zone.ends, POINTS);
        // Pressures are often least on the axis, where those of kinks are infinite.
        points[0] += if zone.kinds[0] == EndKind::Axis { BESIDE_AXIS * zone.length() } else { 0.0 };
        points = crate::order::ascending(points.into_iter().chain(closing_in(base, &zone)));
        points.retain(|xi| zone.left() <= *xi && *xi <= zone.right());
        let has_corner = zone.kinds.contains(&EndKind::Wall);
        let pull = |xi: f64| {
            let place = place(&zone, xi);
            let at = || if has_corner { solved.regular(j, place) } else { solved.at(j, place) };
            -counted(base, solved.terms() / solved.zones().len(), at)
        };
        let points: Vec<Point> = points.into_iter().map(|xi| (xi, pull(xi))).collect();
        let (points, pulls) = with_tops(&points, pull);
        let first = points.iter().find(|xi| **xi > zone.left());
        let first = first.map_or(0.5, |xi| (xi - zone.left()) / zone.length());
        let steepest =
            if has_corner { 1.0 } else { (4.0 * first).powf(-solved.corner_exponent()).max(1.0) };
        Self { points, pulls, steepest }
    }
}

fn look_beside<P: Pressure>(check: &mut Check, base: &Base, solved: &P, allowed: f64) {
    let (state, zones) = (solved.state(), solved.zones());
    let forces: f64 = (0..zones.len()).map(|j| solved.force(j).abs()).sum();
    let scale = forces + state.settlement.abs() + state.tilt.abs();
    let floor = ROUNDING * (scale + base.range());
    for ends in outside(&base.pieces, &zones) {
        let mut points = looked_at(base, ends, POINTS);
        // A base is often lowest at a kink itself.
        points.extend(base.breaks.iter().filter(|at| ends[0] < **at && **at < ends[1]));
        points.sort_by(f64::total_cmp);
        let depth = |xi: f64| state.settlement - state.tilt * xi - base.height_in(ends, xi);
        let touches = |xi: f64| zones.iter().any(|zone| zone.ends.contains(&xi));
        let outside = |xi: f64| counted(base, solved.terms(), || depth(xi) - solved.outside(xi));
        let value = |xi: f64| if touches(xi) { 0.0 } else { outside(xi) };
        let points: Vec<Point> = points.into_iter().map(|xi| (xi, value(xi))).collect();
        let (points, values) = with_tops(&points, value);
        check.add_penetration(&points, &values, [scale, allowed, floor]);
    }
}

/// A value that is summed from so many terms, which is work; none where no work is left, and no answer comes of it.
fn counted(base: &Base, terms: usize, value: impl FnOnce() -> f64) -> f64 {
    base.deadline().spend(work::TERM * terms as f64);
    if base.deadline().is_spent() { 0.0 } else { value() }
}

/// Both ends and places between that show every feature of the profile.
pub(super) fn looked_at(base: &Base, ends: [f64; 2], fewest: usize) -> Vec<f64> {
    let points = points(ends, fewest).into_iter();
    crate::order::ascending(points.chain(between_breaks(&base.marks, ends)))
}

/// Places that close in on the hollow kinks of a zone from either side, under which the pressure falls below all bounds, but as slowly as a logarithm, and half as often on its free ends: not on those of rings, whose modes are cut off.
fn closing_in(base: &Base, zone: &Zone) -> Vec<f64> {
    let half = 0.5 * zone.length();
    let kinks = base.hollows.iter().filter(|at| zone.contains(**at)).map(|at| (*at, CLOSING));
    let ends = zone.free_ends().filter(|_| !base.ground.is_disk()).map(|(_, at)| (at, CLOSING / 2));
    let about = |(at, most): (f64, i32)| {
        let offsets = (1..=most).flat_map(|k| [-1.0, 1.0].map(|side| side * 0.1f64.powi(k)));
        offsets.map(move |offset| at + offset * half)
    };
    kinks.chain(ends).flat_map(about).collect()
}

/// Both ends and points between, closer near the ends.
pub(super) fn points([left, right]: [f64; 2], count: usize) -> Vec<f64> {
    let inner = (1..count).map(|i| {
        let half = (0.5 * PI * i as f64 / count as f64).sin();
        (left + (right - left) * half * half).clamp(left, right)
    });
    std::iter::once(left).chain(inner).chain(std::iter::once(right)).collect()
}
