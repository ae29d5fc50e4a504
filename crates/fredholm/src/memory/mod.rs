//! How much memory a dense system may take.

mod group;
mod process;

use std::path::Path;

use crate::Error;

/// Share of the memory at hand that a computation may take: the rest is for the answer and for others.
const SHARE: f64 = 0.9;
/// Bytes that fit without asking: reading what the system tells takes longer than the computations that need no more.
const SMALL: f64 = (16 << 20) as f64;
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

/// Refuses what would not fit into memory, before anything is allocated. The bytes, all that is held at once, come in floating point: the square of a hostile count
/// overflows every integer.
///
/// # Errors
/// [`Error::TooLarge`], with the degree or number of functions that asked for it.
pub(crate) fn admit(degree: usize, bytes: f64) -> Result<(), Error> {
    if bytes <= SMALL {
        return Ok(());
    }
    let available = available();
    if bytes <= SHARE * available as f64 {
        return Ok(());
    }
    Err(Error::TooLarge { degree, needed: bytes as u64, available })
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
