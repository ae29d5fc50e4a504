//! Bad input is refused with its value.

use shtaerman::{
    Criterion, Error, Foundation, Load, Problem, Punch, Rotational, Solver, StressField, Vertical,
};

fn refused(panels: &[[f64; 2]], period: Option<f64>, ratio: f64) -> &'static str {
    match StressField::from_pressure(panels, period, ratio, |_, _, _| 1.0) {
        Err(Error::InvalidValue { field, .. }) => field,
        other => unreachable!("{other:?}"),
    }
}

#[test]
fn fields_are_checked() {
    let nan = f64::NAN;
    assert_eq!(refused(&[], None, 0.3), "number of panels");
    for panels in [&[[1.0, 1.0]][..], &[[1.0, -1.0]], &[[nan, 1.0]], &[[0.0, f64::INFINITY]]] {
        assert_eq!(refused(panels, None, 0.3), "panel");
    }
    assert_eq!(refused(&[[0.0, 1.0], [0.5, 2.0]], None, 0.3), "panel");
    for period in [1.9, nan, f64::INFINITY, -3.0] {
        assert_eq!(refused(&[[-1.0, 1.0]], Some(period), 0.3), "period");
    }
    for ratio in [nan, 0.51, -1.0] {
        assert_eq!(refused(&[[-1.0, 1.0]], None, ratio), "poisson_ratio");
    }
    for value in [f64::NAN, f64::INFINITY] {
        let field = StressField::from_pressure(&[[-1.0, 1.0]], None, 0.3, |_, _, _| value);
        assert!(matches!(field, Err(Error::Overflow { quantity: "pressure", .. })));
    }
}

#[test]
fn places_are_checked() {
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, 0.3, |_, _, _| 1.0).unwrap();
    for (x, y) in [
        (0.0, -1e-300),
        (0.0, f64::NAN),
        (0.0, f64::INFINITY),
        (f64::NAN, 1.0),
        (f64::INFINITY, 1.0),
    ] {
        assert!(field.stress(x, y).is_err(), "{x} {y}");
    }
    for (x, y) in
        [(0.0, 0.0), (0.0, 1e-320), (1.0, 1e-320), (1e300, 1.0), (0.0, 1e300), (1e-320, 1e-320)]
    {
        let stress = field.stress(x, y).unwrap();
        assert!(stress.von_mises().is_finite() && stress.sigma_x <= 0.0, "{x} {y}: {stress:?}");
    }
}

/// No pressure at all is a stress of nothing.
#[test]
fn nothing_presses() {
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, 0.3, |_, _, _| 0.0).unwrap();
    assert_eq!(field.stress(0.3, 0.2).unwrap().von_mises(), 0.0);
    assert_eq!(field.peak(Criterion::VonMises).value, 0.0);
}

#[test]
fn geometries_without_a_known_field_are_refused() {
    let (foundation, punch) =
        (Foundation::dimensionless(1.0).unwrap(), Punch::circular(1.0).unwrap());
    let load = Load::new(Vertical::Force(1.0), Rotational::Moment(0.0)).unwrap();
    let problem = Problem::new(foundation, punch, load).unwrap().with_solver(Solver::bilateral());
    let refused = problem.first_yield(Criterion::VonMises, 1.0, Some(0.3));
    assert_eq!(refused.err(), Some(Error::NoStresses));
    assert_eq!(problem.check_stresses(), Err(Error::NoStresses));
}
