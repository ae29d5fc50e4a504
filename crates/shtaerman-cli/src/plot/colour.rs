//! Colours that stay apart for colour-blind readers and on paper.

/// A colour: red, green and blue, 0 to 255.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colour(pub u8, pub u8, pub u8);

/// The colours of ordered values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Palette {
    /// From dark to light: perceptually uniform (viridis).
    #[default]
    Sequential,
    /// From light to dark, for values below zero.
    Reversed,
    /// Blue over white to red, for values of both signs.
    Diverging,
}

impl Palette {
    /// Colour of the `index`-th of `count` bands.
    #[must_use]
    pub fn colour(self, index: usize, count: usize) -> Colour {
        let place = index as f64 / count.saturating_sub(1).max(1) as f64;
        match self {
            Self::Sequential => Colour::between(&VIRIDIS, place),
            Self::Reversed => Colour::between(&VIRIDIS, 1.0 - place),
            Self::Diverging => Colour::between(&BLUE_TO_RED, place),
        }
    }
}

/// Viridis (S. van der Walt and N. Smith), at equal distances.
const VIRIDIS: [(f64, f64, f64); 9] = [
    (68.0, 1.0, 84.0),
    (71.0, 44.0, 122.0),
    (59.0, 81.0, 139.0),
    (44.0, 113.0, 142.0),
    (33.0, 144.0, 141.0),
    (39.0, 173.0, 129.0),
    (92.0, 200.0, 99.0),
    (170.0, 220.0, 50.0),
    (253.0, 231.0, 37.0),
];
/// Of equal lightness at equal distances from the middle.
const BLUE_TO_RED: [(f64, f64, f64); 7] = [
    (33.0, 60.0, 130.0),
    (67.0, 125.0, 185.0),
    (160.0, 200.0, 225.0),
    (246.0, 246.0, 244.0),
    (244.0, 190.0, 160.0),
    (208.0, 103.0, 80.0),
    (140.0, 25.0, 45.0),
];

impl Colour {
    /// The ground of a picture.
    pub const PAPER: Self = Self(0xff, 0xff, 0xff);
    /// Text, frames and neutral curves.
    pub const INK: Self = Self(0x22, 0x22, 0x22);
    /// Secondary text and reference lines.
    pub const GREY: Self = Self(0x6e, 0x6e, 0x6e);
    /// Grid lines.
    pub const GRID: Self = Self(0xdc, 0xdc, 0xdc);
    /// Minor grid lines.
    pub const FAINT: Self = Self(0xef, 0xef, 0xef);
    /// First of the categorical colours (Okabe and Ito).
    pub const BLUE: Self = Self(0x00, 0x72, 0xb2);
    /// Warning: what should not be, such as a pulling pressure.
    pub const VERMILION: Self = Self(0xd5, 0x5e, 0x00);
    /// Third of the categorical colours.
    pub const GREEN: Self = Self(0x00, 0x9e, 0x73);
    /// A punch.
    pub const PUNCH: Self = Self(0x5f, 0x66, 0x70);
    /// A rough layer.
    pub const LAYER: Self = Self(0xe6, 0x9f, 0x00);
    /// An elastic body.
    pub const BODY: Self = Self(0x56, 0xb4, 0xe9);

    /// Colour number `index` of a set without order, after Okabe and Ito (2008); repeats after seven.
    #[must_use]
    pub fn categorical(index: usize) -> Self {
        const COLOURS: [Colour; 7] = [
            Colour::BLUE,
            Colour::VERMILION,
            Colour::GREEN,
            Colour(0xcc, 0x79, 0xa7),
            Colour::BODY,
            Colour::LAYER,
            Colour(0x44, 0x44, 0x44),
        ];
        COLOURS[index % COLOURS.len()]
    }

    /// Colour of the `index`-th of `count` ordered values: the viridis map without its pale end.
    #[must_use]
    pub fn ordered(index: usize, count: usize) -> Self {
        const STOPS: [(f64, f64, f64); 6] = [
            (68.0, 1.0, 84.0),
            (65.0, 68.0, 135.0),
            (42.0, 120.0, 142.0),
            (34.0, 168.0, 132.0),
            (94.0, 201.0, 98.0),
            (180.0, 205.0, 34.0),
        ];
        let place = index as f64 / count.saturating_sub(1).max(1) as f64;
        Self::between(&STOPS, place)
    }

    /// The same colour, darker: lines between bands.
    #[must_use]
    pub(super) fn darker(self) -> Self {
        let part = |part: u8| (0.6 * f64::from(part)).round() as u8;
        Self(part(self.0), part(self.1), part(self.2))
    }

    /// The colour at a place from 0 to 1 between stops.
    fn between(stops: &[(f64, f64, f64)], place: f64) -> Self {
        let last = stops.len() - 1;
        let place = place.clamp(0.0, 1.0) * last as f64;
        let low = (place.floor() as usize).min(last - 1);
        let part = place - low as f64;
        let mix = |a: f64, b: f64| (a + part * (b - a)).round() as u8;
        let (a, b) = (stops[low], stops[low + 1]);
        Self(mix(a.0, b.0), mix(a.1, b.1), mix(a.2, b.2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordered_colours_run_from_dark_to_light_and_never_repeat() {
        let luminance =
            |c: Colour| 0.2126 * f64::from(c.0) + 0.7152 * f64::from(c.1) + 0.0722 * f64::from(c.2);
        let colours: Vec<_> = (0..12).map(|i| Colour::ordered(i, 12)).collect();
        assert!(colours.windows(2).all(|pair| luminance(pair[0]) < luminance(pair[1])));
        assert_eq!(Colour::ordered(0, 1), colours[0]);
        assert_eq!(Colour::ordered(99, 12), colours[11]);
    }
}
