//! The slope `h = df0/dr` of the base along a radius, and its integrals under the disk.

use std::f64::consts::FRAC_PI_2;

use crate::contact::smooth::Curve;
use crate::contact::smooth::legendre::integral;

/// Panels are halved at most this often; to this share integrals agree when their panels are halved.
const DEEPEST: u32 = 40;
const AGREED: f64 = 1e-15;
/// Differences this small that do not fall when panels are halved are rounding.
const NOISE: f64 = 1e-11;

/// What the slope is multiplied by, `r = x sin t`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Weight {
    One,
    SineSquared,
    CosineSquared,
}

impl Weight {
    fn at(self, angle: f64) -> f64 {
        match self {
            Self::One => 1.0,
            Self::SineSquared => angle.sin().powi(2),
            Self::CosineSquared => angle.cos().powi(2),
        }
    }
}

/// The base of revolution.
pub(super) struct Shape<'p> {
    pub(super) slope: &'p Curve,
    /// Where it bends, in `(0, 1)`, increasing.
    pub(super) breaks: Vec<f64>,
    /// To which share integrals are wanted.
    pub(super) tolerance: f64,
}

impl Shape<'_> {
    /// `G(x) = x int_0^x h(r) dr/sqrt(x^2 - r^2)`: the height `f0(0) + G` that a disk of the radius `x` with a free edge settles by.
    pub(super) fn transform(&self, x: f64) -> f64 {
        x * self.integral(x, Weight::One)
    }

    /// `int_0^{pi/2} h(x sin t) w(t) dt`.
    pub(super) fn integral(&self, x: f64, weight: Weight) -> f64 {
        let mut cuts = vec![(0.0, 0.0)];
        let inside = self.breaks.iter().filter(|at| **at < x);
        cuts.extend(inside.map(|&at| (at.atan2(((x - at) * (x + at)).sqrt()), at)));
        cuts.push((FRAC_PI_2, x));
        let value = |angle: f64, ends: [f64; 2]| {
            // Rounding must not pass a kink.
            let r = (x * angle.sin()).clamp(ends[0], ends[1]);
            (self.slope)(r) * weight.at(angle)
        };
        let pieces: Vec<([f64; 2], [f64; 2])> = (cuts.windows(2))
            .map(|pair| {
                let to = if pair[1].1 < x { pair[1].1.next_down() } else { x };
                let from = pair[0].1.next_up().min(to);
                ([pair[0].0, pair[1].0], [from, to])
            })
            .collect();
        let size: f64 = (pieces.iter())
            .map(|&([from, to], ends)| integral(from, to, |angle| value(angle, ends).abs()))
            .sum();
        let rule = Adaptive { agreed: self.tolerance.max(AGREED) * size, noise: NOISE * size };
        pieces
            .iter()
            .map(|&([from, to], ends)| {
                let f = |angle: f64| value(angle, ends);
                rule.refined(&f, [from, to], integral(from, to, f), 0, f64::INFINITY)
            })
            .sum()
    }
}

struct Adaptive {
    agreed: f64,
    noise: f64,
}

impl Adaptive {
    fn refined(
        &self,
        f: &impl Fn(f64) -> f64,
        [from, to]: [f64; 2],
        whole: f64,
        depth: u32,
        before: f64,
    ) -> f64 {
        let middle = 0.5 * (from + to);
        let halves = [[from, middle], [middle, to]];
        let parts = halves.map(|[from, to]| integral(from, to, f));
        let sum = parts[0] + parts[1];
        let difference = (sum - whole).abs();
        let is_noise = difference >= 0.5 * before && difference <= self.noise;
        if difference <= self.agreed || is_noise || depth >= DEEPEST || !difference.is_finite() {
            return sum;
        }
        let part = |i: usize| self.refined(f, halves[i], parts[i], depth + 1, difference);
        part(0) + part(1)
    }
}
