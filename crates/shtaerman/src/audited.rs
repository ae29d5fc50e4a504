//! What an audit is handed of a problem: its base, enclosed, and what its load prescribes.

use shtaerman_audit::{Prescribed, Profile};

use crate::expression::Interval;
use crate::{Load, Problem, Rotational};

/// The base of a problem, enclosed.
pub(crate) struct EnclosedBase<'a>(pub(crate) &'a Problem);

impl Profile for EnclosedBase<'_> {
    fn height(&self, x: f64) -> [f64; 2] {
        ends(self.0.dimensionless_enclosure_at(x))
    }

    fn heights(&self, places: &[f64], found: &mut [[f64; 2]]) {
        for (range, known) in found.iter_mut().zip(self.0.dimensionless_enclosures_at(places)) {
            *range = ends(known);
        }
    }

    fn range(&self, interval: [f64; 2]) -> [f64; 2] {
        ends(self.0.dimensionless_enclosure(interval))
    }

    fn taylor_bounds(&self, interval: [f64; 2], order: usize) -> Vec<f64> {
        let found = self.0.dimensionless_taylor(interval, order).unwrap_or_default();
        found.iter().map(|range| range.lower().abs().max(range.upper().abs())).collect()
    }

    fn looks(&self, _: [f64; 2]) -> u64 {
        self.0.profile().looks()
    }
}

fn ends(range: Option<Interval>) -> [f64; 2] {
    range.map_or([f64::NEG_INFINITY, f64::INFINITY], |range| [range.lower(), range.upper()])
}

/// What the load prescribes; of a settlement with an eccentricity the answer's own force and moment instead, which is told.
pub(crate) fn prescribed(load: &Load, force: f64, moment: f64) -> (Prescribed, bool) {
    let given = load.vertical.force();
    let moment = match (load.rotational, given) {
        (Rotational::Tilt(_), _) => None,
        (Rotational::Moment(moment), _) => Some(moment),
        (Rotational::Eccentricity(e), Some(force)) => Some(e * force),
        (Rotational::Eccentricity(0.0), None) => Some(0.0),
        (Rotational::Eccentricity(_), None) => {
            return (Prescribed { force: Some(force), moment: Some(moment) }, true);
        }
    };
    (Prescribed { force: given, moment }, false)
}
