//! Unilateral contact: the pressure never pulls, the base never penetrates, and where it touches is part of the answer.
//!
//! The [topology](topology) is found on cells; the [edges](edges) of the zones by Newton's method on collocated pressures; the
//! [check](check) of the answer between its nodes corrects the topology where that was too coarse.

mod answer;
mod base;
mod check;
mod coarse;
mod edges;
mod elimination;
mod field;
mod harmonic;
mod layer;
mod medium;
mod motion;
mod power;
mod ring;
mod solved;
mod system;
mod topology;
mod zones;

pub use answer::Complementarity;
pub(crate) use answer::UnilateralContact;

use fredholm::collocation::{extrapolate, first_half_count};

use super::accuracy::{Accuracy, ErrorKind};
use super::plan::AIM;
use super::potential::between_nodes;
use crate::{ContactKind, Error, Load, Problem, Rotational, Vertical};
use base::Base;
use check::{Check, check};
use solved::Solved;
use system::Resolution;
use zones::{Zone, corrected};

/// Tension and penetration, relative to their scales, that are corrected on the first nodes, and in the answer.
const COARSELY_ALLOWED: f64 = 1e-6;
const ALLOWED: f64 = 1e-10;
/// Below this a violation may come from too few nodes.
const DOUBTFUL: f64 = 1e-2;
/// Most nodes on either side of the middle of a panel while zones are looked for.
const MOST_HALF_COUNT: f64 = 300.0;
/// Corrections of the topology by the check, for each number of cells.
const CORRECTIONS: usize = 16;
/// Numbers of cells, each four times the one before.
const TOPOLOGIES: usize = 3;
/// Growth of the number of nodes from one resolution to the next.
const RATIO: f64 = std::f64::consts::SQRT_2;
/// Most nodes of all panels together.
const MOST_NODES: usize = 2400;
/// Differences that no longer fall and are below this share of the solution are rounding.
const STAGNANT: f64 = 1e-9;
/// A change of force and displacements, relative to their size, that is rounding.
const RESOLVED: f64 = 1e-13;
/// Points at which two resolutions are compared.
const COMPARED: usize = 200;
/// Rounding of settlement, tilt, force and moment relative to their size.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Problem {
    /// Solves the problem with the pressure nowhere negative: the zones of contact are part of the answer.
    ///
    /// `p0 + theta0 int ln(1/|xi - eta|) p0 deta = delta0 - alpha0 xi - f0(xi)` and `p0 >= 0` on the zones, `p0 = 0` at their free edges, and outside
    /// them on the base a gap that is not negative.
    pub(crate) fn solve_unilateral(&self) -> Result<UnilateralContact, Error> {
        let base = Base::new(self, ContactKind::Unilateral)?;
        self.drawn_up(lifting(base)?)
    }

    /// The same with the whole base in contact, where the pressure may pull: by the equations of the zones, in every geometry and for every layer but a smooth one.
    pub(crate) fn solve_full_contact(&self) -> Result<UnilateralContact, Error> {
        let base = Base::new(self, ContactKind::Bilateral)?;
        self.drawn_up(full(&base)?)
    }

    fn drawn_up(&self, contact: UnilateralContact) -> Result<UnilateralContact, Error> {
        let contact = contact.within(self.solver().tolerance)?;
        Ok(if self.is_symmetric() { contact.without_skew() } else { contact })
    }
}

/// The answer on the whole base.
fn full(base: &Base<'_>) -> Result<UnilateralContact, Error> {
    let (solved, accuracy, edge) = if base.medium.is_closed() {
        let (solved, accuracy) = ring::solve(base)?;
        (solved, accuracy, 0.0)
    } else {
        let zones = base.whole();
        refined(base, &zones, strength(base, &zones))?
    };
    let left = check(base, &solved, ALLOWED);
    if !base.layer.is_linear() && !left.pulling.is_empty() {
        let at = left.pulling[0].iter().sum::<f64>() * 0.5;
        let half_width = base.problem.frame().half_width();
        let variable = base.problem.frame().coordinate();
        return Err(Error::Pulls { variable, at: at * half_width });
    }
    harmonic::answer(base, solved, accuracy, edge, &left)
}

/// The answer where the base may lift off.
fn lifting(base: Base<'_>) -> Result<UnilateralContact, Error> {
    if !base.medium.is_closed() {
        return complementary(&base);
    }
    let (solved, accuracy) = ring::solve(&base)?;
    let noise = accuracy.pressure / solved.largest().max(f64::MIN_POSITIVE);
    let left = check(&base, &solved, ALLOWED.max(2.0 * noise));
    if left.pulling.is_empty() && !ring::lifts(&base, &solved) {
        return harmonic::answer(&base, solved, accuracy, 0.0, &left);
    }
    // Seen from the middle of a gap the wave is one more base with ends.
    let cells = base.cells();
    let cut = match coarse::gap(&base, cells)? {
        Some(middle) => middle,
        None => ring::least(&solved),
    };
    complementary(&base.shifted(cut))
}

/// The answer, with its zones corrected where the finest nodes show what the first did not.
fn complementary(base: &Base<'_>) -> Result<UnilateralContact, Error> {
    let (mut zones, mut start) = find_zones(base)?;
    for _ in 0..CORRECTIONS {
        let (solved, accuracy, edge) = refined(base, &zones, start)?;
        let noise = accuracy.pressure / solved.largest().max(f64::MIN_POSITIVE);
        let left = check(base, &solved, ALLOWED.max(2.0 * noise));
        if left.pulling.is_empty() && left.penetrating.is_empty() {
            return harmonic::answer(base, solved, accuracy, edge, &left);
        }
        zones = corrected(&solved.zones, &left.pulling, &left.penetrating);
        start = strength(base, &zones);
        if zones.is_empty() {
            break;
        }
    }
    Err(Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN })
}

/// The zones at a first number of nodes on either side of the middle of a panel, and that number.
fn find_zones(base: &Base<'_>) -> Result<(Vec<Zone>, f64), Error> {
    let mut last = None;
    for power in 0..TOPOLOGIES {
        let cells = base.cells() * 4usize.pow(power as u32);
        let mut zones = base.first_zones(cells)?;
        let mut start = strength(base, &zones);
        let mut resolution = Resolution::new(&base.medium, half_count(start, -1))?;
        let mut before = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            if zones.is_empty() {
                break;
            }
            let wanted = strength(base, &zones);
            if wanted > start {
                start = wanted;
                resolution = Resolution::new(&base.medium, half_count(start, -1))?;
            }
            let (solved, _) = edges::settle(base, &resolution, &zones)?;
            let Check { pulling, penetrating, tension, penetration } =
                check(base, &solved, COARSELY_ALLOWED);
            if pulling.is_empty() && penetrating.is_empty() {
                return Ok((solved.zones, start));
            }
            last = Some([tension, penetration]);
            let worst = tension.max(penetration);
            let room = MOST_NODES as f64 / (2.0 * solved.panels.len() as f64);
            let finer = (start * RATIO).min(MOST_HALF_COUNT).min(room);
            // Too few nodes show tension where there is none: more of them tell.
            if worst < DOUBTFUL && worst < 0.3 * before && finer > start {
                (start, before) = (finer, worst);
                resolution = Resolution::new(&base.medium, half_count(start, -1))?;
                zones = solved.zones;
            } else {
                before = f64::INFINITY;
                zones = corrected(&solved.zones, &pulling, &penetrating);
            }
        }
    }
    let [tension, penetration] = last.unwrap_or([f64::NAN; 2]);
    Err(Error::NotComplementary { tension, penetration })
}

/// Nodes on either side of the middle of a panel that are about right for the longest panel.
fn strength(base: &Base<'_>, zones: &[Zone]) -> f64 {
    let longest = zones
        .iter()
        .flat_map(|zone| zone.panels(&base.breaks))
        .fold(0.0f64, |most, (left, right)| most.max(right - left));
    first_half_count(0.5 * base.steepness() * longest)
}

fn half_count(start: f64, power: i32) -> usize {
    ((start * RATIO.powi(power)).round() as usize).max(8)
}

/// The answer on growing numbers of nodes.
fn refined(base: &Base<'_>, zones: &[Zone], start: f64) -> Result<(Solved, Accuracy, f64), Error> {
    let tolerance = base.problem.solver().tolerance.unwrap_or(AIM);
    let level = |zones: &[Zone], power: i32| {
        let resolution = Resolution::new(&base.medium, half_count(start, power))?;
        edges::settle(base, &resolution, zones).map(|(solved, _)| solved)
    };
    let coarse = level(zones, -2)?;
    let mut fine = level(&coarse.zones, -1)?;
    let mut before = difference(base, &fine, &coarse);
    let mut best: Option<(Solved, Accuracy, f64)> = None;
    for power in 0.. {
        let finer = level(&fine.zones, power)?;
        let change = difference(base, &finer, &fine);
        let (accuracy, edge) = estimate(base, &finer, &before, &change);
        let sizes = finer.state.sizes(finer.largest());
        let met = accuracy.relative(&sizes) <= tolerance;
        let settled = change.pressure <= 2.0 * finer.pressure_rounding()
            && resolved(&finer, &change)
            || (change.pressure > 0.5 * before.pressure
                && change.pressure <= STAGNANT * finer.largest());
        let next = half_count(start, power + 1) * 2 * finer.panels.len();
        let last = next > MOST_NODES;
        fine = finer;
        if best.as_ref().is_none_or(|(_, known, _)| accuracy.pressure <= known.pressure) {
            best = Some((fine.clone(), accuracy, edge));
        }
        if met || settled || last {
            break;
        }
        before = change;
    }
    Ok(best.unwrap_or_else(|| unreachable!("the first round sets it")))
}

/// Whether the integrals have settled with the pressure: where the body gives nothing, the pressure of a layer that bends is exact on any nodes, its force is not.
fn resolved(solved: &Solved, change: &Change) -> bool {
    let state = &solved.state;
    let small = |change: f64, size: f64| change <= RESOLVED * size;
    solved.layer.is_linear()
        || (small(change.force.max(change.moment), state.force.abs().max(state.moment.abs()))
            && small(
                change.settlement.max(change.tilt),
                state.settlement.abs().max(state.tilt.abs()),
            ))
}

/// Differences between two resolutions.
struct Change {
    pressure: f64,
    settlement: f64,
    tilt: f64,
    force: f64,
    moment: f64,
    edge: f64,
}

fn difference(base: &Base<'_>, fine: &Solved, coarse: &Solved) -> Change {
    let same = fine.zones.len() == coarse.zones.len();
    let edge = (fine.zones.iter().zip(&coarse.zones))
        .flat_map(|(one, two)| {
            (0..2).map(move |side| (one.ends[side].at - two.ends[side].at).abs())
        })
        .fold(if same { 0.0 } else { 2.0 }, f64::max);
    let pressure = (fine.panels.iter())
        .flat_map(|panel| {
            let (middle, half) =
                (0.5 * (panel.left + panel.right), 0.5 * (panel.right - panel.left));
            between_nodes(COMPARED).map(move |y| (middle + half * y).clamp(panel.left, panel.right))
        })
        .map(|xi| {
            let height = base.height(xi);
            let covered = coarse.zones.iter().any(|zone| zone.left() <= xi && xi <= zone.right());
            let other = if covered { coarse.pressure_at(xi, height) } else { 0.0 };
            (fine.pressure_at(xi, height) - other).abs()
        })
        .fold(0.0, f64::max);
    Change {
        pressure,
        settlement: (fine.state.settlement - coarse.state.settlement).abs(),
        tilt: (fine.state.tilt - coarse.state.tilt).abs(),
        force: (fine.state.force - coarse.state.force).abs(),
        moment: (fine.state.moment - coarse.state.moment).abs(),
        edge,
    }
}

/// The error of the finest of three resolutions, and that of its edges; none for what the load prescribes.
fn estimate(base: &Base<'_>, fine: &Solved, before: &Change, change: &Change) -> (Accuracy, f64) {
    let Load { vertical, rotational } = base.load;
    let of = |unknown: bool, part: fn(&Change) -> f64, scale: f64| {
        let estimate = extrapolate(part(before), part(change), scale, RATIO);
        if unknown { estimate.max(ROUNDING * scale) } else { 0.0 }
    };
    let state = &fine.state;
    let displacement = state.settlement.abs().max(state.tilt.abs());
    let force = state.force.abs().max(state.moment.abs());
    let by_force = matches!(vertical, Vertical::Force(_));
    let by_tilt = matches!(rotational, Rotational::Tilt(_));
    let by_moment = matches!(rotational, Rotational::Moment(_));
    let largest = fine.largest();
    let pressure = extrapolate(before.pressure, change.pressure, largest, RATIO);
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure: pressure.max(fine.pressure_rounding()),
        settlement: of(by_force, |c| c.settlement, displacement),
        tilt: of(!by_tilt, |c| c.tilt, displacement),
        force: of(!by_force, |c| c.force, force),
        moment: of(!by_moment, |c| c.moment, force),
    };
    (accuracy, of(true, |c| c.edge, 1.0))
}
