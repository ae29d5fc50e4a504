//! What the control groups of a process leave, in both versions.

use std::path::{Path, PathBuf};

use super::Reader;

/// How a version of control groups names its files.
#[derive(PartialEq)]
struct Version {
    limit: &'static str,
    used: &'static str,
    /// The line of `memory.stat` with the cached files, which the kernel gives up before it refuses memory.
    cached: &'static str,
}

const FIRST: Version = Version {
    limit: "memory.limit_in_bytes",
    used: "memory.usage_in_bytes",
    cached: "total_inactive_file ",
};
const SECOND: Version =
    Version { limit: "memory.max", used: "memory.current", cached: "inactive_file " };

/// Bytes that the control groups of this process leave; none where they have no limit.
pub(super) fn available(read: Reader<'_>) -> Option<u64> {
    let groups = read(Path::new("/proc/self/cgroup"))?;
    let mounts = read(Path::new("/proc/self/mountinfo"))?;
    mounts.lines().filter_map(|line| Mount::parse(line)?.available(&groups, read)).min()
}

/// Where a hierarchy of groups that counts memory is mounted.
struct Mount<'a> {
    version: &'static Version,
    /// The group that stands at the place of the mount.
    root: &'a str,
    place: &'a str,
}

impl<'a> Mount<'a> {
    /// A line of `mountinfo`: four fields in front of the place, then, behind a dash, the kind, the source and the options.
    fn parse(line: &'a str) -> Option<Self> {
        let (front, back) = line.split_once(" - ")?;
        let mut front = front.split(' ').skip(3);
        let (root, place) = (front.next()?, front.next()?);
        let mut back = back.split(' ');
        let version = match back.next()? {
            "cgroup2" => &SECOND,
            "cgroup" if back.nth(1)?.split(',').any(|option| option == "memory") => &FIRST,
            _ => return None,
        };
        Some(Self { version, root, place })
    }

    /// The least that the group of the process and those above it leave.
    fn available(&self, groups: &str, read: Reader<'_>) -> Option<u64> {
        let mut folder = self.folder(groups)?;
        let mut least: Option<u64> = None;
        loop {
            let left = self.left(&folder, read);
            least = least.into_iter().chain(left).min();
            if folder == Path::new(self.place) || !folder.pop() {
                return least;
            }
        }
    }

    /// The folder of the group of the process.
    fn folder(&self, groups: &str) -> Option<PathBuf> {
        let path = groups.lines().find_map(|line| {
            let mut parts = line.splitn(3, ':');
            let (number, controllers, path) = (parts.next()?, parts.next()?, parts.next()?);
            let is_ours = if *self.version == SECOND {
                number == "0"
            } else {
                controllers.split(',').any(|controller| controller == "memory")
            };
            is_ours.then_some(path)
        })?;
        // In a container the mount shows a group below the root; a group outside of it is not seen.
        let inside = path.strip_prefix(self.root.trim_end_matches('/')).unwrap_or("");
        let inside = inside.trim_start_matches('/');
        let is_seen = !inside.split('/').any(|part| part == "..");
        Some(Path::new(self.place).join(if is_seen { inside } else { "" }))
    }

    fn left(&self, folder: &Path, read: Reader<'_>) -> Option<u64> {
        let number = |name: &str| read(&folder.join(name))?.trim().parse::<u64>().ok();
        // `max` where there is no limit.
        let limit = number(self.version.limit)?;
        let used = number(self.version.used)?;
        let cached = read(&folder.join("memory.stat"))
            .and_then(|text| {
                text.lines().find_map(|line| line.strip_prefix(self.version.cached)?.parse().ok())
            })
            .unwrap_or(0);
        Some(limit.saturating_sub(used.saturating_sub(cached)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is left where these files are all there is.
    fn left(files: &[(&str, &str)]) -> Option<u64> {
        available(&|path| {
            let file = files.iter().find(|(name, _)| Path::new(name) == path)?;
            Some(file.1.to_owned())
        })
    }

    const SECOND_ALONE: &str =
        "31 23 0:28 / /sys/fs/cgroup rw,relatime shared:4 - cgroup2 cgroup2 rw,nsdelegate\n";

    #[test]
    fn groups_of_the_second_version_count_with_those_above() {
        let mut files = vec![
            ("/proc/self/cgroup", "0::/user/job\n"),
            ("/proc/self/mountinfo", SECOND_ALONE),
            ("/sys/fs/cgroup/user/job/memory.max", "max\n"),
            ("/sys/fs/cgroup/user/job/memory.current", "100\n"),
            ("/sys/fs/cgroup/user/memory.max", "1000\n"),
            ("/sys/fs/cgroup/user/memory.current", "700\n"),
            ("/sys/fs/cgroup/user/memory.stat", "anon 200\ninactive_file 500\n"),
        ];
        assert_eq!(left(&files), Some(800));
        files[2].1 = "300";
        assert_eq!(left(&files), Some(200));
        assert_eq!(left(&files[..2]), None);
        assert_eq!(left(&[]), None);
    }

    #[test]
    fn groups_of_the_first_version_are_those_of_the_memory() {
        let files = [
            ("/proc/self/cgroup", "4:memory:/docker/box/job\n1:cpu:/\n0::/\n"),
            (
                "/proc/self/mountinfo",
                "32 31 0:29 / /sys/fs/cgroup/cpu rw - cgroup cgroup rw,cpu\n\
                 35 31 0:32 /docker/box /sys/fs/cgroup/memory rw - cgroup cgroup rw,memory\n",
            ),
            ("/sys/fs/cgroup/memory/job/memory.limit_in_bytes", "5000\n"),
            ("/sys/fs/cgroup/memory/job/memory.usage_in_bytes", "6000\n"),
            ("/sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n"),
            ("/sys/fs/cgroup/memory/memory.usage_in_bytes", "6000\n"),
        ];
        assert_eq!(left(&files), Some(0));
        let outside = [
            ("/proc/self/cgroup", "0::/../other\n"),
            ("/proc/self/mountinfo", SECOND_ALONE),
            ("/sys/fs/cgroup/memory.max", "900\n"),
            ("/sys/fs/cgroup/memory.current", "100\n"),
        ];
        assert_eq!(left(&outside), Some(800));
    }
}
