//! What the load prescribes, turned into settlement, tilt, force and moment.

use super::solved::Stiffness;
use crate::{Load, Rotational, Vertical};

/// The linear relation between displacements and forces of a bilateral contact: `P = c11 delta - c12 alpha - F1`,
/// `M = c12 delta - c22 alpha - F2`, (3.7), without dimensions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Balance {
    /// `c11`, `c12`, `c22`.
    pub(super) stiffness: Stiffness,
    /// `F1`, `F2`: force and moment of the response to the profile.
    pub(super) free: [f64; 2],
}

/// Settlement, tilt, force and moment without dimensions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct State {
    pub(super) settlement: f64,
    pub(super) tilt: f64,
    pub(super) force: f64,
    pub(super) moment: f64,
}

impl Balance {
    /// The state under a load.
    pub(super) fn state(&self, load: &Load) -> State {
        let [settlement, tilt] = self.displacements(load);
        let [force, moment] = self.forces(load, settlement, tilt);
        // Adding zero turns a negative zero into a plain one.
        State {
            settlement: settlement + 0.0,
            tilt: tilt + 0.0,
            force: force + 0.0,
            moment: moment + 0.0,
        }
    }

    /// Settlement and tilt from the two conditions of the load.
    fn displacements(&self, load: &Load) -> [f64; 2] {
        let Stiffness { force_settlement: c11, coupling: c12, moment_tilt: c22 } = self.stiffness;
        let [force, moment] = self.free;
        let (row1, right1) = match load.vertical {
            Vertical::Force(prescribed) => ([c11, -c12], prescribed + force),
            Vertical::Settlement(prescribed) => ([1.0, 0.0], prescribed),
        };
        let (row2, right2) = match load.rotational {
            Rotational::Moment(prescribed) => ([c12, -c22], prescribed + moment),
            Rotational::Tilt(prescribed) => ([0.0, 1.0], prescribed),
            // M - e P = 0
            Rotational::Eccentricity(e) => ([c12 - e * c11, e * c12 - c22], moment - e * force),
        };
        let determinant = row1[0] * row2[1] - row1[1] * row2[0];
        [
            (right1 * row2[1] - row1[1] * right2) / determinant,
            (row1[0] * right2 - right1 * row2[0]) / determinant,
        ]
    }

    /// Force and moment; what is prescribed comes back as given.
    fn forces(&self, load: &Load, settlement: f64, tilt: f64) -> [f64; 2] {
        let Stiffness { force_settlement: c11, coupling: c12, moment_tilt: c22 } = self.stiffness;
        let force = match load.vertical {
            Vertical::Force(prescribed) => prescribed,
            Vertical::Settlement(_) => c11 * settlement - c12 * tilt - self.free[0],
        };
        let moment = match load.rotational {
            Rotational::Moment(prescribed) => prescribed,
            Rotational::Eccentricity(e) => e * force,
            Rotational::Tilt(_) => c12 * settlement - c22 * tilt - self.free[1],
        };
        [force, moment]
    }
}
