//! What the load prescribes, turned into settlement, tilt, force and moment.

use super::stiffness::Stiffness;
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

impl State {
    /// The same with what a load prescribes as given: out of equations it comes with rounding.
    pub(super) fn given(self, load: &Load) -> Self {
        let (settlement, force) = match load.vertical {
            Vertical::Settlement(settlement) => (settlement, self.force),
            Vertical::Force(force) => (self.settlement, force),
        };
        let (tilt, moment) = match load.rotational {
            Rotational::Tilt(tilt) => (tilt, self.moment),
            Rotational::Moment(moment) => (self.tilt, moment),
            Rotational::Eccentricity(e) => (self.tilt, e * force),
        };
        // Adding zero turns a negative zero into a plain one.
        Self {
            settlement: settlement + 0.0,
            tilt: tilt + 0.0,
            force: force + 0.0,
            moment: moment + 0.0,
        }
    }
}

impl Balance {
    /// The state under a load.
    pub(super) fn state(&self, load: &Load) -> State {
        let [force, moment] = self.free;
        let vertical = match load.vertical {
            Vertical::Force(prescribed) => prescribed + force,
            Vertical::Settlement(prescribed) => prescribed,
        };
        let rotational = match load.rotational {
            Rotational::Moment(prescribed) => prescribed + moment,
            Rotational::Tilt(prescribed) => prescribed,
            Rotational::Eccentricity(e) => moment - e * force,
        };
        let [settlement, turn] = self.stiffness.displaced(load, [vertical, rotational]);
        let State { settlement, tilt, .. } =
            State { settlement, tilt: -turn, force: 0.0, moment: 0.0 }.given(load);
        let Stiffness { force_settlement: c11, coupling: c12, moment_tilt: c22 } = self.stiffness;
        let force = c11 * settlement - c12 * tilt - force;
        let moment = c12 * settlement - c22 * tilt - moment;
        State { settlement, tilt, force, moment }.given(load)
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
        let balance = Balance { stiffness, free: [0.3, -0.2] };
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
