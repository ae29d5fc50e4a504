//! Work in parts that do not depend on each other, on all processors: what is found is the same to the last bit whoever does which part.

use std::num::NonZero;
use std::sync::{Mutex, OnceLock, PoisonError};
use std::thread::{self, Builder};

/// Fewer multiplications than this are done before another thread has begun.
const WORTH: usize = 1 << 19;
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

/// Does all parts. Where the system gives no thread this one does them alone.
pub(super) fn each<T: Send>(parts: Vec<T>, work: impl Fn(T) + Sync) {
    let others = parts.len().min(processors()) - usize::from(!parts.is_empty());
    let parts = Mutex::new(parts.into_iter());
    let next = || parts.lock().unwrap_or_else(PoisonError::into_inner).next();
    let all = || {
        while let Some(part) = next() {
            work(part);
        }
    };
    thread::scope(|scope| {
        for _ in 0..others {
            let _ = Builder::new().spawn_scoped(scope, all);
        }
        all();
    });
}

fn processors() -> usize {
    static KNOWN: OnceLock<usize> = OnceLock::new();
    *KNOWN.get_or_init(|| thread::available_parallelism().map_or(1, NonZero::get))
}
