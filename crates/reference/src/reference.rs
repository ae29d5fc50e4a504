//! Two solutions, and what their difference says.

use crate::grid::Fineness;
use crate::kernel::Kernel;
use crate::panel::Place;
use crate::problem::{Layer, Problem, Refusal, Rotational, Vertical};
use crate::rough::{self, Solved};
use crate::smooth;
use crate::zones::{places, settle};

const SEARCH: Fineness = Fineness { nodes: 6, shortest: 1e-2, resolved: 1e-3 };
const COARSE: Fineness = Fineness { nodes: 16, shortest: 1e-6, resolved: 1e-12 };
const FINE: Fineness = Fineness { nodes: 20, shortest: 2e-8, resolved: 1e-13 };
/// Rough ground graded by more is refused: its shortest panels at ends, of `1e-26`, leave `1e-26^(1-mu)` of the potential unresolved, 5 % at 0.95, where settlement and pressures elsewhere are right to
/// 1e-12; from 0.96 on they are off by more than their differences between two resolutions say (5e-11, at 0.98 5e-5).
const STRONGEST: f64 = 0.95;
/// To what free ends are found with them.
const SETTLED: [f64; 3] = [1e-4, 1e-12, 1e-12];
/// Roundings of a potential relative to the sum of the sizes of its parts.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Roundings count more without a layer, which damps them.
const UNDAMPED: f64 = 8.0;
/// Roundings of the pressure of a smooth surface, relative to it.
const FIRST_KIND: f64 = 1024.0 * f64::EPSILON;
/// What places are off by in their panels, relative to them.
const PLACED: f64 = 4.0 * f64::EPSILON;
/// Tension and penetration beyond that share of the displacements mean that the zones are others.
const VIOLATED: f64 = 1e-8;

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
    /// How far both differ on each panel of the finer one, in the pressure, on a smooth surface in the density.
    differences: Vec<f64>,
    /// What rounding does to the equation.
    rounding: f64,
    /// The errors of the ends.
    moved: Vec<[f64; 2]>,
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
        let exponent = self.kernel.exponent();
        if self.layer != Layer::None && exponent > STRONGEST {
            return Err(Refusal::TooSingular { exponent, most: STRONGEST });
        }
        let [(coarse, before), (fine, zones)] = if self.layer == Layer::None {
            smooth::settle(self, start, [COARSE, FINE])?
        } else {
            let start = start.unwrap_or(self.pieces);
            let zones = if self.is_bilateral {
                start.to_vec()
            } else {
                settle(self, start, SEARCH, SETTLED[0])?.1
            };
            let (coarse, zones) = settle(self, &zones, COARSE, SETTLED[1])?;
            let (fine, settled) = settle(self, &zones, FINE, SETTLED[2])?;
            [(coarse, zones), (fine, settled)]
        };
        if before.len() != zones.len() {
            return Err(Refusal::ZonesNotFound);
        }
        let moved: Vec<[f64; 2]> = (before.iter().zip(&zones))
            .map(|(one, two)| [0, 1].map(|side| 2.0 * (one[side] - two[side]).abs()))
            .collect();
        let ends = moved.iter().flatten().fold(0.0f64, |most, end| most.max(*end));
        let (first, second) = (self.load(&coarse), self.load(&fine));
        let amplified = if self.layer == Layer::None { UNDAMPED } else { 1.0 };
        let rounding = amplified * ROUNDING * self.size(&fine, &zones);
        let error = |one: f64, two: f64, is_free: bool, size: f64| {
            if is_free { 2.0 * (one - two).abs() + size } else { 0.0 }
        };
        let is_force_free = matches!(self.vertical, Vertical::Settlement(_));
        let is_moment_free = is_force_free || matches!(self.rotational, Rotational::Tilt(_));
        let is_tilt_free = !matches!(self.rotational, Rotational::Tilt(_));
        let width: f64 = self.pieces.iter().map(|[left, right]| right - left).sum();
        let errors = Errors {
            ends,
            settlement: error(coarse.settlement, fine.settlement, !is_force_free, rounding),
            tilt: error(coarse.tilt, fine.tilt, is_tilt_free, rounding / width),
            force: error(first[0], second[0], is_force_free, width * rounding),
            moment: error(first[1], second[1], is_moment_free, width * rounding),
        };
        let force = match self.vertical {
            Vertical::Force(force) => force,
            Vertical::Settlement(_) => second[0],
        };
        let violation = self.violation(&fine, &zones);
        if violation.iter().any(|v| *v > VIOLATED * rounding / (amplified * ROUNDING)) {
            return Err(Refusal::ZonesNotFound);
        }
        let differences = if self.layer == Layer::None {
            smooth::differences(self, &coarse, &fine)
        } else {
            rough::differences(self, &coarse, &fine)
        };
        Ok(Reference {
            problem: self,
            differences,
            rounding,
            moved,
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
            violation,
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
        if self.layer == Layer::None {
            // There the potential is the depth.
            return zones.iter().flatten().fold(0.0f64, |most, x| {
                let [level, arm] = self.kernel.lifts(*x);
                let depth = (solved.settlement * level).abs() + (solved.tilt * arm).abs();
                most.max(2.0 * (depth + self.height(x.min(1.0)).abs()))
            });
        }
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
        let mut worst = [0.0f64; 2];
        if self.is_bilateral {
            return worst;
        }
        let is_smooth = self.layer == Layer::None;
        // A wave's zone may reach beyond the seam.
        let zone_of = |x: f64| zones.iter().find(|[left, right]| *left <= x && x <= *right);
        for x in places(self, zones, 9) {
            let beyond =
                if is_smooth { zone_of(x + 2.0).map(|zone| (x + 2.0, zone)) } else { None };
            match zone_of(x).map(|zone| (x, zone)).or(beyond) {
                Some((at, [left, right])) if is_smooth => {
                    // At ends the pressure is a density over sin phi.
                    let sine = 2.0 * ((at - left) * (right - at)).sqrt() / (right - left);
                    worst[0] = worst[0].max(-smooth::pressure(self, solved, x) * sine);
                }
                Some(_) => worst[0] = worst[0].max(-solved.layer(self, x)),
                None => worst[1] = worst[1].max(solved.layer(self, x)),
            }
        }
        worst
    }
}

impl Reference<'_> {
    /// The pressure at a place of the base and its error; on a smooth surface infinite at corners and kinks.
    #[must_use]
    pub fn pressure(&self, x: f64) -> [f64; 2] {
        if self.problem.layer == Layer::None {
            return self.smooth_pressure(x);
        }
        let layers = [&self.coarse, &self.fine].map(|solved| solved.layer(self.problem, x));
        let at = |v: f64| self.problem.pressure(v)[0];
        let [one, two] = layers.map(at);
        // A power kernel weighs what is not resolved beside a place by its own power; the axis of a disk is no end.
        let rest = 1.0 - self.problem.kernel.exponent();
        let is_axis = x == 0.0 && matches!(self.problem.kernel, Kernel::Disk { .. });
        let unresolved = self.fine.grid.unresolved(x).max(self.coarse.grid.unresolved(x));
        let weighed = if is_axis { 0.0 } else { unresolved.powf(rest) / rest };
        let joined = self.problem.theta * at(layers[1]).abs() * 2.0 * weighed;
        let off = self.rounding + joined;
        let rounded = (at(layers[1] + off) - at(layers[1] - off)).abs();
        let on_panel = smooth::find(self.problem, &self.fine, x)
            .map_or(0.0, |found| self.differences[found.index]);
        [two, 2.0 * (one - two).abs().max(on_panel) + rounded]
    }

    fn smooth_pressure(&self, x: f64) -> [f64; 2] {
        let at = |solved: &Solved, x: f64| smooth::pressure(self.problem, solved, x);
        let found = smooth::find(self.problem, &self.fine, x);
        let two = found.as_ref().map_or(0.0, smooth::Found::pressure);
        let on_panel = found.map_or(0.0, |found| self.differences[found.index] / found.rate);
        let differs = (at(&self.coarse, x) - two).abs().max(on_panel);
        // Beside a kink, where the pressure goes as a logarithm, so does what the place is off by.
        let placed = PLACED * x.abs();
        let grainy = [x - placed, x + placed]
            .map(|x| (at(&self.fine, x) - two).abs())
            .into_iter()
            .fold(0.0, f64::max);
        // Near an end, where the pressure goes as a root, what place and end are off by counts.
        let of_zone = |x: f64| {
            let j = self.zones.iter().position(|[left, right]| *left <= x && x <= *right)?;
            let ([left, right], [first, last]) = (self.zones[j], self.moved[j]);
            let off = |d: f64, end: f64| (f64::EPSILON * x.abs() + end) / d.max(f64::MIN_POSITIVE);
            let is_disk = matches!(self.problem.kernel, Kernel::Disk { .. });
            let of_left = if is_disk && left == 0.0 { 0.0 } else { off(x - left, first) };
            Some(of_left + off(right - x, last))
        };
        let off = of_zone(x).or_else(|| of_zone(x + 2.0)).unwrap_or(0.0);
        let rounded = (FIRST_KIND + off) * two.abs() + self.rounding / self.problem.theta;
        [two, 2.0 * differs + grainy + rounded]
    }
}
