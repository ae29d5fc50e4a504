//! The linearised equation against differences of complete solves and closed forms.

use std::f64::consts::{LN_2, PI};

use crate::inverse::support::{bare, close, load};
use shtaerman::{
    Contact, Derivatives, Elastic, Foundation, Geometry, Grading, Load, Problem, Profile, Punch,
    Rotational, Roughness, Scaling, Sensitivities, Solver, Vertical,
};

const PLANE: Geometry = Geometry::Plane;
const DISK: Geometry = Geometry::Circular;
const WAVE: Geometry = Geometry::Periodic { period: 10e-3 };
const PARABOLA: &str = "x^2/(2*0.8)";
const CHI: f64 = 1.2e-12;

fn with(vertical: Vertical, rotational: Rotational) -> Load {
    Load::new(vertical, rotational).unwrap()
}

fn forced(force: f64, rotational: Rotational) -> Load {
    with(Vertical::Force(force), rotational)
}

fn settled(rotational: Rotational) -> Load {
    with(Vertical::Settlement(6e-6), rotational)
}

fn power() -> Roughness {
    Roughness::power(2e-10, 0.6).unwrap()
}

fn problem_by(
    geometry: Geometry,
    roughness: impl Into<Roughness>,
    profile: &str,
    load: Load,
    solver: Solver,
) -> Problem {
    let body = Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) = (
        Foundation::new(body).with_roughness(roughness).unwrap(),
        Punch::in_geometry(geometry, 5e-3).unwrap(),
    );
    Problem::new(foundation, punch.with_profile(Profile::expression(profile).unwrap()), load)
        .unwrap()
        .with_solver(solver)
}

fn problem(
    geometry: Geometry,
    roughness: impl Into<Roughness>,
    profile: &str,
    load: Load,
) -> Problem {
    problem_by(geometry, roughness, profile, load, Solver::default())
}

/// A derivative by the logarithm of its parameter.
struct Row {
    name: String,
    rate: f64,
    /// Size of the quantity.
    size: f64,
    /// Stated error, relative.
    error: f64,
}

fn rows(contact: &Contact, found: &Sensitivities) -> Vec<Row> {
    let problem = contact.problem();
    let roughness = match problem.scaling().map(Scaling::roughness) {
        Some(Roughness::Linear { compliance }) => compliance,
        Some(Roughness::Power { coefficient, .. }) => coefficient,
        _ => 0.0,
    };
    let graded = problem.foundation().grading().map(|grading| grading.modulus());
    let modulus = graded.or(problem.scaling().map(Scaling::pressure)).unwrap_or(0.0);
    let parts: [(&str, Option<Derivatives>, f64); 5] = [
        ("settlement", found.settlement, contact.settlement()),
        ("force", found.force, contact.force()),
        ("tilt", found.tilt, contact.settlement() / problem.punch().half_width()),
        ("pressure", found.peak_pressure, contact.peak_pressure()),
        ("width", Some(found.contact_width), contact.contact_width()),
    ];
    let mut rows = Vec::new();
    for (name, derivatives, size) in parts {
        let Some(d) = derivatives else { continue };
        for (by, rate, at) in [
            ("roughness", d.roughness, roughness),
            ("modulus", d.young_modulus, modulus),
            ("theta0", d.theta0, contact.theta0()),
            ("force", d.force, contact.force()),
            ("settlement", d.settlement, contact.settlement()),
        ] {
            rows.extend(rate.map(|rate| Row {
                name: format!("{name} by {by}"),
                rate: rate * at,
                size: size.abs(),
                error: d.error,
            }));
        }
    }
    rows
}

/// Both ways agree to what they state, and to `allowed` of the quantity or its change.
#[track_caller]
fn agree(problem: &Problem, allowed: f64) {
    let contact = problem.solve().unwrap();
    let tangent = contact.tangent_sensitivities().unwrap();
    let differences = contact.difference_sensitivities().unwrap();
    assert_eq!(contact.sensitivities().unwrap(), tangent);
    assert_eq!(tangent.held, differences.held);
    let (one, two) = (rows(&contact, &tangent), rows(&contact, &differences));
    assert_eq!(one.len(), two.len());
    for (one, two) in one.iter().zip(&two) {
        let scale = one.size.max(two.rate.abs());
        let gap = (one.rate - two.rate).abs() / scale;
        let stated = 3.0 * (one.error + two.error) + 1e-11;
        assert!(
            gap <= stated && gap <= allowed,
            "{}: {} {}, off {gap:.1e}, stated {:.0e} {:.0e}",
            one.name,
            one.rate,
            two.rate,
            one.error,
            two.error
        );
    }
}

#[test]
fn one_rough_zone() {
    let eccentric = forced(8e5, Rotational::Eccentricity(6e-4));
    let both = load(8e5, 300.0);
    for (roughness, profile, load) in [
        (1.2e-14, PARABOLA, load(8e5, 0.0)),
        (1.2e-14, "x^2/(2*80)", load(8e5, 0.0)),
        (CHI, PARABOLA, both),
        (CHI, "0", load(8e5, 2500.0)),
        (CHI, "abs(x)*2e-3", load(8e5, 100.0)),
        (CHI, PARABOLA, eccentric),
        (CHI, PARABOLA, settled(Rotational::Tilt(1e-4))),
        (CHI, PARABOLA, settled(Rotational::Moment(200.0))),
        (CHI, PARABOLA, settled(Rotational::Eccentricity(2e-4))),
    ] {
        agree(&problem(PLANE, roughness, profile, load), 2e-11);
    }
}

#[test]
fn a_layer_that_bends() {
    let both = load(8e5, 300.0);
    agree(&problem(PLANE, power(), PARABOLA, both), 2e-11);
    agree(&problem(PLANE, power(), "x^2/(2*80)", load(8e5, 0.0)), 2e-11);
    agree(&problem(PLANE, power(), PARABOLA, settled(Rotational::Tilt(1e-4))), 2e-11);
    agree(&problem(DISK, power(), PARABOLA, load(4e3, 0.0)), 2e-11);
    let wave = "1e-7*(1-cos(pi*(x/a-0.3)))";
    agree(&problem(WAVE, power(), wave, load(8e5, 0.0)), 2e-11);
    agree(&problem(WAVE, power(), wave, settled(Rotational::Tilt(0.0))), 2e-11);
    agree(&problem_by(PLANE, power(), "x^2/(2*80)", both, Solver::bilateral()), 2e-11);
    let steep = Roughness::power(1e-5, 0.1).unwrap();
    agree(&problem(PLANE, steep, PARABOLA, load(8e5, 100.0)), 2e-11);
}

#[test]
fn several_zones_and_rows() {
    let both = load(8e5, 300.0);
    agree(&problem(PLANE, CHI, "2e-6*cos(9*x/a) + x^2/20", load(2e5, 50.0)), 2e-11);
    agree(&problem(Geometry::Pair { inner_half_gap: 2e-3 }, CHI, "x^2/8", both), 2e-11);
    agree(&problem(Geometry::Periodic { period: 14e-3 }, CHI, PARABOLA, both), 2e-11);
    for height in ["8e-6", "1e-7"] {
        let profile = format!("{height}*(1-cos(pi*(x/a-0.3)))");
        agree(&problem(WAVE, CHI, &profile, load(8e5, 0.0)), 2e-11);
        agree(&problem(WAVE, CHI, &profile, settled(Rotational::Tilt(0.0))), 2e-11);
    }
}

/// Rings on a smooth surface, with kinks and without; those leave to the width what modes do not tell.
#[test]
fn smooth_rings() {
    for (profile, stated, off) in [
        ("2e-6*cos(3*pi*abs(x)/a + 1)", 2e-7, 2e-7),
        ("2e-6*cos(5*pi*x/a) + x^2/20", 2e-7, 2e-7),
        ("2e-6*abs(abs(x)/a - 0.4)", 0.3, 0.02),
        ("1e-6*abs(abs(x)/a - 0.3) + 1e-6*cos(4*pi*x/a)", 0.3, 0.02),
    ] {
        for load in [forced(300.0, Rotational::Moment(0.0)), settled(Rotational::Tilt(0.0))] {
            let problem = problem(DISK, Roughness::Smooth, profile, load);
            let contact = problem.solve().unwrap();
            let found = contact.tangent_sensitivities().unwrap();
            assert!(found.contact_width.error <= stated, "{profile}: {found:?}");
            agree(&problem, off);
        }
    }
}

/// A wave that is moved changes nothing, whether its crest lies within the period about the origin or its zone reaches beyond it.
#[test]
fn moved_waves_have_the_same_derivatives() {
    let rate = |centre: f64| {
        let shape = format!("4e-4*(1-cos(pi*(x/a-{centre}))+0.2*sin(2*pi*(x/a-{centre})))");
        let contact = problem(WAVE, CHI, &shape, load(8e5, 0.0)).solve().unwrap();
        contact.tangent_sensitivities().unwrap().peak_pressure.unwrap().force.unwrap()
    };
    let first = rate(0.2);
    for centre in [0.7, 1.1, 1.2, 1.3] {
        close(rate(centre), first, 2e-13);
    }
}

#[test]
fn rough_disks() {
    agree(&problem(DISK, CHI, PARABOLA, load(4e3, 0.0)), 2e-11);
    agree(&problem(DISK, CHI, "2e-6*cos(2*pi*x/a) + x^2/20", load(1e3, 0.0)), 2e-11);
    let shallow = "x^2/(2*80)";
    for load in [
        load(4e4, 20.0),
        forced(4e4, Rotational::Eccentricity(5e-4)),
        forced(4e4, Rotational::Tilt(1e-4)),
        settled(Rotational::Eccentricity(5e-4)),
        settled(Rotational::Tilt(1e-4)),
    ] {
        agree(&problem(DISK, CHI, shallow, load), 2e-11);
    }
}

#[test]
fn full_bases() {
    let both = load(8e5, 300.0);
    let on = |profile: &str, solver: Solver| problem_by(PLANE, CHI, profile, both, solver);
    agree(&on(PARABOLA, Solver::bilateral()), 2e-11);
    agree(&on("abs(x)*2e-3", Solver::bilateral()), 2e-11);
    // The degenerate kernel differs from the kernel by what its bound says.
    agree(&on(PARABOLA, Solver::spectral(200).unwrap()), 2e-8);
    agree(&on(PARABOLA, Solver::spectral(12).unwrap()), 1e-4);
    agree(&bare(3.0, "xi^2 - xi/2", load(2.0, 0.3), Solver::bilateral()), 2e-11);
    agree(&bare(3.0, "8*xi^2 - xi/2", load(2.0, 0.3), Solver::default()), 2e-11);
}

#[test]
fn smooth_contact() {
    let smooth = Roughness::Smooth;
    let both = load(8e5, 300.0);
    let of = |profile: &str, load: Load| problem(PLANE, smooth, profile, load);
    agree(&of("x^2/(2*0.8) + 4*x^4", both), 1e-10);
    agree(&of(PARABOLA, settled(Rotational::Tilt(1e-4))), 1e-10);
    agree(&of(PARABOLA, forced(8e5, Rotational::Eccentricity(2e-4))), 1e-10);
    agree(&of("0", both), 1e-10);
    agree(&of("0", load(8e5, 2500.0)), 1e-10);
    agree(&of("2e-6*cos(9*x/a) + x^2/20", load(2e5, 50.0)), 1e-10);
    let pair = Geometry::Pair { inner_half_gap: 2e-3 };
    agree(&problem(pair, smooth, "x^2/8", both), 1e-10);
    agree(&problem(Geometry::Periodic { period: 14e-3 }, smooth, PARABOLA, both), 1e-10);
    let wave = "8e-6*(1-cos(pi*(x/a-0.3)))";
    agree(&problem(WAVE, smooth, wave, load(8e5, 0.0)), 1e-10);
    agree(&problem(WAVE, smooth, wave, settled(Rotational::Tilt(0.0))), 1e-10);
    agree(&problem(WAVE, smooth, "1e-7*(1-cos(pi*x/a))", load(8e5, 0.0)), 1e-10);
    // Differences of a disk's pressure have a few digits less.
    agree(&problem(DISK, smooth, "x^2/(2*0.8) + 300*x^4", load(4e3, 0.0)), 1e-8);
    agree(&problem(DISK, smooth, "0", load(4e4, 10.0)), 1e-10);
    agree(&problem(DISK, smooth, PARABOLA, settled(Rotational::Tilt(0.0))), 1e-8);
}

#[test]
fn elastic_punches_and_graded_bodies() {
    let profile = || Profile::expression(PARABOLA).unwrap();
    for roughness in [1e-13, 0.0] {
        let (one, two) = (Elastic::new(200e9, 0.3).unwrap(), Elastic::new(70e9, 0.33).unwrap());
        let (foundation, punch) = (
            Foundation::new(one).with_roughness(roughness).unwrap(),
            Punch::new(5e-3).unwrap().with_body(two),
        );
        let problem =
            Problem::new(foundation, punch.with_profile(profile()), load(8e5, 100.0)).unwrap();
        agree(&problem, 1e-10);
    }
    for (geometry, force) in [(PLANE, 1e5), (DISK, 1e3)] {
        let grading = Grading::new(0.3, 2e11).unwrap();
        let (foundation, punch) = (
            Foundation::graded(grading, 0.3).unwrap().with_roughness(1e-13).unwrap(),
            Punch::in_geometry(geometry, 5e-3).unwrap(),
        );
        let problem =
            Problem::new(foundation, punch.with_profile(profile()), load(force, 0.0)).unwrap();
        agree(&problem, 1e-9);
        // By the modulus at the depth of 1 m, as it is stated.
        let settled = |modulus: f64| {
            let ground = Foundation::graded(Grading::new(0.3, modulus).unwrap(), 0.3).unwrap();
            let ground = ground.with_roughness(1e-13).unwrap();
            problem.with_foundation(ground).unwrap().solve().unwrap()
        };
        let quotient = (settled(2.001e11).settlement() - settled(1.999e11).settlement()) / 2e8;
        let contact = settled(2e11);
        let by = |found: Sensitivities| found.settlement.unwrap().young_modulus.unwrap();
        close(by(contact.sensitivities().unwrap()), quotient, 1e-6);
        close(by(contact.difference_sensitivities().unwrap()), quotient, 1e-6);
        let stiffer = problem.with_young_modulus(2.001e11).unwrap().solve().unwrap();
        assert_eq!(stiffer.settlement(), settled(2.001e11).settlement());
    }
}

#[test]
fn corners_on_steeply_graded_ground() {
    // The pressure goes as d^(1-mu) at the corner, where it is largest: no double is near enough to it for that.
    for geometry in [PLANE, DISK] {
        let grading = Grading::new(0.8, 2e11).unwrap();
        let (foundation, punch) = (
            Foundation::graded(grading, 0.3).unwrap().with_roughness(1e-15).unwrap(),
            Punch::in_geometry(geometry, 5e-3).unwrap(),
        );
        let flat = Profile::expression("0").unwrap();
        let problem = Problem::new(foundation, punch.with_profile(flat), load(1e4, 0.0)).unwrap();
        let contact = problem.solve().unwrap();
        assert!(contact.tangent_sensitivities().is_none());
        // Of a thin layer the pressure at the corner goes as chi^(-1/2).
        let by = contact.difference_sensitivities().unwrap().peak_pressure.unwrap();
        close(by.roughness.unwrap() * 1e-15, -0.5 * contact.peak_pressure(), 1e-2);
    }
}

#[test]
fn hertz_has_powers_of_force_and_modulus() {
    // Line: p ~ (P E)^(1/2), a ~ (P/E)^(1/2); delta = theta P (ln(2 A/a) + 1/2) in the gauge of the half-width A. Ball: p ~ (P E^2)^(1/3), a ~ (P/E)^(1/3), delta ~ (P/E)^(2/3).
    for (geometry, force, pressure, width) in [
        (PLANE, 8e5, [0.5, 0.5], [0.5, -0.5]),
        (DISK, 4e3, [1.0 / 3.0, 2.0 / 3.0], [1.0 / 3.0, -1.0 / 3.0]),
    ] {
        let contact = problem(geometry, 0.0, PARABOLA, load(force, 0.0)).solve().unwrap();
        let found = contact.tangent_sensitivities().unwrap();
        let exponents = |d: Derivatives, value: f64| {
            assert_eq!(d.roughness, None);
            [d.force.unwrap() * force / value, d.young_modulus.unwrap() * 200e9 / value]
        };
        let settlement = if geometry == DISK {
            [2.0 / 3.0, -2.0 / 3.0]
        } else {
            let half = 0.5 * contact.contact_width();
            let logarithm = (2.0 * 5e-3 / half).ln();
            [logarithm / (logarithm + 0.5), -logarithm / (logarithm + 0.5)]
        };
        let peak = contact.peak_pressure();
        for (found, exact) in [
            (exponents(found.peak_pressure.unwrap(), peak), pressure),
            (exponents(found.contact_width, contact.contact_width()), width),
            (exponents(found.settlement.unwrap(), contact.settlement()), settlement),
        ] {
            close(found[0], exact[0], 2e-11);
            close(found[1], exact[1], 2e-11);
        }
    }
}

#[test]
fn a_flat_punch_goes_from_body_to_layer() {
    // delta = P (theta ln 2 + ..) on a thin layer, P (chi/(2a) + ..) on a thick one.
    let theta = 2.0 * (1.0 - 0.3 * 0.3) / (PI * 200e9);
    let by = |chi: f64| {
        let contact = problem(PLANE, chi, "0", load(8e5, 0.0)).solve().unwrap();
        contact.tangent_sensitivities().unwrap().settlement.unwrap()
    };
    close(by(1e-19).force.unwrap(), theta * LN_2, 3e-5);
    close(by(1e-6).roughness.unwrap(), 8e5 / (2.0 * 5e-3), 1e-6);
    // The uniform pressure P/(2a) settles the body by theta P (3/2 - ln 2) on average.
    let elastic = -theta / 200e9 * 8e5 * (1.5 - LN_2);
    close(by(1e-6).young_modulus.unwrap(), elastic, 1e-6);
}

#[test]
fn a_layer_alone_has_powers() {
    // p^kappa = delta - c xi^2: P ~ delta^(1/kappa + 1/2), p ~ delta^(1/kappa), width ~ delta^(1/2).
    for exponent in [0.3, 0.7, 1.0] {
        let (foundation, punch) = (
            Foundation::dimensionless(0.0).unwrap().with_exponent(exponent).unwrap(),
            Punch::new(1.0).unwrap(),
        );
        let profile = Profile::expression("50*xi^2").unwrap();
        let problem =
            Problem::new(foundation, punch.with_profile(profile), load(0.5, 0.0)).unwrap();
        let contact = problem.solve().unwrap();
        let found = contact.tangent_sensitivities().unwrap();
        let order = 1.0 / exponent + 0.5;
        let power = |d: Derivatives, value: f64| d.force.unwrap() * 0.5 / value;
        close(power(found.settlement.unwrap(), contact.settlement()), 1.0 / order, 1e-11);
        let peak = contact.peak_pressure();
        close(power(found.peak_pressure.unwrap(), peak), 1.0 / (exponent * order), 1e-11);
        close(power(found.contact_width, contact.contact_width()), 0.5 / order, 1e-11);
        assert_eq!(found.settlement.unwrap().theta0, None);
    }
}

#[test]
fn a_wave_in_full_contact_has_a_closed_derivative() {
    // int K cos(pi eta) deta = cos(pi xi), so p0 = P/2 + cos(pi xi) h/(1 + theta0).
    let (theta0, height) = (1.7, 0.2);
    let (foundation, punch) = (
        Foundation::dimensionless(theta0).unwrap(),
        Punch::in_geometry(Geometry::Periodic { period: 2.0 }, 1.0).unwrap(),
    );
    let profile = Profile::expression("-0.2*cos(pi*xi)").unwrap();
    let problem = Problem::new(foundation, punch.with_profile(profile), load(1.0, 0.0)).unwrap();
    let found = problem.solve().unwrap().tangent_sensitivities().unwrap();
    let pressure = found.peak_pressure.unwrap();
    close(pressure.theta0.unwrap(), -height / (1.0 + theta0).powi(2), 1e-12);
    close(pressure.force.unwrap(), 0.5, 1e-14);
    assert_eq!(found.settlement.unwrap().theta0, Some(0.0));
    assert_eq!(found.contact_width.theta0, Some(0.0));
}

#[test]
fn a_pressure_without_a_largest_value_has_no_derivative() {
    for (geometry, profile) in [(PLANE, "abs(x)*2e-3"), (DISK, "abs(x)*2e-3"), (PLANE, "0")] {
        let problem = problem(geometry, 0.0, profile, load(4e3, 0.0));
        let contact = problem.solve().unwrap();
        let found = contact.tangent_sensitivities().unwrap();
        assert!(found.peak_pressure.is_none() && found.settlement.is_some());
        assert!(contact.difference_sensitivities().unwrap().peak_pressure.is_none());
    }
}

/// The derivative by the logarithm of the scale of the profile, against differences of complete solves.
#[test]
fn the_scale_of_the_profile_is_a_parameter_like_others() {
    let eccentric = Rotational::Eccentricity(4e-4);
    let (moment, tilt) = (Rotational::Moment(200.0), Rotational::Tilt(-2e-5));
    for (geometry, roughness, load) in [
        (PLANE, Roughness::from(CHI), forced(0.5e6, moment)),
        (PLANE, Roughness::from(CHI), forced(0.5e6, eccentric)),
        (PLANE, Roughness::from(CHI), settled(tilt)),
        (PLANE, power(), forced(0.5e6, moment)),
        (PLANE, power(), settled(moment)),
        (PLANE, Roughness::Smooth, forced(0.5e6, moment)),
        (PLANE, Roughness::Smooth, settled(tilt)),
        (DISK, Roughness::from(CHI), forced(2e3, Rotational::Moment(0.0))),
        (DISK, power(), settled(Rotational::Moment(0.0))),
    ] {
        let at = |scale: f64| {
            let profile = format!("{scale:e}*({PARABOLA} + 0.2*x^2*xi)");
            let profile =
                if geometry == DISK { format!("{scale:e}*({PARABOLA})") } else { profile };
            problem(geometry, roughness, &profile, load).solve().unwrap()
        };
        let contact = at(1.0);
        let found = contact.tangent_sensitivities().unwrap();
        let h = 1e-3;
        let quotient = |of: fn(&Contact) -> f64| {
            let central = |h: f64| (of(&at(1.0 + h)) - of(&at(1.0 - h))) / (2.0 * h);
            (4.0 * central(h) - central(2.0 * h)) / 3.0
        };
        let a = contact.problem().punch().half_width();
        for (derivatives, of, size) in [
            (found.settlement, Contact::settlement as fn(&Contact) -> f64, contact.settlement()),
            (found.force, Contact::force, contact.force()),
            (found.tilt, Contact::tilt, contact.settlement() / a),
            (found.peak_pressure, Contact::peak_pressure, contact.peak_pressure()),
            (Some(found.contact_width), Contact::contact_width, contact.contact_width()),
        ] {
            let Some(derivatives) = derivatives else { continue };
            let rate = derivatives.profile.unwrap();
            // The differences leave h^4 times a fifth derivative, and the rounding of a solve over h.
            let allowed = (derivatives.error + 2e-9) * size.abs().max(rate.abs());
            let off = (rate - quotient(of)).abs();
            assert!(off <= allowed, "{geometry:?} {roughness:?} {load:?}: {rate:e}, {off:e} off");
        }
    }
}

#[test]
fn the_largest_pressure_beside_a_bend() {
    let text = |tolerance: f64| {
        format!(
            "[foundation]\nyoung_modulus = 4.0962e9\npoisson_ratio = 0.3\nroughness = 2.9113e-9\n[punch]\ngeometry = \"periodic\"\nhalf_width = 0.53054\nperiod = 2.40029\nprofile = \"0.000140255*(x/0.53054)^2 + 6.74223e-5*max(0, x/0.53054 - 0.2207947)^2\"\n[load]\nforce = 462574.666\neccentricity = 0.00490069\n[solver]\ntolerance = {tolerance:e}\n"
        )
    };
    // The place is known to a few digits from few nodes, and lies within a step of the differences from where the base bends.
    let solved = |tolerance| shtaerman::file::parse(&text(tolerance), "test").unwrap().solve();
    let [rough, fine] = [1e-6, 1e-13].map(|tolerance| {
        let contact = solved(tolerance).unwrap();
        let found = contact.tangent_sensitivities().unwrap().peak_pressure.unwrap();
        (contact.peak_pressure_at(), contact.peak_pressure(), found)
    });
    let bend = 0.53054 * 0.2207947;
    assert!((fine.0 - bend).abs() < 2e-3 && fine.0 != bend, "{}", fine.0);
    let [one, two] =
        [&rough, &fine].map(|(_, peak, found)| 462574.666 * found.force.unwrap() / peak);
    let stated = rough.2.error + fine.2.error;
    assert!((one - two).abs() <= stated * one.abs().max(1.0), "{one} {two} {stated:e}");
    assert!(one != two && stated < 1e-6, "{one} {two} {stated:e}");
}

/// On graded ground the slope beside an end changes as a power of the distance: an end off by 5e-15 moves the rate of a width by 2e-10 of it.
#[test]
fn the_width_on_graded_ground() {
    let text = |tolerance: f64| {
        format!(
            "[foundation]\ngrading_exponent = 0.3\ngrading_modulus = 2216232010.7485943\npoisson_ratio = 0.3\nroughness = 1.2737129764157445e-09\n[punch]\ngeometry = \"pair\"\nouter_half_width = 1.0\ninner_half_gap = 0.6048730566563975\nprofile = \"0.001085770664893205*(cosh(x)-1) + 3.0275506293486488e-05*cos(10.944641187272838*x+1.1662127081907638)\"\n[load]\nsettlement = 0.0006823514946591457\neccentricity = 0\n[solver]\ntolerance = {tolerance:e}\n"
        )
    };
    let [rough, fine] = [1e-12, 1e-13].map(|tolerance| {
        let contact = shtaerman::file::parse(&text(tolerance), "test").unwrap().solve().unwrap();
        let found = contact.tangent_sensitivities().unwrap().contact_width;
        (contact.contact_width(), found)
    });
    let of = |(width, found): &(f64, Derivatives)| {
        0.0006823514946591457 * found.settlement.unwrap() / width
    };
    let (one, two, stated) = (of(&rough), of(&fine), rough.1.error + fine.1.error);
    assert!((one - two).abs() <= stated * one.abs().max(1.0), "{one} {two} {stated:e}");
    assert!(stated < 1e-8, "{stated:e}");
}
