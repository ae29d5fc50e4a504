//! `G` from one bend to the next, on panels of `s`.

use std::f64::consts::FRAC_PI_2;

use super::super::accuracy::{DEEPEST, HARMLESS, NOISE, RESOLVED};
use super::super::powers::{NEAREST, PLAIN, Powers, TURN};
use super::super::rule::{ORDER, RULE, integral};
use super::super::shape::{Shape, Symmetry};
use super::panel::{Panel, largest, rounding_of};
use super::start::{FARTHER, Seen, Start};
use super::steps::{STEP, stepwise, stepwise_at_nodes};

/// There are at most so many panels. Half and twice change none of 26 answers (survey).
const MOST_PANELS: usize = 128;
/// Towards a kink the slope vanishes if it falls to a half over so many lengths of the first panel. Half and twice change none of 10 answers (survey).
const LENGTHS: f64 = 1024.0;
/// A first panel shorter than this share of its segment is there for a kink. Half and twice change none of 14 answers (survey).
const SHORT: f64 = 1e-5;
/// Beside a bend that has another next to it, or the axis, panels are this many times as long as they are away from there (survey: 48 disks are known to rounding).
const LONGER: f64 = 4.0;
/// Up to this share of the radius a bend counts as next to the axis (survey: with all of it one or two bends take twice as long for nothing).
const NEXT_TO_AXIS: f64 = 0.1;
/// Longest share of a segment that a bend may shape alone: sixteen times as far is inside, too (theory).
const LONGEST_START: f64 = 1.0 / 16.0;
/// A first panel shorter than this share of its segment is there for a bend (survey).
const BENT: f64 = 1e-2;
/// Halvings of the first panel at most: each leaves a twentieth of what a power of 5 makes, as bends of splines do (theory).
const HALVINGS: usize = 3;
/// What polynomials on panels miss beside a power, in what their last two terms make: four at most, 24 beside `s^2 ln s` (survey).
const MISSED: f64 = 32.0;

/// A panel that may be halved.
struct Sampled {
    ends: [f64; 2],
    values: [f64; ORDER],
    /// What rounded places make of the values.
    blur: f64,
    depth: u32,
    /// The last coefficients, and those of the panel twice as long with its largest coefficient.
    tail: f64,
    before: [f64; 2],
}

/// The coefficients, and what rounded places make of the values.
fn sample(shape: &Shape<'_>, kink: f64, [from, to]: [f64; 2]) -> ([f64; ORDER], f64) {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let known = RULE.nodes.map(|u| shape.transform_beyond(kink, middle + half * u));
    let blur = known.iter().fold(0.0f64, |most, [_, blur]| most.max(*blur));
    (RULE.coefficients(&known.map(|[value, _]| value)), blur)
}

/// The part of the disk between two kinks.
#[derive(Debug, Clone)]
pub(super) struct Segment {
    /// `b` and the next kink or the edge.
    pub(super) ends: [f64; 2],
    /// How far in `s` the bend before `b`, or the axis, lies apart from it; infinite where `b` is the axis.
    apart: f64,
    pub(super) panels: Vec<Panel>,
    /// What `G` is in place of the first panels beside a bend.
    pub(super) start: Option<Start>,
}

/// Whether the first panel of a segment is there for a kink: beside the middle all is as short as the distance from it.
fn is_for_kink(first: &Panel, ends: [f64; 2]) -> bool {
    let length = leg(ends[1], ends[0]);
    first.ends[1] < SHORT * if ends[0] > 0.0 { length.min(ends[0]) } else { length }
}

/// What may stand for the first panels of a segment that begins with a bend, or in the middle, where they are there for a power. It is shortened by halves as long as that pays: the next power says less, and rounding more.
fn started(shape: &Shape<'_>, ends: [f64; 2], panels: &[Panel]) -> Option<Start> {
    let first = panels.first()?.ends[1];
    let length = leg(ends[1], ends[0]).min(if ends[0] > 0.0 { ends[0] } else { ends[1] });
    let longest = first * (LONGEST_START * length / first).log2().floor().exp2();
    let at_bend = shape.transform_beyond(ends[0], 0.0);
    // At a tip the slope is infinite, and `G` begins with a power above zero.
    let [level, mut blur] = if at_bend[0].is_finite() { at_bend } else { [0.0; 2] };
    let exactness = shape.noise + shape.inexactness() * level.abs();
    let mut at = |s: f64| {
        let [value, own] = shape.transform_beyond(ends[0], s);
        blur = blur.max(own);
        (value, exactness + blur)
    };
    let mut known: Vec<f64> =
        (0..FARTHER).map(|i| at(longest * f64::from(1 << (FARTHER - i))).0).collect();
    let mut best: Option<Start> = None;
    let mut before = 0.0;
    for i in 0..DEEPEST {
        let to = longest * 0.5f64.powi(i as i32);
        let (value, noise) = at(to);
        known.push(value);
        let is_end = to < first || panels.iter().any(|panel| panel.ends[1] == to);
        if !is_end {
            continue;
        }
        match Start::seen(to, level, &known[known.len() - 5..], noise) {
            Seen::Power(start) => {
                // A difference may vanish by chance: no half is said to be better than the next power makes it.
                let start = start.half_of(before);
                let error = start.error(&shape.powers);
                if best.is_some_and(|best| error >= best.error(&shape.powers)) {
                    break;
                }
                (best, before) = (Some(start), start.error);
            }
            Seen::Other if best.is_none() => {}
            _ => break,
        }
    }
    // Under a kink of homogeneous ground the pressure is infinite. What an odd part has in the middle is felt times the distance from there.
    let is_odd = ends[0] == 0.0 && shape.part == Symmetry::Odd;
    best.filter(|start| is_odd || start.is_finite(&shape.powers))
}

/// `sqrt(x^2 - y^2)` for `x >= y`.
pub(super) fn leg(x: f64, y: f64) -> f64 {
    // Squares of small numbers would vanish.
    (x - y).max(0.0).sqrt() * (x + y).sqrt()
}

impl Segment {
    /// From one bend to the next or to the edge. The bend before, or the axis, lies `apart` in `s` beyond the first; `size` is `G` at the edge of all, `radius`.
    pub(super) fn new(
        shape: &Shape<'_>,
        ends: [f64; 2],
        apart: f64,
        [size, radius]: [f64; 2],
    ) -> Self {
        let sampled = |own: [f64; 2], depth: u32, before: [f64; 2]| {
            let (values, blur) = sample(shape, ends[0], own);
            let tail = largest(&values[ORDER - 2..]);
            Sampled { ends: own, values, blur, depth, tail, before }
        };
        // G is shaped by what lies apart from the bend, but for rounding of the whole, on panels that are as long as they are away from there.
        let length = leg(ends[1], ends[0]);
        let nearest = apart.max(f64::EPSILON * length);
        let cuts = std::iter::successors(Some(nearest), |cut| Some(LONGER * cut));
        let cuts: Vec<f64> = cuts.take_while(|cut| LONGER * cut < length).collect();
        let begins = std::iter::once(0.0).chain(cuts.iter().copied());
        let first = begins.zip(cuts.iter().copied().chain([length]));
        let mut panels: Vec<Sampled> =
            first.map(|(from, to)| sampled([from, to], 0, [f64::INFINITY, 1.0])).collect();
        let size = panels.iter().fold(size, |most, panel| most.max(largest(&panel.values)));
        let rounded = shape.noise * if shape.part == Symmetry::Odd { 1.0 } else { ends[1] };
        let is_open = |panel: &Sampled| {
            let rounded = rounded + panel.blur;
            let resolved = |own: f64| shape.tolerance.max(RESOLVED) * own + rounded;
            // Slopes of short panels blow up what they miss: beside a bend that lies next to the axis G is to be known as under a paraboloid, however small it is there.
            let beyond = if ends[0] > 0.0 { ends[0].hypot(panel.ends[1]) } else { radius };
            let share = (beyond / (NEXT_TO_AXIS * radius)).min(1.0);
            let size = largest(&panel.values).max(share * share * size).min(size);
            let noise = (10.0 * shape.tolerance).max(NOISE) * size + rounded;
            let [before, whole] = panel.before;
            // Beside the axis G is as small as the power of the base has it, and its slope is divided by the distance: there all is held against its own size, and rounding is what a panel drops.
            let is_beside_axis = ends[0] == 0.0 && panel.ends[0] == 0.0;
            let own = if is_beside_axis { largest(&panel.values) } else { size };
            let (before, noise) = if is_beside_axis {
                (before * (own / whole), rounding_of(ORDER - 1) * own + rounded)
            } else {
                (before, noise)
            };
            let is_noise = panel.tail >= 0.5 * before && panel.tail <= noise;
            let is_settled = panel.tail <= resolved(own) || is_noise;
            !is_settled && panel.depth < DEEPEST && panel.tail.is_finite()
        };
        while panels.len() < MOST_PANELS && !(shape.is_over)() {
            let open = panels.iter().enumerate().filter(|(_, panel)| is_open(panel));
            let worst = open.max_by(|one, two| one.1.tail.total_cmp(&two.1.tail));
            let Some((i, Sampled { ends: [from, to], values, depth, tail, .. })) = worst else {
                break;
            };
            let (middle, depth, before) = (0.5 * (from + to), depth + 1, [*tail, largest(values)]);
            let halves = [[*from, middle], [middle, *to]].map(|own| sampled(own, depth, before));
            panels.splice(i..=i, halves);
        }
        let panels: Vec<Panel> =
            panels.iter().map(|panel| Panel::new(panel.ends, panel.values)).collect();
        let plain = Self { apart, ..Self::at_rest(ends, panels, &shape.powers) };
        let missed = plain.missed(&shape.powers);
        if missed <= NOISE * plain.pressure(&shape.powers, ends[0]).abs() {
            return plain;
        }
        let start = started(shape, ends, &plain.panels);
        match start.filter(|start| start.error(&shape.powers) < missed) {
            Some(start) => plain.beyond_start(shape, start),
            None => plain.halved(shape, missed),
        }
    }

    /// The same with panels from the end of a start on, each four times as long as the one before.
    fn beyond_start(mut self, shape: &Shape<'_>, start: Start) -> Self {
        let panel = |own: [f64; 2]| Panel::new(own, sample(shape, self.ends[0], own).0);
        let mut to = self.panels[0].ends[1];
        let mut added = Vec::new();
        while to > start.to {
            let from = (0.25 * to).max(start.to);
            added.push(panel([from, to]));
            to = from;
        }
        if !added.is_empty() {
            added.push(panel([0.0, to]));
            added.reverse();
            self.panels.splice(..1, added);
        }
        Self { start: Some(start), ..self }
    }

    /// The same with a shorter first panel, as long as that pays: less of a power is missed.
    fn halved(self, shape: &Shape<'_>, mut missed: f64) -> Self {
        let (ends, mut best) = (self.ends, self);
        for _ in 0..HALVINGS {
            let Some([from, to]) = best.panels.first().map(|panel| panel.ends) else { break };
            let middle = 0.5 * (from + to);
            let halves = [[from, middle], [middle, to]];
            let halves = halves.map(|own| Panel::new(own, sample(shape, ends[0], own).0));
            let panels = halves.iter().chain(&best.panels[1..]).cloned().collect();
            let next = Self { apart: best.apart, ..Self::at_rest(ends, panels, &shape.powers) };
            let left = next.missed(&shape.powers);
            if left > 0.5 * missed {
                break;
            }
            (best, missed) = (next, left);
            if missed <= NOISE * best.pressure(&shape.powers, ends[0]).abs() {
                break;
            }
        }
        best
    }

    /// What polynomials miss of the pressure at the bend.
    fn missed(&self, powers: &Powers) -> f64 {
        let at_bend = |segment: &Self| segment.pressure(powers, self.ends[0]);
        let change = (at_bend(self) - at_bend(&self.truncated(powers))).abs();
        // The rounding of long panels is felt everywhere, and stated for all.
        let short = self.panels.first().filter(|_| self.is_bent());
        let rounded = short.map_or(0.0, |first| {
            first.blown(largest(&first.values)) * first.length().powf(powers.exponent())
        });
        // Under a kink it is infinite.
        if change.is_finite() { MISSED * (change + rounded) } else { 0.0 }
    }

    /// Whether its panels are short at the bend.
    pub(super) fn is_bent(&self) -> bool {
        let [bend, end] = self.ends;
        let length = leg(end, bend).min(self.apart);
        self.panels.first().is_some_and(|first| first.ends[1] <= BENT * length)
    }

    /// What polynomials miss of the pressure beside the end, where the base may bend from this side as well: no place sees more of it than those in the last panel.
    fn missed_at_end(&self, powers: &Powers) -> f64 {
        let [kink, end] = self.ends;
        let last = self.panels.last();
        let Some(last) = last.filter(|last| last.length() <= BENT * leg(end, kink)) else {
            return 0.0;
        };
        let less = self.truncated(powers);
        let [from, to] = last.ends;
        // Where the nodes crowd it is most.
        let crowd = last.length() / (ORDER * ORDER) as f64;
        let changes = [from, 0.5 * (from + to), to - crowd].map(|s| {
            let r = kink.hypot(s);
            (self.pressure(powers, r) - less.pressure(powers, r)).abs()
        });
        // Under a kink it is infinite.
        let change = changes.into_iter().filter(|change| change.is_finite()).fold(0.0, f64::max);
        MISSED * change
    }

    /// What the pressure beside the bend may be off by.
    pub(super) fn bend_error(&self, powers: &Powers) -> f64 {
        let at_bend = self.start.map_or_else(|| self.missed(powers), |start| start.error(powers));
        at_bend + self.missed_at_end(powers)
    }

    /// On graded ground `G` rises from a bend as a power above 1 of `s`, but where a kink was not told.
    fn at_rest(ends: [f64; 2], mut panels: Vec<Panel>, powers: &Powers) -> Self {
        if let Some(first) = panels.first_mut()
            && powers.exponent() > 0.0
            && ends[0] > 0.0
            && !is_for_kink(first, ends)
        {
            *first = first.clone().with_rest();
        }
        Self { ends, apart: f64::INFINITY, panels, start: None }
    }

    /// The part up to `end`, by the same polynomials.
    pub(super) fn within(&self, end: f64, powers: &Powers) -> Self {
        let to = leg(end, self.ends[0]);
        let kept = self.panels.iter().filter(|panel| panel.ends[0] < to);
        let panels = kept.map(|panel| panel.within(to)).collect();
        let start = self.start.filter(|start| start.to <= to);
        let apart = self.apart;
        Self { start, apart, ..Self::at_rest([self.ends[0], end], panels, powers) }
    }

    /// The same with less of each series.
    pub(super) fn truncated(&self, powers: &Powers) -> Self {
        let less = |panel: &Panel| {
            let mut values = panel.values;
            values[ORDER - 2..].fill(0.0);
            Panel::new(panel.ends, values)
        };
        let panels = self.panels.iter().map(less).collect();
        let (start, apart) = (self.start, self.apart);
        Self { start, apart, ..Self::at_rest(self.ends, panels, powers) }
    }

    /// `sqrt(x^2 - r^2)` or its negative square at the end `s` of a panel.
    fn beyond(&self, s: f64, r: f64) -> f64 {
        let [kink, end] = self.ends;
        let is_end = self.panels.last().is_some_and(|panel| panel.ends[1] == s);
        let (x, own) = if is_end { (end, 0.0) } else { (kink, s * s) };
        ((x - r) * (x + r) + own).abs().sqrt()
    }

    /// `int dG (x^2 - r^2)^-beta` over the part beyond `r`.
    pub(super) fn pressure(&self, powers: &Powers, r: f64) -> f64 {
        let [kink, end] = self.ends;
        if r >= end {
            return 0.0;
        }
        if r == kink {
            return if powers.exponent() == 0.0 {
                self.at_kink(powers)
            } else {
                self.at_place(powers)
            };
        }
        let is_inside = r > kink;
        // s = scale cosh y or scale sinh y
        let scale = if is_inside { leg(r, kink) } else { leg(kink, r) };
        let mut sum = match &self.start {
            Some(start) if !is_inside => start.outside(powers, scale),
            Some(start) if start.to > scale => start.inside(powers, scale),
            _ => 0.0,
        };
        for panel in self.resolved().filter(|panel| !is_inside || panel.ends[1] > scale) {
            let place = |s: f64| {
                if is_inside {
                    if s <= scale { 0.0 } else { (self.beyond(s, r) / scale).asinh() }
                } else {
                    (s / scale).asinh()
                }
            };
            let turn = panel.ends.map(place);
            sum += if powers.exponent() == 0.0 {
                stepwise_at_nodes(turn, STEP, |y| {
                    let hyperbolic = if is_inside { f64::cosh } else { f64::sinh };
                    panel.slopes_at(&y.map(|y| scale * hyperbolic(y)))
                })
            } else if is_inside {
                let f = |y: f64| panel.slope(scale * y.cosh()) * powers.power(scale * y.sinh());
                powers.graded(0, turn, [STEP, f64::INFINITY], f)
            } else {
                stepwise_at_nodes(turn, STEP, |y| {
                    let slopes = panel.slopes_at(&y.map(|y| scale * y.sinh()));
                    std::array::from_fn(|i| slopes[i] * powers.power(scale * y[i].cosh()))
                })
            };
        }
        sum
    }

    /// The panels that a start does not stand for.
    fn resolved(&self) -> impl Iterator<Item = &Panel> {
        let from = self.start.map_or(0.0, |start| start.to);
        self.panels.iter().filter(move |panel| panel.ends[0] >= from)
    }

    /// `int dG s^(mu-1)`: at a kink `G` rises as `s^(1+mu)`.
    fn at_place(&self, powers: &Powers) -> f64 {
        let Some(first) = self.panels.first() else { return 0.0 };
        let mu = powers.exponent();
        let f = |panel: &Panel, s: f64| panel.slope(s) * s.powf(mu - 1.0);
        let mut sum = if let Some(start) = &self.start {
            start.at_bend(powers)
        } else {
            // Rounding of a slope that vanishes would be blown up by 1/mu.
            let start = first.slope(0.0);
            let rounded =
                if start.abs() > first.blown(largest(&first.values)) { 0.0 } else { start };
            powers.integral(-1, first.ends, |s| f(first, s) - rounded * s.powf(mu - 1.0))
        };
        for panel in self.resolved().filter(|panel| panel.ends[0] > 0.0) {
            sum += powers.graded(-1, panel.ends, [f64::INFINITY; 2], |s| f(panel, s));
        }
        sum
    }

    /// `int dG/s`, infinite where the base has a kink.
    fn at_kink(&self, powers: &Powers) -> f64 {
        let Some(first) = self.panels.first() else { return 0.0 };
        let beyond =
            |panel: &Panel| stepwise(panel.ends.map(f64::ln), STEP, |y| panel.slope(y.exp()));
        if let Some(start) = &self.start {
            return start.at_bend(powers) + self.resolved().map(beyond).sum::<f64>();
        }
        let slope = first.slope(0.0);
        let largest = self.largest_slope();
        let far = LENGTHS * first.ends[1];
        let falls = (self.panels.iter())
            .find(|panel| panel.ends[0] <= far && far < panel.ends[1])
            .is_some_and(|panel| first.slope(first.ends[1]).abs() < 0.5 * panel.slope(far).abs());
        if slope.abs() > HARMLESS * largest && !falls {
            return f64::INFINITY.copysign(slope);
        }
        let near = integral(0.0, first.ends[1], |s| (first.slope(s) - slope) / s);
        near + self.panels[1..].iter().map(beyond).sum::<f64>()
    }

    fn largest_slope(&self) -> f64 {
        let at = |panel: &Panel| panel.ends.map(|s| panel.slope(s).abs());
        self.panels.iter().flat_map(at).fold(0.0, f64::max)
    }

    /// `int (level - G) x^(mu+l) dx/(r^2 - x^2)^((1+mu)/2)`, `r` not inside.
    pub(super) fn displacement(&self, powers: &Powers, lever: i32, r: f64, level: f64) -> f64 {
        let kink = self.ends[0];
        let scale = leg(r, kink);
        let mut sum = 0.0;
        for panel in &self.panels {
            let place = |s: f64| s.atan2(self.beyond(s, r));
            let turn = panel.ends.map(place);
            if powers.exponent() == 0.0 && lever == 0 {
                sum += stepwise_at_nodes(turn, TURN, |y| {
                    let places = y.map(|y| scale * y.sin());
                    let values = panel.values_at(&places);
                    std::array::from_fn(|i| (level - values[i]) * ratio(places[i], kink))
                });
                continue;
            }
            let depth = |y: f64| {
                let s = scale * y.sin();
                (level - panel.value(s)) * ratio(s, kink)
            };
            let graded = |y: f64| {
                let x = kink.hypot(scale * y.sin());
                depth(y) * powers.power(x / (scale * y.cos())) * x.powi(lever)
            };
            let shift = if kink == 0.0 { lever } else { PLAIN };
            let mut turn = turn;
            if kink > 0.0 && turn[0] == 0.0 {
                // A power of x is none beyond the kink, however close to the axis.
                let first = turn[1].min(NEAREST * kink / scale);
                sum += powers.integral(PLAIN, [0.0, first], graded);
                turn[0] = first;
            }
            sum += powers.graded(shift, turn, [TURN, FRAC_PI_2], graded);
        }
        sum
    }

    /// `int (level - G) x^mu dx`.
    pub(super) fn volume(&self, powers: &Powers, level: f64) -> f64 {
        let kink = self.ends[0];
        let shift = if kink == 0.0 { 0 } else { PLAIN };
        let of = |panel: &Panel| {
            powers.integral(shift, panel.ends, |s| {
                (level - panel.value(s)) * ratio(s, kink) * powers.power(kink.hypot(s))
            })
        };
        self.panels.iter().map(of).sum()
    }
}

/// `dx/ds`.
pub(super) fn ratio(s: f64, kink: f64) -> f64 {
    if kink == 0.0 { 1.0 } else { s / s.hypot(kink) }
}
