//! A zone of a half-plane with its pressure.

use std::f64::consts::{LN_2, PI};
use std::sync::Arc;

use fredholm::basis::ChebyshevSeries;
use fredholm::inversion::{Conjugate, Place};

use super::super::modes::{bend, cosines, left_over};
use super::kernel::{Kernel, Remainder};
use crate::contact::zones::Zone;
use crate::rounding::OF_A_VALUE;

#[derive(Debug, Clone)]
pub(super) struct Part {
    zone: Zone,
    /// The conjugate `F` of the slope.
    pub(super) slope: Arc<Conjugate>,
    /// Mean slope of the profile, about which the others are.
    pub(super) lean: f64,
    /// `s_k`.
    smooth: Vec<f64>,
    /// `gamma_0`.
    first: f64,
    /// `G` over `cos phi` where `F` is a short series, or nothing.
    series: Option<ChebyshevSeries>,
    /// Places and masses that stand for the coupled modes in the remainder of the kernel.
    sources: Vec<(f64, f64)>,
    /// `G` at the free ends, where it is rounding.
    rounded: [f64; 2],
}

impl Part {
    /// From the modes `gamma_k` that are coupled, and what of them the profile makes by itself.
    pub(super) fn new(
        kernel: Kernel,
        zone: Zone,
        (slope, lean): (Arc<Conjugate>, f64),
        modes: &[f64],
        own: impl Fn(usize) -> f64,
    ) -> Self {
        let smooth: Vec<f64> = modes.iter().enumerate().map(|(k, mode)| mode - own(k)).collect();
        let terms = slope.series().filter(|_| slope.is_odd());
        let terms = terms.map(fredholm::inversion::Harmonics::cosines);
        let series = terms.map(|terms| {
            let mut sum = smooth.clone();
            sum.resize(smooth.len().max(terms.len() + 1), 0.0);
            sum[1..].iter_mut().zip(terms).for_each(|(g, f)| *g -= f / PI);
            ChebyshevSeries::new(sum)
        });
        let count = modes.len();
        let source = |r: usize| {
            let angle = PI * (r as f64 + 0.5) / count as f64;
            let mass = PI / count as f64 * cosines(modes, angle);
            (zone.middle() + 0.5 * zone.length() * angle.cos(), mass)
        };
        let sources = (0..if kernel.period.is_some() { count } else { 0 }).map(source).collect();
        let rounded = [0.0; 2];
        let mut part =
            Self { zone, slope, lean, smooth, first: modes[0], series, sources, rounded };
        part.rounded = left_over(&zone, |side| part.end_density(side), part.size());
        part
    }

    pub(super) fn half(&self) -> f64 {
        0.5 * self.zone.length()
    }

    pub(super) fn count(&self) -> usize {
        self.smooth.len()
    }

    /// `G` at a place, without what is left of it at free ends.
    pub(super) fn density_at(&self, place: Place) -> f64 {
        let Place { from_left, from_right } = place;
        let [left, right] = self.rounded;
        let rounded = (left * from_right + right * from_left) / (from_left + from_right);
        let density = match &self.series {
            Some(series) => series.evaluate(place.cosine()),
            None => self.density(place.angle()),
        };
        density - rounded
    }

    /// `G(phi)`.
    pub(super) fn density(&self, angle: f64) -> f64 {
        if let Some(series) = &self.series {
            return series.evaluate(angle.cos());
        }
        cosines(&self.smooth, angle) - self.slope.conjugate(angle) / PI
    }

    /// `G` at the left (0) or right (1) end.
    pub(super) fn end_density(&self, side: usize) -> f64 {
        self.density(if side == 0 { PI } else { 0.0 })
    }

    /// By how much that falls as the end moves outwards, over `xi`, with its error.
    pub(super) fn fall(&self, side: usize, rounding: f64) -> [f64; 2] {
        let end = if side == 0 { PI } else { 0.0 };
        let bend = bend(|angle| self.density(angle), end, [self.slope.reach(end), rounding]);
        bend.map(|bend| bend / self.zone.length())
    }

    /// `theta0` times the force of the zone.
    pub(super) fn force(&self) -> f64 {
        PI * self.first
    }

    /// The displacement beyond the zone, by `int ln(1/|xi - eta|)`.
    pub(super) fn beyond(&self, xi: f64) -> f64 {
        let is_right = xi > self.zone.middle();
        let distance = if is_right { xi - self.zone.right() } else { self.zone.left() - xi };
        let e = distance.max(0.0) / self.half();
        let excess = e + (e * (2.0 + e)).sqrt();
        let side = if is_right { 1.0 } else { -1.0 };
        let ratio = side / (1.0 + excess);
        let level = PI * self.smooth[0] * (LN_2 - self.half().ln() - excess.ln_1p());
        let sum = |terms: &[f64]| {
            let terms = terms.iter().enumerate().skip(1).rev();
            PI * terms.fold(0.0, |sum, (k, term)| ratio * (term / k as f64 + sum))
        };
        match &self.series {
            Some(series) => level + sum(series.coefficients()),
            None => level + sum(&self.smooth) - self.slope.outside(excess, side),
        }
    }

    /// The displacement by the remainder of the kernel.
    pub(super) fn by_remainder(&self, remainder: Remainder, xi: f64) -> f64 {
        self.sources.iter().map(|(source, mass)| mass * remainder.at(xi - source)).sum()
    }

    /// Rounding of `G` by the sizes of what is added up in it, for a system in which a rounding of the displacement counts so many times; `slope` is the error of `F`.
    pub(super) fn rounding(&self, condition: f64, slope: f64) -> f64 {
        let sum: f64 = self.smooth.iter().map(|s| s.abs()).sum();
        // The ends are rounded in xi, not in lengths of their zone.
        let remote = 1.0 + self.zone.left().abs().max(self.zone.right().abs()) / self.half();
        // Each mode answers to a sum over nodes of sums over modes.
        OF_A_VALUE * (remote + 2.0 * self.smooth.len() as f64 + condition) * sum + slope / PI
    }

    /// The largest `s_k`.
    pub(super) fn size(&self) -> f64 {
        self.smooth.iter().fold(0.0, |most, s| most.max(s.abs()))
    }
}
