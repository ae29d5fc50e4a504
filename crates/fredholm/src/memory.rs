//! How much memory a dense system may take.

/// Assumed where the operating system does not tell.
const FALLBACK: u64 = 8 << 30;

/// Memory that can be had without swapping, in bytes: `MemAvailable` on Linux, elsewhere 8 GiB.
///
/// ```
/// assert!(fredholm::memory::available() > 0);
/// ```
#[must_use]
pub fn available() -> u64 {
    std::fs::read_to_string("/proc/meminfo")
        .ok()
        .and_then(|text| {
            let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
            line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()
        })
        .map_or(FALLBACK, |kib| kib.saturating_mul(1024))
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
