//! Crowns and the limit of the peak pressure.

use crate::inverse::support::{bare, close, load, physical, unilateral};
use shtaerman::inverse::{InverseError, crown};
use shtaerman::{Error, Load, Profile, Rotational, Solver, Vertical};

#[test]
fn on_a_layer_alone_the_flat_base_is_best() {
    // P = 1: a flat base has 1/2 everywhere; p(0) = 1/2 + kappa/6 in full contact, (9 kappa/32)^(1/3) on a narrower zone.
    let problem = unilateral(0.0, "77*xi^4", load(1.0, 0.0));
    let found = crown(&problem, None).unwrap();
    assert_eq!(found.best.radius, None);
    close(found.best.contact.peak_pressure(), 0.5, 1e-12);
    assert_eq!(found.best.formula(), "0");
    for limit in [0.55, 0.7, 0.9, 3.0] {
        let found = crown(&problem, Some(limit)).unwrap();
        let full: f64 = 6.0 * (limit - 0.5);
        // Full contact while the edges carry: 1/2 - kappa/3 >= 0.
        let kappa = if full <= 1.5 { full } else { 32.0 * limit * limit * limit / 9.0 };
        close(found.least.unwrap().radius.unwrap(), 1.0 / kappa, 1e-9);
        assert_eq!(found.largest.unwrap().radius, None);
    }
}

#[test]
fn the_best_crown_is_between_edge_and_centre() {
    let problem = physical(200e9, 1.2e-14, 5e-3, "0", load(8e5, 0.0));
    let found = crown(&problem, None).unwrap();
    let best = found.best.radius.unwrap();
    let lowest = found.best.contact.peak_pressure();
    assert!(lowest > 80e6, "no pressure is more even than P/2a");
    let peak = |radius: f64| {
        let profile = Profile::expression(&format!("x^2/(2*{radius:e})")).unwrap();
        problem.with_profile(profile).unwrap().solve().unwrap().peak_pressure()
    };
    for share in [0.9, 0.999, 1.001, 1.1, 5.0] {
        assert!(peak(best * share) > lowest, "{share}");
    }
    // Within the limit between the two radii, beyond it outside.
    let limit = 1.05 * lowest;
    let found = crown(&problem, Some(limit)).unwrap();
    let (least, largest) =
        (found.least.unwrap().radius.unwrap(), found.largest.unwrap().radius.unwrap());
    assert!(least < best && best < largest);
    close(peak(least), limit, 1e-9);
    close(peak(largest), limit, 1e-9);
    assert!(peak(0.99 * least) > limit && peak(1.01 * least) < limit);
    assert!(peak(0.99 * largest) < limit && peak(1.01 * largest) > limit);
    // A limit above the peak of the flat base has no largest radius.
    let flat = peak(f64::MAX / 1e10);
    assert_eq!(crown(&problem, Some(1.01 * flat)).unwrap().largest.unwrap().radius, None);
}

#[test]
fn a_tight_limit_names_the_lowest_peak() {
    let problem = physical(200e9, 1.2e-14, 5e-3, "0", load(8e5, 400.0));
    let lowest = crown(&problem, None).unwrap().best.contact.peak_pressure();
    let error = crown(&problem, Some(0.99 * lowest)).unwrap_err();
    let Error::Inverse(InverseError::LimitTooLow { least, radius, .. }) = &error else {
        unreachable!("{error}")
    };
    assert!(*least == lowest && radius.is_some() && !error.is_numerical());
    assert!(error.to_string().contains("MPa"), "{error}");
}

#[test]
fn a_crown_needs_a_force() {
    let settled = Load::new(Vertical::Settlement(1.0), Rotational::Tilt(0.0)).unwrap();
    assert!(crown(&unilateral(1.0, "0", settled), None).is_err());
    for limit in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = crown(&unilateral(1.0, "0", load(1.0, 0.0)), Some(limit)).unwrap_err();
        assert!(matches!(error, Error::InvalidValue { .. }));
    }
    let pulled = bare(1.0, "0", load(-1.0, 0.0), Solver::bilateral());
    assert!(crown(&pulled, None).is_err());
}
