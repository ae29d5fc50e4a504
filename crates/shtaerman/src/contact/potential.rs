//! The elastic displacement under the punch, `theta0 K p0`, as a method leaves it.

use std::sync::OnceLock;

use fredholm::SincSolution;
use fredholm::basis::{ChebyshevSeries, ChebyshevTable, chebyshev};

/// Degree of the series that stands for a collocated potential beside the punch: its coefficients fall as `m^-3`.
const SERIES_DEGREE: usize = 2048;
/// Degree from which on a series is tabulated: the table costs as much as some 50 sums, and an audit asks for thousands.
const TABULATED: usize = 1024;

/// Points at which potentials of different kinds are compared.
const COMPARED: usize = 1024;
/// Most samples of a collocated potential, each of which costs a sum over the nodes.
const MOST_COLLOCATED_SAMPLES: usize = 8192;

/// `theta0 int ln(1/|xi - eta|) p0(eta) deta` on the base.
#[derive(Debug, Clone)]
pub(super) enum Potential {
    /// `sum c_m T_m(xi)`: the degenerate kernel; a long one by its table once a value is asked for.
    Series(ChebyshevSeries, OnceLock<ChebyshevTable>),
    /// Collocation, with its series for points beside the punch once one is asked for.
    Collocated(Box<SincSolution>, OnceLock<ChebyshevSeries>),
}

impl Potential {
    /// The series with these coefficients.
    pub(super) fn series_of(coefficients: Vec<f64>) -> Self {
        Self::Series(ChebyshevSeries::new(coefficients), OnceLock::new())
    }

    pub(super) fn collocated(solution: SincSolution) -> Self {
        Self::Collocated(Box::new(solution), OnceLock::new())
    }

    /// The value at `xi` in `[-1, 1]`.
    pub(super) fn at(&self, xi: f64) -> f64 {
        match self {
            Self::Series(series, _) if series.degree() < TABULATED => series.evaluate(xi),
            Self::Series(series, table) => {
                table.get_or_init(|| ChebyshevTable::new(series)).evaluate(xi)
            }
            Self::Collocated(solution, _) => solution.parameter() * solution.evaluate_potential(xi),
        }
    }

    /// Largest `|level - slope xi - (self - other)(xi)|` over the base: by one transform where both are series, else over points that no grid
    /// of a method shares.
    pub(super) fn largest_difference(&self, other: &Self, level: f64, slope: f64) -> f64 {
        let largest = |values: &mut dyn Iterator<Item = f64>| {
            values.fold(0.0f64, |most, v| most.max(v.abs()))
        };
        if let (Self::Series(one, _), Self::Series(two, _)) = (self, other) {
            let mut difference =
                vec![0.0; one.coefficients().len().max(two.coefficients().len()).max(2)];
            difference.iter_mut().zip(one.coefficients()).for_each(|(d, c)| *d -= c);
            difference.iter_mut().zip(two.coefficients()).for_each(|(d, c)| *d += c);
            difference[0] += level;
            difference[1] -= slope;
            let degree = 2 * difference.len();
            return largest(&mut ChebyshevSeries::new(difference).values(degree).into_iter());
        }
        let signed = |xi: f64| level - slope * xi - (self.at(xi) - other.at(xi));
        largest(&mut between_nodes(COMPARED).map(signed))
    }

    /// The values at [`chebyshev::points`]`(degree)`: by one transform where there is a series, whose own degree may raise the number.
    pub(super) fn sample(&self, degree: usize) -> Vec<f64> {
        match self {
            Self::Series(series, _) => series.values(degree),
            Self::Collocated(..) => {
                let degree = degree.min(MOST_COLLOCATED_SAMPLES);
                chebyshev::points(degree).into_iter().map(|xi| self.at(xi)).collect()
            }
        }
    }

    /// The Chebyshev series of the potential.
    pub(super) fn series(&self) -> &ChebyshevSeries {
        match self {
            Self::Series(series, _) => series,
            Self::Collocated(_, series) => series.get_or_init(|| {
                let points = chebyshev::points(SERIES_DEGREE);
                ChebyshevSeries::through(points.into_iter().map(|xi| self.at(xi)).collect())
            }),
        }
    }

    /// A bound of its size.
    pub(super) fn size(&self) -> f64 {
        match self {
            Self::Series(series, _) => series.coefficients().iter().map(|c| c.abs()).sum(),
            Self::Collocated(solution, _) => {
                let largest = solution.potential().iter().fold(0.0f64, |most, u| most.max(u.abs()));
                solution.parameter() * largest
            }
        }
    }
}

/// Both ends, the middle, and a golden-ratio sequence of angles between, which no grid of a method shares.
pub(super) fn between_nodes(count: usize) -> impl Iterator<Item = f64> {
    const STEP: f64 = 0.618_033_988_749_894_9;
    let between = (1..=count).map(|i| (std::f64::consts::PI * (i as f64 * STEP).fract()).cos());
    [-1.0, 0.0, 1.0].into_iter().chain(between)
}
