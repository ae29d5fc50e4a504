//! Bases that bend at many places, on panels: waves with kinks, traces in a row and on graded ground.

use std::f64::consts::PI;

use shtaerman::{
    Contact, Elastic, Error, Foundation, Geometry, Grading, Load, Problem, Profile, Punch,
    Rotational, Solver, Vertical,
};

use crate::geometries::support::{assert_near, attempt};

const WAVE: Geometry = Geometry::Periodic { period: 2.0 };

fn solved(
    (foundation, punch): (Foundation, Punch),
    profile: Profile,
    load: (Vertical, Rotational),
) -> Result<Contact, Error> {
    let load = Load::new(load.0, load.1)?;
    Problem::new(foundation, punch.with_profile(profile), load)?.solve()
}

#[test]
fn a_wave_with_kinks_in_full_contact() {
    // |xi| = 1/2 - (4/pi^2) sum_(m odd) cos(m pi xi)/m^2, and p_m = -f_m/(1 + 3/m): at crest and valley 1 +- (2/(3 pi^2)) (psi(2) - psi(1/2)), by mpmath.
    let load = (Vertical::Force(2.0), Rotational::Tilt(0.0));
    let contact = attempt((WAVE, 3.0, 1.0), "abs(xi)", load, Solver::default()).unwrap();
    assert_near(contact.dimensionless().pressure(0.0).unwrap(), 1.161188112791802, 1e-12);
    assert_near(contact.dimensionless().pressure(1.0).unwrap(), 0.838811887208198, 1e-12);
    assert_near(contact.dimensionless().pressure(-1.0).unwrap(), 0.838811887208198, 1e-12);
    assert_near(contact.dimensionless().settlement(), 1.5, 1e-13);
    assert!(contact.relative_error() < 1e-11, "{:e}", contact.relative_error());
}

#[test]
fn the_moment_of_a_wave_is_that_of_its_pressure() {
    // p0 = P0/2 - c sin(pi xi)/(1 + theta0), and int xi sin(pi xi) dxi = 2/pi.
    let theta0 = 4.0;
    for rotational in [Rotational::Tilt(0.0), Rotational::Moment(0.0)] {
        let load = (Vertical::Force(2.0), rotational);
        let body = (WAVE, theta0, 1.0);
        let contact = attempt(body, "0.7*sin(pi*xi)", load, Solver::default()).unwrap();
        assert_near(contact.dimensionless().moment(), -0.7 / (1.0 + theta0) * 2.0 / PI, 1e-14);
        let audited = contact.audited().unwrap();
        assert!(audited.relative_error() < 1e-10, "{:e}", audited.relative_error());
        // Lifting off, and seen from elsewhere: by a sum over the period.
        let light = attempt(body, "9*sin(pi*xi+0.8)+2*cos(2*pi*xi)", load, Solver::default());
        let light = light.unwrap();
        let [[left, right]] = light.dimensionless().zones()[..] else {
            panic!("{:?}", light.dimensionless().zones())
        };
        let count = 20_000;
        let sum: f64 = (0..count)
            .map(|i| 2.0 * (f64::from(i) + 0.5) / f64::from(count) - 1.0)
            .map(|xi| xi * light.dimensionless().pressure(xi).unwrap() * 2.0 / f64::from(count))
            .sum();
        assert!(right - left < 1.9);
        assert_near(light.dimensionless().moment(), sum, 1e-6);
    }
}

/// A trace through points of a cubic, which its spline is, and the cubic.
fn cubic(points: i32, scale: f64) -> [Profile; 2] {
    let place = |i: i32| 2.0 * f64::from(i) / f64::from(points - 1) - 1.0;
    let positions: Vec<f64> = (0..points).map(place).collect();
    let heights = positions.iter().map(|x| scale * (x * x + 0.3 * x.powi(3))).collect();
    let formula = format!("{scale}*(x^2 + 0.3*x^3)");
    [Profile::from_points(positions, heights).unwrap(), Profile::expression(&formula).unwrap()]
}

#[test]
fn traces_agree_with_formulas_in_rows_and_on_graded_ground() {
    // Formulas are collocated, traces are solved on panels.
    let row = (
        Foundation::dimensionless(20.0).unwrap(),
        Punch::in_geometry(Geometry::Periodic { period: 2.3 }, 1.0).unwrap(),
    );
    let pair = (
        Foundation::dimensionless(20.0).unwrap(),
        Punch::in_geometry(Geometry::Pair { inner_half_gap: 0.2 }, 1.0).unwrap(),
    );
    let graded = [0.1, 0.6].map(|exponent| {
        let grading = Grading::new(exponent, 1.0).unwrap();
        let chi = grading.response(0.3, 1.0, false) / 8.0;
        (
            Foundation::graded(grading, 0.3).unwrap().with_roughness(chi).unwrap(),
            Punch::new(1.0).unwrap(),
        )
    });
    let [first, second] = graded;
    for (frame, scale) in [(row, 1.0), (pair, 1.0), (first, 0.2), (second, 0.2)] {
        for (scale, moment) in [(0.3 * scale, 0.02), (30.0 * scale, -0.2)] {
            let load = (Vertical::Force(0.5), Rotational::Moment(moment));
            let [trace, formula] = cubic(60, scale);
            let on_panels = solved(frame.clone(), trace, load).unwrap();
            let known = solved(frame.clone(), formula, load).unwrap();
            assert_eq!(on_panels.method().name, shtaerman::MethodName::Panels);
            assert_eq!(known.method().name, shtaerman::MethodName::Sinc);
            let size = known.dimensionless().peak_pressure();
            let (one, other) = (on_panels.dimensionless().zones(), known.dimensionless().zones());
            for (a, b) in one.iter().flatten().zip(other.iter().flatten()) {
                assert_near(*a, *b, 1e-10);
            }
            let displacement =
                known.dimensionless().settlement().abs().max(known.dimensionless().tilt().abs());
            assert_near(
                on_panels.dimensionless().settlement(),
                known.dimensionless().settlement(),
                1e-11 * displacement,
            );
            assert_near(
                on_panels.dimensionless().tilt(),
                known.dimensionless().tilt(),
                1e-11 * displacement,
            );
            for i in -20..=20 {
                let xi = 0.0499 * f64::from(i);
                assert_near(
                    on_panels.dimensionless().pressure(xi).unwrap(),
                    known.dimensionless().pressure(xi).unwrap(),
                    1e-10 * size,
                );
            }
            let (one, other) =
                (on_panels.dimensionless().stiffness(), known.dimensionless().stiffness());
            let size = other.force_settlement;
            assert_near(one.force_settlement, other.force_settlement, 1e-7 * size);
            assert_near(one.coupling, other.coupling, 1e-7 * size);
            assert_near(one.moment_tilt, other.moment_tilt, 1e-7 * size);
            let accuracy = on_panels.relative_error();
            assert!(accuracy < 2e-8, "{accuracy:e}");
        }
    }
}

#[test]
fn a_measured_wave_is_the_same_wherever_its_seam_is() {
    // Heights of a period, in micrometres; turned by so many points the seam lies in the middle of a zone, where a spline that does not repeat has a hollow kink, or in a gap.
    let heights = [
        0.679, 0.912, 0.908, 0.788, 0.432, -0.218, -0.111, 0.448, 0.562, -0.162, -0.901, -1.085,
        -1.226, -1.552, -1.202, -0.139, 0.673, 0.675, 0.437,
    ];
    let count = heights.len();
    let rolled = |by: usize, length: f64, scale: f64| {
        let place = |i: usize| length * (2.0 * i as f64 / count as f64 - 1.0);
        let turned = (0..=count).map(|i| scale * heights[(i + by) % count]).collect();
        Profile::from_points((0..=count).map(place).collect(), turned).unwrap()
    };
    let body = Elastic::new(2e11, 0.3).unwrap();
    let physical = Geometry::Periodic { period: 0.02 };
    let smooth = (
        Foundation::new(body).with_roughness(0.0).unwrap(),
        Punch::in_geometry(physical, 0.01).unwrap(),
    );
    let (frame, length, scale, force) = (smooth, 0.01, 1e-6, 1.6e6);
    let load = (Vertical::Force(force), Rotational::Tilt(0.0));
    let of = |by: usize| solved(frame.clone(), rolled(by, length, scale), load).unwrap();
    let (across, beside) = (of(0), of(8));
    let size = beside.dimensionless().peak_pressure();
    assert_near(across.dimensionless().peak_pressure(), size, 1e-6 * size);
    assert!(across.relative_error() < 1e-6, "{:e}", across.relative_error());
    for i in 0..40 {
        let xi = 0.0493 * f64::from(i) - 0.97;
        let there = xi - 16.0 / count as f64;
        let there = if there < -1.0 { there + 2.0 } else { there };
        assert_near(
            across.dimensionless().pressure(xi).unwrap(),
            beside.dimensionless().pressure(there).unwrap(),
            1e-6 * size,
        );
    }
}
