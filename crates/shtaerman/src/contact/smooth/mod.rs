//! The smooth limit: contact without a layer, plane, of a pair of punches, or periodic.
//!
//! `theta0 int K(xi - eta) p0(eta) deta = delta0 - alpha0 xi - f0(xi)` on the zones. The pressure is singular at the walls of the base,
//! `p0 = K/sqrt(2 pi d)` at a distance `d`, and vanishes as `sqrt(d)` at free edges.
//!
//! On given zones the [system] is solved by the spectral relation of the logarithm; in unilateral contact the [topology] is found on cells, the
//! free [edges] by Newton's method, and the [check] between nodes corrects the topology. A base that repeats without gaps has its own
//! [answer](wave) in full contact.

mod answer;
mod balance;
mod band;
mod check;
mod coupling;
mod density;
mod disk;
mod edges;
mod free_ends;
mod graded;
mod ground;
mod harmonics;
mod kernel;
mod legendre;
mod linear;
mod linearised;
mod panels;
mod problem;
mod slopes;
mod stated;
mod system;
mod topology;
mod wave;
mod zones;

pub use answer::{SmoothContact, SmoothZone};
pub use disk::{SmoothDisk, SmoothDiskContact, SmoothRingsContact};
pub use kernel::SmoothKernel;
pub use problem::{Curve, SmoothProblem, SmoothProfile};

use crate::Error;
use crate::contact::valleys::require_shown;
use check::{Narrowing, check};
use problem::{Base, MOST_CELLS};
use zones::{Zone, corrected, require_few};

/// How finely pressures on zones are resolved.
#[derive(Debug, Clone, Copy)]
struct Detail {
    /// Digits to which modes are kept.
    digits: f64,
    /// Panels of the slopes on a half turn before any is halved.
    panels: usize,
}

/// Detail while zones are looked for, in the answer, and for its error: with other panels rounding comes out differently, too.
const COARSE: Detail = Detail { digits: 9.0, panels: 8 };
const FINE: Detail = Detail { digits: 17.0, panels: 8 };
const COMPARED: Detail = Detail { digits: 12.0, panels: 7 };
/// Tension and penetration, relative to their scales, that are corrected at first, and in the answer.
const COARSELY_ALLOWED: f64 = 1e-6;
const ALLOWED: f64 = 2e-10;
/// Corrections of the topology by the check, for each number of cells.
const CORRECTIONS: usize = 16;
/// Numbers of cells, each four times the one before.
const TOPOLOGIES: usize = 3;
/// Most zones that are solved: beyond, minutes go by.
const MOST_ZONES: usize = 120;

impl SmoothProblem {
    /// Solves the equation, and in unilateral contact finds the zones.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a problem that is not one, a force that is not positive in unilateral contact, a step inside a base in bilateral
    /// contact, and for a base that repeats without gaps anything but `tilt = 0`; [`Error::TipsOver`], [`Error::NoContact`];
    /// [`Error::NotComplementary`] when no zones were found; [`Error::Equation`] where zones come too close to one another, or are too
    /// many, for the modes that can be kept.
    pub fn solve(&self) -> Result<SmoothContact, Error> {
        if self.is_wave() {
            return wave::solve(self);
        }
        solve_zones(&Base::new(self)?, None)
    }
}

/// The answer on the zones of a base, for which a zone to try first may be known.
fn solve_zones(base: &Base<'_>, first: Option<Zone>) -> Result<SmoothContact, Error> {
    if base.problem.is_unilateral {
        return match first.and_then(|zone| tried(base, zone)) {
            Some(contact) => contact,
            None => complementary(base),
        };
    }
    let solved = system::Solved::new(base, &base.pieces(), FINE)?;
    let left = check(base, &solved, ALLOWED);
    SmoothContact::new(base, solved, &left)
}

/// The answer if this zone leads there: the pressure without tension and penetration is but one.
fn tried(base: &Base<'_>, zone: Zone) -> Option<Result<SmoothContact, Error>> {
    let solved = edges::settle(base, &[zone], FINE).ok()?;
    let left = check(base, &solved, ALLOWED);
    left.is_clean().then(|| SmoothContact::new(base, solved, &left))
}

/// The answer, with its zones corrected where all modes show what few did not.
fn complementary(base: &Base<'_>) -> Result<SmoothContact, Error> {
    let mut zones = find_zones(base)?;
    let mut last = [f64::NAN; 2];
    let mut narrowing = Narrowing::new();
    for _ in 0..CORRECTIONS {
        let solved = match edges::settle(base, &zones, FINE) {
            Ok(solved) => solved,
            // What is left of an attempt says more than why the next had none.
            Err(_) if last[1].is_finite() => break,
            Err(error) => return Err(error),
        };
        let left = check(base, &solved, ALLOWED);
        if left.is_clean() {
            return SmoothContact::new(base, solved, &left);
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
fn find_zones(base: &Base<'_>) -> Result<Vec<Zone>, Error> {
    let mut last = Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN };
    let valleys: Vec<f64> = base.valleys().collect();
    let counts = (0..TOPOLOGIES).map(|power| base.cells() * 4usize.pow(power as u32));
    let mut counts: Vec<usize> = counts.map(|count| count.min(MOST_CELLS)).collect();
    counts.dedup();
    for count in counts {
        let intervals = match topology::find(base, count) {
            Ok(intervals) => intervals,
            Err(error) => {
                last = error;
                continue;
            }
        };
        require_shown(&intervals, &valleys, count, MOST_ZONES)?;
        let mut zones: Vec<Zone> =
            intervals.iter().map(|[left, right]| base.zone(*left, *right)).collect();
        let mut narrowing = Narrowing::new();
        for _ in 0..CORRECTIONS {
            if zones.is_empty() {
                break;
            }
            require_few(&zones, MOST_ZONES)?;
            let solved = match edges::settle(base, &zones, COARSE) {
                Ok(solved) => solved,
                Err(error) => {
                    last = error;
                    break;
                }
            };
            let left = check(base, &solved, COARSELY_ALLOWED);
            if left.is_clean() {
                return Ok(solved.parts.iter().map(|part| part.zone).collect());
            }
            let (tension, penetration) = (left.tension, left.penetration);
            last = Error::NotComplementary { tension, penetration };
            let Some(width) = narrowing.next(left.penetration) else { break };
            zones = amended(base, &solved, &left, width);
        }
    }
    Err(last)
}

/// The zones without tension and with what penetrates, in zones of this share.
fn amended(base: &Base<'_>, solved: &system::Solved, left: &check::Check, width: f64) -> Vec<Zone> {
    let zones: Vec<Zone> = solved.parts.iter().map(|part| part.zone).collect();
    let intervals = corrected(&zones, &left.pulling, &left.narrowed(width));
    intervals.iter().map(|[left, right]| base.zone(*left, *right)).collect()
}
