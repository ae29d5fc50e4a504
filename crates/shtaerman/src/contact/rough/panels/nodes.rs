//! The equation on panels of given zones, with products by a fast multipole method.
//!
//! One punch, a pair and graded ground are taken as they are; a row lies on a circle, `xi = centre + L/2 y`, on which the kernel is `ln 1/(2 sin(pi |y - t|/2))`.

use std::f64::consts::PI;
use std::sync::Arc;

use fredholm::multipole::{
    Groups, PanelCondition, PanelEquation, PanelField, PanelKernel, PanelOperator, PanelTask,
    Panels,
};

use super::mesh::{Fineness, LONGEST, panels};
use crate::Error;
use crate::contact::accuracy::SAFETY;
use crate::contact::ground::Hull;
use crate::contact::method::MethodName;
use crate::contact::rough::base::Base;
use crate::contact::rough::frame::Frame;
use crate::contact::rough::nodes::{Discrete, Field, Nodes, Pressed, Response, Step, Task};
use crate::contact::rough::solved::{Solved, largest};
use crate::contact::search::unknown;
use crate::contact::zones::Zone;
use crate::deadline::work;
use crate::rounding::OF_A_VALUE;

/// Most nodes: with their operator, the coarser ones and the directions of a solution they stay below a gigabyte. Half and twice change none of 32 answers (survey).
const MOST_NODES: usize = 600_000;
/// Longest groups, in lengths of the layer, and about the most groups beyond the number of zones. At half or twice stated errors grow up to 6.4 times (survey).
const GROUP: f64 = 0.25;
const MOST_GROUPS: f64 = 400.0;
/// Places on each panel where finenesses are compared. At half or twice 27 of 32 answers change, within what they state (survey).
const PLACES: [f64; 2] = [-0.78, 0.26];

/// How well the equation is to be solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    pub(super) fineness: Fineness,
    /// Residual relative to the layer.
    pub(super) residual: f64,
    /// Residual of responses relative to their right-hand sides; of integrals the square is left.
    pub(super) responses: f64,
    /// What the layer gives at free ends over the largest, at which the zones are good enough: its square is what the pressure elsewhere is off.
    pub(super) good: f64,
}

impl Effort {
    /// Panels of so many nodes, with the residual, that of responses, and what is good enough.
    pub(super) const fn new(order: usize, ends: f64, straight: f64, left: [f64; 3]) -> Self {
        let [residual, responses, good] = left;
        let fineness = Fineness { order, ends, longest: LONGEST, straight };
        Self { fineness, residual, responses, good }
    }
}

/// The displacements of a pressure on panels.
#[derive(Debug, Clone)]
pub(in crate::contact::rough) struct OnPanels {
    field: PanelField,
    hull: Hull,
    /// `theta`.
    parameter: f64,
}

impl OnPanels {
    fn local(&self, places: &[f64]) -> Vec<f64> {
        places.iter().map(|xi| (xi - self.hull.centre) / self.hull.half).collect()
    }
}

impl Field for OnPanels {
    const NAME: MethodName = MethodName::Panels;
    const ROUNDING: f64 = crate::contact::accuracy::ROUNDING;
    /// The coarsest is far coarser than the next: no rate of convergence is known.
    const RATIO: Option<f64> = None;

    fn at(&self, xi: f64) -> f64 {
        self.parameter * self.field.at((xi - self.hull.centre) / self.hull.half)
    }

    fn at_all(&self, places: &[f64]) -> Vec<f64> {
        self.field.values(&self.local(places)).iter().map(|value| self.parameter * value).collect()
    }

    fn slopes(&self, places: &[f64]) -> Option<Vec<[f64; 2]>> {
        let factor = self.parameter / self.hull.half;
        let slopes = self.field.slopes(&self.local(places)).into_iter();
        Some(slopes.map(|sums| sums.map(|sum| factor * sum)).collect())
    }

    fn interpolated(&self, values: &[f64], places: &[f64]) -> Vec<Option<f64>> {
        self.field.panels().interpolate_all(values, &self.local(places))
    }

    fn between() -> Vec<f64> {
        PLACES.to_vec()
    }

    fn turning(base: &Base, solved: &Solved<Self>) -> Result<[f64; 2], Error> {
        let turning = turning(base, solved)?;
        let coarser = solved.coarser.last().map(|coarser| self::turning(base, coarser));
        let off = match coarser {
            Some(coarser) => {
                SAFETY * ((turning - coarser?).abs() + solved.unsolved * turning.abs())
            }
            None => turning.abs(),
        };
        Ok([turning, off])
    }
}

/// The nodes of given zones with their operator.
pub(super) struct PanelNodes<'b> {
    base: &'b Base,
    pub(super) operator: PanelOperator,
    kernel: PanelKernel,
    nodes: Arc<Nodes>,
    parameter: f64,
    effort: Effort,
    /// The integral of 1 over all zones in local coordinates.
    measure: f64,
}

/// The approximate inverse for these slopes of the law.
pub(super) struct PanelInverse {
    groups: Groups,
    slopes: Option<Vec<f64>>,
}

impl PanelInverse {
    /// Groups of a quarter of the layer where the law is steepest.
    fn new(
        base: &Base,
        kernel: &PanelKernel,
        panels: &Panels,
        parameter: f64,
        slopes: Option<Vec<f64>>,
    ) -> Result<Self, Error> {
        let firmest = slopes.as_ref().map_or(1.0, |slopes| largest(slopes));
        let strength = (parameter * firmest).max(f64::MIN_POSITIVE);
        let layer = (GROUP / strength).powf(1.0 / (1.0 - base.ground.exponent()));
        let total: f64 = panels.bounds().iter().map(|[left, right]| right - left).sum();
        let longest = layer.max(total / MOST_GROUPS);
        let groups = Groups::new(kernel, panels, parameter, longest, slopes.as_deref())?;
        Ok(Self { groups, slopes })
    }

    /// The pressures of changes of the layer.
    fn pressures(&self, layer: &[f64]) -> Vec<f64> {
        match &self.slopes {
            None => layer.to_vec(),
            Some(slopes) => slopes.iter().zip(layer).map(|(w, v)| w * v).collect(),
        }
    }
}

impl<'b> PanelNodes<'b> {
    /// On these zones, cut at joints; where another operator is known that has the same panels in many places, faster by it.
    ///
    /// # Errors
    /// [`Error::NotComplementary`] where there are too many nodes, or none.
    pub(super) fn new(
        base: &'b Base,
        joints: &[f64],
        zones: &[Zone],
        effort: Effort,
        known: Option<&PanelOperator>,
    ) -> Result<Self, Error> {
        let (kernel, frame, panels) = cut(base, joints, zones, effort.fineness)?;
        let Hull { centre, half } = frame.hull;
        let operator = PanelOperator::beside(kernel.clone(), panels, known)?;
        let on_base = |y: &f64| centre + half * y;
        let bounds = operator.panels().bounds().iter();
        let panels = bounds.map(|panel| panel.each_ref().map(on_base)).collect();
        let locals = operator.panels().nodes().to_vec();
        let places: Vec<f64> = locals.iter().map(on_base).collect();
        let heights = base.heights(&places)?;
        let share = base.ground.panel_share();
        let parameter = share * base.strength() * base.ground.scale(&frame.hull);
        let measure = operator.panels().weights().iter().sum();
        let zones = zones.to_vec();
        let nodes = Arc::new(Nodes { zones, panels, places, locals, heights, frame });
        Ok(Self { base, operator, kernel, nodes, parameter, effort, measure })
    }

    /// The conditions of the load that are met by pressures, for what is lacking of them.
    fn conditions(&self, lack: [f64; 2]) -> Vec<PanelCondition> {
        let (frame, locals) = (&self.nodes.frame, &self.nodes.locals);
        let (half, unit) = (frame.hull.half, self.unit());
        let mut conditions = Vec::new();
        if frame.is_by_force() {
            conditions.push(PanelCondition::symmetric(vec![1.0; locals.len()], lack[0] / unit));
        }
        if frame.is_by_moment() {
            let row = locals.iter().map(|y| half * y + frame.lever()).collect();
            let (column, value) = (self.nodes.lever(), lack[1] / unit);
            conditions.push(PanelCondition { row, column, value });
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

    /// The number of nodes by what a product takes.
    fn size(&self) -> f64 {
        (self.nodes.places.len() as f64).max(self.operator.near_pairs() as f64 / work::PAIRS)
    }

    /// `dP0` over `p0 dm` in local coordinates.
    fn unit(&self) -> f64 {
        self.base.ground.area() * self.base.ground.measure(&self.nodes.frame.hull)
    }

    fn integral(&self, one: &[f64], other: &[f64]) -> f64 {
        let products: Vec<f64> = one.iter().zip(other).map(|(a, b)| a * b).collect();
        self.operator.panels().integral(&products, |_| 1.0)
    }
}

impl Discrete for PanelNodes<'_> {
    type Pressure = Vec<f64>;
    type Field = OnPanels;
    type Inverse<'o>
        = PanelInverse
    where
        Self: 'o;

    fn shared(&self) -> (&Base, &Arc<Nodes>, f64) {
        (self.base, &self.nodes, self.parameter)
    }

    /// With fast products it grows with the number of nodes, and where these crowd with that of their pairs.
    fn work(&self) -> f64 {
        let ground = &self.base.ground;
        let of_power = if ground.exponent() > 0.0 { work::POWERS } else { 1.0 };
        let of_rings = if ground.is_disk() { work::ON_RINGS } else { 1.0 };
        work::NODE * of_power * of_rings * self.size()
    }

    fn masses(&self, pressure: &Vec<f64>) -> Vec<f64> {
        let weights = self.operator.panels().weights().iter();
        weights.zip(pressure).map(|(weight, p)| weight * p).collect()
    }

    fn pressed(&self, pressures: Vec<f64>) -> Result<Pressed<Vec<f64>>, Error> {
        let potential = self.operator.potential(&pressures);
        Ok(self.with_potential(pressures, &potential))
    }

    fn inverse(&self, slopes: Option<Vec<f64>>) -> Result<PanelInverse, Error> {
        let (base, panels) = (self.base, self.operator.panels());
        let inverse = PanelInverse::new(base, &self.kernel, panels, self.parameter, slopes)?;
        // What the groups do to each other is a dense system.
        base.problem().deadline().spend(work::GROUPS * (inverse.groups.count() as f64).powi(3));
        Ok(inverse)
    }

    fn solve(
        &self,
        inverse: &PanelInverse,
        Task { right, lack, start, residual }: Task<'_>,
    ) -> Result<Step<Vec<f64>>, Error> {
        let nothing = vec![0.0; right.len()];
        let residual = residual.max(OF_A_VALUE * self.norm(right)) * self.measure.sqrt();
        let conditions = self.conditions(lack);
        let start = start.unwrap_or(&nothing);
        let found = self.equation(inverse).solve(right, &conditions, start, residual)?;
        self.base.problem().deadline().spend(work::PRODUCT * self.size() * found.products as f64);
        let mut multipliers = found.multipliers.into_iter();
        let frame = &self.nodes.frame;
        let local = [frame.is_by_force(), frame.is_by_moment()]
            .map(|is_free| if is_free { multipliers.next().unwrap_or(0.0) } else { 0.0 });
        let pressed = self.with_potential(inverse.pressures(&found.values), &found.potential);
        Ok(Step { layer: found.values, local, pressed })
    }

    /// Root of the mean square.
    fn norm(&self, values: &[f64]) -> f64 {
        (self.integral(values, values) / self.measure).sqrt()
    }

    fn residual(&self) -> f64 {
        self.effort.residual
    }

    fn field(&self, pressures: Vec<f64>) -> OnPanels {
        let (hull, parameter) = (self.nodes.frame.hull, self.parameter);
        OnPanels { field: self.operator.field(&pressures), hull, parameter }
    }

    /// These have `d ln d` at free edges, for which the panels are not made.
    fn responses(
        &self,
        inverse: &PanelInverse,
        body: &[f64],
        near: Option<&[Response<OnPanels>; 3]>,
    ) -> Result<[Response<OnPanels>; 3], Error> {
        let share = self.effort.responses;
        let (ones, lever, turns) =
            (vec![1.0; body.len()], self.nodes.lever(), self.nodes.frame.turns);
        // What does not turn has no use for the third.
        let rights = [body, &ones, &lever];
        let rights = if turns { &rights[..] } else { &rights[..2] };
        let start = |near: &Response<OnPanels>| -> Vec<f64> {
            let known = near.field.interpolated(&near.layer, &self.nodes.places);
            known.into_iter().map(Option::unwrap_or_default).collect()
        };
        let starts = near.map(|near| near.each_ref().map(start));
        let starts = starts.unwrap_or_else(|| [(); 3].map(|()| vec![0.0; body.len()]));
        let tasks: Vec<PanelTask<'_>> = (rights.iter().zip(&starts))
            .map(|(right, start)| {
                let tolerance = share * self.norm(right) * self.measure.sqrt();
                PanelTask { right, start, tolerance }
            })
            .collect();
        let found = self.equation(inverse).solve_together(&tasks, &[])?;
        let mut solved = found.into_iter().zip(rights).map(|(found, right)| {
            let terms = right.iter().zip(&found.values).zip(&found.potential);
            let left = terms.map(|((b, v), u)| b - v - self.parameter * u).collect();
            let pressed = self.with_potential(inverse.pressures(&found.values), &found.potential);
            Solution { layer: found.values, pressed, left, noise: share * largest(right) }
        });
        let (Some(body), Some(level)) = (solved.next(), solved.next()) else {
            return Err(unknown());
        };
        let turned = solved.next();
        let (half, measure) = (self.nodes.frame.hull.half, self.unit());
        // The operator is symmetric: with what is left against the pressures of 1 and of `-y`, of a residual the square counts in force and moment.
        let carried = |solution: &Solution| {
            let by =
                |unit: &Solution| measure * self.integral(&unit.pressed.pressure, &solution.left);
            let [force, turn] = solution.pressed.carried;
            [force + by(&level), turn - turned.as_ref().map_or(0.0, |turned| half * by(turned))]
        };
        let [mut by_body, by_level] = [carried(&body), carried(&level)];
        let by_turned = turned.as_ref().map(carried);
        if self.base.layer.is_linear()
            && self.nodes.zones.iter().any(|zone| self.base.is_joined(zone))
        {
            // On a whole circle potentials have no mean, and no more has what a linear layer gives to them.
            by_body[0] = 0.0;
        }
        let response = |Solution { layer, pressed, noise, .. }: Solution, carried: [f64; 2]| {
            Response { layer, field: self.field(pressed.pressure), carried, noise }
        };
        let level = response(level, by_level);
        let turned = turned.zip(by_turned).map(|(turned, carried)| response(turned, carried));
        Ok([response(body, by_body), level.clone(), turned.unwrap_or(level)])
    }
}

/// `dM0/d(-alpha0)` on the panels of a solution: `q + theta W_1 (w q) = r`, `M0 = pi int w q r^2 dr`.
fn turning(base: &Base, solved: &Solved<OnPanels>) -> Result<f64, Error> {
    let kernel = base.ground.turned_panel_kernel()?.ok_or_else(unknown)?;
    let (panels, layer) = (solved.field.field.panels(), solved.layer);
    let operator = PanelOperator::new(kernel.clone(), panels.clone())?;
    let slopes =
        (!layer.is_linear()).then(|| solved.given.iter().map(|v| layer.slope(*v)).collect());
    let parameter = solved.field.parameter;
    let inverse = PanelInverse::new(base, &kernel, panels, parameter, slopes)?;
    let weight = inverse.slopes.as_deref();
    let equation =
        PanelEquation { operator: &operator, parameter, weight, groups: &inverse.groups };
    let radii = panels.nodes();
    let tolerance = solved.unsolved.max(OF_A_VALUE) * panels.integral(radii, |r| r).sqrt();
    let found = equation.solve(radii, &[], &vec![0.0; radii.len()], tolerance)?;
    let size = (radii.len() as f64).max(operator.near_pairs() as f64 / work::PAIRS);
    base.problem().deadline().spend(work::PRODUCT * size * found.products as f64);
    let half = solved.field.hull.half;
    Ok(PI * half.powi(4) * panels.integral(&inverse.pressures(&found.values), |r| r))
}

/// A response with what is left of its equation.
struct Solution {
    layer: Vec<f64>,
    pressed: Pressed<Vec<f64>>,
    left: Vec<f64>,
    noise: f64,
}

/// The kernel of the ground, the frame of all panels, and those of these zones in local coordinates. Where they crowd beside long ones, whose neighbours all act directly, those are cut.
pub(super) fn cut(
    base: &Base,
    joints: &[f64],
    zones: &[Zone],
    mut fineness: Fineness,
) -> Result<(PanelKernel, Frame, Panels), Error> {
    let (kernel, half) = base.ground.panel_kernel().ok_or_else(unknown)?;
    let frame = Frame::new(base, Hull { centre: base.surface.origin, half }, 0.0);
    let mut before = f64::INFINITY;
    loop {
        let bounds = panels(base, joints, zones, fineness, MOST_NODES).ok_or_else(unknown)?;
        let longest = bounds.iter().map(|[left, right]| right - left).fold(0.0, f64::max);
        let local = |xi: f64| frame.local(xi).clamp(-1.0, 1.0);
        let bounds: Vec<[f64; 2]> = bounds.into_iter().map(|panel| panel.map(local)).collect();
        // Where places are rounded to the length of a panel cutting makes none shorter.
        let is_cut = std::mem::replace(&mut before, longest) > longest;
        if !is_cut || bounds.iter().any(|[left, right]| left >= right) {
            return Err(unknown());
        }
        let is_disk = base.ground.is_disk();
        let panels = if is_disk { Panels::about_axis } else { Panels::new };
        let panels = panels(bounds, fineness.order)?;
        match PanelOperator::check(&kernel, &panels) {
            Err(fredholm::Error::TooLarge { .. }) => fineness.longest = 0.5 * longest,
            checked => return Ok(checked.map(|()| (kernel, frame, panels))?),
        }
    }
}
