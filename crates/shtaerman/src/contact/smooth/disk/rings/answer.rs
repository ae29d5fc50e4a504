//! The answer of a smooth circular punch on rings.

use std::f64::consts::{FRAC_1_SQRT_2, PI};
use std::sync::Arc;

use super::super::SmoothDisk;
use super::base::Base;
use super::edges;
use super::system::{Core, Solved};
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::check::Check;
use crate::contact::complementarity::Complementarity;
use crate::contact::method::{Method, MethodName};
use crate::contact::smooth::detail::COMPARED;
use crate::contact::solution::Solution;
use crate::contact::stiffness::Stiffness;
use crate::{Error, Vertical};

/// Points at which two resolutions are compared.
const COMPARISONS: usize = 33;
/// Points of a zone that show extremes, and of all of them.
const PLACES: usize = 256;
const MOST_PLACES: usize = 4096;
/// Rounding of a quantity relative to its size.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Zones, pressure, settlement and force of a circular punch on a smooth body, without tilt and without dimensions.
#[derive(Debug, Clone)]
pub(crate) struct SmoothRingsContact {
    problem: Arc<SmoothDisk>,
    solved: Solved,
    stiffness: Stiffness,
    accuracy: Accuracy,
    edge_error: f64,
    complementarity: Complementarity,
    largest: f64,
}

impl SmoothRingsContact {
    pub(super) fn new(base: &Base<'_>, solved: Solved, left: &Check) -> Result<Self, Error> {
        let (accuracy, edge_error) = estimate(base, &solved);
        let stiffness = solved.stiffness()?;
        let values = [
            ("force", solved.state.force),
            ("settlement", solved.state.settlement),
            ("pressure", left.largest),
            ("error of the pressure", accuracy.pressure),
        ];
        if let Some((quantity, value)) = values.into_iter().find(|(_, value)| !value.is_finite()) {
            return Err(Error::Overflow { quantity, value });
        }
        let (tension, penetration) = (left.tension, left.penetration);
        Ok(Self {
            problem: Arc::new(base.problem.clone()),
            solved,
            stiffness,
            accuracy,
            edge_error,
            complementarity: Complementarity { tension, penetration },
            largest: left.largest,
        })
    }

    /// `delta0`, zero at infinity.
    #[must_use]
    pub(crate) fn settlement0(&self) -> f64 {
        self.solved.state.settlement
    }

    /// `p0` at a distance `|xi|` from the axis: infinite at a corner and at a kink of the base, 0 beside the zones.
    #[must_use]
    pub(crate) fn pressure0(&self, xi: f64) -> f64 {
        self.solved.pressure(xi.abs())
    }

    /// The elastic displacement at a distance `|xi|` from the axis, also beyond the base.
    #[must_use]
    pub(crate) fn elastic_displacement0(&self, xi: f64) -> f64 {
        let r = xi.abs();
        match self.solved.zones.iter().find(|zone| zone.contains(r)) {
            Some(zone) => {
                // At a step the height is that of this side.
                let from = if zone.left() > 0.0 { zone.left().next_up() } else { 0.0 };
                let to = if zone.right() < 1.0 { zone.right().next_down() } else { 1.0 };
                self.settlement0() - (self.problem.height)(r.clamp(from, to))
            }
            None => self.solved.displacement_outside(r),
        }
    }

    /// `d(P0, M0)/d(delta0, -alpha0)` on these zones; free edges that move add nothing of first order.
    #[must_use]
    pub(crate) fn stiffness0(&self) -> Stiffness {
        self.stiffness
    }

    /// The largest `|p0|` seen between the singular places.
    #[must_use]
    pub(crate) fn largest_inside0(&self) -> f64 {
        self.largest
    }

    /// What is left of tension and penetration.
    #[must_use]
    pub(crate) fn complementarity(&self) -> Complementarity {
        self.complementarity
    }

    /// The estimated error; that of the pressure in the middle of the zones, nearer to an edge it grows as that of plane contact.
    #[must_use]
    pub(crate) fn accuracy(&self) -> &Accuracy {
        &self.accuracy
    }

    /// The estimated error of the free edges, in `xi`.
    #[must_use]
    pub(crate) fn edge_error0(&self) -> f64 {
        self.edge_error
    }

    /// The largest estimated error relative to its size.
    #[must_use]
    pub(crate) fn relative_error(&self) -> f64 {
        self.accuracy.relative(&self.solved.state.sizes(self.largest))
    }

    /// Number of coupled modes of the rings, and of coefficients of a disk.
    #[must_use]
    pub(crate) fn modes(&self) -> usize {
        self.solved.modes()
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
        let mut worst = 0.0f64;
        // An irrational share of the step keeps clear of symmetric places, where a kink may be.
        for i in 0..COMPARISONS {
            let angle = PI * (i as f64 + FRAC_1_SQRT_2) / COMPARISONS as f64;
            let other = coarse.as_ref().map_or(f64::INFINITY, |c| c.regular(j, angle));
            worst = worst.max((solved.regular(j, angle) - other).abs());
        }
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
    let by_force = matches!(base.problem.load.vertical, Vertical::Force(_));
    let of = |unknown: bool, error: f64| if unknown { error } else { 0.0 };
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure,
        settlement: of(by_force, change(|s| s.settlement) + level + ROUNDING * settlement.abs()),
        tilt: 0.0,
        force: of(!by_force, change(|s| s.force) + solved.rate * level + ROUNDING * force.abs()),
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
        self.stiffness0()
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        let rings = self.solved.parts.iter().map(|part| part.ring().zone.ends);
        let mirrored = rings.clone().rev().map(|[inner, outer]| [-outer, -inner]);
        let core = self.solved.core.as_ref().map(|core| [-core.radius, core.radius]);
        mirrored.chain(core).chain(rings).collect()
    }

    fn corner_intensity(&self) -> Option<Vec<[f64; 2]>> {
        let count = Solution::zones(self).len();
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
        self.pressure0(xi)
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
        self.elastic_displacement0(xi)
    }

    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        let zones = Solution::zones(self);
        let count = (MOST_PLACES / zones.len().max(1)).clamp(8, PLACES);
        let mut places = vec![-1.0, 1.0];
        for [left, right] in zones {
            places.extend((0..=count).map(|i| {
                let half = (0.5 * PI * i as f64 / count as f64).sin();
                (left + (right - left) * half * half).clamp(left, right)
            }));
        }
        places.sort_by(f64::total_cmp);
        places.dedup();
        let sampled = places.into_iter().map(|xi| (xi, self.pressure0(xi)));
        sampled.filter(|(_, pressure)| pressure.is_finite()).unzip()
    }

    fn method(&self) -> Method {
        Method { name: MethodName::FirstKind, n: self.modes() }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(SmoothRingsContact::accuracy(self))
    }

    fn relative_error(&self) -> f64 {
        SmoothRingsContact::relative_error(self)
    }

    fn edge_error(&self) -> Option<f64> {
        let is_free = self.solved.zones.iter().any(|zone| zone.has_free_end());
        is_free.then(|| self.edge_error0())
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.problem.is_unilateral.then(|| SmoothRingsContact::complementarity(self))
    }

    fn size(&self) -> f64 {
        self.largest_inside0()
    }
}
