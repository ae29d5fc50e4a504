//! A constant in the profile moves the punch and nothing else, and heights that rounding has spoilt are not said to be better than they are.

use shtaerman::{
    Contact, CrossCheck, Elastic, Error, Foundation, Geometry, Load, Problem, Profile, Punch,
    Rotational, Solver, Vertical,
};

use crate::contact::support::{force_and_moment, load};

const PLACES: [f64; 5] = [-1.0, -0.4, 0.0, 0.7, 1.0];

fn ground_punch(profile: Profile, load: Load, solver: Solver) -> Result<Contact, Error> {
    let steel = Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) =
        (Foundation::new(steel).with_roughness(1.2e-14).unwrap(), Punch::new(5e-3).unwrap());
    Problem::new(foundation, punch.with_profile(profile), load)?.with_solver(solver).solve()
}

fn expression(text: &str) -> Profile {
    Profile::expression(text).unwrap()
}

fn tight(solver: Solver) -> Solver {
    solver.with_tolerance(1e-12).unwrap()
}

#[test]
fn a_metre_of_offset_costs_no_digit() {
    let pressed = force_and_moment(0.8e6, 300.0);
    for solver in [Solver::default(), Solver::bilateral()].map(tight) {
        let plain = ground_punch(expression("x^2/(2*20)"), pressed, solver).unwrap();
        for (text, offset) in [
            ("x^2/(2*20) + 1", 1.0),
            ("-(3 - (x^2 + 40)/40)", -2.0),
            ("2*(x^2/80 - 4) + 0.5", -7.5),
        ] {
            let raised = ground_punch(expression(text), pressed, solver).unwrap();
            for xi in PLACES {
                let [one, other] =
                    [&plain, &raised].map(|contact| contact.dimensionless().pressure(xi).unwrap());
                assert!((one / other - 1.0).abs() < 1e-12, "{text} at {xi}: {one} {other}");
            }
            assert!(
                (raised.settlement() - offset - plain.settlement()).abs() < 1e-15 * offset.abs()
            );
            assert!((raised.tilt() / plain.tilt() - 1.0).abs() < 1e-12, "{text}");
            let depth = |contact: &Contact| contact.base_depth(2e-3);
            assert!((depth(&raised) - depth(&plain)).abs() < 1e-18, "{text}");
        }
    }
}

#[test]
fn a_measured_base_may_lie_anywhere() {
    let points = |offset: f64| {
        let positions: Vec<f64> = (-8..=8).map(|i| f64::from(i) / 1600.0).collect();
        // Powers of two, so that the offset leaves the heights as they are.
        let heights = (-8..=8).map(|i| offset + f64::from(i * i) / 2f64.powi(27)).collect();
        Profile::from_points(positions, heights).unwrap()
    };
    let pressed = force_and_moment(0.8e6, 0.0);
    let [plain, raised] = [0.0, 1024.0]
        .map(|offset| ground_punch(points(offset), pressed, tight(Solver::default())).unwrap());
    for xi in PLACES {
        assert!(
            (plain.dimensionless().pressure(xi).unwrap()
                / raised.dimensionless().pressure(xi).unwrap()
                - 1.0)
                .abs()
                < 1e-12,
            "{xi}"
        );
    }
    assert_eq!(raised.tilt(), 0.0);
}

#[test]
fn a_prescribed_settlement_is_counted_from_where_the_heights_are() {
    let sunk = |by: f64| load(Vertical::Settlement(by), Rotational::Tilt(0.0));
    // Both settlements are the same number of steps of 2^-30 m above their offsets.
    let deep = 3200.0 / 2f64.powi(30);
    let plain = ground_punch(expression("x^2/(2*20)"), sunk(deep), tight(Solver::default()));
    let raised =
        ground_punch(expression("x^2/(2*20) + 1"), sunk(1.0 + deep), tight(Solver::default()));
    let (plain, raised) = (plain.unwrap(), raised.unwrap());
    assert_eq!(raised.settlement(), 1.0 + deep);
    assert!((plain.force() / raised.force() - 1.0).abs() < 1e-12);
}

#[test]
fn a_layer_alone_has_the_pressure_of_its_base() {
    // p0 = delta0 - xi^2 with the mean 1/2.
    let (foundation, punch) = (Foundation::dimensionless(0.0).unwrap(), Punch::new(1.0).unwrap());
    let level = load(Vertical::Force(1.0), Rotational::Tilt(0.0));
    let problem = Problem::new(foundation, punch.with_profile(expression("xi^2 + 1e12")), level)
        .unwrap()
        .with_solver(tight(Solver::bilateral()));
    let contact = problem.solve().unwrap();
    for xi in PLACES {
        assert!(
            (contact.dimensionless().pressure(xi).unwrap() - (5.0 / 6.0 - xi * xi)).abs() < 1e-14,
            "{xi}"
        );
    }
    let check: CrossCheck = problem.cross_check(&contact).unwrap();
    assert!(check.pressure < 1e-13 && check.settlement < 1e-13, "{check:?}");
}

/// The pressures of a base in a form that loses digits and in one that does not, with the error that is stated.
fn spoilt(
    (foundation, punch): &(Foundation, Punch),
    texts: [&str; 2],
    force: f64,
    solver: Solver,
) -> (f64, f64) {
    let pressed = load(Vertical::Force(force), Rotational::Moment(0.0));
    let [lossy, exact] = texts.map(|text| {
        let profile = expression(text);
        Problem::new(foundation.clone(), punch.clone().with_profile(profile), pressed)
            .unwrap()
            .with_solver(solver)
            .solve()
            .unwrap()
    });
    let [left, right] = exact.dimensionless().zones()[0].map(|edge| 0.98 * edge);
    let difference = (0..=200)
        .map(|i| left + (right - left) * f64::from(i) / 200.0)
        .map(|xi| {
            (lossy.dimensionless().pressure(xi).unwrap()
                - exact.dimensionless().pressure(xi).unwrap())
            .abs()
        })
        .fold(0.0, f64::max);
    (difference, lossy.dimensionless().error().unwrap().pressure)
}

#[test]
fn rounding_of_heights_is_stated_whatever_the_way() {
    let bowl = ["1e3 - sqrt(1e6 - xi^2)", "xi^2/(1e3 + sqrt(1e6 - xi^2))"];
    let arch = ["1e5*(cosh(1e-3*xi) - 1)", "2e5*sinh(5e-4*xi)^2"];
    let narrow = ["1e5 - sqrt(1e10 - 1e6*xi^2)", "1e6*xi^2/(1e5 + sqrt(1e10 - 1e6*xi^2))"];
    let plane = |theta0| (Foundation::dimensionless(theta0).unwrap(), Punch::new(1.0).unwrap());
    let in_geometry = |geometry, exponent| {
        (
            Foundation::dimensionless(1.0).unwrap().with_exponent(exponent).unwrap(),
            Punch::in_geometry(geometry, 1.0).unwrap(),
        )
    };
    for (frame, texts, solver) in [
        (plane(0.0), bowl, Solver::bilateral()),
        (plane(1.0), bowl, Solver::bilateral()),
        (plane(1.0), bowl, Solver::spectral(4096).unwrap()),
        (plane(1.0), arch, Solver::default()),
        (plane(30.0), arch, Solver::default()),
        (plane(1.0), narrow, Solver::default()),
        (in_geometry(Geometry::Circular, 1.0), bowl, Solver::default()),
        (in_geometry(Geometry::Plane, 0.5), arch, Solver::default()),
    ] {
        let (difference, stated) = spoilt(&frame, texts, 0.2, solver);
        assert!(difference <= stated, "{frame:?} {texts:?}: {difference:e} > {stated:e}");
        assert!(
            stated < 1e-6 && difference > 1e-15,
            "{frame:?} {texts:?}: {difference:e} {stated:e}"
        );
    }
}

#[test]
fn a_tolerance_below_the_rounding_of_heights_is_not_met() {
    let pressed = force_and_moment(0.8e6, 0.0);
    for solver in [Solver::default(), Solver::bilateral()].map(tight) {
        let refused = ground_punch(expression("20 - sqrt(20^2 - x^2)"), pressed, solver);
        assert!(matches!(refused, Err(Error::ToleranceNotMet { .. })), "{refused:?}");
    }
}

/// Without a body the layer is the depth: a parabola of edges `+-sqrt(2 D)`, and a base that meets the body as `(1 - y^2)^1.5`, where an edge moves by the root of what rounding takes of the heights.
#[test]
fn edges_are_known_as_far_as_heights_are() {
    for (text, settlement, edge) in [
        ("max(0, 1048576 + xi^2/2)", 1_048_576.062_5, 0.125f64.sqrt()),
        ("max(0, 3 - max(0, 1 - 4*xi^2)^1.5 + max(0, xi^2 - 0.25))", 3.0, 0.5),
        ("max(0, 3000 - max(0, 1 - 4*xi^2)^1.5 + max(0, xi^2 - 0.25))", 3000.0, 0.5),
    ] {
        let pressed = load(Vertical::Settlement(settlement), Rotational::Tilt(0.0));
        let (foundation, punch) =
            (Foundation::dimensionless(0.0).unwrap(), Punch::new(1.0).unwrap());
        let problem =
            Problem::new(foundation, punch.with_profile(expression(text)), pressed).unwrap();
        let contact = problem.solve().unwrap();
        let [left, right] = contact.dimensionless().zones()[0];
        let error = (left + edge).abs().max((right - edge).abs());
        let stated = contact.dimensionless().error().and_then(|error| error.zones).unwrap();
        assert!(error <= stated && stated < 1e-6, "{text}: {error:e} {stated:e}");
    }
}

/// `0.123 sqrt(1 - y^2)` beside its end: there `1 - y^2` has few digits.
#[test]
fn the_error_covers_what_formulae_lose_beside_an_edge() {
    let text = "10 - 1.09*sqrt(max(0, 1 - (xi/0.123)^2)) + max(0, abs(xi)/0.123 - 1)";
    let pressed = load(Vertical::Settlement(10.0), Rotational::Tilt(0.0));
    let (foundation, punch) = (Foundation::dimensionless(0.0).unwrap(), Punch::new(1.0).unwrap());
    let problem = Problem::new(foundation, punch.with_profile(expression(text)), pressed).unwrap();
    let contact = problem.solve().unwrap();
    let stated = contact.dimensionless().error().unwrap().pressure;
    for share in [1e-3, 1e-6, 1e-9, 1e-12, 1e-14] {
        let xi: f64 = 0.123 * (1.0 - share);
        // 0.123 - xi is exact.
        let y = 1.0 - (0.123 - xi) / 0.123;
        let exact = 1.09 * ((0.123 - xi) / 0.123 * (1.0 + y)).sqrt();
        let error = (contact.dimensionless().pressure(xi).unwrap() - exact).abs();
        assert!(error <= stated && stated < 1e-7, "{share}: {error:e} {stated:e}");
    }
}

/// The sum of the constants, which are not written side by side, has fewer digits than the smaller one.
#[test]
fn constants_that_do_not_add_up_exactly_cost_no_digit() {
    let pressed = load(Vertical::Settlement(1_000_000.5), Rotational::Tilt(0.0));
    let (foundation, punch) = (Foundation::dimensionless(0.0).unwrap(), Punch::new(1.0).unwrap());
    let profile = expression("1000000 + xi^2/2 + 0.0016");
    let contact =
        Problem::new(foundation, punch.with_profile(profile), pressed).unwrap().solve().unwrap();
    let error = (contact.dimensionless().pressure(0.0).unwrap() - 0.4984).abs();
    let stated = contact.dimensionless().error().unwrap().pressure;
    assert!(error <= stated && stated < 1e-14, "{error:e} {stated:e}");
}

/// A load next to the end of a rigid base on a layer: `c = 3 (1 - e)` wide, with the pressure a triangle of the height `2 P/c`. The moment is a number that is rounded, and the answer states what that does.
#[test]
fn rounding_of_the_moment_is_stated_where_it_tells() {
    for eccentricity in [0.9, 0.99991, 0.9999835] {
        for force in [645585.7093079733, 109165.98909137525, 31234.56789] {
            let toml = format!(
                "[foundation]\nyoung_modulus = 5.466140240246691e+30\npoisson_ratio = 0.3\nroughness = 8.2336141667822e-08\n[punch]\nhalf_width = 1.0\nprofile = \"0\"\n[load]\nforce = {force}\neccentricity = {eccentricity}\n"
            );
            let contact = shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap();
            let width = 3.0 * (1.0 - eccentricity);
            let peak = 2.0 * force / width;
            let tilt = -8.2336141667822e-08 * peak / width;
            let stated = contact.error().unwrap();
            // The closed form is rounded, too.
            let rounding = |size: f64| 8.0 * f64::EPSILON * size.abs();
            let off = (contact.tilt() - tilt).abs();
            assert!(off <= stated.tilt + rounding(tilt), "{eccentricity} {force}: {off:e}");
            assert!(stated.tilt < 1e-8 * tilt.abs(), "{stated:?}");
            let off = (contact.settlement() - tilt * (1.0 - width)).abs();
            assert!(off <= stated.settlement + rounding(tilt), "{eccentricity} {force}: {off:e}");
            let off = (contact.peak_pressure() - peak).abs();
            assert!(off <= stated.pressure + rounding(peak), "{eccentricity} {force}: {off:e}");
        }
    }
}
