//! The pressure on given zones, to be looked at anywhere.

use std::sync::Arc;

use fredholm::SincSolution;
use fredholm::collocation::{Place, rounding};

use super::base::Base;
use super::layer::Layer;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::ground::{Ground, Hull};
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;

/// A panel in `xi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Panel {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) zone: usize,
}

impl Panel {
    pub(super) fn length(&self) -> f64 {
        self.right - self.left
    }
}

/// The pressure on given zones under the load; at free edges it need not vanish yet.
#[derive(Debug, Clone)]
pub(super) struct Solved {
    pub(super) zones: Vec<Zone>,
    pub(super) panels: Vec<Panel>,
    pub(super) ground: Arc<dyn Ground>,
    pub(super) layer: Layer,
    pub(super) hull: Hull,
    /// `xi` of the nodes.
    pub(super) positions: Vec<f64>,
    /// The displacement `v` of the layer; its integrals are those of the pressure.
    pub(super) solution: SincSolution,
    /// `D` and `beta`.
    pub(super) local: [f64; 2],
    pub(super) state: State,
    pub(super) stiffness: Stiffness,
    pub(super) stated: Stated,
}

/// What a solution is known to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stated {
    pub(super) accuracy: Accuracy,
    /// Of the free ends, in `xi`.
    pub(super) edge: f64,
}

impl Stated {
    /// With what a kernel that is not known to all digits leaves in a displacement, and that in the pressure and in the ends.
    pub(super) fn with_kernel(self, base: &Base<'_>, solved: &Solved) -> Self {
        let body = base.ground.strength() * base.theta * solved.state.force.abs();
        let missed = base.ground.kernel_error() * body;
        if missed == 0.0 {
            return self;
        }
        let Stiffness { force_settlement, moment_tilt, .. } = solved.stiffness;
        let raised = self.accuracy.with_profile_error(missed, [force_settlement, moment_tilt]);
        let slope = solved.layer.slope(solved.deepest());
        let pressure = raised.pressure + 2.0 * missed * slope;
        let longest = solved.zones.iter().map(Zone::length).fold(0.0, f64::max);
        let edge = self.edge + missed * longest / solved.deepest();
        Self { accuracy: Accuracy { pressure, ..raised }, edge }
    }

    /// Of a solution that others are to be compared with.
    pub(super) fn none() -> Self {
        let unknown = f64::INFINITY;
        let accuracy = Accuracy {
            kind: ErrorKind::Estimate,
            pressure: unknown,
            settlement: unknown,
            tilt: unknown,
            force: unknown,
            moment: unknown,
        };
        Self { accuracy, edge: unknown }
    }
}

impl Solved {
    /// Nodes of one panel.
    pub(super) fn panel_count(&self) -> usize {
        self.positions.len() / self.panels.len()
    }

    /// Where zones are cut into panels.
    pub(super) fn breaks(&self) -> Vec<f64> {
        let pairs = self.panels.windows(2).filter(|pair| pair[0].zone == pair[1].zone);
        pairs.map(|pair| pair[1].left).collect()
    }

    /// Rounding of the displacement of the layer: of what the body gives, and of `D - beta y - f0`, whose terms are large where small zones lie far from the middle.
    pub(super) fn rounding(&self) -> f64 {
        let [constant, slope] = self.local;
        rounding(&self.solution) + f64::EPSILON * (constant.abs() + slope.abs())
    }

    /// Rounding of the pressure.
    pub(super) fn pressure_rounding(&self) -> f64 {
        self.layer.slope(self.deepest()) * self.rounding()
    }

    /// Rounding of the edges: that of the layer over its mean slope.
    pub(super) fn edge_rounding(&self) -> f64 {
        let longest = self.zones.iter().map(Zone::length).fold(0.0, f64::max);
        let slope = self.deepest() / longest;
        if slope > 0.0 { self.rounding() / slope } else { 0.0 }
    }

    /// Largest displacement of the layer at the nodes, of either sign.
    pub(super) fn deepest(&self) -> f64 {
        self.solution.values().iter().fold(0.0, |most, v| most.max(v.abs()))
    }

    /// Largest `|p0|` at the nodes.
    pub(super) fn largest(&self) -> f64 {
        let pressure = |v: &f64| self.layer.pressure(*v).abs();
        self.solution.values().iter().map(pressure).fold(0.0, f64::max)
    }

    /// What the pressure is not known to, as a share of the largest.
    pub(super) fn noise(&self) -> f64 {
        self.stated.accuracy.pressure / self.largest().max(f64::MIN_POSITIVE)
    }

    /// Displacement of the layer at the left (0) or right (1) end of a zone.
    pub(super) fn end_layer(&self, zone: usize, side: usize) -> f64 {
        self.solution.values()[end_node(&self.panels, self.panel_count(), zone, side)]
    }

    /// Force on a zone, but for a factor.
    pub(super) fn zone_force(&self, zone: usize) -> f64 {
        let count = self.panel_count();
        let masses = self.solution.node_masses().chunks_exact(count);
        (self.panels.iter().zip(masses))
            .filter(|(panel, _)| panel.zone == zone)
            .map(|(_, masses)| masses.iter().sum::<f64>())
            .sum()
    }

    /// `p0(xi)` for `xi` in a zone, with the height of the base there.
    pub(super) fn pressure_at(&self, xi: f64, height: f64) -> f64 {
        self.layer.pressure(self.layer_at(xi, height))
    }

    /// The displacement of the layer for `xi` in a zone, below zero where it pulls.
    pub(super) fn layer(&self, base: &Base<'_>, xi: f64) -> f64 {
        self.layer_at(xi, base.height(xi))
    }

    /// The same with the height of the base there.
    pub(super) fn layer_at(&self, xi: f64, height: f64) -> f64 {
        let place = place(&self.panels, &self.hull, xi);
        let right_hand_side = self.local[0] - self.local[1] * place.position - height;
        self.solution.evaluate_place(place, right_hand_side)
    }

    /// `theta0 k int K(xi, eta) p0 dm` for `xi` outside the zones.
    pub(super) fn displacement_outside(&self, xi: f64) -> f64 {
        let Hull { centre, half } = self.hull;
        let y = (xi - centre) / half;
        let local = self.solution.integral(|t| self.ground.value(y, t));
        let gauge = self.ground.gauge(&self.hull);
        self.solution.parameter() * (local - self.solution.integral(|_| 1.0) * gauge)
    }
}

/// A place in the panels, or the nearest there is.
pub(super) fn place(panels: &[Panel], hull: &Hull, xi: f64) -> Place {
    let Hull { centre, half } = *hull;
    let panel = panels.partition_point(|panel| panel.right < xi).min(panels.len() - 1);
    let Panel { left, right, .. } = panels[panel];
    let xi = xi.clamp(left, right);
    Place {
        position: (xi - centre) / half,
        from_left: ((xi - left) / half).max(0.0),
        from_right: ((right - xi) / half).max(0.0),
        panel,
    }
}

/// Index of the node next to an end of a zone.
pub(super) fn end_node(panels: &[Panel], count: usize, zone: usize, side: usize) -> usize {
    if side == 0 {
        count * panels.partition_point(|panel| panel.zone < zone)
    } else {
        (count * panels.partition_point(|panel| panel.zone <= zone)).saturating_sub(1)
    }
}
