//! The pressure on given zones, and where what it tells is positive.

use fredholm::multipole::{
    Groups, PanelCondition, PanelEquation, PanelField, PanelLogarithm, Panels,
};

use super::mesh::{Fineness, panels};
use crate::contact::balance::State;
use crate::contact::solved::Stiffness;
use crate::contact::unilateral::base::Base;
use crate::contact::unilateral::fine::edges::positive;
use crate::contact::unilateral::zones::Zone;
use crate::{Error, Rotational, Vertical};

/// Most nodes.
const MOST_NODES: usize = 400_000;
/// Longest groups, in lengths of the layer, and about the most groups beyond the number of zones.
const GROUP: f64 = 0.25;
const MOST_GROUPS: f64 = 400.0;
/// Rounding of the right-hand side.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Samples between joints, and at least.
const SAMPLES: usize = 4;
const FEWEST_SAMPLES: usize = 4096;

/// The contact on given zones.
#[derive(Debug, Clone)]
pub(in crate::contact::unilateral) struct Level {
    pub(super) zones: Vec<Zone>,
    pub(super) state: State,
    pub(super) stiffness: Stiffness,
    pub(super) field: PanelField,
    /// Pressures at the nodes.
    pub(super) pressures: Vec<f64>,
    theta: f64,
}

impl Level {
    /// Solves on these zones, from what was known before, to a relative residual; none where there are too many nodes.
    pub(super) fn new(
        base: &Base<'_>,
        joints: &[f64],
        zones: &[Zone],
        fineness: Fineness,
        (known, tolerance): (Option<&Self>, f64),
    ) -> Result<Option<Self>, Error> {
        let Some(bounds) = panels(base, joints, zones, fineness, MOST_NODES) else {
            return Ok(None);
        };
        let operator = PanelLogarithm::new(Panels::new(bounds, fineness.order)?)?;
        let panels = operator.panels();
        let total: f64 = zones.iter().map(Zone::length).sum();
        let longest = (GROUP / base.theta).max(total / MOST_GROUPS);
        let groups = Groups::new(panels, base.theta, longest)?;
        let equation =
            PanelEquation { operator: &operator, parameter: base.theta, groups: &groups };
        let nodes = panels.nodes();
        let column = |f: &dyn Fn(f64) -> f64| -> Vec<f64> { nodes.iter().map(|x| f(*x)).collect() };
        let mut right = column(&|x| -base.height(x));
        let mut conditions = Vec::new();
        let mut add = |f: &dyn Fn(f64) -> f64| {
            right.iter_mut().zip(nodes).for_each(|(value, x)| *value += f(*x));
        };
        let force = match base.load.vertical {
            Vertical::Force(value) => {
                conditions.push(PanelCondition { column: vec![1.0; nodes.len()], value });
                value
            }
            Vertical::Settlement(settlement) => {
                add(&|_| settlement);
                0.0
            }
        };
        match base.load.rotational {
            Rotational::Moment(value) => {
                conditions.push(PanelCondition { column: nodes.to_vec(), value });
            }
            Rotational::Eccentricity(e) => {
                conditions.push(PanelCondition { column: nodes.to_vec(), value: e * force });
            }
            Rotational::Tilt(tilt) => add(&|x| -tilt * x),
        }
        let start: Vec<f64> = known.map_or_else(
            || vec![0.0; nodes.len()],
            |known| nodes.iter().map(|x| known.inside(*x).unwrap_or(0.0)).collect(),
        );
        let size = |values: &[f64]| panels.integral(values, |_| 1.0).abs() / total.sqrt();
        let squares: Vec<f64> = right.iter().map(|value| value * value).collect();
        let depth = panels.integral(&squares, |_| 1.0).sqrt();
        let carried = if force > 0.0 { force / total.sqrt() } else { size(&start) };
        let carried = if carried > 0.0 { carried } else { depth };
        let solution = equation.solve(
            &right,
            &conditions,
            &start,
            (tolerance * carried).max(ROUNDING * depth),
        )?;
        let state = balanced(base, panels, &solution.values, &solution.multipliers);
        let field = operator.field(&solution.values);
        let stiffness = Stiffness { force_settlement: 0.0, coupling: 0.0, moment_tilt: 0.0 };
        let mut level = Self {
            zones: zones.to_vec(),
            state,
            stiffness,
            field,
            pressures: solution.values,
            theta: base.theta,
        };
        if std::env::var("SPOTS").is_ok() {
            eprintln!(
                "   zones {} panels {} nodes {} groups {} products {} residual {:e}",
                zones.len(),
                level.field.panels().bounds().len(),
                level.pressures.len(),
                groups.count(),
                solution.products,
                solution.residual / carried
            );
        }
        if known.is_some_and(|_| tolerance < 1e-12) {
            level.stiffness = stiffness_of(&equation)?;
        }
        Ok(Some(level))
    }

    /// The pressure in the zones, from the values at the nodes.
    pub(super) fn inside(&self, xi: f64) -> Option<f64> {
        self.field.panels().interpolate(&self.pressures, xi)
    }

    /// `delta0 - alpha0 xi - f0 - theta0 K p0`, given the height: the pressure in a zone, minus the gap beside.
    pub(super) fn pressure_at(&self, xi: f64, height: f64) -> f64 {
        self.state.settlement - self.state.tilt * xi - height - self.displacement(xi)
    }

    /// `theta0 int ln(1/|xi - eta|) p0(eta) deta`.
    pub(super) fn displacement(&self, xi: f64) -> f64 {
        self.theta * self.field.at(xi)
    }

    /// Whether the place lies in a zone.
    pub(super) fn touches(&self, xi: f64) -> bool {
        let after = self.zones.partition_point(|zone| zone.right() < xi);
        self.zones.get(after).is_some_and(|zone| zone.left() <= xi)
    }

    /// The largest pressure at the nodes.
    pub(super) fn largest(&self) -> f64 {
        self.pressures.iter().fold(0.0, |most, p| most.max(*p))
    }

    /// Largest pressure, of either sign, at the free ends.
    pub(super) fn at_ends(&self, base: &Base<'_>) -> f64 {
        let ends = self.zones.iter().flat_map(|zone| zone.ends).filter(|end| end.is_free);
        ends.map(|end| self.pressure_at(end.at, base.height(end.at)).abs()).fold(0.0, f64::max)
    }

    /// Places from edge to edge of the punch that show every bend of the profile, with what the pressure is there.
    pub(super) fn sampled(&self, base: &Base<'_>, joints: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let middles = self.zones.iter().map(|zone| 0.5 * (zone.left() + zone.right()));
        let mut at: Vec<f64> = middles.collect();
        let cuts: Vec<f64> =
            [-1.0].into_iter().chain(joints.iter().copied()).chain([1.0]).collect();
        for pair in cuts.windows(2) {
            let share = 0.5 * (pair[1] - pair[0]) * FEWEST_SAMPLES as f64;
            let parts = (share.ceil() as usize).max(SAMPLES);
            at.extend((0..parts).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / parts as f64));
        }
        at.push(1.0);
        at.sort_by(f64::total_cmp);
        at.dedup();
        let values = at
            .iter()
            .map(|xi| self.inside(*xi).unwrap_or_else(|| self.pressure_at(*xi, base.height(*xi))))
            .collect();
        (at, values)
    }

    /// Where the pressure and the gap tell that the zones are.
    pub(super) fn next_zones(&self, base: &Base<'_>, sampled: &(Vec<f64>, Vec<f64>)) -> Vec<Zone> {
        let pressure = |xi: f64| self.pressure_at(xi, base.height(xi));
        positive(&pressure, &sampled.0, &sampled.1)
    }
}

/// Settlement, tilt, force and moment from multipliers and pressures.
fn balanced(base: &Base<'_>, panels: &Panels, pressures: &[f64], multipliers: &[f64]) -> State {
    let mut multipliers = multipliers.iter().copied();
    let (force, settlement) = match base.load.vertical {
        Vertical::Force(force) => (force, multipliers.next().unwrap_or(0.0)),
        Vertical::Settlement(settlement) => (panels.integral(pressures, |_| 1.0), settlement),
    };
    let (moment, tilt) = match base.load.rotational {
        Rotational::Moment(moment) => (moment, -multipliers.next().unwrap_or(0.0)),
        Rotational::Eccentricity(e) => (e * force, -multipliers.next().unwrap_or(0.0)),
        Rotational::Tilt(tilt) => (panels.integral(pressures, |x| x), tilt),
    };
    // Adding zero turns a negative zero into a plain one.
    State {
        settlement: settlement + 0.0,
        tilt: tilt + 0.0,
        force: force + 0.0,
        moment: moment + 0.0,
    }
}

/// `d(P0, M0)/d(delta0, -alpha0)` on the zones as they are.
fn stiffness_of(equation: &PanelEquation<'_>) -> Result<Stiffness, Error> {
    const RESIDUAL: f64 = 1e-11;
    let panels = equation.operator.panels();
    let zero = vec![0.0; panels.count()];
    let ones = vec![1.0; panels.count()];
    let size = panels.integral(&ones, |_| 1.0).sqrt();
    let level = equation.solve(&ones, &[], &zero, RESIDUAL * size)?;
    let tilted = equation.solve(panels.nodes(), &[], &zero, RESIDUAL * size)?;
    Ok(Stiffness {
        force_settlement: panels.integral(&level.values, |_| 1.0),
        coupling: panels.integral(&level.values, |x| x),
        moment_tilt: panels.integral(&tilted.values, |x| x),
    })
}
