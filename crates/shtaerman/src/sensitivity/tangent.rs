//! Sensitivities by the linearised equation.
//!
//! Without dimensions a contact depends on `theta0`, the load and the profile. Its equations keep their form when pressures are scaled by `c`, displacements by
//! `c^kappa` and `theta0` by `c^(kappa-1)`, so that derivatives by the scale of the profile follow, and with them those by all units: with `D q` the derivative
//! by `ln theta0` under the same dimensionless load
//!
//! `dq/d ln E = -s D q`, `dq/d ln B = (F q - w q - D q)/kappa`,
//!
//! `s = -d ln theta/d ln E`, 1 for a rigid punch, `F q` the sum of the derivatives by the logarithms of the prescribed force and moment, `w` 1 for pressures,
//! forces and moments, 0 for displacements and lengths. By the scale of the profile itself, with `G q` the sum of the derivatives by the logarithms of the prescribed settlement and
//! tilt, and now `w = kappa` for displacements,
//!
//! `dq/d ln f = (w q - F q + (1 - kappa) D q)/kappa - G q`.

use super::{Derivatives, QUANTITIES, Sensitivities, Values, errors, values};
use crate::bodies::Bodies;
use crate::contact::{Linearised, Rates};
use crate::{Contact, Layering, Scaling, Vertical};

/// Settlement, force, pressure and width among the quantities followed.
const SETTLEMENT: usize = 0;
const FORCE: usize = 1;
const PRESSURE: usize = 3;
const WIDTH: usize = 4;

impl Contact {
    /// The [sensitivities](Self::sensitivities) by the linearised equation alone, for little more than a step of Newton's method; `None` where only
    /// differences of solutions tell: on cells, under a coating, and at corners of strongly graded ground.
    #[must_use]
    pub fn tangent_sensitivities(&self) -> Option<Sensitivities> {
        // A stiffer foundation under the same coating has another kernel.
        if matches!(self.problem().bodies().layering(), Some(Layering::Coating { .. })) {
            return None;
        }
        let found = self.linearised()?;
        let units = Units::new(self);
        let mut derivatives = [Derivatives::default(); QUANTITIES];
        // No derivative is known better than the solution.
        let floor = self.known_to();
        let stated = self.stated();
        let (values, errors) = (values(&stated), errors(&stated));
        for (k, slot) in derivatives.iter_mut().enumerate() {
            units.fill(slot, k, &found, [values[k], errors[k]], floor);
        }
        let sensitivities = Sensitivities::assembled(self, derivatives);
        sensitivities.is_finite().then_some(sensitivities)
    }
}

/// A derivative and its estimated error.
type Estimated = [f64; 2];

/// What a contact is measured in.
struct Units<'c> {
    contact: &'c Contact,
    quantities: Values,
}

impl<'c> Units<'c> {
    fn new(contact: &'c Contact) -> Self {
        let bodies = contact.problem().bodies();
        let units: [fn(&Scaling) -> f64; QUANTITIES] = [
            Scaling::displacement,
            Scaling::force,
            Scaling::angle,
            Scaling::pressure,
            Scaling::half_width,
        ];
        Self { contact, quantities: units.map(|unit| bodies.unit(unit)) }
    }

    /// The derivatives of a quantity by all parameters.
    fn fill(
        &self,
        slot: &mut Derivatives,
        k: usize,
        found: &Linearised,
        [value, value_error]: Estimated,
        floor: f64,
    ) {
        let load = self.contact.problem().load();
        let unit = self.quantities[k];
        let body = [unit * found.rates[0][k], unit * found.errors[0][k]];
        let mut elasticities: Vec<Estimated> = Vec::new();
        let vertical =
            |scale: f64| [found.rates[1][k], found.errors[1][k]].map(|part| unit / scale * part);
        let at = match load.vertical {
            Vertical::Force(force) => {
                let by = vertical(self.quantities[FORCE]);
                slot.force = Some(by[0]);
                by.map(|part| part * force)
            }
            Vertical::Settlement(settlement) => {
                let by = vertical(self.quantities[SETTLEMENT]);
                slot.settlement = Some(by[0]);
                by.map(|part| part * settlement)
            }
        };
        elasticities.push(at);
        match self.contact.problem().bodies() {
            Bodies::Dimensionless { theta0, .. } if *theta0 > 0.0 => {
                slot.theta0 = Some(body[0] / theta0);
                elasticities.push(body);
            }
            Bodies::Dimensionless { .. } => {}
            Bodies::Physical { foundation, scaling, .. } => {
                let share = scaling.contact_modulus() / foundation.plane_strain_modulus();
                let modulus = self.contact.problem().bodies().stated_modulus();
                slot.young_modulus = Some(-share * body[0] / modulus);
                elasticities.push(body.map(|part| share * part));
                if let Some((coefficient, exponent)) = scaling.roughness().coefficients() {
                    let layer = self.by_layer(k, found, value, body, exponent);
                    slot.roughness = Some(layer[0] / coefficient);
                    elasticities.push(layer);
                }
            }
        }
        let [profile, profile_error] = self.by_profile(k, found, value, body);
        slot.profile = Some(profile);
        elasticities.push([0.0, profile_error]);
        let size = (elasticities.iter())
            .fold(value.abs(), |most, [rate, _]| most.max(rate.abs()))
            .max(f64::MIN_POSITIVE);
        let error = elasticities.iter().fold(0.0f64, |most, [_, error]| most.max(error.abs()));
        slot.error = (error.max(value_error) / size).max(floor);
    }

    /// By the logarithm of the coefficient of the layer.
    fn by_layer(
        &self,
        k: usize,
        found: &Linearised,
        value: f64,
        body: Estimated,
        exponent: f64,
    ) -> Estimated {
        let [vertical, rotational] = self.contact.problem().dimensionless_load().forces();
        let of = |rates: &[Rates; 3]| vertical * rates[1][k] + rotational * rates[2][k];
        let sizes = found.errors.map(|rates| rates.map(f64::abs));
        let unit = self.quantities[k];
        let own = if k == FORCE || k == PRESSURE { value } else { 0.0 };
        let error =
            unit * (vertical.abs() * sizes[1][k] + rotational.abs() * sizes[2][k]) + body[1].abs();
        [(unit * of(&found.rates) - own - body[0]) / exponent, error / exponent]
    }

    /// By the logarithm of the scale of the profile.
    fn by_profile(&self, k: usize, found: &Linearised, value: f64, body: Estimated) -> Estimated {
        let exponent = self.contact.problem().foundation().law().exponent().unwrap_or(1.0);
        let unit = self.quantities[k];
        let sum = |[vertical, rotational]: [f64; 2], rates: &[Rates; 3]| {
            unit * (vertical * rates[1][k] + rotational * rates[2][k])
        };
        let sizes = found.errors.map(|rates| rates.map(f64::abs));
        let load = self.contact.problem().dimensionless_load();
        let (forces, displacements) = (load.forces(), load.displacements());
        let weight = match k {
            FORCE | PRESSURE => 1.0,
            WIDTH => 0.0,
            _ => exponent,
        };
        let [by_forces, by_displacements] = [forces, displacements].map(|l| sum(l, &found.rates));
        let rate = (weight * value - by_forces + (1.0 - exponent) * body[0]) / exponent;
        let error = (sum(forces.map(f64::abs), &sizes) + (1.0 - exponent) * body[1].abs())
            / exponent
            + sum(displacements.map(f64::abs), &sizes);
        [rate - by_displacements, error]
    }
}
