//! The parts of the base on which the profile is smooth.

use crate::{Error, Problem};

/// Most cuts of the whole base that are collocated, and most of one that lifts off or stands on other ground than a half-plane, where nothing else serves (survey).
pub(super) const MOST_BREAKS: usize = 15;
pub(super) const MOST_CUTS: usize = 40;
/// Degree of the polynomials that show each part, and how well, as a share of the range of the heights (survey).
pub(crate) const DEGREE: usize = 128;
pub(crate) const RESOLVED: f64 = 1e-12;
/// The shortest of parts that are alike, over the mean. Half and twice change none of 4 answers (survey).
const ALIKE: f64 = 0.25;

/// What is known of the profile between the places where it is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Smoothness {
    /// Proved to be what polynomials show, but for singular places at the cuts.
    Proved,
    /// A spline, whose third derivative jumps, or waves that are not cut.
    Bent,
    /// Nothing: there may be features that no sample shows.
    Unknown,
}

/// Where the base is cut.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Parts {
    /// Places strictly inside the base, as `xi` in increasing order: kinks, steps, and places beside features that are narrow.
    pub(super) joints: Vec<f64>,
    /// What the parts between them are.
    pub(super) smoothness: Smoothness,
}

impl Parts {
    /// The same without any cut.
    pub(super) fn uncut(&self) -> Self {
        let is_whole = self.joints.is_empty();
        let smoothness = match self.smoothness {
            Smoothness::Proved if !is_whole => Smoothness::Bent,
            known => known,
        };
        Self { joints: Vec::new(), smoothness }
    }

    /// Whether there are more cuts than collocation should have panels for.
    pub(super) fn are_many(&self) -> bool {
        self.joints.len() > MOST_BREAKS
    }
}

/// Refuses more cuts than collocation can have panels for.
pub(super) fn require_few(joints: &[f64]) -> Result<(), Error> {
    if joints.len() > MOST_CUTS {
        return Err(Error::TooManyParts { parts: joints.len() + 1, most: MOST_CUTS + 1 });
    }
    Ok(())
}

impl Problem {
    /// The parts of the base; one of a measured profile, whose points are cuts only where that is asked for.
    pub(super) fn parts(&self) -> Parts {
        if self.profile().measured_points().is_some() {
            return Parts { joints: Vec::new(), smoothness: Smoothness::Bent };
        }
        if self.profile().is_closure() {
            let joints = self.profile().breakpoints(self.bodies().half_width());
            return Parts { joints, smoothness: Smoothness::Bent };
        }
        let found = self.resolution(DEGREE, RESOLVED);
        let smoothness = if found.is_complete() { Smoothness::Proved } else { Smoothness::Unknown };
        let parts = Parts { joints: found.joints, smoothness };
        let shortest = ALIKE * 2.0 / (parts.joints.len() + 1) as f64;
        let are_alike = parts.joints.windows(2).all(|pair| pair[1] - pair[0] >= shortest);
        if smoothness == Smoothness::Proved && parts.are_many() && are_alike {
            // Waves all over the base are seen by samples, and need no cuts of their own.
            let singular = found.singular.into_iter().filter(|at| parts.joints.contains(at));
            let joints = self.profile().breakpoints(self.bodies().half_width());
            let joints = crate::order::ascending(joints.into_iter().chain(singular));
            return Parts { joints, smoothness: Smoothness::Bent };
        }
        parts
    }
}
