//! Stated bases that bend at many places: zigzags and traces.

use shtaerman::{
    Contact, Elastic, Foundation, Load, Problem, Profile, Punch, Rotational, Vertical,
};

use crate::smooth::support::close;

fn solved(profile: Profile, vertical: Vertical, rotational: Rotational) -> Contact {
    let body = Elastic::new(2e11, 0.3).unwrap();
    let (foundation, punch) =
        (Foundation::new(body).with_roughness(0.0).unwrap(), Punch::new(0.01).unwrap());
    let load = Load::new(vertical, rotational).unwrap();
    Problem::new(foundation, punch.with_profile(profile), load).unwrap().solve().unwrap()
}

fn agree(one: &Contact, other: &Contact, tolerance: f64, what: &str) {
    assert_eq!(one.dimensionless().zones().len(), other.dimensionless().zones().len(), "{what}");
    for (a, b) in one
        .dimensionless()
        .zones()
        .iter()
        .flatten()
        .zip(other.dimensionless().zones().iter().flatten())
    {
        close(*a, *b, tolerance, what);
    }
    close(one.force(), other.force(), tolerance, what);
    close(one.settlement(), other.settlement(), tolerance, what);
}

#[test]
fn a_folded_sine_is_the_zigzag_of_its_straight_parts() {
    // On the base asin(sin(3 xi)) is max(-pi - 3 xi, min(3 xi, pi - 3 xi)).
    let profile = |formula: &str| Profile::expression(formula).unwrap();
    let zigzag = "1e-7*max(-pi - 3*xi, min(3*xi, pi - 3*xi))";
    for vertical in [Vertical::Settlement(2e-7), Vertical::Force(1e3), Vertical::Force(1e5)] {
        let of = |formula: &str| solved(profile(formula), vertical, Rotational::Tilt(0.0));
        let (folded, straight) = (of("1e-7*asin(sin(3*xi))"), of(zigzag));
        agree(&folded, &straight, 1e-11, &format!("{vertical:?}"));
        assert!(folded.relative_error() < 1e-9, "{:e}", folded.relative_error());
    }
}

#[test]
fn a_trace_is_as_exact_as_the_formula_it_was_taken_from() {
    // A cubic, which the spline through its points is: the formula is a short series, the trace has panels.
    let place = |i: i32| 2.0 * f64::from(i) / 60.0 - 1.0;
    let positions: Vec<f64> = (0..=60).map(|i| 0.01 * place(i)).collect();
    let height = |y: f64| 1e-5 * (y * y + 0.3 * y.powi(3));
    let heights = (0..=60).map(|i| height(place(i))).collect();
    let trace = Profile::from_points(positions, heights).unwrap();
    let formula = Profile::expression("1e-5*(xi^2 + 0.3*xi^3)").unwrap();
    for force in [1e4, 3e5] {
        let of = |profile: &Profile| {
            solved(profile.clone(), Vertical::Force(force), Rotational::Moment(0.0))
        };
        let (measured, known) = (of(&trace), of(&formula));
        agree(&measured, &known, 1e-10, &format!("{force}"));
        let reached = measured.relative_error();
        assert!(reached < 1e-10, "{reached:e}");
    }
}

/// A wedge that becomes steeper at `k`: `P = E* (s c + 2 t sqrt(c^2 - k^2))`, a load that grows as the root of the distance of the edge from the bend.
#[test]
fn an_edge_just_beyond_a_bend_is_found() {
    let (half_width, k, [s, t]) = (0.23, 0.069f64, [3e-3, 3.5e-3]);
    let modulus = 2e11 / (1.0 - 0.09);
    let body = Foundation::new(Elastic::new(2e11, 0.3).unwrap());
    let wedge = Profile::expression(&format!("{s}*abs(x) + {t}*(abs(x - {k}) + abs(x + {k}))"));
    let punch = Punch::new(half_width).unwrap().with_profile(wedge.unwrap());
    for beyond in [-1e-2f64, -1e-5, -1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 0.1, 1.0] {
        let c = k * (1.0 + beyond);
        let bent = if beyond > 0.0 { k * (beyond * (2.0 + beyond)).sqrt() } else { 0.0 };
        let force = modulus * (s * c + 2.0 * t * bent);
        for moment in [0.0, 1e-4 * force * k] {
            let load = Load::force(force).unwrap().with_moment(moment).unwrap();
            let contact = Problem::new(body.clone(), punch.clone(), load).unwrap().solve().unwrap();
            let zones = contact.zones();
            let [left, right] = zones[0];
            assert!(zones.len() == 1 && right > 0.0 && left < 0.0, "{beyond:e}: {zones:?}");
            if moment == 0.0 {
                let stated = contact.error().unwrap().zones.unwrap();
                for edge in [-left, right] {
                    assert!((edge - c).abs() <= stated + 1e-15 * c, "{beyond:e}: {edge} {c}");
                }
                // The pressure at an end at the distance `d` beyond the bend falls as `sqrt(d)`, which modes see late: at `1e-7` 1.05e-3 are stated (and 4e-6 are true), at `1e-6` 1.1e-5.
                let most = if beyond == 1e-7 { 2e-3 } else { 2e-5 };
                assert!(stated <= most * c, "{beyond:e}: {stated:e} stated");
            }
            close(contact.force(), force, 1e-9, "the load is carried");
        }
    }
}
