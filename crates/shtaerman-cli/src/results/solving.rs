//! Cases on several threads.

use std::num::NonZero;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use shtaerman_study::{Row, Study};

/// The rows in the order of their cases; each depends on its case alone, so that the number of threads changes nothing.
pub(crate) fn solved(
    study: &Study,
    cases: Range<usize>,
    threads: usize,
    tell: &(dyn Fn(usize) + Sync),
) -> Vec<Row> {
    solved_unless(study, cases, threads, tell, &AtomicBool::new(false)).unwrap_or_default()
}

/// The same, or none where the flag is set before all of them are solved: it is looked at between cases.
pub(super) fn solved_unless(
    study: &Study,
    cases: Range<usize>,
    threads: usize,
    tell: &(dyn Fn(usize) + Sync),
    stop: &AtomicBool,
) -> Option<Vec<Row>> {
    let block = study.block();
    let next = AtomicUsize::new(cases.start);
    let found = Mutex::new(Vec::with_capacity(cases.len()));
    let work = || {
        loop {
            let first = next.fetch_add(block, Ordering::Relaxed);
            if first >= cases.end || stop.load(Ordering::Relaxed) {
                return;
            }
            let rows = study.solve(first..cases.end.min(first + block));
            let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
            found.extend(rows);
            tell(found.len());
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads.min(cases.len().div_ceil(block)) {
            scope.spawn(work);
        }
        work();
    });
    let mut rows = found.into_inner().unwrap_or_else(PoisonError::into_inner);
    rows.sort_by_key(|row| row.case);
    (rows.len() == cases.len()).then_some(rows)
}

/// How many threads work at a time where nobody says.
pub(crate) fn processors() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}
