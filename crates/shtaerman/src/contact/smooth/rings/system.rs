//! The pressure on given rings, and on a disk inside them.
//!
//! The disk `r <= c` answers by Galin's transforms to its own base and to the rings,
//!
//! `d(x) = delta0 - f0(0) - G(x) - (pi theta0) int s p0 ds/sqrt(s^2 - x^2)`, so that
//! `p0 = (e/pi) [d(c)/w + int G' dx/sqrt(x^2 - r^2)] + (2/pi) int s p0(s) w ds/((s^2 - r^2) sqrt(s^2 - c^2))`, `w = sqrt(c^2 - r^2)`,
//!
//! which leaves to the rings the kernel and the load beside it. Their high modes answer to the profile alone, as in plane contact, and are kept as the
//! conjugate `F` of its [slopes](crate::contact::smooth::slopes): `G = -F/pi + sum s_k cos(k phi)`.

use std::f64::consts::{LN_10, PI};
use std::sync::Arc;

use fredholm::inversion::{AbelTransform, Angular, Conjugate, RingKernel, Shape};

use super::base::Base;
use super::coupling::{self, Nodes, norm};
use super::ring::Ring;
use crate::contact::accuracy::{OF_A_VALUE, ROUNDING};
use crate::contact::balance::State;
use crate::contact::smooth::detail::{Detail, FINE};
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::{Error, Vertical};

/// Most modes for the base itself, half of them but in the answer: a bend of the base asks for all of them. At half or twice 3 of 10 answers are lost, stated errors grow up to 13 times and time grows by 240 % (survey).
const MODES_OF_BASE: usize = 192;

/// A ring with its pressure.
#[derive(Debug, Clone)]
pub(super) struct Part {
    pub(super) nodes: Nodes,
    slopes: Arc<Conjugate>,
    /// Angles at which the base bends.
    bends: Vec<f64>,
    /// `s_k`.
    pub(super) smooth: Vec<f64>,
    /// `(pi/n) G` at the nodes, of as many modes.
    pub(super) masses: Vec<f64>,
}

impl Part {
    pub(super) fn ring(&self) -> &Ring {
        &self.nodes.ring
    }

    pub(super) fn slopes(&self) -> &Conjugate {
        &self.slopes
    }

    /// How far the base goes on from the inner (0) or outer (1) edge without a bend, as angle.
    pub(super) fn straight(&self, side: usize) -> f64 {
        let from = |bend: &f64| if side == 0 { PI - bend } else { *bend };
        self.bends.iter().map(from).fold(PI, f64::min)
    }

    /// `G(phi)`.
    pub(super) fn density(&self, angle: f64) -> f64 {
        cosines(&self.smooth, angle) - self.slopes.conjugate(angle) / PI
    }

    /// Sum over the nodes of a function of the radius and of the distance from a disk of radius `c`.
    pub(super) fn sum(&self, c: f64, f: impl Fn([f64; 2]) -> f64) -> f64 {
        let terms = self.masses.iter().enumerate();
        terms.map(|(q, mass)| mass * f(self.nodes.beside(q, c))).sum()
    }

    /// Rounding of `G`.
    pub(super) fn rounding(&self) -> f64 {
        self.sum_rounding() + self.slopes.error() / PI
    }

    /// The same at the edges.
    pub(super) fn end_rounding(&self) -> f64 {
        self.sum_rounding() + self.slopes.end_error() / PI
    }

    fn sum_rounding(&self) -> f64 {
        let sum: f64 = self.smooth.iter().map(|s| s.abs()).sum();
        // The edges are rounded in r, not in lengths of their ring.
        let remote = 1.0 + 1.0 / self.ring().half;
        OF_A_VALUE * (remote + 2.0 * self.smooth.len() as f64) * sum
    }
}

/// `sum c_k cos(k phi)`.
pub(super) fn cosines(coefficients: &[f64], angle: f64) -> f64 {
    let cosine = angle.cos();
    let (mut next, mut after) = (0.0, 0.0);
    for c in coefficients.iter().skip(1).rev() {
        (next, after) = (c + 2.0 * cosine * next - after, next);
    }
    coefficients[0] + cosine * next - after
}

/// A disk inside the rings.
#[derive(Debug, Clone)]
pub(super) struct Core {
    /// `c`.
    pub(super) radius: f64,
    pub(super) is_free: bool,
    pub(super) transform: Arc<AbelTransform>,
    /// `delta0 - f0(0)`.
    pub(super) level: f64,
    /// `d(c)` and its slope.
    pub(super) corner: f64,
    pub(super) slope: f64,
}

/// The profile on a ring, times `sqrt(r)`, as function of the angle.
struct OnRing<'b, 'p> {
    base: &'b Base<'p>,
    ring: Ring,
    /// The height that counts as zero.
    reference: f64,
}

impl OnRing<'_, '_> {
    /// The radius, at a step on this side of it.
    fn radius(&self, angle: f64) -> f64 {
        self.ring.zone.inside(self.ring.spot(angle).radius)
    }
}

impl Angular for OnRing<'_, '_> {
    fn height(&self, angle: f64) -> f64 {
        let r = self.radius(angle);
        r.sqrt() * (self.base.height(r) - self.reference)
    }

    fn rounding(&self, height: f64, slope: f64) -> f64 {
        OF_A_VALUE * (height + slope / self.ring.half + self.reference.abs())
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        let r = self.radius(angle);
        let height = self.base.height(r) - self.reference;
        let slope = (self.base.problem.slope)(r);
        Some(-self.ring.half * angle.sin() * r.sqrt() * (0.5 * height + r * slope))
    }
}

/// The pressure on zones under the load; at free edges it need not vanish yet.
#[derive(Debug, Clone)]
pub(super) struct Solved {
    /// From left to right, a disk first.
    pub(super) zones: Vec<Zone>,
    pub(super) core: Option<Core>,
    pub(super) parts: Vec<Part>,
    pub(super) theta0: f64,
    /// `e`.
    pub(super) modulus: f64,
    pub(super) state: State,
    /// `dP0/d delta0`.
    pub(super) rate: f64,
}

impl Solved {
    /// Solves on zones from left to right.
    pub(super) fn new(base: &Base<'_>, zones: &[Zone], detail: Detail) -> Result<Self, Error> {
        if zones.is_empty()
            || zones.iter().any(|zone| zone.length().is_nan() || zone.length() <= 0.0)
        {
            return Err(Error::NoContact);
        }
        // Narrower ones are lost in the rounding of their radius.
        if zones.iter().any(|zone| zone.length() < ROUNDING * zone.right()) {
            return Err(Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN });
        }
        let (disk, rings) = match zones[0].left() {
            0.0 => (Some(zones[0]), &zones[1..]),
            _ => (None, zones),
        };
        let c = disk.map_or(0.0, |zone| zone.right());
        let rings: Vec<Ring> = rings.iter().map(|zone| Ring::new(*zone)).collect();
        let reference = base.height(zones[0].left().next_up());
        let profiles = Profiles::new(base, &rings, reference, c, detail)?;
        let nodes: Vec<Nodes> =
            rings.iter().zip(&profiles.counts).map(|(ring, n)| Nodes::new(*ring, *n)).collect();
        // Heights of the axis and transform, about the reference.
        let core = disk.map(|_| {
            let transform = AbelTransform::new(&base.shape, c);
            (Arc::new(transform), base.height(0.0) - reference)
        });
        let levels: Vec<Vec<f64>> =
            nodes.iter().map(|nodes| left(RingKernel::Axisymmetric, c, nodes)).collect();
        let mut heights = profiles.heights.clone();
        if let Some((transform, axis)) = &core {
            for (heights, nodes) in heights.iter_mut().zip(&nodes) {
                let sunk: Vec<f64> = (nodes.spots.iter())
                    .map(|spot| spot.radius.sqrt() * transform.displacement(spot.radius, -axis))
                    .collect();
                heights.iter_mut().zip(nodes.modes(&sunk)).for_each(|(h, own)| *h += own);
            }
        }
        let rights = [levels.clone(), heights];
        let mut found = coupling::solve(RingKernel::Axisymmetric, c, &nodes, &rights)?.into_iter();
        let [level, profile] = [0; 2].map(|_| found.next().unwrap_or_default());
        let (theta0, modulus) = (base.problem.theta0, base.problem.modulus(&base.shape.powers));
        let weight = RingKernel::Axisymmetric.weight() / theta0;
        let rate = 2.0 * modulus * c + weight * product(&levels, &level);
        let free =
            core.as_ref().map_or(0.0, |(transform, axis)| 2.0 * modulus * transform.volume(-axis))
                - weight * product(&levels, &profile);
        let (depth, settlement, force) = match base.problem.load.vertical {
            Vertical::Force(force) => {
                let depth = (force - free) / rate;
                (depth, depth + reference, force)
            }
            Vertical::Settlement(settlement) => {
                let depth = settlement - reference;
                (depth, settlement, rate * depth + free)
            }
        };
        if !(depth.is_finite() && force.is_finite()) {
            let (parameter, smallest) = (theta0, 0.0);
            return Err(Error::Equation(fredholm::Error::Singular { parameter, smallest }));
        }
        let parts: Vec<Part> =
            (nodes.into_iter().zip(profiles.slopes).zip(profiles.bends).enumerate())
                .map(|(j, ((nodes, slopes), bends))| {
                    let modes: Vec<f64> = (level[j].iter().zip(&profile[j]))
                        .map(|(level, profile)| depth * level - profile)
                        .collect();
                    let bent = |k: usize| k as f64 * profiles.heights[j][k] / PI;
                    let smooth = modes.iter().enumerate().map(|(k, mode)| mode + bent(k)).collect();
                    let weight = nodes.weight();
                    let masses = nodes.values(&modes).into_iter().map(|g| weight * g).collect();
                    Part { nodes, slopes: Arc::new(slopes), bends, smooth, masses }
                })
                .collect();
        let core = core.zip(disk).map(|((transform, axis), zone)| {
            let level = depth - axis;
            let [corner, slope] = edge(base, &transform, level, c, &parts);
            Core { radius: c, is_free: zone.is_free(1), transform, level, corner, slope }
        });
        // Adding zero turns a negative zero into a plain one.
        let state =
            State { settlement: settlement + 0.0, tilt: 0.0, force: force + 0.0, moment: 0.0 };
        Ok(Self { zones: zones.to_vec(), core, parts, theta0, modulus, state, rate })
    }

    /// The radius of the disk, 0 without one.
    pub(super) fn inside(&self) -> f64 {
        self.core.as_ref().map_or(0.0, |core| core.radius)
    }

    /// The ring that a zone is.
    pub(super) fn ring(&self, zone: usize) -> Option<&Part> {
        self.parts.get(zone.checked_sub(usize::from(self.core.is_some()))?)
    }

    /// Stiffness on these zones.
    pub(super) fn stiffness(&self) -> Result<Stiffness, Error> {
        let c = self.inside();
        let nodes: Vec<Nodes> = self.parts.iter().map(|part| part.nodes.clone()).collect();
        let levers: Vec<Vec<f64>> =
            nodes.iter().map(|nodes| left(RingKernel::Tilted, c, nodes)).collect();
        let right = [levers.clone()];
        let tilted = coupling::solve(RingKernel::Tilted, c, &nodes, &right)?;
        let weight = RingKernel::Tilted.weight() / self.theta0;
        let rings: f64 = tilted.first().map_or(0.0, |found| product(&levers, found));
        let moment_tilt = 4.0 / 3.0 * self.modulus * c.powi(3) + weight * rings;
        Ok(Stiffness { force_settlement: self.rate, coupling: 0.0, moment_tilt })
    }

    /// Force of a zone.
    pub(super) fn force(&self, zone: usize) -> f64 {
        let c = self.inside();
        let weight = RingKernel::Axisymmetric.weight() / self.theta0;
        if let Some(part) = self.ring(zone) {
            return weight * part.sum(c, |[r, _]| r.sqrt());
        }
        let Some(core) = &self.core else { return 0.0 };
        let own = 2.0 * self.modulus * core.transform.volume(core.level);
        let taken = |[r, beside]: [f64; 2]| {
            r.sqrt() * (1.0 - RingKernel::Axisymmetric.left(c, [r, beside]))
        };
        own - self.parts.iter().map(|part| weight * part.sum(c, taken)).sum::<f64>()
    }

    /// Number of modes of all rings, and of coefficients of the disk.
    pub(super) fn modes(&self) -> usize {
        let rings: usize = self.parts.iter().map(|part| part.smooth.len()).sum();
        rings + self.core.as_ref().map_or(0, |core| core.transform.size())
    }

    /// Rounding of displacements by that of the heights on the zones.
    pub(super) fn displacement_rounding(&self) -> f64 {
        let rings =
            self.parts.iter().map(|part| part.slopes.mode_error() / part.ring().inner().sqrt());
        let core = self.core.as_ref().map_or(0.0, |core| 16.0 * f64::EPSILON * core.level.abs());
        rings.fold(core, f64::max)
    }
}

/// The profiles on rings: their slopes, numbers of modes and coefficients.
struct Profiles {
    slopes: Vec<Conjugate>,
    bends: Vec<Vec<f64>>,
    counts: Vec<usize>,
    heights: Vec<Vec<f64>>,
}

impl Profiles {
    fn new(
        base: &Base<'_>,
        rings: &[Ring],
        reference: f64,
        c: f64,
        detail: Detail,
    ) -> Result<Self, Error> {
        let mut counts = coupling::modes(c, rings, detail.digits)?;
        let shape: &Shape<'_> = &base.shape;
        let bends: Vec<Vec<f64>> = (rings.iter())
            .map(|ring| {
                let inside = |at: &&f64| ring.inner() < **at && **at < ring.outer();
                shape.breaks.iter().filter(inside).map(|at| ring.angle_of(*at)).collect()
            })
            .collect();
        let slopes: Vec<Conjugate> = (rings.iter().zip(&bends))
            .map(|(ring, bends)| {
                let on_ring = OnRing { base, ring: *ring, reference };
                Conjugate::resolve(&on_ring, [bends, &[]], [detail.panels, 1], shape.tolerance)
            })
            .collect();
        let most = if detail.digits >= FINE.digits { MODES_OF_BASE } else { MODES_OF_BASE / 2 };
        let heights = (slopes.iter().zip(&mut counts))
            .map(|(slopes, count)| {
                let mut heights = slopes.coefficients(most.max(*count));
                *count = (*count).max(needed(&heights, detail.digits).min(most));
                heights.truncate(*count);
                heights
            })
            .collect();
        coupling::require_few(c, rings, &counts)?;
        Ok(Self { slopes, bends, counts, heights })
    }
}

/// How many modes of a profile matter to what is beside the logarithm, which is smaller by the square of their number.
fn needed(heights: &[f64], digits: f64) -> usize {
    let size = |(k, f): (usize, &f64)| f.abs() / (1.0 + k as f64);
    let largest = heights.iter().enumerate().map(size).fold(0.0, f64::max);
    let floor = largest * (-digits.min(16.0) * LN_10).exp();
    heights.iter().enumerate().rposition(|pair| size(pair) > floor).map_or(2, |last| last + 2)
}

/// Modes of what a unit settlement, or tilt, leaves to the rings, times `sqrt(r)`.
fn left(harmonic: RingKernel, c: f64, nodes: &Nodes) -> Vec<f64> {
    let values: Vec<f64> = (0..nodes.count())
        .map(|q| {
            let place = nodes.beside(q, c);
            place[0].sqrt() * harmonic.left(c, place)
        })
        .collect();
    nodes.modes(&values)
}

/// `int one two dphi` over all rings.
fn product(one: &[Vec<f64>], two: &[Vec<f64>]) -> f64 {
    let terms = one.iter().zip(two).flat_map(|(one, two)| one.iter().zip(two).enumerate());
    terms.map(|(k, (a, b))| norm(k) * a * b).sum()
}

/// `d(c)` and `d'(c)`.
fn edge(
    base: &Base<'_>,
    transform: &AbelTransform,
    level: f64,
    c: f64,
    parts: &[Part],
) -> [f64; 2] {
    let sum = |f: &dyn Fn([f64; 2]) -> f64| -> f64 {
        PI * parts.iter().map(|part| part.sum(c, f)).sum::<f64>()
    };
    let root = |[s, beside]: [f64; 2]| (beside * (s + c)).sqrt();
    let load = sum(&|place| place[0].sqrt() / root(place));
    let steeper = sum(&|place| c * place[0].sqrt() / root(place).powi(3));
    [level - base.shape.transform(c) - load, -transform.end_slope() - steeper]
}
