//! The tilt of a circular punch: the pressure `p1(r) cos(phi)` beside that without angle.
//!
//! `p1 + pi theta0 int W_1(r, s) p1 s ds = -alpha0 r`, `W_1 = int_0^inf t^mu J_1(r t) J_1(s t) dt`, `mu` that of a graded body, `M0 = pi int p1 r^2 dr`: on the zones of the pressure
//! without angle, and on its nodes.

use std::f64::consts::PI;
use std::sync::Arc;

use fredholm::{SincOperator, SincSolution};

use super::base::Base;
use super::nodes::{Field, PLACES, between_nodes};
use super::solved::{Solved, largest};
use crate::contact::accuracy::{Accuracy, SAFETY};
use crate::contact::ground::SharedKernel;
use crate::contact::rates::{Linearised, Rates};
use crate::contact::search::ALLOWED;
use crate::contact::stiffness::Stiffness;
use crate::error::require;
use crate::{Error, Rotational, Vertical};

/// The pressure `p1(r) cos(phi)` of a tilted circular punch that touches all over.
#[derive(Debug, Clone)]
pub(super) struct Tilted {
    /// For `-alpha0 = 1`.
    unit: Unit,
    /// What it changes by with `ln theta0`.
    changed: SincSolution,
    /// `alpha0`.
    tilt: f64,
    /// What is prescribed of it.
    given: Rotational,
    kernel: SharedKernel,
}

/// The pressure `q` of `q + theta W_1 (dp0/dv q) = r`.
#[derive(Debug, Clone)]
struct Unit {
    solution: SincSolution,
    /// `dM0/d(-alpha0)`.
    turning: f64,
}

impl Unit {
    /// On the nodes of a solution, with what it changes by if `theta` does as `ln theta`.
    fn new<F: Field>(
        base: &Base,
        solved: &Solved<F>,
        kernel: &SharedKernel,
    ) -> Result<(Self, SincSolution), Error> {
        let hull = &solved.nodes.frame.hull;
        let panels = solved.nodes.panels.iter();
        let panels: Vec<(f64, f64)> =
            panels.map(|[left, right]| (left / hull.half, (right / hull.half).min(1.0))).collect();
        let half_count = solved.nodes.a_panel() / 2;
        let known = match panels[..] {
            [(0.0, 1.0)] => base.ground.known_turned_operator(half_count).transpose()?,
            _ => None,
        };
        let operator = match known {
            Some(operator) => operator,
            None => {
                let grid = base.ground.grid(half_count)?;
                Arc::new(SincOperator::on_panels(kernel.as_ref(), grid, &panels)?)
            }
        };
        let slopes: Vec<f64> = solved.given.iter().map(|v| base.layer.slope(*v)).collect();
        let parameter = solved.strength * base.ground.scale(hull);
        let factor = operator.factor_weighted(parameter, &slopes)?;
        let solution = factor.solve(&operator.sample(|y| y)?)?;
        let body: Vec<f64> = solution.potential().iter().map(|u| -parameter * u).collect();
        // r = half y in the lever, in the moment and twice in the area
        let turning = PI * hull.half.powi(4) * solution.integral(|y| y);
        Ok((Self { solution, turning }, factor.solve(&body)?))
    }
}

/// What a circular punch adds to a solution without angle: tilt and moment with their errors, the stiffness against tilt, and a pressure if it tilts.
///
/// # Errors
/// [`Error::LiftsOff`] where it lifts off, [`Error::InvalidValue`] for a tilt on a power law; those of the equation.
pub(super) fn turned<F: Field>(
    base: &Base,
    solved: &mut Solved<F>,
    stiffness: &mut Stiffness,
) -> Result<Option<Tilted>, Error> {
    let Some(kernel) = base.ground.turned_kernel()? else { return Ok(None) };
    let (field, value) = base.problem().load().rotational.named();
    let (unit, changed) = Unit::new(base, solved, &kernel)?;
    stiffness.moment_tilt = unit.turning;
    if value == 0.0 {
        return Ok(None);
    }
    let needed = "zero for a circular punch on a layer with a power law, which mixes the harmonics of the pressure";
    require(base.layer.is_linear(), field, value, needed)?;
    let given = base.surface.setting.load().rotational;
    let (turning, state) = (unit.turning, &mut solved.state);
    [state.tilt, state.moment] = given.turned(state.force, turning);
    let tilted = Tilted { unit, changed, tilt: state.tilt, given, kernel };
    if !base.is_bilateral {
        let [limit, tension] = tilted.tension(base, solved);
        let rounding = solved.rounding() + ALLOWED * solved.largest();
        if limit < 1.0 && tension > rounding {
            return Err(Error::LiftsOff { field, value, limit: limit * value.abs() });
        }
    }
    let coarse = solved.coarser.last().map(|coarse| Unit::new(base, coarse, &tilted.kernel));
    if let Some((coarse, _)) = coarse.transpose()? {
        solved.stated.accuracy = tilted.accuracy(solved, &coarse);
    }
    Ok(Some(tilted))
}

impl Tilted {
    /// `p1(r)`.
    pub(super) fn pressure(&self, r: f64) -> f64 {
        -self.tilt * self.unit.solution.evaluate(r, r)
    }

    /// The elastic displacement at `r` for `cos(phi) = 1`.
    pub(super) fn displacement(&self, r: f64) -> f64 {
        let unit = &self.unit.solution;
        let potential = if r <= 1.0 {
            unit.evaluate_potential(r)
        } else {
            unit.integral(|s| self.kernel.value(r, s))
        };
        -self.tilt * unit.parameter() * potential
    }

    /// The errors of a solution with those of the tilt, by the unit pressure on fewer nodes.
    fn accuracy<F: Field>(&self, solved: &Solved<F>, coarse: &Unit) -> Accuracy {
        let (tilt, moment) = (solved.state.tilt.abs(), solved.state.moment.abs());
        let Unit { solution: unit, turning } = &self.unit;
        let rounding = solved.rounding() / solved.deepest();
        let share = SAFETY * (turning - coarse.turning).abs() / turning + rounding;
        let off = |r: f64| (unit.evaluate(r, r) - coarse.solution.evaluate(r, r)).abs();
        let off = between_nodes(PLACES).map(|y| off(0.5 * (1.0 + y))).fold(0.0, f64::max);
        let size = largest(unit.values());
        let accuracy = solved.stated.accuracy;
        let pressure = accuracy.pressure + tilt * (SAFETY * off + (share + rounding) * size);
        let accuracy = Accuracy { pressure, ..accuracy };
        match self.given {
            Rotational::Tilt(_) => Accuracy { moment: moment * share, ..accuracy },
            Rotational::Moment(_) => Accuracy { tilt: tilt * share, ..accuracy },
            Rotational::Eccentricity(e) => {
                let moment = e.abs() * accuracy.force;
                Accuracy { moment, tilt: tilt * share + moment / turning, ..accuracy }
            }
        }
    }

    /// How much of the tilt keeps the whole base in contact, and the tension under all of it.
    fn tension<F: Field>(&self, base: &Base, solved: &Solved<F>) -> [f64; 2] {
        if !matches!(&solved.nodes.zones[..], [zone] if zone.ends == [0.0, 1.0]) {
            return [0.0, f64::INFINITY];
        }
        let places = between_nodes(PLACES).map(|y| 0.5 * (1.0 + y)).filter(|r| *r > 0.0);
        places.fold([f64::INFINITY, f64::NEG_INFINITY], |[share, tension], r| {
            let (even, odd) = (solved.pressure_at(r, base.height(r)), self.pressure(r).abs());
            [share.min(even.max(0.0) / odd), tension.max(odd - even)]
        })
    }

    /// The first-order change with what the tilt adds to that of the pressure without angle; the peak is a place on the diameter.
    ///
    /// With `ln theta` the unit pressure turns by `T' = -pi int q theta W_1 q r dr`: the operator is symmetric.
    pub(super) fn linearised<F: Field>(
        &self,
        solved: &Solved<F>,
        mut even: Linearised,
        by: Vertical,
        peak: f64,
    ) -> Linearised {
        let Self { unit: Unit { solution: unit, turning }, tilt, .. } = self;
        let masses = unit.node_masses().iter().zip(unit.potential());
        let turning_rate = -PI * unit.parameter() * masses.map(|(mass, u)| mass * u).sum::<f64>();
        let (r, sign) = (peak.abs(), if peak < 0.0 { -1.0 } else { 1.0 });
        let elastic = -unit.parameter() * unit.evaluate_potential(r);
        let [by_body, by_vertical, by_rotational] = &mut even.rates;
        let is_by_force = matches!(by, Vertical::Force(_));
        let force = |rates: &Rates| if is_by_force { 0.0 } else { rates[1] };
        let prescribed = if is_by_force { 1.0 } else { 0.0 };
        let mut by_force = |arm: f64| {
            by_body[2] = -(arm * force(by_body) + tilt * turning_rate) / turning;
            by_vertical[2] = -arm * (force(by_vertical) + prescribed) / turning;
        };
        match self.given {
            Rotational::Tilt(_) => by_rotational[2] = 1.0,
            Rotational::Moment(_) => {
                by_rotational[2] = -1.0 / turning;
                by_force(0.0);
            }
            Rotational::Eccentricity(e) => by_force(e),
        }
        even.rates[0][3] -= sign * tilt * self.changed.evaluate(r, elastic);
        // As near as the unit pressure is known to its own moment.
        let size = solved.rounding() / solved.deepest();
        for (rates, errors) in even.rates.iter_mut().zip(&mut even.errors) {
            rates[3] -= sign * rates[2] * unit.evaluate(r, r);
            errors[2] += size * rates[2].abs();
            errors[3] += size * rates[3].abs();
        }
        even
    }
}
