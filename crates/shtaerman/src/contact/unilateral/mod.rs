//! Unilateral contact: the pressure never pulls, the base never penetrates, and where it touches is part of the answer.
//!
//! The [topology](topology) is found on cells; the [edges](edges) of the zones by Newton's method on collocated pressures; the
//! [check](check) of the answer between its nodes corrects the topology where that was too coarse.

mod anchor;
mod answer;
mod base;
mod cells;
mod check;
mod coarse;
mod damping;
mod eccentric;
mod edges;
mod elimination;
mod field;
mod fine;
mod harmonic;
mod layer;
mod medium;
mod motion;
mod power;
mod reach;
mod ring;
mod solved;
mod system;
mod topology;
mod zones;

pub use answer::Complementarity;
use answer::UnilateralContact;
pub(super) use base::require_even;

use std::sync::Arc;

use fredholm::collocation::{extrapolate, first_half_count};

use super::accuracy::{Accuracy, ErrorKind};
use super::plan::AIM;
use super::potential::between_nodes;
use super::solution::Solution;
use crate::{ContactKind, Error, Load, Problem, Rotational, Vertical};
use base::Base;
use check::{Check, check};
use fine::CellContact;
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
/// A violation that changes by less than this share is the same again.
const SAME: f64 = 1e-2;
/// How zones that vanished are narrowed for the next attempt, and how often: then more cells are tried.
const NARROWER: f64 = 0.2;
const NARROWEST: f64 = 1e-4;
/// Corrections of the topology by the check, for each number of cells.
const CORRECTIONS: usize = 12;
/// Numbers of cells, each four times the one before.
const TOPOLOGIES: usize = 3;
/// Cubes of the numbers of nodes, added up over Newton steps, after which the search for zones ends.
const MOST_WORK: f64 = 1e10;
/// Most zones that are collocated.
const MOST_ZONES: usize = 40;
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

/// Relative errors from which on heights are counted from a tangent, and the length of base within which all zones must lie for that.
const DIGITS_LOST: f64 = 1e-11;
const SMALL_ZONES: f64 = 0.1;

impl Problem {
    /// Solves the problem with the pressure nowhere negative: the zones of contact are part of the answer.
    ///
    /// `p0 + theta0 int ln(1/|xi - eta|) p0 deta = delta0 - alpha0 xi - f0(xi)` and `p0 >= 0` on the zones, `p0 = 0` at their free edges, and outside
    /// them on the base a gap that is not negative.
    pub(super) fn solve_unilateral(&self) -> Result<Arc<dyn Solution>, Error> {
        let base = Base::new(self, ContactKind::Unilateral)?;
        Ok(match lifting(base)? {
            Answer::Zones(contact) => Arc::new(*contact),
            Answer::Cells(contact) => Arc::new(*contact),
        })
    }

    /// The same with the whole base in contact, where the pressure may pull: by the equations of the zones, in every geometry and for every layer but a smooth one.
    pub(super) fn solve_full_contact(&self) -> Result<Arc<dyn Solution>, Error> {
        let base = Base::new(self, ContactKind::Bilateral)?;
        Ok(Arc::new(full(&base)?))
    }
}

/// An answer on zones or on cells.
enum Answer {
    Zones(Box<UnilateralContact>),
    Cells(Box<CellContact>),
}

impl Answer {
    fn zones(contact: UnilateralContact) -> Self {
        Self::Zones(Box::new(contact))
    }

    fn cells(contact: CellContact) -> Self {
        Self::Cells(Box::new(contact))
    }
}

/// The answer on the whole base.
fn full(base: &Base<'_>) -> Result<UnilateralContact, Error> {
    let (solved, accuracy, edge) = if base.medium.is_closed() {
        let (solved, accuracy) = ring::solve(base)?;
        (solved, accuracy, 0.0)
    } else {
        let zones = base.whole();
        let start = strength(base, &zones);
        let (coarse, _) =
            edges::settle(base, &Resolution::new(&base.medium, half_count(start, -1))?, &zones)?;
        refined(base, &coarse, start)?
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
fn lifting(base: Base<'_>) -> Result<Answer, Error> {
    if !base.medium.is_closed() {
        return open(&base);
    }
    let (solved, accuracy) = ring::solve(&base)?;
    let noise = accuracy.pressure / solved.largest().max(f64::MIN_POSITIVE);
    let left = check(&base, &solved, ALLOWED.max(2.0 * noise));
    if left.pulling.is_empty() && !ring::lifts(&base, &solved) {
        return harmonic::answer(&base, solved, accuracy, 0.0, &left).map(Answer::zones);
    }
    // Seen from the middle of a gap the wave is one more base with ends.
    let cells = base.cells();
    let cut = match coarse::gap(&base, cells)? {
        Some(middle) => middle,
        None => ring::least(&solved),
    };
    complementary(&base.shifted(cut)).map(Answer::zones)
}

/// The answer by the method that suits the profile, or by the other.
fn open(base: &Base<'_>) -> Result<Answer, Error> {
    if fine::suits(base)
        && let Some(contact) = fine::solve(base)?
    {
        return Ok(Answer::cells(contact));
    }
    match anchored(base, complementary(base)) {
        Err(error @ (Error::NotComplementary { .. } | Error::Equation(_))) => {
            if let Some((settlement, e)) = base.settlement_at_eccentricity() {
                return reached(base, settlement, e)?.map(Answer::zones).ok_or(error);
            }
            fine::solve(base)?.map(Answer::cells).ok_or(error)
        }
        ending => ending.map(Answer::zones),
    }
}

/// The same answer with heights from the tangent where the zones are, if that is better: beside small zones differences of heights have few digits.
fn anchored(
    base: &Base<'_>,
    known: Result<UnilateralContact, Error>,
) -> Result<UnilateralContact, Error> {
    if base.settlement_at_eccentricity().is_some()
        || base.medium.is_disk()
        || base.medium.is_closed()
    {
        return known;
    }
    let span = match &known {
        Ok(contact) if contact.relative_error() <= DIGITS_LOST => return known,
        Ok(contact) => ends(contact.zones().iter().copied()),
        Err(Error::NotComplementary { .. } | Error::Equation(_)) => {
            let zones = base.first_zones(base.cells()).unwrap_or_default();
            // The line of the force passes between the ends of the contact.
            let line = base.line_of_force().filter(|_| zones.is_empty()).map(|arm| [arm; 2]);
            ends(zones.iter().map(|zone| [zone.left(), zone.right()]).chain(line))
        }
        Err(_) => return known,
    };
    let [left, right] = span;
    if !(right - left < SMALL_ZONES) {
        return known;
    }
    let again = base.anchored(0.5 * (left + right)).map(|base| complementary(&base));
    match (known, again) {
        (Ok(known), Some(Ok(again))) if known.relative_error() <= again.relative_error() => {
            Ok(known)
        }
        (_, Some(Ok(again))) => Ok(again),
        (known, _) => known,
    }
}

/// From the first end of zones to the last.
fn ends(zones: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
    zones.fold([f64::INFINITY, f64::NEG_INFINITY], |[left, right], zone| {
        [left.min(zone[0]), right.max(zone[1])]
    })
}

/// The answer where the force was found first that leads to the settlement.
fn reached(base: &Base<'_>, settlement: f64, e: f64) -> Result<Option<UnilateralContact>, Error> {
    if !base.is_plain() {
        return Ok(None);
    }
    let zones = eccentric::exactly(base, settlement, e)?;
    match corrected_zones(base, zones, &mut 0.0)? {
        Attempt::Found(solved, start) => finished(base, *solved, start).map(Some),
        Attempt::Left(_) => Ok(None),
    }
}

/// The contact on few nodes, without many attempts.
fn quickly(base: &Base<'_>) -> Option<Solved> {
    let zones = base.first_zones(base.cells()).ok()?;
    match corrected_zones(base, zones, &mut 0.0).ok()? {
        Attempt::Found(solved, _) => Some(*solved),
        Attempt::Left(_) => None,
    }
}

/// The answer, with its zones corrected where the finest nodes show what the first did not.
fn complementary(base: &Base<'_>) -> Result<UnilateralContact, Error> {
    let (coarse, start) = find_zones(base)?;
    finished(base, coarse, start)
}

fn finished(
    base: &Base<'_>,
    mut coarse: Solved,
    mut start: f64,
) -> Result<UnilateralContact, Error> {
    for _ in 0..CORRECTIONS {
        let (solved, accuracy, edge) = refined(base, &coarse, start)?;
        let noise = accuracy.pressure / solved.largest().max(f64::MIN_POSITIVE);
        let left = check(base, &solved, ALLOWED.max(2.0 * noise));
        if left.is_clean() {
            return harmonic::answer(base, solved, accuracy, edge, &left);
        }
        let zones = corrected(&solved.zones, &left.pulling, &left.penetrating(1.0));
        if zones.is_empty() {
            break;
        }
        start = strength(base, &zones);
        (coarse, _) =
            edges::settle(base, &Resolution::new(&base.medium, half_count(start, -1))?, &zones)?;
    }
    Err(Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN })
}

/// The answer on few nodes, and the number on either side of the middle of a panel to go on with.
fn find_zones(base: &Base<'_>) -> Result<(Solved, f64), Error> {
    let mut last = None;
    let mut work = 0.0;
    for power in 0..TOPOLOGIES {
        let zones = base.first_zones(base.cells() * 4usize.pow(power as u32))?;
        // Many equal cells show the edges to a thousandth of the few that come first: next to them Newton's method converges.
        let exact = if power == 1 { fine::zones(base)? } else { None };
        for zones in exact.into_iter().chain([zones]) {
            match corrected_zones(base, zones, &mut work)? {
                Attempt::Found(solved, start) => return Ok((*solved, start)),
                Attempt::Left(violation) => last = violation.or(last),
            }
        }
        if work > MOST_WORK {
            break;
        }
    }
    let [tension, penetration] = last.unwrap_or([f64::NAN; 2]);
    Err(Error::NotComplementary { tension, penetration })
}

/// What becomes of zones that the check between the nodes corrects.
enum Attempt {
    Found(Box<Solved>, f64),
    /// Tension and penetration that are left.
    Left(Option<[f64; 2]>),
}

fn corrected_zones(
    base: &Base<'_>,
    mut zones: Vec<Zone>,
    work: &mut f64,
) -> Result<Attempt, Error> {
    let mut start = strength(base, &zones);
    let mut resolution = Resolution::new(&base.medium, half_count(start, -1))?;
    let mut progress = Progress::new();
    let mut left = None;
    for _ in 0..CORRECTIONS {
        if zones.is_empty() || zones.len() > MOST_ZONES || *work > MOST_WORK {
            break;
        }
        let wanted = strength(base, &zones);
        if wanted > start {
            start = wanted;
            resolution = Resolution::new(&base.medium, half_count(start, -1))?;
        }
        let (solved, iterations) = edges::settle(base, &resolution, &zones)?;
        *work += iterations as f64 * (solved.positions.len() as f64).powi(3);
        let check = check(base, &solved, COARSELY_ALLOWED);
        if check.is_clean() {
            return Ok(Attempt::Found(Box::new(solved), start));
        }
        left = Some([check.tension, check.penetration]);
        let room = MOST_NODES as f64 / (2.0 * solved.panels.len() as f64);
        let finer = (start * RATIO).min(MOST_HALF_COUNT).min(room);
        match progress.next(&check, finer > start) {
            Step::Finer => {
                start = finer;
                resolution = Resolution::new(&base.medium, half_count(start, -1))?;
                zones = solved.zones;
            }
            Step::Correct(width) => {
                zones = corrected(&solved.zones, &check.pulling, &check.penetrating(width));
            }
            Step::GiveUp => break,
        }
    }
    Ok(Attempt::Left(left))
}

/// How corrections get on.
struct Progress {
    /// The violation on fewer nodes, infinite after a correction.
    before: f64,
    /// The violation that was corrected last.
    corrected: f64,
    /// Width of the zones that are put where the base penetrates, as a share of the interval where it does.
    width: f64,
}

enum Step {
    Finer,
    Correct(f64),
    GiveUp,
}

impl Progress {
    fn new() -> Self {
        Self { before: f64::INFINITY, corrected: f64::INFINITY, width: 1.0 }
    }

    /// Too few nodes show tension where there is none, and more of them tell; a zone that came in too wide pulled and vanished again.
    fn next(&mut self, check: &Check, can_be_finer: bool) -> Step {
        let worst = check.tension.max(check.penetration);
        let is_same =
            self.corrected.is_finite() && (worst - self.corrected).abs() <= SAME * self.corrected;
        let vanished = is_same && !check.penetrating(1.0).is_empty();
        let doubtful = worst < DOUBTFUL && (is_same || worst < 0.3 * self.before);
        if doubtful && !vanished && can_be_finer {
            self.before = worst;
            return Step::Finer;
        }
        self.width = if vanished { NARROWER * self.width } else { 1.0 };
        self.before = f64::INFINITY;
        self.corrected = worst;
        if self.width < NARROWEST { Step::GiveUp } else { Step::Correct(self.width) }
    }
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

/// The answer on growing numbers of nodes, from the one on the first.
fn refined(base: &Base<'_>, coarse: &Solved, start: f64) -> Result<(Solved, Accuracy, f64), Error> {
    let tolerance = base.problem.solver().tolerance.unwrap_or(AIM);
    let level = |zones: &[Zone], power: i32| {
        let resolution = Resolution::new(&base.medium, half_count(start, power))?;
        edges::settle(base, &resolution, zones).map(|(solved, _)| solved)
    };
    let mut fine = level(&coarse.zones, 0)?;
    let mut before = difference(base, &fine, coarse);
    let mut best: Option<(Solved, Accuracy, f64)> = None;
    for power in 1.. {
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
    (accuracy, of(true, |c| c.edge, 1.0).max(fine.edge_rounding()))
}
