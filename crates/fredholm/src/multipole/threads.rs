//! Work in parts that do not depend on each other, on all processors: what is found is the same to the last bit whoever does which part.

use std::cell::Cell;
use std::num::NonZero;
use std::process;
use std::sync::{Mutex, OnceLock, PoisonError};
use std::thread;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Fewer multiplications than this are done before another thread is at work on them. At four times that traces of 10,000 points take 1 to 3 % longer (survey).
const WORTH: usize = 1 << 17;
/// Parts for each thread: one that is interrupted then keeps the others waiting for no more than its last part.
const PARTS: usize = 4;

/// Into how many parts so many multiplications are cut; one where no other processor would help.
pub(super) fn parts_of(multiplications: usize) -> usize {
    match processors() {
        1 => 1,
        _ if multiplications < WORTH => 1,
        processors => PARTS * processors,
    }
}

/// Does all parts. Where the system gives no thread this one does them alone, and so does a thread that is at work on a part: waiting for others, each of which may wait for what it is making, no work would end.
pub(super) fn each<T: Send>(parts: Vec<T>, work: impl Fn(T) + Sync) {
    thread_local!(static IS_AT_WORK: Cell<bool> = const { Cell::new(false) });
    let others = parts.len().min(processors()).saturating_sub(1);
    let may_ask = others > 0 && !IS_AT_WORK.get();
    let Some(pool) = may_ask.then(pool).flatten() else {
        return parts.into_iter().for_each(work);
    };
    let parts = Mutex::new(parts.into_iter());
    let next = || parts.lock().unwrap_or_else(PoisonError::into_inner).next();
    let all = || {
        IS_AT_WORK.set(true);
        while let Some(part) = next() {
            work(part);
        }
        IS_AT_WORK.set(false);
    };
    pool.in_place_scope(|scope| {
        for _ in 0..others {
            scope.spawn(|_| all());
        }
        all();
    });
}

/// Threads beside the one that asks, begun once: a thread of its own for every piece of work would cost more than small ones take. A process that was forked from another has none of them.
fn pool() -> Option<&'static ThreadPool> {
    static KNOWN: OnceLock<(u32, Option<ThreadPool>)> = OnceLock::new();
    let begun = || ThreadPoolBuilder::new().num_threads(processors() - 1).build().ok();
    let (owner, pool) = KNOWN.get_or_init(|| (process::id(), begun()));
    pool.as_ref().filter(|_| *owner == process::id())
}

fn processors() -> usize {
    static KNOWN: OnceLock<usize> = OnceLock::new();
    *KNOWN.get_or_init(|| thread::available_parallelism().map_or(1, NonZero::get))
}

#[cfg(test)]
mod tests {
    use std::sync::OnceLock;
    use std::thread;

    use super::each;

    /// The sum of the numbers below `count`, by parts in parts.
    fn sum(count: usize) -> usize {
        let mut rows = vec![vec![0; count]; 16];
        each(rows.iter_mut().collect(), |row: &mut Vec<usize>| {
            each(row.iter_mut().enumerate().collect(), |(k, place)| *place = k);
        });
        rows.iter().flatten().sum::<usize>() / 16
    }

    #[test]
    fn work_within_work_comes_to_an_end() {
        for count in [0, 1, 2, 1000] {
            assert_eq!(sum(count), count * count.saturating_sub(1) / 2);
        }
    }

    #[test]
    fn threads_that_share_what_is_made_once_come_to_an_end() {
        for _ in 0..50 {
            let once = OnceLock::new();
            let made = || *once.get_or_init(|| sum(100));
            thread::scope(|scope| {
                let asked = || {
                    // As `PanelField::values` does: before the work, not within it.
                    let first = made();
                    let mut found = vec![0; 64];
                    each(found.iter_mut().collect(), |place: &mut usize| *place = made() + sum(50));
                    assert_eq!(found, vec![first + 1225; 64]);
                };
                for _ in 0..6 {
                    scope.spawn(asked);
                }
            });
        }
    }
}
