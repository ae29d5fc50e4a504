//! Settlements relative to a datum, and the surface.

use crate::inverse::support::{load, physical, unilateral};
use shtaerman::{Datum, Elastic, Foundation, Geometry, Problem, Profile, Punch, SurfaceCurve};

#[test]
fn far_away_the_punch_is_a_line_load() {
    let problem = physical(200e9, 1.2e-14, 5e-3, "x^2/(2*0.8)", load(8e5, 0.0));
    let contact = problem.solve().unwrap();
    let theta = 2.0 / (std::f64::consts::PI * 200e9 / 0.91);
    let far = 500.0;
    let found = contact.relative_settlement(Datum::Distance(far)).unwrap();
    let exact = theta * 8e5 * (5e-3f64 / far).ln();
    assert!((found.displacement / exact - 1.0).abs() < 1e-9);
    assert!((found.settlement - contact.settlement() + exact).abs() < 1e-9 * exact.abs());
    let found = contact.relative_settlement(Datum::Depth(far)).unwrap();
    let exact = theta * 8e5 * ((5e-3f64 / far).ln() + 0.5 / 0.7);
    assert!((found.displacement / exact - 1.0).abs() < 1e-9);
}

#[test]
fn a_hertz_pressure_at_a_depth() {
    // p = p0 sqrt(1 - (x/b)^2) on |x| < b: the integrals of the line load's field from an independent computation (mpmath, 30 digits) at y = b/10, b, 3b:
    // int sqrt(1-s^2) ln(1/r) ds and int sqrt(1-s^2) y^2/r^2 ds.
    let golden = DEPTHS;
    let half_width = 5e-3;
    let modulus = 200e9;
    let foundation = Elastic::new(modulus, 0.3).unwrap();
    // Nearly smooth, the parabola just in full contact: the layer is c = chi E*/a = 1e-6.
    let star = foundation.plane_strain_modulus();
    let radius = 0.7;
    let force = std::f64::consts::PI * star * half_width * half_width / (4.0 * radius);
    let (foundation, punch) = (
        Foundation::new(foundation).with_roughness(1e-6 * half_width / star).unwrap(),
        Punch::new(half_width).unwrap(),
    );
    let profile = Profile::expression("x^2/(2*0.7)").unwrap();
    let problem = Problem::new(foundation, punch.with_profile(profile), load(force, 0.0)).unwrap();
    let contact = problem.solve().unwrap();
    let theta = 2.0 / (std::f64::consts::PI * star);
    let top = star * half_width / (2.0 * radius);
    for [y, logarithm, square] in golden {
        let exact = theta * top * half_width * (logarithm + 0.5 / 0.7 * square);
        let found = contact.relative_settlement(Datum::Depth(y * half_width)).unwrap();
        let scale = theta * top * half_width;
        assert!((found.displacement - exact).abs() < 3e-5 * scale, "{y}: {found:?} {exact}");
    }
}

const DEPTHS: [[f64; 3]; 3] = [
    [0.1, 1.57521709028935, 0.284310227672148],
    [1.0, -0.160912326759377, 1.30129028456857],
    [3.0, -1.74693326762575, 1.52943091508016],
];

#[test]
fn the_surface_is_the_limit_of_the_depth() {
    let problem = physical(200e9, 1.2e-14, 5e-3, "x^2/(2*0.8)", load(8e5, 300.0));
    let contact = problem.solve().unwrap();
    let surface = contact.elastic_displacement(0.0);
    let pressure = contact.pressure(0.0).unwrap();
    let theta = 2.0 / (std::f64::consts::PI * 200e9 / 0.91);
    for depth in [1e-6, 1e-8, 1e-10] {
        let found = contact.relative_settlement(Datum::Depth(depth)).unwrap().displacement;
        // u(0, y) = u(0, 0) + theta pi y p [1/(2 (1-nu)) - 1] + ..
        let first = theta * std::f64::consts::PI * depth * pressure * (0.5 / 0.7 - 1.0);
        let rest = found - surface - first;
        assert!(rest.abs() < 1e-3 * first.abs() + 3e-13 * surface.abs(), "{depth}: {rest} {first}");
    }
}

#[test]
fn a_gauge_does_not_matter() {
    // The same contact under a wider punch: another gauge, the same relative settlement.
    let relative = |half_width: f64, datum| {
        let problem = physical(200e9, 1.2e-14, half_width, "x^2/(2*0.1)", load(8e5, 0.0));
        let contact = problem.solve().unwrap();
        assert!(contact.contact_width() < half_width);
        contact.relative_settlement(datum).unwrap().settlement
    };
    for datum in [Datum::Distance(0.3), Datum::Distance(-2e-3), Datum::Depth(0.1)] {
        let (one, two) = (relative(5e-3, datum), relative(12e-3, datum));
        assert!((one / two - 1.0).abs() < 1e-10, "{datum:?}: {one} {two}");
    }
}

#[test]
fn a_row_repeats_itself() {
    let foundation = Elastic::new(200e9, 0.3).unwrap();
    let row = Geometry::Periodic { period: 12e-3 };
    let (foundation, punch) = (
        Foundation::new(foundation).with_roughness(1.2e-14).unwrap(),
        Punch::in_geometry(row, 5e-3).unwrap(),
    );
    let profile = Profile::expression("x^2/2").unwrap();
    let problem = Problem::new(foundation, punch.with_profile(profile), load(8e5, 0.0)).unwrap();
    let contact = problem.solve().unwrap();
    let at = |x| contact.relative_settlement(Datum::Distance(x)).unwrap().settlement;
    for (one, two) in [(6e-3, 0.498), (4e-3, 1.0), (2e-3, -2e-3)] {
        assert!((at(one) / at(two) - 1.0).abs() < 1e-9, "{one} {two}");
    }
    // Half-way between two punches the surface is highest.
    assert!(at(6e-3) > at(5e-3) && at(5e-3) > at(3e-3));
    // Flamant's point in the depth is that of one punch.
    assert!(contact.relative_settlement(Datum::Depth(1.0)).is_err());
    let SurfaceCurve { x, gap, .. } = SurfaceCurve::new(&contact, 13).unwrap();
    assert_eq!((x[0], gap[0], gap[6]), (-6e-3, None, Some(0.0)));
}

#[test]
fn data_that_mean_nothing_are_refused() {
    let contact = physical(200e9, 1.2e-14, 5e-3, "0", load(8e5, 0.0)).solve().unwrap();
    for datum in [
        Datum::Distance(0.0),
        Datum::Distance(f64::NAN),
        Datum::Distance(f64::INFINITY),
        Datum::Depth(0.0),
        Datum::Depth(-1.0),
        Datum::Depth(f64::NAN),
    ] {
        assert!(contact.relative_settlement(datum).is_err(), "{datum:?}");
    }
    let bare = unilateral(1.0, "0", load(1.0, 0.0)).solve().unwrap();
    assert!(bare.relative_settlement(Datum::Depth(1.0)).is_err());
    assert!(bare.relative_settlement(Datum::Distance(1.0)).is_ok());
    let steel = Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) = (
        Foundation::new(steel).with_roughness(1e-14).unwrap(),
        Punch::new(5e-3).unwrap().with_body(steel),
    );
    let problem = Problem::new(foundation, punch, load(8e5, 0.0)).unwrap();
    assert!(problem.solve().unwrap().relative_settlement(Datum::Distance(1.0)).is_err());
}

#[test]
fn the_surface_curve_holds_together() {
    let problem = physical(200e9, 1.2e-14, 5e-3, "x^2/(2*0.1)", load(8e5, 0.0));
    let contact = problem.solve().unwrap();
    let SurfaceCurve { x, pressure: p, displacement, gap } =
        SurfaceCurve::new(&contact, 61).unwrap();
    assert_eq!((x[0], x[60], x[20], x[40]), (-15e-3, 15e-3, -5e-3, 5e-3));
    let [[left, right]] = contact.zones()[..] else { unreachable!() };
    for i in 0..61 {
        assert!((displacement[i] - displacement[60 - i]).abs() < 1e-12 * displacement[30]);
        let under = x[i].abs() <= 5e-3;
        assert_eq!(gap[i].is_some(), under);
        let Some(gap) = gap[i] else {
            assert_eq!(p[i], 0.0);
            continue;
        };
        // delta - f - chi p = u - gap
        let depth = contact.settlement() - x[i] * x[i] / 0.2 - 1.2e-14 * p[i];
        assert!((displacement[i] - gap - depth).abs() < 1e-12 * contact.settlement().abs());
        assert_eq!(gap > 0.0, x[i] < left || x[i] > right);
    }
    assert!(SurfaceCurve::new(&contact, 1).is_err());
}
