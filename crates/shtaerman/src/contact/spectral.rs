//! Bilateral contact by the degenerate kernel, sections 2 and 3.

use fredholm::basis::{ChebyshevSeries, Function};
use fredholm::bounds::{Given, IteratedSolution, Kind, ResidualOperator, Responses};
use fredholm::kernel::Logarithm;
use fredholm::{DegenerateSolution, DegenerateSolver};

use super::accuracy::{Accuracy, ErrorKind};
use super::balance::{Balance, State};
use super::method::Method;
use super::potential::Potential;
use super::stiffness::Stiffness;
use super::{Draft, Target};
use crate::{Error, Problem, Rotational, Vertical};

/// First degree where none is given.
const FIRST_DEGREE: usize = 1024;
/// Last degree where neither a degree nor a tolerance is given.
const USUAL_DEGREE: usize = 1 << 17;
/// Last degree under an explicit tolerance.
const LAST_DEGREE: usize = 1 << 19;

/// The answers of the degenerate equation to the right-hand sides `1`, `xi` and `f0`, (3.6).
struct Truncated<'k> {
    level: DegenerateSolution<'k, Logarithm>,
    tilted: DegenerateSolution<'k, Logarithm>,
    profile: DegenerateSolution<'k, Logarithm>,
}

/// Solves with the highest Chebyshev degree `degree`: closed-form Gram matrix (3.4), even and odd systems (3.10) and (3.11), symmetric positive form,
/// Cholesky or, for many terms, conjugate gradients with fast products. No statement of the error.
pub(super) fn solve(problem: &Problem, function: &Function, degree: usize) -> Result<Draft, Error> {
    Ok(Truncated::new(&Logarithm::unit(), problem, function, degree)?.draft(problem, degree))
}

/// The same with the guaranteed bounds of its error; an estimate where the profile is not resolved or `n` is far below `theta0`.
pub(super) fn solve_with_bounds(
    problem: &Problem,
    function: &Function,
    degree: usize,
) -> Result<Draft, Error> {
    let kernel = Logarithm::unit();
    let truncated = Truncated::new(&kernel, problem, function, degree)?;
    let mut draft = truncated.draft(problem, degree);
    let bounds = truncated.accuracy(&kernel, problem, function, &draft.state)?;
    draft.accuracy = Some(if bounds.is_finite() {
        bounds
    } else {
        // Far below n = theta0 the energies are not known to be positive, and there is no bound: twice the degree gives an estimate.
        draft.difference(&solve(problem, function, degree.saturating_mul(2))?)
    });
    Ok(draft)
}

/// Doubles the degree until the target is met, or the last degree is reached.
pub(super) fn solve_adaptively(
    problem: &Problem,
    function: &Function,
    target: Target,
) -> Result<Draft, Error> {
    let last = if target.is_explicit { LAST_DEGREE } else { USUAL_DEGREE };
    let first = (4.0 * problem.frame().theta0()).min(last as f64) as usize;
    let mut degree = first.max(FIRST_DEGREE).next_power_of_two();
    loop {
        let mut draft = solve_with_bounds(problem, function, degree)?;
        if draft.meets(problem, target.tolerance) || 2 * degree > last {
            // Below n = 2 theta0 the exact application of the kernel amplifies the error.
            if degree as f64 >= 2.0 * problem.frame().theta0() {
                draft.edges = Some(iterated_edges(problem, function, &draft));
            }
            return Ok(draft);
        }
        degree *= 2;
    }
}

/// The pressures at the left and right edge by one exact application of the kernel to the degenerate solution: their error falls nearly as `n^-4`, that of
/// the plain ones as `n^-2`.
pub(super) fn iterated_edges(problem: &Problem, function: &Function, draft: &Draft) -> [f64; 2] {
    let state = &draft.state;
    let mut right: Vec<f64> = function.series().coefficients().iter().map(|c| -c).collect();
    right.resize(right.len().max(2), 0.0);
    right[0] += state.settlement;
    right[1] -= state.tilt;
    let series = ChebyshevSeries::new(right);
    let correction = draft.potential.series().coefficients();
    let iterated = IteratedSolution::new(problem.frame().theta0(), &series, correction);
    [-1.0, 1.0].map(|xi| {
        let given = state.settlement - state.tilt * xi - problem.dimensionless_profile(xi);
        iterated.evaluate(xi, given)
    })
}

impl<'k> Truncated<'k> {
    fn new(
        kernel: &'k Logarithm,
        problem: &Problem,
        function: &Function,
        degree: usize,
    ) -> Result<Self, Error> {
        let solver = DegenerateSolver::new(kernel, problem.frame().theta0(), degree)?;
        let moments = |series: &ChebyshevSeries| series.moments(degree + 1);
        Ok(Self {
            level: solver.solve(&moments(&one()))?,
            tilted: solver.solve(&moments(&linear()))?,
            profile: solver.solve(&moments(function.series()))?,
        })
    }

    fn draft(&self, problem: &Problem, degree: usize) -> Draft {
        let balance = Balance {
            stiffness: Stiffness {
                force_settlement: self.level.projections()[0],
                coupling: self.tilted.projections()[0],
                moment_tilt: self.tilted.projections()[1],
            },
            free: [self.profile.projections()[0], self.profile.projections()[1]],
        };
        let state = balance.state(&problem.dimensionless_load());
        let potential = (self.level.correction().iter())
            .zip(self.tilted.correction())
            .zip(self.profile.correction())
            .map(|((level, tilted), profile)| {
                state.settlement * level - state.tilt * tilted - profile
            })
            .collect();
        Draft {
            theta0: problem.frame().theta0(),
            balance,
            state,
            potential: Potential::series_of(potential),
            method: Method { name: "spectral", n: degree },
            accuracy: None,
            edges: None,
        }
    }

    /// Bounds from residual, energy and positivity; the profile counts as its Chebyshev series.
    fn accuracy(
        &self,
        kernel: &Logarithm,
        problem: &Problem,
        function: &Function,
        state: &State,
    ) -> Result<Accuracy, Error> {
        let degree = (self.level.correction().len() - 1).max(function.series().degree());
        let operator = ResidualOperator::new(kernel, problem.frame().theta0(), degree)?;
        let kind = if function.is_resolved() { Kind::Bound } else { Kind::Estimate };
        let approximate = |right: &ChebyshevSeries,
                           solution: &DegenerateSolution<'_, Logarithm>| {
            operator.approximation(right, solution.correction(), kind)
        };
        let responses = Responses::new(
            approximate(&one(), &self.level)?,
            approximate(&linear(), &self.tilted)?,
            approximate(function.series(), &self.profile)?,
        )?;
        // p = c_1 A^-1 1 + c_2 A^-1 xi - A^-1 f with c_1 = delta, c_2 = -alpha.
        let load = problem.dimensionless_load();
        let given = [
            match load.vertical {
                Vertical::Force(force) => Given::Projection(force),
                Vertical::Settlement(settlement) => Given::Coefficient(settlement),
            },
            match load.rotational {
                Rotational::Moment(moment) => Given::Projection(moment),
                Rotational::Tilt(tilt) => Given::Coefficient(-tilt),
                Rotational::Eccentricity(eccentricity) => Given::Quotient(eccentricity),
            },
        ];
        let combination = responses.combine_with(given, [state.settlement, -state.tilt]);
        let ([settlement, slope], [force, moment]) =
            (combination.coefficients(), combination.projections());
        let kind = match combination.kind() {
            Kind::Bound => ErrorKind::Bound,
            Kind::Estimate => ErrorKind::Estimate,
        };
        let exact = Accuracy {
            kind,
            pressure: combination.error_supremum(),
            settlement: settlement.error_of(state.settlement),
            tilt: slope.error_of(-state.tilt),
            force: force.error_of(state.force),
            moment: moment.error_of(state.moment),
        };
        let rounded =
            exact.with_rounding(&state.sizes(function.largest() + state.settlement.abs()));
        if function.is_resolved() {
            return Ok(rounded);
        }
        let stiffness = [self.level.projections()[0], self.tilted.projections()[1]];
        Ok(rounded.with_profile_error(function.error() * function.largest(), stiffness))
    }
}

fn one() -> ChebyshevSeries {
    ChebyshevSeries::new(vec![1.0])
}

fn linear() -> ChebyshevSeries {
    ChebyshevSeries::new(vec![0.0, 1.0])
}
