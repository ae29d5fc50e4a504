//! The roughness behind a measured settlement or width.

use super::search::{Range, Search};
use super::{Found, Goal, InverseError};
use crate::{Error, Problem, Roughness, Vertical};

/// The values of `chi E*/a` within which it is looked for.
const RANGE: [f64; 2] = [1e-8, 1e12];

/// The compliance `chi` (m/Pa), or the coefficient `B` (m/Pa^kappa) of a power law, with which the contact has the settlement, the width or the peak
/// pressure wanted under the load of the problem.
///
/// Looked for where the layer under the mean pressure gives `1e-8` to `1e12` of what it would at `chi = a/E*`; of a smooth surface the linear law is meant.
/// Where several values fit, it is the one nearest to that of the problem.
///
/// # Errors
/// [`Error::InvalidValue`] for a goal out of range; [`Error::Inverse`] when no roughness reaches it, with the attainable range, for a
/// dimensionless problem, and for the settlement as goal where the load prescribes it.
pub fn roughness(problem: &Problem, goal: Goal) -> Result<Found, Error> {
    goal.check()?;
    let prescribed = matches!(problem.load().vertical, Vertical::Settlement(_));
    if matches!(goal, Goal::Settlement(_)) && prescribed {
        let words = "the load prescribes the settlement: the roughness behind a measured settlement needs the force in [load]";
        return Err(InverseError::Unsuited(words).into());
    }
    let Some(scaling) = problem.bodies().scaling() else {
        let words = "a dimensionless problem has no roughness to be found: it is the scale of its displacements";
        return Err(InverseError::Unsuited(words).into());
    };
    let layer = scaling.roughness().coefficients();
    let exponent = layer.map_or(1.0, |(_, exponent)| exponent);
    // B p^kappa = chi p at the mean pressure.
    let chi = scaling.half_width() / scaling.contact_modulus();
    let pressure = match problem.load().vertical {
        Vertical::Force(force) => 0.5 * force.abs() / scaling.force() * scaling.pressure(),
        Vertical::Settlement(_) => scaling.contact_modulus() * 1e-3,
    };
    let unit = chi * pressure.powf(1.0 - exponent);
    let ends = RANGE.map(|share| share * unit);
    let start = layer.map_or(unit, |(coefficient, _)| coefficient).clamp(ends[0], ends[1]);
    let posed = |coefficient: f64| problem.with_roughness(Roughness::power(coefficient, exponent)?);
    Search { unknown: "roughness", goal, posed: &posed }.run(Range { start, ends })
}
