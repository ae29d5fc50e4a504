//! The tangent stiffness.

use crate::{Error, Load, Rotational, Scaling, Vertical};

/// The tangent stiffness `d(P, M)/d(delta, -alpha)`, symmetric positive definite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stiffness {
    /// `dP/d delta` (Pa).
    pub force_settlement: f64,
    /// `dP/d(-alpha) = dM/d delta` (N/m).
    pub coupling: f64,
    /// `dM/d(-alpha)` (N).
    pub moment_tilt: f64,
}

impl Stiffness {
    /// As a matrix, row by row.
    #[must_use]
    pub fn matrix(&self) -> [[f64; 2]; 2] {
        [[self.force_settlement, self.coupling], [self.coupling, self.moment_tilt]]
    }

    /// In the units of the problem.
    pub(crate) fn scaled(&self, scaling: &Scaling) -> Self {
        let (force, moment) = (scaling.force(), scaling.moment());
        let (displacement, angle) = (scaling.displacement(), scaling.angle());
        Self {
            force_settlement: self.force_settlement * force / displacement,
            coupling: self.coupling * force / angle,
            moment_tilt: self.moment_tilt * moment / angle,
        }
    }

    /// Changes of `delta0` and `-alpha0` by those of the prescribed quantities: with an eccentricity the other is that of `M0 - e P0`.
    pub(super) fn displaced(&self, load: &Load, [vertical, rotational]: [f64; 2]) -> [f64; 2] {
        let Self { force_settlement: k11, coupling: k12, moment_tilt: k22 } = *self;
        let (row1, right1) = match load.vertical {
            Vertical::Force(_) => ([k11, k12], vertical),
            Vertical::Settlement(_) => ([1.0, 0.0], vertical),
        };
        let (row2, right2) = match load.rotational {
            Rotational::Moment(_) => ([k12, k22], rotational),
            Rotational::Eccentricity(e) => ([k12 - e * k11, k22 - e * k12], rotational),
            Rotational::Tilt(_) => ([0.0, 1.0], -rotational),
        };
        cramer([row1, row2], [right1, right2])
    }
}

/// The solution of two linear equations.
pub(super) fn cramer([row1, row2]: [[f64; 2]; 2], [right1, right2]: [f64; 2]) -> [f64; 2] {
    let determinant = row1[0] * row2[1] - row1[1] * row2[0];
    [
        (right1 * row2[1] - row1[1] * right2) / determinant,
        (row1[0] * right2 - right1 * row2[0]) / determinant,
    ]
}

/// That the solution of equations with this parameter is one.
///
/// # Errors
/// [`Error::Equation`] for what is not finite.
pub(super) fn require_solved(
    found: impl IntoIterator<Item = f64>,
    parameter: f64,
) -> Result<(), Error> {
    if found.into_iter().all(f64::is_finite) {
        return Ok(());
    }
    Err(Error::Equation(fredholm::Error::Singular { parameter, smallest: 0.0 }))
}
