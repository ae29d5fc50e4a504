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
        let mut layers = guides(&points.concat());
        for (index, (series, points)) in self.series.iter().zip(points).enumerate() {
            let mut line = Line::new(&series.name, points, Colour::categorical(index));
            line.dots = true;
            layers.push(Layer::Line(line));
        }
        Figure {
            title: self.title.clone(),
            notes: self.notes.clone(),
            panels: vec![Panel {
                heading: String::new(),
                horizontal: Axis::logarithmic(&self.count_label),
                vertical: Axis::logarithmic(&self.difference_label),
                layers,
            }],
            arrangement: Arrangement::Stacked,
            legend: LegendPlace::Panel,
        }
    }
}

/// Lines of slope -2, -3 and -4 through the corner of the smallest count and the largest difference.
fn guides(points: &[(f64, f64)]) -> Vec<Layer> {
    let drawable = |v: f64| v > 0.0 && v.is_finite();
    let drawn = || points.iter().copied().filter(|&(n, d)| drawable(n) && drawable(d));
    let corner = drawn().reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
    let last = drawn().map(|(n, _)| n).reduce(f64::max);
    let (Some((first, top)), Some(last)) = (corner, last) else { return Vec::new() };
    let guide = |(order, dash): (i32, Dash)| {
        let end = top * (first / last).powi(order);
        let mut line = Line::new(
            format!("n{}", superscript(-order)),
            vec![(first, top), (last, end)],
            Colour::GREY,
        );
        line.dash = dash;
        line.width = 1.2;
        line.sets_range = false;
        Layer::Line(line)
    };
    [(2, Dash::Dashed), (3, Dash::DashDotted), (4, Dash::Dotted)].map(guide).into()
}
