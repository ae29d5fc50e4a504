//! What a file states before its profile and load are read.

use crate::frame::Frame;
use crate::{Error, Foundation, Layering, Punch};

/// A foundation and a flat punch with the frame that both make.
pub(super) struct Stated {
    pub(super) foundation: Foundation,
    pub(super) punch: Punch,
    pub(super) frame: Frame,
}

impl Stated {
    pub(super) fn new(foundation: Foundation, punch: Punch) -> Result<Self, Error> {
        let frame = Frame::new(&foundation, &punch)?;
        Ok(Self { foundation, punch, frame })
    }

    /// The same on a foundation in two pieces.
    pub(super) fn on(self, layering: Layering) -> Result<Self, Error> {
        Self::new(self.foundation.with_layering(layering), self.punch)
    }
}
