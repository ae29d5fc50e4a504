//! How a solution changes to first order with the body and the load.

use super::stiffness::Stiffness;
use crate::{Load, Rotational};

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

    pub(super) fn is_finite(&self) -> bool {
        [self.rates, self.errors].as_flattened().as_flattened().iter().all(|part| part.is_finite())
    }
}

/// All rates of a smooth contact from those by the prescribed quantities, its force and its largest pressure: `theta0` comes with pressures and forces alone,
/// `theta0 K p0 = delta0 - alpha0 xi - f0`.
pub(super) fn smooth_rates(
    load: &Load,
    [force, pressure]: [f64; 2],
    [vertical, rotational]: [Rates; 2],
) -> [Rates; 3] {
    let [forced, turned] = load.forces();
    let own = [0.0, force, 0.0, pressure, 0.0];
    let body = std::array::from_fn(|k| forced * vertical[k] + turned * rotational[k] - own[k]);
    [body, vertical, rotational]
}
