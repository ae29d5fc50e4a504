//! Estimates of the error from solutions on different numbers of nodes.

use super::SincSolution;
use crate::Error;

/// Rounding of `phi = f - lambda K phi` beside the sum of its terms. Survey, see [`SincOperator::rounding`](super::SincOperator::rounding).
pub(super) const ROUNDING: f64 = 12.0 * f64::EPSILON;
/// From here on convergence is not geometric: `h^2` of a kink gives 1/2, and fluctuates.
const SLOW: f64 = 0.25;
/// Safety on differences that fall slowly or not at all.
const SAFETY_SLOW: f64 = 3.0;
/// Safety on the geometric model.
const SAFETY: f64 = 10.0;

/// Safety on an error that was found from the residual at some places. Survey, see [`solve_adaptive`](super::solve_adaptive).
const SAFETY_FOUND: f64 = 5.0;
/// Errors above this share of the solution are no small part of it.
const UNKNOWN: f64 = 1e-3;

/// An estimate of the error of a solution: likely, not guaranteed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Of the largest error of the solution on the closed interval.
    pub solution: f64,
    /// Of the error of the integral `int phi dm`, with the [mass function](crate::kernel::Kernel::mass_function) of the kernel where it has one.
    pub integral: f64,
    /// Of the error of `int (x - c) phi dx` about the middle `c` of the interval.
    pub first_moment: f64,
}

impl Estimate {
    /// Differences of two solutions of one equation on different numbers of nodes, the solution's as the largest over a
    /// dense set of points **between** the nodes: force and end values converge long before them where the right-hand side
    /// oscillates.
    ///
    /// They estimate the error of the coarser solution and exceed that of the finer.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] when the solutions have different parameters, [`Error::WrongLength`] when they have
    /// different panels.
    pub fn between(coarse: &SincSolution, fine: &SincSolution) -> Result<Self, Error> {
        Self::weighted(coarse, fine, &|_| 1.0)
    }

    /// The same with the integral `int u phi dm`.
    pub(super) fn weighted(
        coarse: &SincSolution,
        fine: &SincSolution,
        mass_function: &dyn Fn(f64) -> f64,
    ) -> Result<Self, Error> {
        if coarse.parameter().to_bits() != fine.parameter().to_bits() {
            return Err(Error::InvalidParameter {
                name: "parameter of the coarser solution",
                value: coarse.parameter(),
                requirement: "that of the finer solution",
            });
        }
        let boundaries = fine.mesh().boundaries();
        if coarse.mesh().boundaries() != boundaries
            || coarse.mesh().panels() != fine.mesh().panels()
        {
            return Err(Error::WrongLength {
                what: "list of panels of the coarser solution",
                found: coarse.mesh().panels(),
                expected: fine.mesh().panels(),
            });
        }
        let centre = 0.5 * boundaries[0] + 0.5 * boundaries[boundaries.len() - 1];
        let difference = |u: &dyn Fn(f64) -> f64| (fine.integral(u) - coarse.integral(u)).abs();
        Ok(Self {
            solution: fine.parameter().abs() * potential_difference(coarse, fine),
            integral: difference(mass_function),
            first_moment: difference(&|x| x - centre),
        })
    }

    /// What is stated of a solution of this scale with errors that were found as these, and with this rounding; `sizes` are those of the two integrals of a function that is 1 in size. Where
    /// the error is no small part of the solution, the solution is not resolved, and its whole scale is stated.
    pub(super) fn stated(&self, scale: f64, rounding: f64, sizes: [f64; 2]) -> Self {
        let least = if self.solution > UNKNOWN * scale { scale } else { rounding };
        let [integral, first_moment] = sizes.map(|size| least * size);
        Self {
            solution: (SAFETY_FOUND * self.solution).max(least),
            integral: (SAFETY_FOUND * self.integral).max(integral),
            first_moment: (SAFETY_FOUND * self.first_moment).max(first_moment),
        }
    }
}

/// Rounding that the difference `f - lambda K phi` carries: a floor of the error of any value of a solution. That of the kernel comes on top, see
/// [`SincOperator::rounding`](super::SincOperator::rounding).
#[must_use]
pub fn rounding(solution: &SincSolution) -> f64 {
    ROUNDING
        * (largest(solution.values()) + solution.parameter().abs() * largest(solution.potential()))
}

pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

/// The error of the finest of three solutions on numbers of nodes that grow by `ratio`, from the differences `first` (coarsest to
/// middle) and `second` (middle to finest) of a quantity of size `scale`: the larger of the algebraic and the geometric model, see
/// [`Estimate`]; for differences that hardly fall three times the larger. An estimate.
#[must_use]
pub fn extrapolate(first: f64, second: f64, scale: f64, ratio: f64) -> f64 {
    let rate = second / first;
    if second == 0.0 {
        return 0.0;
    }
    if rate >= SLOW || rate.is_nan() {
        return SAFETY_SLOW * first.max(second);
    }
    let algebraic = second * rate / (1.0 - rate);
    let geometric = SAFETY * scale * (second / scale).powf(ratio);
    algebraic.max(geometric).min(second)
}

/// A bound of `|K phi|` of one less that of the other over the points midway between the finer nodes and the coarser nodes:
/// the interpolated parts are compared there, the straight lines at their ends.
fn potential_difference(coarse: &SincSolution, fine: &SincSolution) -> f64 {
    let ends = fine.boundaries().iter().zip(coarse.boundaries());
    let lines = ends.fold(0.0, |largest: f64, (fine, coarse)| largest.max((fine - coarse).abs()));
    let mut bubbles = 0.0f64;
    for panel in 0..fine.mesh().panels() {
        let midway = points(fine, 0.5);
        for t in midway.chain(points(coarse, 0.0)) {
            bubbles =
                bubbles.max((fine.interpolate(panel, t) - coarse.interpolate(panel, t)).abs());
        }
    }
    lines + bubbles
}

/// The nodes in `t`, moved by a share of the step.
fn points(solution: &SincSolution, shift: f64) -> impl Iterator<Item = f64> + use<> {
    let (half_count, step) = (solution.mesh().grid().half_count(), solution.mesh().grid().step());
    (0..=2 * half_count).map(move |j| (j as f64 - half_count as f64 + shift) * step)
}
