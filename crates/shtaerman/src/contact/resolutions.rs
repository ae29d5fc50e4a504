//! What the differences between three resolutions tell of the error of the finest.
//!
//! A rate of convergence may be assumed only where the profile is proved to be smooth between the places where it is cut: two differences that are alike by chance are no rate, and
//! under a kink in hiding single numbers agree by chance, too, while the pressure between the nodes does not.

use fredholm::collocation::extrapolate;

use super::accuracy::{Accuracy, ErrorKind, ROUNDING, SAFETY, Sizes};
use super::balance::State;
use super::parts::Smoothness;
use super::zones::Zone;
use crate::Load;
use crate::solver::AIM;

/// Differences that fall by less have not begun to (survey).
pub(super) const SLOW: f64 = 0.25;
/// Where nothing is known of the profile between samples no smaller share is stated: two resolutions may both miss what it hides.
pub(super) const UNKNOWN: f64 = 1e-3;

/// Differences between two resolutions of a contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Change {
    pub(super) pressure: f64,
    pub(super) settlement: f64,
    pub(super) tilt: f64,
    pub(super) force: f64,
    pub(super) moment: f64,
    pub(super) edge: f64,
}

impl Change {
    /// Given that of the pressure.
    pub(super) fn between([one, other]: [(&State, &[Zone]); 2], pressure: f64) -> Self {
        let ends = one.1.iter().zip(other.1);
        let edge = ends
            .flat_map(|(one, two)| (0..2).map(move |side| (one.ends[side] - two.ends[side]).abs()))
            .fold(if one.1.len() == other.1.len() { 0.0 } else { 2.0 }, f64::max);
        let difference = |of: fn(&State) -> f64| (of(one.0) - of(other.0)).abs();
        Self {
            pressure,
            settlement: difference(|state| state.settlement),
            tilt: difference(|state| state.tilt),
            force: difference(|state| state.force),
            moment: difference(|state| state.moment),
            edge,
        }
    }
}

/// What collocation leaves on the finest of three numbers of nodes, which grow by a ratio, after two differences of a quantity of this size. Beside ends and kinks its error is `exp(-c sqrt(n))`
/// (F. Stenger, *Numerical Methods Based on Sinc and Analytic Functions*, Springer 1993): its logarithm grows by the root of the ratio. For once a difference may have fallen faster: what nodes
/// miss beside a kink changes its sign (survey: of 1770 errors of random contacts the largest was 0.6 of this but for one of rounding, and 20
/// times what the two differences alone tell).
pub(super) fn left_by_collocation([before, change]: [f64; 2], scale: f64, ratio: f64) -> f64 {
    let exponential = SAFETY * scale * (change / scale).powf(ratio.sqrt());
    let left = extrapolate(before, change, scale, ratio).max(exponential.min(change));
    // Small fast waves of the profile look alike on nodes that do not resolve them: until all are small the last difference is stated.
    if left <= AIM * scale { left } else { left.max(change) }
}

/// How far differences may be trusted.
#[derive(Debug, Clone, Copy)]
pub(super) struct Trust {
    /// What is known of the profile between the places where it is cut.
    smoothness: Smoothness,
    /// Growth of the number of nodes.
    ratio: f64,
    /// Whether each resolution is far coarser than the next, so that none agree by chance.
    is_far: bool,
    /// The error of the pressure, where single numbers are not to be stated far below it.
    floor: Option<f64>,
}

impl Trust {
    /// In differences whose rate is not known.
    pub(super) fn plain(is_far: bool) -> Self {
        Self { smoothness: Smoothness::Bent, ratio: 1.0, is_far, floor: None }
    }

    /// The error of the finest of three resolutions, and that of its edges, but for the rounding of the pressure: none for what the load prescribes. `length` is that of the zones.
    pub(super) fn accuracy(
        &self,
        load: Load,
        [before, change]: [&Change; 2],
        sizes: &Sizes,
        length: f64,
    ) -> (Accuracy, f64) {
        let pressure = self.left([before.pressure, change.pressure], sizes.pressure);
        // Sums over the pressure are off by the square of what it is off by, whatever their differences happen to be.
        let least = (pressure / sizes.pressure.max(f64::MIN_POSITIVE)).powi(2).clamp(ROUNDING, 1.0);
        let of = |part: fn(&Change) -> f64, scale: f64, share: f64| {
            self.left_of_one([part(before), part(change)], scale, share).max(least * scale)
        };
        // Of those that belong together one may agree by chance, and the others be given.
        let displaced = of(|change| change.settlement.max(change.tilt), sizes.displacement, 1.0);
        let carried = of(|change| change.force.max(change.moment), sizes.force, length);
        let share = (displaced / sizes.displacement).max(carried / sizes.force);
        let displaced = displaced.max(share * sizes.displacement);
        let carried = carried.max(share * sizes.force);
        let accuracy = Accuracy {
            kind: ErrorKind::Estimate,
            pressure,
            settlement: displaced,
            tilt: displaced,
            force: carried,
            moment: carried,
        };
        let edge = of(|change| change.edge, 1.0, length / sizes.pressure.max(f64::MIN_POSITIVE));
        (accuracy.under(&load), edge)
    }

    /// From two differences of the pressure between all nodes, and its rounding.
    pub(super) fn new(
        smoothness: Smoothness,
        ratio: f64,
        [before, change]: [f64; 2],
        rounding: f64,
        scale: f64,
    ) -> Self {
        let trust = Self { smoothness, ratio, is_far: false, floor: None };
        // A difference may be rounding alone.
        let is_slow = change > SLOW * before && change > SAFETY * rounding;
        let is_proved = smoothness == Smoothness::Proved;
        let floor = (!is_proved || is_slow).then(|| trust.left([before, change], scale));
        Self { floor, ..trust }
    }

    /// What is left of a quantity of this size after two differences.
    pub(super) fn left(&self, [before, change]: [f64; 2], scale: f64) -> f64 {
        let plain = if change > SLOW * before {
            SAFETY * before.max(change)
        } else if self.is_far {
            change
        } else {
            // One difference may vanish by chance. Where the error falls by a constant share, or ever faster, the mean of two is more than is left.
            (before * change).sqrt()
        };
        match self.smoothness {
            Smoothness::Proved => left_by_collocation([before, change], scale, self.ratio),
            Smoothness::Bent => plain,
            Smoothness::Unknown => plain.max(UNKNOWN * scale),
        }
    }

    /// The same of a single number, which moves by `share` times an error of the pressure.
    pub(super) fn left_of_one(&self, differences: [f64; 2], scale: f64, share: f64) -> f64 {
        self.left(differences, scale).max(self.floor.map_or(0.0, |floor| share * floor))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_agree_by_chance_have_the_error_of_the_pressure() {
        let hidden = Trust::new(Smoothness::Bent, 1.4, [3e-4, 2e-4], 1e-15, 1.0);
        assert_eq!(hidden.left_of_one([1e-9, 1e-10], 1.0, 1.0), SAFETY * 3e-4);
        let slow = Trust::new(Smoothness::Proved, 1.4, [3e-4, 2e-4], 1e-15, 1.0);
        assert!(slow.left_of_one([1e-9, 0.0], 1.0, 1.0) > 3e-4);
        // Of what converges as it is proved to the last difference is more than is left.
        let fast = Trust::new(Smoothness::Proved, 1.4, [1e-6, 1e-10], 1e-15, 1.0);
        let left = fast.left_of_one([1e-7, 1e-11], 1.0, 1.0);
        assert!(left > 0.0 && left < 1e-11, "{left:e}");
        // The differences of the pressure on a pair of punches with 26 waves: the rate of the first two does not go on.
        let differences = [1.7e-4, 2.5e-6, 3.9e-7, 2.5e-10, 1e-14];
        for known in differences.windows(3) {
            let [before, change] = [known[0], known[1]];
            let uneven = Trust::new(Smoothness::Proved, 2f64.sqrt(), [before, change], 1e-15, 1.0);
            assert!(uneven.left([before, change], 1.0) >= known[2], "{change:e}");
        }
        // A measured profile under a layer: the third difference is small by chance.
        let differences = [1.13e-10, 4.94e-11, 1.98e-12, 3.37e-12, 8.1e-13];
        let bent = Trust { smoothness: Smoothness::Bent, ratio: 1.4, is_far: false, floor: None };
        for known in 0..3 {
            let after: f64 = differences[known + 2..].iter().sum();
            assert!(bent.left([differences[known], differences[known + 1]], 1.0) > after);
        }
        let unknown = Trust::new(Smoothness::Unknown, 1.4, [1e-6, 1e-12], 1e-15, 2.0);
        assert_eq!(unknown.left([1e-6, 1e-12], 2.0), 2.0 * UNKNOWN);
    }
}
