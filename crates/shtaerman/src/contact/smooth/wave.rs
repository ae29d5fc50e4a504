//! A wave over the whole period: full contact by the conjugate of its slope, partial contact between the crests.

use std::f64::consts::{PI, SQRT_2, TAU};
use std::sync::Arc;

use super::answer::SmoothContact;
use super::problem::{Base, SmoothProblem, SmoothProfile};
use super::slopes::{Angular, Slopes};
use super::{COMPARED, FINE};
use crate::error::require;
use crate::{Error, Load, Rotational, Vertical};

/// Where both sides of the seam are compared, and the share of the profile's range that makes a jump.
const SEAM: f64 = 1e-9;
/// Points at which the pressure of full contact is looked at, at least.
const POINTS: usize = 256;
/// Newton steps for a settlement.
const SETTLEMENTS: usize = 60;
/// Rounding of pressures and forces.
const ROUNDING: f64 = 1e-14;
/// Points at which two resolutions are compared.
const COMPARISONS: usize = 65;
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

struct Turn<'p>(&'p SmoothProfile);

impl Angular for Turn<'_> {
    fn height(&self, angle: f64) -> f64 {
        (self.0.height)(angle / PI)
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        self.0.slope.as_ref().map(|slope| slope(angle / PI) / PI)
    }
}

impl FullWave {
    fn new(base: &Base<'_>, force: f64) -> Self {
        let SmoothProblem { profile, theta0, .. } = base.problem;
        let bends: Vec<f64> = profile.breaks.iter().map(|at| at * PI).collect();
        let resolved =
            |panels: usize| Slopes::resolve(&Turn(profile), &bends, [panels, 2], profile.tolerance);
        let (slopes, other) = (Arc::new(resolved(FINE.panels)), resolved(COMPARED.panels));
        let difference = (0..COMPARISONS)
            .map(|i| TAU * (i as f64 + 0.5) / COMPARISONS as f64 - PI)
            .map(|angle| (slopes.conjugate(angle) - other.conjugate(angle)).abs())
            .filter(|difference| difference.is_finite())
            .fold(0.0, f64::max);
        let error = [difference + slopes.error(), (slopes.mean() - other.mean()).abs()];
        Self { slopes, theta0: *theta0, force, error }
    }

    /// `p0(xi)`.
    pub(super) fn pressure(&self, xi: f64) -> f64 {
        0.5 * self.force - self.slopes.conjugate(PI * xi) / self.theta0
    }

    /// The settlement: the mean of the profile.
    pub(super) fn settlement(&self) -> f64 {
        self.slopes.mean()
    }

    /// `int xi p0 dxi` over `-1 .. 1`.
    pub(super) fn moment(&self, breaks: &[f64]) -> f64 {
        let mut cuts: Vec<f64> =
            (0..=PANELS).map(|i| 2.0 * i as f64 / PANELS as f64 - 1.0).collect();
        cuts.extend(breaks);
        cuts.sort_by(f64::total_cmp);
        cuts.windows(2)
            .map(|pair| super::legendre::integral(pair[0], pair[1], |xi| xi * self.pressure(xi)))
            .sum()
    }

    /// Where the pressure is least, and how small it is there over its mean deviation.
    fn least(&self, points: usize) -> (f64, f64, f64) {
        // An irrational share of the step keeps clear of symmetric places, where a kink may be.
        let points = (0..points).map(|i| 2.0 * (i as f64 + 0.5 / SQRT_2) / points as f64 - 1.0);
        points.fold((0.0, f64::INFINITY, 0.0), |(at, least, size): (f64, f64, f64), xi| {
            let p = self.pressure(xi);
            let size = size.max(p.abs());
            if p < least { (xi, p, size) } else { (at, least, size) }
        })
    }
}

/// Solves for a base that repeats without gaps.
pub(super) fn solve(base: &Base<'_>) -> Result<SmoothContact, Error> {
    let problem = base.problem;
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
    let full = FullWave::new(base, force);
    let (place, least, size) = full.least(POINTS.max(4 * base.cells()));
    let pulls = |p: f64| problem.is_unilateral && p < -ROUNDING * size;
    if let Vertical::Settlement(settlement) = vertical {
        let requirement = "less than the mean height of the profile: in full contact it is that mean, whatever the force";
        let partial = problem.is_unilateral && settlement < full.settlement();
        require(partial, "settlement", settlement, requirement)?;
        // Without force the least pressure is minus that which closes all gaps.
        return sunk(&moved(problem, place), settlement, -2.0 * least)
            .map(|contact| contact.turned(problem, place));
    }
    if !pulls(least) {
        return Ok(SmoothContact::full(base, full));
    }
    super::solve_zones(&moved(problem, place)).map(|contact| contact.turned(problem, place))
}

/// The force for a settlement, by Newton's method between bounds: a constant pressure moves nothing, so the equation for a given settlement is badly posed
/// near full contact.
fn sunk(problem: &SmoothProblem, settlement: f64, limit: f64) -> Result<SmoothContact, Error> {
    let (mut low, mut high) = (0.0, limit);
    let mut force = 0.3 * limit;
    let mut last = None;
    for _ in 0..SETTLEMENTS {
        let load = Load { vertical: Vertical::Force(force), ..problem.load };
        let contact = super::solve_zones(&SmoothProblem { load, ..problem.clone() })?;
        let excess = contact.settlement0() - settlement;
        if excess > 0.0 {
            high = force;
        } else {
            low = force;
        }
        let newton = force - excess * contact.stiffness0().force_settlement;
        last = Some(contact.settled(settlement));
        let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        if (next - force).abs() <= ROUNDING * force {
            break;
        }
        force = next;
    }
    last.ok_or(Error::NoContact)
}

/// The problem with its seam where the base pulls most.
fn moved(problem: &SmoothProblem, place: f64) -> SmoothProblem {
    // The place becomes +-1.
    let shift = place - 1.0;
    let turned = move |xi: f64| wrapped(xi + shift);
    let SmoothProfile { height, slope, breaks, tolerance } = problem.profile.clone();
    let mut breaks: Vec<f64> =
        breaks.into_iter().chain([1.0]).map(|at| wrapped(at - shift)).collect();
    breaks.sort_by(f64::total_cmp);
    let profile = SmoothProfile {
        height: Arc::new(move |xi| height(turned(xi))),
        slope: slope.map(|slope| Arc::new(move |xi| slope(turned(xi))) as super::Curve),
        breaks,
        tolerance,
    };
    SmoothProblem { profile, ..problem.clone() }
}

/// A place moved by whole periods into `-1 .. 1`.
pub(super) fn wrapped(xi: f64) -> f64 {
    xi - 2.0 * (0.5 * xi).round()
}
