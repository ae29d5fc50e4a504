//! What a method hands over before the answer is drawn up.

use fredholm::basis::chebyshev;

use super::accuracy::{Accuracy, ErrorKind, Sizes};
use super::balance::{Balance, State};
use super::method::Method;
use super::potential::Potential;
use super::resolutions::UNKNOWN;
use crate::Problem;

/// Least and most samples of a pressure.
const SAMPLES: std::ops::RangeInclusive<usize> = 1024..=1 << 17;
/// Samples for each Chebyshev degree that the profile needs.
const SAMPLES_PER_DEGREE: usize = 4;

/// A solution by one method.
#[derive(Debug, Clone)]
pub(super) struct Draft {
    pub(super) theta0: f64,
    pub(super) balance: Balance,
    pub(super) state: State,
    pub(super) potential: Potential,
    pub(super) method: Method,
    pub(super) accuracy: Option<Accuracy>,
    /// Sharper pressures at the left and right edge, where the method has them.
    pub(super) edges: Option<[f64; 2]>,
}

impl State {
    pub(super) fn sizes(&self, pressure: f64) -> Sizes {
        Sizes {
            pressure,
            displacement: self.settlement.abs().max(self.tilt.abs()),
            force: self.force.abs().max(self.moment.abs()),
        }
    }
}

impl Draft {
    /// `p0(xi)`.
    pub(super) fn pressure(&self, problem: &Problem, xi: f64) -> f64 {
        match self.edges {
            Some([left, _]) if xi == -1.0 => left,
            Some([_, right]) if xi == 1.0 => right,
            _ => self.plain_pressure(problem, xi, self.potential.at(xi)),
        }
    }

    fn plain_pressure(&self, problem: &Problem, xi: f64, potential: f64) -> f64 {
        self.state.settlement - self.state.tilt * xi - problem.dimensionless_profile(xi) - potential
    }

    /// Places from left to right with the pressures there, dense enough for a profile of this Chebyshev degree.
    pub(super) fn sample(&self, problem: &Problem, profile_degree: usize) -> (Vec<f64>, Vec<f64>) {
        let wanted = (SAMPLES_PER_DEGREE * profile_degree).clamp(*SAMPLES.start(), *SAMPLES.end());
        let potential = self.potential.sample(wanted.next_power_of_two());
        let mut places = chebyshev::points(potential.len() - 1);
        let mut pressures: Vec<f64> = (places.iter().zip(&potential))
            .map(|(&xi, u)| self.plain_pressure(problem, xi, *u))
            .collect();
        places.reverse();
        pressures.reverse();
        if let Some([left, right]) = self.edges {
            pressures[0] = left;
            pressures[potential.len() - 1] = right;
        }
        (places, pressures)
    }

    /// Differences from another draft of the same problem, the pressure's over points that are dense between the nodes of either.
    pub(super) fn difference(&self, other: &Self) -> Accuracy {
        let settlement = self.state.settlement - other.state.settlement;
        let tilt = self.state.tilt - other.state.tilt;
        Accuracy {
            kind: ErrorKind::Estimate,
            pressure: self.potential.largest_difference(&other.potential, settlement, tilt),
            settlement: settlement.abs(),
            tilt: tilt.abs(),
            force: (self.state.force - other.state.force).abs(),
            moment: (self.state.moment - other.state.moment).abs(),
        }
    }

    /// The estimated or bounded error relative to its size.
    pub(super) fn relative_error(&self, problem: &Problem) -> f64 {
        let (_, pressures) = self.sample(problem, 0);
        let largest = pressures.into_iter().fold(0.0f64, |most, p| most.max(p.abs()));
        self.accuracy
            .map_or(f64::INFINITY, |accuracy| accuracy.relative(&self.state.sizes(largest)))
    }

    /// The same with no small error stated.
    pub(super) fn of_the_unknown(self, problem: &Problem) -> Self {
        let (_, pressures) = self.sample(problem, 0);
        let largest = pressures.into_iter().fold(0.0f64, |most, p| most.max(p.abs()));
        let sizes = self.state.sizes(largest);
        let accuracy = self.accuracy.map(|accuracy| accuracy.of_the_unknown(UNKNOWN, &sizes));
        Self { accuracy, ..self }
    }

    pub(super) fn meets(&self, problem: &Problem, tolerance: f64) -> bool {
        self.relative_error(problem) <= tolerance
    }
}
