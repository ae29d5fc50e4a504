//! Problem and equation files, read and not solved.

use std::path::Path;

use shtaerman::file::AnyFile;

use crate::broken::{broken, bytes};
use crate::check::Outcome;
use crate::{Random, check, files, written};

/// Keys that `--set` may name.
const KEYS: &[&str] = &[
    "load.force",
    "punch.profile",
    "solver.n",
    "foundation.coating.thickness",
    "kernel.mu",
    "equation.rhs",
    "punch",
    "load.tilt",
    "dimensionless.theta0",
    "solver.tolerance",
    "foundation.roughness.exponent",
    "nothing.at.all",
    "",
    "a..b",
    "\"a b\".c",
];

/// Reads a file that was made, and broken in half of the cases, with overrides in a quarter.
pub(super) fn case(random: &mut Random) -> Result<Outcome, String> {
    let mut text = if random.one_in(4) { files::equation(random) } else { files::problem(random) };
    if random.one_in(2) {
        text = broken(random, &text);
    }
    let mut overrides = Vec::new();
    if random.one_in(4) {
        let value = match random.below(3) {
            0 => written::quantity(random),
            1 => format!("\"{}\"", written::quantity(random)),
            _ => written::formula(random, &["x", "xi"], 6),
        };
        let value = if random.one_in(4) { broken(random, &value) } else { value };
        overrides.push(format!("{}={value}", random.of(KEYS)));
    }
    let content = bytes(random, &text);
    // No folder of this name exists: profiles are not read from files.
    match AnyFile::from_bytes(&content, "made.toml", Path::new("/nowhere"), &overrides) {
        Ok(_) => Ok(Outcome::Accepted),
        Err(error) => check::refusal(&error.to_string(), &format!("{text}\n{overrides:?}")),
    }
}
