//! The picture that a command draws beside its result.

use std::path::Path;

use shtaerman::quantity::Dimension;

use super::places;
use crate::Failure;
use crate::arguments::PictureArguments;
use crate::output::{Outputs, Printer};
pub(super) use crate::plot::Titled;
use crate::plot::{Format, Look, Plot, PlotError, Size, page, render_as};

/// Units of a size in a metre: 96 in an inch.
const UNITS_PER_METRE: f64 = 96.0 / 0.0254;

/// What makes a PDF without a browser.
const BUILT: &str = "write .svg or .png, or build the program with the feature for it (cargo install --path crates/shtaerman-cli --features pdf)";

/// A file with its format, and how the picture in it looks.
pub(super) struct Picture<'a> {
    path: &'a Path,
    format: Format,
    /// What prints a PDF where the program was built without it.
    printer: Option<Printer>,
    look: Look,
    title: Option<&'a str>,
}

impl<'a> Picture<'a> {
    /// The picture asked for, if there is one.
    pub(super) fn new(
        path: Option<&'a Path>,
        arguments: &'a PictureArguments,
    ) -> Result<Option<Self>, Failure> {
        let Some(path) = path else { return Ok(None) };
        let (format, printer) = match Format::of_file(path) {
            Err(PlotError::NoPdf) => (Format::Pdf, Some(Printer::find(BUILT)?)),
            format => (format?, None),
        };
        let look = Look {
            size: arguments.size.as_deref().map(size).transpose()?,
            theme: arguments.theme.into(),
            dots_per_inch: arguments.dpi,
        };
        // Before anything is solved; whether there is room is known when it is drawn.
        look.size.map_or(Ok(()), Size::check)?;
        if look.dots_per_inch.is_some() && format != Format::Png {
            let message = "--dpi is for .png: the other formats have no dots";
            return Err(Failure::Usage(message.to_owned()));
        }
        Ok(Some(Self { path, format, printer, look, title: arguments.title.as_deref() }))
    }

    /// Draws it into the outputs.
    pub(super) fn draw(&self, plot: &dyn Plot, outputs: &mut Outputs<'_>) -> Result<(), Failure> {
        let mut figure = plot.figure();
        if let Some(title) = self.title {
            title.clone_into(&mut figure.title);
        }
        let titled = Titled { figure, size: plot.usual_size() };
        let bytes = match &self.printer {
            Some(printer) => printer.pdf(&page(&titled, self.look)?)?,
            None => render_as(&titled, self.format, self.look)?,
        };
        outputs.file(self.path, bytes);
        Ok(())
    }
}

/// `WIDTHxHEIGHT`: bare numbers in 1/96 inch, the pixels of a screen, or lengths; a unit behind the second alone goes for both.
fn size(text: &str) -> Result<Size, Failure> {
    let refused = || {
        Failure::Usage(format!(
            "--size `{text}`: must be width x height, such as \"160 mm x 100 mm\" or 800x600"
        ))
    };
    // Their x is none between the sides.
    let plain = text.replace("px", " ");
    let (width, height) = plain.split_once(['x', 'X', '×']).ok_or_else(refused)?;
    let unit =
        height.trim().trim_start_matches(|c: char| c.is_ascii_digit() || ".eE+-".contains(c));
    let (width, height) = (width.trim(), height.trim());
    let width = match width.parse::<f64>() {
        Ok(_) => format!("{width} {unit}"),
        Err(_) => width.to_owned(),
    };
    let length = |part: &str| -> Result<u32, Failure> {
        let part = part.trim();
        let units = match part.parse::<f64>() {
            Ok(units) => units,
            Err(_) => UNITS_PER_METRE * places::quantity("--size", part, Dimension::LENGTH)?,
        };
        // Out of range is told when it is drawn.
        if units.is_finite() && units >= 0.0 { Ok(units.round() as u32) } else { Err(refused()) }
    };
    Ok(Size { width: length(&width)?, height: length(height)? })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_in_pixels_and_lengths() {
        let read = |text: &str| size(text).map(|size| (size.width, size.height)).ok();
        assert_eq!(read("800x600"), Some((800, 600)));
        // 160 mm = 604.7/96 inch.
        assert_eq!(read("160 mm x 100 mm"), Some((605, 378)));
        assert_eq!(read("160x100 mm"), Some((605, 378)));
        assert_eq!(read("800 px x 600 px"), Some((800, 600)));
        assert_eq!(read("800x600px"), Some((800, 600)));
        assert_eq!(read("6in × 4in"), Some((576, 384)));
        for text in ["800", "800x", "x600", "-800x600", "NaNx600", "800x600 Pa", "wide x high"] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
