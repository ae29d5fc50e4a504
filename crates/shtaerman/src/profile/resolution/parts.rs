//! Joins proved parts as long as the error allowed is met on them together.

use std::cmp::Ordering;

use super::Resolution;
use super::search::{Bounds, Leaf, Outcome, Search};
use crate::expression::Interval;

/// Nothing proved on an interval shorter than this is a single place.
const PLACE: f64 = 1e-11;
/// From one cut to the next towards a singular place distances shrink by this.
const GRADING: f64 = 1.5;

/// Collects the cuts of the segments.
pub(super) struct Partition<'a> {
    search: &'a Search<'a>,
    allowed: f64,
    found: Resolution,
}

/// Proved parts in a row; an end is a cut that may be singular.
struct Row<'a> {
    leaves: &'a [Leaf],
    left: End,
    right: End,
}

#[derive(Debug, Clone, Copy)]
struct End {
    place: f64,
    is_singular: bool,
}

impl<'a> Partition<'a> {
    pub(super) fn new(search: &'a Search<'a>, allowed: f64) -> Self {
        Self { search, allowed, found: Resolution::default() }
    }

    pub(super) fn finish(self) -> Resolution {
        self.found
    }

    /// Adds the cuts inside a segment that is made of these parts.
    pub(super) fn add(&mut self, segment: Interval, leaves: &[Leaf]) {
        let is_proved = |leaf: &Leaf| leaf.outcome != Outcome::Unproved;
        let mut left = End { place: segment.lower(), is_singular: false };
        let is_joined = |u: &Leaf, v: &Leaf| {
            let switches = is_proved(u) && (u.switches[1] || v.switches[0]);
            is_proved(u) == is_proved(v) && !switches
        };
        let mut is_after_proved = false;
        for run in leaves.chunk_by(is_joined) {
            let (Some(first), Some(last)) = (run.first(), run.last()) else { continue };
            let hull = first.part.hull(last.part);
            if !is_proved(first) {
                left = self.leave_out(hull, segment);
                is_after_proved = false;
                continue;
            }
            if is_after_proved {
                left = End { place: hull.lower(), is_singular: false };
                self.found.joints.push(hull.lower());
            }
            is_after_proved = true;
            let mut right = End { place: hull.upper(), is_singular: false };
            // What follows, if it is a single place, is the end of this row.
            let after = leaves.partition_point(|leaf| leaf.part.lower() < hull.upper());
            let gap = leaves[after..].iter().take_while(|leaf| !is_proved(leaf)).last();
            if let Some(gap) = gap {
                let gap = Interval::ends(hull.upper(), gap.part.upper());
                right = self.end_at(gap, segment, hull.upper());
            }
            self.cut(&Row { leaves: run, left, right });
        }
    }

    /// The place of an interval on which nothing is proved: an end of the segment that it touches, or its middle; a long one ends the row.
    fn end_at(&self, gap: Interval, segment: Interval, beside: f64) -> End {
        if gap.length() > PLACE {
            return End { place: beside, is_singular: false };
        }
        let place = if gap.lower() == segment.lower() {
            segment.lower()
        } else if gap.upper() == segment.upper() {
            segment.upper()
        } else {
            gap.lower().midpoint(gap.upper())
        };
        End { place, is_singular: true }
    }

    /// Reports an interval on which nothing is proved and returns where the next row starts.
    fn leave_out(&mut self, gap: Interval, segment: Interval) -> End {
        let end = self.end_at(gap, segment, gap.upper());
        let is_inside = |place: f64| segment.lower() < place && place < segment.upper();
        if end.is_singular {
            self.found.singular.push(end.place);
            self.found.joints.extend(Some(end.place).filter(|&place| is_inside(place)));
            return end;
        }
        let ends = [gap.lower(), gap.upper()];
        self.found.joints.extend(ends.into_iter().filter(|&place| is_inside(place)));
        match self.found.unresolved.last_mut() {
            Some(last) if last[1] == ends[0] => last[1] = ends[1],
            _ => self.found.unresolved.push(ends),
        }
        end
    }

    fn cut(&mut self, row: &Row<'_>) {
        let (Some(first), Some(last)) = (row.leaves.first(), row.leaves.last()) else { return };
        let whole = first.part.hull(last.part);
        let joints = self.joints(row.leaves, whole);
        let at_root =
            |leaf: &Leaf, end: End| leaf.outcome == Outcome::Root && leaf.part.contains(end.place);
        let is_rough = [
            row.left.is_singular || at_root(first, row.left),
            row.right.is_singular || at_root(last, row.right),
        ];
        if joints.is_empty() || !is_rough.contains(&true) {
            self.found.joints.extend(joints);
            return;
        }
        // The parts next to a singular place are left to be graded towards it.
        let start = |leaf: &Leaf, end: End, near: f64, far: f64| {
            if leaf.outcome == Outcome::Root {
                (far - end.place).abs()
            } else {
                (near - end.place).abs()
            }
        };
        let mut middle = [whole.lower(), whole.upper()];
        if is_rough[0] {
            let from = start(first, row.left, first.part.lower(), first.part.upper());
            middle[0] = self.reach(row.leaves, row.left.place, from, whole.upper());
            self.note_root(row.left);
        }
        if is_rough[1] {
            let from = start(last, row.right, last.part.upper(), last.part.lower());
            middle[1] = self.reach(row.leaves, row.right.place, from, whole.lower());
            self.note_root(row.right);
        }
        if middle[0] >= middle[1] {
            return;
        }
        let kept = [(middle[0], is_rough[0]), (middle[1], is_rough[1])];
        let kept = kept.into_iter().filter(|&(place, is_rough)| {
            is_rough && whole.lower() < place && place < whole.upper()
        });
        self.found.joints.extend(kept.map(|(place, _)| place));
        let between = Interval::ends(middle[0], middle[1]);
        let joints = self.joints(covering(row.leaves, between), between);
        self.found.joints.extend(joints);
    }

    fn note_root(&mut self, end: End) {
        if !end.is_singular {
            self.found.singular.push(end.place);
        }
    }

    /// How far from a singular place parts graded towards it meet the error allowed, in the direction of `limit`, given the distance at which they begin.
    fn reach(&self, leaves: &[Leaf], singular: f64, from: f64, limit: f64) -> f64 {
        let side = (limit - singular).signum();
        let most = (limit - singular).abs();
        let mut distance = from;
        while distance < most {
            let next = (GRADING * distance).min(most);
            let (near, far) = (singular + side * distance, singular + side * next);
            let part = Interval::ends(near.min(far), near.max(far));
            // A leaf that is short enough for any slope may reach too near to the place for bounds of a part of it.
            if !self.is_met(leaves, part) && self.search.error(part) > self.allowed {
                return near;
            }
            distance = next;
        }
        limit
    }

    fn is_met(&self, leaves: &[Leaf], interval: Interval) -> bool {
        let bounds = covering(leaves, interval).iter().map(|leaf| leaf.bounds.clone());
        let joined = bounds.reduce(|u, v| u.joined(&v));
        joined.is_none_or(|bounds| bounds.error(interval) <= self.allowed)
    }

    /// As few cuts of an interval as possible, mirrored if the parts are.
    ///
    /// Walks from the left give the latest places of the cuts, walks from the right the earliest; half-way between them parts are most even. If
    /// that does not do, each cut is taken from the walk that starts nearer: then the middle part is shorter than it need be and the others are
    /// parts of either walk.
    fn joints(&self, leaves: &[Leaf], interval: Interval) -> Vec<f64> {
        let latest = self.walk(leaves.iter(), interval, interval.lower(), Interval::upper);
        let mut earliest =
            self.walk(leaves.iter().rev(), interval, interval.upper(), Interval::lower);
        earliest.reverse();
        let even: Vec<f64> = latest.iter().zip(&earliest).map(|(u, v)| u.midpoint(*v)).collect();
        let ends = |cuts: &[f64]| [&[interval.lower()], cuts, &[interval.upper()]].concat();
        let is_met = |ends: &[f64]| self.is_met(leaves, Interval::ends(ends[0], ends[1]));
        if ends(&even).windows(2).all(is_met) {
            return even;
        }
        let count = even.len();
        let nearer = |k: usize| match (2 * k + 1).cmp(&count) {
            Ordering::Less => latest[k],
            Ordering::Equal => even[k],
            Ordering::Greater => earliest[k],
        };
        (0..count).map(nearer).collect()
    }

    /// Cuts before the first part with which the error allowed is no longer met.
    fn walk<'b>(
        &self,
        leaves: impl Iterator<Item = &'b Leaf>,
        interval: Interval,
        start: f64,
        far_end: impl Fn(Interval) -> f64,
    ) -> Vec<f64> {
        let (mut cuts, mut start, mut end) = (Vec::new(), start, start);
        let mut joined: Option<Bounds> = None;
        for leaf in leaves {
            let next = far_end(leaf.part).clamp(interval.lower(), interval.upper());
            let with = joined
                .as_ref()
                .map_or_else(|| leaf.bounds.clone(), |bounds| bounds.joined(&leaf.bounds));
            let stretch = Interval::ends(start.min(next), start.max(next));
            if joined.is_some() && with.error(stretch) > self.allowed {
                cuts.push(end);
                start = end;
                joined = Some(leaf.bounds.clone());
            } else {
                joined = Some(with);
            }
            end = next;
        }
        cuts
    }
}

/// The parts that share more than an end with an interval.
fn covering(leaves: &[Leaf], interval: Interval) -> &[Leaf] {
    let first = leaves.partition_point(|leaf| leaf.part.upper() <= interval.lower());
    let end = leaves.partition_point(|leaf| leaf.part.lower() < interval.upper());
    &leaves[first..end.max(first)]
}
