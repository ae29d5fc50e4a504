//! The audit of an answer: its errors from its own residual, whatever way it was found.
//!
//! The book's chapter *The audit* has the theorem and its proof; the crate `shtaerman-audit` carries it out on plain numbers. Here a contact is handed to it.

use serde::Serialize;
use shtaerman_audit::{Answer, Bound, DiskProblem, Prescribed, Refusal};

use super::ground::SHARP;
use super::parts::{DEGREE, RESOLVED};
use super::posed::{GRADED, Posed, posed};
use super::promise::ROUGHEST;
use super::unaudited::Unaudited;
use super::{Accuracy, ErrorKind};
use crate::audited::{EnclosedBase, prescribed};
use crate::rounding::OF_A_VALUE;
use crate::{Contact, ContactKind, Error, Rotational};

/// On ground that is graded to [`SHARP`] bounds at a place follow from the mean with large factors: one so large that it would be no answer is not given where the mean is known to so much.
const IN_THE_MEAN: f64 = 1e-3;

/// What the audit found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Audit {
    /// Bound or estimate.
    pub kind: ErrorKind,
    /// The error of the pressure in the mean square over the base, without dimensions; `None` where a layer that bends leaves none that is finite.
    pub mean_square: Option<f64>,
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

/// A way to bound the errors of an answer.
type Auditor = fn(&shtaerman_audit::Problem<'_>, &Answer<'_>) -> Result<Bound, Refusal>;

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
        self.audit_as(auditor, &posed(self.solved())?)
    }

    /// The audit of this answer to what is posed.
    fn audit_as(&self, auditor: Auditor, posed: &Posed) -> Result<Audit, Unaudited> {
        // Heights are counted from the level from which they were solved: that loses no digits, and changes nothing but the settlement.
        let problem = self.solved();
        let (settlement, level) = self.solved_settlement();
        let bare = self.dimensionless();
        let bodies = problem.bodies();
        let load = problem.dimensionless_load();
        let (prescribed, is_load_own) = prescribed(&load, bare.force(), bare.moment());
        // A wave cannot tilt, and what is its own mirror image does not.
        let is_symmetric = problem.is_symmetric();
        let is_level = problem.is_wave() || is_symmetric;
        let prescribed =
            if is_level { Prescribed { moment: None, ..prescribed } } else { prescribed };
        let zones = bare.zones();
        let zones = if problem.is_wave() { within_period(&zones) } else { zones };
        let cuts = problem.profile().joints(bodies.half_width()).into_iter();
        let cuts = crate::order::ascending(cuts.chain(problem.resolution(DEGREE, RESOLVED).joints));
        let pressure = |xi: f64| self.pressure_at(xi);
        let answer = Answer {
            zones: &zones,
            pressure: &pressure,
            settlement,
            tilt: bare.tilt(),
            force: bare.force(),
            moment: bare.moment(),
        };
        let (bound, is_bound) = self.bound(auditor, posed, (prescribed, &cuts), &answer)?;
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
        if !accuracy.is_finite() || !bound.residual.is_finite() {
            return Err(if posed.is_bound() {
                Unaudited::NotFinite
            } else {
                Unaudited::NOT_ESTIMATED
            });
        }
        Ok(Audit {
            kind,
            mean_square: Some(bound.mean_square).filter(|error| error.is_finite()),
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
    crate::order::sort_by_number(&mut found, |a| a[0]);
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
        let bodies = problem.bodies();
        let scaled = |size: f64| if bodies.scaling().is_some() { size } else { 0.0 };
        let is_bilateral = problem.solver().contact == ContactKind::Bilateral;
        let profile = &EnclosedBase(problem);
        let pieces = bodies.pieces();
        let plane = |kernel, ground, strength: f64, size| shtaerman_audit::Problem {
            kernel,
            ground,
            theta: strength * bodies.theta0(),
            scaled: scaled(size),
            pieces: &pieces,
            is_bilateral,
            prescribed,
            profile,
            cuts,
        };
        let found = match posed {
            Posed::Layered(ground, strength) => {
                auditor(&plane(ground.kernel(), Some(&**ground), *strength, OF_A_VALUE), answer)
            }
            Posed::Plane(kernel, size, layer) if *layer < 1.0 => {
                let posed = plane(**kernel, None, 1.0, *size);
                shtaerman_audit::audit_bent(&posed, *layer, self.tangent(), answer)
            }
            Posed::Plane(kernel, size, _) => auditor(&plane(**kernel, None, 1.0, *size), answer),
            &Posed::Disk(exponent, layer) => {
                let posed = DiskProblem {
                    exponent,
                    theta: bodies.theta0(),
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
        let is_enough = posed.exponent() < SHARP || bound.pressure <= ROUGHEST * largest;
        let in_the_mean = Unaudited::InTheMeanOnly { mean_square };
        match posed {
            _ if !is_enough && mean_square < IN_THE_MEAN => Err(in_the_mean),
            // A linear layer in the plane has its mean bounded sharply: it is no better known.
            Posed::Disk(..) | Posed::Plane(_, _, ..1.0) if !is_enough => Err(Unaudited::TOO_SHARP),
            _ => Ok((bound, posed.is_bound())),
        }
    }

    /// The tangent stiffness without dimensions. Of a wave, which is infinitely stiff against tilt, nothing follows from the coupling.
    fn tangent(&self) -> [[f64; 2]; 2] {
        let [[k11, k12], [_, k22]] = self.dimensionless().stiffness().matrix();
        let k12 = if self.problem().is_wave() { 0.0 } else { k12 };
        [[k11, k12], [k12, k22]]
    }

    /// What the errors of the contact under the answer's own force become at the settlement prescribed, from which that contact is off by `missed`: to first order, by the tangent
    /// stiffness along `M = e P`, `-alpha = -(k12 - e k11)/(k22 - e k12) delta`. An estimate.
    fn at_settlement(&self, under_own_force: Accuracy, missed: f64, e: f64) -> Accuracy {
        let [[k11, k12], [_, k22]] = self.tangent();
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

    /// The same with the errors of its [audit](Contact::audit) in place of those its method states, or the reason why there is none; held against nothing.
    #[must_use]
    pub fn with_audit(mut self) -> Self {
        let audit = self.audit();
        self.set_audit(audit);
        self
    }

    /// The answer with the errors of its [audit](Contact::audit) in place of those its method states, where the theorem covers it; otherwise as it is, with the reason kept.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] where the audited error is above an explicit tolerance, [`Error::NotBounded`] where it is above 1 % and neither a tolerance nor a degree was
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
        let kept = self.require_tolerance();
        kept.map_err(|error| error.of_audit(self.solution().relative_error()))?;
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Foundation, LayerBase, Layering, Load, Problem, Profile, Punch, Vertical};

    fn contact(thickness: f64, vertical: Vertical) -> Contact {
        let layering =
            Layering::layer(thickness, LayerBase::Bonded { poisson_ratio: 0.3 }).unwrap();
        let foundation = Foundation::dimensionless(4.0).unwrap().with_layering(layering);
        let profile = Profile::expression("x^2 + 0.1*sin(3*x)").unwrap();
        let punch = Punch::new(1.0).unwrap().with_profile(profile);
        let load = Load::new(vertical, Rotational::Moment(0.02)).unwrap();
        Problem::new(foundation, punch, load).unwrap().solve().unwrap()
    }

    /// The answer on one layer is wrong on another, by what the answer there tells; the audit sees it, at both kinds of loads and however thin the difference.
    #[test]
    fn answers_on_another_layer_are_seen() {
        for vertical in [Vertical::Force(0.6), Vertical::Settlement(0.9)] {
            for off in [1e-2, 1e-5, 1e-8] {
                let (one, other) = (contact(0.7, vertical), contact(0.7 * (1.0 + off), vertical));
                let audit =
                    one.audit_as(shtaerman_audit::audit, &posed(other.solved()).unwrap()).unwrap();
                let bare = [&one, &other].map(Contact::dimensionless);
                let apart = |value: fn(&Contact) -> f64| (value(&bare[0]) - value(&bare[1])).abs();
                let places = (0..=40).map(|i| f64::from(i) / 20.0 - 1.0);
                let pressure = places
                    .map(|x| (one.pressure_at(x) - other.pressure_at(x)).abs())
                    .fold(0.0, f64::max);
                let found = audit.accuracy;
                for (stated, actual) in [
                    (found.pressure, pressure),
                    (found.settlement, apart(Contact::settlement)),
                    (found.tilt, apart(Contact::tilt)),
                    (found.force, apart(Contact::force)),
                ] {
                    assert!(stated >= actual, "{vertical:?} {off:e}: {stated:e} {actual:e}");
                }
                assert!(pressure > 1e-3 * off, "{pressure:e}");
                // Sharp enough to be of use.
                assert!(found.pressure < 1e3 * pressure, "{:e} {pressure:e}", found.pressure);
            }
        }
    }
}
