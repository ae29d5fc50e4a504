//! Windows of some units of the machine, which cannot be resolved further.

use crate::allowance::allowance;
use crate::density::Density;
use crate::effort::of_range;
use crate::kernel::Singularity;
use crate::places::Places;
use crate::residual::{Bounded, Residual, blur};

/// Numbers of a window that are looked at one by one.
const MOST_NUMBERS: usize = 40;
/// Within this distance of a jump a formula may leave open on which side of it a number lies: its parts are rounded, and none is much larger than the base.
const OPEN: f64 = 256.0 * f64::EPSILON;
/// So many times that far from a jump heights are off by their rounding.
const CLEAR: f64 = 2.0;
/// What is no more than so many times as much as rounding is rounding.
const ROUNDED: f64 = 4.0;
/// In so many widths about a window the density is taken as a constant and what it differs from that.
pub(crate) const VICINITY: f64 = 64.0;

/// What was seen at numbers: the largest of what counts of the residual, of either sign in a zone and negative beside zones; the least residual; and the largest where the answer's own pressure
/// and the height on the better side of a jump count; and the same with the height at the number.
#[derive(Debug, Clone, Copy)]
struct Seen {
    largest: f64,
    least: f64,
    at_numbers: f64,
    on_its_side: f64,
}

impl Residual<'_> {
    /// Adds a window of some units of the machine: what is about a jump of the base for itself, since only there it is large.
    pub(crate) fn narrow_parts(&self, [left, right]: [f64; 2], found: &mut Vec<Bounded>) {
        let first = self.cuts.partition_point(|cut| *cut < left);
        let mut from = left;
        for cut in self.cuts[first..].iter().take_while(|cut| **cut <= right) {
            let blur = blur(cut.abs());
            for to in [cut - blur, cut + blur] {
                let to = to.clamp(from, right);
                if to > from {
                    found.push(self.narrow([from, to]));
                }
                from = to;
            }
        }
        if right > from {
            found.push(self.narrow([from, right]));
        }
    }

    /// A window of some units of the machine: what one of its numbers tells, and between them what can be at most.
    fn narrow(&self, [left, right]: [f64; 2]) -> Bounded {
        let middle = 0.5 * (left + right);
        let is_inside = self.density.panel_at(middle).is_some();
        let seen = self.seen(&[middle], is_inside);
        let variation = self.variation([left, right]);
        let least = seen.least - variation;
        let largest = if is_inside { seen.largest + variation } else { (-least).max(0.0) };
        let norm = largest * (right - left).sqrt();
        Bounded { left, right, largest, norm, at_numbers: largest, least, is_narrow: true }
    }

    /// Looks at all numbers of those narrow windows that would say more than the others, and more than is allowed: of that which says most first, as what its numbers tell may leave nothing to the rest.
    pub(crate) fn look_closer<'w>(
        &self,
        windows: impl Iterator<Item = &'w mut Bounded>,
        others: f64,
    ) {
        let mut windows: Vec<&mut Bounded> = windows.filter(|window| window.is_narrow).collect();
        windows.sort_by(|one, other| other.at_numbers.total_cmp(&one.at_numbers));
        let mut most = others;
        for window in windows {
            if window.at_numbers <= most {
                break;
            }
            let [left, right] = [window.left, window.right];
            let allowed = allowance(self.theta, right - left) * self.density.largest();
            if window.at_numbers > allowed {
                let numbers: Vec<f64> = std::iter::successors(Some(left), |x| Some(x.next_up()))
                    .take_while(|x| *x <= right)
                    .take(MOST_NUMBERS + 1)
                    .collect();
                let is_inside = self.density.panel_at(0.5 * (left + right)).is_some();
                let jump = self.cuts_within(0.5 * (left + right), OPEN).next();
                let told = if numbers.len() <= MOST_NUMBERS {
                    Some(self.seen(&numbers, is_inside).at_numbers)
                } else {
                    // Beside the origin there are more than can be looked at.
                    jump.map(|jump| self.between([left, right], jump, is_inside))
                };
                window.at_numbers =
                    told.map_or(window.at_numbers, |told| told.min(window.at_numbers));
            }
            most = most.max(window.at_numbers);
        }
    }

    /// The residual at numbers.
    fn seen(&self, numbers: &[f64], is_inside: bool) -> Seen {
        let none = Seen { largest: 0.0, least: f64::INFINITY, at_numbers: 0.0, on_its_side: 0.0 };
        self.each(numbers, is_inside).into_iter().fold(none, |all, one| Seen {
            largest: all.largest.max(one.largest),
            least: all.least.min(one.least),
            at_numbers: all.at_numbers.max(one.at_numbers),
            on_its_side: all.on_its_side.max(one.on_its_side),
        })
    }

    /// The same at each number.
    fn each(&self, numbers: &[f64], is_inside: bool) -> Vec<Seen> {
        let mut potentials = [(0.0, 0.0); MOST_NUMBERS];
        let places = Places::numbers(numbers);
        self.potentials(&places, &mut potentials[..numbers.len()]);
        let mut heights = [[0.0; 2]; MOST_NUMBERS];
        self.profile.heights(numbers, &mut heights[..numbers.len()]);
        let densities = self.density.values(&places);
        (numbers.iter().zip(potentials).zip(heights).zip(densities))
            .map(|(((&x, potential), height), q)| {
                let (w, error) = self.formed(x, height, q, potential);
                // Of what may be off by the error.
                let size = |w: f64, error: f64| match is_inside {
                    _ if w.is_nan() || error.is_nan() => f64::INFINITY,
                    true => w.abs() + error,
                    false => (error - w).max(0.0),
                };
                // The answer's own pressure counts at a place, not the resampled one, which may bend there.
                let own = if is_inside { w + (self.pressure)(x) - q.0 } else { w };
                Seen {
                    largest: size(w, error),
                    least: w - error,
                    at_numbers: self.at_number(x, height, (own, error), &size),
                    on_its_side: size(own, error),
                }
            })
            .collect()
    }

    /// A bound of what counts at all numbers of a window beside a jump, of which there are more than can be looked at: what some tell, and what it may change by between these.
    fn between(&self, window: [f64; 2], jump: f64, is_inside: bool) -> f64 {
        let is_either = |x: f64| self.jump_about(x).is_some() || self.is_open(x);
        let mut numbers = spread(window, jump);
        // A formula leaves open what is nearer to the jump than some number, on either side.
        let ends = numbers.clone();
        for pair in ends.windows(2).filter(|pair| is_either(pair[0]) != is_either(pair[1])) {
            let first = is_either(pair[0]);
            let [mut before, mut after] = [order(pair[0]), order(pair[1])];
            while after - before > 1 {
                let middle = before + (after - before) / 2;
                if is_either(number(middle)) == first { before = middle } else { after = middle }
            }
            numbers.extend([before, after].map(number));
        }
        numbers.sort_by(f64::total_cmp);
        let seen: Vec<Seen> =
            numbers.chunks(MOST_NUMBERS).flat_map(|some| self.each(some, is_inside)).collect();
        let mut largest = seen.iter().fold(0.0f64, |most, one| most.max(one.at_numbers));
        for (ends, seen) in numbers.windows(2).zip(seen.windows(2)) {
            let inner = [ends[0].next_up(), ends[1].next_down()];
            if inner[0] > inner[1] {
                continue;
            }
            let told =
                |one: &Seen, x: f64| if is_either(x) { one.at_numbers } else { one.on_its_side };
            let told = told(&seen[0], ends[0]).max(told(&seen[1], ends[1]));
            largest = largest.max(told + self.variation(inner));
        }
        largest
    }

    /// The nearest places where the base may jump, one on either side, if they are within a distance.
    fn cuts_within(&self, x: f64, distance: f64) -> impl Iterator<Item = f64> + '_ {
        let after = self.cuts.partition_point(|cut| *cut < x);
        let nearest = [after.checked_sub(1), Some(after)].into_iter().flatten();
        nearest
            .filter_map(|index| self.cuts.get(index).copied())
            .filter(move |cut| (x - cut).abs() <= distance)
    }

    /// The place of a jump on either side of which a number may lie, as far as that place is known.
    fn jump_about(&self, x: f64) -> Option<f64> {
        self.cuts_within(x, OPEN).find(|cut| (x - cut).abs() <= blur(cut.abs()))
    }

    /// Whether a formula, with its roundings, leaves open on which side of a jump a number lies: then its height is that of either side.
    pub(crate) fn is_open(&self, x: f64) -> bool {
        self.cuts_within(x, OPEN).any(|cut| {
            let [low, high] = self.profile.range([cut - OPEN, cut + OPEN]);
            let width = |x: f64| {
                let [low, high] = self.profile.height(x);
                high - low
            };
            // Where a smooth base is flat it changes within that distance by no more than its rounding.
            let rounding = || width(cut - CLEAR * OPEN).max(width(cut + CLEAR * OPEN));
            width(x) > 0.5 * (high - low) && width(x) > ROUNDED * rounding()
        })
    }

    /// What counts of `w` at a number: beside a jump of the base, as far as its place is known, its height is that of either side, also where rounding leaves open of which.
    fn at_number(
        &self,
        x: f64,
        [f_low, f_high]: [f64; 2],
        (w, error): (f64, f64),
        size: &dyn Fn(f64, f64) -> f64,
    ) -> f64 {
        let either = match self.jump_about(x) {
            Some(cut) => {
                let blur = blur(cut.abs());
                Some(self.profile.range([cut - blur, cut + blur]))
            }
            None => self.is_open(x).then_some([f_low, f_high]),
        };
        let Some([low, high]) = either else { return size(w, error) };
        let f = 0.5 * (f_low + f_high);
        let [lower, upper] = [w + (low - f).min(0.0), w + (high - f).max(0.0)];
        let nearest = if lower > 0.0 { lower } else { upper.min(0.0) };
        size(nearest, (error - 0.5 * (f_high - f_low)).max(0.0))
    }

    /// A bound of how much `w` changes in a narrow window.
    fn variation(&self, [left, right]: [f64; 2]) -> f64 {
        self.count(of_range(self.profile.looks([left, right])));
        let [low, high] = self.profile.range([left, right]);
        (high - low)
            + self.theta * self.potential_variation([left, right])
            + self.tilt.abs() * (right - left)
            + density_variation(self.density, [left, right])
    }

    /// A bound of how much the potential changes.
    ///
    /// Of the density in the vicinity, of the half-length `D`, a constant changes it by `2 w |sigma'(D)| w`, and what differs from the constant by at most `e` by
    /// `e int |sigma(|x - t|) - sigma(|y - t|)| dt`. What is farther: by `w int q |sigma'|`.
    pub(crate) fn potential_variation(&self, [left, right]: [f64; 2]) -> f64 {
        let (c, width) = (0.5 * (left + right), right - left);
        let vicinity = [c - VICINITY * width, c + VICINITY * width];
        let singularity = self.density.kernel.singularity();
        let whole = vicinity.map(|x| self.density.panel_at(x).is_some());
        let steady = self.density.evaluate(c).abs();
        let unsteady = density_variation(self.density, vicinity);
        // Beside an end of a zone the density falls to nothing.
        let touching = self.density.panels.iter();
        let touching =
            touching.filter(|panel| panel.left <= vicinity[1] && panel.right >= vicinity[0]);
        let drop = touching.fold(0.0f64, |most, panel| most.max(panel.largest));
        let unsteady = if whole == [true; 2] { unsteady } else { unsteady + 2.0 * steady + drop };
        let far = (VICINITY - 1.0) * width;
        let mut farther = 0.0;
        self.density.parts(c, &mut |distance, mass, largest, length| {
            let gap = far.max(distance - width);
            let (slope, sum) = match singularity {
                Singularity::Logarithm => (1.0 / gap, (1.0 + length / gap).ln()),
                Singularity::Power(mu) => (mu * gap.powf(-1.0 - mu), gap.powf(-mu)),
            };
            farther += width * (mass * slope).min(2.0 * largest * sum);
        });
        let sum = nearby(singularity, width, VICINITY);
        let slope = match singularity {
            Singularity::Logarithm => 1.0 / far,
            Singularity::Power(mu) => mu * far.powf(-1.0 - mu),
        };
        steady * 2.0 * width * width * slope + unsteady * sum + farther
    }
}

/// Numbers of a window from left to right, as many apart from each other, with a place between them and its neighbours.
fn spread([left, right]: [f64; 2], place: f64) -> Vec<f64> {
    let beside = [place.next_down(), place, place.next_up()];
    let parts = (MOST_NUMBERS - 1 - beside.len()) as i64;
    let (first, last) = (order(left), order(right));
    let step = last / parts - first / parts;
    let inner = (1..parts).map(|k| number(first + k * step));
    let inner = inner.chain(beside).filter(|x| left < *x && *x < right);
    let mut numbers: Vec<f64> = inner.chain([left, right]).collect();
    numbers.sort_by(f64::total_cmp);
    numbers
}

/// The numbers of the machine in their order, zero being 0.
fn order(x: f64) -> i64 {
    let magnitude = x.abs().to_bits() as i64;
    if x < 0.0 { -magnitude } else { magnitude }
}

fn number(order: i64) -> f64 {
    f64::from_bits(order.unsigned_abs()).copysign(order as f64)
}

/// A bound of `int |sigma(|x - t|) - sigma(|y - t|)| dt` over what is within so many widths of two places that are `width` apart.
pub(crate) fn nearby(singularity: Singularity, width: f64, widths: f64) -> f64 {
    match singularity {
        Singularity::Logarithm => 2.0 * width * (3.0 + (1.0 + 2.0 * widths).ln()),
        Singularity::Power(mu) => 8.0 * width.powf(1.0 - mu) / (1.0 - mu),
    }
}

/// A bound of how much the density changes between the ends of the panels that an interval touches.
pub(crate) fn density_variation(density: &Density, [left, right]: [f64; 2]) -> f64 {
    let first = density.panels.partition_point(|panel| panel.right < left);
    let (mut change, mut before) = (0.0, None);
    for panel in density.panels[first..].iter().take_while(|panel| panel.left <= right) {
        let share = (right.min(panel.right) - left.max(panel.left)) / panel.half();
        // |P_k'| <= k (k + 1)/2
        let slope: f64 = (panel.coefficients.iter().enumerate())
            .map(|(k, c)| 0.5 * (k * (k + 1)) as f64 * c.abs())
            .sum();
        change += (slope * share).min(2.0 * panel.swing);
        let start = panel.evaluate(panel.left);
        change += before.map_or(0.0, |end: f64| (start - end).abs());
        before = Some(panel.evaluate(panel.right));
    }
    change
}
