//! The linearised equation on the zones of a solution: how everything changes with the body and the load.
//!
//! `law(p0) + theta0 K p0 = delta0 - alpha0 xi - f0` is written for the displacement `v` of the layer, `p0 = p(v)`: for a law that bends `dlaw/dp0` is infinite at a free edge, but
//! `p'(v)` vanishes there. Changed by a parameter on zones that stay,
//!
//! `v' + theta0 K(p'(v) v') = delta0' - alpha0' xi - (theta0)'/theta0 * theta0 K p0`,
//!
//! a sum of the responses to `-theta0 K p0`, to 1 and to `-y`. What a free edge `e` adds is of second order, as the pressure vanishes there; it moves by `e' = -v'/(dv/dxi)`.

use std::f64::consts::TAU;

use super::frame::{Direction, Frame};
use super::nodes::{Field, Response};
use super::solved::Solved;
use super::surface::Surface;
use crate::contact::accuracy::{ROUNDING, SAFETY};
use crate::contact::rates::{Linearised, Rates};
use crate::contact::resolutions::{Trust, left_by_collocation};
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::{Error, Load};

/// The first-order changes by the three inputs, each with what is rounding of it.
pub(super) type Changes = [[Rates; 2]; 3];

/// A resolution of a solution.
pub(super) struct Known<'k, F> {
    pub(super) frame: Frame,
    pub(super) parts: &'k [Response<F>; 3],
    /// `theta0 K p0`.
    pub(super) displacement: &'k dyn Fn(f64) -> f64,
    /// Where the pressure is largest, and `dp0/dv` there.
    pub(super) peak: (f64, f64),
}

impl<F: Field> Known<'_, F> {
    /// What the layer answers at a place.
    pub(super) fn layer(&self, xi: f64) -> [f64; 3] {
        let right = [-(self.displacement)(xi), 1.0, -self.frame.local(xi)];
        [0, 1, 2].map(|k| right[k] - self.parts[k].field.at(xi))
    }

    /// The changes by `ln theta0` and by what is prescribed; none by an eccentricity, nor by a tilt that cannot be.
    pub(super) fn changes(&self, solved: Option<(&Solved<F>, &Surface)>) -> Result<Changes, Error> {
        let edges = solved.map_or_else(Vec::new, |(solved, surface)| self.edges(solved, surface));
        let is_disk = solved.is_some_and(|(solved, _)| solved.ground.is_disk());
        let (at, modulus) = self.peak;
        let at_peak = self.layer(at);
        let [body, frame @ ..] = self.parts.each_ref().map(|part| part.carried);
        let (body, frame) =
            (Direction { local: [0.0; 2], carried: body }, Direction::of_local(frame));
        let change = |share: f64, values: [f64; 2]| -> Result<[Rates; 2], Error> {
            let wanted = self.frame.conditions_for(values);
            let [raise, turn] = self.frame.met(&frame, (share, &body), wanted)?;
            let sum = [(share, body), (raise, frame[0]), (turn, frame[1])];
            let of = |layer: &[f64; 3]| -> f64 {
                sum.iter().zip(layer).map(|((factor, _), part)| factor * part).sum()
            };
            let parts = sum.iter().zip(self.parts);
            let noise: f64 = parts.map(|((factor, _), part)| factor.abs() * part.noise).sum();
            let (mut width, mut width_noise) = (0.0, 0.0);
            // An image on the other side of the axis moves along.
            let sides = if is_disk { 2.0 } else { 1.0 };
            for edge in &edges {
                let [moved, off] = edge.moved_by(&of, noise);
                width += sides * moved;
                width_noise += sides * off;
            }
            let state = self.frame.changes(&Direction::sum(&sum));
            let rates = [state.settlement, state.force, state.tilt, modulus * of(&at_peak), width];
            Ok([rates, [0.0, 0.0, 0.0, modulus * noise, width_noise]])
        };
        let none = [[0.0; 5]; 2];
        let rotates = self.frame.rotates();
        Ok([
            change(1.0, [0.0, 0.0])?,
            change(0.0, [1.0, 0.0])?,
            if rotates { change(0.0, [0.0, 1.0])? } else { none },
        ])
    }
}

/// The first-order change of a solution whose largest pressure is at `peak`; none where no coarser one tells its error.
pub(super) fn linearised<F: Field>(
    solved: &Solved<F>,
    surface: &Surface,
    load: Load,
    peak: f64,
) -> Option<Linearised> {
    let height = surface.height(peak);
    let changes = |solved: &Solved<F>| -> Option<Changes> {
        let known = Known {
            frame: solved.nodes.frame.under(load),
            parts: solved.responses.as_ref()?,
            displacement: &|xi| solved.displacement(xi),
            peak: (peak, solved.layer.slope(solved.layer_at(peak, height))),
        };
        known.changes(Some((solved, surface))).ok()
    };
    let levels = solved.coarser.iter().chain([solved]);
    let levels: Vec<Changes> = levels.filter_map(changes).collect();
    let Linearised { rates, mut errors } = compared(&levels, F::RATIO)?;
    let left = SAFETY * left_by_answer(solved);
    for (errors, rates) in errors.iter_mut().zip(&rates) {
        errors.iter_mut().zip(rates).for_each(|(error, rate)| *error += left * rate.abs());
    }
    Some(Linearised { rates, errors })
}

/// What an answer that is off leaves of what responses carry, as a share. A free end that is off by `e` changes what a response `v_j` carries against another by `e v_j v_k` (Hadamard's formula). Beside a free end a layer that bends
/// carries nothing, but its slope `dp/dv`, a power of the pressure, is off by `1 - kappa` times the share by which the pressure is.
fn left_by_answer<F: Field>(solved: &Solved<F>) -> f64 {
    if !solved.layer.is_linear() {
        return (1.0 - solved.layer.exponent()) * solved.noise();
    }
    let (off, frame) = (solved.ends_off(), &solved.nodes.frame);
    let Some(responses) = solved.responses.as_ref().filter(|_| off > 0.0) else { return 0.0 };
    let is_disk = solved.ground.is_disk();
    let gained = |k: usize, right: &dyn Fn(f64) -> f64| -> f64 {
        let ends = solved.nodes.zones.iter().flat_map(Zone::free_ends);
        let of_end = |(_, at): (usize, f64)| {
            let around = if is_disk { TAU * at.abs() } else { 1.0 };
            around * (right(at) - responses[k].field.at(at)).powi(2)
        };
        off * ends.map(of_end).sum::<f64>()
    };
    let level = gained(1, &|_| 1.0) / responses[1].carried[0].abs();
    let turned =
        gained(2, &|at| -frame.local(at)) * frame.hull.half / responses[2].carried[1].abs();
    // The gauge takes its part of the force.
    let by_gauge = (solved.stiffness().force_settlement / responses[1].carried[0]).abs().max(1.0);
    by_gauge * if frame.turns { level.max(turned) } else { level }
}

/// The last of two resolutions with its difference from the one before, of three with what is left of these, whose nodes may grow by a ratio.
pub(super) fn compared(levels: &[Changes], ratio: Option<f64>) -> Option<Linearised> {
    let [.., before, last] = levels else { return None };
    let first = levels.len().checked_sub(3).and_then(|first| levels.get(first));
    let errors: [Rates; 3] = std::array::from_fn(|input| {
        let of = |level: &Changes, k: usize| level[input][0][k];
        let mut errors: Rates = std::array::from_fn(|k| {
            let change = (of(last, k) - of(before, k)).abs();
            let left = match first {
                Some(first) => {
                    let scale = of(last, k).abs().max(f64::MIN_POSITIVE);
                    let earlier = (of(before, k) - of(first, k)).abs();
                    left([earlier, change], scale, ratio)
                }
                None => SAFETY * change,
            };
            left + last[input][1][k]
        });
        // One of settlement and tilt may agree by chance.
        let displacement = errors[0].max(errors[2]);
        for k in [0, 2] {
            errors[k] = if errors[k] > 0.0 { displacement } else { 0.0 };
        }
        errors
    });
    let rates = last.map(|[rates, _]| rates);
    Some(Linearised { errors: with_that_of_displacements(&rates, errors), rates })
}

/// The pressure at one place may agree by chance as well: it is known to no smaller a share than displacements and force, of which one is no part of the load.
fn with_that_of_displacements(rates: &[Rates; 3], mut errors: [Rates; 3]) -> [Rates; 3] {
    let largest =
        |of: &[Rates; 3], k: usize| of.iter().fold(0.0f64, |most, r| most.max(r[k].abs()));
    let share = |k: &[usize]| {
        let [error, size] =
            [&errors, rates].map(|of| k.iter().map(|k| largest(of, *k)).sum::<f64>());
        if size > 0.0 { error / size } else { 0.0 }
    };
    let share = share(&[0, 2]).max(share(&[1]));
    for (errors, rates) in errors.iter_mut().zip(rates) {
        errors[3] = errors[3].max(share * rates[3].abs());
    }
    errors
}

/// What is left of a quantity of this size after two differences, of nodes that may grow by a ratio.
fn left([earlier, change]: [f64; 2], scale: f64, ratio: Option<f64>) -> f64 {
    match ratio {
        Some(ratio) => left_by_collocation([earlier, change], scale, ratio),
        None => Trust::plain(false).left([earlier, change], scale).max(SAFETY * change),
    }
}

/// The error of the stiffness: for all entries the largest difference from a coarser resolution, as one may be nothing by chance; of panels all of them may be.
pub(super) fn stiffness_error<F: Field>(solved: &Solved<F>) -> Option<Stiffness> {
    let known = solved.coarser.iter().chain([solved]).filter(|level| level.responses.is_some());
    let known: Vec<[[f64; 2]; 2]> = known.map(|level| level.stiffness().matrix()).collect();
    let [.., before, last] = &known[..] else { return None };
    let difference = |one: &[[f64; 2]; 2], other: &[[f64; 2]; 2]| {
        let entries = one.as_flattened().iter().zip(other.as_flattened());
        entries.fold(0.0f64, |most, (a, b)| most.max((a - b).abs()))
    };
    let (largest, change) = (difference(last, &[[0.0; 2]; 2]), difference(last, before));
    let error = match &known[..] {
        [first, _, _] if F::RATIO.is_none() => {
            left([difference(before, first), change], largest, None)
        }
        _ => SAFETY * change,
    };
    let error = error.max(ROUNDING * largest) + SAFETY * left_by_answer(solved) * largest;
    Some(Stiffness { force_settlement: error, coupling: error, moment_tilt: error })
}
