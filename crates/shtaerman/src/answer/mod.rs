//! The answer as data: what the faces print and other programs read.

pub mod convergence;
mod cross_check;
pub(crate) mod datum;
mod sense;
mod surface_curve;

pub use cross_check::{CrossCheck, ReferenceError};
pub use datum::{Datum, RelativeSettlement};
pub(crate) use sense::wide_base;
pub use surface_curve::SurfaceCurve;

use serde::Serialize;

use crate::{
    Audit, Complementarity, Contact, Error, ErrorKind, Errors, Foundation, Law, Scaling,
    Sensitivities, Unaudited, Warning,
};

/// Version of the answer's layout; the JSON Schema `schema/answer.schema.json` describes it.
pub const SCHEMA: &str = "shtaerman-answer/2";

/// A solved contact with its pressure at chosen points.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer {
    /// [`SCHEMA`].
    pub schema: &'static str,
    /// `unilateral` or `bilateral`.
    pub contact: &'static str,
    /// Quantities without dimension, (2.5); `null` for a smooth surface, where their scale `chi` is undefined.
    pub dimensionless: Option<Quantities>,
    /// Quantities in SI units; `null` for a dimensionless problem.
    pub physical: Option<Quantities>,
    /// The pressure at points.
    pub pressure: PressureCurve,
    /// The surface under and beside the punch, where asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surface: Option<SurfaceCurve>,
    /// How it was solved.
    pub method: MethodReport,
    /// How sure the answer is.
    pub error: Option<ErrorReport>,
    /// The audit of the answer, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub audit: Option<AuditReport>,
    /// What a unilateral answer leaves of tension and penetration, relative to their scales.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub complementarity: Option<Complementarity>,
    /// Differences from the other method, where asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cross_check: Option<CrossCheck>,
    /// What a user should know.
    pub warnings: Vec<Warning>,
}

/// How an answer was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MethodReport {
    /// `spectral` or `sinc`.
    pub name: &'static str,
    /// Highest Chebyshev degree kept, or number of nodes.
    pub n: usize,
    /// Why this method.
    pub reason: String,
}

/// What an audit says, or why there is none.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AuditReport {
    /// `bound`, `estimate` or `none`.
    pub kind: &'static str,
    /// What it rests on, or why there is none.
    pub reason: String,
    /// What was found.
    #[serde(flatten)]
    pub found: Option<AuditFigures>,
}

/// The figures of an audit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AuditFigures {
    /// The error of the pressure `p/E` in the mean square over the base, where it is finite.
    pub mean_square: Option<f64>,
    /// The norm of the residual.
    pub residual: f64,
    /// Panels of the resampled pressure.
    pub panels: usize,
    /// Windows on which the residual was bounded.
    pub windows: usize,
}

impl AuditReport {
    fn new(audit: &Result<Audit, Unaudited>) -> Self {
        match audit {
            Ok(audit) => Self {
                kind: audit.kind.name(),
                reason: audit.reason.to_owned(),
                found: Some(AuditFigures {
                    mean_square: audit.mean_square,
                    residual: audit.residual,
                    panels: audit.panels,
                    windows: audit.windows,
                }),
            },
            Err(reason) => Self { kind: "none", reason: reason.to_string(), found: None },
        }
    }
}

/// The error of an answer: without dimensions, with a twin in SI units. Only what the load leaves unknown has an entry.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ErrorReport {
    /// `bound` or `estimate`.
    pub kind: ErrorKind,
    /// The errors without dimensions.
    #[serde(flatten)]
    pub dimensionless: Errors,
    /// The errors in SI units; `null` for a dimensionless problem.
    pub physical: Option<Errors>,
}

/// The quantities of a contact in one system of units: those of the problem, or none.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantities {
    /// `2 a/(pi E* chi)`, with quantities without dimensions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub theta0: Option<f64>,
    /// `delta` (m), see `gauge`; `delta/(chi E)`.
    pub settlement: f64,
    /// `alpha` (rad); `a alpha/(chi E)`.
    pub tilt: f64,
    /// `P` (N/m; N under a circular punch); `P/(a E)`.
    pub force: f64,
    /// `M` (N m/m; N m under a circular punch); `M/(a^2 E)`.
    pub moment: f64,
    /// `p` at the left edge of the punch (Pa), 0 where it lifted; `p/E`.
    pub pressure_left: f64,
    /// `p` in the middle (Pa); `p/E`.
    pub pressure_middle: f64,
    /// `p` at the right edge of the punch (Pa), 0 where it lifted; `p/E`.
    pub pressure_right: f64,
    /// `P` over the length of the base, or the area of a circular one (Pa); that over `E`.
    pub mean_pressure: f64,
    /// `P` over the width of the zones, or over their area (Pa); that over `E`.
    pub mean_contact_pressure: f64,
    /// The largest pressure (Pa); `p/E`.
    pub peak_pressure: f64,
    /// Its place (m); `x/a`; of equal ones the leftmost, of -r and r under a circular punch, which are one, either.
    pub peak_pressure_at: f64,
    /// `d(P, M)/d(delta, -alpha)` (Pa, N/m; N/m, N; under a circular punch N/m, N; N, N m).
    pub stiffness: [[f64; 2]; 2],
    /// Zones of contact (m); `x/a`.
    pub zones: Vec<[f64; 2]>,
    /// Width of all zones together (m); in `a`.
    pub contact_width: f64,
    /// What belongs to a physical problem alone.
    #[serde(flatten)]
    pub physical: Option<PhysicalOnly>,
    /// The settlement relative to the data asked for, in the units of the problem.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub relative_settlement: Vec<RelativeSettlement>,
    /// How the answer changes with roughness, modulus (`theta0` of a dimensionless problem) and load, where it was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensitivities: Option<Sensitivities>,
}

/// Quantities in SI units that have no twin without dimensions.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PhysicalOnly {
    /// `E*` (Pa), composite where the punch is elastic.
    pub contact_modulus: f64,
    /// What the settlement is measured against.
    pub gauge: &'static str,
    /// Corner intensities `lim sqrt(2 pi d) p` of a smooth surface, `[left, right]` of each zone (Pa sqrt(m)); 0 at free edges. On graded ground
    /// `lim sqrt(2 pi) d^beta p` (Pa m^beta).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner_intensity: Option<Vec<[f64; 2]>>,
    /// That `beta = (1-mu)/2`, for a smooth surface on graded ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner_exponent: Option<f64>,
    /// Edge pressures `K/sqrt(E* chi)` that the corners of the same contact without roughness imply, `[left, right]` of each of its zones (Pa).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub implied_edge_pressure: Option<Vec<[f64; 2]>>,
}

/// The pressure at points, in SI units or in numbers for a dimensionless problem.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PressureCurve {
    /// Places (m).
    pub x: Vec<f64>,
    /// Pressures (Pa).
    pub pressure: Vec<f64>,
}

impl PressureCurve {
    /// The pressure at `points`, in the units of the contact.
    ///
    /// # Errors
    /// [`Error::BeyondPunch`] for a point that is not on the closed base.
    pub fn at(contact: &Contact, points: Vec<f64>) -> Result<Self, Error> {
        let pressure = points.iter().map(|&x| contact.pressure(x)).collect::<Result<_, _>>()?;
        Ok(Self { x: points, pressure })
    }

    /// The pressure at `count` points from edge to edge, denser at the edges of the punch and of the zones.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for fewer than two points.
    pub fn along(contact: &Contact, count: usize) -> Result<Self, Error> {
        crate::error::require(count >= 2, "points", count as f64, "at least 2")?;
        let half_width = contact.half_width();
        let points = spread(&contact.dimensionless().zones(), count);
        Self::at(contact, points.into_iter().map(|xi| half_width * xi).collect())
    }
}

/// `count` places from -1 to 1, on each zone and on each interval beside as Chebyshev points; on the whole base where they are too few for that.
fn spread(zones: &[[f64; 2]], count: usize) -> Vec<f64> {
    const FEWEST: usize = 4;
    let inside = zones.iter().flatten().copied().filter(|xi| xi.abs() < 1.0);
    let mut ends = crate::order::ascending(inside.chain([-1.0, 1.0]));
    let steps = count - 1;
    if steps < FEWEST * (ends.len() - 1) {
        ends = vec![-1.0, 1.0];
    }
    let mut points = vec![-1.0];
    let spare = steps.saturating_sub(FEWEST * (ends.len() - 1)) as f64;
    let fixed = if ends.len() > 2 { FEWEST } else { 0 };
    let share = |at: f64| {
        if fixed == 0 { steps as f64 * 0.5 * (at + 1.0) } else { spare * 0.5 * (at + 1.0) }
    };
    for (index, pair) in ends.windows(2).enumerate() {
        let upto = share(pair[1]).round() as usize + fixed * (index + 1);
        let inside = upto + 1 - points.len();
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        let places = fredholm::basis::chebyshev::points(inside).into_iter().rev().skip(1);
        points.extend(places.map(|y| (middle + half * y).clamp(pair[0], pair[1])));
        // The ends are exact whatever the sums round to.
        if let Some(last) = points.last_mut() {
            *last = pair[1];
        }
    }
    points
}

impl Answer {
    /// The answer with a pressure curve.
    #[must_use]
    pub fn new(contact: &Contact, pressure: PressureCurve) -> Self {
        let problem = contact.problem();
        let (contact, bare) = (&contact.stated(), contact.dimensionless());
        Self {
            schema: SCHEMA,
            contact: problem.solver().contact.name(),
            dimensionless: (problem.foundation().law() != Law::Smooth)
                .then(|| Quantities { theta0: Some(contact.theta0()), ..Quantities::new(&bare) }),
            physical: (!problem.is_dimensionless()).then(|| Quantities {
                physical: Some(PhysicalOnly::new(contact)),
                ..Quantities::new(contact)
            }),
            pressure,
            surface: None,
            method: MethodReport {
                name: contact.method().name.name(),
                n: contact.method().n,
                reason: contact.reason().to_owned(),
            },
            error: ErrorReport::new(contact),
            audit: contact.audited_by().map(AuditReport::new),
            complementarity: contact.complementarity(),
            cross_check: None,
            warnings: [contact.warnings(), &contact.sense_checks()].concat(),
        }
    }

    /// The answer with settlements relative to these data.
    #[must_use]
    pub fn with_relative_settlement(mut self, relative: Vec<RelativeSettlement>) -> Self {
        match (&mut self.physical, &mut self.dimensionless) {
            (Some(physical), _) => physical.relative_settlement = relative,
            (None, Some(dimensionless)) => dimensionless.relative_settlement = relative,
            (None, None) => {}
        }
        self
    }

    /// The answer with the [edge pressures](Contact::implied_edge_pressures) that corners without roughness imply.
    #[must_use]
    pub fn with_implied_edge_pressure(mut self, implied: Option<Vec<[f64; 2]>>) -> Self {
        if let Some(physical) = self.physical.as_mut().and_then(|known| known.physical.as_mut()) {
            physical.implied_edge_pressure = implied;
        }
        self
    }

    /// The answer with its sensitivities.
    #[must_use]
    pub fn with_sensitivities(mut self, sensitivities: Sensitivities) -> Self {
        match (&mut self.physical, &mut self.dimensionless) {
            (Some(physical), _) => physical.sensitivities = Some(sensitivities),
            (None, Some(dimensionless)) => dimensionless.sensitivities = Some(sensitivities),
            (None, None) => {}
        }
        self
    }
}

impl ErrorReport {
    fn new(contact: &Contact) -> Option<Self> {
        let dimensionless = contact.dimensionless().error()?;
        let physical = if contact.problem().is_dimensionless() { None } else { contact.error() };
        Some(Self { kind: dimensionless.kind, dimensionless, physical })
    }
}

impl Quantities {
    fn new(contact: &Contact) -> Self {
        Self {
            theta0: None,
            settlement: contact.settlement(),
            tilt: contact.tilt(),
            force: contact.force(),
            moment: contact.moment(),
            pressure_left: contact.pressure_left(),
            pressure_middle: contact.pressure_middle(),
            pressure_right: contact.pressure_right(),
            mean_pressure: contact.mean_pressure(),
            mean_contact_pressure: contact.mean_contact_pressure(),
            peak_pressure: contact.peak_pressure(),
            peak_pressure_at: contact.peak_pressure_at(),
            stiffness: contact.stiffness().matrix(),
            zones: contact.zones(),
            contact_width: contact.contact_width(),
            physical: None,
            relative_settlement: Vec::new(),
            sensitivities: None,
        }
    }
}

impl PhysicalOnly {
    fn new(contact: &Contact) -> Self {
        let problem = contact.problem();
        Self {
            contact_modulus: problem.scaling().map_or(0.0, Scaling::contact_modulus),
            gauge: problem.gauge(),
            corner_intensity: contact.corner_intensity(),
            corner_exponent: corner_exponent(problem.foundation()),
            implied_edge_pressure: None,
        }
    }
}

/// `beta` of the corners, where it is not the 1/2 of a homogeneous body.
fn corner_exponent(foundation: &Foundation) -> Option<f64> {
    let is_graded_and_smooth = foundation.grading().is_some() && foundation.law() == Law::Smooth;
    is_graded_and_smooth.then(|| foundation.corner_exponent())
}

#[cfg(test)]
mod tests {
    use super::spread;

    #[test]
    fn places_are_dense_at_the_ends_of_zones() {
        for (zones, count) in [
            (vec![[-1.0, 1.0]], 201),
            (vec![[-0.5, 0.25]], 201),
            (vec![[-1.0, -0.9], [0.3, 1.0]], 51),
            (vec![[-0.5, 0.25]], 5),
            (vec![[-1.0, 1.0]], 2),
        ] {
            let points = spread(&zones, count);
            assert_eq!((points.len(), points[0], points[count - 1]), (count, -1.0, 1.0));
            assert!(points.windows(2).all(|pair| pair[0] < pair[1]), "{points:?}");
            let inside = zones.iter().flatten().filter(|at| at.abs() < 1.0);
            assert!(count < 10 || inside.into_iter().all(|at| points.contains(at)), "{points:?}");
        }
    }
}
