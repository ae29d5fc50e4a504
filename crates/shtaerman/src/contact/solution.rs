//! What a way of solving hands over before the answer is drawn up.

use std::fmt::Debug;

use super::accuracy::Accuracy;
use super::balance::State;
use super::complementarity::Complementarity;
use super::draft::Draft;
use super::method::Method;
use super::rates::Linearised;
use super::stiffness::Stiffness;
use crate::Problem;

/// A solution without dimensions, by whatever way.
pub(super) trait Solution: Debug + Send + Sync {
    /// Settlement, tilt, force and moment.
    fn state(&self) -> State;

    /// `d(P0, M0)/d(delta0, -alpha0)`.
    fn stiffness(&self) -> Stiffness;

    /// The estimated error of each entry, where the method tells one.
    fn stiffness_error(&self) -> Option<Stiffness> {
        None
    }

    /// The zones of contact from left to right, as `xi`.
    fn zones(&self) -> Vec<[f64; 2]>;

    /// Whether the base touches at `xi`.
    fn touches(&self, xi: f64) -> bool {
        self.zones().iter().any(|[left, right]| *left <= xi && xi <= *right)
    }

    /// `p0(xi)` on the base, 0 outside the zones; infinite at a singular corner.
    fn pressure(&self, problem: &Problem, xi: f64) -> f64;

    /// The same at many places.
    fn pressures(&self, problem: &Problem, places: &[f64]) -> Vec<f64> {
        places.iter().map(|&xi| self.pressure(problem, xi)).collect()
    }

    /// `p0` in a zone by the distances from both of its ends, where the smaller may be far below the rounding of `xi`.
    fn pressure_beside(
        &self,
        problem: &Problem,
        zone: usize,
        from_left: f64,
        from_right: f64,
    ) -> f64 {
        let [left, right] = self.zones().get(zone).copied().unwrap_or([f64::NAN; 2]);
        let xi = if from_left < from_right { left + from_left } else { right - from_right };
        self.pressure(problem, xi)
    }

    /// `theta0 int K(xi, eta) p0(eta) deta` at any `xi`.
    fn displacement(&self, xi: f64) -> f64;

    /// Places from left to right with the pressures there, dense enough to show extremes; all finite.
    fn sample(&self, problem: &Problem) -> (Vec<f64>, Vec<f64>);

    /// Method and size.
    fn method(&self) -> Method;

    /// The error, where the method tells one.
    fn accuracy(&self) -> Option<&Accuracy>;

    /// What a disturbance of the heights grows to in the pressure of a linear layer: the inverse of `I + theta0 K` has a norm near one, and the balance adds as much
    /// again.
    fn growth(&self) -> f64 {
        2.0
    }

    /// The largest error relative to its size; infinite where the method tells none.
    fn relative_error(&self) -> f64 {
        let sizes = self.state().sizes(self.size());
        self.accuracy().map_or(f64::INFINITY, |accuracy| accuracy.relative(&sizes))
    }

    /// The estimated error of the edges, in `xi`, where they are unknown.
    fn edge_error(&self) -> Option<f64> {
        None
    }

    /// What is left of tension and penetration, where they were looked for.
    fn complementarity(&self) -> Option<Complementarity> {
        None
    }

    /// `lim sqrt(2 pi d) p0` at the left and right end of each zone, `d` in `xi`, where the surface is smooth; 0 at free ends.
    fn corner_intensity(&self) -> Option<Vec<[f64; 2]>> {
        None
    }

    /// How it changes to first order, the largest pressure being at `peak`; none where only differences of solutions tell.
    fn linearised(&self, _problem: &Problem, _peak: f64) -> Option<Linearised> {
        None
    }

    /// A bound of the size of `p0 + f0`, for the check that an answer is finite.
    fn size(&self) -> f64;
}

/// The draft with the Chebyshev degree that shows the features of the profile.
#[derive(Debug, Clone)]
pub(super) struct FullBase {
    pub(super) draft: Draft,
    pub(super) profile_degree: usize,
}

impl Solution for FullBase {
    fn state(&self) -> State {
        self.draft.state
    }

    fn stiffness(&self) -> Stiffness {
        self.draft.balance.stiffness
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        vec![[-1.0, 1.0]]
    }

    fn pressure(&self, problem: &Problem, xi: f64) -> f64 {
        self.draft.pressure(problem, xi)
    }

    fn displacement(&self, xi: f64) -> f64 {
        if xi.abs() <= 1.0 { self.draft.potential.at(xi) } else { self.draft.beside(xi) }
    }

    fn sample(&self, problem: &Problem) -> (Vec<f64>, Vec<f64>) {
        self.draft.sample(problem, self.profile_degree)
    }

    fn method(&self) -> Method {
        self.draft.method
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        self.draft.accuracy.as_ref()
    }

    fn linearised(&self, problem: &Problem, peak: f64) -> Option<Linearised> {
        let displacement = |xi: f64| self.displacement(xi);
        let (method, degree) = (self.draft.method, self.profile_degree);
        let found = problem.linearised_full_base(&displacement, method, degree, peak)?;
        Some(found.with_stiffness(&self.stiffness(), &problem.dimensionless_load()))
    }

    fn size(&self) -> f64 {
        let state = &self.draft.state;
        state.settlement.abs() + state.tilt.abs() + self.draft.potential.size()
    }
}
