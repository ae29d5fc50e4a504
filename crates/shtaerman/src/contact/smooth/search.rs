//! The search for the zones of plane contact and of rings: cells show them first, and the check between the nodes corrects them.

use super::check::{Check, Narrowing};
use super::zones::{Zone, corrected, require_few};
use super::{ALLOWED, COARSE, COARSELY_ALLOWED, Detail, FINE};
use crate::Error;
use crate::contact::valleys::require_shown;

/// Corrections of the topology by the check, for each number of cells.
const CORRECTIONS: usize = 16;
/// Numbers of cells, each four times the one before.
const TOPOLOGIES: usize = 3;
/// Below this a violation may come from too few modes.
const DOUBTFUL: f64 = 1e-2;

/// A base on which zones can be looked for.
pub(super) trait Searched {
    /// A solution on zones.
    type Solved;
    /// Most zones that are solved: beyond, minutes go by.
    const MOST_ZONES: usize;

    /// Cells to begin with, and most of them.
    fn cells(&self) -> [usize; 2];

    /// Where the profile has valleys.
    fn valleys(&self) -> Vec<f64>;

    /// The intervals of contact on about so many cells.
    fn intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error>;

    /// A zone whose ends are free unless they are walls, or beyond them.
    fn zone(&self, left: f64, right: f64) -> Zone;

    /// The solution on zones near these, whose free ends are moved to where the density vanishes.
    fn settle(&self, zones: &[Zone], detail: Detail) -> Result<Self::Solved, Error>;

    /// Tension and penetration of a solution, listed beyond `allowed`.
    fn check(&self, solved: &Self::Solved, allowed: f64) -> Check;

    /// The zones of a solution.
    fn zones(solved: &Self::Solved) -> Vec<Zone>;

    /// Tension and penetration, relative to their scales, that the modes do not resolve.
    fn noise(&self, _solved: &Self::Solved, _left: &Check) -> f64 {
        0.0
    }
}

/// The solution, with its zones corrected where all modes show what few did not, and what is left.
pub(super) fn complementary<B: Searched>(base: &B) -> Result<(B::Solved, Check), Error> {
    let mut zones = find_zones(base)?;
    let mut last = [f64::NAN; 2];
    let mut narrowing = Narrowing::new();
    for _ in 0..CORRECTIONS {
        let solved = match base.settle(&zones, FINE) {
            Ok(solved) => solved,
            // What is left of an attempt says more than why the next had none.
            Err(_) if last[1].is_finite() => break,
            Err(error) => return Err(error),
        };
        let left = base.check(&solved, ALLOWED);
        // What the modes do not resolve is no reason to correct zones.
        let is_noise = || {
            let noise = base.noise(&solved, &left).min(COARSELY_ALLOWED);
            noise > ALLOWED && base.check(&solved, noise).is_clean()
        };
        if left.is_clean() || is_noise() {
            return Ok((solved, left));
        }
        last = [left.tension, left.penetration];
        let Some(width) = narrowing.next(left.penetration) else { break };
        zones = amended(base, &solved, &left, width);
        if zones.is_empty() {
            break;
        }
    }
    Err(Error::NotComplementary { tension: last[0], penetration: last[1] })
}

/// The zones with few modes.
fn find_zones<B: Searched>(base: &B) -> Result<Vec<Zone>, Error> {
    let mut last = Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN };
    let valleys = base.valleys();
    let [first, most] = base.cells();
    let counts = (0..TOPOLOGIES).map(|power| first * 4usize.pow(power as u32));
    let mut counts: Vec<usize> = counts.map(|count| count.min(most)).collect();
    counts.dedup();
    let mut doubtful = Doubtful { violation: DOUBTFUL, zones: None };
    for count in counts {
        let zones = base.intervals(count).and_then(|intervals| {
            require_shown(&intervals, &valleys, count, B::MOST_ZONES)?;
            corrected_zones(base, zones(base, &intervals), &mut doubtful)
        });
        match zones {
            Ok(zones) => return Ok(zones),
            Err(error @ Error::TooManyZones { .. }) => return Err(error),
            // What is left of an attempt says more than that the next came to no end.
            Err(Error::Equation(_)) if is_attempt(&last) => {}
            Err(error) => last = error,
        }
    }
    // All modes tell whether there is anything left.
    doubtful.zones.ok_or(last)
}

/// The zones with the least violation so small that all modes may show none.
struct Doubtful {
    violation: f64,
    zones: Option<Vec<Zone>>,
}

fn is_attempt(error: &Error) -> bool {
    matches!(error, Error::NotComplementary { penetration, .. } if penetration.is_finite())
}

fn corrected_zones<B: Searched>(
    base: &B,
    mut zones: Vec<Zone>,
    doubtful: &mut Doubtful,
) -> Result<Vec<Zone>, Error> {
    let mut last = Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN };
    let mut narrowing = Narrowing::new();
    for _ in 0..CORRECTIONS {
        if zones.is_empty() {
            break;
        }
        require_few(&zones, B::MOST_ZONES)?;
        let solved = base.settle(&zones, COARSE)?;
        let left = base.check(&solved, COARSELY_ALLOWED);
        if left.is_clean() {
            return Ok(B::zones(&solved));
        }
        let Check { tension, penetration, .. } = left;
        if tension.max(penetration) < doubtful.violation {
            let zones = Some(B::zones(&solved));
            *doubtful = Doubtful { violation: tension.max(penetration), zones };
        }
        last = Error::NotComplementary { tension, penetration };
        let Some(width) = narrowing.next(penetration) else { break };
        zones = amended(base, &solved, &left, width);
    }
    Err(last)
}

/// The zones without tension and with what penetrates, in zones of this share.
fn amended<B: Searched>(base: &B, solved: &B::Solved, left: &Check, width: f64) -> Vec<Zone> {
    let intervals = corrected(&B::zones(solved), &left.pulling, &left.narrowed(width));
    zones(base, &intervals)
}

fn zones<B: Searched>(base: &B, intervals: &[[f64; 2]]) -> Vec<Zone> {
    intervals.iter().map(|[left, right]| base.zone(*left, *right)).collect()
}
