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

    fn width(self, scale: f64) -> f64 {
        scale
            * match self {
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
    /// Row of each name, and its left end from that of the legend; behind them the place of what tells how many were left out.
    places: Vec<(usize, f64)>,
    width: f64,
    /// Size of the text, and what lengths are multiplied by.
    size: u32,
    scale: f64,
}

/// A legend that names so many says enough; the others are counted.
const ENOUGH: usize = 12;

impl Legend {
    /// Height of a row.
    pub(super) fn row(sizes: Sizes) -> f64 {
        ROW * f64::from(sizes.legend)
    }

    /// The names of some panels, equal ones once, in at most `rows` rows of a width.
    pub(super) fn new(panels: &[&Panel], width: f64, rows: usize, sizes: Sizes) -> Self {
        let (size, scale) = (sizes.legend, sizes.scale);
        let mut entries: Vec<Entry> = Vec::new();
        for entry in panels.iter().flat_map(|panel| &panel.layers).filter_map(entry) {
            if !entries.iter().any(|other| other.name == entry.name) {
                entries.push(entry);
            }
        }
        // What is drawn stands before what is marked.
        entries.sort_by_key(|entry| entry.sample.is_mark());
        for entry in &mut entries {
            entry.name = text::fit(&entry.name, size, width - scale * (SAMPLE + GAP));
        }
        let lengths: Vec<f64> = entries.iter().map(|entry| length(entry, size, scale)).collect();
        let places = places(&lengths, width, scale * BETWEEN);
        let room = places.iter().filter(|place| place.0 < rows.max(1)).count();
        // The last place tells how many have none.
        let omitted = if entries.len() > room { entries.len() - room + 1 } else { 0 };
        entries.truncate(entries.len() - omitted);
        let ends = places.iter().zip(&lengths).take(entries.len());
        let width = ends.map(|(place, length)| place.1 + length).fold(0.0, f64::max);
        Self { entries, omitted, places, width, size, scale }
    }

    /// Whether no name had to be left out that there would be room for in a larger picture.
    pub(super) fn is_complete(&self) -> bool {
        self.omitted == 0 || self.entries.len() >= ENOUGH
    }

    pub(super) fn height(&self) -> f64 {
        let shown = self.entries.len() + usize::from(self.omitted > 0);
        let rows = self.places.iter().take(shown).map(|place| place.0 + 1).max().unwrap_or(0);
        ROW * f64::from(self.size) * rows as f64
    }

    pub(super) fn width(&self) -> f64 {
        self.width
    }

    /// Draws the legend with its upper left corner at a point.
    pub(super) fn draw(&self, canvas: &mut Canvas, corner: Point) {
        let style =
            Style { size: self.size, colour: Colour::INK, anchor: Anchor::Start, upright: false };
        let place = |index: usize| {
            let (row, along) = self.places.get(index).copied().unwrap_or_default();
            (corner.0 + along, corner.1 + ROW * f64::from(self.size) * (row as f64 + 0.5))
        };
        for (index, entry) in self.entries.iter().enumerate() {
            let (x, y) = place(index);
            draw_sample(canvas, (x, y), entry);
            let from = x + entry.sample.width(self.scale) + self.scale * GAP;
            canvas.text((from, y), &entry.name, style);
        }
        if self.omitted > 0 {
            canvas.text(place(self.entries.len()), &format!("… and {} more", self.omitted), style);
        }
    }
}

fn length(entry: &Entry, size: u32, scale: f64) -> f64 {
    entry.sample.width(scale) + scale * GAP + text::width(&entry.name, size)
}

/// One row as narrow as the names allow, or even columns; where these take more rows than names one behind the other, each in the first row that has room for it, the latter.
fn places(lengths: &[f64], width: f64, between: f64) -> Vec<(usize, f64)> {
    let mut rows: Vec<f64> = Vec::new();
    let mut flowing = Vec::new();
    for length in lengths {
        let fitting = rows.iter().position(|next| next + length <= width);
        let row = fitting.unwrap_or_else(|| {
            rows.push(0.0);
            rows.len() - 1
        });
        flowing.push((row, rows[row]));
        rows[row] += length + between;
    }
    if rows.len() <= 1 {
        return flowing;
    }
    let widest = lengths.iter().copied().fold(0.0, f64::max) + between;
    let most = (((width + between) / widest).floor().max(1.0) as usize).min(lengths.len().max(1));
    // As many columns as the rows need, so that the last row is not left nearly empty.
    let count = lengths.len().div_ceil(lengths.len().div_ceil(most).max(1)).max(1);
    if lengths.len().div_ceil(count) > rows.len() {
        return flowing;
    }
    (0..lengths.len()).map(|index| (index / count, (index % count) as f64 * widest)).collect()
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
    let ((x, y), scale) = (at, canvas.sizes().scale);
    let width_of_sample = entry.sample.width(scale);
    let middle = x + 0.5 * width_of_sample;
    match entry.sample {
        Sample::Stroke { width, dash, upright: true, .. } => {
            let half = 8.0 * scale;
            canvas.path(&[(middle, y - half), (middle, y + half)], entry.colour, width, dash);
        }
        Sample::Stroke { width, dash, dot, .. } => {
            canvas.path(&[(x, y), (x + width_of_sample, y)], entry.colour, width, dash);
            if dot {
                canvas.dot((middle, y), 3.0, entry.colour);
            }
        }
        Sample::Cross => cross_at(canvas, (middle, y)),
        Sample::Arrow => arrow_at(canvas, (middle, y - 7.0 * scale), entry.colour, true),
        Sample::Swatch { opacity } => {
            let half = 5.0 * scale;
            let (right, top, bottom) = (x + width_of_sample, y - half, y + half);
            let corners = [(x, top), (right, top), (right, bottom), (x, bottom)];
            canvas.fill(&corners, entry.colour, opacity);
        }
    }
}
