//! The audit of an answer: its errors from its own residual, whatever way it was found.
//!
//! The book's chapter *The audit* has the theorem and its proof; the crate `shtaerman-audit` carries it out on plain numbers. Here a contact is handed to it.

use serde::Serialize;
use shtaerman_audit::{Answer, Bound, DiskProblem, Ground, Kernel, Prescribed, Profile, Refusal};

use super::accuracy::OF_A_VALUE;
use super::ground::SHARP;
use super::parts::{DEGREE, RESOLVED};
use super::promise::ROUGHEST;
use super::{Accuracy, ErrorKind};
use crate::roughness::Law;
use crate::{Contact, ContactKind, Error, Geometry, Layering, Load, Problem, Rotational, Vertical};

/// What scaling does to the constants of graded ground, relative to them, which hold gamma functions, times `1 - mu` (tested against 30 digits).
const GRADED: f64 = 8e-15;

/// On ground that is graded to [`SHARP`] bounds at a place follow from the mean with large factors: one so large that it would be no answer is not given where the mean is known to so much.
const IN_THE_MEAN: f64 = 1e-3;

/// What the audit found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Audit {
    /// Bound or estimate.
    pub kind: ErrorKind,
    /// The error of the pressure in the mean square over the base, without dimensions.
    pub mean_square: f64,
    /// The norm of the residual.
    pub residual: f64,
    /// Panels of the resampled pressure.
    pub panels: usize,
    /// Windows on which the residual was bounded.
    pub windows: usize,
    /// What it rests on, in one sentence.
    pub reason: &'static str,
    /// The errors of the answer.
    #[serde(skip)]
    pub(crate) accuracy: Accuracy,
    /// What the largest `p0` is at most, where that is known.
    #[serde(skip)]
    pub(crate) highest: Option<f64>,
    /// The error of the free ends of the zones in `xi`; none where no end is free or another zone cannot be excluded.
    #[serde(skip)]
    pub(crate) edges: Option<f64>,
}

impl Audit {
    /// The error of the pressure at any place of the base, without dimensions.
    #[must_use]
    pub fn pressure(&self) -> f64 {
        self.accuracy.pressure
    }
}

/// Why an answer has no audit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unaudited {
    /// The theorem does not hold for it.
    NotCovered(&'static str),
    /// No bound was found.
    Refused(Refusal),
    /// No finite bound was found.
    NotFinite,
    /// On graded ground with an exponent from 1/2 on the pressure has corners so sharp that the residual bounds it in the mean only.
    InTheMeanOnly {
        /// The bound of the error in the mean square, relative to the largest pressure.
        mean_square: f64,
    },
}

impl std::fmt::Display for Unaudited {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NotCovered(reason) => formatter.write_str(reason),
            Self::NotFinite => formatter.write_str(
                "no finite bound of its error was found: the pressure changes too sharply for it, which more roughness or a lower grading exponent mends",
            ),
            Self::InTheMeanOnly { mean_square } => write!(
                formatter,
                "beside corners of the pressure on graded ground with an exponent from 1/2 on the residual bounds it in the mean square only, by {mean_square:.1e} of its largest value"
            ),
            Self::Refused(Refusal::NoPressure) => formatter.write_str("the pressure is not finite"),
            Self::Refused(Refusal::TooManyPanels) => {
                formatter.write_str("the pressure bends at more places than the audit follows")
            }
            Self::Refused(Refusal::TooManyWindows { at }) => {
                write!(
                    formatter,
                    "the residual near xi = {at} changes faster than the audit follows"
                )
            }
            Self::Refused(Refusal::Penetrates { at }) => {
                write!(
                    formatter,
                    "the base penetrates near xi = {at:.6}, where the answer has no contact"
                )
            }
            Self::Refused(Refusal::LoadNotMet) => {
                formatter.write_str("the pressure is far from the prescribed force or moment")
            }
        }
    }
}

/// A way to bound the errors of an answer.
type Auditor = fn(&shtaerman_audit::Problem<'_>, &Answer<'_>) -> Result<Bound, Refusal>;

/// The base of a problem, enclosed.
struct Base<'a>(&'a Problem);

impl Profile for Base<'_> {
    fn height(&self, x: f64) -> [f64; 2] {
        (self.0.dimensionless_enclosure_at(x))
            .map_or([f64::NEG_INFINITY, f64::INFINITY], |range| [range.lower(), range.upper()])
    }

    fn range(&self, interval: [f64; 2]) -> [f64; 2] {
        (self.0.dimensionless_enclosure(interval))
            .map_or([f64::NEG_INFINITY, f64::INFINITY], |range| [range.lower(), range.upper()])
    }

    fn taylor_bounds(&self, interval: [f64; 2], order: usize) -> Vec<f64> {
        let found = self.0.dimensionless_taylor(interval, order).unwrap_or_default();
        found.iter().map(|range| range.lower().abs().max(range.upper().abs())).collect()
    }
}

/// What a contact asks of the audit.
enum Posed {
    /// A plane contact: the kernel, what scaling may do to the numbers, and the exponent of the layer.
    Plane(Kernel, f64, f64),
    /// Plane ground described by a transfer function, and how much stronger than the foundation it is where points meet.
    Layered(Box<Ground>, f64),
    /// A circular punch: the exponent of the ground and that of the layer.
    Disk(f64, f64),
}

/// A wave on a power law under a settlement: its force is bounded by nothing.
const NOT_ESTIMATED: Unaudited =
    Unaudited::NotCovered("the residual says nothing of its errors: the estimate is not finite");

impl Posed {
    /// Whether the residual is bounded between all places.
    fn is_bound(&self) -> bool {
        matches!(self, Self::Plane(_, _, layer) if *layer == 1.0)
    }
}

/// What a contact asks of the audit, or why it has none.
fn posed(problem: &Problem) -> Result<Posed, Unaudited> {
    let frame = problem.frame();
    if problem.profile().is_closure() {
        return Err(Unaudited::NotCovered(
            "the profile is a closure, of which nothing is known between samples",
        ));
    }
    let layer = match frame.law() {
        Law::Linear => 1.0,
        Law::Power(exponent) => exponent,
        Law::Smooth => {
            return Err(Unaudited::NotCovered(
                "a smooth surface has no layer, and without it the residual bounds nothing in the mean square",
            ));
        }
    };
    if let Some(layering) = frame.layering() {
        return layered(problem, &layering.clone().scaled(frame.half_width()), layer);
    }
    let exponent = frame.grading().map_or(0.0, |grading| grading.exponent());
    let geometry = frame.geometry().scaled(frame.half_width());
    if geometry == Geometry::Circular {
        return Ok(Posed::Disk(exponent, layer));
    }
    Ok(match geometry {
        Geometry::Periodic { period } => Posed::Plane(Kernel::Row { period }, OF_A_VALUE, layer),
        _ if exponent > 0.0 => {
            Posed::Plane(Kernel::Power { exponent }, OF_A_VALUE + GRADED / (1.0 - exponent), layer)
        }
        _ => Posed::Plane(Kernel::Logarithm, OF_A_VALUE, layer),
    })
}

/// What a contact on a layer, under a coating or on an influence function asks of the audit, or why it has none.
fn layered(problem: &Problem, layering: &Layering, layer: f64) -> Result<Posed, Unaudited> {
    if problem.frame().geometry() == Geometry::Circular {
        return Err(Unaudited::NotCovered(
            "the residual on a layer under a circular punch is not bounded yet: its errors are estimates of the method",
        ));
    }
    if layer < 1.0 {
        return Err(Unaudited::NotCovered(
            "the residual bounds nothing for a power law of roughness on a layer, under a coating or on an influence function, whose kernels are not known to have a maximum principle: its errors are estimates of the method",
        ));
    }
    if layering.remainder().is_some() {
        return Err(Unaudited::NotCovered(
            "of an influence function given by its remainder it is not known whether it is positive, without which the residual bounds nothing: its errors are estimates of the method, and a cross-check by product integration holds them against another; with a transfer function it has an audit",
        ));
    }
    let ground = Ground::new(layering.thickness(), layering.far_share(), &|u| layering.transfer(u));
    if !ground.is_positive() && !matches!(problem.load().vertical(), Vertical::Force(_)) {
        return Err(Unaudited::NotCovered(
            "at a settlement prescribed the residual bounds nothing under a coating that is stiffer than what it lies on, whose kernel is known to be positive only for pressures without force: its errors are estimates of the method; with the force prescribed it has an audit",
        ));
    }
    Ok(Posed::Layered(Box::new(ground), layering.strength()))
}

/// A bound of plane contact, or an estimate of another.
const BOUND: &str = "the residual of the answer, resampled and bounded between all places, with rounding: it holds whatever way the answer was found";
const OWN_LOAD: &str = "the residual of the answer, resampled: a bound for the contact under its own force and moment, an estimate for the settlement prescribed";
const SAMPLED: &str = "the residual of the answer at places of its own: the profile is enclosed between them, the potential is not";

const TRANSFORMED: &str = "the residual of the answer, resampled and bounded between all places but for the quadrature of the ground's transfer function, which is estimated";

impl Contact {
    /// Bounds the errors of this answer by its residual: nothing is asked of the way it was found.
    ///
    /// Guaranteed for plane contact of one punch, a pair and a row and for graded ground, with a linear layer, bilateral or not; with a settlement and an eccentricity prescribed
    /// together it holds for the contact under the answer's own force and moment, and is an estimate.
    /// On plane ground with a transfer function (layers, coatings, [`Influence::by_transfer`](crate::Influence::by_transfer)) it is an estimate: its quadrature is compared, not enclosed.
    ///
    /// # Errors
    /// [`Unaudited`] with the reason.
    pub fn audit(&self) -> Result<Audit, Unaudited> {
        self.audit_by(shtaerman_audit::audit)
    }

    /// The same on panels half as long: a second bound from other numbers, with which the first can be compared.
    ///
    /// # Errors
    /// Those of [`Contact::audit`].
    pub fn audit_on_halved_panels(&self) -> Result<Audit, Unaudited> {
        self.audit_by(shtaerman_audit::audit_on_halved_panels)
    }

    fn audit_by(&self, auditor: Auditor) -> Result<Audit, Unaudited> {
        // Heights are counted from the level from which they were solved: that loses no digits, and changes nothing but the settlement.
        let problem = self.solved();
        let (settlement, level) = self.solved_settlement();
        let bare = self.dimensionless();
        let posed = posed(problem)?;
        let frame = problem.frame();
        let load = problem.dimensionless_load();
        let (prescribed, is_load_own) = prescribed(&load, bare.force(), bare.moment());
        // A wave cannot tilt, and what is its own mirror image does not.
        let is_symmetric = problem.is_symmetric();
        let is_level = problem.is_wave() || is_symmetric;
        let prescribed =
            if is_level { Prescribed { moment: None, ..prescribed } } else { prescribed };
        let zones = bare.zones();
        let zones = if problem.is_wave() { within_period(&zones) } else { zones };
        let mut cuts = problem.profile().joints(frame.half_width());
        cuts.extend(problem.resolution(DEGREE, RESOLVED).joints);
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let pressure = |xi: f64| self.pressure_at(xi);
        let answer = Answer {
            zones: &zones,
            pressure: &pressure,
            settlement,
            tilt: bare.tilt(),
            force: bare.force(),
            moment: bare.moment(),
        };
        let (bound, is_bound) = self.bound(auditor, &posed, (prescribed, &cuts), &answer)?;
        let is_bound = is_bound && !is_load_own;
        let kind = if is_bound { ErrorKind::Bound } else { ErrorKind::Estimate };
        let reason = match posed.is_bound() {
            false if matches!(posed, Posed::Layered(..)) => TRANSFORMED,
            false => SAMPLED,
            true if is_load_own => OWN_LOAD,
            true => BOUND,
        };
        let accuracy = Accuracy {
            kind,
            pressure: bound.pressure,
            settlement: bound.settlement,
            tilt: bound.tilt,
            force: bound.force,
            // The true one of what is its own mirror image is 0.
            moment: if is_symmetric { bare.moment().abs() } else { bound.moment },
        };
        let accuracy = match load.rotational {
            Rotational::Eccentricity(e) if is_load_own => {
                self.at_settlement(accuracy, bound.settlement, e)
            }
            _ => accuracy,
        };
        if !accuracy.is_finite() {
            return Err(if posed.is_bound() { Unaudited::NotFinite } else { NOT_ESTIMATED });
        }
        Ok(Audit {
            kind,
            mean_square: bound.mean_square,
            residual: bound.residual,
            panels: bound.panels,
            windows: bound.windows,
            reason,
            accuracy: accuracy.with_level(level),
            highest: bound.highest,
            edges: bound.ends,
        })
    }
}

/// Zones of a wave within its period, `[-1, 1]`, from left to right: the solution lets them reach across the seam.
fn within_period(zones: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    for [left, right] in zones {
        let back = 2.0 * (0.5 * (left + 1.0)).floor();
        let [left, right] = [left - back, right - back];
        if right > 1.0 {
            found.extend([[left, 1.0], [-1.0, right - 2.0]]);
        } else {
            found.push([left, right]);
        }
    }
    found.retain(|[left, right]| left < right);
    found.sort_by(|a, b| a[0].total_cmp(&b[0]));
    found
}

impl Contact {
    /// The audit of what was posed, and whether it is a bound.
    fn bound(
        &self,
        auditor: Auditor,
        posed: &Posed,
        (prescribed, cuts): (Prescribed, &[f64]),
        answer: &Answer<'_>,
    ) -> Result<(Bound, bool), Unaudited> {
        let problem = self.solved();
        let frame = problem.frame();
        let scaled = |size: f64| if frame.scaling().is_some() { size } else { 0.0 };
        let is_bilateral = problem.solver().contact == ContactKind::Bilateral;
        let profile = &Base(problem);
        let pieces = frame.pieces();
        let plane = |kernel, ground, strength: f64, size| shtaerman_audit::Problem {
            kernel,
            ground,
            theta: strength * frame.theta0(),
            scaled: scaled(size),
            pieces: &pieces,
            is_bilateral,
            prescribed,
            profile,
            cuts,
        };
        let found = match posed {
            Posed::Layered(ground, strength) => {
                auditor(&plane(ground.kernel(), Some(&**ground), *strength, SCALED), answer)
            }
            Posed::Plane(kernel, size, layer) if *layer < 1.0 => {
                let stiffness = self.dimensionless().stiffness().matrix();
                let posed = plane(*kernel, None, 1.0, *size);
                shtaerman_audit::audit_bent(&posed, *layer, stiffness, answer)
            }
            Posed::Plane(kernel, size, _) => auditor(&plane(*kernel, None, 1.0, *size), answer),
            &Posed::Disk(exponent, layer) => {
                let posed = DiskProblem {
                    exponent,
                    theta: frame.theta0(),
                    layer,
                    scaled: scaled(OF_A_VALUE + GRADED * exponent.min(1.0)),
                    is_bilateral,
                    prescribed,
                    profile,
                    cuts,
                };
                shtaerman_audit::audit_disk(&posed, answer)
            }
        };
        let bound = found.map_err(Unaudited::Refused)?;
        let largest = self.peak().0.abs();
        let mean_square = bound.mean_square / largest;
        let is_sharp =
            matches!(posed, Posed::Plane(Kernel::Power { exponent }, _, 1.0) if *exponent >= SHARP);
        if is_sharp && bound.pressure > ROUGHEST * largest && mean_square < IN_THE_MEAN {
            return Err(Unaudited::InTheMeanOnly { mean_square });
        }
        Ok((bound, posed.is_bound()))
    }

    /// What the errors of the contact under the answer's own force become at the settlement prescribed, from which that contact is off by `missed`: to first order, by the tangent
    /// stiffness along `M = e P`, `-alpha = -(k12 - e k11)/(k22 - e k12) delta`. An estimate.
    fn at_settlement(&self, under_own_force: Accuracy, missed: f64, e: f64) -> Accuracy {
        let [[k11, k12], [_, k22]] = self.dimensionless().stiffness().matrix();
        let turn = (k12 - e * k11) / (k22 - e * k12);
        let force = missed * (k11 - k12 * turn).abs();
        let largest = self.peak().0.abs();
        Accuracy {
            pressure: under_own_force.pressure
                + largest * force / self.dimensionless().force().abs(),
            settlement: 0.0,
            tilt: under_own_force.tilt + missed * turn.abs(),
            force,
            moment: e.abs() * force,
            ..under_own_force
        }
    }
}

impl Contact {
    /// Whether norms of the pressure are within the range of double precision.
    fn has_finite_squares(&self) -> bool {
        let (peak, _) = self.peak();
        (peak * peak).is_finite() && (self.theta0() * self.solution_size().powi(2)).is_finite()
    }

    /// The answer with the errors of its [audit](Contact::audit) in place of those its method states, where the theorem covers it; otherwise as it is, with the reason kept.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] where the audited error is above an explicit tolerance, [`Error::NotAccurate`] where it is above 1 % and neither a tolerance nor a degree was
    /// given, [`Error::AuditFailed`] where the pressure does not carry the load or no finite bound was found,
    /// [`Error::Overflow`] where the pressure leaves the range of double precision.
    pub fn audited(mut self) -> Result<Self, Error> {
        let audit = self.audit();
        match audit {
            Err(Unaudited::NotFinite | Unaudited::Refused(Refusal::NoPressure))
                if !self.has_finite_squares() =>
            {
                let quantity = "bound of the error of the pressure";
                return Err(Error::Overflow { quantity, value: f64::INFINITY });
            }
            Err(
                refused @ (Unaudited::NotFinite
                | Unaudited::Refused(
                    Refusal::NoPressure | Refusal::LoadNotMet | Refusal::Penetrates { .. },
                )),
            ) => return Err(Error::AuditFailed { reason: refused.to_string() }),
            Ok(_) | Err(_) => {}
        }
        self.set_audit(audit);
        self.require_tolerance()?;
        Ok(self)
    }
}

/// What the load prescribes; of a settlement with an eccentricity the answer's own force and moment instead, which is told.
fn prescribed(load: &Load, force: f64, moment: f64) -> (Prescribed, bool) {
    match (load.vertical, load.rotational) {
        (Vertical::Force(force), Rotational::Moment(moment)) => {
            (Prescribed { force: Some(force), moment: Some(moment) }, false)
        }
        (Vertical::Force(force), Rotational::Eccentricity(e)) => {
            (Prescribed { force: Some(force), moment: Some(e * force) }, false)
        }
        (Vertical::Force(force), Rotational::Tilt(_)) => {
            (Prescribed { force: Some(force), moment: None }, false)
        }
        (Vertical::Settlement(_), Rotational::Moment(moment)) => {
            (Prescribed { force: None, moment: Some(moment) }, false)
        }
        (Vertical::Settlement(_), Rotational::Tilt(_)) => {
            (Prescribed { force: None, moment: None }, false)
        }
        (Vertical::Settlement(_), Rotational::Eccentricity(0.0)) => {
            (Prescribed { force: None, moment: Some(0.0) }, false)
        }
        (Vertical::Settlement(_), Rotational::Eccentricity(_)) => {
            (Prescribed { force: Some(force), moment: Some(moment) }, true)
        }
    }
}
