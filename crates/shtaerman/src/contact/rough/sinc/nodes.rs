//! The equation collocated on given zones.

use std::cell::{OnceCell, RefCell};
use std::sync::Arc;

use fredholm::collocation::{SincFactor, SincGrid, WeightedFactor, rounding};
use fredholm::{SincOperator, SincSolution};

use super::field::SincField;
use crate::Error;
use crate::contact::ground::{Ground, Hull};
use crate::contact::rough::base::Base;
use crate::contact::rough::frame::{Direction, Frame};
use crate::contact::rough::nodes::{Discrete, Nodes, Pressed, Response, Step, Task};
use crate::contact::zones::Zone;

/// Fewest nodes on either side of the middle of a panel. Half and twice change none of 20 answers (survey).
pub(super) const FEWEST: usize = 8;

/// Panels with their operator.
type Built = (Vec<(f64, f64)>, Arc<SincOperator>);

/// A number of nodes with what can be shared among zones.
pub(in crate::contact::rough) struct Resolution {
    /// Nodes on either side of the middle of a panel, before they are rounded to a number.
    pub(super) strength: f64,
    ground: Arc<dyn Ground>,
    grid: Arc<SincGrid>,
    /// The operator on the local interval in one panel.
    whole: OnceCell<Arc<SincOperator>>,
    /// The operator on other panels that was built last.
    latest: RefCell<Option<Built>>,
}

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
enum Factor<'o> {
    Linear(SincFactor<'o>),
    Weighted(WeightedFactor<'o>),
}

/// The inverse, with the solutions for `D` and `beta`.
pub(in crate::contact::rough) struct SincInverse<'o> {
    factor: Factor<'o>,
    frame: [SincSolution; 2],
}

impl SincInverse<'_> {
    fn solve(&self, right: &[f64]) -> Result<SincSolution, Error> {
        self.factor.solve(right)
    }
}

impl Factor<'_> {
    fn solve(&self, right: &[f64]) -> Result<SincSolution, Error> {
        Ok(match self {
            Self::Linear(factor) => factor.solve(right)?,
            Self::Weighted(factor) => factor.solve(right)?,
        })
    }
}

/// The nodes of given zones with their operator.
pub(in crate::contact::rough) struct SincNodes<'b> {
    base: &'b Base,
    operator: Arc<SincOperator>,
    nodes: Arc<Nodes>,
    /// `theta`.
    parameter: f64,
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
            zones.iter().flat_map(|zone| zone.panels(&base.breaks)).map(<[f64; 2]>::from).collect();
        let operator = resolution.operator(&local_panels(ground, &hull, &panels))?;
        let place = |place: fredholm::collocation::Place| {
            let [left, right] = panels[place.panel];
            let xi = if place.from_left < place.from_right {
                left + hull.half * place.from_left
            } else {
                right - hull.half * place.from_right
            };
            xi.clamp(left.next_up(), right.next_down().max(left.next_up()))
        };
        let places: Vec<f64> = operator.places().map(place).collect();
        let heights = base.heights(&places)?;
        let frame = Frame::new(base, hull, ground.gauge(&hull));
        let (zones, locals) = (zones.to_vec(), operator.positions().collect());
        let nodes = Arc::new(Nodes { zones, panels, places, locals, heights, frame });
        let parameter = base.strength() * ground.scale(&hull);
        Ok(Self { base, operator, nodes, parameter })
    }

    /// Force, and moment about the centre, of a pressure: `b int p dy`, `b^2 int y p dy`; on a disk the force of rings.
    fn carried(&self, solution: &SincSolution) -> [f64; 2] {
        let (ground, frame) = (self.base.ground.as_ref(), &self.nodes.frame);
        let unit = ground.area() * ground.measure(&frame.hull);
        let turn = |y: f64| frame.hull.half * y;
        [
            unit * solution.integral(|_| 1.0),
            if frame.turns { unit * solution.integral(turn) } else { 0.0 },
        ]
    }

    fn with_displacement(&self, pressure: SincSolution) -> Pressed<SincSolution> {
        let displaced = pressure.potential().iter().map(|u| self.parameter * u).collect();
        let carried = self.carried(&pressure);
        Pressed { pressure, displaced, carried }
    }

    fn direction(&self, inverse: &SincInverse<'_>, k: usize) -> Direction {
        let local = [[1.0, 0.0], [0.0, 1.0]][k];
        Direction { local, carried: self.carried(&inverse.frame[k]) }
    }
}

impl Discrete for SincNodes<'_> {
    type Pressure = SincSolution;
    type Field = SincField;
    type Inverse<'o>
        = SincInverse<'o>
    where
        Self: 'o;

    fn base(&self) -> &Base {
        self.base
    }

    fn nodes(&self) -> &Arc<Nodes> {
        &self.nodes
    }

    fn pressed(&self, pressures: Vec<f64>) -> Result<Pressed<SincSolution>, Error> {
        let nothing = vec![0.0; pressures.len()];
        let response = self.operator.response(self.parameter, &nothing, &pressures)?;
        Ok(self.with_displacement(response))
    }

    fn inverse(&self, slopes: Option<Vec<f64>>) -> Result<SincInverse<'_>, Error> {
        let factor = match slopes {
            None => Factor::Linear(self.operator.factor(self.parameter)?),
            Some(slopes) => {
                Factor::Weighted(self.operator.factor_weighted(self.parameter, &slopes)?)
            }
        };
        let level = factor.solve(&vec![1.0; self.nodes.places.len()])?;
        // What does not turn has no use for the other.
        let tilted = if self.nodes.frame.turns {
            let lever: Vec<f64> = self.nodes.locals.iter().map(|y| -y).collect();
            factor.solve(&lever)?
        } else {
            level.clone()
        };
        Ok(SincInverse { factor, frame: [level, tilted] })
    }

    fn solve(
        &self,
        inverse: &SincInverse<'_>,
        Task { right, lack, .. }: Task<'_>,
    ) -> Result<Step<SincSolution>, Error> {
        let frame = &self.nodes.frame;
        let free = Direction { local: [0.0; 2], carried: self.carried(&inverse.solve(right)?) };
        let directions = [0, 1].map(|k| self.direction(inverse, k));
        let local = frame.met(&directions, (1.0, &free), lack)?;
        let sums = right.iter().zip(&self.nodes.locals);
        let right: Vec<f64> = sums.map(|(b, y)| b + (local[0] - local[1] * y)).collect();
        let solution = inverse.solve(&right)?;
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
        _near: Option<&dyn Fn(f64) -> [f64; 3]>,
    ) -> Result<[Response<SincField>; 3], Error> {
        let [level, tilted] = inverse.frame.clone();
        Ok([inverse.solve(body)?, level, tilted].map(|solution| Response {
            layer: Vec::new(),
            carried: self.carried(&solution),
            noise: rounding(&solution),
            field: self.field(solution),
        }))
    }
}

/// The panels in local coordinates.
fn local_panels(ground: &dyn Ground, hull: &Hull, panels: &[[f64; 2]]) -> Vec<(f64, f64)> {
    let ends = ground.local_ends();
    let local = |xi: f64| {
        let y = (xi - hull.centre) / hull.half;
        ends.map_or(y, |[left, right]| y.clamp(left, right))
    };
    let mut local: Vec<(f64, f64)> =
        panels.iter().map(|&[left, right]| (local(left), local(right))).collect();
    // The ends of the hull are exact.
    if let Some([left, right]) = ends
        && let (Some(first), Some(last)) = (panels.first(), panels.last())
    {
        let end = local.len() - 1;
        if !ground.is_disk() || first[0] == 0.0 {
            local[0].0 = left;
        }
        if last[1] > first[0] {
            local[end].1 = right;
        }
    }
    local
}
