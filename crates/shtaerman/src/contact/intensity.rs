//! Singular corners of smooth contact, and the edge pressure a rough layer makes of them.

use std::f64::consts::FRAC_PI_2;

use super::Contact;
use super::companion::companion;
use super::setting::Setting;
use crate::deadline::work;
use crate::roughness::Law;
use crate::{Geometry, Problem, Scaling};

/// The work that the smooth companion may take, half a second, however many points were measured: it comes beside an answer (survey).
const COMPANION: f64 = 0.125 * work::MOST;
/// From this `theta0` on the corners of the smooth companion say something of edge pressures, and up to so many zones it is worth its solve (survey).
const NEARLY_SMOOTH: f64 = 40.0;
const FEW_ZONES: usize = 4;

impl Contact {
    /// Whether the contact reaches a corner of the base and is so nearly smooth that its [edge pressures](Self::implied_edge_pressures) are those that corners imply.
    #[must_use]
    pub fn is_nearly_smooth(&self) -> bool {
        let zones = self.solution().zones();
        let has_corner = zones.iter().flatten().any(|xi| xi.abs() == 1.0);
        has_corner && zones.len() <= FEW_ZONES && self.theta0() >= NEARLY_SMOOTH
    }

    /// Corner intensities `K = lim sqrt(2 pi d) p` (Pa sqrt(m); without dimensions those over `E sqrt(a)`) of a smooth contact, `d` the distance from the end of a
    /// zone: left and right for each of [`zones`](Self::zones), 0 at free ends. `None` for a rough surface, whose pressure is finite.
    ///
    /// On graded ground `E = E0 y^mu` corners are less sharp: there it is `K = lim sqrt(2 pi) d^beta p` (Pa m^beta) with
    /// [`beta = (1-mu)/2`](crate::Foundation::corner_exponent).
    #[must_use]
    pub fn corner_intensity(&self) -> Option<Vec<[f64; 2]>> {
        let root = self.half_width().powf(self.problem().bodies().corner_exponent());
        let unit = self.scale(Scaling::pressure) * root;
        let zones = self.solution().corner_intensity()?;
        Some(zones.into_iter().map(|zone| zone.map(|k| unit * k)).collect())
    }

    /// Corners, as `xi`, where the pressure of a smooth contact is infinite, with their intensities.
    pub(super) fn singular_corners(&self) -> Vec<(f64, f64)> {
        let intensities = self.corner_intensity().unwrap_or_default();
        let ends =
            self.solution().zones().into_iter().flatten().zip(intensities.into_iter().flatten());
        ends.filter(|(_, k)| *k != 0.0).collect()
    }

    /// Edge pressures (Pa) that the corners of the smooth companion problem (`roughness = 0`, all else alike) imply: `K/sqrt(E* chi)` as `chi -> 0`, left and right
    /// for each of its zones, 0 at free ends.
    ///
    /// Within 1 % of the pressure of a flat punch from `theta0 = 40` under a force, 110 under a moment. `None` unless the layer is linear
    /// and the geometry one strip, a pair or a row on a homogeneous body, and where the companion has no solution (a step in the base of a bilateral contact), or none within half a second.
    #[must_use]
    pub fn implied_edge_pressures(&self) -> Option<Vec<[f64; 2]>> {
        let problem = self.problem();
        let bodies = problem.bodies();
        // A wave has no corners.
        let has_corners = bodies.geometry() != Geometry::Circular && !problem.is_wave();
        let is_plane = has_corners && bodies.is_homogeneous();
        if !is_plane || bodies.law() != Law::Linear || bodies.theta0() == 0.0 {
            return None;
        }
        let intensities = self.corners_without_roughness(|| without_roughness(problem))?;
        // E* chi = 2 a/(pi theta0)
        let unit = self.scale(Scaling::pressure) * (FRAC_PI_2 * bodies.theta0()).sqrt();
        Some(intensities.iter().map(|ends| ends.map(|intensity| unit * intensity)).collect())
    }
}

/// The corner intensities of the smooth companion.
fn without_roughness(problem: &Problem) -> Option<Vec<[f64; 2]>> {
    let companion = companion(problem)?;
    // Within a time of its own.
    let timed = companion.timed_for(COMPANION).unwrap_or(companion);
    let found = Setting::new(&timed).without_layer().ok();
    let smooth = found.filter(|_| !timed.deadline().is_past())?;
    timed.deadline().lift();
    smooth.corner_intensity()
}
