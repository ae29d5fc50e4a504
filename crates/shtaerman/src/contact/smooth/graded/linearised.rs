//! Smooth contact on graded ground to first order, by its stiffness and the flat pressures on its zones.

use super::field::Field;
use super::stated::GradedContact;
use crate::contact::rates::{Linearised, Rates};
use crate::contact::smooth::told;
use crate::contact::solution::Solution;

/// What the elimination of coupled zones leaves in the densities at their ends, relative to them: beside the width of `0.449*step(x+0.5295)+0.497*x^2` (`mu = 0.141`, force 1.57516) differences of solutions show 2e-11. At half or twice 9 of 14 answers change, within what they state (survey).
const COUPLED: f64 = 1e-10;

impl GradedContact {
    /// The first-order change, the largest pressure being at `peak`.
    pub(super) fn first_order(&self, peak: f64) -> Linearised {
        let load = &self.problem().load;
        let stiffness = self.stiffness();
        let (force, largest) = (self.state().force, self.pressure(peak));
        let of = |prescribed: [f64; 2]| -> [Rates; 2] {
            let [raise, turn] = stiffness.displaced(load, prescribed);
            let force = stiffness.force_settlement * raise + stiffness.coupling * turn;
            let touching = self.fields().iter().find(|field| field.strip.zone.contains(peak));
            let pressure = match touching {
                Some(field) if largest.is_finite() => {
                    field.flat_change(field.place(peak), raise, turn)
                }
                _ => 0.0,
            };
            let coupled = if self.fields().len() > 1 { COUPLED } else { 0.0 };
            let widths = self.fields().iter().map(|field| widening(field, [raise, turn], coupled));
            let [width, error] = widths.fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
            [[raise, force, -turn, pressure, width], [0.0, 0.0, 0.0, 0.0, error]]
        };
        let rates = told::rates(load, [force, largest], |prescribed| of(prescribed)[0]);
        let bounds = told::rates(load, [0.0; 2], |prescribed| of(prescribed)[1]);
        Linearised { rates, errors: bounds.map(|rates| rates.map(f64::abs)) }
    }
}

/// How much wider a zone becomes, and the error of that; with what densities may be off by besides, relative to them.
fn widening(field: &Field, [raise, turn]: [f64; 2], coupled: f64) -> [f64; 2] {
    let zone = field.strip.zone;
    let mut sum = [0.0; 2];
    for side in (0..2).filter(|&side| zone.is_free(side)) {
        let moved =
            field.flat_density(field.place(zone.ends[side]), raise, turn) / field.slopes[side];
        sum[0] += moved;
        sum[1] += moved.abs() * ((field.slope_errors[side] / field.slopes[side]).abs() + coupled);
    }
    sum
}
