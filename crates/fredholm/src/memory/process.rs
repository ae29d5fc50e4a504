//! What the limits of a process leave.

use std::path::Path;

use super::{Reader, kibibytes};

/// The name of a limit, and what counts against it.
const LIMITS: [(&str, &str); 2] = [("Max address space", "VmSize:"), ("Max data size", "VmData:")];

/// Bytes that the limits of this process leave; none where it has no limit.
pub(super) fn available(read: Reader<'_>) -> Option<u64> {
    let limits = read(Path::new("/proc/self/limits"))?;
    let status = read(Path::new("/proc/self/status"))?;
    let left = |(name, used): (&str, &str)| {
        let line = limits.lines().find_map(|line| line.strip_prefix(name))?;
        // The soft limit comes first, `unlimited` where there is none.
        let limit: u64 = line.split_whitespace().next()?.parse().ok()?;
        Some(limit.saturating_sub(kibibytes(&status, used)?))
    };
    LIMITS.into_iter().filter_map(left).min()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn left(address_space: &str, data: &str) -> Option<u64> {
        available(&|path| {
            Some(match path.to_str()? {
                "/proc/self/limits" => format!(
                    "Limit                     Soft Limit           Hard Limit           Units     \n\
                     Max data size             {data}                unlimited            bytes     \n\
                     Max address space         {address_space}       unlimited            bytes     \n"
                ),
                "/proc/self/status" => {
                    "Name:\tx\nVmSize:\t    1000 kB\nVmData:\t     200 kB\n".to_owned()
                }
                _ => return None,
            })
        })
    }

    #[test]
    fn the_tightest_limit_counts_less_what_is_used() {
        assert_eq!(left("unlimited", "unlimited"), None);
        assert_eq!(left("2048000", "unlimited"), Some(2_048_000 - 1_024_000));
        assert_eq!(left("2048000", "1024000"), Some(1_024_000 - 204_800));
        assert_eq!(left("1000", "unlimited"), Some(0));
        assert_eq!(available(&|_| None), None);
    }
}
