//! The book as it is built, without a browser; `crates/explore/tests/browser/test_book.py` looks at it in Chromium.
#![expect(clippy::unwrap_used, reason = "helpers outside of test functions fail by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

/// A page without what stands between these signs, again and again.
fn without(html: &str, from: &str, to: &str) -> String {
    let mut rest = html;
    let mut kept = String::new();
    while let Some((before, after)) = rest.split_once(from) {
        kept.push_str(before);
        rest = after.split_once(to).unwrap().1;
    }
    kept + rest
}

fn pages(folder: &Path) -> Vec<(String, String)> {
    let mut pages: Vec<(String, String)> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "html"))
        .map(|path| {
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            (name, fs::read_to_string(path).unwrap())
        })
        .collect();
    pages.sort();
    pages
}

#[test]
fn no_page_shows_tex_or_loads_anything_from_elsewhere() {
    let folder = tempfile::tempdir().unwrap();
    let book = folder.path().join("book");
    shtaerman_book::build(&docs(), &book).unwrap();
    let mut formulas = 0;
    for (name, html) in pages(&book) {
        formulas += html.matches("class=\"katex\"").count();
        for foreign in ["src=\"http", "rel=\"stylesheet\" href=\"http", "MathJax"] {
            assert!(!html.contains(foreign), "{name} has {foreign}");
        }
        let text = without(&without(&html, "<script", "</script>"), "<pre", "</pre>");
        for sign in ["\\frac", "\\int", "\\theta", "\\ln", "\\,", "\\left", "$$"] {
            assert!(!text.contains(sign), "{name} has {sign}");
        }
    }
    assert!(formulas > 300, "{formulas}");
    for file in ["katex/LICENSE", "katex/fonts/KaTeX_Main-Regular.woff2"] {
        assert!(book.join(file).is_file(), "{file}");
    }
    let listing = fs::read_to_string(book.join(shtaerman_book::LISTING)).unwrap();
    assert!(listing.lines().any(|line| line.ends_with("  src/model.md")), "{listing}");
}

#[test]
fn a_book_is_replaced_and_nothing_else_is() {
    let folder = tempfile::tempdir().unwrap();
    let docs = folder.path().join("docs");
    fs::create_dir_all(docs.join("src")).unwrap();
    fs::create_dir_all(docs.join("katex/fonts")).unwrap();
    fs::write(docs.join("katex/LICENSE"), "MIT").unwrap();
    fs::write(docs.join("book.toml"), "[book]\ntitle = \"t\"\n").unwrap();
    fs::write(docs.join("src/SUMMARY.md"), "[One](one.md)\n").unwrap();
    fs::write(docs.join("src/one.md"), "With $x^2$.\n").unwrap();
    let book = folder.path().join("book");
    shtaerman_book::build(&docs, &book).unwrap();
    fs::write(book.join("left.html"), "of an older book").unwrap();
    shtaerman_book::build(&docs, &book).unwrap();
    assert!(!book.join("left.html").exists());

    // A fault leaves the book as it was, and is told with its place.
    let before = fs::read(book.join("one.html")).unwrap();
    fs::write(docs.join("src/one.md"), "a\nb $\\frac{1}$\n").unwrap();
    let told = format!("{:#}", shtaerman_book::build(&docs, &book).unwrap_err());
    assert!(told.contains("one.md") && told.contains("line 2"), "{told}");
    assert_eq!(fs::read(book.join("one.html")).unwrap(), before);

    let other = folder.path().join("other");
    fs::create_dir(&other).unwrap();
    fs::write(other.join("mine.txt"), "mine").unwrap();
    let told = shtaerman_book::build(&docs, &other).unwrap_err().to_string();
    assert!(told.contains("no book"), "{told}");
    assert!(other.join("mine.txt").is_file());
    // No folder of the work is left beside them.
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3);
}
