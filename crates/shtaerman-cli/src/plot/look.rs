//! How a picture is made: size, theme and resolution.

use super::error::PlotError;
use super::figure::{Figure, Plot};
use super::format::{MOST_PIXELS, PNG_PIXELS_PER_UNIT, RESOLUTIONS, Size, UNITS_PER_INCH};
use super::theme::Theme;

/// How a picture is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Look {
    /// Its size; none for the one that suits plot and theme, or a larger one where that has no room for what is drawn.
    pub size: Option<Size>,
    /// Where it is to be looked at.
    pub theme: Theme,
    /// Pixels of a PNG for each inch, 50 to 1200; none for 192.
    pub dots_per_inch: Option<u32>,
}

impl Look {
    /// The size that suits plot and theme.
    pub(super) fn usual_size(self, plot: &dyn Plot) -> Size {
        match plot.usual_size() {
            Some(size) => self.theme.scaled(size),
            None => self.theme.size(),
        }
    }

    pub(super) fn resolution(self, size: Size) -> Result<u32, PlotError> {
        let dots = self.dots_per_inch.unwrap_or(PNG_PIXELS_PER_UNIT * UNITS_PER_INCH);
        let [least, most] = RESOLUTIONS;
        let part = f64::from(dots) / f64::from(UNITS_PER_INCH);
        let pixels = f64::from(size.width) * f64::from(size.height) * part * part;
        if (least..=most).contains(&dots) && pixels <= MOST_PIXELS as f64 {
            return Ok(dots);
        }
        Err(PlotError::Resolution { dots })
    }
}

impl Theme {
    /// The size of a picture for which none is asked: 800 x 600, in print 160 mm x 120 mm.
    #[must_use]
    pub fn size(self) -> Size {
        match self {
            Self::Screen | Self::Dark => Size::default(),
            Self::Print => Size { width: 605, height: 454 },
        }
    }

    /// A size meant for a screen, in the proportion of the theme's own.
    #[must_use]
    pub fn scaled(self, size: Size) -> Size {
        let part = f64::from(self.size().width) / f64::from(Size::default().width);
        let scaled = |length: u32| (f64::from(length) * part).round() as u32;
        Size { width: scaled(size.width), height: scaled(size.height) }
    }
}

/// A figure of a size that suits it; none for the usual one.
pub(crate) struct Titled {
    pub(crate) figure: Figure,
    pub(crate) size: Option<Size>,
}

impl Plot for Titled {
    fn figure(&self) -> Figure {
        self.figure.clone()
    }

    fn usual_size(&self) -> Option<Size> {
        self.size
    }
}
