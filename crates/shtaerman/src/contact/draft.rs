//! What a method hands over before the answer is drawn up.

use super::accuracy::{Accuracy, ErrorKind, Sizes};
use super::balance::{Balance, State};
use super::potential::Potential;
use super::solved::Method;
use crate::Problem;

/// Points at which the pressures of two drafts are compared.
const COMPARED: usize = 1024;

/// A solution by one method.
#[derive(Debug, Clone)]
pub(super) struct Draft {
    pub(super) balance: Balance,
    pub(super) state: State,
    pub(super) potential: Potential,
    pub(super) method: Method,
    pub(super) accuracy: Option<Accuracy>,
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
        self.state.settlement
            - self.state.tilt * xi
            - problem.dimensionless_profile(xi)
            - self.potential.at(xi)
    }

    /// Differences from another draft of the same problem, the pressure's over a set of points that no grid of a method shares.
    pub(super) fn difference(&self, other: &Self) -> Accuracy {
        let settlement = (self.state.settlement - other.state.settlement).abs();
        let tilt = (self.state.tilt - other.state.tilt).abs();
        let signed = |xi: f64| {
            (self.state.settlement - other.state.settlement)
                - (self.state.tilt - other.state.tilt) * xi
                - (self.potential.at(xi) - other.potential.at(xi))
        };
        Accuracy {
            kind: ErrorKind::Estimate,
            pressure: compared_points().fold(0.0f64, |most, xi| most.max(signed(xi).abs())),
            settlement,
            tilt,
            force: (self.state.force - other.state.force).abs(),
            moment: (self.state.moment - other.state.moment).abs(),
        }
    }

    /// The estimated or bounded error relative to its size.
    pub(super) fn relative_error(&self, problem: &Problem) -> f64 {
        let largest =
            compared_points().fold(0.0f64, |most, xi| most.max(self.pressure(problem, xi).abs()));
        self.accuracy
            .map_or(f64::INFINITY, |accuracy| accuracy.relative(&self.state.sizes(largest)))
    }

    pub(super) fn meets(&self, problem: &Problem, tolerance: f64) -> bool {
        self.relative_error(problem) <= tolerance
    }
}

impl Accuracy {
    pub(super) fn scaled(self, factor: f64) -> Self {
        Self {
            kind: self.kind,
            pressure: factor * self.pressure,
            settlement: factor * self.settlement,
            tilt: factor * self.tilt,
            force: factor * self.force,
            moment: factor * self.moment,
        }
    }
}

/// Both ends, the middle, and a golden-ratio sequence of angles between.
fn compared_points() -> impl Iterator<Item = f64> {
    const STEP: f64 = 0.618_033_988_749_894_9;
    let between = (1..=COMPARED).map(|i| (std::f64::consts::PI * (i as f64 * STEP).fract()).cos());
    [-1.0, 0.0, 1.0].into_iter().chain(between)
}
