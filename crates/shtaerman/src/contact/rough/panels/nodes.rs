//! The equation on panels of given zones, with products by a fast multipole method.
//!
//! One punch, a pair and graded ground are taken as they are; a row lies on a circle, `xi = centre + L/2 y`, on which the kernel is `ln 1/(2 sin(pi |y - t|/2))`.

use std::sync::Arc;

use fredholm::multipole::{
    Groups, PanelCondition, PanelEquation, PanelField, PanelKernel, PanelOperator, Panels,
};

use super::mesh::{Fineness, LONGEST, panels};
use crate::Error;
use crate::contact::accuracy::OF_A_VALUE;
use crate::contact::ground::Hull;
use crate::contact::method::MethodName;
use crate::contact::rough::base::Base;
use crate::contact::rough::frame::Frame;
use crate::contact::rough::nodes::{Discrete, Field, Nodes, Pressed, Response, Step, Task};
use crate::contact::rough::solved::largest;
use crate::contact::zones::Zone;

/// Most nodes. Half and twice change none of 32 answers (survey).
const MOST_NODES: usize = 400_000;
/// Longest groups, in lengths of the layer, and about the most groups beyond the number of zones. At half or twice stated errors grow up to 6.4 times (survey).
const GROUP: f64 = 0.25;
const MOST_GROUPS: f64 = 400.0;
/// How panels that are too long are shortened, twice at most.
const SHORTER: f64 = 0.25;
/// Residuals of responses relative to their right-hand sides; of integrals the square is left. At half or twice 29 of 32 answers change, within what they state (survey).
const RESIDUALS: [f64; 2] = [1e-9, 1e-12];
/// Places on each panel where finenesses are compared. At half or twice 27 of 32 answers change, within what they state (survey).
const PLACES: [f64; 2] = [-0.78, 0.26];

/// How well the equation is to be solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    pub(super) fineness: Fineness,
    /// Residual relative to the layer.
    pub(super) residual: f64,
}

/// The displacements of a pressure on panels.
#[derive(Debug, Clone)]
pub(in crate::contact::rough) struct OnPanels {
    field: PanelField,
    hull: Hull,
    /// `theta`.
    parameter: f64,
    pressures: Arc<Vec<f64>>,
}

impl Field for OnPanels {
    const NAME: MethodName = MethodName::Panels;
    const ROUNDING: f64 = 32.0 * f64::EPSILON;
    /// The coarsest is far coarser than the next: no rate of convergence is known.
    const RATIO: Option<f64> = None;

    fn at(&self, xi: f64) -> f64 {
        self.parameter * self.field.at((xi - self.hull.centre) / self.hull.half)
    }

    fn masses(&self) -> Vec<f64> {
        let weights = self.field.panels().weights().iter();
        weights.zip(self.pressures.iter()).map(|(weight, p)| weight * p).collect()
    }

    fn interpolated(&self, values: &[f64], xi: f64) -> Option<f64> {
        self.field.panels().interpolate(values, (xi - self.hull.centre) / self.hull.half)
    }

    fn between() -> Vec<f64> {
        PLACES.to_vec()
    }
}

/// The nodes of given zones with their operator.
pub(super) struct PanelNodes<'b> {
    base: &'b Base,
    operator: PanelOperator,
    kernel: PanelKernel,
    nodes: Arc<Nodes>,
    parameter: f64,
    effort: Effort,
    /// The length of all zones in local coordinates.
    total: f64,
}

/// The approximate inverse for these slopes of the law.
pub(super) struct PanelInverse {
    groups: Groups,
    slopes: Option<Vec<f64>>,
}

impl<'b> PanelNodes<'b> {
    /// On these zones, cut at joints; none where there are too many nodes.
    pub(super) fn new(
        base: &'b Base,
        joints: &[f64],
        zones: &[Zone],
        effort: Effort,
    ) -> Result<Option<Self>, Error> {
        let Some((kernel, half)) = base.ground.panel_kernel() else { return Ok(None) };
        let hull = Hull { centre: base.surface.origin, half };
        let frame = Frame::new(base, hull, 0.0);
        let Some(operator) = operator(base, (kernel, &frame), joints, zones, effort.fineness)?
        else {
            return Ok(None);
        };
        let on_base = |y: &f64| hull.centre + half * y;
        let bounds = operator.panels().bounds().iter();
        let panels = bounds.map(|panel| [on_base(&panel[0]), on_base(&panel[1])]).collect();
        let locals = operator.panels().nodes().to_vec();
        let places: Vec<f64> = locals.iter().map(on_base).collect();
        let heights = base.heights(&places)?;
        let total = zones.iter().map(Zone::length).sum::<f64>() / half;
        let parameter = base.strength() * base.ground.scale(&hull);
        let zones = zones.to_vec();
        let nodes = Arc::new(Nodes { zones, panels, places, locals, heights, frame });
        Ok(Some(Self { base, operator, kernel, nodes, parameter, effort, total }))
    }

    /// The conditions of the load that are met by pressures, for what is lacking of them.
    fn conditions(&self, lack: [f64; 2]) -> Vec<PanelCondition> {
        let (frame, locals) = (&self.nodes.frame, &self.nodes.locals);
        let half = frame.hull.half;
        let mut conditions = Vec::new();
        if frame.is_by_force() {
            conditions.push(PanelCondition::symmetric(vec![1.0; locals.len()], lack[0] / half));
        }
        if frame.is_by_moment() {
            let row = locals.iter().map(|y| half * y + frame.lever()).collect();
            let column = locals.iter().map(|y| -y).collect();
            conditions.push(PanelCondition { row, column, value: lack[1] / half });
        }
        conditions
    }

    fn equation<'e>(&'e self, inverse: &'e PanelInverse) -> PanelEquation<'e> {
        PanelEquation {
            operator: &self.operator,
            parameter: self.parameter,
            weight: inverse.slopes.as_deref(),
            groups: &inverse.groups,
        }
    }

    /// The pressure with its potential.
    fn with_potential(&self, pressure: Vec<f64>, potential: Vec<f64>) -> Pressed<Vec<f64>> {
        let carried = self.carried(&pressure);
        let displaced = potential.into_iter().map(|u| self.parameter * u).collect();
        Pressed { pressure, displaced, carried }
    }

    /// Force, and moment about the centre.
    fn carried(&self, pressure: &[f64]) -> [f64; 2] {
        let (frame, panels) = (&self.nodes.frame, self.operator.panels());
        let half = frame.hull.half;
        let turn = if frame.turns { half * half * panels.integral(pressure, |y| y) } else { 0.0 };
        [half * panels.integral(pressure, |_| 1.0), turn]
    }
}

impl PanelInverse {
    /// The pressures of changes of the layer.
    fn pressures(&self, layer: &[f64]) -> Vec<f64> {
        match &self.slopes {
            None => layer.to_vec(),
            Some(slopes) => slopes.iter().zip(layer).map(|(w, v)| w * v).collect(),
        }
    }
}

impl Discrete for PanelNodes<'_> {
    type Pressure = Vec<f64>;
    type Field = OnPanels;
    type Inverse<'o>
        = PanelInverse
    where
        Self: 'o;

    fn base(&self) -> &Base {
        self.base
    }

    fn nodes(&self) -> &Arc<Nodes> {
        &self.nodes
    }

    fn pressed(&self, pressures: Vec<f64>) -> Result<Pressed<Vec<f64>>, Error> {
        let potential = self.operator.potential(&pressures);
        Ok(self.with_potential(pressures, potential))
    }

    /// Groups of a quarter of the layer where the law is steepest.
    fn inverse(&self, slopes: Option<Vec<f64>>) -> Result<PanelInverse, Error> {
        let firmest =
            slopes.as_ref().map_or(1.0, |w| w.iter().fold(0.0f64, |most, w| most.max(*w)));
        let strength = (self.parameter * firmest).max(f64::MIN_POSITIVE);
        let layer = (GROUP / strength).powf(1.0 / (1.0 - self.base.ground.exponent()));
        let longest = layer.max(self.total / MOST_GROUPS);
        let panels = self.operator.panels();
        let groups = Groups::new(self.kernel, panels, self.parameter, longest, slopes.as_deref())?;
        Ok(PanelInverse { groups, slopes })
    }

    fn solve(
        &self,
        inverse: &PanelInverse,
        Task { right, lack, start, residual }: Task<'_>,
    ) -> Result<Step<Vec<f64>>, Error> {
        let nothing = vec![0.0; right.len()];
        let tolerance = residual.max(OF_A_VALUE * self.norm(right));
        let equation = self.equation(inverse);
        let conditions = self.conditions(lack);
        let found = equation.solve(right, &conditions, start.unwrap_or(&nothing), tolerance)?;
        let mut multipliers = found.multipliers.into_iter();
        let frame = &self.nodes.frame;
        let local = [frame.is_by_force(), frame.is_by_moment()]
            .map(|is_free| if is_free { multipliers.next().unwrap_or(0.0) } else { 0.0 });
        let pressed = self.with_potential(inverse.pressures(&found.values), found.potential);
        Ok(Step { layer: found.values, local, pressed })
    }

    /// Root of the integral of the square.
    fn norm(&self, values: &[f64]) -> f64 {
        let squares: Vec<f64> = values.iter().map(|value| value * value).collect();
        self.operator.panels().integral(&squares, |_| 1.0).sqrt()
    }

    fn extent(&self) -> f64 {
        self.total
    }

    fn residual(&self) -> f64 {
        self.effort.residual
    }

    fn field(&self, pressures: Vec<f64>) -> OnPanels {
        let (hull, parameter) = (self.nodes.frame.hull, self.parameter);
        let field = self.operator.field(&pressures);
        OnPanels { field, hull, parameter, pressures: Arc::new(pressures) }
    }

    /// These have `d ln d` at free edges, for which the panels are not made.
    fn responses(
        &self,
        inverse: &PanelInverse,
        body: &[f64],
        near: Option<&dyn Fn(f64) -> [f64; 3]>,
    ) -> Result<[Response<OnPanels>; 3], Error> {
        let share = RESIDUALS[usize::from(near.is_some())];
        let near: Vec<[f64; 3]> = near.map_or_else(
            || vec![[0.0; 3]; body.len()],
            |near| self.nodes.places.iter().map(|xi| near(*xi)).collect(),
        );
        let lever: Vec<f64> = self.nodes.locals.iter().map(|y| -y).collect();
        let rights = [body, &vec![1.0; body.len()], &lever];
        let equation = self.equation(inverse);
        let solved = |k: usize| -> Result<Solution, Error> {
            let start: Vec<f64> = near.iter().map(|values| values[k]).collect();
            let tolerance = share * self.norm(rights[k]);
            let found = equation.solve(rights[k], &[], &start, tolerance)?;
            let terms = rights[k].iter().zip(&found.values).zip(&found.potential);
            let left = terms.map(|((b, v), u)| b - v - self.parameter * u).collect();
            let noise = share * largest(rights[k]);
            let pressures = inverse.pressures(&found.values);
            Ok(Solution { layer: found.values, pressures, left, noise })
        };
        let (body, level) = (solved(0)?, solved(1)?);
        // What does not turn has no use for the third.
        let turned = if self.nodes.frame.turns { solved(2)? } else { level.clone() };
        let known = [&level.pressures, &turned.pressures];
        let mut responses = [&body, &level, &turned].map(|solution| self.response(solution, known));
        let is_joined = self.nodes.zones.iter().any(|zone| self.base.is_joined(zone));
        if is_joined && self.base.layer.is_linear() {
            // On a whole circle potentials have no mean, and no more has what a linear layer gives to them.
            responses[0].carried[0] = 0.0;
        }
        Ok(responses)
    }
}

/// The pressures of a response, what is left of its equation, and what that leaves of the layer.
#[derive(Clone)]
struct Solution {
    layer: Vec<f64>,
    pressures: Vec<f64>,
    left: Vec<f64>,
    noise: f64,
}

impl PanelNodes<'_> {
    /// The operator is symmetric: with what is left against the pressures of the responses to 1 and to `-y`, of a residual the square counts in force and moment.
    fn response(&self, solution: &Solution, known: [&Vec<f64>; 2]) -> Response<OnPanels> {
        let half = self.nodes.frame.hull.half;
        let [by_force, by_turn] = known.map(|pressures| {
            let products: Vec<f64> =
                pressures.iter().zip(&solution.left).map(|(p, l)| p * l).collect();
            half * self.operator.panels().integral(&products, |_| 1.0)
        });
        let [force, turn] = self.carried(&solution.pressures);
        let turn = if self.nodes.frame.turns { turn - half * by_turn } else { 0.0 };
        let field = self.field(solution.pressures.clone());
        let (layer, noise) = (solution.layer.clone(), solution.noise);
        Response { layer, field, carried: [force + by_force, turn], noise }
    }
}

/// The operator on panels of these zones; none where there are too many nodes. Where they crowd beside long panels, whose neighbours all act directly, those are cut.
fn operator(
    base: &Base,
    (kernel, frame): (PanelKernel, &Frame),
    joints: &[f64],
    zones: &[Zone],
    mut fineness: Fineness,
) -> Result<Option<PanelOperator>, Error> {
    loop {
        let Some(bounds) = panels(base, joints, zones, fineness, MOST_NODES) else {
            return Ok(None);
        };
        let local = |xi: f64| frame.local(xi).clamp(-1.0, 1.0);
        let bounds: Vec<[f64; 2]> = bounds.into_iter().map(|panel| panel.map(local)).collect();
        if bounds.iter().any(|[left, right]| left >= right) {
            return Ok(None);
        }
        let panels = Panels::new(bounds, fineness.order)?;
        match PanelOperator::new(kernel, panels) {
            Err(fredholm::Error::TooLarge { .. })
                if fineness.longest > SHORTER * SHORTER * LONGEST =>
            {
                fineness.longest *= SHORTER;
            }
            Err(fredholm::Error::TooLarge { .. }) => return Ok(None),
            operator => return Ok(Some(operator?)),
        }
    }
}
