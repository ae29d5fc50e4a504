//! Stated bases that bend at many places: zigzags and traces.

use shtaerman::{
    Contact, Elastic, Foundation, Load, Problem, Profile, Punch, Rotational, Vertical,
};

use crate::support::close;

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
