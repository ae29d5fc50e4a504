//! `cargo run -p shtaerman-book [-- FOLDER]` builds the book.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "cargo run -p shtaerman-book [-- FOLDER]: builds the book of docs/ into FOLDER, by default target/book, where `shtaerman book` finds it";

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut arguments = std::env::args_os().skip(1);
    let folder = match (arguments.next(), arguments.next()) {
        (None, _) => root.join("target/book"),
        (Some(folder), None) if !folder.to_string_lossy().starts_with('-') => PathBuf::from(folder),
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match shtaerman_book::build(&root.join("docs"), &folder) {
        Ok(()) => {
            let folder = folder.canonicalize().unwrap_or(folder);
            println!("the book: {}", folder.join("index.html").display());
            ExitCode::SUCCESS
        }
        Err(reason) => {
            eprintln!("the book was not built: {reason:#}");
            ExitCode::FAILURE
        }
    }
}
