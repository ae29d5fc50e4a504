//! What can go wrong when a picture is made.

use super::format::{MOST_PIXELS, RESOLUTIONS, Size};

/// Why a picture was not made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// The file's suffix names a format that is not written.
    #[error(".{suffix} is not supported: use .svg, .png or .pdf")]
    Format {
        /// The suffix, without its dot.
        suffix: String,
    },
    /// The file has no suffix to tell its format.
    #[error("{file:?} has no suffix to tell the format of the picture: use .svg, .png or .pdf")]
    NoSuffix {
        /// The file as it was given.
        file: String,
    },
    /// The picture would be too small to read or too large to hold.
    #[error(
        "a picture of {width} x {height} is out of range: use {} x {} to {} x {}",
        Size::SMALLEST.width, Size::SMALLEST.height, Size::LARGEST.width, Size::LARGEST.height
    )]
    Size {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
    },
    /// The program was built without the feature that writes PDF.
    #[error(
        ".pdf needs a program that was built with it (cargo install --path crates/shtaerman-cli --features pdf): use .svg or .png"
    )]
    NoPdf,
    /// The resolution is out of range, or makes more pixels than are held.
    #[error(
        "{dots} dots per inch: from {} to {} are drawn, and at most {} million pixels in all",
        RESOLUTIONS[0], RESOLUTIONS[1], MOST_PIXELS / 1_000_000
    )]
    Resolution {
        /// Dots per inch asked for.
        dots: u32,
    },
    /// The PNG or PDF could not be encoded.
    #[error("the picture could not be encoded: {0}")]
    Encoding(String),
}
