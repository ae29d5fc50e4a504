//! Corner intensities, and the edge pressure they imply.

use std::f64::consts::PI;

use crate::limits::support::{CASES, FLAT, PARABOLA, roughness};
use shtaerman::{Contact, Foundation, Load, Problem, Punch, Rotational, Solver, Vertical};

#[test]
fn intensities_of_the_flat_punch() {
    // K = (P +- 2 M/a)/sqrt(pi a)
    let zones = FLAT.solve(0.0).corner_intensity().unwrap();
    let root = PI.sqrt();
    assert!((zones[0][0] - 0.6 / root).abs() < 1e-13 && (zones[0][1] - 1.4 / root).abs() < 1e-13);
    assert_eq!(PARABOLA.solve(0.0).corner_intensity(), Some(vec![[0.0; 2]]));
    assert_eq!(FLAT.solve(1.0).corner_intensity(), None);
    assert_eq!(FLAT.solve(0.0).implied_edge_pressures(), None);
}

#[test]
fn a_small_roughness_has_the_implied_pressure() {
    for case in &CASES {
        let contact = case.solve(roughness(1e5));
        let implied = contact.implied_edge_pressures().unwrap();
        for (ends, zone) in implied.iter().zip(contact.zones()) {
            for side in 0..2 {
                let pressure = contact.pressure(zone[side]).unwrap();
                let error = (pressure - ends[side]).abs();
                assert!(error <= 1e-3 * ends[side], "{}: {pressure} {ends:?}", case.name);
            }
        }
    }
}

fn dimensionless(theta0: f64, force: f64, moment: f64) -> Contact {
    let load = Load::new(Vertical::Force(force), Rotational::Moment(moment)).unwrap();
    let (foundation, punch) =
        (Foundation::dimensionless(theta0).unwrap(), Punch::new(1.0).unwrap());
    Problem::new(foundation, punch, load).unwrap().with_solver(Solver::bilateral()).solve().unwrap()
}

#[test]
fn within_one_percent_from_40_under_a_force_and_110_under_a_moment() {
    for (force, moment, range) in [(1.0, 0.0, 40.0), (0.0, 1.0, 110.0)] {
        let off = |theta0: f64| {
            let contact = dimensionless(theta0, force, moment);
            let implied = contact.implied_edge_pressures().unwrap()[0][1];
            contact.dimensionless().pressure(1.0).unwrap() / implied - 1.0
        };
        assert!(off(range).abs() < 0.0101, "{range}: {}", off(range));
        assert!(off(0.8 * range).abs() > 0.01, "{range}: {}", off(0.8 * range));
        for more in [2.0, 10.0, 100.0] {
            assert!(
                off(more * range).abs() < 0.011 / more.sqrt(),
                "{range}: {}",
                off(more * range)
            );
        }
    }
}
