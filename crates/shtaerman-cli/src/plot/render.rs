//! From a figure to the bytes of a file.

use kuva::backend::svg::SvgBackend;

use super::error::PlotError;
use super::figure::Plot;
use super::format::{Format, Size};
use super::{draw, raster};

/// Draws a plot and returns the bytes of the file.
///
/// The bytes depend on the arguments alone.
///
/// # Errors
///
/// [`PlotError::Size`] when the size is outside of [`Size::SMALLEST`] to [`Size::LARGEST`];
/// [`PlotError::Encoding`] when the PNG cannot be encoded.
pub fn render(plot: &dyn Plot, format: Format, size: Size) -> Result<Vec<u8>, PlotError> {
    size.check()?;
    let scene = draw::figure(&plot.figure(), size);
    match format {
        Format::Svg => Ok(SvgBackend::default().render_scene(&scene).into_bytes()),
        Format::Png => raster::png(&scene, size),
    }
}
