//! How much memory a dense system may take.

mod group;
mod process;

use std::path::Path;

/// Assumed where the operating system does not tell.
const FALLBACK: u64 = 8 << 30;

/// Memory that can be had without swapping, in bytes: on Linux the least of `MemAvailable`, what the limits of the process
/// (`ulimit -v`, `ulimit -d`) leave, and what its control groups leave; elsewhere 8 GiB.
///
/// ```
/// assert!(fredholm::memory::available() > 0);
/// ```
#[must_use]
pub fn available() -> u64 {
    let read = |path: &Path| std::fs::read_to_string(path).ok();
    let machine =
        read(Path::new("/proc/meminfo")).and_then(|text| kibibytes(&text, "MemAvailable:"));
    [process::available(&read), group::available(&read)]
        .into_iter()
        .flatten()
        .fold(machine.unwrap_or(FALLBACK), u64::min)
}

/// Reads a file of the system; none where it cannot be read.
type Reader<'a> = &'a dyn Fn(&Path) -> Option<String>;

/// The bytes of a line such as `VmSize:    123 kB`.
fn kibibytes(text: &str, name: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    let count: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(count.saturating_mul(1024))
}

/// A number of bytes as people read it, in binary units.
pub(crate) fn display(bytes: u64) -> String {
    const UNITS: [&str; 7] = ["B", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"];
    let mut value = bytes as f64;
    let mut unit = 0;
    while value >= 1024.0 && unit + 1 < UNITS.len() {
        value /= 1024.0;
        unit += 1;
    }
    format!("{value:.3} {}", UNITS[unit])
}
