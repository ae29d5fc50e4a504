//! The answer, by either discretisation.

use std::sync::Arc;

use super::base::Base;
use super::linearised::{linearised, stiffness_error};
use super::nodes::Field;
use super::solved::{Solved, Stated};
use super::surface::Surface;
use super::turned::{Tilted, turned};
use crate::contact::accuracy::Accuracy;
use crate::contact::balance::State;
use crate::contact::check::Check;
use crate::contact::complementarity::Complementarity;
use crate::contact::ground::SHARP;
use crate::contact::method::Method;
use crate::contact::rates::Linearised;
use crate::contact::solution::Solution;
use crate::contact::steps::INSIDE;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::{EndKind, Zone, outside};
use crate::{Error, Load};

/// Samples are no closer to the ends of panels than this share of them: the end itself counts for those, as at a corner the pressure differs from that by `d ln d` (theory).
const APART: f64 = 1e-5;

/// Zones, pressure, settlement, tilt, force and moment of a contact on a rough surface, without dimensions.
#[derive(Debug, Clone)]
pub(super) struct RoughContact<F> {
    surface: Surface,
    solved: Solved<F>,
    /// On the base, from left to right.
    zones: Vec<[f64; 2]>,
    /// Settlement, tilt, force and moment of the problem itself.
    state: State,
    stiffness: Stiffness,
    accuracy: Accuracy,
    edge_error: f64,
    /// None where the whole base was kept in contact.
    complementarity: Option<Complementarity>,
    /// The tilt of a circular punch.
    tilted: Option<Tilted>,
    /// What is left of the error of the stiffness against that.
    turning_error: f64,
    /// Places besides the nodes that are looked at: one in each interval where the contact does not touch, and those of crests between nodes.
    beside: Vec<f64>,
}

impl<F: Field> RoughContact<F> {
    /// The answer that a solution amounts to, with the tilt of a circular punch.
    ///
    /// # Errors
    /// [`Error::LiftsOff`] where a circular punch tilts so much that it lifts off.
    pub(super) fn new(base: &Base, mut solved: Solved<F>, left: &Check) -> Result<Self, Error> {
        let mut stiffness = solved.stiffness();
        let (tilted, turning_error) = turned(base, &mut solved, &mut stiffness)?;
        let Stated { accuracy, edge: edge_error, .. } = solved.stated_with_kernel(base, &stiffness);
        let Check { tension, penetration, missed, .. } = *left;
        let accuracy = accuracy.with_left(missed, &stiffness);
        let accuracy = Accuracy {
            pressure: accuracy.pressure + 2.0 * missed * solved.layer.slope(solved.deepest()),
            ..accuracy
        };
        let complementarity = Complementarity { tension, penetration };
        let gaps = outside(&base.pieces, &solved.nodes.zones).into_iter();
        let gaps = gaps.map(|[left, right]| 0.5 * (left + right));
        let beside = gaps.chain(solved.crests(&base.samples)).collect();
        let (state, accuracy) = match &base.surface.tangent {
            Some(tangent) => {
                let given = base.surface.setting.load();
                (tangent.state(given, solved.state), tangent.accuracy(accuracy))
            }
            None => (solved.state, accuracy),
        };
        Ok(Self {
            zones: base.surface.zones(solved.nodes.zones.iter().map(|zone| zone.ends)),
            surface: base.surface.clone(),
            solved,
            state,
            stiffness,
            accuracy,
            edge_error,
            complementarity: (!base.is_bilateral).then_some(complementarity),
            tilted,
            turning_error,
            beside,
        })
    }

    /// Where full contact pulls most; none where it does so no more than rounding.
    pub(super) fn pulls_most(&self) -> Option<f64> {
        self.solved.pulls_most(self.accuracy.pressure)
    }

    /// Refuses tension of a layer that bends, which has none.
    ///
    /// # Errors
    /// [`Error::Pulls`].
    pub(super) fn without_tension(self) -> Result<Arc<dyn Solution>, Error> {
        match self.pulls_most().filter(|_| !self.solved.layer.is_linear()) {
            None => Ok(Arc::new(self)),
            Some(at) => {
                let bodies = self.surface.setting.problem().bodies();
                let (variable, at) = (bodies.coordinate(), at * bodies.half_width());
                Err(Error::Pulls { variable, at })
            }
        }
    }

    /// The same as contact that might lift off, and does not.
    pub(super) fn lifting(self) -> Self {
        Self { complementarity: Some(Complementarity { tension: 0.0, penetration: 0.0 }), ..self }
    }

    /// What turns with `cos(phi)` at a place of the base.
    fn turned(&self, xi: f64, of: impl Fn(&Tilted) -> f64) -> f64 {
        let sign = if xi < 0.0 { -1.0 } else { 1.0 };
        self.tilted.as_ref().map_or(0.0, |tilted| sign * of(tilted))
    }

    /// The pressure at `xi` given its part without angle: no tension, where the base may lift off.
    fn kept(&self, xi: f64, place: f64, pressure: f64) -> f64 {
        let pressure = pressure + self.turned(xi, |tilted| tilted.pressure(place));
        if self.complementarity.is_some() { pressure.max(0.0) } else { pressure }
    }
}

impl<F: Field> Solution for RoughContact<F> {
    fn state(&self) -> State {
        self.state
    }

    fn stiffness(&self) -> Stiffness {
        self.stiffness
    }

    fn stiffness_error(&self) -> Option<Stiffness> {
        let known = stiffness_error(&self.solved)?;
        Some(Stiffness { moment_tilt: known.moment_tilt.max(self.turning_error), ..known })
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        self.zones.clone()
    }

    fn touches(&self, xi: f64) -> bool {
        self.solved.nodes.zone(self.surface.located(xi)).is_some()
    }

    fn pressure(&self, xi: f64) -> f64 {
        let place = self.surface.located(xi);
        let Some(zone) = self.solved.nodes.zone(place) else {
            return if xi.is_nan() { xi } else { 0.0 };
        };
        let inside = INSIDE * zone.length();
        let inwards = match (0..2).find(|&side| zone.ends[side] == place) {
            Some(side) if zone.is_free(side) => return 0.0,
            // At a step of the base the height is that under pressure.
            Some(side) if zone.kinds[side] == EndKind::Wall && xi.abs() < 1.0 => {
                if side == 0 {
                    inside
                } else {
                    -inside
                }
            }
            _ => 0.0,
        };
        let height = |step: f64| self.surface.height(place + step * inwards);
        // On a steep base the distance alone would show.
        let height = if inwards == 0.0 { height(0.0) } else { 2.0 * height(1.0) - height(2.0) };
        self.kept(xi, place, self.solved.pressure_at(place, height))
    }

    fn displacement(&self, xi: f64) -> f64 {
        let place = self.surface.located(xi);
        self.solved.displacement(place) + self.turned(xi, |tilted| tilted.displacement(place))
    }

    /// The nodes, both ends of the base and of the zones, and a place in every gap.
    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        let Solved { nodes, given, layer, .. } = &self.solved;
        let ends = nodes.zones.iter().map(|zone| zone.ends).chain(nodes.panels.iter().copied());
        let ends = ends.flatten().chain(self.beside.iter().copied());
        let ends = ends.flat_map(|place| self.surface.images(place)).chain([-1.0, 1.0]);
        let ends = crate::order::ascending(ends.map(|xi| xi + 0.0)).into_iter();
        let ends = ends.map(|xi| (xi, self.pressure(xi)));
        let values = nodes.places.chunks(nodes.a_panel()).zip(given.chunks(nodes.a_panel()));
        let known =
            nodes.panels.iter().zip(values).flat_map(|([left, right], (places, values))| {
                // The end itself counts for nodes so close to it that the pressure at a corner is hardly more.
                let least = APART * (right - left);
                let is_apart = move |at: f64| at - left > least && right - at > least;
                places.iter().zip(values).filter(move |(at, _)| is_apart(**at))
            });
        let known = known.flat_map(|(place, v)| {
            let at = |xi: f64| (xi + 0.0, self.kept(xi, *place, layer.pressure(*v)));
            self.surface.images(*place).map(at)
        });
        let mut samples: Vec<(f64, f64)> = ends.chain(known).collect();
        crate::order::sort_by_number(&mut samples, |one| one.0);
        samples.dedup_by(|one, two| one.0 == two.0);
        samples.into_iter().unzip()
    }

    fn method(&self) -> Method {
        let of_tilt = self.tilted.as_ref().map_or(0, |tilted| tilted.unit.nodes());
        Method { name: F::NAME, n: self.solved.given.len().max(of_tilt) }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        self.solved.nodes.zones.iter().any(Zone::has_free_end).then_some(self.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.complementarity
    }

    fn linearised(&self, load: Load, peak: f64) -> Option<Linearised> {
        let (solved, place) = (&self.solved, self.surface.located(peak));
        let at_corner = solved.nodes.end_at(place).is_some_and(|(zone, side)| !zone.is_free(side));
        // There the pressure goes as `d^(1-mu)`, and no double is near enough to a corner: differences tell.
        if at_corner && solved.ground.exponent() >= SHARP {
            return None;
        }
        let found = linearised(solved, &self.surface, load, place)?;
        match &self.tilted {
            Some(tilted) => Some(tilted.linearised(found, load.vertical, peak)),
            None => Some(found),
        }
    }

    fn size(&self) -> f64 {
        self.solved.largest() + self.tilted.as_ref().map_or(0.0, Tilted::largest)
    }
}
