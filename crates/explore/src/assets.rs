//! The files of the page, part of the program.

/// A file of the page.
#[derive(Debug, Clone, Copy)]
pub struct Asset {
    /// Its place, such as `/main.js`.
    pub path: &'static str,
    /// What it is.
    pub content_type: &'static str,
    /// What is in it.
    pub bytes: &'static [u8],
}

const HTML: &str = "text/html; charset=utf-8";
const CSS: &str = "text/css; charset=utf-8";
const JAVASCRIPT: &str = "text/javascript; charset=utf-8";
const SVG: &str = "image/svg+xml";

macro_rules! assets {
    ($(($path:literal, $file:literal, $kind:expr)),* $(,)?) => {
        &[$(Asset { path: $path, content_type: $kind, bytes: include_bytes!(concat!("../assets/", $file)) }),*]
    };
}

/// All of them.
pub const ASSETS: &[Asset] = assets![
    ("/", "index.html", HTML),
    ("/icon.svg", "icon.svg", SVG),
    ("/style.css", "style.css", CSS),
    ("/answers.js", "answers.js", JAVASCRIPT),
    ("/chart.js", "chart.js", JAVASCRIPT),
    ("/controls.js", "controls.js", JAVASCRIPT),
    ("/dom.js", "dom.js", JAVASCRIPT),
    ("/engine.js", "engine.js", JAVASCRIPT),
    ("/inputs.js", "inputs.js", JAVASCRIPT),
    ("/kernels.js", "kernels.js", JAVASCRIPT),
    ("/main.js", "main.js", JAVASCRIPT),
    ("/map.js", "map.js", JAVASCRIPT),
    ("/model.js", "model.js", JAVASCRIPT),
    ("/paper.js", "paper.js", JAVASCRIPT),
    ("/pictures.js", "pictures.js", JAVASCRIPT),
    ("/profile.js", "profile.js", JAVASCRIPT),
    ("/state.js", "state.js", JAVASCRIPT),
    ("/study.js", "study.js", JAVASCRIPT),
    ("/theme.js", "theme.js", JAVASCRIPT),
    ("/toml.js", "toml.js", JAVASCRIPT),
    ("/units.js", "units.js", JAVASCRIPT),
];
