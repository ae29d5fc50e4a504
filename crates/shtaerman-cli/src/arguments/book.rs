//! `shtaerman book`.

use std::path::PathBuf;

use clap::Args;

/// `shtaerman book`.
#[derive(Debug, Args)]
pub struct BookArguments {
    /// Chapter to begin with, such as problem-files [default: the introduction].
    #[arg(value_name = "CHAPTER")]
    pub chapter: Option<String>,
    /// Folder of the built book [default: that of the variable `SHTAERMAN_BOOK`, else `share/doc/shtaerman/book` beside the folder of the program, else `target/book` of the clone in which it was built].
    #[arg(long, value_name = "FOLDER")]
    pub folder: Option<PathBuf>,
    /// Only print the address.
    #[arg(long)]
    pub no_browser: bool,
}
