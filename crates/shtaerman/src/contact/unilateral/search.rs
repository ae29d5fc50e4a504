//! The search for zones: cells show them first, and the check between the nodes corrects them.

use super::base::{Base, MOST_CELLS};
use super::check::{Check, check};
use super::refinement::{RATIO, half_count, strength};
use super::solved::Solved;
use super::system::Resolution;
use super::zones::{Zone, corrected};
use super::{COARSELY_ALLOWED, CORRECTIONS, edges};
use crate::Error;
use crate::contact::valleys;

/// Below this a violation may come from too few nodes.
const DOUBTFUL: f64 = 1e-2;
/// Most nodes on either side of the middle of a panel while zones are looked for.
const MOST_HALF_COUNT: f64 = 300.0;
/// A violation that changes by less than this share is the same again.
const SAME: f64 = 1e-2;
/// How zones that vanished are narrowed for the next attempt, and how often: then more cells are tried.
const NARROWER: f64 = 0.2;
const NARROWEST: f64 = 1e-4;
/// Numbers of cells, each four times the one before.
const TOPOLOGIES: usize = 3;
/// Cubes of the numbers of nodes, added up over Newton steps, after which the search for zones ends.
const MOST_WORK: f64 = 1e10;
/// Most zones that are collocated.
const MOST_ZONES: usize = 40;
/// So many on cells are too many whatever more cells would show.
const FAR_TOO_MANY: usize = 50;

/// The answer on few nodes, and the number on either side of the middle of a panel to go on with.
pub(super) fn find_zones(base: &Base<'_>) -> Result<(Solved, f64), Error> {
    let mut last = None;
    let mut too_many = None;
    let mut work = 0.0;
    let counts = (0..TOPOLOGIES).map(|power| base.cells() * 4usize.pow(power as u32));
    let mut counts: Vec<usize> = counts.map(|count| count.min(MOST_CELLS)).collect();
    counts.dedup();
    for count in counts {
        let zones = base.first_zones(count)?;
        require_few(base, &zones, count)?;
        if zones.len() > MOST_ZONES {
            too_many = Some(Error::TooManyZones { zones: zones.len(), most: MOST_ZONES });
            continue;
        }
        match corrected_zones(base, zones, &mut work)? {
            Attempt::Found(solved, start) => return Ok((*solved, start)),
            Attempt::Left(violation) => last = violation.or(last),
        }
        if work > MOST_WORK.min(base.effort.work) {
            break;
        }
    }
    let [tension, penetration] = last.unwrap_or([f64::NAN; 2]);
    Err(too_many.unwrap_or(Error::NotComplementary { tension, penetration }))
}

/// Refuses far more zones than are collocated, seen by cells or hidden from them.
fn require_few(base: &Base<'_>, zones: &[Zone], cells: usize) -> Result<(), Error> {
    if zones.len() > FAR_TOO_MANY {
        return Err(Error::TooManyZones { zones: zones.len(), most: MOST_ZONES });
    }
    let found: Vec<[f64; 2]> = zones.iter().map(|zone| [zone.left(), zone.right()]).collect();
    let valleys: Vec<f64> = valleys::valleys(&base.samples).collect();
    valleys::require_shown(&found, &valleys, cells, MOST_ZONES)
}

/// What becomes of zones that the check between the nodes corrects.
pub(super) enum Attempt {
    Found(Box<Solved>, f64),
    /// Tension and penetration that are left.
    Left(Option<[f64; 2]>),
}

pub(super) fn corrected_zones(
    base: &Base<'_>,
    mut zones: Vec<Zone>,
    work: &mut f64,
) -> Result<Attempt, Error> {
    let mut start = strength(base, &zones);
    let mut resolution = Resolution::new(&base.medium, half_count(start, -1))?;
    let mut progress = Progress::new();
    let mut left = None;
    for _ in 0..CORRECTIONS {
        let is_done = *work > MOST_WORK.min(base.effort.work);
        if zones.is_empty() || zones.len() > MOST_ZONES || is_done {
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
        let room = base.effort.nodes as f64 / (2.0 * solved.panels.len() as f64);
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
