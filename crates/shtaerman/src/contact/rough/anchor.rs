//! Small zones far from the middle of the base: heights from the tangent there, which keeps their digits.
//!
//! With `f0 = h + s (xi - c) + r` the equation is one with the profile `r`, the settlement `delta0 - h + s c` and the tilt `alpha0 + s`: under a given force both
//! are as small as the contact, where `delta0`, `alpha0 xi` and `f0` are large and cancel.

use crate::contact::accuracy::{Accuracy, ROUNDING};
use crate::contact::balance::State;
use crate::{Load, Problem, Rotational, Vertical};

/// A tangent of the profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Anchor {
    /// `c`.
    at: f64,
    /// `h`.
    height: f64,
    /// `s`.
    slope: f64,
}

impl Anchor {
    /// The tangent at a place, where there is one.
    pub(super) fn new(problem: &Problem, at: f64) -> Option<Self> {
        let (height, slope) = (problem.dimensionless_profile(at), problem.dimensionless_slope(at)?);
        (height.is_finite() && slope.is_finite()).then_some(Self { at, height, slope })
    }

    /// `s`.
    pub(super) fn slope(&self) -> f64 {
        self.slope
    }

    /// `r(xi)`.
    pub(super) fn rise(&self, problem: &Problem, xi: f64) -> f64 {
        problem.dimensionless_rise(self.at, xi)
    }

    /// The load of the problem with the profile `r`.
    pub(super) fn load(&self, load: Load) -> Load {
        let vertical = match load.vertical {
            Vertical::Force(force) => Vertical::Force(force),
            Vertical::Settlement(settlement) => {
                Vertical::Settlement(settlement - self.height + self.slope * self.at)
            }
        };
        let rotational = match load.rotational {
            Rotational::Tilt(tilt) => Rotational::Tilt(tilt + self.slope),
            other => other,
        };
        Load { vertical, rotational }
    }

    /// The state of the problem itself; what the load prescribes comes back as given.
    pub(super) fn state(&self, given: Load, state: State) -> State {
        let settlement = state.settlement + (self.height - self.slope * self.at);
        State { settlement, tilt: state.tilt - self.slope, ..state }.given(&given)
    }

    /// Errors with the rounding of what is added.
    pub(super) fn accuracy(&self, accuracy: Accuracy) -> Accuracy {
        let size = self.height.abs().max(self.slope.abs());
        let raised = |error: f64| if error == 0.0 { 0.0 } else { error + ROUNDING * size };
        Accuracy {
            settlement: raised(accuracy.settlement),
            tilt: raised(accuracy.tilt),
            ..accuracy
        }
    }
}
