//! Plane contact with a layer that follows a power law: an **estimate**, as its residual is sampled.

use crate::bound::{Answer, Bound, MOST_WINDOWS, Prescribed, Problem, Refusal, resample};
use crate::density::Density;
use crate::kernel::Kernel;
use crate::open::free_ends;
use crate::sampled::{Field, Seen, cover, largest};
use crate::shape::Shape;
use crate::{Profile, layer};

/// Unit of rounding.
const UNIT: f64 = 0.5 * f64::EPSILON;
/// Places of a panel where the answer is compared with its resampled pressure.
const COMPARED: [f64; 3] = [0.071_828, 0.371_828, 0.914_159];

/// Estimates the errors of an answer in a layer `p^kappa`, `0 < kappa < 1`, with the tangent stiffness `d(P, M)/d(delta, -alpha)`.
///
/// As for [a disk](crate::audit_disk), by the complete maximum principle. The power has it; the logarithm and the row have it after a constant `c` is added to them, which is as good
/// as a settlement of `theta c P`: nothing where the force is prescribed, else at most `c/V` times the residual, `V` the energy of the equilibrium on the base. What force and moment that are
/// prescribed make of a free tilt is estimated by the tangent.
///
/// # Errors
/// [`Refusal`] where the residual was not resolved.
pub fn audit_bent(
    problem: &Problem<'_>,
    kappa: f64,
    stiffness: [[f64; 2]; 2],
    answer: &Answer<'_>,
) -> Result<Bound, Refusal> {
    let panels = resample(problem, answer)?;
    let shape = Shape::new(&panels, problem.is_bilateral);
    let density = Density::new(problem.kernel, panels);
    let mut audit = Audit { problem, answer, kappa, density, shape, shift: [0.0; 2], misfit: 0.0 };
    audit.misfit = audit.misfit();
    audit.settle();
    let (mut zones, mut gaps) = (Vec::new(), Vec::new());
    let refused = |error: crate::residual::TooManyWindows| Refusal::TooManyWindows { at: error.at };
    for panel in &audit.density.panels {
        cover(&audit, [panel.left, panel.right], true, MOST_WINDOWS, &mut zones)
            .map_err(refused)?;
    }
    for gap in audit.gaps() {
        cover(&audit, gap, false, MOST_WINDOWS, &mut gaps).map_err(refused)?;
    }
    Ok(audit.stated(stiffness, &zones, &gaps))
}

struct Audit<'a> {
    problem: &'a Problem<'a>,
    answer: &'a Answer<'a>,
    kappa: f64,
    density: Density,
    shape: Shape,
    /// What settlement and tilt are taken to be beside those of the answer.
    shift: [f64; 2],
    misfit: f64,
}

impl Field for Audit<'_> {
    fn residual(&self, x: f64) -> (f64, f64) {
        let problem = self.problem;
        let is_inside = self.density.panel_at(x).is_some();
        let q = if is_inside { (self.answer.pressure)(x) } else { 0.0 };
        // What pulls by rounding is cut off.
        let q = if problem.is_bilateral { q } else { q.max(0.0) };
        let layer = layer::displacement(self.kappa, q);
        let (potential, rounding) = self.density.potential(x);
        let [low, high] = problem.profile.height(x);
        let height = 0.5 * (low + high);
        let [settlement, tilt] =
            [self.answer.settlement + self.shift[0], self.answer.tilt + self.shift[1]];
        let value = layer + problem.theta * potential - (settlement - tilt * x - height);
        let given = settlement.abs() + tilt.abs() + height.abs();
        let size = 4.0 * (layer.abs() + problem.theta * potential.abs() + given);
        let scaled = problem.scaled * (problem.theta * potential.abs() + given);
        let noise = problem.theta * (rounding + self.misfit) + (high - low);
        (value, noise + UNIT * size + scaled)
    }

    fn profile(&self) -> Option<&dyn Profile> {
        Some(self.problem.profile)
    }
}

/// A bound of the potential of a density of size one on an interval of this width.
fn narrow(width: f64, kernel: Kernel) -> f64 {
    let mu = kernel.singularity().exponent();
    let own = if mu == 0.0 {
        width * (3.0 + width.ln().abs())
    } else {
        4.0 * width.powf(1.0 - mu) / (1.0 - mu)
    };
    own.min(kernel.mass())
}

/// The constant after whose addition the kernel has the complete maximum principle, and the energy `V` of the equilibrium without it.
fn principle(kernel: Kernel) -> [f64; 2] {
    use std::f64::consts::{LN_2, PI};
    match kernel {
        // In angles the inverse of the logarithm has the jumps (1/4 sin^2 + 1/4 sin^2)/pi^2 >= 1/(2 pi^2), and those of the constant 1/(pi^2 (ln 2 + c)).
        Kernel::Logarithm => [2.0 - LN_2, LN_2],
        Kernel::ShiftedLogarithm { constant } => {
            [(2.0 - LN_2 - constant).max(0.0), LN_2 + constant]
        }
        // 1/(4 pi^2 sin^2) >= 1/(4 pi^2) and 1/(4 pi^2 c).
        Kernel::Row { period } => [1.0, -(PI / period).sin().ln()],
        Kernel::Power { .. } => [0.0, 1.0],
    }
}

impl Audit<'_> {
    /// An estimate of the potential of what the panels miss of the pressure between the nodes: it changes its sign on each, so that squares are added.
    fn misfit(&self) -> f64 {
        let panels = self.density.panels.iter();
        let missed = panels.map(|panel| {
            let places = COMPARED.map(|t| panel.left + t * (panel.right - panel.left));
            let differences = places.map(|x| (panel.evaluate(x) - (self.answer.pressure)(x)).abs());
            let largest = differences.into_iter().fold(0.0, f64::max);
            (largest * narrow(2.0 * panel.half(), self.problem.kernel)).powi(2)
        });
        missed.sum::<f64>().sqrt()
    }

    /// The free ones of settlement and tilt that leave the least residual at the middles of the panels.
    fn settle(&mut self) {
        let Prescribed { force, moment } = self.problem.prescribed;
        let places: Vec<[f64; 3]> = (self.density.panels.iter())
            .map(|panel| [panel.middle(), 2.0 * panel.half(), self.residual(panel.middle()).0])
            .collect();
        let sum = |u: &dyn Fn(f64, f64) -> f64| -> f64 {
            places.iter().map(|[x, weight, w]| weight * u(*x, *w)).sum()
        };
        let length = sum(&|_, _| 1.0);
        let middle = if force.is_some() { sum(&|x, _| x) / length } else { 0.0 };
        let d = if force.is_some() { sum(&|_, w| w) / length } else { 0.0 };
        let square = sum(&|x, _| (x - middle) * (x - middle));
        let is_turning = moment.is_some() && square > 0.0;
        let a = if is_turning { -sum(&|x, w| (w - d) * (x - middle)) / square } else { 0.0 };
        if d.is_finite() && a.is_finite() {
            self.shift = [d + a * middle, a];
        }
    }

    /// The intervals of the base beside the zones.
    fn gaps(&self) -> Vec<[f64; 2]> {
        let mut gaps = Vec::new();
        for [left, right] in self.problem.pieces {
            let mut from = *left;
            let zones = self.answer.zones.iter();
            for zone in zones.filter(|zone| zone[1] >= *left && zone[0] <= *right) {
                if zone[0] > from {
                    gaps.push([from, zone[0]]);
                }
                from = from.max(zone[1]);
            }
            if from < *right {
                gaps.push([from, *right]);
            }
        }
        gaps
    }

    fn stated(&self, stiffness: [[f64; 2]; 2], zones: &[Seen], gaps: &[Seen]) -> Bound {
        let Prescribed { force, moment } = self.problem.prescribed;
        let seen = || zones.iter().chain(gaps);
        let residual = seen().map(|window| window.square).sum::<f64>().sqrt();
        let [constant, energy] = principle(self.problem.kernel);
        // A force that is not prescribed is off, which is as good as a settlement.
        let of_force = if force.is_some() { 1.0 } else { 1.0 + constant / energy };
        let highest = self.density.largest();
        let softest = layer::softest(self.kappa, highest);
        let together: Vec<Seen> = seen().copied().collect();
        let potential = |width: f64| self.problem.theta * narrow(width, self.problem.kernel);
        let largest = largest(&together, softest, potential);
        let missing = |prescribed: Option<f64>, own: f64, rounding: f64| {
            prescribed.map_or(0.0, |value| (value - own).abs() + rounding)
        };
        // What force and moment are off by where settlement and tilt are as they are, and what that makes of these.
        let moved = 2.0 * of_force * largest * softest * self.shape.length;
        let [[k11, k12], [_, k22]] = stiffness;
        let [off_force, off_moment] = [
            missing(force, self.shape.force, self.shape.rounding[0]),
            missing(moment, self.shape.moment, self.shape.rounding[1]),
        ];
        let [settled, tilted] = match (force, moment) {
            (Some(_), Some(_)) => {
                let determinant = k11 * k22 - k12 * k12;
                let [p, m] = [moved + off_force, moved + off_moment];
                [(k22 * p + k12.abs() * m) / determinant, (k11 * m + k12.abs() * p) / determinant]
            }
            (Some(_), None) => [largest + off_force / k11, 0.0],
            (None, Some(_)) => [0.0, (moved + off_moment) / k22],
            (None, None) => [0.0; 2],
        };
        let shift = settled + tilted;
        let margin = of_force * (largest + shift);
        let off = seen().map(|window| self.pressure_error(window, margin + shift));
        let off = off.fold(0.0, f64::max);
        let open = gaps.iter().filter(|gap| gap.least <= margin + shift);
        let length = self.shape.length + open.map(|gap| gap.right - gap.left).sum::<f64>();
        let moved = length * off + self.shape.rounding[0] + self.shape.rounding[1];
        let unless = |given: bool, value: f64| if given { 0.0 } else { value };
        Bound {
            mean_square: residual * layer::softest(self.kappa, highest + off),
            pressure: off,
            highest: Some(crate::highest::highest(&self.density.panels, off) + off),
            settlement: unless(force.is_none(), settled + self.shift[0].abs()),
            tilt: unless(moment.is_none(), tilted + self.shift[1].abs()),
            force: unless(force.is_some(), moved + (self.answer.force - self.shape.force).abs()),
            moment: unless(
                moment.is_some(),
                moved + (self.answer.moment - self.shape.moment).abs(),
            ),
            ends: self.ends(gaps, [off, margin + shift]),
            residual,
            panels: self.density.panels.len(),
            windows: zones.len() + gaps.len(),
        }
    }

    /// What the pressure in a window may be off by where potential and displacements may be by this.
    fn pressure_error(&self, window: &Seen, off: f64) -> f64 {
        let pressure = |x: f64| (self.answer.pressure)(x).abs();
        let highest = pressure(window.left).max(pressure(window.right));
        layer::pressure_error(self.kappa, highest, window.largest + off)
    }

    fn ends(&self, gaps: &[Seen], limits: [f64; 2]) -> Option<f64> {
        let is_end = |x: f64| self.problem.pieces.iter().flatten().any(|end| *end == x);
        let zones = self.answer.zones.iter();
        let ends = zones.flat_map(|[left, right]| [[*left, *right], [*right, *left]]);
        let free: Vec<[f64; 2]> = ends.filter(|[end, _]| !is_end(*end)).collect();
        free_ends(&free, gaps, &|x| self.density.evaluate(x), limits)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::closed::Base;

    /// `p = sqrt(c^2 - x^2)` has the potential `pi c^2/2 (ln(2/c) + 1/2) - pi/2 x^2` on `|x| < c`, and less beyond.
    #[test]
    fn disturbed_answers_are_found_out() {
        for (c, theta, kappa) in
            [(1.0, 1.0, 0.5), (1.0, 40.0, 0.8), (0.6, 2.0, 0.7), (0.5, 90.0, 0.9)]
        {
            let base = Base { c, bend: 0.5 * theta * PI, kappa };
            let settlement = theta * PI * c * c / 2.0 * ((2.0 / c).ln() + 0.5);
            let force = 0.5 * PI * c * c;
            let exact = |x: f64| ((c - x) * (c + x)).max(0.0).sqrt();
            for by_force in [true, false] {
                for size in [0.0, 1e-9, 1e-4] {
                    let pressure = |x: f64| exact(x) * (1.0 + size * (3.0 * x + 0.4).cos());
                    let problem = Problem {
                        kernel: Kernel::Logarithm,
                        theta,
                        scaled: 0.0,
                        pieces: &[[-1.0, 1.0]],
                        is_bilateral: false,
                        prescribed: Prescribed { force: by_force.then_some(force), moment: None },
                        profile: &base,
                        cuts: &[],
                    };
                    let off = if by_force { size } else { 0.0 };
                    let answer = Answer {
                        zones: &[[-c, c]],
                        pressure: &pressure,
                        settlement: settlement + off,
                        tilt: 0.0,
                        force,
                        moment: 0.0,
                    };
                    // Only the rounding of the load comes in by it.
                    let stiffness = [[1.0 / (1.0 + theta), 0.0], [0.0, 1.0]];
                    let bound = audit_bent(&problem, kappa, stiffness, &answer).unwrap();
                    let worst = (-500..=500)
                        .map(|k| c * f64::from(k) / 500.0)
                        .map(|x| (pressure(x) - exact(x)).abs())
                        .fold(0.0, f64::max);
                    println!("{c} {theta} {kappa} {by_force} {size:e}: {worst:e} {bound:?}");
                    let slack = 1e-15 * (1.0 + theta);
                    assert!(bound.pressure >= worst - slack && bound.settlement >= off - slack);
                    let idle = if size > 0.0 { 40.0 * (1.0 + theta) * worst } else { 0.0 };
                    assert!(bound.pressure <= idle + 1e-11 * (1.0 + theta), "idle");
                }
            }
        }
    }
}
