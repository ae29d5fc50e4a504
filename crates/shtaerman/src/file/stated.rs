//! What a file states before its profile and load are read.

use crate::bodies::Bodies;
use crate::{Error, Foundation, Layering, Punch};

/// A foundation and a flat punch with the bodies that both make.
pub(super) struct Stated {
    pub(super) foundation: Foundation,
    pub(super) punch: Punch,
    pub(super) bodies: Bodies,
}

impl Stated {
    pub(super) fn new(foundation: Foundation, punch: Punch) -> Result<Self, Error> {
        let bodies = Bodies::new(&foundation, &punch)?;
        Ok(Self { foundation, punch, bodies })
    }

    /// The same on a foundation in two pieces.
    pub(super) fn on(self, layering: Layering) -> Result<Self, Error> {
        Self::new(self.foundation.with_layering(layering), self.punch)
    }
}
