//! The arguments of `shtaerman explore`.

use std::path::PathBuf;

use clap::Args;

/// `shtaerman explore`.
#[derive(Debug, Args)]
pub struct ExploreArguments {
    /// Problem, equation or study file (TOML) to begin with [default: an example].
    #[arg(value_name = "FILE.toml")]
    pub file: Option<PathBuf>,
    /// Port of this machine for the page [default: 4117, or another where that is taken].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub port: Option<u16>,
    /// Do not open the browser; the address is printed.
    #[arg(long)]
    pub no_browser: bool,
    /// How long a solve may take, such as "30 s"; what takes twice as long is ended.
    #[arg(long, value_name = "TIME", default_value = "10 s", allow_hyphen_values = true)]
    pub time_limit: String,
    /// Be a process that computes for the page.
    #[arg(long, hide = true, conflicts_with_all = ["file", "port", "no_browser"])]
    pub worker: bool,
}
