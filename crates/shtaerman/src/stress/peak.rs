//! Where an equivalent stress is largest.
//!
//! Candidates are the local maxima on a grid in bipolar coordinates of every panel and of all panels together, which are fine near every end, and those straight below crests of the pressure; the best are
//! refined by Newton's method on the exact gradient. To these come the surface under the contact, where the pressure is largest, and the ends of
//! panels: where the pressure jumps, the stress beneath depends on the direction alone, and its largest value is the limit that counts.

use std::f64::consts::PI;

use serde::Serialize;

use super::StressField;
use super::complex::Complex;
use super::measure::Criterion;
use super::panel::Panel;

/// Grid in bipolar coordinates: largest distance from the middle, largest step, and number of angles.
const OUTERMOST: f64 = 24.0;
const STRIDE: f64 = 1.0;
const ANGLES: usize = 14;
/// Steps of the pressure that are one step of the grid.
const STEPS: f64 = 3.4;
const LEAST_STRIDE: f64 = 0.2;
/// More panels than these are searched zone by zone, and more zones coarsely.
const FEW: usize = 8;
const COARSE: f64 = 2.0;
/// From one depth below a crest to the next.
const DEEPER: f64 = 1.5;
/// Local maxima below this share of the best are not refined, nor more than this many.
const WORTHWHILE: f64 = 0.9;
const MOST_REFINED: usize = 24;
/// A value that exceeds another by less than this share is equal to it.
const EQUAL: f64 = 1e-12;
/// A maximum as close to a corner, relative to the longest panel, and not above its limit, climbs towards that.
const CLOSE: f64 = 1e-2;
/// One that is as close as this is at the corner: what it has beyond the limit there is rounding of the place.
const TOUCHING: f64 = 1e-13;
/// The depth, relative to the longest panel, of the surface to rounding.
const SHALLOW: f64 = 1e-12;
/// The first step of a refinement, relative to the distance from the nearest end: a quarter of what the grid has there, as longer ones lead to another maximum.
const SHORT: f64 = 0.03;
/// Steps of each refinement.
const COMPASS_STEPS: usize = 60;
const NEWTON_STEPS: usize = 80;
/// Halvings of a step of Newton's method, and the share of the rise that the gradient tells which a step has to have (Armijo's condition).
const SHORTENED: i32 = 12;
const ASCENT: f64 = 0.1;
/// Offset of the difference quotients of the gradient, and the step that is small enough, relative to the distance from the nearest end.
const OFFSET: f64 = 1e-5;
const SETTLED: f64 = 1e-13;

/// The largest value of an equivalent stress.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Peak {
    /// The value, in the units of the problem; infinite under a corner with infinite pressure.
    pub value: f64,
    /// Place along the surface.
    pub x: f64,
    /// Depth; 0 on the surface.
    pub depth: f64,
    /// Whether it is the limit at the end of a panel where the pressure jumps or is infinite: the stress there depends on the direction, and the value is that of the worst.
    pub is_corner: bool,
}

/// A node at which the size of the pressure exceeds that at its neighbours, between these.
#[derive(Clone, Copy)]
struct Crest<'p> {
    panel: &'p Panel,
    nodes: [f64; 3],
    size: f64,
}

/// A place and the value there.
type Reached = ([f64; 2], f64);

impl StressField {
    /// The largest equivalent stress in the body and its place; of equal ones that inside the body, of those the leftmost. Of a periodic pressure it is that in the period about 0, or, where panels reach beyond it, about their middle.
    #[must_use]
    pub fn peak(&self, criterion: Criterion) -> Peak {
        let corners = self.corner_peaks(criterion);
        let mut peaks = self.inner_peaks(criterion);
        // What climbs to the surface is found there, and what climbs into a corner is its limit.
        let longest = self.inner().iter().map(Panel::length).fold(0.0, f64::max);
        peaks.retain(|peak| peak.depth > SHALLOW * longest);
        peaks.retain(|peak| !corners.iter().any(|corner| is_limit(longest, peak, corner)));
        peaks.extend(self.surface_peaks(criterion));
        peaks.extend(corners);
        let zero = Peak { value: 0.0, x: 0.0, depth: 0.0, is_corner: false };
        let best = peaks.into_iter().fold(zero, |best, peak| {
            if peak.value > best.value * (1.0 + EQUAL) { peak } else { best }
        });
        let [length, stress] = self.units;
        Peak { value: best.value * stress, x: best.x * length, depth: best.depth * length, ..best }
    }

    fn inner_peaks(&self, criterion: Criterion) -> Vec<Peak> {
        let mut found: Vec<Reached> = Vec::new();
        for (interval, stride) in self.searched() {
            found.extend(self.grid_maxima(criterion, interval, stride));
        }
        if let [first, .., last] = self.inner() {
            found.extend(self.grid_maxima(criterion, [first.left, last.right], 0.5 * STRIDE));
        }
        if let (Some(period), Some(first)) = (self.inner_period(), self.inner().first()) {
            let hull = [first.left, first.left + period];
            found.extend(self.grid_maxima(criterion, hull, 0.5 * STRIDE));
        }
        found.extend(self.below_crests(criterion));
        let best = found.iter().fold(0.0f64, |most, candidate| most.max(candidate.1));
        found.retain(|candidate| candidate.1 >= WORTHWHILE * best);
        crate::order::sort_by_number(&mut found, |one| -one.1);
        found.truncate(MOST_REFINED);
        let mut peaks: Vec<Peak> =
            found.into_iter().map(|start| self.refined(criterion, start)).collect();
        peaks.iter_mut().for_each(|peak| peak.x = self.within_period(peak.x));
        crate::order::sort_by_number(&mut peaks, |one| one.x);
        peaks
    }

    /// The same place in the period about 0 where all panels lie within that, else about their middle.
    fn within_period(&self, x: f64) -> f64 {
        let [Some(first), Some(last)] = [self.inner().first(), self.inner().last()] else {
            return x;
        };
        let [left, right] = [first.left, last.right];
        let x = match self.inner_period() {
            Some(period) => {
                let reach = 0.5 * period * (1.0 + EQUAL);
                let is_about_zero = -reach <= left && right <= reach;
                let middle = if is_about_zero { 0.0 } else { left.midpoint(right) };
                x - period * ((x - middle) / period).round()
            }
            None => x,
        };
        // A rounded zero.
        if x.abs() <= EQUAL * (right - left) { 0.0 } else { x }
    }

    /// The intervals over which maxima are looked for, with the step of each grid.
    fn searched(&self) -> Vec<([f64; 2], f64)> {
        let panels = self.inner();
        if panels.len() <= FEW {
            let of_panel = |panel: &Panel| ([panel.left, panel.right], stride(panel));
            return panels.iter().map(of_panel).collect();
        }
        let mut zones: Vec<[f64; 2]> = Vec::new();
        for panel in panels {
            match zones.last_mut() {
                Some(last) if last[1] == panel.left => last[1] = panel.right,
                _ => zones.push([panel.left, panel.right]),
            }
        }
        let stride = if zones.len() <= FEW { LEAST_STRIDE } else { COARSE };
        zones.into_iter().map(|zone| (zone, stride)).collect()
    }

    /// The points of a grid over an interval that exceed their neighbours.
    fn grid_maxima(
        &self,
        criterion: Criterion,
        [left, right]: [f64; 2],
        stride: f64,
    ) -> Vec<Reached> {
        let count = (OUTERMOST / stride) as i64;
        let place = |column: i64, row: usize| {
            let angle = PI * (row as f64 + 0.5) / ANGLES as f64;
            bipolar(left, right, Complex::new(column as f64 * stride, angle))
        };
        let rows: Vec<Vec<f64>> = (0..ANGLES)
            .map(|row| {
                (-count..=count)
                    .map(|column| self.equivalent(criterion, place(column, row)))
                    .collect()
            })
            .collect();
        let width = rows[0].len();
        let value = |row: usize, column: usize| rows[row][column];
        let mut found = Vec::new();
        for row in 0..ANGLES {
            for column in 0..width {
                let here = value(row, column);
                let beside = (row.saturating_sub(1)..=(row + 1).min(ANGLES - 1)).flat_map(|row| {
                    (column.saturating_sub(1)..=(column + 1).min(width - 1))
                        .map(move |column| (row, column))
                });
                if here > 0.0 && beside.into_iter().all(|(row, column)| value(row, column) <= here)
                {
                    found.push((place(column as i64 - count, row), here));
                }
            }
        }
        found
    }

    fn refined(&self, criterion: Criterion, start: Reached) -> Peak {
        let (place, value) = self.settled(criterion, self.climbed(criterion, start));
        Peak { value, x: place[0], depth: place[1], is_corner: false }
    }

    /// By steps along the axes, halved where none leads upwards.
    fn climbed(&self, criterion: Criterion, (mut place, mut value): Reached) -> Reached {
        let mut step = SHORT * self.distance(place);
        for _ in 0..COMPASS_STEPS {
            let around = [[step, 0.0], [-step, 0.0], [0.0, step], [0.0, -step]];
            let best = around
                .map(|[dx, dy]| [place[0] + dx, place[1] + dy])
                .into_iter()
                .filter(|place| place[1] > 0.0)
                .map(|place| (place, self.equivalent(criterion, place)))
                .fold((place, value), |best, next| if next.1 > best.1 { next } else { best });
            if best.1 > value {
                (place, value) = best;
            } else {
                step *= 0.5;
            }
            if step < 1e-4 * self.distance(place) {
                break;
            }
        }
        (place, value)
    }

    /// By Newton's method on the gradient, with the matrix made negative definite where the top is flat.
    fn settled(&self, criterion: Criterion, (mut place, mut value): Reached) -> Reached {
        for _ in 0..NEWTON_STEPS {
            let reach = self.distance(place);
            let offset = OFFSET * reach.min(place[1]);
            if offset <= 0.0 {
                break;
            }
            let slope = |place| self.slope(criterion, place).1;
            let gradient = slope(place);
            let [x, y] = place;
            let [right, left] = [slope([x + offset, y]), slope([x - offset, y])];
            let [below, above] = [slope([x, y + offset]), slope([x, y - offset])];
            let quotient = |one: f64, two: f64| 0.5 * (one - two) / offset;
            let hessian = [
                quotient(right[0], left[0]),
                0.5 * (quotient(right[1], left[1]) + quotient(below[0], above[0])),
                quotient(below[1], above[1]),
            ];
            let step = ascent(hessian, gradient);
            let size = step[0].hypot(step[1]);
            if size.is_nan() || size <= SETTLED * reach {
                break;
            }
            // Along a ridge that bends a full step leads off it, a shorter one upwards: the direction is one of ascent.
            let most = (0.3 * reach.min(y) / size).min(1.0);
            let rise = step[0] * gradient[0] + step[1] * gradient[1];
            let next = (0..SHORTENED).find_map(|cut| {
                let share = most * 0.5f64.powi(cut);
                let next = [x + share * step[0], y + share * step[1]];
                let reached = self.equivalent(criterion, next);
                // Next to the top the values differ by rounding alone, while the gradient still tells the place.
                let least = value + ASCENT * share * rise - EQUAL * value;
                (reached >= least).then_some((next, reached))
            });
            let Some((next, reached)) = next else { break };
            (place, value) = (next, reached);
        }
        (place, value)
    }

    /// Distance from the nearest end of a panel.
    fn distance(&self, [x, y]: [f64; 2]) -> f64 {
        let x = self.reduced(x);
        let to_end = |panel: &Panel| {
            let seen = panel.seen(x, y);
            seen.from_left.hypot(y).min(seen.to_right.hypot(y))
        };
        self.inner().iter().map(to_end).fold(f64::INFINITY, f64::min)
    }

    /// The crests of the pressure that may be the highest, each with the nodes on both sides: these show all of them, which a grid for the body may miss.
    fn crests(&self) -> Vec<Crest<'_>> {
        let mut crests: Vec<Crest<'_>> = Vec::new();
        for panel in self.inner() {
            for three in panel.samples().windows(3) {
                let [before, at, after] = [0, 1, 2].map(|i| three[i]);
                // Next to an end places are one number.
                let are_apart = before.0 < at.0 && at.0 < after.0;
                if are_apart && before.1 <= at.1 && after.1 <= at.1 {
                    crests.push(Crest { panel, nodes: [before.0, at.0, after.0], size: at.1 });
                }
            }
        }
        let best = crests.iter().fold(0.0, |most, crest| crest.size.max(most));
        crests.retain(|crest| crest.size >= WORTHWHILE * best);
        crate::order::sort_by_number(&mut crests, |crest| -crest.size);
        crests.truncate(MOST_REFINED);
        crests
    }

    /// The places of the surface where the pressure is largest: `(1 - 2 nu) p` there.
    fn surface_peaks(&self, criterion: Criterion) -> Vec<Peak> {
        let factor = criterion.of_parts(2.0, 0.0, self.poisson_ratio());
        let refined =
            self.crests().into_iter().map(|Crest { panel, nodes: [before, at, after], .. }| {
                let level = self.level(panel, before, after).unwrap_or(at);
                let [own, other] = [at, level].map(|x| self.inside(panel, x).abs());
                let (x, pressure) = if other > own { (level, other) } else { (at, own) };
                Peak { value: factor * pressure, x, depth: 0.0, is_corner: false }
            });
        refined.collect()
    }

    /// Maxima straight below the crests of the pressure, from the distance between nodes to the length of the panel.
    fn below_crests(&self, criterion: Criterion) -> Vec<Reached> {
        let below = |Crest { panel, nodes: [before, at, after], .. }: Crest<'_>| {
            let shallowest = 0.5 * (after - before);
            let depths = (0..).map(|k| shallowest * DEEPER.powi(k));
            let depths = depths.take_while(|depth| *depth < panel.length());
            let values: Vec<Reached> = depths
                .map(|depth| ([at, depth], self.equivalent(criterion, [at, depth])))
                .collect();
            let is_top = |three: &&[Reached]| three[0].1 <= three[1].1 && three[2].1 <= three[1].1;
            values.windows(3).filter(is_top).map(|three| three[1]).collect::<Vec<_>>()
        };
        self.crests().into_iter().flat_map(below).collect()
    }

    /// Where the slope of the pressure changes its sign, by bisection.
    fn level(&self, panel: &Panel, mut left: f64, mut right: f64) -> Option<f64> {
        let slope = |x: f64| panel.potential::<false>(panel.seen(x, 0.0))[1].im;
        let at_left = slope(left);
        if at_left * slope(right) >= 0.0 {
            return None;
        }
        for _ in 0..80 {
            let middle = left.midpoint(right);
            if slope(middle) * at_left > 0.0 { left = middle } else { right = middle }
        }
        Some(left.midpoint(right))
    }

    /// The limits at the ends of panels: pressures `p-` and `p+` beside the point give at the angle `phi` from the right
    /// `sigma_x + sigma_y = -(2/pi) [p+ (pi - phi) + p- phi]` and the radius `|p+ - p-| sin phi/pi`.
    fn corner_peaks(&self, criterion: Criterion) -> Vec<Peak> {
        let mut corners: Vec<(f64, [f64; 2])> = Vec::new();
        for panel in self.inner() {
            match corners.last_mut() {
                Some((x, beside)) if *x == panel.left => beside[1] = panel.ends[0],
                _ => corners.push((panel.left, [0.0, panel.ends[0]])),
            }
            corners.push((panel.right, [panel.ends[1], 0.0]));
        }
        self.join_period(&mut corners);
        corners
            .into_iter()
            .map(|(x, beside)| {
                let value = worst_direction(criterion, beside, self.poisson_ratio());
                let is_corner = (beside[0] - beside[1]).abs() > EQUAL * beside[0].abs();
                Peak { value, x, depth: 0.0, is_corner }
            })
            .collect()
    }

    /// A base without gaps ends where it begins again.
    fn join_period(&self, corners: &mut [(f64, [f64; 2])]) {
        if let [first, .., last] = corners
            && self.is_closed()
        {
            first.1[0] = last.1[0];
            last.1[1] = first.1[1];
        }
    }
}

/// Whether a maximum is what the stress tends to at a corner, given the longest panel.
fn is_limit(longest: f64, peak: &Peak, corner: &Peak) -> bool {
    let apart = (peak.x - corner.x).hypot(peak.depth) / longest;
    apart <= TOUCHING || apart <= CLOSE && peak.value <= corner.value * (1.0 + EQUAL)
}

/// Step of a grid that shows what the pressure of a panel does.
fn stride(panel: &Panel) -> f64 {
    (STEPS * panel.step()).clamp(LEAST_STRIDE, STRIDE)
}

/// The largest limit over all directions.
fn worst_direction(criterion: Criterion, [before, after]: [f64; 2], poisson_ratio: f64) -> f64 {
    if before.is_infinite() || after.is_infinite() {
        return f64::INFINITY;
    }
    let value = |angle: f64| {
        let sum = 2.0 / PI * (after * (PI - angle) + before * angle);
        criterion.of_parts(sum, (after - before).abs() * angle.sin() / PI, poisson_ratio)
    };
    const SAMPLES: usize = 64;
    let angle = |index: usize| PI * index as f64 / SAMPLES as f64;
    let best = (0..=SAMPLES)
        .fold(0, |best, next| if value(angle(next)) > value(angle(best)) { next } else { best });
    let (mut low, mut high) = (angle(best.saturating_sub(1)), angle((best + 1).min(SAMPLES)));
    for _ in 0..100 {
        let third = (high - low) / 3.0;
        if value(low + third) < value(high - third) { low += third } else { high -= third }
    }
    value(low.midpoint(high)).max(value(angle(best)))
}

/// The place with the bipolar coordinates `tau` over an interval.
fn bipolar(left: f64, right: f64, tau: Complex) -> [f64; 2] {
    let from_end = |sign: f64| {
        let size = (-sign * tau.re).exp();
        let below = Complex::new(1.0 + size * tau.im.cos(), -sign * size * tau.im.sin()).inverse();
        below.scaled(right - left)
    };
    let one = from_end(1.0);
    let x = if tau.re <= 0.0 { left + one.re } else { right - from_end(-1.0).re };
    [x, one.im.max(0.0)]
}

/// The step of Newton's method for a maximum: eigenvalues of the Hessian `[xx, xy, yy]` are taken as negative, and kept off zero.
fn ascent([xx, xy, yy]: [f64; 3], gradient: [f64; 2]) -> [f64; 2] {
    let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    let radius = half.hypot(xy);
    let (largest, angle) = (mean.abs() + radius, 0.5 * xy.atan2(half));
    let (sine, cosine) = angle.sin_cos();
    let along =
        [cosine * gradient[0] + sine * gradient[1], cosine * gradient[1] - sine * gradient[0]];
    let scaled = [mean + radius, mean - radius];
    let steps =
        [0, 1].map(|i| along[i] / scaled[i].abs().max(1e-9 * largest).max(f64::MIN_POSITIVE));
    [cosine * steps[0] - sine * steps[1], sine * steps[0] + cosine * steps[1]]
}
