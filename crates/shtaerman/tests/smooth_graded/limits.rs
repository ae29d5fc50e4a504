//! What smooth contact on graded ground tends to, and what tends to it.

use shtaerman::{
    Elastic, Foundation, Geometry, Load, Problem, Profile, Punch, Rotational, Vertical,
};

use crate::smooth_graded::support::{Case, NU};

#[test]
fn little_grading_is_none() {
    for geometry in [Geometry::Plane, Geometry::Circular] {
        for (profile, force, moment) in
            [("0", 1.0, 0.1), ("x^2/2", 0.1, 0.0), ("abs(x)/2", 0.05, 0.0)]
        {
            let (vertical, rotational) = (Vertical::Force(force), Rotational::Moment(moment));
            let material = Elastic::new(1.0, NU).unwrap();
            let (foundation, punch) = (
                Foundation::new(material).with_roughness(0.0).unwrap(),
                Punch::in_geometry(geometry, 1.0).unwrap(),
            );
            let load = Load::new(vertical, rotational).unwrap();
            let base = Profile::expression(profile).unwrap();
            let plain =
                Problem::new(foundation, punch.with_profile(base), load).unwrap().solve().unwrap();
            let mut last = f64::INFINITY;
            for mu in [1e-2, 1e-3, 1e-4, 1e-5] {
                let case = Case { geometry, ..Case::plane(mu) };
                let graded = case.solve(profile, vertical, rotational);
                let share = |x: f64| {
                    let x = x * plain.zones()[0][1];
                    graded.pressure(x).unwrap() / plain.pressure(x).unwrap() - 1.0
                };
                let error = share(0.4).abs().max(share(-0.8).abs());
                assert!(error < 8.0 * mu && error < 0.2 * last, "{profile} {mu}: {error}");
                last = error;
            }
        }
    }
}

#[test]
fn a_thin_layer_tends_to_none() {
    for geometry in [Geometry::Plane, Geometry::Circular] {
        for (profile, force) in [("0", 1.0), ("x^2/2", 0.2)] {
            let case = Case { geometry, ..Case::plane(0.3) };
            let smooth = case.press(profile, force);
            let mut last = f64::INFINITY;
            for chi in [1e-2, 1e-3, 1e-4] {
                let base = Profile::expression(profile).unwrap();
                let load = (Vertical::Force(force), Rotational::Moment(0.0));
                let rough = case.problem(base, chi, load.0, load.1).solve().unwrap();
                let errors = [0.0, 0.3, 0.6].map(|y| {
                    let x = y * smooth.zones()[0][1];
                    (rough.pressure(x).unwrap() / smooth.pressure(x).unwrap() - 1.0).abs()
                });
                let error = errors.into_iter().fold(0.0, f64::max);
                assert!(error < 0.25 * last, "{profile} {chi}: {error}");
                last = error;
                let excess = rough.settlement() / smooth.settlement() - 1.0;
                assert!(excess > 0.0 && excess < 3.0 * chi, "{profile} {chi}: {excess}");
            }
            assert!(last < 1e-3, "{profile}: {last}");
        }
    }
}
