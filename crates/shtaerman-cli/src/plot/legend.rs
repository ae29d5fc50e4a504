//! Names of curves, set in rows.

use super::canvas::{Anchor, Canvas, Point, Style};
use super::colour::Colour;
use super::cross::{arrow_at, cross_at};
use super::figure::{Dash, Layer, Panel};
use super::text;
use super::theme::Sizes;

/// Height of a row, in sizes of its text.
const ROW: f64 = 1.58;
const SAMPLE: f64 = 30.0;
const GAP: f64 = 7.0;
const BETWEEN: f64 = 22.0;

/// What stands before a name.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Sample {
    Stroke { width: f64, dash: Dash, dot: bool, upright: bool },
    Swatch { opacity: f64 },
    Cross,
    Arrow,
}

impl Sample {
    fn is_mark(self) -> bool {
        matches!(self, Self::Stroke { upright: true, .. } | Self::Arrow)
    }

    fn width(self) -> f64 {
        match self {
            Self::Stroke { upright: true, .. } => 4.0,
            Self::Cross => 16.0,
            Self::Arrow => 12.0,
            _ => SAMPLE,
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
struct Entry {
    name: String,
    colour: Colour,
    sample: Sample,
}

/// The names of a panel or figure and their places.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Legend {
    entries: Vec<Entry>,
    /// Names left out for want of room.
    omitted: usize,
    /// Left end of each column, from the left end of the legend.
    columns: Vec<f64>,
    width: f64,
    /// Size of the text.
    size: u32,
}

impl Legend {
    /// Height of a row.
    pub(super) fn row(sizes: Sizes) -> f64 {
        ROW * f64::from(sizes.legend)
    }

    /// The names of some panels, equal ones once, in at most `rows` rows of a width.
    pub(super) fn new(panels: &[&Panel], width: f64, rows: usize, sizes: Sizes) -> Self {
        let size = sizes.legend;
        let mut entries: Vec<Entry> = Vec::new();
        for entry in panels.iter().flat_map(|panel| &panel.layers).filter_map(entry) {
            if !entries.iter().any(|other| other.name == entry.name) {
                entries.push(entry);
            }
        }
        // What is drawn stands before what is marked.
        entries.sort_by_key(|entry| entry.sample.is_mark());
        for entry in &mut entries {
            entry.name = text::fit(&entry.name, size, width - SAMPLE - GAP);
        }
        let columns = columns(&entries, width, size);
        let room = (rows.max(1) * columns.len().max(1)).max(1);
        let omitted = if entries.len() > room { entries.len() - room + 1 } else { 0 };
        entries.truncate(entries.len() - omitted);
        let ends =
            entries.iter().enumerate().map(|(i, e)| columns[i % columns.len()] + length(e, size));
        let width = ends.fold(0.0, f64::max);
        Self { entries, omitted, columns, width, size }
    }

    pub(super) fn height(&self) -> f64 {
        let places = self.entries.len() + usize::from(self.omitted > 0);
        ROW * f64::from(self.size) * places.div_ceil(self.columns.len().max(1)) as f64
    }

    pub(super) fn width(&self) -> f64 {
        self.width
    }

    /// Draws the legend with its upper left corner at a point.
    pub(super) fn draw(&self, canvas: &mut Canvas, corner: Point) {
        let style =
            Style { size: self.size, colour: Colour::INK, anchor: Anchor::Start, upright: false };
        let place = |index: usize| {
            let row = (index / self.columns.len().max(1)) as f64;
            let column =
                self.columns.get(index % self.columns.len().max(1)).copied().unwrap_or(0.0);
            (corner.0 + column, corner.1 + ROW * f64::from(self.size) * (row + 0.5))
        };
        for (index, entry) in self.entries.iter().enumerate() {
            let (x, y) = place(index);
            draw_sample(canvas, (x, y), entry);
            canvas.text((x + entry.sample.width() + GAP, y), &entry.name, style);
        }
        if self.omitted > 0 {
            canvas.text(place(self.entries.len()), &format!("… and {} more", self.omitted), style);
        }
    }
}

fn length(entry: &Entry, size: u32) -> f64 {
    entry.sample.width() + GAP + text::width(&entry.name, size)
}

/// One row as narrow as the names allow, or even columns.
fn columns(entries: &[Entry], width: f64, size: u32) -> Vec<f64> {
    let mut next = 0.0;
    let mut starts = Vec::new();
    for entry in entries {
        starts.push(next);
        next += length(entry, size) + BETWEEN;
    }
    if next - BETWEEN <= width {
        return starts;
    }
    let widest = entries.iter().map(|entry| length(entry, size)).fold(0.0, f64::max) + BETWEEN;
    let most = (((width + BETWEEN) / widest).floor().max(1.0) as usize).min(entries.len().max(1));
    // As many columns as the rows need, so that the last row is not left nearly empty.
    let count = entries.len().div_ceil(entries.len().div_ceil(most).max(1)).max(1);
    (0..count).map(|column| column as f64 * widest).collect()
}

fn entry(layer: &Layer) -> Option<Entry> {
    let (name, colour, sample) = match layer {
        Layer::Line(line) => {
            let stroke = Sample::Stroke {
                width: line.width,
                dash: line.dash,
                dot: line.dots,
                upright: false,
            };
            (&line.name, line.colour, stroke)
        }
        Layer::Mark(mark) => {
            let stroke =
                Sample::Stroke { width: 1.2, dash: mark.dash, dot: false, upright: mark.vertical };
            (&mark.name, mark.colour, stroke)
        }
        Layer::Band(band) => (&band.name, band.colour, Sample::Swatch { opacity: band.opacity }),
        Layer::Area(area) => (&area.name, area.colour, Sample::Swatch { opacity: area.opacity }),
        Layer::Cross(cross) => (&cross.name, Colour::INK, Sample::Cross),
        Layer::Pole(pole) => (&pole.name, pole.colour, Sample::Arrow),
        Layer::Contours(_) | Layer::ColourBar(_) => return None,
    };
    let name = text::clean(name);
    (!name.is_empty()).then_some(Entry { name, colour, sample })
}

fn draw_sample(canvas: &mut Canvas, at: Point, entry: &Entry) {
    let (x, y) = at;
    let middle = x + 0.5 * entry.sample.width();
    match entry.sample {
        Sample::Stroke { width, dash, upright: true, .. } => {
            canvas.path(&[(middle, y - 8.0), (middle, y + 8.0)], entry.colour, width, dash);
        }
        Sample::Stroke { width, dash, dot, .. } => {
            canvas.path(&[(x, y), (x + SAMPLE, y)], entry.colour, width, dash);
            if dot {
                canvas.dot((middle, y), 3.0, entry.colour);
            }
        }
        Sample::Cross => cross_at(canvas, (middle, y)),
        Sample::Arrow => arrow_at(canvas, (middle, y - 7.0), entry.colour, true),
        Sample::Swatch { opacity } => {
            let (right, top, bottom) = (x + SAMPLE, y - 5.0, y + 5.0);
            let corners = [(x, top), (right, top), (right, bottom), (x, bottom)];
            canvas.fill(&corners, entry.colour, opacity);
        }
    }
}
