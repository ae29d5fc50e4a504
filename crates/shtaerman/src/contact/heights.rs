//! Heights of the base: counted from its level, and known to their rounding only.

use super::accuracy::{Accuracy, Sizes};
use super::solution::Solution;
use crate::roughness::Law;
use crate::{Error, Problem, Scaling};

/// Places in all zones at which the rounding of heights is looked at, at least one in each, and where in its step each lies: an irrational share keeps clear of jumps.
const PLACES: usize = 128;
const ASIDE: f64 = 0.381_966;
/// Of a disturbance of the heights on its way to the tilt, in half-widths of the contact.
const TURN: f64 = 2.0;
/// Rounding of the level that is added to the settlement.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Errors that the rounding of heights makes, and the sizes against which they are held.
#[derive(Debug, Clone, Copy)]
pub(super) struct OfHeights {
    accuracy: Accuracy,
    sizes: Sizes,
}

impl Problem {
    /// The largest rounding of the dimensionless heights in the zones of contact, and the largest of these.
    fn height_rounding(&self, zones: &[[f64; 2]]) -> [f64; 2] {
        let steps = (PLACES / zones.len().max(1)).max(1);
        let (profile, half_width) = (self.profile(), self.frame().half_width());
        let [mut rounding, mut largest] = [0.0f64; 2];
        for [left, right] in zones {
            for i in 0..steps {
                let xi = left + (right - left) * (i as f64 + ASIDE) / steps as f64;
                let xi = xi.clamp(-1.0, 1.0);
                largest = largest.max(profile.height(xi, half_width).abs());
                let here = profile.rounding(xi, half_width);
                if here.is_finite() {
                    rounding = rounding.max(here);
                }
            }
        }
        let scale = self.frame().scaling().map_or(1.0, Scaling::displacement);
        [rounding / scale, largest / scale]
    }

    /// What the rounding of heights makes of a solution; none where the method tells no error.
    pub(super) fn of_heights(&self, solution: &dyn Solution) -> Option<OfHeights> {
        let known = *solution.accuracy()?;
        let zones = solution.zones();
        let (left, right) = (zones.first()?[0], zones.last()?[1]);
        let [rounding, height] = self.height_rounding(&zones);
        let (half, middle) = (0.5 * (right - left), 0.5 * (right + left).abs());
        let steepness = match self.frame().law() {
            // The pressure follows from slopes.
            Law::Smooth => 0.0,
            Law::Linear => 1.0,
            Law::Power(exponent) => {
                solution.size().max(f64::MIN_POSITIVE).powf(1.0 - exponent) / exponent
            }
        };
        let stiffness = solution.stiffness().force_settlement.abs();
        let force = if stiffness.is_finite() { stiffness * rounding } else { 0.0 };
        let turn = TURN * rounding / half.max(f64::MIN_POSITIVE);
        // What is prescribed or zero by symmetry stays exact.
        let unless_exact = |known: f64, error: f64| if known == 0.0 { 0.0 } else { error };
        let accuracy = Accuracy {
            kind: known.kind,
            pressure: solution.growth() * steepness * rounding,
            settlement: unless_exact(known.settlement, rounding + middle * turn),
            tilt: unless_exact(known.tilt, turn),
            force: unless_exact(known.force, force),
            moment: unless_exact(known.moment, (middle + half) * force),
        };
        let sizes = solution.state().sizes(solution.size());
        // A settlement may be next to nothing where heights above and below cancel.
        let sizes = Sizes { displacement: sizes.displacement.max(height), ..sizes };
        Some(OfHeights { accuracy, sizes })
    }
}

impl OfHeights {
    /// The largest error relative to its size.
    pub(super) fn relative(&self) -> f64 {
        self.accuracy.relative(&self.sizes)
    }

    /// The larger one of an error and this.
    pub(super) fn or(&self, known: &Accuracy) -> Accuracy {
        let own = &self.accuracy;
        Accuracy {
            kind: known.kind,
            pressure: known.pressure.max(own.pressure),
            settlement: known.settlement.max(own.settlement),
            tilt: known.tilt.max(own.tilt),
            force: known.force.max(own.force),
            moment: known.moment.max(own.moment),
        }
    }
}

impl Accuracy {
    /// With the rounding of a level that is added to the settlement.
    pub(crate) fn with_level(self, level: f64) -> Self {
        let known = self.settlement;
        let settlement = if known == 0.0 { 0.0 } else { known + ROUNDING * level.abs() };
        Self { settlement, ..self }
    }
}

impl Error {
    /// The same with settlements counted from where the heights are, not from a level, in the units of the problem and without dimensions.
    pub(crate) fn with_level(self, level: f64, level0: f64) -> Self {
        match self {
            Self::SettlementOutOfReach { value, eccentricity, limit, bound } => {
                let (value, limit) = (value + level, limit + level);
                Self::SettlementOutOfReach { value, eccentricity, limit, bound }
            }
            Self::ToleranceNotMet { tolerance, reached, method, n, settlement0, tilt0 } => {
                let settlement0 = settlement0 + level0;
                Self::ToleranceNotMet { tolerance, reached, method, n, settlement0, tilt0 }
            }
            other => other,
        }
    }
}
