//! The residual of an answer, bounded between the places where it is computed.
//!
//! `w = q + theta K q - (delta - alpha x - f)`. On a window `[c - r, c + r]` it is the sum of a function that is analytic in the disk of radius `R > r` about `c`, the profile, and a
//! remainder: in that disk the density is replaced by one polynomial, off by at most `eta`, so the potential of what is left is at most `eta int |K|`. Interpolation at Chebyshev
//! nodes then bounds the analytic part from its values, with the remainders of the book's chapter on the audit.

use crate::Profile;
use crate::chebyshev::{evaluate, lebesgue, nodes};
use crate::density::Density;
use crate::kernel::Singularity;

/// Radius of the disk in radii of the window, if nothing is in the way; and below which a window is halved instead.
const DISK: f64 = 1.8;
const LEAST_DISK: f64 = 1.3;
/// The largest ellipse of analyticity that is used, in radii of the disk.
const INSIDE: f64 = 0.97;
/// Nodes of the polynomial that stands for the density in a disk.
const DENSITY_NODES: usize = 22;
/// Numbers of nodes on a window.
const COUNTS: [usize; 10] = [5, 7, 9, 12, 15, 19, 23, 28, 33, 40];
/// Share of the budget for interpolation: a few nodes more make it small.
const FINE: f64 = 0.2;
/// Share of the residual that remainders may have.
const SHARE: f64 = 0.15;
/// Jumps of the density that a window may have in its remainders, in jumps: its residual has about as much.
const JUMPS: f64 = 16.0;
/// Larger jumps, relative to the density, are no noise: windows shrink to them.
const NOISE: f64 = 1e-8;
/// Windows are at least this wide, relative to their distance from the origin: some units of the machine.
const FINEST: f64 = 4.0 * f64::EPSILON;
/// Beside the origin, where numbers are as fine as one likes, they are at least that of this share of the whole.
const SMALLEST: f64 = 1e-3;
/// Numbers of a window that are looked at one by one.
const MOST_NUMBERS: usize = 32;
/// Unit of rounding.
const UNIT: f64 = 0.5 * f64::EPSILON;

/// How far a jump of the base may lie from where its formula jumps: some roundings of its place.
pub(crate) fn blur(x: f64) -> f64 {
    4.0 * FINEST * x.max(SMALLEST)
}

/// What is known of the residual on a window.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounded {
    pub(crate) left: f64,
    pub(crate) right: f64,
    /// A bound of `|w|` in a zone, of `max(-w, 0)` beside zones.
    pub(crate) largest: f64,
    /// A bound of the norm of the same in `L2` of the window.
    pub(crate) norm: f64,
    /// The largest of these at numbers of the machine in the window, where it is as narrow as these allow: elsewhere the same.
    pub(crate) at_numbers: f64,
    /// A lower bound of `w`.
    pub(crate) least: f64,
    /// Whether the window could not be resolved: its measure is a few units of the machine.
    pub(crate) is_narrow: bool,
}

/// Why the residual was not bounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TooManyWindows {
    pub(crate) at: f64,
}

/// An answer of which the residual is formed.
pub(crate) struct Residual<'a> {
    pub(crate) density: &'a Density,
    pub(crate) profile: &'a dyn Profile,
    pub(crate) theta: f64,
    pub(crate) settlement: f64,
    pub(crate) tilt: f64,
    /// What `theta` and the profile may be off by, relative to their sizes.
    pub(crate) scaled: f64,
}

impl Residual<'_> {
    /// `w(x)` and a bound of its rounding.
    pub(crate) fn at(&self, x: f64) -> (f64, f64) {
        self.with_potential(x, self.density.potential(x))
    }

    fn with_potential(&self, x: f64, (potential, rounding): (f64, f64)) -> (f64, f64) {
        let q = self.density.evaluate(x);
        let [low, high] = self.profile.height(x);
        let height = 0.5 * (low + high);
        let value = q + self.theta * potential - (self.settlement - self.tilt * x - height);
        let given = self.settlement.abs() + self.tilt.abs() + height.abs();
        let size = 32.0 * q.abs() + 4.0 * self.theta * potential.abs() + 4.0 * given;
        let scaled = self.scaled * (self.theta * potential.abs() + given);
        (value, self.theta * rounding + (high - low) + UNIT * size + scaled)
    }

    /// Bounds of `|w|` on windows that cover a zone.
    pub(crate) fn in_zone(
        &self,
        zone: [f64; 2],
        most: usize,
        found: &mut Vec<Bounded>,
    ) -> Result<(), TooManyWindows> {
        self.cover(zone, most, found, &|window| self.window_in_zone(window, zone))
    }

    /// Lower bounds of `w` on windows that cover an interval beside the zones.
    pub(crate) fn beside_zones(
        &self,
        gap: [f64; 2],
        most: usize,
        found: &mut Vec<Bounded>,
    ) -> Result<(), TooManyWindows> {
        self.cover(gap, most, found, &|window| self.window_in_gap(window))
    }

    fn cover(
        &self,
        whole: [f64; 2],
        most: usize,
        found: &mut Vec<Bounded>,
        bound: &dyn Fn([f64; 2]) -> Option<Bounded>,
    ) -> Result<(), TooManyWindows> {
        let mut stack = vec![whole];
        while let Some([left, right]) = stack.pop() {
            let middle = 0.5 * (left + right);
            let size = left.abs().max(right.abs()).max(SMALLEST * (whole[1] - whole[0]));
            if right - left <= FINEST * size || middle <= left || middle >= right {
                found.push(self.narrow([left, right]));
            } else if let Some(window) = bound([left, right]) {
                found.push(window);
            } else {
                stack.push([middle, right]);
                stack.push([left, middle]);
            }
            if found.len() + stack.len() > most {
                return Err(TooManyWindows { at: middle });
            }
        }
        Ok(())
    }

    /// A window of some units of the machine: its numbers one by one, and between them what can be at most.
    fn narrow(&self, [left, right]: [f64; 2]) -> Bounded {
        let is_inside = self.density.panel_at(0.5 * (left + right)).is_some();
        // Jumps of the base are known to some roundings of their places.
        let blur = blur(left.abs().max(right.abs()));
        let [low, high] = self.profile.range([left - blur, right + blur]);
        let (mut largest, mut least, mut at_numbers) = (0.0f64, f64::INFINITY, 0.0f64);
        let mut x = left;
        let mut looked_at = 0;
        while x <= right && looked_at < MOST_NUMBERS {
            looked_at += 1;
            let (w, error) = self.at(x);
            let size = |w: f64| if is_inside { w.abs() } else { (-w).max(0.0) };
            largest = largest.max(size(w) + error);
            least = least.min(w - error);
            // Where the base jumps its height is that of either side, also where rounding leaves open of which.
            let [f_low, f_high] = self.profile.height(x);
            let f = 0.5 * (f_low + f_high);
            let [lower, upper] = [w + (low - f).min(0.0), w + (high - f).max(0.0)];
            let nearest = if lower > 0.0 { lower } else { upper.min(0.0) };
            at_numbers = at_numbers.max(size(nearest) + (error - (f_high - f_low)));
            x = x.next_up();
        }
        let crude = largest + self.variation([left, right]);
        // Beside the origin there are more than can be looked at.
        let at_numbers = if x <= right { crude } else { at_numbers };
        let least = least - self.variation([left, right]);
        let norm = crude * (right - left).sqrt();
        Bounded { left, right, largest: crude, norm, at_numbers, least, is_narrow: true }
    }

    /// A bound of how much `w` changes in a narrow window.
    fn variation(&self, [left, right]: [f64; 2]) -> f64 {
        let [low, high] = self.profile.range([left, right]);
        let (c, width) = (0.5 * (left + right), right - left);
        let mu = self.density.kernel.singularity().exponent();
        let mut potential = 0.0;
        self.density.parts(c, &mut |distance, mass, largest, length| {
            let gap = distance - width;
            potential += if gap > width && gap > 0.25 * length {
                if mu == 0.0 { mass * width / gap } else { mass * mu * width / gap.powf(1.0 + mu) }
            } else if mu == 0.0 {
                largest * 2.0 * width * (3.0 + (1.0 + length / width).ln())
            } else {
                largest * 8.0 * width.powf(1.0 - mu) / (1.0 - mu)
            };
        });
        (high - low)
            + self.theta * potential
            + self.tilt.abs() * width
            + self.own_variation([left, right])
    }

    /// A bound of how much the density changes.
    fn own_variation(&self, [left, right]: [f64; 2]) -> f64 {
        let first = self.density.panels.partition_point(|panel| panel.right < left);
        let (mut change, mut before) = (0.0, None);
        for panel in self.density.panels[first..].iter().take_while(|panel| panel.left <= right) {
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

    /// A bound of `|w|` on a window of a zone; none where it has to be halved.
    fn window_in_zone(&self, [left, right]: [f64; 2], zone: [f64; 2]) -> Option<Bounded> {
        let (c, r) = (0.5 * (left + right), 0.5 * (right - left));
        let disk = (DISK * r).min(INSIDE * (c - zone[0]).min(zone[1] - c));
        if disk < LEAST_DISK * r {
            return None;
        }
        let (middle, error) = self.at(c);
        let fitted = self.fit(c, disk);
        let singularity = self.density.kernel.singularity();
        // Where panels meet the density jumps by what it is off by: windows cannot know it better.
        let noise =
            JUMPS * fitted.jump.min(NOISE * fitted.largest).max(4.0 * UNIT * fitted.largest);
        let budget = (SHARE * middle.abs()).max(2.0 * error).max(noise);
        let missed = fitted.missed * (1.0 + self.theta * local_mass(singularity, disk));
        if missed > budget {
            return None;
        }
        // The ellipse about the window with the foci at its ends and this half-axis has its rho; the one about the disk that contains it its gamma.
        let axis = INSIDE * disk / r;
        let rho = axis + (axis * axis - 1.0).sqrt();
        let minor = (axis * axis - 1.0).sqrt() * r / disk;
        let gamma = minor + (1.0 + minor * minor).sqrt();
        let parts = self.density_parts(c, disk);
        let (count, remainder) = self.count([left, right], budget, |count| {
            let fallen = 4.0 * rho.powi(1 - count as i32) / (rho - 1.0);
            let plain = 1.0 + lebesgue(count);
            let potential = fitted.sum(|k| {
                let analytic = fallen * gamma.powi(k) * local_potential(singularity, disk);
                analytic.min(plain * local_mass(singularity, disk))
            });
            let own = fitted.sum(|k| {
                if (k as usize) < count { 0.0 } else { (fallen * gamma.powi(k)).min(plain) }
            });
            own + self.theta * (potential + outside(&parts, singularity, r, count))
        })?;
        let (values, error) = self.values(c, r, count);
        let rest = remainder + missed;
        let largest = self.sup(&values, count, error + missed) + rest;
        // The square of a polynomial of degree n - 1 is integrated exactly against (1 - t^2)^(-1/2) >= 1 by the sum over n nodes times pi/n.
        let squares: f64 = values.iter().map(|w| (w.abs() + error + missed).powi(2)).sum();
        let norm =
            (std::f64::consts::PI * r * squares / count as f64).sqrt() + rest * (2.0 * r).sqrt();
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

    fn density_parts(&self, c: f64, disk: f64) -> Vec<(f64, f64)> {
        let mut parts = Vec::new();
        self.density.parts(c, &mut |distance, mass, _, _| parts.push((distance.max(disk), mass)));
        parts
    }

    /// The smallest number of nodes with which all remainders are within the budget, and the remainder.
    fn count(
        &self,
        window: [f64; 2],
        budget: f64,
        remainder: impl Fn(usize) -> f64,
    ) -> Option<(usize, f64)> {
        let r = 0.5 * (window[1] - window[0]);
        let mut profile = ProfileRemainder::new(self.profile, window);
        for count in COUNTS {
            let own = remainder(count);
            if own > FINE * budget {
                continue;
            }
            let total = own + profile.at_nodes(count, r);
            if total <= FINE * budget {
                return Some((count, total));
            }
        }
        None
    }

    fn values(&self, c: f64, r: f64, count: usize) -> (Vec<f64>, f64) {
        let places: Vec<f64> = nodes(count).places.iter().map(|t| c + r * t).collect();
        let mut potentials = vec![(0.0, 0.0); count];
        self.density.potentials(&places, &mut potentials);
        let mut largest = 0.0f64;
        let values = (places.iter().zip(potentials))
            .map(|(x, potential)| {
                let (w, error) = self.with_potential(*x, potential);
                largest = largest.max(error);
                w
            })
            .collect();
        (values, largest)
    }

    /// A bound of the polynomial through values that are off by `error` each.
    fn sup(&self, values: &[f64], count: usize, error: f64) -> f64 {
        let lebesgue = lebesgue(count);
        let largest = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        let sum: f64 = nodes(count).coefficients(values).map(f64::abs).sum();
        (lebesgue * largest).min(sum) + lebesgue * error
    }

    /// A lower bound of `w` on a window beside the zones; none where it has to be halved.
    fn window_in_gap(&self, [left, right]: [f64; 2]) -> Option<Bounded> {
        let (c, r) = (0.5 * (left + right), 0.5 * (right - left));
        let (middle, error) = self.at(c);
        let singularity = self.density.kernel.singularity();
        let parts = self.density_parts(c, LEAST_DISK * r);
        // A panel that reaches into the window's own disk may touch the window.
        let mut is_near = false;
        self.density.parts(c, &mut |distance, mass, _, _| {
            is_near |= mass > 0.0 && distance < LEAST_DISK * r;
        });
        if is_near {
            return None;
        }
        let budget = (SHARE * middle.abs()).max(2.0 * error);
        let (count, remainder) = self.count([left, right], budget, |count| {
            self.theta * outside(&parts, singularity, r, count)
        })?;
        let (values, error) = self.values(c, r, count);
        let mut swing = 0.0;
        let mut mean = 0.0;
        for (k, a) in nodes(count).coefficients(&values).enumerate() {
            if k == 0 { mean = a } else { swing += a.abs() }
        }
        let error = (1.0 + lebesgue(count)) * error + remainder;
        let least = mean - swing - error;
        let lowest = values.iter().copied().fold(f64::INFINITY, f64::min);
        if least < -(2.0 * error).max(-2.0 * lowest) {
            return None;
        }
        let largest = (-least).max(0.0);
        let norm = largest * (right - left).sqrt();
        Some(Bounded { left, right, largest, norm, at_numbers: largest, least, is_narrow: false })
    }

    /// The polynomial that stands for the density in a disk.
    fn fit(&self, c: f64, disk: f64) -> Fitted {
        let panels = &self.density.panels;
        let first = panels.partition_point(|panel| panel.right <= c - disk);
        let last = panels.partition_point(|panel| panel.left < c + disk);
        let count = if last - first == 1 { crate::legendre::ORDER } else { DENSITY_NODES };
        let at = nodes(count);
        let values: Vec<f64> =
            at.places.iter().map(|t| self.density.evaluate(c + disk * t)).collect();
        let coefficients: Vec<f64> = at.coefficients(&values).collect();
        let largest =
            panels[first..last].iter().fold(0.0f64, |most, panel| most.max(panel.largest));
        let mut missed = 0.0f64;
        if last - first > 1 {
            // A polynomial is nowhere more than 1/cos(pi degree/(2 n)) of its largest value at n Chebyshev nodes.
            let samples = nodes(SAMPLES);
            let factor = 1.0
                / (std::f64::consts::PI * (DENSITY_NODES - 1) as f64 / (2 * SAMPLES) as f64).cos();
            for panel in &panels[first..last] {
                let (l, r) = (panel.left.max(c - disk), panel.right.min(c + disk));
                let (middle, half) = (0.5 * (l + r), 0.5 * (r - l));
                for t in &samples.places {
                    let x = middle + half * t;
                    let other = evaluate(&coefficients, ((x - c) / disk).clamp(-1.0, 1.0));
                    missed = missed.max(factor * (panel.evaluate(x) - other).abs());
                }
            }
        }
        let jump = (panels[first..last].windows(2))
            .map(|pair| (pair[0].evaluate(pair[0].right) - pair[1].evaluate(pair[1].left)).abs())
            .fold(0.0, f64::max);
        Fitted { coefficients, missed: missed + 32.0 * UNIT * largest, jump, largest }
    }
}

/// What interpolation of the profile misses on a window.
pub(crate) struct ProfileRemainder<'a> {
    profile: &'a dyn Profile,
    window: [f64; 2],
    bounds: Vec<f64>,
}

impl<'a> ProfileRemainder<'a> {
    pub(crate) fn new(profile: &'a dyn Profile, window: [f64; 2]) -> Self {
        Self { profile, window, bounds: Vec::new() }
    }

    /// At `n` Chebyshev nodes `f^(n)/n! 2 (r/2)^n`; or what fewer miss, times one more than Lebesgue's constant.
    pub(crate) fn at_nodes(&mut self, count: usize, r: f64) -> f64 {
        if self.bounds.len() <= count {
            // High orders are dear: only as many as may be needed.
            let order = ORDERS.into_iter().find(|order| *order >= count).unwrap_or(count);
            self.bounds = self.profile.taylor_bounds(self.window, order);
        }
        let missed = |n: usize| {
            let bound = self.bounds.get(n).copied().unwrap_or(f64::INFINITY);
            // No product of zero and infinity.
            if bound == 0.0 { 0.0 } else { 2.0 * (0.5 * r).powi(n as i32) * bound }
        };
        let fewer = (2..count).map(missed).fold(f64::INFINITY, f64::min);
        missed(count).min((1.0 + lebesgue(count)) * fewer)
    }
}

/// Orders of derivatives of the profile that are asked for together.
const ORDERS: [usize; 4] = [9, 15, 23, 40];

/// Places at which a piece of the density is compared with the polynomial that stands for it.
const SAMPLES: usize = 36;

/// A polynomial in a disk about a window.
struct Fitted {
    /// Chebyshev coefficients on the diameter.
    coefficients: Vec<f64>,
    /// A bound of what it misses.
    missed: f64,
    /// The largest jump of the density between its panels, and its largest size.
    jump: f64,
    largest: f64,
}

impl Fitted {
    /// The sum of the sizes of its coefficients, each times a weight.
    fn sum(&self, weight: impl Fn(i32) -> f64) -> f64 {
        self.coefficients.iter().zip(0..).map(|(c, k)| c.abs() * weight(k)).sum()
    }
}

/// `int |sigma|` over a disk's diameter from any of its points, for the window inside.
fn local_mass(singularity: Singularity, disk: f64) -> f64 {
    match singularity {
        Singularity::Logarithm => 2.0 * disk * (1.0 + disk.ln().abs() + 1.0),
        Singularity::Power(mu) => 4.0 * disk.powf(1.0 - mu) / (1.0 - mu),
    }
}

/// A bound of the potential of a density of size one on the diameter, continued into the disk: along straight paths from either end, the logarithm relative to the disk's radius.
fn local_potential(singularity: Singularity, disk: f64) -> f64 {
    match singularity {
        Singularity::Logarithm => 13.2 * disk,
        Singularity::Power(mu) => 2.0 * (2.0 * disk).powf(1.0 - mu) / (1.0 - mu),
    }
}

/// What interpolation of the potential of masses at their distances from the middle of a window misses.
///
/// `ln|x - t| = const - 2 sum rho^-k T_k(x)/k` and `|x - t|^-mu = (r rho/2)^-mu sum C_k^mu(x) rho^-k`, with `rho = D + sqrt(D^2 - 1)`, `D = |t - c|/r`: nodes alias each term to at most
/// its own size. The images of a row that are more than one period away add less than a tenth.
fn outside(parts: &[(f64, f64)], singularity: Singularity, r: f64, count: usize) -> f64 {
    let n = count as f64;
    let mut sum = 0.0;
    for (distance, mass) in parts {
        let d = distance / r;
        let inverse = 1.0 / (d + (d * d - 1.0).max(0.0).sqrt());
        let fallen = inverse.powi(count as i32);
        sum += mass
            * match singularity {
                Singularity::Logarithm => 4.0 * fallen / (n * (1.0 - inverse)),
                Singularity::Power(mu) => {
                    let rest = (n + 1.0) / (1.0 - inverse) + inverse / (1.0 - inverse).powi(2);
                    2.0 * (0.5 * r / inverse).powf(-mu) * fallen * rest
                }
            };
    }
    1.1 * sum
}
