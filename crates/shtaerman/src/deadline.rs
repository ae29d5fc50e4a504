//! When a search has to come to its end.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// The end of the time that a solve may take, or the wish of its caller to end it; without a limit no clock is read.
#[derive(Debug, Clone, Default)]
pub(crate) struct Deadline(Option<Arc<End>>);

#[derive(Debug)]
struct End {
    at: Option<Instant>,
    /// Set by the caller who does not want to wait any longer.
    stop: Option<Arc<AtomicBool>>,
    /// Once the answer is there, nothing that is asked of it ends early.
    is_lifted: AtomicBool,
}

impl Deadline {
    /// From now on; a limit beyond what a clock can tell is none.
    pub(crate) fn after(limit: Duration) -> Self {
        let end = ending(limit);
        Self(end.map(|at| Arc::new(End::new(Some(at), None))))
    }

    /// From now on, and earlier where the caller says so.
    pub(crate) fn unless(stop: &Arc<AtomicBool>, limit: Option<Duration>) -> Self {
        let end = limit.and_then(ending);
        Self(Some(Arc::new(End::new(end, Some(Arc::clone(stop))))))
    }

    /// Whether there is one that holds.
    pub(crate) fn is_set(&self) -> bool {
        self.0.as_ref().is_some_and(|end| !end.is_lifted.load(Ordering::Relaxed))
    }

    pub(crate) fn is_past(&self) -> bool {
        self.is_set() && self.0.as_ref().is_some_and(|end| end.is_past())
    }

    /// From here on there is none, in all copies.
    pub(crate) fn lift(&self) {
        if let Some(end) = &self.0 {
            end.is_lifted.store(true, Ordering::Relaxed);
        }
    }
}

/// When a limit that begins now is over. In a browser there is no clock, and no end by it.
fn ending(limit: Duration) -> Option<Instant> {
    if cfg!(all(target_family = "wasm", target_os = "unknown")) {
        return None;
    }
    Instant::now().checked_add(limit)
}

impl End {
    fn new(at: Option<Instant>, stop: Option<Arc<AtomicBool>>) -> Self {
        Self { at, stop, is_lifted: AtomicBool::new(false) }
    }

    fn is_past(&self) -> bool {
        self.stop.as_ref().is_some_and(|stop| stop.load(Ordering::Relaxed))
            || self.at.is_some_and(|at| Instant::now() >= at)
    }
}

/// Problems are the same whenever they are solved.
impl PartialEq for Deadline {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}
