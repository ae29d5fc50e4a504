//! The tilt of a circular punch: the pressure `p1(r) cos(phi)` beside that without angle.
//!
//! `p1 + pi theta0 int W_1(r, s) p1 s ds = -alpha0 r`, `W_1 = int_0^inf t^mu J_1(r t) J_1(s t) dt`, `mu` that of a graded body, `M0 = pi int p1 r^2 dr`.

use std::f64::consts::PI;
use std::sync::Arc;

use fredholm::collocation::{Estimate, solve_adaptive};
use fredholm::{SincOperator, SincSolution};

use super::base::{Base, stated};
use super::nodes::{Field, between_nodes};
use super::solved::{Solved, largest};
use crate::contact::accuracy::Accuracy;
use crate::contact::ground::SharedKernel;
use crate::contact::rates::{Linearised, Rates};
use crate::contact::search::ALLOWED;
use crate::contact::stiffness::Stiffness;
use crate::solver::AIM;
use crate::{Error, Rotational, Vertical};

/// Places between axis and edge where tension is looked for.
const PLACES: usize = 128;

/// The pressure `p1(r) cos(phi)` of a tilted circular punch.
#[derive(Debug, Clone)]
pub(super) struct Tilted {
    /// For `-alpha0 = 1`.
    unit: SincSolution,
    /// `alpha0`.
    tilt: f64,
    /// What is prescribed of it.
    given: Rotational,
    kernel: SharedKernel,
}

impl Tilted {
    /// `p1(r)`.
    pub(super) fn pressure(&self, r: f64) -> f64 {
        -self.tilt * self.unit.evaluate(r, r)
    }

    /// The elastic displacement at `r` for `cos(phi) = 1`.
    pub(super) fn displacement(&self, r: f64) -> f64 {
        let potential = if r <= 1.0 {
            self.unit.evaluate_potential(r)
        } else {
            self.unit.integral(|s| self.kernel.value(r, s))
        };
        -self.tilt * self.unit.parameter() * potential
    }

    /// `dM0/d(-alpha0)`.
    fn turning(&self) -> f64 {
        PI * self.unit.integral(|r| r)
    }

    /// The first-order change with what the tilt adds to that of the pressure without angle; the peak is a place on the diameter.
    ///
    /// The unit pressure `q` of `q + theta W_1 q = r` turns by `T = pi int q r^2 dr`, and with `ln theta` by `T' = -pi int q theta W_1 q r dr`: the operator is symmetric.
    pub(super) fn linearised<F: Field>(
        &self,
        solved: &Solved<F>,
        mut even: Linearised,
        by: Vertical,
        peak: f64,
    ) -> Option<Linearised> {
        let Self { unit, tilt, kernel, .. } = self;
        let parameter = unit.parameter();
        let operator = SincOperator::new(kernel.as_ref(), unit.values().len() / 2).ok()?;
        let right: Vec<f64> = unit.potential().iter().map(|u| -parameter * u).collect();
        let changed = operator.factor(parameter).ok()?.solve(&right).ok()?;
        let turning = self.turning();
        let masses = unit.node_masses().iter().zip(&right);
        let turning_rate = PI * masses.map(|(mass, g)| mass * g).sum::<f64>();
        let (r, sign) = (peak.abs(), if peak < 0.0 { -1.0 } else { 1.0 });
        let elastic = -parameter * unit.evaluate_potential(r);
        let pressures = [unit.evaluate(r, r), changed.evaluate(r, elastic)];
        let [by_body, by_vertical, by_rotational] = &mut even.rates;
        let arm = match self.given {
            Rotational::Moment(_) => {
                by_rotational[2] = -1.0 / turning;
                Some(0.0)
            }
            Rotational::Tilt(_) => {
                by_rotational[2] = 1.0;
                None
            }
            Rotational::Eccentricity(e) => Some(e),
        };
        if let Some(arm) = arm {
            let is_by_force = matches!(by, Vertical::Force(_));
            let force = |rates: &Rates| if is_by_force { 0.0 } else { rates[1] };
            let given = if is_by_force { 1.0 } else { 0.0 };
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
}

/// What a circular punch adds to a solution without angle: tilt and moment with their errors, the stiffness against tilt, and a pressure if there is any.
///
/// # Errors
/// [`Error::LiftsOff`] where it lifts off, [`Error::InvalidValue`] for a tilt on a power law; those of the equation.
pub(super) fn turned<F: Field>(
    base: &Base,
    solved: &mut Solved<F>,
    stiffness: &mut Stiffness,
) -> Result<Option<Tilted>, Error> {
    let Some(kernel) = base.ground.turned_kernel()? else { return Ok(None) };
    let (field, value) = stated(base.problem().load().rotational);
    if value == 0.0 {
        stiffness.moment_tilt = turning(base, solved, &kernel)?;
        return Ok(None);
    }
    let needed = "zero for a circular punch on a layer with a power law, which mixes the harmonics of the pressure";
    crate::error::require(base.layer.is_linear(), field, value, needed)?;
    let tolerance = base.problem().solver().tolerance.unwrap_or(AIM);
    let found = solve_adaptive(kernel.as_ref(), PI * base.theta(), |r| r, tolerance)?;
    let given = base.surface.setting.load().rotational;
    let mut tilted = Tilted { unit: found.solution, tilt: 1.0, given, kernel };
    let turning = tilted.turning();
    let state = &mut solved.state;
    (state.tilt, state.moment) = match given {
        Rotational::Tilt(tilt) => (tilt, -tilt * turning),
        Rotational::Moment(moment) => (-moment / turning, moment),
        Rotational::Eccentricity(e) => (-e * state.force / turning, e * state.force),
    };
    tilted.tilt = state.tilt;
    stiffness.moment_tilt = turning;
    solved.stated.accuracy = tilted.accuracy(solved, &found.estimate);
    if !base.is_bilateral {
        let [limit, tension] = tension(base, solved, &tilted);
        let rounding = solved.rounding() + ALLOWED * solved.largest();
        if limit < 1.0 && tension > rounding {
            return Err(Error::LiftsOff { field, value, limit: limit * value.abs() });
        }
    }
    Ok(Some(tilted))
}

impl Tilted {
    /// The errors with those of the tilt.
    fn accuracy<F: Field>(&self, solved: &Solved<F>, unit: &Estimate) -> Accuracy {
        let (tilt, moment) = (solved.state.tilt.abs(), solved.state.moment.abs());
        let (turning, accuracy) = (self.turning(), solved.stated.accuracy);
        let share = PI * unit.integral / turning;
        let pressure = tilt * unit.solution + share * tilt * largest(self.unit.values());
        let accuracy = Accuracy { pressure: accuracy.pressure + pressure, ..accuracy };
        match self.given {
            Rotational::Tilt(_) => Accuracy { moment: moment * share, ..accuracy },
            Rotational::Moment(_) => Accuracy { tilt: tilt * share, ..accuracy },
            Rotational::Eccentricity(e) => {
                let moment = e.abs() * accuracy.force;
                Accuracy { moment, tilt: tilt * share + moment / turning, ..accuracy }
            }
        }
    }
}

/// How much of the tilt keeps the whole base in contact, and the tension under all of it.
fn tension<F: Field>(base: &Base, solved: &Solved<F>, tilted: &Tilted) -> [f64; 2] {
    if !matches!(&solved.nodes.zones[..], [zone] if zone.ends == [0.0, 1.0]) {
        return [0.0, f64::INFINITY];
    }
    let places = between_nodes(PLACES).map(|y| 0.5 * (1.0 + y)).filter(|r| *r > 0.0);
    places.fold([f64::INFINITY, f64::NEG_INFINITY], |[share, tension], r| {
        let (even, odd) = (solved.pressure_at(r, base.height(r)), tilted.pressure(r).abs());
        [share.min(even.max(0.0) / odd), tension.max(odd - even)]
    })
}

/// `dM0/d(-alpha0)` on the zones as they are.
fn turning<F: Field>(base: &Base, solved: &Solved<F>, kernel: &SharedKernel) -> Result<f64, Error> {
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
    let weights: Vec<f64> = solved.given.iter().map(|v| base.layer.slope(*v)).collect();
    let right = operator.sample(|y| y)?;
    let parameter = base.strength() * base.ground.scale(hull);
    let unit = operator.factor_weighted(parameter, &weights)?.solve(&right)?;
    // r = half y in the lever, in the moment and twice in the area
    Ok(PI * hull.half.powi(4) * unit.integral(|y| y))
}
