//! The pressures on zones of graded ground, one by one or together.

use std::f64::consts::PI;
use std::sync::Arc;

use fredholm::inversion::Place;

use super::super::base::Base;
use super::super::modes::Modes;
use super::super::plane;
use super::super::pressure::{Density, Known, Pressure};
use super::Ground;
use super::couple::couple;
use super::on_zone::OnZone;
use super::strip::Strip;
use crate::Error;
use crate::contact::accuracy::ROUNDING;
use crate::contact::balance::{Balance, State};
use crate::contact::edges::EndState;
use crate::contact::stiffness::{Stiffness, require_solved};
use crate::contact::zones::Zone;
use crate::deadline::work;

/// What the elimination of coupled zones leaves in the densities at their ends, relative to them: beside the width of `0.449*step(x+0.5295)+0.497*x^2` (`mu = 0.141`, force 1.57516) differences of solutions show 2e-11. At half or twice 9 of 14 answers change, within what they state (survey).
const COUPLED: f64 = 1e-10;

#[derive(Debug, Clone)]
pub(in super::super) struct Solved {
    strips: Vec<Strip>,
    ground: Ground,
    state: State,
    stiffness: Stiffness,
    /// `theta0` times the force on each zone.
    forces: Vec<f64>,
    tolerance: f64,
    /// The middle of the zones, and the coefficients of the pressures that displace all of them by 1 and by `xi - middle`.
    middle: f64,
    flat: Arc<[Modes; 2]>,
}

/// Force and moment, about the middle of a zone, of its own pressure under the profile without depth and tilt, and of densities.
struct Carried {
    /// `P0` of an even density 1, `M0` of an odd one.
    units: [f64; 2],
    /// What the profile takes away.
    free: [f64; 2],
}

impl Carried {
    fn new(ground: &Ground, zone: &Zone, profile: &OnZone) -> Self {
        let b = 0.5 * zone.length();
        let powers = &ground.powers;
        let unit = 2.0 * ground.modulus / PI * powers.total() * powers.power(b);
        let units = [unit, unit * b * b / (2.0 + powers.exponent())];
        let [even, odd] = profile.levers(powers);
        Self { units, free: [units[0] * even, units[1] * odd] }
    }
}

impl Solved {
    /// On zones that stay as they are; of several zones polynomials are kept to these digits.
    ///
    /// # Errors
    /// [`Error::ZonesTooClose`], [`Error::Equation`] where something is not finite.
    pub(super) fn new(
        base: &Arc<Base>,
        ground: &Ground,
        zones: &[Zone],
        digits: f64,
    ) -> Result<Self, Error> {
        let profiles: Vec<Arc<OnZone>> =
            zones.iter().map(|zone| Arc::new(OnZone::new(base, &ground.powers, zone))).collect();
        let carried: Vec<Carried> = (zones.iter().zip(&profiles))
            .map(|(zone, profile)| Carried::new(ground, zone, profile))
            .collect();
        let middle = 0.5 * (zones[0].left() + zones[zones.len() - 1].right());
        let flat = match zones {
            [zone] => {
                let (total, mu) = (ground.powers.total(), ground.powers.exponent());
                let (level, tilted) = (vec![mu * total], vec![0.0, 0.5 * zone.length() * total]);
                [vec![level], vec![tilted], vec![vec![0.0; 2]]]
            }
            _ => {
                let counts = plane::counts(zones, digits)?;
                couple(base, &ground.powers, zones, &counts, &profiles, middle)?
            }
        };
        let [level, tilted, profile] = flat;
        // The profile of one zone is about its height in the middle, which the depth is measured from.
        let height = if zones.len() == 1 { base.height(middle) } else { 0.0 };
        let sums = |modes: &Modes| sums(zones, &carried, modes, middle);
        let [one, two, mut free] = [sums(&level), sums(&tilted), sums(&profile)];
        for (zone, own) in zones.iter().zip(&carried) {
            free[0] += own.free[0];
            free[1] += own.free[1] + (zone.middle() - middle) * own.free[0];
        }
        let coupling = 0.5 * (one[1] + two[0]);
        let stiffness = Stiffness { force_settlement: one[0], coupling, moment_tilt: two[1] };
        let balance = Balance { centre: middle, stiffness, free };
        let [depth, tilt] = balance.depth_and_tilt(&base.load.lowered(height, 0.0));
        let state = balance.state_of(&base.load, [depth, tilt], [height, 0.0]);
        let mut forces = Vec::with_capacity(zones.len());
        let mut strips = Vec::with_capacity(zones.len());
        for (j, own) in profiles.into_iter().enumerate() {
            let at = |modes: &Modes, n: usize| modes[j].get(n).copied().unwrap_or(0.0);
            let count = level[j].len().max(tilted[j].len());
            let density: Vec<f64> = (0..count)
                .map(|n| depth * at(&level, n) - tilt * at(&tilted, n) - at(&profile, n))
                .collect();
            let lowest = [density[0], density[1]];
            let others = if zones.len() > 1 { density } else { Vec::new() };
            let Carried { units, free } = carried[j];
            forces.push(base.setting.theta0() * (units[0] * lowest[0] - free[0]));
            strips.push(Strip::new(ground, zones[j], Some(own), lowest, others));
        }
        let ends = strips.iter().flat_map(|strip| [strip.end_density(0), strip.end_density(1)]);
        require_solved(ends.chain([state.settlement, state.tilt]), 0.5 * zones[0].length())?;
        Ok(Self {
            strips,
            ground: ground.clone(),
            state,
            stiffness: balance.about_base(),
            forces,
            tolerance: base.tolerance,
            middle,
            flat: Arc::new([level, tilted]),
        })
    }

    /// The same with less of each series.
    pub(super) fn truncated(&self) -> Self {
        let less =
            |strip: &Strip| if strip.is_truncated() { strip.truncated() } else { strip.clone() };
        Self { strips: self.strips.iter().map(less).collect(), ..self.clone() }
    }

    fn are_coupled(&self) -> bool {
        self.strips.len() > 1
    }

    /// Rounding of the densities of a zone, as a share of what is added up in them.
    fn share(&self, zone: usize) -> f64 {
        let strip = &self.strips[zone];
        // The kernel of a small exponent is nearly the same everywhere, whatever the zone.
        let mu = self.ground.powers.exponent();
        let condition = if self.are_coupled() { 1.0 + 1.0 / mu } else { 1.0 };
        // The ends are rounded in xi, not in lengths of their zone.
        condition * ROUNDING * (1.0 + strip.farthest() / strip.half()) + 4.0 * self.tolerance
    }
}

/// Force and moment about a middle of the densities of all zones.
fn sums(zones: &[Zone], carried: &[Carried], modes: &Modes, middle: f64) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for ((zone, own), modes) in zones.iter().zip(carried).zip(modes) {
        let force = own.units[0] * modes[0];
        let odd = modes.get(1).copied().unwrap_or(0.0);
        sums[0] += force;
        sums[1] += own.units[1] * odd / (0.5 * zone.length()) + (zone.middle() - middle) * force;
    }
    sums
}

impl Pressure for Solved {
    fn zones(&self) -> Vec<Zone> {
        self.strips.iter().map(|strip| strip.zone).collect()
    }

    fn state(&self) -> State {
        self.state
    }

    fn stiffness(&self) -> Stiffness {
        self.stiffness
    }

    fn force(&self, zone: usize) -> f64 {
        self.forces[zone]
    }

    fn at(&self, zone: usize, place: Place) -> f64 {
        self.strips[zone].pressure(place)
    }

    fn corner_exponent(&self) -> f64 {
        self.ground.powers.corner_exponent()
    }

    fn outside(&self, xi: f64) -> f64 {
        self.strips.iter().map(|strip| strip.outside(xi)).sum()
    }

    fn end(&self, zone: usize, side: usize) -> EndState {
        let strip = &self.strips[zone];
        let (value, scale) = (strip.end_density(side), strip.density_scale());
        let step = value / strip.falls()[side];
        EndState { value, rounding: ROUNDING * scale, scale, none: 0.0, enough: 0.0, step }
    }

    fn density(&self, zone: usize, side: usize) -> Density {
        let strip = &self.strips[zone];
        let [fall, missed] = strip.known_falls()[side];
        let coupled = if self.are_coupled() { COUPLED * fall.abs() } else { 0.0 };
        Density { value: strip.end_density(side), fall, fall_error: missed + coupled }
    }

    fn intensity(&self, zone: usize, _side: usize) -> f64 {
        self.strips[zone].intensity()
    }

    fn known(&self, zone: usize, largest: f64) -> Known {
        let (strip, share) = (&self.strips[zone], self.share(zone));
        let density = share * strip.density_scale();
        let blown = strip.slope_rounding() * strip.half();
        let bent = strip.flat_pressure(density + blown) + strip.bend_error();
        Known { density, pressure: share * largest + bent }
    }

    /// A depth or tilt that is off changes the densities by `mu B` or `b B` of it, `b` the half-length of all zones together: a turn raises some and sinks others, which even a kernel that is nearly the same everywhere tells apart.
    fn displacement_rounding(&self) -> [f64; 2] {
        let (total, mu) = (self.ground.powers.total(), self.ground.powers.exponent());
        let zones = self.strips.iter().enumerate();
        let densities = zones.map(|(j, strip)| self.share(j) * strip.density_scale());
        let density = densities.fold(0.0, f64::max);
        let depth = density / (mu * total);
        let (first, last) = (self.strips[0].zone, self.strips[self.strips.len() - 1].zone);
        let (reach, centre) = (0.5 * (last.right() - first.left()), self.middle);
        let turn = density / (reach * total);
        [depth + turn * centre.abs(), turn]
    }

    fn change(&self, raise: f64, turn: f64) -> Self {
        let depth = raise + turn * self.middle;
        let strip = |(j, strip): (usize, &Strip)| {
            let at = |part: usize, n: usize| self.flat[part][j].get(n).copied().unwrap_or(0.0);
            let count = self.flat[0][j].len().max(self.flat[1][j].len());
            let density: Vec<f64> =
                (0..count).map(|n| depth * at(0, n) + turn * at(1, n)).collect();
            let lowest = [density[0], density[1]];
            let zone = Zone::new(strip.zone.ends, [false; 2]);
            Strip::new(&self.ground, zone, None, lowest, density)
        };
        let strips = self.strips.iter().enumerate().map(strip).collect();
        Self { strips, ..self.clone() }
    }

    fn unknowns(&self) -> usize {
        self.strips.iter().map(Strip::size).sum()
    }

    fn terms(&self) -> usize {
        work::TERMS_OF_POWER * self.unknowns()
    }

    fn coupled(&self) -> usize {
        if self.are_coupled() { self.flat[0].iter().map(Vec::len).sum() } else { 0 }
    }

    /// The polynomials of one zone are kept to all digits from the first.
    fn is_fine(&self) -> bool {
        self.strips.len() == 1
    }
}
