//! The two ways of a smooth disk against each other.

use std::sync::Arc;

use super::solve;
use crate::contact::smooth::disk::SmoothDisk;
use crate::contact::solution::Solution;
use crate::deadline::Deadline;
use crate::{Error, Load, Rotational, Vertical};

fn close(found: f64, exact: f64, relative: f64, what: &str) {
    assert!((found - exact).abs() <= relative * exact.abs(), "{what}: {found:e}, exact {exact:e}");
}

#[test]
fn one_disk_is_that_of_galins_transforms() {
    for (load, kink, is_unilateral) in
        [(0.3, 1.0, true), (3.0, 1.0, true), (0.5, 0.4, true), (0.1, 1.0, false)]
    {
        let bend = if kink < 1.0 { 0.2 } else { 0.0 };
        let disk = SmoothDisk {
            exponent: 0.0,
            theta0: 1.0,
            load: Load::new(Vertical::Force(load), Rotational::Moment(0.0)).unwrap(),
            height: Arc::new(move |r: f64| r * r + bend * (r - kink).max(0.0)),
            slope: Arc::new(move |r: f64| 2.0 * r + if r > kink { bend } else { 0.0 }),
            breaks: vec![kink],
            joints: Vec::new(),
            tolerance: 0.0,
            is_unilateral,
            deadline: Deadline::default(),
            is_over: Arc::new(|| false),
        };
        let (one, two) = (disk.solve().unwrap(), solve(&disk).unwrap());
        let [[left, right]] = two.zones()[..] else { panic!("one disk") };
        assert_eq!(left, -right);
        let radius = one.zones()[0][1];
        close(right, radius, 1e-14, "radius");
        close(two.state().settlement, one.state().settlement, 1e-14, "settlement");
        close(two.state().force, load, 1e-13, "force");
        close(two.stiffness().moment_tilt, one.stiffness().moment_tilt, 1e-13, "turning");
        let [one_corner, two_corner] =
            [one.corner_intensity(), two.corner_intensity()].map(|all| all.unwrap()[0][1]);
        assert!((two_corner - one_corner).abs() < 1e-14);
        for xi in [0.0, 0.1, -0.3, 0.399, 0.9 * radius] {
            assert!((one.pressure(xi) - two.pressure(xi)).abs() < 1e-12, "{load}: {xi}");
            assert!(
                (one.displacement(xi + 0.6) - two.displacement(xi + 0.6)).abs() < 1e-14,
                "{load}: {xi}"
            );
        }
    }
    let refused = SmoothDisk {
        exponent: 0.0,
        theta0: 1.0,
        load: Load::new(Vertical::Force(1.0), Rotational::Moment(0.1)).unwrap(),
        height: Arc::new(|r: f64| -r * r),
        slope: Arc::new(|r: f64| -2.0 * r),
        breaks: Vec::new(),
        joints: Vec::new(),
        tolerance: 0.0,
        is_unilateral: true,
        deadline: Deadline::default(),
        is_over: Arc::new(|| false),
    };
    let refused = solve(&refused);
    assert!(matches!(refused, Err(Error::InvalidValue { field: "moment", value: 0.1, .. })));
}
