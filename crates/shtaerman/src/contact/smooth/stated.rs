//! The error of a pressure on zones, by another resolution of the same zones and by rounding.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use super::equation::FirstKind;
use super::pressure::{Known, Pressure, at_angle};
use crate::Vertical;
use crate::contact::accuracy::{Accuracy, ErrorKind, ROUNDING, SAFETY};
use crate::contact::balance::State;

/// Points of a zone at which two resolutions are compared.
const COMPARISONS: usize = 33;

/// What an end that moves does to the force at a given settlement, over `theta0`, intensities and `D^2/D'` of its density, which is estimated: a quarter of it by theory, as the force on `(-a, a)` is `1/(theta0 ln(2/a))`.
pub(super) const MOVED: f64 = PI;

/// The largest difference of two functions of the angle of a zone. An irrational share of the step keeps clear of symmetric places, where a kink may be.
pub(super) fn difference(one: impl Fn(f64) -> f64, other: impl Fn(f64) -> f64) -> f64 {
    (0..COMPARISONS)
        .map(|i| PI * (i as f64 + FRAC_1_SQRT_2) / COMPARISONS as f64)
        .fold(0.0, |most: f64, angle| most.max((one(angle) - other(angle)).abs()))
}

/// The error of a solution, and that of its free ends in `xi`; infinite where the other resolution has none, zero for what the load prescribes.
pub(super) fn estimate<F: FirstKind>(
    equation: &F,
    solved: &F::Solved,
    largest: f64,
) -> (Accuracy, f64) {
    let other = equation.compared(solved);
    let zones = solved.zones();
    let state = solved.state();
    let (level, is_disk) = (solved.change(1.0, 0.0), equation.base().ground.is_disk());
    let (mut pressure, mut edge, mut moved) = (0.0f64, 0.0f64, 0.0);
    let around = |at: f64| if is_disk { 2.0 * PI * at } else { 1.0 };
    for (j, zone) in zones.iter().enumerate() {
        // A corner is where its place was rounded to; a pressure beyond all numbers is told by itself.
        for side in [0, 1].into_iter().filter(|side| !zone.is_free(*side)) {
            let [own, of_level] = [solved, &level].map(|of| of.density(j, side).value);
            let strength = around(zone.ends[side]) * solved.intensity(j, side).powi(2);
            let off = f64::EPSILON * equation.base().distance(zone.ends[side]);
            let carried = Some(off * (strength * own * of_level).abs());
            moved += carried.filter(|carried| carried.is_finite()).unwrap_or(0.0);
        }
        let Known { density: rounding, pressure: own } = solved.known(j, largest);
        let along = |of: &F::Solved, angle: f64| of.regular(j, at_angle(zone, angle));
        let changed = difference(
            |angle| along(solved, angle),
            |angle| other.as_ref().map_or(f64::INFINITY, |other| along(other, angle)),
        );
        // What is left at a free end is taken away along the whole zone.
        let mut left = 0.0f64;
        for (side, at) in zone.free_ends() {
            let here = solved.density(j, side);
            let there = other.as_ref().map_or(f64::INFINITY, |o| o.density(j, side).value);
            // All zones are one system, rounded as the largest, and a height that is rounded presses or relieves its zone.
            let shared = SAFETY * f64::EPSILON * solved.end(j, side).scale;
            let of_level = level.density(j, side).value;
            let height = equation.base().height_in(zone.ends, at);
            let raised = 0.5 * ROUNDING * (state.settlement.abs() + height.abs()) * of_level.abs();
            let density =
                here.value.abs() + (here.value - there).abs() + rounding + shared + raised;
            left = left.max(here.value.abs() * solved.singular(j, side));
            edge = edge
                .max((density / here.fall).abs() + 0.5 * ROUNDING * equation.base().distance(at));
            let strength = around(at) * (solved.intensity(j, side) * density).powi(2);
            moved += (strength * of_level / here.fall).abs().max(0.0); // 0/0 where nothing is left.
        }
        pressure = pressure.max(changed + own + left);
    }
    let change = |part: fn(&State) -> f64| {
        let there = other.as_ref().map_or(f64::INFINITY, |other| part(&other.state()));
        (part(&state) - there).abs()
    };
    let [level, turn] = solved.displacement_rounding();
    let stiffness = solved.stiffness();
    // A depth that is off moves a force that is given to no other place, and about it a turn carries none.
    let lever = (stiffness.coupling / stiffness.force_settlement).abs();
    let about = (stiffness.moment_tilt - lever * stiffness.coupling.abs()).max(0.0) * turn;
    let raised = stiffness.force_settlement * level;
    let is_forced = matches!(equation.base().load.vertical, Vertical::Force(_));
    let off_centre = if is_forced { 0.0 } else { lever * raised };
    let rounded = ROUNDING * state.settlement.abs().max(state.tilt.abs());
    // A disk is tilted by its moment alone.
    let tilted = if is_disk { 0.0 } else { rounded };
    let carried = about + ROUNDING * state.force.abs().max(state.moment.abs());
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure,
        settlement: change(|state| state.settlement) + level + rounded,
        tilt: change(|state| state.tilt) + turn + tilted,
        force: change(|state| state.force) + raised + carried,
        moment: change(|state| state.moment) + off_centre + carried,
    };
    let force = stiffness.force_settlement.abs();
    let depth = MOVED * equation.base().setting.theta0() * moved / force;
    // Of what lies so deep at the ends of all zones together, and turns about their middle.
    let [first, last] = [zones[0], zones[zones.len() - 1]];
    let (reach, middle) =
        (0.5 * (last.right() - first.left()), 0.5 * (first.left() + last.right()));
    let is_turned = !is_disk && equation.base().load.rotational.tilt().is_none();
    let turned = if is_turned { 2.0 * depth / reach } else { 0.0 };
    let arm = middle.abs();
    let opened = [depth + arm * turned, turned, force * depth, force * depth * (arm + 2.0 * reach)];
    (accuracy.open(opened, |known, more| known + more), edge)
}

/// The error of the pressure over the largest one.
pub(super) fn noise<F: FirstKind>(equation: &F, solved: &F::Solved, largest: f64) -> f64 {
    estimate(equation, solved, largest).0.pressure / largest
}
