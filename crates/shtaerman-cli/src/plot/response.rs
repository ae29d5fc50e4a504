//! Outputs of a study over one of its varied values.

use super::Plot;
use super::axis::Axis;
use super::colour::Colour;
use super::figure::{Arrangement, Figure, Layer, LegendPlace, Line, Panel};

/// One panel for each output, below each other.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ResponsePlot {
    /// Title; empty for none.
    pub title: String,
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
    /// The points, in the order of the cases.
    pub points: Vec<(f64, f64)>,
}

/// Values whose ends are further apart than this, as a ratio, are drawn on a logarithmic axis.
const DECADES: f64 = 30.0;

impl Plot for ResponsePlot {
    fn figure(&self) -> Figure {
        let values = || self.curves.iter().flat_map(|curve| &curve.points).map(|point| point.0);
        let ends =
            values().fold([f64::INFINITY, 0.0f64], |[low, high], x| [low.min(x), high.max(x)]);
        let horizontal = |label: &str| {
            if ends[0] > 0.0 && ends[1] > DECADES * ends[0] {
                Axis::logarithmic(label)
            } else {
                Axis::linear(label)
            }
        };
        let panel = |curve: &ResponseCurve| {
            let colour = Colour::BLUE;
            let layers = if self.is_connected {
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
            Panel {
                heading: String::new(),
                horizontal: horizontal(&self.horizontal_label),
                vertical: Axis::linear(&curve.label),
                layers,
            }
        };
        Figure {
            title: self.title.clone(),
            notes: Vec::new(),
            panels: self.curves.iter().map(panel).collect(),
            arrangement: Arrangement::Stacked,
            legend: LegendPlace::Panel,
        }
    }
}
