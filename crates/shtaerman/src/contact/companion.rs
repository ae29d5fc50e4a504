//! The same problem with a smooth surface.

use std::f64::consts::PI;

use crate::frame::Frame;
use crate::{Elastic, Problem, Roughness, Scaling, Solver};

/// The same problem with a smooth surface; of a dimensionless one with `E = 1`, `chi = 1`.
pub(super) fn companion(problem: &Problem) -> Option<Problem> {
    let frame = problem.frame();
    let (half_width, roughness) = (frame.half_width(), Roughness::Smooth);
    // theta0 chi, the response of the body over its half-width (m/Pa).
    let unit = frame.unit(|scaling| scaling.displacement() / scaling.pressure());
    let response = frame.theta0() * unit / half_width;
    let moduli = match frame.scaling() {
        Some(scaling) => [scaling.pressure(), scaling.contact_modulus()],
        None => [1.0, 2.0 / (PI * response)],
    };
    let geometry = frame.geometry();
    let scaling = Scaling::with_response(response, moduli, roughness, half_width, geometry).ok()?;
    let (foundation, body) = match frame {
        Frame::Physical { foundation, body, .. } => (*foundation, *body),
        Frame::Dimensionless { .. } => (Elastic::new(1.0, 0.0).ok()?, None),
    };
    let frame = Frame::Physical {
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
    problem.with_solver(solver).in_frame(frame).ok()
}
