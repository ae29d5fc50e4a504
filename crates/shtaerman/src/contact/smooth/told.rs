//! What every smooth answer tells of itself.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use super::check::points;
use crate::contact::accuracy::Accuracy;
use crate::contact::balance::State;
use crate::contact::complementarity::Complementarity;
use crate::contact::rates::{Rates, smooth_rates};
use crate::{Error, Load, Rotational, Vertical};

/// Points of a zone at which two resolutions are compared.
const COMPARISONS: usize = 33;
/// Points of a zone that show extremes, and of all of them. At half or twice 16 of 32 answers change, within what they state (survey).
const PLACES: usize = 256;
const MOST_PLACES: usize = 2048;

/// Errors, what is left of complementarity, and the largest pressure.
#[derive(Debug, Clone, Copy)]
pub(super) struct Told {
    pub(super) accuracy: Accuracy,
    /// Of the free edges, in `xi`.
    pub(super) edge_error: f64,
    pub(super) complementarity: Complementarity,
    /// The largest `|p0|` seen between the singular places.
    pub(super) largest: f64,
}

impl Told {
    /// Errors that count for what the load leaves open; tension and penetration relative to their scales.
    ///
    /// # Errors
    /// [`Error::Overflow`] when something is not finite.
    pub(super) fn new(
        (load, state): (&Load, &State),
        largest: f64,
        (accuracy, edge_error): (Accuracy, f64),
        [tension, penetration]: [f64; 2],
    ) -> Result<Self, Error> {
        let values = [
            ("force", state.force),
            ("moment", state.moment),
            ("settlement", state.settlement),
            ("tilt", state.tilt),
            ("pressure", largest),
            ("error of the pressure", accuracy.pressure),
        ];
        if let Some((quantity, value)) = values.into_iter().find(|(_, value)| !value.is_finite()) {
            return Err(Error::Overflow { quantity, value });
        }
        let complementarity = Complementarity { tension, penetration };
        Ok(Self { accuracy: open(load, accuracy), edge_error, complementarity, largest })
    }
}

/// Without errors of what the load prescribes.
fn open(load: &Load, accuracy: Accuracy) -> Accuracy {
    let of = |is_given: bool, error: f64| if is_given { 0.0 } else { error };
    let by_force = matches!(load.vertical, Vertical::Force(_));
    Accuracy {
        settlement: of(!by_force, accuracy.settlement),
        tilt: of(matches!(load.rotational, Rotational::Tilt(_)), accuracy.tilt),
        force: of(by_force, accuracy.force),
        moment: of(matches!(load.rotational, Rotational::Moment(_)), accuracy.moment),
        ..accuracy
    }
}

/// The largest difference of two functions of the angle of a zone. An irrational share of the step keeps clear of symmetric places, where a kink may be.
pub(super) fn compared(one: impl Fn(f64) -> f64, other: impl Fn(f64) -> f64) -> f64 {
    (0..COMPARISONS)
        .map(|i| PI * (i as f64 + FRAC_1_SQRT_2) / COMPARISONS as f64)
        .fold(0.0, |most: f64, angle| most.max((one(angle) - other(angle)).abs()))
}

/// Places of zones, closer to their ends, and the ends of the base, in order; of a base that repeats those of a zone may lie beyond `-1`.
pub(super) fn places(zones: &[[f64; 2]]) -> Vec<f64> {
    let count = (MOST_PLACES / zones.len().max(1)).clamp(8, PLACES);
    let along = zones.iter().flat_map(|zone| points(*zone, 0, count));
    let along = along.map(|xi| if xi < -1.0 { xi + 2.0 } else { xi });
    let mut places: Vec<f64> = along.chain([-1.0, 1.0]).filter(|xi| xi.abs() <= 1.0).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// First-order changes by those of `[settlement, force, tilt, pressure, width]` that go with each input of the load.
pub(super) fn rates(
    load: &Load,
    [force, largest]: [f64; 2],
    of: impl Fn([f64; 2]) -> Rates,
) -> [Rates; 3] {
    let finite = if largest.is_finite() { largest } else { 0.0 };
    let rotates = !matches!(load.rotational, Rotational::Eccentricity(_));
    let turned = if rotates { of([0.0, 1.0]) } else { [0.0; 5] };
    smooth_rates(load, [force, finite], [of([1.0, 0.0]), turned])
}
