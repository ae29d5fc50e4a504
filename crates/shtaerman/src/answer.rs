//! The answer as data: what the faces print and other programs read.

use serde::Serialize;

use crate::audit::{Audit, Unaudited};
use crate::contact::Stiffness;
use crate::{
    Complementarity, Contact, CrossCheck, Error, ErrorKind, Law, RelativeSettlement, Rotational,
    Scaling, Sensitivities, SurfaceCurve, Vertical, Warning,
};

/// Version of the answer's layout; the JSON Schema `schema/answer.schema.json` describes it.
pub const SCHEMA: &str = "shtaerman-answer/1";

/// From this `theta0` on the corners of the smooth companion say something of edge pressures, and up to so many zones it is worth its solve.
const NEARLY_SMOOTH: f64 = 40.0;
const FEW_ZONES: usize = 4;

/// A solved contact with its pressure at chosen points.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer {
    /// [`SCHEMA`].
    pub schema: &'static str,
    /// `unilateral` or `bilateral`.
    pub contact: &'static str,
    /// Quantities without dimension, (2.5); `null` for a smooth surface, where their scale `chi` is undefined.
    pub dimensionless: Option<Dimensionless>,
    /// Quantities in SI units; `null` for a dimensionless problem.
    pub physical: Option<Physical>,
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
    /// The error of the pressure `p/E` in the mean square over the base.
    pub mean_square: f64,
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

/// Errors of the pressure and of the unknowns.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Errors {
    /// Largest error of the pressure on the closed base.
    pub pressure_sup: f64,
    /// Error of the largest pressure, where an audit bounds it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pressure_max: Option<f64>,
    /// Error of the settlement.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub settlement: Option<f64>,
    /// Error of the tilt.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tilt: Option<f64>,
    /// Error of the force.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
    /// Error of the moment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment: Option<f64>,
    /// Error of the edges of the zones.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edges: Option<f64>,
    /// Errors of the entries of the tangent stiffness, where the method tells them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<[[f64; 2]; 2]>,
}

/// Quantities without dimension.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[allow(non_snake_case, reason = "the names of the paper are the names of the interface")]
pub struct Dimensionless {
    /// `2 a/(pi E* chi)`.
    pub theta0: f64,
    /// `P/(a E)`.
    pub P0: f64,
    /// `M/(a^2 E)`.
    pub M0: f64,
    /// `delta/(chi E)`.
    pub delta0: f64,
    /// `a alpha/(chi E)`.
    pub alpha0: f64,
    /// `p/E` at the left edge of the punch; 0 where it lifted.
    pub p0_left: f64,
    /// `p/E` in the middle.
    pub p0_mid: f64,
    /// `p/E` at the right edge of the punch; 0 where it lifted.
    pub p0_right: f64,
    /// Mean of `p/E` over the base.
    pub p0_mean: f64,
    /// The largest `p/E`.
    pub p0_max: f64,
    /// Its place `xi`; of equal ones the leftmost.
    pub p0_max_at: f64,
    /// `d(P0, M0)/d(delta0, -alpha0)`.
    pub stiffness: [[f64; 2]; 2],
    /// Zones of contact, as `xi`.
    pub edges: Vec<[f64; 2]>,
    /// The settlement relative to the data asked for, of a dimensionless problem.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub relative_settlement: Vec<RelativeSettlement>,
    /// How the answer changes with `theta0` and load, of a dimensionless problem; where it was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensitivities: Option<Sensitivities>,
}

/// Quantities in SI units.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Physical {
    /// `delta` (m), see `gauge`.
    pub settlement: f64,
    /// `alpha` (rad).
    pub tilt: f64,
    /// `P` (N/m; N under a circular punch).
    pub force: f64,
    /// `M` (N m/m; N m under a circular punch).
    pub moment: f64,
    /// `p` at the left edge of the punch (Pa).
    pub pressure_left: f64,
    /// `p` in the middle (Pa).
    pub pressure_mid: f64,
    /// `p` at the right edge of the punch (Pa).
    pub pressure_right: f64,
    /// `P` over the length of the base, or the area of a circular one (Pa).
    pub pressure_mean: f64,
    /// The largest pressure (Pa).
    pub pressure_max: f64,
    /// Its place (m); of equal ones the leftmost.
    pub pressure_max_at: f64,
    /// `d(P, M)/d(delta, -alpha)` (Pa, N/m; N/m, N; under a circular punch N/m, N; N, N m).
    pub stiffness: [[f64; 2]; 2],
    /// Zones of contact (m).
    pub edges: Vec<[f64; 2]>,
    /// Width of all zones together (m).
    pub contact_width: f64,
    /// `E*` (Pa), composite where the punch is elastic.
    pub contact_modulus: f64,
    /// What the settlement is measured against.
    pub gauge: &'static str,
    /// The settlement relative to the data asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub relative_settlement: Vec<RelativeSettlement>,
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
    /// How the answer changes with roughness, modulus and load, where it was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensitivities: Option<Sensitivities>,
}

/// The pressure at points.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum PressureCurve {
    /// SI units.
    Physical {
        /// Places (m).
        x: Vec<f64>,
        /// Pressures (Pa).
        p: Vec<f64>,
    },
    /// No dimensions.
    Dimensionless {
        /// Places.
        xi: Vec<f64>,
        /// Pressures over `E`.
        p0: Vec<f64>,
    },
}

impl PressureCurve {
    /// The pressure at `points`, in the units of the problem.
    ///
    /// # Errors
    /// [`Error::BeyondPunch`] for a point that is not on the closed base.
    pub fn at(contact: &Contact, points: Vec<f64>) -> Result<Self, Error> {
        let pressures =
            points.iter().map(|&x| contact.pressure(x)).collect::<Result<Vec<_>, _>>()?;
        Ok(if contact.problem().frame().scaling().is_some() {
            Self::Physical { x: points, p: pressures }
        } else {
            Self::Dimensionless { xi: points, p0: pressures }
        })
    }

    /// The pressure at `count` points from edge to edge, denser at the edges of the punch and of the zones.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for fewer than two points.
    pub fn along(contact: &Contact, count: usize) -> Result<Self, Error> {
        crate::error::require(count >= 2, "points", count as f64, "at least 2")?;
        let half_width = contact.problem().frame().half_width();
        let points = spread(&contact.edges0(), count);
        Self::at(contact, points.into_iter().map(|xi| half_width * xi).collect())
    }

    /// The places, in the units of the problem.
    #[must_use]
    pub fn places(&self) -> &[f64] {
        match self {
            Self::Physical { x, .. } => x,
            Self::Dimensionless { xi, .. } => xi,
        }
    }

    /// The pressures, in the units of the problem.
    #[must_use]
    pub fn pressures(&self) -> &[f64] {
        match self {
            Self::Physical { p, .. } => p,
            Self::Dimensionless { p0, .. } => p0,
        }
    }
}

/// `count` places from -1 to 1, on each zone and on each interval beside as Chebyshev points; on the whole base where they are too few for that.
fn spread(zones: &[[f64; 2]], count: usize) -> Vec<f64> {
    const FEWEST: usize = 4;
    let mut ends: Vec<f64> = zones.iter().flatten().copied().filter(|xi| xi.abs() < 1.0).collect();
    ends.extend([-1.0, 1.0]);
    ends.sort_by(f64::total_cmp);
    ends.dedup();
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
        let physical =
            contact.problem().frame().scaling().is_some().then(|| Physical::new(contact));
        Self {
            schema: SCHEMA,
            contact: contact.problem().solver().contact.name(),
            dimensionless: (contact.problem().frame().law() != Law::Smooth)
                .then(|| Dimensionless::new(contact)),
            physical,
            pressure,
            surface: None,
            method: MethodReport {
                name: contact.method().name,
                n: contact.method().n,
                reason: contact.reason().to_owned(),
            },
            error: ErrorReport::new(contact),
            audit: contact.audited_by().map(AuditReport::new),
            complementarity: contact.complementarity(),
            cross_check: None,
            warnings: contact.warnings().to_vec(),
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
        let accuracy = contact.accuracy()?;
        let load = contact.problem().load();
        let by_force = matches!(load.vertical, Vertical::Force(_));
        let by_tilt = matches!(load.rotational, Rotational::Tilt(_));
        let by_moment = matches!(load.rotational, Rotational::Moment(_));
        let dimensionless = Errors {
            pressure_sup: accuracy.pressure,
            pressure_max: contact.peak_error0(),
            settlement: by_force.then_some(accuracy.settlement),
            tilt: (!by_tilt).then_some(accuracy.tilt),
            force: (!by_force).then_some(accuracy.force),
            moment: (!by_moment).then_some(accuracy.moment),
            edges: contact.edge_error0(),
            stiffness: contact.stiffness_error0().map(|error| error.matrix()),
        };
        let physical =
            contact.problem().frame().scaling().map(|scaling| dimensionless.scaled(scaling));
        Some(Self { kind: accuracy.kind, dimensionless, physical })
    }
}

impl Errors {
    fn scaled(&self, scaling: &Scaling) -> Self {
        Self {
            pressure_sup: self.pressure_sup * scaling.pressure(),
            pressure_max: self.pressure_max.map(|error| error * scaling.pressure()),
            settlement: self.settlement.map(|error| error * scaling.displacement()),
            tilt: self.tilt.map(|error| error * scaling.angle()),
            force: self.force.map(|error| error * scaling.force()),
            moment: self.moment.map(|error| error * scaling.moment()),
            edges: self.edges.map(|error| error * scaling.half_width()),
            stiffness: self.stiffness.map(|[[force_settlement, coupling], [_, moment_tilt]]| {
                let error = Stiffness { force_settlement, coupling, moment_tilt };
                error.scaled(scaling).matrix()
            }),
        }
    }
}

impl Dimensionless {
    fn new(contact: &Contact) -> Self {
        let (p0_max, p0_max_at) = contact.peak_pressure0();
        Self {
            theta0: contact.theta0(),
            P0: contact.force0(),
            M0: contact.moment0(),
            delta0: contact.settlement0(),
            alpha0: contact.tilt0(),
            p0_left: contact.pressure0(-1.0),
            p0_mid: contact.pressure0(0.0),
            p0_right: contact.pressure0(1.0),
            p0_mean: contact.mean_pressure0(),
            p0_max,
            p0_max_at,
            stiffness: contact.stiffness0().matrix(),
            edges: contact.edges0(),
            relative_settlement: Vec::new(),
            sensitivities: None,
        }
    }
}

impl Physical {
    fn new(contact: &Contact) -> Self {
        let (pressure_max, pressure_max_at) = contact.peak_pressure();
        Self {
            settlement: contact.settlement(),
            tilt: contact.tilt(),
            force: contact.force(),
            moment: contact.moment(),
            pressure_left: contact.pressure_left(),
            pressure_mid: contact.pressure_mid(),
            pressure_right: contact.pressure_right(),
            pressure_mean: contact.mean_pressure(),
            pressure_max,
            pressure_max_at,
            stiffness: contact.stiffness().matrix(),
            edges: contact.edges(),
            contact_width: contact.contact_width(),
            contact_modulus: contact
                .problem()
                .frame()
                .scaling()
                .map_or(0.0, Scaling::contact_modulus),
            gauge: contact.problem().frame().gauge(),
            corner_intensity: contact.corner_intensity(),
            corner_exponent: corner_exponent(contact),
            implied_edge_pressure: implied(contact),
            relative_settlement: Vec::new(),
            sensitivities: None,
        }
    }
}

/// `beta` of the corners, where it is not the 1/2 of a homogeneous body.
fn corner_exponent(contact: &Contact) -> Option<f64> {
    let frame = contact.problem().frame();
    let is_graded_and_smooth = frame.grading().is_some() && frame.law() == Law::Smooth;
    is_graded_and_smooth.then(|| frame.corner_exponent())
}

/// Edge pressures that the corners of the smooth companion imply, where the contact has corners and is nearly smooth.
fn implied(contact: &Contact) -> Option<Vec<[f64; 2]>> {
    let ends = contact.edges0();
    let has_corner = ends.iter().flatten().any(|xi| xi.abs() == 1.0);
    let sensible = has_corner && ends.len() <= FEW_ZONES && contact.theta0() >= NEARLY_SMOOTH;
    if sensible { contact.implied_edge_pressures() } else { None }
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
