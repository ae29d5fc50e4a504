//! Draws filled contours, their colour bar, and crosses.

use super::bar_labels::bar_labels;
use super::canvas::{Anchor, Canvas, Point};
use super::colour::Colour;
use super::contours::{Field, Vertex};
use super::cross::cross_at;
use super::figure::{ColourBar, Contours, Cross, Dash};
use super::layout::{BAR_GAP, BAR_LABEL_GAP, BAR_WIDTH, NUMBER_GAP, line_height};
use super::mapping::{Mapping, draw_upright, style};
use super::shape;
use super::text;

/// A closed contour with the band that begins inside it.
struct Loop {
    vertices: Vec<Vertex>,
    /// Area as a share of the map, in billionths: larger loops surround smaller ones.
    area: i64,
    /// Loops that coincide are painted in this order.
    order: i64,
    band: usize,
}

/// The contours of all levels. One of the encoders fills holes, so the inside of a hole is painted over with the band below.
fn loops(field: &Field<'_>, levels: &[f64]) -> Vec<Loop> {
    let whole = field.regions(f64::MIN);
    let total: f64 = whole.iter().map(|vertices| area(vertices)).sum();
    let base =
        whole.into_iter().map(|vertices| Loop { vertices, area: i64::MAX, order: 0, band: 0 });
    let mut loops: Vec<Loop> = base.collect();
    for (index, &level) in levels.iter().enumerate() {
        for vertices in field.regions(level) {
            let share = area(&vertices) / total;
            let (order, band) =
                if share < 0.0 { (-(index as i64), index) } else { (index as i64, index + 1) };
            loops.push(Loop { vertices, area: (1e9 * share.abs()) as i64, order, band });
        }
    }
    loops.sort_by_key(|contour| (std::cmp::Reverse(contour.area), contour.order));
    loops
}

/// Positive for loops around high values in one sense of the axes, negative in the other; of holes the opposite.
fn area(vertices: &[Vertex]) -> f64 {
    let next = vertices.iter().cycle().skip(1);
    vertices.iter().zip(next).map(|(a, b)| 0.5 * (a.x * b.y - b.x * a.y)).sum()
}

pub(super) fn draw_contours(
    canvas: &mut Canvas,
    mapping: &Mapping<'_>,
    contours: &Contours,
) -> bool {
    let bands = contours.levels.len() + 1;
    let values: Vec<f64> =
        contours.values.iter().map(|value| value.clamp(f64::MIN, f64::MAX)).collect();
    let field = Field { x: &contours.x, y: &contours.y, values: &values };
    let loops = loops(&field, &contours.levels);
    let place = |vertex: &Vertex| mapping.x(vertex.x).zip(mapping.y(vertex.y));
    for contour in &loops {
        let points: Vec<Point> = contour.vertices.iter().filter_map(place).collect();
        let points = shape::thinned(&points);
        canvas.fill(&points, contours.palette.colour(contour.band, bands), 1.0);
    }
    for contour in loops.iter().skip(1) {
        let colour = contours.palette.colour(contour.band, bands).darker();
        let vertices = &contour.vertices;
        // A loop begins anywhere: what crosses its beginning is one line.
        let start = vertices.iter().position(|vertex| vertex.on_border).unwrap_or(0);
        let turned = vertices.iter().cycle().skip(start).take(vertices.len() + 1);
        let points = turned.map(|vertex| if vertex.on_border { None } else { place(vertex) });
        for run in shape::runs(points).iter().filter(|run| run.len() > 1) {
            canvas.path(run, colour, 0.7, Dash::Solid);
        }
    }
    !loops.is_empty()
}

pub(super) fn draw_cross(canvas: &mut Canvas, mapping: &Mapping<'_>, cross: &Cross) {
    if let Some((x, y)) = mapping.x(cross.at.0).zip(mapping.y(cross.at.1)) {
        cross_at(canvas, (x, y));
    }
}

/// Bands from below to above at the right of the frame, with the levels between them.
pub(super) fn draw_colour_bar(canvas: &mut Canvas, mapping: &Mapping<'_>, bar: &ColourBar) {
    let frame = mapping.layout.frame;
    let sizes = canvas.sizes();
    let bands = bar.levels.len() + 1;
    let left = frame.right + sizes.scale * BAR_GAP;
    let right = left + sizes.scale * BAR_WIDTH;
    let height = frame.height() / bands as f64;
    let level = |index: usize| frame.bottom - height * index as f64;
    let [below, above] = bar.goes_on;
    let (middle, tip) = (left.midpoint(right), 0.5 * height.min(2.0 * (right - left)));
    let mut outline = Vec::new();
    for band in 0..bands {
        let (bottom, top) = (level(band), level(band + 1));
        let mut corners = vec![(left, bottom), (right, bottom), (right, top), (left, top)];
        // What goes on ends in an arrow.
        if band == 0 && below {
            corners = vec![(left, bottom - tip), (middle, bottom), (right, bottom - tip)];
            corners.extend([(right, top), (left, top)]);
        }
        if band + 1 == bands && above {
            corners = vec![(left, bottom), (right, bottom), (right, top + tip)];
            corners.extend([(middle, top), (left, top + tip)]);
        }
        canvas.fill(&corners, bar.palette.colour(band, bands), 1.0);
    }
    let ends = |end: f64, inwards: f64, goes_on: bool, [from, to]: [f64; 2]| {
        if goes_on {
            vec![(from, end + inwards), (middle, end), (to, end + inwards)]
        } else {
            vec![(from, end), (to, end)]
        }
    };
    outline.extend(ends(frame.top, tip, above, [left, right]));
    outline.extend(ends(frame.bottom, -tip, below, [right, left]));
    for (from, to) in outline.iter().zip(outline.iter().cycle().skip(1)) {
        canvas.line(*from, *to, Colour::INK, 1.0);
    }
    let (labels, multiplier) = bar_labels(bar);
    let mut taken = f64::INFINITY;
    for (index, label) in labels.iter().enumerate() {
        let y = level(index + 1);
        canvas.line((left, y), (right, y), Colour::INK, 0.6);
        if taken - y >= 0.95 * line_height(sizes.tick) {
            canvas.text(
                (right + NUMBER_GAP, y),
                label,
                style(sizes.tick, Colour::INK, Anchor::Start),
            );
            taken = y;
        }
    }
    let above = (right, frame.top - 0.5 * line_height(sizes.tick));
    canvas.text(above, &multiplier, style(sizes.tick, Colour::INK, Anchor::Middle));
    let widest = labels.iter().map(|label| text::width(label, sizes.tick)).fold(0.0, f64::max);
    let gap = NUMBER_GAP + sizes.scale * BAR_LABEL_GAP;
    let x = right + gap + widest.max(12.0) + 0.5 * line_height(sizes.label);
    draw_upright(canvas, &bar.label, x, frame, [frame.top, mapping.layout.cell.bottom]);
}
