//! Times that other jobs on the machine do not count in.

use std::sync::LazyLock;
use std::time::Instant;

/// When the first time was asked for.
static START: LazyLock<Instant> = LazyLock::new(Instant::now);

/// Processor time of this thread in seconds, where the system tells it (Linux, which counts some in steps of 4 ms); elsewhere the time since the first call.
pub(crate) fn seconds() -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| START.elapsed().as_secs_f64(), |found| 1e-9 * found)
}

/// The mean time of one of many calls, as many as take some tenths of a second, and what the last returned.
pub(crate) fn mean<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let mut last = work();
    let mut count = 1;
    loop {
        let start = seconds();
        (0..count).for_each(|_| last = work());
        let spent = seconds() - start;
        if spent > 0.25 {
            return (spent / f64::from(count), last);
        }
        count *= 2;
    }
}
