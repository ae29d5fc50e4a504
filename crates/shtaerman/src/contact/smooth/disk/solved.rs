//! The pressure on a disk and rings.
//!
//! The disk `r <= c` answers by the transforms to its own base and to the rings,
//!
//! `d(x) = delta0 - f0(0) - G(x) - (pi theta0) int s p0 ds/sqrt(s^2 - x^2)`, so that
//! `p0 = (e/pi) [d(c)/w + int G' dx/sqrt(x^2 - r^2)] + (2/pi) int s p0(s) w ds/((s^2 - r^2) sqrt(s^2 - c^2))`, `w = sqrt(c^2 - r^2)`,
//!
//! which leaves to the rings the kernel and the load beside it. Their high modes answer to the profile alone, as in plane contact.

use std::f64::consts::{LN_10, PI};
use std::sync::{Arc, OnceLock};

use fredholm::inversion::{Conjugate, Place, RingKernel, Weight};

use super::super::equation::{Detail, FINE};
use super::super::modes::{Modes, norm, require_few};
use super::super::pressure::{Density, Known, Pressure};
use super::Disk;
use super::core::Core;
use super::coupling::{RingNodes, counts, coupled, narrowest};
use super::ring::Ring;
use super::ring_part::{OnRing, RingPart};
use crate::contact::accuracy::ROUNDING;
use crate::contact::balance::State;
use crate::contact::edges::EndState;
use crate::contact::stiffness::{Stiffness, require_solved};
use crate::contact::zones::Zone;
use crate::{Error, Vertical};

/// Most modes for the base itself, half of them but in the answer: a bend of the base asks for all of them. At half or twice 3 of 10 answers are lost, stated errors grow up to 13 times and time grows by 240 % (survey).
const MODES_OF_BASE: usize = 192;

#[derive(Debug, Clone)]
pub(in super::super) struct Solved {
    /// From left to right, a disk first.
    pub(super) zones: Vec<Zone>,
    pub(super) core: Option<Core>,
    parts: Vec<RingPart>,
    /// The modes of the rings under a flat base one deep.
    flat: Arc<Modes>,
    theta0: f64,
    state: State,
    /// Without what rings add against a tilt.
    stiffness: Stiffness,
    /// That, in the answer, once it is asked for.
    turning: Option<OnceLock<f64>>,
}

impl Solved {
    pub(super) fn new(disk: &Disk, zones: &[Zone], detail: Detail) -> Result<Self, Error> {
        // Narrower ones are lost in the rounding of their radius.
        if zones.iter().any(|zone| zone.length() < ROUNDING * zone.right()) {
            return Err(Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN });
        }
        let base = &disk.base;
        let (inner, rings) = match zones[0].left() {
            0.0 => (Some(zones[0]), &zones[1..]),
            _ => (None, zones),
        };
        let c = inner.map_or(0.0, |zone| zone.right());
        let rings: Vec<Ring> = rings.iter().map(|zone| Ring::new(*zone)).collect();
        let reference = base.height(zones[0].left().next_up());
        let profiles = Profiles::new(disk, &rings, reference, c, detail)?;
        // Height of the axis and transform, about the reference.
        let is_fine = detail.digits >= FINE.digits;
        let core = inner.map(|_| (disk.transform(c, is_fine), base.height(0.0) - reference));
        let kernel = RingKernel::Axisymmetric;
        let nodes = profiles.nodes;
        let levels: Modes =
            nodes.iter().map(|ring| ring.modes_of(c, |place| kernel.left(c, place))).collect();
        let mut heights = profiles.heights.clone();
        if let Some((transform, axis)) = &core {
            for (heights, ring) in heights.iter_mut().zip(&nodes) {
                let sunk = ring.modes_of(c, |[r, _]| transform.displacement(r, -axis));
                heights.iter_mut().zip(sunk).for_each(|(h, own)| *h += own);
            }
        }
        let all: Vec<&RingNodes> = nodes.iter().collect();
        let mut found = coupled(kernel, (c, detail.digits), &all, &[levels.clone(), heights])?;
        let level = std::mem::take(&mut found[0]);
        let profile = &found[1];
        let theta0 = base.setting.theta0();
        let weight = kernel.weight() / theta0;
        let alone = Core::rate(&disk.powers, disk.modulus, c);
        let rate = alone + weight * product(&levels, &level);
        let volume = |level: f64| {
            let volume = core.as_ref().map_or(0.0, |(transform, _)| transform.volume(level));
            2.0 * disk.modulus * volume
        };
        let axis = core.as_ref().map_or(0.0, |(_, axis)| *axis);
        let free = volume(-axis) - weight * product(&levels, profile);
        let (depth, settlement, force) = match base.load.vertical {
            Vertical::Force(force) => {
                let depth = (force - free) / rate;
                (depth, depth + reference, force)
            }
            Vertical::Settlement(settlement) => {
                let depth = settlement - reference;
                (depth, settlement, rate * depth + free)
            }
        };
        require_solved([depth, force], theta0)?;
        let turning = is_fine.then(OnceLock::new);
        let moment_tilt = Core::turning(&disk.powers, disk.modulus, c);
        let stiffness = Stiffness { force_settlement: rate, coupling: 0.0, moment_tilt };
        let slopes = profiles.slopes.into_iter().zip(&profiles.heights);
        let parts: Vec<RingPart> = (nodes.into_iter().zip(slopes).enumerate())
            .map(|(j, (nodes, (slope, heights)))| {
                let modes = level[j].iter().zip(&profile[j]);
                let modes: Vec<f64> = modes.map(|(level, own)| depth * level - own).collect();
                RingPart::new(nodes, slope, &modes, heights)
            })
            .collect();
        let [tilt, moment] = disk.rotational.turned(force, moment_tilt);
        let core = core.zip(inner).map(|((transform, axis), zone)| {
            let level = depth - axis;
            let slope = transform.end_slope();
            let load = by_rings(&parts, c);
            Core {
                radius: c,
                is_free: zone.is_free(1),
                powers: disk.powers.clone(),
                modulus: disk.modulus,
                level,
                corner: level - disk.with_shape(|shape| shape.transform(c)) - load[0],
                slope: -slope - load[1],
                transform: Some(transform),
                rounding: base.tolerance.max(ROUNDING),
                tilt,
            }
        });
        let state = State { settlement, tilt, force, moment }.plain();
        let (zones, flat) = (zones.to_vec(), Arc::new(level));
        Ok(Self { zones, core, parts, flat, theta0, state, stiffness, turning })
    }

    pub(super) fn has_rings(&self) -> bool {
        !self.parts.is_empty()
    }

    /// The same with less of the series of the disk; of a disk alone with the force integrated in another order, `P0/rate = d - c int h(c cos t) sin^(2+mu) t dt`.
    pub(super) fn compared(&self, disk: &Disk) -> Self {
        let mut other = self.clone();
        let Some(core) = &mut other.core else { return other };
        core.transform = core.transform.as_ref().map(|all| Arc::new(all.truncated()));
        if !self.parts.is_empty() {
            return other;
        }
        let (c, state) = (core.radius, &mut other.state);
        let mean = disk.with_shape(|shape| c * shape.integral(c, Weight::SineSquared));
        let rate = Core::rate(&core.powers, core.modulus, c);
        match disk.base.load.vertical {
            Vertical::Settlement(_) => state.force = rate * (core.level - mean),
            Vertical::Force(force) => {
                let deeper = force / rate + mean - core.level;
                state.settlement += deeper;
                (core.corner, core.is_free) = (core.corner + deeper, false);
            }
        }
        let turned = disk.rotational.turned(state.force, self.stiffness.moment_tilt);
        [state.tilt, state.moment] = turned;
        other
    }

    /// The radius of the disk, 0 without one.
    fn inside(&self) -> f64 {
        self.core.as_ref().map_or(0.0, |core| core.radius)
    }

    /// The ring that a zone is.
    fn ring(&self, zone: usize) -> Option<&RingPart> {
        self.parts.get(zone.checked_sub(usize::from(self.core.is_some()))?)
    }

    /// What the pressures of rings add on the disk, by the distance from its edge.
    fn on_disk(&self, core: &Core, from_edge: f64) -> f64 {
        let (c, r) = (core.radius, core.radius - from_edge);
        let load = |[s, beside]: [f64; 2]| {
            s.sqrt() / ((beside + from_edge) * (s + r) * (beside * (s + c)).sqrt())
        };
        self.parts.iter().map(|part| part.sum(c, load)).sum()
    }

    /// Rounding of the density at an end of a zone, or between.
    fn rounding(&self, zone: usize, of_slope: fn(&Conjugate) -> f64) -> f64 {
        match (self.ring(zone), &self.core) {
            (Some(part), _) => part.rounding(of_slope),
            (None, Some(core)) => core.depth_rounding(),
            (None, None) => 0.0,
        }
    }

    /// The density at an end, and how it falls there.
    fn at_end(&self, zone: usize, side: usize) -> (f64, [f64; 2]) {
        match (self.ring(zone), &self.core) {
            (Some(part), _) => (part.end_density(side), part.fall(side)),
            (None, Some(core)) if side == 1 => (core.corner, [-core.slope, 0.0]),
            _ => (0.0, [1.0, 0.0]),
        }
    }
}

impl Pressure for Solved {
    fn zones(&self) -> Vec<Zone> {
        self.zones.clone()
    }

    fn state(&self) -> State {
        self.state
    }

    fn stiffness(&self) -> Stiffness {
        let by_rings = self.turning.as_ref().filter(|_| self.has_rings()).map_or(0.0, |known| {
            *known.get_or_init(|| {
                let nodes: Vec<&RingNodes> = self.parts.iter().map(|part| &part.nodes).collect();
                tilted_rate(self.inside(), &nodes).unwrap_or(f64::NAN)
            })
        });
        let moment_tilt = self.stiffness.moment_tilt + by_rings / self.theta0;
        Stiffness { moment_tilt, ..self.stiffness }
    }

    fn force(&self, zone: usize) -> f64 {
        let c = self.inside();
        let weight = RingKernel::Axisymmetric.weight();
        if let Some(part) = self.ring(zone) {
            return weight * part.sum(c, |[r, _]| r.sqrt());
        }
        let Some(core) = &self.core else { return 0.0 };
        let volume = core.transform.as_ref().map_or(0.0, |all| all.volume(core.level));
        let own = 2.0 * core.modulus * volume * self.theta0;
        let left = |place: [f64; 2]| RingKernel::Axisymmetric.left(c, place);
        let taken = |place: [f64; 2]| place[0].sqrt() * (1.0 - left(place));
        own - self.parts.iter().map(|part| weight * part.sum(c, taken)).sum::<f64>()
    }

    fn at(&self, zone: usize, place: Place) -> f64 {
        self.on_side(zone, place, 0.0)
    }

    fn on_side(&self, zone: usize, place: Place, side: f64) -> f64 {
        match (self.ring(zone), &self.core) {
            (Some(part), _) => part.pressure(place.from_left, place.from_right) / self.theta0,
            (None, Some(core)) => core.pressure(place, side, self.on_disk(core, place.from_right)),
            (None, None) => f64::NAN,
        }
    }

    fn corner_exponent(&self) -> f64 {
        self.core.as_ref().map_or(0.5, |core| core.powers.corner_exponent())
    }

    fn regular(&self, zone: usize, place: Place) -> f64 {
        match (self.ring(zone), &self.core) {
            (Some(part), _) => {
                part.regular(part.ring().angle(place.from_left, place.from_right)) / self.theta0
            }
            (None, Some(core)) if place.from_right == 0.0 => core.flat_pressure(core.corner),
            (None, Some(core)) => core.share(place.from_right) * self.at(zone, place),
            (None, None) => f64::NAN,
        }
    }

    fn outside(&self, r: f64) -> f64 {
        let c = self.inside();
        let core = self.core.as_ref().map_or(0.0, |core| {
            core.transform.as_ref().map_or(0.0, |all| all.displacement(r, core.level))
        });
        core + self.parts.iter().map(|part| part.displacement(c, r)).sum::<f64>()
    }

    fn turned_outside(&self, r: f64) -> f64 {
        let Some(core) = self.core.as_ref().filter(|core| core.tilt != 0.0) else { return 0.0 };
        -core.tilt * r * core.share_of_tilt(r)
    }

    fn turned_intensity(&self, _zone: usize) -> f64 {
        let of = |core: &Core| core.tilt_density() * core.radius * core.intensity();
        self.core.as_ref().map_or(0.0, of)
    }

    fn end(&self, zone: usize, side: usize) -> EndState {
        let rings = self.parts.iter().map(RingPart::size).fold(f64::MIN_POSITIVE, f64::max);
        let core = self.core.as_ref();
        let scale = core
            .map_or(rings, |core| rings.max(core.slope.abs() * core.radius).max(core.corner.abs()));
        let (value, fall) = match self.ring(zone) {
            Some(part) => (part.end_density(side), part.fall_of_modes(side)),
            None => (self.at_end(zone, side).0, self.at_end(zone, side).1[0]),
        };
        let rounding = self.rounding(zone, Conjugate::end_error) + f64::EPSILON * scale;
        EndState { value, rounding, scale, none: 0.0, enough: 0.0, step: value / fall }
    }

    fn density(&self, zone: usize, side: usize) -> Density {
        let (value, [fall, fall_error]) = self.at_end(zone, side);
        Density { value, fall, fall_error }
    }

    fn intensity(&self, zone: usize, side: usize) -> f64 {
        match (self.ring(zone), &self.core) {
            (Some(part), _) => part.intensity(side) / self.theta0,
            (None, Some(core)) if side == 1 => core.intensity(),
            _ => 0.0,
        }
    }

    fn known(&self, zone: usize, _largest: f64) -> Known {
        let density = self.rounding(zone, Conjugate::end_error);
        let pressure = match (self.ring(zone), &self.core) {
            (Some(part), _) => {
                let ring = part.ring();
                let size = self.theta0 * ring.half * ring.inner() * ring.inner().sqrt();
                part.rounding(Conjugate::error) / size
            }
            (None, Some(core)) => core.flat_pressure(density + core.slope_rounding()),
            (None, None) => 0.0,
        };
        Known { density, pressure }
    }

    fn displacement_rounding(&self) -> [f64; 2] {
        let core = self.core.as_ref().map_or(0.0, Core::depth_rounding);
        let rings = self.parts.iter().map(RingPart::displacement_rounding);
        let State { tilt, moment, .. } = self.state;
        let turned = (moment / self.stiffness.moment_tilt).abs().max(tilt.abs());
        [rings.fold(core, f64::max), ROUNDING * turned]
    }

    /// Rings have no tilt, and what turns adds nothing to them.
    fn change(&self, raise: f64, turn: f64) -> Self {
        let flat = Arc::new(Conjugate::flat());
        let part = |(part, level): (&RingPart, &Vec<f64>)| {
            let modes: Vec<f64> = level.iter().map(|mode| raise * mode).collect();
            let mut nodes = part.nodes.clone();
            nodes.ring.zone = Zone::new(nodes.ring.zone.ends, [false; 2]);
            RingPart::new(nodes, Arc::clone(&flat), &modes, &vec![0.0; modes.len()])
        };
        let parts: Vec<RingPart> = self.parts.iter().zip(&*self.flat).map(part).collect();
        let core = self.core.as_ref().map(|core| Core {
            transform: None,
            level: raise,
            corner: raise - by_rings(&parts, core.radius)[0],
            tilt: -turn,
            is_free: false,
            ..core.clone()
        });
        Self { core, parts, ..self.clone() }
    }

    fn unknowns(&self) -> usize {
        let transform = self.core.as_ref().and_then(|core| core.transform.as_ref());
        self.coupled() + transform.map_or(0, |all| all.size())
    }

    fn coupled(&self) -> usize {
        self.parts.iter().map(RingPart::count).sum()
    }
}

/// The profiles on rings: their nodes, slopes and coefficients.
struct Profiles {
    nodes: Vec<RingNodes>,
    slopes: Vec<Arc<Conjugate>>,
    heights: Modes,
}

impl Profiles {
    fn new(
        disk: &Disk,
        rings: &[Ring],
        reference: f64,
        c: f64,
        detail: Detail,
    ) -> Result<Self, Error> {
        let base = &disk.base;
        let mut counts = counts(c, rings, detail.digits)?;
        let slope = |ring: &Ring| {
            let inside = |at: &&f64| ring.inner() < **at && **at < ring.outer();
            let angle = |at: &f64| ring.angle(at - ring.inner(), ring.outer() - at);
            let bends: Vec<f64> = base.breaks.iter().filter(inside).map(angle).collect();
            let on_ring = OnRing { base, ring: *ring, reference };
            let slope =
                Conjugate::resolve(&on_ring, [&bends, &[]], [detail.panels, 1], base.tolerance);
            Arc::new(slope)
        };
        let slopes: Vec<Arc<Conjugate>> = rings.iter().map(slope).collect();
        let most = if detail.digits >= FINE.digits { MODES_OF_BASE } else { MODES_OF_BASE / 2 };
        let heights = (slopes.iter().zip(&mut counts))
            .map(|(slope, count)| {
                let mut heights = slope.coefficients(most.max(*count));
                *count = (*count).max(needed(&heights, detail.digits).min(most));
                heights.truncate(*count);
                heights
            })
            .collect();
        require_few(&counts, || narrowest(c, rings))?;
        let nodes = rings.iter().zip(&counts).map(|(ring, n)| RingNodes::new(*ring, *n)).collect();
        Ok(Self { nodes, slopes, heights })
    }
}

/// How many modes of a profile matter to what is beside the logarithm, which is smaller by the square of their number.
fn needed(heights: &[f64], digits: f64) -> usize {
    let size = |(k, f): (usize, &f64)| f.abs() / (1.0 + k as f64);
    let largest = heights.iter().enumerate().map(size).fold(0.0, f64::max);
    let floor = largest * (-digits.min(f64::from(f64::DIGITS + 1)) * LN_10).exp();
    heights.iter().enumerate().rposition(|pair| size(pair) > floor).map_or(2, |last| last + 2)
}

/// `theta0 dM0/d(-alpha0)` of the rings.
fn tilted_rate(c: f64, rings: &[&RingNodes]) -> Result<f64, Error> {
    let kernel = RingKernel::Tilted;
    let levers: Modes =
        rings.iter().map(|ring| ring.modes_of(c, |place| kernel.left(c, place))).collect();
    let tilted = coupled(kernel, (c, FINE.digits), rings, std::slice::from_ref(&levers))?;
    Ok(kernel.weight() * tilted.first().map_or(0.0, |found| product(&levers, found)))
}

/// `int one two dphi` over all rings.
fn product(one: &[Vec<f64>], two: &[Vec<f64>]) -> f64 {
    let terms = one.iter().zip(two).flat_map(|(one, two)| one.iter().zip(two).enumerate());
    terms.map(|(k, (a, b))| norm(k) * a * b).sum()
}

/// What rings take from `d(c)`, and how that grows with `c`.
fn by_rings(parts: &[RingPart], c: f64) -> [f64; 2] {
    let sum = |f: &dyn Fn([f64; 2]) -> f64| -> f64 {
        PI * parts.iter().map(|part| part.sum(c, f)).sum::<f64>()
    };
    let root = |[s, beside]: [f64; 2]| (beside * (s + c)).sqrt();
    let load = sum(&|place| place[0].sqrt() / root(place));
    let steeper = sum(&|place| c * place[0].sqrt() / root(place).powi(3));
    [load, steeper]
}
