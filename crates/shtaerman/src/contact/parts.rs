//! The parts of the base on which the profile is smooth.

use crate::{Error, Problem};

/// Most cuts of the whole base that are collocated, and most of one that lifts off or stands on other ground than a half-plane, where nothing else serves.
pub(super) const MOST_BREAKS: usize = 15;
const MOST_CUTS: usize = 40;

/// Where the base is cut.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Parts {
    /// Places strictly inside the base, as `xi` in increasing order: kinks, steps, and places beside features that are narrow.
    pub(super) joints: Vec<f64>,
    /// Whether the profile is proved to be smooth between them.
    pub(super) is_proved: bool,
}

impl Parts {
    /// Without any cut.
    pub(super) fn whole(is_proved: bool) -> Self {
        Self { joints: Vec::new(), is_proved }
    }

    /// Whether there are more cuts than collocation should have panels for.
    pub(super) fn are_many(&self) -> bool {
        self.joints.len() > MOST_BREAKS
    }

    /// Refuses more cuts than collocation can have panels for.
    pub(super) fn require_few(&self) -> Result<(), Error> {
        let parts = self.joints.len() + 1;
        if self.joints.len() > MOST_CUTS {
            return Err(Error::TooManyParts { parts, most: MOST_CUTS + 1 });
        }
        Ok(())
    }
}

impl Problem {
    /// The parts of the base.
    pub(super) fn parts(&self) -> Parts {
        let joints = self.profile().breakpoints(self.frame().half_width());
        Parts { joints, is_proved: self.profile().measured_points().is_none() }
    }
}
