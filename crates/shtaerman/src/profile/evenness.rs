//! How far a profile is from its mirror image.

use std::collections::BinaryHeap;

use super::base::{Profile, Shape, line};
use super::waiting::Waiting;
use crate::expression::{Expression, Interval, Line, Reflection};

/// Pieces of a half that are looked at before any is divided, and divisions at most.
const PIECES: usize = 512;
const MOST_DIVISIONS: usize = 20_000;
/// Places in a piece of a spline at which two cubics are the same when they agree.
const PLACES: usize = 4;
/// Rounding of a height.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The difference of the two halves of a profile, in its units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unevenness {
    /// The largest `|f(x) - f(-x)|` found.
    pub(crate) found: f64,
    /// What it is anywhere, at most; infinite where no bound is known.
    pub(crate) at_most: f64,
    /// What counts as nothing.
    pub(crate) negligible: f64,
}

impl Unevenness {
    const NONE: Self = Self { found: 0.0, at_most: 0.0, negligible: 0.0 };

    /// Whether the two halves are known to be the same.
    pub(crate) fn is_negligible(&self) -> bool {
        self.at_most <= self.negligible
    }
}

impl Profile {
    /// Whether the base is proved to be its own mirror image, or its negative: by the form of an expression, by the points of a measured profile.
    pub(crate) fn reflection(&self, half_width: f64) -> Reflection {
        match &self.shape {
            Shape::Flat => Reflection::OF_ZERO,
            Shape::Expression(expression) => expression.reflection(&line(half_width)),
            Shape::Measured(spline) => spline.reflection(),
            Shape::Function(_) => Reflection::default(),
        }
    }

    /// How far the halves of the base differ; what is less than `share` of the range of heights counts as nothing.
    pub(crate) fn unevenness(&self, half_width: f64, share: f64) -> Unevenness {
        if self.reflection(half_width).is_even {
            return Unevenness::NONE;
        }
        let places = self.compared(half_width);
        let mirrored: Vec<f64> = places.iter().map(|xi| -xi).collect();
        let [right, left] = [&places, &mirrored].map(|places| self.heights(places, half_width));
        let (mut lowest, mut highest, mut found) = (f64::INFINITY, f64::NEG_INFINITY, 0.0f64);
        for (here, there) in right.into_iter().zip(left) {
            (lowest, highest) = (lowest.min(here).min(there), highest.max(here).max(there));
            found = found.max((here - there).abs());
        }
        let rounding = ROUNDING * lowest.abs().max(highest.abs());
        let negligible = share * (highest - lowest) + rounding;
        let unevenness = Unevenness { found, at_most: found, negligible };
        match &self.shape {
            Shape::Expression(expression) if found <= negligible => {
                Search { expression, line: line(half_width), unevenness }.run()
            }
            _ => unevenness,
        }
    }

    /// Places in the right half at which it is compared with the left one: of a measured profile so many that every cubic is known.
    fn compared(&self, half_width: f64) -> Vec<f64> {
        let mut joints = vec![0.0, 1.0];
        if self.measured_points().is_some() {
            joints.extend(self.joints(half_width).iter().map(|xi| xi.abs()));
        } else {
            joints.extend((1..PIECES).map(|i| i as f64 / PIECES as f64));
        }
        joints.sort_by(f64::total_cmp);
        let inside = |pair: &[f64]| {
            let [left, right] = [pair[0], pair[1]];
            (0..PLACES).map(move |i| left + (right - left) * i as f64 / PLACES as f64)
        };
        joints.windows(2).flat_map(inside).chain([1.0]).collect()
    }
}

/// The search for the largest difference: always where it can be largest.
struct Search<'e> {
    expression: &'e Expression,
    line: Line,
    unevenness: Unevenness,
}

impl Search<'_> {
    fn run(mut self) -> Unevenness {
        let cut = |i: usize| i as f64 / PIECES as f64;
        let pieces = (0..PIECES).filter_map(|i| self.piece(cut(i), cut(i + 1)));
        let mut waiting: BinaryHeap<Waiting> = pieces.collect();
        for _ in 0..MOST_DIVISIONS {
            let Some(Waiting { rank: bound, part: range }) = waiting.pop() else { break };
            self.unevenness.at_most = bound.max(self.unevenness.found);
            if self.unevenness.is_negligible() {
                break;
            }
            let middle = range.lower().midpoint(range.upper());
            let (here, there) = (self.height(middle), self.height(-middle));
            self.unevenness.found = self.unevenness.found.max((here - there).abs());
            let is_between = range.lower() < middle && middle < range.upper();
            if self.unevenness.found > self.unevenness.negligible || !is_between {
                break;
            }
            waiting.extend(self.piece(range.lower(), middle));
            waiting.extend(self.piece(middle, range.upper()));
        }
        self.unevenness
    }

    fn height(&self, xi: f64) -> f64 {
        self.expression.evaluate_at(&self.line, xi)
    }

    /// A piece of the right half with a bound of the difference there.
    fn piece(&self, left: f64, right: f64) -> Option<Waiting> {
        let range = Interval::new(left, right)?;
        let here = self.expression.enclose_along(&self.line, range);
        let there = self.expression.enclose_along(&self.line, Interval::new(-right, -left)?);
        let (one, other) = (here.interval, there.interval);
        let apart = (one.upper() - other.lower()).max(other.upper() - one.lower());
        let is_known = here.is_finite() && there.is_finite();
        Some(Waiting { rank: if is_known { apart } else { f64::INFINITY }, part: range })
    }
}
