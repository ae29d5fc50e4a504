//! What is refused, with a true reason.

use shtaerman::{Error, Geometry, Profile, Rotational, Vertical};

use crate::smooth_graded::support::Case;

const LEVEL: Rotational = Rotational::Moment(0.0);

#[test]
fn loads_that_no_pressure_balances() {
    for geometry in [Geometry::Plane, Geometry::Circular] {
        let case = Case { geometry, half_width: 0.2, ..Case::plane(0.3) };
        for force in [0.0, -2.0] {
            let error = case.attempt("x^2", Vertical::Force(force), LEVEL).unwrap_err();
            assert!(
                matches!(error, Error::InvalidValue { field: "force", value, .. } if value == force),
                "{error}"
            );
        }
        let error = case.attempt("x^2", Vertical::Settlement(-1.0), LEVEL).unwrap_err();
        assert!(matches!(error, Error::NoContact), "{error}");
    }
    let case = Case { half_width: 0.2, ..Case::plane(0.3) };
    let error = case.attempt("0", Vertical::Force(5.0), Rotational::Moment(1.1)).unwrap_err();
    assert!(
        matches!(error, Error::TipsOver { field: "moment", value, limit, .. } if value == 1.1 && limit == 1.0),
        "{error}"
    );
    let disk = Case { geometry: Geometry::Circular, ..case };
    let error = disk.attempt("0", Vertical::Force(5.0), Rotational::Moment(0.9)).unwrap_err();
    // P a/(3 + mu)
    assert!(
        matches!(error, Error::LiftsOff { limit, .. } if (limit * 3.3 - 1.0).abs() < 1e-9),
        "{error}"
    );
}

#[test]
fn rings_of_contact() {
    let case = Case { half_width: 0.5, ..Case::disk(0.3) };
    let error = case.attempt("(x^2 - 0.04)^2", Vertical::Force(1e-4), LEVEL).unwrap_err();
    let text = error.to_string();
    let Error::Rings { roughness: Some(roughness), .. } = error else { panic!("{text}") };
    let (_, told) = text.split_once("a small roughness instead of 0, such as ").expect(&text);
    assert_eq!(told.strip_suffix(" m/Pa").unwrap().parse(), Ok(roughness), "{text}");
    // With the roughness that is told there are answers, which change by little where it is a tenth of that, and by ten times less where it is a hundredth.
    let settled = |roughness: f64| {
        let profile = Profile::expression("(x^2 - 0.04)^2").unwrap();
        let rough = case.problem(profile, roughness, Vertical::Force(1e-4), LEVEL).solve().unwrap();
        // The ring on both sides of the axis.
        assert_eq!(rough.zones().len(), 2);
        rough.settlement()
    };
    let [one, two, three] = [1.0, 0.1, 0.01].map(|share| settled(share * roughness));
    assert!((one - two).abs() < 1e-3 * one.abs(), "{one} {two}");
    assert!((two - three).abs() < 0.15 * (one - two).abs(), "{one} {two} {three}");
}
