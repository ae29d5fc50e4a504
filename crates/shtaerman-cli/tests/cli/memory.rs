//! Results of any size are written as they are made.
#![cfg(target_os = "linux")]

use crate::cli::support::{Folder, PHYSICAL, finished};

/// 150 MB of addresses, of which the program alone has 60. As trees of values these took from 200 MB on, and forty times that at their largest.
const LIMIT: &str = "ulimit -v 150000";

#[test]
fn many_rows_take_little_memory() {
    let folder = Folder::new();
    for format in ["json", "csv", "table"] {
        let rows = ["regularity", "--theta0", "13", "--rows", "50000", "--format", format];
        let text = finished(folder.limited(LIMIT, &rows).output().unwrap()).answer();
        assert!(text.matches('\n').count() > 100_000, "{format}");
    }
}

#[test]
fn grids_take_little_memory() {
    let folder = Folder::with(PHYSICAL);
    let grid = ["stress", "punch.toml", "--no-audit", "--grid", "300x300"];
    for format in ["json", "csv", "npz"] {
        let more = ["--format", format, "--output", "grid"];
        let run = folder.limited(LIMIT, &[&grid[..], &more].concat()).output().unwrap();
        finished(run).answer();
        // Ten components of 90,000 places, eight bytes each at least.
        assert!(std::fs::metadata(folder.path("grid")).unwrap().len() > 7_200_000, "{format}");
    }
    // What goes into a pipe is what goes into a file.
    let piped = [&grid[..], &["--format", "npz", "--output", "/dev/stdout"]].concat();
    let piped = folder.command(&piped).output().unwrap();
    assert!(piped.stdout == std::fs::read(folder.path("grid")).unwrap());
}
