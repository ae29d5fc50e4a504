//! The answer of smooth contact.

use std::f64::consts::PI;
use std::sync::Arc;

use super::band::wrapped;
use super::detail::COMPARED;
use super::edges;
use super::full::FullWave;
use super::problem::{Base, SmoothProblem};
use super::system::{Part, Place, Solved};
use super::told::{Told, compared, places};
use crate::contact::accuracy::ROUNDING;
use crate::contact::accuracy::{Accuracy, ErrorKind, Sizes};
use crate::contact::balance::State;
use crate::contact::check::Check;
use crate::contact::complementarity::Complementarity;
use crate::contact::method::{Method, MethodName};
use crate::contact::rates::Linearised;
use crate::contact::solution::Solution;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::{Error, Load};

/// Panels of the force on a part of a zone, and of the moment of a wave. At half or twice 3 of 5 answers change, within what they state (survey).
pub(super) const PANELS: usize = 64;

/// Zones, pressure, settlement, tilt, force and moment of contact without a layer, all without dimensions.
#[derive(Debug, Clone)]
pub(crate) struct SmoothContact {
    problem: Arc<SmoothProblem>,
    solution: Known,
    /// The place of the base's own zero: a wave is turned.
    shift: f64,
    state: State,
    told: Told,
    /// Difference of the largest and the smallest height.
    range: f64,
}

#[derive(Debug, Clone)]
enum Known {
    Zones(Solved),
    Full(FullWave),
}

impl SmoothContact {
    pub(super) fn new(base: &Base<'_>, solved: Solved, left: &Check) -> Result<Self, Error> {
        let penetration = if base.problem.is_unilateral { left.penetration } else { 0.0 };
        let stated = (&base.problem.load, &solved.state);
        let shares = [left.tension, penetration];
        let told = Told::new(stated, left.largest, estimate(base, &solved), shares)?;
        let (problem, state) = (Arc::new(base.problem.clone()), solved.state);
        let (solution, range) = (Known::Zones(solved), base.range());
        Ok(Self { problem, solution, shift: 0.0, state, told, range })
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
        let complementarity = Complementarity { tension: most / largest, penetration: 0.0 };
        let told = Told { accuracy, edge_error: 0.0, complementarity, largest };
        let (problem, range) = (Arc::new(base.problem.clone()), base.range());
        Self { problem, solution: Known::Full(full), shift: 0.0, state, told, range }
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
        let stiffness = self.stiffness().force_settlement;
        let accuracy = &mut self.told.accuracy;
        accuracy.force = stiffness * accuracy.settlement + rounding;
        accuracy.settlement = 0.0;
        self.state.settlement = settlement;
        self
    }

    /// The zones with their densities; none for full contact of a wave.
    pub(super) fn solved(&self) -> Option<&Solved> {
        match &self.solution {
            Known::Zones(solved) => Some(solved),
            Known::Full(_) => None,
        }
    }

    /// Force on what the turn took below `-1`.
    fn force_before_seam(&self) -> f64 {
        let Known::Zones(solved) = &self.solution else { return 0.0 };
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
                    fredholm::inversion::integral(from, from + width, |angle| part.density(angle))
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

    /// A place in the turn of the solution.
    pub(super) fn local(&self, solved: &Solved, xi: f64) -> f64 {
        if self.shift == 0.0 { solved.kernel.reduced(xi) } else { wrapped(xi - self.shift) }
    }

    /// The ends of the zones from left to right, each with its number in the solution; of a base that repeats without gaps the left end may lie beyond `-1`. None in
    /// full contact of a wave.
    fn turned_zones(&self) -> Vec<([f64; 2], usize)> {
        let Known::Zones(solved) = &self.solution else { return Vec::new() };
        let of = |(j, part): (usize, &Part)| {
            let mut ends = part.zone.ends.map(|end| end + self.shift);
            if self.shift != 0.0 && ends[1] <= -1.0 {
                ends = ends.map(|end| end + 2.0);
            }
            (ends, j)
        };
        let mut zones: Vec<([f64; 2], usize)> = solved.parts.iter().enumerate().map(of).collect();
        zones.sort_by(|one, two| one.0[0].total_cmp(&two.0[0]));
        zones
    }
}

impl Solution for SmoothContact {
    fn state(&self) -> State {
        self.state
    }

    /// Infinite for full contact of a wave, whose settlement does not depend on the force.
    fn stiffness(&self) -> Stiffness {
        match &self.solution {
            Known::Zones(solved) => solved.stiffness,
            Known::Full(_) => Stiffness {
                force_settlement: f64::INFINITY,
                coupling: 0.0,
                moment_tilt: f64::INFINITY,
            },
        }
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        match &self.solution {
            Known::Zones(_) => self.turned_zones().into_iter().map(|(ends, _)| ends).collect(),
            Known::Full(_) => vec![[-1.0, 1.0]],
        }
    }

    fn touches(&self, xi: f64) -> bool {
        match &self.solution {
            Known::Full(_) => true,
            Known::Zones(solved) => {
                let place = self.local(solved, xi);
                solved.parts.iter().any(|part| part.zone.contains(place))
            }
        }
    }

    fn corner_intensity(&self) -> Option<Vec<[f64; 2]>> {
        let Known::Zones(solved) = &self.solution else { return Some(vec![[0.0; 2]]) };
        let intensity = |j: usize, side: usize| {
            let is_free = solved.parts[j].zone.is_free(side);
            if is_free { 0.0 } else { solved.intensity(j, side) }
        };
        let of = |(_, j): ([f64; 2], usize)| [0, 1].map(|side| intensity(j, side));
        Some(self.turned_zones().into_iter().map(of).collect())
    }

    /// What repeats is continued.
    fn pressure(&self, xi: f64) -> f64 {
        match &self.solution {
            // In a gap narrower than rounding that a hollow kink opens.
            Known::Full(full) if self.problem.is_unilateral => {
                let pressure = full.pressure(wrapped(xi));
                if pressure == f64::NEG_INFINITY { 0.0 } else { pressure }
            }
            Known::Full(full) => full.pressure(wrapped(xi)),
            Known::Zones(solved) => solved.pressure_at(self.local(solved, xi)),
        }
    }

    fn pressures(&self, places: &[f64]) -> Vec<f64> {
        let Known::Zones(solved) = &self.solution else {
            return places.iter().map(|&xi| self.pressure(xi)).collect();
        };
        solved.pressures(places.iter().map(|&xi| self.local(solved, xi)))
    }

    fn pressure_beside(&self, zone: usize, from_left: f64, from_right: f64) -> f64 {
        let (Known::Zones(solved), Some((_, j))) =
            (&self.solution, self.turned_zones().get(zone).copied())
        else {
            return self.pressure(from_left - 1.0);
        };
        let place = Place { from_left: from_left.max(0.0), from_right: from_right.max(0.0) };
        solved.pressure(j, place)
    }

    fn displacement(&self, xi: f64) -> f64 {
        let height = |xi: f64| (self.problem.profile.height)(xi);
        let Known::Zones(solved) = &self.solution else {
            return self.state.settlement - height(wrapped(xi));
        };
        let place = self.local(solved, xi);
        let Some(part) = solved.parts.iter().find(|part| part.zone.contains(place)) else {
            return solved.displacement_outside(place);
        };
        // The profile itself knows no turn.
        let inside = part.zone.inside(place) + self.shift;
        let own = if self.shift == 0.0 { inside } else { wrapped(inside) };
        self.state.settlement - self.state.tilt * place - height(own)
    }

    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        let places = places(&self.zones());
        let pressures = self.pressures(&places);
        places.into_iter().zip(pressures).filter(|(_, p)| p.is_finite()).unzip()
    }

    /// With as many coupled modes in all zones.
    fn method(&self) -> Method {
        let n = self.solved().map_or(0, Solved::modes);
        Method { name: MethodName::FirstKind, n }
    }

    /// Of the pressure in the middle of the zones: nearer to an end it grows as `1/sqrt(1 - y^2)`, `y` in `-1 .. 1` along the zone.
    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.told.accuracy)
    }

    fn relative_error(&self) -> f64 {
        let sizes = self.state.sizes(self.told.largest);
        // The settlement of a wave in full contact is the mean of its heights, which may be nothing.
        let displacement = sizes.displacement.max(self.range);
        self.told.accuracy.relative(&Sizes { displacement, ..sizes })
    }

    fn edge_error(&self) -> Option<f64> {
        let is_free = self.solved()?.parts.iter().any(|part| part.zone.has_free_end());
        is_free.then_some(self.told.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.problem.is_unilateral.then_some(self.told.complementarity)
    }

    fn linearised(&self, _load: Load, peak: f64) -> Option<Linearised> {
        self.first_order(peak)
    }

    fn size(&self) -> f64 {
        self.told.largest
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
        let density = compared(
            |angle| part.density(angle),
            |angle| coarse.as_ref().map_or(f64::INFINITY, |c| c.parts[j].density(angle)),
        );
        let density = density + solved.rounding(j);
        pressure = pressure.max(density / (solved.theta0 * part.half()));
        let at_ends = (0..2).fold(0.0f64, |most, side| {
            let other = coarse.as_ref().map_or(f64::INFINITY, |c| c.end_density(j, side));
            most.max((solved.end_density(j, side) - other).abs())
        });
        edge = edge.max(edges::end_error(solved, j, at_ends + solved.end_rounding(j)));
    }
    let state = &solved.state;
    let displacement = state.settlement.abs().max(state.tilt.abs());
    let size = state.force.abs().max(state.moment.abs());
    let [level, turn] = solved.displacement_rounding();
    let stiffness = solved.stiffness;
    let forced = stiffness.force_settlement * level + stiffness.moment_tilt * turn;
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure,
        settlement: change(|state| state.settlement) + level + ROUNDING * displacement,
        tilt: change(|state| state.tilt) + turn + ROUNDING * displacement,
        force: change(|state| state.force) + forced + ROUNDING * size,
        moment: change(|state| state.moment) + forced + ROUNDING * size,
    };
    (accuracy, edge)
}
