//! The answer of a smooth circular punch on rings.

use std::f64::consts::PI;
use std::sync::Arc;

use super::base::Base;
use super::edges;
use super::system::{Core, Solved};
use crate::Error;
use crate::contact::accuracy::ROUNDING;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::check::Check;
use crate::contact::complementarity::Complementarity;
use crate::contact::method::{Method, MethodName};
use crate::contact::smooth::detail::COMPARED;
use crate::contact::smooth::disk::SmoothDisk;
use crate::contact::smooth::told::{Told, compared, places};
use crate::contact::solution::Solution;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;

/// Zones, pressure, settlement and force of a circular punch on a smooth body, without tilt and without dimensions.
#[derive(Debug, Clone)]
pub(crate) struct SmoothRingsContact {
    problem: Arc<SmoothDisk>,
    solved: Solved,
    stiffness: Stiffness,
    told: Told,
}

impl SmoothRingsContact {
    pub(super) fn new(base: &Base<'_>, solved: Solved, left: &Check) -> Result<Self, Error> {
        let stated = (&base.problem.load, &solved.state);
        let shares = [left.tension, left.penetration];
        let told = Told::new(stated, left.largest, estimate(base, &solved), shares)?;
        let stiffness = solved.stiffness()?;
        Ok(Self { problem: Arc::new(base.problem.clone()), solved, stiffness, told })
    }

    /// The zone along the diameter, and whether it is on the left.
    fn along_diameter(&self, zone: usize) -> (usize, bool) {
        let rings = self.solved.parts.len();
        let shift = usize::from(self.solved.core.is_some());
        if zone < rings { (rings - 1 - zone + shift, true) } else { (zone - rings, false) }
    }
}

/// The error by comparison with fewer modes and other panels on the same zones, and that of the edges; none for what the load prescribes.
fn estimate(base: &Base<'_>, solved: &Solved) -> (Accuracy, f64) {
    let coarse = Solved::new(base, &solved.zones, COMPARED).ok().map(truncated);
    let (mut pressure, mut edge) = (0.0f64, 0.0f64);
    for j in 0..solved.zones.len() {
        let worst = compared(
            |angle| solved.regular(j, angle),
            |angle| coarse.as_ref().map_or(f64::INFINITY, |coarse| coarse.regular(j, angle)),
        );
        let difference = |one: &dyn Fn(&Solved) -> f64| {
            coarse.as_ref().map_or(f64::INFINITY, |coarse| (one(solved) - one(coarse)).abs())
        };
        let (rounding, density) = match (solved.ring(j), &solved.core) {
            (Some(part), _) => {
                let ring = part.ring();
                let size = solved.theta0 * ring.half * ring.inner() * ring.inner().sqrt();
                let at = |side: usize| {
                    difference(&|s: &Solved| s.ring(j).map_or(0.0, |p| p.end_density(side)))
                };
                (part.rounding() / size, at(0).max(at(1)))
            }
            (None, Some(core)) => {
                let depth =
                    ROUNDING * core.level.abs() + core.transform.slope_rounding() * core.radius;
                let corner = |s: &Solved| s.core.as_ref().map_or(0.0, |core| core.corner);
                (solved.modulus / PI * depth / core.radius, difference(&corner))
            }
            (None, None) => (0.0, 0.0),
        };
        pressure = pressure.max(worst + rounding);
        edge = edge.max(edges::end_error(solved, j, density));
    }
    let change = |part: fn(&State) -> f64| {
        let other = coarse.as_ref().map_or(f64::INFINITY, |coarse| part(&coarse.state));
        (part(&solved.state) - other).abs()
    };
    let level = solved.displacement_rounding();
    let State { settlement, force, .. } = solved.state;
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure,
        settlement: change(|s| s.settlement) + level + ROUNDING * settlement.abs(),
        tilt: 0.0,
        force: change(|s| s.force) + solved.rate * level + ROUNDING * force.abs(),
        moment: 0.0,
    };
    (accuracy, edge)
}

/// The estimated error of the pressure over the largest one.
pub(super) fn noise(base: &Base<'_>, solved: &Solved, largest: f64) -> f64 {
    estimate(base, solved).0.pressure / largest
}

/// The same with less of the series of the disk.
fn truncated(mut solved: Solved) -> Solved {
    if let Some(core) = &mut solved.core {
        *core = Core { transform: Arc::new(core.transform.truncated()), ..core.clone() };
    }
    solved
}

impl Solution for SmoothRingsContact {
    fn state(&self) -> State {
        self.solved.state
    }

    fn stiffness(&self) -> Stiffness {
        self.stiffness
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        let rings = self.solved.parts.iter().map(|part| part.ring().zone.ends);
        let mirrored = rings.clone().rev().map(|[inner, outer]| [-outer, -inner]);
        let core = self.solved.core.as_ref().map(|core| [-core.radius, core.radius]);
        mirrored.chain(core).chain(rings).collect()
    }

    fn corner_intensity(&self) -> Option<Vec<[f64; 2]>> {
        let count = self.zones().len();
        let of = |zone: usize| {
            let (own, is_left) = self.along_diameter(zone);
            let [inner, outer] = self.solved.intensity(own);
            match self.solved.ring(own) {
                None => [outer; 2],
                Some(_) if is_left => [outer, inner],
                Some(_) => [inner, outer],
            }
        };
        Some((0..count).map(of).collect())
    }

    fn pressure(&self, xi: f64) -> f64 {
        self.solved.pressure(xi.abs())
    }

    fn pressure_beside(&self, zone: usize, from_left: f64, from_right: f64) -> f64 {
        let (own, is_left) = self.along_diameter(zone);
        match self.solved.ring(own) {
            None => self.solved.pressure_beside(own, from_left, from_left.min(from_right)),
            Some(_) if is_left => self.solved.pressure_beside(own, from_right, from_left),
            Some(_) => self.solved.pressure_beside(own, from_left, from_right),
        }
    }

    fn displacement(&self, xi: f64) -> f64 {
        let r = xi.abs();
        match self.solved.zones.iter().find(|zone| zone.contains(r)) {
            Some(zone) => {
                // At a step the height is that of this side.
                let from = if zone.left() > 0.0 { zone.left().next_up() } else { 0.0 };
                let to = if zone.right() < 1.0 { zone.right().next_down() } else { 1.0 };
                self.solved.state.settlement - (self.problem.height)(r.clamp(from, to))
            }
            None => self.solved.displacement_outside(r),
        }
    }

    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        let sampled = places(&self.zones()).into_iter().map(|xi| (xi, self.pressure(xi)));
        sampled.filter(|(_, pressure)| pressure.is_finite()).unzip()
    }

    /// With as many coupled modes of the rings and coefficients of a disk.
    fn method(&self) -> Method {
        Method { name: MethodName::FirstKind, n: self.solved.modes() }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.told.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        let is_free = self.solved.zones.iter().any(Zone::has_free_end);
        is_free.then_some(self.told.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.problem.is_unilateral.then_some(self.told.complementarity)
    }

    fn size(&self) -> f64 {
        self.told.largest
    }
}
