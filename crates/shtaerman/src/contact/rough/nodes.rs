//! What both discretisations are to the rest: zones with nodes, a factored equation on them, and displacements anywhere.

use std::fmt::Debug;
use std::ops::Range;
use std::sync::Arc;

use super::base::Base;
use super::frame::{Direction, Frame};
use super::solved::Solved;
use crate::Error;
use crate::contact::method::MethodName;
use crate::contact::zones::Zone;
use crate::golden::GOLDEN;

/// Places on a panel at which resolutions are compared (survey).
pub(super) const PLACES: usize = 128;
/// Fewest nodes of a collocated panel on either side of its middle (survey).
pub(super) const FEWEST: usize = 8;
/// Growth of their number from one resolution to the next (survey).
pub(super) const RATIO: f64 = std::f64::consts::SQRT_2;
/// Most of them together: a dense system takes some seconds (memory and time).
pub(super) const MOST_DENSE: usize = 2400;

/// Zones cut into panels, with the nodes on these.
#[derive(Debug, Clone)]
pub(super) struct Nodes {
    pub(super) zones: Vec<Zone>,
    /// From left to right, as `xi`.
    pub(super) panels: Vec<[f64; 2]>,
    /// The nodes, of each panel as many, as `xi` and as `y`.
    pub(super) places: Vec<f64>,
    pub(super) locals: Vec<f64>,
    /// `f0` at the nodes.
    pub(super) heights: Vec<f64>,
    pub(super) frame: Frame,
}

impl Nodes {
    /// Nodes of a panel.
    pub(super) fn a_panel(&self) -> usize {
        self.places.len() / self.panels.len().max(1)
    }

    /// The zone that holds a place.
    pub(super) fn zone(&self, xi: f64) -> Option<&Zone> {
        let after = self.zones.partition_point(|zone| zone.right() < xi);
        self.zones.get(after).filter(|zone| zone.left() <= xi)
    }

    /// The panels of a zone.
    pub(super) fn panels_of(&self, zone: &Zone) -> Range<usize> {
        let first = self.panels.partition_point(|[_, right]| *right <= zone.left());
        first..self.panels.partition_point(|[left, _]| *left < zone.right())
    }

    /// The zone that ends here, and whether that is its left (0) or right (1) end.
    pub(super) fn end_at(&self, xi: f64) -> Option<(&Zone, usize)> {
        let zone = self.zone(xi)?;
        (0..2).find(|&side| zone.ends[side] == xi).map(|side| (zone, side))
    }

    /// `D - beta y - f0` at the nodes.
    pub(super) fn right(&self, [constant, slope]: [f64; 2]) -> Vec<f64> {
        let places = self.locals.iter().zip(&self.heights);
        places.map(|(y, height)| constant - slope * y - height).collect()
    }

    /// `-y` at the nodes.
    pub(super) fn lever(&self) -> Vec<f64> {
        self.locals.iter().map(|y| -y).collect()
    }

    /// Places on all panels, given from -1 to 1 on each.
    pub(super) fn on_panels(&self, places: &[f64]) -> impl Iterator<Item = f64> {
        self.panels.iter().flat_map(move |&[left, right]| {
            let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
            places.iter().map(move |y| (middle + half * y).clamp(left, right))
        })
    }
}

/// A pressure with what it does.
pub(super) struct Pressed<P> {
    pub(super) pressure: P,
    /// `theta K p` at the nodes, in local coordinates.
    pub(super) displaced: Vec<f64>,
    /// Force, and moment about the centre.
    pub(super) carried: [f64; 2],
}

/// An equation `v + theta K (w v) - D' + beta' y = b` whose `D'` and `beta'` make up for what the load lacks.
pub(super) struct Task<'t> {
    pub(super) right: &'t [f64],
    pub(super) lack: [f64; 2],
    /// Values to begin with, and the norm of the residual that is small enough: nothing to those who solve directly.
    pub(super) start: Option<&'t [f64]>,
    pub(super) residual: f64,
}

/// The layer at the nodes, `D` and `beta`, and the pressure `w v`.
pub(super) struct Step<P> {
    pub(super) layer: Vec<f64>,
    pub(super) local: [f64; 2],
    pub(super) pressed: Pressed<P>,
}

impl<P> Step<P> {
    pub(super) fn direction(&self) -> Direction {
        Direction { local: self.local, carried: self.pressed.carried }
    }
}

/// What the layer answers, with its pressure, to a right-hand side of the linearised equation.
#[derive(Debug, Clone)]
pub(super) struct Response<F> {
    /// The layer at the nodes, where others begin with that.
    pub(super) layer: Vec<f64>,
    /// The displacement of the pressure.
    pub(super) field: F,
    /// Force, and moment about the centre.
    pub(super) carried: [f64; 2],
    /// What the layer is not known to.
    pub(super) noise: f64,
}

/// The equation on nodes.
pub(super) trait Discrete {
    /// A pressure as it is kept.
    type Pressure;
    /// The displacements of one, anywhere.
    type Field: Field;
    /// `1 + theta K w`, ready to be solved.
    type Inverse<'o>
    where
        Self: 'o;

    /// The base, the nodes and `theta`.
    fn shared(&self) -> (&Base, &Arc<Nodes>, f64);

    fn base(&self) -> &Base {
        self.shared().0
    }

    /// What a step takes, in cubes of the numbers of unknowns of dense systems.
    fn work(&self) -> f64;

    fn nodes(&self) -> &Arc<Nodes> {
        self.shared().1
    }

    fn parameter(&self) -> f64 {
        self.shared().2
    }

    /// `p dm` at the nodes, but for the measure.
    fn masses(&self, pressure: &Self::Pressure) -> Vec<f64>;

    /// Force, and moment about the centre, of masses.
    fn carried(&self, masses: &[f64]) -> [f64; 2] {
        let (ground, nodes) = (self.base().ground.as_ref(), self.nodes());
        let frame = &nodes.frame;
        let unit = ground.area() * ground.measure(&frame.hull);
        let turn: f64 = masses.iter().zip(&nodes.locals).map(|(mass, y)| mass * y).sum();
        let turn = if frame.turns { unit * frame.hull.half * turn } else { 0.0 };
        [unit * masses.iter().sum::<f64>(), turn]
    }

    /// A pressure with its potential `K p` at the nodes.
    fn with_potential(
        &self,
        pressure: Self::Pressure,
        potential: &[f64],
    ) -> Pressed<Self::Pressure> {
        let carried = self.carried(&self.masses(&pressure));
        let displaced = potential.iter().map(|u| self.parameter() * u).collect();
        Pressed { pressure, displaced, carried }
    }

    fn pressed(&self, pressures: Vec<f64>) -> Result<Pressed<Self::Pressure>, Error>;

    /// For the slopes `w = dp0/dv` of the law at the nodes; none where they are 1.
    fn inverse(&self, slopes: Option<Vec<f64>>) -> Result<Self::Inverse<'_>, Error>;

    fn solve(
        &self,
        inverse: &Self::Inverse<'_>,
        task: Task<'_>,
    ) -> Result<Step<Self::Pressure>, Error>;

    /// A norm of values at the nodes, of 1 about 1.
    fn norm(&self, values: &[f64]) -> f64;

    /// The residual that is small enough, relative to the norm of the layer, rounding aside.
    fn residual(&self) -> f64 {
        0.0
    }

    fn field(&self, pressure: Self::Pressure) -> Self::Field;

    /// The responses to these values at the nodes, to 1 and to `-y`; perhaps from those on other nodes.
    fn responses(
        &self,
        inverse: &Self::Inverse<'_>,
        body: &[f64],
        near: Option<&[Response<Self::Field>; 3]>,
    ) -> Result<[Response<Self::Field>; 3], Error>;
}

/// The displacements of a pressure on nodes, anywhere.
pub(super) trait Field: Debug + Clone + Send + Sync + 'static {
    /// Name of the method.
    const NAME: MethodName;
    /// Rounding of what the layer gives, relative to what is added up in it.
    const ROUNDING: f64;
    /// Growth of the number of nodes from one resolution to the next, where errors fall as that lets expect.
    const RATIO: Option<f64>;

    /// `theta K p` at a place in the zones or beside them, in local coordinates.
    fn at(&self, xi: f64) -> f64;

    /// The same at many places.
    fn at_all(&self, places: &[f64]) -> Vec<f64> {
        places.iter().map(|xi| self.at(*xi)).collect()
    }

    /// Its slope at places where the pressure vanishes, each with the size of what is added up in it, where that is sooner known than by a sum over the nodes.
    fn slopes(&self, _places: &[f64]) -> Option<Vec<[f64; 2]>> {
        None
    }

    /// The function of these values at the nodes at places of the zones, where that is sooner known than the displacement.
    fn interpolated(&self, _values: &[f64], places: &[f64]) -> Vec<Option<f64>> {
        vec![None; places.len()]
    }

    /// The pressure at places of the zones as the values at the nodes alone tell it, where the displacement is that of a function through these.
    fn pressures(&self, _places: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// Places on each panel, from -1 to 1, at which resolutions are compared.
    fn between() -> Vec<f64>;

    /// `dM0/d(-alpha0)` of a disk, by pressures that go with `cos(phi)` on the zones of a solution, and what is left of its error beside that of these.
    fn turning(base: &Base, solved: &Solved<Self>) -> Result<[f64; 2], Error>;
}

/// Both ends, the middle, and a golden-ratio sequence of angles between, which no grid of a method shares.
pub(super) fn between_nodes(count: usize) -> impl Iterator<Item = f64> {
    let between = (1..=count).map(|i| (std::f64::consts::PI * (i as f64 * GOLDEN).fract()).cos());
    [-1.0, 0.0, 1.0].into_iter().chain(between)
}
