//! The zones of contact.

use super::accuracy::ROUNDING;
use crate::Error;
use crate::intervals::joined;

/// What holds an end of a zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum EndKind {
    /// Nothing: the pressure vanishes there.
    Free,
    /// An edge of the base, or a step of it: the pressure need not vanish.
    Wall,
    /// The axis of a circular punch, which is no end of the contact.
    Axis,
}

/// A zone of contact, `[left, right]`; on a circular punch a ring, or a disk from the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Zone {
    /// Left and right end, `xi`.
    pub(super) ends: [f64; 2],
    /// What holds them.
    pub(super) kinds: [EndKind; 2],
}

impl Zone {
    /// A zone with ends that are free or walls.
    pub(super) fn new(ends: [f64; 2], is_free: [bool; 2]) -> Self {
        let kind = |is_free: bool| if is_free { EndKind::Free } else { EndKind::Wall };
        Self { ends, kinds: is_free.map(kind) }
    }

    /// A zone in the base from `-1` to 1, where walls are.
    #[cfg(test)]
    pub(super) fn within(left: f64, right: f64) -> Self {
        Self::new([left, right], [left > -1.0, right < 1.0])
    }

    /// The same as disk, if it begins at the axis.
    pub(super) fn about_axis(mut self) -> Self {
        if self.ends[0] == 0.0 {
            self.kinds[0] = EndKind::Axis;
        }
        self
    }

    pub(super) fn left(&self) -> f64 {
        self.ends[0]
    }

    pub(super) fn right(&self) -> f64 {
        self.ends[1]
    }

    pub(super) fn length(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    pub(super) fn middle(&self) -> f64 {
        0.5 * (self.ends[0] + self.ends[1])
    }

    /// How far off the middle is by rounding of the ends.
    pub(super) fn rounding(&self) -> f64 {
        ROUNDING * self.left().abs().max(self.right().abs())
    }

    /// Whether the left (0) or right (1) end is free.
    pub(super) fn is_free(&self, side: usize) -> bool {
        self.kinds[side] == EndKind::Free
    }

    pub(super) fn has_free_end(&self) -> bool {
        self.kinds.contains(&EndKind::Free)
    }

    /// The free ends, each with its side.
    pub(super) fn free_ends(&self) -> impl Iterator<Item = (usize, f64)> + use<> {
        let Self { ends, kinds } = *self;
        (0..2).filter(move |&side| kinds[side] == EndKind::Free).map(move |side| (side, ends[side]))
    }

    /// The place next to `xi` strictly inside, where at a step the height is that of this side; of a zone that no number is inside of, an end or beside it.
    pub(super) fn inside(&self, xi: f64) -> f64 {
        xi.max(self.left().next_up()).min(self.right().next_down())
    }

    pub(super) fn contains(&self, xi: f64) -> bool {
        self.ends[0] <= xi && xi <= self.ends[1]
    }

    /// The panels into which breakpoints cut the zone.
    pub(super) fn panels(&self, breaks: &[f64]) -> Vec<[f64; 2]> {
        crate::order::panels(self.ends, breaks)
    }

    /// What is left of the zone without the intervals where the pressure pulls.
    fn without(&self, pulling: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let [start, right] = self.ends;
        let mut left = start;
        let mut kept = Vec::new();
        for &[from, to] in pulling.iter().filter(|[from, to]| *to > start && *from < right) {
            if from > left {
                kept.push([left, from]);
            }
            left = left.max(to);
        }
        if left < right {
            kept.push([left, right]);
        }
        kept
    }
}

/// A penetration this close to a zone, and this short, as a share of the zone, is that of an edge which is not quite right. Half and twice change none of 10 answers (survey).
const BESIDE: f64 = 1e-2;

/// Extends an interval over a short penetration beside it; whether there was one.
fn extended(intervals: &mut [[f64; 2]], [from, to]: [f64; 2]) -> bool {
    for interval in intervals {
        let length = interval[1] - interval[0];
        let gap = (from - interval[1]).max(interval[0] - to);
        if gap <= BESIDE * length && to - from <= BESIDE * length {
            *interval = [interval[0].min(from), interval[1].max(to)];
            return true;
        }
    }
    false
}

/// Intervals of contact without those where the pressure pulls, and with those where the base penetrates; from left to right, slivers left to the next check.
pub(super) fn corrected(
    zones: &[Zone],
    pulling: &[[f64; 2]],
    penetrating: &[[f64; 2]],
) -> Vec<[f64; 2]> {
    let mut intervals: Vec<[f64; 2]> = zones.iter().flat_map(|z| z.without(pulling)).collect();
    for interval in penetrating {
        if !extended(&mut intervals, *interval) {
            intervals.push(*interval);
        }
    }
    joined(intervals)
}

/// Makes mirror images of zones that are to this share of the shorter one, where the contact is its own: so are their operators, of which a half is enough.
pub(super) fn mirror(zones: &mut [Zone], close: f64) {
    let count = zones.len();
    let is_near = |i: usize| {
        let (one, other) = (&zones[i], &zones[count - 1 - i]);
        let apart = (one.left() + other.right()).abs();
        apart <= close * one.length().min(other.length()) && one.kinds[0] == other.kinds[1]
    };
    if (0..count).all(is_near) {
        for i in 0..count {
            let at = 0.5 * (zones[i].left() - zones[count - 1 - i].right());
            (zones[i].ends[0], zones[count - 1 - i].ends[1]) = (at, -at);
        }
    }
}

/// Whether zones are mirror images to the last bit.
pub(super) fn are_images(zones: &[Zone]) -> bool {
    let pairs = zones.iter().zip(zones.iter().rev());
    pairs.into_iter().all(|(one, other)| one.left() == -other.right())
}

/// The intervals of the pieces of a base beside zones.
pub(super) fn outside(pieces: &[[f64; 2]], zones: &[Zone]) -> Vec<[f64; 2]> {
    let mut intervals = Vec::new();
    for &[first, last] in pieces {
        let mut left = first;
        for zone in zones.iter().filter(|zone| zone.left() < last && zone.right() > first) {
            if zone.left() > left {
                intervals.push([left, zone.left()]);
            }
            left = zone.right();
        }
        if left < last {
            intervals.push([left, last]);
        }
    }
    intervals
}

/// Refuses more zones than `most`: their equations are dense.
pub(super) fn require_few(zones: &[Zone], most: usize) -> Result<(), Error> {
    let zones = zones.len();
    if zones > most { Err(Error::TooManyZones { zones, most }) } else { Ok(()) }
}

/// Where an end of the contact can rest under pressure: the edges of the base, and steps of it.
#[derive(Debug, Clone)]
pub(super) struct Walls {
    /// Those of left and those of right ends, in no order.
    places: [Vec<f64>; 2],
    /// The ends of the base.
    outermost: [f64; 2],
}

impl Walls {
    /// The ends of the pieces of a base.
    pub(super) fn of(pieces: &[[f64; 2]]) -> Self {
        let places = [0, 1].map(|side| pieces.iter().map(|piece| piece[side]).collect());
        let first = pieces.first().map_or(-1.0, |piece| piece[0]);
        let last = pieces.last().map_or(1.0, |piece| piece[1]);
        Self { places, outermost: [first, last] }
    }

    /// Adds a step of the base, which rises to the right by so much: what lies higher touches first.
    pub(super) fn add_step(&mut self, at: f64, rise: f64) {
        self.places[usize::from(rise > 0.0)].push(at);
    }

    /// The next wall for a left (0) or right (1) end outwards of a place inside the contact.
    pub(super) fn beyond(&self, side: usize, inside: f64) -> f64 {
        let walls = self.places[side].iter().copied();
        if side == 0 {
            walls.filter(|wall| *wall <= inside).fold(self.outermost[0], f64::max)
        } else {
            walls.filter(|wall| *wall >= inside).fold(self.outermost[1], f64::min)
        }
    }

    /// The wall at which a left (0) or right (1) end rests that moves from one place to another: the first that it meets, the end of the base at the latest. What it may have passed before holds it no more.
    pub(super) fn crossed(&self, side: usize, [at, to]: [f64; 2]) -> Option<f64> {
        let (first, last) = (at.min(to), at.max(to));
        let walls = self.places[side].iter().chain([&self.outermost[side]]).copied();
        let is_outwards = (to > at) == (side == 1);
        let met =
            walls.filter(|wall| first <= *wall && *wall <= last && (is_outwards || *wall != at));
        met.min_by(|a, b| (a - at).abs().total_cmp(&(b - at).abs()))
    }

    /// The wall for a left (0) or right (1) end this close outwards of a place.
    pub(super) fn near(&self, side: usize, at: f64, distance: f64) -> Option<f64> {
        let outwards = |wall: f64| if side == 0 { at - wall } else { wall - at };
        let near = |wall: &f64| (0.0..=distance).contains(&outwards(*wall));
        self.places[side].iter().copied().find(near)
    }

    /// Whether there is one here.
    pub(super) fn contains(&self, at: f64) -> bool {
        self.places.iter().flatten().any(|wall| *wall == at)
    }

    /// Those strictly inside an interval, for left (0) or right (1) ends.
    pub(super) fn inside(&self, side: usize, [left, right]: [f64; 2]) -> impl Iterator<Item = f64> {
        self.places[side].iter().copied().filter(move |wall| left < *wall && *wall < right)
    }

    /// A zone whose ends are free unless they are walls, or beyond them.
    pub(super) fn zone(&self, [left, right]: [f64; 2]) -> Zone {
        let inside = 0.5 * (left + right);
        let (first, last) = (self.beyond(0, inside), self.beyond(1, inside));
        Zone::new([left.max(first), right.min(last)], [left > first, right < last])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inside_of_a_zone_without_one_is_beside_its_ends() {
        let zone = Zone::new([0.5, 1.0], [true; 2]);
        assert_eq!(
            [0.2, 0.7, 1.5].map(|xi| zone.inside(xi)),
            [0.5f64.next_up(), 0.7, 1.0f64.next_down()]
        );
        let sliver = Zone::new([0.5, 0.5f64.next_up()], [true; 2]);
        assert!((sliver.inside(0.5) - 0.5).abs() <= f64::EPSILON);
    }

    #[test]
    fn zones_are_split_and_joined() {
        let zones = [[-1.0, 0.0], [0.5, 1.0]].map(|ends| Zone::new(ends, [true; 2]));
        assert_eq!(
            corrected(&zones, &[[-0.5, -0.25]], &[]),
            [[-1.0, -0.5], [-0.25, 0.0], [0.5, 1.0]]
        );
        assert_eq!(corrected(&zones, &[], &[[0.0, 0.5]]), [[-1.0, 1.0]]);
        assert_eq!(corrected(&zones, &[[-1.0, 0.0]], &[[0.2, 0.3]]), [[0.2, 0.3], [0.5, 1.0]]);
        // An edge that was a little off.
        assert_eq!(corrected(&zones, &[[-1e-4, 0.0]], &[[1e-9, 2e-4]]), [[-1.0, 2e-4], [0.5, 1.0]]);
        assert_eq!(outside(&[[-1.0, 2.0]], &zones), [[0.0, 0.5], [1.0, 2.0]]);
    }

    #[test]
    fn what_is_nearly_even_becomes_even() {
        let mut zones = [Zone::within(-0.9, -0.3), Zone::within(0.3 + 1e-9, 0.9 - 1e-12)];
        mirror(&mut zones, 1e-6);
        assert!(are_images(&zones));
        assert!((zones[0].left() + 0.9).abs() < 1e-12 && (zones[1].left() - 0.3).abs() < 1e-9);
        let mut other = [Zone::within(-0.9, 0.8)];
        mirror(&mut other, 1e-6);
        assert_eq!(other, [Zone::within(-0.9, 0.8)]);
    }

    #[test]
    fn breakpoints_cut_zones() {
        let zone = Zone::within(-0.5, 0.5);
        assert_eq!(zone.panels(&[-0.7, 0.0, 0.5]), [[-0.5, 0.0], [0.0, 0.5]]);
    }

    #[test]
    fn ends_rest_at_walls() {
        let mut walls = Walls::of(&[[-1.0, 1.0]]);
        walls.add_step(0.25, 1.0);
        let zone = walls.zone([-2.0, 0.2]);
        assert_eq!((zone.ends, zone.is_free(0), zone.is_free(1)), ([-1.0, 0.2], false, true));
        assert_eq!(walls.zone([0.0, 0.5]), Zone::new([0.0, 0.25], [true, false]));
        assert_eq!(walls.zone([0.3, 0.5]), Zone::new([0.3, 0.5], [true; 2]));
        assert_eq!(walls.near(1, 0.25 - 1e-12, 1e-11), Some(0.25));
        assert_eq!(walls.near(1, 0.25 + 1e-12, 1e-11), None);
    }
}
