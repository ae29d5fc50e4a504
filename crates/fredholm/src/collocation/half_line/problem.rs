//! An equation on the half-line, solved on growing numbers of nodes and on sections of different lengths.

use super::integral::over_half_line;
use super::misfit::Misfit;
use super::section::{Layout, Section, taper};
use super::solution::{HalfLineEstimate, HalfLineSolution};
use crate::collocation::estimate::extrapolate;
use crate::kernel::{Kernel, MacdonaldHalfLine};
use crate::quadrature::places::{Sampled, dominant};
use crate::{Error, Interval};

/// Length of the section beyond `x_max` in units of the length of decay.
const ROOM: f64 = 46.0;
/// The same of the section it is compared with, as a share.
const LESS_ROOM: f64 = 36.0 / 46.0;
/// Growth of the number of nodes.
const RATIO: f64 = std::f64::consts::SQRT_2;
/// Most refinements.
const REFINEMENTS: u32 = 6;
/// Nodes in a decay length far from 0, for the third solution.
const DENSITY: f64 = 3.3;
/// Largest and smallest step of `t` of the third solution. Measured, as is the rest of [`step`].
const STEPS: [f64; 2] = [0.004, 0.12];
/// Slowest power with which the end value is left.
const SLOWEST: f64 = 0.04;
/// Rounding of `f - lambda K phi`, in units of the last place of its terms.
const ROUNDING: f64 = 24.0 * f64::EPSILON;
/// About how many points of each solution are compared.
const POINTS: usize = 500;
/// Differences that no longer fall and are below this share of the solution are rounding.
const STAGNANT: f64 = 1e-9;
/// Safety on what the nodes do not see of the right-hand side.
const SEEN: f64 = 2.0;
/// Agreement of two quadratures of the right-hand side on a section.
const SECTION_ROUNDING: f64 = 1e-12;
/// Safety on the exponential law of the section.
const SAFETY: f64 = 10.0;

/// `phi + lambda int_0^inf K phi ds = f`, to be known up to an end.
pub(super) struct Problem<'p> {
    kernel: &'p MacdonaldHalfLine,
    parameter: f64,
    /// The parameter of the equation in decay lengths, with `kappa = 1`.
    unit_parameter: f64,
    f: &'p dyn Fn(f64) -> f64,
    /// `x_max`, and the same in decay lengths.
    x_max: f64,
    end: f64,
    /// Length, in decay lengths, in which the influence of what is far falls by `e`.
    fall: f64,
    /// `phi/f` for constants, far from 0.
    far: f64,
    /// The step of `t` of the third solution.
    step: f64,
    /// The right-hand side on the section, between the nodes of any grid; places in decay lengths.
    sampled: Sampled,
}

/// One solution, and what is compared.
struct Run {
    solution: HalfLineSolution,
    /// `int T phi ds` with the tail `T` of the kernel, in decay lengths.
    product: f64,
    /// The largest values of `phi` up to the end and of `lambda K phi` on the section.
    largest: [f64; 2],
    misfit: Misfit,
    /// `int f chi dx` with the taper of the section, by its nodes, in decay lengths.
    tapered: f64,
    /// Length of the section, in decay lengths.
    length: f64,
}

/// Differences of two solutions.
#[derive(Clone, Copy)]
struct Difference {
    solution: f64,
    product: f64,
}

impl<'p> Problem<'p> {
    pub(super) fn new(
        kernel: &'p MacdonaldHalfLine,
        parameter: f64,
        f: &'p dyn Fn(f64) -> f64,
        (x_max, cuts): (f64, &[f64]),
    ) -> Result<Self, Error> {
        let end = kernel.decay() * x_max;
        let top = kernel.symbol_at_zero();
        let strength = parameter * top;
        let end_exponent = kernel.end_exponent();
        if end_exponent < SLOWEST {
            return Err(Error::InvalidParameter {
                name: "order",
                value: kernel.order(),
                requirement: "at most 0.48 for collocation: the end value is left as the power 1 - 2 order of the distance, which is still large at \
                              the smallest numbers",
            });
        }
        if strength <= -1.0 {
            return Err(Error::InSpectrum { parameter, top });
        }
        let delta = 0.5 - kernel.order();
        let fall = if strength < 0.0 {
            // 1 - p^2 = |strength|^(1/delta)
            (-((-strength).ln() / delta).exp_m1()).sqrt().recip()
        } else {
            1.0
        };
        let step = step(strength.abs(), end_exponent);
        let unit_parameter = parameter * kernel.unit_scale();
        let far = 1.0 / (1.0 + strength);
        let section = Interval::new(0.0, end + ROOM * fall)?;
        let cuts: Vec<f64> = cuts.iter().map(|x| kernel.decay() * x).collect();
        let sampled = Sampled::new(section, &|xi| f(xi / kernel.decay()), &cuts)?;
        Ok(Self { kernel, parameter, unit_parameter, f, x_max, end, fall, far, step, sampled })
    }

    /// The solution with its estimates.
    pub(super) fn solve(&self, tolerance: f64) -> Result<HalfLineSolution, Error> {
        let (mut run, mut estimate, reference) = self.refined(tolerance)?;
        let shorter = self.run(reference.step, LESS_ROOM * ROOM)?;
        estimate.section = section_error(&self.difference(&shorter, &reference.run), &run);
        if estimate.section > tolerance * run.largest[0] {
            // A coarse section rings from its end: once more on the finest nodes.
            let shorter = self.run(run.solution.step(), LESS_ROOM * ROOM)?;
            estimate.section = section_error(&self.difference(&shorter, &run), &run);
        }
        estimate.solution = estimate.nodes.max(estimate.section).max(run.rounding());
        self.integrate(&mut run, &mut estimate);
        run.solution.estimate = estimate;
        run.solution.converged = estimate.solution <= tolerance * run.largest[0];
        Ok(run.solution)
    }

    /// Solutions on growing numbers of nodes: the last, the estimate of its error and the one before it.
    fn refined(&self, tolerance: f64) -> Result<(Run, HalfLineEstimate, Reference), Error> {
        let first = self.run(RATIO * RATIO * self.step, ROOM)?;
        let step = RATIO * self.step;
        let mut previous = Reference { run: self.run(step, ROOM)?, step };
        let mut before = self.difference(&first, &previous.run);
        let mut refinements = 0;
        loop {
            let step = previous.step / RATIO;
            let run = self.run(step, ROOM)?;
            let difference = self.difference(&previous.run, &run);
            let scale = run.largest[0];
            let rounding = run.rounding();
            let hidden = self.hidden(&run);
            let nodes = extrapolate(before.solution, difference.solution, scale, RATIO)
                .max(SEEN * hidden.solution);
            let product = extrapolate(before.product, difference.product, run.product.abs(), RATIO)
                .max(SEEN * hidden.product);
            let stagnant = difference.solution > 0.5 * before.solution;
            let out_of_reach = rounding > tolerance * scale;
            let settled = (difference.solution <= rounding && hidden.solution <= tolerance * scale)
                || (stagnant && (out_of_reach || difference.solution <= STAGNANT * scale));
            refinements += 1;
            let full = !self.layout(step / RATIO, ROOM).fits();
            if nodes <= tolerance * scale || settled || refinements > REFINEMENTS || full {
                let estimate =
                    HalfLineEstimate { solution: nodes, nodes, section: 0.0, integral: product };
                return Ok((run, estimate, previous));
            }
            previous = Reference { run, step };
            before = difference;
        }
    }

    /// What the nodes miss of the right-hand side, as a misfit between them shows it: `lambda K delta` up to the end, and `int T delta` as it is at most.
    fn hidden(&self, run: &Run) -> Difference {
        let places = self.sampled.places.iter().zip(&self.sampled.values);
        let differences: Vec<f64> = places.map(|(&xi, f)| run.misfit.at(xi, *f)).collect();
        let Some(density) = dominant(&differences, self.sampled.largest) else {
            return Difference { solution: 0.0, product: 0.0 };
        };
        let profile = self.kernel.unit_profile();
        let potential = |x: f64| {
            let term = |(index, delta): &(usize, f64)| {
                let (s, cell) = (self.sampled.places[*index], self.sampled.cell(*index));
                // Within its own cell a singular function has its mean at about a quarter of it.
                delta * cell * profile.pair((x - s).abs().max(0.25 * cell)).value
            };
            density.iter().map(term).sum::<f64>().abs()
        };
        let known = density.iter().filter(|(index, _)| self.sampled.places[*index] <= self.end);
        let top = known.max_by(|one, two| one.1.abs().total_cmp(&two.1.abs()));
        let top = top.map_or(self.end, |(index, _)| self.sampled.places[*index]);
        let worst = [0.0, top, self.end].into_iter().map(potential).fold(0.0, f64::max);
        // (1 + lambda K)^-1 lambda K is at most 1 for a positive kernel, however large lambda is.
        let most = density.iter().fold(0.0f64, |most, (_, delta)| most.max(delta.abs()));
        let solution = (self.unit_parameter.abs() * worst).min(most) * self.far.max(1.0);
        let cells = density.iter().map(|(index, delta)| delta * self.sampled.cell(*index));
        Difference { solution, product: cells.sum::<f64>().abs() }
    }

    fn layout(&self, step: f64, room: f64) -> Layout {
        Layout { length: self.end + room * self.fall, step, stretch: DENSITY * self.step }
    }

    fn run(&self, step: f64, room: f64) -> Result<Run, Error> {
        let layout = self.layout(step, room);
        let (profile, parameter) = (self.kernel.unit_profile(), self.unit_parameter);
        let section = Section::new(profile, self.kernel.end_exponent(), layout)?;
        let sample = |xi: &f64| {
            let x = xi / self.kernel.decay();
            let value = (self.f)(x);
            if value.is_finite() {
                Ok(value)
            } else {
                Err(Error::NotFinite { what: "right-hand side", at: x, value })
            }
        };
        let f: Vec<f64> = section.positions.iter().map(sample).collect::<Result<_, _>>()?;
        let nodal = section.solve(&section.factor(parameter)?, &f);
        let tails = section.tails(profile)?;
        let product = tails.iter().zip(&nodal.masses).map(|(t, m)| t * m).sum();
        let ends = [self.x_max, self.end, layout.length];
        let misfit = Misfit::new(&section, &f, layout.length);
        let tapered = section.integral(&f);
        let solution = HalfLineSolution::new(&section, &nodal, self.kernel, self.parameter, ends);
        let known = section.positions.iter().take_while(|x| **x <= self.end).count().max(1);
        let values = f.iter().zip(&nodal.potential).map(|(f, u)| (f - parameter * u).abs());
        let potential = nodal.potential.iter().fold(0.0, |most: f64, u| most.max(u.abs()));
        let largest = values.take(known).fold(0.0, f64::max);
        let largest = [largest, parameter.abs() * potential];
        Ok(Run { solution, product, largest, misfit, tapered, length: layout.length })
    }

    /// Of the solutions at points between the nodes of either, and of the products.
    fn difference(&self, coarse: &Run, fine: &Run) -> Difference {
        let at = |x: f64| {
            (fine.solution.evaluate_potential(x) - coarse.solution.evaluate_potential(x)).abs()
        };
        let ends = [0.0, fine.solution.end()].into_iter();
        let [of_fine, of_coarse] = [fine, coarse].map(|run| {
            let stride = 1 + run.solution.node_count() / POINTS;
            run.solution.midway().step_by(stride)
        });
        let points = ends.chain(of_fine).chain(of_coarse);
        Difference {
            solution: self.parameter.abs() * points.map(at).fold(0.0, f64::max),
            product: (fine.product - coarse.product).abs(),
        }
    }

    /// `(1 + lambda G^(0)) int phi = int f + lambda int T phi`.
    fn integrate(&self, run: &mut Run, estimate: &mut HalfLineEstimate) {
        let scale = self.fall / self.kernel.decay();
        let Some([whole, error]) = over_half_line(self.f, scale) else {
            estimate.integral = f64::INFINITY;
            return;
        };
        // A quadrature settles without a feature between all its nodes; on the section there is a second one, with other nodes.
        let on_section = |x: f64| (self.f)(x) * taper(self.kernel.decay() * x, run.length);
        let error = match over_half_line(&on_section, scale) {
            Some([again, own]) => {
                let difference = (again - run.tapered / self.kernel.decay()).abs();
                let rounding = SECTION_ROUNDING * (whole.abs() + error);
                if difference > rounding + own { error + difference } else { error }
            }
            None => error,
        };
        // Both in decay lengths but for the integral of f.
        let unit = self.unit_parameter / self.kernel.decay();
        let correction = unit * run.product;
        let integral = self.far * (whole + correction);
        // 1 + lambda G^(0) may be a small difference.
        let condition = (1.0 / self.far - 1.0).abs() * integral.abs();
        let rounding = ROUNDING * (whole.abs() + correction.abs() + condition);
        run.solution.integral = Some(integral);
        estimate.integral = self.far * (error + unit.abs() * estimate.integral + rounding);
    }
}

/// A solution with its step.
struct Reference {
    run: Run,
    step: f64,
}

impl Run {
    fn rounding(&self) -> f64 {
        ROUNDING * (self.largest[0] + self.largest[1])
    }
}

/// The error of a section from the difference to a shorter one: both fall as `e^(-room)` or, for growing right-hand sides, some other exponential.
fn section_error(difference: &Difference, run: &Run) -> f64 {
    let scale = run.largest[0];
    let share = difference.solution / scale;
    if share > 0.0 {
        (SAFETY * scale * share.powf(1.0 / LESS_ROOM)).min(difference.solution)
    } else {
        difference.solution
    }
}

/// The step of `t` that gives about 13 digits for smooth right-hand sides: smaller where the layer at 0 is thin (strong equations), and where the end value is left
/// slowly.
fn step(strength: f64, end_exponent: f64) -> f64 {
    let layers = 1.0 + 0.35 * (strength / 3.0).max(1.0).log10();
    let slow = (2.0 * end_exponent).min(1.0).powf(1.3);
    (STEPS[1] / layers * slow).max(STEPS[0])
}
