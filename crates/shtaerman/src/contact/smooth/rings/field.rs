//! Pressure and displacement of rings and of the disk inside them.

use std::f64::consts::{LN_2, PI};

use fredholm::inversion::RingKernel;
use fredholm::special::arithmetic_geometric_mean as mean;

use super::ring::distance;
use super::system::{Core, Part, Solved, cosines};

/// Beyond this distance in the logarithm of the radius the nodes of a ring see it without its singularity.
const FAR: f64 = 2.0;

impl Part {
    /// `p0` by the distances from both edges; infinite at a singular one.
    pub(super) fn pressure(&self, theta0: f64, from_inner: f64, from_outer: f64) -> f64 {
        let ring = self.ring();
        let angle = ring.angle(from_inner, from_outer);
        let density = self.density(angle);
        if from_inner <= 0.0 || from_outer <= 0.0 {
            let is_free = ring.zone.is_free(usize::from(from_outer <= from_inner));
            return if is_free || density == 0.0 { 0.0 } else { density * f64::INFINITY };
        }
        let radius = ring.spot(angle).radius;
        density / (theta0 * ring.half * angle.sin() * radius * radius.sqrt())
    }

    /// `G` at the inner (0) or outer (1) edge.
    pub(super) fn end_density(&self, side: usize) -> f64 {
        self.density(if side == 0 { PI } else { 0.0 })
    }

    /// `lim sqrt(2 pi d) p0` at the inner (0) or outer (1) edge.
    pub(super) fn intensity(&self, theta0: f64, side: usize) -> f64 {
        let ring = self.ring();
        (PI / ring.half).sqrt() * self.end_density(side) / (theta0 * ring.zone.ends[side])
    }

    /// The displacement at `r` beside the ring, and beside a disk of radius `c`.
    pub(super) fn displacement(&self, c: f64, r: f64) -> f64 {
        let ring = self.ring();
        let is_outside = r > 0.5 * (ring.inner() + ring.outer());
        let beyond = if is_outside { r - ring.outer() } else { ring.inner() - r }.max(0.0);
        let length = if is_outside { distance(ring.outer(), beyond) } else { distance(r, beyond) };
        let taken = self.sum(c, |place| RingKernel::Axisymmetric.taken(c, [r, r - c], place));
        if length.is_nan() || length > FAR {
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
        let rest: f64 = (self.masses.iter().zip(&self.nodes.angles))
            .map(|(mass, &angle)| {
                let half = if is_outside { 0.5 * angle } else { 0.5 * (PI - angle) };
                let y = length + 2.0 * ring.half * half.sin().powi(2);
                let factor = RingKernel::Axisymmetric.factor(y);
                let added = (factor - 1.0) * cosines(&logarithm, angle);
                mass * (added + RingKernel::Axisymmetric.rest(y))
            })
            .sum();
        own - self.slopes().outside(excess, side) + rest
    }
}

impl Solved {
    /// `sqrt(c^2 - r^2)`, by the distance from the edge of the disk.
    fn root(core: &Core, from_edge: f64) -> f64 {
        (from_edge.max(0.0) * (2.0 * core.radius - from_edge)).sqrt()
    }

    /// `p0` on the disk, by the distance from its edge.
    pub(super) fn core_pressure(&self, core: &Core, from_edge: f64) -> f64 {
        let r = core.radius - from_edge;
        let root = Self::root(core, from_edge);
        if root == 0.0 {
            return if core.is_free || core.corner == 0.0 {
                0.0
            } else {
                core.corner * f64::INFINITY
            };
        }
        let c = core.radius;
        let load = |[s, beside]: [f64; 2]| {
            s.sqrt() / ((beside + from_edge) * (s + r) * (beside * (s + c)).sqrt())
        };
        let rings: f64 = self.parts.iter().map(|part| part.sum(c, load)).sum();
        let flat = if core.corner == 0.0 { 0.0 } else { core.corner / root };
        self.modulus / PI * (flat + core.transform.pressure(r.max(0.0)) + PI * root * rings)
    }

    /// `p0` in a zone by the distances from its ends; those of a disk from the axis and from its edge.
    pub(super) fn pressure_beside(&self, zone: usize, from_left: f64, from_right: f64) -> f64 {
        match (self.ring(zone), &self.core) {
            (Some(part), _) => part.pressure(self.theta0, from_left, from_right),
            (None, Some(core)) => self.core_pressure(core, from_right),
            (None, None) => f64::NAN,
        }
    }

    /// `p0(r)`, 0 beside the zones.
    pub(super) fn pressure(&self, r: f64) -> f64 {
        match self.zones.iter().position(|zone| zone.contains(r)) {
            Some(j) => {
                let zone = &self.zones[j];
                self.pressure_beside(j, r - zone.left(), zone.right() - r)
            }
            None if r.is_nan() => r,
            None => 0.0,
        }
    }

    /// The displacement beside the zones.
    pub(super) fn displacement_outside(&self, r: f64) -> f64 {
        let c = self.inside();
        let core =
            self.core.as_ref().map_or(0.0, |core| core.transform.displacement(r, core.level));
        core + self.parts.iter().map(|part| part.displacement(c, r)).sum::<f64>()
    }

    /// `lim sqrt(2 pi d) p0` at the ends of a zone, 0 at free ones and at the axis.
    pub(super) fn intensity(&self, zone: usize) -> [f64; 2] {
        let zone_of = self.zones[zone];
        match (self.ring(zone), &self.core) {
            (Some(part), _) => std::array::from_fn(|side| {
                if zone_of.is_free(side) { 0.0 } else { part.intensity(self.theta0, side) }
            }),
            (None, Some(core)) if !core.is_free => {
                [0.0, (PI / core.radius).sqrt() * self.modulus / PI * core.corner]
            }
            _ => [0.0; 2],
        }
    }

    /// The pressure in a zone at an angle `0 .. pi` from its outer edge, without the singularity at its ends; of a disk `r = c cos(phi/2)`.
    pub(super) fn regular(&self, zone: usize, angle: f64) -> f64 {
        match (self.ring(zone), &self.core) {
            (Some(part), _) => {
                let radius = part.ring().spot(angle).radius;
                part.density(angle) / (self.theta0 * part.ring().half * radius * radius.sqrt())
            }
            (None, Some(core)) => {
                let sine = (0.5 * angle).sin();
                let from_edge = 2.0 * core.radius * (0.25 * angle).sin().powi(2);
                sine * self.core_pressure(core, from_edge)
            }
            (None, None) => f64::NAN,
        }
    }
}
