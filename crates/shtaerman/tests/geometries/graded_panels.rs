//! Graded ground on panels, next to where these meet and where a contact ends, against the same bases without the kinks that ask for panels: cases of a hostile review.

use shtaerman::{Contact, MethodName};

/// So many kinks that a base with them is for panels, and so faint that nothing else shows them.
fn with_kinks(profile: &str) -> String {
    let kinks = (0..18).map(|k| format!("1e-22*abs(rho - {:.4})", 0.0313 + 0.0521 * f64::from(k)));
    format!("{profile} + {}", kinks.collect::<Vec<_>>().join(" + "))
}

/// A file of this geometry, exponent, modulus, roughness, height of the base, base and force.
fn solved(
    geometry: &str,
    [exponent, modulus, roughness, height, force]: [f64; 5],
    profile: &str,
) -> Contact {
    let (width, place) = match geometry {
        "circular" => ("radius", "rho"),
        _ => ("half_width", "xi"),
    };
    let profile = profile.replace("rho", place);
    let text = format!(
        "[foundation]\npoisson_ratio = 0.3\ngrading_exponent = {exponent}\ngrading_modulus = {modulus}\nroughness = {roughness}\n[punch]\ngeometry = \"{geometry}\"\n{width} = 0.25\n\
         profile = \"{height}*({profile})\"\n[load]\nforce = {force}\nmoment = 0\n"
    );
    let contact = shtaerman::file::parse(&text, "test").unwrap().solve().unwrap();
    let is_on_panels = contact.method().name == MethodName::Panels;
    assert_eq!(is_on_panels, profile.contains("1e-22"), "{text}");
    contact
}

/// `d^(1 - mu)` of the distance from where two panels meet is in the potential of each.
#[test]
fn pressures_next_to_ends_of_panels() {
    let plane = [0.8, 365_420_280.0, 2.9e-9, 6.3e-4, 3073.0];
    let circular = [0.45, 2.2e8, 2.9e-9, 6.3e-4, 950.0];
    for (geometry, numbers, profile) in
        [("plane", plane, "rho^4 - 0.1*rho^2"), ("circular", circular, "0.3*rho^2 + 0.1*rho^3")]
    {
        let [smooth, found] =
            [profile.to_owned(), with_kinks(profile)].map(|base| solved(geometry, numbers, &base));
        let stated = [&smooth, &found].map(|contact| contact.error().unwrap().pressure);
        assert!(stated[1] < 1e-8 * found.peak_pressure(), "{geometry}: {stated:?}");
        let mut count = 0;
        // Middles of pieces between kinks, where panels meet.
        for k in 0..17 {
            let middle = 0.25 * (0.0313 + 0.0521 * (f64::from(k) + 0.5));
            let beside = (-8..=8).map(|j| f64::from_bits((middle.to_bits() as i64 + j) as u64));
            for x in beside.chain([middle + 1e-15, middle - 2e-14]) {
                let (Ok(one), Ok(other)) = (smooth.pressure(x), found.pressure(x)) else {
                    continue;
                };
                let allowed = stated[0] + stated[1] + 1e-14 * one.abs();
                assert!(
                    (one - other).abs() <= allowed,
                    "{geometry} {x:e}: {one} {other} {stated:?}"
                );
                count += 1;
            }
        }
        assert!(count > 100);
    }
}

/// The slope of the layer at a free end is an integral over `d^(-mu)`, and what the layer answers has `d^(1 - mu)` there.
#[test]
fn the_width_of_contact() {
    for (numbers, profile) in [
        ([0.45, 224_942_568.0, 2.9e-9, 6.3e-4, 953.6], "0.3*rho^2 + 13.83*max(0, 1.51e-05 - rho)"),
        ([0.49, 37_363_934.0, 2.6e-9, 2.7e-5, 56.3], "floor(5.95*rho)*0.0084 + 0.3*rho^2"),
        ([0.3, 37_363_934.0, 2.6e-9, 2.7e-4, 200.0], "0.3*rho^2"),
    ] {
        let widths = [profile.to_owned(), with_kinks(profile)].map(|base| {
            let contact = solved("circular", numbers, &base);
            let width = contact.dimensionless().sensitivities().unwrap().contact_width;
            let zones = contact.dimensionless().zones();
            let whole: f64 = zones.iter().map(|[left, right]| right - left).sum();
            let share = contact.dimensionless().force() / whole;
            [width.force.unwrap() * share, width.error]
        });
        let [[one, error], [other, beside]] = widths;
        let off = (one - other).abs();
        assert!(off <= 2e-7 && off <= error + beside, "{profile}: {widths:?}");
    }
}
