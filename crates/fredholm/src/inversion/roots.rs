//! Slopes that go as a power of the distance from a place, which is a jump if the power is zero.

use std::f64::consts::{PI, TAU};

use super::accuracy::ROUNDING;
use super::angular::Angular;
use super::panels::Panel;
use super::rule::integral;

/// The nearest offset at which both sides of a place are compared, in roundings of the angle, and how much farther each next one is. At half or twice stated errors grow up to 2 times (survey).
pub(super) const NEAREST: f64 = 1e4;
const FARTHER: f64 = 30.0;
/// Powers from here on are resolved by panels. Half and twice change nothing in the one answer that asks for it (survey).
const SMOOTH: f64 = 0.999;

/// A profile near a place.
pub(super) struct Local<'p> {
    pub(super) profile: &'p dyn Angular,
    pub(super) is_odd: bool,
}

impl Local<'_> {
    /// `g(at + offset) - g(at - offset)`.
    fn jump(&self, at: f64, offset: f64) -> Option<f64> {
        let after = at + offset;
        let after = if !self.is_odd && after > PI { after - TAU } else { after };
        Some(self.profile.slope(after)? - self.profile.slope(at - offset)?)
    }

    fn nearest(&self) -> f64 {
        NEAREST * self.profile.blur()
    }

    /// The jump at the nearest offset and the power of the offset that it goes with; none where slopes are not known, or do not differ.
    pub(super) fn power(&self, at: f64) -> Option<(f64, f64)> {
        let [power, _] = self.powers(at)?;
        Some((self.jump(at, self.nearest())?, power))
    }

    /// The power by the nearest two offsets and by the next two.
    fn powers(&self, at: f64) -> Option<[f64; 2]> {
        let nearest = self.nearest();
        let [near, middle, far] = [1.0, FARTHER, FARTHER * FARTHER]
            .map(|times| self.jump(at, times * nearest).filter(|jump| *jump != 0.0));
        let (near, middle, far) = (near?, middle?, far?);
        let powers = [middle / near, far / middle].map(|ratio| ratio.ln() / FARTHER.ln());
        powers.iter().all(|power| power.is_finite()).then_some(powers)
    }
}

/// A place where `g` goes as a power below one of the distance.
#[derive(Debug, Clone, Copy)]
pub(super) struct Root {
    pub(super) at: f64,
    /// The shortest panel beside it.
    pub(super) reach: f64,
    /// `F` there, and its error.
    pub(super) conjugate: f64,
    pub(super) error: f64,
}

impl Root {
    /// That of a place where panels meet; none where they resolve the slope, or where it does not differ by more than a threshold at their ends.
    pub(super) fn of(panels: &[Panel], local: &Local<'_>, at: f64, threshold: f64) -> Option<Self> {
        let (jump, _) = local.power(at)?;
        let [power, other] = local.powers(at)?;
        let before = panels.iter().find(|panel| panel.end == at)?;
        let after = panels.iter().find(|panel| panel.start == at)?;
        let blur = local.profile.blur();
        let is_resolved = !before.is_blurred(blur) && !after.is_blurred(blur);
        let reach = 2.0 * before.half().min(after.half());
        // g(at + t) - g(at - t) = J (t/reach)^power
        let jump = jump * (reach / local.nearest()).powf(power);
        if is_resolved || !(0.0..SMOOTH).contains(&power) || jump.abs() <= threshold {
            return None;
        }
        let mut sum = 2.0 * jump / power;
        for panel in panels {
            let is_beside = panel.end == at || panel.start == at;
            if is_beside {
                let rest = [[panel.start, at - reach], [at + reach, panel.end]];
                let rest = rest.into_iter().filter(|[from, to]| from < to);
                let pole = |angle: f64| panel.at(angle) / (0.5 * (angle - at)).tan();
                sum += rest.map(|[from, to]| integral(from, to, pole)).sum::<f64>();
            } else {
                sum += panel.cotangent(at);
            }
            if local.is_odd {
                sum += panel.cotangent(-at);
            }
        }
        // The sides at the nearest offset are rounded by that share of it.
        let rounding = ROUNDING / (f64::EPSILON * NEAREST);
        let error = jump.abs() / PI * ((1.0 / power - 1.0 / other).abs() + rounding);
        Some(Self { at, reach, conjugate: -sum / TAU, error })
    }
}
