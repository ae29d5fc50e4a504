//! The pressure on given zones, to be looked at anywhere.

use std::sync::Arc;

use super::frame::Direction;
use super::layer::Layer;
use super::nodes::{Discrete, Field, Nodes, Response, Step};
use crate::Error;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::ground::Ground;
use crate::contact::search::ALLOWED;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::line_search::Point;

/// Share of a zone, or of a panel at its end, over which the slope of the layer at that end is taken (survey).
pub(super) const BESIDE: f64 = 0.02;

/// The pressure on given zones under the load; at free edges it need not vanish yet.
#[derive(Debug, Clone)]
pub(super) struct Solved<F> {
    pub(super) nodes: Arc<Nodes>,
    pub(super) ground: Arc<dyn Ground>,
    /// `k theta0`.
    pub(super) strength: f64,
    pub(super) layer: Layer,
    /// The displacement `v` of the layer at the nodes.
    pub(super) given: Vec<f64>,
    /// `p0 dm` at the nodes.
    pub(super) masses: Vec<f64>,
    pub(super) field: F,
    pub(super) local: [f64; 2],
    pub(super) state: State,
    /// `theta K p` at the nodes.
    displaced: Vec<f64>,
    pub(super) responses: Option<Arc<[Response<F>; 3]>>,
    /// The residual that was small enough, relative to the layer; 0 where the equation was solved directly.
    pub(super) unsolved: f64,
    pub(super) at_ends: AtEnds,
    pub(super) stated: Stated,
    /// Up to two coarser resolutions of the same.
    pub(super) coarser: Vec<Self>,
}

/// What is left at free ends, the most of all; nothing where the zones are those of the pressure.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct AtEnds {
    /// The displacement of the layer, in size.
    pub(super) layer: f64,
    /// How far an end lies from where it would vanish.
    pub(super) off: f64,
}

/// What a solution is known to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stated {
    pub(super) accuracy: Accuracy,
    /// Of the free ends, in `xi`.
    pub(super) edge: f64,
    /// How far these are off by what the nodes miss, rounding aside: as other numbers of nodes tell it, and waves between the nodes.
    pub(super) off: f64,
}

impl Stated {
    /// Of a solution that others are to be compared with.
    fn none() -> Self {
        let [pressure, settlement, tilt, force, moment] = [f64::INFINITY; 5];
        let kind = ErrorKind::Estimate;
        let accuracy = Accuracy { kind, pressure, settlement, tilt, force, moment };
        Self { accuracy, edge: f64::INFINITY, off: 0.0 }
    }
}

/// The largest size of some values.
pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

impl<F: Field> Solved<F> {
    pub(super) fn new<D: Discrete<Field = F>>(on: &D, step: Step<D::Pressure>) -> Self {
        let (base, nodes) = (on.base(), Arc::clone(on.nodes()));
        let direction = step.direction();
        let Step { layer: given, local, pressed } = step;
        let measure = base.ground.measure(&nodes.frame.hull);
        let masses = on.masses(&pressed.pressure).into_iter();
        let masses: Vec<f64> = masses.map(|mass| measure * mass).collect();
        let moment = base.ground.is_closed().then(|| {
            let moments = nodes.places.iter().zip(&masses);
            moments.map(|(xi, mass)| base.surface.on_base(*xi) * mass).sum()
        });
        Self {
            ground: Arc::clone(&base.ground),
            strength: base.strength(),
            layer: base.layer,
            given,
            masses,
            field: on.field(pressed.pressure),
            local,
            state: nodes.frame.state(&direction, moment),
            displaced: pressed.displaced,
            responses: None,
            unsolved: on.residual(),
            at_ends: AtEnds::default(),
            stated: Stated::none(),
            coarser: Vec::new(),
            nodes,
        }
    }

    /// With its responses, perhaps from those of a solution nearby.
    pub(super) fn answering<D: Discrete<Field = F>>(
        mut self,
        on: &D,
        inverse: &D::Inverse<'_>,
        near: Option<&Self>,
    ) -> Result<Self, Error> {
        let gauge = self.nodes.frame.gauge_of(self.state.force);
        let body: Vec<f64> = self.displaced.iter().map(|u| gauge - u).collect();
        let near = near.and_then(|near| near.responses.as_deref());
        self.responses = Some(Arc::new(on.responses(inverse, &body, near)?));
        Ok(self)
    }

    /// Largest displacement of the layer at the nodes, of either sign.
    pub(super) fn deepest(&self) -> f64 {
        largest(&self.given)
    }

    /// Largest `|p0|` at the nodes.
    pub(super) fn largest(&self) -> f64 {
        self.given.iter().fold(0.0, |most, v| most.max(self.layer.pressure(*v).abs()))
    }

    /// A bound of what is added up in the displacement of the layer.
    pub(super) fn size(&self) -> f64 {
        self.deepest() + largest(&self.displaced)
    }

    /// Rounding of the displacement of the layer: of what the body gives, and of `D - beta y - f0`, whose terms are large where small zones lie far from the middle.
    pub(super) fn rounding(&self) -> f64 {
        let [constant, slope] = self.local;
        F::ROUNDING * self.size() + f64::EPSILON * (constant.abs() + slope.abs())
    }

    /// Where it pulls most, if by more than rounding and than the pressure is known to.
    pub(super) fn pulls_most(&self, known_to: f64) -> Option<f64> {
        let (xi, least) =
            self.nodes.places.iter().zip(&self.given).min_by(|a, b| a.1.total_cmp(b.1))?;
        let deepest = self.deepest();
        let known_to = known_to / self.layer.slope(deepest);
        (*least < -known_to.max(ALLOWED * deepest)).then_some(*xi)
    }

    /// What the pressure is not known to, as a share of the largest.
    pub(super) fn noise(&self) -> f64 {
        self.stated.accuracy.pressure / self.largest().max(f64::MIN_POSITIVE)
    }

    /// `D - beta y - f0 - theta K p`, given the height: what the layer gives in a zone, minus the gap beside.
    pub(super) fn layer_at(&self, xi: f64, height: f64) -> f64 {
        self.under((xi, height), self.field.at(xi))
    }

    /// The same at many places with their heights.
    pub(super) fn layers_at(&self, places: &[Point]) -> Vec<f64> {
        let displaced = self.field.at_all(&places.iter().map(|(xi, _)| *xi).collect::<Vec<_>>());
        let places = places.iter().zip(displaced);
        places.map(|(place, displaced)| self.under(*place, displaced)).collect()
    }

    fn under(&self, (xi, height): Point, displaced: f64) -> f64 {
        self.local[0] - self.local[1] * self.nodes.frame.local(xi) - height - displaced
    }

    /// The pressure of that.
    pub(super) fn pressure_at(&self, xi: f64, height: f64) -> f64 {
        self.layer.pressure(self.layer_at(xi, height))
    }

    /// `theta0 k int K(xi, eta) p0 dm`.
    pub(super) fn displacement(&self, xi: f64) -> f64 {
        self.field.at(xi) - self.nodes.frame.gauge_of(self.state.force)
    }

    /// `theta0 k int dK/dxi p0 dm` at places, and the same of the size of what is added up.
    pub(super) fn slopes(&self, places: &[f64]) -> Vec<[f64; 2]> {
        let slope_at = |xi: &f64| {
            let masses = self.nodes.places.iter().zip(&self.masses);
            let parts =
                masses.map(|(eta, mass)| self.strength * mass * self.ground.slope(*xi, *eta));
            parts.fold([0.0; 2], |[sum, size], part| [sum + part, size + part.abs()])
        };
        self.field.slopes(places).unwrap_or_else(|| places.iter().map(slope_at).collect())
    }

    /// How far free ends are off: from where the layer would vanish there, and by what nodes miss.
    pub(super) fn ends_off(&self) -> f64 {
        self.at_ends.off.max(self.stated.off)
    }

    /// The largest displacement of the layer, of either sign, at the free ends.
    pub(super) fn layer_at_ends(&self, height: impl Fn(f64) -> f64) -> f64 {
        let ends = self.nodes.zones.iter().flat_map(Zone::free_ends);
        ends.map(|(_, at)| self.layer_at(at, height(at)).abs()).fold(0.0, f64::max)
    }

    /// `d(P0, M0)/d(delta0, -alpha0)`; free edges that move add nothing of first order, as the pressure vanishes there. NaN without responses.
    pub(super) fn stiffness(&self) -> Stiffness {
        let carried = |k: usize| self.responses.as_ref().map_or([f64::NAN; 2], |r| r[k].carried);
        self.nodes.frame.stiffness(&Direction::of_local([carried(1), carried(2)]))
    }
}
