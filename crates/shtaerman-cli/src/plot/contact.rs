//! Pressure below a punch and the surfaces in contact.

use super::Plot;
use super::axis::Axis;
use super::colour::Colour;
use super::figure::{
    Area, Arrangement, Band, Base, Dash, Figure, Layer, LegendPlace, Line, Mark, Panel, Pole,
};
use super::layout::{BELOW_INSET, BESIDE_INSET};

/// Most ends of zones that are marked: more would hide the curve.
const MOST_MARKED: usize = 32;
/// Room below the deepest point, as a share of the range of depths.
const BELOW: f64 = 0.08;

/// A contact: pressure over the position and, below it, punch, rough layer and body pressed into each other.
///
/// Depths and displacements count downward, into the body. All numbers are drawn as they are given; the labels name their units. A point with a number that
/// cannot be drawn breaks its curve.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ContactPlot {
    /// Title; empty for none.
    pub title: String,
    /// Notes below the title.
    pub notes: Vec<String>,
    /// Position and contact pressure; compression is positive. An infinite one is shown by an arrow.
    pub pressure: Vec<(f64, f64)>,
    /// Position and the least and largest pressure that its stated error allows.
    pub pressure_band: Vec<(f64, f64, f64)>,
    /// What the band is, such as `error (bound)`.
    pub band_name: String,
    /// Where the pressure is infinite somewhere, the size at which the panel is cut.
    pub largest_shown: Option<f64>,
    /// Position and depth of the punch's base.
    pub punch_base: Vec<(f64, f64)>,
    /// Position, and the depths of the upper and lower side of the rough layer.
    pub layer: Vec<(f64, f64, f64)>,
    /// What the layer is, such as `rough layer, drawn 1 µm thick where free`.
    pub layer_name: String,
    /// Surface of the elastic body, below the punch and outside: position and depth.
    pub body_surface: Vec<(f64, f64)>,
    /// Edges of the punch.
    pub edges: Vec<f64>,
    /// Ends of the zones of contact, where they are not edges.
    pub contact_ends: Vec<f64>,
    /// Ends of what is shown; none for everything.
    pub window: Option<[f64; 2]>,
    /// What the whole is called, where that is a part only: an inset shows it.
    pub whole: String,
    /// How many units of the position one of the depth is, where both are lengths.
    pub length_of_depth: Option<f64>,
    /// Label of the position, such as `x [mm]`.
    pub position_label: String,
    /// Label of the pressure, such as `p [MPa]`.
    pub pressure_label: String,
    /// Label of the depth, such as `depth [µm]`.
    pub depth_label: String,
}

impl Plot for ContactPlot {
    fn figure(&self) -> Figure {
        let mut panels = vec![self.pressure_panel()];
        if !(self.punch_base.is_empty() && self.body_surface.is_empty()) {
            panels[0].horizontal.label.clear();
            if !self.whole.is_empty() {
                panels[0].inset = Some(Box::new(self.inset()));
                panels[0].vertical.include.extend(self.highest_beside_inset());
            }
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
        let mut layers = Vec::new();
        if !self.pressure_band.is_empty() {
            layers.push(Layer::Band(Band {
                name: self.band_name.clone(),
                points: self.pressure_band.clone(),
                colour: Colour::BLUE,
                opacity: 0.22,
            }));
        }
        if self.pressure.iter().any(|point| point.1 < 0.0) {
            layers.push(Layer::Area(Area {
                name: "tension, p < 0".to_owned(),
                points: self.cut(),
                base: Base::NegativeToZero,
                colour: Colour::VERMILION,
                opacity: 0.3,
            }));
        }
        layers.push(Layer::Mark(Mark::horizontal(0.0)));
        layers.extend(self.marks(true));
        layers.push(Layer::Line(Line::new("contact pressure", self.cut(), Colour::BLUE)));
        if self.largest_shown.is_some() {
            let mut whole = Line::new("", self.pressure.clone(), Colour::BLUE);
            whole.sets_range = false;
            layers.push(Layer::Line(whole));
        }
        let infinite = self.pressure.iter().filter(|point| point.1.is_infinite());
        layers.extend(infinite.enumerate().map(|(index, &(at, p))| {
            let name = if index == 0 { "infinite".to_owned() } else { String::new() };
            Layer::Pole(Pole { name, at, colour: Colour::BLUE, is_upward: p > 0.0 })
        }));
        let mut vertical = Axis::linear(&self.pressure_label).including(0.0);
        vertical.include.extend(self.largest_shown);
        Panel::new(self.position_axis(), vertical, layers)
    }

    /// The curve without what lies beyond the largest pressure shown.
    fn cut(&self) -> Vec<(f64, f64)> {
        let most = self.largest_shown.unwrap_or(f64::INFINITY);
        let seen = |p: f64| if p.abs() > most { f64::NAN } else { p };
        self.pressure.iter().map(|&(x, p)| (x, seen(p))).collect()
    }

    fn position_axis(&self) -> Axis {
        Axis::linear(&self.position_label).between(self.window)
    }

    fn surface_panel(&self) -> Panel {
        let mut layers = self.bodies(true);
        layers.push(Layer::Mark(Mark::horizontal(0.0)));
        layers.extend(self.marks(false));
        let body = Line { width: 1.4, ..Line::new("", self.body_surface.clone(), Colour::BLUE) };
        let base = Line { width: 1.8, ..Line::new("", self.punch_base.clone(), Colour::INK) };
        layers.extend([Layer::Line(body), Layer::Line(base)]);
        let mut vertical = Axis::linear(&self.depth_label).including(0.0).reversed();
        vertical.include.extend(self.deepest());
        let panel = Panel::new(self.position_axis(), vertical, layers);
        Panel { length_of_height: self.length_of_depth, ..panel }
    }

    /// A place below what is shown, so that there is body to be seen.
    fn deepest(&self) -> Option<f64> {
        let lines = self.punch_base.iter().chain(&self.body_surface);
        let shown = lines.filter(|point| self.is_shown(point.0)).map(|point| point.1);
        let [high, deep] = shown
            .filter(|depth| depth.is_finite())
            .fold([0.0f64, 0.0f64], |[high, deep], depth| [high.min(depth), deep.max(depth)]);
        let below = deep + BELOW * (deep - high);
        below.is_finite().then_some(below)
    }

    fn is_shown(&self, at: f64) -> bool {
        self.window.is_none_or(|[left, right]| (left..=right).contains(&at))
    }

    /// Punch, layer and body as areas.
    fn bodies(&self, named: bool) -> Vec<Layer> {
        let name = |name: &str| if named { name.to_owned() } else { String::new() };
        let mut layers = Vec::new();
        layers.push(Layer::Area(Area {
            name: name("punch"),
            points: self.punch_base.clone(),
            base: Base::Top,
            colour: Colour::PUNCH,
            opacity: 0.5,
        }));
        if !self.layer.is_empty() {
            layers.push(Layer::Band(Band {
                name: name(&self.layer_name),
                points: self.layer.clone(),
                colour: Colour::LAYER,
                opacity: 0.65,
            }));
        }
        layers.push(Layer::Area(Area {
            name: name("elastic body"),
            points: self.body_surface.clone(),
            base: Base::Bottom,
            colour: Colour::BODY,
            opacity: 0.35,
        }));
        layers
    }

    /// What the vertical axis of the pressure must reach so that the curve stays below an inset.
    fn highest_beside_inset(&self) -> Option<f64> {
        let [left, right] = self.window?;
        let from = right - BESIDE_INSET * (right - left);
        let cut = self.cut();
        let below = cut.iter().filter(|(x, p)| (from..=right).contains(x) && p.is_finite());
        let highest = below.map(|point| point.1).fold(0.0, f64::max);
        (highest > 0.0).then_some(highest / BELOW_INSET)
    }

    /// The whole base with the window in it, as an inset.
    fn inset(&self) -> Panel {
        let mut layers = self.bodies(false);
        for at in self.window.into_iter().flatten() {
            let (dash, colour) = (Dash::Solid, Colour::VERMILION);
            layers.push(Layer::Mark(Mark { dash, colour, ..Mark::vertical("", at) }));
        }
        let vertical = Axis::linear("").including(0.0).reversed();
        let ends = self.body_surface.first().zip(self.body_surface.last());
        let ends = ends.map(|(first, last)| [first.0, last.0]);
        let panel = Panel::new(Axis::linear("").between(ends), vertical, layers);
        Panel { heading: self.whole.clone(), ..panel }
    }

    /// Marks at the edges of the punch and at the ends of the contact zones.
    fn marks(&self, named: bool) -> Vec<Layer> {
        let marked = |name: &str, places: &[f64], dash: Dash| -> Vec<Layer> {
            let shown = places.iter().filter(|at| self.is_shown(**at)).enumerate();
            let mark = |(index, at): (usize, &f64)| {
                let name = if named && index == 0 { name } else { "" };
                Layer::Mark(Mark { dash, ..Mark::vertical(name, *at) })
            };
            let layers: Vec<Layer> = shown.map(mark).collect();
            if layers.len() <= MOST_MARKED { layers } else { Vec::new() }
        };
        let mut layers = marked("edges of the punch", &self.edges, Dash::Dashed);
        layers.extend(marked("ends of the contact", &self.contact_ends, Dash::Dotted));
        layers
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_stays_below_an_inset() {
        let plot = ContactPlot {
            window: Some([0.0, 1.0]),
            pressure: vec![(0.0, 9.0), (0.5, 8.0), (0.9, 2.0), (1.0, 1.0)],
            body_surface: vec![(0.0, 0.0), (1.0, 0.0)],
            whole: "the whole base".to_owned(),
            ..ContactPlot::default()
        };
        let included = |plot: &ContactPlot| plot.figure().panels[0].vertical.include.clone();
        assert!(included(&plot).contains(&(2.0 / BELOW_INSET)));
        let bare = ContactPlot { whole: String::new(), ..plot };
        assert!(!included(&bare).contains(&(2.0 / BELOW_INSET)));
    }
}
