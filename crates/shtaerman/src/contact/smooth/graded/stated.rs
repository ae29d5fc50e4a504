//! A stated plane problem with a smooth surface on graded ground, and its answer as a solution like any other.

use super::Solved;
use super::field::Field;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::smooth::disk::transform::Transform;
use crate::contact::smooth::problem::SmoothProblem;
use crate::contact::smooth::system::Place;
use crate::contact::solution::Solution;
use crate::contact::solved::{Method, Stiffness};
use crate::contact::unilateral::Complementarity;
use crate::{Error, Problem, Rotational, Vertical};

/// Rounding of a quantity relative to what is added up in it.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Zone, pressure, settlement, tilt, force and moment of a smooth plane punch on graded ground, without dimensions.
#[derive(Debug)]
pub(crate) struct GradedStrip {
    problem: SmoothProblem,
    solved: Solved,
    accuracy: Accuracy,
    edge_error: f64,
}

impl Problem {
    /// Solves a plane punch with a smooth surface on graded ground.
    ///
    /// # Errors
    /// Those of [`SmoothProblem::solve`], with values in the units of the problem; [`Error::SeveralZones`].
    pub(crate) fn solve_smooth_graded(&self, exponent: f64) -> Result<GradedStrip, Error> {
        let problem = self.smooth();
        let solved = super::solve(&problem, exponent).map_err(|error| self.in_units(error));
        let half_width = self.frame().half_width();
        let solved = solved.map_err(|error| match error {
            Error::SeveralZones { at, found, .. } => {
                let variable = self.frame().coordinate();
                Error::SeveralZones { variable, at: at * half_width, found }
            }
            other => other,
        })?;
        GradedStrip::new(problem, solved)
    }
}

impl GradedStrip {
    fn new(problem: SmoothProblem, solved: Solved) -> Result<Self, Error> {
        let (accuracy, edge_error) = estimate(&problem, &solved);
        let State { settlement, tilt, force, moment } = solved.field.strip.state;
        let values = [
            ("force", force),
            ("moment", moment),
            ("settlement", settlement),
            ("tilt", tilt),
            ("pressure", solved.left.largest),
            ("error of the pressure", accuracy.pressure),
        ];
        if let Some((quantity, value)) = values.into_iter().find(|(_, value)| !value.is_finite()) {
            return Err(Error::Overflow { quantity, value });
        }
        Ok(Self { problem, solved, accuracy, edge_error })
    }

    fn field(&self) -> &Field {
        &self.solved.field
    }

    fn pressure0(&self, xi: f64) -> f64 {
        let field = self.field();
        if field.strip.zone.contains(xi) || xi.is_nan() {
            field.pressure(field.place(xi))
        } else {
            0.0
        }
    }
}

/// The error: of the pressure by leaving out the last coefficients and by the rounding of what is added up in it, which gives that of all others.
fn estimate(problem: &SmoothProblem, solved: &Solved) -> (Accuracy, f64) {
    let Solved { field, left, tolerance } = solved;
    let strip = &field.strip;
    let (half, [from, to]) = (strip.half(), strip.zone.ends);
    // The ends are rounded in xi, not in lengths of their zone.
    let remote = 1.0 + from.abs().max(to.abs()) / half;
    let share = ROUNDING * remote + 4.0 * tolerance;
    let density = share * strip.density_scale();
    let other = field.truncated();
    let differences = left.places.iter().map(|&xi| {
        let place = field.place(xi);
        (field.regular(place) - other.regular(place)).abs()
    });
    let series = differences.fold(0.0, f64::max);
    let blown = field.transforms[0].slope_rounding() * half
        + field.transforms[1].slope_rounding() * half * half;
    let pressure = series + share * left.largest + field.flat_pressure(density + blown);
    let State { settlement, tilt, force, moment } = strip.state;
    // A depth or tilt that is off changes the densities by mu B or b B of it.
    let [level, turn] = [strip.levels[0], half * strip.levels[1]];
    let total = field.ground.total();
    let mu = field.ground.powers.exponent();
    let depth_error = density / (mu * total) + ROUNDING * (settlement.abs() + strip.depth.abs());
    let tilt_error = density / (half * total) + ROUNDING * tilt.abs();
    let settlement_error = depth_error + tilt_error * strip.centre().abs();
    let sum = share * (level.abs() + turn.abs()) + density;
    let force_error = strip.own.force_settlement
        * (sum / (mu * total) + ROUNDING * (settlement.abs() + strip.depth.abs()))
        + ROUNDING * force.abs();
    let moment_error = strip.own.moment_tilt * (sum / (half * total))
        + strip.centre().abs() * force_error
        + ROUNDING * moment.abs();
    let of = |unknown: bool, error: f64| if unknown { error } else { 0.0 };
    let by_force = matches!(problem.load.vertical, Vertical::Force(_));
    let by_tilt = matches!(problem.load.rotational, Rotational::Tilt(_));
    let by_moment = matches!(problem.load.rotational, Rotational::Moment(_));
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure,
        settlement: of(by_force, settlement_error),
        tilt: of(!by_tilt, tilt_error),
        force: of(!by_force, force_error),
        moment: of(!by_moment, moment_error),
    };
    let edge = (0..2).filter(|&side| strip.zone.is_free[side]).fold(0.0f64, |most, side| {
        let moved = (density + strip.end_density(side).abs()) / field.slopes[side].abs();
        most.max((moved + ROUNDING * (from.abs().max(to.abs()))).min(1.0))
    });
    (accuracy, edge)
}

impl Solution for GradedStrip {
    fn state(&self) -> State {
        self.field().strip.state
    }

    fn stiffness(&self) -> Stiffness {
        self.field().strip.stiffness
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        vec![self.field().strip.zone.ends]
    }

    fn pressure(&self, _: &Problem, xi: f64) -> f64 {
        self.pressure0(xi)
    }

    fn pressure_beside(&self, _: &Problem, _: usize, from_left: f64, from_right: f64) -> f64 {
        let (from_left, from_right) = (from_left.max(0.0), from_right.max(0.0));
        self.field().pressure(Place { from_left, from_right })
    }

    fn displacement(&self, xi: f64) -> f64 {
        let strip = &self.field().strip;
        if !strip.zone.contains(xi) {
            return self.field().displacement_outside(xi);
        }
        // At a step the height is that of this side.
        let [left, right] = strip.zone.ends;
        let inside = xi.clamp(left.next_up(), right.next_down());
        strip.state.settlement - strip.state.tilt * xi - (self.problem.profile.height)(inside)
    }

    fn sample(&self, _: &Problem) -> (Vec<f64>, Vec<f64>) {
        let mut places = self.solved.left.places.clone();
        places.extend(self.field().breaks.iter().copied());
        places.extend([-1.0, 1.0]);
        places.extend(self.field().strip.zone.ends);
        places.sort_by(f64::total_cmp);
        places.dedup();
        let sampled = places.into_iter().map(|xi| (xi, self.pressure0(xi)));
        sampled.filter(|(_, pressure)| pressure.is_finite()).unzip()
    }

    fn method(&self) -> Method {
        let n = self.field().transforms.iter().map(Transform::size).sum();
        Method { name: "first_kind", n }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        self.field().strip.zone.is_free.contains(&true).then_some(self.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        let (tension, penetration) = (self.solved.left.tension.0, self.solved.left.penetration.0);
        self.problem.is_unilateral.then_some(Complementarity { tension, penetration })
    }

    fn corner_intensity(&self) -> Option<Vec<[f64; 2]>> {
        Some(vec![[0, 1].map(|side| self.field().intensity(side))])
    }

    fn size(&self) -> f64 {
        self.solved.left.largest
    }
}
