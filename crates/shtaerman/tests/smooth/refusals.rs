//! What no contact can balance, or no such problem can mean.

use crate::smooth::support::{balanced, level, punch};
use shtaerman::{Error, Load, Rotational, Vertical};

#[test]
fn loads() {
    let said = |load: Load| punch(1.0, |x| x * x, load).refused();
    assert!(matches!(said(balanced(0.0, 0.0)), Error::InvalidValue { field: "force", .. }));
    assert!(matches!(said(balanced(-1.0, 0.0)), Error::InvalidValue { field: "force", .. }));
    assert!(matches!(said(balanced(1.0, -1.0)), Error::TipsOver { limit: 1.0, .. }));
    let e = Load::new(Vertical::Force(1.0), Rotational::Eccentricity(1.2)).unwrap();
    assert!(matches!(said(e), Error::TipsOver { field: "eccentricity", .. }));
    let clear = Load::new(Vertical::Settlement(-0.1), Rotational::Tilt(0.0)).unwrap();
    assert!(matches!(said(clear), Error::NoContact));
    let clear = Load::new(Vertical::Settlement(-0.1), Rotational::Moment(0.0)).unwrap();
    assert!(matches!(said(clear), Error::NoContact));
}

#[test]
fn bases() {
    let step = |x: f64| if x > 0.25 { 1.0 } else { 0.0 };
    let problem = punch(1.0, step, balanced(1.0, 0.0)).breaks(&[0.25]).bilateral();
    assert!(matches!(problem.refused(), Error::InvalidValue { field: "profile", .. }));
    let holed = punch(1.0, |x| if x > 0.5 { f64::NAN } else { 0.0 }, balanced(1.0, 0.0));
    assert!(matches!(holed.refused(), Error::ProfileNotFinite { .. }));
}

#[test]
fn waves() {
    let ramp = punch(1.0, |x| x, level(1.0)).period(2.0);
    assert!(matches!(ramp.refused(), Error::InvalidValue { field: "profile", .. }));
    let turned = punch(1.0, |_| 0.0, balanced(1.0, 0.1)).period(2.0);
    assert!(matches!(turned.refused(), Error::InvalidValue { field: "moment", .. }));
    let load = Load::new(Vertical::Settlement(1.0), Rotational::Tilt(0.0)).unwrap();
    let sunk = punch(1.0, |_| 0.0, load).period(2.0);
    assert!(matches!(sunk.refused(), Error::InvalidValue { field: "settlement", .. }));
    assert!(punch(1.0, |_| 0.0, level(1.0)).period(1.0).solve().is_err());
}

#[test]
fn gaps_too_narrow_are_said_to_be() {
    let refused = punch(1.0, |_| 0.0, level(1.0)).gap(1e-7).refused();
    assert!(refused.is_numerical());
    // From -1e-7 to 1e-7; of a row from one punch to the next.
    let Error::ZonesTooClose { gap, .. } = refused else { panic!("{refused}") };
    assert!((gap - 2e-7).abs() < 1e-15);
    let refused = punch(1.0, |_| 0.0, level(1.0)).period(2.0 + 1e-6).refused();
    let Error::ZonesTooClose { gap, .. } = refused else { panic!("{refused}") };
    assert!((gap - 1e-6).abs() < 1e-14);
}

#[test]
fn hundreds_of_zones() {
    let wavy = punch(1.0, |x| (1500.0 * x).cos(), balanced(1.0, 0.0)).formula("cos(1500*x)");
    match wavy.refused() {
        Error::TooManyZones { zones, most } => assert!(most >= 100 && zones > most),
        other => panic!("{other}"),
    }
}
