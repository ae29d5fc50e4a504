//! Heights of the base: counted from its level, and known to their rounding only.

use super::accuracy::Accuracy;
use super::solution::Solution;
use crate::roughness::Law;
use crate::{Error, Problem};

/// Places in all zones at which the rounding of heights is looked at, at least one in each, and where in its step each lies: an irrational share keeps clear of jumps.
const PLACES: usize = 128;
const ASIDE: f64 = 0.381_966;
/// Growth of a disturbance of the heights on its way to the pressure of the layer: the inverse of `I + theta0 K` has a norm near one, and the balance adds as much again.
const GROWTH: f64 = 2.0;
/// Rounding of the level that is added to the settlement.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

impl Problem {
    /// The largest rounding of the dimensionless heights in the zones of contact.
    fn height_rounding(&self, zones: &[[f64; 2]]) -> f64 {
        let steps = (PLACES / zones.len().max(1)).max(1);
        let half_width = self.frame().half_width();
        let mut largest = 0.0f64;
        for [left, right] in zones {
            for i in 0..steps {
                let xi = left + (right - left) * (i as f64 + ASIDE) / steps as f64;
                let rounding = self.profile().rounding(xi.clamp(-1.0, 1.0), half_width);
                if rounding.is_finite() {
                    largest = largest.max(rounding);
                }
            }
        }
        self.frame().scaling().map_or(largest, |scaling| largest / scaling.displacement())
    }

    /// The error of a solution, at least what the rounding of heights makes of it.
    pub(super) fn stated(&self, solution: &dyn Solution) -> Option<Accuracy> {
        let accuracy = *solution.accuracy()?;
        let zones = solution.zones();
        let (Some([left, _]), Some([_, right])) = (zones.first(), zones.last()) else {
            return Some(accuracy);
        };
        let rounding = self.height_rounding(&zones);
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
        let turn = GROWTH * rounding / half.max(f64::MIN_POSITIVE);
        let raised = |known: f64, to: f64| if known == 0.0 { 0.0 } else { known.max(to) };
        let force = if stiffness.is_finite() { stiffness * rounding } else { 0.0 };
        Some(Accuracy {
            kind: accuracy.kind,
            pressure: accuracy.pressure.max(GROWTH * steepness * rounding),
            settlement: raised(accuracy.settlement, rounding + middle * turn),
            tilt: raised(accuracy.tilt, turn),
            force: raised(accuracy.force, force),
            moment: raised(accuracy.moment, (middle + half) * force),
        })
    }
}

impl Accuracy {
    /// With the rounding of a level that is added to the settlement.
    pub(super) fn with_level(self, level: f64) -> Self {
        let known = self.settlement;
        let settlement = if known == 0.0 { 0.0 } else { known + ROUNDING * level.abs() };
        Self { settlement, ..self }
    }
}

impl Error {
    /// The same with settlements counted from where the heights are, not from a level, in the units of the problem and without dimensions.
    pub(super) fn with_level(self, level: f64, level0: f64) -> Self {
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
