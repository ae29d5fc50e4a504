//! The same problem by a method that shares no code with those that solve it.

use serde::Serialize;
use shtaerman_reference::{
    Break, Kernel, Layer, Problem as Posed, Reference, Refusal, Rotational as Turned, Transferred,
    Vertical as Pressed,
};

use crate::contact::layered_plane;
use crate::contact::parts::{DEGREE, RESOLVED};
use crate::contact::steps::INSIDE;
use crate::contact::{Accuracy, Contact, ErrorKind};
use crate::roughness::Law;
use crate::{ContactKind, Error, Geometry, Layering, Load, Problem, Rotational, Scaling, Vertical};

/// Places at which pressures are compared: evenly over the base, an odd number as panels of the reference meet between halves and know least there, in the middle, and beside each end of a zone.
const EVENLY: u32 = 97;
const BESIDE: u32 = 12;
/// The same on a smooth surface, where the rounding of a place is a large share of its distance from an end.
const BESIDE_SINGULAR: u32 = 4;
/// Where the reference is this much less certain than the answer, it is said.
const CERTAIN: f64 = 10.0;

/// Differences between an answer and the reference, without dimensions, with what the reference states of its own errors.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CrossCheck {
    /// `product_integration`.
    pub method: &'static str,
    /// Unknowns of its finest solution.
    pub n: usize,
    /// Largest difference of the pressures `p0` over many places of the base.
    pub pressure: f64,
    /// Where the pressures differ most beside what both state there, as `xi`.
    pub pressure_at: f64,
    /// Difference of `delta0`.
    pub settlement: f64,
    /// Difference of `alpha0`.
    pub tilt: f64,
    /// Difference of `P0`.
    pub force: f64,
    /// Difference of `M0`.
    pub moment: f64,
    /// What the reference states of its own errors.
    pub reference_error: ReferenceError,
    /// Whether no difference is larger than what both state of their errors together, at any of the places.
    pub agrees: bool,
    /// What could not be checked to the digits that the answer states, and how far it was; none where all was.
    pub limits: Option<String>,
}

/// Errors of a reference, without dimensions; zero for what the load prescribes.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct ReferenceError {
    /// Of the pressure, largest over the places compared.
    pub pressure: f64,
    /// Of `delta0`.
    pub settlement: f64,
    /// Of `alpha0`.
    pub tilt: f64,
    /// Of `P0`.
    pub force: f64,
    /// Of `M0`.
    pub moment: f64,
}

impl Problem {
    /// Solves the problem by product integration on graded panels, which shares no code with the methods of this library but the numbers of the problem, and compares. It searches the
    /// zones by itself, from the full base; where it does not find them, from those of the answer.
    ///
    /// # Errors
    /// [`Error::NoReference`] with the reason.
    pub fn cross_check(&self, contact: &Contact) -> Result<CrossCheck, Error> {
        let (problem, level) = self.lowered().unwrap_or_else(|| (self.clone(), 0.0));
        let displacement = self.bodies().unit(Scaling::displacement);
        let height = |xi: f64| problem.dimensionless_profile(xi);
        let layering =
            self.bodies().layering().map(|on| on.clone().scaled(self.bodies().half_width()));
        let influence = layering.as_ref().map(influence);
        let posed = Posing::new(&problem, level / displacement, &height, influence.as_deref());
        posed
            .and_then(|posing| posing.compare(contact))
            .map_err(|reason| Error::NoReference { reason })
    }
}

/// The influence function of ground in two pieces or of one's own, from its transfer function by quadrature that is not that of the solution.
fn influence(layering: &Layering) -> Box<dyn Fn(f64) -> f64 + '_> {
    let strength = layering.strength();
    if let Some(remainder) = layering.remainder() {
        return Box::new(move |d| remainder.at(d) - d.ln());
    }
    let transfer = |u| layering.transfer(u);
    let kernel = Transferred::new(layering.thickness(), layering.far_share(), &transfer, 2.0);
    Box::new(move |d| strength * kernel.value(d))
}

/// A problem as the reference takes it.
struct Posing<'a> {
    kernel: Kernel<'a>,
    theta: f64,
    layer: Layer,
    pieces: Vec<[f64; 2]>,
    breaks: Vec<Break>,
    is_bilateral: bool,
    load: Load,
    /// From which heights and settlement are counted.
    level: f64,
    height: &'a dyn Fn(f64) -> f64,
}

/// The error of an answer whose method states none.
const UNKNOWN: Accuracy = Accuracy {
    kind: ErrorKind::Estimate,
    pressure: f64::INFINITY,
    settlement: f64::INFINITY,
    tilt: f64::INFINITY,
    force: f64::INFINITY,
    moment: f64::INFINITY,
};

/// A quantity that is compared, with the error stated by the answer, the reference's own, and the size of such quantities.
struct Part {
    name: &'static str,
    difference: f64,
    stated: f64,
    own: f64,
    size: f64,
}

impl Part {
    fn agrees(&self) -> bool {
        self.difference <= self.stated + self.own
    }
}

/// `sin phi` of a place `c + b cos phi` in its zone: on a smooth surface the error of the pressure is stated for the middle and grows as one over that; 1 beside the zones.
fn middle(contact: &Contact, xi: f64) -> f64 {
    let zones = contact.dimensionless().zones();
    let zone = zones.iter().find(|[left, right]| *left <= xi && xi <= *right);
    zone.map_or(1.0, |[left, right]| 2.0 * ((xi - left) * (right - xi)).sqrt() / (right - left))
}

/// What is compared.
struct Found<'a> {
    settlement: f64,
    tilt: f64,
    force: f64,
    moment: f64,
    errors: ReferenceError,
    n: usize,
    pressure: &'a dyn Fn(f64) -> [f64; 2],
}

impl<'a> Posing<'a> {
    fn new(
        problem: &Problem,
        level: f64,
        height: &'a dyn Fn(f64) -> f64,
        influence: Option<&'a dyn Fn(f64) -> f64>,
    ) -> Result<Self, Refusal> {
        let bodies = problem.bodies();
        let layer = match bodies.law() {
            Law::Linear => Layer::Linear,
            Law::Power(exponent) => Layer::Power { exponent },
            Law::Smooth => Layer::None,
        };
        let exponent = bodies.grading().map_or(0.0, |grading| grading.exponent());
        let (kernel, pieces) = match bodies.geometry().scaled(bodies.half_width()) {
            Geometry::Circular if influence.is_some() => {
                return Err(Refusal::NotCovered(
                    "the reference has no kernel of a layer under a circular punch",
                ));
            }
            Geometry::Circular => (Kernel::Disk { exponent, harmonic: 0 }, vec![[0.0, 1.0]]),
            Geometry::Periodic { period } => (Kernel::Row { period }, bodies.pieces()),
            Geometry::Plane | Geometry::Pair { .. } if exponent > 0.0 => {
                (Kernel::Power { exponent }, bodies.pieces())
            }
            Geometry::Plane | Geometry::Pair { .. } => {
                (influence.map_or(Kernel::Logarithm, Kernel::Plane), bodies.pieces())
            }
        };
        // What a remainder does within a panel, quadrature on longer ones would miss.
        let own = bodies.layering().filter(|on| on.remainder().is_some());
        let own = own.and_then(|on| layered_plane(&on.clone().scaled(bodies.half_width())).ok());
        let bends = own.map(|kernel| kernel.bend());
        let load = problem.dimensionless_load();
        // A wave cannot tilt.
        let load = if problem.is_wave() {
            Load { rotational: Rotational::Tilt(0.0), ..load }
        } else {
            load
        };
        Ok(Self {
            kernel,
            theta: bodies.theta0(),
            layer,
            breaks: breaks(problem, &pieces, bends),
            pieces,
            is_bilateral: problem.solver().contact == ContactKind::Bilateral,
            load,
            level,
            height,
        })
    }

    fn posed(&self) -> Posed<'_> {
        Posed {
            kernel: self.kernel,
            theta: self.theta,
            layer: self.layer,
            pieces: &self.pieces,
            is_bilateral: self.is_bilateral,
            vertical: match self.load.vertical {
                Vertical::Force(force) => Pressed::Force(force),
                Vertical::Settlement(settlement) => Pressed::Settlement(settlement),
            },
            rotational: match self.load.rotational {
                Rotational::Moment(moment) => Turned::Moment(moment),
                Rotational::Eccentricity(e) => Turned::Eccentricity(e),
                Rotational::Tilt(tilt) => Turned::Tilt(tilt),
            },
            base: self.height,
            breaks: &self.breaks,
        }
    }

    fn compare(&self, contact: &Contact) -> Result<CrossCheck, Refusal> {
        let posed = self.posed();
        let Kernel::Disk { exponent, .. } = self.kernel else {
            let found = solve(&posed, &contact.dimensionless().zones())?;
            return Ok(self.judge(contact, &Found::new(&found, &|xi| found.pressure(xi))));
        };
        let zones: Vec<[f64; 2]> = (contact.dimensionless().zones().into_iter())
            .filter(|[_, right]| *right > 0.0)
            .map(|[left, right]| [left.max(0.0), right])
            .collect();
        let round = Posed { rotational: Turned::Tilt(0.0), ..posed };
        let even = solve(&round, &zones)?;
        if self.load.rotational.named().1 == 0.0 {
            return Ok(self.judge(contact, &Found::new(&even, &|xi| even.pressure(xi.abs()))));
        }
        let turned = match self.load.rotational {
            Rotational::Moment(moment) => Turned::Moment(moment),
            Rotational::Eccentricity(e) => Turned::Moment(e * even.force),
            Rotational::Tilt(tilt) => Turned::Tilt(tilt),
        };
        let tilted = Posed {
            kernel: Kernel::Disk { exponent, harmonic: 1 },
            is_bilateral: true,
            vertical: Pressed::Settlement(0.0),
            rotational: turned,
            ..self.posed()
        };
        let odd = solve(&tilted, &self.pieces)?;
        let lifts = |xi: f64| even.pressure(xi)[0] < odd.pressure(xi)[0].abs();
        if even.zones != self.pieces
            || !self.is_bilateral && (0..=64).any(|i| lifts(f64::from(i) / 64.0))
        {
            return Err(Refusal::NotCovered(
                "a tilted disk that lifts off is no body of revolution",
            ));
        }
        if self.layer != Layer::Linear && self.layer != Layer::None {
            return Err(Refusal::NotCovered("a power law mixes the harmonics of a tilted disk"));
        }
        let pressure = |xi: f64| {
            let [[p, one], [q, other]] = [even.pressure(xi.abs()), odd.pressure(xi.abs())];
            [p + q.copysign(q * xi), one + other]
        };
        let mut found = Found::new(&even, &pressure);
        (found.tilt, found.moment) = (odd.tilt, odd.moment);
        (found.errors.tilt, found.errors.moment) = (odd.errors.tilt, odd.errors.moment);
        if let Rotational::Eccentricity(e) = self.load.rotational {
            found.errors.moment += e.abs() * even.errors.force;
            found.errors.tilt += (odd.tilt / even.force).abs() * even.errors.force;
        }
        Ok(self.judge(contact, &found))
    }

    /// Holds the differences against what both state.
    fn judge(&self, contact: &Contact, found: &Found<'_>) -> CrossCheck {
        let stated = contact.accuracy().copied().unwrap_or(UNKNOWN);
        let own = &found.errors;
        let moved = found.settlement.abs().max(found.tilt.abs());
        let pressed = found.force.abs().max(found.moment.abs());
        let part = |name, difference: f64, stated, own, size| Part {
            name,
            difference: difference.abs(),
            stated,
            own,
            size,
        };
        let (settlement, level) = contact.solved_settlement();
        let bare = contact.dimensionless();
        let settlement = (found.settlement - settlement) + (self.level - level);
        let (pressure, pressure_at) = self.pressures(contact, found, stated.pressure);
        let parts = [
            pressure,
            part("settlement", settlement, stated.settlement, own.settlement, moved),
            part("tilt", found.tilt - bare.tilt(), stated.tilt, own.tilt, moved),
            part("force", found.force - bare.force(), stated.force, own.force, pressed),
            part("moment", found.moment - bare.moment(), stated.moment, own.moment, pressed),
        ];
        let [pressure, settlement, tilt, force, moment] = &parts;
        CrossCheck {
            method: "product_integration",
            n: found.n,
            pressure: pressure.difference,
            pressure_at: pressure_at.0,
            settlement: settlement.difference,
            tilt: tilt.difference,
            force: force.difference,
            moment: moment.difference,
            reference_error: ReferenceError { pressure: pressure.own, ..*own },
            agrees: pressure_at.1 <= 1.0 && parts[1..].iter().all(Part::agrees),
            limits: limits(&parts),
        }
    }

    /// The pressures at many places; and where they differ most beside both errors there, with the difference over those.
    fn pressures(&self, contact: &Contact, found: &Found<'_>, stated: f64) -> (Part, (f64, f64)) {
        let mut worst = (0.0, 0.0);
        let mut part = Part { name: "pressure", difference: 0.0, stated, own: 0.0, size: 0.0 };
        for xi in self.places(contact) {
            let [p, own] = (found.pressure)(xi);
            let known = contact.pressure_at(xi);
            // A corner or a kink of a smooth surface.
            if known.is_infinite() || p.is_infinite() {
                continue;
            }
            let share = if self.layer == Layer::None { middle(contact, xi) } else { 1.0 };
            let difference = (p - known).abs() * share;
            part.difference = part.difference.max(difference);
            part.own = part.own.max(own * share);
            part.size = part.size.max(p.abs() * share);
            let allowed = stated + own * share;
            let over = if difference == 0.0 { 0.0 } else { difference / allowed };
            // What is not a number is within nothing.
            if over.is_nan() || over > worst.1 {
                worst = (xi, if over.is_nan() { f64::INFINITY } else { over });
            }
        }
        (part, worst)
    }

    /// Where pressures are compared.
    fn places(&self, contact: &Contact) -> Vec<f64> {
        let place = |i: u32| 2.0 * f64::from(i) / f64::from(EVENLY) - 1.0;
        let mut places: Vec<f64> = (0..=EVENLY).map(place).chain([0.0]).collect();
        for [left, right] in contact.dimensionless().zones() {
            let reach = 0.45 * (right - left);
            let nearest = if self.layer == Layer::None { BESIDE_SINGULAR } else { BESIDE };
            let beside = (0..=nearest).map(|k| reach * 0.1f64.powi(k as i32));
            places.extend(beside.flat_map(|d| [left + d, right - d]));
            places.extend([left, right]);
        }
        for cut in &self.breaks {
            places.extend([cut.at - 1e-6, cut.at + 1e-6]);
        }
        let is_jump = |xi: f64| {
            let xi = if matches!(self.kernel, Kernel::Disk { .. }) { xi.abs() } else { xi };
            self.breaks.iter().any(|cut| cut.is_sharp && (cut.at - xi).abs() < INSIDE)
        };
        let pieces = contact.problem().bodies().pieces();
        places.retain(|xi| {
            pieces.iter().any(|[left, right]| left <= xi && xi <= right) && !is_jump(*xi)
        });
        places
    }
}

impl<'a> Found<'a> {
    fn new(reference: &Reference<'_>, pressure: &'a dyn Fn(f64) -> [f64; 2]) -> Self {
        let errors = reference.errors;
        Self {
            settlement: reference.settlement,
            tilt: reference.tilt,
            force: reference.force,
            moment: reference.moment,
            errors: ReferenceError {
                pressure: 0.0,
                settlement: errors.settlement,
                tilt: errors.tilt,
                force: errors.force,
                moment: errors.moment,
            },
            n: reference.unknowns,
            pressure,
        }
    }
}

/// The reference, from zones of its own; where it does not find them, from those of the answer.
fn solve<'p>(posed: &'p Posed<'p>, zones: &[[f64; 2]]) -> Result<Reference<'p>, Refusal> {
    match posed.solve(None) {
        Err(Refusal::ZonesNotFound | Refusal::NoContact) => posed.solve(Some(zones)),
        found => found,
    }
}

/// Where panels end: the switches and hidden kinks of the profile, its measured points, the surroundings of what no sample may show, and evenly where an influence function bends within less than the
/// base.
fn breaks(problem: &Problem, pieces: &[[f64; 2]], bends: Option<f64>) -> Vec<Break> {
    let half_width = problem.bodies().half_width();
    let resolution = problem.resolution(DEGREE, RESOLVED);
    let sharp = problem.profile().breakpoints(half_width).into_iter().chain(resolution.singular);
    let mut found: Vec<Break> = sharp.map(|at| Break { at, is_sharp: true }).collect();
    let mild = problem.profile().joints(half_width).into_iter().chain(resolution.joints);
    let count = bends.map_or(0, |length| (2.0 / length).ceil() as usize);
    let even = (1..count).map(|i| 2.0 * i as f64 / count as f64 - 1.0);
    for at in mild.chain(even) {
        if !found.iter().any(|known| (known.at - at).abs() < INSIDE) {
            found.push(Break { at, is_sharp: false });
        }
    }
    // The tip of a cone is a break of a disk.
    let is_tip = |at: f64| at == 0.0 && pieces[0][0] == 0.0;
    found.retain(|cut| {
        is_tip(cut.at) || pieces.iter().any(|[left, right]| *left < cut.at && cut.at < *right)
    });
    crate::order::sort_by_number(&mut found, |one| one.at);
    found.dedup_by(|later, earlier| later.at - earlier.at < INSIDE);
    found
}

/// What the reference knows less well than the answer states, by more than rounding.
fn limits(parts: &[Part]) -> Option<String> {
    let unchecked: Vec<String> = (parts.iter())
        .filter(|part| part.own > CERTAIN * part.stated && part.own > RESOLVED * part.size)
        .map(|Part { name, stated, own, .. }| {
            format!("{name} to {own:.1e} only, of which the answer states {stated:.1e}")
        })
        .collect();
    (!unchecked.is_empty()).then(|| unchecked.join("; "))
}
