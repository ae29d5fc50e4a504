//! Where curves are evaluated: as densely as they bend.

use shtaerman::{Contact, Error, PressureCurve};

/// Share of the range of a curve by which straight lines between its points may miss it: half a pixel of a panel of common height.
const VISIBLE: f64 = 1.0 / 400.0;
/// How often the distance between points is halved at most.
const HALVINGS: usize = 5;
/// Points of a curve at most.
const MOST: usize = 8001;
/// Share of the points nearest to infinite values that do not set the range.
const CLIPPED: f64 = 0.02;

/// A curve with points between its own wherever its pressure, or the base above it, bends so much that straight lines would show something else: a waviness or a measured roughness that is finer than
/// the points. What is straight between the points costs nothing more. Places beside the `window` are left as they are.
pub(crate) fn refined(
    contact: &Contact,
    curve: PressureCurve,
    window: [f64; 2],
) -> Result<PressureCurve, Error> {
    let bases = |places: &[f64]| places.iter().map(|&x| contact.base_depth(x)).collect();
    let evaluate = |places: &[f64]| -> Result<[Vec<f64>; 2], Error> {
        let pressure = PressureCurve::at(contact, places.to_vec())?.pressure;
        Ok([pressure, bases(places)])
    };
    let mut x = curve.x;
    let known = [curve.pressure, bases(&x)];
    let [pressure, _] = between(&mut x, known, window, evaluate)?;
    Ok(PressureCurve { x, pressure })
}

/// The values of some curves at places from left to right, to which those are added that the curves need.
pub(crate) fn between<const N: usize, E>(
    places: &mut Vec<f64>,
    mut known: [Vec<f64>; N],
    [left, right]: [f64; 2],
    mut evaluate: impl FnMut(&[f64]) -> Result<[Vec<f64>; N], E>,
) -> Result<[Vec<f64>; N], E> {
    for _ in 0..HALVINGS {
        let bent = bent(places, &known);
        let middles = (1..places.len()).filter(|&index| bent[index]).map(|index| {
            let [from, to] = [places[index - 1], places[index]];
            (index, from.midpoint(to))
        });
        let is_new = |&(index, middle): &(usize, f64)| {
            places[index - 1] < middle && middle < places[index] && (left..=right).contains(&middle)
        };
        let wanted: Vec<(usize, f64)> = middles.filter(is_new).collect();
        if wanted.is_empty() || places.len() + wanted.len() > MOST {
            break;
        }
        let middles: Vec<f64> = wanted.iter().map(|wanted| wanted.1).collect();
        let found = evaluate(&middles)?;
        let merged = |old: &[f64], new: &[f64]| -> Vec<f64> {
            let (mut all, mut from) = (Vec::with_capacity(old.len() + new.len()), 0);
            for (&(index, _), value) in wanted.iter().zip(new) {
                all.extend_from_slice(&old[from..index]);
                all.push(*value);
                from = index;
            }
            all.extend_from_slice(&old[from..]);
            all
        };
        *places = merged(places, &middles);
        for (known, found) in known.iter_mut().zip(&found) {
            *known = merged(known, found);
        }
    }
    Ok(known)
}

/// Whether the interval that ends at a place is one in which some curve departs from a straight line so that it can be seen. Between equidistant points it does so by a quarter of what the
/// middle one of three departs from the line through its neighbours.
fn bent<const N: usize>(places: &[f64], known: &[Vec<f64>; N]) -> Vec<bool> {
    let mut bent = vec![false; places.len()];
    for values in known {
        let [low, high] = range(values);
        let clipped: Vec<f64> = values
            .iter()
            .map(|value| if value.is_nan() { *value } else { value.clamp(low, high) })
            .collect();
        for index in 1..places.len().saturating_sub(1) {
            let [a, b, c] = [places[index - 1], places[index], places[index + 1]];
            let [u, v, w] = [clipped[index - 1], clipped[index], clipped[index + 1]];
            let departs = (v - (u + (w - u) * (b - a) / (c - a))).abs();
            if 0.25 * departs > VISIBLE * (high - low) {
                bent[index] = true;
                bent[index + 1] = true;
            }
        }
    }
    bent
}

/// The least and the largest value that are drawn: beside infinite ones not all are.
fn range(values: &[f64]) -> [f64; 2] {
    let mut finite: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
    finite.sort_by(f64::total_cmp);
    let Some(last) = finite.len().checked_sub(1) else { return [0.0, 0.0] };
    let outer = |infinite: f64| {
        if values.contains(&infinite) { (CLIPPED * last as f64).ceil() as usize } else { 0 }
    };
    let (low, high) = (outer(f64::NEG_INFINITY).min(last), outer(f64::INFINITY).min(last));
    [finite[low], finite[last - high].max(finite[low])]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest departure of straight lines between the points found for a function, and how many points these are.
    fn departure(f: impl Fn(f64) -> f64, count: usize) -> (f64, usize) {
        let mut places: Vec<f64> =
            (0..count).map(|index| 2.0 * index as f64 / (count - 1) as f64 - 1.0).collect();
        let known = [places.iter().map(|&x| f(x)).collect::<Vec<f64>>()];
        let evaluate = |places: &[f64]| Ok::<_, ()>([places.iter().map(|&x| f(x)).collect()]);
        let [values] = between(&mut places, known, [-1.0, 1.0], evaluate).unwrap();
        assert!(places.is_sorted_by(|a, b| a < b) && places.len() == values.len());
        let departs = |index: usize| {
            let [a, b] = [places[index - 1], places[index]];
            (1..8)
                .map(|part| {
                    let share = f64::from(part) / 8.0;
                    let line = values[index - 1] + share * (values[index] - values[index - 1]);
                    (f(a + share * (b - a)) - line).abs()
                })
                .fold(0.0, f64::max)
        };
        ((1..places.len()).map(departs).fold(0.0, f64::max), places.len())
    }

    #[test]
    fn curves_that_are_finer_than_their_points_have_more() {
        let (missed, count) = departure(|x| (200.0 * x).cos(), 201);
        assert!(missed < 0.01 && count < MOST, "{missed:e} with {count}");
        let (_, count) = departure(|x| 1.0 - x * x, 201);
        assert_eq!(count, 201);
        // At poles the points stay bounded.
        let (_, count) = departure(|x| (1.0 - x * x).powf(-0.5), 201);
        assert!(count < 400, "{count}");
    }
}
