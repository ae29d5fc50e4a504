//! How the answer changes with roughness, modulus and load.

mod differences;
mod tangent;

use serde::Serialize;

use crate::{Contact, Error, ErrorKind, Errors, Rotational, Vertical};

/// Derivatives of the answer, by its linearised equation or by central differences of complete solves.
///
/// What [`held`](Self::held) names stays as it is, and so do profile and geometry. The settlement is that in its gauge. Where an edge of the contact
/// is just about to move or the largest pressure to change its place, a derivative has two sides: the linearised equation gives that of the contact as it is, the error of differences
/// is as large as what the sides differ by.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sensitivities {
    /// Always an estimate.
    pub kind: ErrorKind,
    /// `moment`, `eccentricity` or `tilt`: what the load keeps.
    pub held: &'static str,
    /// Of the settlement (m), or of the force (N/m) where the settlement is prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub settlement: Option<Derivatives>,
    /// Of the force (N/m), where the settlement is prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<Derivatives>,
    /// Of the tilt (rad), where it is not prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tilt: Option<Derivatives>,
    /// Of the largest pressure (Pa); without where that is infinite, or the tip of a cusp under a kink.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_pressure: Option<Derivatives>,
    /// Of the width of contact (m).
    pub contact_width: Derivatives,
}

impl Sensitivities {
    /// From the derivatives of settlement, force, tilt, largest pressure and width.
    fn assembled(contact: &Contact, derivatives: [Derivatives; QUANTITIES]) -> Self {
        let [settlement, force, tilt, peak_pressure, contact_width] = derivatives;
        let load = contact.problem().load();
        let by_force = matches!(load.vertical, Vertical::Force(_));
        let by_tilt = matches!(load.rotational, Rotational::Tilt(_));
        Self {
            kind: ErrorKind::Estimate,
            held: load.rotational.named().0,
            settlement: by_force.then_some(settlement),
            force: (!by_force).then_some(force),
            tilt: (!by_tilt).then_some(tilt),
            peak_pressure: contact.has_smooth_peak().then_some(peak_pressure),
            contact_width,
        }
    }

    /// Whether no derivative overflowed.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let Self { settlement, force, tilt, peak_pressure, contact_width, .. } = self;
        let all = [*settlement, *force, *tilt, *peak_pressure, Some(*contact_width)];
        all.into_iter().flatten().all(|derivatives| derivatives.is_finite())
    }
}

impl Derivatives {
    fn is_finite(&self) -> bool {
        let Self { roughness, young_modulus, theta0, force, settlement, profile, error } = *self;
        let all = [roughness, young_modulus, theta0, force, settlement, profile, Some(error)];
        all.into_iter().flatten().all(f64::is_finite)
    }
}

/// Derivatives of one quantity, SI units; of a dimensionless problem without units.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Derivatives {
    /// With respect to `chi` (m/Pa) or the coefficient `B` (m/Pa^kappa).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roughness: Option<f64>,
    /// With respect to Young's modulus of the foundation (Pa); of a graded one that at the depth of 1 m, its `grading_modulus`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub young_modulus: Option<f64>,
    /// With respect to `theta0`, of a dimensionless problem.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub theta0: Option<f64>,
    /// With respect to the force (N/m), where it is prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
    /// With respect to the settlement (m), where it is prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub settlement: Option<f64>,
    /// With respect to the logarithm of the scale of the profile, `d/ds` at `s = 1` for the base `s f(x)`: for the crown `x^2/(2R)` it is `-R d/dR`. By the linearised equation
    /// alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub profile: Option<f64>,
    /// Largest estimated error, relative to the largest elasticity `|d ln q/d ln parameter|` of the quantity (or to 1, if that is larger).
    pub error: f64,
}

/// The quantities followed.
const QUANTITIES: usize = 5;
type Values = [f64; QUANTITIES];

impl Contact {
    /// How settlement (or force), tilt, largest pressure and width change with roughness, Young's modulus and the prescribed force (or settlement): by the
    /// [linearised equation](Self::tangent_sensitivities), or where the method has none by [differences](Self::difference_sensitivities).
    ///
    /// # Errors
    /// Those of the differences.
    pub fn sensitivities(&self) -> Result<Sensitivities, Error> {
        self.tangent_sensitivities().map_or_else(|| self.difference_sensitivities(), Ok)
    }
}

fn values(contact: &Contact) -> Values {
    [
        contact.settlement(),
        contact.force(),
        contact.tilt(),
        contact.peak_pressure(),
        contact.contact_width(),
    ]
}

/// What is stated of their errors, but for the width.
fn errors(contact: &Contact) -> Values {
    let known =
        |errors: Errors| [errors.settlement, errors.force, errors.tilt, errors.pressure, 0.0];
    contact.error().map_or([0.0; QUANTITIES], known)
}
