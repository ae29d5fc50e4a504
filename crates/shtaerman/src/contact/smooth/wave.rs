//! A wave over the whole period: in full contact, or in partial contact between the crests.

use std::sync::Arc;

use super::answer::SmoothContact;
use super::band::{Band, wrapped};
use super::check::MOST_POINTS;
use super::full::FullWave;
use super::open::solve_zones;
use super::problem::{Base, Sample, SmoothProblem, SmoothProfile};
use super::{ALLOWED, topology};
use crate::contact::accuracy::ROUNDING;
use crate::contact::extremes::NEGLIGIBLE;
use crate::contact::iteration::STEPS;
use crate::contact::solution::Solution;
use crate::contact::steps::BESIDE;
use crate::error::require;
use crate::{Error, Load, Rotational, Vertical};

/// Where the pressure is least, how small it is there, and its mean deviation.
fn least(along: &[(f64, f64)]) -> (f64, f64, f64) {
    along.iter().fold((0.0, f64::INFINITY, 0.0), |(at, least, size): (f64, f64, f64), &(xi, p)| {
        let size = size.max(p.abs());
        if p < least { (xi, p, size) } else { (at, least, size) }
    })
}

/// Solves for a base that repeats without gaps.
pub(super) fn solve(problem: &SmoothProblem) -> Result<SmoothContact, Error> {
    problem.check()?;
    let band = Band::of(problem);
    let base = &match &band {
        Some(band) => Base::with_samples(problem, vec![band.samples.clone()])?,
        None => Base::new(problem)?,
    };
    let Load { vertical, rotational } = problem.load;
    let level = matches!(rotational, Rotational::Tilt(tilt) if tilt == 0.0);
    let given = match rotational {
        Rotational::Tilt(value) | Rotational::Moment(value) | Rotational::Eccentricity(value) => {
            value
        }
    };
    let requirement =
        "tilt = 0 for a base that repeats without gaps: neither a tilt nor a moment repeats";
    require(level, "tilt", given, requirement)?;
    let step = (base.height(1.0 - BESIDE) - base.height(BESIDE - 1.0)).abs();
    let requirement = "the same at both ends of a period";
    require(step <= 1e-6 * base.range(), "profile", base.height(1.0), requirement)?;
    let force = match vertical {
        Vertical::Force(force) => force,
        Vertical::Settlement(_) => 0.0,
    };
    let full = FullWave::new(problem, band.as_ref(), force);
    let along = full.along((4 * base.cells()).min(MOST_POINTS));
    let (place, least, size) = least(&along);
    let pulls = |p: f64| problem.is_unilateral && p < -ALLOWED * size;
    let lowest = full.lowest(&along);
    let lower = |one: (f64, f64), two: (f64, f64)| if two.1 < one.1 { two } else { one };
    let others = [lowest, full.beside_kink(), full.between(&problem.profile.breaks)];
    let (place, least) = others.into_iter().flatten().fold((place, least), lower);
    // The seam is best left where it is as deep in the valley.
    let bottom = place;
    let is_seam = full.pressure(-1.0) <= least + NEGLIGIBLE * size;
    let place = if is_seam { 1.0 } else { place };
    let partial = || Partial::new(problem, band.as_ref(), place);
    if let Vertical::Settlement(settlement) = vertical {
        let requirement = "less than the mean height of the profile: in full contact it is that mean, whatever the force";
        let is_partial = problem.is_unilateral && settlement < full.settlement();
        require(is_partial, "settlement", settlement, requirement)?;
        // Without force the least pressure is minus that which closes all gaps.
        let first = |force: f64| full.first_zone(&along, (bottom, least), force);
        return sunk(partial(), first, settlement, -2.0 * least);
    }
    if !pulls(least) {
        return Ok(SmoothContact::full(base, full));
    }
    partial().solve(force, full.first_zone(&along, (bottom, least), force))
}

/// The force for a settlement, by Newton's method between bounds: a constant pressure moves nothing, so the equation for a given settlement is badly posed
/// near full contact.
fn sunk(
    mut partial: Partial<'_>,
    first: impl Fn(f64) -> Option<[f64; 2]>,
    settlement: f64,
    limit: f64,
) -> Result<SmoothContact, Error> {
    let (mut low, mut high) = (0.0, limit);
    let mut force = 0.3 * limit;
    let mut last = None;
    for _ in 0..STEPS {
        let contact = partial.solve(force, first(force))?;
        let excess = contact.state().settlement - settlement;
        if excess > 0.0 {
            high = force;
        } else {
            low = force;
        }
        let newton = force - excess * contact.stiffness().force_settlement;
        last = Some(contact.settled(settlement));
        let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        if (next - force).abs() <= ROUNDING * force {
            break;
        }
        force = next;
    }
    last.ok_or(Error::NoContact)
}

/// Partial contact of a wave, seen from where full contact pulls most.
struct Partial<'p> {
    problem: &'p SmoothProblem,
    band: Option<&'p Band>,
    turned: Turned,
}

impl<'p> Partial<'p> {
    fn new(problem: &'p SmoothProblem, band: Option<&'p Band>, place: f64) -> Self {
        Self { problem, band, turned: Turned::new(problem, band, place) }
    }

    /// The answer for a force; a zone to try first is one of the wave as it is.
    fn solve(&mut self, force: f64, first: Option<[f64; 2]>) -> Result<SmoothContact, Error> {
        let load = Load { vertical: Vertical::Force(force), ..self.problem.load };
        let loaded = |turned: &Turned| SmoothProblem { load, ..turned.problem.clone() };
        let problem = loaded(&self.turned);
        let contact = match self.turned.solve(&problem, first) {
            Ok(contact) => contact,
            Err(error) => {
                // Where full contact pulls most partial contact may touch.
                let Some(gap) = self.turned.gap(&problem) else { return Err(error) };
                self.turned = Turned::new(self.problem, self.band, gap);
                self.turned.solve(&loaded(&self.turned), first)?
            }
        };
        Ok(contact.turned(self.problem, self.turned.place))
    }
}

/// A problem with its seam at another place.
struct Turned {
    problem: SmoothProblem,
    /// The place that became `+-1`.
    place: f64,
    /// Samples of the turned profile, where they are those of the profile.
    samples: Option<Vec<Sample>>,
}

impl Turned {
    fn new(problem: &SmoothProblem, band: Option<&Band>, place: f64) -> Self {
        let Some(band) = band else {
            let seam = Some(1.0);
            return Self { problem: moved(problem, place, seam), place, samples: None };
        };
        let samples = Some(band.turned(place));
        Self { problem: moved(problem, place, None), place, samples }
    }

    fn base<'q>(&self, problem: &'q SmoothProblem) -> Result<Base<'q>, Error> {
        match &self.samples {
            Some(samples) => Base::with_samples(problem, vec![samples.clone()]),
            None => Base::new(problem),
        }
    }

    /// The middle of the longest gap on cells where these show contact on both sides of the seam, as a place of the wave as it is.
    fn gap(&self, problem: &SmoothProblem) -> Option<f64> {
        let base = self.base(problem).ok()?;
        let intervals = topology::find(&base, base.cells()).ok()?;
        gap_between(&intervals).map(|middle| wrapped(middle + self.place - 1.0))
    }

    /// The answer for a problem that differs by its load only; a zone to try first is one of the profile before the turn.
    fn solve(
        &self,
        problem: &SmoothProblem,
        first: Option<[f64; 2]>,
    ) -> Result<SmoothContact, Error> {
        let base = self.base(problem)?;
        let zone = first.and_then(|[left, right]| {
            let middle = wrapped(0.5 * (left + right) - self.place + 1.0);
            let half = 0.5 * (right - left);
            let [left, right] = [middle - half, middle + half];
            (-1.0 < left && left < right && right < 1.0).then(|| base.walls.zone([left, right]))
        });
        solve_zones(&base, zone)
    }
}

/// The middle of the longest gap between intervals that touch both ends of the period; none where there is no gap, or no contact at the ends.
fn gap_between(intervals: &[[f64; 2]]) -> Option<f64> {
    let ([first, ..], [.., last]) = (intervals, intervals) else { return None };
    let gaps = intervals.windows(2).map(|pair| [pair[0][1], pair[1][0]]);
    let longest = gaps.max_by(|one, other| (one[1] - one[0]).total_cmp(&(other[1] - other[0])));
    let touches = first[0] <= -1.0 && last[1] >= 1.0;
    longest.filter(|_| touches).map(|[left, right]| 0.5 * (left + right))
}

/// The problem turned until a place is its seam; where it bends at its own seam, that is a break.
fn moved(problem: &SmoothProblem, place: f64, seam: Option<f64>) -> SmoothProblem {
    // The place becomes +-1.
    let shift = place - 1.0;
    let turned = move |xi: f64| wrapped(xi + shift);
    let SmoothProfile { height, slope, breaks, joints, tolerance } = problem.profile.clone();
    let moved = |places: Vec<f64>, seam: Option<f64>| {
        let places = places.into_iter().chain(seam).map(|at| wrapped(at - shift));
        let mut places: Vec<f64> = places.collect();
        places.sort_by(f64::total_cmp);
        places
    };
    let profile = SmoothProfile {
        height: Arc::new(move |xi| height(turned(xi))),
        slope: slope.map(|slope| Arc::new(move |xi| slope(turned(xi))) as super::Curve),
        breaks: moved(breaks, seam),
        joints: moved(joints, None),
        tolerance,
    };
    SmoothProblem { profile, ..problem.clone() }
}
