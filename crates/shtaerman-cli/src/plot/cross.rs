//! Crosses, which mark places of a map, and arrows, which say that a curve goes on.

use super::canvas::{Canvas, Point};
use super::colour::Colour;

/// Half the length of a stroke of a cross.
const ARM: f64 = 7.0;

/// A dark cross with a light rim, to be seen on any colour.
pub(super) fn cross_at(canvas: &mut Canvas, (x, y): Point) {
    let scale = canvas.sizes().scale;
    for (colour, width, arm) in
        [(Colour::PAPER, 5.0, scale * (ARM + 1.2)), (Colour::INK, 2.0, scale * ARM)]
    {
        canvas.line((x - arm, y), (x + arm, y), colour, width);
        canvas.line((x, y - arm), (x, y + arm), colour, width);
    }
}

/// Height of an arrow, and half its width.
const ARROW: (f64, f64) = (9.0, 4.5);

/// An arrow with its tip at a point.
pub(super) fn arrow_at(canvas: &mut Canvas, (x, y): Point, colour: Colour, is_upward: bool) {
    let scale = canvas.sizes().scale;
    let (height, half) = (scale * ARROW.0, scale * ARROW.1);
    let height = if is_upward { height } else { -height };
    canvas.fill(&[(x, y), (x + half, y + height), (x - half, y + height)], colour, 1.0);
    canvas.line((x, y + height), (x, y + 1.8 * height), colour, 1.6);
}
