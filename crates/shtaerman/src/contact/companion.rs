//! The same problem with a smooth surface.

use std::f64::consts::PI;

use crate::bodies::Bodies;
use crate::{Elastic, Problem, Roughness, Scaling, Solver};

/// The same problem with a smooth surface; of a dimensionless one with `E = 1`, `chi = 1`.
pub(super) fn companion(problem: &Problem) -> Option<Problem> {
    let bodies = problem.bodies();
    let (half_width, roughness) = (bodies.half_width(), Roughness::Smooth);
    // theta0 chi, the response of the body over its half-width (m/Pa).
    let unit = bodies.unit(|scaling| scaling.displacement() / scaling.pressure());
    let response = bodies.theta0() * unit / half_width;
    let moduli = match bodies.scaling() {
        Some(scaling) => [scaling.pressure(), scaling.contact_modulus()],
        None => [1.0, 2.0 / (PI * response)],
    };
    let geometry = bodies.geometry();
    let scaling = Scaling::with_response(response, moduli, roughness, half_width, geometry).ok()?;
    let (foundation, body) = match bodies {
        Bodies::Physical { foundation, body, .. } => (*foundation, *body),
        Bodies::Dimensionless { .. } => (Elastic::new(1.0, 0.0).ok()?, None),
    };
    let bodies = Bodies::Physical {
        foundation,
        grading: None,
        layering: None,
        body,
        roughness,
        geometry,
        scaling,
    };
    let Solver { contact, time_limit, .. } = *problem.solver();
    let solver = Solver { contact, time_limit, ..Solver::default() };
    problem.with_solver(solver).of_bodies(bodies).ok()
}
