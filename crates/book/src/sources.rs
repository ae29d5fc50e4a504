//! What a built book was made of, so that one that is stale is told from one that is not.

use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// Name of the listing in a built book.
pub const LISTING: &str = "sources.txt";

/// SHA-256 and path of each file below `docs`, sorted, as `sha256sum` writes them; `shtaerman book` compares it with the sources.
///
/// # Errors
///
/// Files that cannot be read.
pub fn listing(docs: &Path) -> io::Result<String> {
    let mut files = Vec::new();
    gather(docs, &mut files)?;
    let mut named = Vec::with_capacity(files.len());
    for file in files {
        let path = file.strip_prefix(docs).unwrap_or(&file);
        let parts: Vec<_> = path.iter().map(|part| part.to_string_lossy()).collect();
        named.push((parts.join("/"), Sha256::digest(fs::read(&file)?)));
    }
    named.sort();
    let mut text = String::new();
    for (path, digest) in named {
        for byte in digest {
            // Writing to a string does not fail.
            let _ = write!(text, "{byte:02x}");
        }
        let _ = writeln!(text, "  {path}");
    }
    Ok(text)
}

fn gather(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            gather(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}
