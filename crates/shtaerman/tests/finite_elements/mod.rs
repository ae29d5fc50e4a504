//! Tables for finite-element models against sensitivities, closed forms and solves of their own.
#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use shtaerman::finite_elements::{LoadCurve, Penalty, force_curve, moment_curve};
use shtaerman::{
    Datum, Elastic, Error, Foundation, Grading, Load, Problem, Profile, Punch, Rotational,
    Roughness, Solver, Vertical,
};

const HALF_WIDTH: f64 = 5e-3;

fn steel(roughness: impl Into<Roughness>) -> Foundation {
    Foundation::new(Elastic::new(200e9, 0.3).unwrap()).with_roughness(roughness).unwrap()
}

fn on(foundation: Foundation, punch: Punch, profile: &str, load: Load) -> Problem {
    let punch = punch.with_profile(Profile::expression(profile).unwrap());
    Problem::new(foundation, punch, load).unwrap()
}

fn plane(roughness: impl Into<Roughness>, profile: &str, load: Load) -> Problem {
    on(steel(roughness), Punch::new(HALF_WIDTH).unwrap(), profile, load)
}

fn force(force: f64) -> Load {
    Load::force(force).unwrap()
}

/// The displacement that straight lines give under a load.
fn interpolated(curve: &LoadCurve, load: f64) -> f64 {
    let points = &curve.points;
    let above = points.partition_point(|point| point[1] < load).clamp(1, points.len() - 1);
    let [[u0, p0], [u1, p1]] = [points[above - 1], points[above]];
    u0 + (u1 - u0) * (load - p0) / (p1 - p0)
}

/// A linear layer and a penalty in series are one linear layer, so `w` is the derivative of the settlement by `chi`, which the linearised equation gives.
#[test]
fn the_penalty_is_the_sensitivity_to_a_linear_layer() {
    let chi = 1.2e-14;
    let graded = Foundation::graded(Grading::new(0.3, 60e9).unwrap(), 0.25).unwrap();
    let problems = [
        plane(chi, "0", force(8e5)),
        plane(chi, "x^2/(2*2)", force(8e5)),
        plane(chi, "0", force(8e5).with_moment(1500.0).unwrap()),
        plane(chi, "x^2/(2*2)", force(8e5).with_eccentricity(1e-3).unwrap()),
        plane(chi, "x^2/(2*2)", force(8e5).with_tilt(2e-4).unwrap()),
        plane(chi, "x^2/(2*2)", Load::settlement(5e-6).unwrap()),
        on(steel(chi), Punch::pair(HALF_WIDTH, 2e-3).unwrap(), "x^2/(2*20)", force(8e5)),
        on(steel(chi), Punch::periodic(HALF_WIDTH, 15e-3).unwrap(), "x^2/(2*2)", force(8e5)),
        // A wave that is not its own mirror image, in touch at its crests.
        on(
            steel(chi),
            Punch::periodic(HALF_WIDTH, 2.0 * HALF_WIDTH).unwrap(),
            "4e-6*cos(pi*x/a) + 1e-6*sin(2*pi*x/a)",
            force(8e5),
        ),
        on(steel(chi), Punch::circular(HALF_WIDTH).unwrap(), "x^2/(2*2)", force(6e3)),
        on(
            steel(chi),
            Punch::circular(HALF_WIDTH).unwrap(),
            "0",
            force(6e3).with_moment(5.0).unwrap(),
        ),
        on(
            graded.with_roughness(chi).unwrap(),
            Punch::new(HALF_WIDTH).unwrap(),
            "x^2/(2*2)",
            force(8e5),
        ),
    ];
    for (index, problem) in problems.iter().enumerate() {
        let contact = problem.solve().unwrap();
        let penalty = Penalty::new(&contact, 1e-2, None).unwrap();
        // Of a prescribed settlement the force under which it is prescribed.
        let held = problem.with_force(contact.force()).unwrap();
        let derivatives = held.solve().unwrap().sensitivities().unwrap().settlement.unwrap();
        let exact = derivatives.roughness.unwrap();
        let off = penalty.mean_pressure / exact - 1.0;
        assert!(off.abs() < 2e-6, "{index}: {} for {exact}", penalty.mean_pressure);
        // And the stiffness does what it says, to first order in the share.
        let series = steel_with(&held, chi + 1.0 / penalty.stiffness).solve().unwrap();
        let rise = (series.settlement() - contact.settlement()) / penalty.settlement;
        assert!((rise / 1e-2 - 1.0).abs() < 0.02, "{index}: {rise}");
    }
}

fn steel_with(problem: &Problem, chi: f64) -> Problem {
    problem.with_roughness(chi).unwrap()
}

/// A layer so soft that the body is rigid beside it spreads the force evenly under a flat base.
#[test]
fn on_a_soft_layer_the_weighted_mean_is_the_mean() {
    let law = Roughness::power(1e-5, 0.3).unwrap();
    let contact = plane(law, "0", force(8e5)).solve().unwrap();
    let penalty = Penalty::new(&contact, 1e-3, None).unwrap();
    assert!((penalty.mean_pressure / contact.mean_pressure() - 1.0).abs() < 1e-4);
    assert!((penalty.settlement / contact.settlement() - 1.0).abs() < 1e-12);
    // `k w = share delta`
    let share = penalty.mean_pressure / penalty.stiffness / penalty.settlement;
    assert!((share / 1e-3 - 1.0).abs() < 1e-12);
}

/// Hertz's line contact on a smooth surface: half-width `c^2 = 4 P R/(pi E*)`, `delta = theta P (ln(2 a/c) + 1/2)`.
#[test]
fn the_force_curve_of_a_smooth_crown_is_that_of_hertz() {
    let (radius, share) = (2.0, 1e-4);
    let problem = plane(0.0, "x^2/(2*2)", force(8e5));
    let curve = force_curve(&problem, 1.0, share, None).unwrap();
    let modulus = 200e9 / (1.0 - 0.09);
    let theta = 2.0 / (std::f64::consts::PI * modulus);
    let exact = |force: f64| {
        let half_width = (4.0 * force * radius / (std::f64::consts::PI * modulus)).sqrt();
        theta * force * ((2.0 * HALF_WIDTH / half_width).ln() + 0.5)
    };
    assert_eq!(curve.points[0], [0.0, 0.0]);
    for [settlement, force] in &curve.points[1..] {
        assert!((settlement / exact(*force) - 1.0).abs() < 1e-9, "{force}");
    }
    let range = exact(8e5);
    for step in 1..=1000 {
        let force = 8e5 * f64::from(step) / 1000.0;
        let off = (interpolated(&curve, force) - exact(force)).abs() / range;
        assert!(off <= share, "{force}: {off}");
    }
}

/// Between all points the lines are as near to solves of their own as is stated, whatever holds the punch.
#[test]
fn force_curves_are_near_to_solves_between_their_points() {
    let power = Roughness::power(1e-9, 0.4).unwrap();
    let steep = Roughness::power(6e-8, 0.17).unwrap();
    let share = 2e-3;
    let cases = [
        (plane(1.2e-14, "0", force(8e5)), None),
        (plane(power, "x^2/(2*2) + 1e-5", force(8e5)), Some(Datum::Distance(0.5))),
        (plane(steep, "x^2/(2*20)", force(8e5)), Some(Datum::Depth(0.05))),
        (plane(1.2e-14, "x^2/(2*2)", force(8e5).with_eccentricity(2e-3).unwrap()), None),
        (plane(1.2e-14, "x^2/(2*2)", force(8e5).with_tilt(1e-3).unwrap()), None),
        (on(steel(power), Punch::circular(HALF_WIDTH).unwrap(), "x^2/(2*2)", force(6e3)), None),
        (
            on(
                steel(1.2e-14),
                Punch::periodic(HALF_WIDTH, 2.0 * HALF_WIDTH).unwrap(),
                "4e-6*cos(pi*x/a) + 1e-6*sin(2*pi*x/a)",
                force(8e5),
            ),
            None,
        ),
    ];
    for (index, (problem, datum)) in cases.iter().enumerate() {
        let own = problem.solve().unwrap();
        let curve = force_curve(problem, 1.5, share, *datum).unwrap();
        assert!(curve.deviation <= share && curve.relative_error < 1e-8, "{index}: {curve:?}");
        let [last, largest] = *curve.points.last().unwrap();
        assert!((largest / (1.5 * own.force()) - 1.0).abs() < 1e-15);
        assert!(curve.points.windows(2).all(|pair| pair[1][0] > pair[0][0]));
        let solved = |force: f64| {
            let contact = problem.with_force(force).unwrap().solve().unwrap();
            match datum {
                Some(datum) => contact.relative_settlement(*datum).unwrap().settlement,
                None => contact.settlement(),
            }
        };
        // Lift-off is the same in all of them.
        let lift_off = solved(largest) - last;
        for step in 1..40 {
            let force = largest * (f64::from(step) / 40.0).powi(3);
            let off = (interpolated(&curve, force) - (solved(force) - lift_off)).abs() / last;
            assert!(off <= share, "{index}, {force}: {off}");
        }
        // The curve begins where a small force has moved nothing yet.
        let tiny = solved(1e-9 * largest) - lift_off;
        assert!(tiny > 0.0 && tiny < 0.05 * last, "{index}: {tiny} {last}");
    }
}

/// Under a flat base on a soft layer `-alpha = 3 chi M/(2 a^3)` as long as all of it touches, up to a third of `P a`.
#[test]
fn the_moment_curve_of_a_soft_layer_is_straight_within_the_kern() {
    let chi = 1e-9;
    let problem = plane(chi, "0", force(8e5));
    let kern = moment_curve(&problem, 0.33, 1e-3).unwrap();
    for [rotation, moment] in &kern.points {
        let exact = 1.5 * chi * moment / HALF_WIDTH.powi(3);
        assert!((rotation - exact).abs() <= 1e-4 * exact.abs() + 1e-16, "{moment}");
    }
    // Beyond, the triangle of pressure on the width 3 (a - e): chi p_max = alpha w, p_max w/2 = P.
    let beyond = moment_curve(&problem, 0.8, 1e-3).unwrap();
    let [rotation, moment] = *beyond.points.last().unwrap();
    let (e, a) = (moment / 8e5, HALF_WIDTH);
    let width = 3.0 * (a - e);
    let exact = chi * 2.0 * 8e5 / (width * width);
    assert!((rotation / exact - 1.0).abs() < 1e-3, "{rotation} {exact}");
    // A base that is its own mirror image turns either way alike.
    for ([u, m], [v, n]) in beyond.points.iter().zip(beyond.points.iter().rev()) {
        assert!((m + n).abs() < 1e-9 * moment && (u + v).abs() < 1e-9 * rotation);
    }
}

#[test]
fn refuses_what_has_no_table_and_says_why() {
    let bare =
        Problem::new(Foundation::dimensionless(3.0).unwrap(), Punch::new(1.0).unwrap(), force(1.0))
            .unwrap();
    let flat = plane(1.2e-14, "0", force(8e5));
    let bilateral = flat.with_solver(Solver::bilateral());
    let wave = on(
        steel(1.2e-14),
        Punch::periodic(HALF_WIDTH, 2.0 * HALF_WIDTH).unwrap(),
        "1e-7*cos(pi*x/a)",
        force(8e5),
    );
    // The middle of a punch loaded far off rises under more force.
    let turning = Load::new(Vertical::Force(8e5), Rotational::Eccentricity(4.9e-3)).unwrap();
    let turning = plane(1e-12, "0", turning);
    let told = |result: Result<LoadCurve, Error>| match result {
        Err(Error::NoTable { reason }) => reason,
        other => panic!("{other:?}"),
    };
    assert!(told(force_curve(&bare, 1.0, 1e-3, None)).contains("dimensionless"));
    assert!(told(moment_curve(&bilateral, 0.5, 1e-3)).contains("bilateral"));
    assert!(told(moment_curve(&wave, 0.5, 1e-3)).contains("cannot tilt"));
    assert!(told(force_curve(&turning, 1.0, 1e-3, None)).contains("does not grow"));
    let smooth = plane(0.0, "x^2/(2*2)", force(8e5)).solve().unwrap();
    assert!(matches!(Penalty::new(&smooth, 1e-3, None), Err(Error::NoTable { .. })));
    assert!(Penalty::new(&bilateral.solve().unwrap(), 1e-3, None).is_err());
    for share in [0.0, -1.0, 0.6, f64::NAN] {
        assert!(force_curve(&flat, 1.0, share, None).is_err(), "{share}");
        assert!(moment_curve(&flat, share.min(0.0), 1e-3).is_err(), "{share}");
    }
    for factor in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        assert!(force_curve(&flat, factor, 1e-3, None).is_err(), "{factor}");
    }
}
