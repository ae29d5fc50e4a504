//! From a figure to the bytes of a file.

use kuva::backend::svg::SvgBackend;
use kuva::render::render::Scene;

use super::error::PlotError;
use super::figure::{Figure, Plot};
use super::fitting::{layout_in, usually};
use super::format::{Format, Size};
use super::look::Look;
use super::{draw, raster, text};

/// Draws a plot for a screen and returns the bytes of the file.
///
/// The bytes depend on the arguments alone.
///
/// # Errors
///
/// As [`render_as`].
pub fn render(plot: &dyn Plot, format: Format, size: Size) -> Result<Vec<u8>, PlotError> {
    render_as(plot, format, Look { size: Some(size), ..Look::default() })
}

/// Draws a plot with a look and returns the bytes of the file.
///
/// The bytes depend on the arguments alone.
///
/// # Errors
///
/// [`PlotError::Size`] when the size is outside of [`Size::SMALLEST`] to [`Size::LARGEST`], [`PlotError::Crowded`] where there is no room in it for what is drawn; [`PlotError::Resolution`] for a PNG of a resolution out of range;
/// [`PlotError::Encoding`] when the file cannot be encoded; [`PlotError::NoPdf`] for a PDF without the feature `pdf`.
pub fn render_as(plot: &dyn Plot, format: Format, look: Look) -> Result<Vec<u8>, PlotError> {
    let Drawn { scene, figure, size } = drawn(plot, look)?;
    match format {
        Format::Svg => Ok(svg(&scene, &figure, size).into_bytes()),
        Format::Png => raster::png(&scene, size, look.resolution(size)?),
        Format::Pdf => pdf(&scene, size),
    }
}

/// A page of the size of the picture, for a browser that prints it.
///
/// # Errors
///
/// As [`render_as`] of an SVG.
pub(crate) fn page(plot: &dyn Plot, look: Look) -> Result<String, PlotError> {
    let Drawn { scene, figure, size } = drawn(plot, look)?;
    let Size { width, height } = size;
    Ok(format!(
        "<!doctype html><meta charset=\"utf-8\"><title>{}</title><style>@page{{size:{width}px {height}px;margin:0}}body{{margin:0}}svg{{display:block}}</style>{}",
        escaped(&text::clean(&figure.title)),
        svg(&scene, &figure, size)
    ))
}

/// A figure in its place.
struct Drawn {
    scene: Scene,
    figure: Figure,
    size: Size,
}

fn drawn(plot: &dyn Plot, look: Look) -> Result<Drawn, PlotError> {
    let figure = plot.figure();
    let (size, layout) = match look.size {
        Some(size) => {
            size.check()?;
            (size, layout_in(&figure, size, look.theme)?)
        }
        None => usually(&figure, look.usual_size(plot), look.theme),
    };
    let scene = draw::figure(&figure, &layout, size, look.theme);
    Ok(Drawn { scene, figure, size })
}

/// The scene as SVG that scales, with round corners of strokes, and with what it shows as text for readers who do not see it.
fn svg(scene: &Scene, figure: &Figure, size: Size) -> String {
    let drawn = SvgBackend::default().render_scene(scene);
    let Some((head, body)) = drawn.split_once('>') else { return drawn };
    let Size { width, height } = size;
    let title = escaped(&text::clean(&figure.title));
    let notes: Vec<String> = figure.notes.iter().map(|note| escaped(&text::clean(note))).collect();
    let short = |words: &str| words.chars().take(LONGEST_DESCRIPTION).collect::<String>();
    let mut described = String::new();
    for (tag, words) in [("title", title), ("desc", notes.join("; "))] {
        if !words.is_empty() {
            described.push_str(&format!("<{tag}>{}</{tag}>", whole(&short(&words))));
        }
    }
    format!(
        "{head} viewBox=\"0 0 {width} {height}\" stroke-linejoin=\"round\" role=\"img\">{described}{body}"
    )
}

/// Most letters of a description.
const LONGEST_DESCRIPTION: usize = 1000;

fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Text without an entity that was cut at its end.
fn whole(words: &str) -> &str {
    match words.rfind('&') {
        Some(at) if !words[at..].contains(';') => &words[..at],
        _ => words,
    }
}

#[cfg(feature = "pdf")]
fn pdf(scene: &Scene, size: Size) -> Result<Vec<u8>, PlotError> {
    use kuva::backend::pdf::{PageSize, PdfBackend};
    /// Points of a page for a unit of the picture: 72 and 96 to the inch.
    const POINTS: f64 = 0.75;
    let page = PageSize::points(POINTS * f64::from(size.width), POINTS * f64::from(size.height));
    let page = PdfBackend::new().with_page_size(page);
    page.render_scenes(std::slice::from_ref(scene)).map_err(PlotError::Encoding)
}

#[cfg(not(feature = "pdf"))]
fn pdf(_: &Scene, _: Size) -> Result<Vec<u8>, PlotError> {
    Err(PlotError::NoPdf)
}
