//! From the points of a panel to those of the picture.

use super::canvas::{Anchor, Canvas, Frame, Point, Style};
use super::colour::Colour;
use super::figure::Panel;
use super::layout::PanelLayout;
use super::shape;
use super::text;

/// Text of a size and colour, along the page.
pub(super) fn style(size: u32, colour: Colour, anchor: Anchor) -> Style {
    Style { size, colour, anchor, upright: false }
}

/// A label read from below to above in the middle of a frame, or, where it is longer, reaching beyond that.
pub(super) fn draw_upright(
    canvas: &mut Canvas,
    label: &str,
    x: f64,
    frame: Frame,
    [top, bottom]: [f64; 2],
) {
    let size = canvas.sizes().label;
    let words = text::fit_label(&text::clean(label), size, bottom - top);
    let half = 0.5 * text::width(&words, size);
    let y = frame.centre().1.max(top + half).min(bottom - half);
    let upright = Style { upright: true, ..style(size, Colour::INK, Anchor::Middle) };
    canvas.text((x, y), &words, upright);
}

/// Carries points of a panel to points of the picture.
pub(super) struct Mapping<'a> {
    pub(super) panel: &'a Panel,
    pub(super) layout: &'a PanelLayout,
}

impl Mapping<'_> {
    pub(super) fn across(&self, place: f64) -> f64 {
        let part = self.layout.horizontal.range.part(place);
        let part = if self.panel.horizontal.reversed { 1.0 - part } else { part };
        self.layout.frame.left + part * self.layout.frame.width()
    }

    pub(super) fn down(&self, place: f64) -> f64 {
        let part = self.layout.vertical.range.part(place);
        let part = if self.panel.vertical.reversed { part } else { 1.0 - part };
        self.layout.frame.top + part * self.layout.frame.height()
    }

    pub(super) fn x(&self, value: f64) -> Option<f64> {
        self.panel.horizontal.scale.place(value).map(|place| self.across(place))
    }

    pub(super) fn y(&self, value: f64) -> Option<f64> {
        self.panel.vertical.scale.place(value).map(|place| self.down(place))
    }

    /// Unbroken parts of a curve.
    pub(super) fn runs(&self, points: &[(f64, f64)]) -> Vec<Vec<Point>> {
        shape::runs(points.iter().map(|&(x, y)| self.x(x).zip(self.y(y))))
    }
}
