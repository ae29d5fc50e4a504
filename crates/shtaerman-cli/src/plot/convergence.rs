//! How fast an error falls with the number of terms.

use super::Plot;
use super::axis::Axis;
use super::colour::Colour;
use super::figure::{Arrangement, Dash, Figure, Layer, LegendPlace, Line, Panel};
use super::text::superscript;

/// Differences over the number of terms, both logarithmic, with the slopes `n^-2`, `n^-3`, `n^-4`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ConvergencePlot {
    /// Title; empty for none.
    pub title: String,
    /// Notes below the title.
    pub notes: Vec<String>,
    /// What converges.
    pub series: Vec<ConvergenceSeries>,
    /// Label of the number of terms, such as `n`.
    pub count_label: String,
    /// Label of the differences, such as `difference from the finest`.
    pub difference_label: String,
}

/// One converging quantity.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ConvergenceSeries {
    /// Name in the legend.
    pub name: String,
    /// Numbers of terms.
    pub n: Vec<f64>,
    /// Difference at each; the sign is dropped, and zero is not drawn.
    pub difference: Vec<f64>,
}

impl ConvergenceSeries {
    fn points(&self) -> Vec<(f64, f64)> {
        let pairs = self.n.iter().zip(&self.difference);
        pairs.map(|(&n, &difference)| (n, difference.abs())).collect()
    }
}

impl Plot for ConvergencePlot {
    fn figure(&self) -> Figure {
        let points: Vec<_> = self.series.iter().map(ConvergenceSeries::points).collect();
        let corner = guide_corner(&points.concat());
        let mut layers = Vec::new();
        let mut vertical = Axis::logarithmic(&self.difference_label);
        vertical.include.extend(corner.map(|corner| corner.top));
        for (index, (series, points)) in self.series.iter().zip(points).enumerate() {
            let mut line = Line::new(&series.name, points, Colour::categorical(index));
            line.dots = true;
            layers.push(Layer::Line(line));
        }
        layers.extend(corner.map_or_else(Vec::new, guides));
        Figure {
            title: self.title.clone(),
            notes: self.notes.clone(),
            panels: vec![Panel::new(Axis::logarithmic(&self.count_label), vertical, layers)],
            arrangement: Arrangement::Stacked,
            legend: LegendPlace::Panel,
        }
    }
}

/// Where the guides begin, and the count at which they end.
#[derive(Debug, Clone, Copy)]
struct GuideCorner {
    first: f64,
    last: f64,
    top: f64,
}

/// At the smallest count, far enough above the largest difference to be told from its curve.
fn guide_corner(points: &[(f64, f64)]) -> Option<GuideCorner> {
    let drawable = |v: f64| v > 0.0 && v.is_finite();
    let drawn = || points.iter().copied().filter(|&(n, d)| drawable(n) && drawable(d));
    let corner = drawn().reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))?;
    let last = drawn().map(|(n, _)| n).reduce(f64::max)?;
    Some(GuideCorner { first: corner.0, last, top: 2.5 * corner.1 })
}

/// Lines of slope -2, -3 and -4.
fn guides(corner: GuideCorner) -> Vec<Layer> {
    let GuideCorner { first, last, top } = corner;
    let guide = |(order, dash): (i32, Dash)| {
        let end = top * (first / last).powi(order);
        let name = format!("n{}", superscript(-order));
        let mut line = Line::new(name, vec![(first, top), (last, end)], Colour::GREY);
        line.dash = dash;
        line.width = 1.2;
        line.sets_range = false;
        Layer::Line(line)
    };
    [(2, Dash::Dashed), (3, Dash::DashDotted), (4, Dash::Dotted)].map(guide).into()
}
