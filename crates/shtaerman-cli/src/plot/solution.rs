//! The solution of an integral equation.

use super::Plot;
use super::axis::Axis;
use super::colour::Colour;
use super::figure::{Arrangement, Band, Figure, Layer, LegendPlace, Line, Mark, Panel, Pole};

/// Share of the interval at an end where the solution is infinite that does not set the range of the plot.
const CLIPPED: f64 = 0.015;

/// One curve over an interval; infinite values at an end are allowed: the curve then runs out of the frame there.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolutionPlot {
    /// Title; empty for none.
    pub title: String,
    /// Notes below the title.
    pub notes: Vec<String>,
    /// The points, from end to end.
    pub points: Vec<(f64, f64)>,
    /// How far the solution may be off, and what this is, such as `error (bound)`; drawn as a band where it can be seen.
    pub error: Option<(f64, String)>,
    /// Ends of what is shown; none for everything.
    pub window: Option<[f64; 2]>,
    /// Label of the horizontal axis.
    pub horizontal_label: String,
    /// Label of the vertical axis.
    pub vertical_label: String,
}

impl Plot for SolutionPlot {
    fn figure(&self) -> Figure {
        let mut layers = vec![Layer::Mark(Mark::horizontal(0.0))];
        let inner = self.inner();
        layers.extend(self.band(inner));
        let is_clipped = inner.len() < self.points.len();
        if is_clipped {
            let mut whole = Line::new("", self.points.clone(), Colour::BLUE);
            whole.sets_range = false;
            layers.push(Layer::Line(whole));
        }
        layers.push(Layer::Line(Line::new("", inner.to_vec(), Colour::BLUE)));
        let infinite = self.points.iter().filter(|point| point.1.is_infinite());
        layers.extend(infinite.enumerate().map(|(index, (at, value))| {
            let name = if index == 0 { "infinite".to_owned() } else { String::new() };
            Layer::Pole(Pole { name, at: *at, colour: Colour::BLUE, is_upward: *value > 0.0 })
        }));
        let mut horizontal = Axis::linear(&self.horizontal_label).between(self.window);
        if let (true, Some(first), Some(last)) =
            (is_clipped, self.points.first(), self.points.last())
        {
            horizontal = horizontal.including(first.0).including(last.0);
        }
        Figure {
            title: self.title.clone(),
            notes: self.notes.clone(),
            panels: vec![Panel::new(
                horizontal,
                Axis::linear(&self.vertical_label).including(0.0),
                layers,
            )],
            arrangement: Arrangement::Stacked,
            legend: LegendPlace::Panel,
        }
    }
}

/// Error, relative to the largest value drawn, from which on it can be seen.
const VISIBLE: f64 = 1e-3;

impl SolutionPlot {
    fn band(&self, inner: &[(f64, f64)]) -> Option<Layer> {
        let (error, name) = self.error.as_ref()?;
        let largest = inner.iter().map(|point| point.1.abs()).filter(|value| value.is_finite());
        let largest = largest.fold(0.0, f64::max);
        (*error > VISIBLE * largest && error.is_finite()).then(|| {
            Layer::Band(Band {
                name: name.clone(),
                points: inner.iter().map(|(x, value)| (*x, value - error, value + error)).collect(),
                colour: Colour::BLUE,
                opacity: 0.22,
            })
        })
    }

    /// The points without the neighbourhood of the ends where the curve is infinite.
    fn inner(&self) -> &[(f64, f64)] {
        let (Some(first), Some(last)) = (self.points.first(), self.points.last()) else {
            return &self.points;
        };
        let share = CLIPPED * (last.0 - first.0);
        let left = if first.1.is_finite() { first.0 } else { first.0 + share };
        let right = if last.1.is_finite() { last.0 } else { last.0 - share };
        let start = self.points.partition_point(|point| point.0 < left);
        let end = self.points.partition_point(|point| point.0 <= right);
        self.points.get(start..end).unwrap_or(&self.points)
    }
}
