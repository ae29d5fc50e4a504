//! `shtaerman book`: where it looks for the built book, and that it notices a stale one.

use std::fs;

use crate::cli::support::Folder;

/// SHA-256 of `one\n` and `two\n`, by `sha256sum`.
const ONE: &str = "2c8b08da5ce60398e1f19af0e5dccc744df274b826abe585eaba68c525434806";
const TWO: &str = "27dd8ed44a83ff94d557f9fd0412ed5a8cbca69ea04922d88c01184a07300a5a";

/// A clone with a chapter and its built book.
fn clone() -> Folder {
    let folder = Folder::new();
    for path in ["docs/src", "target/book"] {
        fs::create_dir_all(folder.path(path)).unwrap();
    }
    folder.write("docs/src/model.md", "one\n");
    folder.write("target/book/index.html", "<p>one");
    folder.write("target/book/model.html", "<p>one");
    folder.write("target/book/sources.txt", format!("{ONE}  src/model.md\n"));
    folder.write("target/book/version.txt", concat!(env!("CARGO_PKG_VERSION"), "\n"));
    folder
}

const OPEN: [&str; 4] = ["book", "--no-browser", "--folder", "target/book"];

#[test]
fn it_names_the_page_of_the_book() {
    let folder = clone();
    let run = folder.run(&OPEN);
    assert_eq!(run.stderr, "");
    assert!(run.answer().trim_end().ends_with("index.html"));
    let run = folder.run(&[&OPEN[..], &["model.md"]].concat());
    assert!(run.answer().trim_end().ends_with("model.html"));
    let run = folder.run(&[&OPEN[..], &["modle"]].concat());
    assert!(run.refusal().contains("no chapter `modle`; there are model"), "{}", run.stderr);
}

#[test]
fn it_notices_a_stale_book() {
    let folder = clone();
    folder.write("docs/src/model.md", "two\n");
    let run = folder.run(&OPEN);
    assert!(run.stderr.contains("is stale: docs/src/model.md has changed"), "{}", run.stderr);
    folder.write("target/book/sources.txt", format!("{TWO}  src/model.md\n"));
    assert_eq!(folder.run(&OPEN).stderr, "");
    folder.write("docs/src/new.md", "one\n");
    let run = folder.run(&OPEN);
    assert!(run.stderr.contains("docs/src/new.md is new"), "{}", run.stderr);
    folder.write("target/book/version.txt", "0.0.1\n");
    let run = folder.run(&OPEN);
    assert!(run.stderr.contains("about version 0.0.1"), "{}", run.stderr);
    // Elsewhere there is nothing to compare it with.
    fs::rename(folder.path("target"), folder.path("installed")).unwrap();
    folder.write("installed/book/version.txt", env!("CARGO_PKG_VERSION"));
    assert_eq!(folder.run(&["book", "--no-browser", "--folder", "installed/book"]).stderr, "");
}

#[test]
fn without_a_book_it_says_how_one_is_built() {
    let folder = Folder::new();
    let run = folder.run(&["book", "--no-browser", "--folder", "nowhere"]);
    let said = run.refusal();
    assert!(said.contains("nowhere: there is no built book"), "{said}");
    assert!(said.contains("cargo run -p shtaerman-book"), "{said}");
}
