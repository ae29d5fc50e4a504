//! From one limit to the other.

use crate::limits::support::{CASES, Case};

/// `chi E*/a` from 1e-6 to 1e6: rounding takes the digits of thinner layers.
fn ladder() -> impl Iterator<Item = f64> {
    (0..40).map(|i| 10f64.powf(-6.0 + 12.0 * f64::from(i) / 39.0))
}

fn width(case: &Case, roughness: f64) -> [f64; 3] {
    let contact = case.solve(roughness);
    [contact.settlement(), contact.contact_width(), contact.peak_pressure()]
}

#[test]
fn settlement_width_and_peak_are_monotone() {
    for case in &CASES {
        let mut before: Option<[f64; 3]> = None;
        for roughness in ladder() {
            let [settlement, width, peak] = width(case, roughness);
            if let Some([s, w, p]) = before {
                let what = format!("{} at {roughness:e}", case.name);
                // Under an eccentric load the middle of the base may rise as the tilt grows.
                if case.moment.abs() < 0.5 {
                    assert!(settlement > s, "{what}: settlement {s} {settlement}");
                }
                // Turned on its corner, a flat punch stands on less of its base the rougher it is.
                let wider = if case.moment < 0.5 { width - w } else { w - width };
                assert!(wider >= -1e-14 * w, "{what}: width {w} {width}");
                assert!(peak < p * (1.0 + 1e-12), "{what}: peak {p} {peak}");
            }
            before = Some([settlement, width, peak]);
        }
    }
}

#[test]
fn the_smooth_answer_is_the_limit() {
    for case in &CASES {
        let (rough, smooth) = (case.solve(1e-6), case.solve(0.0));
        assert!((rough.settlement() - smooth.settlement()).abs() < 1e-4, "{}", case.name);
        assert!((rough.contact_width() - smooth.contact_width()).abs() < 1e-4, "{}", case.name);
        let [left, right] = smooth.zones()[0];
        let x = 0.4 * left + 0.6 * right;
        let (one, other) = (rough.pressure(x).unwrap(), smooth.pressure(x).unwrap());
        assert!((one - other).abs() < 1e-4, "{}: {one} {other}", case.name);
    }
}
