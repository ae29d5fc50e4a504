//! How the sources hang together: files and folders import one another in one direction.
//!
//! A file imports another where it names something that is defined there, through re-exports too. Two rules hold for every crate, its tests left out:
//!
//! - Between folders there is no circle: where folder A imports from folder B, straight or through others, B imports nothing from A. The files beside `lib.rs`
//!   are a folder as others are. A `mod.rs` (or `lib.rs`, `main.rs`) that names what lies in the folders below it, such as re-exports of it, is no import
//!   in this sense, unless these name something that is defined in that `mod.rs`.
//! - Within a folder no circle has more than three files.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

mod circles;
mod modules;
mod numbers;
mod surface;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use circles::{Graph, circles};
use modules::{Imports, Modules};
use numbers::Numbers;
use surface::surface;

/// The most files of one folder that may import one another in a circle.
const MOST_FILES: usize = 3;
/// The most lines of `contact/`, and the most numbers that have a name there.
const MOST_LINES: usize = 17_000;
const MOST_NUMBERS: usize = 150;

/// How the line of a circle begins.
const FOLDERS: &str = "folders: ";
const FILES: &str = "files: ";

#[test]
fn imports_go_one_way() {
    let crates: Vec<Imports> = roots().iter().map(|root| Modules::read(root).imports()).collect();
    let found: BTreeSet<String> = crates.iter().flat_map(circles_of).collect();
    let arrows: Vec<String> = found
        .iter()
        .flat_map(|circle| crates.iter().flat_map(|imports| arrows(imports, circle)))
        .collect();
    let circles: Vec<&str> = found.iter().map(String::as_str).collect();
    assert!(
        found.is_empty(),
        "circles of imports:\n{}\n\nthe imports in them:\n{}\n",
        circles.join("\n"),
        arrows.join("\n")
    );
}

/// What a reader of `contact/` has before him stays within what he can keep in mind: `cargo test -p shtaerman --test structure -- --nocapture` shows how much that is.
#[test]
fn contact_stays_small() {
    let contact = repository().join("crates/shtaerman/src/contact");
    let (mut lines, mut named, mut bare) = (0, 0, Vec::new());
    for file in &sources(&contact) {
        let numbers = Numbers::read(file);
        lines += std::fs::read_to_string(file).unwrap().lines().count();
        if !is_of_tests(file) {
            println!("{}: {}", short(file), numbers.named.join(" "));
            named += numbers.named.len();
            bare.extend(numbers.bare.iter().map(|number| format!("{}: {number}", short(file))));
        }
    }
    println!("contact: {lines} lines, {named} named numbers");
    assert!((1..=MOST_LINES).contains(&lines), "{lines} lines");
    assert!((1..=MOST_NUMBERS).contains(&named), "{named} named numbers");
    assert!(bare.is_empty(), "comparisons with a number that has no name:\n{}", bare.join("\n"));
}

/// What a user can name is a promise: a change of it is meant, and is seen in the listing. `shtaerman` shows modules of `shtaerman_input` as its own.
#[test]
fn the_public_interface_is_the_one_listed() {
    const RENEW: &str = "RENEW_LISTINGS";
    for (name, folder) in
        [("fredholm", "fredholm"), ("shtaerman", "shtaerman"), ("shtaerman_input", "input")]
    {
        let root = repository().join(format!("crates/{folder}/src/lib.rs"));
        let now = surface(name, &root);
        let listing =
            repository().join(format!("crates/shtaerman/tests/data/public_api/{name}.txt"));
        if std::env::var_os(RENEW).is_some() {
            let text: String = now.iter().map(|line| format!("{line}\n")).collect();
            std::fs::write(&listing, text).unwrap();
        }
        let text = std::fs::read_to_string(&listing).unwrap();
        let listed: BTreeSet<String> = text.lines().map(str::to_owned).collect();
        let gone = listed.difference(&now).map(|line| format!("- {line}\n"));
        let new = now.difference(&listed).map(|line| format!("+ {line}\n"));
        let changes: String = gone.chain(new).collect();
        assert!(
            changes.is_empty(),
            "{} differs from the sources:\n{changes}If that is meant, renew it with `{RENEW}=1 cargo test -p shtaerman --test structure`, \
             and say in CHANGELOG.md what changed.",
            listing.display()
        );
    }
}

/// All files of a folder and of those in it, by name.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut inside: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    inside.sort();
    inside
        .into_iter()
        .flat_map(|path| if path.is_dir() { sources(&path) } else { vec![path] })
        .collect()
}

/// Whether a file holds tests alone.
fn is_of_tests(file: &Path) -> bool {
    file.ends_with("tests.rs")
}

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap()
}

/// The roots of all crates.
fn roots() -> Vec<PathBuf> {
    let folders = std::fs::read_dir(repository().join("crates")).unwrap();
    let sources = folders.map(|folder| folder.unwrap().path().join("src"));
    let root = |source: PathBuf| {
        ["lib.rs", "main.rs"].map(|name| source.join(name)).into_iter().find(|root| root.exists())
    };
    let mut roots: Vec<PathBuf> = sources.filter_map(root).collect();
    roots.sort();
    roots
}

/// The circles of a crate, each on one line.
fn circles_of(imports: &Imports) -> Vec<String> {
    let show = |circle: &BTreeSet<String>| circle.iter().cloned().collect::<Vec<_>>().join(" ");
    let between = circles(&folders(imports));
    let mut lines: Vec<String> =
        between.iter().map(|circle| format!("{FOLDERS}{}", show(circle))).collect();
    let all: BTreeSet<PathBuf> = imports.keys().map(|file| folder_of(file)).collect();
    for folder in all {
        let within = circles(&inside(imports, &folder));
        let long = within.iter().filter(|circle| circle.len() > MOST_FILES);
        lines.extend(long.map(|circle| format!("{FILES}{}", show(circle))));
    }
    lines
}

/// What makes a circle, one import on a line.
fn arrows(imports: &Imports, circle: &str) -> Vec<String> {
    let folders = circle.strip_prefix(FOLDERS);
    let names: BTreeSet<&str> =
        folders.or(circle.strip_prefix(FILES)).unwrap_or_default().split(' ').collect();
    let node = |file: &Path| if folders.is_some() { short(&folder_of(file)) } else { short(file) };
    let mut lines = Vec::new();
    for (file, targets) in imports {
        for (target, named) in targets {
            let [from, to] = [node(file), node(target)];
            let is_arrow = from != to
                && names.contains(from.as_str())
                && names.contains(to.as_str())
                && (folders.is_none() || counts_between_folders(imports, file, target));
            if is_arrow {
                let named: Vec<&str> = named.iter().map(String::as_str).collect();
                lines.push(format!("{} -> {}: {}", short(file), short(target), named.join(", ")));
            }
        }
    }
    lines
}

/// Imports between the files of one folder.
fn inside(imports: &Imports, folder: &Path) -> Graph {
    let mut graph = Graph::new();
    for (file, targets) in imports.iter().filter(|(file, _)| folder_of(file) == folder) {
        let near = targets.keys().filter(|target| folder_of(target) == folder);
        graph.insert(short(file), near.map(|target| short(target)).collect());
    }
    graph
}

/// Imports between folders.
fn folders(imports: &Imports) -> Graph {
    let mut graph = Graph::new();
    for (file, targets) in imports {
        let arrows = graph.entry(short(&folder_of(file))).or_default();
        let far = targets.keys().filter(|target| counts_between_folders(imports, file, target));
        arrows.extend(far.map(|target| short(&folder_of(target))));
    }
    graph
}

/// Whether the import of one file by another is one between folders.
fn counts_between_folders(imports: &Imports, file: &Path, target: &Path) -> bool {
    let [from, to] = [folder_of(file), folder_of(target)];
    let stands_above = is_head(file) && to.starts_with(&from);
    let is_asked_back = || {
        let mut below = imports.iter().filter(|(other, _)| folder_of(other) == to);
        below.any(|(_, named)| named.contains_key(file))
    };
    from != to && (!stands_above || is_asked_back())
}

/// The folder whose head a file is by its name: of `mod.rs` the one it lies in, of `name.rs` the folder `name` beside it, if there is one.
fn headed(file: &Path) -> Option<PathBuf> {
    let is_named = ["mod.rs", "lib.rs", "main.rs"].iter().any(|name| file.ends_with(name));
    if is_named {
        return file.parent().map(Path::to_owned);
    }
    Some(file.with_extension("")).filter(|folder| folder.is_dir())
}

fn is_head(file: &Path) -> bool {
    headed(file).is_some()
}

/// The folder to which a file belongs.
fn folder_of(file: &Path) -> PathBuf {
    headed(file).unwrap_or_else(|| file.with_file_name("").components().collect())
}

/// A path from the crates on, without `src`.
fn short(path: &Path) -> String {
    let crates = repository().join("crates");
    path.strip_prefix(crates).unwrap().to_string_lossy().replace("/src", "")
}
