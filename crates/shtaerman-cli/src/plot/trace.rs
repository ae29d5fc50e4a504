//! A measured trace before and after.

use super::Plot;
use super::axis::Axis;
use super::colour::Colour;
use super::figure::{Arrangement, Dash, Figure, Layer, LegendPlace, Line, Mark, Panel};

/// Most points of a curve: of more the lowest and the highest of each stretch are drawn.
const MOST_POINTS: usize = 4000;

/// A trace as it was read and, below it, as it is used over what it was made from.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TracePlot {
    /// Title; empty for none.
    pub title: String,
    /// Positions and heights as they were read.
    pub before: Vec<(f64, f64)>,
    /// The same in their place and levelled, not yet filtered.
    pub levelled: Vec<(f64, f64)>,
    /// As they are used.
    pub after: Vec<(f64, f64)>,
    /// Ends of the base.
    pub ends: [f64; 2],
    /// Label of the positions.
    pub position_label: String,
    /// Labels of the heights before and after.
    pub height_labels: [String; 2],
}

impl Plot for TracePlot {
    fn figure(&self) -> Figure {
        let line = |name: &str, points: &[(f64, f64)], colour: Colour, width: f64| Line {
            width,
            ..Line::new(name, thinned(points), colour)
        };
        let axis = |points: &[(f64, f64)]| {
            let ends = points.first().zip(points.last()).map(|(first, last)| [first.0, last.0]);
            Axis::linear(&self.position_label).between(ends)
        };
        let [before, after] = &self.height_labels;
        let read = vec![Layer::Line(line("as read", &self.before, Colour::GREY, 1.2))];
        let mut used = Vec::new();
        if self.levelled != self.after {
            let unfiltered = line("before the filter", &self.levelled, Colour::GREY, 0.9);
            used.push(Layer::Line(unfiltered));
        }
        used.push(Layer::Line(line("as used", &self.after, Colour::BLUE, 2.0)));
        let edges = self.ends.iter().enumerate().map(|(index, at)| {
            let name = if index == 0 { "ends of the base" } else { "" };
            Layer::Mark(Mark { dash: Dash::Dashed, ..Mark::vertical(name, *at) })
        });
        used.extend(edges);
        Figure {
            title: self.title.clone(),
            notes: Vec::new(),
            panels: vec![
                Panel::new(axis(&self.before), Axis::linear(before), read),
                Panel::new(axis(&self.after), Axis::linear(after), used),
            ],
            arrangement: Arrangement::Stacked,
            legend: LegendPlace::Panel,
        }
    }
}

/// The lowest and the highest point of each of many stretches.
fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if points.len() <= MOST_POINTS {
        return points.to_vec();
    }
    let stretch = points.len().div_ceil(MOST_POINTS / 2);
    let extremes = |chunk: &[(f64, f64)]| {
        let by_height = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let ends = chunk.iter().min_by(by_height).zip(chunk.iter().max_by(by_height));
        let mut pair: Vec<(f64, f64)> = ends.map_or(Vec::new(), |(low, high)| vec![*low, *high]);
        pair.sort_by(|a, b| a.0.total_cmp(&b.0));
        pair
    };
    points.chunks(stretch).flat_map(extremes).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_traces_keep_their_peaks() {
        let points: Vec<(f64, f64)> = (0..100_000).map(|i| (f64::from(i), 0.0)).collect();
        let mut spiked = points.clone();
        (spiked[12_345].1, spiked[77_777].1) = (5.0, -3.0);
        let drawn = thinned(&spiked);
        assert!(drawn.len() <= MOST_POINTS + 2, "{}", drawn.len());
        assert!(drawn.contains(&(12_345.0, 5.0)) && drawn.contains(&(77_777.0, -3.0)));
        assert_eq!(thinned(&points[..100]), points[..100]);
    }
}
