//! What is said above the picture of a contact.

use shtaerman::quantity::{Measure, OutputUnits};
use shtaerman::{
    Contact, ContactKind, Geometry, Law, LayerBase, Layering, Problem, Roughness, Scaling,
};

use super::ContactPicture;
use crate::report::heading::heading;
use crate::report::number::significant;

/// Digits of a number in a title or a note.
const DIGITS: usize = 4;

/// Name, load and largest pressure.
pub(super) fn title(contact: &Contact, wanted: &ContactPicture) -> String {
    let said = format!("{}, {}", load(contact, &wanted.units), peak(contact, &wanted.units));
    match heading(&wanted.name) {
        Some(name) => format!("{name}: {said}"),
        None => said,
    }
}

/// Force and, where there is one, moment.
pub(crate) fn load(contact: &Contact, units: &OutputUnits) -> String {
    let problem = contact.problem();
    let (force, moment) = (contact.force(), contact.moment());
    if problem.is_dimensionless() {
        let force = format!("P₀ = {}", significant(force, DIGITS));
        return if is_there(contact) {
            format!("{force}, M₀ = {}", significant(moment, DIGITS))
        } else {
            force
        };
    }
    let [force_measure, moment_measure] = if problem.is_circular() {
        [Measure::Force, Measure::Moment]
    } else {
        [Measure::ForcePerLength, Measure::MomentPerLength]
    };
    let said = units.shown_with_digits(force, force_measure, DIGITS);
    if !is_there(contact) {
        return said;
    }
    // N m per m is N, which the chosen units of a moment say themselves.
    let per = if problem.is_circular() || units.has(moment_measure) { "" } else { " m/m" };
    format!("{said}, moment {}{per}", units.shown_with_digits(moment, moment_measure, DIGITS))
}

/// Whether there is a moment beyond its error.
fn is_there(contact: &Contact) -> bool {
    let error = contact.error().map_or(0.0, |error| error.moment);
    let scale = contact.force().abs() * contact.problem().punch().half_width();
    contact.moment().abs() > error.max(1e-12 * scale)
}

fn peak(contact: &Contact, units: &OutputUnits) -> String {
    let peak = contact.peak_pressure();
    if !peak.is_finite() {
        return "infinite pressure at corners".to_owned();
    }
    let shown = if contact.problem().is_dimensionless() {
        significant(peak, DIGITS)
    } else {
        units.shown_with_digits(peak, Measure::Pressure, DIGITS)
    };
    format!("largest pressure {shown}")
}

/// What was pressed on what, and how sure the answer is.
pub(super) fn notes(contact: &Contact, units: &OutputUnits) -> Vec<String> {
    let mut notes = vec![setting(contact, units), sureness(contact, units)];
    if !contact.tension().is_empty() {
        notes.push(
            "the pressure is negative where the area is shaded: the punch would lift off there"
                .to_owned(),
        );
    }
    notes
}

fn setting(contact: &Contact, units: &OutputUnits) -> String {
    let problem = contact.problem();
    let kind = match problem.solver().contact() {
        ContactKind::Unilateral => "unilateral contact",
        ContactKind::Bilateral => "bilateral contact",
    };
    let mut said = vec![kind.to_owned()];
    let Some(scaling) = problem.scaling() else {
        if problem.foundation().law() != Law::Smooth {
            said.push(format!("θ₀ = {}", significant(contact.theta0(), DIGITS)));
        }
        said.extend(ground(problem, units));
        return said.join(", ");
    };
    let length = |value: f64| units.shown_with_digits(value, Measure::Length, DIGITS);
    let half_width = scaling.half_width();
    said.push(match problem.punch().geometry() {
        Geometry::Circular => format!("radius {}", length(half_width)),
        Geometry::Pair { inner_half_gap } => {
            format!("feet from ±{} to ±{}", length(inner_half_gap), length(half_width))
        }
        Geometry::Periodic { period } if problem.punch().geometry().is_wave(half_width) => {
            format!("a wave of period {}", length(period))
        }
        Geometry::Periodic { period } => {
            format!("half-width {}, period {}", length(half_width), length(period))
        }
        _ => format!("half-width {}", length(half_width)),
    });
    let modulus = scaling.contact_modulus();
    said.push(format!("E* = {}", units.shown_with_digits(modulus, Measure::Pressure, DIGITS)));
    said.extend(ground(problem, units));
    said.push(layer(scaling, units));
    said.join(", ")
}

/// What the ground is beside its modulus; nothing of a half-space of one material.
fn ground(problem: &Problem, units: &OutputUnits) -> Option<String> {
    let foundation = problem.foundation();
    let length = |value: f64| match problem.is_dimensionless() {
        true => format!("{} a", significant(value, DIGITS)),
        false => units.shown_with_digits(value, Measure::Length, DIGITS),
    };
    match (foundation.layering(), foundation.grading()) {
        (Some(Layering::Layer { thickness, base, .. }), _) => {
            let held = match base {
                LayerBase::Bonded { .. } => "bonded to",
                LayerBase::Frictionless => "sliding on",
            };
            Some(format!("a layer {} thick, {held} a rigid base", length(*thickness)))
        }
        (Some(Layering::Coating { thickness, coating, .. }), _) => {
            let modulus =
                units.shown_with_digits(coating.young_modulus(), Measure::Pressure, DIGITS);
            Some(format!("coating {} thick of E = {modulus}", length(*thickness)))
        }
        (None, Some(grading)) if !grading.is_homogeneous() => {
            Some(format!("graded as y^{}", significant(grading.exponent(), DIGITS)))
        }
        _ => None,
    }
}

fn layer(scaling: &Scaling, units: &OutputUnits) -> String {
    match scaling.roughness() {
        Roughness::Linear { compliance } if compliance > 0.0 => {
            format!(
                "rough layer χ = {}",
                units.shown_with_digits(compliance, Measure::Compliance, DIGITS)
            )
        }
        Roughness::Power { exponent, .. } => {
            format!("rough layer v = B p^{}", significant(exponent, DIGITS))
        }
        _ => "smooth surface".to_owned(),
    }
}

/// The error of the pressure as the answer states it, seen or not.
fn sureness(contact: &Contact, units: &OutputUnits) -> String {
    let Some(error) = contact.error() else {
        return "no error is stated for the pressure".to_owned();
    };
    let at_most = if contact.problem().is_dimensionless() {
        significant(error.pressure, 2)
    } else {
        units.shown_with_digits(error.pressure, Measure::Pressure, 2)
    };
    format!("error of the pressure at most {at_most} ({})", error.kind.name())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_become_headings() {
        assert_eq!(heading("crowned_punch").as_deref(), Some("Crowned punch"));
        assert_eq!(heading("  "), None);
    }
}
