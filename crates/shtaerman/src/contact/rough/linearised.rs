//! The linearised equation on the zones of a solution: how everything changes with the body and the load.
//!
//! `law(p0) + theta0 K p0 = delta0 - alpha0 xi - f0` is written for the displacement `v` of the layer, `p0 = p(v)`: for a law that bends `dlaw/dp0` is infinite at a
//! free edge, but `p'(v)` vanishes there. Changed by a parameter on zones that stay,
//!
//! `v' + theta0 K(p'(v) v') = delta0' - alpha0' xi - (theta0)'/theta0 * theta0 K p0`,
//!
//! the operator of Newton's steps and of the stiffness. What a free edge `e` adds is of second order, as the pressure vanishes there; it moves by `e' = -v'/(dv/dxi)`.

mod tilted;

use fredholm::SincSolution;
use fredholm::collocation::{extrapolate, first_half_count, rounding};

use super::answer::UnilateralContact;
use super::base::Base;
use super::effort::Effort;
use super::refinement::RATIO;
use super::solved::{end_node, place};
use super::system::{FEWEST, Factor, Resolution, System};
use crate::contact::accuracy::ROUNDING;
use crate::contact::ground::SHARP;
use crate::contact::rates::{Linearised, Rates};
use crate::contact::setting::Setting;
use crate::contact::zones::{EndKind, Zone};
use crate::{ContactKind, Error, Load, Rotational};

/// Nodes of a full base that was not collocated, for each Chebyshev degree of its profile. At half or twice 3 of 10 answers change, within what they state (survey).
const NODES_PER_DEGREE: f64 = 2.0;

/// A solution, on whatever nodes.
struct Known<'k, 'p> {
    base: &'k Base<'p>,
    zones: &'k [Zone],
    /// `v(xi)`.
    layer: &'k dyn Fn(f64) -> f64,
    /// `theta0 K p0` at `xi`.
    displacement: &'k dyn Fn(f64) -> f64,
    tilt: f64,
    /// Where the pressure is largest.
    peak: f64,
    /// Rounding of `v` over the length `1/theta0` in which its slope at an edge changes where the layer is thin.
    noise: f64,
}

impl UnilateralContact {
    /// The first-order change of the solution.
    pub(super) fn first_order(&self, load: Load, peak: f64) -> Option<Linearised> {
        let (solved, setting) = (self.solved(), self.setting());
        let mut base = Base::new(setting, setting.problem().solver().contact).ok()?;
        base.anchor = self.anchor();
        base.load.vertical = load.vertical;
        // The tilt of a disk is another harmonic, a wave has none.
        if !base.ground.is_disk() && !base.ground.is_closed() {
            base.load.rotational = load.rotational;
        }
        let located = self.locate(peak).abs();
        let is_corner = solved.zones.iter().any(|zone| {
            (0..2).any(|side| zone.kinds[side] == EndKind::Wall && zone.ends[side].abs() == located)
        });
        // There the pressure goes as `d^(1-mu)`, and no double is near enough to a corner: differences tell.
        if is_corner && base.ground.exponent() >= SHARP {
            return None;
        }
        base.anchor = self.anchor();
        if base.ground.is_closed() {
            base = base.shifted(solved.hull.centre - 1.0);
        }
        // As the solution itself was cut.
        base.breaks = solved.breaks();
        let tilt = if base.ground.is_disk() { 0.0 } else { solved.state.tilt };
        let known = Known {
            base: &base,
            zones: &solved.zones,
            layer: &|xi| solved.layer(&base, xi),
            displacement: &|xi| solved.state.settlement - tilt * xi - solved.layer_at(xi, 0.0),
            tilt,
            peak: self.locate(peak),
            noise: base.steepness() * solved.rounding(),
        };
        let found = known.linearised(solved.panel_count() / 2)?;
        match self.tilted() {
            Some(tilted) => tilted::turned(&base, solved, tilted, found, peak),
            None => Some(found),
        }
    }
}

impl Setting {
    /// The first-order change of a solution by the degenerate kernel, given its displacement `theta0 K p0` and the degree that its profile needs.
    pub(in crate::contact) fn linearised_whole_base(
        &self,
        displacement: &dyn Fn(f64) -> f64,
        profile_degree: usize,
        peak: f64,
    ) -> Option<Linearised> {
        let base = Base::new(self, ContactKind::Bilateral).ok()?;
        let base = base.cut(&self.collocated_parts());
        let panels = base.breaks.len() + 1;
        let smooth = first_half_count(base.steepness()).max(FEWEST as f64);
        let wanted = smooth + NODES_PER_DEGREE * profile_degree as f64;
        // Of a linear layer the pressure itself counts for nothing.
        let known = Known {
            base: &base,
            zones: &base.whole(),
            layer: &|_| 1.0,
            displacement,
            tilt: 0.0,
            peak,
            noise: 0.0,
        };
        known.linearised(wanted.min(0.5 * Effort::LITTLE.nodes as f64 / panels as f64) as usize)
    }
}

impl Known<'_, '_> {
    /// By three numbers of nodes, the last of which is given.
    fn linearised(&self, half_count: usize) -> Option<Linearised> {
        let level = |power: i32| {
            let count = (half_count as f64 * RATIO.powi(power)).round().max(FEWEST as f64) as usize;
            Level::new(self, count).and_then(|level| level.rates()).ok()
        };
        let (coarse, middle, fine) = (level(-2)?, level(-1)?, level(0)?);
        let errors = std::array::from_fn(|input| {
            std::array::from_fn(|k| {
                let of = |found: &[Change; 3]| found[input].rates[k];
                let (one, two, three) = (of(&coarse), of(&middle), of(&fine));
                let scale = three.abs().max(f64::MIN_POSITIVE);
                let resolved = extrapolate((one - two).abs(), (two - three).abs(), scale, RATIO);
                resolved + fine[input].noise[k]
            })
        });
        Some(Linearised { rates: fine.map(|change| change.rates), errors })
    }
}

/// A first-order change, with its rounding.
#[derive(Default, Clone, Copy)]
struct Change {
    rates: Rates,
    noise: Rates,
}

/// A free edge: the node beside it, and `dv/dxi` outwards there with its rounding.
struct Edge {
    node: usize,
    slope: f64,
    noise: f64,
}

/// The linearised equation on some nodes.
struct Level<'k, 'b, 'p> {
    known: &'k Known<'b, 'p>,
    system: System<'b, 'p>,
    /// `v` at the nodes.
    layer: Vec<f64>,
}

impl<'k, 'b, 'p> Level<'k, 'b, 'p> {
    fn new(known: &'k Known<'b, 'p>, half_count: usize) -> Result<Self, Error> {
        let resolution = Resolution::new(&known.base.ground, half_count as f64)?;
        let system = System::new(known.base, &resolution, known.zones)?;
        let layer = system.positions.iter().map(|&xi| (known.layer)(xi)).collect();
        Ok(Self { known, system, layer })
    }

    fn rates(&self) -> Result<[Change; 3], Error> {
        let system = &self.system;
        let law = self.known.base.layer;
        let factor = if law.is_linear() {
            Factor::Linear(system.operator.factor(system.parameter())?)
        } else {
            let weights: Vec<f64> = self.layer.iter().map(|v| law.slope(*v)).collect();
            Factor::Weighted(system.operator.factor_weighted(system.parameter(), &weights)?)
        };
        let frame = system.frame(&factor)?;
        let given: Vec<f64> =
            system.positions.iter().map(|&xi| -(self.known.displacement)(xi)).collect();
        let elastic = system.direction(&factor.solve(&given)?, 1.0, [0.0; 2]);
        let edges = self.edges()?;
        // The tilt of a disk is another harmonic, a wave has none.
        let is_level = system.ground.is_disk() || system.ground.is_closed();
        let rotates =
            !is_level && !matches!(system.base.load.rotational, Rotational::Eccentricity(_));
        let rates = |share: f64, prescribed: [f64; 2]| -> Result<Change, Error> {
            let conditions = system.conditions_for(prescribed);
            let local = system.met(&frame, &elastic.scaled(share), conditions)?;
            let right: Vec<f64> = (system.operator.positions().zip(&given))
                .map(|(y, g)| share * g + local[0] - local[1] * y)
                .collect();
            let solution = factor.solve(&right)?;
            Ok(self.change(&solution, share, local, &edges))
        };
        Ok([
            rates(1.0, [0.0, 0.0])?,
            rates(0.0, [1.0, 0.0])?,
            if rotates { rates(0.0, [0.0, 1.0])? } else { Change::default() },
        ])
    }

    /// What a change of the layer with these changes of `ln theta0`, `D` and `beta` amounts to.
    fn change(
        &self,
        solution: &SincSolution,
        share: f64,
        local: [f64; 2],
        edges: &[Edge],
    ) -> Change {
        let system = &self.system;
        let state = system.changes(&system.direction(solution, 1.0, local));
        let Known { base, layer, displacement, peak, noise: of_layer, .. } = self.known;
        let place = place(&system.panels, &system.hull, *peak);
        let given = -share * displacement(*peak) + local[0] - local[1] * place.position;
        let slope = base.layer.slope(layer(*peak));
        let pressure = slope * solution.evaluate_place(place, given);
        let rounded = rounding(solution);
        // An image on the other side of the axis moves along.
        let sides = if base.ground.is_disk() { 2.0 } else { 1.0 };
        let (mut width, mut noise) = (0.0, 0.0);
        for Edge { node, slope, noise: of_slope } in edges {
            let moved = -sides * solution.values()[*node] / slope;
            width += moved;
            noise += (sides * rounded + moved.abs() * (of_slope + of_layer)) / slope.abs();
        }
        Change {
            rates: [state.settlement, state.force, state.tilt, pressure, width],
            noise: [0.0, 0.0, 0.0, slope * rounded, noise],
        }
    }

    /// The free edges.
    fn edges(&self) -> Result<Vec<Edge>, Error> {
        let Known { base, zones, .. } = self.known;
        let free: Vec<(usize, usize)> = (0..zones.len())
            .flat_map(|zone| zones[zone].free_ends().map(move |(side, _)| (zone, side)))
            .collect();
        if free.is_empty() {
            return Ok(Vec::new());
        }
        let system = &self.system;
        let pressures: Vec<f64> = self.layer.iter().map(|v| base.layer.pressure(*v)).collect();
        let nothing = vec![0.0; pressures.len()];
        let solution = system.operator.response(system.parameter(), &nothing, &pressures)?;
        let measure = system.ground.measure(&system.hull);
        let masses: Vec<f64> = solution.node_masses().iter().map(|mass| measure * mass).collect();
        let count = system.panel_count();
        Ok(free
            .into_iter()
            .map(|(zone, side)| {
                let node = end_node(&system.panels, count, zone, side);
                let (slope, noise) = self.layer_slope(zones[zone].ends[side], &masses);
                Edge { node, slope: if side == 0 { -slope } else { slope }, noise }
            })
            .collect())
    }

    /// `dv/dxi = -alpha0 - f0' - theta0 k int dK/dxi p0 dm` at a free edge, where the pressure vanishes, and its rounding.
    fn layer_slope(&self, edge: f64, masses: &[f64]) -> (f64, f64) {
        let Known { base, tilt, .. } = self.known;
        let profile = base.slope(edge);
        let (mut body, mut size) = (0.0, tilt.abs() + profile.abs());
        for (&xi, mass) in self.system.positions.iter().zip(masses) {
            let part = self.system.strength() * mass * base.ground.slope(edge, xi);
            body += part;
            size += part.abs();
        }
        (-tilt - profile - body, ROUNDING * size)
    }
}
