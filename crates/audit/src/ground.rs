//! Plane ground that a transfer function describes: what its kernel has beside the logarithm.
//!
//! `K(d) = m ln(1/d) + int_0^inf ((M(v) - m)/v) cos(v d/h) dv` is `ln(1/d) + R(d)`. With `-ln t = int_0^inf (cos vt - exp(-2v))/v dv - ln 2`,
//!
//! `R(d) = int_0^inf [(M(v) - 1) cos(v d/h) + (1 - m) exp(-2v)]/v dv + (1 - m) ln 2h`.
//!
//! The potential of `R` is found from the transform of the density on each wave number: not from a table of `R`.

use crate::allowance::UNIT;
use crate::chebyshev;
use crate::density::Density;
use crate::kernel::{Layered, SPLITS};
use crate::legendre::RULE;
use crate::profile::Profile;

/// Beyond this `v` a transfer function counts as 1.
const LAST: f64 = 25.0;
/// Panels of `v` are so long at most, and so many times `h`: then `cos(v d/h)`, `d <= 2`, turns by 12 on one, which 24 nodes integrate to rounding. They halve so often towards 0.
const LONGEST: f64 = 0.5;
const TURN: f64 = 6.0;
const HALVINGS: usize = 20;
/// The rule is compared with one of panels so much shorter, at so many distances.
const OTHER: f64 = 0.55;
const COMPARED: u32 = 16;
/// Distances at which `R` is looked at.
const SAMPLES: u32 = 256;
/// Panels of the density are cut to so many thicknesses, on which no wave turns by more than 15; those of its potential are twice the thickness, half as far from its singularities at `2ih`.
const CUT: f64 = 0.6;
const NODES: usize = 24;

/// A wave number `v`, with the weights of `M - 1` and of `(1 - m) exp(-2v)`, both over `v`.
type Wave = [f64; 3];

/// Ground of which the transfer function is known.
#[derive(Debug, Clone)]
pub struct Ground {
    length: f64,
    waves: Vec<Wave>,
    /// `(1 - m) ln 2h`
    constant: f64,
    kernel: Layered,
    /// What the quadrature of `R` may be off by.
    error: f64,
    /// A bound of `|R'|` in the strip `|Im d| <= h`.
    slope: f64,
}

impl Ground {
    /// Of the length `h`, `m = M(0)` and `M`, which is 1 from `v = 25` on.
    #[must_use]
    pub fn new(length: f64, far_share: f64, transfer: &dyn Fn(f64) -> f64) -> Self {
        let width = LONGEST.min(TURN * length);
        let waves = waves(width, far_share, transfer);
        let constant = (1.0 - far_share) * (2.0 * length).ln();
        let remainder = |waves: &[Wave], d: f64| constant + sum(waves, d / length);
        let other = self::waves(OTHER * width, far_share, transfer);
        let distance = |i: u32, count: u32| 2.0 * f64::from(i) / f64::from(count);
        let off = (0..=COMPARED)
            .map(|i| distance(i, COMPARED))
            .map(|d| (remainder(&waves, d) - remainder(&other, d)).abs())
            .fold(0.0, f64::max);
        let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
        for i in 0..=SAMPLES {
            let value = remainder(&waves, distance(i, SAMPLES));
            (low, high) = (low.min(value), high.max(value));
        }
        let moment = |grown: f64| -> f64 {
            waves.iter().map(|[v, m, _]| (v * m).abs() * (grown * v).exp()).sum::<f64>() / length
        };
        // Between the samples R changes by its slope, and it is even.
        let between = 0.5 * distance(1, SAMPLES) * moment(0.0);
        let sizes: f64 = waves.iter().map(|[_, m, e]| m.abs() + e.abs()).sum();
        let tail = (transfer(LAST) - 1.0).abs();
        let kernel = Layered {
            constant: 0.5 * (low + high),
            rest: 0.5 * (high - low) + between,
            is_positive: is_positive(far_share, &waves, transfer),
            splits: (far_share == 0.0).then(|| splits(length, &waves, transfer)),
        };
        let error = off + tail + 8.0 * UNIT * (sizes + constant.abs());
        let slope = moment(1.0);
        Self { length, waves, constant, kernel, error, slope }
    }

    /// Its kernel.
    #[must_use]
    pub fn kernel(&self) -> crate::Kernel {
        crate::Kernel::Layered(self.kernel)
    }

    /// Whether the kernel is positive on `[-1, 1]` for pressures of any force, not only for those without: where `M >= m`, it is `m ln(1/d)` and a function whose transform is positive.
    #[must_use]
    pub fn is_positive(&self) -> bool {
        self.kernel.is_positive
    }
}

/// `sum` over the rule at `t = d/h`.
fn sum(waves: &[Wave], t: f64) -> f64 {
    waves.iter().rev().map(|[v, m, e]| m * (v * t).cos() + e).sum()
}

fn waves(width: f64, far_share: f64, transfer: &dyn Fn(f64) -> f64) -> Vec<Wave> {
    let count = (LAST / width).ceil();
    let first = LAST / count;
    let mut ends = vec![0.0];
    ends.extend((0..HALVINGS as i32).rev().map(|k| first * 0.5f64.powi(k)));
    let mut k = 2.0;
    while k <= count {
        ends.push(first * k);
        k += 1.0;
    }
    let panels = ends.windows(2).map(|pair| [0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0])]);
    panels
        .flat_map(|[middle, half]| {
            RULE.nodes.iter().zip(&RULE.weights).map(move |(t, w)| (middle + half * t, half * w))
        })
        .map(|(v, w)| {
            [v, w * (transfer(v) - 1.0) / v, w * (1.0 - far_share) * (-2.0 * v).exp() / v]
        })
        .collect()
}

/// Whether `M >= m` at all nodes, but for rounding.
fn is_positive(far_share: f64, waves: &[Wave], transfer: &dyn Fn(f64) -> f64) -> bool {
    waves.iter().all(|[v, ..]| transfer(*v) >= far_share * (1.0 - 64.0 * UNIT))
}

/// Of `K` below the wave number `N` the value at 0, `int_0^N M(qh)/q dq`, and of what is above the norm of a row, at most `sqrt(pi/N) max M`; at `N h` from 25 down by halves, then up.
fn splits(length: f64, waves: &[Wave], transfer: &dyn Fn(f64) -> f64) -> [[f64; 2]; SPLITS] {
    let highest = waves.iter().map(|[v, ..]| transfer(*v)).fold(1.0, f64::max);
    let ends: Vec<f64> = (0..SPLITS as i32).map(|k| LAST * 0.5f64.powi(8 - k)).collect();
    std::array::from_fn(|k| {
        let [mut below, mut last] = [0.0; 2];
        // The rule up to the end of a node is off by one node's part.
        let mut next = 0.0;
        for [v, _, e] in waves {
            // Of m = 0 the weight itself, over v.
            let part = e * (2.0 * v).exp() * transfer(*v);
            if *v > ends[k] {
                next = part;
                break;
            }
            below += part;
            last = *v;
        }
        let beyond = (ends[k] / last.max(f64::MIN_POSITIVE)).ln().max(0.0) * highest;
        let row = highest * (std::f64::consts::PI * length / ends[k]).sqrt();
        [below + next + beyond, row]
    })
}

/// The base, with what the remainder's potential adds to it: `f + theta int (R - c) q ds`.
pub(crate) struct Raised<'a> {
    profile: &'a dyn Profile,
    theta: f64,
    /// Chebyshev coefficients of the potential on equal parts of `[-1, 1]`.
    parts: Vec<Vec<f64>>,
    error: f64,
    /// Bounds of the potential and of its slope in the strip, and the width of that.
    largest: f64,
    slope: f64,
    length: f64,
}

impl<'a> Raised<'a> {
    pub(crate) fn new(
        profile: &'a dyn Profile,
        ground: &Ground,
        theta: f64,
        density: &Density,
    ) -> Self {
        let places = places(density, CUT * ground.length);
        let force: f64 = places.iter().map(|[_, q]| q).sum();
        let mass: f64 = density.panels.iter().map(crate::panel::Panel::mass).sum();
        let transform: Vec<[f64; 2]> = (ground.waves.iter())
            .map(|[v, m, _]| {
                let (mut even, mut odd) = (0.0, 0.0);
                for [s, q] in &places {
                    let (sin, cos) = (v * s / ground.length).sin_cos();
                    even += q * cos;
                    odd += q * sin;
                }
                [m * even, m * odd]
            })
            .collect();
        let plain: f64 = ground.waves.iter().rev().map(|[_, _, e]| e).sum();
        let level = force * (plain + ground.constant - ground.kernel.constant);
        let at = |x: f64| -> f64 {
            let waves = ground.waves.iter().zip(&transform).rev();
            let sum: f64 = waves
                .map(|([v, ..], [even, odd])| {
                    let (sin, cos) = (v * x / ground.length).sin_cos();
                    even * cos + odd * sin
                })
                .sum();
            sum + level
        };
        let count = (1.0 / ground.length).ceil().max(1.0);
        let half = 1.0 / count;
        let nodes = chebyshev::nodes(NODES);
        let parts: Vec<Vec<f64>> = (0..count as u32)
            .map(|k| {
                let middle = -1.0 + (2.0 * f64::from(k) + 1.0) * half;
                let values: Vec<f64> = nodes.places.iter().map(|t| at(middle + half * t)).collect();
                nodes.coefficients(&values)
            })
            .collect();
        let tail = (parts.iter())
            .map(|c| 2.0 * (c[NODES - 1].abs() + c[NODES - 2].abs()))
            .fold(0.0, f64::max);
        Self {
            profile,
            theta,
            parts,
            error: tail + ground.error * mass,
            largest: ground.kernel.rest * mass,
            slope: ground.slope * mass,
            length: ground.length,
        }
    }

    fn potential(&self, x: f64) -> f64 {
        let count = self.parts.len() as f64;
        let place = 0.5 * (x + 1.0) * count;
        let index = place.floor().clamp(0.0, count - 1.0);
        chebyshev::evaluate(&self.parts[index as usize], 2.0 * (place - index) - 1.0)
    }

    /// A range of the profile with that of the potential added to it.
    fn with(&self, [low, high]: [f64; 2], x: f64, off: f64) -> [f64; 2] {
        let (value, off) = (self.theta * self.potential(x), self.theta * (self.error + off));
        let rounding = 2.0 * UNIT * (value.abs() + low.abs().max(high.abs()));
        [low + value - off - rounding, high + value + off + rounding]
    }
}

impl Profile for Raised<'_> {
    fn height(&self, x: f64) -> [f64; 2] {
        self.with(self.profile.height(x), x, 0.0)
    }

    fn heights(&self, places: &[f64], found: &mut [[f64; 2]]) {
        self.profile.heights(places, found);
        for (range, x) in found.iter_mut().zip(places) {
            *range = self.with(*range, *x, 0.0);
        }
    }

    fn range(&self, [left, right]: [f64; 2]) -> [f64; 2] {
        let off = 0.5 * (right - left) * self.slope;
        self.with(self.profile.range([left, right]), 0.5 * (left + right), off)
    }

    /// By Cauchy's inequality the `n`-th derivative of the slope is at most `n! h^-n` times its bound in the strip.
    fn taylor_bounds(&self, interval: [f64; 2], order: usize) -> Vec<f64> {
        let mut bounds = self.profile.taylor_bounds(interval, order);
        for (n, bound) in bounds.iter_mut().enumerate() {
            let own = match n {
                0 => self.largest,
                _ => self.slope * self.length.powi(1 - n as i32) / n as f64,
            };
            *bound += self.theta * own;
        }
        bounds
    }

    fn looks(&self, interval: [f64; 2]) -> u64 {
        self.profile.looks(interval)
    }
}

/// Gauss nodes of the density with their masses, on its panels cut to this length.
fn places(density: &Density, longest: f64) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    for panel in &density.panels {
        let count = (2.0 * panel.half() / longest).ceil().max(1.0);
        let half = panel.half() / count;
        let mut k = 0.0;
        while k < count {
            let middle = panel.left + (2.0 * k + 1.0) * half;
            for (t, w) in RULE.nodes.iter().zip(&RULE.weights) {
                let x = middle + half * t;
                found.push([x, half * w * panel.evaluate(x)]);
            }
            k += 1.0;
        }
    }
    found
}
