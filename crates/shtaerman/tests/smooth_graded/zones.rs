//! Several zones, plane.

use fredholm::quadrature::{double_exponential, gauss_power};
use shtaerman::{
    Contact, Elastic, Foundation, Geometry, Load, Problem, Profile, Punch, Rotational, Solver,
    Vertical,
};

use crate::smooth_graded::support::{Case, NU, close, piece};

const LEVEL: Rotational = Rotational::Moment(0.0);

/// The displacement at `x` by the kernel itself, over the pressures of all zones.
fn potential(case: &Case, contact: &Contact, kinks: &[f64], x: f64) -> f64 {
    let pressure = |s: f64, _: f64| contact.pressure(s).unwrap();
    let mut sum = 0.0;
    for zone in contact.zones() {
        let mut cuts = vec![zone[0], zone[1]];
        cuts.extend(kinks.iter().chain([&x]).filter(|at| zone[0] < **at && **at < zone[1]));
        cuts.sort_by(f64::total_cmp);
        let pairs = cuts.windows(2).map(|pair| [pair[0], pair[1]]);
        sum += pairs.map(|ends| piece(&pressure, ends, x, case.mu)).sum::<f64>();
    }
    case.line() * sum
}

/// Force and moment by quadrature.
fn resultants(contact: &Contact, kinks: &[f64]) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for zone in contact.zones() {
        let mut cuts = vec![zone[0], zone[1]];
        cuts.extend(kinks.iter().filter(|at| zone[0] < **at && **at < zone[1]));
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let half = 0.5 * (pair[1] - pair[0]);
            for node in double_exponential(150) {
                let at = pair[0] + half * node.from_left;
                let pressure = contact.pressure(at).unwrap();
                if pressure.is_finite() {
                    sums[0] += node.weight * half * pressure;
                    sums[1] += node.weight * half * pressure * at;
                }
            }
        }
    }
    sums
}

/// The kernel gives the base's depth on all zones, loads are met, and no gap is negative.
#[track_caller]
fn check(case: &Case, contact: &Contact, kinks: &[f64], zones: usize, what: &str) {
    let edges = contact.zones();
    assert_eq!(edges.len(), zones, "{what}: {edges:?}");
    let size = contact.settlement().abs();
    let allowed = 1e-10;
    for [left, right] in &edges {
        for share in [0.03, 0.31, 0.5, 0.84] {
            let x = left + share * (right - left);
            let error = potential(case, contact, kinks, x) - contact.base_depth(x);
            assert!(error.abs() < allowed * size, "{what} {x}: {error:e} of {size}");
        }
    }
    for pair in edges.windows(2) {
        for share in [0.01, 0.5, 0.9] {
            let x = pair[0][1] + share * (pair[1][0] - pair[0][1]);
            let error = potential(case, contact, kinks, x) - contact.elastic_displacement(x);
            assert!(error.abs() < allowed * size, "{what} {x}: {error:e} of {size}");
        }
    }
    let [force, moment] = resultants(contact, kinks);
    close(force, contact.force(), 1e-8, &format!("force, {what}"));
    let arm = contact.force() * case.half_width;
    assert!((moment - contact.moment()).abs() < 1e-8 * arm, "{what}: {moment}");
    assert!(contact.relative_error() < 1e-10, "{what}: {:?}", contact.dimensionless().error());
}

#[test]
fn waves_and_hollow_bases() {
    for (mu, profile, kinks, force, rotational, zones) in [
        (0.3, "cos(12*x)", &[][..], 1e-4, LEVEL, 2),
        (0.3, "(x^2 - 0.04)^2", &[], 1e-5, LEVEL, 2),
        (0.5, "(x^2 - 0.04)^2", &[], 1e-5, Rotational::Eccentricity(0.03), 2),
        (0.8, "x^2 + 0.02*cos(20*x)", &[], 0.0005, LEVEL, 2),
        (0.2, "abs(abs(x) - 0.3)/5", &[-0.3, 0.3], 0.004, LEVEL, 2),
        (0.6, "x^2/3 - 0.02*cos(25*x) + x/50", &[], 0.01, Rotational::Tilt(0.01), 3),
    ] {
        let case = Case { half_width: 0.5, ..Case::plane(mu) };
        let contact = case.solve(profile, Vertical::Force(force), rotational);
        check(&case, &contact, kinks, zones, profile);
        let left = contact.complementarity().unwrap();
        assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{profile} {left:?}");
    }
}

#[test]
fn waves_that_are_flat_are_one_zone() {
    let case = Case { half_width: 0.5, ..Case::plane(0.3) };
    let contact = case.press("1e-3*cos(12*x)", 1.0);
    assert_eq!(contact.zones(), [[-0.5, 0.5]]);
}

#[test]
fn pairs_of_punches() {
    for mu in [0.02, 0.2, 0.5, 0.8] {
        for (profile, solver, rotational) in [
            ("0", Solver::default(), LEVEL),
            ("0", Solver::bilateral(), Rotational::Eccentricity(0.2)),
            ("x^2/2", Solver::bilateral(), Rotational::Tilt(0.1)),
            ("x^2/2", Solver::default(), LEVEL),
        ] {
            let geometry = Geometry::Pair { inner_half_gap: 0.1 };
            let case = Case { geometry, solver, half_width: 0.5, ..Case::plane(mu) };
            let contact = case.solve(profile, Vertical::Force(0.05), rotational);
            check_pair(&case, &contact, profile);
        }
    }
}

/// The displacement at `x` in a zone by the kernel, by rules for the powers at corners, free ends and `x` itself: no place comes so close to a corner that rounding is felt.
fn smooth_potential(case: &Case, contact: &Contact, x: f64) -> f64 {
    const NODES: usize = 40;
    let mu = case.mu;
    let part = |from: f64, to: f64, exponent: f64| -> f64 {
        let rule = gauss_power(NODES, exponent).unwrap();
        let terms = rule.iter().map(|node| {
            let s = from + (to - from) * node.from_left;
            let distance = (x - s).abs();
            let value = contact.pressure(s).unwrap() * distance.powf(-mu);
            node.weight * node.from_left.powf(-exponent) * value
        });
        (to - from).abs() * terms.sum::<f64>()
    };
    let mut sum = 0.0;
    for ([left, right], intensities) in
        contact.zones().into_iter().zip(contact.corner_intensity().unwrap())
    {
        let [at_left, at_right] =
            intensities.map(|k| if k == 0.0 { 0.5 * (1.0 + mu) } else { 0.5 * (mu - 1.0) });
        if left < x && x < right {
            let [one, two] = [left, right].map(|end| 0.5 * (end + x));
            sum += part(left, one, at_left) + part(x, one, -mu);
            sum += part(right, two, at_right) + part(x, two, -mu);
        } else {
            let middle = 0.5 * (left + right);
            sum += part(left, middle, at_left) + part(right, middle, at_right);
        }
    }
    case.line() * sum
}

#[track_caller]
fn check_pair(case: &Case, contact: &Contact, what: &str) {
    let size = contact.settlement().abs();
    for [left, right] in contact.zones() {
        for share in [0.1, 0.5, 0.84] {
            let x = left + share * (right - left);
            let error = smooth_potential(case, contact, x) - contact.base_depth(x);
            let mu = case.mu;
            assert!(error.abs() < 1e-11 * size, "{mu} {what} {x}: {error:e} of {size}");
        }
    }
    assert!(contact.relative_error() < 1e-10, "{what}: {:?}", contact.dimensionless().error());
}

#[test]
fn one_zone_of_two_ways_is_the_same() {
    // A pair whose gap is below one end of a base that lifts there.
    let case = Case { half_width: 0.5, ..Case::plane(0.4) };
    let pair = Case { geometry: Geometry::Pair { inner_half_gap: 1e-3 }, ..case };
    let profile = "(x - 0.2)^2";
    let one = case.solve(profile, Vertical::Force(1e-3), LEVEL_AT);
    let two = pair.solve(profile, Vertical::Force(1e-3), LEVEL_AT);
    assert_eq!(two.zones().len(), 1);
    for (a, b) in one.zones()[0].into_iter().zip(two.zones()[0]) {
        close(a, b, 1e-12, "edge");
    }
    close(one.settlement(), two.settlement(), 1e-12, "settlement");
}

const LEVEL_AT: Rotational = Rotational::Tilt(0.0);

#[test]
fn little_grading_is_a_homogeneous_pair() {
    let geometry = Geometry::Pair { inner_half_gap: 0.3 };
    for (profile, force, rotational) in
        [("0", 1.0, Rotational::Moment(0.1)), ("x^2/2", 0.1, LEVEL), ("0.1*cos(9*x)", 0.02, LEVEL)]
    {
        let body = Elastic::new(1.0, NU).unwrap();
        let (foundation, punch) = (
            Foundation::new(body).with_roughness(0.0).unwrap(),
            Punch::in_geometry(geometry, 1.0).unwrap(),
        );
        let load = Load::new(Vertical::Force(force), rotational).unwrap();
        let base = Profile::expression(profile).unwrap();
        let plain =
            Problem::new(foundation, punch.with_profile(base), load).unwrap().solve().unwrap();
        let mut last = f64::INFINITY;
        for mu in [1e-2, 1e-3, 1e-4, 1e-5] {
            let case = Case { geometry, ..Case::plane(mu) };
            let graded = case.solve(profile, Vertical::Force(force), rotational);
            assert_eq!(graded.zones().len(), plain.zones().len());
            let mut error = 0.0f64;
            for [left, right] in plain.zones() {
                for share in [0.3, 0.6] {
                    let x = left + share * (right - left);
                    let share = graded.pressure(x).unwrap() / plain.pressure(x).unwrap();
                    error = error.max((share - 1.0).abs());
                }
            }
            assert!(error < 20.0 * mu && error < 0.2 * last, "{profile} {mu}: {error}");
            last = error;
        }
    }
}

#[test]
fn a_thin_layer_tends_to_none_in_several_zones() {
    let case = Case { half_width: 0.5, ..Case::plane(0.3) };
    let profile = "(x^2 - 0.04)^2";
    let (force, load) = (1e-4, Rotational::Eccentricity(0.02));
    let smooth = case.solve(profile, Vertical::Force(force), load);
    assert_eq!(smooth.zones().len(), 2);
    let mut last = f64::INFINITY;
    for chi in [1e-2, 1e-3, 1e-4] {
        let base = Profile::expression(profile).unwrap();
        let rough = case.problem(base, chi, Vertical::Force(force), load).solve().unwrap();
        let mut error = 0.0f64;
        for [left, right] in smooth.zones() {
            let x = 0.5 * (left + right);
            let share = rough.pressure(x).unwrap() / smooth.pressure(x).unwrap();
            error = error.max((share - 1.0).abs());
        }
        assert!(error < 0.25 * last, "{chi}: {error}");
        last = error;
    }
    assert!(last < 2e-3, "{last}");
}

/// A step leaves one half of the base clear: a flat base as wide as the other, moved aside. Where it lowers both outer parts, two flat bases carry the load.
#[test]
fn contact_ends_at_a_step() {
    let solved = |half_width: f64, base: &str, force: f64| {
        let case = Case { half_width, ..Case::plane(0.3) };
        let profile = Profile::expression(base).unwrap();
        case.problem(profile, 0.0, Vertical::Force(force), Rotational::Tilt(0.0)).solve().unwrap()
    };
    for base in ["0.3*step(x-0.5)", "where(x>0.5, 0.3, 0)", "0.1*x^0*step(x-0.5)"] {
        let stepped = solved(1.0, base, 0.016);
        let flat = solved(0.75, "0", 0.016);
        assert_eq!(stepped.zones(), [[-1.0, 0.5]], "{base}");
        close(stepped.settlement(), flat.settlement(), 1e-13, base);
        // The force acts in the middle of the flat base, at x = -0.25.
        close(stepped.moment(), -0.25 * 0.016, 1e-13, base);
        for x in [-0.9, -0.25, 0.3] {
            let pressure = |contact: &Contact, x: f64| contact.pressure(x).unwrap();
            close(pressure(&stepped, x), pressure(&flat, x + 0.25), 1e-12, base);
        }
        assert_eq!(stepped.pressure(0.7).unwrap(), 0.0, "{base}");
    }
    let raised = solved(1.0, "where(abs(x) < 0.5, 0.3, 0)", 0.016);
    assert_eq!(raised.zones(), [[-1.0, -0.5], [0.5, 1.0]]);
    let carried = raised.force();
    close(carried, 0.016, 1e-14, "force");
}
