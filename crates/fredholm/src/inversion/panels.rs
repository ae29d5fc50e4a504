//! Panels on which a slope is a polynomial, halved until it is, with their integrals against the pole.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::accuracy::{DEEPEST, NOISE, OF_A_VALUE, ROUNDING};
use super::angular::Angular;
use super::roots::{Beside, Cusp, Local, Side};
use super::rule::{ORDER, RULE, cauchy, derivative, polynomials};

/// There are at most so many panels. Half and twice change none of 32 answers (survey).
const MOST_PANELS: usize = 40_000;
/// The nodes next to the ends of a panel are this share of it away from them, less rounding. Half and twice change none of 32 answers (survey).
const BLURRED: f64 = 1e3;
/// Beside a power below one of the distance halving ends where the last coefficients of a panel are rounding. They fall as the power of its length, and the faster with the degree the nearer the power is to
/// one: up to 0.95 at most so many times farther away (theory).
const UNRESOLVED: f64 = 100.0;
/// A last coefficient that keeps this share when a panel is halved does not fall.
const STAYS: f64 = 0.6;
/// Half of a panel so short that what is left is noise if it is the same in both halves: without it a ring a millionth as wide as its radius is not found, as heights beside its bottom are
/// noise (test `a_narrow_ring_is_a_line_of_hertz`).
const FASTEST: f64 = 1e-4;
/// A pole so many half-lengths from the middle of a panel is far. At half or twice 1 of 32 differ beyond what is stated and stated errors grow up to 4e+03 times (survey).
const FAR: f64 = 2.5;
/// As near by the angle, too: between short panels the difference of two places has lost its digits, not that of their ends: at this distance three of sixteen (rounding).
const BESIDE: f64 = 1e-3;
/// Distances below this count as this: where panels meet, the logarithms of either side cancel to rounding. At half or twice stated errors grow up to 1.3 times (survey).
const CLOSEST: f64 = 1e-30;
/// Below this the difference of the cotangent and its pole is summed as a series. At half or twice stated errors grow up to 5.8 times (survey).
const SERIES: f64 = 0.3;

/// A piece of the angle with the polynomial that the slope is there.
#[derive(Debug, Clone)]
pub(super) struct Panel {
    pub(super) start: f64,
    pub(super) end: f64,
    pub(super) values: [f64; ORDER],
    coefficients: [f64; ORDER],
    /// What the slope is instead, with the same moments, where it goes as a power of the distance from an end.
    cusp: Option<Cusp>,
    /// Whether `t = 0` is the nearer end of the half turn.
    is_first: bool,
    /// `g(t) sin t` with its weights, and `sin^2(t/2)` or `cos^2(t/2)` of the nearer end.
    masses: [f64; ORDER],
    squares: [f64; ORDER],
    sines: [f64; ORDER],
}

impl Panel {
    fn new(start: f64, end: f64, coefficients: [f64; ORDER]) -> Self {
        let values = RULE.values(&coefficients);
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        let is_first = middle < FRAC_PI_2;
        let angles = RULE.nodes.map(|u| middle + half * u);
        let squares = angles.map(|t| square(t, is_first));
        let sines = angles.map(f64::sin);
        let mut masses = sines;
        for (i, mass) in masses.iter_mut().enumerate() {
            *mass *= half * RULE.weights[i] * values[i];
        }
        Self { start, end, values, coefficients, cusp: None, is_first, masses, squares, sines }
    }

    fn with_cusp(start: f64, end: f64, cusp: Cusp) -> Self {
        Self { cusp: Some(cusp), ..Self::new(start, end, cusp.coefficients()) }
    }

    /// `g` at both ends.
    pub(super) fn ends(&self) -> [f64; 2] {
        let even: f64 = self.coefficients.iter().step_by(2).sum();
        let odd: f64 = self.coefficients.iter().skip(1).step_by(2).sum();
        [even - odd, even + odd]
    }

    pub(super) fn middle(&self) -> f64 {
        0.5 * (self.start + self.end)
    }

    pub(super) fn half(&self) -> f64 {
        0.5 * (self.end - self.start)
    }

    pub(super) fn at(&self, angle: f64) -> f64 {
        let u = (angle - self.middle()) / self.half();
        polynomials(u).iter().zip(&self.coefficients).map(|(p, c)| p * c).sum()
    }

    /// `p.v. int g(t)/(t - pole) dt` for a pole so far to the right of both ends.
    fn cauchy(&self, [from_left, from_right]: [f64; 2]) -> f64 {
        let half = self.half();
        if let Some(cusp) = &self.cusp {
            let length = 2.0 * half;
            return cusp.cauchy(from_left / length, from_right / length, CLOSEST / length);
        }
        let apart = |distance: f64| if distance.abs() < CLOSEST { CLOSEST } else { distance };
        cauchy(&self.coefficients, apart(from_left) / half, apart(from_right) / half)
    }

    /// Whether nothing shorter would show more.
    pub(super) fn is_blurred(&self, blur: f64) -> bool {
        self.half() <= BLURRED * blur
    }

    /// `int g(t) atan(sin t/(excess + 1 - side cos t)) dt` by the nodes.
    pub(super) fn turned(&self, excess: f64, side: f64) -> f64 {
        let half = self.half();
        let is_near = self.is_first == (side > 0.0);
        let term = |i: usize| {
            let square = if is_near { self.squares[i] } else { 1.0 - self.squares[i] };
            RULE.weights[i] * self.values[i] * self.sines[i].atan2(excess + 2.0 * square)
        };
        half * (0..ORDER).map(term).sum::<f64>()
    }

    /// `p.v. int g(t) [cot((t - angle)/2) + cot((t + angle)/2)] dt` on a half turn.
    pub(super) fn both_cotangents(&self, angle: f64) -> f64 {
        let reach = (FAR * self.half()).max(BESIDE);
        let middle = self.middle();
        let mirrored = (middle + angle).min(TAU - middle - angle);
        if (middle - angle).abs() <= reach || mirrored <= reach {
            return self.cotangent(angle) + self.cotangent(-angle);
        }
        // sin t / (sin^2(t/2) - sin^2(angle/2)), whose difference keeps its digits at either end
        let other = square(angle, self.is_first);
        let sum: f64 = self
            .masses
            .iter()
            .zip(&self.squares)
            .map(|(mass, square)| mass / (square - other))
            .sum();
        if self.is_first { sum } else { -sum }
    }

    /// `p.v. int g(t) cot((t - pole)/2) dt`.
    pub(super) fn cotangent(&self, pole: f64) -> f64 {
        let half = self.half();
        let offset = self.middle() - pole;
        let turns = (offset / TAU).round() * TAU;
        let pole = if turns == 0.0 { pole } else { pole + turns };
        let near = (offset - turns).abs() <= (FAR * half).max(BESIDE);
        let mut sum = 0.0;
        for (i, value) in self.values.iter().enumerate() {
            let z = self.middle() + half * RULE.nodes[i] - pole;
            let kernel = if near { without_pole(z) } else { 1.0 / (0.5 * z).tan() };
            sum += RULE.weights[i] * value * kernel;
        }
        sum *= half;
        if near {
            let distances = [self.start, self.end].map(|end| pole - end);
            sum += 2.0 * self.cauchy(distances);
        }
        sum
    }
}

/// Puts cusps in place of panels that cannot follow the slope beside places where it goes as a power of the distance, which bends tell, and tells what `F` may be off by for that.
pub(super) fn follow_cusps(
    panels: &mut [Panel],
    local: &Local<'_>,
    threshold: f64,
    is_cusp: impl Fn(f64) -> bool,
) -> f64 {
    let count = panels.len();
    let (mut worst, mut hidden) = (0.0f64, 0.0);
    for i in 0..count {
        let next = (i + 1) % count;
        let is_end = local.is_odd && next == 0;
        let at = panels[i].end;
        let blur = UNRESOLVED * local.profile.blur(at);
        if is_end || ![i, next].iter().any(|k| panels[*k].is_blurred(blur)) || !is_cusp(at) {
            continue;
        }
        let beside = [(i, false), (next, true)];
        let sides = beside.map(|(k, is_right)| {
            // At an end of a half turn there is no neighbour that says how far the slope rises.
            let is_last = local.is_odd && k == if is_right { count - 1 } else { 0 };
            let is_short = panels[k].is_blurred(blur) && !is_last;
            if is_short { local.side(at, is_right, threshold) } else { Beside::Smooth }
        });
        // A side that is resolved says what the slope is at the place.
        let value = match sides {
            [Beside::Smooth, Beside::Smooth] => continue,
            [Beside::Smooth, _] => panels[i].ends()[1],
            [_, Beside::Smooth] => panels[next].ends()[0],
            [Beside::Power(left), Beside::Power(right)] => 0.5 * (left.value + right.value),
            _ => 0.5 * (panels[i].ends()[1] + panels[next].ends()[0]),
        };
        let outer =
            [panels[(i + count - 1) % count].ends()[1], panels[(next + 1) % count].ends()[0]];
        let rises = outer.map(|outer| outer - value);
        let is_flat = |(side, rise): (&Beside, f64)| {
            matches!(side, Beside::Smooth) || rise.abs() <= threshold
        };
        if sides.iter().zip(rises).all(is_flat) {
            continue;
        }
        for (((k, is_right), side), rise) in beside.into_iter().zip(sides).zip(rises) {
            let side: Side = match side {
                Beside::Smooth => continue,
                Beside::Power(side) => side,
                Beside::Unclear => return f64::INFINITY,
            };
            let cusp = Cusp { is_right, value, rise, power: side.power };
            panels[k] = Panel::with_cusp(panels[k].start, panels[k].end, cusp);
            // What rounded places make of the slope on the panels next to it.
            let places = OF_A_VALUE / f64::EPSILON * local.profile.blur(at) / panels[k].half();
            // What goes with the distance is taken for a part of the power.
            let leaning = (1.0 / side.power - 1.0) / PI * (panels[k].half() * side.lean).abs();
            hidden += side.hidden * rise.abs();
            worst = worst.max((side.error + side.power * places) * rise.abs() + leaning);
        }
    }
    worst + hidden
}

fn square(angle: f64, is_first: bool) -> f64 {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    if is_first { sine * sine } else { cosine * cosine }
}

/// `cot(z/2) - 2/z`.
fn without_pole(z: f64) -> f64 {
    if z.abs() > SERIES {
        return 1.0 / (0.5 * z).tan() - 2.0 / z;
    }
    let s = z * z;
    -z * (1.0 / 6.0
        + s * (1.0 / 360.0 + s * (1.0 / 15120.0 + s * (1.0 / 604_800.0 + s / 23_950_080.0))))
}

/// Makes neighbours meet but for the angles where the slope jumps, and tells how it jumps there; an odd slope vanishes at both ends, if it nearly does.
pub(super) fn join(
    panels: &mut [Panel],
    is_odd: bool,
    threshold: f64,
    is_jump: impl Fn(f64) -> bool,
) -> Vec<(f64, f64)> {
    let mut jumps = Vec::new();
    let count = panels.len();
    let mut changes = vec![[0.0; 2]; count];
    for i in 0..count {
        let next = (i + 1) % count;
        // A cusp meets its neighbours as it is.
        if [i, next].iter().any(|k| panels[*k].cusp.is_some()) {
            continue;
        }
        let [last, first] = [panels[i].ends()[1], panels[next].ends()[0]];
        let is_end = next == 0 && is_odd;
        let size = if is_end { last.abs().max(first.abs()) } else { (first - last).abs() };
        if size > threshold && (is_end || is_jump(panels[i].end)) {
            if !is_end {
                jumps.push((panels[i].end, first - last));
            }
            continue;
        }
        // What an end is moved by spreads over its panel: a short one at a root of the distance moves to a long one, and not that to it.
        let [half, other] = [panels[i].half(), panels[next].half()];
        let meeting = (last * half + first * other) / (half + other);
        let [to_last, to_first] = if is_end { [0.0; 2] } else { [meeting; 2] };
        changes[i][1] = to_last - last;
        changes[next][0] = to_first - first;
    }
    let moved = panels.iter_mut().zip(changes).filter(|(panel, _)| panel.cusp.is_none());
    for (panel, [left, right]) in moved {
        let mut coefficients = panel.coefficients;
        coefficients[0] += 0.5 * (left + right);
        coefficients[1] += 0.5 * (right - left);
        *panel = Panel::new(panel.start, panel.end, coefficients);
    }
    jumps
}

/// Halves panels until the slope is resolved.
pub(super) struct Builder<'p> {
    pub(super) profile: &'p dyn Angular,
    pub(super) panels: Vec<Panel>,
    /// `int f dt`.
    pub(super) sum: f64,
    /// Largest error of `g`.
    pub(super) worst: f64,
    /// Largest `|f|`, and whether slopes were taken of heights.
    pub(super) heights: f64,
    pub(super) is_by_heights: bool,
    /// Largest `|f|` and `|g|`.
    pub(super) scale: [f64; 2],
    pub(super) tolerance: f64,
}

/// What samples of an interval tell.
pub(super) struct Sampled {
    coefficients: [f64; ORDER],
    integral: f64,
    /// Largest `|f|` and `|g|`.
    sizes: [f64; 2],
    /// Last coefficients of what was sampled, and whether that is the slope.
    tail: f64,
    is_slope: bool,
}

impl Builder<'_> {
    /// Samples between the first cuts, which give the scale.
    pub(super) fn first(&mut self, cuts: &[f64]) -> Vec<Sampled> {
        let samples: Vec<Sampled> =
            cuts.windows(2).map(|pair| self.sample(pair[0], pair[1])).collect();
        self.scale = samples.iter().fold([0.0; 2], |most, Sampled { sizes, .. }| {
            [most[0].max(sizes[0]), most[1].max(sizes[1])]
        });
        samples
    }

    fn sample(&self, start: f64, end: f64) -> Sampled {
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        let angles = RULE.nodes.map(|u| middle + half * u);
        let tangents = self.profile.tangents(&angles);
        let heights: [f64; ORDER] = std::array::from_fn(|k| tangents[k].0);
        let integral = half * heights.iter().zip(&RULE.weights).map(|(h, w)| h * w).sum::<f64>();
        let slopes: [Option<f64>; ORDER] = std::array::from_fn(|k| tangents[k].1);
        let is_slope = slopes.iter().all(Option::is_some);
        // Where a formula loses its slope at a place, as that of asin(sin(x)) at a crest, it is that of the panel.
        let secant = (self.profile.height(end) - self.profile.height(start)) / (end - start);
        let known = |slope: Option<f64>| slope.filter(|slope| slope.is_finite()).unwrap_or(secant);
        let largest = |values: &[f64]| values.iter().fold(0.0f64, |most, v| most.max(v.abs()));
        let (coefficients, tail) = if is_slope {
            let coefficients = RULE.coefficients(&slopes.map(known));
            (coefficients, largest(&coefficients[ORDER - 2..]))
        } else {
            // About its middle value: small panels have small rounding.
            let reference = heights[ORDER / 2];
            let mut series = RULE.coefficients(&heights.map(|h| h - reference));
            let tail = largest(&series[ORDER - 2..]);
            // Coefficients of rounding would be blown up by the derivative.
            let floor = 2.0 * f64::EPSILON * largest(&heights);
            let last = series.iter().rposition(|c| c.abs() > floor).unwrap_or(0);
            series[last + 1..].fill(0.0);
            (derivative(&series).map(|c| c / half), tail)
        };
        let sizes = [largest(&heights), largest(&coefficients)];
        Sampled { coefficients, integral, sizes, tail, is_slope }
    }

    /// Adds an interval, of which samples are known, as a panel or halved.
    pub(super) fn add(
        &mut self,
        [start, end]: [f64; 2],
        sampled: &Sampled,
        depth: u32,
        before: f64,
    ) {
        let half = 0.5 * (end - start);
        // Shorter panels show nothing but rounded angles.
        let blur = self.profile.blur(0.5 * (start + end));
        let is_short = half <= BLURRED * blur || depth >= DEEPEST;
        let is_full = self.panels.len() >= MOST_PANELS;
        if self.is_met(sampled, half) || is_short || is_full || !sampled.tail.is_finite() {
            self.push([start, end], sampled);
            return;
        }
        let middle = 0.5 * (start + end);
        let halves = [[start, middle], [middle, end]].map(|[a, b]| ([a, b], self.sample(a, b)));
        // A kink stays in one half, and what is smooth falls in both.
        let keeps = |part: &Sampled| part.tail >= STAYS * sampled.tail;
        // Of last coefficients that are rounding it is enough that one half keeps them.
        let is_rounding = sampled.tail <= ROUNDING * self.scale[1];
        let stays = if sampled.is_slope && is_rounding {
            halves.iter().any(|(_, part)| keeps(part))
        } else if sampled.is_slope {
            halves.iter().all(|(_, part)| keeps(part))
        } else {
            sampled.tail >= STAYS * before
        };
        if depth > 0 && stays && self.may_be_noise(sampled, half, blur) {
            self.push([start, end], sampled);
            return;
        }
        for (ends, part) in halves {
            self.add(ends, &part, depth + 1, sampled.tail);
        }
    }

    fn is_met(&self, sampled: &Sampled, half: f64) -> bool {
        let (scale, rounding) = if sampled.is_slope {
            (self.scale[1], OF_A_VALUE * self.profile.taken_slope())
        } else {
            (self.scale[1] * half / ORDER as f64, f64::EPSILON * sampled.sizes[0])
        };
        sampled.tail <= (self.tolerance * scale).max(rounding)
    }

    /// Whether last coefficients that no halving makes smaller are rounding: small ones, those that rounded places make, or those of panels so short that nothing of
    /// the profile is as fast.
    fn may_be_noise(&self, sampled: &Sampled, half: f64, blur: f64) -> bool {
        if !sampled.is_slope {
            return sampled.tail <= NOISE * self.scale[0];
        }
        let noise = NOISE * self.scale[1].max(self.profile.taken_slope());
        let bend: f64 = sampled.coefficients[1..].iter().map(|c| c.abs()).sum();
        let blurred = ROUNDING / f64::EPSILON * blur / half * bend;
        sampled.tail <= noise.max(blurred) || half <= FASTEST
    }

    fn push(&mut self, [start, end]: [f64; 2], sampled: &Sampled) {
        let half = 0.5 * (end - start);
        let Sampled { coefficients, integral, sizes, tail, is_slope } = *sampled;
        let error = if is_slope { tail } else { tail * ORDER as f64 / half };
        // What a panel adds to F is about its error times its length over the distance.
        let own = if self.panels.len() < MOST_PANELS { error * half.min(1.0) } else { sizes[1] };
        self.worst = self.worst.max(own);
        self.sum += integral;
        self.heights = self.heights.max(sizes[0]);
        self.is_by_heights |= !is_slope;
        self.panels.push(Panel::new(start, end, coefficients));
    }
}
