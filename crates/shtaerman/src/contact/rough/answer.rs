//! The unilateral answer.

use fredholm::SincSolution;

use super::anchor::Anchor;
use super::base::Base;

use super::between::PLACES;
use super::between::between_nodes;
use super::solved::{Solved, Stated};
use crate::Load;
use crate::contact::accuracy::Accuracy;
use crate::contact::balance::State;
use crate::contact::check::Check;
use crate::contact::complementarity::Complementarity;
use crate::contact::ground::SharedKernel;
use crate::contact::method::{Method, MethodName};
use crate::contact::rates::Linearised;
use crate::contact::setting::Setting;
use crate::contact::solution::Solution;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::{Zone, outside};

/// Zones, pressure, settlement, tilt, force and moment of a unilateral contact, without dimensions.
#[derive(Debug, Clone)]
pub(super) struct UnilateralContact {
    setting: Setting,
    solved: Solved,
    /// Settlement, tilt, force and moment of the problem itself.
    state: State,
    /// Where heights are counted from.
    anchor: Option<Anchor>,
    accuracy: Accuracy,
    edge_error: f64,
    /// None where the whole base was kept in contact.
    complementarity: Option<Complementarity>,
    /// The tilt of a circular punch.
    tilted: Option<Tilted>,
    /// Places where the contact does not touch, one for each interval.
    beside: Vec<f64>,
}

/// The pressure `p1(r) cos(phi)` of a tilted circular punch.
#[derive(Debug, Clone)]
pub(super) struct Tilted {
    /// For `-alpha0 = 1`.
    pub(super) unit: SincSolution,
    /// `alpha0`.
    pub(super) tilt: f64,
    pub(super) kernel: SharedKernel,
}

impl Tilted {
    /// `p1(r)`.
    pub(super) fn pressure(&self, r: f64) -> f64 {
        -self.tilt * self.unit.evaluate(r, r)
    }

    /// The elastic displacement at `r` for `cos(phi) = 1`.
    fn displacement(&self, r: f64) -> f64 {
        let potential = if r <= 1.0 {
            self.unit.evaluate_potential(r)
        } else {
            self.unit.integral(|s| self.kernel.value(r, s))
        };
        -self.tilt * self.unit.parameter() * potential
    }
}

impl UnilateralContact {
    pub(super) fn new(base: &Base<'_>, solved: Solved, check: &Check) -> Self {
        let Stated { accuracy, edge: edge_error } = solved.stated.with_kernel(base, &solved);
        let complementarity =
            Complementarity { tension: check.tension, penetration: check.penetration };
        let complementarity = (!base.is_bilateral).then_some(complementarity);
        let beside = outside(&base.pieces, &solved.zones)
            .iter()
            .map(|[left, right]| 0.5 * (left + right))
            .collect();
        let given = base.setting.load();
        let (state, accuracy) = match &base.anchor {
            Some(anchor) => (anchor.state(given, solved.state), anchor.accuracy(accuracy)),
            None => (solved.state, accuracy),
        };
        let anchor = base.anchor;
        let setting = base.setting.clone();
        let tilted = None;
        Self {
            setting,
            solved,
            state,
            anchor,
            accuracy,
            edge_error,
            complementarity,
            tilted,
            beside,
        }
    }

    pub(super) fn setting(&self) -> &Setting {
        &self.setting
    }

    pub(super) fn solved(&self) -> &Solved {
        &self.solved
    }

    pub(super) fn tilted(&self) -> Option<&Tilted> {
        self.tilted.as_ref()
    }

    pub(super) fn anchor(&self) -> Option<Anchor> {
        self.anchor
    }

    pub(super) fn with_tilt(self, tilted: Tilted) -> Self {
        Self { tilted: Some(tilted), ..self }
    }

    /// Where a point of the base lies in the coordinates of the solution: on a disk the distance from the axis, on a wave without gaps the image between the ends
    /// of its zones.
    pub(super) fn locate(&self, xi: f64) -> f64 {
        if self.solved.ground.is_disk() {
            return xi.abs();
        }
        if self.solved.ground.is_closed() {
            let origin = self.solved.hull.centre;
            return xi + 2.0 * (0.5 * (origin - xi)).round();
        }
        xi
    }

    /// The zone of a place in the coordinates of the solution.
    fn zone(&self, place: f64) -> Option<&Zone> {
        self.solved.zones.iter().find(|zone| zone.left() <= place && place <= zone.right())
    }

    /// Both places of the base, or the one, that a place in the coordinates of the solution stands for.
    fn images(&self, place: f64) -> [f64; 2] {
        if self.solved.ground.is_disk() {
            return [-place, place];
        }
        let is_image = self.solved.ground.is_closed() && place.abs() > 1.0;
        let place = if is_image { place - 2.0 * (0.5 * place).round() } else { place };
        [place; 2]
    }
}

/// The images of the zones of a wave whose middles lie on the base, from left to right.
pub(super) fn on_the_base(zones: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut images: Vec<[f64; 2]> = zones
        .map(|[left, right]| {
            let periods = 2.0 * (0.25 * (left + right)).round();
            [left - periods, right - periods]
        })
        .collect();
    images.sort_by(|one, two| one[0].total_cmp(&two[0]));
    images
}

impl Solution for UnilateralContact {
    fn state(&self) -> State {
        self.state
    }

    /// Edges that move add nothing of first order, as the pressure vanishes there.
    fn stiffness(&self) -> Stiffness {
        self.solved.stiffness
    }

    /// Of a disk along its diameter; of a wave without gaps a zone may reach beyond the base, on its image.
    fn zones(&self) -> Vec<[f64; 2]> {
        let zones = self.solved.zones.iter().map(|zone| [zone.left(), zone.right()]);
        if self.solved.ground.is_closed() {
            return on_the_base(zones);
        }
        if !self.solved.ground.is_disk() {
            return zones.collect();
        }
        let mut along: Vec<[f64; 2]> = Vec::new();
        for [left, right] in zones {
            if left == 0.0 {
                along.push([-right, right]);
            } else {
                along.extend([[-right, -left], [left, right]]);
            }
        }
        along.sort_by(|one, two| one[0].total_cmp(&two[0]));
        along
    }

    fn touches(&self, xi: f64) -> bool {
        self.zone(self.locate(xi)).is_some()
    }

    fn pressure(&self, xi: f64) -> f64 {
        let place = self.locate(xi);
        let Some(zone) = self.zone(place) else {
            return if xi.is_nan() { xi } else { 0.0 };
        };
        if zone.free_ends().any(|(_, at)| at == place) {
            return 0.0;
        }
        // At a step of the base the height is that under pressure.
        let inside = 1e-12 * zone.length();
        let at_step = |side: usize| zone.ends[side] == place && xi.abs() < 1.0;
        let shift = if at_step(0) {
            inside
        } else if at_step(1) {
            -inside
        } else {
            0.0
        };
        let [_, image] = self.images(place);
        let height = |step: f64| match &self.anchor {
            Some(anchor) => anchor.rise(self.setting.problem(), image + step * shift),
            None => self.setting.height(image + step * shift),
        };
        // On a steep base the distance alone would show.
        let height = if shift == 0.0 { height(0.0) } else { 2.0 * height(1.0) - height(2.0) };
        let pressure = self.solved.pressure_at(place, height);
        let sign = if xi < 0.0 { -1.0 } else { 1.0 };
        pressure + self.tilted.as_ref().map_or(0.0, |tilted| sign * tilted.pressure(place))
    }

    fn displacement(&self, xi: f64) -> f64 {
        let place = self.locate(xi);
        let sign = if xi < 0.0 { -1.0 } else { 1.0 };
        let turned = self.tilted.as_ref().map_or(0.0, |tilted| sign * tilted.displacement(place));
        if self.zone(place).is_some() {
            // Of the equation itself: the layer without the profile, with the sign turned.
            let State { settlement, tilt, .. } = self.solved.state;
            let tilt = if self.solved.ground.is_disk() { 0.0 } else { tilt };
            return settlement - tilt * place - self.solved.layer_at(place, 0.0) + turned;
        }
        self.solved.displacement_outside(place) + turned
    }

    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        let mut places: Vec<f64> = vec![-1.0, 1.0];
        // Between any two nodes: on many of them a pressure has as many tops.
        let nodes = self.solved.positions.len() / self.solved.panels.len().max(1);
        let count = PLACES.max(2 * nodes);
        for panel in &self.solved.panels {
            let (middle, half) =
                (0.5 * (panel.left + panel.right), 0.5 * (panel.right - panel.left));
            let inside =
                between_nodes(count).map(|y| (middle + half * y).clamp(panel.left, panel.right));
            places.extend(inside.flat_map(|place| self.images(place)));
        }
        // Ends themselves, which a share of a panel misses by a rounding: at corners the pressure is steep.
        let ends = self.solved.panels.iter().flat_map(|panel| [panel.left, panel.right]);
        places.extend(ends.flat_map(|place| self.images(place)));
        places.extend(self.beside.iter().flat_map(|place| self.images(*place)));
        // A zero has one sign.
        places.iter_mut().for_each(|place| *place += 0.0);
        places.sort_by(f64::total_cmp);
        places.dedup();
        let pressures = places.iter().map(|&xi| self.pressure(xi)).collect();
        (places, pressures)
    }

    fn method(&self) -> Method {
        Method { name: MethodName::Sinc, n: self.solved.positions.len() }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        self.solved.zones.iter().any(Zone::has_free_end).then_some(self.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.complementarity
    }

    fn linearised(&self, load: Load, peak: f64) -> Option<Linearised> {
        self.first_order(load, peak)
    }

    fn size(&self) -> f64 {
        self.solved.largest()
    }
}
