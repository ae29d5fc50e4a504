//! Where a base was found to need cuts, kept until it is asked for again: every force of a search, and the audit, ask for the same.

use std::sync::{Arc, Mutex, PoisonError};

/// The cuts of a base and what was proved of the parts between.
///
/// On each part between neighbouring cuts (the joints and the ends of the pieces) the profile differs from some polynomial of the degree asked for
/// by no more than the tolerance asked for, times the range of its heights (or than a few roundings of the largest height, if that is more), except
/// in the neighbourhood of what is listed as singular or unresolved.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Resolution {
    /// Rising `xi` inside the pieces: switches, the surroundings of narrow features, singular places.
    pub joints: Vec<f64>,
    /// Joints and ends of pieces, to rounding, at which no smoothness was proved: hidden kinks such as that of `sqrt((xi - 0.3)^2)`, roots such as
    /// that of `abs(xi)^1.5`. A part beside one is resolved piece by piece if it is cut at distances from it that grow by half from one cut to the next.
    pub singular: Vec<f64>,
    /// Intervals of `xi`, rising, on which nothing was proved with the work that is allowed; there may be features of any width.
    pub unresolved: Vec<[f64; 2]>,
}

impl Resolution {
    /// Whether something was proved everywhere but at single places.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.unresolved.is_empty()
    }
}

/// What a resolution is found for.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Asked {
    pub(super) pieces: Vec<[f64; 2]>,
    pub(super) half_width: f64,
    pub(super) degree: usize,
    pub(super) tolerance: f64,
}

/// Shared by the copies of a profile.
#[derive(Debug, Clone, Default)]
pub(super) struct Resolved(Arc<Mutex<Option<(Asked, Resolution)>>>);

impl Resolved {
    /// What is known, or what is found: threads that ask at once find it each, and wait for none.
    pub(super) fn known_or(&self, asked: Asked, find: impl FnOnce() -> Resolution) -> Resolution {
        let last = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let known = last().as_ref().filter(|(known, _)| *known == asked).cloned();
        if let Some((_, found)) = known {
            return found;
        }
        let found = find();
        *last() = Some((asked, found.clone()));
        found
    }
}

/// What is kept follows from the rest of the profile.
impl PartialEq for Resolved {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}
