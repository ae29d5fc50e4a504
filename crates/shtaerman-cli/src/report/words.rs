//! An answer in sentences.

use shtaerman::quantity::{Measure, OutputUnits};
use shtaerman::{Contact, Geometry, Law, Rotational, Vertical};

use super::{Shown, significant};

/// Significant digits of a value.
const DIGITS: usize = 6;
/// A tilt below this share of what its error or rounding makes is told as none.
const ROUNDING: f64 = 1e-12;
/// Places this near to an edge, in half-widths, are that edge.
const NEAR: f64 = 1e-9;
/// Most zones that are told one by one.
const MOST_ZONES: usize = 3;

/// Values of a contact as sentences show them.
struct Words {
    shown: Shown,
}

impl Words {
    fn of(contact: &Contact, units: &OutputUnits) -> Self {
        Self { shown: Shown::of(contact.problem(), units) }
    }

    fn length(&self, value: f64) -> String {
        self.shown.with_digits(value, Measure::Length, DIGITS)
    }

    fn depth(&self, value: f64) -> String {
        self.shown.with_digits(value, Measure::Displacement, DIGITS)
    }

    fn pressure(&self, value: f64) -> String {
        self.shown.with_digits(value, Measure::Pressure, DIGITS)
    }

    fn angle(&self, value: f64) -> String {
        self.shown.with_digits(value, Measure::Angle, DIGITS)
    }

    fn force(&self, value: f64) -> String {
        self.shown.with_digits(value, self.shown.force(), DIGITS)
    }

    fn moment(&self, value: f64) -> String {
        self.shown.with_digits(value, self.shown.moment(), DIGITS)
    }
}

/// What the answer says: how the punch moves, where it touches, where it presses most, how sure that is.
pub(crate) fn sentences(contact: &Contact, units: &OutputUnits) -> Vec<String> {
    let shown = &Words::of(contact, units);
    let mut said = vec![motion(contact, shown), touching(contact, shown), pressing(contact, shown)];
    said.extend(certainty(contact, &shown.shown));
    said
}

fn motion(contact: &Contact, shown: &Words) -> String {
    let load = contact.problem().load();
    let depth = shown.depth(contact.settlement().abs());
    let sinks = match load.vertical() {
        Vertical::Force(_) if contact.settlement() < 0.0 => {
            format!("Against its gauge the punch stands {depth} above zero")
        }
        Vertical::Force(_) => format!("The punch sinks in by {depth}"),
        Vertical::Settlement(_) => {
            let force = shown.force(contact.force());
            format!("To sink in by {depth} the punch needs a force of {force}")
        }
    };
    let half_width = contact.problem().punch().half_width();
    let is_level = (contact.tilt() * half_width).abs() <= ROUNDING * contact.settlement().abs();
    let side = if contact.tilt() > 0.0 { "left" } else { "right" };
    let tilts = match load.rotational() {
        Rotational::Tilt(_) if is_level && contact.moment() != 0.0 => {
            format!(" and is held level by a moment of {}", shown.moment(contact.moment()))
        }
        _ if is_level => " and stays level".to_owned(),
        Rotational::Tilt(_) => format!(
            ", held at a tilt of {} by a moment of {}",
            shown.angle(contact.tilt()),
            shown.moment(contact.moment())
        ),
        Rotational::Moment(_) | Rotational::Eccentricity(_) => {
            format!(" and tilts by {}, its {side} side deeper", shown.angle(contact.tilt().abs()))
        }
    };
    format!("{sinks}{tilts}.")
}

fn touching(contact: &Contact, shown: &Words) -> String {
    let punch = contact.problem().punch();
    let zones = contact.zones();
    let width = shown.length(contact.contact_width());
    if contact.dimensionless().zones() == punch.pieces() {
        return match zones.len() {
            1 => format!("It touches along its whole base, {width} wide."),
            2 => format!("Both bases touch wholly, {width} together."),
            count => format!("All {count} bases touch wholly, {width} together."),
        };
    }
    if contact.problem().is_circular() {
        return touching_rings(contact, shown);
    }
    let whole: f64 = punch.pieces().iter().map(|piece| piece[1] - piece[0]).sum();
    let share = 100.0 * contact.dimensionless().contact_width() / whole;
    let places: Vec<String> = zones
        .iter()
        .take(MOST_ZONES)
        .map(|zone| format!("from {} to {}", shown.length(zone[0]), shown.length(zone[1])))
        .collect();
    let more = zones.len().saturating_sub(MOST_ZONES);
    let more = match more {
        0 => String::new(),
        1 => " and in 1 more zone".to_owned(),
        more => format!(" and in {more} more zones"),
    };
    format!(
        "It touches {}{more}: {width}, {} % of its base; the rest has lifted off.",
        places.join(" and "),
        significant(share, 3)
    )
}

/// Where a circular punch touches, as radii, and the share of the area of its base.
fn touching_rings(contact: &Contact, shown: &Words) -> String {
    let radius = contact.problem().punch().half_width();
    let rings: Vec<[f64; 2]> = contact
        .zones()
        .into_iter()
        .map(|[from, to]| [from.max(0.0), to])
        .filter(|[from, to]| from < to)
        .collect();
    let area = |[from, to]: &[f64; 2]| (to / radius).powi(2) - (from / radius).powi(2);
    let share = 100.0 * rings.iter().map(area).sum::<f64>();
    let place = |[from, to]: &[f64; 2]| match *from {
        0.0 => format!("up to {}", shown.length(*to)),
        from => format!("from {} to {}", shown.length(from), shown.length(*to)),
    };
    let places: Vec<String> = rings.iter().take(MOST_ZONES).map(place).collect();
    let more = match rings.len().saturating_sub(MOST_ZONES) {
        0 => String::new(),
        1 => " and in one ring more".to_owned(),
        more => format!(" and in {more} rings more"),
    };
    format!(
        "It touches at radii {}{more}: {} % of the area of its base; the rest has lifted off.",
        places.join(" and "),
        significant(share, 3)
    )
}

fn pressing(contact: &Contact, shown: &Words) -> String {
    let peak = contact.peak_pressure();
    let xi = contact.dimensionless().peak_pressure_at();
    let place = if (xi + 1.0).abs() < NEAR {
        "at the left edge".to_owned()
    } else if (xi - 1.0).abs() < NEAR {
        "at the right edge".to_owned()
    } else if xi.abs() < NEAR {
        "in the middle".to_owned()
    } else {
        format!(
            "at {} = {}",
            contact.problem().coordinate(),
            shown.length(contact.peak_pressure_at())
        )
    };
    if !peak.is_finite() {
        return format!(
            "Without roughness the pressure is infinite {}.",
            infinite(contact, shown, place)
        );
    }
    let mean = contact.mean_pressure();
    let ratio = peak / mean;
    let beside = if ratio.is_finite() && ratio > 0.0 {
        format!(", {} times the mean over the base", significant(ratio, 3))
    } else {
        String::new()
    };
    format!("The pressure is largest {place}: {}{beside}.", shown.pressure(peak))
}

/// Where the pressure is infinite: at edges, or below a kink, the place of the largest pressure.
fn infinite(contact: &Contact, shown: &Words, place: String) -> String {
    let ends: Vec<f64> = contact.zones().into_iter().flatten().collect();
    let pressures = contact.pressures(&ends).unwrap_or_default();
    let found = ends.iter().zip(pressures).filter(|(_, pressure)| pressure.is_infinite());
    let edges: Vec<f64> = found.map(|(end, _)| *end).collect();
    let punch = contact.problem().punch();
    match edges.as_slice() {
        [] | [_] => place,
        _ if punch.geometry() == Geometry::Circular => "at its edge".to_owned(),
        [left, right] if *left == -*right && *right == punch.half_width() => {
            "at both edges".to_owned()
        }
        edges => super::stress::infinite_at(edges, &|x| shown.length(x)),
    }
}

fn certainty(contact: &Contact, shown: &Shown) -> Option<String> {
    let error = contact.error()?;
    let is_bound = error.kind.name() == "bound";
    let pressure = shown.few_digits(error.pressure, Measure::Pressure);
    let (what, value) = match contact.problem().load().vertical() {
        Vertical::Force(_) => {
            ("settlement", shown.few_digits(error.settlement, Measure::Displacement))
        }
        Vertical::Settlement(_) => ("force", shown.few_digits(error.force, shown.force())),
    };
    let sure = if is_bound { "is guaranteed to be" } else { "is estimated to be" };
    // That of a smooth surface is stated for the middle of the zones, and nearer to a corner it grows as the pressure does.
    let is_smooth = contact.problem().foundation().law() == Law::Smooth;
    let place = match is_smooth && !(is_bound && contact.peak_pressure().is_finite()) {
        true => "in the middle of the contact",
        false => "everywhere",
    };
    Some(format!(
        "The pressure {sure} within {pressure} of the truth {place}, the {what} within {value}."
    ))
}
