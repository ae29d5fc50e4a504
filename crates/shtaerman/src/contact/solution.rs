//! What a way of solving hands over before the answer is drawn up.

use std::fmt::Debug;

use super::accuracy::Accuracy;
use super::balance::State;
use super::complementarity::Complementarity;
use super::method::Method;
use super::rates::Linearised;
use super::stiffness::Stiffness;
use crate::Load;

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
    fn pressure(&self, xi: f64) -> f64;

    /// The same at many places.
    fn pressures(&self, places: &[f64]) -> Vec<f64> {
        places.iter().map(|&xi| self.pressure(xi)).collect()
    }

    /// `p0` in a zone by the distances from both of its ends, where the smaller may be far below the rounding of `xi`.
    fn pressure_beside(&self, zone: usize, from_left: f64, from_right: f64) -> f64 {
        let [left, right] = self.zones().get(zone).copied().unwrap_or([f64::NAN; 2]);
        let xi = if from_left < from_right { left + from_left } else { right - from_right };
        self.pressure(xi)
    }

    /// `theta0 int K(xi, eta) p0(eta) deta` at any `xi`.
    fn displacement(&self, xi: f64) -> f64;

    /// Places from left to right with the pressures there, dense enough to show extremes; all finite.
    fn sample(&self) -> (Vec<f64>, Vec<f64>);

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

    /// How it changes to first order with what a load prescribes that it meets, the largest pressure being at `peak`; none where only differences of solutions tell.
    fn linearised(&self, _load: Load, _peak: f64) -> Option<Linearised> {
        None
    }

    /// A bound of the size of `p0 + f0`, for the check that an answer is finite.
    fn size(&self) -> f64;
}
