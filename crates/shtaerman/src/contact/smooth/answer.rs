//! The answer of smooth contact.

use std::f64::consts::{FRAC_1_SQRT_2, PI};
use std::sync::Arc;

use super::detail::COMPARED;
use super::edges;
use super::legendre;
use super::problem::{Base, SmoothProblem};
use super::system::{Part, Place, Solved};
use super::wave::{FullWave, wrapped};
use crate::contact::accuracy::{Accuracy, ErrorKind, Sizes};
use crate::contact::balance::State;
use crate::contact::check::Check;
use crate::contact::complementarity::Complementarity;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::{Error, Rotational, Vertical};

/// Points at which two resolutions are compared.
const COMPARISONS: usize = 33;
/// Rounding of settlement, tilt, force and moment relative to their size.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Panels of the force on a part of a zone.
const PANELS: usize = 64;

/// A zone of smooth contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SmoothZone {
    /// Left and right end, `xi`; of a base that repeats without gaps the left end may lie beyond `-1`, and full contact is `-1, 1`.
    pub(crate) ends: [f64; 2],
    /// Whether each end is free, with a pressure that vanishes as `sqrt(d)`; else it rests at a wall.
    pub(crate) is_free: [bool; 2],
    /// Corner intensities `lim sqrt(2 pi d) p0`, `d` the distance from the end in `xi`: times `E sqrt(a)` those of the problem. 0 at free ends.
    pub(crate) intensity0: [f64; 2],
    /// Force on the zone, `P/(a E)`.
    pub(crate) force0: f64,
}

/// Zones, pressure, settlement, tilt, force and moment of contact without a layer, all without dimensions.
#[derive(Debug, Clone)]
pub(crate) struct SmoothContact {
    problem: Arc<SmoothProblem>,
    solution: Solution,
    /// The place of the base's own zero: a wave is turned.
    shift: f64,
    state: State,
    accuracy: Accuracy,
    edge_error: f64,
    complementarity: Complementarity,
    largest: f64,
    /// Difference of the largest and the smallest height.
    range: f64,
}

#[derive(Debug, Clone)]
enum Solution {
    Zones(Solved),
    Full(FullWave),
}

impl SmoothContact {
    pub(super) fn new(base: &Base<'_>, solved: Solved, left: &Check) -> Result<Self, Error> {
        let complementarity = if base.problem.is_unilateral {
            Complementarity { tension: left.tension, penetration: left.penetration }
        } else {
            Complementarity { tension: left.tension, penetration: 0.0 }
        };
        let (accuracy, edge_error) = estimate(base, &solved);
        let state = solved.state;
        let values = [
            ("force", state.force),
            ("moment", state.moment),
            ("settlement", state.settlement),
            ("tilt", state.tilt),
            ("pressure", left.largest),
            ("error of the pressure", accuracy.pressure),
        ];
        if let Some((quantity, value)) = values.into_iter().find(|(_, value)| !value.is_finite()) {
            return Err(Error::Overflow { quantity, value });
        }
        Ok(Self {
            problem: Arc::new(base.problem.clone()),
            solution: Solution::Zones(solved),
            shift: 0.0,
            state,
            accuracy,
            edge_error,
            complementarity,
            largest: left.largest,
            range: base.range(),
        })
    }

    /// Full contact of a wave.
    pub(super) fn full(base: &Base<'_>, full: FullWave) -> Self {
        let state = State {
            settlement: full.settlement(),
            tilt: 0.0,
            force: full.force,
            moment: full.moment(&base.problem.profile.breaks),
        };
        let points: Vec<(f64, f64)> = (0..=1024)
            .map(|i| f64::from(i) / 512.0 - 1.0)
            .map(|xi| (xi, full.pressure(xi)))
            .filter(|(_, p)| p.is_finite())
            .collect();
        let largest = points.iter().fold(f64::MIN_POSITIVE, |most, (_, p)| most.max(p.abs()));
        let most = points.iter().fold(0.0f64, |most, (_, p)| most.max(-p));
        let pressure = full.error[0] / full.theta0 + ROUNDING * largest;
        let accuracy = Accuracy {
            kind: ErrorKind::Estimate,
            pressure,
            settlement: full.error[1] + ROUNDING * state.settlement.abs(),
            tilt: 0.0,
            force: 0.0,
            moment: pressure,
        };
        Self {
            problem: Arc::new(base.problem.clone()),
            solution: Solution::Full(full),
            shift: 0.0,
            state,
            accuracy,
            edge_error: 0.0,
            complementarity: Complementarity { tension: most / largest, penetration: 0.0 },
            largest,
            range: base.range(),
        }
    }

    /// The same wave with its seam back where it was; `place` became `+-1`.
    pub(super) fn turned(mut self, problem: &SmoothProblem, place: f64) -> Self {
        self.shift = place - 1.0;
        self.problem = Arc::new(problem.clone());
        self.state.moment += self.shift * self.state.force + 2.0 * self.force_before_seam();
        self
    }

    /// The same as answer to this settlement.
    pub(super) fn settled(mut self, settlement: f64) -> Self {
        let rounding = ROUNDING * self.state.force;
        let stiffness = self.stiffness0().force_settlement;
        self.accuracy.force = stiffness * self.accuracy.settlement + rounding;
        self.accuracy.settlement = 0.0;
        self.state.settlement = settlement;
        self
    }

    /// The zones with their densities; none for full contact of a wave.
    pub(super) fn solved(&self) -> Option<&Solved> {
        match &self.solution {
            Solution::Zones(solved) => Some(solved),
            Solution::Full(_) => None,
        }
    }

    /// Force on what the turn took below `-1`.
    fn force_before_seam(&self) -> f64 {
        let Solution::Zones(solved) = &self.solution else { return 0.0 };
        let seam = -1.0 - self.shift;
        let of = |part: &Part| {
            let Zone { ends: [left, right], .. } = part.zone;
            if right <= seam {
                return part.force();
            }
            if left >= seam {
                return 0.0;
            }
            let start = part.place(seam).angle();
            let width = (PI - start) / PANELS as f64;
            (0..PANELS)
                .map(|i| {
                    let from = start + width * i as f64;
                    legendre::integral(from, from + width, |angle| part.density(angle))
                })
                .sum()
        };
        solved.parts.iter().map(of).sum::<f64>() / solved.theta0
    }

    /// The problem solved.
    #[must_use]
    pub(crate) fn problem(&self) -> &SmoothProblem {
        &self.problem
    }

    /// `P0`; where it is prescribed, as given.
    #[must_use]
    pub(crate) fn force0(&self) -> f64 {
        self.state.force
    }

    /// `M0 = int xi p0 dxi`; where it is prescribed, as given.
    #[must_use]
    pub(crate) fn moment0(&self) -> f64 {
        self.state.moment
    }

    /// `delta0` in the gauge of the kernel.
    #[must_use]
    pub(crate) fn settlement0(&self) -> f64 {
        self.state.settlement
    }

    /// `alpha0`.
    #[must_use]
    pub(crate) fn tilt0(&self) -> f64 {
        self.state.tilt
    }

    /// The zones of contact from left to right.
    #[must_use]
    pub(crate) fn zones(&self) -> Vec<SmoothZone> {
        let solved = match &self.solution {
            Solution::Zones(solved) => solved,
            Solution::Full(full) => {
                let (ends, is_free) = ([-1.0, 1.0], [false; 2]);
                return vec![SmoothZone {
                    ends,
                    is_free,
                    intensity0: [0.0; 2],
                    force0: full.force,
                }];
            }
        };
        let of = |(j, part): (usize, &Part)| {
            let ends = part.zone.ends;
            let is_free = [0, 1].map(|side| part.zone.is_free(side));
            let intensity = |side: usize| {
                if is_free[side] { 0.0 } else { solved.intensity(j, side) }
            };
            // As a zone of the base: its right end in -1 .. 1.
            let mut ends = ends.map(|end| end + self.shift);
            if self.shift != 0.0 && ends[1] <= -1.0 {
                ends = ends.map(|end| end + 2.0);
            }
            let intensity0 = [intensity(0), intensity(1)];
            SmoothZone { ends, is_free, intensity0, force0: part.force() / solved.theta0 }
        };
        let mut zones: Vec<SmoothZone> = solved.parts.iter().enumerate().map(of).collect();
        zones.sort_by(|one, two| one.ends[0].total_cmp(&two.ends[0]));
        zones
    }

    /// `p0(xi)`: infinite at a singular end, 0 outside the zones; what repeats is continued.
    #[must_use]
    pub(crate) fn pressure0(&self, xi: f64) -> f64 {
        match &self.solution {
            // In a gap narrower than rounding that a hollow kink opens.
            Solution::Full(full) if self.problem.is_unilateral => {
                let pressure = full.pressure(wrapped(xi));
                if pressure == f64::NEG_INFINITY { 0.0 } else { pressure }
            }
            Solution::Full(full) => full.pressure(wrapped(xi)),
            Solution::Zones(solved) => solved.pressure_at(self.local(solved, xi)),
        }
    }

    /// [`p0`](Self::pressure0) at many places, which costs less than one by one.
    #[must_use]
    pub(crate) fn pressures0(&self, places: &[f64]) -> Vec<f64> {
        let Solution::Zones(solved) = &self.solution else {
            return places.iter().map(|&xi| self.pressure0(xi)).collect();
        };
        solved.pressures(places.iter().map(|&xi| self.local(solved, xi)))
    }

    /// `p0` in a zone of [`zones`](Self::zones) by the distances from both of its ends, the smaller of which may be far below the rounding of `xi`.
    #[must_use]
    pub(crate) fn pressure_beside0(&self, zone: usize, from_left: f64, from_right: f64) -> f64 {
        let (Solution::Zones(solved), Some(ends)) =
            (&self.solution, self.zones().get(zone).map(|zone| zone.ends))
        else {
            return self.pressure0(from_left - 1.0);
        };
        let middle = self.local(solved, 0.5 * (ends[0] + ends[1]));
        let own = solved.parts.iter().position(|part| part.zone.contains(middle));
        let place = Place { from_left: from_left.max(0.0), from_right: from_right.max(0.0) };
        own.map_or(f64::NAN, |j| solved.pressure(j, place))
    }

    /// `theta0 int K(xi - eta) p0(eta) deta`, the elastic displacement at any `xi`, also beyond the base.
    #[must_use]
    pub(crate) fn elastic_displacement0(&self, xi: f64) -> f64 {
        let height = |xi: f64| (self.problem.profile.height)(xi);
        match &self.solution {
            Solution::Full(_) => self.state.settlement - height(wrapped(xi)),
            Solution::Zones(solved) => {
                let place = self.local(solved, xi);
                let zone = solved.parts.iter().find(|part| part.zone.contains(place));
                match zone {
                    Some(part) => {
                        // The profile itself knows no turn.
                        let inside = part.zone.inside(place) + self.shift;
                        let own = if self.shift == 0.0 { inside } else { wrapped(inside) };
                        self.state.settlement - self.state.tilt * place - height(own)
                    }
                    None => solved.displacement_outside(place),
                }
            }
        }
    }

    /// `d(P0, M0)/d(delta0, -alpha0)` on these zones; free edges that move add nothing of first order. Infinite for full contact of a wave, whose
    /// settlement does not depend on the force.
    #[must_use]
    pub(crate) fn stiffness0(&self) -> Stiffness {
        match &self.solution {
            Solution::Zones(solved) => solved.stiffness,
            Solution::Full(_) => Stiffness {
                force_settlement: f64::INFINITY,
                coupling: 0.0,
                moment_tilt: f64::INFINITY,
            },
        }
    }

    /// The largest `|p0|` seen between the singular places.
    #[must_use]
    pub(crate) fn largest_inside0(&self) -> f64 {
        self.largest
    }

    /// Whether the base touches at `xi`.
    #[must_use]
    pub(crate) fn is_contact(&self, xi: f64) -> bool {
        match &self.solution {
            Solution::Full(_) => true,
            Solution::Zones(solved) => {
                let place = self.local(solved, xi);
                solved.parts.iter().any(|part| part.zone.contains(place))
            }
        }
    }

    /// What is left of tension and penetration.
    #[must_use]
    pub(crate) fn complementarity(&self) -> Complementarity {
        self.complementarity
    }

    /// The estimated error; that of the pressure in the middle of the zones, nearer to an end it grows as `1/sqrt(1 - y^2)`, `y` in `-1 .. 1` along the zone.
    #[must_use]
    pub(crate) fn accuracy(&self) -> &Accuracy {
        &self.accuracy
    }

    /// The estimated error of the free edges, in `xi`.
    #[must_use]
    pub(crate) fn edge_error0(&self) -> f64 {
        self.edge_error
    }

    /// The largest estimated error relative to its size; of the pressure the largest between the singular ends.
    #[must_use]
    pub(crate) fn relative_error(&self) -> f64 {
        let sizes = self.state.sizes(self.largest);
        // The settlement of a wave in full contact is the mean of its heights, which may be nothing.
        let displacement = sizes.displacement.max(self.range);
        self.accuracy.relative(&Sizes { displacement, ..sizes })
    }

    /// Number of coupled modes in all zones.
    #[must_use]
    pub(crate) fn modes(&self) -> usize {
        match &self.solution {
            Solution::Zones(solved) => solved.modes(),
            Solution::Full(_) => 0,
        }
    }

    /// A place in the turn of the solution.
    pub(super) fn local(&self, solved: &Solved, xi: f64) -> f64 {
        if self.shift == 0.0 { solved.kernel.reduced(xi) } else { wrapped(xi - self.shift) }
    }
}

/// The error by comparison with fewer modes and other panels on the same zones, and that of the edges; none for what the load prescribes.
fn estimate(base: &Base<'_>, solved: &Solved) -> (Accuracy, f64) {
    let coarse = solved.again(base, COMPARED).ok();
    let (mut pressure, mut edge) = (0.0f64, 0.0f64);
    let change = |part: fn(&State) -> f64| {
        coarse
            .as_ref()
            .map_or(f64::INFINITY, |coarse| (part(&solved.state) - part(&coarse.state)).abs())
    };
    for (j, part) in solved.parts.iter().enumerate() {
        let mut density = 0.0f64;
        // An irrational share of the step keeps clear of symmetric places, where a kink may be.
        for i in 0..COMPARISONS {
            let angle = PI * (i as f64 + FRAC_1_SQRT_2) / COMPARISONS as f64;
            let other = coarse.as_ref().map_or(f64::INFINITY, |c| c.parts[j].density(angle));
            density = density.max((part.density(angle) - other).abs());
        }
        let density = density + solved.rounding(j);
        pressure = pressure.max(density / (solved.theta0 * part.half()));
        let at_ends = (0..2).fold(0.0f64, |most, side| {
            let other = coarse.as_ref().map_or(f64::INFINITY, |c| c.end_density(j, side));
            most.max((solved.end_density(j, side) - other).abs())
        });
        edge = edge.max(edges::end_error(solved, j, at_ends + solved.end_rounding(j)));
    }
    let of = |unknown: bool, part: fn(&State) -> f64, floor: f64| {
        if unknown { change(part) + floor } else { 0.0 }
    };
    let state = &solved.state;
    let displacement = state.settlement.abs().max(state.tilt.abs());
    let size = state.force.abs().max(state.moment.abs());
    let by_force = matches!(base.problem.load.vertical, Vertical::Force(_));
    let rotational = base.problem.load.rotational;
    let by_tilt = matches!(rotational, Rotational::Tilt(_));
    let by_moment = matches!(rotational, Rotational::Moment(_));
    let [level, turn] = solved.displacement_rounding();
    let stiffness = solved.stiffness;
    let forced = stiffness.force_settlement * level + stiffness.moment_tilt * turn;
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure,
        settlement: of(by_force, |state| state.settlement, level + ROUNDING * displacement),
        tilt: of(!by_tilt, |state| state.tilt, turn + ROUNDING * displacement),
        force: of(!by_force, |state| state.force, forced + ROUNDING * size),
        moment: of(!by_moment, |state| state.moment, forced + ROUNDING * size),
    };
    (accuracy, edge)
}
