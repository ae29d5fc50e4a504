//! Pressure below a punch and the surfaces in contact.

use super::Plot;
use super::axis::Axis;
use super::colour::Colour;
use super::figure::{
    Area, Arrangement, Band, Base, Dash, Figure, Layer, LegendPlace, Line, Mark, Panel,
};

/// Most zones whose ends are marked: of more, the marks would hide the curve.
const MOST_MARKED: usize = 16;

/// A contact: pressure over the position and, below it, the surfaces pressed into each other.
///
/// Depths and displacements count downward, into the body. All numbers are drawn as they are given;
/// the labels name their units. Vectors over the positions that are shorter than `position` end early.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ContactPlot {
    /// Title; empty for none.
    pub title: String,
    /// Notes below the title.
    pub notes: Vec<String>,
    /// Positions along the base of the punch, from edge to edge.
    pub position: Vec<f64>,
    /// Contact pressure at the positions; compression is positive.
    pub pressure: Vec<f64>,
    /// Lower and upper bound of the pressure at the positions.
    pub pressure_band: Option<(Vec<f64>, Vec<f64>)>,
    /// Depth of the punch's base below the undeformed surface at the positions.
    pub punch_base: Vec<f64>,
    /// Surface of the body, below the punch and outside: position and displacement into the body.
    pub body_surface: Vec<(f64, f64)>,
    /// Zones of contact, where they are not the full base.
    pub contact_zones: Vec<[f64; 2]>,
    /// Label of the position, such as `x [mm]`.
    pub position_label: String,
    /// Label of the pressure, such as `p [MPa]`.
    pub pressure_label: String,
    /// Label of the depth, such as `displacement [µm]`.
    pub displacement_label: String,
}

impl Plot for ContactPlot {
    fn figure(&self) -> Figure {
        let mut panels = vec![self.pressure_panel()];
        if !(self.punch_base.is_empty() && self.body_surface.is_empty()) {
            panels[0].horizontal.label.clear();
            panels.push(self.surface_panel());
        }
        Figure {
            title: self.title.clone(),
            notes: self.notes.clone(),
            panels,
            arrangement: Arrangement::Stacked,
            legend: LegendPlace::Panel,
        }
    }
}

impl ContactPlot {
    fn pressure_panel(&self) -> Panel {
        let points = over(&self.position, &self.pressure);
        let mut layers = Vec::new();
        if let Some((lower, upper)) = &self.pressure_band {
            layers.push(Layer::Band(self.band(lower, upper)));
        }
        if points.iter().any(|&(x, p)| x.is_finite() && p < 0.0) {
            layers.push(Layer::Area(Area {
                name: "tension, p < 0".to_owned(),
                points: points.clone(),
                base: Base::NegativeToZero,
                colour: Colour::VERMILION,
                opacity: 0.3,
            }));
        }
        layers.push(Layer::Mark(Mark::horizontal(0.0)));
        layers.extend(self.edges(true));
        layers.push(Layer::Line(Line::new("contact pressure", points, Colour::BLUE)));
        Panel {
            heading: String::new(),
            horizontal: Axis::linear(&self.position_label),
            vertical: Axis::linear(&self.pressure_label).including(0.0),
            layers,
        }
    }

    fn band(&self, lower: &[f64], upper: &[f64]) -> Band {
        let points = self.position.iter().zip(lower).zip(upper);
        Band {
            name: "bounds of the pressure".to_owned(),
            points: points.map(|((&x, &low), &high)| (x, low, high)).collect(),
            colour: Colour::BLUE,
            opacity: 0.22,
        }
    }

    fn surface_panel(&self) -> Panel {
        let base = over(&self.position, &self.punch_base);
        let mut punch = Line::new("base of the punch", base.clone(), Colour::INK);
        punch.dash = Dash::Dashed;
        let body = Line::new(
            "elastic surface of the body (gap: rough layer)",
            self.body_surface.clone(),
            Colour::GREEN,
        );
        let mut layers = vec![
            area(base, Base::Top, Colour::GREY),
            area(self.body_surface.clone(), Base::Bottom, Colour::GREEN),
            Layer::Mark(Mark::horizontal(0.0)),
        ];
        layers.extend(self.edges(false));
        layers.extend([Layer::Line(body), Layer::Line(punch)]);
        Panel {
            heading: String::new(),
            horizontal: Axis::linear(&self.position_label),
            vertical: Axis::linear(&self.displacement_label).including(0.0).reversed(),
            layers,
        }
    }

    /// Marks at the edges of the punch and at the ends of the contact zone.
    fn edges(&self, named: bool) -> Vec<Layer> {
        let finite = || self.position.iter().copied().filter(|x| x.is_finite());
        let ends = finite().reduce(f64::min).zip(finite().reduce(f64::max));
        let mut layers = marks(if named { "edges of the punch" } else { "" }, ends, Dash::Dashed);
        for (index, &[left, right]) in self.contact_zones.iter().take(MOST_MARKED).enumerate() {
            let name = if named && index == 0 { "ends of the contact" } else { "" };
            layers.extend(marks(name, Some((left, right)), Dash::Dotted));
        }
        layers
    }
}

fn over(position: &[f64], values: &[f64]) -> Vec<(f64, f64)> {
    position.iter().copied().zip(values.iter().copied()).collect()
}

fn area(points: Vec<(f64, f64)>, base: Base, colour: Colour) -> Layer {
    Layer::Area(Area { name: String::new(), points, base, colour, opacity: 0.12 })
}

fn marks(name: &str, ends: Option<(f64, f64)>, dash: Dash) -> Vec<Layer> {
    let Some((left, right)) = ends else { return Vec::new() };
    let mark = |name: &str, at| Layer::Mark(Mark { dash, ..Mark::vertical(name, at) });
    vec![mark(name, left), mark("", right)]
}
