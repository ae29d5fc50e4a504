//! How pictures look: sizes of text, widths of strokes, and what becomes of colours.

use super::colour::Colour;

/// Where a picture is to be looked at. All have the same parts in the same places.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Theme {
    /// Large text on white with a grid.
    #[default]
    Screen,
    /// Text of 7.5 to 10 points and thin strokes in black on white, without a grid: a column of a journal.
    Print,
    /// As for a screen, light on dark.
    Dark,
}

/// Sizes of text in units of the picture (1/96 inch), and what strokes are multiplied by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sizes {
    pub(super) title: u32,
    pub(super) note: u32,
    pub(super) heading: u32,
    pub(super) label: u32,
    pub(super) tick: u32,
    pub(super) legend: u32,
    pub(super) stroke: f64,
    /// What lengths of marks, samples and gaps are multiplied by.
    pub(super) scale: f64,
    /// Space at the rim of the picture, and between panels.
    pub(super) rim: f64,
    pub(super) between: f64,
}

/// The least sizes: 9 units are 6.75 points, of which journals print no less.
const LEAST_TITLE: u32 = 11;
const LEAST_HEADING: u32 = 10;
const LEAST_TEXT: u32 = 9;

impl Sizes {
    /// All sizes by one factor, but text not below what can be read.
    pub(super) fn scaled(self, factor: f64) -> Self {
        let text = |size: u32, least: u32| {
            ((factor * f64::from(size)).round() as u32).max(least.min(size))
        };
        Self {
            title: text(self.title, LEAST_TITLE),
            note: text(self.note, LEAST_TEXT),
            heading: text(self.heading, LEAST_HEADING),
            label: text(self.label, LEAST_TEXT),
            tick: text(self.tick, LEAST_TEXT),
            legend: text(self.legend, LEAST_TEXT),
            stroke: factor * self.stroke,
            scale: factor * self.scale,
            rim: factor * self.rim,
            between: factor * self.between,
        }
    }
}

impl Theme {
    pub(super) fn sizes(self) -> Sizes {
        match self {
            Self::Screen | Self::Dark => Sizes {
                title: 17,
                note: 12,
                heading: 14,
                label: 13,
                tick: 12,
                legend: 12,
                stroke: 1.0,
                scale: 1.0,
                rim: 14.0,
                between: 16.0,
            },
            Self::Print => Sizes {
                title: 13,
                note: 10,
                heading: 11,
                label: 11,
                tick: 10,
                legend: 10,
                stroke: 0.75,
                scale: 1.0,
                rim: 5.0,
                between: 9.0,
            },
        }
    }

    pub(super) fn has_grid(self) -> bool {
        self != Self::Print
    }

    /// What a colour meant for white paper becomes.
    pub(super) fn colour(self, colour: Colour) -> Colour {
        match (self, colour) {
            (Self::Screen, colour) => colour,
            (Self::Print, Colour::INK) => Colour(0, 0, 0),
            (Self::Print, Colour::GREY) => Colour(0x50, 0x50, 0x50),
            (Self::Print, colour) => colour,
            (Self::Dark, Colour::PAPER) => Colour(0x14, 0x18, 0x1f),
            (Self::Dark, Colour::INK) => Colour(0xe8, 0xec, 0xf1),
            (Self::Dark, Colour::GREY) => Colour(0x9a, 0xa5, 0xb1),
            (Self::Dark, Colour::GRID) => Colour(0x33, 0x3a, 0x44),
            (Self::Dark, Colour::FAINT) => Colour(0x23, 0x29, 0x31),
            (Self::Dark, Colour::BLUE) => Colour(0x5c, 0xb3, 0xf0),
            (Self::Dark, Colour::VERMILION) => Colour(0xff, 0x8a, 0x3d),
            (Self::Dark, Colour::GREEN) => Colour(0x2f, 0xc8, 0x9c),
            (Self::Dark, Colour::PUNCH) => Colour(0x8d, 0x96, 0xa1),
            (Self::Dark, colour) => colour,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_stands_out_from_its_ground_in_every_theme() {
        // Relative luminance and contrast of WCAG 2.1.
        let part = |part: u8| {
            let part = f64::from(part) / 255.0;
            if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
        };
        let luminance = |c: Colour| 0.2126 * part(c.0) + 0.7152 * part(c.1) + 0.0722 * part(c.2);
        for theme in [Theme::Screen, Theme::Print, Theme::Dark] {
            let ground = luminance(theme.colour(Colour::PAPER));
            for ink in [Colour::INK, Colour::GREY] {
                let ink = luminance(theme.colour(ink));
                let contrast = (ink.max(ground) + 0.05) / (ink.min(ground) + 0.05);
                assert!(contrast >= 4.5, "{theme:?}: {contrast}");
            }
        }
    }
}
