//! How much each varied value matters, as bars.

use super::Plot;
use super::axis::Axis;
use super::colour::Colour;
use super::figure::{Arrangement, Figure, Layer, LegendPlace, Line, Panel};

/// Width of a bar of the first order, and of one with all others.
const WIDTHS: [f64; 2] = [6.0, 14.0];

/// One panel for each output, with a bar for each varied value, the longest on top.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TornadoPlot {
    /// Title; empty for none.
    pub title: String,
    /// Notes below the title.
    pub notes: Vec<String>,
    /// The varied values.
    pub names: Vec<String>,
    /// The outputs.
    pub outputs: Vec<Bars>,
}

/// The bars of one output.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bars {
    /// Its name.
    pub name: String,
    /// Share of the variance that each varied value brings about alone, and together with the others.
    pub shares: Vec<[f64; 2]>,
}

impl Plot for TornadoPlot {
    fn figure(&self) -> Figure {
        let total = |variable: usize| -> f64 {
            let shares = self.outputs.iter().filter_map(|output| output.shares.get(variable));
            shares.map(|share| share[1]).filter(|share| share.is_finite()).sum()
        };
        let mut order: Vec<usize> = (0..self.names.len()).collect();
        order.sort_by(|one, two| total(*two).total_cmp(&total(*one)));
        let names: Vec<String> = order.iter().map(|index| self.names[*index].clone()).collect();
        let panel = |output: &Bars| {
            let mut layers = Vec::new();
            for (kind, name, colour) in [
                (1, "with all others (total)", Colour::GREY),
                (0, "alone (first order)", Colour::BLUE),
            ] {
                for (place, index) in order.iter().enumerate() {
                    let Some(share) = output.shares.get(*index) else { continue };
                    let at = place as f64;
                    let name = if place == 0 { name } else { "" };
                    let mut bar = Line::new(name, vec![(0.0, at), (share[kind], at)], colour);
                    bar.width = WIDTHS[kind];
                    layers.push(Layer::Line(bar));
                }
            }
            let horizontal = Axis::linear("share of the variance").including(0.0).including(1.0);
            let vertical = Axis::of_names(names.clone()).reversed();
            Panel { heading: output.name.clone(), ..Panel::new(horizontal, vertical, layers) }
        };
        Figure {
            title: self.title.clone(),
            notes: self.notes.clone(),
            panels: self.outputs.iter().map(panel).collect(),
            arrangement: Arrangement::Stacked,
            legend: LegendPlace::Figure,
        }
    }
}
