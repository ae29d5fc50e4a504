//! The equation collocated on given zones.

use std::cell::RefCell;
use std::sync::Arc;

use fredholm::collocation::{Place, SincGrid, WeightedFactor, rounding};
use fredholm::{SincOperator, SincSolution};

use crate::Error;
use crate::contact::ground::{Ground, Hull};
use crate::contact::method::MethodName;
use crate::contact::rough::base::Base;
use crate::contact::rough::frame::{Direction, Frame};
use crate::contact::rough::nodes::{
    Discrete, FEWEST, Field, Nodes, PLACES, Pressed, RATIO, Response, Step, Task, between_nodes,
};
use crate::contact::rough::solved::Solved;
use crate::contact::rough::turned::collocated_turning;
use crate::contact::zones::Zone;
use crate::profile::beside::{Beside, corrected};

/// Shares of a panel from its ends at which resolutions are compared as well, one a decade: nodes crowd there, and what they miss of a kernel that is a power shows in a few decades only, which places between the nodes do not reach (survey).
const BESIDE_ENDS: [f64; 9] = [3e-14, 3e-13, 3e-12, 3e-11, 3e-10, 3e-9, 3e-8, 3e-7, 3e-6];

/// A number of nodes with what can be shared among zones.
pub(in crate::contact::rough) struct Resolution {
    /// Nodes on either side of the middle of a panel, before they are rounded to a number.
    pub(super) strength: f64,
    /// What the layer gives at free ends over the most, at which the zones are good enough.
    pub(super) ends: f64,
    ground: Arc<dyn Ground>,
    grid: Arc<SincGrid>,
    /// The last operator with its panels: a zone without bends, and one that is its own mirror image with a bend in the middle, has the same wherever its ends are.
    last: RefCell<Option<(LocalPanels, Arc<SincOperator>)>>,
}

/// Panels in local coordinates.
type LocalPanels = Vec<(f64, f64)>;

impl Resolution {
    /// About so many nodes on either side of the middle of a panel.
    pub(super) fn new(ground: &Arc<dyn Ground>, strength: f64, ends: f64) -> Result<Self, Error> {
        let grid = ground.grid((strength.round() as usize).max(FEWEST))?;
        Ok(Self { strength, ends, ground: Arc::clone(ground), grid, last: RefCell::default() })
    }

    fn operator(&self, panels: LocalPanels) -> Result<Arc<SincOperator>, Error> {
        let mut last = self.last.borrow_mut();
        if let Some((known, operator)) = &*last
            && *known == panels
        {
            return Ok(Arc::clone(operator));
        }
        let build = || self.ground.operator(&self.grid, &panels).map(Arc::new);
        let operator = match (self.ground.local_ends(), &panels[..]) {
            (Some([left, right]), [panel]) if *panel == (left, right) => {
                let known = self.ground.known_operator(self.grid.half_count());
                known.unwrap_or_else(build)?
            }
            _ => build()?,
        };
        *last = Some((panels, Arc::clone(&operator)));
        Ok(operator)
    }
}

/// The displacements of a collocated pressure.
#[derive(Debug, Clone)]
pub(in crate::contact::rough) struct SincField {
    nodes: Arc<Nodes>,
    ground: Arc<dyn Ground>,
    /// Its integrals are those of the pressure.
    solution: SincSolution,
}

impl Field for SincField {
    const NAME: MethodName = MethodName::Sinc;
    /// As [`fredholm::collocation::rounding`].
    const ROUNDING: f64 = 12.0 * f64::EPSILON;
    const RATIO: Option<f64> = Some(RATIO);

    fn at(&self, xi: f64) -> f64 {
        let position = self.nodes.frame.local(xi);
        match self.place(xi) {
            Some(place) => -self.solution.evaluate_place(place, 0.0),
            None => {
                let kernel =
                    |t: &[f64], values: &mut [f64]| self.ground.values(position, t, values);
                self.solution.parameter() * self.solution.integral_of(kernel)
            }
        }
    }

    fn pressures(&self, places: &[f64]) -> Option<Vec<f64>> {
        // On disks densities are told by the measure `s ds`.
        let is_disk = self.ground.is_disk();
        let density = |place: Place| if is_disk { place.position } else { 1.0 };
        let told = |place: Place| self.solution.density_at(place) / density(place);
        places.iter().map(|xi| self.place(*xi).map(told)).collect()
    }

    fn between() -> Vec<f64> {
        let beside =
            BESIDE_ENDS.into_iter().flat_map(|share| [2.0 * share - 1.0, 1.0 - 2.0 * share]);
        between_nodes(PLACES).chain(beside).collect()
    }

    fn turning(base: &Base, solved: &Solved<Self>) -> Result<[f64; 2], Error> {
        collocated_turning(base, solved)
    }
}

impl SincField {
    /// Where a place of the zones lies on its panel.
    fn place(&self, xi: f64) -> Option<Place> {
        let Nodes { panels, frame, .. } = &*self.nodes;
        let panel = panels.partition_point(|[_, right]| *right < xi);
        let [left, right] = panels.get(panel).filter(|[left, _]| *left <= xi)?;
        let [from_left, from_right] = [xi - left, right - xi].map(|d| d / frame.hull.half);
        Some(Place { position: frame.local(xi), from_left, from_right, panel })
    }
}

/// The nodes of given zones with their operator.
pub(in crate::contact::rough) struct SincNodes<'b> {
    base: &'b Base,
    operator: Arc<SincOperator>,
    nodes: Arc<Nodes>,
    parameter: f64,
}

/// The inverse, with the solutions for `D` and `beta`.
pub(in crate::contact::rough) struct SincInverse<'o> {
    factor: WeightedFactor<'o>,
    frame: [Pressed<SincSolution>; 2],
}

impl<'b> SincNodes<'b> {
    pub(super) fn new(
        base: &'b Base,
        resolution: &Resolution,
        zones: &[Zone],
    ) -> Result<Self, Error> {
        let (Some(first), Some(last)) = (zones.first(), zones.last()) else {
            return Err(Error::NoContact);
        };
        let ground = base.ground.as_ref();
        let hull = ground.hull(first.left(), last.right(), base.surface.origin);
        let panels: Vec<[f64; 2]> =
            zones.iter().flat_map(|zone| zone.panels(&base.breaks)).collect();
        let operator = resolution.operator(local_panels(ground, &hull, &panels))?;
        let place = |place: Place| {
            let distances = [place.from_left, place.from_right].map(|d| hull.half * d);
            Beside::new(panels[place.panel], distances)
        };
        let beside: Vec<Beside> = operator.places().map(place).collect();
        let places: Vec<f64> = beside.iter().map(Beside::number).collect();
        base.problem().deadline().spend(ground.entry() * (places.len() as f64).powi(2));
        let mut heights = base.heights(&places)?;
        corrected(&mut heights, &beside, |xi| base.height(xi));
        let frame = Frame::new(base, hull, ground.gauge(&hull));
        let (zones, locals) = (zones.to_vec(), operator.positions().collect());
        let nodes = Arc::new(Nodes { zones, panels, places, locals, heights, frame });
        Ok(Self { base, operator, nodes, parameter: base.strength() * ground.scale(&hull) })
    }

    fn with_displacement(&self, solution: SincSolution) -> Pressed<SincSolution> {
        let potential = solution.potential().to_vec();
        self.with_potential(solution, &potential)
    }
}

impl Discrete for SincNodes<'_> {
    type Pressure = SincSolution;
    type Field = SincField;
    type Inverse<'o>
        = SincInverse<'o>
    where
        Self: 'o;

    fn shared(&self) -> (&Base, &Arc<Nodes>, f64) {
        (self.base, &self.nodes, self.parameter)
    }

    fn work(&self) -> f64 {
        (self.nodes.places.len() as f64).powi(3)
    }

    fn masses(&self, solution: &SincSolution) -> Vec<f64> {
        solution.node_masses().to_vec()
    }

    fn pressed(&self, pressures: Vec<f64>) -> Result<Pressed<SincSolution>, Error> {
        let nothing = vec![0.0; pressures.len()];
        let response = self.operator.response(self.parameter, &nothing, &pressures)?;
        Ok(self.with_displacement(response))
    }

    fn inverse(&self, slopes: Option<Vec<f64>>) -> Result<SincInverse<'_>, Error> {
        let ones = vec![1.0; self.nodes.places.len()];
        let weights = slopes.as_ref().unwrap_or(&ones);
        let factor = self.operator.factor_weighted(self.parameter, weights)?;
        let level = factor.solve(&ones)?;
        // What does not turn has no use for the other.
        let turns = self.nodes.frame.turns;
        let tilted = if turns { factor.solve(&self.nodes.lever())? } else { level.clone() };
        let frame = [level, tilted].map(|solution| self.with_displacement(solution));
        Ok(SincInverse { factor, frame })
    }

    fn solve(
        &self,
        inverse: &SincInverse<'_>,
        Task { right, lack, .. }: Task<'_>,
    ) -> Result<Step<SincSolution>, Error> {
        let carried = self.carried(&inverse.factor.node_masses(right)?);
        let free = Direction { local: [0.0; 2], carried };
        let directions = Direction::of_local(inverse.frame.each_ref().map(|unit| unit.carried));
        let local = self.nodes.frame.met(&directions, (1.0, &free), lack)?;
        let sums = right.iter().zip(&self.nodes.locals);
        let right: Vec<f64> = sums.map(|(b, y)| b + (local[0] - local[1] * y)).collect();
        let solution = inverse.factor.solve(&right)?;
        let layer = solution.values().to_vec();
        Ok(Step { layer, local, pressed: self.with_displacement(solution) })
    }

    /// Root of the mean square.
    fn norm(&self, values: &[f64]) -> f64 {
        (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
    }

    fn field(&self, solution: SincSolution) -> SincField {
        let (nodes, ground) = (Arc::clone(&self.nodes), Arc::clone(&self.base.ground));
        SincField { nodes, ground, solution }
    }

    fn responses(
        &self,
        inverse: &SincInverse<'_>,
        body: &[f64],
        _near: Option<&[Response<SincField>; 3]>,
    ) -> Result<[Response<SincField>; 3], Error> {
        let [level, tilted] = inverse.frame.each_ref().map(|unit| unit.pressure.clone());
        Ok([inverse.factor.solve(body)?, level, tilted].map(|solution| {
            let noise = rounding(&solution);
            let Pressed { pressure, carried, .. } = self.with_displacement(solution);
            Response { layer: Vec::new(), field: self.field(pressure), carried, noise }
        }))
    }
}

/// The panels in local coordinates, the ends of the hull exact.
fn local_panels(ground: &dyn Ground, hull: &Hull, panels: &[[f64; 2]]) -> LocalPanels {
    let ends = ground.local_ends();
    let local = |xi: f64| {
        let y = (xi - hull.centre) / hull.half;
        ends.map_or(y, |[left, right]| y.clamp(left, right))
    };
    let mut local: LocalPanels =
        panels.iter().map(|&[left, right]| (local(left), local(right))).collect();
    let Some([left, right]) = ends else { return local };
    if let (Some(first), Some(begin)) = (local.first_mut(), panels.first())
        && (!ground.is_disk() || begin[0] == 0.0)
    {
        first.0 = left;
    }
    if let Some(last) = local.last_mut() {
        last.1 = right;
    }
    local
}
