//! Where the parts of a picture go.

use super::axis::{Axis, Range};
use super::bar_labels::bar_labels;
use super::canvas::Frame;
use super::figure::{Arrangement, Figure, Layer, LegendPlace, Panel};
use super::format::Size;
use super::legend::{self, Legend};
use super::text;
use super::ticks::Ticks;

pub(super) const TITLE: u32 = 17;
pub(super) const NOTE: u32 = 12;
pub(super) const HEADING: u32 = 14;
pub(super) const LABEL: u32 = 13;
pub(super) const TICK: u32 = 12;
/// Space at the rim of the picture.
pub(super) const RIM: f64 = 14.0;
/// Length of a tick mark.
pub(super) const TICK_MARK: f64 = 5.0;
/// From one line of text to the next, in sizes of the font.
const LEADING: f64 = 1.4;
/// Space between panels.
const BETWEEN: f64 = 16.0;
/// Room for the part of the last tick label that stands out beyond the frame.
const LAST_LABEL: f64 = 10.0;
/// Space beside a colour bar, its width, and the space between the numbers and the label.
pub(super) const BAR_GAP: f64 = 14.0;
pub(super) const BAR_WIDTH: f64 = 16.0;
pub(super) const BAR_LABEL_GAP: f64 = 6.0;
/// Frames are not made smaller than this.
const SMALLEST_FRAME: f64 = 40.0;
/// Frames lower than this make notes and legends give way.
const ROOMY_FRAME: f64 = 70.0;

/// Height of a line of text.
pub(super) fn line_height(size: u32) -> f64 {
    LEADING * f64::from(size)
}

/// Places of everything in a picture.
pub(super) struct Layout {
    pub(super) title: Vec<String>,
    pub(super) notes: Vec<String>,
    /// The legend of the figure and the height of its upper side.
    pub(super) legend: (Legend, f64),
    pub(super) panels: Vec<PanelLayout>,
}

/// Places of everything in a panel.
pub(super) struct PanelLayout {
    pub(super) frame: Frame,
    /// Upper side of the heading.
    pub(super) top: f64,
    /// Middle of the vertical axis' label.
    pub(super) label: f64,
    pub(super) legend: Legend,
    pub(super) horizontal: AxisLayout,
    pub(super) vertical: AxisLayout,
}

/// Range and ticks of an axis.
pub(super) struct AxisLayout {
    pub(super) range: Range,
    pub(super) ticks: Ticks,
}

impl Layout {
    /// A layout that gives up notes and legends where they would leave no room for the frames.
    pub(super) fn new(figure: &Figure, size: Size) -> Self {
        let lines = (0.15 * f64::from(size.height) / line_height(NOTE)) as usize;
        let full = Self::with(figure, size, lines, true);
        if full.is_roomy() {
            return full;
        }
        let bare = Self::with(figure, size, 0, true);
        if bare.is_roomy() { bare } else { Self::with(figure, size, 0, false) }
    }

    fn is_roomy(&self) -> bool {
        self.panels.iter().all(|panel| panel.frame.height() >= ROOMY_FRAME)
    }

    fn with(figure: &Figure, size: Size, lines: usize, legends: bool) -> Self {
        let (width, height) = (f64::from(size.width), f64::from(size.height));
        let room = width - 2.0 * RIM;
        let title = text::wrap(&text::clean(&figure.title), TITLE, room, 2);
        let notes = figure.notes.iter().take(lines);
        let mut notes: Vec<String> =
            notes.flat_map(|note| text::wrap(&text::clean(note), NOTE, room, 2)).collect();
        notes.truncate(lines);
        let mut top = RIM;
        top += line_height(TITLE) * title.len() as f64 + line_height(NOTE) * notes.len() as f64;
        let legend = shared_legend(
            figure,
            room,
            if legends { (0.25 * height / legend::ROW) as usize } else { 0 },
        );
        let legend_top = top + 4.0;
        if legend.height() > 0.0 {
            top = legend_top + legend.height();
        }
        let area = Frame { left: RIM, top: top + 6.0, right: width - RIM, bottom: height - RIM };
        Self { title, notes, legend: (legend, legend_top), panels: panels(figure, area, legends) }
    }
}

fn shared_legend(figure: &Figure, width: f64, rows: usize) -> Legend {
    match figure.legend {
        LegendPlace::Figure if rows > 0 => {
            Legend::new(&figure.panels.iter().collect::<Vec<_>>(), width, rows)
        }
        _ => Legend::default(),
    }
}

/// Extent of the rows around the frame of a panel.
struct Rows {
    /// Heading, legend and common factor above.
    above: f64,
    /// Tick labels and label below.
    below: f64,
    legend: Legend,
}

fn panels(figure: &Figure, area: Frame, legends: bool) -> Vec<PanelLayout> {
    let ranges = shared_ranges(figure);
    let cells = cells(figure, area);
    let parts = figure.panels.iter().zip(&cells).zip(&ranges);
    let rows: Vec<Rows> =
        parts.map(|((panel, cell), ranges)| rows(figure, panel, *cell, *ranges, legends)).collect();
    let cells = even_heights(figure, &cells, &rows);
    let mut built: Vec<PanelLayout> = Vec::new();
    for (((panel, cell), ranges), rows) in figure.panels.iter().zip(cells).zip(ranges).zip(rows) {
        let bottom = cell.bottom - rows.below;
        let top = (cell.top + rows.above).min(bottom - SMALLEST_FRAME);
        let vertical = ticks(&panel.vertical, ranges.1, bottom - top, false);
        let left = cell.left + left_margin(&panel.vertical, &vertical);
        built.push(PanelLayout {
            frame: Frame { left, top, right: cell.right - right_margin(panel), bottom },
            top: cell.top,
            label: cell.left + 0.5 * line_height(LABEL),
            legend: rows.legend,
            horizontal: AxisLayout { range: ranges.0, ticks: Ticks::default() },
            vertical: AxisLayout { range: ranges.1, ticks: vertical },
        });
    }
    align(figure, &mut built);
    for (panel, layout) in figure.panels.iter().zip(&mut built) {
        layout.frame.left = layout.frame.left.min(layout.frame.right - SMALLEST_FRAME);
        let range = layout.horizontal.range;
        layout.horizontal.ticks = ticks(&panel.horizontal, range, layout.frame.width(), true);
    }
    built
}

/// Frames below each other begin at one place, frames beside each other end at one height.
fn align(figure: &Figure, panels: &mut [PanelLayout]) {
    match figure.arrangement {
        Arrangement::Stacked => {
            let left = panels.iter().map(|panel| panel.frame.left).fold(0.0, f64::max);
            for panel in panels {
                panel.frame.left = left;
            }
        }
        Arrangement::SideBySide => {
            let top = panels.iter().map(|panel| panel.frame.top).fold(0.0, f64::max);
            for panel in panels {
                panel.frame.top = top.min(panel.frame.bottom - SMALLEST_FRAME);
            }
        }
    }
}

fn cells(figure: &Figure, area: Frame) -> Vec<Frame> {
    let count = figure.panels.len().max(1) as f64;
    let gaps = BETWEEN * (count - 1.0);
    let cell = |index: usize| match figure.arrangement {
        Arrangement::Stacked => {
            let height = (area.height() - gaps) / count;
            let top = area.top + index as f64 * (height + BETWEEN);
            Frame { top, bottom: top + height, ..area }
        }
        Arrangement::SideBySide => {
            let width = (area.width() - gaps) / count;
            let left = area.left + index as f64 * (width + BETWEEN);
            Frame { left, right: left + width, ..area }
        }
    };
    (0..figure.panels.len()).map(cell).collect()
}

/// Stacked cells of such heights that all frames are equally high.
fn even_heights(figure: &Figure, cells: &[Frame], rows: &[Rows]) -> Vec<Frame> {
    if figure.arrangement == Arrangement::SideBySide {
        return cells.to_vec();
    }
    let total: f64 = cells.iter().map(|cell| cell.height()).sum();
    let taken: f64 = rows.iter().map(|rows| rows.above + rows.below).sum();
    let frame = (total - taken) / cells.len().max(1) as f64;
    let mut top = cells.first().map_or(0.0, |cell| cell.top);
    let even = |(cell, rows): (&Frame, &Rows)| {
        let bottom = top + frame + rows.above + rows.below;
        let even = Frame { top, bottom, ..*cell };
        top = bottom + BETWEEN;
        even
    };
    cells.iter().zip(rows).map(even).collect()
}

fn rows(
    figure: &Figure,
    panel: &Panel,
    cell: Frame,
    ranges: (Range, Range),
    legends: bool,
) -> Rows {
    let legend = match figure.legend {
        LegendPlace::Panel if legends => {
            let most = ((0.3 * cell.height() / legend::ROW) as usize).max(1);
            Legend::new(&[panel], cell.width() - 60.0, most)
        }
        _ => Legend::default(),
    };
    let exponent = |axis: &Axis, range| Ticks::new(axis.scale, range, 5).exponent;
    let mut above = legend.height() + 4.0;
    if !panel.heading.is_empty() {
        above += line_height(HEADING);
    }
    let has_bar_factor = panel
        .layers
        .iter()
        .any(|layer| matches!(layer, Layer::ColourBar(bar) if !bar_labels(bar).1.is_empty()));
    if exponent(&panel.vertical, ranges.1) != 0 || has_bar_factor {
        above += line_height(TICK);
    }
    let mut below = TICK_MARK + line_height(TICK);
    if !panel.horizontal.label.is_empty() || exponent(&panel.horizontal, ranges.0) != 0 {
        below += line_height(LABEL);
    }
    Rows { above, below, legend }
}

/// Room for the last tick label, or for a colour bar.
fn right_margin(panel: &Panel) -> f64 {
    let bar = panel.layers.iter().find_map(|layer| match layer {
        Layer::ColourBar(bar) => Some(bar_labels(bar).0),
        _ => None,
    });
    bar.map_or(LAST_LABEL, |labels| {
        let widest = labels.iter().map(|label| text::width(label, TICK)).fold(12.0, f64::max);
        BAR_GAP + BAR_WIDTH + 4.0 + widest + BAR_LABEL_GAP + line_height(LABEL)
    })
}

fn left_margin(axis: &Axis, ticks: &Ticks) -> f64 {
    let labels = ticks.labelled.iter().map(|tick| text::width(&tick.label, TICK));
    let label = if axis.label.is_empty() { 0.0 } else { line_height(LABEL) };
    label + labels.fold(12.0, f64::max) + TICK_MARK + 8.0
}

/// As many ticks as fit along a length without their labels touching.
fn ticks(axis: &Axis, range: Range, length: f64, horizontal: bool) -> Ticks {
    if !axis.names.is_empty() {
        return Ticks::named(&axis.names);
    }
    let spacing = if horizontal { 75.0 } else { 30.0 };
    let most = ((length / spacing) as usize).clamp(2, 24);
    let extent = |label: &str| if horizontal { text::width(label, TICK) + 10.0 } else { 15.0 };
    let reach = |index: usize, ticks: &Ticks| {
        let tick = &ticks.labelled[index];
        let (place, half) = (length * range.part(tick.place), 0.5 * extent(&tick.label));
        (place - half, place + half)
    };
    let fits = |ticks: &Ticks| {
        let neighbours = 1..ticks.labelled.len();
        neighbours.into_iter().all(|i| reach(i - 1, ticks).1 <= reach(i, ticks).0)
    };
    let mut ticks = Ticks::new(axis.scale, range, most);
    for wanted in (2..most).rev() {
        if fits(&ticks) {
            break;
        }
        ticks = Ticks::new(axis.scale, range, wanted);
    }
    let mut taken = f64::NEG_INFINITY;
    let mut keep = Vec::new();
    for index in 0..ticks.labelled.len() {
        let (from, to) = reach(index, &ticks);
        keep.push(from >= taken);
        taken = if from >= taken { to } else { taken };
    }
    let mut keep = keep.into_iter();
    ticks.labelled.retain(|_| keep.next().unwrap_or(true));
    ticks
}

/// Horizontal and vertical range of every panel, made equal along the arrangement.
fn shared_ranges(figure: &Figure) -> Vec<(Range, Range)> {
    let mut ranges: Vec<_> = figure.panels.iter().map(panel_ranges).collect();
    let all = ranges.iter().copied().reduce(|a, b| (a.0.union(b.0), a.1.union(b.1)));
    let Some(all) = all else { return ranges };
    let same = |scale: fn(&Panel) -> super::axis::Scale| {
        figure.panels.windows(2).all(|pair| scale(&pair[0]) == scale(&pair[1]))
    };
    match figure.arrangement {
        Arrangement::Stacked if same(|panel| panel.horizontal.scale) => {
            ranges.iter_mut().for_each(|range| range.0 = all.0);
        }
        Arrangement::SideBySide if same(|panel| panel.vertical.scale) => {
            ranges.iter_mut().for_each(|range| range.1 = all.1);
        }
        _ => {}
    }
    ranges
}

fn panel_ranges(panel: &Panel) -> (Range, Range) {
    let (mut x, mut y) = (Vec::new(), Vec::new());
    for layer in &panel.layers {
        for point in layer_points(layer) {
            let place =
                (panel.horizontal.scale.place(point.0), panel.vertical.scale.place(point.1));
            if let (Some(across), Some(up)) = place {
                x.push(across);
                y.push(up);
            }
        }
    }
    let with = |axis: &Axis, places: Vec<f64>, padding: f64| {
        let included = axis.include.iter().filter_map(|&value| axis.scale.place(value));
        axis.scale.range(places.into_iter().chain(included), padding)
    };
    // A map fills its frame.
    let is_map = panel.layers.iter().any(|layer| matches!(layer, Layer::Contours(_)));
    let (beside, above) = if is_map { (0.0, 0.0) } else { (0.025, 0.06) };
    (with(&panel.horizontal, x, beside), with(&panel.vertical, y, above))
}

/// The points that the axes must hold.
fn layer_points(layer: &Layer) -> Vec<(f64, f64)> {
    match layer {
        Layer::Line(line) if line.sets_range => line.points.clone(),
        Layer::Band(band) => {
            band.points.iter().flat_map(|&(x, low, high)| [(x, low), (x, high)]).collect()
        }
        Layer::Area(area) => area.points.clone(),
        Layer::Contours(contours) => match (contours.x.as_slice(), contours.y.as_slice()) {
            ([left, .., right], [top, .., bottom]) => vec![(*left, *top), (*right, *bottom)],
            _ => Vec::new(),
        },
        Layer::Line(_) | Layer::Mark(_) | Layer::ColourBar(_) | Layer::Cross(_) => Vec::new(),
    }
}
