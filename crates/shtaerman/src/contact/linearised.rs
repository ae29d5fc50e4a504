//! The first-order change of a contact, with the place of its largest pressure, and whether that is one.

use super::accuracy::{ROUNDING, SAFETY};
use super::edges::CLOSE;
use super::kinks::jump;
use super::rates::Linearised;
use crate::Contact;
use crate::extremes::Sampled;
use crate::roughness::Law;

/// Step of the differences that show where the pressure is largest, as a share of its zone; a correction by more than one is no smooth peak's (survey).
const STEP: f64 = 5e-4;
/// Steps that the formula of five points and a correction by one reach to either side.
const REACH: f64 = 3.0;
/// The share of a rate at the largest pressure that neither differences of resolutions nor its place show: beside walls it was up to 2.5e-11 (survey).
const MISSED: f64 = 1e-10;

impl Contact {
    /// Where the pressure is largest: a maximum shows its place to the root of rounding only, its slope all of it. With the step of the differences that showed it, 0 where it is known as a
    /// number, and how many of these it may be off by.
    fn peak_place(&self) -> [f64; 3] {
        let (_, start) = self.peak();
        let exact = [start, 0.0, 0.0];
        // Zones of a wave may lie beyond the period about the origin.
        let periods = if self.problem().is_wave() { 1.0 } else { 0.0 };
        let image = |[left, right]: [f64; 2]| {
            let shift = 2.0 * periods * (0.5 * (left.midpoint(right) - start)).round();
            [left - shift, right - shift]
        };
        let mut zones = self.solution().zones().into_iter().map(image);
        let zone = zones.find(|[left, right]| *left < start && start < *right);
        let Some([left, right]) = zone else { return exact };
        let half_width = self.problem().bodies().half_width();
        let breaks = self.problem().profile().breakpoints(half_width);
        let bends = breaks.into_iter().chain([left, right]);
        let nearest = bends.fold(f64::INFINITY, |least, at| least.min((at - start).abs()));
        if nearest <= ROUNDING {
            return exact;
        }
        let step = (STEP * (right - left)).min(nearest / REACH);
        // Without a bend that differences show its place is known to the root of rounding.
        let rounded = [start, f64::EPSILON.sqrt() * (right - left), SAFETY];
        // Newton's step to the root of the slope, and the pressure over its bend.
        let shift = |place: f64, step: f64| {
            let [a, b, c, d, e] =
                [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| self.pressure_at(place + k * step));
            let slope = (8.0 * (d - b) - (e - a)) / 12.0;
            let bend = (16.0 * (d + b) - (e + a) - 30.0 * c) / 12.0;
            let is_peak = bend < 0.0 && slope.abs() <= -bend;
            is_peak.then_some((-slope / bend, c / bend))
        };
        let Some((first, _)) = shift(start, step) else { return rounded };
        // What half the step changes, the formula with the whole step missed; its own error is a sixteenth.
        let (place, step) = (start + first * step, 0.5 * step);
        let Some((second, size)) = shift(place, step) else { return rounded };
        // The error of a pressure varies over a tenth of its zone.
        let slope = 10.0 * step / (right - left) * self.known_to() + 2.0 * f64::EPSILON;
        [place + second * step, step, second.abs() + slope * size.abs()]
    }

    /// Where the pressure may be largest as well, as far as it is known.
    fn rivals(&self) -> Vec<f64> {
        let (peak, at) = self.peak();
        let known = [self.solution().accuracy(), self.accuracy()].into_iter().flatten();
        let off = 2.0 * known.map(|known| known.pressure).fold(0.0, f64::max);
        let (places, pressures) = self.solution().sample();
        Sampled::new(|xi| self.pressure_at(xi), places, pressures).elsewhere(at, peak - off)
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
        let [place, step, off] = self.peak_place();
        let at = |place| self.solution().linearised(self.solved().dimensionless_load(), place);
        let mut found = at(place)?;
        if step > 0.0 {
            let beside = at(place + step)?;
            for k in 0..found.rates.len() {
                let [here, there] = [&found, &beside].map(|at| at.rates[k][3]);
                found.errors[k][3] += MISSED * here.abs() + off * (there - here).abs();
            }
        }
        // A coarse answer may take one crest for the highest where it is another.
        for rival in self.rivals() {
            let beside = at(rival)?;
            for k in 0..found.rates.len() {
                let [here, there] = [&found, &beside].map(|at| at.rates[k][3]);
                let there = (there - here).abs() + beside.errors[k][3];
                found.errors[k][3] = found.errors[k][3].max(there);
            }
        }
        if self.is_level() {
            for rates in found.rates.iter_mut().chain(&mut found.errors) {
                rates[2] = 0.0;
            }
        }
        found.is_finite().then_some(found)
    }

    /// Whether the largest pressure is finite, and not the tip of a cusp under a kink of the base (on smooth graded ground), which has too few digits for rates.
    pub(crate) fn has_smooth_peak(&self) -> bool {
        let (value, peak) = self.peak();
        let (profile, bodies) = (self.problem().profile(), self.problem().bodies());
        let is_kink = |at: &f64| (at - peak).abs() < CLOSE && jump(self.problem(), *at).is_some();
        let is_cusp = || profile.breakpoints(bodies.half_width()).iter().any(is_kink);
        value.is_finite() && (bodies.law() != Law::Smooth || !is_cusp())
    }

    /// The pressure at `xi` if that is, to rounding, a kink where it is infinite.
    pub(super) fn singular_pressure(&self, xi: f64) -> Option<f64> {
        self.kinks().iter().find(|kink| kink.is_at(xi)).map(|kink| kink.pressure)
    }
}
