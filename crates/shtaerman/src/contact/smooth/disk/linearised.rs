//! A smooth disk of contact to first order: what a flat base of its radius adds.

use super::SmoothDiskContact;
use crate::Rotational;
use crate::contact::rates::{Linearised, Rates, smooth_rates};

impl SmoothDiskContact {
    /// The first-order change, the largest pressure being at `peak`.
    pub(super) fn first_order(&self, peak: f64) -> Linearised {
        let load = &self.problem().load;
        let (field, stiffness) = (self.field(), self.stiffness0());
        let largest = self.pressure0(peak);
        let finite = if largest.is_finite() { largest } else { 0.0 };
        let of = |prescribed: [f64; 2]| -> Rates {
            let [raise, turn] = stiffness.displaced(load, prescribed);
            let pressure = if largest.is_finite() { field.flat(peak, raise, turn) } else { 0.0 };
            // A free edge follows the depth.
            let width = if field.is_free { 2.0 * raise / field.transform.end_slope() } else { 0.0 };
            [raise, stiffness.force_settlement * raise, -turn, pressure, width]
        };
        let rotates = !matches!(load.rotational, Rotational::Eccentricity(_));
        let turned = if rotates { of([0.0, 1.0]) } else { [0.0; 5] };
        let rates = smooth_rates(load, [self.force0(), finite], [of([1.0, 0.0]), turned]);
        Linearised { rates, errors: [[0.0; 5]; 3] }
    }
}
