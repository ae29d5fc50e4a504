//! File format and size of a picture.

use std::path::Path;

use super::error::PlotError;

/// Pixels of a PNG per unit of [`Size`] where no resolution is asked for: sharp on a dense screen.
pub const PNG_PIXELS_PER_UNIT: u32 = 2;
/// Units of a size in an inch.
pub(super) const UNITS_PER_INCH: u32 = 96;

/// File format of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Scalable Vector Graphics.
    Svg,
    /// Portable Network Graphics.
    Png,
    /// Portable Document Format, in a build with the feature `pdf`.
    Pdf,
}

impl Format {
    /// The format that a file's suffix asks for, in any case of letters.
    ///
    /// # Errors
    ///
    /// [`PlotError::Format`] for another suffix, [`PlotError::NoSuffix`] for none, [`PlotError::NoPdf`] where the program was built without it.
    pub fn of_file(file: &Path) -> Result<Self, PlotError> {
        let Some(suffix) = file.extension() else {
            return Err(PlotError::NoSuffix { file: file.to_string_lossy().into_owned() });
        };
        let suffix = suffix.to_string_lossy();
        match suffix.to_ascii_lowercase().as_str() {
            "svg" => Ok(Self::Svg),
            "png" => Ok(Self::Png),
            "pdf" if cfg!(feature = "pdf") => Ok(Self::Pdf),
            "pdf" => Err(PlotError::NoPdf),
            _ => Err(PlotError::Format { suffix: suffix.into_owned() }),
        }
    }
}

/// Size of a picture, in SVG user units (1/96 inch); a PNG has [`PNG_PIXELS_PER_UNIT`] pixels for each where no resolution is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size {
    /// Width, 220 to 4000.
    pub width: u32,
    /// Height, 140 to 4000.
    pub height: u32,
}

impl Size {
    /// The smallest picture, which has room for a curve with its axes.
    pub const SMALLEST: Self = Self { width: 220, height: 140 };
    /// The largest picture; its PNG takes half a gigabyte while it is drawn.
    pub const LARGEST: Self = Self { width: 4000, height: 4000 };

    pub(crate) fn check(self) -> Result<(), PlotError> {
        let (smallest, largest) = (Self::SMALLEST, Self::LARGEST);
        let fits = (smallest.width..=largest.width).contains(&self.width)
            && (smallest.height..=largest.height).contains(&self.height);
        if fits { Ok(()) } else { Err(PlotError::Size { width: self.width, height: self.height }) }
    }
}

/// The least and the most dots per inch of a PNG, and the most pixels.
pub(super) const RESOLUTIONS: [u32; 2] = [50, 1200];
pub(super) const MOST_PIXELS: u64 = 80_000_000;

impl Default for Size {
    /// 800 x 600.
    fn default() -> Self {
        Self { width: 800, height: 600 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_suffix_picks_the_format() {
        assert_eq!(Format::of_file(Path::new("out/p.svg")), Ok(Format::Svg));
        assert_eq!(Format::of_file(Path::new("P.PNG")), Ok(Format::Png));
    }

    #[test]
    fn another_suffix_is_an_error_that_says_what_would_be_right() {
        let error = Format::of_file(Path::new("p.jpg")).unwrap_err();
        assert_eq!(error.to_string(), ".jpg is not supported: use .svg, .png or .pdf");
        let error = Format::of_file(Path::new("picture")).unwrap_err();
        assert!(error.to_string().contains("\"picture\" has no suffix"));
    }

    #[test]
    fn a_size_out_of_range_is_refused() {
        assert!(Size::default().check().is_ok());
        let error = Size { width: 0, height: 9000 }.check().unwrap_err();
        assert!(error.to_string().contains("0 x 9000"), "{error}");
    }
}
