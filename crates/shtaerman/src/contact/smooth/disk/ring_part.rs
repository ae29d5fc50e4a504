//! A ring with its pressure.

use crate::rounding::OF_A_VALUE;
use std::f64::consts::{LN_2, PI, TAU};
use std::sync::Arc;

use fredholm::inversion::{Angular, Conjugate, RingKernel};
use fredholm::special::arithmetic_geometric_mean as mean;

use super::super::base::Base;
use super::super::modes::{bend, bend_of_cut, cosines, left_over};
use super::coupling::RingNodes;
use super::ring::{Ring, distance};
use crate::contact::accuracy::SAFETY;

#[derive(Debug, Clone)]
pub(super) struct RingPart {
    pub(super) nodes: RingNodes,
    slope: Arc<Conjugate>,
    /// `s_k`.
    smooth: Vec<f64>,
    /// `(pi/n) G` at the nodes, of as many modes.
    masses: Vec<f64>,
    /// `G` at the free edges, where it is rounding.
    rounded: [f64; 2],
}

impl RingPart {
    /// From the modes `gamma_k` that are coupled, and those `f_k` of the profile.
    pub(super) fn new(
        nodes: RingNodes,
        slope: Arc<Conjugate>,
        modes: &[f64],
        heights: &[f64],
    ) -> Self {
        let own = heights.iter().enumerate().map(|(k, f)| k as f64 * f / PI);
        let smooth = modes.iter().zip(own).map(|(mode, own)| mode + own).collect();
        let weight = nodes.nodes.weight();
        let masses = nodes.nodes.values(modes).into_iter().map(|g| weight * g).collect();
        let mut part = Self { nodes, slope, smooth, masses, rounded: [0.0; 2] };
        part.rounded = left_over(&part.ring().zone, |side| part.end_density(side), part.size());
        part
    }

    pub(super) fn ring(&self) -> &Ring {
        &self.nodes.ring
    }

    pub(super) fn count(&self) -> usize {
        self.smooth.len()
    }

    /// `G(phi)`.
    pub(super) fn density(&self, angle: f64) -> f64 {
        cosines(&self.smooth, angle) - self.slope.conjugate(angle) / PI
    }

    /// `G` at the inner (0) or outer (1) edge.
    pub(super) fn end_density(&self, side: usize) -> f64 {
        self.density(if side == 0 { PI } else { 0.0 })
    }

    /// By how much that falls as the edge moves outwards of the ring, over the radius, with its error: beside a kink of the base the modes go as `k^-3`, so that those of the bend that are left out
    /// are of the size of what the last half of them makes of it, from whatever mode on; where a kink is nearer than a wave of the last mode, as much larger.
    pub(super) fn fall(&self, side: usize) -> [f64; 2] {
        let end = if side == 0 { PI } else { 0.0 };
        let ring = self.ring();
        let scale = 2.0 * ring.half * ring.zone.ends[side];
        let reach = self.slope.reach(end);
        let known = [reach, self.rounding(Conjugate::end_error)];
        let [bend, error] = bend(|angle| self.density(angle), end, known);
        let (n, mut sum, mut cut) = (self.count(), 0.0, 0.0_f64);
        for k in (n / 2..n).rev() {
            sum += (k * k) as f64 * self.smooth[k] * (k as f64 * end).cos();
            cut = cut.max(sum.abs());
        }
        let cut = SAFETY * cut * (TAU / (n as f64 * reach)).max(1.0);
        [bend, error + cut].map(|bend| bend / scale)
    }

    /// The same for Newton's method: beside a kink of the base the modes end before they are small.
    pub(super) fn fall_of_modes(&self, side: usize) -> f64 {
        let end = if side == 0 { PI } else { 0.0 };
        let ring = self.ring();
        let bend = bend_of_cut(|angle| self.density(angle), end, self.count());
        bend / (2.0 * ring.half * ring.zone.ends[side])
    }

    /// Sum over the nodes of a function of the radius and of the distance from a disk of radius `c`.
    pub(super) fn sum(&self, c: f64, f: impl Fn([f64; 2]) -> f64) -> f64 {
        let terms = self.masses.iter().enumerate();
        terms.map(|(q, mass)| mass * f(self.nodes.beside(q, c))).sum()
    }

    /// `theta0 p0` at an angle without the singularity at the edges, and what is left of it at free ones.
    pub(super) fn regular(&self, angle: f64) -> f64 {
        let radius = self.ring().spot(angle).radius;
        let (sine, cosine) = (0.5 * angle).sin_cos();
        let rounded = self.rounded[0] * sine * sine + self.rounded[1] * cosine * cosine;
        (self.density(angle) - rounded) / (self.ring().half * radius * radius.sqrt())
    }

    /// `theta0 p0` by the distances from both edges; infinite at a singular one.
    pub(super) fn pressure(&self, from_inner: f64, from_outer: f64) -> f64 {
        let ring = self.ring();
        let angle = ring.angle(from_inner, from_outer);
        if from_inner <= 0.0 || from_outer <= 0.0 {
            let density = self.density(angle);
            let is_free = ring.zone.is_free(usize::from(from_outer <= from_inner));
            return if is_free || density == 0.0 { 0.0 } else { density * f64::INFINITY };
        }
        self.regular(angle) / angle.sin()
    }

    /// `theta0 lim sqrt(2 pi d) p0` of a density 1 at the inner (0) or outer (1) edge.
    pub(super) fn intensity(&self, side: usize) -> f64 {
        let ring = self.ring();
        (PI / ring.half).sqrt() / ring.zone.ends[side]
    }

    /// The displacement at `r` beside the ring, and beside a disk of radius `c`.
    pub(super) fn displacement(&self, c: f64, r: f64) -> f64 {
        let ring = self.ring();
        let is_outside = r > 0.5 * (ring.inner() + ring.outer());
        let beyond = if is_outside { r - ring.outer() } else { ring.inner() - r }.max(0.0);
        let length = if is_outside { distance(ring.outer(), beyond) } else { distance(r, beyond) };
        let taken = self.sum(c, |place| RingKernel::Axisymmetric.taken(c, [r, r - c], place));
        // Beyond this distance in the logarithm of the radius the nodes of a ring see it without its singularity.
        if length.is_nan() || length > 2.0 {
            let whole =
                |[s, _]: [f64; 2]| s.sqrt() * PI / (2.0 * mean(0.5 * (r + s), 0.5 * (r - s).abs()));
            let taken = if c == 0.0 { 0.0 } else { taken / r.sqrt() };
            return self.sum(c, whole) - taken;
        }
        (self.near(length, is_outside) - taken) / r.sqrt()
    }

    /// `int Q G dphi` so far beyond an edge.
    fn near(&self, length: f64, is_outside: bool) -> f64 {
        let ring = self.ring();
        let e = length / ring.half;
        let excess = e + (e * (2.0 + e)).sqrt();
        let side = if is_outside { 1.0 } else { -1.0 };
        let ratio = side / (1.0 + excess);
        // Modes of ln 1/|y - y'|.
        let mut logarithm = vec![LN_2 - ring.half.ln() - excess.ln_1p()];
        let mut power = 1.0;
        for k in 1..self.smooth.len() {
            power *= ratio;
            logarithm.push(power / k as f64);
        }
        let own: f64 = logarithm.iter().zip(&self.smooth).map(|(l, s)| PI * l * s).sum();
        for value in logarithm.iter_mut().skip(1) {
            *value *= 2.0;
        }
        // What is left out of the series is rounding: then it is the logarithm itself.
        let is_whole = power.abs() < f64::EPSILON;
        let kernel = RingKernel::Axisymmetric;
        let rest: f64 = (self.masses.iter().zip(&self.nodes.nodes.angles))
            .map(|(mass, &angle)| {
                let half = if is_outside { 0.5 * angle } else { 0.5 * (PI - angle) };
                let y = length + 2.0 * ring.half * half.sin().powi(2);
                if is_whole {
                    return mass * (kernel.whole(y) + y.ln());
                }
                let [factor, rest] = kernel.parts(y);
                mass * ((factor - 1.0) * cosines(&logarithm, angle) + rest)
            })
            .sum();
        own - self.slope.outside(excess, side) + rest
    }

    /// Rounding of `G` by the sizes of what is added up in it; `slope` is the error of `F`.
    pub(super) fn rounding(&self, slope: fn(&Conjugate) -> f64) -> f64 {
        let sum: f64 = self.smooth.iter().map(|s| s.abs()).sum();
        // The edges are rounded in r, not in lengths of their ring.
        let remote = 1.0 + 1.0 / self.ring().half;
        OF_A_VALUE * (remote + 2.0 * self.smooth.len() as f64) * sum + slope(&self.slope) / PI
    }

    /// Rounding of displacements by that of the heights.
    pub(super) fn displacement_rounding(&self) -> f64 {
        self.slope.mode_error() / self.ring().inner().sqrt()
    }

    /// The largest `s_k`.
    pub(super) fn size(&self) -> f64 {
        self.smooth.iter().fold(0.0, |most, s| most.max(s.abs()))
    }
}

/// The profile on a ring, times `sqrt(r)`, as function of the angle.
pub(super) struct OnRing<'b> {
    pub(super) base: &'b Base,
    pub(super) ring: Ring,
    /// The height that counts as zero.
    pub(super) reference: f64,
}

impl OnRing<'_> {
    /// The radius, at a step on this side of it.
    fn radius(&self, angle: f64) -> f64 {
        self.ring.zone.inside(self.ring.spot(angle).radius)
    }
}

impl Angular for OnRing<'_> {
    fn height(&self, angle: f64) -> f64 {
        let r = self.radius(angle);
        r.sqrt() * (self.base.height(r) - self.reference)
    }

    fn rounding(&self, height: f64, slope: f64) -> f64 {
        OF_A_VALUE * (height + slope / self.ring.half + self.reference.abs())
    }

    /// Places are rounded in `r`, not in lengths of the ring.
    fn blur(&self, angle: f64) -> f64 {
        f64::EPSILON * (1.0 + 0.5 / (self.ring.half * angle.sin().abs()))
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        let r = self.radius(angle);
        let slope = self.base.has_slope().then(|| self.base.slope(r))?;
        let height = self.base.height(r) - self.reference;
        Some(-self.ring.half * angle.sin() * r.sqrt() * (0.5 * height + r * slope))
    }
}
