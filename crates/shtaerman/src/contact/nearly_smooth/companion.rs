//! The same problem with other roughnesses.

use std::f64::consts::PI;

use super::SWITCH;
use super::fit::{Three, beside_limit};
use crate::contact::smooth::{SmoothContact, SmoothZone};
use crate::contact::solution::Solution;
use crate::contact::unilateral::{KnownZone, UnilateralContact};
use crate::frame::Frame;
use crate::{Elastic, Problem, Roughness, Scaling, Solver};

/// `theta0` of the rough companions, for a half-width of the shortest stretch.
const SAMPLES: Three = [1e4, 1e5, SWITCH];

/// A rough problem with its solution.
#[derive(Debug, Clone)]
pub(super) struct Rough {
    pub(super) problem: Problem,
    pub(super) contact: UnilateralContact,
}

impl Rough {
    /// `p0(xi)` as `delta0 - alpha0 xi - f0 - theta0 K p0`.
    pub(super) fn pressure(&self, xi: f64) -> f64 {
        self.contact.pressure(&self.problem, xi)
    }
}

/// The smooth companion, with `theta0 = 1`, and rougher ones.
#[derive(Debug, Clone)]
pub(super) struct Companions {
    pub(super) smooth: SmoothContact,
    /// None where all ends are walls and nothing bends between them: then there is nothing to expand.
    pub(super) rough: Option<[Rough; 3]>,
    /// `theta0` of these.
    pub(super) at: Three,
    /// Ends and kinks of each zone of the smooth contact, from left to right.
    pub(super) marks: Vec<Vec<f64>>,
    /// Which ends of the zones are free.
    pub(super) is_free: Vec<[bool; 2]>,
}

impl Companions {
    /// None where the direct solution serves, or the zones are not alike.
    pub(super) fn new(problem: &Problem) -> Option<Self> {
        let smooth = companion(problem, Roughness::Smooth)?.solve_smooth().ok()?;
        let breaks = problem.profile().breakpoints(problem.frame().half_width());
        // More than can have panels of their own.
        if problem.parts().are_many() {
            return None;
        }
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
        let is_free: Vec<[bool; 2]> = zones.iter().map(|zone| zone.is_free).collect();
        let has_layers =
            is_free.as_flattened().contains(&true) || marks.iter().any(|marks| marks.len() > 2);
        let rough = if has_layers { Some(rough_ones(problem, &zones, at)?) } else { None };
        Some(Self { smooth, rough, at, marks, is_free })
    }

    /// The zones of contact for ends at these places.
    pub(super) fn zones(&self, ends: &[[f64; 2]]) -> Vec<KnownZone> {
        ends.iter().copied().zip(self.is_free.iter().copied()).collect()
    }
}

/// The rough companions, each from where the rougher ones lead.
fn rough_ones(problem: &Problem, zones: &[SmoothZone], at: Three) -> Option<[Rough; 3]> {
    let mut known: Vec<Rough> = Vec::with_capacity(at.len());
    for theta0 in at {
        let rougher = companion(problem, Roughness::from(elastic(problem) / theta0))?;
        let start: Vec<KnownZone> = (zones.iter().enumerate())
            .map(|(j, zone)| {
                let end = |side: usize| {
                    let ends = known.iter().map(|rough| rough.contact.zones()[j][side]);
                    if zone.is_free[side] {
                        foreseen(zone.ends[side], &ends.collect::<Vec<_>>(), at, theta0)
                    } else {
                        zone.ends[side]
                    }
                };
                ([end(0), end(1)], zone.is_free)
            })
            .collect();
        let contact = rougher.settled_near(&start, 1.0)?;
        let is_first = known.is_empty();
        if !is_alike(zones, &contact) || (is_first && !contact.is_complementary(&rougher)) {
            return None;
        }
        known.push(Rough { problem: rougher, contact });
    }
    known.try_into().ok()
}

/// Where an edge is to be expected from where it is at larger roughnesses.
fn foreseen(limit: f64, ends: &[f64], at: Three, theta0: f64) -> f64 {
    match *ends {
        [one] => limit + (one - limit) * (at[0] / theta0) * (theta0.ln() / at[0].ln()),
        [one, two] => beside_limit(limit, [one, one, two], [at[0], at[0], at[1]], theta0).value,
        _ => limit,
    }
}

/// Whether the contacts have the same zones, with free ends and walls alike.
fn is_alike(zones: &[SmoothZone], rough: &UnilateralContact) -> bool {
    let (ends, is_free) = (rough.zones(), rough.free_ends());
    zones.len() == ends.len()
        && zones.iter().zip(ends.iter().zip(is_free)).all(|(zone, (ends, is_free))| {
            (0..2).all(|side| {
                is_free[side] == zone.is_free[side]
                    && (is_free[side] || ends[side] == zone.ends[side])
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
    problem.with_solver(solver).in_frame(frame).ok()
}
