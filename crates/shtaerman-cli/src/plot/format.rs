//! File format and size of a picture.

use std::path::Path;

use super::error::PlotError;
use super::figure::Plot;
use super::theme::Theme;

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
    /// Width, 280 to 4000.
    pub width: u32,
    /// Height, 200 to 4000.
    pub height: u32,
}

impl Size {
    /// The smallest picture whose text can be read.
    pub const SMALLEST: Self = Self { width: 280, height: 200 };
    /// The largest picture; its PNG takes half a gigabyte while it is drawn.
    pub const LARGEST: Self = Self { width: 4000, height: 4000 };

    pub(super) fn check(self) -> Result<(), PlotError> {
        let (smallest, largest) = (Self::SMALLEST, Self::LARGEST);
        let fits = (smallest.width..=largest.width).contains(&self.width)
            && (smallest.height..=largest.height).contains(&self.height);
        if fits { Ok(()) } else { Err(PlotError::Size { width: self.width, height: self.height }) }
    }
}

/// How a picture is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Look {
    /// Its size; none for the one that suits plot and theme.
    pub size: Option<Size>,
    /// Where it is to be looked at.
    pub theme: Theme,
    /// Pixels of a PNG for each inch, 50 to 1200; none for 192.
    pub dots_per_inch: Option<u32>,
}

impl Look {
    /// The least and the most dots per inch.
    pub const RESOLUTIONS: [u32; 2] = [50, 1200];
    /// The most pixels of a PNG.
    pub const MOST_PIXELS: u64 = 80_000_000;

    /// The size asked for, or the one that suits plot and theme.
    pub(super) fn size_of(self, plot: &dyn Plot) -> Size {
        self.size.unwrap_or_else(|| match plot.usual_size() {
            Some(size) => self.theme.scaled(size),
            None => self.theme.size(),
        })
    }

    pub(super) fn resolution(self, size: Size) -> Result<u32, PlotError> {
        let dots = self.dots_per_inch.unwrap_or(PNG_PIXELS_PER_UNIT * UNITS_PER_INCH);
        let [least, most] = Self::RESOLUTIONS;
        let part = f64::from(dots) / f64::from(UNITS_PER_INCH);
        let pixels = f64::from(size.width) * f64::from(size.height) * part * part;
        if (least..=most).contains(&dots) && pixels <= Self::MOST_PIXELS as f64 {
            return Ok(dots);
        }
        Err(PlotError::Resolution { dots })
    }
}

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
