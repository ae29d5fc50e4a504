//! The book in `docs/` as HTML that needs no network: mdBook as a library, with formulas set by `KaTeX` beforehand.

mod formulas;
mod sources;

use std::fs;
use std::path::{Path, PathBuf};

use mdbook_driver::MDBook;
use mdbook_driver::book::{Book, BookItem};
use mdbook_driver::errors::{Error, Result};
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};

pub use formulas::{BadFormula, Setter};
pub use sources::{LISTING, listing};

/// Sets the formulas of every chapter, before mdBook reads its Markdown.
struct Formulas(Setter);

impl Preprocessor for Formulas {
    fn name(&self) -> &'static str {
        "formulas"
    }

    fn run(&self, _: &PreprocessorContext, mut book: Book) -> Result<Book> {
        let mut failure = None;
        book.for_each_mut(|item| {
            let BookItem::Chapter(chapter) = item else { return };
            match self.0.chapter(&chapter.content) {
                Ok(content) => chapter.content = content,
                Err(bad) => {
                    let path = chapter.path.clone().unwrap_or_default();
                    failure.get_or_insert(Error::from(bad).context(path.display().to_string()));
                }
            }
        });
        failure.map_or(Ok(book), Err)
    }
}

/// Builds the book of the folder `docs` into `folder`, which is replaced whole, or left as it was.
///
/// # Errors
///
/// A formula that `KaTeX` does not take, with chapter and line; what mdBook refuses; a `folder` that has files and is no book.
pub fn build(docs: &Path, folder: &Path) -> Result<()> {
    if is_in_use(folder)? {
        return Err(Error::msg(format!(
            "{}: this folder has files and no book in it; name a new one",
            folder.display()
        )));
    }
    let parent = folder.parent().filter(|parent| !parent.as_os_str().is_empty());
    let parent = parent.unwrap_or(Path::new("."));
    fs::create_dir_all(parent)?;
    // Beside the folder, so that it is renamed and not copied.
    let new = tempfile::Builder::new().prefix(".book-").tempdir_in(parent)?;
    let built = std::path::absolute(new.path().join("book"))?;
    let mut book = MDBook::load(docs)?;
    book.config.build.build_dir.clone_from(&built);
    book.with_preprocessor(Formulas(Setter::default()));
    book.build()?;
    copy(&docs.join("katex/fonts"), &built.join("katex/fonts"))?;
    fs::copy(docs.join("katex/LICENSE"), built.join("katex/LICENSE"))?;
    fs::write(built.join(LISTING), listing(docs)?)?;
    fs::write(built.join("version.txt"), concat!(env!("CARGO_PKG_VERSION"), "\n"))?;
    if folder.exists() {
        fs::rename(folder, new.path().join("old"))?;
    }
    fs::rename(&built, folder)?;
    Ok(())
}

/// Whether there is something in a folder that is no book of ours.
fn is_in_use(folder: &Path) -> Result<bool> {
    if !folder.exists() {
        return Ok(false);
    }
    Ok(!folder.join(LISTING).exists() && fs::read_dir(folder)?.next().is_some())
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let path: PathBuf = entry?.path();
        if let Some(name) = path.file_name() {
            fs::copy(&path, to.join(name))?;
        }
    }
    Ok(())
}
