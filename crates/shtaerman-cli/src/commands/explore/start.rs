//! What the page begins with.

#[cfg(not(target_family = "wasm"))]
use std::path::Path;
use std::time::Duration;

use serde_json::{Value, json};
#[cfg(not(target_family = "wasm"))]
use shtaerman::document::{Document, ValueKind, load_bytes};
use shtaerman::quantity::OutputUnits;
use shtaerman_study::Output;

use super::kernel;
#[cfg(not(target_family = "wasm"))]
use crate::failure::shown;

macro_rules! example {
    ($name:literal) => {
        ($name, include_str!(concat!("../../../../../examples/", $name, ".toml")))
    };
}

/// The examples that the page offers.
const EXAMPLES: [(&str, &str); 14] = [
    example!("crowned_punch"),
    example!("flat_punch"),
    example!("eccentric_load"),
    example!("two_punches"),
    example!("wave"),
    example!("rough_ball"),
    example!("rubber_layer"),
    example!("coated_shaft"),
    example!("power_layer"),
    example!("measured_profile"),
    example!("paper_row"),
    example!("studies/force_and_roughness"),
    example!("equation_power"),
    example!("equation_log"),
];

const TRACE: (&str, &str) =
    ("measured_profile.csv", include_str!("../../../../../examples/measured_profile.csv"));

/// What the page begins with where it has no file.
pub(super) fn without_file(limit: Duration) -> Value {
    told(&Value::Null, limit)
}

/// What the page begins with for a file that was read.
#[cfg(not(target_family = "wasm"))]
pub(super) fn with_file(path: &Path, bytes: &[u8], limit: Duration) -> Value {
    let name = path.file_name().map_or_else(|| shown(path), |name| shown(Path::new(name)));
    let text = String::from_utf8_lossy(bytes);
    let file = json!({ "name": name, "toml": text, "files": files(path, &text) });
    told(&file, limit)
}

fn told(file: &Value, limit: Duration) -> Value {
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "file": file,
        "examples": examples(),
        "kernels": kernel::families(),
        "outputs": Output::quantities(),
        "time_limit": limit.as_secs_f64(),
        "unit_systems": OutputUnits::SYSTEMS,
    })
}

fn examples() -> Value {
    let example = |(name, toml): &(&str, &str)| {
        let title = toml.lines().next().unwrap_or_default().trim_start_matches("# ");
        let (trace, content) = TRACE;
        let files = if toml.contains(trace) { json!({ trace: content }) } else { json!({}) };
        let name = name.rsplit('/').next().unwrap_or(name);
        json!({ "name": format!("{name}.toml"), "title": title, "toml": toml, "files": files })
    };
    Value::Array(EXAMPLES.iter().map(example).collect())
}

/// The measured profile that a file names, each byte a character of the same number; that it cannot be read is told when the problem is solved.
#[cfg(not(target_family = "wasm"))]
fn files(path: &Path, text: &str) -> Value {
    let Ok(document) = Document::parse(text, "") else { return json!({}) };
    let keys = ["punch.profile.csv", "dimensionless.profile.csv"];
    let Some(value) = keys.into_iter().find_map(|key| document.get(key)) else { return json!({}) };
    let ValueKind::String(name) = value.kind() else { return json!({}) };
    let folder = path.parent().unwrap_or(Path::new(""));
    match load_bytes(&folder.join(name)) {
        Ok(bytes) => json!({ name: bytes.into_iter().map(char::from).collect::<String>() }),
        Err(_) => json!({}),
    }
}
