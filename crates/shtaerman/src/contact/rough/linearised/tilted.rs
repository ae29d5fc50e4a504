//! The tilt of a circular punch to first order.

use std::f64::consts::PI;

use fredholm::SincOperator;

use super::super::answer::Tilted;
use super::super::base::Base;
use super::super::solved::Solved;
use crate::contact::rates::{Linearised, Rates};
use crate::{Rotational, Vertical};

/// What the tilt adds to the first-order change of the pressure without angle; the peak is a place on the diameter.
///
/// The unit pressure `q` of `q + theta W_1 q = r` turns by `T = pi int q r^2 dr`, and with `ln theta` by `T' = -pi int q theta W_1 q r dr`: the operator is symmetric.
pub(super) fn turned(
    base: &Base<'_>,
    solved: &Solved,
    tilted: &Tilted,
    mut even: Linearised,
    peak: f64,
) -> Option<Linearised> {
    let Tilted { unit, tilt, kernel } = tilted;
    let parameter = unit.parameter();
    let operator = SincOperator::new(kernel.as_ref(), unit.values().len() / 2).ok()?;
    let right: Vec<f64> = unit.potential().iter().map(|u| -parameter * u).collect();
    let changed = operator.factor(parameter).ok()?.solve(&right).ok()?;
    let turning = PI * unit.integral(|r| r);
    let masses = unit.node_masses().iter().zip(&right);
    let turning_rate = PI * masses.map(|(mass, g)| mass * g).sum::<f64>();
    let (r, sign) = (peak.abs(), if peak < 0.0 { -1.0 } else { 1.0 });
    let elastic = -parameter * unit.evaluate_potential(r);
    let pressures = [unit.evaluate(r, r), changed.evaluate(r, elastic)];
    let [by_body, by_vertical, by_rotational] = &mut even.rates;
    let arm = match base.problem.dimensionless_load().rotational {
        Rotational::Moment(_) => {
            by_rotational[2] = -1.0 / turning;
            0.0
        }
        Rotational::Tilt(_) => {
            by_rotational[2] = 1.0;
            f64::NAN
        }
        Rotational::Eccentricity(e) => e,
    };
    if !arm.is_nan() {
        let force = |rates: &Rates| match base.load.vertical {
            Vertical::Force(_) => 0.0,
            Vertical::Settlement(_) => rates[1],
        };
        let given = if matches!(base.load.vertical, Vertical::Force(_)) { 1.0 } else { 0.0 };
        by_body[2] = -(arm * force(by_body) + tilt * turning_rate) / turning;
        by_vertical[2] = -arm * (force(by_vertical) + given) / turning;
    }
    by_body[3] -= sign * tilt * pressures[1];
    for rates in &mut even.rates {
        rates[3] -= sign * rates[2] * pressures[0];
    }
    // As near as the unit pressure is known to its own moment.
    let size = solved.rounding() / solved.deepest();
    for (rates, errors) in even.rates.iter().zip(&mut even.errors) {
        errors[2] += size * rates[2].abs();
        errors[3] += size * rates[3].abs();
    }
    Some(even)
}
