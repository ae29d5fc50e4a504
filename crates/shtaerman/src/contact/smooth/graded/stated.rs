//! A stated plane problem with a smooth surface on graded ground, and its answer as a solution like any other.

use super::Solved;
use super::check::Along;
use super::field::{Field, displacement_outside};
use super::strip::Strip;
use crate::contact::accuracy::ROUNDING;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::complementarity::Complementarity;
use crate::contact::method::{Method, MethodName};
use crate::contact::rates::Linearised;
use crate::contact::smooth::problem::SmoothProblem;
use crate::contact::smooth::system::Place;
use crate::contact::smooth::told::Told;
use crate::contact::solution::Solution;
use crate::contact::stiffness::Stiffness;
use crate::{Error, Load, Problem};

/// Every so many places are compared with less of each series. At half or twice 10 of 22 answers change, within what they state (survey).
const COMPARED: usize = 3;

/// Zones, pressure, settlement, tilt, force and moment of a smooth plane punch on graded ground, without dimensions.
#[derive(Debug)]
pub(crate) struct GradedContact {
    problem: SmoothProblem,
    solved: Solved,
    told: Told,
}

impl Problem {
    /// Solves a plane punch with a smooth surface on graded ground.
    ///
    /// # Errors
    /// Those of [`SmoothProblem::solve`], with values in the units of the problem.
    pub(crate) fn solve_smooth_graded(&self, exponent: f64) -> Result<GradedContact, Error> {
        let problem = self.smooth();
        let solved = super::solve(&problem, exponent).map_err(|error| self.in_units(error));
        GradedContact::new(problem, solved?)
    }
}

impl GradedContact {
    fn new(problem: SmoothProblem, solved: Solved) -> Result<Self, Error> {
        let stated = (&problem.load, &solved.fields[0].strip.state);
        let shares = [solved.left.tension, solved.left.penetration];
        let told = Told::new(stated, solved.along.largest, estimate(&solved), shares)?;
        Ok(Self { problem, solved, told })
    }

    pub(super) fn problem(&self) -> &SmoothProblem {
        &self.problem
    }

    pub(super) fn fields(&self) -> &[Field] {
        &self.solved.fields
    }

    fn touching(&self, xi: f64) -> Option<&Field> {
        self.fields().iter().find(|field| field.strip.zone.contains(xi))
    }
}

/// What a zone is known to.
struct Known {
    /// Of its densities, its pressure and its free ends.
    density: f64,
    pressure: f64,
    edge: f64,
    /// Of the displacement by a zone, at its middle and by a turn.
    depth: f64,
    tilt: f64,
}

/// Of the pressure by leaving out the last coefficients and by the rounding of what is added up in it, which gives that of all others.
fn known(field: &Field, along: &Along, zone: usize, [condition, tolerance]: [f64; 2]) -> Known {
    let strip = &field.strip;
    let (half, [from, to]) = (strip.half(), strip.zone.ends);
    // The ends are rounded in xi, not in lengths of their zone.
    let remote = 1.0 + from.abs().max(to.abs()) / half;
    let share = condition * ROUNDING * remote + 4.0 * tolerance;
    let density = share * strip.density_scale();
    let series = if field.is_truncated() {
        let other = field.truncated();
        let places = along.places[zone].iter().zip(&along.pressures[zone]);
        let differences = places
            .step_by(COMPARED)
            .map(|(&xi, pressure)| (pressure - other.regular(field.place(xi))).abs());
        differences.fold(0.0, f64::max)
    } else {
        0.0
    };
    let blown = field.slope_rounding() * half;
    let pressure = series + share * along.largest + field.flat_pressure(density + blown);
    let edge = (0..2).filter(|&side| strip.zone.is_free(side)).fold(0.0f64, |most, side| {
        let moved = (density + strip.end_density(side).abs()) / field.slopes[side].abs();
        most.max((moved + ROUNDING * (from.abs().max(to.abs()))).min(1.0))
    });
    let total = field.ground.total();
    let depth = density / (field.ground.powers.exponent() * total);
    Known { density, pressure, edge, depth, tilt: density / (half * total) }
}

/// The error of the answer from those of its zones.
fn estimate(solved: &Solved) -> (Accuracy, f64) {
    let Solved { fields, along, tolerance, .. } = solved;
    let mu = fields[0].ground.powers.exponent();
    let total = fields[0].ground.total();
    // That of a small exponent is nearly the same everywhere, whatever the zone.
    let condition = if fields.len() > 1 { 1.0 + 1.0 / mu } else { 1.0 };
    let all: Vec<Known> = (fields.iter().enumerate())
        .map(|(zone, field)| known(field, along, zone, [condition, *tolerance]))
        .collect();
    let most = |of: fn(&Known) -> f64| all.iter().map(of).fold(0.0, f64::max);
    let State { settlement, tilt, force, moment } = fields[0].strip.state;
    // A depth or tilt that is off changes the densities by mu B or b B of it.
    let first = fields[0].strip.zone.left();
    let last = fields[fields.len() - 1].strip.zone.right();
    let (reach, centre) = (0.5 * (last - first), 0.5 * (first + last));
    let tilt_error =
        if fields.len() > 1 { most(|known| known.depth) / reach } else { most(|known| known.tilt) }
            + ROUNDING * tilt.abs();
    let own: f64 = fields.iter().map(|field| field.strip.depth(&field.ground).abs()).sum();
    let depth_error = most(|known| known.depth) + ROUNDING * (settlement.abs() + own);
    let settlement_error = depth_error + tilt_error * centre.abs();
    let (mut force_error, mut moment_error) = (ROUNDING * force.abs(), ROUNDING * moment.abs());
    for (field, known) in fields.iter().zip(&all) {
        let strip = &field.strip;
        let share = known.density / strip.density_scale();
        let levels = strip.levels[0].abs() + strip.half() * strip.levels[1].abs();
        let sum = share * levels + known.density;
        let by_force =
            strip.own.force_settlement * (sum / (mu * total) + ROUNDING * (settlement.abs() + own));
        force_error += by_force;
        moment_error += strip.own.moment_tilt * (sum / (strip.half() * total))
            + strip.centre().abs() * by_force;
    }
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure: most(|known| known.pressure),
        settlement: settlement_error,
        tilt: tilt_error,
        force: force_error,
        moment: moment_error,
    };
    (accuracy, most(|known| known.edge))
}

impl Solution for GradedContact {
    fn state(&self) -> State {
        self.fields()[0].strip.state
    }

    fn stiffness(&self) -> Stiffness {
        self.fields()[0].strip.stiffness
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        self.fields().iter().map(|field| field.strip.zone.ends).collect()
    }

    fn pressure(&self, xi: f64) -> f64 {
        if xi.is_nan() {
            return xi;
        }
        self.touching(xi).map_or(0.0, |field| field.pressure(field.place(xi)))
    }

    fn pressure_beside(&self, zone: usize, from_left: f64, from_right: f64) -> f64 {
        let (from_left, from_right) = (from_left.max(0.0), from_right.max(0.0));
        let place = Place { from_left, from_right };
        self.fields().get(zone).map_or(0.0, |field| field.pressure(place))
    }

    fn displacement(&self, xi: f64) -> f64 {
        let Some(field) = self.touching(xi) else {
            return displacement_outside(self.fields(), xi);
        };
        // At a step the height is that of this side.
        let Strip { zone, state, .. } = &field.strip;
        let inside = zone.inside(xi);
        state.settlement - state.tilt * xi - (self.problem.profile.height)(inside)
    }

    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        let along = &self.solved.along;
        let mut sampled: Vec<(f64, f64)> = Vec::new();
        let mut others = vec![-1.0, 1.0];
        for (j, field) in self.fields().iter().enumerate() {
            let known = along.places[j].iter().zip(&along.pressures[j]);
            sampled.extend(
                known.map(|(&xi, &regular)| (xi, regular / field.regular_share(field.place(xi)))),
            );
            others.extend(field.breaks.iter().chain(&field.strip.zone.ends));
        }
        sampled.extend(others.into_iter().map(|xi| (xi, self.pressure(xi))));
        sampled.sort_by(|one, two| one.0.total_cmp(&two.0));
        sampled.dedup_by(|next, last| next.0 == last.0);
        sampled.into_iter().filter(|(_, pressure)| pressure.is_finite()).unzip()
    }

    fn method(&self) -> Method {
        let n = self.fields().iter().map(Field::size).sum();
        Method { name: MethodName::FirstKind, n }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.told.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        let is_free = self.fields().iter().any(|field| field.strip.zone.has_free_end());
        is_free.then_some(self.told.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.problem.is_unilateral.then_some(self.told.complementarity)
    }

    fn corner_intensity(&self) -> Option<Vec<[f64; 2]>> {
        let of = |field: &Field| [0, 1].map(|side| field.intensity(side));
        Some(self.fields().iter().map(of).collect())
    }

    fn linearised(&self, _load: Load, peak: f64) -> Option<Linearised> {
        Some(self.first_order(peak))
    }

    fn size(&self) -> f64 {
        self.told.largest
    }
}
