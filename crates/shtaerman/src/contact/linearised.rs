//! How a solution changes to first order with the body and the load.

use super::solved::Stiffness;
use crate::{Contact, Load, Rotational, Vertical};

/// Rates of settlement, force, tilt, largest pressure and width of contact, without dimensions.
pub(crate) type Rates = [f64; 5];

/// The derivatives of a solution on zones that stay as they are, with those of its edges.
///
/// Edges may be held still, as the pressure vanishes at a free one: `d/dq int p dx = int dp/dq dx`, and the equation between its ends, too, changes by `dp/dq` alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Linearised {
    /// By `ln theta0` under the same load, by the prescribed force or settlement, by the prescribed moment or tilt; zeros for an eccentricity.
    pub(crate) rates: [Rates; 3],
    /// Estimated errors.
    pub(crate) errors: [Rates; 3],
}

impl Linearised {
    /// With settlement, force and tilt under a changed load by the stiffness of the answer, which a truncated kernel makes its own.
    pub(super) fn with_stiffness(mut self, stiffness: &Stiffness, load: &Load) -> Self {
        let rotates = !matches!(load.rotational, Rotational::Eccentricity(_));
        for (input, prescribed) in [(1, [1.0, 0.0]), (2, [0.0, 1.0])] {
            if input == 1 || rotates {
                let [raise, turn] = stiffness.displaced(load, prescribed);
                let force = stiffness.force_settlement * raise + stiffness.coupling * turn;
                self.rates[input][..3].copy_from_slice(&[raise, force, -turn]);
            }
        }
        self
    }

    fn is_finite(&self) -> bool {
        [self.rates, self.errors].as_flattened().as_flattened().iter().all(|part| part.is_finite())
    }
}

/// Step of the differences that show where the pressure is largest, as a share of its zone, and the longest correction in steps: a longer one is no smooth peak's.
const STEP: f64 = 5e-4;
const LONGEST: f64 = 0.02;
/// Corrections of the place, and the share of a rate there by which it may miss what the place has in error.
const CORRECTIONS: usize = 2;
const MISSED: f64 = 1e-10;

impl Contact {
    /// Where the pressure is largest: a maximum shows its place to the root of rounding only, its slope all of it. With the error it leaves in a rate.
    fn peak_place(&self) -> (f64, f64) {
        let (_, start) = self.peak();
        let zones = self.solution().zones();
        let Some([left, right]) =
            zones.iter().find(|[left, right]| *left < start && start < *right)
        else {
            return (start, 0.0);
        };
        let step = STEP * (right - left);
        let half_width = self.problem().frame().half_width();
        let is_near = |at: f64| (at - start).abs() < 3.0 * step;
        let breaks = self.problem().profile().breakpoints(half_width);
        if is_near(*left) || is_near(*right) || breaks.into_iter().any(is_near) {
            return (start, 0.0);
        }
        let mut place = start;
        for _ in 0..CORRECTIONS {
            let [a, b, c, d, e] =
                [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| self.pressure_at(place + k * step));
            let slope = (8.0 * (d - b) - (e - a)) / 12.0;
            let bend = (16.0 * (d + b) - (e + a) - 30.0 * c) / 12.0;
            let shift = -slope / bend;
            if bend >= 0.0 || shift.is_nan() || shift.abs() > LONGEST {
                return (start, 0.0);
            }
            place += shift * step;
        }
        (place, MISSED)
    }

    /// The error of the solution relative to its size; 0 where the method tells none.
    pub(crate) fn known_to(&self) -> f64 {
        let (peak, _) = self.peak();
        let solution = self.solution();
        let solved = match solution.accuracy() {
            Some(accuracy) if peak.is_finite() => {
                accuracy.relative(&solution.state().sizes(peak.abs()))
            }
            Some(_) => solution.relative_error(),
            None => 0.0,
        };
        solved.max(self.of_heights())
    }

    /// The first-order change, where the method has one.
    pub(crate) fn linearised(&self) -> Option<Linearised> {
        let (place, share) = self.peak_place();
        let mut found = self.solution().linearised(self.solved(), place)?;
        for (rates, errors) in found.rates.iter().zip(&mut found.errors) {
            errors[3] += share * rates[3].abs();
        }
        if self.is_level() {
            for rates in found.rates.iter_mut().chain(&mut found.errors) {
                rates[2] = 0.0;
            }
        }
        found.is_finite().then_some(found)
    }
}

impl Stiffness {
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
        let determinant = row1[0] * row2[1] - row1[1] * row2[0];
        [
            (right1 * row2[1] - row1[1] * right2) / determinant,
            (row1[0] * right2 - right1 * row2[0]) / determinant,
        ]
    }
}

/// All rates of a smooth contact from those by the prescribed quantities, its force and its largest pressure: `theta0` comes with pressures and forces alone,
/// `theta0 K p0 = delta0 - alpha0 xi - f0`.
pub(super) fn smooth_rates(
    load: &Load,
    [force, pressure]: [f64; 2],
    [vertical, rotational]: [Rates; 2],
) -> [Rates; 3] {
    let forced = match load.vertical {
        Vertical::Force(force) => force,
        Vertical::Settlement(_) => 0.0,
    };
    let turned = match load.rotational {
        Rotational::Moment(moment) => moment,
        Rotational::Eccentricity(_) | Rotational::Tilt(_) => 0.0,
    };
    let own = [0.0, force, 0.0, pressure, 0.0];
    let body = std::array::from_fn(|k| forced * vertical[k] + turned * rotational[k] - own[k]);
    [body, vertical, rotational]
}
