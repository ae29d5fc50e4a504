//! When a search has to come to its end.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// The end of the time that a solve may take; without a limit no clock is read.
#[derive(Debug, Clone, Default)]
pub(crate) struct Deadline(Option<Arc<End>>);

#[derive(Debug)]
struct End {
    at: Instant,
    /// Once the answer is there, nothing that is asked of it ends early.
    is_lifted: AtomicBool,
}

impl Deadline {
    /// From now on; a limit beyond what a clock can tell is none.
    pub(crate) fn after(limit: Duration) -> Self {
        let end = Instant::now().checked_add(limit);
        Self(end.map(|at| Arc::new(End { at, is_lifted: AtomicBool::new(false) })))
    }

    /// Whether there is one that holds.
    pub(crate) fn is_set(&self) -> bool {
        self.0.as_ref().is_some_and(|end| !end.is_lifted.load(Ordering::Relaxed))
    }

    pub(crate) fn is_past(&self) -> bool {
        self.is_set() && self.0.as_ref().is_some_and(|end| Instant::now() >= end.at)
    }

    /// From here on there is none, in all copies.
    pub(crate) fn lift(&self) {
        if let Some(end) = &self.0 {
            end.is_lifted.store(true, Ordering::Relaxed);
        }
    }
}

/// Problems are the same whenever they are solved.
impl PartialEq for Deadline {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}
