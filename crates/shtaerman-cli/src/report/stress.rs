//! Stresses below the surface as table, JSON, CSV and `NumPy` arrays.

use std::fmt::Write;

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use shtaerman::quantity::Measure;
use shtaerman::{Criterion, FirstYield, Peak, Stress, StressField, Warning, WarningCode};

use super::{Shown, Table, Told, significant};
use crate::arguments::StressComponent;
use crate::output::Content;
use crate::output::npz::{Array, npz};

/// Name of this JSON layout and its version.
const SCHEMA: &str = "shtaerman-stress/2";

/// What is written of a stress, in this order.
const COMPONENTS: [(&str, StressComponent); 10] = [
    ("sigma_x", StressComponent::SigmaX),
    ("sigma_y", StressComponent::SigmaY),
    ("sigma_z", StressComponent::SigmaZ),
    ("tau_xy", StressComponent::TauXy),
    ("sigma_1", StressComponent::Sigma1),
    ("sigma_2", StressComponent::Sigma2),
    ("sigma_3", StressComponent::Sigma3),
    ("max_shear", StressComponent::MaxShear),
    ("tresca", StressComponent::Tresca),
    ("von_mises", StressComponent::VonMises),
];

/// A component of a stress.
#[must_use]
fn component(stress: &Stress, component: StressComponent) -> f64 {
    match component {
        StressComponent::SigmaX => stress.sigma_x,
        StressComponent::SigmaY => stress.sigma_y,
        StressComponent::SigmaZ => stress.sigma_z,
        StressComponent::TauXy => stress.tau_xy,
        StressComponent::Sigma1 => stress.principal()[0],
        StressComponent::Sigma2 => stress.principal()[1],
        StressComponent::Sigma3 => stress.principal()[2],
        StressComponent::MaxShear => stress.max_shear(),
        StressComponent::Tresca => stress.tresca(),
        StressComponent::VonMises => stress.von_mises(),
    }
}

/// Stresses at places, or on a grid row by row from the surface down.
#[derive(Debug)]
pub(crate) struct Stresses {
    /// Positions: of each place, or of the columns of the grid.
    pub(crate) x: Vec<f64>,
    /// Depths: of each place, or of the rows of the grid.
    pub(crate) y: Vec<f64>,
    /// Whether the places are a grid.
    pub(crate) is_grid: bool,
    /// The stresses.
    pub(crate) stresses: Vec<Stress>,
}

impl Stresses {
    /// One component everywhere.
    #[must_use]
    pub(crate) fn values(&self, which: StressComponent) -> Vec<f64> {
        self.stresses.iter().map(|stress| component(stress, which)).collect()
    }

    /// The place of each stress.
    fn places(&self) -> impl Iterator<Item = (f64, f64)> {
        (0..self.stresses.len()).map(|index| {
            if self.is_grid {
                (self.x[index % self.x.len()], self.y[index / self.x.len()])
            } else {
                (self.x[index], self.y[index])
            }
        })
    }
}

impl Serialize for Stresses {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(2 + COMPONENTS.len()))?;
        map.serialize_entry("x", &self.x)?;
        map.serialize_entry("y", &self.y)?;
        for (name, which) in COMPONENTS {
            if self.is_grid {
                map.serialize_entry(name, &Rows { stresses: self, which })?;
            } else {
                map.serialize_entry(name, &Row { stresses: &self.stresses, which })?;
            }
        }
        map.end()
    }
}

/// A component on a grid, a row for each depth.
struct Rows<'a> {
    stresses: &'a Stresses,
    which: StressComponent,
}

impl Serialize for Rows<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let rows = self.stresses.stresses.chunks(self.stresses.x.len());
        serializer.collect_seq(rows.map(|stresses| Row { stresses, which: self.which }))
    }
}

/// A component at places one after the other.
struct Row<'a> {
    stresses: &'a [Stress],
    which: StressComponent,
}

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.stresses.iter().map(|stress| component(stress, self.which)))
    }
}

/// The largest value of an equivalent stress.
#[derive(Debug, Serialize)]
struct PeakReport {
    /// Null where infinite.
    value: f64,
    x: f64,
    y: f64,
    is_corner: bool,
}

impl PeakReport {
    fn new(peak: &Peak, factor: f64) -> Self {
        let Peak { value, x, depth, is_corner } = *peak;
        Self { value: factor * value, x, y: depth, is_corner }
    }
}

#[derive(Debug, Serialize)]
struct Maxima {
    von_mises: PeakReport,
    max_shear: PeakReport,
}

/// The load at first yield by one criterion.
#[derive(Debug, Serialize)]
pub(crate) struct YieldReport {
    criterion: Criterion,
    force: f64,
    error: f64,
    moment: f64,
    factor: f64,
    x: f64,
    y: f64,
    is_corner: bool,
}

impl From<FirstYield> for YieldReport {
    fn from(first: FirstYield) -> Self {
        let FirstYield { criterion, force, error, moment, factor, place } = first;
        let Peak { x, depth, is_corner, .. } = place;
        Self { criterion, force, error, moment, factor, x, y: depth, is_corner }
    }
}

/// What `stress --format json` writes.
#[derive(Debug, Serialize)]
pub(crate) struct StressReport<'a> {
    schema: &'static str,
    units: &'static str,
    #[serde(skip)]
    shown: Shown,
    poisson_ratio: f64,
    force: f64,
    moment: f64,
    zones: Vec<[f64; 2]>,
    /// Where the stress is infinite.
    #[serde(skip)]
    infinite: Vec<f64>,
    period: Option<f64>,
    error: f64,
    nodes: usize,
    maximum: Maxima,
    yield_stress: Option<f64>,
    first_yield: Option<Vec<YieldReport>>,
    warnings: Vec<Warning>,
    points: Option<&'a Stresses>,
    grid: Option<&'a Stresses>,
}

impl<'a> StressReport<'a> {
    /// The report of a field under a force and a moment.
    pub(crate) fn new(
        field: &StressField,
        [force, moment]: [f64; 2],
        shown: Shown,
        peaks: &[Peak; 2],
    ) -> Self {
        Self {
            schema: SCHEMA,
            units: if shown.is_physical { "si" } else { "dimensionless" },
            shown,
            poisson_ratio: field.poisson_ratio(),
            force,
            moment,
            zones: field.zones(),
            infinite: field.infinite_corners(),
            period: field.period(),
            error: field.error(),
            nodes: field.nodes(),
            maximum: Maxima {
                von_mises: PeakReport::new(&peaks[0], 1.0),
                max_shear: PeakReport::new(&peaks[1], 0.5),
            },
            yield_stress: None,
            first_yield: None,
            warnings: Vec::new(),
            points: None,
            grid: None,
        }
    }

    /// Adds what was found for a yield stress, or why nothing was.
    pub(crate) fn set_yield(&mut self, stress: f64, found: Result<Vec<YieldReport>, String>) {
        self.yield_stress = Some(stress);
        match found {
            Ok(loads) => self.first_yield = Some(loads),
            Err(message) => self.warnings.push(Warning { code: WarningCode::NoYield, message }),
        }
    }

    /// Adds what a user should know about the contact.
    pub(crate) fn add_warnings(&mut self, warnings: &[Warning]) {
        self.warnings.extend_from_slice(warnings);
    }

    /// Adds stresses.
    pub(crate) fn set_stresses(&mut self, stresses: &'a Stresses) {
        if stresses.is_grid { self.grid = Some(stresses) } else { self.points = Some(stresses) }
    }

    fn shown(&self, value: f64, measure: Measure) -> String {
        if value.is_finite() { self.shown.value(value, measure) } else { "infinite".to_owned() }
    }
}

/// That no load has a yield stress as its largest equivalent stress.
pub(crate) fn no_yield(yield_stress: f64, nearest: f64, shown: &Shown) -> String {
    format!(
        "no load brings the largest equivalent stress to the yield stress, {}: the nearest is {}; a corner with infinite pressure yields at once, \
         a profile that is forced into contact may yield without any force",
        shown.value(yield_stress, Measure::Pressure),
        shown.value(nearest, Measure::Pressure)
    )
}

/// The maxima, and the load at first yield, for people.
pub(crate) fn stress_table(
    name: &str,
    report: &StressReport<'_>,
    places: Option<&Stresses>,
) -> Told {
    let physical = report.shown.is_physical;
    let units = if physical { "" } else { "; lengths in half-widths, stresses in E" };
    let length = |value| report.shown(value, Measure::Length);
    let stress = |value| report.shown(value, Measure::Pressure);
    let mut text = Told::new(format!(
        "{name}: stresses below the contact, plane strain, tension positive, y is depth{units}\n\n"
    ));
    let mut table = Table::new(&["", "", ""]);
    let mut row = |name: &str, value: String, note: String| {
        table.row(vec![name.to_owned(), value, note]);
    };
    let force = report.shown(report.force, Measure::ForcePerLength);
    let per =
        if report.period.is_some() { "per unit length and period" } else { "per unit length" };
    row("force", force, per.to_owned());
    row("moment", report.shown(report.moment, Measure::MomentPerLength), String::new());
    let zones: Vec<String> = report
        .zones
        .iter()
        .take(6)
        .map(|zone| format!("{} to {}", length(zone[0]), length(zone[1])))
        .collect();
    let more = report.zones.len() - zones.len();
    let more = match more {
        0 => String::new(),
        1 => "and 1 more zone".to_owned(),
        more => format!("and {more} more zones"),
    };
    row("contact", zones.join(", "), more);
    for (name, peak) in [
        ("von Mises, largest", &report.maximum.von_mises),
        ("shear stress, largest", &report.maximum.max_shear),
    ] {
        let place = match report.infinite.as_slice() {
            corners @ [_, ..] if peak.value.is_infinite() => infinite_at(corners, &length),
            _ => place(peak, &length),
        };
        row(name, stress(peak.value), place);
    }
    row("Poisson's ratio", significant(report.poisson_ratio, 6), String::new());
    text.table(table);
    let digits = |value: f64| report.shown.few_digits(value, Measure::Pressure);
    let _ = writeln!(
        text,
        "\nerror (estimate), at most: {}; nodes: {}",
        digits(report.error),
        report.nodes
    );
    if let (Some(limit), Some(loads)) = (report.yield_stress, &report.first_yield) {
        let _ = writeln!(
            text,
            "\nfirst yield at {}, force and moment scaled together (error: estimate):\n",
            stress(limit)
        );
        let mut table =
            Table::new(&["criterion", "force", "error", "moment", "times the load", "where"]);
        for load in loads {
            let peak = PeakReport { value: 0.0, x: load.x, y: load.y, is_corner: load.is_corner };
            let criterion = match load.criterion {
                Criterion::VonMises => "von Mises",
                Criterion::Tresca => "Tresca",
            };
            table.row(vec![
                criterion.to_owned(),
                report.shown(load.force, Measure::ForcePerLength),
                report.shown.few_digits(load.error, Measure::ForcePerLength),
                report.shown(load.moment, Measure::MomentPerLength),
                significant(load.factor, 6),
                place(&peak, &length),
            ]);
        }
        text.table(table);
    }
    if let Some(places) = places {
        text.push('\n');
        let names = COMPONENTS.iter().map(|(name, _)| *name);
        let mut table =
            Table::new(&["x", "y"].into_iter().chain(names).collect::<Vec<_>>()).with_keys(2);
        for ((x, y), at) in places.places().zip(&places.stresses) {
            let values = COMPONENTS.iter().map(|(_, which)| stress(component(at, *which)));
            table.row([length(x), length(y)].into_iter().chain(values).collect());
        }
        text.table(table);
    }
    if !report.warnings.is_empty() {
        text.push('\n');
    }
    for warning in &report.warnings {
        let _ = writeln!(text, "warning: {}", warning.message);
    }
    text
}

/// The corners at which a stress is infinite.
pub(crate) fn infinite_at(corners: &[f64], length: &dyn Fn(f64) -> String) -> String {
    match corners {
        [] => String::new(),
        [x] => format!("at the edge x = {}", length(*x)),
        [x, y] => format!("at the edges x = {} and {}", length(*x), length(*y)),
        [x, .., y] => {
            let count = corners.len();
            format!("at {count} edges, from x = {} to {}", length(*x), length(*y))
        }
    }
}

fn place(peak: &PeakReport, length: &dyn Fn(f64) -> String) -> String {
    let x = length(peak.x);
    if peak.is_corner {
        return format!("at the edge x = {x}, as a limit");
    }
    if peak.y == 0.0 {
        return format!("at x = {x} on the surface");
    }
    format!("at x = {x}, depth {}", length(peak.y))
}

/// One row for each place: `x,y`, then the components; in SI units, or in those chosen.
pub(crate) fn stress_csv<'a>(stresses: &'a Stresses, shown: &Shown) -> Content<'a> {
    let lengths = ["x", "y"].map(|name| shown.column(name, Measure::Length));
    let columns = COMPONENTS.map(|(name, _)| shown.column(name, Measure::Pressure));
    let (length, stress) = (lengths[0].1, columns[0].1);
    let header: Vec<String> = lengths.into_iter().chain(columns).map(|(name, _)| name).collect();
    let rows = stresses.places().zip(&stresses.stresses).map(move |((x, y), at)| {
        let values = COMPONENTS.iter().map(|(_, which)| component(at, *which) * stress);
        // A zero has no sign.
        let numbers = [x * length, y * length].into_iter().chain(values).map(|value| value + 0.0);
        numbers.map(|value| value.to_string()).collect()
    });
    Content::csv(&header, rows)
}

/// `x` and `y` of the grid, and each component with a row for each depth.
pub(crate) fn stress_npz(stresses: &Stresses) -> Content<'_> {
    let lengths = [stresses.y.len(), stresses.x.len()];
    let shape = if stresses.is_grid { &lengths[..] } else { &lengths[..1] };
    let places = [("x", &lengths[1..], &stresses.x), ("y", &lengths[..1], &stresses.y)]
        .map(|(name, shape, values)| Array::numbers(name, shape, values.iter().copied()));
    let components = COMPONENTS.map(|(name, which)| {
        let values = stresses.stresses.iter().map(move |stress| component(stress, which));
        Array::numbers(name, shape, values)
    });
    npz(places.into_iter().chain(components).collect())
}
