//! A wave over the whole period: full contact by the conjugate of its slope, partial contact between the crests.

use std::f64::consts::{PI, SQRT_2, TAU};
use std::sync::Arc;

use super::angular::Angular;
use super::answer::SmoothContact;
use super::band::Band;
use super::detail::{COMPARED, FINE};
use super::open::solve_zones;
use super::problem::{Base, Sample, SmoothProblem, SmoothProfile};
use super::slopes::Slopes;
use super::{ALLOWED, topology};
use crate::contact::solution::Solution;
use crate::error::require;
use crate::{Error, Load, Rotational, Vertical};

/// Where both sides of the seam are compared, and the share of the profile's range that makes a jump.
const SEAM: f64 = 1e-9;
/// Points at which the pressure of full contact is looked at, at least and at most.
const POINTS: usize = 256;
const MOST_POINTS: usize = 3072;
/// By this share of the pressure the bottom of a valley is no deeper than another place.
const AS_DEEP: f64 = 1e-12;
/// Parts of the stretch between two cuts of the profile.
const BETWEEN: usize = 16;
/// How near a kink the pressure is looked at.
const BESIDE: f64 = 1e-12;
/// Newton steps for a settlement.
const SETTLEMENTS: usize = 60;
/// Rounding of pressures and forces.
const ROUNDING: f64 = 1e-14;
/// Points at which two resolutions are compared.
const COMPARISONS: usize = 65;
/// Twice the share of its bend by which the bottom of a valley can lie below the lowest of equally spaced places.
const VALLEY: f64 = 0.25;
/// Parabolas towards the bottom of a valley, and how much closer the places of each are.
const BOTTOMS: usize = 6;
const CLOSER: f64 = 0.1;
/// Halvings of a way out of a gap.
const HALVINGS: usize = 30;
/// Panels of the integral for the moment.
const PANELS: usize = 32;

/// Full contact of a wave: `p0 = P0/2 - F/theta0` with `F = sum k f_k cos(k pi xi + ..)`, as `int K cos(k pi eta) deta = cos(k pi xi)/k` for `L = 2`.
#[derive(Debug, Clone)]
pub(super) struct FullWave {
    pub(super) slopes: Arc<Slopes>,
    pub(super) theta0: f64,
    pub(super) force: f64,
    /// Estimated errors of `F` and of the mean of the profile, by other panels.
    pub(super) error: [f64; 2],
}

/// The profile of a wave over the angle `pi xi`.
pub(super) struct Turn<'p>(pub(super) &'p SmoothProfile);

impl Angular for Turn<'_> {
    fn height(&self, angle: f64) -> f64 {
        (self.0.height)(angle / PI)
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        self.0.slope.as_ref().map(|slope| slope(angle / PI) / PI)
    }
}

impl FullWave {
    fn new(problem: &SmoothProblem, band: Option<&Band>, force: f64) -> Self {
        let SmoothProblem { profile, theta0, .. } = problem;
        let theta0 = *theta0;
        if let Some(Band { slopes, .. }) = band {
            let error = [slopes.error(), 0.0];
            return Self { slopes: Arc::new(slopes.clone()), theta0, force, error };
        }
        let angles = |places: &[f64]| -> Vec<f64> { places.iter().map(|at| at * PI).collect() };
        let [bends, joints] = [&profile.breaks, &profile.joints].map(|places| angles(places));
        let resolved = |panels: usize| {
            Slopes::on_panels(&Turn(profile), [&bends, &joints], [panels, 2], profile.tolerance)
        };
        let (slopes, other) = (Arc::new(resolved(FINE.panels)), resolved(COMPARED.panels));
        let difference = (0..COMPARISONS)
            .map(|i| TAU * (i as f64 + 0.5) / COMPARISONS as f64 - PI)
            .map(|angle| (slopes.conjugate(angle) - other.conjugate(angle)).abs())
            .filter(|difference| difference.is_finite())
            .fold(0.0, f64::max);
        let error = [difference + slopes.error(), (slopes.mean() - other.mean()).abs()];
        Self { slopes, theta0, force, error }
    }

    /// `p0(xi)`.
    pub(super) fn pressure(&self, xi: f64) -> f64 {
        0.5 * self.force - self.slopes.conjugate(PI * xi) / self.theta0
    }

    /// The settlement: the mean of the profile.
    pub(super) fn settlement(&self) -> f64 {
        self.slopes.mean()
    }

    /// `int xi p0 dxi` over `-1 .. 1`, of panels by what they make of `xi`: `2/pi^2 int f' ln|2 cos(pi xi/2)| dxi` is the integral of `xi F`, as the logarithm is the conjugate of `xi`.
    pub(super) fn moment(&self, breaks: &[f64]) -> f64 {
        if let Some(turning) = self.slopes.turning() {
            return -2.0 / (PI * PI * self.theta0) * turning;
        }
        let mut cuts: Vec<f64> =
            (0..=PANELS).map(|i| 2.0 * i as f64 / PANELS as f64 - 1.0).collect();
        cuts.extend(breaks);
        cuts.sort_by(f64::total_cmp);
        cuts.windows(2)
            .map(|pair| super::legendre::integral(pair[0], pair[1], |xi| xi * self.pressure(xi)))
            .sum()
    }

    /// The pressure at equally spaced places.
    fn along(&self, points: usize) -> Vec<(f64, f64)> {
        // An irrational share of the step keeps clear of symmetric places, where a kink may be.
        let points = (0..points).map(|i| 2.0 * (i as f64 + 0.5 / SQRT_2) / points as f64 - 1.0);
        points.map(|xi| (xi, self.pressure(xi))).collect()
    }

    /// The pressure right beside the kink where the base is most hollow, with the place of that kink: at the kink itself it is minus infinity,
    /// and where it pulls no farther from it than rounding there is nothing to open.
    fn beside_kink(&self) -> Option<(f64, f64)> {
        let deepest = self.slopes.hollows().min_by(|one, two| one.1.total_cmp(&two.1))?;
        let kink = deepest.0 / PI;
        let beside = [-BESIDE, BESIDE].map(|offset| self.pressure(wrapped(kink + offset)));
        Some((kink, beside[0].min(beside[1])))
    }

    /// The least pressure in the valleys between equally spaced places that might reach below zero, with its place: a gap about to open is shorter than their distance.
    fn lowest(&self, along: &[(f64, f64)]) -> Option<(f64, f64)> {
        let count = along.len();
        let step = 2.0 / count as f64;
        let at = |i: usize| along[i % count].1;
        let may_reach = |i: usize| {
            let (before, here, after) = (at(i + count - 1), at(i), at(i + 1));
            let bend = before + after - 2.0 * here;
            here <= before && here <= after && here < VALLEY * bend
        };
        (0..count)
            .filter(|&i| may_reach(i))
            .map(|i| self.bottom(along[i].0, step))
            .min_by(|one, two| one.1.total_cmp(&two.1))
    }

    /// The least pressure between cuts of the profile, which lie about narrow features that equally spaced places miss.
    fn between(&self, cuts: &[f64]) -> Option<(f64, f64)> {
        let places = cuts.windows(2).flat_map(|pair| {
            let step = (pair[1] - pair[0]) / BETWEEN as f64;
            (1..BETWEEN).map(move |i| (pair[0] + step * i as f64, step))
        });
        let lowest = places
            .map(|(at, step)| (at, self.pressure(at), step))
            .min_by(|one, two| one.1.total_cmp(&two.1));
        lowest.map(|(at, _, step)| self.bottom(at, step))
    }

    /// The bottom of the valley about a place by parabolas through ever closer places.
    fn bottom(&self, at: f64, step: f64) -> (f64, f64) {
        let pressure = |xi: f64| self.pressure(wrapped(xi));
        let mut best = (at, pressure(at));
        let mut step = step;
        for _ in 0..BOTTOMS {
            let (before, after) = (pressure(best.0 - step), pressure(best.0 + step));
            let bend = before + after - 2.0 * best.1;
            let vertex = best.0 + 0.5 * step * (before - after) / bend;
            let moved = vertex.clamp(best.0 - step, best.0 + step);
            let sides = [(best.0 - step, before), (best.0 + step, after), (moved, pressure(moved))];
            best = sides
                .into_iter()
                .filter(|side| side.1 < best.1)
                .fold(best, |least, side| if side.1 < least.1 { side } else { least });
            step *= CLOSER;
        }
        (wrapped(best.0), best.1)
    }

    /// A zone for a force: where the pressure of full contact is above its largest value less twice the mean. Of one cosine that is the zone itself,
    /// as Westergaard's half-width has `sin^2 = P0/(2 p*)`. On panels, where there may be a kink, it is where full contact does not pull: a gap that a kink opens is
    /// about as wide. None where it is in several parts.
    fn first_zone(
        &self,
        along: &[(f64, f64)],
        (bottom, least): (f64, f64),
        force: f64,
    ) -> Option<[f64; 2]> {
        let count = along.len();
        let at = |i: usize| along[i % count].1;
        let step = 2.0 / count as f64;
        let level = if self.slopes.is_sampled() {
            self.top(along) - force
        } else {
            0.5 * (self.force - force)
        };
        let is_inside = |i: usize| at(i) > level;
        let rises = (0..count).filter(|&i| !is_inside(i) && is_inside(i + 1)).count();
        if rises > 1 || least >= level {
            return None;
        }
        let outside = (0..count).filter(|&i| !is_inside(i)).count();
        let width = step * (outside + 1) as f64;
        let [left, right] = [-width, width].map(|width| self.climbed(bottom, width, level));
        Some([right, left + 2.0])
    }

    /// The largest pressure, by a parabola through three places.
    fn top(&self, along: &[(f64, f64)]) -> f64 {
        let count = along.len();
        let at = |i: usize| along[i % count].1;
        let top = (0..count).fold(0, |top, i| if at(i) > at(top) { i } else { top });
        let (before, peak, after) = (at(top + count - 1), at(top), at(top + 1));
        let bend = 2.0 * peak - before - after;
        let beside = if bend > 0.0 { (after - before) / (bend * count as f64) } else { 0.0 };
        peak.max(self.pressure(wrapped(along[top].0 + beside)))
    }

    /// Where the pressure rises to a value this far from the bottom of a valley at most, by halving.
    fn climbed(&self, bottom: f64, width: f64, level: f64) -> f64 {
        let (mut below, mut above) = (0.0, width);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (below + above);
            if self.pressure(wrapped(bottom + middle)) < level {
                below = middle;
            } else {
                above = middle;
            }
        }
        bottom + 0.5 * (below + above)
    }
}

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
    let step = (base.height(1.0 - SEAM) - base.height(SEAM - 1.0)).abs();
    let requirement = "the same at both ends of a period";
    require(step <= 1e-6 * base.range(), "profile", base.height(1.0), requirement)?;
    let force = match vertical {
        Vertical::Force(force) => force,
        Vertical::Settlement(_) => 0.0,
    };
    let full = FullWave::new(problem, band.as_ref(), force);
    let along = full.along((4 * base.cells()).clamp(POINTS, MOST_POINTS));
    let (place, least, size) = least(&along);
    let pulls = |p: f64| problem.is_unilateral && p < -ALLOWED * size;
    let lowest = full.lowest(&along);
    let lower = |one: (f64, f64), two: (f64, f64)| if two.1 < one.1 { two } else { one };
    let others = [lowest, full.beside_kink(), full.between(&problem.profile.breaks)];
    let (place, least) = others.into_iter().flatten().fold((place, least), lower);
    // The seam is best left where it is as deep in the valley.
    let bottom = place;
    let is_seam = full.pressure(-1.0) <= least + AS_DEEP * size;
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
    for _ in 0..SETTLEMENTS {
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

/// A place moved by whole periods into `-1 .. 1`.
pub(super) fn wrapped(xi: f64) -> f64 {
    match xi.abs() {
        size if size < 1.0 => xi,
        size if size < 3.0 => xi - 2f64.copysign(xi),
        _ => xi - 2.0 * (0.5 * xi).round(),
    }
}
