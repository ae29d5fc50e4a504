//! Outputs of a study over one of its varied values.

use super::Plot;
use super::axis::Axis;
use super::colour::Colour;
use super::figure::{
    Arrangement, ColourBar, Contours, Figure, Layer, LegendPlace, Line, Panel, Pole,
};
use super::format::Size;
use super::map::levels;

/// One panel for each output, below each other.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ResponsePlot {
    /// Title; empty for none.
    pub title: String,
    /// What is not drawn, below the title.
    pub notes: Vec<String>,
    /// Label of the varied value.
    pub horizontal_label: String,
    /// Whether the points belong to one curve.
    pub is_connected: bool,
    /// The outputs.
    pub curves: Vec<ResponseCurve>,
}

/// One output.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ResponseCurve {
    /// Label of its axis.
    pub label: String,
    /// The points, in the order of the cases; where the value is infinite the curve runs out of the frame.
    pub points: Vec<(f64, f64)>,
}

/// Heights of the title and of a panel of a map, and panels for which there is room.
const TITLE: u32 = 60;
const PANEL: u32 = 280;
const MOST_PANELS: usize = 12;
/// Values whose ends are further apart than this, as a ratio, are drawn on a logarithmic axis.
const DECADES: f64 = 30.0;

/// A linear axis, or a logarithmic one for positive values that are far apart.
fn axis(label: &str, values: impl Iterator<Item = f64>) -> Axis {
    let [low, high] =
        values.fold([f64::INFINITY, 0.0f64], |[low, high], x| [low.min(x), high.max(x)]);
    if low > 0.0 && high > DECADES * low { Axis::logarithmic(label) } else { Axis::linear(label) }
}

impl Plot for ResponsePlot {
    fn figure(&self) -> Figure {
        let values = self.curves.iter().flat_map(|curve| &curve.points).map(|point| point.0);
        let horizontal = axis(&self.horizontal_label, values);
        let panel = |(index, curve): (usize, &ResponseCurve)| {
            let mut horizontal = horizontal.clone();
            // All have the same places along.
            if index + 1 < self.curves.len() {
                horizontal.label.clear();
            }
            let colour = Colour::BLUE;
            let mut layers = if self.is_connected {
                vec![Layer::Line(Line::new("", curve.points.clone(), colour))]
            } else {
                // Each point as a line of its own: nothing lies between them.
                let dot = |point: &(f64, f64)| {
                    let mut line = Line::new("", vec![*point], colour);
                    line.dots = true;
                    Layer::Line(line)
                };
                curve.points.iter().map(dot).collect()
            };
            let infinite = curve.points.iter().filter(|point| point.1.is_infinite());
            layers.extend(infinite.enumerate().map(|(index, &(at, value))| {
                let name = if index == 0 { "infinite".to_owned() } else { String::new() };
                Layer::Pole(Pole { name, at, colour, is_upward: value > 0.0 })
            }));
            Panel::new(horizontal, Axis::linear(&curve.label), layers)
        };
        Figure {
            title: self.title.clone(),
            notes: self.notes.clone(),
            panels: self.curves.iter().enumerate().map(panel).collect(),
            arrangement: Arrangement::Stacked,
            legend: LegendPlace::Panel,
        }
    }
}

/// Outputs over two varied values, as bands of colour; one panel for each output.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ResponseMap {
    /// Title; empty for none.
    pub title: String,
    /// Labels of the two varied values, along and up.
    pub labels: [String; 2],
    /// Their values.
    pub values: [Vec<f64>; 2],
    /// The outputs.
    pub surfaces: Vec<ResponseSurface>,
}

/// One output over the grid.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ResponseSurface {
    /// Name and unit.
    pub label: String,
    /// Values, one row for each of the values up.
    pub values: Vec<f64>,
}

impl ResponseMap {
    /// A picture with room for each panel.
    #[must_use]
    pub fn size(&self) -> Size {
        let usual = Size::default();
        let height = TITLE + PANEL * self.surfaces.len().min(MOST_PANELS) as u32;
        Size { height: height.max(usual.height), ..usual }
    }
}

impl Plot for ResponseMap {
    fn usual_size(&self) -> Option<Size> {
        Some(self.size())
    }

    fn figure(&self) -> Figure {
        let [x, y] = &self.values;
        let panel = |surface: &ResponseSurface| {
            let (levels, palette) = levels(&surface.values, None);
            let contours = Contours {
                x: x.clone(),
                y: y.clone(),
                values: surface.values.clone(),
                levels: levels.clone(),
                palette,
            };
            // The heading names it.
            let label = String::new();
            let goes_on = [false; 2];
            let bar = (!levels.is_empty()).then_some(ColourBar { label, levels, palette, goes_on });
            let layers = std::iter::once(Layer::Contours(contours))
                .chain(bar.map(Layer::ColourBar))
                .collect();
            let horizontal = axis(&self.labels[0], x.iter().copied());
            let vertical = axis(&self.labels[1], y.iter().copied());
            Panel { heading: surface.label.clone(), ..Panel::new(horizontal, vertical, layers) }
        };
        Figure {
            title: self.title.clone(),
            notes: Vec::new(),
            panels: self.surfaces.iter().map(panel).collect(),
            arrangement: Arrangement::Stacked,
            legend: LegendPlace::Panel,
        }
    }
}
