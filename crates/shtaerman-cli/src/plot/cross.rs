//! Crosses, which mark places of a map.

use super::canvas::{Canvas, Point};
use super::colour::Colour;

/// Half the length of a stroke of a cross.
const ARM: f64 = 7.0;

/// A dark cross with a light rim, to be seen on any colour.
pub(super) fn cross_at(canvas: &mut Canvas, (x, y): Point) {
    for (colour, width, arm) in [(Colour::PAPER, 5.0, ARM + 1.2), (Colour::INK, 2.0, ARM)] {
        canvas.line((x - arm, y), (x + arm, y), colour, width);
        canvas.line((x, y - arm), (x, y + arm), colour, width);
    }
}
