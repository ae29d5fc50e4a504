//! `G` on panels, and what follows from it: pressure and displacement.
//!
//! Between kinks `b < x` of the base `G` is smooth in `s = sqrt(x^2 - b^2)`, on graded powers but for a power `s^(1+mu)` at the kink; on each panel of `s` it
//! is a polynomial.

mod panel;
mod segment;
mod start;
mod steps;

use self::segment::{Segment, leg, ratio};
use super::powers::Powers;
use super::rule::ORDER;
use super::shape::{Shape, Symmetry};

/// A bend that is no nearer to the middle of a zone, in radii, is known to what is stated (survey).
const BESIDE_MIDDLE: f64 = 1e-5;

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
        let before = [f64::NAN].into_iter().chain(cuts.iter().copied());
        let segments: Vec<Segment> = (before.zip(cuts.windows(2)))
            .map(|(before, pair)| {
                let apart = if pair[0] > 0.0 { leg(pair[0], before) } else { f64::INFINITY };
                Segment::new(shape, [pair[0], pair[1]], apart, [size, radius])
            })
            .collect();
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
            let bend = segment.ends[0];
            0.0 < bend && bend < BESIDE_MIDDLE * self.radius() && segment.is_bent()
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
