//! The tilt of a circular punch: the pressure `p1(r) cos(phi)` beside that without angle.
//!
//! `p1 + pi theta0 int W_1(r, s) p1 s ds = -alpha0 r`, `W_1 = int_0^inf t^mu J_1(r t) J_1(s t) dt`, `mu` that of a graded body, `M0 = pi int p1 r^2 dr`. Where
//! a linear layer touches all over it has a resolution of its own; else it is found, for the stiffness alone, on the zones and nodes of the pressure without angle.

use std::f64::consts::PI;
use std::sync::Arc;

use fredholm::collocation::{self, first_half_count};
use fredholm::{SincOperator, SincSolution};

use super::base::Base;
use super::nodes::{FEWEST, Field, MOST_DENSE, PLACES, RATIO, between_nodes};
use super::solved::{Solved, largest};
use crate::contact::accuracy::{Accuracy, SAFETY};
use crate::contact::balance::State;
use crate::contact::ground::{Hull, SharedKernel};
use crate::contact::parts::Smoothness;
use crate::contact::rates::{Linearised, Rates};
use crate::contact::resolutions::Trust;
use crate::contact::search::{ALLOWED, unknown};
use crate::contact::stiffness::Stiffness;
use crate::solver::AIM;
use crate::{Error, Rotational, Vertical};

/// The pressure `p1(r) cos(phi)` of a tilted circular punch that touches all over.
#[derive(Debug, Clone)]
pub(super) struct Tilted {
    /// For `-alpha0 = 1`.
    pub(super) unit: Unit,
    /// What is left of its error by its resolutions and rounding: of the pressure, and of `dM0/d(-alpha0)`.
    off: [f64; 2],
    /// `alpha0`.
    tilt: f64,
    /// What is prescribed of it.
    given: Rotational,
    kernel: SharedKernel,
}

/// The pressure `q` of `q + theta W_1 (dp0/dv q) = r`.
#[derive(Debug, Clone)]
pub(super) struct Unit {
    solution: SincSolution,
    /// What it changes by with `ln theta0`.
    changed: SincSolution,
    /// `dM0/d(-alpha0)`.
    turning: f64,
}

/// `dM0/d(-alpha0)` on the zones and nodes of a collocated pressure; what is left of its error is that of these.
pub(super) fn collocated_turning<F: Field>(
    base: &Base,
    solved: &Solved<F>,
) -> Result<[f64; 2], Error> {
    let Some(kernel) = base.ground.turned_kernel()? else { return Err(unknown()) };
    let (nodes, half) = (&solved.nodes, solved.nodes.frame.hull.half);
    let local = |[left, right]: &[f64; 2]| (left / half, (right / half).min(1.0));
    let panels: Vec<(f64, f64)> = nodes.panels.iter().map(local).collect();
    let on = (nodes.a_panel() / 2, &panels[..]);
    Ok([Unit::new(base, &kernel, &nodes.frame.hull, on, &solved.given)?.turning, 0.0])
}

impl Unit {
    /// With so many nodes on either side of the middle of each panel, in local coordinates, and what the layer gives at them; under a linear one that counts for nothing.
    fn new(
        base: &Base,
        kernel: &SharedKernel,
        hull: &Hull,
        (half_count, panels): (usize, &[(f64, f64)]),
        given: &[f64],
    ) -> Result<Self, Error> {
        let operator = if *panels == [(0.0, 1.0)]
            && let Some(known) = base.ground.known_turned_operator(half_count)
        {
            known?
        } else {
            let grid = base.ground.grid(half_count)?;
            Arc::new(SincOperator::on_panels(kernel.as_ref(), grid, panels)?)
        };
        let (count, size) = (operator.count(), operator.count() as f64);
        base.problem().deadline().spend((base.ground.entry() + size) * size * size);
        let slope = |k: usize| given.get(k).map_or(1.0, |v| base.layer.slope(*v));
        let parameter = base.strength() * base.ground.scale(hull);
        let factor =
            operator.factor_weighted(parameter, &(0..count).map(slope).collect::<Vec<_>>())?;
        let solution = factor.solve(&operator.sample(|y| y)?)?;
        let body: Vec<f64> = solution.potential().iter().map(|u| -parameter * u).collect();
        // r = half y in the lever, in the moment and twice in the area
        let turning = PI * hull.half.powi(4) * solution.integral(|y| y);
        Ok(Self { solution, changed: factor.solve(&body)?, turning })
    }

    pub(super) fn nodes(&self) -> usize {
        self.solution.values().len()
    }

    /// Differences of the pressure between the nodes, and of `dM0/d(-alpha0)`.
    fn differences(&self, other: &Self) -> [f64; 2] {
        let off = |r: f64| (self.solution.evaluate(r, r) - other.solution.evaluate(r, r)).abs();
        let off = between_nodes(PLACES).map(|y| off(0.5 * (1.0 + y))).fold(off(1.0), f64::max);
        [off, (self.turning - other.turning).abs()]
    }

    /// On the whole radius on growing resolutions of its own, with what is left of its errors: the pressure without angle may need more, fewer, or be nothing.
    fn resolved(base: &Base, kernel: &SharedKernel) -> Result<(Self, [f64; 2]), Error> {
        let (deadline, room) = (base.problem().deadline(), (MOST_DENSE / 2) as f64);
        let tolerance = base.problem().solver().tolerance.unwrap_or(AIM);
        let first = first_half_count(base.steepness()).max(base.ground.first_half_count(1.0));
        let on_level = |level: i32| {
            let count = (first.min(room) * RATIO.powi(level - 2)).round() as usize;
            let hull = base.ground.hull(0.0, 1.0, base.surface.origin);
            Self::new(base, kernel, &hull, (count.max(FEWEST), &[(0.0, 1.0)]), &[])
        };
        let (mut finest, mut before) = (on_level(0)?, [f64::INFINITY; 2]);
        for level in 1.. {
            let finer = on_level(level)?;
            let is_most = finer.nodes() as f64 * RATIO > MOST_DENSE as f64;
            let change = finer.differences(&finest);
            let size = largest(finer.solution.values());
            let rounding = collocation::rounding(&finer.solution);
            let pressures = [before[0], change[0]];
            let trust = Trust::new(Smoothness::Proved, RATIO, pressures, rounding, size);
            let left = |k: usize, size: f64| trust.left_of_one([before[k], change[k]], size, 1.0);
            let share = rounding / size;
            // The moment, a single number, may agree by chance: no better than the pressure is it known.
            let known = left(0, size) / size;
            let share = share.max(known).max(left(1, finer.turning) / finer.turning);
            let off = [share * size, share * finer.turning];
            let is_known = share <= tolerance.max(rounding / size);
            if level > 1 && (is_known || is_most || deadline.is_past()) {
                return Ok((finer, off));
            }
            (finest, before) = (finer, change);
        }
        Err(unknown())
    }
}

/// What a circular punch adds to a solution without angle: tilt and moment with their errors, the stiffness against tilt with what its own resolutions leave of its error, and a
/// pressure if it tilts.
///
/// # Errors
/// [`Error::LiftsOff`] where it lifts off, [`Error::InvalidValue`] for a tilt on a power law; those of the equation.
pub(super) fn turned<F: Field>(
    base: &Base,
    solved: &mut Solved<F>,
    stiffness: &mut Stiffness,
) -> Result<(Option<Tilted>, f64), Error> {
    let Some(kernel) = base.ground.turned_kernel()? else { return Ok((None, 0.0)) };
    base.problem().require_one_harmonic()?;
    let (field, value) = base.problem().load().rotational.named();
    let touches_all_over =
        matches!(&solved.nodes.zones[..], [zone] if zone.ends == [0.0, 1.0]) || base.is_bilateral;
    if !(touches_all_over && base.layer.is_linear()) {
        if value != 0.0 {
            return Err(Error::LiftsOff { field, value, limit: 0.0 });
        }
        let [turning, off] = F::turning(base, solved)?;
        stiffness.moment_tilt = turning;
        return Ok((None, off));
    }
    let (unit, off) = Unit::resolved(base, &kernel)?;
    stiffness.moment_tilt = unit.turning;
    if value == 0.0 {
        return Ok((None, off[1]));
    }
    let given = base.surface.setting.load().rotational;
    [solved.state.tilt, solved.state.moment] = given.turned(solved.state.force, unit.turning);
    let tilted = Tilted { unit, off, tilt: solved.state.tilt, given, kernel };
    if !base.is_bilateral {
        let [limit, tension] = tilted.tension(base, solved);
        if limit < 1.0 && tension > solved.rounding() + ALLOWED * solved.largest() {
            return Err(Error::LiftsOff { field, value, limit: limit * value.abs() });
        }
    }
    solved.stated.accuracy = tilted.accuracy(solved.stated.accuracy, &solved.state);
    Ok((Some(tilted), off[1]))
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

    /// The largest pressure.
    pub(super) fn largest(&self) -> f64 {
        self.tilt.abs() * largest(self.unit.solution.values())
    }

    /// The errors of a solution in this state with those of the tilt.
    fn accuracy(&self, accuracy: Accuracy, state: &State) -> Accuracy {
        let (tilt, moment) = (state.tilt.abs(), state.moment.abs());
        let (turning, [off, turning_off]) = (self.unit.turning, self.off);
        let share = turning_off / turning;
        let pressure = accuracy.pressure + tilt * off + share * self.largest();
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
        let places = between_nodes(PLACES).map(|y| 0.5 * (1.0 + y)).filter(|r| *r > 0.0);
        places.fold([f64::INFINITY, f64::NEG_INFINITY], |[share, tension], r| {
            let (even, odd) = (solved.pressure_at(r, base.height(r)), self.pressure(r).abs());
            [share.min(even.max(0.0) / odd), tension.max(odd - even)]
        })
    }

    /// The first-order change with what the tilt adds to that of the pressure without angle; the peak is a place on the diameter.
    ///
    /// With `ln theta` the unit pressure turns by `T' = -pi int q theta W_1 q r dr`: the operator is symmetric.
    pub(super) fn linearised(&self, mut even: Linearised, by: Vertical, peak: f64) -> Linearised {
        let Self { unit: Unit { solution: unit, changed, turning }, tilt, .. } = self;
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
        even.rates[0][3] -= sign * tilt * changed.evaluate(r, elastic);
        // As near as the unit pressure and its moment are known.
        let size = SAFETY * (self.off[1] / turning).max(self.off[0] / largest(unit.values()));
        for (rates, errors) in even.rates.iter_mut().zip(&mut even.errors) {
            rates[3] -= sign * rates[2] * unit.evaluate(r, r);
            errors[2] += size * rates[2].abs();
            errors[3] += size * rates[3].abs();
        }
        even
    }
}
