//! The pressures on zones that stay as they are, one by one or together.

use std::f64::consts::PI;

use fredholm::inversion::ultraspherical::Ripple;

use super::couple::{Coupled, couple};
use super::parts::Parts;
use super::strip::{Ground, Strip};
use crate::Error;
use crate::contact::balance::State;
use crate::contact::smooth::SmoothKernel;
use crate::contact::smooth::balance::Centred;
use crate::contact::smooth::coupling;
use crate::contact::smooth::problem::Base;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;

/// Force and moment, about the middle of a zone, of its own pressure under the profile without depth and tilt, and of densities.
struct Balance {
    /// `P0` of an even density 1, `M0` of an odd one.
    units: [f64; 2],
    /// What the profile takes away.
    free: [f64; 2],
}

impl Balance {
    fn new(ground: &Ground, zone: &Zone, parts: &Parts) -> Self {
        let b = 0.5 * zone.length();
        let mu = ground.powers.exponent();
        let unit = 2.0 * ground.modulus / PI * ground.total() * ground.powers.power(b);
        let units = [unit, unit * b * b / (2.0 + mu)];
        let [even, odd] = parts.levers(ground);
        Self { units, free: [units[0] * even, units[1] * odd] }
    }

    fn stiffness(&self, ground: &Ground) -> Stiffness {
        let ([force, moment], total) = (self.units, ground.total());
        Stiffness {
            force_settlement: force * ground.powers.exponent() * total,
            coupling: 0.0,
            moment_tilt: moment * total,
        }
    }
}

/// A zone with what its pressure is made of.
pub(super) struct Settled {
    pub(super) strip: Strip,
    pub(super) parts: Parts,
    pub(super) ripple: Ripple,
    /// The coefficients of the first two polynomials.
    pub(super) lowest: [f64; 2],
    /// The coefficients of the pressures that displace all zones by 1 and by `xi - middle`.
    pub(super) flat: [Vec<f64>; 2],
    pub(super) middle: f64,
}

/// The pressures on zones that stay as they are; of several zones polynomials are kept to these digits.
///
/// # Errors
/// [`Error::Equation`] where zones come too close for the polynomials that can be kept, or something is not finite.
pub(super) fn fixed(
    base: &Base<'_>,
    ground: &Ground,
    zones: &[Zone],
    digits: f64,
) -> Result<Vec<Settled>, Error> {
    let settled = match zones {
        [zone] => vec![alone(base, ground, zone)],
        _ => together(base, ground, zones, digits)?,
    };
    for Settled { strip, .. } in &settled {
        let State { settlement, tilt, .. } = strip.state;
        let densities = [strip.end_density(0), strip.end_density(1), settlement, tilt];
        if !densities.iter().all(|value| value.is_finite()) {
            let (parameter, smallest) = (strip.half(), 0.0);
            return Err(Error::Equation(fredholm::Error::Singular { parameter, smallest }));
        }
    }
    Ok(settled)
}

/// One zone.
fn alone(base: &Base<'_>, ground: &Ground, zone: &Zone) -> Settled {
    let parts = Parts::new(base, ground, zone);
    let balance = Balance::new(ground, zone, &parts);
    let (b, c) = (0.5 * zone.length(), 0.5 * (zone.left() + zone.right()));
    let (full, height) = (ground.powers.exponent() * ground.total(), base.height(c));
    let own = balance.stiffness(ground);
    let centred = Centred { centre: c, stiffness: own, free: balance.free };
    // The profile about its height in the middle, which the depth is measured from.
    let load = lowered(base.problem.load, height);
    let [depth, tilt] = centred.depth_and_tilt(&load);
    let levels = [full * depth, -tilt * ground.total()];
    let ripple = Ripple::new(&ground.powers, parts.modes(), Vec::new());
    let [even, odd] = parts.lowest();
    let lowest = [levels[0] - even, b * levels[1] - odd];
    let strip = Strip {
        zone: *zone,
        state: centred.state_of(&base.problem.load, [depth, tilt], [height, 0.0]),
        stiffness: centred.about_base(),
        own,
        force: balance.units[0] * full * depth - balance.free[0],
        levels,
        transforms: parts.transforms(ground),
        ripple: ripple.ends(),
        ripple_size: ripple.size(),
        steepest: parts.steepest,
    };
    let flat = [vec![full], vec![0.0, b * ground.total()]];
    Settled { strip, parts, ripple, lowest, flat, middle: c }
}

/// Several zones.
fn together(
    base: &Base<'_>,
    ground: &Ground,
    zones: &[Zone],
    digits: f64,
) -> Result<Vec<Settled>, Error> {
    let counts = coupling::modes(SmoothKernel::Plane, zones, digits)?;
    let parts: Vec<Parts> = zones.iter().map(|zone| Parts::new(base, ground, zone)).collect();
    let balances: Vec<Balance> =
        zones.iter().zip(&parts).map(|(zone, parts)| Balance::new(ground, zone, parts)).collect();
    let middle = 0.5 * (zones[0].left() + zones[zones.len() - 1].right());
    let Coupled { mut level, mut tilted, profile } =
        couple(base, ground, zones, &counts, &parts, middle)?;
    // Force and moment of densities.
    let carried = |densities: &[Vec<f64>]| -> [f64; 2] {
        let mut sums = [0.0; 2];
        for ((zone, balance), density) in zones.iter().zip(&balances).zip(densities) {
            let (b, c) = (0.5 * zone.length(), 0.5 * (zone.left() + zone.right()));
            let force = balance.units[0] * density[0];
            sums[0] += force;
            sums[1] += balance.units[1] * density[1] / b + (c - middle) * force;
        }
        sums
    };
    let [one, two] = [carried(&level), carried(&tilted)];
    let mut free = carried(&profile);
    for (zone, balance) in zones.iter().zip(&balances) {
        let arm = 0.5 * (zone.left() + zone.right()) - middle;
        free[0] += balance.free[0];
        free[1] += balance.free[1] + arm * balance.free[0];
    }
    let coupling = 0.5 * (one[1] + two[0]);
    let stiffness = Stiffness { force_settlement: one[0], coupling, moment_tilt: two[1] };
    let centred = Centred { centre: middle, stiffness, free };
    let displaced = centred.depth_and_tilt(&base.problem.load);
    let state = centred.state_of(&base.problem.load, displaced, [0.0; 2]);
    let stiffness = centred.about_base();
    let mut settled = Vec::with_capacity(zones.len());
    for (j, parts) in parts.into_iter().enumerate() {
        let (zone, balance) = (zones[j], &balances[j]);
        let b = 0.5 * zone.length();
        let flat = [std::mem::take(&mut level[j]), std::mem::take(&mut tilted[j])];
        let [depth, tilt] = displaced;
        let density: Vec<f64> = (0..counts[j])
            .map(|n| depth * flat[0][n] - tilt * flat[1][n] - profile[j][n])
            .collect();
        let levels = [density[0], density[1] / b];
        let [even, odd] = parts.lowest();
        let lowest = [density[0] - even, density[1] - odd];
        let ripple = Ripple::new(&ground.powers, parts.modes(), density);
        let strip = Strip {
            zone,
            state,
            stiffness,
            own: balance.stiffness(ground),
            force: balance.units[0] * levels[0] - balance.free[0],
            levels,
            transforms: parts.transforms(ground),
            ripple: ripple.ends(),
            ripple_size: ripple.size(),
            steepest: parts.steepest,
        };
        settled.push(Settled { strip, parts, ripple, lowest, flat, middle });
    }
    Ok(settled)
}

/// The load of a profile less its height in the middle.
fn lowered(load: crate::Load, height: f64) -> crate::Load {
    use crate::Vertical;
    let vertical = match load.vertical {
        Vertical::Settlement(settlement) => Vertical::Settlement(settlement - height),
        force @ Vertical::Force(_) => force,
    };
    crate::Load { vertical, ..load }
}
