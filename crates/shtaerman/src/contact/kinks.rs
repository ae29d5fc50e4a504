//! Kinks of the base on a smooth surface, under which the pressure is infinite.

use super::Contact;
use crate::Problem;
use crate::roughness::Law;

/// Offsets at which slopes beside a breakpoint are compared, and the share of the jump at the farther that is there at the nearer: where slopes only bend steeply it vanishes.
const BESIDE: [f64; 2] = [1e-8, 1e-12];
const KEPT: f64 = 0.9;

/// A kink this close to an end of its zone, as a share of the zone, lies on it.
const AT_END: f64 = 1e-8;
/// A peak this close to a kink lies on it.
const AT_KINK: f64 = 1e-5;

/// A jump of the slope of the base inside a zone of smooth contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Kink {
    pub(super) xi: f64,
    /// A place this close is, to rounding, the kink.
    pub(super) rounding: f64,
    /// `+inf` where the base has an edge towards the body, `-inf` where it is hollow: with a jump `J` of `df0/dxi` the pressure goes as
    /// `p0 ~ J/(pi^2 theta0) ln(1/|d|)` at the distance `d`, as the kernel has the symbol `pi/|k|`.
    pub(super) pressure: f64,
}

/// The kinks inside zones of a smooth, homogeneous body; none on graded ground, where the pressure is `|d|^mu` more regular, or under a layer.
pub(super) fn kinks(problem: &Problem, zones: &[[f64; 2]]) -> Vec<Kink> {
    let frame = problem.frame();
    if frame.law() != Law::Smooth || frame.grading().is_some() {
        return Vec::new();
    }
    let half_width = frame.half_width();
    let kink = |xi: f64| {
        let [left, right] = zones.iter().find(|[left, right]| {
            let margin = AT_END * (right - left);
            left + margin < xi && xi < right - margin
        })?;
        let pressure = f64::INFINITY.copysign(jump(problem, xi)?);
        // A zone may be narrower than the rounding of a whole half-width.
        let rounding = f64::EPSILON * xi.abs().max(right - left);
        Some(Kink { xi, rounding, pressure })
    };
    problem.profile().breakpoints(half_width).into_iter().filter_map(kink).collect()
}

/// The jump of the slope, if there is one.
fn jump(problem: &Problem, xi: f64) -> Option<f64> {
    let half_width = problem.frame().half_width();
    let at = |xi: f64| problem.profile().slope(xi, half_width);
    let [far, near] = BESIDE.map(|offset| Some(at(xi + offset)? - at(xi - offset)?));
    let (far, near) = (far?, near?);
    (near.is_finite() && near != 0.0 && near / far > KEPT).then_some(near)
}

impl Contact {
    /// Whether the largest pressure is finite, and not the tip of a cusp under a kink of the base (on smooth graded ground), which has too few digits for rates.
    pub(crate) fn has_smooth_peak(&self) -> bool {
        let (value, peak) = self.peak_pressure0();
        let (profile, frame) = (self.problem().profile(), self.problem().frame());
        let breaks = || profile.breakpoints(frame.half_width()).into_iter();
        let is_kink = |at: f64| (at - peak).abs() < AT_KINK && jump(self.problem(), at).is_some();
        let is_cusp = frame.law() == Law::Smooth && breaks().any(is_kink);
        value.is_finite() && !is_cusp
    }

    /// The pressure at `xi` if that is, to rounding, a kink where it is infinite.
    pub(super) fn singular_pressure(&self, xi: f64) -> Option<f64> {
        self.kinks()
            .iter()
            .find(|kink| (kink.xi - xi).abs() <= kink.rounding)
            .map(|kink| kink.pressure)
    }
}
