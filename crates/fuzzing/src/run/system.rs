//! What the system says of this process; Linux does.

use std::fs;
use std::time::Duration;

/// Time of the processor that this thread has had.
pub(super) fn processor_time() -> Option<Duration> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split(' ').next()?.parse().ok().map(Duration::from_nanos)
}

/// The most memory that this process has held at once since [`forget_memory`], in bytes.
#[must_use]
pub fn memory() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix(" kB")?.parse::<u64>().ok().map(|size| size * 1024)
}

/// Begins to measure [`memory`] anew.
pub fn forget_memory() {
    // Where that cannot be, the figure is that of the whole process.
    let _ = fs::write("/proc/self/clear_refs", "5");
}
