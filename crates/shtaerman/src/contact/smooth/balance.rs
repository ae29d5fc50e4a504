//! What the load prescribes, about the middle of the zones: about the middle of the base short zones near an edge would lose twice their digits.

use crate::contact::balance::State;
use crate::contact::stiffness::Stiffness;
use crate::{Load, Rotational, Vertical};

/// `P = c11 d - c12 alpha - F1`, `M - c P = c12 d - c22 alpha - F2`, with the depth `d = delta - alpha c` at the middle `c`.
pub(super) struct Centred {
    pub(super) centre: f64,
    pub(super) stiffness: Stiffness,
    /// `F1`, `F2`.
    pub(super) free: [f64; 2],
}

impl Centred {
    /// Depth at the middle and tilt under a load.
    pub(super) fn depth_and_tilt(&self, load: &Load) -> [f64; 2] {
        let Stiffness { force_settlement: c11, coupling: c12, moment_tilt: c22 } = self.stiffness;
        let [force, moment] = self.free;
        let (row1, right1) = match load.vertical {
            Vertical::Force(prescribed) => ([c11, -c12], prescribed + force),
            Vertical::Settlement(prescribed) => ([1.0, self.centre], prescribed),
        };
        // M' + arm P = prescribed
        let turned = |arm: f64, prescribed: f64| {
            ([c12 + arm * c11, -c22 - arm * c12], prescribed + moment + arm * force)
        };
        let (row2, right2) = match (load.rotational, load.vertical) {
            (Rotational::Tilt(prescribed), _) => ([0.0, 1.0], prescribed),
            (Rotational::Moment(prescribed), Vertical::Force(force)) => {
                turned(0.0, prescribed - self.centre * force)
            }
            (Rotational::Moment(prescribed), Vertical::Settlement(_)) => {
                turned(self.centre, prescribed)
            }
            (Rotational::Eccentricity(e), Vertical::Force(force)) => {
                turned(0.0, (e - self.centre) * force)
            }
            (Rotational::Eccentricity(e), Vertical::Settlement(_)) => turned(self.centre - e, 0.0),
        };
        let determinant = row1[0] * row2[1] - row1[1] * row2[0];
        [
            (right1 * row2[1] - row1[1] * right2) / determinant,
            (row1[0] * right2 - right1 * row2[0]) / determinant,
        ]
    }

    /// The state for a depth and a tilt besides those of a line, its height at the middle and its slope; what the load prescribes comes back as given.
    pub(super) fn state_of(
        &self,
        load: &Load,
        [depth, tilt]: [f64; 2],
        [height, slope]: [f64; 2],
    ) -> State {
        let Stiffness { force_settlement: c11, coupling: c12, moment_tilt: c22 } = self.stiffness;
        let force = match load.vertical {
            Vertical::Force(prescribed) => prescribed,
            Vertical::Settlement(_) => c11 * depth - c12 * tilt - self.free[0],
        };
        let moment = match load.rotational {
            Rotational::Moment(prescribed) => prescribed,
            Rotational::Eccentricity(e) => e * force,
            Rotational::Tilt(_) => c12 * depth - c22 * tilt - self.free[1] + self.centre * force,
        };
        let settlement = match load.vertical {
            Vertical::Settlement(prescribed) => prescribed,
            Vertical::Force(_) => depth + height + (tilt - slope) * self.centre,
        };
        let tilt = match load.rotational {
            Rotational::Tilt(prescribed) => prescribed,
            Rotational::Moment(_) | Rotational::Eccentricity(_) => tilt - slope,
        };
        // Adding zero turns a negative zero into a plain one.
        State {
            settlement: settlement + 0.0,
            tilt: tilt + 0.0,
            force: force + 0.0,
            moment: moment + 0.0,
        }
    }

    /// The stiffness about the middle of the base.
    pub(super) fn about_base(&self) -> Stiffness {
        let Stiffness { force_settlement: c11, coupling: c12, moment_tilt: c22 } = self.stiffness;
        let c = self.centre;
        Stiffness {
            force_settlement: c11,
            coupling: c12 + c * c11,
            moment_tilt: c22 + c * (2.0 * c12 + c * c11),
        }
    }
}
