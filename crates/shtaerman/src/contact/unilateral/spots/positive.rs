//! Where a function of the base is positive.

use crate::contact::valleys::GOLDEN;

/// Steps on the way to an edge, and towards a peak between samples.
const STEPS: usize = 80;
const GOLDEN_STEPS: usize = 40;

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
            edges.push(edge(pressure, (at[i - 1], values[i - 1]), peak, none));
            edges.push(edge(pressure, peak, (at[i + 1], values[i + 1]), none));
        }
        if is_crossed(values[i], values[i + 1]) {
            edges.push(edge(pressure, (at[i], values[i]), (at[i + 1], values[i + 1]), none));
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
fn hidden(
    pressure: &impl Fn(f64) -> f64,
    at: &[f64],
    values: &[f64],
    i: usize,
) -> Option<(f64, f64)> {
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
    let (mut left, mut right) = (at[i - 1], at[i + 1]);
    for _ in 0..GOLDEN_STEPS {
        let inner = [right - GOLDEN * (right - left), left + GOLDEN * (right - left)];
        let heights = inner.map(|xi| sign * pressure(xi));
        for (xi, height) in inner.iter().zip(heights) {
            if height > 0.0 {
                return Some((*xi, sign * height));
            }
        }
        if heights[0] > heights[1] { right = inner[1] } else { left = inner[0] }
    }
    None
}

/// The crossing between two places of different signs: by false position (Illinois), every third step by halves.
fn edge(
    pressure: &impl Fn(f64) -> f64,
    (mut left, mut at_left): (f64, f64),
    (mut right, mut at_right): (f64, f64),
    none: f64,
) -> f64 {
    let positive_left = at_left > 0.0;
    let (mut last, mut was_left) = (left, None);
    for step in 1..=STEPS {
        let secant = left + (right - left) * at_left / (at_left - at_right);
        let middle = 0.5 * (left + right);
        let inside = secant > left && secant < right && step % 3 != 0;
        let place = if inside { secant } else { middle };
        let value = pressure(place);
        if value.abs() <= none || middle <= left || middle >= right || place == last {
            return place;
        }
        let is_left = (value > 0.0) == positive_left;
        let again = was_left == Some(is_left);
        if is_left {
            (left, at_left) = (place, value);
            at_right *= if again { 0.5 } else { 1.0 };
        } else {
            (right, at_right) = (place, value);
            at_left *= if again { 0.5 } else { 1.0 };
        }
        (last, was_left) = (place, Some(is_left));
    }
    0.5 * (left + right)
}
