//! The elastic displacement under the punch, `theta0 K p0`, as a method leaves it.

use std::sync::OnceLock;

use fredholm::SincSolution;
use fredholm::basis::{ChebyshevSeries, chebyshev};

/// Degree of the series that stands for a collocated potential beside the punch: its coefficients fall as `m^-3`.
const SERIES_DEGREE: usize = 2048;

/// `theta0 int ln(1/|xi - eta|) p0(eta) deta` on the base.
#[derive(Debug, Clone)]
pub(super) enum Potential {
    /// `sum c_m T_m(xi)`: the degenerate kernel.
    Series(ChebyshevSeries),
    /// Collocation, with its series for points beside the punch once one is asked for.
    Collocated(Box<SincSolution>, OnceLock<ChebyshevSeries>),
}

impl Potential {
    pub(super) fn collocated(solution: SincSolution) -> Self {
        Self::Collocated(Box::new(solution), OnceLock::new())
    }

    /// The value at `xi` in `[-1, 1]`.
    pub(super) fn at(&self, xi: f64) -> f64 {
        match self {
            Self::Series(series) => series.evaluate(xi),
            Self::Collocated(solution, _) => solution.parameter() * solution.evaluate_potential(xi),
        }
    }

    /// The Chebyshev series of the potential.
    pub(super) fn series(&self) -> &ChebyshevSeries {
        match self {
            Self::Series(series) => series,
            Self::Collocated(_, series) => series.get_or_init(|| {
                let points = chebyshev::points(SERIES_DEGREE);
                ChebyshevSeries::through(points.into_iter().map(|xi| self.at(xi)).collect())
            }),
        }
    }

    /// A bound of its size.
    pub(super) fn size(&self) -> f64 {
        match self {
            Self::Series(series) => series.coefficients().iter().map(|c| c.abs()).sum(),
            Self::Collocated(solution, _) => {
                let largest = solution.potential().iter().fold(0.0f64, |most, u| most.max(u.abs()));
                solution.parameter() * largest
            }
        }
    }
}
