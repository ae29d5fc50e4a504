//! `shtaerman book`.

use std::collections::BTreeMap;
use std::env;
use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use crate::Failure;
use crate::arguments::BookArguments;
use crate::failure::{shown, warn};
use crate::output::Outputs;

/// In a built book: SHA-256 and path of each file that it was made of, and the version of the program that it is about.
const SOURCES: &str = "sources.txt";
const VERSION: &str = "version.txt";
/// How one is built.
const BUILD: &str = "`cargo run -p shtaerman-book` in a clone of the repository builds it there, `cargo run -p shtaerman-book -- FOLDER` anywhere else";

pub(super) fn run(arguments: &BookArguments) -> Result<(), Failure> {
    let folder = folder(arguments)?;
    let page = page(&folder, arguments.chapter.as_deref())?;
    if let Some(why) = staleness(&folder) {
        warn(&format!("the book in {} is stale: {why}; {BUILD}", shown(&folder)));
    }
    let mut outputs = Outputs::default();
    outputs.result(None, format!("{}\n", shown(&page)));
    outputs.write()?;
    if !arguments.no_browser {
        show(&page);
    }
    Ok(())
}

#[cfg(not(target_family = "wasm"))]
fn show(page: &Path) {
    if let Err(error) = shtaerman_explore::show(&page.to_string_lossy()) {
        warn(&format!("no browser could be opened ({error}): open the file yourself"));
    }
}

/// In a browser there is one, and this command is not reached.
#[cfg(target_family = "wasm")]
fn show(_page: &Path) {}

/// The folder of a built book: the one that was named, else the first of the usual ones that has one.
fn folder(arguments: &BookArguments) -> Result<PathBuf, Failure> {
    let variable = env::var_os("SHTAERMAN_BOOK").filter(|value| !value.is_empty());
    if let Some(named) = arguments.folder.clone().or(variable.map(PathBuf::from)) {
        if is_book(&named) {
            return Ok(named.canonicalize().unwrap_or(named));
        }
        let message = format!("{}: there is no built book; {BUILD}", shown(&named));
        return Err(Failure::Usage(message));
    }
    let usual = usual();
    if let Some(found) = usual.iter().find(|place| is_book(place)) {
        return Ok(found.canonicalize().unwrap_or(found.clone()));
    }
    let places: Vec<String> = usual.iter().map(|place| shown(place)).collect();
    Err(Failure::Usage(format!(
        "no built book was found, neither in {} nor named by --folder or the variable SHTAERMAN_BOOK; {BUILD}",
        places.join(" nor in ")
    )))
}

/// Beside the folder of the program, as programs are installed, and in the clone where it was built.
fn usual() -> Vec<PathBuf> {
    let program = env::current_exe().and_then(|path| path.canonicalize()).unwrap_or_default();
    let Some(above) = program.parent().and_then(Path::parent) else { return Vec::new() };
    vec![above.join("share/doc/shtaerman/book"), above.join("book")]
}

fn is_book(folder: &Path) -> bool {
    folder.join("index.html").is_file() && folder.join(SOURCES).is_file()
}

fn page(folder: &Path, chapter: Option<&str>) -> Result<PathBuf, Failure> {
    let Some(chapter) = chapter else { return Ok(folder.join("index.html")) };
    let name = chapter.trim_end_matches(".html").trim_end_matches(".md");
    let chapters = chapters(folder)
        .map_err(|error| Failure::Usage(format!("{} cannot be read: {error}", shown(folder))))?;
    if chapters.iter().any(|known| known == name) {
        return Ok(folder.join(format!("{name}.html")));
    }
    let list = chapters.join(", ");
    Err(Failure::Usage(format!("there is no chapter `{chapter}`; there are {list}")))
}

/// Chapters by the names of their files.
fn chapters(folder: &Path) -> io::Result<Vec<String>> {
    let listing = fs::read_to_string(folder.join(SOURCES))?;
    let names = sums(&listing).into_keys().filter_map(|path| {
        let name = path.strip_prefix("src/")?.strip_suffix(".md")?;
        let is_page = folder.join(format!("{name}.html")).is_file();
        is_page.then(|| name.to_owned())
    });
    Ok(names.collect())
}

/// Lines as `sha256sum` writes them: the sum of each path.
fn sums(listing: &str) -> BTreeMap<&str, &str> {
    listing
        .lines()
        .filter_map(|line| line.split_once("  "))
        .map(|(sum, path)| (path, sum))
        .collect()
}

/// Why a book does not say what is so: it is about another version, or in a clone its sources are others by now.
fn staleness(folder: &Path) -> Option<String> {
    let version = fs::read_to_string(folder.join(VERSION)).unwrap_or_default();
    let own = env!("CARGO_PKG_VERSION");
    if version.trim() != own {
        return Some(format!("it is about version {}, and this is {own}", version.trim()));
    }
    let target =
        folder.parent().filter(|target| target.file_name() == Some(OsStr::new("target")))?;
    let docs = target.parent()?.join("docs");
    let listing = fs::read_to_string(folder.join(SOURCES)).ok()?;
    let known = sums(&listing);
    for (path, sum) in &known {
        let now = fs::read(docs.join(path)).ok().map(|content| digest(&content));
        if now.as_deref() != Some(*sum) {
            return Some(format!("docs/{path} has changed since"));
        }
    }
    let entries = fs::read_dir(docs.join("src")).ok()?;
    let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let mut new: Vec<String> = names
        .filter(|name| name.ends_with(".md") && !known.contains_key(format!("src/{name}").as_str()))
        .collect();
    new.sort();
    new.first().map(|name| format!("docs/src/{name} is new"))
}

fn digest(content: &[u8]) -> String {
    Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect()
}
