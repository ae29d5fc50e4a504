//! When a search has to come to its end: by the clock where a limit of time is given, else by the work it has done, which is the same on every machine.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// What a search does, in cubes of the numbers of unknowns of dense systems, some 10 to 15 ps each (survey: what takes longest among 800 plausible problems, and among 200,000 random ones).
pub(crate) mod work {
    /// What a search may do, some five seconds, and as much again for so many measured points.
    pub(crate) const MOST: f64 = 3.2e11;
    pub(crate) const POINTS: f64 = 1000.0;
    /// Of a step on panels for each node, and of a look at a place; and of a product for each node.
    pub(crate) const NODE: f64 = 4.7e5;
    pub(crate) const PRODUCT: f64 = 3.5e4;
    /// Of the means over groups of panels for each cube of their number, which is a definite system (survey: a step that shows 6000 zones).
    pub(crate) const GROUPS: f64 = 0.5;
    /// So many pairs of nodes that are near to each other take as long as a node (survey: 40 to 300 a node, up to 5800 where they crowd).
    pub(crate) const PAIRS: f64 = 300.0;
    /// So many times as much where the kernel is a power.
    pub(crate) const POWERS: f64 = 1.5;
    /// So many times as much where panels are rings, about: a trace of 2000 points on a nearly smooth disk was refused after 30 s without it.
    pub(crate) const ON_RINGS: f64 = 2.0;
    /// Of a system on cells for each cube: the definite way is tried before the general one, and memory is asked for anew.
    pub(crate) const CELLS: f64 = 5.4;
    /// Of what a place does to another on a rough surface, where it is a ring, where its kernel is a power, and where it lies on a layered body, of which the potential counts as well.
    pub(crate) const ENTRY: f64 = 340.0;
    pub(crate) const RING: f64 = 1700.0;
    pub(crate) const RING_OF_POWER: f64 = 4000.0;
    pub(crate) const LAYERED_RING: f64 = 67_000.0;
    /// So many times the cube of the modes on a smooth surface; of a zone so many times that for what it does to itself and to another, and of what a node of a ring does to another.
    pub(crate) const SPECTRAL: f64 = 3.4;
    pub(crate) const MODES: f64 = 8.0;
    pub(crate) const RINGS: f64 = 6000.0;
    /// Of a term of a sum for the pressure of a smooth surface, or for its displacement, at a place where it is looked at.
    pub(crate) const TERM: f64 = 170.0;
    /// So many times as much where terms are powers.
    pub(crate) const TERMS_OF_POWER: usize = 12;
    /// Of a slope of the profile on a smooth surface by polynomials, and by the formula itself.
    pub(crate) const SLOPE: f64 = 11_000.0;
    pub(crate) const DERIVATIVE: f64 = 34_000.0;
    /// Formulas of so many operations count as a whole one, shorter ones as their part (survey: a power of a distance takes 100 ns).
    const LONG: usize = 24;

    /// The part of a derivative that one of a formula of so many operations is.
    pub(crate) fn share(operations: Option<usize>) -> f64 {
        operations.map_or(1.0, |count| (count as f64 / LONG as f64).min(1.0))
    }
}

/// The end of the time, or of the work, that a solve may take, or the wish of its caller to end it; without a limit of time no clock is read.
#[derive(Debug, Clone, Default)]
pub(crate) struct Deadline(Option<Arc<End>>);

#[derive(Debug)]
struct End {
    at: Option<Instant>,
    /// What is left of the work, in cubes of the numbers of unknowns of dense systems; none where time is limited.
    work: Option<AtomicU64>,
    /// Set by the caller who does not want to wait any longer.
    stop: Option<Arc<AtomicBool>>,
    /// Once the answer is there, nothing that is asked of it ends early.
    is_lifted: AtomicBool,
}

impl Deadline {
    /// From now on; a limit beyond what a clock can tell is none.
    pub(crate) fn after(limit: Duration) -> Self {
        let end = ending(limit);
        Self(end.map(|at| Arc::new(End::new(Some(at), None, None))))
    }

    /// After so much work.
    pub(crate) fn of_work(most: f64) -> Self {
        Self(Some(Arc::new(End::new(None, Some(most), None))))
    }

    /// After this time, or else so much work, and earlier where the caller says so.
    pub(crate) fn unless(stop: &Arc<AtomicBool>, limit: Option<Duration>, most: f64) -> Self {
        let (end, work) = (limit.and_then(ending), limit.is_none().then_some(most));
        Self(Some(Arc::new(End::new(end, work, Some(Arc::clone(stop))))))
    }

    /// Takes work from what is left.
    pub(crate) fn spend(&self, work: f64) {
        if let Some(left) = self.0.as_ref().and_then(|end| end.work.as_ref()) {
            let rest = left.load(Ordering::Relaxed).saturating_sub(work as u64);
            left.store(rest, Ordering::Relaxed);
        }
    }

    /// Whether there is one that holds.
    pub(crate) fn is_set(&self) -> bool {
        self.0.as_ref().is_some_and(|end| !end.is_lifted.load(Ordering::Relaxed))
    }

    pub(crate) fn is_past(&self) -> bool {
        self.is_set() && self.0.as_ref().is_some_and(|end| end.is_past())
    }

    /// Whether no work is left.
    pub(crate) fn is_spent(&self) -> bool {
        self.is_set() && self.0.as_ref().is_some_and(|end| end.is_spent())
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
    fn new(at: Option<Instant>, work: Option<f64>, stop: Option<Arc<AtomicBool>>) -> Self {
        let work = work.map(|most| AtomicU64::new(most as u64));
        Self { at, work, stop, is_lifted: AtomicBool::new(false) }
    }

    fn is_spent(&self) -> bool {
        self.work.as_ref().is_some_and(|left| left.load(Ordering::Relaxed) == 0)
    }

    fn is_past(&self) -> bool {
        self.stop.as_ref().is_some_and(|stop| stop.load(Ordering::Relaxed))
            || self.is_spent()
            || self.at.is_some_and(|at| Instant::now() >= at)
    }
}

/// Problems are the same whenever they are solved.
impl PartialEq for Deadline {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}
