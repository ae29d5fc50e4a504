//! The residual on a window that can be resolved: interpolation of what is analytic in the disk about it, and bounds of the rest.

use crate::allowance::{UNIT, allowance};
use crate::chebyshev::{MOST, lebesgue, nodes};
use crate::effort::of_range;
use crate::fitted::{Fitted, fit};
use crate::heights::{Heights, Known};
use crate::places::{Places, middle};
use crate::remainders::{Part, local_mass, local_potential, outside};
use crate::residual::{Bounded, Residual};

/// Radius of the disk in radii of the window, if nothing is in the way; and below which a window is halved instead. Beside an end of a zone, where the density bends, it is as many times
/// larger than the window as the end is farther than the disk: what stands for the density in it and what interpolates its potential then fall at one rate.
const DISK: f64 = 1.8;
const LEAST_DISK: f64 = 1.25;
/// The largest ellipse of analyticity that is used, in radii of the disk.
const INSIDE: f64 = 0.97;
/// Share of its distance from the ends of a panel that a disk on it has: rounding does not carry it beyond.
const ON_PANEL: f64 = 1.0 - 1e-9;
/// Ends of disks are rounded: below this share of their distance from the origin they are off by more than `1 - INSIDE` of the radius.
const PLACED: f64 = 17.0 * f64::EPSILON;
/// Nodes are rounded to this share of the half-length of a window: what they are from a panel's end in its reach then takes no further rounding, and by Markov's inequality a polynomial changes by
/// `n^2` of its size for each unit of its place, here by a millionth at most.
const GRID: f64 = 1.0 / (1_u64 << 32) as f64;
/// Of what interpolation misses, with nodes so rounded.
const MOVED: f64 = 1.01;
/// Roundings of the cosine sums of a window, for each node squared.
const COSINES: f64 = 3.0;
/// Numbers of nodes on a window: eight or sixteen of them cost as much as one less.
const COUNTS: [usize; 9] = [3, 5, FEW, 12, 16, 20, 24, 32, 40];
/// So many tell what is to be expected of a window beside the zones.
const FEW: usize = 8;
/// Share of the budget for interpolation: a few nodes more make it small.
const FINE: f64 = 0.6;
/// Share of the residual that remainders may have.
const SHARE: f64 = 0.15;
/// The residual is not looked at where so many times that of the window before is missed: it would have to be 27 times as large here (survey: of a trace of 10,000 points 59,000 windows are halved so, and none for another reason).
const FAR_MORE: f64 = 4.0;
/// Jumps of the density that a window may have in its remainders, in jumps: a polynomial cannot follow them closer than one and a half, and their potential may have as much.
const JUMPS: f64 = 3.0;
const SPREAD: f64 = 2.0;
/// Larger jumps, relative to the density, are no noise: windows shrink to them.
const NOISE: f64 = 1e-8;

impl Residual<'_> {
    /// A bound of `|w|` on a window of a zone; none where it has to be halved.
    pub(crate) fn window_in_zone(
        &self,
        [left, right]: [f64; 2],
        zone: [f64; 2],
        known: &mut Known,
    ) -> Option<Bounded> {
        let (c, r) = middle([left, right]);
        let mut heights = known.on(self.profile, [left, right]);
        let mut disk = (DISK * r).min((r * (c - zone[0]).min(zone[1] - c)).sqrt());
        if disk < LEAST_DISK * r || disk < PLACED * c.abs() || self.is_open_at([left, c, right]) {
            return None;
        }
        let mut fitted = fit(self.density, c, disk)?;
        let singularity = self.density.kernel.singularity();
        let allowed = allowance(self.theta, 2.0 * r) * self.density.largest();
        // Where panels meet the density jumps by what it is off by: windows cannot know it better.
        let spread = |disk: f64| 1.0 + self.theta * local_mass(singularity, disk);
        let jump = |fitted: &Fitted, disk: f64| {
            JUMPS * spread(disk).min(SPREAD) * fitted.jump.min(NOISE * fitted.largest)
        };
        // Where one polynomial does not serve, as beside a kink, a smaller disk may lie on a single panel.
        if fitted.missed * spread(disk) > allowed.max(jump(&fitted, disk))
            && let Some((smaller, own)) = self.on_one_panel(c, r, disk)
        {
            (disk, fitted) = (smaller, own);
        }
        let jump = jump(&fitted, disk);
        let missed = fitted.missed * spread(disk);
        // The ellipse about the window with the foci at its ends and this half-axis has its rho; the one about the disk that contains it its gamma.
        let axis = INSIDE * disk / r;
        let rho = axis + (axis * axis - 1.0).sqrt();
        let minor = (axis * axis - 1.0).sqrt() * r / disk;
        let gamma = minor + (1.0 + minor * minor).sqrt();
        let parts = self.parts(c, (disk, r));
        let powers: Vec<f64> = std::iter::successors(Some(1.0), |power| Some(power * gamma))
            .take(fitted.len())
            .collect();
        let (local_mass, local) =
            (local_mass(singularity, disk), local_potential(singularity, disk));
        let remainder = |count: usize, most: f64| {
            let fallen = 4.0 * rho.powi(1 - count as i32) / (rho - 1.0);
            let plain = 1.0 + crowded(c, r, count) * lebesgue(count);
            let whole = plain * local_mass;
            let potential = fitted.sum(|k| (fallen * powers[k] * local).min(whole), whole);
            let own = |k: usize| if k < count { 0.0 } else { (fallen * powers[k]).min(plain) };
            let inside = fitted.sum(own, plain) + self.theta * potential;
            inside + self.theta * outside(&parts, singularity, count, most / self.theta)
        };
        // What the residual itself may hide is looked for only where that is needed.
        let least = jump.max(allowed).max(self.noise.get());
        let found =
            if missed <= least { count_with(&mut heights, least, 0, remainder) } else { None };
        let (count, remainder) = match found {
            Some(found) => found,
            // What is missed by far more than the residual was on the window before is no small share of it here.
            None if missed > FAR_MORE * self.before.get().max(least) => return None,
            None => {
                let (w, error) = self.at(c);
                let budget = (SHARE * w.abs()).max(2.0 * error).max(least);
                if missed > budget || budget <= least {
                    return None;
                }
                count_with(&mut heights, budget, 0, remainder)?
            }
        };
        let (values, error) = self.values([left, right], count);
        self.noise.set(error);
        let rest = remainder + missed;
        let crowded = crowded(c, r, count);
        let own = self.sup(&values, lebesgue(count), error + missed);
        let largest = crowded * own + rest;
        self.before.set(largest);
        // The square of a polynomial of degree n - 1 is integrated exactly against (1 - t^2)^(-1/2) >= 1 by the sum over n nodes times pi/n.
        let squares: f64 = values.iter().map(|w| (w.abs() + error + missed).powi(2)).sum();
        let norm = (std::f64::consts::PI * r * squares / count as f64).sqrt()
            + ((crowded - 1.0) * own + rest) * (2.0 * r).sqrt();
        Some(Bounded {
            left,
            right,
            largest,
            norm,
            at_numbers: largest,
            least: -largest,
            is_narrow: false,
        })
    }

    /// The largest disk about a window that is smaller than this one and lies on one panel, if it is no smaller than the least, with the polynomial of the panel.
    fn on_one_panel(&self, c: f64, r: f64, disk: f64) -> Option<(f64, Fitted)> {
        let panel = &self.density.panels[self.density.panel_at(c)?];
        let own = ON_PANEL * (c - panel.left).min(panel.right - c);
        let serves = own < disk && own >= LEAST_DISK * r && own >= PLACED * c.abs();
        serves.then(|| fit(self.density, c, own)).flatten().map(|fitted| (own, fitted))
    }

    /// Whether it is open of an end of a window or its middle on which side of a jump it lies. Ends are those of many windows.
    fn is_open_at(&self, [left, c, right]: [f64; 3]) -> bool {
        if self.cuts.is_empty() {
            return false;
        }
        let before = self.ends.get();
        let ends = [left, right].map(|x| {
            let known = before.iter().find(|(end, _)| *end == x);
            (x, known.map_or_else(|| self.is_open(x), |(_, is_open)| *is_open))
        });
        self.ends.set(ends);
        ends.iter().any(|(_, is_open)| *is_open) || self.is_open(c)
    }

    /// The density outside a disk about the middle of a window.
    fn parts(&self, c: f64, (disk, r): (f64, f64)) -> Vec<Part> {
        let singularity = self.density.kernel.singularity();
        let mut parts = Vec::new();
        self.density.parts(c, &mut |distance, mass, largest, _| {
            parts.push(Part::new(singularity, (distance, disk, r), mass, largest));
        });
        parts
    }

    fn values(&self, [left, right]: [f64; 2], count: usize) -> (Vec<f64>, f64) {
        let (c, r) = middle([left, right]);
        let (from, offsets) = placed(c, r, count);
        let nodes = Places { from, offsets: &offsets };
        let mut potentials = [(0.0, 0.0); MOST];
        self.potentials(&nodes, &mut potentials[..count]);
        let densities = self.density.values(&nodes);
        let places: Vec<f64> = offsets.iter().map(|offset| from + offset).collect();
        let mut heights = [[0.0; 2]; MOST];
        if from == 0.0 {
            self.profile.heights(&places, &mut heights[..count]);
        } else {
            self.count(count as u64 * of_range(self.profile.looks([left, right])));
            for (height, x) in heights.iter_mut().zip(&places) {
                let between = [x.next_down().max(left), x.next_up().min(right)];
                *height = self.profile.range(between);
            }
        }
        let mut largest = 0.0f64;
        let values = (places.iter().zip(heights).zip(densities).zip(potentials))
            .map(|(((x, height), q), potential)| {
                let (w, error) = self.formed(*x, height, q, potential);
                largest = largest.max(error);
                w
            })
            .collect();
        (values, largest)
    }

    /// A bound of the polynomial through values that are off by `error` each.
    fn sup(&self, values: &[f64], lebesgue: f64, error: f64) -> f64 {
        let count = values.len();
        let largest = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        let sum: f64 = nodes(count).coefficients(values).iter().map(|c| c.abs()).sum();
        (lebesgue * largest).min(sum) + lebesgue * error
    }

    /// A lower bound of `w` on a window beside the zones; none where it has to be halved.
    pub(crate) fn window_in_gap(
        &self,
        [left, right]: [f64; 2],
        known: &mut Known,
    ) -> Option<Bounded> {
        let (c, r) = middle([left, right]);
        let mut heights = known.on(self.profile, [left, right]);
        let singularity = self.density.kernel.singularity();
        let parts = self.parts(c, (LEAST_DISK * r, r));
        // A panel that reaches into the window's own disk may touch the window.
        let mut is_near = false;
        self.density.parts(c, &mut |distance, mass, _, _| {
            is_near |= mass > 0.0 && distance < LEAST_DISK * r;
        });
        if is_near || self.is_open_at([left, c, right]) {
            return None;
        }
        let allowed = allowance(self.theta, right - left) * self.density.largest();
        let (few, error) = self.values([left, right], FEW);
        let between = 0.5 * (few[FEW / 2 - 1] + few[FEW / 2]);
        let budget = (SHARE * between.abs()).max(2.0 * error).max(allowed);
        let (count, remainder) = count_with(&mut heights, budget, FEW, |count, most| {
            self.theta * outside(&parts, singularity, count, most / self.theta)
        })?;
        let (values, error) =
            if count == FEW { (few, error) } else { self.values([left, right], count) };
        let mut swing = 0.0;
        let mut mean = 0.0;
        for (k, a) in nodes(count).coefficients(&values).into_iter().enumerate() {
            if k == 0 { mean = a } else { swing += a.abs() }
        }
        let size = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        let crowded = crowded(c, r, count);
        let cosines = COSINES * (count * count) as f64 * UNIT * size;
        let placed = (crowded - 1.0) * lebesgue(count) * size;
        let rounding = (1.0 + crowded * lebesgue(count)) * error + cosines;
        let least = mean - swing - rounding - placed - remainder;
        let lowest = values.iter().copied().fold(f64::INFINITY, f64::min);
        // Smaller windows do not help where rounding or the values themselves are at fault.
        if least < -(2.0 * rounding).max(-2.0 * lowest).max(allowed) {
            return None;
        }
        let largest = (-least).max(0.0);
        let norm = largest * (right - left).sqrt();
        Some(Bounded { left, right, largest, norm, at_numbers: largest, least, is_narrow: false })
    }
}

/// The smallest number of nodes, at least `first`, with which all remainders are within the budget, and the remainder; of a larger one than is asked for any part will do.
fn count_with(
    heights: &mut Heights<'_>,
    budget: f64,
    first: usize,
    remainder: impl Fn(usize, f64) -> f64,
) -> Option<(usize, f64)> {
    for count in COUNTS.into_iter().filter(|count| *count >= first) {
        let most = FINE * budget / MOVED;
        let own = remainder(count, most);
        if own > most {
            continue;
        }
        let total = own + heights.missed(count, most - own);
        if total <= most {
            return Some((count, MOVED * total));
        }
    }
    None
}

/// Chebyshev nodes on a window: numbers of the machine where these are fine enough, else what they are from its middle.
fn placed(c: f64, r: f64, count: usize) -> (f64, Vec<f64>) {
    let at = nodes(count).places.iter();
    if f64::EPSILON * c.abs() <= GRID * r {
        return (0.0, at.map(|t| c + r * t).collect());
    }
    let finest = GRID * power_of_two(r);
    (c, at.map(|t| (r * t / finest).round() * finest).collect())
}

/// The largest power of two that is no larger, of a normal number.
fn power_of_two(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & f64::INFINITY.to_bits())
}

/// What rounded nodes make of bounds of the polynomial through values at them.
fn crowded(c: f64, r: f64, count: usize) -> f64 {
    let moved = (UNIT * c.abs() / r).min(GRID);
    1.0 / (1.0 - lebesgue(count) * (count * count) as f64 * moved)
}
