//! The base as a solution sees it: places, their images, and heights.
//!
//! Small zones far from the middle of the base have heights from the tangent there, which keeps their digits. With `f0 = h + s (xi - c) + r` the equation is one with the profile `r`,
//! the settlement `delta0 - h + s c` and the tilt `alpha0 + s`: under a given force both are as small as the contact, where `delta0`, `alpha0 xi` and `f0` are large and cancel.

use std::ops::Add;

use crate::contact::accuracy::{Accuracy, ROUNDING};
use crate::contact::balance::State;
use crate::contact::ground::Ground;
use crate::contact::setting::Setting;
use crate::{Load, Problem, Scaling};

/// A tangent of the profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tangent {
    /// `c`.
    at: f64,
    /// `h`.
    height: f64,
    /// `s`.
    slope: f64,
}

impl Tangent {
    /// The tangent at a place, where there is one.
    pub(super) fn new(problem: &Problem, at: f64) -> Option<Self> {
        let (height, slope) = (problem.dimensionless_profile(at), problem.dimensionless_slope(at)?);
        (height.is_finite() && slope.is_finite()).then_some(Self { at, height, slope })
    }

    /// The load of the problem with the profile `r`.
    pub(super) fn load(&self, load: Load) -> Load {
        load.lowered(self.height, self.slope).lowered(-self.slope * self.at, 0.0)
    }

    /// The state of the problem itself; what the load prescribes comes back as given.
    pub(super) fn state(&self, given: Load, state: State) -> State {
        let settlement = state.settlement + (self.height - self.slope * self.at);
        State { settlement, tilt: state.tilt - self.slope, ..state }.given(&given)
    }

    /// Errors with the rounding of what is added.
    pub(super) fn accuracy(&self, accuracy: Accuracy) -> Accuracy {
        let size = self.height.abs().max(self.slope.abs());
        let rounding = ROUNDING * size;
        accuracy.open([rounding, rounding, 0.0, 0.0], f64::add)
    }
}

/// Places and heights of a base.
#[derive(Debug, Clone)]
pub(super) struct Surface {
    pub(super) setting: Setting,
    /// Where heights are counted from.
    pub(super) tangent: Option<Tangent>,
    is_disk: bool,
    is_closed: bool,
    /// Whether the profile has a step where the period is joined.
    has_seam: bool,
    /// The middle of the base: where it has no gaps, of the part of the wave that is looked at.
    pub(super) origin: f64,
    /// Where that part bends beyond the period, in order, and the same on the base.
    pub(super) images: Vec<[f64; 2]>,
}

impl Surface {
    pub(super) fn new(setting: &Setting, ground: &dyn Ground) -> Self {
        let (is_disk, is_closed) = (ground.is_disk(), ground.is_closed());
        let has_seam = is_closed && setting.height(-1.0) != setting.height(1.0);
        let (setting, images) = (setting.clone(), Vec::new());
        Self { setting, tangent: None, is_disk, is_closed, has_seam, origin: 0.0, images }
    }

    /// `f0(xi)`, or what it has beyond its tangent.
    pub(super) fn height(&self, xi: f64) -> f64 {
        match &self.tangent {
            Some(tangent) => self.setting.problem().dimensionless_rise(tangent.at, xi),
            None => self.setting.height(self.on_base(xi)),
        }
    }

    /// The same at many places.
    pub(super) fn heights(&self, places: &[f64]) -> Vec<f64> {
        if self.tangent.is_some() {
            return places.iter().map(|xi| self.height(*xi)).collect();
        }
        let on_base: Vec<f64> = places.iter().map(|xi| self.on_base(*xi)).collect();
        self.setting.problem().dimensionless_profiles(&on_base)
    }

    /// What rounding may make of a height; of one above its tangent nothing.
    pub(super) fn rounding(&self, xi: f64) -> f64 {
        if self.tangent.is_some() {
            return 0.0;
        }
        let (problem, xi) = (self.setting.problem(), self.on_base(xi));
        let rounding = problem.profile().rounding(xi, problem.bodies().half_width());
        // An enclosure without an end says nothing of it.
        if rounding.is_finite() {
            rounding / problem.bodies().unit(Scaling::displacement)
        } else {
            0.0
        }
    }

    /// `df0/dxi`, at a kink to the right, or what it has beyond the slope of the tangent; NaN where the profile has none.
    pub(super) fn slope(&self, xi: f64) -> f64 {
        let (problem, xi) = (self.setting.problem(), self.on_base(xi));
        let slope = problem.profile().slope(xi, problem.bodies().half_width());
        let scale = problem.bodies().unit(Scaling::displacement);
        slope.unwrap_or(f64::NAN) / scale - self.tangent.map_or(0.0, |tangent| tangent.slope)
    }

    /// Where a place of the solution lies on the base: a wave without gaps goes on beyond its period. There places are counted from the nearest bend, whose own place is rounded: at a sharp tip
    /// that would be felt.
    pub(super) fn on_base(&self, xi: f64) -> f64 {
        if !self.is_closed || xi.abs() <= 1.0 {
            return xi;
        }
        match crate::order::nearest(&self.images, xi) {
            Some([image, at]) => (at + (xi - image)).clamp(-1.0, 1.0),
            None => xi - 2.0 * (0.5 * xi).round(),
        }
    }

    /// Where a place of the base lies in the solution: on a disk the distance from the axis, on a wave without gaps the image about the origin. Ends of a period that differ lie just inside it.
    pub(super) fn located(&self, xi: f64) -> f64 {
        let xi = if self.has_seam && xi.abs() == 1.0 { xi * (1.0 - f64::EPSILON) } else { xi };
        if self.is_disk {
            xi.abs()
        } else if self.is_closed {
            xi + 2.0 * (0.5 * (self.origin - xi)).round()
        } else {
            xi
        }
    }

    /// Both places of the base, or the one, that a place of the solution stands for.
    pub(super) fn images(&self, place: f64) -> [f64; 2] {
        let place = self.on_base(place);
        if self.is_disk { [-place, place] } else { [place; 2] }
    }

    /// The zones of a solution on the base, from left to right: of a disk along its diameter; of a wave without gaps those whose middles lie on the base.
    pub(super) fn zones(&self, zones: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
        let mut along: Vec<[f64; 2]> = Vec::new();
        for [left, right] in zones {
            if self.is_closed {
                let periods = 2.0 * (0.25 * (left + right)).round();
                along.push([left - periods, right - periods]);
            } else if self.is_disk && left == 0.0 {
                along.push([-right, right]);
            } else if self.is_disk {
                along.extend([[-right, -left], [left, right]]);
            } else {
                along.push([left, right]);
            }
        }
        crate::order::sort_by_number(&mut along, |one| one[0]);
        along
    }
}
