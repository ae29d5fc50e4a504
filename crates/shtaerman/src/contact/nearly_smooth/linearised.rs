//! Nearly smooth contact to first order: the rates of its companions, expanded as their values are.

use std::sync::Arc;

use super::answer::NearlySmooth;
use super::companion::{Rough, companion};
use super::fit::{Fitted, Three, beside_limit, through};
use crate::contact::Contact;
use crate::contact::linearised::Linearised;
use crate::contact::solution::Solution;
use crate::{Problem, Rotational, Roughness, Vertical};

/// Index of the largest pressure among the quantities, and of those that are displacements.
const PRESSURE: usize = 3;
const DISPLACEMENTS: [usize; 2] = [0, 2];
/// A peak this close to a mark, in units of the width of its layer, is there.
const AT_MARK: f64 = 10.0;

/// Where the pressure is largest.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Peak {
    Inside,
    Wall,
    Kink,
}

impl NearlySmooth {
    /// The first-order change, the largest pressure being at `place`.
    ///
    /// Each rate follows `q0 + (A ln theta0 + B)/theta0` beside the smooth one, displacements divided by `theta0`. At a kink the smooth pressure has no rate, and the
    /// limit comes from the companions; at a wall the pressure grows as `sqrt(theta0)`, and the solution at this `theta0` has its rate.
    pub(super) fn first_order(&self, problem: &Problem, place: f64) -> Option<Linearised> {
        let direct = || self.pressure.direct.contact.linearised(problem, place);
        let Some(rough) = &self.pressure.companions.rough else { return direct() };
        let peak = self.peak(place);
        let limit = self.smooth_rates(problem)?;
        let of = |rough: &Rough| {
            let solution = Arc::new(rough.contact.clone());
            let contact = Contact::new(&rough.problem, solution, String::new()).ok()?;
            Some((contact.linearised()?, contact.peak().0))
        };
        let values = [of(&rough[0])?, of(&rough[1])?, of(&rough[2])?];
        let (values, peaks) = (values.map(|(rates, _)| rates), values.map(|(_, peak)| peak));
        let at_wall = if peak == Peak::Wall { Some(direct()?) } else { None };
        let (at, theta0) = (self.pressure.companions.at, self.pressure.theta0);
        let mut found = Linearised { rates: [[0.0; 5]; 3], errors: [[0.0; 5]; 3] };
        for input in 0..3 {
            for k in 0..5 {
                if let (PRESSURE, Some(direct)) = (k, &at_wall) {
                    found.rates[input][k] = direct.rates[input][k];
                    found.errors[input][k] = direct.errors[input][k];
                    continue;
                }
                let unit = |theta0: f64| unit(problem, input, k, theta0);
                let rates: Three = [0, 1, 2].map(|i| values[i].rates[input][k] / unit(at[i]));
                let Fitted { value, error } = if k == PRESSURE && peak == Peak::Kink {
                    // Under a kink the pressure grows as ln(theta0), and its rate by that falls as it.
                    let own = if input == 0 { 1.0 } else { 0.0 };
                    let rates = [0, 1, 2].map(|i| rates[i] + own * peaks[i]);
                    let value =
                        through(rates, at, theta0) - own * Solution::pressure(self, problem, place);
                    // What the next term of the series may be beside the last, and rounding of the peaks.
                    let next = at[1].ln() / at[1] * (rates[1] - rates[2]).abs();
                    let rounding = own * rough[2].contact.rounding();
                    Fitted { value, error: next + rounding }
                } else {
                    beside_limit(limit.rates[input][k] / unit(1.0), rates, at, theta0)
                };
                // Errors of the companions fall with their corrections.
                let known = (0..3)
                    .map(|i| values[i].errors[input][k].abs() / unit(at[i]) * at[i] / theta0)
                    .fold(limit.errors[input][k].abs() / unit(1.0), f64::max);
                found.rates[input][k] = value * unit(theta0);
                found.errors[input][k] = (error + known) * unit(theta0);
            }
        }
        Some(found)
    }

    /// The rates of the smooth companion, with `theta0 = 1`.
    fn smooth_rates(&self, problem: &Problem) -> Option<Linearised> {
        let smooth = companion(problem, Roughness::Smooth)?;
        let contact = Arc::new(self.pressure.companions.smooth.clone());
        Contact::new(&smooth, contact, String::new()).ok()?.linearised()
    }

    fn peak(&self, place: f64) -> Peak {
        let is_near = |at: &f64| (at - place).abs() * self.pressure.theta0 < AT_MARK;
        for marks in &self.pressure.marks {
            if let Some(mark) = marks.iter().position(is_near) {
                let is_end = mark == 0 || mark + 1 == marks.len();
                return if is_end { Peak::Wall } else { Peak::Kink };
            }
        }
        Peak::Inside
    }
}

/// What a rate is measured in where displacements are in units of `theta0`.
fn unit(problem: &Problem, input: usize, quantity: usize, theta0: f64) -> f64 {
    let load = problem.load();
    let by_displacement = match input {
        1 => matches!(load.vertical, Vertical::Settlement(_)),
        2 => matches!(load.rotational, Rotational::Tilt(_)),
        _ => false,
    };
    let of = if DISPLACEMENTS.contains(&quantity) { theta0 } else { 1.0 };
    if by_displacement { of / theta0 } else { of }
}
