//! Where a function of the base is positive.

use crate::contact::iteration::{Point, crossing, top};

/// Where a function with these values at places from end to end of a piece of the base is positive; values up to `none` are zero.
pub(super) fn positive(
    pressure: &impl Fn(f64) -> f64,
    at: &[f64],
    values: &[f64],
    none: f64,
) -> Vec<[f64; 2]> {
    let mut edges = Vec::new();
    for i in 0..at.len() - 1 {
        if let Some(peak) = hidden(pressure, at, values, i) {
            edges.push(crossing(pressure, (at[i - 1], values[i - 1]), peak, none));
            edges.push(crossing(pressure, peak, (at[i + 1], values[i + 1]), none));
        }
        if is_crossed(values[i], values[i + 1]) {
            edges.push(crossing(pressure, (at[i], values[i]), (at[i + 1], values[i + 1]), none));
        }
    }
    paired(edges, values[0] > 0.0, [at[0], at[at.len() - 1]])
}

/// Edges in turn open and close a zone.
fn paired(mut edges: Vec<f64>, begins_inside: bool, [first, last]: [f64; 2]) -> Vec<[f64; 2]> {
    edges.sort_by(f64::total_cmp);
    if begins_inside {
        edges.insert(0, first);
    }
    if edges.len() % 2 == 1 {
        edges.push(last);
    }
    edges.chunks_exact(2).filter(|pair| pair[0] < pair[1]).map(|pair| [pair[0], pair[1]]).collect()
}

fn is_crossed(one: f64, other: f64) -> bool {
    (one > 0.0) != (other > 0.0)
}

/// The place beside a sample where the pressure has the other sign than at that sample and its neighbours.
fn hidden(pressure: &impl Fn(f64) -> f64, at: &[f64], values: &[f64], i: usize) -> Option<Point> {
    if i == 0 || i + 1 >= at.len() {
        return None;
    }
    let [before, here, after] = [values[i - 1], values[i], values[i + 1]];
    let sign = if here > 0.0 { -1.0 } else { 1.0 };
    let is_peak = sign * here >= sign * before && sign * here >= sign * after;
    if !is_peak || is_crossed(here, before) || is_crossed(here, after) {
        return None;
    }
    // The parabola through the three, with a margin, stays on this side: so does the pressure.
    let rise = (0.125 * (after - before).powi(2) / (2.0 * here - before - after)).abs();
    if 2.0 * rise < here.abs() {
        return None;
    }
    let (place, height) = top(&|xi| sign * pressure(xi), at[i - 1], at[i + 1]);
    (height > 0.0).then_some((place, sign * height))
}
