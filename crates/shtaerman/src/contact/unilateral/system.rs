//! The equations on given zones: pressure, settlement and tilt under the load, and how they change when an edge moves.
//!
//! With the hull of the zones `c - b .. c + b`, `xi = c + b y`, the equation becomes one on panels of `(-1, 1)` with `theta = b theta0`,
//!
//! `p + theta int ln(1/|y - t|) p dt = D - beta y - f0(c + b y)`, `D = delta0 - alpha0 c + theta0 P0 ln b`, `beta = b alpha0`.
//!
//! An edge that moves with the velocity `V`, straight on its panel and zero elsewhere, changes the pressure at points that move along by `p'` with
//!
//! `A p' = -(alpha0 + f0') V - theta0 int [V'(s) ln(1/|x - s|) - (V(x) - V(s))/(x - s)] p(s) ds`.

use std::cell::OnceCell;
use std::sync::Arc;

use fredholm::collocation::{Place, SincFactor, SincGrid, rounding};
use fredholm::kernel::Logarithm;
use fredholm::{SincOperator, SincSolution};

use super::base::Base;
use super::elimination;
use super::zones::Zone;
use crate::contact::balance::State;
use crate::contact::solved::Stiffness;
use crate::{Error, Rotational, Vertical};

/// Steps of the difference quotient of the profile, as a share of the panel: it serves Newton steps, not answers.
const DIFFERENCE: f64 = 1e-5;

/// A number of nodes with what can be shared among zones.
pub(super) struct Resolution {
    grid: Arc<SincGrid>,
    /// The operator on `(-1, 1)` in one panel.
    whole: OnceCell<Arc<SincOperator>>,
}

impl Resolution {
    pub(super) fn new(half_count: usize) -> Result<Self, Error> {
        let grid = Arc::new(SincGrid::new(&Logarithm::unit(), half_count)?);
        Ok(Self { grid, whole: OnceCell::new() })
    }

    fn operator(&self, panels: &[(f64, f64)]) -> Result<Arc<SincOperator>, Error> {
        let build = || {
            SincOperator::on_panels(&Logarithm::unit(), Arc::clone(&self.grid), panels)
                .map(Arc::new)
        };
        if panels.len() > 1 {
            return Ok(build()?);
        }
        if let Some(known) = self.whole.get() {
            return Ok(Arc::clone(known));
        }
        let operator = build()?;
        Ok(Arc::clone(self.whole.get_or_init(|| operator)))
    }
}

/// The hull of the zones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Hull {
    pub(super) centre: f64,
    pub(super) half: f64,
}

/// A panel in `xi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Panel {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) zone: usize,
}

impl Panel {
    fn length(&self) -> f64 {
        self.right - self.left
    }
}

/// The pressure on given zones under the load; at free edges it need not vanish yet.
#[derive(Debug, Clone)]
pub(super) struct Solved {
    pub(super) zones: Vec<Zone>,
    pub(super) panels: Vec<Panel>,
    pub(super) hull: Hull,
    /// `xi` of the nodes.
    pub(super) positions: Vec<f64>,
    pub(super) solution: SincSolution,
    /// `D` and `beta`.
    pub(super) local: [f64; 2],
    pub(super) state: State,
    pub(super) stiffness: Stiffness,
}

/// A change of the pressure, at points that may move along, with what it adds to the conditions of the load.
struct Direction {
    /// Pressure at the nodes.
    values: Vec<f64>,
    /// `int p' dxi`.
    spread: f64,
    force: f64,
    moment: f64,
    /// Change of `D`, of `beta`, and of the edges.
    constant: f64,
    slope: f64,
}

impl Solved {
    /// Solves on the zones, from left to right, and gives the Newton step of each free edge where it is wanted.
    pub(super) fn new(
        base: &Base<'_>,
        resolution: &Resolution,
        zones: &[Zone],
        with_steps: bool,
    ) -> Result<(Self, Vec<f64>), Error> {
        let system = System::new(base, resolution, zones)?;
        let operator = Arc::clone(&system.operator);
        let factor = operator.factor(base.theta * system.hull.half)?;
        system.solve(&factor, with_steps)
    }

    /// Nodes of one panel.
    pub(super) fn panel_count(&self) -> usize {
        self.positions.len() / self.panels.len()
    }

    /// Rounding of the pressure.
    pub(super) fn rounding(&self) -> f64 {
        rounding(&self.solution)
    }

    /// Largest `|p0|` at the nodes.
    pub(super) fn largest(&self) -> f64 {
        self.solution.values().iter().fold(0.0, |most, p| most.max(p.abs()))
    }

    /// Pressure at the left (0) or right (1) end of a zone.
    pub(super) fn end_pressure(&self, zone: usize, side: usize) -> f64 {
        self.solution.values()[end_node(&self.panels, self.panel_count(), zone, side)]
    }

    /// Force on a zone.
    pub(super) fn zone_force(&self, zone: usize) -> f64 {
        let Zone { ends } = self.zones[zone];
        let [left, right] = ends.map(|end| (end.at - self.hull.centre) / self.hull.half);
        // Nodes may round onto the ends of their zone.
        let slack = 8.0 * f64::EPSILON;
        let inside = |y: f64| f64::from(u8::from(y >= left - slack && y <= right + slack));
        self.hull.half * self.solution.integral(inside)
    }

    /// `p0(xi)` for `xi` in a zone.
    pub(super) fn pressure(&self, base: &Base<'_>, xi: f64) -> f64 {
        self.pressure_at(xi, base.height(xi))
    }

    /// The same with the height of the base there.
    pub(super) fn pressure_at(&self, xi: f64, height: f64) -> f64 {
        let Hull { centre, half } = self.hull;
        let y = ((xi - centre) / half).clamp(-1.0, 1.0);
        let panel =
            self.panels.partition_point(|panel| panel.right < xi).min(self.panels.len() - 1);
        let Panel { left, right, .. } = self.panels[panel];
        let place = Place {
            position: y,
            from_left: ((xi - left) / half).max(0.0),
            from_right: ((right - xi) / half).max(0.0),
            panel,
        };
        let right_hand_side = self.local[0] - self.local[1] * y - height;
        self.solution.evaluate_place(place, right_hand_side)
    }

    /// `theta0 int ln(1/|xi - eta|) p0 deta` for `xi` outside the zones.
    pub(super) fn displacement_outside(&self, xi: f64) -> f64 {
        let Hull { centre, half } = self.hull;
        let y = (xi - centre) / half;
        let local = self.solution.integral(|t| -(y - t).abs().max(f64::MIN_POSITIVE).ln());
        self.solution.parameter() * (local - self.solution.integral(|_| 1.0) * half.ln())
    }
}

/// Index of the node next to an end of a zone.
fn end_node(panels: &[Panel], count: usize, zone: usize, side: usize) -> usize {
    if side == 0 {
        count * panels.partition_point(|panel| panel.zone < zone)
    } else {
        (count * panels.partition_point(|panel| panel.zone <= zone)).saturating_sub(1)
    }
}

struct System<'b, 'p> {
    base: &'b Base<'p>,
    zones: Vec<Zone>,
    panels: Vec<Panel>,
    hull: Hull,
    operator: Arc<SincOperator>,
    positions: Vec<f64>,
    heights: Vec<f64>,
}

impl<'b, 'p> System<'b, 'p> {
    fn new(base: &'b Base<'p>, resolution: &Resolution, zones: &[Zone]) -> Result<Self, Error> {
        let (Some(first), Some(last)) = (zones.first(), zones.last()) else {
            return Err(Error::NoContact);
        };
        let (left, right) = (first.left(), last.right());
        let hull = Hull { centre: 0.5 * (left + right), half: 0.5 * (right - left) };
        let panels: Vec<Panel> = (zones.iter().enumerate())
            .flat_map(|(zone, place)| {
                let panels = place.panels(&base.breaks);
                panels.into_iter().map(move |(left, right)| Panel { left, right, zone })
            })
            .collect();
        let local = |xi: f64| ((xi - hull.centre) / hull.half).clamp(-1.0, 1.0);
        let mut unit: Vec<(f64, f64)> =
            panels.iter().map(|panel| (local(panel.left), local(panel.right))).collect();
        // The ends of the hull are exact.
        unit[0].0 = -1.0;
        let end = unit.len() - 1;
        unit[end].1 = 1.0;
        let operator = resolution.operator(&unit)?;
        let positions: Vec<f64> = operator
            .places()
            .map(|place| {
                let Panel { left, right, .. } = panels[place.panel];
                let xi = if place.from_left < place.from_right {
                    left + hull.half * place.from_left
                } else {
                    right - hull.half * place.from_right
                };
                xi.clamp(left.next_up(), right.next_down().max(left.next_up()))
            })
            .collect();
        let heights: Vec<f64> = (positions.iter())
            .map(|&xi| base.problem.finite_profile(xi))
            .collect::<Result<_, _>>()?;
        Ok(Self { base, zones: zones.to_vec(), panels, hull, operator, positions, heights })
    }

    fn panel_count(&self) -> usize {
        self.positions.len() / self.panels.len()
    }

    fn solve(self, factor: &SincFactor<'_>, with_steps: bool) -> Result<(Solved, Vec<f64>), Error> {
        let locals: Vec<f64> = self.operator.positions().collect();
        let level = factor.solve(&vec![1.0; locals.len()])?;
        let tilted = factor.solve(&locals)?;
        let profile = factor.solve(&self.heights)?;
        let one = self.direction(&level, 1.0, [1.0, 0.0]);
        let slope = self.direction(&tilted, -1.0, [0.0, 1.0]);
        let given = self.direction(&profile, -1.0, [0.0, 0.0]);
        let prescribed = self.prescribed();
        let rows = (0..2)
            .map(|k| {
                let of = |direction: &Direction| self.conditions(direction)[k];
                vec![of(&one), of(&slope), prescribed[k] - of(&given)]
            })
            .collect();
        let found = elimination::solve(rows).ok_or_else(|| self.singular())?;
        let local = [found[0], found[1]];
        let right: Vec<f64> = (locals.iter().zip(&self.heights))
            .map(|(y, height)| local[0] - local[1] * y - height)
            .collect();
        let solution = factor.solve(&right)?;
        let state = self.state(local, &solution);
        let steps = if with_steps {
            self.steps(factor, &solution, &state, one, slope)?
        } else {
            Vec::new()
        };
        let stiffness = self.stiffness(&level, &tilted);
        let Self { zones, panels, hull, positions, .. } = self;
        let solved = Solved { zones, panels, hull, positions, solution, local, state, stiffness };
        Ok((solved, steps))
    }

    /// No pressure balances the load on these zones.
    fn singular(&self) -> Error {
        Error::Equation(fredholm::Error::Singular { parameter: self.base.theta, smallest: 0.0 })
    }

    /// Force and moment of a pressure: `b int p dy`, `c P + b^2 int y p dy`.
    fn carried(&self, solution: &SincSolution) -> [f64; 2] {
        let Hull { centre, half } = self.hull;
        let force = half * solution.integral(|_| 1.0);
        [force, centre * force + half * half * solution.integral(|y| y)]
    }

    fn direction(
        &self,
        solution: &SincSolution,
        sign: f64,
        [constant, slope]: [f64; 2],
    ) -> Direction {
        let [force, moment] = self.carried(solution).map(|part| sign * part);
        let values = solution.values().iter().map(|p| sign * p).collect();
        Direction { values, spread: force, force, moment, constant, slope }
    }

    /// What a direction adds to the two prescribed quantities.
    fn conditions(&self, direction: &Direction) -> [f64; 2] {
        let Hull { centre, half } = self.hull;
        let Direction { spread, force, moment, constant, slope, .. } = direction;
        [
            match self.base.load.vertical {
                Vertical::Force(_) => *force,
                Vertical::Settlement(_) => {
                    constant + centre / half * slope - self.base.theta * half.ln() * spread
                }
            },
            match self.base.load.rotational {
                Rotational::Moment(_) => *moment,
                Rotational::Eccentricity(e) => moment - e * force,
                Rotational::Tilt(_) => slope / half,
            },
        ]
    }

    fn prescribed(&self) -> [f64; 2] {
        let vertical = match self.base.load.vertical {
            Vertical::Force(value) | Vertical::Settlement(value) => value,
        };
        let rotational = match self.base.load.rotational {
            Rotational::Moment(value) | Rotational::Tilt(value) => value,
            Rotational::Eccentricity(_) => 0.0,
        };
        [vertical, rotational]
    }

    /// Settlement, tilt, force and moment; what is prescribed comes back as given.
    fn state(&self, [constant, slope]: [f64; 2], solution: &SincSolution) -> State {
        let Hull { centre, half } = self.hull;
        let [carried, turned] = self.carried(solution);
        let tilt = match self.base.load.rotational {
            Rotational::Tilt(tilt) => tilt,
            Rotational::Moment(_) | Rotational::Eccentricity(_) => slope / half,
        };
        let (force, settlement) = match self.base.load.vertical {
            Vertical::Force(force) => {
                (force, constant + tilt * centre - self.base.theta * force * half.ln())
            }
            Vertical::Settlement(settlement) => (carried, settlement),
        };
        let moment = match self.base.load.rotational {
            Rotational::Moment(moment) => moment,
            Rotational::Eccentricity(e) => e * force,
            Rotational::Tilt(_) => turned,
        };
        // Adding zero turns a negative zero into a plain one.
        State {
            settlement: settlement + 0.0,
            tilt: tilt + 0.0,
            force: force + 0.0,
            moment: moment + 0.0,
        }
    }

    /// `d(P0, M0)/d(delta0, -alpha0)` on these zones; free edges that move add nothing of first order.
    fn stiffness(&self, level: &SincSolution, tilted: &SincSolution) -> Stiffness {
        let Hull { centre, half } = self.hull;
        let gauge = self.base.theta * half.ln();
        let force = half * level.integral(|_| 1.0);
        let cross = half * level.integral(|y| y);
        let turn = half * tilted.integral(|y| y);
        let divisor = 1.0 - gauge * force;
        let coupling = (centre * force + half * cross) / divisor;
        let raised = centre + gauge * coupling;
        Stiffness {
            force_settlement: force / divisor,
            coupling,
            moment_tilt: centre * coupling + half * (raised * cross + half * turn),
        }
    }

    /// The Newton step of each end, left to right; 0 for those that are not free.
    fn steps(
        &self,
        factor: &SincFactor<'_>,
        solution: &SincSolution,
        state: &State,
        one: Direction,
        slope: Direction,
    ) -> Result<Vec<f64>, Error> {
        let free: Vec<(usize, usize)> = (0..self.zones.len())
            .flat_map(|zone| [(zone, 0), (zone, 1)])
            .filter(|&(zone, side)| self.zones[zone].ends[side].is_free)
            .collect();
        let mut steps = vec![0.0; 2 * self.zones.len()];
        if free.is_empty() {
            return Ok(steps);
        }
        let nodes: Vec<usize> = (free.iter())
            .map(|&(zone, side)| end_node(&self.panels, self.panel_count(), zone, side))
            .collect();
        let slopes = self.profile_slopes();
        let mut directions = vec![one, slope];
        for &node in &nodes {
            directions.push(self.moved(factor, solution, state, &slopes, node)?);
        }
        let mut rows: Vec<Vec<f64>> = (0..2)
            .map(|k| {
                let mut row: Vec<f64> = directions.iter().map(|d| self.conditions(d)[k]).collect();
                row.push(0.0);
                row
            })
            .collect();
        for &node in &nodes {
            let mut row: Vec<f64> = directions.iter().map(|d| d.values[node]).collect();
            row.push(-solution.values()[node]);
            rows.push(row);
        }
        let found = elimination::solve(rows).ok_or_else(|| self.singular())?;
        for (&(zone, side), step) in free.iter().zip(&found[2..]) {
            steps[2 * zone + side] = *step;
        }
        Ok(steps)
    }

    /// The change of the pressure when the end at this node moves to the right.
    fn moved(
        &self,
        factor: &SincFactor<'_>,
        solution: &SincSolution,
        state: &State,
        slopes: &[f64],
        node: usize,
    ) -> Result<Direction, Error> {
        let count = self.panel_count();
        let half = self.hull.half;
        let range = node / count * count..(node / count + 1) * count;
        let panel = self.panels[node / count];
        let stretch = if node == range.start { -1.0 } else { 1.0 } / panel.length();
        let fixed = if node == range.start { panel.right } else { panel.left };
        let velocity = |xi: f64| (xi - fixed) * stretch;
        let mut density = vec![0.0; self.positions.len()];
        density[range.clone()].copy_from_slice(&solution.values()[range.clone()]);
        // Of the moving panel alone, in xi: b (K p) - ln b P.
        let local = if self.panels.len() == 1 {
            solution.potential().to_vec()
        } else {
            self.operator.apply(&density)?
        };
        let masses = solution.node_masses();
        let weighed = |f: &dyn Fn(f64) -> f64| -> f64 {
            range.clone().map(|j| half * masses[j] * f(self.positions[j])).sum()
        };
        let carried = weighed(&|_| 1.0);
        let mut right: Vec<f64> = local
            .iter()
            .map(|u| -self.base.theta * stretch * (half * u - half.ln() * carried))
            .collect();
        for (i, value) in right.iter_mut().enumerate() {
            let xi = self.positions[i];
            if range.contains(&i) {
                // (V(x) - V(s))/(x - s) is the stretch on the panel, V(x)/(x - s) beyond it.
                let v = velocity(xi);
                let others = (0..self.positions.len()).filter(|j| !range.contains(j));
                let beyond: f64 =
                    others.map(|j| half * masses[j] / apart(xi, self.positions[j])).sum();
                *value += self.base.theta * (stretch * carried + v * beyond)
                    - (state.tilt + slopes[i]) * v;
            } else {
                *value -= self.base.theta * weighed(&|s| velocity(s) / apart(xi, s));
            }
        }
        let changed = factor.solve(&right)?;
        let mut direction = self.direction(&changed, 1.0, [0.0, 0.0]);
        direction.force += stretch * carried;
        direction.moment += weighed(&|s| velocity(s) + stretch * s);
        Ok(direction)
    }

    /// `f0'` at the nodes, by differences within their panels.
    fn profile_slopes(&self) -> Vec<f64> {
        let count = self.panel_count();
        let slope = |(i, &xi): (usize, &f64)| {
            let Panel { left, right, .. } = self.panels[i / count];
            let step = DIFFERENCE * (right - left);
            let (from, to) = ((xi - step).max(left.next_up()), (xi + step).min(right.next_down()));
            if to > from {
                (self.base.height(to) - self.base.height(from)) / (to - from)
            } else {
                0.0
            }
        };
        self.positions.iter().enumerate().map(slope).collect()
    }
}

/// `x - s`, kept away from zero: where two panels meet the quotient counts for nothing.
fn apart(x: f64, s: f64) -> f64 {
    let difference = x - s;
    if difference == 0.0 { f64::INFINITY } else { difference }
}
