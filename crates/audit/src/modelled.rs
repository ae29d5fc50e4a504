//! The base by polynomials, each off by a known amount: an enclosure of a formula costs more than all else at a place.
//!
//! On an interval of half-length `r` the polynomial through values at `n` Chebyshev nodes misses `2 (r/2)^n max |f^(n)|/n!`, the derivative enclosed, and what the values are off by times
//! Lebesgue's constant. It is summed in twice the precision, so that nothing else is lost.

use crate::allowance::UNIT;
use crate::chebyshev::{lebesgue, nodes};
use crate::double::{Doubles, LANES, NEGLIGIBLE, chebyshev, placed};
use crate::effort::Effort;
use crate::profile::Profile;
use crate::vectorised::vectorised;

/// Numbers of nodes of a piece.
const COUNTS: [usize; 7] = [4, 6, 8, 12, 16, 20, HIGHEST];
/// Order up to which derivatives are asked for.
const HIGHEST: usize = 24;
/// What a polynomial may miss beside what heights are known to, as a share of the unit of the residual; or as a share of what heights are known to.
const MISSED: f64 = 0.05;
const KNOWN: f64 = 0.25;
/// Nodes of an interval that are few enough not to try halves; more than this many are not taken.
const FEW: usize = 48;
const MOST: usize = 8192;
/// Halves are taken where they need at most this share of the nodes.
const WORTH: f64 = 0.7;
/// Looks at a panel that take as long as to look up bounds that are kept.
const KEPT: u64 = 1;
/// The share of what an audit may take that goes into polynomials, at most: where nothing is left the base is asked for anew each time (survey: 30,000 looks at most for 180 plausible problems of 1,250,000; a formula that
/// bends at `1e-12` of its length would take ten million, for nothing).
const SHARE: u64 = 4;
/// A height takes this share of what derivatives take, and a look for the sums (survey: at most 0.04 us an operation of a formula, where derivatives take 0.3 to 0.5).
const OF_DERIVATIVES: u64 = 14;
/// Intervals are not halved below this length.
const SHORTEST: f64 = 1e-4;
/// Within this distance of a place where the base may jump a formula may leave open on which side a number is: there heights are asked for anew.
const BESIDE: f64 = 1024.0 * f64::EPSILON;
/// Nodes that are rounded more than this, times their number cubed, do not serve.
const PLACED: f64 = 0.5;

/// A base that stands for another one.
pub(crate) struct Modelled<'a> {
    profile: &'a dyn Profile,
    regions: Vec<Region>,
    pieces: Vec<Piece>,
    /// Those of the places given where the base was not found to be smooth.
    cuts: Vec<f64>,
    /// Looks that are left.
    room: u64,
}

/// An interval with bounds of the derivatives on it, shown by some pieces of equal length.
#[derive(Debug)]
struct Region {
    left: f64,
    right: f64,
    /// Of `|f^(n)|/n!`.
    bounds: Vec<f64>,
    /// Whether the base is smooth where the region to the left of this one ends.
    is_joined: bool,
}

/// A polynomial that stands for the base.
#[derive(Debug)]
struct Piece {
    left: f64,
    right: f64,
    centre: f64,
    inverse: f64,
    /// Chebyshev coefficients in `(x - centre) inverse`, as sums of two numbers.
    coefficients: Vec<[f64; 2]>,
    error: f64,
    /// A bound of the slope.
    slope: f64,
}

impl<'a> Modelled<'a> {
    /// A base on some intervals, from left to right, of which residuals are wanted to `unit`; it may jump at `cuts` within them.
    pub(crate) fn new(
        profile: &'a dyn Profile,
        intervals: &[[f64; 2]],
        cuts: &[f64],
        unit: f64,
    ) -> Self {
        let room = Effort::new(cuts).looks / SHARE;
        let mut found = Self { profile, regions: vec![], pieces: vec![], cuts: vec![], room };
        for interval in intervals {
            let inside = cuts.iter().filter(|cut| interval[0] < **cut && **cut < interval[1]);
            let inside: Vec<f64> = inside.copied().collect();
            found.divide(*interval, &inside, unit);
        }
        let is_open = |cut: &f64| !found.is_smooth_at(*cut);
        found.cuts = cuts.iter().copied().filter(is_open).collect();
        found
    }

    /// Where the base may jump or bend.
    pub(crate) fn cuts(&self) -> &[f64] {
        &self.cuts
    }

    /// Whether the base is known to be smooth about a place.
    pub(crate) fn is_smooth_at(&self, x: f64) -> bool {
        let index = self.regions.partition_point(|region| region.right < x);
        let Some(region) = self.regions.get(index) else { return false };
        if x < region.right {
            return region.left < x;
        }
        self.regions.get(index + 1).is_some_and(|next| next.left == x && next.is_joined)
    }

    /// Adds regions that cover an interval, as far as the base can be shown there.
    fn divide(&mut self, interval: [f64; 2], cuts: &[f64], unit: f64) {
        let mut stack = vec![self.tried(interval, false, unit)];
        while let Some(tried) = stack.pop() {
            if tried.nodes() <= FEW {
                self.add(tried);
                continue;
            }
            let [left, right] = tried.interval;
            let middle = 0.5 * (left + right);
            let inside = cuts.iter().copied().filter(|cut| left < *cut && *cut < right);
            let nearest = inside.min_by(|a, b| (a - middle).abs().total_cmp(&(b - middle).abs()));
            let at = nearest.unwrap_or(middle);
            if right - left <= SHORTEST && nearest.is_none() {
                self.add(tried);
                continue;
            }
            let is_smooth = tried.is_smooth();
            let first = self.tried([left, at], tried.is_joined, unit);
            let last = self.tried([at, right], is_smooth, unit);
            let halves = first.nodes().saturating_add(last.nodes());
            if tried.nodes() <= MOST && halves as f64 > WORTH * tried.nodes() as f64 {
                self.add(tried);
            } else {
                stack.push(last);
                stack.push(first);
            }
        }
    }

    fn tried(&mut self, interval: [f64; 2], is_joined: bool, unit: f64) -> Tried {
        if !self.takes(self.profile.looks(interval)) {
            return Tried { interval, bounds: Vec::new(), is_joined, best: None };
        }
        let bounds = self.profile.taylor_bounds(interval, HIGHEST);
        let [low, high] = self.profile.height(0.5 * (interval[0] + interval[1]));
        let known = 0.5 * KNOWN * (high - low);
        let wanted = if known.is_finite() { known.max(MISSED * unit) } else { 0.0 };
        let half = 0.5 * (interval[1] - interval[0]);
        let best = (COUNTS.into_iter())
            .filter_map(|count| Some((count, parts(count, half, *bounds.get(count)?, wanted)?)))
            .min_by_key(|(count, parts)| count * parts);
        Tried { interval, bounds, is_joined, best }
    }

    /// Takes so many looks, if they are left; from then on, none.
    fn takes(&mut self, looks: u64) -> bool {
        let left = self.room.checked_sub(looks);
        self.room = left.unwrap_or(0);
        left.is_some()
    }

    fn add(&mut self, tried: Tried) {
        let Tried { interval: [left, right], bounds, is_joined, best } = tried;
        let Some((count, parts)) = best.filter(|(count, parts)| count * parts <= MOST) else {
            return;
        };
        let a_node = 1 + self.profile.looks([left, right]) / OF_DERIVATIVES;
        if !self.takes((count * parts) as u64 * a_node) {
            return;
        }
        let end = |i: usize| {
            let share = i as f64 / parts as f64;
            if i == parts { right } else { left + share * (right - left) }
        };
        let before = self.pieces.len();
        for i in 0..parts {
            match Piece::new(self.profile, [end(i), end(i + 1)], count, &bounds) {
                Some(piece) => self.pieces.push(piece),
                None => {
                    self.pieces.truncate(before);
                    return;
                }
            }
        }
        self.regions.push(Region { left, right, bounds, is_joined });
    }

    /// The piece of a place, where the base is shown by one and a formula leaves nothing open.
    fn piece_at(&self, x: f64) -> Option<&Piece> {
        let after = self.cuts.partition_point(|cut| *cut < x);
        let is_beside = |cut: Option<&f64>| cut.is_some_and(|cut| (x - cut).abs() <= BESIDE);
        if is_beside(self.cuts.get(after))
            || is_beside(after.checked_sub(1).and_then(|i| self.cuts.get(i)))
        {
            return None;
        }
        let piece = self.pieces.get(self.pieces.partition_point(|piece| piece.right < x))?;
        (piece.left <= x).then_some(piece)
    }

    /// The regions that an interval touches in more than an end, if they cover it and the base is smooth where they meet.
    fn regions_of(&self, [left, right]: [f64; 2]) -> Option<&[Region]> {
        let first = self.regions.partition_point(|region| region.right <= left);
        let last = self.regions.partition_point(|region| region.left < right);
        let regions = self.regions.get(first..last)?;
        let (one, other) = (regions.first()?, regions.last()?);
        let is_covered = one.left <= left && right <= other.right;
        let joined = |pair: &[Region]| pair[0].right == pair[1].left && pair[1].is_joined;
        (is_covered && regions.windows(2).all(joined)).then_some(regions)
    }
}

/// An interval with what is known of the base on it, and the least number of nodes, times pieces, that show it.
struct Tried {
    interval: [f64; 2],
    bounds: Vec<f64>,
    is_joined: bool,
    best: Option<(usize, usize)>,
}

impl Tried {
    fn nodes(&self) -> usize {
        self.best.map_or(usize::MAX, |(count, parts)| count.saturating_mul(parts))
    }

    fn is_smooth(&self) -> bool {
        self.bounds.get(HIGHEST).is_some_and(|bound| bound.is_finite())
    }
}

/// Into how many parts an interval is to be cut for so many nodes on each.
fn parts(count: usize, half: f64, bound: f64, wanted: f64) -> Option<usize> {
    if !bound.is_finite() || wanted <= 0.0 {
        return None;
    }
    // 2 (r/2)^n bound <= wanted
    let longest = 2.0 * (0.5 * wanted / bound).powf(1.0 / count as f64);
    let parts = (half / longest).ceil().max(1.0);
    (parts <= MOST as f64).then_some(parts as usize)
}

impl Piece {
    fn new(
        profile: &dyn Profile,
        [left, right]: [f64; 2],
        count: usize,
        bounds: &[f64],
    ) -> Option<Self> {
        let centre = 0.5 * (left + right);
        let half = (right - centre).max(centre - left);
        // No place of the piece is beyond 1.
        let inverse = (1.0 - 4.0 * f64::EPSILON) / half;
        let at = nodes(count);
        let places: Vec<f64> =
            at.places.iter().map(|t| (centre + half * t).clamp(left, right)).collect();
        let (mut heights, mut off) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let mut ranges = vec![[0.0; 2]; count];
        profile.heights(&places, &mut ranges);
        for [low, high] in ranges {
            let height = 0.5 * (low + high);
            heights.push(height);
            off.push((high - height).max(height - low));
        }
        let mut piece = Self {
            left,
            right,
            centre,
            inverse,
            coefficients: vec![[0.0; 2]; count],
            error: 0.0,
            slope: bounds.get(1).copied().unwrap_or(f64::INFINITY),
        };
        // What sums of cosines lose is found by looking at the nodes.
        let middle = heights[count / 2];
        let changes: Vec<f64> = heights.iter().map(|height| height - middle).collect();
        for (c, own) in piece.coefficients.iter_mut().zip(at.coefficients(&changes)) {
            c[0] = own;
        }
        let (first, lost) = crate::sum::two_sum(piece.coefficients[0][0], middle);
        piece.coefficients[0] = [first, lost];
        let missed = piece.missed(&places, &heights);
        for (c, own) in piece.coefficients.iter_mut().zip(at.coefficients(&missed)) {
            c[1] += own;
        }
        let missed = piece.missed(&places, &heights);
        let largest = missed.iter().zip(&off).fold(0.0f64, |most, (a, b)| most.max(a.abs() + b));
        // Nodes are rounded.
        let moved = (places.iter().zip(&at.places))
            .map(|(x, t)| ((x - centre) * inverse - t).abs())
            .fold(0.0, f64::max)
            + 4.0 * UNIT;
        let n = count as f64;
        let crowded = moved * n * n * n;
        if crowded.is_nan() || crowded > PLACED {
            return None;
        }
        let lebesgue = lebesgue(count);
        let bound = bounds.get(count).copied().unwrap_or(f64::INFINITY);
        let interpolation =
            if bound == 0.0 { 0.0 } else { 2.0 * (0.5 * half).powi(count as i32) * bound };
        let sizes: f64 = piece.coefficients.iter().map(|[high, low]| high.abs() + low.abs()).sum();
        // By Markov's inequality a polynomial changes by n^2 for each unit of its place.
        piece.error = (1.0 + 1e-9)
            * (lebesgue * largest / (1.0 - lebesgue * moved * n * n).max(0.0)
                + interpolation * (1.0 + 4.0 * crowded)
                + NEGLIGIBLE * sizes
                + f64::MIN_POSITIVE);
        piece.error.is_finite().then_some(piece)
    }

    /// What the polynomial misses of heights at places.
    fn missed(&self, places: &[f64], heights: &[f64]) -> Vec<f64> {
        let [high, low] = self.evaluated(places);
        (heights.iter().zip(high).zip(low))
            .map(|((height, high), low)| (height - high) - low)
            .collect()
    }

    /// Its values as sums of two numbers.
    fn evaluated(&self, places: &[f64]) -> [Vec<f64>; 2] {
        let mut found = [Vec::with_capacity(places.len()), Vec::with_capacity(places.len())];
        for some in places.chunks(LANES) {
            let Doubles { high, low } = self.lanes(some);
            found[0].extend(&high[..some.len()]);
            found[1].extend(&low[..some.len()]);
        }
        found
    }

    fn lanes(&self, places: &[f64]) -> Doubles {
        let mut x = [self.centre; LANES];
        x[..places.len()].copy_from_slice(places);
        vectorised(
            #[inline(always)]
            || chebyshev(&self.coefficients, &placed(&x, self.centre, self.inverse)),
        )
    }

    /// Bounds of the base at places on it.
    fn heights(&self, places: &[f64], found: &mut [[f64; 2]]) {
        for (some, found) in places.chunks(LANES).zip(found.chunks_mut(LANES)) {
            let value = self.lanes(some);
            for (range, value) in found.iter_mut().zip(value.high) {
                let off = self.error + 2.0 * UNIT * value.abs();
                *range = [value - off, value + off];
            }
        }
    }

    /// A bound of the base on a part of the piece.
    fn range(&self, [left, right]: [f64; 2]) -> [f64; 2] {
        let middle = (0.5 * (left + right)).clamp(left, right);
        let mut found = [[0.0; 2]];
        self.heights(&[middle], &mut found);
        let change = (1.0 + 4.0 * f64::EPSILON) * self.slope * (right - middle).max(middle - left);
        let [low, high] = found[0];
        [low - change - UNIT * low.abs(), high + change + UNIT * high.abs()]
    }
}

impl Profile for Modelled<'_> {
    fn height(&self, x: f64) -> [f64; 2] {
        let mut found = [[0.0; 2]];
        self.heights(&[x], &mut found);
        found[0]
    }

    fn heights(&self, places: &[f64], found: &mut [[f64; 2]]) {
        let mut from = 0;
        while let Some(x) = places.get(from) {
            let Some(piece) = self.piece_at(*x) else {
                let is_off = |x: &&f64| self.piece_at(**x).is_none();
                let to = from + places[from..].iter().take_while(is_off).count();
                self.profile.heights(&places[from..to], &mut found[from..to]);
                from = to;
                continue;
            };
            let is_on =
                |x: &f64| piece.left <= *x && *x <= piece.right && self.piece_at(*x).is_some();
            let count = places[from..].iter().take_while(|x| is_on(x)).count();
            piece.heights(&places[from..from + count], &mut found[from..from + count]);
            from += count;
        }
    }

    fn range(&self, interval: [f64; 2]) -> [f64; 2] {
        let [left, right] = interval;
        if self.regions_of(interval).is_none() {
            return self.profile.range(interval);
        }
        let first = self.pieces.partition_point(|piece| piece.right <= left);
        let touched = self.pieces[first..].iter().take_while(|piece| piece.left < right);
        touched
            .map(|piece| piece.range([left.max(piece.left), right.min(piece.right)]))
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [from, to]| {
                [low.min(from), high.max(to)]
            })
    }

    fn taylor_bounds(&self, interval: [f64; 2], order: usize) -> Vec<f64> {
        let Some(regions) = self.regions_of(interval) else {
            return self.profile.taylor_bounds(interval, order);
        };
        (0..=order)
            .map_while(|n| {
                let mut bounds = regions.iter().map(|region| region.bounds.get(n).copied());
                bounds.try_fold(0.0f64, |most, bound| Some(most.max(bound?)))
            })
            .collect()
    }

    fn looks(&self, interval: [f64; 2]) -> u64 {
        if self.regions_of(interval).is_some() { KEPT } else { self.profile.looks(interval) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closed::Base;

    /// Places all over an interval, from left to right.
    fn places([left, right]: [f64; 2]) -> Vec<f64> {
        let count = 5000;
        (0..=count).map(|k| left + (right - left) * f64::from(k) / f64::from(count)).collect()
    }

    #[test]
    fn heights_are_where_they_are_said_to_be() {
        for base in [Base { c: 1.0, bend: 2.0, kappa: 1.0 }, Base { c: 0.6, bend: 0.3, kappa: 0.5 }]
        {
            let model = Modelled::new(&base, &[[-1.0, 1.0]], &[], 4e-15);
            let all = places([-1.0, 1.0]);
            let mut found = vec![[0.0; 2]; all.len()];
            model.heights(&all, &mut found);
            for (x, [low, high]) in all.iter().zip(found) {
                let [from, to] = base.height(*x);
                let exact = 0.5 * (from + to);
                let off = 0.5 * (to - from);
                assert!(low <= exact + off && exact - off <= high, "{x}: {low} {high} {exact}");
                assert!(high - low <= 10.0 * (to - from) + 1e-14, "{x}: {:e}", high - low);
            }
        }
    }

    /// A base with very many waves is shown as far as the work suffices, and no farther.
    #[test]
    fn waves_without_number_have_an_end() {
        struct Waves;
        impl Profile for Waves {
            fn height(&self, x: f64) -> [f64; 2] {
                let f = (1e7 * x).sin();
                [f - 1e-15, f + 1e-15]
            }
            fn range(&self, _: [f64; 2]) -> [f64; 2] {
                [-1.0, 1.0]
            }
            fn taylor_bounds(&self, _: [f64; 2], order: usize) -> Vec<f64> {
                let bound = |n: usize| (1..=n).fold(1.0, |bound, k| bound * 1e7 / k as f64);
                (0..=order).map(bound).collect()
            }
            fn looks(&self, _: [f64; 2]) -> u64 {
                20
            }
        }
        let model = Modelled::new(&Waves, &[[-1.0, 1.0]], &[], 1e-14);
        let nodes: usize = model.pieces.iter().map(|piece| piece.coefficients.len()).sum();
        let room = Effort::new(&[]).looks / SHARE;
        assert!(0 < nodes && nodes as u64 <= room, "{nodes}");
        assert_eq!(model.height(0.9), Waves.height(0.9));
    }
}
