//! Draws a figure from its layout.

use kuva::render::render::Scene;

use super::canvas::{Anchor, Canvas, Frame, Point};
use super::colour::Colour;
use super::cross::arrow_at;
use super::draw_map::{draw_colour_bar, draw_contours, draw_cross};
use super::figure::{Area, Band, Base, Figure, Layer, Line, Mark, Panel, Pole};
use super::format::Size;
use super::layout::{AxisLayout, Layout, PanelLayout, TICK_MARK, line_height};
use super::mapping::{Mapping, draw_upright, style};
use super::shape;
use super::text;
use super::theme::{Sizes, Theme};

/// The picture of a figure.
pub(super) fn figure(figure: &Figure, layout: &Layout, size: Size, theme: Theme) -> Scene {
    let sizes = layout.sizes;
    let mut canvas = Canvas::new(size, theme, sizes);
    let mut top = sizes.rim;
    for (lines, size, colour) in
        [(&layout.title, sizes.title, Colour::INK), (&layout.notes, sizes.note, Colour::GREY)]
    {
        for line in lines {
            let at = (sizes.rim, top + 0.5 * line_height(size));
            canvas.text(at, line, style(size, colour, Anchor::Start));
            top += line_height(size);
        }
    }
    layout.legend.0.draw(&mut canvas, (sizes.rim, layout.legend.1));
    for (panel, layout) in figure.panels.iter().zip(&layout.panels) {
        draw_panel(&mut canvas, panel, layout);
    }
    canvas.finish()
}

fn draw_panel(canvas: &mut Canvas, panel: &Panel, layout: &PanelLayout) {
    let frame = layout.frame;
    let mapping = Mapping { panel, layout };
    let sizes = canvas.sizes();
    if canvas.theme().has_grid() {
        draw_grid(canvas, &mapping);
    }
    canvas.clip(frame);
    let mut drawn = false;
    for layer in &panel.layers {
        drawn |= draw_layer(canvas, &mapping, layer);
    }
    canvas.unclip();
    if !drawn {
        let style = style(sizes.label, Colour::GREY, Anchor::Middle);
        let said = text::fit("no numbers to draw", sizes.label, frame.width());
        canvas.text(frame.centre(), &said, style);
    }
    if let (Some(panel), Some(layout)) = (&panel.inset, &layout.inset) {
        draw_inset(canvas, panel, layout);
    }
    draw_frame(canvas, frame);
    for layer in &panel.layers {
        if let Layer::ColourBar(bar) = layer {
            draw_colour_bar(canvas, &mapping, bar);
        }
    }
    draw_head(canvas, panel, layout);
    draw_horizontal_axis(canvas, &mapping);
    draw_vertical_axis(canvas, &mapping);
}

/// A small panel on its own ground.
fn draw_inset(canvas: &mut Canvas, panel: &Panel, layout: &PanelLayout) {
    let (frame, size) = (layout.frame, canvas.sizes().tick);
    let margin = 0.5 * f64::from(size);
    let (left, right, below) = (frame.left - margin, frame.right + margin, frame.bottom + margin);
    let ground = [
        (left, layout.cell.top + 1.0),
        (right, layout.cell.top + 1.0),
        (right, below),
        (left, below),
    ];
    canvas.fill(&ground, Colour::PAPER, 0.85);
    let mapping = Mapping { panel, layout };
    canvas.clip(frame);
    for layer in &panel.layers {
        draw_layer(canvas, &mapping, layer);
    }
    canvas.unclip();
    draw_frame(canvas, frame);
    let heading = text::fit(&text::clean(&panel.heading), size, frame.width());
    let above = (frame.left, frame.top - 0.5 * line_height(size));
    canvas.text(above, &heading, style(size, Colour::GREY, Anchor::Start));
}

fn draw_grid(canvas: &mut Canvas, mapping: &Mapping<'_>) {
    let frame = mapping.layout.frame;
    let lines = |axis: &AxisLayout| {
        let minor = axis.ticks.minor.iter().map(|&place| (place, Colour::FAINT));
        let major = axis.ticks.labelled.iter().map(|tick| (tick.place, Colour::GRID));
        minor.chain(major).collect::<Vec<_>>()
    };
    for (place, colour) in lines(&mapping.layout.horizontal) {
        let x = mapping.across(place);
        canvas.line((x, frame.top), (x, frame.bottom), colour, 1.0);
    }
    for (place, colour) in lines(&mapping.layout.vertical) {
        let y = mapping.down(place);
        canvas.line((frame.left, y), (frame.right, y), colour, 1.0);
    }
}

fn draw_frame(canvas: &mut Canvas, frame: Frame) {
    let (left, top, right, bottom) = (frame.left, frame.top, frame.right, frame.bottom);
    let corners = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
    for pair in corners.windows(2) {
        canvas.line(pair[0], pair[1], Colour::INK, 1.0);
    }
}

fn draw_head(canvas: &mut Canvas, panel: &Panel, layout: &PanelLayout) {
    let mut top = layout.cell.top;
    let sizes = canvas.sizes();
    if !panel.heading.is_empty() {
        let room = layout.frame.width();
        let heading = text::fit(&text::clean(&panel.heading), sizes.heading, room);
        let at = (layout.frame.left, top + 0.5 * line_height(sizes.heading));
        canvas.text(at, &heading, style(sizes.heading, Colour::INK, Anchor::Start));
        top += line_height(sizes.heading);
    }
    layout.legend.draw(canvas, (layout.legend_left(), top));
}

fn draw_horizontal_axis(canvas: &mut Canvas, mapping: &Mapping<'_>) {
    let frame = mapping.layout.frame;
    let sizes = canvas.sizes();
    let mark = sizes.scale * TICK_MARK;
    let ticks = &mapping.layout.horizontal.ticks;
    let row = frame.bottom + mark + 0.5 * line_height(sizes.tick);
    for tick in &ticks.labelled {
        let x = mapping.across(tick.place);
        canvas.line((x, frame.bottom), (x, frame.bottom + mark), Colour::INK, 1.0);
        canvas.text((x, row), &tick.label, style(sizes.tick, Colour::INK, Anchor::Middle));
    }
    let row = frame.bottom + mark + line_height(sizes.tick) + 0.5 * line_height(sizes.label);
    let multiplier = ticks.multiplier();
    let Foot { label, is_centred, exaggeration } = Foot::new(mapping, &multiplier, sizes);
    let (x, anchor) =
        if is_centred { (frame.centre().0, Anchor::Middle) } else { (frame.left, Anchor::Start) };
    canvas.text((x, row), &label, style(sizes.label, Colour::INK, anchor));
    canvas.text((frame.right, row), &multiplier, style(sizes.tick, Colour::INK, Anchor::End));
    let before = frame.right - beside(&multiplier, sizes);
    canvas.text((before, row), &exaggeration, style(sizes.tick, Colour::GREY, Anchor::End));
}

/// What a common factor takes at the right, with the space before it.
fn beside(multiplier: &str, sizes: Sizes) -> f64 {
    if multiplier.is_empty() {
        return 0.0;
    }
    text::width(multiplier, sizes.tick) + 0.5 * f64::from(sizes.tick)
}

/// The line below a horizontal axis.
struct Foot {
    label: String,
    is_centred: bool,
    /// By how much heights are drawn larger than lengths.
    exaggeration: String,
}

impl Foot {
    /// The label in the middle, and at the left where what stands at the right would touch it.
    fn new(mapping: &Mapping<'_>, multiplier: &str, sizes: Sizes) -> Self {
        let width = mapping.layout.frame.width();
        let taken = beside(multiplier, sizes);
        let label = text::clean(&mapping.panel.horizontal.label);
        let middle = text::width(&label, sizes.label);
        let factor = mapping.layout.exaggeration.map(text::round_number);
        let told = factor.map_or([const { String::new() }; 2], |factor| {
            [format!("heights exaggerated {factor} times"), format!("heights ×{factor}")]
        });
        let gap = f64::from(sizes.tick);
        let space = |words: &str| match words {
            "" => taken,
            words => taken + text::width(words, sizes.tick) + gap,
        };
        if let Some(words) = told.iter().find(|words| 2.0 * space(words) + middle <= width) {
            return Self { label, is_centred: true, exaggeration: words.clone() };
        }
        let [_, short] = told;
        let label = text::fit_label(&label, sizes.label, width - space(&short) - gap);
        Self { label, is_centred: false, exaggeration: short }
    }
}

fn draw_vertical_axis(canvas: &mut Canvas, mapping: &Mapping<'_>) {
    let (frame, reach) = (mapping.layout.frame, mapping.layout.label_reach());
    let sizes = canvas.sizes();
    let mark = sizes.scale * TICK_MARK;
    let ticks = &mapping.layout.vertical.ticks;
    for tick in &ticks.labelled {
        let y = mapping.down(tick.place);
        canvas.line((frame.left - mark, y), (frame.left, y), Colour::INK, 1.0);
        let at = (frame.left - mark - 3.0, y);
        canvas.text(at, &tick.label, style(sizes.tick, Colour::INK, Anchor::End));
    }
    let above = (frame.left, frame.top - 0.5 * line_height(sizes.tick));
    canvas.text(above, &ticks.multiplier(), style(sizes.tick, Colour::INK, Anchor::Start));
    for (index, line) in mapping.layout.upright.iter().enumerate() {
        let across = mapping.layout.label + index as f64 * line_height(sizes.label);
        draw_upright(canvas, line, across, frame, reach);
    }
}

/// Draws a layer and tells whether anything but a mark was there to draw.
fn draw_layer(canvas: &mut Canvas, mapping: &Mapping<'_>, layer: &Layer) -> bool {
    match layer {
        Layer::Line(line) => draw_line(canvas, mapping, line),
        Layer::Band(band) => draw_band(canvas, mapping, band),
        Layer::Area(area) => draw_area(canvas, mapping, area),
        Layer::Mark(mark) => {
            draw_mark(canvas, mapping, mark);
            false
        }
        Layer::Contours(contours) => draw_contours(canvas, mapping, contours),
        Layer::Cross(cross) => {
            draw_cross(canvas, mapping, cross);
            false
        }
        Layer::Pole(pole) => {
            draw_pole(canvas, mapping, pole);
            false
        }
        // Beside the frame, which clips what is drawn here.
        Layer::ColourBar(_) => false,
    }
}

fn draw_line(canvas: &mut Canvas, mapping: &Mapping<'_>, line: &Line) -> bool {
    let runs = mapping.runs(&line.points);
    for run in &runs {
        if run.len() > 1 {
            canvas.path(run, line.colour, line.width, line.dash);
        }
        if line.dots || run.len() == 1 {
            run.iter().for_each(|&point| canvas.dot(point, line.width + 1.2, line.colour));
        }
    }
    !runs.is_empty() && line.sets_range
}

fn draw_band(canvas: &mut Canvas, mapping: &Mapping<'_>, band: &Band) -> bool {
    let points = band.points.iter().map(|&(x, low, high)| {
        let x = mapping.x(x)?;
        Some(((x, mapping.y(low)?), (x, mapping.y(high)?)))
    });
    let runs = shape::runs(points);
    for run in &runs {
        let upper = run.iter().map(|pair| pair.1);
        let polygon: Vec<Point> = upper.chain(run.iter().rev().map(|pair| pair.0)).collect();
        canvas.fill(&polygon, band.colour, band.opacity);
    }
    !runs.is_empty()
}

fn draw_area(canvas: &mut Canvas, mapping: &Mapping<'_>, area: &Area) -> bool {
    let frame = mapping.layout.frame;
    let runs = mapping.runs(&area.points);
    for run in &runs {
        let polygons = match (area.base, mapping.y(0.0)) {
            (Base::Top, _) => vec![shape::down_to(run, frame.top)],
            (Base::Bottom, _) => vec![shape::down_to(run, frame.bottom)],
            (Base::NegativeToZero, Some(zero)) => {
                shape::beyond(run, zero, !mapping.panel.vertical.reversed)
            }
            (Base::NegativeToZero, None) => Vec::new(),
        };
        for polygon in polygons {
            canvas.fill(&polygon, area.colour, area.opacity);
        }
    }
    !runs.is_empty()
}

fn draw_mark(canvas: &mut Canvas, mapping: &Mapping<'_>, mark: &Mark) {
    let frame = mapping.layout.frame;
    let ends = if mark.vertical {
        mapping.x(mark.at).map(|x| [(x, frame.top), (x, frame.bottom)])
    } else {
        mapping.y(mark.at).map(|y| [(frame.left, y), (frame.right, y)])
    };
    if let Some(ends) = ends {
        canvas.path(&ends, mark.colour, 1.2, mark.dash);
    }
}

fn draw_pole(canvas: &mut Canvas, mapping: &Mapping<'_>, pole: &Pole) {
    if let Some(x) = mapping.x(pole.at) {
        let frame = mapping.layout.frame;
        let tip = if pole.is_upward { frame.top + 2.0 } else { frame.bottom - 2.0 };
        arrow_at(canvas, (x, tip), pole.colour, pole.is_upward);
    }
}
