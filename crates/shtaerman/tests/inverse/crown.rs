//! Crowns and the limit of the peak pressure.

use crate::inverse::support::{bare, close, load, physical, unilateral};
use shtaerman::inverse::{InverseError, crown};
use shtaerman::{Error, Load, Problem, Profile, Rotational, Solver, Vertical};

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

/// Bilateral contact on a layer with a power law, which is refused where the edges of a sharp crown would pull.
fn kept(punch: &str, roughness: &str, load: &str) -> Problem {
    let toml = format!(
        "[foundation]\nyoung_modulus = 200e9\npoisson_ratio = 0.3\n{roughness}\n[punch]\n{punch}\nprofile = \"0\"\n[load]\n{load}\n[solver]\ncontact = \"bilateral\""
    );
    shtaerman::file::parse(&toml, "test").unwrap()
}

/// The peak pressure by a solve of its own, none where that is refused.
fn peak(problem: &Problem, radius: f64) -> Option<f64> {
    let profile = Profile::expression(&format!("x^2/(2*{radius:e})")).unwrap();
    Some(problem.with_profile(profile).unwrap().solve().ok()?.peak_pressure())
}

#[test]
fn the_best_crown_is_the_lowest_of_a_scan_where_sharper_ones_are_refused() {
    let strip = "half_width = 0.025";
    let disk = "geometry = \"circular\"\nradius = 0.039";
    for (punch, roughness, load) in [
        (
            strip,
            "roughness = { coefficient = 2.03e-12, exponent = 0.85 }",
            "force = 1.488e6\neccentricity = 0.0038",
        ),
        (strip, "roughness = { coefficient = 3e-10, exponent = 0.6 }", "force = 9e5\nmoment = 0"),
        (
            disk,
            "roughness = { coefficient = 3.1e-10, exponent = 0.5 }",
            "force = 21890\nmoment = 0",
        ),
    ] {
        let problem = kept(punch, roughness, load);
        let best = crown(&problem, None).unwrap().best;
        let (radius, lowest) = (best.radius.unwrap(), best.contact.peak_pressure());
        // Ten radii a decade over a decade and more on either side, and a hundred times as many nearby.
        let wide = (-15..=10).map(|k| 10f64.powf(f64::from(k) / 10.0));
        let scan: Vec<Option<f64>> = wide
            .chain((-10..=10).map(|k| 10f64.powf(f64::from(k) / 1000.0)))
            .map(|share| peak(&problem, radius * share))
            .collect();
        assert!(scan.iter().any(Option::is_none), "the sharp side is refused: {load}");
        let least = scan.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        assert!(least >= lowest * (1.0 - 1e-12), "{lowest} is not the lowest: {least}, {load}");
    }
}

#[test]
fn where_the_peak_falls_to_the_last_crown_that_can_be_solved_none_is_the_best() {
    let law = "roughness = { coefficient = 2.03e-12, exponent = 0.85 }";
    let strip = |load: &str| kept("half_width = 0.025", law, load);
    let refused = |problem: &Problem, limit: Option<f64>| {
        let error = crown(problem, limit).unwrap_err();
        assert!(error.is_numerical() && error.to_string().contains("unilateral"), "{error}");
        let Error::Inverse(InverseError::Unsolved { radius, peak, .. }) = error else {
            unreachable!("{error}")
        };
        (radius.unwrap(), peak)
    };
    // Loads far off the middle, and one whose limit is kept as far as can be solved.
    for eccentricity in [0.0075, 0.01] {
        let problem = strip(&format!("force = 1.488e6\neccentricity = {eccentricity}"));
        let (radius, lowest) = refused(&problem, None);
        assert_eq!(peak(&problem, radius * (1.0 - 1e-9)), None);
        close(peak(&problem, radius).unwrap(), lowest, 1e-12);
        for share in [1.0001, 1.01, 1.1, 2.0, 30.0] {
            assert!(peak(&problem, radius * share).unwrap() > lowest, "{share}");
        }
    }
    let problem = strip("force = 1.488e6\neccentricity = 0.0038");
    let best = crown(&problem, None).unwrap().best.radius.unwrap();
    let (radius, last) = refused(&problem, Some(6e7));
    assert!(radius < best && last < 6e7);
    assert_eq!(peak(&problem, radius * (1.0 - 1e-9)), None);
}
