//! The picture of a contact.

use shtaerman::quantity::{Dimension, axis_unit};
use shtaerman::{Contact, Error, Law, PressureCurve};

use super::number::significant;
use crate::plot::ContactPlot;

/// Points of the plotted curves.
const PLOT_POINTS: usize = 401;
/// How far beside the punch the surface is drawn, in half-widths.
const PLOT_MARGIN: f64 = 0.6;

/// The picture of a contact: its pressure and, below it, the base and the deformed surface, in units that suit them.
///
/// # Errors
/// Those of [`PressureCurve::along`].
pub fn contact_plot(contact: &Contact) -> Result<ContactPlot, Error> {
    let half_width = contact.problem().punch().half_width();
    let physical = !contact.problem().is_dimensionless();
    let curve = PressureCurve::along(contact, PLOT_POINTS)?;
    let places = &curve.x;
    let base: Vec<f64> = places.iter().map(|&x| contact.base_depth(x)).collect();
    let beside = (1..=80).map(|i| half_width * (1.0 + PLOT_MARGIN * (f64::from(i) / 80.0).powi(2)));
    let mut surface: Vec<(f64, f64)> = beside
        .clone()
        .map(|x| -x)
        .chain(places.iter().copied())
        .chain(beside)
        .map(|x| (x, contact.elastic_displacement(x)))
        .collect();
    surface.sort_by(|one, two| one.0.total_cmp(&two.0));
    let unit =
        |values: &mut dyn Iterator<Item = f64>, dimension: Dimension, symbol: &str, plain: &str| {
            let largest = values.fold(0.0f64, |largest, value| largest.max(value.abs()));
            if physical {
                let unit = axis_unit(largest, dimension);
                (unit.factor, format!("{symbol} [{}]", unit.label))
            } else {
                (1.0, plain.to_owned())
            }
        };
    let (length, position_label) =
        unit(&mut std::iter::once(half_width), Dimension::LENGTH, "x", "ξ = x/a");
    let (stress, pressure_label) = unit(
        &mut curve.pressure.iter().copied(),
        Dimension::PRESSURE,
        "pressure p",
        "pressure p₀ = p/E",
    );
    let depths = &mut base.iter().copied().chain(surface.iter().map(|point| point.1));
    let (depth, displacement_label) = unit(depths, Dimension::LENGTH, "depth", "depth / (χE)");
    Ok(ContactPlot {
        title: "Contact of a rigid punch with a rough elastic body".to_owned(),
        notes: notes(contact),
        position: places.iter().map(|x| x * length).collect(),
        pressure: curve.pressure.iter().map(|p| p * stress).collect(),
        pressure_band: band(contact, &curve, stress),
        punch_base: base.iter().map(|u| u * depth).collect(),
        body_surface: surface.iter().map(|(x, u)| (x * length, u * depth)).collect(),
        contact_zones: lifted(contact).iter().map(|zone| zone.map(|x| x * length)).collect(),
        position_label,
        pressure_label,
        displacement_label,
    })
}

/// Error of the pressure, relative to its largest value, from which on it can be seen in a plot.
const VISIBLE: f64 = 1e-3;

/// The pressure less and plus its error, where that can be seen.
fn band(contact: &Contact, curve: &PressureCurve, factor: f64) -> Option<(Vec<f64>, Vec<f64>)> {
    let error = contact.error()?.pressure;
    let largest = curve.pressure.iter().fold(0.0f64, |most, p| most.max(p.abs()));
    let shifted = |by: f64| curve.pressure.iter().map(|p| (p + by) * factor).collect();
    (error > VISIBLE * largest).then(|| (shifted(-error), shifted(error)))
}

/// The zones of contact, where they are not the full base.
fn lifted(contact: &Contact) -> Vec<[f64; 2]> {
    let pieces = contact.problem().punch().pieces();
    if contact.dimensionless().zones() == pieces { Vec::new() } else { contact.zones() }
}

fn notes(contact: &Contact) -> Vec<String> {
    let surface = match contact.problem().foundation().law() {
        Law::Smooth => "smooth surface".to_owned(),
        Law::Linear | Law::Power(_) => {
            format!("θ₀ = {}", significant(contact.theta0(), 5))
        }
    };
    let mut notes = vec![format!(
        "{surface}, {} method with n = {}; {}",
        contact.method().name,
        contact.method().n,
        contact.problem().solver().contact().name()
    )];
    if !contact.tension().is_empty() {
        notes.push(
            "the pressure is negative where the area is shaded: the punch would lift off there"
                .to_owned(),
        );
    }
    notes
}
