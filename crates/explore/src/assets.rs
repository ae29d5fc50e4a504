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
    ("/main.js", "main.js", JAVASCRIPT),
];
