//! Corners, ranges of the parameters, and what lies at their ends.

use std::f64::consts::PI;

use fredholm::Error;
use fredholm::kernel::{
    Kernel, LogarithmRatio, LogarithmRatioLimit, LogarithmSine, LogarithmSquare, SpectralRelation,
};

#[test]
fn values_are_right_at_the_corner() {
    let limit = LogarithmRatioLimit::new(1.0).unwrap();
    assert_eq!(limit.value(0.0, 0.0), 0.0);
    assert_eq!(limit.value(0.0, 0.3), 0.0);
    for (x, s, exact) in [
        (1e-300, 1.0, 2e-300),
        (1.0, 1e-20, 2e-20),
        (3e-200, 1e-200, 2f64.ln()),
        (0.75, 0.25, 2f64.ln()),
    ] {
        assert!((limit.value(x, s) / exact - 1.0).abs() < 1e-15, "{x} {s}");
        assert_eq!(limit.value(x, s), limit.value(s, x));
    }
    let companion = LogarithmSquare::new(0.0, 1.0).unwrap();
    assert!((companion.value(1e-200, 0.0) - 400.0 * 10f64.ln()).abs() < 1e-12);
}

#[test]
fn parameters_out_of_range_are_refused() {
    let refused = |result: Result<(), Error>, name: &str| match result {
        Err(Error::InvalidParameter { name: found, .. }) => assert_eq!(found, name),
        other => panic!("{other:?}"),
    };
    for b in [0.0, -1.0, f64::NAN, f64::INFINITY, 1.0, 2.0, 1e-151] {
        refused(LogarithmRatio::new(b, 1.0).map(|_| ()), "inner end");
    }
    let message = LogarithmRatio::new(0.0, 1.0).unwrap_err().to_string();
    assert!(message.contains("LogarithmRatioLimit"), "{message}");
    for a in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-200, 1e200] {
        refused(LogarithmRatio::new(0.5 * a, a).map(|_| ()), "outer end");
        refused(LogarithmSquare::new(0.5 * a, a).map(|_| ()), "outer end");
        refused(LogarithmSquare::with_gauge(0.5, 1.0, a).map(|_| ()), "gauge");
        refused(LogarithmRatioLimit::new(a).map(|_| ()), "length");
    }
    for b in [-1e-9, f64::NAN, 1.0, f64::INFINITY] {
        refused(LogarithmSquare::new(b, 1.0).map(|_| ()), "inner end");
    }
    for alpha in [0.0, -1.0, f64::NAN, PI, 3.2, f64::INFINITY, 1e-160] {
        refused(LogarithmSine::new(alpha).map(|_| ()), "alpha");
    }
}

#[test]
fn extreme_parameters_stay_finite() {
    let relations: [Box<dyn SpectralRelation>; 9] = [
        Box::new(LogarithmRatio::new(1e-150, 1.0).unwrap()),
        Box::new(LogarithmRatio::new(1.0f64.next_down(), 1.0).unwrap()),
        Box::new(LogarithmRatio::new(1e149, 1e150).unwrap()),
        Box::new(LogarithmRatioLimit::new(1e-150).unwrap()),
        Box::new(LogarithmSine::new(1e-150).unwrap()),
        Box::new(LogarithmSine::new(PI.next_down()).unwrap()),
        Box::new(LogarithmSquare::new(1.0f64.next_down(), 1.0).unwrap()),
        Box::new(LogarithmSquare::new(5e-324, 1.0).unwrap()),
        Box::new(LogarithmSquare::with_gauge(1e-150, 1e150, 1e-150).unwrap()),
    ];
    for relation in relations {
        let gram = relation.gram(12).unwrap();
        let (left, right) = (relation.interval().left(), relation.interval().right());
        for n in 0..12 {
            assert!(relation.eigenvalue(n).is_finite() && relation.norm(n) > 0.0);
            assert!((0..12).all(|m| gram.entry(n, m).is_finite()), "{:?}", relation.interval());
            assert!(gram.entry(n, n) > 0.0, "{:?} {n}", relation.interval());
        }
        for x in [left, relation.interval().centre(), right] {
            let mut values = [0.0; 12];
            relation.eigenfunctions(x, &mut values);
            assert!(values.iter().all(|value| value.abs() <= 1.0 + 1e-13), "{values:?}");
            assert!(relation.weight_rest(0, x).is_finite() && relation.weight_rest(1, x) >= 0.0);
        }
        let moments = relation.moments(&|_| 1.0, 12).unwrap();
        let scale = gram.entry(0, 0);
        for (k, moment) in moments.values.iter().enumerate() {
            assert!(moment.is_finite(), "{:?} {k}", relation.interval());
            assert!(moment.abs() <= 1.01 * scale.max(right - left));
        }
    }
    for count in [usize::MAX, usize::MAX / 2, 1 << 40] {
        let relations: [Box<dyn SpectralRelation>; 4] = [
            Box::new(LogarithmRatio::new(0.5, 1.0).unwrap()),
            Box::new(LogarithmRatioLimit::new(1.0).unwrap()),
            Box::new(LogarithmSine::new(1.0).unwrap()),
            Box::new(LogarithmSquare::new(0.5, 1.0).unwrap()),
        ];
        for relation in relations {
            assert!(matches!(relation.gram(count), Err(Error::TooLarge { .. })));
            assert!(matches!(relation.moments(&|_| 1.0, count), Err(Error::TooLarge { .. })));
        }
    }
}
