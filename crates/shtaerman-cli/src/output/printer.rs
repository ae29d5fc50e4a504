//! PDF by a browser: Chromium prints a page into a file.

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::Failure;

/// Names it a browser by the user.
const VARIABLE: &str = "SHTAERMAN_CHROMIUM";
/// The names of Chromium and its kin.
const NAMES: [&str; 8] = [
    "chromium",
    "chromium-browser",
    "google-chrome-stable",
    "google-chrome",
    "chrome",
    "microsoft-edge",
    "msedge",
    "brave-browser",
];
/// Where systems keep them that do not put programs on a path.
const PLACES: [&str; 5] = [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
    "C:\\Program Files (x86)\\Microsoft\\Edge\\Application\\msedge.exe",
];
/// The longest that a page may take.
const PATIENCE: Duration = Duration::from_secs(60);
const TICK: Duration = Duration::from_millis(20);

/// A browser that prints.
#[derive(Debug)]
pub(crate) struct Printer(PathBuf);

impl Printer {
    /// The browser that the user names, or one of those there are.
    ///
    /// # Errors
    /// [`Failure::Usage`] where there is none, with what else can be done.
    pub(crate) fn find(otherwise: &str) -> Result<Self, Failure> {
        if let Some(named) = std::env::var_os(VARIABLE).filter(|named| !named.is_empty()) {
            let path = PathBuf::from(named);
            if path.is_file() {
                return Ok(Self(path));
            }
            return Err(Failure::Usage(format!(
                "{VARIABLE} is {}, which is no program",
                path.display()
            )));
        }
        let folders = std::env::var_os("PATH").unwrap_or_default();
        let on_path = std::env::split_paths(&folders).flat_map(|folder| {
            NAMES.map(|name| folder.join(format!("{name}{}", std::env::consts::EXE_SUFFIX)))
        });
        let found = on_path.chain(PLACES.map(PathBuf::from)).find(|path| path.is_file());
        found.map(Self).ok_or_else(|| {
            Failure::Usage(format!(
                "a PDF is printed by Chromium, Chrome or Edge, and none was found: name it by {VARIABLE}, or {otherwise}"
            ))
        })
    }

    /// The page as a PDF. The same page gives the same bytes from the same browser: the time at which it was printed, and the numbers that the browser gave to elements, are left out.
    ///
    /// # Errors
    /// [`Failure::Check`] where the browser does not print it.
    pub(crate) fn pdf(&self, html: &str) -> Result<Vec<u8>, Failure> {
        let failed = |what: String| {
            Failure::Check(format!("{} did not print the page: {what}", self.0.display()))
        };
        let folder = tempfile::Builder::new().prefix(super::TEMPORARY).tempdir();
        let folder = folder.map_err(|error| failed(error.to_string()))?;
        let (page, pdf) = (folder.path().join("page.html"), folder.path().join("page.pdf"));
        std::fs::write(&page, html).map_err(|error| failed(error.to_string()))?;
        let mut browser =
            self.start(folder.path(), &page, &pdf).map_err(|error| failed(error.to_string()))?;
        let ended = wait(&mut browser).map_err(|error| failed(error.to_string()))?;
        if !ended {
            return Err(failed(format!("it took longer than {} s", PATIENCE.as_secs())));
        }
        let bytes = std::fs::read(&pdf).map_err(|error| failed(error.to_string()))?;
        if !bytes.starts_with(b"%PDF-") {
            return Err(failed("what it wrote is no PDF".to_owned()));
        }
        Ok(renumbered(timeless(bytes)))
    }

    fn start(&self, folder: &Path, page: &Path, pdf: &Path) -> io::Result<Child> {
        let mut print = std::ffi::OsString::from("--print-to-pdf=");
        print.push(pdf);
        let mut profile = std::ffi::OsString::from("--user-data-dir=");
        profile.push(folder.join("profile"));
        let mut command = Command::new(&self.0);
        command
            .args([
                "--headless",
                "--disable-gpu",
                "--no-first-run",
                "--disable-background-networking",
            ])
            .args([
                "--disable-component-update",
                "--disable-sync",
                "--disable-extensions",
                "--disable-quic",
            ])
            .args(["--no-pdf-header-footer"])
            .args([profile, print])
            .arg(page)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        if is_root() {
            // Its sandbox does not work for the administrator. The page holds no script, and may not load anything.
            command.arg("--no-sandbox");
        }
        command.spawn()
    }
}

/// Whether the browser ended by itself in time; else it is ended.
fn wait(browser: &mut Child) -> io::Result<bool> {
    let since = Instant::now();
    while since.elapsed() < PATIENCE {
        if browser.try_wait()?.is_some() {
            return Ok(true);
        }
        sleep(TICK);
    }
    browser.kill()?;
    browser.wait()?;
    Ok(false)
}

#[cfg(unix)]
fn is_root() -> bool {
    use std::os::unix::fs::MetadataExt;
    std::fs::metadata("/proc/self").is_ok_and(|own| own.uid() == 0)
}

#[cfg(not(unix))]
fn is_root() -> bool {
    false
}

/// The dates of a PDF, as `D:YYYYMMDDHHMMSS`, become the first of 1970: other bytes keep their places.
fn timeless(mut bytes: Vec<u8>) -> Vec<u8> {
    const DATE: &[u8] = b"19700101000000";
    for key in [&b"/CreationDate (D:"[..], b"/ModDate (D:"] {
        for place in digits_behind(&bytes, key, DATE.len()) {
            bytes[place..place + DATE.len()].copy_from_slice(DATE);
        }
    }
    bytes
}

/// The names of marked elements, as `(node00000023)`, which a browser numbers by what it did before, are numbered from 1 in their order, which the tree of names keeps.
fn renumbered(mut bytes: Vec<u8>) -> Vec<u8> {
    const DIGITS: usize = 8;
    let places = digits_behind(&bytes, b"(node", DIGITS);
    let names: BTreeSet<Vec<u8>> =
        places.iter().map(|&place| bytes[place..place + DIGITS].to_vec()).collect();
    for place in places {
        let name = &mut bytes[place..place + DIGITS];
        let rank = names.range(..=name.to_vec()).count();
        name.copy_from_slice(format!("{rank:0DIGITS$}").as_bytes());
    }
    bytes
}

/// Where so many digits stand behind a key.
fn digits_behind(bytes: &[u8], key: &[u8], count: usize) -> Vec<usize> {
    let ends = bytes.windows(key.len()).enumerate().filter(|(_, window)| *window == key);
    let is_number = |place: &usize| {
        bytes.get(*place..place + count).is_some_and(|text| text.iter().all(u8::is_ascii_digit))
    };
    ends.map(|(at, _)| at + key.len()).filter(is_number).collect()
}

#[cfg(test)]
mod tests {
    use super::{renumbered, timeless};

    #[test]
    fn dates_are_left_out_of_a_pdf() {
        let pdf = b"%PDF-1.4 /CreationDate (D:20260102030405+00'00') /ModDate (D:20260102030405+00'00') (D:2026)";
        let shown = String::from_utf8(timeless(pdf.to_vec())).unwrap();
        assert_eq!(
            shown,
            "%PDF-1.4 /CreationDate (D:19700101000000+00'00') /ModDate (D:19700101000000+00'00') (D:2026)"
        );
    }
    #[test]
    fn elements_of_a_pdf_are_numbered_in_their_order() {
        let one = "(node00000023) (node00000024) (node00000031) (node00000023) (node12)";
        let other = "(node00000003) (node00000004) (node00000005) (node00000003) (node12)";
        let shown = |text: &str| String::from_utf8(renumbered(text.into())).unwrap();
        assert_eq!(
            shown(one),
            "(node00000001) (node00000002) (node00000003) (node00000001) (node12)"
        );
        assert_eq!(shown(one), shown(other));
    }
}
