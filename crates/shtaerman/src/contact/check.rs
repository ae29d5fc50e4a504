//! Complementarity between the nodes: where an answer pulls and where the base penetrates.

use super::accuracy::{ROUNDING, SAFETY};
use crate::Error;
use crate::line_search::{Point, top};

/// Fewest points of a zone, or of an interval outside the zones.
pub(super) const POINTS: usize = 48;
/// Parts of an interval between two breaks (survey).
pub(super) const BETWEEN: usize = 8;

/// What is left of tension and penetration.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Check {
    /// Largest tension over the largest pressure, of a smooth surface that between the singular ends.
    pub(super) tension: f64,
    /// Largest penetration over the size of the displacements compared.
    pub(super) penetration: f64,
    /// The largest pressure.
    pub(super) largest: f64,
    /// Intervals of tension that are too large to be rounding.
    pub(super) pulling: Vec<[f64; 2]>,
    /// The same of penetration, with the deepest place in the middle.
    pub(super) penetrating: Vec<[f64; 3]>,
    /// The deepest penetration beyond rounding, a displacement: a zone that is about to open is not in the answer, and displacements may be off by as much.
    pub(super) missed: f64,
    /// Whether no node sees the tension that is listed: then there are too few.
    pub(super) is_between_nodes: bool,
}

impl Check {
    /// Of what was not looked at.
    pub(super) fn none() -> Self {
        let (pulling, penetrating) = (Vec::new(), Vec::new());
        Self {
            tension: 0.0,
            penetration: 0.0,
            largest: f64::MIN_POSITIVE,
            pulling,
            penetrating,
            missed: 0.0,
            is_between_nodes: false,
        }
    }

    /// Whether nothing is to be corrected.
    pub(super) fn is_clean(&self) -> bool {
        self.pulling.is_empty() && self.penetrating.is_empty()
    }

    pub(super) fn violation(&self) -> f64 {
        self.tension.max(self.penetration)
    }

    pub(super) fn as_error(&self) -> Error {
        Error::NotComplementary { tension: self.tension, penetration: self.penetration }
    }

    /// The same with the mirror images of what is listed right of the middle.
    pub(super) fn with_images(mut self) -> Self {
        let pulling = self.pulling.iter().rev().map(|[left, right]| [-right, -left]);
        self.pulling = pulling.chain(self.pulling.iter().copied()).collect();
        let images = self.penetrating.iter().rev().map(|place| [2, 1, 0].map(|k| -place[k]));
        self.penetrating = images.chain(self.penetrating.iter().copied()).collect();
        self
    }

    /// The intervals of penetration, narrowed by a factor towards the deepest places.
    pub(super) fn narrowed(&self, width: f64) -> Vec<[f64; 2]> {
        let narrowed = |[left, deepest, right]: &[f64; 3]| {
            [deepest - width * (deepest - left), deepest + width * (right - deepest)]
        };
        self.penetrating.iter().map(narrowed).collect()
    }

    /// Adds tension at places of a zone, over the largest pressure; beyond a threshold it is listed for correction. What is not a number is no pressure.
    pub(super) fn add_tension(&mut self, places: &[f64], tension: &[f64], [size, most]: [f64; 2]) {
        if let ([first, .., last], true) = (places, tension.iter().any(|t| t.is_nan())) {
            self.tension = f64::NAN;
            self.pulling.push([*first, *last]);
            return;
        }
        self.tension = tension.iter().fold(self.tension, |worst, t| worst.max(t / size));
        let found = above(places, tension, most);
        self.pulling.extend(found.into_iter().map(|[left, _, right]| [left, right]));
    }

    /// Adds penetration at places beside the zones, over the size of what is compared; beyond a share of that and rounding it is listed for correction.
    pub(super) fn add_penetration(
        &mut self,
        places: &[f64],
        penetration: &[f64],
        [size, allowed, rounding]: [f64; 3],
    ) {
        let deepest = penetration.iter().fold(0.0f64, |most, g| most.max(*g));
        self.penetration = self.penetration.max(deepest / size);
        self.missed = self.missed.max(deepest - rounding);
        self.penetrating.extend(above(places, penetration, allowed * size + rounding));
    }
}

/// Values at points, with the top of the parabola through each three of which the middle one is the largest: what exceeds little may do so between the points only, and what may
/// exceed zero there is looked for.
pub(super) fn with_tops(points: &[Point], value: impl Fn(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    let mut found = points.to_vec();
    let threes = points.windows(3).map(|three| [three[0], three[1], three[2]]);
    for mut three in threes.filter(|[a, b, c]| b.1 >= a.1 && b.1 >= c.1) {
        let mut missed = 0.0f64;
        // The second lies about the first: a dip may be far narrower than places are apart.
        for _ in 0..2 {
            let Some((at, expected)) = top_of(three) else { break };
            let top = (at, value(at));
            found.push(top);
            // Off from the parabola by about as much as is still to be gained.
            missed = missed.max((expected - top.1).abs());
            let mut four = [three[0], three[1], three[2], top];
            crate::order::sort_by_number(&mut four, |a| a.0);
            let largest = if four[1].1 >= four[2].1 { 1 } else { 2 };
            three = [0, 1, 2].map(|i| four[largest + i - 1]);
        }
        let highest = three[1].1;
        if missed > ROUNDING * highest.abs() && highest + SAFETY * missed > 0.0 {
            found.push(top(&value, three[0].0, three[2].0));
        }
    }
    crate::order::sort_by_number(&mut found, |a| a.0);
    found.into_iter().unzip()
}

/// The top of the parabola through three points, if it lies between them, and its height.
fn top_of([(a, u), (b, v), (c, w)]: [Point; 3]) -> Option<Point> {
    let [before, after] = [(v - u) / (b - a), (w - v) / (c - b)];
    let bend = (after - before) / (c - a);
    let top = 0.5 * (a + b) - 0.5 * before / bend;
    let height = u + (top - a) * (before + bend * (top - b));
    (a < top && top < c && top != b).then_some((top, height))
}

/// The intervals around points where the values exceed a threshold, to halfway to the nearest points where they do not, with the place of the largest value in the middle.
fn above(points: &[f64], values: &[f64], threshold: f64) -> Vec<[f64; 3]> {
    let mut intervals: Vec<[f64; 3]> = Vec::new();
    let (mut inside, mut largest) = (false, threshold);
    for i in 0..points.len() {
        let exceeds = values[i] > threshold;
        if exceeds && !inside {
            let left = if i == 0 { points[0] } else { 0.5 * (points[i - 1] + points[i]) };
            intervals.push([left, points[i], points[i]]);
            largest = threshold;
        }
        if exceeds && let Some(last) = intervals.last_mut() {
            last[2] = points.get(i + 1).map_or(points[i], |next| 0.5 * (points[i] + next));
            if values[i] > largest {
                (largest, last[1]) = (values[i], points[i]);
            }
        }
        inside = exceeds;
    }
    intervals
}

/// Places between the breaks of a profile, which may lie close about a narrow feature, and the ends of an interval.
pub(super) fn between_breaks(breaks: &[f64], [left, right]: [f64; 2]) -> Vec<f64> {
    let inside = breaks.iter().copied().filter(|xi| left < *xi && *xi < right);
    let part = |[from, to]: [f64; 2]| {
        (1..BETWEEN).map(move |i| from + (to - from) * i as f64 / BETWEEN as f64)
    };
    crate::order::parts([left, right], inside).into_iter().flat_map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A narrow top between points that are all below the threshold.
    #[test]
    fn tops_between_points_are_seen() {
        let points: Vec<f64> = (0..11).map(|i| f64::from(i) * 0.1).collect();
        let value = |x: f64| 1.0 - 400.0 * (x - 0.55).powi(2);
        let points: Vec<Point> = points.into_iter().map(|x| (x, value(x))).collect();
        let (points, values) = with_tops(&points, value);
        assert_eq!(above(&points[..5], &values[..5], 0.9).len(), 0);
        let found = above(&points, &values, 0.9);
        assert_eq!(found.len(), 1);
        assert!((found[0][1] - 0.55).abs() < 1e-12);
    }

    #[test]
    fn intervals_surround_what_exceeds() {
        let points = [0.0, 1.0, 2.0, 3.0, 4.0];
        assert_eq!(
            above(&points, &[1.0, 0.0, 0.0, 2.0, 3.0], 0.5),
            [[0.0, 0.0, 0.5], [2.5, 4.0, 4.0]]
        );
        assert!(above(&points, &[0.0; 5], 0.5).is_empty());
    }
}
