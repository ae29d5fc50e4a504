//! What can go wrong when a picture is made.

use super::format::Size;

/// Why a picture was not made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// The file's suffix names a format that is not written.
    #[error(".{suffix} is not supported: use .svg or .png")]
    Format {
        /// The suffix, without its dot.
        suffix: String,
    },
    /// The file has no suffix to tell its format.
    #[error("{file:?} has no suffix to tell the format of the picture: use .svg or .png")]
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
    /// The PNG could not be encoded.
    #[error("the PNG could not be encoded: {0}")]
    Encoding(String),
}
