//! The slope `h = df0/dr` of the base along a radius, and its integrals under the disk.

use std::collections::VecDeque;
use std::f64::consts::FRAC_PI_2;

use crate::contact::smooth::Curve;
use crate::contact::smooth::legendre::integral;

/// Panels are halved at most this often; to this share integrals agree when their panels are halved.
const DEEPEST: u32 = 40;
const AGREED: f64 = 1e-15;
/// Differences this small that do not fall when panels are halved are rounding.
const NOISE: f64 = 1e-11;
/// Panels of an integral at most, and its accuracy over that of what is made of it.
const MOST_PANELS: usize = 512;
const INNER: f64 = 1e-2;

/// What the slope is multiplied by, `r = x cos t`.
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
    /// `G(x) = x int_0^x h(r) dr/sqrt(x^2 - r^2)`: the height above `f0(0)` that a disk of the radius `x` with a free edge settles by.
    pub(super) fn transform(&self, x: f64) -> f64 {
        x * self.integral(x, Weight::One)
    }

    /// `G(x)` at `x = sqrt(b^2 + s^2)`, however small `s` is against the kink `b`.
    pub(super) fn transform_beyond(&self, kink: f64, s: f64) -> f64 {
        let x = kink.hypot(s);
        let leg = |at: f64| ((kink - at) * (kink + at) + s * s).sqrt();
        x * self.integrated(x, Weight::One, leg)
    }

    /// `int_0^{pi/2} h(x cos t) w(t) dt`.
    pub(super) fn integral(&self, x: f64, weight: Weight) -> f64 {
        self.integrated(x, weight, |at| ((x - at) * (x + at)).sqrt())
    }

    /// The same by the distances `sqrt(x^2 - b^2)` from the kinks.
    fn integrated(&self, x: f64, weight: Weight, leg: impl Fn(f64) -> f64) -> f64 {
        let mut cuts = vec![(FRAC_PI_2, 0.0)];
        let inside = self.breaks.iter().map(|&at| (at, leg(at))).filter(|(_, leg)| *leg > 0.0);
        cuts.extend(inside.map(|(at, leg)| (leg.atan2(at), at)));
        cuts.push((0.0, x));
        let value = |angle: f64, ends: [f64; 2]| {
            // Rounding must not pass a kink.
            let r = (x * angle.cos()).clamp(ends[0], ends[1]);
            (self.slope)(r) * weight.at(angle)
        };
        let pieces: Vec<([f64; 2], [f64; 2])> = (cuts.windows(2))
            .map(|pair| {
                let to = if pair[1].1 < x { pair[1].1.next_down() } else { x };
                let from = pair[0].1.next_up().min(to);
                ([pair[1].0, pair[0].0], [from, to])
            })
            .collect();
        let size: f64 = (pieces.iter())
            .map(|&([from, to], ends)| integral(from, to, |angle| value(angle, ends).abs()))
            .sum();
        let agreed = (INNER * self.tolerance).max(AGREED) * size;
        let mut panels: VecDeque<Panel> = (pieces.iter().enumerate())
            .map(|(piece, &([from, to], ends))| {
                let whole = integral(from, to, |angle| value(angle, ends));
                Panel { piece, ends: [from, to], whole, depth: 0, before: f64::INFINITY }
            })
            .collect();
        // The first in, the first out: where there is an end to it, no place is left out.
        let (mut sum, mut halved) = (0.0, 0);
        while let Some(panel) = panels.pop_front() {
            let halves = panel.halves(|angle| value(angle, pieces[panel.piece].1));
            let both = halves[0].whole + halves[1].whole;
            let difference = (both - panel.whole).abs();
            let is_noise = difference >= 0.5 * panel.before && difference <= NOISE * size;
            let is_last = panel.depth >= DEEPEST || halved >= MOST_PANELS;
            if difference <= agreed || is_noise || is_last || !difference.is_finite() {
                sum += both;
            } else {
                halved += 1;
                panels.extend(halves.map(|half| Panel { before: difference, ..half }));
            }
        }
        sum
    }
}

/// An interval of the angle with its integral.
struct Panel {
    piece: usize,
    ends: [f64; 2],
    whole: f64,
    depth: u32,
    /// How much the integral of the panel twice as long changed.
    before: f64,
}

impl Panel {
    fn halves(&self, f: impl Fn(f64) -> f64) -> [Self; 2] {
        let [from, to] = self.ends;
        let middle = 0.5 * (from + to);
        [[from, middle], [middle, to]].map(|ends| Self {
            piece: self.piece,
            ends,
            whole: integral(ends[0], ends[1], &f),
            depth: self.depth + 1,
            before: self.before,
        })
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;
    use std::sync::Arc;

    use super::*;

    #[test]
    fn transforms_of_a_cone_with_a_flat_are_known() {
        // h = 1 beyond b: G = x acos(b/x), int h cos^2 = (t - sin t cos t)/2 .. with t = acos(b/x)
        let b = 0.25;
        let slope: Curve = Arc::new(move |r| if r < b { 0.0 } else { 1.0 });
        let shape = Shape { slope: &slope, breaks: vec![b], tolerance: 0.0 };
        for x in [0.3f64, 0.7, 1.0] {
            let t = (b / x).acos();
            assert!((shape.transform(x) - x * t).abs() < 1e-15);
            let level = 0.5 * (t + t.sin() * t.cos());
            assert!((shape.integral(x, Weight::CosineSquared) - level).abs() < 1e-15);
            let free = 0.5 * (t - t.sin() * t.cos());
            assert!((shape.integral(x, Weight::SineSquared) - free).abs() < 1e-15);
        }
        for s in [1e-12f64, 1e-5, 0.3] {
            let exact = b.hypot(s) * s.atan2(b);
            assert!((shape.transform_beyond(b, s) / exact - 1.0).abs() < 1e-14, "{s}");
        }
        // h = sqrt(r): int_0^{pi/2} sqrt(cos t) dt = (2 pi)^(3/2)/Gamma(1/4)^2
        let slope: Curve = Arc::new(f64::sqrt);
        let shape = Shape { slope: &slope, breaks: Vec::new(), tolerance: 0.0 };
        let exact = (2.0 * PI).powf(1.5) / 3.625_609_908_221_908f64.powi(2);
        assert!((shape.integral(1.0, Weight::One) - exact).abs() < 1e-14);
    }
}
