//! `G` on panels, and what follows from it: pressure and displacement.
//!
//! Between kinks `b < x` of the base `G` is smooth in `s = sqrt(x^2 - b^2)`, on graded powers but for a power `s^(1+mu)` at the kink; on each panel of `s` it
//! is a polynomial.

mod panel;
mod start;

use std::f64::consts::FRAC_PI_2;

use self::panel::{Panel, largest, rounding_of};
use self::start::{FARTHER, Seen, Start};
use super::accuracy::{DEEPEST, HARMLESS, NOISE, RESOLVED};
use super::powers::{NEAREST, PLAIN, Powers, TURN, distant};
use super::rule::{ORDER, RULE, integral, integral_at_nodes};
use super::shape::{Shape, Symmetry};

/// There are at most so many panels. Half and twice change none of 26 answers (survey).
const MOST_PANELS: usize = 128;
/// Length of a step in the logarithm of `s` within which polynomials of `s` are integrated exactly. At half or twice 24 of 25 answers change, within what they state (survey).
const STEP: f64 = 1.0;
/// Towards a kink the slope vanishes if it falls to a half over so many lengths of the first panel. Half and twice change none of 10 answers (survey).
const LENGTHS: f64 = 1024.0;
/// A first panel shorter than this share of its segment is there for a kink. Half and twice change none of 14 answers (survey).
const SHORT: f64 = 1e-5;

/// Longest share of a segment that a bend may shape alone: sixteen times as far is inside, too (theory).
const LONGEST_START: f64 = 1.0 / 16.0;
/// A first panel shorter than this share of its segment is there for a bend (survey).
const BENT: f64 = 1e-2;
/// Halvings of the first panel at most: each leaves a twentieth of what a power of 5 makes, as bends of splines do (theory).
const HALVINGS: usize = 3;
/// What polynomials on panels miss beside a power, in what their last two terms make: four at most (survey).
const MISSED: f64 = 8.0;
/// A bend that is no nearer to the middle of a zone, in radii, is known to what is stated (survey).
const BESIDE_MIDDLE: f64 = 1e-5;

/// A panel that may be halved.
struct Sampled {
    ends: [f64; 2],
    values: [f64; ORDER],
    depth: u32,
    /// The last coefficients, and those of the panel twice as long with its largest coefficient.
    tail: f64,
    before: [f64; 2],
}

fn sample(shape: &Shape<'_>, kink: f64, [from, to]: [f64; 2]) -> [f64; ORDER] {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    RULE.coefficients(&RULE.nodes.map(|u| shape.transform_beyond(kink, middle + half * u)))
}

/// The part of the disk between two kinks.
#[derive(Debug, Clone)]
struct Segment {
    /// `b` and the next kink or the edge.
    ends: [f64; 2],
    panels: Vec<Panel>,
    /// What `G` is in place of the first panels beside a bend.
    start: Option<Start>,
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
    let level = shape.transform_beyond(ends[0], 0.0);
    let mut known: Vec<f64> = (0..FARTHER)
        .map(|i| shape.transform_beyond(ends[0], longest * f64::from(1 << (FARTHER - i))))
        .collect();
    let mut best: Option<Start> = None;
    let mut before = 0.0;
    for i in 0..DEEPEST {
        let to = longest * 0.5f64.powi(i as i32);
        known.push(shape.transform_beyond(ends[0], to));
        let is_end = to < first || panels.iter().any(|panel| panel.ends[1] == to);
        if !is_end {
            continue;
        }
        match Start::new(to, level, &known[known.len() - 5..], shape.noise) {
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
fn leg(x: f64, y: f64) -> f64 {
    // Squares of small numbers would vanish.
    (x - y).max(0.0).sqrt() * (x + y).sqrt()
}

impl Segment {
    fn new(shape: &Shape<'_>, ends: [f64; 2], size: f64) -> Self {
        let sampled = |own: [f64; 2], depth: u32, before: [f64; 2]| {
            let values = sample(shape, ends[0], own);
            Sampled { ends: own, values, depth, tail: largest(&values[ORDER - 2..]), before }
        };
        let first = sampled([0.0, leg(ends[1], ends[0])], 0, [f64::INFINITY, 1.0]);
        let size = size.max(largest(&first.values));
        let rounded = shape.noise * if shape.part == Symmetry::Odd { 1.0 } else { ends[1] };
        let resolved = |own: f64| shape.tolerance.max(RESOLVED) * own + rounded;
        let noise = (10.0 * shape.tolerance).max(NOISE) * size + rounded;
        let is_open = |panel: &Sampled| {
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
        let mut panels = vec![first];
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
        let plain = Self::at_rest(ends, panels, &shape.powers);
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
        let panel = |own: [f64; 2]| Panel::new(own, sample(shape, self.ends[0], own));
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
            let halves = halves.map(|own| Panel::new(own, sample(shape, ends[0], own)));
            let panels = halves.iter().chain(&best.panels[1..]).cloned().collect();
            let next = Self::at_rest(ends, panels, &shape.powers);
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
        let is_short = |first: &&Panel| first.ends[1] < BENT * leg(self.ends[1], self.ends[0]);
        let rounded = self.panels.first().filter(is_short).map_or(0.0, |first| {
            first.blown(largest(&first.values)) * first.length().powf(powers.exponent())
        });
        // Under a kink it is infinite.
        if change.is_finite() { MISSED * (change + rounded) } else { 0.0 }
    }

    /// What the pressure beside the bend may be off by.
    fn bend_error(&self, powers: &Powers) -> f64 {
        self.start.map_or_else(|| self.missed(powers), |start| start.error(powers))
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
        Self { ends, panels, start: None }
    }

    /// The part up to `end`, by the same polynomials.
    fn within(&self, end: f64, powers: &Powers) -> Self {
        let to = leg(end, self.ends[0]);
        let kept = self.panels.iter().filter(|panel| panel.ends[0] < to);
        let panels = kept.map(|panel| panel.within(to)).collect();
        let start = self.start.filter(|start| start.to <= to);
        Self { start, ..Self::at_rest([self.ends[0], end], panels, powers) }
    }

    /// The same with less of each series.
    fn truncated(&self, powers: &Powers) -> Self {
        let less = |panel: &Panel| {
            let mut values = panel.values;
            values[ORDER - 2..].fill(0.0);
            Panel::new(panel.ends, values)
        };
        let panels = self.panels.iter().map(less).collect();
        Self { start: self.start, ..Self::at_rest(self.ends, panels, powers) }
    }

    /// `sqrt(x^2 - r^2)` or its negative square at the end `s` of a panel.
    fn beyond(&self, s: f64, r: f64) -> f64 {
        let [kink, end] = self.ends;
        let is_end = self.panels.last().is_some_and(|panel| panel.ends[1] == s);
        let (x, own) = if is_end { (end, 0.0) } else { (kink, s * s) };
        ((x - r) * (x + r) + own).abs().sqrt()
    }

    /// `int dG (x^2 - r^2)^-beta` over the part beyond `r`.
    fn pressure(&self, powers: &Powers, r: f64) -> f64 {
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
    fn displacement(&self, powers: &Powers, lever: i32, r: f64, level: f64) -> f64 {
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
    fn volume(&self, powers: &Powers, level: f64) -> f64 {
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
fn ratio(s: f64, kink: f64) -> f64 {
    if kink == 0.0 { 1.0 } else { s / s.hypot(kink) }
}

/// Gauss's rule on parts no longer than `step`.
fn stepwise(turn: [f64; 2], step: f64, f: impl Fn(f64) -> f64) -> f64 {
    in_parts(turn, step, |start, end| integral(start, end, &f))
}

/// The same for a function of all nodes of a part at once.
fn stepwise_at_nodes(turn: [f64; 2], step: f64, f: impl Fn(&[f64; ORDER]) -> [f64; ORDER]) -> f64 {
    in_parts(turn, step, |start, end| integral_at_nodes(start, end, &f))
}

fn in_parts([from, to]: [f64; 2], step: f64, part: impl Fn(f64, f64) -> f64) -> f64 {
    let length = to - from;
    if length <= 0.0 || !length.is_finite() {
        return if length <= 0.0 { 0.0 } else { f64::NAN };
    }
    let (mut from, mut sum) = (from, 0.0);
    while let Some(share) = distant(to - from) {
        sum += part(from, from + share);
        from += share;
    }
    let length = to - from;
    let count = (length / step).ceil().max(1.0);
    let width = length / count;
    let parts = (0..count as usize).map(|i| {
        let start = from + width * i as f64;
        part(start, start + width)
    });
    sum + parts.sum::<f64>()
}

/// `G` between the axis and the edge of the contact.
#[derive(Debug, Clone)]
pub struct AbelTransform {
    segments: Vec<Segment>,
    powers: Powers,
    part: Symmetry,
    is_zero: bool,
}

impl AbelTransform {
    /// Up to the radius.
    pub fn new(shape: &Shape<'_>, radius: f64) -> Self {
        let mut cuts = vec![0.0];
        cuts.extend(shape.breaks.iter().filter(|at| **at < radius));
        cuts.push(radius);
        let size = shape.transform(radius).abs();
        let segments: Vec<Segment> =
            cuts.windows(2).map(|pair| Segment::new(shape, [pair[0], pair[1]], size)).collect();
        let mut panels = segments.iter().flat_map(|segment| &segment.panels);
        let is_zero = panels.all(|panel| panel.count == 0);
        Self { segments, powers: shape.powers.clone(), part: shape.part, is_zero }
    }

    /// The same up to a smaller radius, by the same polynomials: as accurate relative to `G` at the old one. None where it ends before the middle of the first part of a segment, whose polynomial says nothing of
    /// a small share.
    #[must_use]
    pub fn within(&self, radius: f64) -> Option<Self> {
        if self.segments.last().is_some_and(|last| last.ends[1] == radius) {
            return Some(self.clone());
        }
        let inside = self.segments.iter().filter(|segment| segment.ends[0] < radius);
        let cut = |segment: &Segment| segment.within(segment.ends[1].min(radius), &self.powers);
        let segments: Vec<Segment> = inside.map(cut).collect();
        let is_told = |last: &Segment| {
            let first =
                self.segments.get(segments.len() - 1).and_then(|whole| whole.panels.first());
            let reached = last.panels.last().map_or(0.0, |panel| panel.ends[1]);
            last.panels.len() > 1 || first.is_some_and(|first| reached >= 0.5 * first.ends[1])
        };
        let is_told = segments.last().is_some_and(is_told);
        is_told.then(|| Self { segments, ..self.clone() })
    }

    /// Whether there is anything that [`truncated`](Self::truncated) leaves out.
    pub fn has_tail(&self) -> bool {
        let mut panels = self.segments.iter().flat_map(|segment| &segment.panels);
        panels.any(|panel| panel.count > ORDER - 2)
    }

    /// The same with less of each series, for a comparison.
    pub fn truncated(&self) -> Self {
        let segments = self.segments.iter().map(|segment| segment.truncated(&self.powers));
        Self { segments: segments.collect(), ..self.clone() }
    }

    /// `int_r^c G'(x) dx/(x^2 - r^2)^beta`; infinite at a kink of a homogeneous body.
    pub fn pressure(&self, r: f64) -> f64 {
        if self.is_zero {
            return 0.0;
        }
        self.segments.iter().map(|segment| segment.pressure(&self.powers, r)).sum()
    }

    /// The same at a bend or in the middle, if that lies no farther than what places are rounded to.
    pub fn pressure_about(&self, r: f64, rounding: f64) -> f64 {
        let mut bends = self.segments.iter().map(|segment| segment.ends[0]);
        let near = bends.find(|bend| (bend - r).abs() <= rounding);
        self.pressure(near.unwrap_or(r))
    }

    /// `(2/pi) cos(pi mu/2) int_0^c (level - G(x)) x^mu dx/(r^2 - x^2)^((1+mu)/2)` for `r >= c`; in the plane times `r/x` for even, `x` for odd
    /// displacements.
    pub fn displacement(&self, r: f64, level: f64) -> f64 {
        let lever = self.part.lever();
        if self.is_zero && level == 0.0 {
            return 0.0;
        }
        let of = |segment: &Segment| segment.displacement(&self.powers, lever, r, level);
        let sum: f64 = self.segments.iter().map(of).sum();
        let arm = if self.part == Symmetry::Even { r } else { 1.0 };
        self.powers.beside() * arm * sum
    }

    /// `int_0^c (level - G(x)) x^mu dx`.
    pub fn volume(&self, level: f64) -> f64 {
        self.segments.iter().map(|segment| segment.volume(&self.powers, level)).sum()
    }

    /// What the pressure beside bends may be off by. In the plane that of one next to the middle, but not at it, is not known: what either half has between them cancels, and places are rounded in lengths of the zone.
    pub fn bend_error(&self) -> f64 {
        let is_blurred = |segment: &Segment| {
            let [bend, end] = segment.ends;
            let is_near = 0.0 < bend && bend < BESIDE_MIDDLE * self.radius();
            is_near && segment.panels[0].ends[1] <= BENT * leg(end, bend)
        };
        if self.part != Symmetry::Revolution && self.segments.iter().any(is_blurred) {
            return f64::INFINITY;
        }
        self.segments.iter().map(|segment| segment.bend_error(&self.powers)).sum()
    }

    /// What rounding of `G` makes of `G'` on the longest panels of each segment.
    pub fn slope_rounding(&self) -> f64 {
        let of = |segment: &Segment| {
            let size = segment
                .panels
                .iter()
                .fold(0.0f64, |most, panel| most.max(panel.value(panel.ends[1]).abs()));
            let longest =
                (segment.panels.iter()).max_by(|one, two| one.length().total_cmp(&two.length()));
            longest.map_or(0.0, |panel| panel.blown(size))
        };
        self.segments.iter().map(of).fold(0.0, f64::max)
    }

    fn radius(&self) -> f64 {
        self.segments.last().map_or(0.0, |segment| segment.ends[1])
    }

    /// `G'(c)`.
    pub fn end_slope(&self) -> f64 {
        let Some(segment) = self.segments.last() else { return 0.0 };
        let [kink, end] = segment.ends;
        let s = leg(end, kink);
        segment.panels.last().map_or(0.0, |panel| panel.slope(s) / ratio(s, kink))
    }

    /// Number of coefficients.
    pub fn size(&self) -> usize {
        self.segments.iter().map(|segment| ORDER * segment.panels.len()).sum()
    }

    /// The kinks inside the contact, the axis first and the edge last.
    pub fn cuts(&self) -> Vec<f64> {
        let edge = self.segments.last().map(|segment| segment.ends[1]);
        self.segments.iter().map(|segment| segment.ends[0]).chain(edge).collect()
    }
}

#[cfg(test)]
mod tests;
