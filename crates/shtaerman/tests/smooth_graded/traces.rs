//! Measured bases of many points: each is a bend of the base, and cut there the pressure is as exact as elsewhere.

use shtaerman::{Profile, Rotational, Vertical};

use crate::smooth_graded::support::{Case, potential};

/// Equally spaced places with waves of many lengths.
fn trace(points: i32) -> (Vec<f64>, Vec<f64>) {
    let places: Vec<f64> =
        (0..points).map(|i| 2.0 * f64::from(i) / f64::from(points - 1) - 1.0).collect();
    let height = |x: &f64| {
        let wave = |k: i32| {
            let k = f64::from(k);
            k.powf(-1.5) * (3.1 * k * x + k * k).sin()
        };
        2e-3 * (0.3 * x * x + 0.3 * (1..=60).map(wave).sum::<f64>())
    };
    let heights = places.iter().map(height).collect();
    (places, heights)
}

/// The kernel itself, integrated between the points, gives the depth of the base.
#[test]
fn the_points_of_a_trace_are_bends() {
    for (mu, points) in [(0.3, 40), (0.7, 70)] {
        let case = Case::plane(mu);
        let (places, heights) = trace(points);
        let profile = Profile::from_points(places.clone(), heights).unwrap();
        let load = (Vertical::Force(0.01), Rotational::Moment(0.0));
        let contact = case.problem(profile, 0.0, load.0, load.1).solve().unwrap();
        assert_eq!(contact.zones(), [[-1.0, 1.0]]);
        assert!(contact.relative_error() < 1e-8, "{mu}: {:e}", contact.relative_error());
        let size = contact.settlement().abs();
        for x in [-0.713, 0.1] {
            let error = potential(&case, &contact, &places, x) - contact.base_depth(x);
            println!("{mu} {points} {x}: {error:e} of {size:e}");
            assert!(error.abs() < 1e-9 * size, "{mu} {points} {x}: {error:e} of {size:e}");
        }
    }
}
