//! That the page is shown in the browser of the user, and only where that is wanted.

use std::io::{BufRead, BufReader};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::explore::client::{PROGRAM, Page};

/// What desktops open addresses with; this one writes them down.
fn fake_browser(folder: &Path) {
    let told = folder.join("told");
    let script = format!("#!/bin/sh\nprintf '%s\\n' \"$@\" > '{}'\n", told.display());
    let path = folder.join("xdg-open");
    std::fs::write(&path, script).unwrap();
    std::fs::set_permissions(&path, PermissionsExt::from_mode(0o755)).unwrap();
}

fn explore(path: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(PROGRAM);
    command.arg("explore").args(more).env("PATH", path).stderr(Stdio::piped());
    command
}

/// What the browser was asked to open; none within a time.
fn opened(folder: &Path, within: Duration) -> Option<String> {
    let start = Instant::now();
    while start.elapsed() < within {
        let told = std::fs::read_to_string(folder.join("told")).unwrap_or_default();
        if told.ends_with('\n') {
            return Some(told);
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    None
}

#[test]
fn the_browser_is_asked_for_the_page_that_is_served() {
    let folder = tempfile::tempdir().unwrap();
    fake_browser(folder.path());
    let page = Page::of(explore(folder.path(), &[]));
    let told = opened(folder.path(), Duration::from_secs(60)).unwrap();
    assert_eq!(told, format!("http://127.0.0.1:{}/\n", page.port));
    assert_eq!(page.get("/").status, 200);
}

#[test]
fn no_browser_is_asked_where_none_is_wanted() {
    let folder = tempfile::tempdir().unwrap();
    fake_browser(folder.path());
    let page = Page::of(explore(folder.path(), &["--no-browser"]));
    // It is served by then, and would have been opened before.
    assert_eq!(page.get("/").status, 200);
    assert_eq!(opened(folder.path(), Duration::from_millis(300)), None);
}

/// Without a browser the address is told, and the page is served all the same.
#[test]
fn that_there_is_no_browser_is_told_with_the_address() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = Page::of(explore(folder.path(), &[]));
    let mut line = String::new();
    BufReader::new(page.process.stderr.take().unwrap()).read_line(&mut line).unwrap();
    let advice = format!("open http://127.0.0.1:{}/ yourself", page.port);
    assert!(
        line.starts_with("warning: no browser could be opened") && line.contains(&advice),
        "{line}"
    );
    assert_eq!(page.get("/").status, 200);
}
