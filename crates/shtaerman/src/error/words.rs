//! Parts of messages.

use crate::quantity::plain;

/// A relative error; of an infinite one that there is none.
pub(super) fn relative(reached: f64) -> String {
    if reached.is_finite() {
        format!("a relative error of {reached:.1e}")
    } else {
        "no error that could be told".to_owned()
    }
}

/// What is left of an equation with this relative error.
pub(super) fn unsolved(reached: f64) -> &'static str {
    if reached < 1.0 { "no answer to two digits" } else { "no digit of the solution is certain" }
}

/// A value that is known to three digits.
pub(super) fn about(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

/// How far the search for zones came.
pub(super) fn attempt(tension: f64, penetration: f64) -> String {
    if tension.is_nan() {
        return "no attempt came to an end. A base with many waves, kinks or measured points may not be resolved, most of all under a disk on strongly graded ground, and of zones far smaller than the base its heights have too few digits: a smoother profile, another load or a rougher surface may be solved".to_owned();
    }
    if !(tension.is_finite() && penetration.is_finite()) {
        return "the best attempt has no pressure that its tension, and no displacement that its penetration could be measured by; another load, roughness or profile of more usual size may be solved".to_owned();
    }
    format!(
        "the best attempt has a tension of {tension:.1e} and a penetration of {penetration:.1e} of their scales"
    )
}

/// What is said of a circular punch that leans.
pub(super) fn lifts_off(field: &str, value: f64, limit: f64) -> String {
    let value = plain(value);
    let reason = if limit == 0.0 {
        "the circular base does not touch as a whole without it, and a contact that is no full disk is solved under a central load only (moment = 0)".to_owned()
    } else {
        format!(
            "the circular punch lifts off on one side, and its contact is no disk any more: full contact holds up to a magnitude of {}",
            plain(limit)
        )
    };
    format!("{field} = {value}: {reason}; contact = \"bilateral\" lets the pressure pull instead")
}
