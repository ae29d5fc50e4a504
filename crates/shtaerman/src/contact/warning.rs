//! What a user should know about a contact.

use super::Contact;
use super::complementarity::Complementarity;
use super::kinks::Kink;
use crate::bodies::Bodies;
use crate::intervals::SLIVER;
use crate::quantity::{Dimension, DisplayUnit, Measure, OutputUnits, engineering};
use crate::warning::{Warning, WarningCode};

/// Degrees per unit of `theta0` below which the layers of width `1/theta0` at the edges are hardly resolved. At half or twice 4 of 10 answers change, within what they state (survey).
const LAYER_DEGREES: f64 = 4.0;
/// Most intervals a message names (survey).
const MOST_PLACES: usize = 6;

/// A coordinate in the units of the problem, or in those chosen.
fn position(bodies: &Bodies, units: &OutputUnits, xi: f64) -> String {
    // A rounded zero.
    if xi.abs() < SLIVER {
        return "0".to_owned();
    }
    match bodies.scaling() {
        Some(scaling) => units.shown(xi * scaling.half_width(), Measure::Length),
        None => engineering(xi, Dimension::NONE),
    }
}

/// Places as a sentence has them, and how many more there are of what they are.
fn listed<T>(all: &[T], what: &str, told: impl Fn(&T) -> String) -> String {
    let mut places: Vec<String> = all.iter().take(MOST_PLACES).map(told).collect();
    if all.len() > MOST_PLACES {
        places.push(format!("{} more {what}", all.len() - MOST_PLACES));
    }
    places.join(" and ")
}

impl Contact {
    /// What is warned of with places.
    pub(super) const PLACED: [WarningCode; 3] =
        [WarningCode::NegativePressure, WarningCode::SingularEdge, WarningCode::SingularKink];

    /// One of those, with lengths in these units.
    pub(super) fn placed_warning(&self, code: WarningCode, units: &OutputUnits) -> Option<Warning> {
        let bodies = self.problem().bodies();
        match code {
            WarningCode::NegativePressure => {
                Warning::negative_pressure(bodies, units, self.tension_at())
            }
            WarningCode::SingularEdge => {
                Warning::singular_edge(bodies, units, &self.singular_corners())
            }
            WarningCode::SingularKink => Warning::singular_kink(bodies, units, self.kinks()),
            _ => None,
        }
    }

    /// [`Contact::warnings`] with their places in these units.
    #[must_use]
    pub fn warnings_in(&self, units: &OutputUnits) -> Vec<Warning> {
        let told = |warning: &Warning| self.placed_warning(warning.code, units);
        self.warnings().iter().map(|one| told(one).unwrap_or_else(|| one.clone())).collect()
    }
}

impl Warning {
    /// The search ended at the time limit, with so much left.
    pub(super) fn time_limit(left: Option<Complementarity>) -> Self {
        let left = left.map_or(String::new(), |Complementarity { tension, penetration }| {
            format!(
                "; tension {tension:.1e} and penetration {penetration:.1e} of their scales are left"
            )
        });
        let message =
            format!("the time limit ended the search: zones and pressure are not final{left}");
        Self { code: WarningCode::TimeLimit, message }
    }

    /// The pressure is negative on these intervals of `xi`; none if there are none.
    pub(super) fn negative_pressure(
        bodies: &Bodies,
        units: &OutputUnits,
        tension: &[[f64; 2]],
    ) -> Option<Self> {
        if tension.is_empty() {
            return None;
        }
        let shown = |xi: f64| position(bodies, units, xi);
        let variable = bodies.coordinate();
        let places = listed(tension, "intervals", |[left, right]| {
            format!("{variable} = {} to {}", shown(*left), shown(*right))
        });
        let message = format!(
            "the pressure is negative at {places}: a bilateral answer that pulls there; a real punch would lift off"
        );
        Some(Self { code: WarningCode::NegativePressure, message })
    }

    /// The pressure is infinite at these `xi`, with these corner intensities in the units of the problem; none if there are none.
    pub(super) fn singular_edge(
        bodies: &Bodies,
        units: &OutputUnits,
        corners: &[(f64, f64)],
    ) -> Option<Self> {
        if corners.is_empty() {
            return None;
        }
        let intensity = match bodies.scaling() {
            Some(_) => bodies.corner_unit(),
            None => DisplayUnit::NUMBER,
        };
        let places = listed(corners, "corners", |(xi, k)| {
            let k = engineering(*k, intensity.clone());
            format!("{} = {} (K = {k})", bodies.coordinate(), position(bodies, units, *xi))
        });
        let meaning = if bodies.grading().is_some() {
            let beta = engineering(bodies.corner_exponent(), Dimension::NONE);
            format!("K = lim sqrt(2 pi) d^{beta} p at the distance d")
        } else {
            "K = lim sqrt(2 pi d) p at the distance d: with a roughness chi it would be about K/sqrt(E* chi)"
                .to_owned()
        };
        let message = format!(
            "the pressure of a smooth surface is infinite at the corner {places}, {meaning}"
        );
        Some(Self { code: WarningCode::SingularEdge, message })
    }

    /// The pressure is infinite under these kinks; none if there are none.
    pub(super) fn singular_kink(
        bodies: &Bodies,
        units: &OutputUnits,
        kinks: &[Kink],
    ) -> Option<Self> {
        let kinks: Vec<&Kink> = kinks.iter().filter(|kink| kink.pressure.is_infinite()).collect();
        if kinks.is_empty() {
            return None;
        }
        let places = listed(&kinks, "places", |kink| {
            format!("{} = {}", bodies.coordinate(), position(bodies, units, kink.xi))
        });
        let growth = match kinks.iter().any(|kink| kink.is_cusp) {
            true => "as a power of the distance where the base has a cusp, else as its logarithm",
            false => "as the logarithm of the distance",
        };
        let message = format!(
            "the pressure of a smooth surface is infinite under the kink of the base at {places}, {growth}: a roughness or a radius there makes it finite"
        );
        Some(Self { code: WarningCode::SingularKink, message })
    }

    /// The expansion of the profile is off by `error`, relative to its largest value.
    pub(super) fn profile_not_resolved(error: f64) -> Self {
        let message = format!(
            "the profile is not resolved to rounding (a kink, a jump, fast oscillation, or a formula that loses digits): its \
             expansion is off by about {error:.1e} of its largest value (estimate)"
        );
        Self { code: WarningCode::ProfileNotResolved, message }
    }

    /// Nothing is proved of the profile between samples; none where it is.
    pub(super) fn profile_not_proved(is_unknown: bool) -> Option<Self> {
        is_unknown.then(|| Self {
            code: WarningCode::ProfileNotResolved,
            message: "too fast an oscillation, or too many features: what the profile does between samples is not proved, and features narrower than these may be missed; no \
                      relative error below 1e-3 is stated"
                .to_owned(),
        })
    }

    /// The degree does not resolve the boundary layers; none if it does.
    pub(super) fn low_degree(degree: usize, theta0: f64) -> Option<Self> {
        if degree as f64 >= LAYER_DEGREES * theta0 {
            return None;
        }
        let message = format!(
            "n = {degree} is below {LAYER_DEGREES} theta0 = {}: the boundary layers at the edges are hardly resolved and edge pressures have \
             few digits",
            engineering(LAYER_DEGREES * theta0, Dimension::NONE)
        );
        Some(Self { code: WarningCode::LowDegree, message })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Elastic, Foundation, Punch};

    #[test]
    fn names_places_as_people_write_them() {
        let steel = Elastic::new(200e9, 0.3).unwrap();
        let steel = Foundation::new(steel).with_roughness(1.2e-14).unwrap();
        let physical = Bodies::new(&steel, &Punch::new(5e-3).unwrap()).unwrap();
        let bare = Foundation::dimensionless(1.0).unwrap();
        let bare = Bodies::new(&bare, &Punch::new(1.0).unwrap()).unwrap();
        let units = OutputUnits::default();
        for (bodies, tension, said) in [
            (&physical, [[-1.0, -2.67e-16]].as_slice(), "at x = -5 mm to 0:"),
            (&physical, &[[0.5, 1.0]], "at x = 2.5 mm to 5 mm:"),
            (
                &bare,
                &[[-1.0, -0.892_038_1], [0.25, 1.0]],
                "at xi = -1 to -0.892038 and xi = 0.25 to 1:",
            ),
            (&bare, &[[0.0, 0.1]; 9], "and 3 more intervals:"),
        ] {
            let warning = Warning::negative_pressure(bodies, &units, tension).unwrap();
            assert!(warning.message.contains(said), "{}", warning.message);
        }
        assert_eq!(Warning::negative_pressure(&bare, &units, &[]), None);
        let corners = Warning::singular_edge(&bare, &units, &[(0.5, 1.0); 8]).unwrap().message;
        assert!(corners.contains("xi = 0.5 (K = 1) and 2 more corners, K"), "{corners}");
    }
}
