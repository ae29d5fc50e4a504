//! The answer on panels.

use super::level::Level;
use super::responses::{Responses, linearised};
use crate::contact::accuracy::Accuracy;
use crate::contact::balance::State;
use crate::contact::complementarity::Complementarity;
use crate::contact::method::{Method, MethodName};
use crate::contact::rates::Linearised;
use crate::contact::setting::Setting;
use crate::contact::solution::Solution;
use crate::contact::steps::INSIDE;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::{Load, Rotational};

/// Tension over the largest pressure that is none. Half and twice change none of 10 answers (survey).
const PULLING: f64 = 1e-10;

/// A contact in many zones with its errors.
#[derive(Debug, Clone)]
pub(in crate::contact::rough) struct SpotContact {
    pub(super) setting: Setting,
    pub(super) level: Level,
    /// On the panels before the last, and on the last.
    pub(super) responses: [Responses; 2],
    pub(super) accuracy: Accuracy,
    pub(super) edge_error: f64,
    /// None where the whole base was kept in contact.
    pub(super) complementarity: Option<Complementarity>,
}

impl SpotContact {
    /// Where full contact pulls most; none where it does so no more than rounding.
    pub(in crate::contact::rough) fn pulls_most(&self) -> Option<f64> {
        let nodes = self.level.field.panels().nodes().iter().zip(&self.level.given);
        let (y, least) = nodes.min_by(|one, two| one.1.total_cmp(two.1))?;
        let known_to = self.accuracy.pressure / self.level.layer.slope(self.level.largest());
        let allowed = known_to.max(PULLING * self.level.largest());
        (*least < -allowed).then(|| self.level.chart.place(*y))
    }

    /// The same as contact that might lift off, and does not.
    pub(in crate::contact::rough) fn lifting(self) -> Self {
        let complementarity = Some(Complementarity { tension: 0.0, penetration: 0.0 });
        Self { complementarity, ..self }
    }

    /// No tension, where the base may lift off.
    fn kept(&self, pressure: f64) -> f64 {
        if self.complementarity.is_some() { pressure.max(0.0) } else { pressure }
    }
}

impl Solution for SpotContact {
    fn state(&self) -> State {
        self.level.state
    }

    /// Edges that move add nothing of first order, as the pressure vanishes there.
    fn stiffness(&self) -> Stiffness {
        self.responses[1].stiffness()
    }

    fn stiffness_error(&self) -> Option<Stiffness> {
        Some(self.responses[1].stiffness_error(&self.responses[0]))
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        let zones = self.level.zones.iter().map(|zone| [zone.left(), zone.right()]);
        self.level.chart.zones_on_base(zones)
    }

    fn touches(&self, xi: f64) -> bool {
        self.level.touches(self.level.chart.located(xi))
    }

    fn pressure(&self, place: f64) -> f64 {
        let chart = &self.level.chart;
        let xi = chart.located(place);
        if xi.is_nan() || !self.level.touches(xi) {
            return if xi.is_nan() { xi } else { 0.0 };
        }
        let inwards = match self.level.end_at(xi) {
            Some((_, true)) => return 0.0,
            // At a step of the base the height is that under pressure.
            Some((side, _)) if place.abs() < 1.0 => {
                if side == 0 {
                    INSIDE
                } else {
                    -INSIDE
                }
            }
            _ => 0.0,
        };
        let height = |step: f64| self.setting.height(place + step * inwards);
        // On a steep base the distance alone would show.
        let height = if inwards == 0.0 { height(0.0) } else { 2.0 * height(1.0) - height(2.0) };
        self.kept(self.level.pressure_at(xi, height))
    }

    fn displacement(&self, xi: f64) -> f64 {
        self.level.displacement(self.level.chart.located(xi))
    }

    /// The nodes, both ends of the base and of the zones.
    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        let panels = self.level.field.panels();
        let pressures = self.level.pressures.iter().map(|p| self.kept(*p));
        let chart = &self.level.chart;
        let known = panels.nodes().iter().map(|y| chart.on_base(chart.place(*y))).zip(pressures);
        let zones = self.level.zones.iter().flat_map(|zone| [zone.left(), zone.right()]);
        let ends = zones.map(|xi| chart.on_base(xi)).chain([-1.0, 1.0]);
        let ends = ends.map(|xi| (xi, self.pressure(xi)));
        // Of a node that rounds to an end the end counts: beside a corner the pressure may change from one to the other.
        let mut samples: Vec<(f64, f64)> = ends.chain(known).collect();
        samples.sort_by(|one, two| one.0.total_cmp(&two.0));
        samples.dedup_by(|one, two| one.0 == two.0);
        samples.into_iter().unzip()
    }

    fn method(&self) -> Method {
        Method { name: MethodName::Panels, n: self.level.pressures.len() }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        self.level.zones.iter().any(Zone::has_free_end).then_some(self.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.complementarity
    }

    fn linearised(&self, mut load: Load, peak: f64) -> Option<Linearised> {
        if self.level.chart.is_closed() {
            // That no moment is asked for means that a wave cannot tilt.
            load.rotational = Rotational::Tilt(0.0);
        }
        let peak = self.level.chart.located(peak);
        let given = self.level.inside(peak).unwrap_or(0.0);
        Some(linearised(&self.responses, &load, (peak, self.level.layer.slope(given))))
    }

    fn size(&self) -> f64 {
        self.level.highest()
    }
}
