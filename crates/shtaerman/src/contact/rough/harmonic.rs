//! The tilt of a circular punch: the pressure `p1(r) cos(phi)` beside that without angle.
//!
//! `p1 + pi theta0 int W_1(r, s) p1 s ds = -alpha0 r`, `W_1 = int_0^inf t^mu J_1(r t) J_1(s t) dt`, `mu` that of a graded body, `M0 = pi int p1 r^2 dr`.

use std::f64::consts::PI;
use std::sync::Arc;

use fredholm::collocation::solve_adaptive;
use fredholm::{SincOperator, SincSolution};

use super::answer::{Tilted, UnilateralContact};
use super::base::Base;
use super::between::PLACES;
use super::between::between_nodes;
use super::solved::Solved;
use crate::contact::check::Check;
use crate::contact::ground::SharedKernel;
use crate::contact::search::ALLOWED;
use crate::contact::zones::Zone;
use crate::solver::AIM;
use crate::{Error, Rotational};

/// The answer, with the tilt of a circular punch.
pub(super) fn answer(
    base: &Base<'_>,
    mut solved: Solved,
    check: &Check,
) -> Result<UnilateralContact, Error> {
    let Some(kernel) = base.ground.turned_kernel()? else {
        return Ok(UnilateralContact::new(base, solved, check));
    };
    let wanted = base.problem.dimensionless_load().rotational;
    let given = match base.problem.load().rotational {
        Rotational::Moment(value) => ("moment", value),
        Rotational::Eccentricity(value) => ("eccentricity", value),
        Rotational::Tilt(value) => ("tilt", value),
    };
    if given.1 == 0.0 {
        solved.stiffness.moment_tilt = base.turning(&solved, &kernel)?;
        return Ok(UnilateralContact::new(base, solved, check));
    }
    crate::error::require(
        base.layer.is_linear(),
        given.0,
        given.1,
        "zero for a circular punch on a layer with a power law, which mixes the harmonics of the pressure",
    )?;
    let tolerance = base.problem.solver().tolerance.unwrap_or(AIM);
    let found = solve_adaptive(kernel.as_ref(), PI * base.theta, |r| r, tolerance)?;
    let unit = found.solution;
    // M0 per -alpha0
    let turning = PI * unit.integral(|r| r);
    let state = &mut solved.state;
    let (tilt, moment) = match wanted {
        Rotational::Tilt(tilt) => (tilt, -tilt * turning),
        Rotational::Moment(moment) => (-moment / turning, moment),
        Rotational::Eccentricity(e) => (-e * state.force / turning, e * state.force),
    };
    (state.tilt, state.moment) = (tilt, moment);
    solved.stiffness.moment_tilt = turning;
    let mut accuracy = solved.stated.accuracy;
    let unit_error = found.estimate.solution;
    let share = PI * found.estimate.integral / turning;
    accuracy.pressure += tilt.abs() * unit_error + share * tilt.abs() * largest(&unit);
    match wanted {
        Rotational::Tilt(_) => accuracy.moment = moment.abs() * share,
        Rotational::Moment(_) => accuracy.tilt = tilt.abs() * share,
        Rotational::Eccentricity(_) => {
            let arm = moment / solved.state.force;
            accuracy.moment = arm.abs() * accuracy.force;
            accuracy.tilt = tilt.abs() * share + accuracy.moment / turning;
        }
    }
    solved.stated.accuracy = accuracy;
    let tilted = Tilted { unit, tilt, kernel };
    if !base.is_bilateral {
        let [limit, tension] = base.tension(&solved, &tilted);
        let rounding = solved.rounding() + ALLOWED * solved.largest();
        if limit < 1.0 && tension > rounding {
            let (field, value) = given;
            return Err(Error::LiftsOff { field, value, limit: limit * value.abs() });
        }
    }
    Ok(UnilateralContact::new(base, solved, check).with_tilt(tilted))
}

fn largest(solution: &SincSolution) -> f64 {
    solution.values().iter().fold(0.0, |most, p| most.max(p.abs()))
}

impl Base<'_> {
    /// How much of the tilt keeps the whole base in contact, and the tension under all of it.
    fn tension(&self, solved: &Solved, tilted: &Tilted) -> [f64; 2] {
        let covers = |zone: &Zone| zone.ends == [0.0, 1.0];
        if !matches!(&solved.zones[..], [zone] if covers(zone)) {
            return [0.0, f64::INFINITY];
        }
        between_nodes(PLACES).map(|y| 0.5 * (1.0 + y)).filter(|r| *r > 0.0).fold(
            [f64::INFINITY, f64::NEG_INFINITY],
            |[share, tension], r| {
                let (even, odd) = (solved.pressure_at(r, self.height(r)), tilted.pressure(r).abs());
                [share.min(even.max(0.0) / odd), tension.max(odd - even)]
            },
        )
    }

    /// `dM0/d(-alpha0)` on the zones as they are.
    fn turning(&self, solved: &Solved, kernel: &SharedKernel) -> Result<f64, Error> {
        let half = solved.hull.half;
        let panels: Vec<(f64, f64)> = (solved.panels.iter())
            .map(|panel| (panel.left / half, (panel.right / half).min(1.0)))
            .collect();
        let half_count = solved.panel_count() / 2;
        let known = match panels[..] {
            [(0.0, 1.0)] => self.ground.known_turned_operator(half_count).transpose()?,
            _ => None,
        };
        let operator = match known {
            Some(operator) => operator,
            None => {
                let grid = self.ground.grid(half_count)?;
                Arc::new(SincOperator::on_panels(kernel.as_ref(), grid, &panels)?)
            }
        };
        let weights: Vec<f64> =
            solved.solution.values().iter().map(|v| self.layer.slope(*v)).collect();
        let right = operator.sample(|y| y)?;
        let parameter = solved.solution.parameter();
        let unit = operator.factor_weighted(parameter, &weights)?.solve(&right)?;
        // r = half y in the lever, in the moment and twice in the area
        Ok(PI * half.powi(4) * unit.integral(|y| y))
    }
}
