//! The pressure on given zones, and where what it tells is positive.

use fredholm::multipole::{
    Groups, PanelCondition, PanelEquation, PanelField, PanelOperator, Panels,
};

use super::bent;
use super::chart::Chart;
use super::mesh::{Fineness, LONGEST, panels};
use super::positive::positive;
use crate::contact::accuracy::OF_A_VALUE;
use crate::contact::balance::State;
use crate::contact::rough::base::Base;
use crate::contact::rough::base::SAMPLES_A_PART;
use crate::contact::rough::coarse::Coarse;
use crate::contact::rough::layer::Layer;
use crate::contact::search::Equation;
use crate::contact::zones::Zone;
use crate::{Error, Rotational, Vertical};

/// Most nodes. Half and twice change none of 32 answers (survey).
const MOST_NODES: usize = 400_000;
/// Longest groups, in lengths of the layer, and about the most groups beyond the number of zones. At half or twice stated errors grow up to 6.4 times (survey).
const GROUP: f64 = 0.25;
const MOST_GROUPS: f64 = 400.0;
/// How panels that are too long are shortened, three times at most.
const SHORTER: f64 = 0.25;
/// Samples between measured points, between other joints, and at least. At half or twice time grows by 27 % (survey).
const SAMPLES: usize = 4;
const FEWEST_SAMPLES: usize = 4096;

/// What is known before: other zones or panels, or cells.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known<'k> {
    pub(super) level: Option<&'k Level>,
    pub(super) coarse: Option<&'k Coarse>,
}

/// The contact on given zones.
#[derive(Debug, Clone)]
pub(in crate::contact::rough) struct Level {
    pub(super) zones: Vec<Zone>,
    pub(super) state: State,
    pub(super) field: PanelField,
    /// Pressures at the nodes.
    pub(super) pressures: Vec<f64>,
    /// What the layer gives at the nodes: of a linear one the pressures.
    pub(super) given: Vec<f64>,
    pub(super) layer: Layer,
    pub(super) chart: Chart,
    /// `theta0` by the coordinates of the panels.
    parameter: f64,
}

/// What the layer gives at places of a piece of the base from end to end, beside the zones minus the gap.
#[derive(Debug, Clone)]
pub(super) struct Sampled {
    pub(super) at: Vec<f64>,
    pub(super) values: Vec<f64>,
}

/// How well the equation is to be solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    pub(super) fineness: Fineness,
    /// Residual relative to the pressure.
    pub(super) residual: f64,
    /// Whether the first-order changes are wanted.
    pub(super) has_responses: bool,
}

/// The operator of a level with its approximate inverse.
#[derive(Debug)]
pub(super) struct System {
    pub(super) operator: PanelOperator,
    pub(super) groups: Groups,
    pub(super) chart: Chart,
    /// `theta0` by the coordinates of the panels.
    pub(super) parameter: f64,
    /// `theta0 K p0` at the nodes.
    pub(super) displacements: Vec<f64>,
    /// `dp0/dv` at the nodes; none for a linear layer.
    pub(super) modulus: Option<Vec<f64>>,
}

impl System {
    pub(super) fn equation(&self) -> PanelEquation<'_> {
        PanelEquation {
            operator: &self.operator,
            parameter: self.parameter,
            weight: self.modulus.as_deref(),
            groups: &self.groups,
        }
    }

    /// The pressures of small changes of the layer.
    pub(super) fn pressures(&self, changes: &[f64]) -> Vec<f64> {
        match &self.modulus {
            None => changes.to_vec(),
            Some(modulus) => modulus.iter().zip(changes).map(|(w, v)| w * v).collect(),
        }
    }
}

impl Level {
    /// Solves on these zones, from what was known before; none where there are too many nodes.
    pub(super) fn new(
        base: &Base<'_>,
        joints: &[f64],
        zones: &[Zone],
        effort: Effort,
        known: Known<'_>,
    ) -> Result<Option<(Self, System)>, Error> {
        let Some(chart) = Chart::new(base) else { return Ok(None) };
        let Some(operator) = operator(base, &chart, joints, zones, effort.fineness)? else {
            return Ok(None);
        };
        let panels = operator.panels();
        let parameter = base.theta * chart.half();
        let given = Given::new(base, &chart, panels);
        let total = zones.iter().map(Zone::length).sum::<f64>() / chart.half();
        let task = Task { base, operator: &operator, parameter, given: &given, total, effort };
        let start: Vec<Option<f64>> = (panels.nodes().iter())
            .map(|y| {
                known.level.and_then(|known| known.field.panels().interpolate(&known.given, *y))
            })
            .collect();
        let found = if base.layer.is_linear() {
            Some(task.linear(&chart, &start)?)
        } else {
            bent::solve(&task, &chart, &start, known)?
        };
        let Some(Found { given, pressures, multipliers, potential, modulus, groups }) = found
        else {
            return Ok(None);
        };
        let level = Self {
            zones: zones.to_vec(),
            state: balanced(base, &chart, panels, &pressures, &multipliers),
            field: operator.field(&pressures),
            pressures,
            given,
            layer: base.layer,
            chart,
            parameter,
        };
        let displacements = potential.iter().map(|u| parameter * u).collect();
        let system = System { operator, groups, chart, parameter, displacements, modulus };
        Ok(Some((level, system)))
    }

    /// What the layer gives in the zones, from the values at the nodes.
    pub(super) fn inside(&self, xi: f64) -> Option<f64> {
        self.field.panels().interpolate(&self.given, self.chart.local(xi))
    }

    /// `delta0 - alpha0 xi - f0 - theta0 K p0`, given the height: what the layer gives in a zone, of a linear one the pressure; minus the gap beside.
    pub(super) fn layer_at(&self, xi: f64, height: f64) -> f64 {
        self.state.settlement - self.state.tilt * xi - height - self.displacement(xi)
    }

    /// The pressure of that.
    pub(super) fn pressure_at(&self, xi: f64, height: f64) -> f64 {
        self.layer.pressure(self.layer_at(xi, height))
    }

    /// `theta0 int K p0 deta`.
    pub(super) fn displacement(&self, xi: f64) -> f64 {
        self.parameter * self.field.at(self.chart.local(xi))
    }

    /// Whether the place lies in a zone.
    pub(super) fn touches(&self, xi: f64) -> bool {
        let after = self.zones.partition_point(|zone| zone.right() < xi);
        self.zones.get(after).is_some_and(|zone| zone.left() <= xi)
    }

    /// The side of the end of a zone that is here, and whether it is free.
    pub(super) fn end_at(&self, xi: f64) -> Option<(usize, bool)> {
        let after = self.zones.partition_point(|zone| zone.right() < xi);
        let zone = self.zones.get(after)?;
        (0..2).find(|&side| zone.ends[side] == xi).map(|side| (side, zone.is_free(side)))
    }

    /// The panels as intervals of `xi`.
    pub(super) fn bounds(&self) -> Vec<[f64; 2]> {
        let bounds = self.field.panels().bounds().iter();
        bounds.map(|panel| panel.map(|y| self.chart.place(y))).collect()
    }

    /// The least slope of what the layer gives at a free end.
    pub(super) fn gentlest(&self) -> f64 {
        let bounds = self.bounds();
        let first = |at: f64| bounds.partition_point(|[_, right]| *right <= at);
        let mut least = f64::INFINITY;
        for zone in &self.zones {
            for (side, end) in zone.free_ends() {
                let panel = if side == 0 { first(end) } else { first(end).saturating_sub(1) };
                let Some([left, right]) = bounds.get(panel) else { continue };
                let middle = 0.5 * (left + right);
                let distance = (middle - end).abs();
                if let Some(given) = self.inside(middle).filter(|_| distance > 0.0) {
                    least = least.min(given.abs() / distance);
                }
            }
        }
        least
    }

    /// A bound of what is added up in what the layer gives.
    pub(super) fn size(&self) -> f64 {
        self.largest() + self.state.settlement.abs() + self.state.tilt.abs()
    }

    /// The most that the layer gives at the nodes.
    pub(super) fn largest(&self) -> f64 {
        self.given.iter().fold(0.0, |most, v| most.max(v.abs()))
    }

    /// The largest pressure at the nodes.
    pub(super) fn highest(&self) -> f64 {
        self.pressures.iter().fold(0.0, |most, p| most.max(p.abs()))
    }

    /// The most that the layer gives, of either sign, at the free ends.
    pub(super) fn at_ends(&self, base: &Base<'_>) -> f64 {
        let ends = self.zones.iter().flat_map(Zone::free_ends);
        ends.map(|(_, at)| self.layer_at(at, base.height(at)).abs()).fold(0.0, f64::max)
    }

    /// Places of each piece of the base, from end to end, that show every bend of the profile, with what the pressure is there.
    pub(super) fn sampled(&self, base: &Base<'_>, joints: &[f64]) -> Vec<Sampled> {
        (base.pieces.iter()).map(|piece| self.sampled_on(base, joints, *piece)).collect()
    }

    fn sampled_on(&self, base: &Base<'_>, joints: &[f64], [from, to]: [f64; 2]) -> Sampled {
        let mut at: Vec<f64> = Vec::new();
        for zone in self.zones.iter().filter(|zone| zone.left() >= from && zone.right() <= to) {
            at.extend([zone.left(), 0.5 * (zone.left() + zone.right()), zone.right()]);
        }
        let inside = joints.iter().copied().filter(|at| *at > from && *at < to);
        let cuts: Vec<f64> = [from].into_iter().chain(inside).chain([to]).collect();
        let is_measured = base.problem.profile().measured_points().is_some();
        let fewest = if is_measured { SAMPLES } else { SAMPLES_A_PART };
        for pair in cuts.windows(2) {
            let share = 0.5 * (pair[1] - pair[0]) * FEWEST_SAMPLES as f64;
            let parts = (share.ceil() as usize).max(fewest);
            at.extend((0..parts).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / parts as f64));
        }
        at.push(to);
        at.sort_by(f64::total_cmp);
        at.dedup();
        let value = |xi: &f64| {
            // At an end the polynomials are least exact, and beside it the same function goes on.
            let inside = if self.end_at(*xi).is_some() { None } else { self.inside(*xi) };
            inside.unwrap_or_else(|| self.layer_at(*xi, base.height(*xi)))
        };
        let values = at.iter().map(value).collect();
        Sampled { at, values }
    }

    /// Where the pressure and the gap tell that the zones are; pressures up to `none` are zero.
    pub(super) fn next_zones(&self, base: &Base<'_>, sampled: &[Sampled], none: f64) -> Vec<Zone> {
        let given = |xi: f64| self.layer_at(xi, base.height(xi));
        let on_piece = |piece: &Sampled| positive(&given, &piece.at, &piece.values, none);
        sampled.iter().flat_map(on_piece).map(|ends| base.zone(ends)).collect()
    }
}

/// The operator on panels of these zones; none where there are too many nodes. Where they crowd beside long panels, whose neighbours all act directly, those are cut.
fn operator(
    base: &Base<'_>,
    chart: &Chart,
    joints: &[f64],
    zones: &[Zone],
    mut fineness: Fineness,
) -> Result<Option<PanelOperator>, Error> {
    loop {
        let Some(bounds) = panels(base, joints, zones, fineness, MOST_NODES) else {
            return Ok(None);
        };
        let local = |xi: f64| chart.local(xi).clamp(-1.0, 1.0);
        let bounds: Vec<[f64; 2]> = bounds.into_iter().map(|panel| panel.map(local)).collect();
        if bounds.iter().any(|[left, right]| left >= right) {
            return Ok(None);
        }
        let panels = Panels::new(bounds, fineness.order)?;
        match PanelOperator::new(chart.kernel, panels) {
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

/// What is found on given panels.
pub(super) struct Found {
    /// What the layer gives, and the pressure.
    pub(super) given: Vec<f64>,
    pub(super) pressures: Vec<f64>,
    pub(super) multipliers: Vec<f64>,
    /// `K p0`.
    pub(super) potential: Vec<f64>,
    pub(super) modulus: Option<Vec<f64>>,
    pub(super) groups: Groups,
}

/// The equation on given panels.
pub(super) struct Task<'t, 'b, 'p> {
    pub(super) base: &'b Base<'p>,
    pub(super) operator: &'t PanelOperator,
    /// `theta0` by the coordinates of the panels.
    pub(super) parameter: f64,
    pub(super) given: &'t Given,
    /// The length of all zones in those coordinates.
    total: f64,
    effort: Effort,
}

impl Task<'_, '_, '_> {
    /// Groups of a quarter of the layer where the modulus is largest.
    pub(super) fn groups(&self, chart: &Chart, modulus: Option<&[f64]>) -> Result<Groups, Error> {
        let firmest = modulus.map_or(1.0, |w| w.iter().fold(0.0f64, |most, w| most.max(*w)));
        let strength = (self.parameter * firmest).max(f64::MIN_POSITIVE);
        let layer = (GROUP / strength).powf(1.0 / (1.0 - self.base.ground.exponent()));
        let longest = layer.max(self.total / MOST_GROUPS);
        let panels = self.operator.panels();
        Ok(Groups::new(chart.kernel, panels, self.parameter, longest, modulus)?)
    }

    /// Root of the integral of the square.
    pub(super) fn norm(&self, values: &[f64]) -> f64 {
        let squares: Vec<f64> = values.iter().map(|value| value * value).collect();
        self.operator.panels().integral(&squares, |_| 1.0).sqrt()
    }

    /// The residual that is small enough for a layer of this norm.
    pub(super) fn tolerance(&self, size: f64) -> f64 {
        (self.effort.residual * size).max(OF_A_VALUE * self.norm(&self.given.right))
    }

    fn linear(&self, chart: &Chart, start: &[Option<f64>]) -> Result<Found, Error> {
        let groups = self.groups(chart, None)?;
        let (operator, parameter) = (self.operator, self.parameter);
        let equation = PanelEquation { operator, parameter, weight: None, groups: &groups };
        let start: Vec<f64> = start.iter().map(|value| value.unwrap_or(0.0)).collect();
        let Given { right, conditions, force } = self.given;
        // At least the norm of a uniform pressure.
        let carried = [self.norm(&start), force / self.total.sqrt(), self.norm(right)];
        let carried = carried.into_iter().find(|size| *size > 0.0).unwrap_or(1.0);
        let solution = equation.solve(right, conditions, &start, self.tolerance(carried))?;
        Ok(Found {
            given: solution.values.clone(),
            pressures: solution.values,
            multipliers: solution.multipliers,
            potential: solution.potential,
            modulus: None,
            groups,
        })
    }
}

/// What the load and the profile prescribe at the nodes.
pub(super) struct Given {
    pub(super) right: Vec<f64>,
    pub(super) conditions: Vec<PanelCondition>,
    /// The prescribed force, or none.
    force: f64,
}

impl Given {
    fn new(base: &Base<'_>, chart: &Chart, panels: &Panels) -> Self {
        let places: Vec<f64> = panels.nodes().iter().map(|y| chart.place(*y)).collect();
        let nodes = &places;
        let half = chart.half();
        let mut right: Vec<f64> = nodes.iter().map(|x| -base.height(*x)).collect();
        let mut add = |f: &dyn Fn(f64) -> f64| {
            right.iter_mut().zip(nodes).for_each(|(value, x)| *value += f(*x));
        };
        let mut conditions = Vec::new();
        let force = match base.load.vertical {
            Vertical::Force(value) => {
                conditions.push(PanelCondition::symmetric(vec![1.0; nodes.len()], value / half));
                value / half
            }
            Vertical::Settlement(settlement) => {
                add(&|_| settlement);
                0.0
            }
        };
        let column = nodes.clone();
        match (base.load.vertical, base.load.rotational) {
            (_, Rotational::Moment(moment)) => {
                conditions.push(PanelCondition::symmetric(column, moment / half));
            }
            (Vertical::Force(force), Rotational::Eccentricity(e)) => {
                conditions.push(PanelCondition::symmetric(column, e * force / half));
            }
            (Vertical::Settlement(_), Rotational::Eccentricity(e)) => {
                let row = nodes.iter().map(|x| x - e).collect();
                conditions.push(PanelCondition { row, column, value: 0.0 });
            }
            (_, Rotational::Tilt(tilt)) => add(&|x| -tilt * x),
        }
        Self { right, conditions, force }
    }
}

/// Settlement, tilt, force and moment from multipliers and pressures.
fn balanced(
    base: &Base<'_>,
    chart: &Chart,
    panels: &Panels,
    pressures: &[f64],
    multipliers: &[f64],
) -> State {
    let mut multipliers = multipliers.iter().copied();
    let carried = |lever: &dyn Fn(f64) -> f64| chart.half() * panels.integral(pressures, lever);
    let settlement = match base.load.vertical {
        Vertical::Force(_) => multipliers.next().unwrap_or(0.0),
        Vertical::Settlement(settlement) => settlement,
    };
    let tilt = -multipliers.next().unwrap_or(0.0);
    let (force, moment) = (carried(&|_| 1.0), carried(&|y| chart.lever(y)));
    State { settlement, tilt, force, moment }.given(&base.load)
}
