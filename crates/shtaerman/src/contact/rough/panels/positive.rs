//! Where a function of the base is positive.

use crate::contact::iteration::{Point, crossing, top};

/// Where a function with these values at places from end to end of a piece of the base is positive; values up to `none` are zero.
pub(super) fn positive(f: &impl Fn(f64) -> f64, points: &[Point], none: f64) -> Vec<[f64; 2]> {
    let mut edges = Vec::new();
    if points[0].1 > 0.0 {
        edges.push(points[0].0);
    }
    for i in 0..points.len() - 1 {
        if let Some(peak) = hidden(f, points, i) {
            edges.push(crossing(f, points[i - 1], peak, none));
            edges.push(crossing(f, peak, points[i + 1], none));
        }
        if is_crossed(points[i].1, points[i + 1].1) {
            edges.push(crossing(f, points[i], points[i + 1], none));
        }
    }
    edges.sort_by(f64::total_cmp);
    if edges.len() % 2 == 1 {
        edges.push(points[points.len() - 1].0);
    }
    // Edges in turn open and close a zone.
    edges.chunks_exact(2).filter(|pair| pair[0] < pair[1]).map(|pair| [pair[0], pair[1]]).collect()
}

fn is_crossed(one: f64, other: f64) -> bool {
    (one > 0.0) != (other > 0.0)
}

/// The place beside a sample where the function has the other sign than at that sample and its neighbours.
fn hidden(f: &impl Fn(f64) -> f64, points: &[Point], i: usize) -> Option<Point> {
    let [before, here, after] = *points.get(i.checked_sub(1)?..i + 2)? else { return None };
    let sign = if here.1 > 0.0 { -1.0 } else { 1.0 };
    let is_peak = sign * here.1 >= sign * before.1 && sign * here.1 >= sign * after.1;
    if !is_peak || is_crossed(here.1, before.1) || is_crossed(here.1, after.1) {
        return None;
    }
    // The parabola through the three, with a margin, stays on this side: so does the function.
    let bend = 2.0 * here.1 - before.1 - after.1;
    let rise = (0.125 * (after.1 - before.1).powi(2) / bend).abs();
    if 2.0 * rise < here.1.abs() {
        return None;
    }
    let (place, height) = top(&|xi| sign * f(xi), before.0, after.0);
    (height > 0.0).then_some((place, sign * height))
}
