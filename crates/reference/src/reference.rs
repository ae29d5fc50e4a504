//! Two solutions, and what their difference says.

use crate::grid::Fineness;
use crate::panel::Place;
use crate::problem::{Layer, Problem, Refusal, Rotational, Vertical};
use crate::rough::Solved;
use crate::zones::{places, settle};

const SEARCH: Fineness = Fineness { nodes: 6, shortest: 1e-2, resolved: 1e-3 };
const COARSE: Fineness = Fineness { nodes: 16, shortest: 1e-6, resolved: 1e-12 };
const FINE: Fineness = Fineness { nodes: 20, shortest: 2e-8, resolved: 1e-14 };
/// To what free ends are found with them.
const SETTLED: [f64; 3] = [1e-4, 1e-10, 1e-12];
/// Roundings of a potential relative to the sum of the sizes of its parts.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Errors of a reference, stated from the difference of two resolutions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// Of the ends of zones.
    pub ends: f64,
    /// Of `delta`; 0 where it is prescribed, as the others.
    pub settlement: f64,
    /// Of `alpha`.
    pub tilt: f64,
    /// Of `P`.
    pub force: f64,
    /// Of `M`.
    pub moment: f64,
}

/// A solved contact.
pub struct Reference<'a> {
    problem: &'a Problem<'a>,
    coarse: Solved,
    fine: Solved,
    /// What rounding does to the equation.
    rounding: f64,
    /// The zones of contact.
    pub zones: Vec<[f64; 2]>,
    /// `delta`.
    pub settlement: f64,
    /// `alpha`.
    pub tilt: f64,
    /// `P`.
    pub force: f64,
    /// `M`.
    pub moment: f64,
    /// Their errors.
    pub errors: Errors,
    /// Unknowns of the finer solution.
    pub unknowns: usize,
    /// The most negative `v` in the zones, and the largest depth to which the body would enter the base outside of them, as far as many places show.
    pub violation: [f64; 2],
}

impl<'a> Problem<'a> {
    /// Solves the contact; the search for zones starts from the whole base, or from zones that someone else has found.
    ///
    /// # Errors
    /// [`Refusal`].
    pub fn solve(&'a self, start: Option<&[[f64; 2]]>) -> Result<Reference<'a>, Refusal> {
        if self.layer == Layer::None {
            return Err(Refusal::NotCovered("it solves no smooth surfaces yet"));
        }
        let start = start.unwrap_or(self.pieces);
        let (_, zones) = settle(self, start, SEARCH, SETTLED[0])?;
        let (coarse, zones) = settle(self, &zones, COARSE, SETTLED[1])?;
        let before = zones.clone();
        let (fine, zones) = settle(self, &zones, FINE, SETTLED[2])?;
        if before.len() != zones.len() {
            return Err(Refusal::ZonesNotFound);
        }
        let moved = before.iter().flatten().zip(zones.iter().flatten());
        let ends = moved.fold(0.0f64, |most, (one, two)| most.max((one - two).abs()));
        let (first, second) = (self.load(&coarse), self.load(&fine));
        let rounding = ROUNDING * self.size(&fine, &zones);
        let error = |one: f64, two: f64, is_free: bool, size: f64| {
            if is_free { 2.0 * (one - two).abs() + size } else { 0.0 }
        };
        let is_force_free = matches!(self.vertical, Vertical::Settlement(_));
        let is_moment_free = is_force_free || matches!(self.rotational, Rotational::Tilt(_));
        let is_tilt_free = !matches!(self.rotational, Rotational::Tilt(_));
        let width: f64 = self.pieces.iter().map(|[left, right]| right - left).sum();
        let errors = Errors {
            ends: 2.0 * ends,
            settlement: error(coarse.settlement, fine.settlement, !is_force_free, rounding),
            tilt: error(coarse.tilt, fine.tilt, is_tilt_free, rounding / width),
            force: error(first[0], second[0], is_force_free, width * rounding),
            moment: error(first[1], second[1], is_moment_free, width * rounding),
        };
        let force = match self.vertical {
            Vertical::Force(force) => force,
            Vertical::Settlement(_) => second[0],
        };
        Ok(Reference {
            problem: self,
            rounding,
            settlement: fine.settlement,
            tilt: fine.tilt,
            force,
            moment: match self.rotational {
                Rotational::Moment(moment) => moment,
                Rotational::Eccentricity(e) => e * force,
                Rotational::Tilt(_) => second[1],
            },
            errors,
            unknowns: fine.grid.len(),
            violation: self.violation(&fine, &zones),
            zones,
            coarse,
            fine,
        })
    }

    /// Force and moment.
    fn load(&self, solved: &Solved) -> [f64; 2] {
        let mut load = [0.0; 2];
        for ((place, weight), p) in solved.grid.nodes().iter().zip(&solved.pressures) {
            let [force, moment] = self.kernel.weights(place.x());
            load[0] += weight * force * p;
            load[1] += weight * moment * p;
        }
        load
    }

    /// The size of what is added up in the equation.
    fn size(&self, solved: &Solved, zones: &[[f64; 2]]) -> f64 {
        let of_zone = |[left, right]: &[f64; 2]| {
            [0.013, 0.31, 0.5, 0.77, 0.991].map(|share| left + (right - left) * share)
        };
        zones.iter().flat_map(of_zone).fold(0.0f64, |most, x| {
            let row = solved.grid.row(&self.kernel, Place::on_line(x));
            let sum: f64 = row.iter().zip(&solved.pressures).map(|(a, p)| (a * p).abs()).sum();
            let [level, arm] = self.kernel.lifts(x);
            let depth = (solved.settlement * level).abs() + (solved.tilt * arm).abs();
            most.max(depth + self.height(x).abs() + self.theta * sum)
        })
    }

    fn violation(&self, solved: &Solved, zones: &[[f64; 2]]) -> [f64; 2] {
        if self.is_bilateral {
            return [0.0; 2];
        }
        let mut worst = [0.0f64; 2];
        for x in places(self, zones, 9) {
            let v = solved.layer(self, x);
            let is_inside = zones.iter().any(|[left, right]| *left <= x && x <= *right);
            let k = usize::from(!is_inside);
            worst[k] = worst[k].max(if is_inside { -v } else { v });
        }
        worst
    }
}

impl Reference<'_> {
    /// The pressure at a place of the base and its error.
    #[must_use]
    pub fn pressure(&self, x: f64) -> [f64; 2] {
        let layers = [&self.coarse, &self.fine].map(|solved| solved.layer(self.problem, x));
        let at = |v: f64| self.problem.pressure(v)[0];
        let [one, two] = layers.map(at);
        let rounded = (at(layers[1] + self.rounding) - at(layers[1] - self.rounding)).abs();
        [two, 2.0 * (one - two).abs() + rounded]
    }
}
