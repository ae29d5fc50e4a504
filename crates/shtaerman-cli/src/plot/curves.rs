//! Several curves for ordered values of a parameter, in one or more panels.

use super::Plot;
use super::axis::{Axis, Scale};
use super::colour::Colour;
use super::figure::{Arrangement, Dash, Figure, Layer, LegendPlace, Line, Mark, Panel};

/// How the ordinates of curves of very different sizes are shown.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum CurveScaling {
    /// Linear where the largest curve is at most 100 times the smallest, else symmetric logarithmic
    /// from the size of the smallest curve on, so that signs and all sizes can be seen.
    #[default]
    Automatic,
    /// Linear.
    Linear,
    /// Symmetric logarithmic; see [`Scale::SymmetricLogarithmic`].
    SymmetricLogarithmic {
        /// Where the linear part goes over into the logarithmic one.
        threshold: f64,
    },
    /// Every curve divided by its largest size: shapes can be compared and sizes cannot. The label of
    /// the axis should say so.
    Normalised,
}

/// Families of curves, one family a panel, with one legend for all.
#[derive(Debug, Clone, PartialEq)]
pub struct CurvesPlot {
    /// Title; empty for none.
    pub title: String,
    /// Notes below the title.
    pub notes: Vec<String>,
    /// The panels.
    pub panels: Vec<CurvePanel>,
    /// How the ordinates are shown.
    pub scaling: CurveScaling,
    /// How the panels lie to each other.
    pub arrangement: Arrangement,
    /// Label of the horizontal axis.
    pub horizontal_label: String,
    /// Label of the vertical axis.
    pub vertical_label: String,
}

/// A family of curves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CurvePanel {
    /// Heading; empty for none.
    pub heading: String,
    /// The curves, in the order of their parameter.
    pub curves: Vec<Curve>,
}

/// A named curve.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    /// Name in the legend.
    pub name: String,
    /// The points.
    pub points: Vec<(f64, f64)>,
}

impl Curve {
    /// Largest finite size of the ordinates.
    fn size(&self) -> Option<f64> {
        let sizes = self.points.iter().map(|point| point.1.abs());
        sizes.filter(|size| size.is_finite() && *size > 0.0).reduce(f64::max)
    }
}

impl Plot for CurvesPlot {
    fn figure(&self) -> Figure {
        let scale = self.scale();
        let panels = self.panels.iter().enumerate();
        Figure {
            title: self.title.clone(),
            notes: self.notes.clone(),
            panels: panels.map(|(index, panel)| self.panel(index, panel, scale)).collect(),
            arrangement: self.arrangement,
            legend: LegendPlace::Figure,
        }
    }
}

impl CurvesPlot {
    fn scale(&self) -> Scale {
        match self.scaling {
            CurveScaling::Automatic => self.automatic_scale(),
            CurveScaling::Linear | CurveScaling::Normalised => Scale::Linear,
            CurveScaling::SymmetricLogarithmic { threshold } => {
                Scale::SymmetricLogarithmic { threshold }
            }
        }
    }

    fn automatic_scale(&self) -> Scale {
        let sizes = || self.panels.iter().flat_map(|panel| &panel.curves).filter_map(Curve::size);
        match (sizes().reduce(f64::min), sizes().reduce(f64::max)) {
            (Some(small), Some(large)) if large / small > 100.0 => {
                let threshold = 10f64.powf(small.log10().round());
                Scale::SymmetricLogarithmic { threshold }
            }
            _ => Scale::Linear,
        }
    }

    fn panel(&self, index: usize, panel: &CurvePanel, scale: Scale) -> Panel {
        let shown_before = |wanted: Arrangement| self.arrangement == wanted && index > 0;
        let last = index + 1 == self.panels.len();
        let mut horizontal = Axis::linear(&self.horizontal_label);
        let mut vertical = Axis::with_scale(&self.vertical_label, scale).including(0.0);
        if shown_before(Arrangement::SideBySide) {
            vertical.label.clear();
        }
        if self.arrangement == Arrangement::Stacked && !last {
            horizontal.label.clear();
        }
        let mut layers = vec![Layer::Mark(Mark::horizontal(0.0))];
        let count = panel.curves.len();
        layers.extend(panel.curves.iter().enumerate().map(|(i, curve)| self.line(curve, i, count)));
        Panel { heading: panel.heading.clone(), ..Panel::new(horizontal, vertical, layers) }
    }

    /// Neighbours differ in stroke too, so that they can be told apart without colour.
    fn line(&self, curve: &Curve, index: usize, count: usize) -> Layer {
        const DASHES: [Dash; 3] = [Dash::Solid, Dash::Dashed, Dash::DashDotted];
        let divisor = match self.scaling {
            CurveScaling::Normalised => curve.size().unwrap_or(1.0),
            _ => 1.0,
        };
        let points = curve.points.iter().map(|&(x, y)| (x, y / divisor)).collect();
        let mut line = Line::new(&curve.name, points, Colour::ordered(index, count));
        line.dash = DASHES[index % DASHES.len()];
        line.width = 1.8;
        Layer::Line(line)
    }
}
