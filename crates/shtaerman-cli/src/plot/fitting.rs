//! Which sizes of text, and how much of the notes, a picture has room for.

use super::error::PlotError;
use super::figure::Figure;
use super::format::Size;
use super::layout::Layout;
use super::text;
use super::theme::{Sizes, Theme};

/// Pictures larger than this have larger text, so that a poster is read from afar.
const USUAL: [f64; 2] = [1200.0, 900.0];
/// Lines of the title.
const TITLE: usize = 2;
/// Frames lower or narrower than these, in sizes of tick labels, are not roomy, or are too small.
const ROOMY: [f64; 2] = [5.0, 6.0];
const LEAST: [f64; 2] = [3.2, 6.0];
/// How much a picture grows from one try to the next.
const GROWTH: f64 = 1.02;

/// A way to make room.
struct Attempt {
    /// What sizes of text are multiplied by.
    scale: f64,
    has_notes: bool,
    title: usize,
    /// Whether the title is as small as a label.
    is_title_small: bool,
    /// Height and width of frames.
    frame: [f64; 2],
}

/// The smallest text, without notes.
const SMALLEST: Attempt =
    Attempt { scale: 0.65, has_notes: false, title: TITLE, is_title_small: false, frame: LEAST };

/// What is tried in turn: without the notes, with smaller text, with lower frames, with a title as small as a label, with one line of a title that is cut.
fn attempts() -> impl Iterator<Item = Attempt> {
    let roomy = [1.0, 0.87, 0.75, 0.65].into_iter().flat_map(|scale| {
        [true, false].map(|has_notes| Attempt { scale, has_notes, frame: ROOMY, ..SMALLEST })
    });
    let small = Attempt { is_title_small: true, ..SMALLEST };
    roomy.chain([SMALLEST, small, Attempt { title: 1, ..SMALLEST }])
}

/// The sizes of a picture that is looked at whole.
fn usual(size: Size, theme: Theme) -> Sizes {
    let [width, height] = [f64::from(size.width) / USUAL[0], f64::from(size.height) / USUAL[1]];
    theme.sizes().scaled(width.min(height).max(1.0))
}

/// The layout of a figure in a size; none where there is no room for it.
fn fitting(figure: &Figure, size: Size, theme: Theme) -> Option<Layout> {
    let fits = |is_title_whole: bool| {
        attempts().find_map(|attempt| {
            let layout = tried(figure, size, theme, &attempt);
            let has_title = !is_title_whole || !text::is_cut(&layout.title);
            (has_title && layout.fits(figure, attempt.frame)).then_some(layout)
        })
    };
    // A title that is longer than any picture is cut in all of them.
    fits(true).or_else(|| fits(false))
}

fn tried(figure: &Figure, size: Size, theme: Theme, attempt: &Attempt) -> Layout {
    let mut sizes = usual(size, theme).scaled(attempt.scale);
    if attempt.is_title_small {
        sizes.title = sizes.label;
    }
    Layout::new(figure, size, sizes, attempt.title, attempt.has_notes)
}

/// The layout of a figure in a size that was asked for.
///
/// # Errors
/// [`PlotError::Crowded`] where there is no room for it.
pub(super) fn layout_in(figure: &Figure, size: Size, theme: Theme) -> Result<Layout, PlotError> {
    fitting(figure, size, theme).ok_or_else(|| {
        let least = grown(size, [GROWTH; 2], |size| fitting(figure, size, theme));
        let least = least.map_or_else(|| usually(figure, theme.size(), theme).0, |(size, _)| size);
        PlotError::Crowded { asked: size, least }
    })
}

/// The layout of a figure in the size that suits it, or in a higher or larger one that has room for it.
pub(super) fn usually(figure: &Figure, size: Size, theme: Theme) -> (Size, Layout) {
    let fits = |size| fitting(figure, size, theme);
    let found = fits(size)
        .map(|layout| (size, layout))
        .or_else(|| grown(size, [1.0, GROWTH], fits))
        .or_else(|| grown(size, [GROWTH; 2], fits));
    // What fits on no picture is drawn as well as may be.
    let last = Attempt { title: 1, ..SMALLEST };
    found.unwrap_or_else(|| (Size::LARGEST, tried(figure, Size::LARGEST, theme, &last)))
}

/// The first of larger and larger sizes that fits.
fn grown(
    size: Size,
    by: [f64; 2],
    fits: impl Fn(Size) -> Option<Layout>,
) -> Option<(Size, Layout)> {
    let [mut width, mut height] = [f64::from(size.width), f64::from(size.height)];
    loop {
        (width, height) = (by[0] * width, by[1] * height);
        let size = Size { width: width.ceil() as u32, height: height.ceil() as u32 };
        if size.width > Size::LARGEST.width || size.height > Size::LARGEST.height {
            return None;
        }
        if let Some(layout) = fits(size) {
            return Some((size, layout));
        }
    }
}
