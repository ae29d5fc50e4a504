//! The displacements of a collocated pressure.

use std::sync::Arc;

use fredholm::SincSolution;
use fredholm::collocation::Place;

use crate::contact::ground::Ground;
use crate::contact::method::MethodName;
use crate::contact::rough::nodes::{Field, Nodes, between_nodes};

/// Growth of the number of nodes from one resolution to the next. At half or twice 4 of 32 answers are lost, 17 of 32 differ beyond what is stated, stated errors grow up to 1e+06 times and time grows by 401 % (survey).
pub(super) const RATIO: f64 = std::f64::consts::SQRT_2;
/// Places on a panel at which resolutions are compared. At half or twice 1 of 32 differ beyond what is stated and stated errors grow up to 2.8 times (survey).
pub(super) const PLACES: usize = 128;

/// A pressure by its values at the nodes.
#[derive(Debug, Clone)]
pub(in crate::contact::rough) struct SincField {
    pub(super) nodes: Arc<Nodes>,
    pub(super) ground: Arc<dyn Ground>,
    /// Its integrals are those of the pressure.
    pub(super) solution: SincSolution,
}

impl SincField {
    /// A place in the panels; none beside them.
    fn place(&self, xi: f64) -> Option<Place> {
        let panels = &self.nodes.panels;
        let panel = panels.partition_point(|[_, right]| *right < xi);
        let [left, right] = *panels.get(panel).filter(|[left, _]| *left <= xi)?;
        let half = self.nodes.frame.hull.half;
        let [from_left, from_right] = [(xi - left) / half, (right - xi) / half];
        Some(Place { position: self.nodes.frame.local(xi), from_left, from_right, panel })
    }
}

impl Field for SincField {
    const NAME: MethodName = MethodName::Sinc;
    /// As [`fredholm::collocation::rounding`].
    const ROUNDING: f64 = 12.0 * f64::EPSILON;
    const RATIO: Option<f64> = Some(RATIO);

    fn at(&self, xi: f64) -> f64 {
        if let Some(place) = self.place(xi) {
            return -self.solution.evaluate_place(place, 0.0);
        }
        let y = self.nodes.frame.local(xi);
        self.solution.parameter() * self.solution.integral(|t| self.ground.value(y, t))
    }

    fn masses(&self) -> Vec<f64> {
        self.solution.node_masses().to_vec()
    }

    fn between() -> Vec<f64> {
        between_nodes(PLACES).collect()
    }
}
