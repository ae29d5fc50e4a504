//! What the differences between three resolutions tell of the error of the finest.
//!
//! A rate of convergence may be assumed only where the profile is proved to be smooth between the places where it is cut: two differences that are alike by chance are no rate, and
//! under a kink in hiding single numbers agree by chance, too, while the pressure between the nodes does not.

use fredholm::collocation::extrapolate;

use super::parts::Smoothness;

/// Differences that fall by less have not begun to, and what is stated over them.
const SLOW: f64 = 0.25;
const SAFETY: f64 = 4.0;
/// Where nothing is known of the profile between samples no smaller share is stated: two resolutions may both miss what it hides.
pub(super) const UNKNOWN: f64 = 1e-3;
/// Roundings of the pressure that a difference may have by rounding alone.
const ROUNDINGS: f64 = 4.0;

/// How far differences may be trusted.
#[derive(Debug, Clone, Copy)]
pub(super) struct Trust {
    /// What is known of the profile between the places where it is cut.
    smoothness: Smoothness,
    /// Growth of the number of nodes.
    ratio: f64,
    /// The error of the pressure, where single numbers are not to be stated far below it.
    floor: Option<f64>,
}

impl Trust {
    /// From two differences of the pressure between all nodes, and its rounding.
    pub(super) fn new(
        smoothness: Smoothness,
        ratio: f64,
        [before, change]: [f64; 2],
        rounding: f64,
        scale: f64,
    ) -> Self {
        let trust = Self { smoothness, ratio, floor: None };
        let is_slow = change > SLOW * before && change > ROUNDINGS * rounding;
        let is_proved = smoothness == Smoothness::Proved;
        let floor = (!is_proved || is_slow).then(|| trust.left([before, change], scale));
        Self { floor, ..trust }
    }

    /// What is left of a quantity of this size after two differences.
    pub(super) fn left(&self, [before, change]: [f64; 2], scale: f64) -> f64 {
        let plain = if change <= SLOW * before { change } else { SAFETY * before.max(change) };
        match self.smoothness {
            Smoothness::Proved => extrapolate(before, change, scale, self.ratio),
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
        let unknown = Trust::new(Smoothness::Unknown, 1.4, [1e-6, 1e-12], 1e-15, 2.0);
        assert_eq!(unknown.left([1e-6, 1e-12], 2.0), 2.0 * UNKNOWN);
    }
}
