//! The answer of smooth contact, whatever the ground.

use std::f64::consts::TAU;
use std::sync::Arc;

use super::base::{Base, SAMPLES, wrapped};
use super::check::{check, points};
use super::equation::{FINE, FirstKind};
use super::pressure::{Pressure, place};
use super::stated::{MOVED, estimate};
use crate::contact::accuracy::{Accuracy, SAFETY, Sizes};
use crate::contact::balance::State;
use crate::contact::check::Check;
use crate::contact::complementarity::Complementarity;
use crate::contact::method::{Method, MethodName};
use crate::contact::rates::{Linearised, Rates, smooth_rates};
use crate::contact::search::{ALLOWED, complementary, unknown};
use crate::contact::solution::Solution;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::{Error, Load, Rotational, Vertical};

/// Points of a zone that show extremes. At half or twice 16 of 32 answers change, within what they state (survey).
const PLACES: usize = 256;

/// Zones, pressure, settlement, tilt, force and moment of contact without a layer, all without dimensions.
#[derive(Debug)]
pub(super) struct SmoothContact<P> {
    base: Arc<Base>,
    solved: P,
    /// Those of the base, which differ from the ones that are solved for where a wave is seen from elsewhere.
    state: State,
    accuracy: Accuracy,
    edge_error: f64,
    complementarity: Complementarity,
    /// The largest pressure seen between the singular places.
    largest: f64,
    /// The zones along the base with their numbers, and whether each is the mirror image of its ring.
    along: Vec<([f64; 2], usize, bool)>,
}

impl<P: Pressure> SmoothContact<P> {
    /// Errors count for what the load leaves open.
    ///
    /// # Errors
    /// [`Error::Overflow`] when something is not finite.
    pub(super) fn new<F: FirstKind<Solved = P>>(
        equation: &F,
        solved: P,
        left: &Check,
    ) -> Result<Self, Error> {
        let base = Arc::clone(equation.base());
        let (accuracy, edge_error) = estimate(equation, &solved, left.largest);
        let accuracy = accuracy.with_left(left.missed, &solved.stiffness());
        let state = solved.state();
        let values = [
            ("force", state.force),
            ("moment", state.moment),
            ("settlement", state.settlement),
            ("tilt", state.tilt),
            ("pressure", left.largest),
        ];
        if let Some((quantity, value)) = values.into_iter().find(|(_, value)| !value.is_finite()) {
            return Err(Error::Overflow { quantity, value });
        }
        let is_disk = base.ground.is_disk();
        let rotational =
            if is_disk { base.setting.load().rotational } else { base.load.rotational };
        let load = Load { rotational, ..base.load };
        let (tension, penetration) = (left.tension, left.penetration);
        Ok(Self {
            along: along(&base, &solved.zones()),
            accuracy: accuracy.under(&load),
            complementarity: Complementarity { tension, penetration },
            largest: left.largest,
            base,
            solved,
            state,
            edge_error,
        })
    }

    /// The same with a moment about the middle of the base itself.
    pub(super) fn with_moment(mut self, moment: f64) -> Self {
        self.state.moment = moment;
        self
    }

    /// The same as answer to this settlement, which the force answers for.
    pub(super) fn settled(mut self, settlement: f64, rounding: f64) -> Self {
        let stiffness = self.solved.stiffness().force_settlement;
        self.accuracy.force = stiffness * self.accuracy.settlement + rounding;
        (self.accuracy.settlement, self.state.settlement) = (0.0, settlement);
        self
    }

    pub(super) fn solved(&self) -> &P {
        &self.solved
    }

    /// The zone that holds a place among the zones.
    fn touching(&self, at: f64) -> Option<(usize, Zone)> {
        let mut zones = self.solved.zones().into_iter().enumerate();
        zones.find(|(_, zone)| zone.contains(at))
    }

    /// The free ends: zone, side and, of a disk, circumference.
    fn free_ends(&self) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        let is_disk = self.base.ground.is_disk();
        let around = move |at: f64| if is_disk { TAU * at } else { 1.0 };
        let of_zone = move |(j, zone): (usize, Zone)| {
            zone.free_ends().map(move |(side, at)| (j, side, around(at)))
        };
        self.solved.zones().into_iter().enumerate().flat_map(of_zone)
    }

    /// What ends that are off may make of a zone or a gap between two, as a share. What is off at both ends is so along the zone, in its first modes: how a density falls is off by the squares of
    /// their numbers more, of rates by up to 20 times (survey).
    fn ends_off(&self) -> f64 {
        let ends: Vec<[f64; 2]> = self.solved.zones().iter().map(|zone| zone.ends).collect();
        let lengths = ends.iter().map(|[left, right]| right - left);
        let gaps = ends.windows(2).map(|pair| pair[1][0] - pair[0][1]);
        2.0 * SAFETY * SAFETY * self.edge_error / lengths.chain(gaps).fold(f64::INFINITY, f64::min)
    }

    /// Rates with what they may be off by, for changes of what the load prescribes.
    /// `units` are those by a depth and a turn of 1.
    fn rates(&self, load: &Load, prescribed: [f64; 2], units: &[P; 2], peak: f64) -> [Rates; 2] {
        let stiffness = self.solved.stiffness();
        let [raise, turn] = stiffness.displaced(load, prescribed);
        let force = stiffness.force_settlement * raise + stiffness.coupling * turn;
        let change = self.solved.change(raise, turn);
        let touching = self.touching(self.base.located(peak));
        let touching = touching.filter(|_| self.pressure(peak).is_finite());
        let pressure = |change: &P| {
            touching.map_or(0.0, |(j, zone)| {
                change.on_side(j, place(&zone, self.base.located(peak)), peak.signum())
            })
        };
        let off = self.off(load, units, &change);
        let (mut width, ends_off) = ([0.0; 2], self.ends_off());
        let images = if self.base.ground.is_disk() { 2.0 } else { 1.0 };
        for (j, side, _) in self.free_ends() {
            let here = self.solved.density(j, side);
            let moved = images * change.density(j, side).value / here.fall;
            // Terms may cancel, what ends do to each of them does not.
            let [level, turned] = [0, 1].map(|k| units[k].density(j, side).value.abs());
            let terms = [(raise, level, off[0]), (turn, turned, off[1])];
            let density: f64 =
                (terms.iter()).map(|(by, of, off)| of * (ends_off * by.abs() + off)).sum();
            width[0] += moved;
            width[1] += ((moved * here.fall_error).abs() + images * density) / here.fall.abs();
        }
        let rates = [raise, force, -turn, pressure(&change), width[0]];
        let of_pressure = off[0] * pressure(&units[0]).abs() + off[1] * pressure(&units[1]).abs();
        [rates, [off[0], off[2], off[1], of_pressure, width[1]]]
    }

    /// What raise, turn and force of a change are off by as free ends are: one that is off by `e` changes what a displacement carries against another by `MOVED theta0 K_j K_k e`, `K` their
    /// intensities there (Hadamard's formula), twice as much as a zone alone shows.
    fn off(&self, load: &Load, units: &[P; 2], change: &P) -> [f64; 3] {
        let mut carried = [0.0; 2];
        for (j, side, around) in self.free_ends() {
            let intensity = |of: &P| self.solved.intensity(j, side) * of.density(j, side).value;
            let strength = MOVED * self.base.setting.theta0() * around * self.edge_error;
            for (carried, unit) in carried.iter_mut().zip(units) {
                *carried += strength * (intensity(unit) * intensity(change)).abs();
            }
        }
        let is_forced = matches!(load.vertical, Vertical::Force(_));
        let is_turned = !matches!(load.rotational, Rotational::Tilt(_));
        let open =
            [if is_forced { carried[0] } else { 0.0 }, if is_turned { carried[1] } else { 0.0 }];
        let stiffness = self.solved.stiffness();
        let [one, other] = [[open[0], 0.0], [0.0, open[1]]].map(|o| stiffness.displaced(load, o));
        let [raise, turn] = [0, 1].map(|k| one[k].abs() + other[k].abs());
        let force = carried[0] + stiffness.coupling.abs() * turn;
        [raise, turn, if is_forced { 0.0 } else { force }]
    }
}

/// The zones along the base, from left to right: of a disk along its diameter, of a wave those whose right ends lie on the base.
fn along(base: &Base, zones: &[Zone]) -> Vec<([f64; 2], usize, bool)> {
    let mut along = Vec::new();
    for (j, zone) in zones.iter().enumerate() {
        let [left, right] = zone.ends;
        if base.ground.is_disk() {
            if left == 0.0 {
                along.push(([-right, right], j, false));
            } else {
                along.extend([([-right, -left], j, true), (zone.ends, j, false)]);
            }
            continue;
        }
        let mut ends = zone.ends.map(|end| end + base.shift);
        if base.shift != 0.0 && ends[1] <= -1.0 {
            ends = ends.map(|end| end + 2.0);
        }
        along.push((ends, j, false));
    }
    crate::order::sort_by_number(&mut along, |one| one.0[0]);
    along
}

impl<P: Pressure> Solution for SmoothContact<P> {
    fn state(&self) -> State {
        self.state
    }

    /// A free edge that moves adds nothing of first order.
    fn stiffness(&self) -> Stiffness {
        self.solved.stiffness()
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        self.along.iter().map(|(ends, _, _)| *ends).collect()
    }

    fn touches(&self, xi: f64) -> bool {
        self.touching(self.base.located(xi)).is_some()
    }

    fn corner_intensity(&self) -> Option<Vec<[f64; 2]>> {
        let zones = self.solved.zones();
        let intensity = |j: usize, side: usize| {
            let is_free = zones[j].is_free(side);
            if is_free {
                0.0
            } else {
                self.solved.intensity(j, side) * self.solved.density(j, side).value
            }
        };
        let of = |&([left, _], j, is_mirrored): &([f64; 2], usize, bool)| {
            if is_mirrored {
                return [intensity(j, 1), intensity(j, 0)];
            }
            if self.base.ground.is_disk() && left < 0.0 {
                // Both ends of the diameter are its edge, of which the tilt raises one.
                let turned = self.solved.turned_intensity(j);
                return [-1.0, 1.0].map(|side| intensity(j, 1) + side * turned);
            }
            [intensity(j, 0), intensity(j, 1)]
        };
        Some(self.along.iter().map(of).collect())
    }

    fn pressure(&self, xi: f64) -> f64 {
        let at = self.base.located(xi);
        match self.touching(at) {
            Some((j, zone)) => self.solved.on_side(j, place(&zone, at), xi.signum()),
            None if xi.is_nan() => xi,
            None => 0.0,
        }
    }

    fn pressure_beside(&self, zone: usize, from_left: f64, from_right: f64) -> f64 {
        let Some(&([left, _], j, is_mirrored)) = self.along.get(zone) else { return 0.0 };
        let (mut near, mut far) = (from_left.max(0.0), from_right.max(0.0));
        if is_mirrored {
            (near, far) = (far, near);
        }
        if self.base.ground.is_disk() && left < 0.0 && !is_mirrored {
            let radius = self.solved.zones()[j].right();
            let edge = near.min(far);
            (near, far) = ((radius - edge).max(0.0), edge);
        }
        self.solved.at(j, fredholm::inversion::Place { from_left: near, from_right: far })
    }

    fn displacement(&self, xi: f64) -> f64 {
        let at = self.base.located(xi);
        let State { settlement, tilt, .. } = self.solved.state();
        let Some((_, zone)) = self.touching(at) else {
            let side = if self.base.ground.is_disk() { xi.signum() } else { 0.0 };
            return self.solved.outside(at) + side * self.solved.turned_outside(at);
        };
        let lever = if self.base.ground.is_disk() { xi } else { at };
        settlement - tilt * lever - self.base.height_in(zone.ends, at)
    }

    /// Places of the zones, closer to their ends, and the ends of the base, but for those where the pressure is infinite; of a base that repeats those of a zone may lie beyond `-1`.
    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        let count = (SAMPLES / self.along.len().max(1)).min(PLACES);
        let along = self.along.iter().flat_map(|(ends, _, _)| points(*ends, count));
        let along = along.map(|xi| if xi < -1.0 { wrapped(xi) } else { xi });
        let places = along.chain([-1.0, 1.0]).filter(|xi| xi.abs() <= 1.0);
        let places = crate::order::ascending(places).into_iter();
        let sampled = places.map(|xi| (xi, self.pressure(xi)));
        sampled.filter(|(_, pressure)| pressure.is_finite()).unzip()
    }

    fn method(&self) -> Method {
        Method { name: MethodName::FirstKind, n: self.solved.unknowns() }
    }

    /// Of the pressure in the middle of the zones: nearer to a corner it grows as the pressure does.
    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.accuracy)
    }

    fn relative_error(&self) -> f64 {
        let sizes = self.state.sizes(self.largest);
        let displacement = sizes.displacement.max(self.base.range());
        self.accuracy.relative(&Sizes { displacement, ..sizes })
    }

    fn edge_error(&self) -> Option<f64> {
        let is_free = self.solved.zones().iter().any(Zone::has_free_end);
        is_free.then_some(self.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.base.setting.is_unilateral().then_some(self.complementarity)
    }

    fn linearised(&self, mut load: Load, peak: f64) -> Option<Linearised> {
        if self.base.setting.problem().is_wave() {
            // That no moment is asked for means that a wave cannot tilt.
            load.rotational = self.base.load.rotational;
        }
        let units = [self.solved.change(1.0, 0.0), self.solved.change(0.0, 1.0)];
        let [by_force, force_error] = self.rates(&load, [1.0, 0.0], &units, peak);
        let turns = !matches!(load.rotational, Rotational::Eccentricity(_));
        let [by_moment, moment_error] =
            if turns { self.rates(&load, [0.0, 1.0], &units, peak) } else { [[0.0; 5]; 2] };
        let largest = self.pressure(peak);
        let own = [self.state.force, if largest.is_finite() { largest } else { 0.0 }];
        let errors = smooth_rates(&load, [0.0; 2], [force_error, moment_error]);
        Some(Linearised {
            rates: smooth_rates(&load, own, [by_force, by_moment]),
            errors: errors.map(|rates| rates.map(f64::abs)),
        })
    }

    fn size(&self) -> f64 {
        self.largest
    }
}

/// The contact on the whole base, or on the zones where it touches.
pub(super) fn contact<F: FirstKind>(equation: &F) -> Result<SmoothContact<F::Solved>, Error> {
    let (solved, left) = if equation.base().setting.is_unilateral() {
        complementary(equation)?
    } else {
        let solved = equation.on_zones(&equation.base().whole(), FINE)?;
        let left = check(equation.base(), &solved, ALLOWED);
        (solved, left)
    };
    if equation.base().deadline().is_spent() {
        return Err(unknown());
    }
    SmoothContact::new(equation, solved, &left)
}
