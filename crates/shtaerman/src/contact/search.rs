//! The search for the zones of contact, on one page.
//!
//! 1. A complementarity problem on cells shows the zones to about a cell.
//! 2. On these the equation is solved, and [Newton's method](super::edges) moves free ends to where the pressure vanishes.
//! 3. A [check](super::check) between the nodes looks for tension in the zones and penetration beside them.
//! 4. Where it finds any the zones are corrected, or more nodes taken, and all begins again; else the answer is refined, and checked once more.
//!
//! Once a [deadline](Deadline) is past every step takes what there is: what comes of it is no answer, but the best so far.

use super::check::Check;
use super::edges::{self, EndState};
use super::resolutions::SLOW;
use super::valleys::require_shown;
use super::zones::{Walls, Zone, corrected, require_few};
use crate::Error;
use crate::deadline::Deadline;

/// Tension and penetration, relative to their scales, that are corrected on few nodes, and in the answer (survey).
pub(super) const COARSELY_ALLOWED: f64 = 1e-6;
pub(super) const ALLOWED: f64 = 2e-10;
/// Corrections of the zones by the check, for each number of cells (survey).
pub(super) const CORRECTIONS: usize = 16;
/// Below this a violation that falls with more nodes comes from too few; one that changes by less than this share of itself is the same again (survey).
const DOUBTFUL: f64 = 1e-2;
/// How zones that vanished are narrowed for the next attempt. At half or twice 3 of 12 answers change, within what they state (survey).
const NARROWER: f64 = 0.2;

/// So many numbers of cells are tried (survey).
const TOPOLOGIES: u32 = 3;

/// Where a search begins.
#[derive(Debug, Clone, Copy)]
pub(super) enum Start {
    /// On the whole base.
    Whole,
    /// On zones that about so many cells show.
    Cells(usize),
}

impl Start {
    /// Numbers of cells, each four times the one before.
    pub(super) fn on_cells(first: usize, most: usize) -> Vec<Self> {
        let counts = (0..TOPOLOGIES).map(|power| (first * 4usize.pow(power)).min(most));
        let mut counts: Vec<usize> = counts.collect();
        counts.dedup();
        counts.into_iter().map(Self::Cells).collect()
    }
}

/// An equation that can be solved on given zones.
pub(super) trait Equation {
    /// The solution on zones.
    type Solved;
    /// How finely it is resolved.
    type Effort;
    /// Most zones that are solved: their equations are dense.
    const MOST_ZONES: usize;

    /// Whether the base may lift off.
    fn may_lift(&self) -> bool;

    /// When the search has to come to its end.
    fn deadline(&self) -> &Deadline;

    /// Where ends of zones can rest.
    fn walls(&self) -> &Walls;

    /// Whether a zone may reach over a step of the base.
    fn spans_steps(&self) -> bool {
        false
    }

    /// Whether the value at an end changes with that end alone, so that the last step tells the next and one that made it worse was too long: not beside narrow gaps of smooth
    /// surfaces, whose ends depend on each other.
    fn ends_are_apart(&self) -> bool {
        false
    }

    /// A zone about this interval.
    fn zone(&self, interval: [f64; 2]) -> Zone {
        self.walls().zone(interval)
    }

    /// Zones as symmetry has them.
    fn arranged(&self, zones: Vec<Zone>) -> Vec<Zone> {
        zones
    }

    /// Where to begin, one after the other.
    fn starts(&self) -> Vec<Start>;

    /// The pieces of the base.
    fn pieces(&self) -> Vec<[f64; 2]>;

    /// Where the profile has valleys.
    fn valleys(&self) -> Vec<f64>;

    /// The intervals of contact on about so many cells.
    fn intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error>;

    /// The effort with which zones near these are looked for, no less than was taken before.
    fn effort(&self, zones: &[Zone], before: Option<Self::Effort>) -> Result<Self::Effort, Error>;

    /// More effort; none where that is not to be had.
    fn finer(&self, _solved: &Self::Solved, _effort: &Self::Effort) -> Option<Self::Effort> {
        None
    }

    /// The solution on these zones, perhaps from one on zones nearby.
    fn solve(
        &self,
        zones: &[Zone],
        effort: &Self::Effort,
        near: Option<&Self::Solved>,
    ) -> Result<Self::Solved, Error>;

    /// The zones of a solution.
    fn zones(&self, solved: &Self::Solved) -> Vec<Zone>;

    /// The force on a zone, or a multiple of it.
    fn force(&self, solved: &Self::Solved, zone: usize) -> f64;

    /// What is known at both ends of each zone, found with this effort.
    fn ends(&self, solved: &Self::Solved, effort: &Self::Effort) -> Vec<[EndState; 2]>;

    /// Tension and penetration, listed beyond `allowed`.
    fn check(&self, solved: &Self::Solved, allowed: f64) -> Check;

    /// The answer, from what was found with this effort.
    fn refined(&self, coarse: Self::Solved, effort: &Self::Effort) -> Result<Self::Solved, Error>;

    /// Whether that takes a solution as it is, as more effort adds nothing.
    fn is_refined(&self, _solved: &Self::Solved) -> bool {
        false
    }

    /// Tension and penetration, relative to their scales, that an answer does not resolve.
    fn noise(&self, _solved: &Self::Solved, _left: &Check) -> f64 {
        0.0
    }
}

/// The answer where the base may lift off, and what is left of tension and penetration.
///
/// # Errors
/// [`Error::NotComplementary`] where no zones were found, [`Error::TooManyZones`]; those of the solutions.
pub(super) fn complementary<E: Equation>(equation: &E) -> Result<(E::Solved, Check), Error> {
    let Coarse { solved: mut coarse, mut effort, mut left } = found(equation)?;
    if equation.deadline().is_past() {
        let left = left.unwrap_or_else(|| equation.check(&coarse, ALLOWED));
        return Ok((coarse, left));
    }
    let mut last = unknown();
    let mut progress = Progress::new();
    for _ in 0..CORRECTIONS {
        let solved = match equation.refined(coarse, &effort) {
            Ok(solved) => solved,
            // What is left of an attempt says more than why the next had none.
            Err(_) if is_attempt(&last) => break,
            Err(error) => return Err(error),
        };
        let left = left.take().unwrap_or_else(|| equation.check(&solved, ALLOWED));
        // What the nodes do not resolve is no reason to correct zones.
        let is_noise = || {
            let noise = equation.noise(&solved, &left);
            noise > ALLOWED && equation.check(&solved, noise).is_clean()
        };
        if left.is_clean() || equation.deadline().is_past() || is_noise() {
            return Ok((solved, left));
        }
        last = left.as_error();
        let Next::Correct(width) = progress.next(&left, || false) else { break };
        let zones = amended(equation, &solved, &left, width);
        if zones.is_empty() {
            break;
        }
        effort = equation.effort(&zones, Some(effort))?;
        coarse = match edges::settle(equation, &zones, &effort, None) {
            Ok(solved) => solved,
            Err(_) => break,
        };
    }
    Err(last)
}

/// An answer on few nodes, with their effort.
struct Coarse<E: Equation> {
    solved: E::Solved,
    effort: E::Effort,
    /// What is left of tension and penetration, where that is known as of an answer.
    left: Option<Check>,
}

fn found<E: Equation>(equation: &E) -> Result<Coarse<E>, Error> {
    let mut last = unknown();
    let mut doubtful = Doubtful { violation: DOUBTFUL, zones: None };
    let valleys = equation.valleys();
    for start in equation.starts() {
        let zones = match start {
            Start::Whole => Ok(equation.pieces()),
            Start::Cells(count) => equation.intervals(count).and_then(|intervals| {
                require_shown(&intervals, &valleys, count, E::MOST_ZONES)?;
                Ok(intervals)
            }),
        };
        let zones = zones.map(|intervals| zones_about(equation, &intervals));
        match zones.and_then(|zones| corrected_zones(equation, zones, &mut doubtful)) {
            Ok(found) => return Ok(found),
            Err(error @ Error::TooManyZones { .. }) => return Err(error),
            // What is left of an attempt says more than that the next came to no end.
            Err(Error::Equation(_)) if is_attempt(&last) => {}
            Err(error) => last = error,
        }
        if equation.deadline().is_past() {
            return Err(last);
        }
    }
    // All nodes tell whether there is anything left.
    let Some(zones) = doubtful.zones else { return Err(last) };
    let effort = equation.effort(&zones, None)?;
    Ok(Coarse { solved: edges::settle(equation, &zones, &effort, None)?, effort, left: None })
}

/// The zones with the least violation so small that more nodes may show none.
struct Doubtful {
    violation: f64,
    zones: Option<Vec<Zone>>,
}

fn corrected_zones<E: Equation>(
    equation: &E,
    mut zones: Vec<Zone>,
    doubtful: &mut Doubtful,
) -> Result<Coarse<E>, Error> {
    let mut effort = equation.effort(&zones, None)?;
    let mut last = unknown();
    let mut progress = Progress::new();
    for _ in 0..CORRECTIONS {
        if zones.is_empty() {
            break;
        }
        require_few(&zones, E::MOST_ZONES)?;
        effort = equation.effort(&zones, Some(effort))?;
        let solved = edges::settle(equation, &zones, &effort, None)?;
        if equation.deadline().is_past() {
            return Ok(Coarse { solved, effort, left: None });
        }
        let last_of_all = equation.is_refined(&solved).then(|| equation.check(&solved, ALLOWED));
        if last_of_all.as_ref().is_some_and(Check::is_clean) {
            return Ok(Coarse { solved, effort, left: last_of_all });
        }
        let left = equation.check(&solved, COARSELY_ALLOWED);
        if left.is_clean() {
            return Ok(Coarse { solved, effort, left: last_of_all });
        }
        if left.violation() < doubtful.violation {
            let zones = Some(equation.zones(&solved));
            *doubtful = Doubtful { violation: left.violation(), zones };
        }
        last = left.as_error();
        let mut finer = None;
        let next = progress.next(&left, || {
            finer = equation.finer(&solved, &effort);
            finer.is_some()
        });
        match (next, finer) {
            (Next::Finer, Some(finer)) => {
                (effort, zones) = (finer, equation.zones(&solved));
            }
            (Next::Correct(width), _) => zones = amended(equation, &solved, &left, width),
            _ => break,
        }
    }
    Err(last)
}

/// The zones without tension and with what penetrates, in zones of this share.
fn amended<E: Equation>(equation: &E, solved: &E::Solved, left: &Check, width: f64) -> Vec<Zone> {
    let intervals = corrected(&equation.zones(solved), &left.pulling, &left.narrowed(width));
    zones_about(equation, &intervals)
}

fn zones_about<E: Equation>(equation: &E, intervals: &[[f64; 2]]) -> Vec<Zone> {
    intervals.iter().map(|interval| equation.zone(*interval)).collect()
}

/// Nothing is known of what was left.
pub(super) fn unknown() -> Error {
    Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN }
}

fn is_attempt(error: &Error) -> bool {
    matches!(error, Error::NotComplementary { penetration, .. } if penetration.is_finite())
}

/// How corrections get on.
struct Progress {
    /// The violation on fewer nodes, infinite after a correction.
    before: f64,
    /// The violation and the penetration that were corrected last.
    corrected: [f64; 2],
    /// Width of the zones that are put where the base penetrates, as a share of the interval where it does.
    width: f64,
}

/// What to do next.
enum Next {
    /// Take more nodes.
    Finer,
    /// Correct the zones, those that are added as wide as this share.
    Correct(f64),
}

impl Progress {
    fn new() -> Self {
        Self { before: f64::INFINITY, corrected: [f64::INFINITY; 2], width: 1.0 }
    }

    /// Too few nodes show tension where there is none, and more of them tell; a zone that came in too wide pulled and vanished again, and leaves the same penetration.
    fn next(&mut self, left: &Check, can_be_finer: impl FnOnce() -> bool) -> Next {
        let worst = left.violation();
        let is_same =
            |one: f64, other: f64| one.is_finite() && (one - other).abs() <= DOUBTFUL * one;
        let [violation, penetration] = self.corrected;
        let vanished = !left.penetrating.is_empty() && is_same(penetration, left.penetration);
        // What a correction leaves as it was is none of the zones.
        let is_doubtful = is_same(violation, worst)
            || (worst < DOUBTFUL || left.is_between_nodes) && worst < SLOW * self.before;
        // Narrower ones are tried once before more nodes are.
        let narrows = vanished && self.width == 1.0;
        if is_doubtful && !narrows && can_be_finer() {
            self.before = worst;
            return Next::Finer;
        }
        self.width = if vanished { NARROWER * self.width } else { 1.0 };
        self.before = f64::INFINITY;
        self.corrected = [worst, left.penetration];
        Next::Correct(self.width)
    }
}
