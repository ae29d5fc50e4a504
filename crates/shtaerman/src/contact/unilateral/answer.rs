//! The unilateral answer.

use fredholm::SincSolution;
use fredholm::kernel::{Kernel, WeberSonine};

use super::base::Base;
use super::check::Check;
use super::medium::Medium;
use super::solved::Solved;
use crate::contact::accuracy::Accuracy;
use crate::contact::solved::Stiffness;
use crate::{Error, Problem, Scaling};

/// What the answer leaves of tension and penetration, checked between its nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Complementarity {
    /// Largest tension in the zones over the largest pressure.
    pub tension: f64,
    /// Largest penetration beside the zones over the size of the displacements compared there.
    pub penetration: f64,
}

/// Zones, pressure, settlement, tilt, force and moment of a unilateral contact.
///
/// Quantities with a `0` in their name are without dimensions, the others in the units of the problem.
#[derive(Debug, Clone)]
pub struct UnilateralContact {
    problem: Problem,
    solved: Solved,
    accuracy: Accuracy,
    edge_error: f64,
    complementarity: Complementarity,
    /// The tilt of a circular punch.
    tilted: Option<Tilted>,
}

/// The pressure `p1(r) cos(phi)` of a tilted circular punch.
#[derive(Debug, Clone)]
pub(super) struct Tilted {
    /// For `-alpha0 = 1`.
    pub(super) unit: SincSolution,
    /// `alpha0`.
    pub(super) tilt: f64,
    pub(super) kernel: WeberSonine,
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
    pub(super) fn new(
        base: &Base<'_>,
        solved: Solved,
        accuracy: Accuracy,
        edge_error: f64,
        check: &Check,
        tilted: Option<Tilted>,
    ) -> Result<Self, Error> {
        let complementarity =
            Complementarity { tension: check.tension, penetration: check.penetration };
        let problem = base.problem.clone();
        let contact = Self { problem, solved, accuracy, edge_error, complementarity, tilted };
        for (quantity, value) in [
            ("force", contact.force0() * contact.scale(Scaling::force)),
            ("moment", contact.moment0() * contact.scale(Scaling::moment)),
            ("settlement", contact.settlement0() * contact.scale(Scaling::displacement)),
            ("tilt", contact.tilt0() * contact.scale(Scaling::angle)),
            ("pressure", contact.solved.largest() * contact.scale(Scaling::pressure)),
            ("error of the pressure", contact.accuracy.pressure),
        ] {
            if !value.is_finite() {
                return Err(Error::Overflow { quantity, value });
            }
        }
        Ok(contact)
    }

    /// The problem solved.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// `theta0`.
    #[must_use]
    pub fn theta0(&self) -> f64 {
        self.problem.frame().theta0()
    }

    /// `P0 = P/(a E)`; where it is prescribed, as given.
    #[must_use]
    pub fn force0(&self) -> f64 {
        self.solved.state.force
    }

    /// `M0 = M/(a^2 E)`; where it is prescribed, as given.
    #[must_use]
    pub fn moment0(&self) -> f64 {
        self.solved.state.moment
    }

    /// `delta0 = delta/(chi E)` in the gauge `ln(a/|x-s|)` with the half-width `a` of the punch, also where the zones are smaller.
    #[must_use]
    pub fn settlement0(&self) -> f64 {
        self.solved.state.settlement
    }

    /// `alpha0 = a alpha/(chi E)`.
    #[must_use]
    pub fn tilt0(&self) -> f64 {
        self.solved.state.tilt
    }

    /// The zones of contact from left to right, `[left, right]` in `xi`.
    #[must_use]
    pub fn edges0(&self) -> Vec<[f64; 2]> {
        self.solved.zones.iter().map(|zone| [zone.left(), zone.right()]).collect()
    }

    /// The zones of contact in the units of the problem.
    #[must_use]
    pub fn edges(&self) -> Vec<[f64; 2]> {
        let half_width = self.problem.frame().half_width();
        self.edges0().into_iter().map(|zone| zone.map(|xi| xi * half_width)).collect()
    }

    /// Where a point of the base lies in the coordinates of the solution: on a disk the distance from the axis, on a wave without gaps the image between the ends of the
    /// zones. Points beyond the punch count as the nearer edge.
    fn locate(&self, xi: f64) -> f64 {
        match self.solved.medium {
            Medium::Disk { .. } => xi.abs().min(1.0),
            Medium::Row { .. } if self.solved.medium.is_closed() => {
                let origin = self.solved.hull.centre;
                xi + 2.0 * (0.5 * (origin - xi)).round()
            }
            Medium::Row { .. } | Medium::Line => xi.clamp(-1.0, 1.0),
        }
    }

    /// `f0` at a place in the coordinates of the solution.
    fn height(&self, xi: f64) -> f64 {
        let is_image = self.solved.medium.is_closed() && xi.abs() > 1.0;
        let xi = if is_image { xi - 2.0 * (0.5 * xi).round() } else { xi };
        self.problem.dimensionless_profile(xi)
    }

    /// `p0(xi)` on the base, 0 outside the zones and at their free edges; points beyond the punch count as the nearer edge, those of a wave without gaps as their images,
    /// NaN stays. On a disk along the diameter of the tilt.
    #[must_use]
    pub fn pressure0(&self, xi: f64) -> f64 {
        let turned = self.tilted.as_ref().map_or(0.0, |tilted| {
            tilted.pressure(xi.abs().min(1.0)) * if xi < 0.0 { -1.0 } else { 1.0 }
        });
        let xi = self.locate(xi);
        let inside = |left: f64, right: f64| left <= xi && xi <= right;
        let Some(zone) = self.solved.zones.iter().find(|zone| inside(zone.left(), zone.right()))
        else {
            return if xi.is_nan() { xi } else { 0.0 };
        };
        if zone.ends.iter().any(|end| end.is_free && end.at == xi) {
            return 0.0;
        }
        // At a step of the base the height is that under pressure.
        let inside = 1e-12 * zone.length();
        let at_step = |side: usize| zone.ends[side].at == xi && xi.abs() < 1.0 && xi != 0.0;
        let shift = if at_step(0) {
            inside
        } else if at_step(1) {
            -inside
        } else {
            0.0
        };
        self.solved.pressure_at(xi, self.height(xi + shift)) + turned
    }

    /// `p(x)` in the units of the problem.
    ///
    /// # Errors
    /// [`Error::BeyondPunch`] outside the closed base, also for NaN.
    pub fn pressure(&self, x: f64) -> Result<f64, Error> {
        let half_width = self.problem.frame().half_width();
        if x.abs() <= half_width {
            return Ok(self.pressure0(x / half_width) * self.scale(Scaling::pressure));
        }
        let variable = self.problem.frame().coordinate();
        Err(Error::BeyondPunch { variable, at: x, left: -half_width, right: half_width })
    }

    /// `theta0 int ln(1/|xi - eta|) p0(eta) deta`, the elastic displacement without the layer, at any `xi`.
    #[must_use]
    pub fn elastic_displacement0(&self, xi: f64) -> f64 {
        let sign = if xi < 0.0 { -1.0 } else { 1.0 };
        let turned =
            self.tilted.as_ref().map_or(0.0, |tilted| sign * tilted.displacement(xi.abs()));
        // Beyond the punch the place counts as it is.
        let place = match self.solved.medium {
            Medium::Disk { .. } => xi.abs(),
            Medium::Row { .. } if self.solved.medium.is_closed() => self.locate(xi),
            Medium::Row { .. } | Medium::Line => xi,
        };
        let touches = |left: f64, right: f64| left <= place && place <= right;
        if self.solved.zones.iter().any(|zone| touches(zone.left(), zone.right())) {
            // Of the equation itself: the layer without the profile, with the sign turned.
            let tilt = if self.solved.medium.is_disk() { 0.0 } else { self.tilt0() };
            let depth = self.settlement0() - tilt * place;
            return depth - self.solved.layer_at(place, 0.0) + turned;
        }
        self.solved.displacement_outside(place) + turned
    }

    /// The gap `f0 + alpha0 xi - delta0 + theta0 int ln(1/|xi - eta|) p0(eta) deta` between base and body outside the zones; 0 in them.
    /// Points beyond the punch count as the nearer edge.
    #[must_use]
    pub fn gap0(&self, xi: f64) -> f64 {
        let xi = self.locate(xi);
        let touches = |left: f64, right: f64| left <= xi && xi <= right;
        if self.solved.zones.iter().any(|zone| touches(zone.left(), zone.right())) {
            return 0.0;
        }
        let depth = self.settlement0() - self.tilt0() * xi - self.height(xi);
        self.solved.displacement_outside(xi) - depth
    }

    /// The tangent stiffness without dimensions. Edges that move add nothing of first order, as the pressure vanishes there.
    #[must_use]
    pub fn stiffness0(&self) -> Stiffness {
        self.solved.stiffness
    }

    /// What is left of tension and penetration.
    #[must_use]
    pub fn complementarity(&self) -> Complementarity {
        self.complementarity
    }

    /// The estimated error, without dimensions.
    #[must_use]
    pub fn accuracy(&self) -> &Accuracy {
        &self.accuracy
    }

    /// The estimated error of the edges, in `xi`.
    #[must_use]
    pub fn edge_error0(&self) -> f64 {
        self.edge_error
    }

    /// Number of nodes in all zones.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.solved.positions.len()
    }

    /// The largest estimated error relative to its size.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        self.accuracy.relative(&self.solved.state.sizes(self.solved.largest()))
    }

    fn scale(&self, unit: impl Fn(&Scaling) -> f64) -> f64 {
        self.problem.frame().scaling().map_or(1.0, unit)
    }
}
