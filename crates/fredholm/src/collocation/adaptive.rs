//! The number of nodes chosen by the estimate of the error.

use std::f64::consts::SQRT_2;
use std::sync::Arc;

use super::check::Check;
use super::estimate::largest;
use super::mesh::{Mesh, boundaries};
use super::operator::require_finite_parameter;
use super::resolution::{Misfit, between_numbers};
use super::{Estimate, SincFactor, SincGrid, SincOperator, SincSolution};
use crate::Error;
use crate::kernel::Kernel;
use crate::quadrature::places::Sampled;

/// Growth of the number of nodes where they do not see the right-hand side.
const RATIO: f64 = SQRT_2;
/// Least and most growth of the number of nodes.
const LEAST_GROWTH: f64 = 1.2;
const MOST_GROWTH: f64 = 2.0;
/// The tolerance for which numbers of nodes were measured, and how much fewer are tried first for coarser ones.
const MEASURED: f64 = 1e-12;
const LEAST_SHARE: f64 = 0.4;
/// Errors that fall by less than this from one number of nodes to the next may fluctuate.
const SLOW: f64 = 0.25;
/// Safety on those.
const SAFETY_SLOW: f64 = 3.0;
/// Nodes on either side of the middle that corners need, times the power with which solutions leave their end values. Measured, power kernels with exponents of 0.7 to 0.9.
const IN_CORNERS: f64 = 38.0;
/// The same where the ends differ. Measured, Weber-Sonine kernels with `gamma` of 0.25 and 0.4.
const IN_UNLIKE_CORNERS: f64 = 48.0;
/// Nodes on either side for each power of `x` as which solutions vanish at the centre. Measured, Weber-Sonine kernel of order 5.
const AT_CENTRE: f64 = 17.0;
/// Fewest nodes on either side of the middle of a panel.
const LEAST_HALF_COUNT: usize = 4;
/// Most nodes on either side of the middle of a panel.
const LARGEST_HALF_COUNT: usize = 1500;
/// Most nodes on either side of the middles of all panels together.
const LARGEST_TOTAL: usize = 3999;
/// Differences that no longer fall and are below this share of the solution are rounding.
const STAGNANT: f64 = 1e-9;
/// Most breakpoints, with those that were found.
const MOST_JOINTS: usize = 24;
/// Safety on what the nodes miss of the right-hand side.
const SAFETY: f64 = 2.0;
/// What is missed after a round, over what was before, from which on another round is in vain.
const STUCK: f64 = 0.5;

/// A solution with the estimate of its error.
#[derive(Debug, Clone)]
pub struct AdaptiveSolution {
    /// The solution on the finest nodes.
    pub solution: SincSolution,
    /// The estimate of its error.
    pub estimate: Estimate,
    /// Whether the estimate meets the tolerance; if not, this is the best that was reached.
    pub converged: bool,
    /// Nodes on either side of the middle of each panel.
    pub half_count: usize,
}

/// Solves `phi + parameter K phi = f` to a tolerance relative to the largest value of the solution, by collocation on
/// growing numbers of nodes.
///
/// The error is that which a rule on twice as many nodes finds, between the nodes as well as at them; and the right-hand side itself is looked at, at some 6000 places that no
/// grid has: where a narrow feature lies between the nodes it gets panels of its own, and what stays unresolved is part of the estimate.
///
/// **What a sampled function can hide.** `f` is known where it was asked, and nowhere else. A feature narrower than about a 4000th of the interval may lie between all
/// those places too; nothing shows it then, and the estimate does not hold. Name it as a breakpoint ([`solve_adaptive_with_breaks`]) where you know of it.
///
/// ```
/// use fredholm::collocation::solve_adaptive;
/// use fredholm::kernel::Logarithm;
///
/// let found = solve_adaptive(&Logarithm::unit(), 60.0, f64::exp, 1e-11)?;
/// assert!(found.converged && found.estimate.solution < 1e-11);
/// let exact = 0.029_684_678_799_719_241; // mpmath, 40 digits
/// assert!((found.solution.integral(|_| 1.0) - exact).abs() < 1e-13);
/// # Ok::<(), fredholm::Error>(())
/// ```
///
/// # Errors
/// [`Error::InvalidParameter`] for a tolerance that is not positive or a parameter that is not finite; [`Error::NotFinite`] where `f` is not finite; as
/// [`SincOperator::sample`] and [`SincOperator::factor`]. A tolerance that is out of reach is no error: see
/// [`AdaptiveSolution::converged`].
pub fn solve_adaptive(
    kernel: &dyn Kernel,
    parameter: f64,
    f: impl Fn(f64) -> f64,
    tolerance: f64,
) -> Result<AdaptiveSolution, Error> {
    solve_adaptive_with_breaks(kernel, &[], parameter, f, tolerance)
}

/// [`solve_adaptive`] for a right-hand side with kinks or jumps, or narrow features, at the breakpoints.
///
/// # Errors
/// As [`solve_adaptive`]; [`Error::InvalidParameter`] for a bad breakpoint.
pub fn solve_adaptive_with_breaks(
    kernel: &dyn Kernel,
    breaks: &[f64],
    parameter: f64,
    f: impl Fn(f64) -> f64,
    tolerance: f64,
) -> Result<AdaptiveSolution, Error> {
    solve_adaptive_in_parts(kernel, breaks, &[], parameter, f, tolerance)
}

/// [`solve_adaptive_with_breaks`] for a right-hand side of which more is known than its values: that it is nearly a polynomial of a degree below 32 on each of the parts into which cuts, in any
/// order, divide the interval. It is looked at in every part, so that nothing is hidden.
///
/// ```
/// use fredholm::collocation::solve_adaptive_in_parts;
/// use fredholm::kernel::Logarithm;
///
/// // Narrow; the cuts say where to look.
/// let (centre, width) = (0.1234, 1e-4);
/// let f = |x: f64| 1.0 + (-((x - centre) / width).powi(2)).exp();
/// let cuts: Vec<f64> = (-6..=6).map(|i| centre + f64::from(i) * width).collect();
/// let found = solve_adaptive_in_parts(&Logarithm::unit(), &[], &cuts, 1.0, f, 1e-11)?;
/// let without = solve_adaptive_in_parts(&Logarithm::unit(), &[], &[], 1.0, |_| 1.0, 1e-11)?;
/// let difference = found.solution.evaluate(centre, 2.0) - without.solution.evaluate(centre, 1.0);
/// // The bump adds its own potential, about -sqrt(pi) width ln(1/width).
/// assert!((difference - 1.0 + 1.7e-3).abs() < 5e-4);
/// # Ok::<(), fredholm::Error>(())
/// ```
///
/// # Errors
/// As [`solve_adaptive_with_breaks`].
pub fn solve_adaptive_in_parts(
    kernel: &dyn Kernel,
    breaks: &[f64],
    cuts: &[f64],
    parameter: f64,
    f: impl Fn(f64) -> f64,
    tolerance: f64,
) -> Result<AdaptiveSolution, Error> {
    require_finite_parameter(parameter)?;
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::InvalidParameter {
            name: "tolerance",
            value: tolerance,
            requirement: "finite and positive",
        });
    }
    // A bad interval or breakpoint is refused before the function is asked for thousands of values.
    boundaries(kernel.interval(), breaks)?;
    let strength = parameter * kernel.interval().half_length();
    let least = sufficient_half_count(strength).max(kernel.first_half_count());
    let sampled = Sampled::new(kernel.interval(), &f, cuts)?;
    let panels = sampled.partition(&f, breaks, tolerance);
    let joints = panels.as_deref().map(|panels| sampled.joints(panels, breaks));
    let sampled = match panels {
        Some(panels) => sampled.thinned(&f, &panels),
        None => sampled,
    };
    let problem = Problem { kernel, parameter, f: &f, tolerance, least, sampled: &sampled };
    let breaks = problem.with_joints(breaks, &joints.unwrap_or_default())?;
    problem.resolved(&breaks)
}

fn grid(kernel: &dyn Kernel, half_count: f64) -> Result<Arc<SincGrid>, Error> {
    Ok(Arc::new(SincGrid::new(kernel, (half_count.round() as usize).max(LEAST_HALF_COUNT))?))
}

/// Most nodes on either side of the middle of a panel, where there are so many breakpoints.
fn most(breaks: &[f64]) -> usize {
    LARGEST_HALF_COUNT.min(LARGEST_TOTAL / (breaks.len() + 1))
}

struct Problem<'p> {
    kernel: &'p dyn Kernel,
    parameter: f64,
    f: &'p dyn Fn(f64) -> f64,
    tolerance: f64,
    /// Fewest nodes on either side of the middle of a panel.
    least: f64,
    sampled: &'p Sampled,
}

impl Problem<'_> {
    /// The breakpoints with those of narrow features: of several choices the one on whose panels the nodes miss least.
    fn with_joints(&self, breaks: &[f64], choices: &[Vec<f64>; 2]) -> Result<Vec<f64>, Error> {
        let mut best = (f64::INFINITY, breaks.to_vec());
        for joints in choices.iter().filter(|joints| !joints.is_empty()) {
            let all: Vec<f64> = breaks.iter().chain(joints).copied().collect();
            if all.len() > MOST_JOINTS {
                continue;
            }
            let Ok(first) = self.first(&all) else { continue };
            let grid = grid(self.kernel, first)?;
            let mesh = Mesh::new(grid, self.kernel.interval(), &all)?;
            let misfit = Misfit::new(&mesh, self.f, self.sampled)?.mean();
            if misfit < best.0 {
                best = (misfit, all);
            }
        }
        Ok(best.1)
    }

    /// A solution on nodes that see the right-hand side, as far as that can be had.
    fn resolved(&self, breaks: &[f64]) -> Result<AdaptiveSolution, Error> {
        let (mut before, mut start) = (f64::INFINITY, self.first(breaks)?);
        loop {
            let (mut found, growth) = self.refined(breaks, start)?;
            let missed =
                Misfit::new(found.solution.mesh(), self.f, self.sampled)?.missed(self.kernel);
            let scale = largest(found.solution.values());
            // (1 + lambda K)^-1 lambda K is at most 1 for a positive kernel, however large lambda is.
            let unseen = (self.parameter.abs() * missed.potential).min(missed.largest);
            let unseen = SAFETY * growth * unseen;
            let larger = RATIO * found.half_count as f64;
            let may_grow = larger <= most(breaks) as f64 && found.converged;
            if unseen > self.tolerance * scale && unseen < STUCK * before && may_grow {
                (before, start) = (unseen, larger);
                continue;
            }
            let unknown =
                between_numbers(found.solution.mesh(), self.kernel, self.f, self.sampled.largest);
            let strength = self.parameter.abs();
            let at_ends = growth * (strength * unknown.potential).min(unknown.largest)
                + growth * scale * (strength * unknown.tail).min(1.0);
            found.estimate.solution = found.estimate.solution.max(unseen).max(at_ends);
            found.estimate.integral += SAFETY * growth * missed.integral;
            found.estimate.first_moment += SAFETY * growth * missed.first_moment;
            found.converged = found.estimate.solution <= self.tolerance * scale;
            return Ok(found);
        }
    }

    /// How many nodes on either side of the middle of a panel are tried first: the weaker the power with which solutions leave their end values, the more there are in the corners.
    fn first(&self, breaks: &[f64]) -> Result<f64, Error> {
        let most = most(breaks);
        if self.least.round() > most as f64 {
            return Err(self.too_many(breaks, most));
        }
        let (at_ends, at_centre) = (self.kernel.end_exponent(), self.kernel.centre_exponent());
        let in_corners = if self.kernel.is_even() { IN_CORNERS } else { IN_UNLIKE_CORNERS };
        let is_smooth = at_ends >= 1.0 && at_centre == 0.0;
        let corners = if is_smooth { 0.0 } else { in_corners / at_ends.min(1.0) };
        let corners = corners + AT_CENTRE * at_centre;
        let share = (self.tolerance.ln() / MEASURED.ln()).clamp(LEAST_SHARE, 1.0);
        Ok((share * self.least.max(corners)).min(most as f64))
    }

    /// What asks for more nodes than there may be: the kernel, or else the breakpoints.
    fn too_many(&self, breaks: &[f64], most: usize) -> Error {
        let of_kernel = self.kernel.first_half_count();
        if of_kernel > most as f64 {
            return Error::BeyondMethod {
                what: "number of nodes on either side that so narrow a kernel needs",
                value: of_kernel.round(),
                limit: "at most 1500, and fewer between breakpoints: a shorter interval or a kernel that falls more slowly (a smaller kappa) needs fewer",
            };
        }
        Error::BeyondMethod {
            what: "number of breakpoints",
            value: breaks.len() as f64,
            limit: "at most 8001 nodes over all panels between them: fewer kinks and steps need fewer",
        }
    }

    /// Solutions on growing numbers of nodes until their errors say that it is enough; the last, and by what errors grow.
    fn refined(&self, breaks: &[f64], start: f64) -> Result<(AdaptiveSolution, f64), Error> {
        let most = most(breaks);
        let mut half_count = (start.round() as usize).max(LEAST_HALF_COUNT);
        let mut before = f64::INFINITY;
        loop {
            let Level { solution, error, growth, rounding, sizes } =
                self.level(breaks, half_count)?;
            let scale = largest(solution.values());
            let is_slow = error.solution > SLOW * before;
            let mut estimate = error.stated(scale, rounding, sizes);
            if is_slow {
                estimate.solution = estimate.solution.max(SAFETY_SLOW * before);
            }
            let wanted = self.tolerance * scale;
            let converged = estimate.solution <= wanted;
            let is_stagnant = error.solution > STUCK * before;
            let is_rounding =
                error.solution <= rounding || (is_stagnant && error.solution <= STAGNANT * scale);
            let next = following(half_count, estimate.solution / scale, self.tolerance).min(most);
            if converged || is_rounding || next == half_count {
                let found = AdaptiveSolution { solution, estimate, converged, half_count };
                return Ok((found, growth));
            }
            half_count = next;
            before = error.solution;
        }
    }

    /// By what errors of the right-hand side and rounding grow, at least 1: `(1 + parameter K)^-1` is at most 1 in `L2` where nothing is negative; elsewhere from the solution itself and from
    /// that for a step in the middle, in which every eigenfunction has its share.
    fn growth(&self, factor: &SincFactor<'_>, solution: &SincSolution) -> Result<f64, Error> {
        if self.parameter >= 0.0 {
            return Ok(1.0);
        }
        let centre = self.kernel.interval().centre();
        let places = solution.mesh().positions().iter();
        let step: Vec<f64> = places.map(|x| if *x < centre { 0.0 } else { 1.0 }).collect();
        let answer = largest(factor.solve(&step)?.values());
        Ok((largest(solution.values()) / self.sampled.largest).max(answer).max(1.0))
    }

    /// The solution on so many nodes.
    fn level(&self, breaks: &[f64], half_count: usize) -> Result<Level, Error> {
        let finer = Arc::new(SincGrid::new(self.kernel, 2 * half_count)?);
        let mesh = Mesh::new(Arc::new(finer.coarser()), self.kernel.interval(), breaks)?;
        let finer = mesh.with_grid(finer);
        let operator = SincOperator::on_mesh(self.kernel, mesh)?;
        let factor = operator.factor(self.parameter)?;
        let solution = factor.solve(&operator.sample(self.f)?)?;
        let growth = self.growth(&factor, &solution)?;
        let rounding = growth * operator.rounding(&solution)?;
        let check = Check { kernel: self.kernel, operator: &operator, finer };
        let error = check.error(&factor, &solution, self.f)?;
        let centre = operator.interval().centre();
        let sizes = [
            operator.integral_of_size(|x| self.kernel.mass_function(x)),
            operator.integral_of_size(|x| x - centre),
        ];
        Ok(Level { solution, error, growth, rounding, sizes })
    }
}

/// A solution with its error as it was found, and the rounding it carries.
struct Level {
    solution: SincSolution,
    error: Estimate,
    growth: f64,
    rounding: f64,
    /// The integrals of `|u|` and `|x - c|`.
    sizes: [f64; 2],
}

/// How many nodes are tried next where the error, relative to the solution, is larger than the tolerance: in proportion to the digits, for errors that fall as `exp(-c n)`.
fn following(half_count: usize, error: f64, tolerance: f64) -> usize {
    let growth = tolerance.ln() / error.ln();
    let growth = if error < 1.0 { growth.clamp(LEAST_GROWTH, MOST_GROWTH) } else { MOST_GROWTH };
    (half_count as f64 * growth).ceil() as usize
}

/// Nodes on either side of the middle that give about 13 digits for the logarithm and a right-hand side of a few terms, as the finest of three that are compared; `strength` is
/// `lambda` times the half-length. Measured.
#[must_use]
pub fn first_half_count(strength: f64) -> f64 {
    half_count(22.0, 16.0, strength)
}

/// The same for 12 digits on nodes that stand alone.
fn sufficient_half_count(strength: f64) -> f64 {
    half_count(27.0, 15.0, strength)
}

/// So many nodes for a small parameter, and so many more for each decade of a large one.
fn half_count(least: f64, more: f64, strength: f64) -> f64 {
    (least + more * strength.abs().max(1.0).log10()).min(160.0)
}
