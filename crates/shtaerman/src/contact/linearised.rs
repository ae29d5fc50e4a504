//! The first-order change of a contact, with the place of its largest pressure, and whether that is one.

use super::edges::CLOSE;
use super::kinks::jump;
use super::rates::Linearised;
use crate::Contact;
use crate::roughness::Law;

/// Step of the differences that show where the pressure is largest, as a share of its zone; a correction by more than one is no smooth peak's (survey).
const STEP: f64 = 5e-4;
/// Steps that the formula of five points and a correction by one reach to either side.
const REACH: f64 = 3.0;
/// The error of a pressure varies over this share of a zone.
const VARIES: f64 = 0.1;

/// Where the pressure is largest.
struct Peak {
    place: f64,
    /// A step of the differences that showed it, and how many of these the place may be off by.
    step: f64,
    off: f64,
}

impl Contact {
    /// Where the pressure is largest: a maximum shows its place to the root of rounding only, its slope all of it.
    fn peak_place(&self) -> Peak {
        let (_, start) = self.peak();
        let exact = Peak { place: start, step: 0.0, off: 0.0 };
        // Zones of a wave may lie beyond the period about the origin.
        let images: &[f64] = if self.problem().is_wave() { &[0.0, -2.0, 2.0] } else { &[0.0] };
        let zones = self.solution().zones();
        let zone = zones.iter().find_map(|[left, right]| {
            let image = images.iter().find(|image| (*left..*right).contains(&(start + *image)))?;
            Some([left - image, right - image])
        });
        let Some([left, right]) = zone else { return exact };
        let step = STEP * (right - left);
        let half_width = self.problem().frame().half_width();
        let is_near = |at: f64| (at - start).abs() < REACH * step;
        let breaks = self.problem().profile().breakpoints(half_width);
        if is_near(left) || is_near(right) || breaks.into_iter().any(is_near) {
            return exact;
        }
        // Newton's step to the root of the slope, and the pressure over its bend.
        let shift = |place: f64| {
            let [a, b, c, d, e] =
                [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| self.pressure_at(place + k * step));
            let slope = (8.0 * (d - b) - (e - a)) / 12.0;
            let bend = (16.0 * (d + b) - (e + a) - 30.0 * c) / 12.0;
            let is_peak = bend < 0.0 && slope.abs() <= -bend;
            is_peak.then_some((-slope / bend, c / bend))
        };
        let Some((first, _)) = shift(start) else { return exact };
        let place = start + first * step;
        let Some((second, size)) = shift(place) else { return exact };
        let slope = STEP / VARIES * self.known_to() + 2.0 * f64::EPSILON;
        Peak { place, step, off: second.abs() + slope * size.abs() }
    }

    /// The error of the solution relative to its size; 0 where the method tells none.
    pub(crate) fn known_to(&self) -> f64 {
        let (peak, _) = self.peak();
        let solution = self.solution();
        let solved = match solution.accuracy() {
            Some(accuracy) if peak.is_finite() => {
                accuracy.relative(&solution.state().sizes(peak.abs()))
            }
            Some(_) => solution.relative_error(),
            None => 0.0,
        };
        solved.max(self.of_heights())
    }

    /// The first-order change, where the method has one.
    pub(crate) fn linearised(&self) -> Option<Linearised> {
        let Peak { place, step, off } = self.peak_place();
        let load = self.solved().dimensionless_load();
        let mut found = self.solution().linearised(load, place)?;
        if off > 0.0 {
            let beside = self.solution().linearised(load, place + step)?;
            for (k, errors) in found.errors.iter_mut().enumerate() {
                errors[3] += off * (beside.rates[k][3] - found.rates[k][3]).abs();
            }
        }
        if self.is_level() {
            for rates in found.rates.iter_mut().chain(&mut found.errors) {
                rates[2] = 0.0;
            }
        }
        found.is_finite().then_some(found)
    }
}

impl Contact {
    /// Whether the largest pressure is finite, and not the tip of a cusp under a kink of the base (on smooth graded ground), which has too few digits for rates.
    pub(crate) fn has_smooth_peak(&self) -> bool {
        let (value, peak) = self.peak();
        let (profile, frame) = (self.problem().profile(), self.problem().frame());
        let breaks = || profile.breakpoints(frame.half_width()).into_iter();
        let is_kink = |at: f64| (at - peak).abs() < CLOSE && jump(self.problem(), at).is_some();
        let is_cusp = frame.law() == Law::Smooth && breaks().any(is_kink);
        value.is_finite() && !is_cusp
    }

    /// The pressure at `xi` if that is, to rounding, a kink where it is infinite.
    pub(super) fn singular_pressure(&self, xi: f64) -> Option<f64> {
        self.kinks().iter().find(|kink| kink.is_at(xi)).map(|kink| kink.pressure)
    }
}
