//! How the answer changes with roughness, modulus and load.

use serde::Serialize;

use crate::{Contact, Error, ErrorKind, Problem, Rotational, Roughness, Vertical};

/// Relative step of the difference quotients; twice and four times it serve the extrapolation.
const STEP: f64 = 1e-3;

/// Derivatives of the answer, estimated by central differences of complete solves.
///
/// What [`held`](Self::held) names stays as it is, and so do profile and geometry. The settlement is that in its gauge. Where an edge of the contact
/// is just about to move or the largest pressure to change its place, a derivative has two sides, and its error is as large as their difference.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sensitivities {
    /// Always an estimate.
    pub kind: ErrorKind,
    /// `moment`, `eccentricity` or `tilt`: what the load keeps.
    pub held: &'static str,
    /// Of the settlement (m), or of the force (N/m) where the settlement is prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub settlement: Option<Derivatives>,
    /// Of the force (N/m), where the settlement is prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<Derivatives>,
    /// Of the tilt (rad), where it is not prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tilt: Option<Derivatives>,
    /// Of the largest pressure (Pa); without where that is infinite.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pressure_max: Option<Derivatives>,
    /// Of the width of contact (m).
    pub contact_width: Derivatives,
}

impl Sensitivities {
    /// Whether no derivative overflowed.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let Self { settlement, force, tilt, pressure_max, contact_width, .. } = self;
        let all = [*settlement, *force, *tilt, *pressure_max, Some(*contact_width)];
        all.into_iter().flatten().all(|derivatives| derivatives.is_finite())
    }
}

impl Derivatives {
    fn is_finite(&self) -> bool {
        let Self { roughness, young_modulus, theta0, force, settlement, error } = *self;
        let all = [roughness, young_modulus, theta0, force, settlement, Some(error)];
        all.into_iter().flatten().all(f64::is_finite)
    }
}

/// Derivatives of one quantity, SI units; of a dimensionless problem without units.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Derivatives {
    /// With respect to `chi` (m/Pa) or the coefficient `B` (m/Pa^kappa).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roughness: Option<f64>,
    /// With respect to Young's modulus of the foundation (Pa).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub young_modulus: Option<f64>,
    /// With respect to `theta0`, of a dimensionless problem.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub theta0: Option<f64>,
    /// With respect to the force (N/m), where it is prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
    /// With respect to the settlement (m), where it is prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub settlement: Option<f64>,
    /// Largest estimated error, relative to the largest elasticity `|d ln q/d ln parameter|` of the quantity (or to 1, if that is larger).
    pub error: f64,
}

/// What is varied.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Parameter {
    Roughness,
    YoungModulus,
    Theta0,
    Vertical,
}

/// The quantities followed.
const QUANTITIES: usize = 5;
type Values = [f64; QUANTITIES];

impl Contact {
    /// How settlement (or force), tilt, largest pressure and width change with roughness, Young's modulus and the prescribed force (or settlement): by
    /// central differences on complete solves, six for each parameter, extrapolated twice.
    ///
    /// # Errors
    /// What [`Problem::solve`] says of a neighbouring problem.
    pub fn sensitivities(&self) -> Result<Sensitivities, Error> {
        let mut found = [Derivatives::default(); QUANTITIES];
        let values = values(self);
        for parameter in parameters(self.problem()) {
            let (at, step) = self.parameter(parameter);
            let derivatives = self.derivatives(parameter, at, step)?;
            for (k, (value, error)) in derivatives.into_iter().enumerate() {
                let slot = &mut found[k];
                match (parameter, self.problem().load().vertical) {
                    (Parameter::Roughness, _) => slot.roughness = Some(value),
                    (Parameter::YoungModulus, _) => slot.young_modulus = Some(value),
                    (Parameter::Theta0, _) => slot.theta0 = Some(value),
                    (Parameter::Vertical, Vertical::Force(_)) => slot.force = Some(value),
                    (Parameter::Vertical, Vertical::Settlement(_)) => slot.settlement = Some(value),
                }
                let size = values[k].abs().max((value * at).abs()).max(f64::MIN_POSITIVE);
                slot.error = slot.error.max(error * step / STEP / size);
            }
        }
        let [settlement, force, tilt, pressure_max, contact_width] = found;
        let load = self.problem().load();
        let by_force = matches!(load.vertical, Vertical::Force(_));
        let by_tilt = matches!(load.rotational, Rotational::Tilt(_));
        Ok(Sensitivities {
            kind: ErrorKind::Estimate,
            held: match load.rotational {
                Rotational::Moment(_) => "moment",
                Rotational::Eccentricity(_) => "eccentricity",
                Rotational::Tilt(_) => "tilt",
            },
            settlement: by_force.then_some(settlement),
            force: (!by_force).then_some(force),
            tilt: (!by_tilt).then_some(tilt),
            pressure_max: self.peak_pressure().0.is_finite().then_some(pressure_max),
            contact_width,
        })
    }

    /// The value of a parameter, and the step by which it is varied.
    fn parameter(&self, parameter: Parameter) -> (f64, f64) {
        let frame = self.problem().frame();
        let value = match parameter {
            Parameter::Roughness => match frame.scaling().map(crate::Scaling::roughness) {
                Some(Roughness::Linear { compliance }) => compliance,
                Some(Roughness::Power { coefficient, .. }) => coefficient,
                Some(Roughness::Smooth) | None => 0.0,
            },
            Parameter::YoungModulus => frame.scaling().map_or(1.0, crate::Scaling::pressure),
            Parameter::Theta0 => frame.theta0(),
            Parameter::Vertical => match self.problem().load().vertical {
                Vertical::Force(value) | Vertical::Settlement(value) => value,
            },
        };
        // A load of zero is varied by what its answer is about.
        let stiffness = self.stiffness().force_settlement;
        let size = match (parameter, self.problem().load().vertical) {
            (Parameter::Vertical, Vertical::Force(_)) if value == 0.0 => {
                stiffness * self.settlement().abs()
            }
            (Parameter::Vertical, Vertical::Settlement(_)) if value == 0.0 => {
                self.force().abs() / stiffness
            }
            _ => value.abs(),
        };
        (value, STEP * if size > 0.0 { size } else { 1.0 })
    }

    fn varied(&self, parameter: Parameter, value: f64) -> Result<Problem, Error> {
        let problem = self.problem();
        match parameter {
            Parameter::Roughness => {
                let exponent = match problem.frame().scaling().map(crate::Scaling::roughness) {
                    Some(Roughness::Power { exponent, .. }) => exponent,
                    _ => 1.0,
                };
                problem.with_roughness(Roughness::power(value, exponent)?)
            }
            Parameter::YoungModulus => problem.with_young_modulus(value),
            Parameter::Theta0 => problem.with_frame(problem.frame().with_theta0(value)?),
            Parameter::Vertical => problem.with_vertical(match problem.load().vertical {
                Vertical::Force(_) => Vertical::Force(value),
                Vertical::Settlement(_) => Vertical::Settlement(value),
            }),
        }
    }

    /// Derivatives with their errors: quotients `D(h), D(2h), D(4h)` with errors in even powers of `h`, extrapolated.
    fn derivatives(
        &self,
        parameter: Parameter,
        at: f64,
        step: f64,
    ) -> Result<[(f64, f64); QUANTITIES], Error> {
        let quotient = |step: f64| -> Result<Values, Error> {
            let solved = |value: f64| self.varied(parameter, value)?.solve().map(|c| values(&c));
            let (left, right) = (solved(at - step)?, solved(at + step)?);
            Ok(std::array::from_fn(|k| (right[k] - left[k]) / (2.0 * step)))
        };
        let [one, two, four] = [quotient(step)?, quotient(2.0 * step)?, quotient(4.0 * step)?];
        Ok(std::array::from_fn(|k| {
            let (fine, coarse) = ((4.0 * one[k] - two[k]) / 3.0, (4.0 * two[k] - four[k]) / 3.0);
            let best = (16.0 * fine - coarse) / 15.0;
            (best, (best - fine).abs())
        }))
    }
}

fn parameters(problem: &Problem) -> Vec<Parameter> {
    let frame = problem.frame();
    let mut parameters = match frame.scaling() {
        None if frame.theta0() > 0.0 => vec![Parameter::Theta0],
        None => vec![],
        Some(scaling) if scaling.roughness() == Roughness::Smooth => vec![Parameter::YoungModulus],
        Some(_) => vec![Parameter::Roughness, Parameter::YoungModulus],
    };
    parameters.push(Parameter::Vertical);
    parameters
}

fn values(contact: &Contact) -> Values {
    [
        contact.settlement(),
        contact.force(),
        contact.tilt(),
        contact.peak_pressure().0,
        contact.contact_width(),
    ]
}
