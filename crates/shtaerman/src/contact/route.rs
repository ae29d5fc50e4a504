//! Which way a problem is solved, and why.

use std::fmt;
use std::sync::Arc;

use fredholm::basis::Function;

use super::method::MethodName;
use super::parts::Parts;
use super::setting::Setting;
use super::solution::Solution;
use super::spectral::{SpectralContact, profile_series};
use crate::roughness::Law;
use crate::solver::AIM;
use crate::{Error, ErrorKind, Geometry, MethodChoice};

/// Profiles of a higher Chebyshev degree than this oscillate faster than collocation should follow (survey).
const LARGEST_COLLOCATED_DEGREE: usize = 256;
/// Profiles up to this degree are tried by collocation, too, where the degenerate kernel falls short. The degree counts rounding of the series as well: `cos(437.5*xi)` has 3184, and waves to `cos(600*xi)` are resolved (survey).
const LARGEST_TRIED_DEGREE: usize = 4096;

/// A way to the solution on given ground, for one kind of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Route {
    /// The first kind: a smooth surface.
    Smooth,
    /// The second kind, on zones that are part of the answer.
    Lifting,
    /// The second kind on the whole base.
    WholeBase,
    /// The whole base of one punch on a half-plane with a linear layer, for which the spectral relation serves.
    PlainBase,
}

impl Route {
    fn of(setting: &Setting) -> Self {
        let bodies = setting.problem().bodies();
        match bodies.law() {
            Law::Smooth => Self::Smooth,
            _ if setting.is_unilateral() => Self::Lifting,
            Law::Linear if bodies.is_homogeneous() && bodies.geometry() == Geometry::Plane => {
                Self::PlainBase
            }
            _ => Self::WholeBase,
        }
    }
}

/// Why a method was taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Reason {
    /// So many zones on a smooth surface.
    SpectralRelation(usize),
    /// So many zones on few bends.
    ExactEdges(usize),
    /// So many zones where the base bends often, or where collocation did not find them.
    ManyBends(usize),
    /// Somebody asked for the degree, for the degenerate kernel, or for collocation.
    DegreeGiven,
    SpectralAskedFor,
    SincAskedFor,
    /// So many places where the profile is cut.
    Cut(usize),
    Smooth,
    /// The Chebyshev degree that the profile needs, where that is known.
    Degree(Option<usize>),
    /// Collocation came closer than the degenerate kernel.
    Closer,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let zones = |count: usize| match count {
            1 => "one zone".to_owned(),
            count => format!("{count} zones"),
        };
        match *self {
            Self::SpectralRelation(count) => {
                write!(f, "{} on a smooth surface: the spectral relation of the first kind", zones(count))
            }
            Self::ExactEdges(count) => {
                write!(f, "{} with exact edges: collocation converges exponentially", zones(count))
            }
            Self::ManyBends(count) => write!(
                f,
                "{} with exact edges on panels between the bends of the base, for which collocation is not made, or where it did not find the zones",
                zones(count)
            ),
            Self::DegreeGiven => {
                f.write_str("a given n fixes the truncation of the degenerate kernel")
            }
            Self::SpectralAskedFor => f.write_str(
                "asked for; n doubled until the bound was met or the last n reached, edge pressures by the iterated solution",
            ),
            Self::SincAskedFor => f.write_str("asked for"),
            Self::Cut(count) => write!(
                f,
                "the profile has {count} breakpoint(s): collocation on the panels between them"
            ),
            Self::Smooth => {
                f.write_str("the profile is smooth: collocation converges exponentially")
            }
            Self::Degree(needed) => {
                let needed = needed.map_or(format!("beyond {}", Function::LAST_DEGREE), |degree| degree.to_string());
                write!(
                    f,
                    "the profile needs Chebyshev degree {needed}: the structured spectral solve; edge pressures by the iterated solution"
                )
            }
            Self::Closer => f.write_str(
                "the profile oscillates: collocation on many nodes came closer than the degenerate kernel",
            ),
        }
    }
}

/// A solution with the reason for its method.
#[derive(Debug)]
pub(super) struct Found {
    pub(super) solution: Arc<dyn Solution>,
    pub(super) reason: Reason,
    /// The error of the series that stood for the profile, where it was not resolved.
    pub(super) profile_error: Option<f64>,
}

impl Found {
    fn new(solution: Arc<dyn Solution>, reason: impl Fn(usize) -> Reason) -> Self {
        let reason = reason(solution.zones().len());
        Self { solution, reason, profile_error: None }
    }

    /// On zones of a rough surface, by collocation or on panels.
    fn on_zones(solution: Arc<dyn Solution>) -> Self {
        match solution.method().name {
            MethodName::Panels => Self::new(solution, Reason::ManyBends),
            _ => Self::new(solution, Reason::ExactEdges),
        }
    }

    pub(super) fn spectral(contact: SpectralContact, reason: Reason) -> Self {
        let profile_error = contact.profile_error();
        Self { solution: Arc::new(contact), reason, profile_error }
    }
}

/// The solution of a problem by the way that is made for it.
///
/// # Errors
/// Those of the way.
pub(super) fn solution(setting: &Setting) -> Result<Found, Error> {
    Ok(match Route::of(setting) {
        Route::Smooth => Found::new(setting.without_layer()?, Reason::SpectralRelation),
        Route::Lifting => Found::on_zones(setting.lifting()?),
        Route::WholeBase => Found::on_zones(setting.whole_base()?),
        Route::PlainBase => match on_panels(setting)? {
            Some(solution) => Found::on_zones(solution),
            None => plain_base(setting)?,
        },
    })
}

/// The whole base on panels, where nobody asked for another method and it was measured, or falls into more parts than are collocated.
fn on_panels(setting: &Setting) -> Result<Option<Arc<dyn Solution>>, Error> {
    let solver = setting.problem().solver();
    let is_free = solver.method == MethodChoice::Auto && solver.degree.is_none();
    let is_measured = setting.problem().profile().measured_points().is_some();
    if !is_free || !(is_measured || setting.parts().are_many()) {
        return Ok(None);
    }
    setting.whole_base_on_panels()
}

/// The whole base of one punch on a half-plane with a linear layer, by the method that was asked for, or by the one that suits it.
fn plain_base(setting: &Setting) -> Result<Found, Error> {
    let solver = setting.problem().solver();
    match (solver.method, solver.degree) {
        (MethodChoice::Spectral | MethodChoice::Auto, Some(degree)) => {
            let series = profile_series(setting)?;
            let contact = SpectralContact::with_bounds(setting, &series, degree)?;
            Ok(Found::spectral(contact, Reason::DegreeGiven))
        }
        (MethodChoice::Spectral, None) => {
            let series = profile_series(setting)?;
            let contact = SpectralContact::adaptive(setting, &series)?;
            Ok(Found::spectral(contact, Reason::SpectralAskedFor))
        }
        (MethodChoice::Sinc, _) => {
            collocated(setting, &setting.collocated_parts(), Reason::SincAskedFor)
        }
        (MethodChoice::Auto, None) => suited(setting),
    }
}

fn collocated(setting: &Setting, parts: &Parts, reason: Reason) -> Result<Found, Error> {
    let solution = setting.collocated(parts)?;
    Ok(Found { solution, reason, profile_error: None })
}

/// By the profile: collocation where it is smooth or has few cuts, the degenerate kernel where it oscillates; of those that fall short the best.
fn suited(setting: &Setting) -> Result<Found, Error> {
    let tolerance = setting.problem().solver().tolerance.unwrap_or(AIM);
    let meets = |found: &Found| found.solution.relative_error() <= tolerance;
    let parts = setting.parts();
    let mut candidates = Vec::new();
    // Resolving a profile with a kink takes long and leads nowhere: panels are tried first.
    if !parts.joints.is_empty() && !parts.are_many() {
        match collocated(setting, parts, Reason::Cut(parts.joints.len())) {
            Ok(found) if meets(&found) => return Ok(found),
            Ok(found) => candidates.push(found),
            Err(_) => {}
        }
    }
    let series = profile_series(setting)?;
    let (degree, is_resolved) = (series.series().degree(), series.is_resolved());
    if is_resolved && degree <= LARGEST_COLLOCATED_DEGREE {
        return collocated(setting, &parts.uncut(), Reason::Smooth);
    }
    let contact = SpectralContact::adaptive(setting, &series)?;
    let found = Found::spectral(contact, Reason::Degree(is_resolved.then_some(degree)));
    let is_tried = !meets(&found) && is_resolved && degree <= LARGEST_TRIED_DEGREE;
    candidates.push(found);
    if is_tried && let Ok(found) = collocated(setting, &parts.uncut(), Reason::Closer) {
        candidates.push(found);
    }
    // An audit bounds an estimate as rounding grows with `theta0`.
    let bounded = setting.problem().aim() / AIM;
    let is_bound =
        |found: &Found| found.solution.accuracy().is_some_and(|a| a.kind == ErrorKind::Bound);
    let error = |found: &Found| {
        found.solution.relative_error() * if is_bound(found) { 1.0 } else { bounded }
    };
    let best = candidates.into_iter().min_by(|one, two| error(one).total_cmp(&error(two)));
    best.ok_or_else(super::search::unknown)
}
