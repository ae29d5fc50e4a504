//! Many zones against collocation, cells, and what must hold.

use super::super::base::Base;
use super::*;
use crate::contact::solution::Solution;
use crate::{ContactKind, Frame, Load, Problem, Profile, Rotational, Solver, Vertical};

fn problem(theta0: f64, profile: Profile, vertical: Vertical, rotational: Rotational) -> Problem {
    let load = Load::new(vertical, rotational).unwrap();
    Problem::new(Frame::dimensionless(theta0).unwrap(), profile, load, Solver::default()).unwrap()
}

/// A trace with waves of many lengths.
fn trace(points: i32, theta0: f64, roughness: f64) -> Profile {
    let positions: Vec<f64> =
        (0..points).map(|i| 2.0 * f64::from(i) / f64::from(points - 1) - 1.0).collect();
    let height = |x: &f64| {
        let waves = |k: i32| {
            let k = f64::from(k);
            k.powf(-1.5) * (3.1 * k * x + k * k).sin()
        };
        2.0 * (1.0 + theta0) * (0.3 * x * x + roughness * (1..=60).map(waves).sum::<f64>())
    };
    let heights = positions.iter().map(height).collect();
    Profile::measured(positions, heights).unwrap()
}

fn panels(problem: &Problem) -> SpotContact {
    let base = Base::new(problem, ContactKind::Unilateral).unwrap();
    solve(&base).unwrap().expect("panels serve")
}
