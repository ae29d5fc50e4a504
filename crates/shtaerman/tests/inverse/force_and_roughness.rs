//! Force and roughness from what they cause.

use crate::inverse::support::{HERTZ_FORCE, bare, close, load, parabola, physical, unilateral};
use shtaerman::inverse::{Goal, InverseError, force, roughness};
use shtaerman::{Error, Load, Rotational, Roughness, Solver, Vertical, file};

/// `chi E*/a_H`, `a/a_H`, `p/p_H` of the rough parabola.
const GOLDEN: [[f64; 3]; 3] = [
    [0.1, 1.0741908, 0.96991644],
    [1.0, 1.39306501, 0.802671925],
    [10.0, 2.43891775, 0.4768618686],
];

#[test]
fn a_layer_alone_has_closed_forms() {
    // f0 = c xi^2: half-width w = sqrt(q/c) under the peak q, P = 4/3 c w^3
    let c = 50.0;
    for start in [1e-3, 1.0, 4.0] {
        let problem = unilateral(0.0, "50*xi^2", load(start, 0.0));
        for q in [0.01, 0.7, 20.0] {
            let found = force(&problem, Goal::PeakPressure(q)).unwrap();
            close(found.value, 4.0 / 3.0 * c * (q / c).powf(1.5), 1e-11);
            assert!(found.relative_error() < 1e-11 && found.evaluations < 60);
        }
        for width in [1e-3f64, 0.3, 1.9] {
            let found = force(&problem, Goal::ContactWidth(width)).unwrap();
            close(found.value, 4.0 / 3.0 * c * (0.5 * width).powi(3), 1e-11);
        }
        // The least force that makes the full base touch; an edge this close to a corner rests on it.
        let found = force(&problem, Goal::ContactWidth(2.0)).unwrap();
        close(found.value, 4.0 / 3.0 * c, 1e-9);
        assert!((found.reached - 2.0).abs() < 1e-12);
    }
}

#[test]
fn the_golden_parabola_backwards() {
    let (hertz, peak) = (0.01, 2.0 * HERTZ_FORCE / (std::f64::consts::PI * 0.01));
    for [chi, width, pressure] in GOLDEN {
        let elsewhere = parabola(chi * hertz, 7.0 * HERTZ_FORCE);
        let width = Goal::ContactWidth(2.0 * hertz * width);
        let pressure = Goal::PeakPressure(peak * pressure);
        // The figures have nine digits; force goes with the square of what is given.
        close(force(&elsewhere, width).unwrap().value, HERTZ_FORCE, 3e-7);
        close(force(&elsewhere, pressure).unwrap().value, HERTZ_FORCE, 3e-7);
        let smoother = parabola(1e-3 * chi * hertz, HERTZ_FORCE);
        close(roughness(&smoother, width).unwrap().value, chi * hertz, 2e-6);
        close(roughness(&smoother, pressure).unwrap().value, chi * hertz, 2e-6);
    }
}

#[test]
fn an_infinite_corner_is_no_size() {
    // Hertz: p = sqrt(P/pi) for E* = R = 1 until the contact reaches the corners, at a/(2R) = 0.1; from there on the peak is infinite.
    let problem = parabola(0.0, HERTZ_FORCE);
    for peak in [0.03f64, 0.0999] {
        let found = force(&problem, Goal::PeakPressure(peak)).unwrap();
        close(found.value, std::f64::consts::PI * peak * peak, 1e-9);
        assert!(found.relative_error() < 1e-11);
    }
    for peak in [0.11, 1e30] {
        match force(&problem, Goal::PeakPressure(peak)) {
            Err(Error::Inverse(InverseError::Jump { at, below, above, .. })) => {
                close(at, std::f64::consts::PI * 0.01, 1e-9);
                close(below, 0.1, 1e-6);
                assert!(above.is_infinite());
            }
            other => panic!("{other:?}"),
        }
    }
    let flat = physical(1.0, 0.0, 1.0, "0", load(1.0, 0.0));
    let said = force(&flat, Goal::PeakPressure(1.0)).unwrap_err().to_string();
    assert!(said.contains("infinite whatever the force"), "{said}");
}

#[test]
fn roughness_behind_a_settlement() {
    // Nearly a layer alone: delta = chi P/(2a), chi E*/a = 1e7.
    let problem = physical(1e12 * (1.0 - 0.09), 1e-9, 1e-2, "0", load(3e5, 0.0));
    let chi = 1e-7;
    let found = roughness(&problem, Goal::Settlement(chi * 3e5 / 2e-2)).unwrap();
    close(found.value, chi, 1e-6);
    // A power law has its coefficient found: delta = B (P/2a)^kappa.
    let power = Roughness::power(1e-7, 0.5).unwrap();
    let problem = problem.with_roughness(power).unwrap();
    if let Ok(found) = roughness(&problem, Goal::Settlement(1e-3 * (3e5f64 / 2e-2).sqrt())) {
        close(found.value, 1e-3, 1e-5);
    }
}

#[test]
fn what_the_load_says_is_kept() {
    let moment = 800.0;
    let problem = physical(200e9, 1.2e-14, 5e-3, "x^2/(2*0.8)", load(8e5, moment));
    let found = force(&problem, Goal::PeakPressure(400e6)).unwrap();
    close(found.contact.moment() / found.contact.force(), moment / 8e5, 1e-14);
    close(found.contact.peak_pressure(), 400e6, 1e-11);
    assert_eq!(found.contact.force(), found.value);
    // A tilt stays.
    let tilted = Load::new(Vertical::Force(8e5), Rotational::Tilt(1e-4)).unwrap();
    let found = force(&problem.with_load(tilted).unwrap(), Goal::PeakPressure(400e6)).unwrap();
    assert_eq!(found.contact.tilt(), 1e-4);
    // A settlement in the file is only where the search begins.
    let settled = Load::new(Vertical::Settlement(1e-5), Rotational::Moment(0.0)).unwrap();
    let other = force(&problem.with_load(settled).unwrap(), Goal::PeakPressure(400e6)).unwrap();
    let centred = problem.with_load(load(8e5, 0.0)).unwrap();
    let same = force(&centred, Goal::PeakPressure(400e6)).unwrap();
    close(other.value, same.value, 1e-10);
}

#[test]
fn no_such_value_says_what_can_be_had() {
    let problem = unilateral(1.0, "4*xi^2", load(1.0, 0.0));
    let error = force(&problem, Goal::ContactWidth(2.5)).unwrap_err();
    let Error::Inverse(InverseError::NoSuchValue { least, most, wanted, .. }) = error else {
        unreachable!("{error}")
    };
    assert!(wanted == 2.5 && most == 2.0 && least < 1e-3, "{least} {most}");
    // A flat base touches everywhere or, off centre, on the same zone under any force.
    for moment in [0.0, 0.8] {
        let flat = unilateral(1.0, "0", load(1.0, moment));
        let error = force(&flat, Goal::ContactWidth(1e-3)).unwrap_err();
        assert!(error.to_string().contains("whatever the force"), "{error}");
    }
    // The settlement under this force is at least that of the smooth surface.
    let problem = physical(200e9, 1e-14, 5e-3, "0", load(8e5, 0.0));
    let smooth = 2.0 * 8e5 * 2f64.ln() / (std::f64::consts::PI * 200e9 / 0.91);
    let error = roughness(&problem, Goal::Settlement(0.5 * smooth)).unwrap_err();
    let Error::Inverse(InverseError::NoSuchValue { least, most, .. }) = error else {
        unreachable!("{error}")
    };
    close(least, smooth, 1e-6);
    assert!(most > 1e3 * smooth);
    assert!(!error_is_numerical(&problem));
}

fn error_is_numerical(problem: &shtaerman::Problem) -> bool {
    roughness(problem, Goal::Settlement(-1.0)).unwrap_err().is_numerical()
}

#[test]
fn a_width_may_jump() {
    // The middle step stands out by 1: when the outer ones come down, both sides touch at once.
    let problem = unilateral(0.0, "where(abs(xi) < 0.5, 0, 1)", load(0.5, 0.0));
    let error = force(&problem, Goal::ContactWidth(1.5)).unwrap_err();
    let Error::Inverse(InverseError::Jump { at, below, above, .. }) = error else {
        unreachable!("{error}")
    };
    close(at, 1.0, 1e-9);
    close(below, 1.0, 1e-9);
    close(above, 2.0, 1e-9);
}

#[test]
fn unsuited_problems_are_refused() {
    let problem = unilateral(1.0, "xi^2", load(1.0, 0.0));
    for goal in [
        Goal::PeakPressure(-1.0),
        Goal::PeakPressure(0.0),
        Goal::PeakPressure(f64::NAN),
        Goal::ContactWidth(f64::INFINITY),
        Goal::Settlement(f64::NAN),
    ] {
        for error in [force(&problem, goal).unwrap_err(), roughness(&problem, goal).unwrap_err()] {
            assert!(matches!(error, Error::InvalidValue { .. }), "{error}");
        }
    }
    assert!(force(&problem, Goal::Settlement(1.0)).is_err());
    assert!(roughness(&problem, Goal::ContactWidth(1.0)).is_err());
    let pulled = bare(1.0, "xi^2", load(-1.0, 0.0), Solver::bilateral());
    assert!(force(&pulled, Goal::PeakPressure(1.0)).is_err());
}

/// The least force under which the whole base touches is that with no least pressure: just below it the base lifts off, on smooth surfaces beside a gap between the places where an answer is looked at.
#[test]
fn the_whole_base_touches_from_where_the_least_pressure_is_zero() {
    let waves = "2.67e-7*cos(pi*x/0.005) + 8e-8*cos(2*pi*x/0.005 + 1)";
    for chi in [0.0, 1.2e-14] {
        let problem = physical(200e9, chi, 5e-3, waves, load(6.83e4, 0.0));
        let found = force(&problem, Goal::ContactWidth(1e-2)).unwrap();
        assert!(found.evaluations < 45, "{}", found.evaluations);
        let pressed = |share: f64| problem.with_force(share * found.value).unwrap();
        assert_eq!(found.contact.zones().len(), 1);
        let lifted = pressed(1.0 - 4e-4).solve().unwrap();
        let [left, right] = [lifted.zones()[0][1], lifted.zones()[1][0]];
        assert!(
            lifted.zones().len() == 2 && (0.0..2e-4).contains(&(right - left)),
            "{left} {right}"
        );
        // Kept in contact there it pulls about as much as the force falls short of.
        let bilateral = Solver::bilateral();
        let kept = pressed(1.0 - 4e-4).with_solver(bilateral).solve().unwrap();
        let pull = kept.pressure(0.5 * (left + right)).unwrap() / kept.mean_pressure();
        assert!((-8e-4..-8e-5).contains(&pull), "{pull}");
    }
    // Under a power law the least pressure begins as a power of the force: c p^k at the edge of a parabola.
    let law = Roughness::power(1e-11, 0.5).unwrap();
    let bent = physical(200e9, 1e-14, 5e-3, "x^2/(2*50)", load(1e6, 0.0)).with_roughness(law);
    let found = force(&bent.unwrap(), Goal::ContactWidth(1e-2)).unwrap();
    close(found.value, 66407.82503, 1e-9);
}

/// At ten times the load the zones come too close to a step; at twice the load, where the width is, they do not.
#[test]
fn what_cannot_be_solved_far_away_hides_nothing_nearby() {
    let text = r#"
        [foundation]
        young_modulus = 9.0505e9
        poisson_ratio = 0.121
        roughness = 0
        [punch]
        half_width = 3.87e-3
        profile = "2.029e-07*((x/0.00387)^2 + 0.182262*step(x-0.00211096))"
        [load]
        force = 32154
        tilt = -6.663e-5
    "#;
    let problem = file::parse(text, "test").unwrap();
    let wanted = 7.724_299_809_509_158e-3;
    assert!(problem.with_load(load_of(321_540.0)).unwrap().solve().is_err());
    let found = force(&problem, Goal::ContactWidth(wanted)).unwrap();
    let contact = problem.with_load(load_of(found.value)).unwrap().solve().unwrap();
    assert!((contact.contact_width() / wanted - 1.0).abs() < 1e-9, "{}", contact.contact_width());
}

fn load_of(force: f64) -> Load {
    Load::new(Vertical::Force(force), Rotational::Tilt(-6.663e-5)).unwrap()
}

#[test]
fn what_is_had_anyway_tells_nothing() {
    let flat = physical(200e9, 1e-14, 5e-3, "0", load(1e6, 0.0));
    let error = roughness(&flat, Goal::ContactWidth(10e-3)).unwrap_err().to_string();
    assert!(error.starts_with("a contact width of 10 mm tells no roughness"), "{error}");
}

/// Under an eccentric load the largest pressure falls with the roughness, to rise again: what lies between two decades is found, from wherever the search begins, and what can be had is told to its last digits.
#[test]
fn what_only_a_roughness_between_two_decades_has_is_found() {
    let at = |roughness: f64| {
        let text = format!(
            "[foundation]\nyoung_modulus = 2e11\npoisson_ratio = 0.3\nroughness = {roughness:e}\n[punch]\nhalf_width = 5e-3\nprofile = \"x^2/41.548\"\n[load]\nforce = 1.4005e5\neccentricity = 2e-4\n"
        );
        file::parse(&text, "test").unwrap()
    };
    let peak = |roughness: f64| at(roughness).solve().unwrap().peak_pressure();
    // By looking at ten roughnesses in each decade.
    let least =
        (0..30).map(|k| peak(10f64.powf(-14.5 + 0.1 * f64::from(k)))).fold(f64::INFINITY, f64::min);
    for start in [8.736_916_929_264_561e-14, 1e-13, 3e-13] {
        for wanted in [peak(1.0978e-13), peak(1.7e-13), least] {
            let found = roughness(&at(start), Goal::PeakPressure(wanted)).unwrap();
            let again = peak(found.value);
            assert!((again / wanted - 1.0).abs() < 1e-7, "{start:e} {wanted}: {found:?}");
        }
        let refused = roughness(&at(start), Goal::PeakPressure(0.5 * least));
        let Err(Error::Inverse(InverseError::NoSuchValue { least: told, .. })) = refused else {
            panic!("{refused:?}")
        };
        assert!(told <= least && told > 0.999 * least, "{told} {least}");
    }
}
