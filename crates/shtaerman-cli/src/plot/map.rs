//! Map of a value over a section through the body.

use super::Plot;
use super::axis::{Axis, Range, Scale};
use super::colour::{Colour, Palette};
use super::figure::{
    Arrangement, ColourBar, Contours, Cross, Figure, Layer, LegendPlace, Line, Panel,
};
use super::format::Size;
use super::ticks::Ticks;

/// Bands that are aimed at.
const BANDS: usize = 12;
/// Room above the surface, as a share of the depth.
const ABOVE: f64 = 0.05;
/// What rounding may make of the distance between two levels, relative to it.
const ROUNDING: f64 = 1e-9;
/// What a picture needs around its frame.
const BESIDE: f64 = 190.0;
const AROUND: f64 = 175.0;

/// A value over a section, depth downward, with the zones of contact on the surface.
///
/// The values are drawn as bands between round levels with lines between them. Values beyond `limits` count as these.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MapPlot {
    /// Title; empty for none.
    pub title: String,
    /// Notes below the title.
    pub notes: Vec<String>,
    /// Positions along the surface.
    pub x: Vec<f64>,
    /// Depths.
    pub depth: Vec<f64>,
    /// Values, one row for each depth.
    pub values: Vec<f64>,
    /// The smallest and largest value that is told apart; `None` for those of the values.
    pub limits: Option<(f64, f64)>,
    /// The largest value anywhere, where it is known; it may lie between the points.
    pub largest: Option<f64>,
    /// Zones of contact.
    pub zones: Vec<[f64; 2]>,
    /// Places of the largest value: more than one where it is infinite at several.
    pub crosses: Vec<(f64, f64)>,
    /// Their name in the legend.
    pub cross_name: String,
    /// Label of the position, such as `x [mm]`.
    pub position_label: String,
    /// Label of the depth, such as `depth [mm]`.
    pub depth_label: String,
    /// Label of the value, such as `von Mises [MPa]`.
    pub value_label: String,
}

impl MapPlot {
    /// A picture in which position and depth have about one scale, as far as sizes allow.
    #[must_use]
    pub fn size(&self) -> Size {
        let width = Size::default().width;
        let reach = |along: &[f64]| match along {
            [first, .., last] => (last - first).abs(),
            _ => 0.0,
        };
        let (across, down) = (reach(&self.x), reach(&self.depth) * (1.0 + ABOVE));
        let ratio = if across > 0.0 && down > 0.0 { down / across } else { 0.5 };
        let height = (f64::from(width) - BESIDE) * ratio + AROUND;
        Size { width, height: height.clamp(380.0, 1000.0) as u32 }
    }

    fn levels(&self) -> (Vec<f64>, Palette) {
        levels(&self.values, self.limits)
    }

    /// Whether values lie farther beyond the outer levels than the next level would, for which the outer colours stand.
    fn goes_on(&self, levels: &[f64]) -> [bool; 2] {
        let ([first, second, ..], Some(last)) = (levels, levels.last()) else { return [false; 2] };
        let step = (1.0 + ROUNDING) * (second - first);
        let is_beyond = |value: f64| [first - value > step, value - last > step];
        let cut = self
            .values
            .iter()
            .copied()
            .chain(self.largest)
            .filter(|value| !value.is_nan())
            .map(is_beyond);
        cut.fold([false; 2], |[below, above], [low, high]| [below || low, above || high])
    }
}

/// Round levels between values, of which those beyond the limits count as these, and the colours for them.
pub(super) fn levels(values: &[f64], limits: Option<(f64, f64)>) -> (Vec<f64>, Palette) {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let low = finite().fold(f64::INFINITY, f64::min);
    let high = finite().fold(f64::NEG_INFINITY, f64::max);
    let (low, high) = limits.unwrap_or((low, high));
    if low.is_nan() || low >= high || high.is_nan() {
        return (Vec::new(), Palette::Sequential);
    }
    // A small part of the other sign, such as that of rounding, is no reason for two colours.
    let both = low < -0.1 * high.abs() && high > 0.1 * low.abs();
    let reach = high.max(-low);
    // White is zero: as many bands on either side.
    let (low, high) = if both { (-reach, reach) } else { (low, high) };
    let ticks = Ticks::new(Scale::Linear, Range { low, high }, BANDS);
    // A level at an end of the range parts nothing.
    let apart = 1e-9 * (high - low);
    let places = ticks.labelled.into_iter().map(|tick| tick.place);
    let levels = places.filter(|place| *place > low + apart && *place < high - apart).collect();
    let palette = if both {
        Palette::Diverging
    } else if high <= -0.1 * low {
        Palette::Reversed
    } else {
        Palette::Sequential
    };
    (levels, palette)
}

impl Plot for MapPlot {
    fn usual_size(&self) -> Option<Size> {
        Some(self.size())
    }

    fn figure(&self) -> Figure {
        let (levels, palette) = self.levels();
        let contours = Contours {
            x: self.x.clone(),
            y: self.depth.clone(),
            values: self.values.clone(),
            levels: levels.clone(),
            palette,
        };
        let mut layers = vec![Layer::Contours(contours)];
        if !levels.is_empty() {
            let label = self.value_label.clone();
            let goes_on = self.goes_on(&levels);
            layers.push(Layer::ColourBar(ColourBar { label, levels, palette, goes_on }));
        }
        if let (Some(first), Some(last)) = (self.x.first(), self.x.last()) {
            let mut surface = Line::new("", vec![(*first, 0.0), (*last, 0.0)], Colour::INK);
            surface.width = 1.0;
            layers.push(Layer::Line(surface));
        }
        for (index, &[left, right]) in self.zones.iter().enumerate() {
            let name = if index == 0 { "contact" } else { "" };
            let mut zone = Line::new(name, vec![(left, 0.0), (right, 0.0)], Colour::INK);
            zone.width = 6.0;
            zone.sets_range = false;
            layers.push(Layer::Line(zone));
        }
        layers.extend(self.crosses.iter().enumerate().map(|(index, &at)| {
            let name = if index == 0 { self.cross_name.clone() } else { String::new() };
            Layer::Cross(Cross { name, at })
        }));
        let deepest = self.depth.last().copied().unwrap_or(1.0);
        Figure {
            title: self.title.clone(),
            notes: self.notes.clone(),
            panels: vec![Panel::new(
                Axis::linear(&self.position_label),
                Axis::linear(&self.depth_label).reversed().including(-ABOVE * deepest),
                layers,
            )],
            arrangement: Arrangement::Stacked,
            legend: LegendPlace::Panel,
        }
    }
}
