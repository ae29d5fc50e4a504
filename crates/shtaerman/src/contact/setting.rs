//! The problem as it is solved, without dimensions: made once, and shared by the equation, its solution and the answer.

use std::sync::{Arc, OnceLock};

use super::parts::{MOST_CUTS, Parts, Smoothness};
use crate::roughness::Law;
use crate::{ContactKind, Load, Problem};

/// A problem whose heights are counted from the level of its base. Copies share what they hold.
#[derive(Debug, Clone)]
pub(super) struct Setting(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    problem: Problem,
    load: Load,
    /// Found when they are first asked for: resolving a profile takes time.
    parts: OnceLock<Parts>,
}

impl Setting {
    pub(super) fn new(problem: &Problem) -> Self {
        let (problem, load) = (problem.clone(), problem.dimensionless_load());
        Self(Arc::new(Shared { problem, load, parts: OnceLock::new() }))
    }

    /// The problem itself, in its own units.
    pub(super) fn problem(&self) -> &Problem {
        &self.0.problem
    }

    /// What is prescribed.
    pub(super) fn load(&self) -> Load {
        self.0.load
    }

    /// Whether the base may lift off.
    pub(super) fn is_unilateral(&self) -> bool {
        self.problem().solver().contact == ContactKind::Unilateral
    }

    /// `theta0`.
    pub(super) fn theta0(&self) -> f64 {
        self.problem().theta0()
    }

    /// `f0(xi)`.
    pub(super) fn height(&self, xi: f64) -> f64 {
        self.problem().dimensionless_profile(xi)
    }

    /// The parts of the base on which its profile is smooth.
    pub(super) fn parts(&self) -> &Parts {
        self.0.parts.get_or_init(|| self.problem().parts())
    }

    /// The same as collocation takes them: uncut where there are more than can have panels.
    pub(super) fn collocated_parts(&self) -> Parts {
        let parts = self.parts();
        if parts.are_many() { parts.uncut() } else { parts.clone() }
    }

    /// The same with the points of a measured profile as cuts, where these are few.
    pub(super) fn parts_between_points(&self) -> Parts {
        let profile = self.problem().profile();
        let points = profile.measured_points().unwrap_or(0);
        if points == 0 || points > MOST_CUTS {
            return self.parts().clone();
        }
        let mut joints = profile.joints(self.problem().bodies().half_width());
        joints.sort_by(f64::total_cmp);
        Parts { joints, smoothness: Smoothness::Proved }
    }

    /// Whether the surface is rough and nothing is proved of the profile between samples.
    pub(super) fn has_unknown_layer(&self) -> bool {
        let is_rough = self.problem().bodies().law() != Law::Smooth;
        is_rough && self.parts().smoothness == Smoothness::Unknown
    }
}
