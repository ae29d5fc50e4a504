//! Where the parts of a picture go.

use super::axis::{Axis, Range};
use super::bar_labels::bar_labels;
use super::canvas::Frame;
use super::figure::{Arrangement, Figure, Layer, LegendPlace, Panel};
use super::format::Size;
use super::legend::Legend;
use super::margins::{left_margin, right_margin, ticks, ticks_up};
use super::ranges::{exaggerated, panel_ranges, shared_ranges};
use super::text;
use super::theme::Sizes;
use super::ticks::Ticks;

/// Length of a tick mark.
pub(super) const TICK_MARK: f64 = 5.0;
/// From one line of text to the next, in sizes of the font.
const LEADING: f64 = 1.4;
/// Space beside a colour bar, its width, and the space between the numbers and the label.
pub(super) const BAR_GAP: f64 = 14.0;
pub(super) const BAR_WIDTH: f64 = 16.0;
pub(super) const BAR_LABEL_GAP: f64 = 6.0;
/// Space before the numbers of a colour bar.
pub(super) const NUMBER_GAP: f64 = 4.0;
/// Frames are not made smaller than this.
const SMALLEST_FRAME: f64 = 20.0;
/// Most lines of the label up an axis: a name of two words, and its unit.
const LABEL_LINES: usize = 3;
/// Space above a frame.
const ABOVE: f64 = 4.0;

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
    pub(super) sizes: Sizes,
}

/// Places of everything in a panel.
pub(super) struct PanelLayout {
    pub(super) frame: Frame,
    /// What the panel takes with all that is around its frame.
    pub(super) cell: Frame,
    /// Middle of the first line of the vertical axis' label.
    pub(super) label: f64,
    /// Its lines: more where one has no room.
    pub(super) upright: Vec<String>,
    pub(super) legend: Legend,
    pub(super) horizontal: AxisLayout,
    pub(super) vertical: AxisLayout,
    /// By which factor heights are drawn larger than lengths, where both are lengths.
    pub(super) exaggeration: Option<f64>,
    pub(super) inset: Option<Box<PanelLayout>>,
}

/// Range and ticks of an axis.
pub(super) struct AxisLayout {
    pub(super) range: Range,
    pub(super) ticks: Ticks,
}

impl Layout {
    /// Everything in its place, with so many lines of the title at most.
    pub(super) fn new(
        figure: &Figure,
        size: Size,
        sizes: Sizes,
        title: usize,
        has_notes: bool,
    ) -> Self {
        let (width, height) = (f64::from(size.width), f64::from(size.height));
        let room = width - 2.0 * sizes.rim;
        let title = text::wrap(&text::clean(&figure.title), sizes.title, room, title);
        let lines = if has_notes { (0.15 * height / line_height(sizes.note)) as usize } else { 0 };
        let mut notes: Vec<String> = Vec::new();
        for note in &figure.notes {
            let left = (lines - notes.len()).min(2);
            notes.extend(text::wrap_clauses(&text::clean(note), sizes.note, room, left));
        }
        let mut top = sizes.rim;
        top += line_height(sizes.title) * title.len() as f64;
        top += line_height(sizes.note) * notes.len() as f64;
        let rows = ((0.25 * height / Legend::row(sizes)) as usize).max(1);
        let legend = shared_legend(figure, room, rows, sizes);
        let gap = 4.0 * sizes.scale;
        let legend_top = top + gap;
        if legend.height() > 0.0 {
            top = legend_top + legend.height();
        }
        let area = Frame {
            left: sizes.rim,
            top: top + 1.5 * gap,
            right: width - sizes.rim,
            bottom: height - sizes.rim,
        };
        let panels = panels(figure, area, sizes);
        Self { title, notes, legend: (legend, legend_top), panels, sizes }
    }

    /// Whether frames have a height and a width, in sizes of tick labels, no name is left out, none lies on another, and those of panels below each other, which nothing else tells apart, are whole.
    pub(super) fn fits(&self, figure: &Figure, [height, width]: [f64; 2]) -> bool {
        let tick = f64::from(self.sizes.tick);
        let is_single = figure.panels.len() < 2;
        let is_roomy = |(panel, layout): (&Panel, &PanelLayout)| {
            let names = LEADING * tick * panel.vertical.names.len() as f64;
            layout.frame.height() >= (height * tick).max(names)
                && layout.frame.width() >= width * tick
                && layout.legend.is_complete()
                && (is_single || layout.has_whole_label(self.sizes.label))
        };
        self.legend.0.is_complete() && figure.panels.iter().zip(&self.panels).all(is_roomy)
    }
}

fn shared_legend(figure: &Figure, width: f64, rows: usize, sizes: Sizes) -> Legend {
    match figure.legend {
        LegendPlace::Figure => {
            Legend::new(&figure.panels.iter().collect::<Vec<_>>(), width, rows, sizes)
        }
        LegendPlace::Panel => Legend::default(),
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

fn panels(figure: &Figure, area: Frame, sizes: Sizes) -> Vec<PanelLayout> {
    let ranges = shared_ranges(figure);
    let cells = cells(figure, area, sizes.between);
    let parts = figure.panels.iter().zip(&cells).zip(&ranges);
    let rows: Vec<Rows> =
        parts.map(|((panel, cell), ranges)| rows(figure, panel, *cell, *ranges, sizes)).collect();
    let cells = even_heights(figure, &cells, &rows, sizes.between);
    let mut built: Vec<PanelLayout> = Vec::new();
    for (((panel, cell), ranges), rows) in figure.panels.iter().zip(cells).zip(ranges).zip(rows) {
        let bottom = cell.bottom - rows.below;
        let top = (cell.top + rows.above).min(bottom - SMALLEST_FRAME);
        let room = [cell.width(), bottom - top];
        let vertical = ticks_up(&panel.vertical, ranges.1, room, sizes);
        let right = cell.right - right_margin(panel, ranges.0, cell.width(), sizes);
        let left = cell.left + left_margin(&panel.vertical, &vertical, sizes);
        let mut layout = PanelLayout {
            frame: Frame { left, top, right, bottom },
            cell,
            label: cell.left + 0.5 * line_height(sizes.label),
            upright: Vec::new(),
            legend: rows.legend,
            horizontal: AxisLayout { range: ranges.0, ticks: Ticks::default() },
            vertical: AxisLayout { range: ranges.1, ticks: vertical },
            exaggeration: None,
            inset: None,
        };
        layout.break_label(&panel.vertical.label, sizes);
        built.push(layout);
    }
    align(figure, &mut built);
    for (panel, layout) in figure.panels.iter().zip(&mut built) {
        layout.frame.left = layout.frame.left.min(layout.frame.right - SMALLEST_FRAME);
        layout.set(panel, sizes);
        if !is_labelled(figure, panel) {
            layout.horizontal.ticks.exponent = 0;
        }
        let small = panel.inset.as_deref().and_then(|panel| inset(panel, layout.frame, sizes));
        layout.inset = small.map(Box::new);
    }
    built
}

impl PanelLayout {
    /// Left end of the legend: that of the frame, or farther to the left where there is not enough room.
    pub(super) fn legend_left(&self) -> f64 {
        self.frame.left.min(self.cell.right - self.legend.width()).max(self.cell.left)
    }

    /// Upper and lower end of the column at the left that a label may take.
    pub(super) fn label_reach(&self) -> [f64; 2] {
        let is_free = self.legend_left() >= self.frame.left;
        [if is_free { self.cell.top } else { self.frame.top }, self.cell.bottom]
    }

    /// Sets the lines of the label up the axis: more than one, beside which the frame is narrower, where they are whole and one is not.
    fn break_label(&mut self, label: &str, sizes: Sizes) {
        let label = text::clean(label);
        if label.is_empty() || is_endless(&label, sizes.label) {
            self.upright = vec![label];
            return;
        }
        let [top, bottom] = self.label_reach();
        let lines = text::wrap(&label, sizes.label, bottom - top, LABEL_LINES);
        if text::is_cut(&lines) {
            self.upright = vec![label];
            return;
        }
        let more = lines.len().saturating_sub(1);
        self.frame.left += line_height(sizes.label) * more as f64;
        self.upright = lines;
    }

    /// Whether the label up the axis is whole, or can be so on no picture.
    fn has_whole_label(&self, size: u32) -> bool {
        let [top, bottom] = self.label_reach();
        let is_whole = |line: &String| text::width(line, size) <= bottom - top;
        self.upright.iter().all(|line| is_whole(line) || is_endless(line, size))
    }

    /// Sets what follows from the final frame: ticks along, and the factor by which heights are drawn larger.
    fn set(&mut self, panel: &Panel, sizes: Sizes) {
        let (frame, range) = (self.frame, self.horizontal.range);
        self.horizontal.ticks = ticks(&panel.horizontal, range, frame.width(), true, sizes);
        let ranges = [range, self.vertical.range];
        if let Some((range, factor)) = exaggerated(panel, ranges, [frame.width(), frame.height()]) {
            let ticks = ticks(&panel.vertical, range, frame.height(), false, sizes);
            self.vertical = AxisLayout { range, ticks };
            self.exaggeration = Some(factor);
        }
    }
}

/// Whether a label is longer than all its lines up the highest picture.
fn is_endless(label: &str, size: u32) -> bool {
    text::width(label, size) > LABEL_LINES as f64 * f64::from(Size::LARGEST.height)
}

/// Size of an inset as a share of its frame, and the least it may have.
const INSET: [f64; 2] = [0.32, 0.36];
/// Shares of a frame from its right end within which an inset stands, and from its lower end below which it and its heading do not reach.
pub(super) const BESIDE_INSET: f64 = 0.36;
pub(super) const BELOW_INSET: f64 = 0.5;
const SMALLEST_INSET: [f64; 2] = [110.0, 50.0];

/// A small panel in the upper right corner of a frame, with its heading above; none where there is no room.
fn inset(panel: &Panel, around: Frame, sizes: Sizes) -> Option<PanelLayout> {
    let [width, height] = [INSET[0] * around.width(), INSET[1] * around.height()];
    let [least_width, least_height] = SMALLEST_INSET.map(|least| sizes.scale * least);
    if width < least_width || height < least_height {
        return None;
    }
    let right = around.right - 0.8 * f64::from(sizes.tick);
    let top = around.top + line_height(sizes.tick) + 2.0;
    let frame = Frame { left: right - width, top, right, bottom: top + height };
    let (across, down) = panel_ranges(panel);
    Some(PanelLayout {
        frame,
        cell: around,
        label: frame.left,
        upright: Vec::new(),
        legend: Legend::default(),
        horizontal: AxisLayout { range: across, ticks: Ticks::default() },
        vertical: AxisLayout { range: down, ticks: Ticks::default() },
        exaggeration: None,
        inset: None,
    })
}

/// Frames below each other begin and end at one place, frames beside each other end at one height.
fn align(figure: &Figure, panels: &mut [PanelLayout]) {
    match figure.arrangement {
        Arrangement::Stacked => {
            let left = panels.iter().map(|panel| panel.frame.left).fold(0.0, f64::max);
            let right = panels.iter().map(|panel| panel.frame.right).fold(f64::INFINITY, f64::min);
            for panel in panels {
                (panel.frame.left, panel.frame.right) = (left, right);
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

fn cells(figure: &Figure, area: Frame, between: f64) -> Vec<Frame> {
    let count = figure.panels.len().max(1) as f64;
    let gaps = between * (count - 1.0);
    let cell = |index: usize| match figure.arrangement {
        Arrangement::Stacked => {
            let height = (area.height() - gaps) / count;
            let top = area.top + index as f64 * (height + between);
            Frame { top, bottom: top + height, ..area }
        }
        Arrangement::SideBySide => {
            let width = (area.width() - gaps) / count;
            let left = area.left + index as f64 * (width + between);
            Frame { left, right: left + width, ..area }
        }
    };
    (0..figure.panels.len()).map(cell).collect()
}

/// Stacked cells of such heights that all frames are equally high.
fn even_heights(figure: &Figure, cells: &[Frame], rows: &[Rows], between: f64) -> Vec<Frame> {
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
        top = bottom + between;
        even
    };
    cells.iter().zip(rows).map(even).collect()
}

/// Whether the line below a panel says what its horizontal axis is: of panels below each other with one range the last one does.
fn is_labelled(figure: &Figure, panel: &Panel) -> bool {
    let is_last = figure.panels.last().is_some_and(|last| std::ptr::eq(last, panel));
    let is_apart = figure.arrangement == Arrangement::SideBySide;
    is_last || is_apart || !panel.horizontal.label.is_empty()
}

fn rows(figure: &Figure, panel: &Panel, cell: Frame, ranges: (Range, Range), sizes: Sizes) -> Rows {
    let legend = match figure.legend {
        LegendPlace::Panel => {
            let most = ((0.3 * cell.height() / Legend::row(sizes)) as usize).max(3);
            // What may stand out to the left of a frame is left out.
            let beside = 60.0 * sizes.scale.min(1.0);
            Legend::new(&[panel], cell.width() - beside, most, sizes)
        }
        LegendPlace::Figure => Legend::default(),
    };
    let exponent = |axis: &Axis, range| Ticks::new(axis.scale, range, 5).exponent;
    let mut above = legend.height() + ABOVE * sizes.scale;
    if !panel.heading.is_empty() {
        above += line_height(sizes.heading);
    }
    let has_bar_factor = panel
        .layers
        .iter()
        .any(|layer| matches!(layer, Layer::ColourBar(bar) if !bar_labels(bar).1.is_empty()));
    if exponent(&panel.vertical, ranges.1) != 0 || has_bar_factor {
        above += line_height(sizes.tick);
    }
    let mut below = sizes.scale * TICK_MARK + line_height(sizes.tick);
    let has_factor = exponent(&panel.horizontal, ranges.0) != 0;
    if is_labelled(figure, panel) && (has_factor || !panel.horizontal.label.is_empty()) {
        below += line_height(sizes.label);
    }
    Rows { above, below, legend }
}
