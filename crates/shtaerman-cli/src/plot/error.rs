//! What can go wrong when a picture is made.

use super::format::{MOST_PIXELS, RESOLUTIONS, Size, UNITS_PER_INCH};

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
        "a picture of {width} x {height} is out of range: from {} to {}",
        in_both(Size::SMALLEST, f64::ceil),
        in_both(Size::LARGEST, f64::floor)
    )]
    Size {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
    },
    /// There is no room for what is drawn.
    #[error(
        "a picture of {asked} has no room for what it shows: at least {least}",
        asked = in_both(*asked, f64::round), least = in_both(*least, f64::ceil)
    )]
    Crowded {
        /// The size asked for.
        asked: Size,
        /// The least of the same proportion that would do.
        least: Size,
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

/// A size in its own units, and in whole millimetres.
fn in_both(size: Size, whole: fn(f64) -> f64) -> String {
    let millimetres = |units: u32| whole(25.4 / f64::from(UNITS_PER_INCH) * f64::from(units));
    let Size { width, height } = size;
    format!("{width} x {height} ({} mm x {} mm)", millimetres(width), millimetres(height))
}
