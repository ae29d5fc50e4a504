//! Kinks of the base on a smooth surface, under which the pressure is infinite.

use super::steps::{BESIDE, INSIDE};
use crate::intervals::SLIVER;
use crate::roughness::Law;
use crate::{ContactKind, Problem};

/// Slopes beside a breakpoint are compared at two distances: the share of the jump at the farther that is there at the nearer. Where slopes only bend steeply it vanishes; where there is as much more of it the slope has no bounds (survey).
const KEPT: f64 = 0.9;

/// A jump of the slope of the base inside a zone of smooth contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Kink {
    pub(super) xi: f64,
    /// A place this close is, to rounding, the kink.
    rounding: f64,
    /// The period of a base that repeats without gaps.
    period: Option<f64>,
    /// `+inf` where the base has an edge towards the body, `-inf` where it is hollow: with a jump `J` of `df0/dxi` the pressure goes as
    /// `p0 ~ J/(pi^2 theta0) ln(1/|d|)` at the distance `d`, as the kernel has the symbol `pi/|k|`. 0 where a hollow base lifts off, in a gap that is
    /// narrower than rounding.
    pub(super) pressure: f64,
    /// Whether the slope has no bounds there, and the pressure goes as it does, as a power of the distance.
    pub(super) is_cusp: bool,
}

impl Kink {
    pub(super) fn is_at(&self, xi: f64) -> bool {
        let images = [0.0, -1.0, 1.0].map(|m| m * self.period.unwrap_or(0.0));
        images.into_iter().any(|shift| (self.xi + shift - xi).abs() <= self.rounding)
    }
}

/// The kinks inside zones of a smooth, homogeneous body; none on graded ground, where the pressure is `|d|^mu` more regular, or under a layer.
pub(super) fn kinks(problem: &Problem, zones: &[[f64; 2]]) -> Vec<Kink> {
    let bodies = problem.bodies();
    if bodies.law() != Law::Smooth || bodies.grading().is_some() {
        return Vec::new();
    }
    // `xi` from one end of a base to the other.
    let period = problem.is_wave().then_some(2.0);
    let is_unilateral = problem.solver().contact == ContactKind::Unilateral;
    let kink = |xi: f64| {
        // A zone of a wave may reach over the seam, and full contact has no ends.
        let images = [0.0, -1.0, 1.0].map(|m| xi + m * period.unwrap_or(0.0));
        let [left, right] = zones.iter().find(|[left, right]| {
            // A kink this close to an end of its zone lies on it.
            let margin = SLIVER * (right - left);
            let is_full = period.is_some_and(|period| right - left >= period);
            is_full || images.iter().any(|xi| left + margin < *xi && *xi < right - margin)
        })?;
        let Jump { size, is_cusp } = jump(problem, xi)?;
        let pressure = f64::INFINITY.copysign(size);
        let pressure = if is_unilateral { pressure.max(0.0) } else { pressure };
        // A zone may be narrower than the rounding of a whole half-width.
        let rounding = f64::EPSILON * xi.abs().max(right - left);
        Some(Kink { xi, rounding, period, pressure, is_cusp })
    };
    let places = problem.profile().breakpoints(bodies.half_width());
    places.into_iter().chain(period.map(|_| 1.0)).filter_map(kink).collect()
}

/// A jump of the slope.
pub(super) struct Jump {
    size: f64,
    /// Whether it grows without bounds the nearer the sides are.
    is_cusp: bool,
}

impl Jump {
    /// Whether the base opens away from the body there.
    pub(super) fn is_hollow(&self) -> bool {
        self.size < 0.0
    }
}

/// The jump of the slope, if there is one.
pub(super) fn jump(problem: &Problem, xi: f64) -> Option<Jump> {
    let half_width = problem.bodies().half_width();
    let at = |xi: f64| {
        let beyond_seam = problem.is_wave() && xi > 1.0;
        problem.profile().slope(if beyond_seam { xi - 2.0 } else { xi }, half_width)
    };
    let [far, near] = [BESIDE, INSIDE].map(|offset| Some(at(xi + offset)? - at(xi - offset)?));
    let (far, near) = (far?, near?);
    let is_cusp = near / far > 1.0 / KEPT;
    (near.is_finite() && near != 0.0 && near / far > KEPT).then_some(Jump { size: near, is_cusp })
}
