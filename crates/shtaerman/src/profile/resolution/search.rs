//! Halves a base until bounds of derivatives prove every part resolved.

use std::collections::BinaryHeap;

use super::super::base::Profile;
use super::super::waiting::Waiting;
use crate::expression::{Interval, Taylor};

/// Enclosures of Taylor coefficients at most, and their product with the length of the expression.
const MOST_ENCLOSURES: usize = 2000;
const MOST_OPERATIONS: usize = 100_000;
/// Enclosures used at most to find the range of heights.
const MOST_FOR_RANGE: usize = 400;
/// Evenly spaced heights that are looked at first, inside each segment: the value at an end may be that of a jump.
const SAMPLES: u32 = 16;
/// Parts are not halved below some roundings of the half-width.
const SHORTEST: f64 = 64.0 * f64::EPSILON;
/// Roundings of the largest height that no tolerance goes below.
const ROUNDINGS: f64 = 4.0;

/// What is aimed at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Goal {
    /// Error of a part.
    pub(super) allowed: f64,
    /// Error that is too large at the first order looked at.
    hopeless: f64,
}

/// Order looked at first, and how far its error can exceed the range of heights if that of a higher one is to be small: that of `cos(w x)`, which falls
/// the most, is `2 (w r/2)^n/n!` and no more than `1e7` at the order 8 if it is below `1e-3` at the order 64.
const FIRST_ORDER: usize = 8;
const HOPELESS: f64 = 1e8;

/// A part of the base and the bounds of the coefficients on it.
#[derive(Debug, Clone)]
pub(super) struct Leaf {
    pub(super) part: Interval,
    pub(super) bounds: Bounds,
    pub(super) outcome: Outcome,
    /// Whether something switches at its ends, so that bounds on either side say nothing of both together.
    pub(super) switches: [bool; 2],
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Outcome {
    /// Resolved, and smooth to the highest order looked at.
    Smooth,
    /// Resolved by what derivatives there are.
    Root,
    /// Nothing is proved.
    Unproved,
}

/// Bounds of the Taylor coefficients over some parts.
#[derive(Debug, Clone)]
pub(super) struct Bounds {
    range: Interval,
    /// Binary logarithms of `|f^(k)|/k!` from `k = 1` on: powers of short lengths leave the range of numbers.
    logarithms: Vec<f64>,
}

impl Bounds {
    fn of(expansion: &Taylor, degree: usize) -> Self {
        let range = expansion.range().unwrap_or(Interval::WHOLE);
        Self { range, logarithms: (1..=degree).map(|k| expansion.logarithm(k)).collect() }
    }

    /// Bounds for both.
    pub(super) fn joined(&self, other: &Self) -> Self {
        let pairs = self.logarithms.iter().zip(&other.logarithms);
        Self {
            range: self.range.hull(other.range),
            logarithms: pairs.map(|(u, v)| u.max(*v)).collect(),
        }
    }

    /// Bound of the error of interpolation at `order` points.
    fn error_at(&self, order: usize, interval: Interval) -> f64 {
        let step = (0.25 * interval.length()).log2();
        let bound = self.logarithms.get(order - 1).copied().unwrap_or(f64::INFINITY);
        (1.0 + order as f64 * step + bound).exp2()
    }

    /// Bound of the error of the best interpolation on an interval that the parts cover.
    pub(super) fn error(&self, interval: Interval) -> f64 {
        let step = (0.25 * interval.length()).log2();
        let constant = (0.5 * self.range.length()).log2();
        let errors =
            self.logarithms.iter().zip(1..).map(|(bound, k)| 1.0 + f64::from(k) * step + bound);
        errors.fold(constant, f64::min).exp2()
    }

    fn is_bounded(&self, order: usize) -> bool {
        self.logarithms.get(order - 1).is_some_and(|bound| *bound < f64::INFINITY)
    }
}

/// Parts that wait, by the stretch of the base they lie in: stretches take turns, so that a hopeless one does not use up the work of the others.
struct Queue {
    stretches: Vec<Stretch>,
}

#[derive(Default)]
struct Stretch {
    waiting: BinaryHeap<Waiting>,
    turns: usize,
}

/// Stretches of the base.
const STRETCHES: usize = 16;

impl Queue {
    fn of(segments: &[Interval]) -> Self {
        let mut queue = Self { stretches: (0..STRETCHES).map(|_| Stretch::default()).collect() };
        segments.iter().for_each(|&segment| queue.push(segment));
        queue
    }

    fn push(&mut self, part: Interval) {
        let index =
            (0.5 * (middle(part) + 1.0) * STRETCHES as f64).clamp(0.0, STRETCHES as f64 - 1.0);
        self.stretches[index as usize].waiting.push(Waiting { rank: part.length(), part });
    }

    /// The longest part of the stretch that had the fewest turns.
    fn next(&mut self) -> Option<Interval> {
        let waiting = self.stretches.iter_mut().filter(|stretch| !stretch.waiting.is_empty());
        let stretch = waiting.min_by_key(|stretch| stretch.turns)?;
        stretch.turns += 1;
        stretch.waiting.pop().map(|waiting| waiting.part)
    }
}

fn middle(part: Interval) -> f64 {
    part.lower().midpoint(part.upper())
}

fn halves(part: Interval) -> [Interval; 2] {
    let middle = middle(part);
    [Interval::ends(part.lower(), middle), Interval::ends(middle, part.upper())]
}

pub(super) struct Search<'a> {
    profile: &'a Profile,
    pub(super) half_width: f64,
    degree: usize,
    most: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        profile: &'a Profile,
        half_width: f64,
        degree: usize,
        operations: usize,
    ) -> Self {
        let most = (MOST_OPERATIONS / operations.max(1)).min(MOST_ENCLOSURES);
        Self { profile, half_width, degree, most }
    }

    /// The error that a tolerance allows.
    pub(super) fn goal(&self, segments: &[Interval], tolerance: f64) -> Goal {
        let heights = self.heights(segments);
        let rounding = ROUNDINGS * f64::EPSILON * heights.size();
        let allowed = (tolerance * heights.length()).max(rounding);
        Goal { allowed, hopeless: HOPELESS * heights.length().max(rounding) }
    }

    /// The range of heights that are met: no less than half of the true range, as far as enclosures tell.
    fn heights(&self, segments: &[Interval]) -> Interval {
        let height = |xi: f64| {
            let value = self.profile.height(xi, self.half_width);
            Interval::point(value).filter(|value| value.is_bounded())
        };
        let sample = |part: Interval, step: u32| {
            let share = (f64::from(step) + 0.5) / f64::from(SAMPLES);
            height((1.0 - share) * part.lower() + share * part.upper())
        };
        let samples = segments.iter().flat_map(|&part| (0..SAMPLES).map(move |step| (part, step)));
        let samples = samples.filter_map(|(part, step)| sample(part, step));
        let mut met = samples.reduce(Interval::hull).unwrap_or(Interval::ZERO);
        let mut waiting: BinaryHeap<_> =
            segments.iter().map(|&part| self.overshoot(part, met)).collect();
        for _ in 0..MOST_FOR_RANGE.min(self.most) {
            let Some(Waiting { rank, part }) = waiting.pop() else { break };
            let rounding = ROUNDINGS * f64::EPSILON * met.size();
            if rank <= met.length().max(rounding) {
                break;
            }
            if part.length() <= SHORTEST {
                continue;
            }
            for half in halves(part) {
                met = height(middle(half)).map_or(met, |value| met.hull(value));
                waiting.push(self.overshoot(half, met));
            }
        }
        met
    }

    /// How far the heights on a part may lie beyond those met.
    fn overshoot(&self, part: Interval, met: Interval) -> Waiting {
        let range = self.profile.expansion(part, 1, self.half_width).range();
        let beyond =
            |range: Interval| (range.upper() - met.upper()).max(met.lower() - range.lower());
        Waiting { rank: range.map_or(f64::INFINITY, beyond), part }
    }

    /// The segments cut into parts on each of which the error allowed is met, or nothing is proved: from left to right.
    pub(super) fn leaves(&self, segments: &[Interval], goal: Goal) -> Vec<Leaf> {
        let mut queue = Queue::of(segments);
        let mut leaves = Vec::new();
        let mut used = 0;
        while let Some(part) = queue.next() {
            if used == self.most {
                leaves.push(self.unproved(part));
                continue;
            }
            used += 1;
            let leaf = self.judged(part, goal);
            if leaf.outcome == Outcome::Unproved && part.length() > SHORTEST {
                halves(part).into_iter().for_each(|half| queue.push(half));
            } else {
                leaves.push(leaf);
            }
        }
        leaves.sort_by(|u, v| u.part.lower().total_cmp(&v.part.lower()));
        leaves
    }

    /// The same parts quartered where they are smooth: on shorter ones enclosures exceed less what they enclose.
    pub(super) fn quartered(&self, leaves: Vec<Leaf>) -> Vec<Leaf> {
        let is_cut = |leaf: &Leaf| leaf.outcome == Outcome::Smooth;
        if leaves.iter().filter(|leaf| is_cut(leaf)).count() * 4 > self.most {
            return leaves;
        }
        let quarters = |leaf: Leaf| {
            if !is_cut(&leaf) {
                return vec![leaf];
            }
            let [first, second] = halves(leaf.part).map(halves);
            let at_end =
                [[leaf.switches[0], false], [false; 2], [false; 2], [false, leaf.switches[1]]];
            let quarter = |(part, switches)| {
                let bounds = Bounds::of(&self.expansion(part, self.degree), self.degree);
                Leaf { part, bounds, outcome: leaf.outcome, switches }
            };
            [first, second].concat().into_iter().zip(at_end).map(quarter).collect()
        };
        leaves.into_iter().flat_map(quarters).collect()
    }

    /// Bound of the error of the best interpolation on a part.
    pub(super) fn error(&self, part: Interval) -> f64 {
        Bounds::of(&self.expansion(part, self.degree), self.degree).error(part)
    }

    fn expansion(&self, part: Interval, order: usize) -> Taylor {
        self.profile.expansion(part, order, self.half_width)
    }

    /// A part with bounds up to the degree, unless those of the first orders tell that they are of no use.
    fn judged(&self, part: Interval, goal: Goal) -> Leaf {
        let order = FIRST_ORDER.min(self.degree);
        let expansion = self.expansion(part, order);
        let switches = expansion.switches();
        let mut bounds = Bounds::of(&expansion, order);
        let last = bounds.error_at(order, part);
        bounds.logarithms.resize(self.degree, f64::INFINITY);
        let outcome = self.outcome(&bounds, part, goal.allowed);
        let is_hopeless = last > goal.hopeless && outcome == Outcome::Unproved;
        if is_hopeless || !bounds.is_bounded(order) {
            return Leaf { part, bounds, outcome, switches };
        }
        let bounds = Bounds::of(&self.expansion(part, self.degree), self.degree);
        let outcome = self.outcome(&bounds, part, goal.allowed);
        Leaf { part, bounds, outcome, switches }
    }

    fn outcome(&self, bounds: &Bounds, part: Interval, allowed: f64) -> Outcome {
        // Far from a step that is too steep for its derivatives to be enclosed.
        let is_flat = bounds.range.length() <= allowed * part.length();
        if is_flat {
            return Outcome::Smooth;
        }
        // A kink is found to rounding rather than hidden in a part so short that it does not matter.
        if !bounds.is_bounded(2) || bounds.error(part) > allowed {
            return Outcome::Unproved;
        }
        if bounds.is_bounded(self.degree) { Outcome::Smooth } else { Outcome::Root }
    }

    fn unproved(&self, part: Interval) -> Leaf {
        let logarithms = vec![f64::INFINITY; self.degree];
        let bounds = Bounds { range: Interval::WHOLE, logarithms };
        Leaf { part, bounds, outcome: Outcome::Unproved, switches: [false; 2] }
    }
}
