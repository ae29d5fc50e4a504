//! The picture of a contact.

mod sampling;
mod surfaces;
mod words;

use shtaerman::quantity::{Measure, OutputUnits};
use shtaerman::{Contact, Error, Geometry, PressureCurve};

use crate::plot::ContactPlot;
pub(crate) use sampling::{between, refined};
use surfaces::{Surfaces, shifts};
pub(crate) use words::load as said_load;

/// Points of the plotted curves.
const PLOT_POINTS: usize = 401;
/// Parts of a base that are repeated within a window, each with points of its own; of more all of the base has them.
const FEW: usize = 3;
/// Share of a zone beside an infinite pressure that does not set the range of the panel.
const CLIPPED: f64 = 0.02;
/// A contact less wide than this share of the base is shown larger, with its neighbourhood.
const NARROW: f64 = 0.25;
/// That neighbourhood on either side, in widths of the contact.
const BESIDE: f64 = 1.0;
/// Error of the pressure, relative to its largest value, from which on it can be seen in a plot.
const VISIBLE: f64 = 1e-3;

/// What a picture of a contact is to show, beside the contact.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ContactPicture {
    /// Name of the problem, such as that of its file; empty for none.
    pub name: String,
    /// The title in place of one from name, load and largest pressure.
    pub title: Option<String>,
    /// Ends of what is shown, in the units of the problem; by default the whole base, or a contact that is much less wide with its neighbourhood. Beside the base the free surface is
    /// shown, and what is periodic goes on, for some hundred periods at most.
    pub x_range: Option<[f64; 2]>,
    /// Units of the axes.
    pub units: OutputUnits,
}

/// The picture of a contact: its pressure and, below it, the base, the rough layer and the deformed body, in units that suit them.
///
/// # Errors
/// Those of [`PressureCurve::along`].
pub fn contact_plot(contact: &Contact) -> Result<ContactPlot, Error> {
    contact_picture(contact, &ContactPicture::default())
}

/// The same as it is wanted.
///
/// # Errors
/// Those of [`PressureCurve::along`].
pub fn contact_picture(contact: &Contact, wanted: &ContactPicture) -> Result<ContactPlot, Error> {
    let window = wanted.x_range.or_else(|| neighbourhood(contact));
    let curve = curve(contact, window)?;
    let surfaces = Surfaces::new(contact, &curve.x, window);
    let shown = Shown::new(contact, wanted, &curve, &surfaces, window);
    let stated = contact.error();
    let [p, x] = [shown.pressure.factor, shown.length.factor];
    let pressure = surfaces.repeated(&curve.x, &curve.pressure);
    let band = stated.filter(|stated| stated.pressure > VISIBLE * largest(&curve.pressure));
    let banded = |error: f64| {
        pressure
            .iter()
            .map(|(at, value)| (at * x, (value - error) * p, (value + error) * p))
            .collect()
    };
    Ok(ContactPlot {
        title: wanted.title.clone().unwrap_or_else(|| words::title(contact, wanted)),
        notes: words::notes(contact, &wanted.units),
        pressure_band: band.map_or_else(Vec::new, |stated| banded(stated.pressure)),
        band_name: stated
            .map_or_else(String::new, |stated| format!("error ({})", stated.kind.name())),
        largest_shown: largest_shown(contact, &pressure).map(|largest| largest * p),
        pressure: pressure.iter().map(|(at, value)| (at * x, value * p)).collect(),
        punch_base: shown.line(&surfaces.base),
        layer: shown.band(&surfaces.layer),
        layer_name: shown.layer_name(&surfaces, wanted),
        body_surface: shown.line(&surfaces.body),
        edges: surfaces.edges.iter().map(|at| at * x).collect(),
        contact_ends: surfaces.ends(contact).iter().map(|at| at * x).collect(),
        window: Some(window.unwrap_or_else(|| surfaces.reach()).map(|at| at * x)),
        whole: match window {
            Some(window) if surfaces.is_part(window) => {
                shown.whole(contact, wanted, surfaces.reach())
            }
            _ => String::new(),
        },
        length_of_depth: shown.length_of_depth(),
        position_label: shown.length.label.clone(),
        pressure_label: shown.pressure.label.clone(),
        depth_label: shown.depth.label.clone(),
    })
}

/// A contact much less wide than the base, with as much beside it as shows how the surfaces part.
fn neighbourhood(contact: &Contact) -> Option<[f64; 2]> {
    let zones = contact.zones();
    let (left, right) = (zones.first()?[0], zones.last()?[1]);
    let width = right - left;
    let half_width = contact.problem().punch().half_width();
    let is_narrow = width > 0.0 && width < NARROW * 2.0 * half_width;
    is_narrow.then(|| {
        let from = (left - BESIDE * width).max(-half_width);
        let to = (right + BESIDE * width).min(half_width);
        [from, to]
    })
}

/// The pressure from edge to edge, with points enough in the window.
fn curve(contact: &Contact, window: Option<[f64; 2]>) -> Result<PressureCurve, Error> {
    let whole = PressureCurve::along(contact, PLOT_POINTS)?;
    let punch = contact.problem().punch();
    let half_width = punch.half_width();
    let Some([left, right]) = window else {
        return refined(contact, whole, [-half_width, half_width]);
    };
    // The parts of the base that the window shows, wherever they are repeated: a few at most, or all of it.
    let mut parts: Vec<[f64; 2]> = shifts(punch, window)
        .into_iter()
        .map(|shift| [(left - shift).max(-half_width), (right - shift).min(half_width)])
        .filter(|[left, right]| left < right)
        .collect();
    if parts.len() > FEW {
        parts = vec![[-half_width, half_width]];
    }
    let shown = parts.iter().fold([half_width, -half_width], |[from, to], [left, right]| {
        [from.min(*left), to.max(*right)]
    });
    let more = parts.into_iter().flat_map(|[left, right]| {
        let step = (right - left) / PLOT_POINTS as f64;
        (1..PLOT_POINTS).map(move |index| left + step * index as f64)
    });
    let mut places: Vec<f64> = whole.x.iter().copied().chain(more).collect();
    places.retain(|place| place.abs() <= half_width);
    places.sort_by(f64::total_cmp);
    places.dedup();
    refined(contact, PressureCurve::at(contact, places)?, shown)
}

fn largest(values: &[f64]) -> f64 {
    let finite = values.iter().filter(|value| value.is_finite());
    finite.fold(0.0f64, |most, value| most.max(value.abs()))
}

/// The largest pressure away from the places where it is infinite; none where it is finite everywhere.
fn largest_shown(contact: &Contact, pressure: &[(f64, f64)]) -> Option<f64> {
    let infinite = pressure.iter().filter(|point| point.1.is_infinite()).map(|point| point.0);
    let poles: Vec<f64> = infinite.collect();
    let reach = CLIPPED * contact.contact_width();
    let near = |at: f64| poles.iter().any(|pole| (at - pole).abs() < reach);
    let away = pressure.iter().filter(|point| point.1.is_finite() && !near(point.0));
    (!poles.is_empty()).then(|| away.map(|point| point.1.abs()).fold(0.0, f64::max))
}

/// A unit of an axis with its label.
struct Unit {
    factor: f64,
    label: String,
}

/// The units of the axes.
struct Shown {
    length: Unit,
    pressure: Unit,
    depth: Unit,
    is_physical: bool,
}

impl Shown {
    fn new(
        contact: &Contact,
        wanted: &ContactPicture,
        curve: &PressureCurve,
        surfaces: &Surfaces,
        window: Option<[f64; 2]>,
    ) -> Self {
        let problem = contact.problem();
        let is_physical = !problem.is_dimensionless();
        let unit = |largest: f64, measure: Measure, symbol: &str, plain: &str| {
            if is_physical {
                let unit = wanted.units.axis(largest, measure);
                Unit { factor: unit.factor, label: format!("{symbol} [{}]", unit.label) }
            } else {
                Unit { factor: 1.0, label: plain.to_owned() }
            }
        };
        let reach = window
            .map_or(problem.punch().half_width(), |[left, right]| left.abs().max(right.abs()));
        let repeated = surfaces.repeated(&curve.x, &curve.pressure);
        let most = largest_shown(contact, &repeated).unwrap_or_else(|| largest(&curve.pressure));
        let depths = surfaces.depths(window);
        Self {
            length: unit(reach, Measure::Length, "x", "ξ = x/a"),
            pressure: unit(most, Measure::Pressure, "pressure p", "pressure p/E"),
            depth: unit(largest(&depths), Measure::Displacement, "depth", "depth / (χE)"),
            is_physical,
        }
    }

    fn line(&self, points: &[(f64, f64)]) -> Vec<(f64, f64)> {
        points.iter().map(|(x, u)| (x * self.length.factor, u * self.depth.factor)).collect()
    }

    fn band(&self, points: &[(f64, f64, f64)]) -> Vec<(f64, f64, f64)> {
        let depth = self.depth.factor;
        points.iter().map(|(x, u, v)| (x * self.length.factor, u * depth, v * depth)).collect()
    }

    /// A depth of one unit, in units of the position.
    fn length_of_depth(&self) -> Option<f64> {
        self.is_physical.then(|| self.length.factor / self.depth.factor)
    }

    /// What an inset shows around a part: the base between its edges, of what is repeated all that is drawn.
    fn whole(&self, contact: &Contact, wanted: &ContactPicture, reach: [f64; 2]) -> String {
        let punch = contact.problem().punch();
        let is_repeated = matches!(punch.geometry(), Geometry::Periodic { .. });
        if self.is_physical {
            let length = |value| wanted.units.shown_with_digits(value, Measure::Length, 4);
            match reach {
                _ if !is_repeated => {
                    format!("the whole base, to ±{}", length(punch.half_width()))
                }
                [left, right] if left == -right => format!("two periods, to ±{}", length(right)),
                [left, right] => format!("from {} to {}", length(left), length(right)),
            }
        } else {
            "the whole base".to_owned()
        }
    }

    /// What the layer is, and how thick it is drawn where it is free: the model knows only by how much it is compressed.
    fn layer_name(&self, surfaces: &Surfaces, wanted: &ContactPicture) -> String {
        let thickness = match surfaces.thickness {
            Some(thickness) if self.is_physical => {
                wanted.units.shown_with_digits(thickness, Measure::Displacement, 2)
            }
            Some(thickness) => super::significant(thickness, 2),
            None => return String::new(),
        };
        format!("rough layer, drawn {thickness} thick where free")
    }
}
