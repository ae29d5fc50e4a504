//! The same problem with other roughnesses.

use std::f64::consts::PI;

use super::SWITCH;
use crate::contact::smooth::SmoothContact;
use crate::contact::{Contact, plan};
use crate::{Elastic, Frame, Problem, Roughness, Scaling, Solver};

/// `theta0` of the rough companions, for a half-width of the shortest stretch.
const SAMPLES: [f64; 4] = [1e3, 1e4, 1e5, SWITCH];

/// The smooth companion, with `theta0 = 1`, and rougher ones.
#[derive(Debug, Clone)]
pub(super) struct Companions {
    pub(super) smooth: SmoothContact,
    pub(super) rough: [Contact; 4],
    /// `theta0` of these.
    pub(super) at: [f64; 4],
    /// Ends and kinks of each zone of the smooth contact, from left to right.
    pub(super) marks: Vec<Vec<f64>>,
    /// Half of the shortest stretch between them, or the narrowest gap.
    pub(super) shortest: f64,
}

impl Companions {
    /// None where the direct solution serves, or the zones are not alike.
    pub(super) fn new(problem: &Problem) -> Option<Self> {
        let smooth = companion(problem, Roughness::Smooth)?.solve_smooth().ok()?;
        let breaks = problem.profile().breakpoints(problem.frame().half_width());
        let zones = smooth.zones();
        let marks: Vec<Vec<f64>> = (zones.iter())
            .map(|zone| {
                let [left, right] = zone.ends;
                let inside = breaks.iter().copied().filter(|at| left < *at && *at < right);
                [left].into_iter().chain(inside).chain([right]).collect()
            })
            .collect();
        let stretches =
            marks.iter().flat_map(|marks| marks.windows(2)).map(|w| 0.5 * (w[1] - w[0]));
        let gaps = zones.windows(2).map(|pair| pair[1].ends[0] - pair[0].ends[1]);
        let shortest = stretches.chain(gaps).fold(1.0f64, f64::min);
        if shortest.is_nan() || problem.frame().theta0() * shortest <= SWITCH {
            return None;
        }
        let at = SAMPLES.map(|theta0| theta0 / shortest);
        let solve = |theta0: f64| {
            let elastic = elastic(problem);
            let rough = companion(problem, Roughness::from(elastic / theta0))?;
            plan::solve_rough(&rough).ok()
        };
        let rough = [solve(at[0])?, solve(at[1])?, solve(at[2])?, solve(at[3])?];
        let alike = rough.iter().all(|contact| is_alike(&smooth, contact));
        alike.then_some(Self { smooth, rough, at, marks, shortest })
    }
}

/// Whether the contacts have the same zones, with free ends and walls alike.
fn is_alike(smooth: &SmoothContact, rough: &Contact) -> bool {
    let (zones, edges) = (smooth.zones(), rough.edges0());
    zones.len() == edges.len()
        && zones.iter().zip(edges).all(|(zone, ends)| {
            (0..2).all(|side| {
                let is_free = rough.pressure0(ends[side]) == 0.0;
                is_free == zone.is_free[side] && (is_free || ends[side] == zone.ends[side])
            })
        })
}

/// `theta0 chi`, the response of the body over its half-width (m/Pa).
fn elastic(problem: &Problem) -> f64 {
    let frame = problem.frame();
    let unit = |scaling: &Scaling| scaling.displacement() / scaling.pressure();
    frame.theta0() * frame.scaling().map_or(1.0, unit)
}

/// The same problem with another roughness (m/Pa); of a dimensionless one with `E = 1`, `chi = 1`.
pub(in crate::contact) fn companion(problem: &Problem, roughness: Roughness) -> Option<Problem> {
    let frame = problem.frame();
    let half_width = frame.half_width();
    let response = elastic(problem) / half_width;
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
    let frame = Frame::Physical { foundation, grading: None, body, roughness, geometry, scaling };
    let solver = Solver { contact: problem.solver().contact, ..Solver::default() };
    Problem::new(frame, problem.profile().clone(), *problem.load(), solver).ok()
}
