//! What the load prescribes, turned into settlement, tilt, force and moment.

use super::stiffness::{Stiffness, cramer};
use crate::{Load, Rotational, Vertical};

/// The linear relation between displacements and forces of a contact on zones that stay: `P = c11 d - c12 alpha - F1`, `M - c P = c12 d - c22 alpha - F2`, (3.7), without dimensions, with the depth
/// `d = delta - alpha c` at a place `c`: about the middle of the base short zones near an edge would lose twice their digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Balance {
    /// `c`.
    pub(super) centre: f64,
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

impl State {
    /// The same with what a load prescribes as given: out of equations it comes with rounding.
    pub(super) fn given(self, load: &Load) -> Self {
        let force = load.vertical.force().unwrap_or(self.force);
        let moment = match load.rotational {
            Rotational::Tilt(_) => self.moment,
            Rotational::Moment(moment) => moment,
            Rotational::Eccentricity(e) => e * force,
        };
        let settlement = load.vertical.settlement().unwrap_or(self.settlement);
        Self { settlement, tilt: load.rotational.tilt().unwrap_or(self.tilt), force, moment }
            .plain()
    }

    /// The same without negative zeros: adding zero turns one into a plain one.
    pub(super) fn plain(self) -> Self {
        Self {
            settlement: self.settlement + 0.0,
            tilt: self.tilt + 0.0,
            force: self.force + 0.0,
            moment: self.moment + 0.0,
        }
    }
}

impl Rotational {
    /// Tilt and moment under a force, of a disk with this `dM0/d(-alpha0)`.
    pub(super) fn turned(self, force: f64, turning: f64) -> [f64; 2] {
        match self {
            // Of rings, which stand level, it is known in the answer only.
            _ if self.named().1 == 0.0 => [0.0; 2],
            Self::Tilt(tilt) => [tilt, -tilt * turning],
            Self::Moment(moment) => [-moment / turning, moment],
            Self::Eccentricity(e) => [-e * force / turning, e * force],
        }
    }
}

impl Balance {
    /// The state under a load.
    pub(super) fn state(&self, load: &Load) -> State {
        self.state_of(load, self.depth_and_tilt(load), [0.0; 2])
    }

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
        cramer([row1, row2], [right1, right2])
    }

    /// The state for a depth and a tilt besides those of a line, its height at the middle and its slope; what the load prescribes comes back as given.
    pub(super) fn state_of(
        &self,
        load: &Load,
        [depth, tilt]: [f64; 2],
        [height, slope]: [f64; 2],
    ) -> State {
        let Stiffness { force_settlement: c11, coupling: c12, moment_tilt: c22 } = self.stiffness;
        let force = load.vertical.force().unwrap_or(c11 * depth - c12 * tilt - self.free[0]);
        let moment = c12 * depth - c22 * tilt - self.free[1] + self.centre * force;
        let settlement = depth + height + (tilt - slope) * self.centre;
        State { settlement, tilt: tilt - slope, force, moment }.given(load)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_prescribed_comes_back_as_given() {
        // Divided by the determinant this tilt was one unit of the machine off, with an error of 0 stated.
        let stiffness = Stiffness {
            force_settlement: 1.188_761_992_637_466,
            coupling: 0.1,
            moment_tilt: 0.405_856_439_910_121_4,
        };
        let balance = Balance { centre: 0.0, stiffness, free: [0.3, -0.2] };
        for i in 1..200 {
            let value = 1.877_74 * f64::from(i) / 7.0;
            let by_force =
                Load { vertical: Vertical::Force(2.877_79), rotational: Rotational::Tilt(value) };
            let state = balance.state(&by_force);
            assert_eq!((state.force, state.tilt), (2.877_79, value));
            let by_settlement =
                Load { vertical: Vertical::Settlement(value), rotational: Rotational::Moment(0.4) };
            let state = balance.state(&by_settlement);
            assert_eq!((state.settlement, state.moment), (value, 0.4));
            let carried = stiffness.force_settlement * value - stiffness.coupling * state.tilt;
            assert!((state.force - (carried - 0.3)).abs() <= 1e-12 * value);
        }
    }
}
