//! The free ends of the zones, where the corner intensity vanishes.
//!
//! The pressure that an end gains when it moves is a solution without load, singular as `d^(-3/2)` with the intensity there as factor. Where the
//! intensities vanish there is none, so each depends on its own end only: `dG/d(end) = G'/(2 b)` outwards, `G'` the slope of
//! `G` over `(xi - c)/b` at the end, and Newton's method needs no more than that.

use std::f64::consts::PI;

use super::system::Solved;
use crate::contact::edges::EndState;

/// Below so many roundings of the scale, and one for each that a rounding of the displacement counts, a density is none where slopes are known: at an end it is no better known.
const NONE: f64 = 8.0;
/// Angles at which the slope of the density is taken. At half or twice 25 of 32 answers change, within what they state (survey).
pub(super) const BESIDE: f64 = 0.06;
/// The same times the number of modes: beside a close neighbour the density changes as fast as these do.
const BESIDE_OF_MODES: f64 = 10.0;

/// What is known at the ends of all zones.
pub(super) fn ends(solved: &Solved) -> Vec<[EndState; 2]> {
    let scale = solved.density_scale();
    let rounding = f64::EPSILON * scale;
    let none = if solved.is_sampled() { (NONE + solved.condition()) * rounding } else { 0.0 };
    let end = |j: usize, side: usize| {
        let value = solved.end_density(j, side);
        let rounding = solved.rounding(j) + rounding;
        let step = -value / slope(solved, j, side) * solved.parts[j].zone.length();
        EndState { value, rounding, scale, none, enough: none, step }
    };
    (0..solved.parts.len()).map(|j| [end(j, 0), end(j, 1)]).collect()
}

/// Estimated error of the free ends of a zone, in `xi`.
pub(super) fn end_error(solved: &Solved, j: usize, density_error: f64) -> f64 {
    let zone = solved.parts[j].zone;
    zone.free_ends().fold(0.0, |most: f64, (side, _)| {
        let density = solved.end_density(j, side).abs() + density_error;
        most.max((density / slope(solved, j, side)).abs() * zone.length())
    })
}

/// `dG/dy` outwards at an end of a zone, `y = (xi - c)/b`.
fn slope(solved: &Solved, j: usize, side: usize) -> f64 {
    let part = &solved.parts[j];
    let at = |offset: f64| part.density(if side == 0 { PI - offset } else { offset });
    even_slope(at, BESIDE.min(BESIDE_OF_MODES / part.count() as f64))
}

/// The slope over `cos(phi)` outwards at the end `phi = 0` of an even function, from its values there and at angles beside.
pub(super) fn even_slope(at: impl Fn(f64) -> f64, beside: f64) -> f64 {
    let end = at(0.0);
    let one = (at(beside) - end) / (beside * beside);
    let two = (at(2.0 * beside) - end) / (4.0 * beside * beside);
    // cos is 1 - phi^2/2
    -2.0 * (4.0 * one - two) / 3.0
}
