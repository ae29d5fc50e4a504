//! Sensitivities by central differences of complete solves.

use super::{Derivatives, QUANTITIES, Sensitivities, Values, errors, values};
use crate::bodies::Bodies;
use crate::{Contact, Error, Problem, Roughness, Vertical};

/// Relative step of the difference quotients; twice and four times it serve the extrapolation.
const STEP: f64 = 1e-3;
/// What is off in the result over how much the two quotients that are extrapolated differ, where answers on one side of the parameter are all off by the same, as those of another number of nodes: 31/15
/// (theory). What the last extrapolation changes is a thirtieth of that.
const OFF_ON_ONE_SIDE: f64 = 31.0 / 15.0;
/// What is off in the result, times the step, over what is off in each of the answers, where nothing is said of how that goes with the parameter: the sum of the sizes of the weights of
/// `D(h), D(2h), D(4h)`, 64/45, 20/45 and 1/45, over 1, 2 and 4 (theory).
const OFF_IN_ANSWERS: f64 = 64.0 / 45.0 + 10.0 / 45.0 + 0.25 / 45.0;

/// What is varied.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Parameter {
    Roughness,
    YoungModulus,
    Theta0,
    Vertical,
}

impl Contact {
    /// The [sensitivities](Self::sensitivities) by central differences on complete solves, six for each parameter, extrapolated twice: independent of the linearised
    /// equation, and for every method.
    ///
    /// # Errors
    /// What [`Problem::solve`] says of a neighbouring problem.
    pub fn difference_sensitivities(&self) -> Result<Sensitivities, Error> {
        if !self.is_as_stated() {
            return self.stated().difference_sensitivities();
        }
        // What is off in all of the answers alike shows in no difference, what is not counts for much more: under kinks of a base the error goes as the modes, many waves to a change of the load.
        let floor = Derivatives { error: self.known_to(), ..Derivatives::default() };
        let mut found = [floor; QUANTITIES];
        let (values, mut errors) = (values(self), errors(self));
        let of_ends = self.error().and_then(|known| known.zones).unwrap_or(0.0);
        errors[QUANTITIES - 1] = 2.0 * self.zones().len() as f64 * of_ends;
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
                slot.error =
                    slot.error.max((error * step + OFF_IN_ANSWERS * errors[k]) / STEP / size);
            }
        }
        Ok(Sensitivities::assembled(self, found))
    }

    /// The value of a parameter, and the step by which it is varied.
    fn parameter(&self, parameter: Parameter) -> (f64, f64) {
        let bodies = self.problem().bodies();
        let value = match parameter {
            Parameter::Roughness => layer(bodies).map_or(0.0, |(coefficient, _)| coefficient),
            Parameter::YoungModulus => bodies.stated_modulus(),
            Parameter::Theta0 => bodies.theta0(),
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
                let exponent = layer(problem.bodies()).map_or(1.0, |(_, exponent)| exponent);
                problem.with_roughness(Roughness::power(value, exponent)?)
            }
            Parameter::YoungModulus => problem.with_young_modulus(value),
            Parameter::Theta0 => problem.with_theta0(value),
            Parameter::Vertical => {
                problem.with_vertical(problem.load().vertical.mapped(|_| value, |_| value))
            }
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
            (best, OFF_ON_ONE_SIDE * (fine - coarse).abs())
        }))
    }
}

/// `B` and `kappa` of a physical problem with a layer.
fn layer(bodies: &Bodies) -> Option<(f64, f64)> {
    bodies.scaling()?.roughness().coefficients()
}

fn parameters(problem: &Problem) -> Vec<Parameter> {
    let bodies = problem.bodies();
    let mut parameters = match bodies.scaling() {
        None if bodies.theta0() > 0.0 => vec![Parameter::Theta0],
        None => vec![],
        Some(scaling) if scaling.roughness() == Roughness::Smooth => vec![Parameter::YoungModulus],
        Some(_) => vec![Parameter::Roughness, Parameter::YoungModulus],
    };
    parameters.push(Parameter::Vertical);
    parameters
}
