//! The equations on given zones: pressure, settlement and tilt under the load.
//!
//! In local coordinates `xi = c + b y` of the [ground](crate::contact::ground) the equation becomes
//!
//! `v + theta int K(y, t) p dm(t) = D - beta y - f0(c + b y)`, `D = delta0 - alpha0 c + theta0 P0 g`, `beta = b alpha0`
//!
//! with `theta = b^(1-mu) k theta0` and the gauge `g`: for one punch or a pair on a half-plane the zones lie in `c - b .. c + b`, and `g = ln b`.

use std::cell::{OnceCell, RefCell};
use std::sync::Arc;

use fredholm::collocation::{SincFactor, SincGrid, WeightedFactor};
use fredholm::{SincOperator, SincSolution};

use super::base::Base;
use super::extent::Extent;
use super::power;
use super::solved::{Panel, Solved, Stated};
use crate::contact::balance::State;
use crate::contact::ground::{Ground, Hull};
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::{Error, Load, Rotational, Vertical};

/// Fewest nodes on either side of the middle of a panel. Half and twice change none of 20 answers (survey).
pub(super) const FEWEST: usize = 8;

/// A number of nodes with what can be shared among zones.
pub(super) struct Resolution {
    /// Nodes on either side of the middle of a panel, before they are rounded to a number.
    pub(super) strength: f64,
    ground: Arc<dyn Ground>,
    grid: Arc<SincGrid>,
    /// The operator on the local interval in one panel.
    whole: OnceCell<Arc<SincOperator>>,
    /// The operator on other panels that was built last: those of a mirrored contact stay the same while its edges move.
    latest: RefCell<Option<Built>>,
}

/// Panels with their operator.
type Built = (Vec<(f64, f64)>, Arc<SincOperator>);

impl Resolution {
    /// About so many nodes on either side of the middle of a panel.
    pub(super) fn new(ground: &Arc<dyn Ground>, strength: f64) -> Result<Self, Error> {
        let grid = ground.grid((strength.round() as usize).max(FEWEST))?;
        let (whole, latest) = (OnceCell::new(), RefCell::new(None));
        Ok(Self { strength, ground: Arc::clone(ground), grid, whole, latest })
    }

    fn operator(&self, panels: &[(f64, f64)]) -> Result<Arc<SincOperator>, Error> {
        let build = || self.ground.operator(&self.grid, panels).map(Arc::new);
        let is_whole = matches!((self.ground.local_ends(), panels), (Some([left, right]), [panel]) if *panel == (left, right));
        if !is_whole {
            if let Some((known, operator)) = &*self.latest.borrow()
                && known == panels
            {
                return Ok(Arc::clone(operator));
            }
            let operator = build()?;
            self.latest.replace(Some((panels.to_vec(), Arc::clone(&operator))));
            return Ok(operator);
        }
        if let Some(known) = self.whole.get() {
            return Ok(Arc::clone(known));
        }
        let operator = match self.ground.known_operator(self.grid.half_count()) {
            Some(operator) => operator?,
            None => build()?,
        };
        Ok(Arc::clone(self.whole.get_or_init(|| operator)))
    }
}

/// The factored equation, or its linearisation.
pub(super) enum Factor<'o> {
    Linear(SincFactor<'o>),
    Weighted(WeightedFactor<'o>),
}

impl Factor<'_> {
    /// The displacement of the layer, with the integrals of the pressure.
    pub(super) fn solve(&self, right: &[f64]) -> Result<SincSolution, Error> {
        Ok(match self {
            Self::Linear(factor) => factor.solve(right)?,
            Self::Weighted(factor) => factor.solve(right)?,
        })
    }
}

/// A solution under the load.
pub(super) struct Found {
    /// `D` and `beta`.
    pub(super) local: [f64; 2],
    pub(super) solution: SincSolution,
    pub(super) frame: [Direction; 2],
}

impl Solved {
    /// Solves on the zones, from left to right. `before` is where Newton's method for a layer that bends begins.
    pub(super) fn new(
        base: &Base<'_>,
        resolution: &Resolution,
        zones: &[Zone],
        before: Option<&Self>,
    ) -> Result<Self, Error> {
        let system = System::new(base, resolution, zones)?;
        let operator = Arc::clone(&system.operator);
        if base.layer.is_linear() {
            let factor = Factor::Linear(operator.factor(system.parameter())?);
            let frame = system.frame(&factor)?;
            let (local, solution) = system.superposed(&factor, &frame)?;
            return Ok(system.finish(Found { local, solution, frame }));
        }
        let found = power::solve(&system, &operator, before)?;
        Ok(system.finish(found))
    }
}

/// A change of the layer, at points that may move along, with what it adds to the conditions of the load.
pub(super) struct Direction {
    /// Displacement of the layer at the nodes.
    pub(super) values: Vec<f64>,
    pub(super) force: f64,
    /// Moment about the centre of the hull: about that of the base, small zones far from it would lose twice the digits.
    turn: f64,
    /// Change of `D`, of `beta`, and of the edges.
    constant: f64,
    slope: f64,
}

pub(super) struct System<'b, 'p> {
    pub(super) base: &'b Base<'p>,
    pub(super) ground: Arc<dyn Ground>,
    pub(super) zones: Vec<Zone>,
    pub(super) panels: Vec<Panel>,
    pub(super) hull: Hull,
    pub(super) operator: Arc<SincOperator>,
    pub(super) positions: Vec<f64>,
    pub(super) heights: Vec<f64>,
}

impl Direction {
    /// So much of the direction, `D` and `beta` included.
    pub(super) fn scaled(&self, share: f64) -> Self {
        Self {
            values: self.values.iter().map(|v| share * v).collect(),
            force: share * self.force,
            turn: share * self.turn,
            constant: share * self.constant,
            slope: share * self.slope,
        }
    }
}

impl<'b, 'p> System<'b, 'p> {
    pub(super) fn new(
        base: &'b Base<'p>,
        resolution: &Resolution,
        zones: &[Zone],
    ) -> Result<Self, Error> {
        let (Some(first), Some(last)) = (zones.first(), zones.last()) else {
            return Err(Error::NoContact);
        };
        let ground = Arc::clone(&base.ground);
        let hull = ground.hull(first.left(), last.right(), base.origin);
        let panels: Vec<Panel> = (zones.iter().enumerate())
            .flat_map(|(zone, place)| {
                let panels = place.panels(&base.breaks);
                panels.into_iter().map(move |(left, right)| Panel { left, right, zone })
            })
            .collect();
        let operator = resolution.operator(&local_panels(ground.as_ref(), &hull, &panels))?;
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
        let heights: Vec<f64> =
            positions.iter().map(|&xi| base.finite_height(xi)).collect::<Result<_, _>>()?;
        let zones = zones.to_vec();
        Ok(Self { base, ground, zones, panels, hull, operator, positions, heights })
    }

    pub(super) fn panel_count(&self) -> usize {
        self.positions.len() / self.panels.len()
    }

    /// `k theta0`.
    pub(super) fn strength(&self) -> f64 {
        self.ground.strength() * self.base.theta
    }

    /// `theta`.
    pub(super) fn parameter(&self) -> f64 {
        self.strength() * self.ground.scale(&self.hull)
    }

    pub(super) fn is_by_force(&self) -> bool {
        matches!(self.base.load.vertical, Vertical::Force(_))
    }

    pub(super) fn is_by_moment(&self) -> bool {
        !matches!(self.base.load.rotational, Rotational::Tilt(_))
    }

    pub(super) fn extent(&self) -> Extent {
        self.base.extent(self.zones.iter().map(|zone| zone.ends))
    }

    pub(super) fn gauge(&self) -> f64 {
        self.ground.gauge(&self.hull)
    }

    /// `D - beta y - f0` at the nodes.
    pub(super) fn right_hand_side(&self, local: [f64; 2]) -> Vec<f64> {
        (self.operator.positions().zip(&self.heights))
            .map(|(y, height)| local[0] - local[1] * y - height)
            .collect()
    }

    /// The solution under the load as a sum of three, and `D` and `beta`.
    fn superposed(
        &self,
        factor: &Factor<'_>,
        frame: &[Direction; 2],
    ) -> Result<([f64; 2], SincSolution), Error> {
        let profile = factor.solve(&self.heights)?;
        let given = self.direction(&profile, -1.0, [0.0, 0.0]);
        let local = self.balanced(frame, &given)?;
        Ok((local, factor.solve(&self.right_hand_side(local))?))
    }

    /// The directions of `D` and of `beta`.
    pub(super) fn frame(&self, factor: &Factor<'_>) -> Result<[Direction; 2], Error> {
        let locals: Vec<f64> = self.operator.positions().collect();
        let level = factor.solve(&vec![1.0; locals.len()])?;
        let tilted = factor.solve(&locals)?;
        Ok([self.direction(&level, 1.0, [1.0, 0.0]), self.direction(&tilted, -1.0, [0.0, 1.0])])
    }

    /// How much of both directions meets the conditions of the load, beside what is given.
    pub(super) fn balanced(
        &self,
        frame: &[Direction; 2],
        given: &Direction,
    ) -> Result<[f64; 2], Error> {
        self.met(frame, given, self.prescribed())
    }

    /// The same for other values of the conditions.
    pub(super) fn met(
        &self,
        frame: &[Direction; 2],
        given: &Direction,
        prescribed: [f64; 2],
    ) -> Result<[f64; 2], Error> {
        let [[a, c], [b, d]] = frame.each_ref().map(|direction| self.conditions(direction));
        let known = self.conditions(given);
        let lack = [prescribed[0] - known[0], prescribed[1] - known[1]];
        let determinant = a * d - b * c;
        let found =
            [(lack[0] * d - b * lack[1]) / determinant, (a * lack[1] - lack[0] * c) / determinant];
        if found.iter().all(|value| value.is_finite()) { Ok(found) } else { Err(self.singular()) }
    }

    fn finish(self, found: Found) -> Solved {
        let Found { local, solution, frame } = found;
        let state = self.state(local, &solution);
        let stiffness = self.stiffness(&frame);
        let Self { base, ground, zones, panels, hull, positions, .. } = self;
        let layer = base.layer;
        Solved {
            stated: Stated::none(),
            zones,
            panels,
            ground,
            layer,
            hull,
            positions,
            solution,
            local,
            state,
            stiffness,
        }
    }

    /// No pressure balances the load on these zones.
    pub(super) fn singular(&self) -> Error {
        Error::Equation(fredholm::Error::Singular { parameter: self.base.theta, smallest: 0.0 })
    }

    /// Force, and moment about the centre, of a pressure: `b int p dy`, `b^2 int y p dy`; on a disk the force of rings, which have no moment.
    fn carried(&self, solution: &SincSolution) -> [f64; 2] {
        let half = self.hull.half;
        let force =
            self.ground.area() * self.ground.measure(&self.hull) * solution.integral(|_| 1.0);
        // Rings have no moment, and a wave that goes on has none that could turn it.
        if self.ground.is_disk() || self.ground.is_closed() {
            return [force, 0.0];
        }
        [force, half * half * solution.integral(|y| y)]
    }

    /// `int xi p0 dxi` over the period `-1 .. 1` of a wave that is cut elsewhere; where it is joined there is an end of a panel.
    fn moment_of_a_period(&self, solution: &SincSolution) -> f64 {
        let Hull { centre, half } = self.hull;
        let lever = |y: f64| {
            let xi = centre + half * y;
            xi - 2.0 * (0.5 * xi).round()
        };
        self.ground.measure(&self.hull) * solution.integral(lever)
    }

    /// A solution for a right-hand side, with what it adds to `D` and `beta`.
    pub(super) fn direction(
        &self,
        solution: &SincSolution,
        sign: f64,
        [constant, slope]: [f64; 2],
    ) -> Direction {
        let [force, turn] = self.carried(solution).map(|part| sign * part);
        let values = solution.values().iter().map(|v| sign * v).collect();
        Direction { values, force, turn, constant, slope }
    }

    /// Settlement, tilt, force and moment of a direction.
    pub(super) fn changes(&self, direction: &Direction) -> State {
        let Hull { centre, half } = self.hull;
        let Direction { force, turn, constant, slope, .. } = direction;
        State {
            settlement: constant + centre / half * slope - self.base.theta * self.gauge() * force,
            tilt: slope / half,
            force: *force,
            moment: turn + self.arm() * force,
        }
    }

    /// Where moments are counted from, as `xi`: rings have none, and a wave that goes on has none that could turn it.
    fn arm(&self) -> f64 {
        if self.ground.is_disk() || self.ground.is_closed() { 0.0 } else { self.hull.centre }
    }

    /// What a direction adds to the two prescribed quantities, a moment about the centre where the force is prescribed.
    pub(super) fn conditions(&self, direction: &Direction) -> [f64; 2] {
        let Direction { force, turn, .. } = *direction;
        let State { settlement, tilt, .. } = self.changes(direction);
        let Load { vertical, rotational } = self.base.load;
        [
            match vertical {
                Vertical::Force(_) => force,
                Vertical::Settlement(_) => settlement,
            },
            match (rotational, vertical) {
                (Rotational::Tilt(_), _) => tilt,
                (_, Vertical::Force(_)) => turn,
                (Rotational::Moment(_), _) => turn + self.arm() * force,
                (Rotational::Eccentricity(e), _) => turn + (self.arm() - e) * force,
            },
        ]
    }

    /// The conditions for values of the two prescribed quantities; an eccentricity, which is no quantity to be met, counts as nothing.
    pub(super) fn conditions_for(&self, [vertical, rotational]: [f64; 2]) -> [f64; 2] {
        let Load { vertical: by, rotational: kept } = self.base.load;
        let rotational = match (kept, by) {
            (Rotational::Moment(_), Vertical::Force(_)) => rotational - self.arm() * vertical,
            (Rotational::Eccentricity(e), Vertical::Force(_)) => (e - self.arm()) * vertical,
            _ => rotational,
        };
        [vertical, rotational]
    }

    /// The conditions of the load.
    pub(super) fn prescribed(&self) -> [f64; 2] {
        let Load { vertical, rotational } = self.base.load;
        let (Vertical::Force(vertical) | Vertical::Settlement(vertical)) = vertical;
        let rotational = match rotational {
            Rotational::Moment(value) | Rotational::Tilt(value) => value,
            Rotational::Eccentricity(_) => 0.0,
        };
        self.conditions_for([vertical, rotational])
    }

    /// Settlement, tilt, force and moment; what is prescribed comes back as given.
    fn state(&self, [constant, slope]: [f64; 2], solution: &SincSolution) -> State {
        let Hull { centre, half } = self.hull;
        let [force, turn] = self.carried(solution);
        let moment = if self.ground.is_closed() {
            self.moment_of_a_period(solution)
        } else {
            turn + self.arm() * force
        };
        let load = &self.base.load;
        let state = State { settlement: 0.0, tilt: slope / half, force, moment }.given(load);
        let gauge = self.base.theta * state.force * self.gauge();
        State { settlement: constant + state.tilt * centre - gauge, ..state }.given(load)
    }

    /// `d(P0, M0)/d(delta0, -alpha0)` on these zones; free edges that move add nothing of first order.
    fn stiffness(&self, [level, tilted]: &[Direction; 2]) -> Stiffness {
        let Hull { centre, half } = self.hull;
        let gauge = self.base.theta * self.gauge();
        let divisor = 1.0 - gauge * level.force;
        let coupling = (level.turn + self.arm() * level.force) / divisor;
        let raised = centre + gauge * coupling;
        // The slope is that of -beta.
        let turn = -tilted.turn * half;
        Stiffness {
            force_settlement: level.force / divisor,
            coupling,
            moment_tilt: centre * coupling + raised * level.turn + turn,
        }
    }
}

/// The panels in local coordinates.
fn local_panels(ground: &dyn Ground, hull: &Hull, panels: &[Panel]) -> Vec<(f64, f64)> {
    let ends = ground.local_ends();
    let local = |xi: f64| {
        let y = (xi - hull.centre) / hull.half;
        ends.map_or(y, |[left, right]| y.clamp(left, right))
    };
    let mut local: Vec<(f64, f64)> =
        panels.iter().map(|panel| (local(panel.left), local(panel.right))).collect();
    // The ends of the hull are exact.
    if let Some([left, right]) = ends
        && let (Some(first), Some(last)) = (panels.first(), panels.last())
    {
        let end = local.len() - 1;
        if !ground.is_disk() || first.left == 0.0 {
            local[0].0 = left;
        }
        if last.right > first.left {
            local[end].1 = right;
        }
    }
    local
}
