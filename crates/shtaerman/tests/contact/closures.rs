//! Bases given by closures against the same ones as formulas.

use shtaerman::{
    Contact, Elastic, Error, Foundation, Geometry, Grading, Load, Problem, Profile, Punch, Solver,
};
use shtaerman_random::Random;

fn on(foundation: Foundation, geometry: Geometry, profile: Profile, solver: Solver) -> Contact {
    let punch = Punch::in_geometry(geometry, 0.01).unwrap().with_profile(profile);
    let load = Load::force(2e4).unwrap();
    Problem::new(foundation, punch, load).unwrap().with_solver(solver).solve().unwrap()
}

/// Both agree to this share of the largest pressure and of the settlement, and the closure states no less.
#[track_caller]
fn agree(closure: &Contact, formula: &Contact, allowed: f64, what: &str) {
    let largest = formula.peak_pressure();
    let stated = closure.error().unwrap().pressure;
    for i in -20..=20 {
        let x = 0.01 * 0.0491 * f64::from(i);
        let [one, other] = [closure, formula].map(|contact| contact.pressure(x).unwrap());
        assert!((one - other).abs() <= allowed * largest, "{what} at {x}: {one} {other}");
    }
    assert!(stated <= 1e-3 * largest, "{what}: {stated:e}");
    let change = (closure.settlement() / formula.settlement() - 1.0).abs();
    assert!(change < allowed, "{what}: settlement {change:e}");
    assert_eq!(closure.zones().len(), formula.zones().len(), "{what}");
}

#[test]
fn closures_are_formulas_in_every_geometry() {
    let steel = Foundation::new(Elastic::new(200e9, 0.3).unwrap());
    let sand = Foundation::graded(Grading::new(0.3, 200e9).unwrap(), 0.3).unwrap();
    for (name, foundation, geometry, allowed) in [
        ("plane", steel.clone(), Geometry::Plane, 1e-10),
        ("pair", steel.clone(), Geometry::Pair { inner_half_gap: 0.002 }, 1e-9),
        ("row", steel.clone(), Geometry::Periodic { period: 0.05 }, 1e-10),
        ("disk", steel, Geometry::Circular, 1e-9),
        ("graded", sand, Geometry::Plane, 1e-8),
    ] {
        for roughness in [0.0, 1e-14] {
            let foundation = foundation.with_roughness(roughness).unwrap();
            let closure = Profile::from_fn(|x| x * x / (2.0 * 3.0));
            let formula = Profile::expression("x^2/(2*3)").unwrap();
            let [one, other] = [closure, formula]
                .map(|profile| on(foundation.clone(), geometry, profile, Solver::unilateral()));
            agree(&one, &other, allowed, &format!("{name}, roughness {roughness}"));
        }
    }
}

#[test]
fn kinks_are_where_they_are_said_to_be() {
    let steel = Foundation::new(Elastic::new(200e9, 0.3).unwrap()).with_roughness(1e-14).unwrap();
    let wedge = || Profile::from_fn(|x| 1e-3 * (x - 1e-3).abs()).with_breaks(vec![1e-3]).unwrap();
    let formula = || Profile::expression("1e-3*abs(x - 1e-3)").unwrap();
    for solver in [Solver::unilateral(), Solver::bilateral()] {
        let [one, other] =
            [wedge(), formula()].map(|profile| on(steel.clone(), Geometry::Plane, profile, solver));
        agree(&one, &other, 1e-9, &format!("{solver:?}"));
    }
    assert!(Profile::from_fn(f64::abs).with_breaks(vec![f64::NAN]).is_err());
}

#[test]
fn closures_say_what_they_lack() {
    let steel = Foundation::new(Elastic::new(200e9, 0.3).unwrap()).with_roughness(1e-14).unwrap();
    let profile = Profile::from_fn(|x| x * x);
    let contact = on(steel.clone(), Geometry::Plane, profile.clone(), Solver::unilateral());
    let audited = contact.audited().unwrap();
    let reason = audited.audited_by().unwrap().as_ref().unwrap_err().to_string();
    assert!(reason.contains("closure"), "{reason}");
    assert!(profile == profile.clone() && profile != Profile::from_fn(|x| x * x));
    let pole = Punch::new(0.01).unwrap().with_profile(Profile::from_fn(|x| 1.0 / x));
    let refused = Problem::new(steel.clone(), pole, Load::force(1.0).unwrap());
    assert!(matches!(refused, Err(Error::ProfileNotFinite { at: 0.0, .. })), "{refused:?}");
}

#[test]
fn problems_and_contacts_go_to_other_threads() {
    fn shared<T: Send + Sync + Clone>() {}
    shared::<Problem>();
    shared::<Contact>();
}

/// A table looked up by its owner may have nothing to say beyond the base: the last of many kinks, which are solved on panels, is 2e-7 of the base from its end.
#[test]
fn closures_are_not_asked_beyond_the_base() {
    let steel = Foundation::new(Elastic::new(200e9, 0.3).unwrap()).with_roughness(1e-10).unwrap();
    let mut kinks: Vec<f64> = (0..19).map(|k| -0.009 + 0.001 * f64::from(k)).collect();
    kinks.push(0.01 * (1.0 - 2e-7));
    let places = kinks.clone();
    let profile = Profile::from_fn(move |x: f64| {
        assert!(x.abs() <= 0.01, "asked at {x:e}");
        x * x / 6.0 + places.iter().map(|kink| 1e-5 * (x - kink).abs()).sum::<f64>()
    });
    let profile = profile.with_breaks(kinks).unwrap();
    let contact = on(steel, Geometry::Plane, profile, Solver::bilateral());
    assert_eq!(contact.method().name.to_string(), "panels");
}

/// Smooth waves, whose pressures follow from slopes: of a closure these are known by its heights only, and what that leaves is stated. Rings under a disk were off by up to 8,000 times as much.
#[test]
fn closures_of_waves_are_off_by_no_more_than_they_state() {
    let mut random = Random::new(90_117);
    let steel = Foundation::new(Elastic::new(200e9, 0.3).unwrap());
    for geometry in [Geometry::Circular, Geometry::Plane, Geometry::Periodic { period: 0.05 }] {
        for exponent in [None, Some(0.3)] {
            if exponent.is_some() && matches!(geometry, Geometry::Periodic { .. }) {
                continue;
            }
            for _ in 0..if exponent.is_some() { 4 } else { 12 } {
                let foundation = exponent.map_or(steel.clone(), |exponent| {
                    Foundation::graded(Grading::new(exponent, 200e9).unwrap(), 0.3).unwrap()
                });
                let (height, wave) =
                    (10f64.powf(random.between(-8.0, -6.0)), random.between(800.0, 4000.0));
                let shift =
                    if geometry == Geometry::Circular { 0.0 } else { random.between(0.0, 6.0) };
                let closure = Profile::from_fn(move |x| height * (wave * x + shift).cos());
                let formula = format!("{height:?}*cos({wave:?}*x + {shift:?})");
                let profiles = [closure, Profile::expression(&formula).unwrap()];
                let [one, other] = profiles
                    .map(|profile| on(foundation.clone(), geometry, profile, Solver::unilateral()));
                let stated = [&one, &other].map(|contact| contact.error().unwrap());
                let pressure = stated[0].pressure + stated[1].pressure;
                for zone in other.zones() {
                    for share in [0.3, 0.42, 0.5, 0.7] {
                        let x = zone[0] + share * (zone[1] - zone[0]);
                        let [a, b] = [&one, &other].map(|contact| contact.pressure(x).unwrap());
                        let off = (a - b).abs();
                        assert!(
                            off <= pressure,
                            "{geometry:?} {exponent:?} {formula} at {x}: {off:e} {stated:?}"
                        );
                    }
                }
                let settlement = stated[0].settlement + stated[1].settlement + 1e-14 * height;
                let off = (one.settlement() - other.settlement()).abs();
                assert!(
                    off <= settlement,
                    "{geometry:?} {exponent:?} {formula}: {off:e} {stated:?}"
                );
            }
        }
    }
}
